"""From a comparison and how it is looked at to both scans in one scene."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.model.superimposition import Cut, Style, Superimposition
from app.scene.coarse import Coarse
from app.scene.content import Content
from app.scene.geometry import Geometry, Patch
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
        plane = wish.cut.axis, place_of(content.geometry, wish.cut)
    comparison, geometry, once = content.comparison, content.geometry, content.once
    skins, curves = [], []
    for surface, colour in enumerate((quiet.surface_1, quiet.surface_2)):
        patch, coat = geometry.patches[surface], wish.coats[surface]
        points, before = patch.points, wish.before and surface == 1
        if before:
            points = once(_before, comparison, geometry)
        colours: Colours | Rgb = colour
        triangles = once(_with_data, patch)
        if coat.heatmap:
            colours = once(_painted, comparison, geometry, surface, scale, quiet.no_data)
        coarse = None if patch.coarse is None else once(_coarse, patch.coarse)
        opacity = wish.opacity(surface)
        skins.append(Skin(points, patch.normals, triangles, coarse, colours, opacity, coat.style))
        curves.append(
            once(_curve, comparison, geometry, surface, before, *plane) if plane else NO_CURVE
        )
    return Superimposed(
        (skins[0], skins[1]),
        plane,
        (curves[0], curves[1]),
        (quiet.node_1, quiet.node_2),
        quiet.background,
        wish.perspective,
    )


NO_CURVE: Segments = np.zeros((0, 2, 3), dtype=np.float32)


def place_of(geometry: Geometry, cut: Cut) -> float:
    """Return the coordinate at which a plane cuts, in the scene's coordinates."""
    low, high = geometry.low[cut.axis], geometry.high[cut.axis]
    return float(low + cut.share * (high - low))


def profile_on(comparison: Comparison, geometry: Geometry, cut: Cut) -> Profile:
    """Return the profiles of both surfaces along a cut, in the comparison's coordinates."""
    at = place_of(geometry, cut) + geometry.origin[cut.axis]
    other = 1 - cut.axis
    ends = (geometry.low + geometry.origin)[other], (geometry.high + geometry.origin)[other]
    line = [0.0, 0.0, 0.0, 0.0]
    line[cut.axis] = line[2 + cut.axis] = float(at)
    line[other], line[2 + other] = float(ends[0]), float(ends[1])
    return profile_of(comparison, (line[0], line[1], line[2], line[3]), geometry)


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


def _curve(
    comparison: Comparison, geometry: Geometry, surface: int, before: bool, axis: int, place: float
) -> Segments:
    patch = geometry.patches[surface]
    points = _before(comparison, geometry) if before else patch.points
    return cut_of(points, _with_data(patch), axis, place)


def _painted(
    comparison: Comparison, geometry: Geometry, surface: int, scale: Scale, missing: Rgb
) -> Colours:
    """(m, 3) the colours of the differences, of the triangles with data."""
    d = _differences(comparison, surface)
    values = d[_with_data(geometry.patches[surface])].mean(axis=1)
    return coloured(values if scale.signed else np.abs(values), scale, missing)


def _before(comparison: Comparison, geometry: Geometry) -> NDArray[np.float32]:
    """Return the nodes of surface 2 where they lay before it was moved onto surface 1."""
    back = composed(comparison.frame, inverse(comparison.transform))
    points = applied(back, geometry.patches[1].points + geometry.origin) - geometry.origin
    return np.asarray(points, np.float32)
