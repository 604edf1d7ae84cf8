"""How well one surface lies on another, looked at from both."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.alignment.free_motions import free_motions
from surfcmp_core.alignment.prepared import Prepared
from surfcmp_core.compiled.linear_algebra import dots, length, turned

_LOOKED_AT = 5_000
"""Nodes of each surface that are looked at."""
_BESIDE = 2.0
"""A node this many local spacings beside its partner lies beyond the border."""
_AROUND = 6
"""Neighbours whose directions tell how well a surface's own nodes hold its form."""


@dataclass(frozen=True, slots=True)
class Account:
    """What speaks for a pose and against it; the fields of an `Alignment` by their names."""

    overlaps: tuple[float, float]
    agreement: float
    turned: float
    shifted: float
    free: tuple[str, ...]


@dataclass(frozen=True, slots=True, eq=False)
class _Paired:
    """Nodes of one surface that have a partner: (k, 3) places, directions, and the partners'."""

    share: float
    places: NDArray[np.float64]
    own: NDArray[np.float64]
    partners: NDArray[np.float64]


def account_of(sides: tuple[Prepared, Prepared], motion: NDArray[np.float64]) -> Account:
    """Look at a pose from both surfaces.

    Parameters
    ----------
    sides : two Prepared
    motion : (4, 4) float64
        Of surface 2, in the coordinates of the sides: from where it started.

    Returns
    -------
    Account
        Its `agreement` is 1 - s / s0, the smaller of both ways: s is the median sine of the angle
        between partners' normals, s0 that of the same nodes paired by chance.
    """
    second = sides[1]
    ways = _both_ways(sides, motion)
    more = ways[0] if len(ways[0].places) >= len(ways[1].places) else ways[1]
    noise = max(_unevenness(side) for side in sides)
    middle = second.moving.mean(axis=0)
    way = turned(middle, motion[:3, :3]) + motion[:3, 3] - middle
    # the directions of free motions are those of surface 1
    onto_first = motion[:3, :3] if more is ways[0] else np.eye(3)
    return Account(
        (ways[0].share, ways[1].share),
        min(_agreement(way) for way in ways),
        angle_of(motion[:3, :3]),
        length(way),
        free_motions(
            turned(more.places, onto_first),
            turned(more.own, onto_first),
            turned(more.partners, onto_first),
            noise,
        ),
    )


def agreement_of(sides: tuple[Prepared, Prepared], motion: NDArray[np.float64]) -> float:
    """Give the `agreement` of a pose alone."""
    return min(_agreement(way) for way in _both_ways(sides, motion))


def _both_ways(
    sides: tuple[Prepared, Prepared], motion: NDArray[np.float64]
) -> tuple[_Paired, _Paired]:
    first, second = sides
    back = motion[:3, :3].T
    return (
        _paired(first, second, back, -turned(motion[:3, 3], back)),
        _paired(second, first, motion[:3, :3], motion[:3, 3]),
    )


def _chosen(side: Prepared) -> NDArray[np.intp]:
    may = np.flatnonzero(side.may)
    return may[:: -(-len(may) // _LOOKED_AT)]


def _paired(
    moving: Prepared, fixed: Prepared, rotation: NDArray[np.float64], shift: NDArray[np.float64]
) -> _Paired:
    nodes = _chosen(moving)
    at = turned(moving.places[nodes], rotation) + shift
    partner = fixed.nearest(at)
    normal = fixed.normals[partner]
    away = at - fixed.places[partner]
    off = dots(away, normal)
    aside = np.sqrt(np.maximum(dots(away, away) - off * off, 0.0))
    paired = fixed.inner[partner] & (aside <= _BESIDE * fixed.spacing[partner])
    return _Paired(
        float(paired.mean()),
        at[paired],
        turned(moving.normals[nodes[paired]], rotation),
        normal[paired],
    )


def _agreement(way: _Paired) -> float:
    count = len(way.own)
    if count == 0:
        return 0.0
    step = int(0.618 * count) | 1
    while math.gcd(step, count) > 1:
        step += 2
    by_chance = (np.arange(count) * step + count // 2) % count
    chance = _sine(way.own, way.partners[by_chance])
    # all of one direction: nothing that partners could agree about
    return max(1.0 - _sine(way.own, way.partners) / chance, 0.0) if chance > 1e-9 else 0.0


def _sine(one: NDArray[np.float64], other: NDArray[np.float64]) -> float:
    return math.sqrt(float(np.median(_square_sines(one, other))))


def _square_sines(one: NDArray[np.float64], other: NDArray[np.float64]) -> NDArray[np.float64]:
    cosine = dots(one, other)
    return np.maximum(1.0 - cosine * cosine, 0.0)


def _unevenness(side: Prepared) -> float:
    """Give the mean squared sine between a node's normal and those around it."""
    nodes = _chosen(side)
    around = np.asarray(side.tree.batch_knn_search(side.places[nodes], _AROUND + 1)[0], np.intp)
    return float(np.median(_square_sines(side.normals[nodes, None], side.normals[around[:, 1:]])))


def angle_of(rotation: NDArray[np.float64]) -> float:
    """Give the angle of a rotation in degrees, to the millionth."""
    cosine = (float(rotation[0, 0]) + float(rotation[1, 1]) + float(rotation[2, 2]) - 1.0) / 2.0
    against = rotation - rotation.T
    sine = length((against[2, 1], against[0, 2], against[1, 0]))
    return round(math.degrees(math.atan2(sine / 2.0, cosine)), 6)
