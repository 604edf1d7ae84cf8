"""The lights of every view: a strong one from the upper left, a weak one from the right."""

import pyvista

LIGHTS = (((-0.55, 0.75, 1.0), 0.85), ((0.9, 0.1, 0.6), 0.22))
"""From where, as the camera sees it, and how strong."""


def light(renderer: pyvista.Renderer) -> None:
    """Light a scene from where the camera is."""
    for place, strength in LIGHTS:
        lamp = pyvista.Light(position=place, focal_point=(0, 0, 0), intensity=strength)
        lamp.light_type = pyvista.Light.CAMERA_LIGHT
        renderer.AddLight(lamp)
