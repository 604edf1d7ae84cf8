"""From a comparison and a view state to the four views."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.model.view_state import Heatmap, ViewState
from app.scene.chain_colours import chain_colours
from app.scene.colour_maps import Colours, Rgb, banded, continuous, map_of
from app.scene.geometry import Geometry, Patch
from app.scene.palette import Palette, palette
from app.scene.values import Trust, values_of
from surfcmp_core.comparison import Comparison

VIEWS = 4
"""Surface 1, surface 2, T with its chains, the heatmap."""
TRUST_COLOURS: dict[Trust, Rgb] = {
    Trust.BOTH: (64, 145, 108),
    Trust.ONLY_1: (122, 163, 204),
    Trust.ONLY_2: (217, 178, 110),
}
FADED = 0.72
"""How far what is not brushed or not chosen moves towards the background."""


@dataclass(frozen=True, slots=True, eq=False)
class MeshLayer:
    """One patch as it is drawn.

    Attributes
    ----------
    patch : Patch
    colours : (m, 3) uint8, or one colour for all
    relief : bool
        Draw the heights; else the map, z = 0.
    shaded : bool
        Lit by the relief's normals, also on the map.
    edges : bool
        The triangles' sides are drawn where they are large enough to see.
    outline : (k, 2, 3) float32
        Segments drawn over everything: what is picked or chosen.
    """

    patch: Patch
    colours: Colours | Rgb
    relief: bool
    shaded: bool
    edges: bool
    outline: NDArray[np.float32]


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """The four views and the colours they share."""

    layers: tuple[MeshLayer, ...]
    palette: Palette


NOTHING = np.zeros((0, 2, 3), dtype=np.float32)


def scene_of(comparison: Comparison, geometry: Geometry, state: ViewState) -> Scene:
    """Return what the four views show."""
    quiet = palette(state.dark)
    colours: list[Colours | Rgb] = [
        quiet.surface_1,
        quiet.surface_2,
        united_colours(comparison, state),
        heatmap_colours(comparison, state),
    ]
    one, two, united = geometry.patches
    outline = outline_of(comparison, geometry, state)
    layers = [
        MeshLayer(
            patch=patch,
            colours=colour,
            relief=state.relief,
            shaded=state.relief or view < 2,
            edges=state.edges,
            outline=outline,
        )
        for view, (patch, colour) in enumerate(zip((one, two, united, united), colours, strict=True))
    ]
    return Scene(layers=tuple(layers), palette=quiet)


def united_colours(comparison: Comparison, state: ViewState) -> Colours:
    """Return (M, 3) the colours of T: clouts quiet, each chain its own."""
    quiet, united = palette(state.dark), comparison.united
    seen = np.bitwise_and.reduce(united.label[united.triangles], axis=1)
    table = np.array([quiet.shared, quiet.surface_1, quiet.surface_2, quiet.shared], np.uint8)
    colours = table[seen]
    inside = united.chain >= 0
    colours[inside] = chain_colours(united.chain_closed)[united.chain[inside]]
    if state.chain is not None:
        colours = faded(colours, united.chain != state.chain, quiet.background)
    return colours


def heatmap_colours(comparison: Comparison, state: ViewState) -> Colours:
    """Return (M, 3) the colours of the heatmap."""
    quiet = palette(state.dark)
    values = values_of(comparison, state.heatmap)
    signed = state.heatmap is Heatmap.SIGNED
    limit = state.scale.limit
    if state.heatmap is Heatmap.TRUST:
        table = np.array([*TRUST_COLOURS.values(), quiet.no_data], np.uint8)
        colours = table[values.astype(np.intp)]
    elif not state.heatmap.of_difference:
        low, high = height_range(comparison)
        colours = continuous(values, low, high, map_of(state.heatmap), quiet.no_data)
    elif state.scale.banded:
        colours = banded(values, state.scale, signed, quiet.no_data)
    else:
        low = -limit if signed else 0.0
        colours = continuous(values, low, limit, map_of(state.heatmap), quiet.no_data)
    if state.brush is not None:
        low, high = state.brush
        with np.errstate(invalid="ignore"):
            out = ~((values >= low) & (values <= high))
        colours = faded(colours, out, quiet.background)
    return colours


def height_range(comparison: Comparison) -> tuple[float, float]:
    """Return the lowest and highest z of both surfaces: one range for both."""
    lows, highs = zip(*((grid.z.min(), grid.z.max()) for grid in comparison.grids), strict=True)
    return float(min(lows)), float(max(highs))


def faded(colours: Colours, where: NDArray[np.bool_], towards: Rgb) -> Colours:
    """Return `colours` with those `where` moved most of the way `towards` a colour."""
    mixed = colours.copy()
    pale = colours[where] * (1 - FADED) + np.array(towards) * FADED
    mixed[where] = np.rint(pale).astype(np.uint8)
    return mixed


def outline_of(
    comparison: Comparison, geometry: Geometry, state: ViewState
) -> NDArray[np.float32]:
    """Return (k, 2, 3) the sides of the picked triangle, just above the surface."""
    if state.picked is None or state.picked >= len(comparison.united.triangles):
        return NOTHING
    corners = geometry.patches[2].points[comparison.united.triangles[state.picked]].copy()
    if not state.relief:
        corners[:, 2] = 0.0
    return np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)
