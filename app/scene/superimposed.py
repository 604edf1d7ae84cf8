"""From a comparison and how it is looked at to both scans in one scene."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.model.superimposition import Cut, Style, Superimposition
from app.scene.coarse import Coarse
from app.scene.content import Content
from app.scene.geometry import Patch
from app.scene.lines import Segments
from app.scene.profile import Profile, profile_of
from app.scene.quiet_colours import palette
from surfcmp_core.colours.maps import Colours, Rgb
from surfcmp_core.colours.scale import Scale, coloured
from surfcmp_core.compiled.linear_algebra import applied, composed, inverse

if TYPE_CHECKING:
    from surfcmp_core.comparing.comparison import Comparison

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Skin:
    """One scan as it is drawn: its own triangles, where it has data.

    Attributes
    ----------
    points, normals : (n, 3) float32
        In the scene's coordinates.
    triangles : (m, 3) int32
    coarse : (k, 3) int32 or None
        Triangles drawn in their place while the camera moves.
    colours : (m, 3) uint8, or one colour for all
    opacity : float
    style : Style
    """

    points: NDArray[np.float32]
    normals: NDArray[np.float32]
    triangles: NDArray[np.int32]
    coarse: NDArray[np.int32] | None
    colours: Colours | Rgb
    opacity: float
    style: Style


@dataclass(frozen=True, slots=True, eq=False)
class Superimposed:
    """Both scans, and the plane that cuts them.

    Attributes
    ----------
    skins : two Skin
    plane : (axis, coordinate) or None
        What lies below it is drawn.
    curves : two (k, 2, 3) float32
        Where the plane cuts each scan.
    curve_colours : two colours
    background : colour
    perspective : bool
    """

    skins: tuple[Skin, Skin]
    plane: tuple[int, float] | None
    curves: tuple[Segments, Segments]
    curve_colours: tuple[Rgb, Rgb]
    background: Rgb
    perspective: bool


def superimposed(
    content: Content, scale: Scale, wish: Superimposition, *, dark: bool
) -> Superimposed:
    """Return both scans as they are to be drawn.

    Parameters
    ----------
    content : Content
    scale : Scale
        Of the differences' colours.
    wish : Superimposition
    dark : bool
        In a dark window.
    """
    quiet = palette(dark)
    plane = None
    if wish.cut is not None:
        plane = wish.cut.axis, place_of(content, wish.cut)
    skins, curves = [], []
    for surface, colour in enumerate((quiet.surface_1, quiet.surface_2)):
        patch = content.geometry.patches[surface]
        points = patch.points
        if surface == 1 and wish.before:
            points = content.once(_before, content, patch)
        colours: Colours | Rgb = colour
        triangles = content.once(_with_data, patch)
        if wish.coats[surface].heatmap:
            found = content.once(_painted, content, surface, scale, quiet.no_data)
            colours = found if patch.data is None else found[patch.data]
        coat = wish.coats[surface]
        coarse = None if patch.coarse is None else content.once(_coarse, patch.coarse)
        opacity = wish.opacity(surface)
        skins.append(Skin(points, patch.normals, triangles, coarse, colours, opacity, coat.style))
        curves.append(cut_of(points, triangles, *plane) if plane else NO_CURVE)
    return Superimposed(
        (skins[0], skins[1]),
        plane,
        (curves[0], curves[1]),
        (quiet.node_1, quiet.node_2),
        quiet.background,
        wish.perspective,
    )


NO_CURVE: Segments = np.zeros((0, 2, 3), dtype=np.float32)


def place_of(content: Content, cut: Cut) -> float:
    """Return the coordinate at which a plane cuts, in the scene's coordinates."""
    low, high = content.geometry.low[cut.axis], content.geometry.high[cut.axis]
    return float(low + cut.share * (high - low))


def profile_on(content: Content, cut: Cut) -> Profile:
    """Return the profiles of both surfaces along a cut, in the comparison's coordinates."""
    geometry = content.geometry
    at = place_of(content, cut) + geometry.origin[cut.axis]
    other = 1 - cut.axis
    ends = (geometry.low + geometry.origin)[other], (geometry.high + geometry.origin)[other]
    line = [0.0, 0.0, 0.0, 0.0]
    line[cut.axis] = line[2 + cut.axis] = float(at)
    line[other], line[2 + other] = float(ends[0]), float(ends[1])
    return profile_of(content.comparison, (line[0], line[1], line[2], line[3]), geometry)


def cut_of(
    points: NDArray[np.float32], triangles: NDArray[np.int32], axis: int, place: float
) -> Segments:
    """Return (k, 2, 3) the segments in which a plane cuts triangles.

    Parameters
    ----------
    points : (n, 3) float32
    triangles : (m, 3) int32
    axis : int
        The plane's normal.
    place : float
        The coordinate of its points along that axis.
    """
    above = points[:, axis] > place
    count = above[triangles].sum(axis=1)
    hit = triangles[(count == 1) | (count == 2)]
    if not len(hit):
        return NO_CURVE
    lone = np.where(above[hit].sum(axis=1) == 1, above[hit].T, ~above[hit].T).T.argmax(axis=1)
    rows = np.arange(len(hit))
    tip = points[hit[rows, lone]].astype(np.float64)
    ends = []
    for step in (1, 2):
        base = points[hit[rows, (lone + step) % 3]].astype(np.float64)
        share = (place - tip[:, axis]) / (base[:, axis] - tip[:, axis])
        ends.append(tip + share[:, None] * (base - tip))
    return np.stack(ends, axis=1).astype(np.float32)


def difference_at(
    comparison: Comparison, surface: int, triangle: NDArray[np.int32], place: Floats
) -> float:
    """Return d at a place (x, y) of the comparison, on one of a scan's triangles; NaN without data.

    Parameters
    ----------
    triangle : (3,) int32
        Nodes of the scan's grid.
    place : (2,) float64
    """
    nodes = comparison.grids[surface].nodes[triangle]
    sides = (nodes[1:] - nodes[0]).T
    try:
        one, two = np.linalg.solve(sides, place - nodes[0])
    except np.linalg.LinAlgError:
        return float("nan")
    d = _differences(comparison, surface)[triangle]
    return float(d[0] + one * (d[1] - d[0]) + two * (d[2] - d[0]))


def _differences(comparison: Comparison, surface: int) -> Floats:
    """(n,) d at the nodes of a scan."""
    united = comparison.united
    own = (united.node_1, united.node_2)[surface]
    return np.asarray(comparison.z1[own] - comparison.z2[own])


def _coarse(coarse: Coarse) -> NDArray[np.int32]:
    """(k, 3) the coarse triangles, in numbers of the patch's own nodes."""
    return np.ascontiguousarray(coarse.nodes[coarse.triangles], dtype=np.int32)


def _with_data(patch: Patch) -> NDArray[np.int32]:
    if patch.data is None:
        return patch.triangles
    return np.ascontiguousarray(patch.triangles[patch.data])


def _painted(content: Content, surface: int, scale: Scale, missing: Rgb) -> Colours:
    d = _differences(content.comparison, surface)
    values = d[content.geometry.patches[surface].triangles].mean(axis=1)
    return coloured(values if scale.signed else np.abs(values), scale, missing)


def _before(content: Content, patch: Patch) -> NDArray[np.float32]:
    """Return the nodes of surface 2 where they lay before it was moved onto surface 1."""
    comparison, origin = content.comparison, content.geometry.origin
    back = composed(comparison.frame, inverse(comparison.transform))
    points = applied(back, patch.points + origin) - origin
    return np.asarray(points, np.float32)
