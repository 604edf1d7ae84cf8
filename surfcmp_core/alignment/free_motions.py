"""Motions of a surface over another that their form does not hold.

Of all motions in which the nodes move by 1 in the mean (root mean square), those are free in which
hardly anything of that leads along the normals: a sphere turns about its middle, a cylinder turns
about its axis and slides along it, a plane slides on itself.
"""

import math

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.linear_algebra import dots, eigen

_FREE = 1e-4
"""A motion of which less than this share (squared) leads along the normals is free."""
_AT_MOST = 1e-2
_OF_NOISE = 0.6
"""So is one of less than this share, and less than this part of what noise makes of normals."""
_ALONE = 4e-2
"""Nor may more of it lead along the nodes' own normals: partners may be the wrong ones."""
_SLIDE = 1e-2
"""Squared turn, over the surface's size, below which a motion is a shift."""
_ALONG = 0.999
"""Cosine to an axis from which on a direction is called by its name."""


def free_motions(
    places: NDArray[np.float64],
    own: NDArray[np.float64],
    partners: NDArray[np.float64],
    unevenness: float,
) -> tuple[str, ...]:
    """Name the motions that nothing holds.

    What a motion has along the normals is measured by the nodes' own normals times those of their
    partners: the noise of the two surfaces is not the same, and does not hold.

    Parameters
    ----------
    places : (k, 3) float64
        Nodes that have partners.
    own, partners : (k, 3) float64
        Unit normals of the nodes and of their partners, of either sign.
    unevenness : float
        Squared sine between neighbours' normals.

    Returns
    -------
    tuple of str
        "turn about x", "slide along (0.71, 0.00, 0.71)"; x, y, z are the coordinates' axes.

    References
    ----------
    [Gelfand2003]; [GelfandGuibas2004].
    """
    if len(places) == 0:
        return ()
    cosine = dots(own, partners)
    own = np.where(cosine < 0.0, -1.0, 1.0)[:, None] * own
    noise = max(float(np.median(np.maximum(1.0 - cosine * cosine, 0.0))), unevenness)
    at = places - places.mean(axis=0)
    size = math.sqrt(float(dots(at, at).mean()))
    if size == 0.0:
        return ()
    at = at / size
    inertia = np.eye(3) - (at[:, :, None] * at[:, None, :]).mean(axis=0)
    spread, axes = eigen(inertia)
    unit = np.zeros((6, 6))  # six motions, in columns, each of which moves the nodes by 1
    unit[:3, :3] = axes / np.sqrt(np.maximum(spread, 1e-12))
    unit[3:, 3:] = np.eye(3)
    one, other = _along(at, own, unit), _along(at, partners, unit)
    held = (one[:, :, None] * other[:, None, :]).mean(axis=0)
    shares, motions = eigen((held + held.T) / 2.0)
    alone = np.square(_product(one, motions)).mean(axis=0)
    free = (shares < max(_FREE, min(_AT_MOST, _OF_NOISE * noise))) & (alone < _ALONE)
    return _named(_product(unit, motions[:, free]))


def _along(
    at: NDArray[np.float64], normals: NDArray[np.float64], unit: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Give what each of the six motions has along the normal of each node: (k, 6)."""
    slopes = np.concatenate((np.cross(at, normals), normals), axis=1)
    return _product(slopes, unit)


def _product(one: NDArray[np.float64], other: NDArray[np.float64]) -> NDArray[np.float64]:
    """Multiply matrices by sums of a fixed order."""
    return (one[:, :, None] * other[None, :, :]).sum(axis=1)


def _named(motions: NDArray[np.float64]) -> tuple[str, ...]:
    """Tell turns from slides among motions, (6, m): all that they span is free."""
    if motions.shape[1] == 0:
        return ()
    turns, shifts = motions[:3], motions[3:]
    squares, mixtures = eigen(_product(turns.T, turns))
    slides = squares < _SLIDE
    return (
        *(f"turn about {name}" for name in _directions(_product(turns, mixtures[:, ~slides]))),
        *(f"slide along {name}" for name in _directions(_product(shifts, mixtures[:, slides]))),
    )


def _directions(vectors: NDArray[np.float64]) -> list[str]:
    """Name directions that span the same as some vectors, (3, m); axes where there are some."""
    if vectors.shape[1] == 0:
        return []
    _, basis = eigen(_product(vectors, vectors.T))
    left = basis[:, 3 - min(vectors.shape[1], 3) :]
    names = []
    while left.shape[1]:
        lengths = (left * left).sum(axis=1)
        axis = int(np.argmax(np.round(lengths, 6)))
        way = _product(left, left[axis][:, None])[:, 0] / math.sqrt(float(lengths[axis]))
        names.append((axis, _name(way)))
        # what is left is at right angles to it
        rest = left - way[:, None] * _product(way[None, :], left)
        _, turned_basis = eigen(_product(rest, rest.T))
        left = turned_basis[:, 4 - left.shape[1] :]
    return [name for _, name in sorted(names)]


def _name(way: NDArray[np.float64]) -> str:
    axis = int(np.argmax(np.abs(way)))
    if abs(float(way[axis])) > _ALONG:
        return "xyz"[axis]
    way = way * math.copysign(1.0, float(way[axis]))
    return "(" + ", ".join(f"{part + 0.0:.2f}" for part in way) + ")"
