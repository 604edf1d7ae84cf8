"""From a comparison and a view state to the four views."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.model.view_state import ChainsBy, Heatmap, ViewState
from app.scene.chain_colours import chain_colours
from app.scene.chain_table import ChainTable
from app.scene.coarse import Coarse
from app.scene.content import Content
from app.scene.geometry import Patch
from app.scene.lines import Segments, lines_of
from app.scene.quiet_colours import Palette, palette
from app.scene.values import Trust, values_of
from surfcmp_core.colours.maps import Colours, Rgb, height_map, spread
from surfcmp_core.colours.scale import Scale, coloured

if TYPE_CHECKING:  # the window is on the screen before the core is loaded
    from surfcmp_core.comparing.comparison import Comparison

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
    colours : (m, 3) uint8, or one colour for all, or None
        None in a sketch, where the coarse patch is drawn in place of the patch.
    coarse_colours : (t, 3) uint8, or one colour for all, or None
        Of the coarse patch, where there is one.
    nodes : (n, 3) uint8 or None
        Colours of the nodes, which are drawn where they lie far enough apart; None in a sketch.
    relief : bool
        Draw the heights; else the map, z = 0.
    shaded : bool
        Lit by the relief's normals, also on the map.
    edges : bool
        The triangles' sides are drawn where they are large enough to see.
    lines : (k, 2, 3) float32
        Segments drawn over everything.
    line_colours : (k, 3) uint8
    """

    patch: Patch
    colours: Colours | Rgb | None
    coarse_colours: Colours | Rgb | None
    nodes: Colours | None
    relief: bool
    shaded: bool
    edges: bool
    lines: Segments
    line_colours: Colours

    def differs_from(self, other: MeshLayer) -> bool:
        """Whether the two look different; arrays are compared by identity, but for lines."""
        if self.colours is None or other.colours is None:
            repainted = self.coarse_colours is not other.coarse_colours
        else:
            repainted = self.colours is not other.colours
        return (
            repainted
            or self.patch is not other.patch
            or (self.relief, self.shaded, self.edges) != (other.relief, other.shaded, other.edges)
            or self.lines_differ_from(other)
        )

    def lines_differ_from(self, other: MeshLayer) -> bool:
        """Whether the lines over the two are others."""
        return not (
            np.array_equal(self.lines, other.lines)
            and np.array_equal(self.line_colours, other.line_colours)
        )


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """The four views and the colours they share."""

    layers: tuple[MeshLayer, ...]
    palette: Palette


def scene_of(content: Content, state: ViewState, *, sketch: bool = False) -> Scene:
    """Return what the four views show; a `sketch` only what is drawn while the camera moves."""
    comparison, geometry, once = content.comparison, content.geometry, content.once
    quiet = palette(state.dark)
    patches = (*geometry.patches, geometry.patches[2])

    def paint(view: int, coarse: Coarse | None) -> Colours | Rgb:
        if view < 2:
            plain = (quiet.surface_1, quiet.surface_2)[view]
            return once(surface_colours, patches[view], plain, state.dark, coarse)
        if view == 2:
            end = state.colours.end if state.chains_by is ChainsBy.MEAN else 0.0
            how = state.chains_by, end, state.chain, state.dark
            return once(united_colours, comparison, content.chains, *how, coarse)
        kind, scale = state.heatmap, visible_part(state.colours)
        return once(heatmap_colours, comparison, kind, scale, state.brush, state.dark, coarse)

    def node_colours(view: int) -> Colours:
        if view < 2:
            return once(plain_nodes, len(patches[view].points), view + 1, state.dark)
        return once(united_nodes, comparison, state.dark)

    lines = [lines_of(content, state, quiet, view) for view in range(VIEWS)]
    layers = [
        MeshLayer(
            patch=patch,
            colours=None if sketch and patch.coarse else paint(view, None),
            coarse_colours=paint(view, patch.coarse) if patch.coarse else None,
            nodes=None if sketch else node_colours(view),
            relief=state.relief,
            shaded=state.relief or view < 2,
            edges=state.edges,
            lines=lines[view][0],
            line_colours=lines[view][1],
        )
        for view, patch in enumerate(patches)
    ]
    return Scene(layers=tuple(layers), palette=quiet)


def visible_part(scale: Scale) -> Scale:
    """Return the scale without what its colours do not show."""
    return replace(scale, end=1.0) if scale.bands else scale


def plain_nodes(count: int, surface: int, dark: bool) -> Colours:
    """Return (count, 3) the colour of all nodes of surface 1 or 2."""
    return np.tile(node_table(dark)[surface], (count, 1))


def united_nodes(comparison: Comparison, dark: bool) -> Colours:
    """Return (N, 3) the colours of T's nodes: of 1, of 2, shared."""
    return np.asarray(node_table(dark)[comparison.united.label])


def node_table(dark: bool) -> Colours:
    """Return the colours of nodes by their label: none, 1, 2, shared."""
    quiet = palette(dark)
    return np.array([quiet.shared, quiet.node_1, quiet.node_2, quiet.edge], dtype=np.uint8)


def surface_colours(
    patch: Patch, colour: Rgb, dark: bool, coarse: Coarse | None = None
) -> Colours | Rgb:
    """Return the colours of T1 or T2, or of its `coarse` patch: pale where it has no data."""
    if patch.data is None:
        return colour
    data = patch.data if coarse is None else patch.data[coarse.source]
    table = np.array([colour, colour], dtype=np.uint8)
    table = faded(table, np.array([True, False]), palette(dark).background)
    return np.asarray(table[data.astype(np.intp)])


def united_colours(
    comparison: Comparison,
    chains: ChainTable,
    by: ChainsBy,
    end: float,
    chosen: int | None,
    dark: bool,
    coarse: Coarse | None = None,
) -> Colours:
    """Return the colours of T: clouts quiet, chains as `chain_colours` has them, `chosen` alone.

    (M, 3), or one for each triangle of the `coarse` patch.
    """
    quiet, united = palette(dark), comparison.united
    triangles, chain = united.triangles, united.chain
    if coarse is not None:
        triangles, chain = triangles[coarse.source], chain[coarse.source]
    seen = np.bitwise_and.reduce(united.label[triangles], axis=1)
    table = np.array([quiet.shared, quiet.surface_1, quiet.surface_2, quiet.shared], np.uint8)
    colours = table[seen]
    inside = chain >= 0
    colours[inside] = chain_colours(chains, by, end, dark=dark)[chain[inside]]
    if chosen is not None:
        colours = faded(colours, chain != chosen, quiet.background)
    return colours


def heatmap_colours(
    comparison: Comparison,
    heatmap: Heatmap,
    scale: Scale,
    brush: tuple[float, float] | None,
    dark: bool,
    coarse: Coarse | None = None,
) -> Colours:
    """Return the colours of the heatmap; what lies outside `brush` fades.

    (M, 3), or one for each triangle of the `coarse` patch.
    """
    quiet = palette(dark)
    values = values_of(comparison, heatmap, None if coarse is None else coarse.source)
    if heatmap is Heatmap.TRUST:
        table = np.array([*TRUST_COLOURS.values(), quiet.no_data], np.uint8)
        colours = table[values.astype(np.intp)]
    elif not heatmap.of_difference:
        low, high = height_range(comparison)
        colours = spread(values, low, high, height_map(), quiet.no_data)
    else:
        colours = coloured(values, scale, quiet.no_data)
    if brush is not None:
        with np.errstate(invalid="ignore"):
            outside = ~((values >= brush[0]) & (values <= brush[1]))
        colours = faded(colours, outside, quiet.background)
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
