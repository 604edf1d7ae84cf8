"""Lines drawn over the surfaces: the regions' borders, the section."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from app.model.view_state import ViewState
from app.scene.content import Content
from app.scene.pick import heights_at
from app.scene.profile import profile_of
from app.scene.quiet_colours import Palette
from surfcmp_core.colours.maps import Colours, Rgb

Segments = NDArray[np.float32]
"""(k, 2, 3)."""


def lines_of(
    content: Content, state: ViewState, quiet: Palette, view: int
) -> tuple[Segments, Colours]:
    """Return the segments to be drawn over a view, on its surface, and the colour of each."""
    parts: list[tuple[Segments, Rgb]] = []
    patch = content.geometry.patches[2]
    for edges, colour in content.borders:
        ends = patch.points[edges]
        ends[..., 2] = heights_at(content.comparison, content.geometry, edges, view)
        parts.append((ends, colour))
    if state.section is not None:
        parts.append((section_line(content, state, view), quiet.accent))
    nothing = np.zeros((0, 2, 3), dtype=np.float32)
    segments = np.concatenate([nothing, *(part for part, _ in parts)])
    if not state.relief:
        segments[..., 2] = 0.0
    counts = [len(part) for part, _ in parts]
    colours = np.repeat(
        np.array([colour for _, colour in parts] or [(0, 0, 0)], dtype=np.uint8),
        counts or [0],
        axis=0,
    )
    return segments, colours


def section_line(content: Content, state: ViewState, view: int) -> Segments:
    """Return the section's line, laid on the surface a view shows."""
    assert state.section is not None
    x0, y0, x1, y1 = state.section
    profile = content.once(profile_of, content.comparison, state.section, content.geometry)
    share = profile.along / (math.sqrt((x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0)) or 1.0)
    z1 = np.where(np.isnan(profile.z1), profile.z2, profile.z1)
    z2 = np.where(np.isnan(profile.z2), profile.z1, profile.z2)
    z = (z1, z2, (z1 + z2) / 2)[min(view, 2)]
    points = np.column_stack([x0 + share * (x1 - x0), y0 + share * (y1 - y0), z])
    points = points[np.isfinite(z)] - content.geometry.origin
    if len(points) < 2:
        return np.zeros((0, 2, 3), dtype=np.float32)
    return np.stack([points[:-1], points[1:]], axis=1).astype(np.float32)
