"""From a surface to its grid: distinct nodes in the order of a space-filling curve."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel
from surfcmp_core.errors import InputError
from surfcmp_core.grid.curve import curve_keys
from surfcmp_core.surface import Duplicates, Surface
from surfcmp_core.surface.used import repeated_triangles


@dataclass(frozen=True, slots=True, eq=False)
class Grid:
    """Distinct nodes of one surface (paper: G1 or G2, definition 1) with their values.

    Attributes
    ----------
    nodes : (n, 2) float64
        x, y, bit for bit the input's; no two rows equal; along a Hilbert curve.
    z : (n,) float64
        The surface's value F at each node.
    source : (n,) int64
        Row of the surface's `points` each node came from (the first of merged ones).
    faces : (m, 3) int32 or None
        The model's own triangles in node numbers, as the file turns them, without those that
        merging made lines or equal to earlier ones; None for a cloud.
    merged : int
        Nodes of the surface merged into another one of equal (x, y).
    keys : (n,) uint64
        Place along the curve, ascending; nodes of one key stand in lexicographic order.
    name : str
        How messages call the surface.
    """

    nodes: NDArray[np.float64]
    z: NDArray[np.float64]
    source: NDArray[np.int64]
    faces: NDArray[np.int32] | None
    merged: int
    keys: NDArray[np.uint64]
    name: str


_CROWDED = 64
"""Nodes in one cell of the curve from which on sorting them one by one would not be linear."""


@kernel
def _longest_run(keys: NDArray[np.uint64], order: NDArray[np.int64]) -> int:
    longest = 0
    begin = 0
    for k in range(order.size):
        if keys[order[k]] != keys[order[begin]]:
            begin = k
        longest = max(longest, k + 1 - begin)
    return longest


@kernel
def _runs(
    nodes: NDArray[np.float64],
    keys: NDArray[np.uint64],
    order: NDArray[np.int64],
    starts: NDArray[np.int64],
) -> int:
    """Make `order`, sorted by key, lexicographic within a key; find where equal nodes start.

    Equal nodes come in the order of the input.
    """
    count = 0
    begin = 0
    while begin < order.size:
        end = begin + 1
        while end < order.size and keys[order[end]] == keys[order[begin]]:
            end += 1
        for i in range(begin + 1, end):
            moving = order[i]
            x, y = nodes[moving, 0], nodes[moving, 1]
            j = i
            while j > begin:
                other = order[j - 1]
                if nodes[other, 0] < x or (
                    nodes[other, 0] == x
                    and (nodes[other, 1] < y or (nodes[other, 1] == y and other < moving))
                ):
                    break
                order[j] = other
                j -= 1
            order[j] = moving
        for i in range(begin, end):
            if (
                i == begin
                or nodes[order[i], 0] != nodes[order[i - 1], 0]
                or nodes[order[i], 1] != nodes[order[i - 1], 1]
            ):
                starts[count] = i
                count += 1
        begin = end
    return count


def _merged_values(
    z: NDArray[np.float64], starts: NDArray[np.int64], duplicates: Duplicates, name: str
) -> NDArray[np.float64]:
    highest = np.maximum.reduceat(z, starts)
    lowest = np.minimum.reduceat(z, starts)
    torn = int(np.count_nonzero(highest != lowest))
    if torn and duplicates == "refuse":
        raise InputError(
            f"not one-valued: {torn} places (x, y) have nodes of different z "
            "(choose what to do with --duplicates mean, max or min)",
            where=(name,),
        )
    if duplicates == "max":
        return highest
    if duplicates == "min" or not torn:
        return lowest
    counts = np.diff(np.append(starts, len(z)))
    mean = np.add.reduceat(z, starts) / counts
    return np.where(highest == lowest, lowest, mean)


def grid_of(
    surface: Surface,
    *,
    duplicates: Duplicates = "refuse",
    box: tuple[float, float, float, float] | None = None,
) -> Grid:
    """Make the grid of a surface.

    Parameters
    ----------
    surface : Surface
        z = F(x, y); finite.
    duplicates : {"refuse", "mean", "max", "min"}
        Value of a place (x, y) that has nodes of different z. Nodes of equal z are merged always.
    box : tuple of float, optional
        Box of the curve, smallest x, y, largest x, y; both grids of a comparison share one, so that
        they run through memory side by side.

    Returns
    -------
    Grid

    Raises
    ------
    InputError
        Fewer than three distinct nodes; different values at one place under "refuse".
    """
    nodes = np.ascontiguousarray(surface.points[:, :2])
    z = surface.points[:, 2]
    if len(nodes) < 3:
        raise InputError(f"{len(nodes)} nodes; at least 3 are needed", where=(surface.name,))
    if box is None:
        box = box_of(surface)
    keys = curve_keys(nodes, box)
    order = np.argsort(keys)
    if _longest_run(keys, order) > _CROWDED:  # one node far away puts all others into one cell
        order = np.lexsort((nodes[:, 1], nodes[:, 0], keys))
    starts = np.empty(len(order), np.int64)
    starts = starts[: _runs(nodes, keys, order, starts)]
    source = order[starts]
    if len(starts) < 3:
        fault = f"{len(starts)} distinct nodes; at least 3 are needed"
        raise InputError(fault, where=(surface.name,))
    merged = len(nodes) - len(starts)
    values = _merged_values(z[order], starts, duplicates, surface.name) if merged else z[order]
    faces = None
    if surface.faces is not None:
        number = np.empty(len(nodes), np.int32)
        number[order] = np.repeat(
            np.arange(len(starts), dtype=np.int32), np.diff(np.append(starts, len(nodes)))
        )
        faces = number[surface.faces]
        a, b, c = faces.T
        faces = faces[(a != b) & (b != c) & (c != a)]  # those that stood upright are lines now
        if merged:  # and layers above each other are one
            faces = np.delete(faces, repeated_triangles(nodes[source], faces), axis=0)
    return Grid(nodes[source], values, source, faces, merged, keys[source], surface.name)


def box_of(*surfaces: Surface) -> tuple[float, float, float, float]:
    """Smallest x and y, largest x and y of all nodes."""
    columns = [[surface.points[:, axis] for surface in surfaces] for axis in (0, 1)]
    low = [min(float(column.min()) for column in axis) for axis in columns]
    high = [max(float(column.max()) for column in axis) for axis in columns]
    return low[0], low[1], high[0], high[1]
