"""The Delaunay triangulation of one grid."""

from typing import NamedTuple

import numpy as np
import pythoncdt
import triangular
from numpy.typing import NDArray

from surfcmp_core.errors import InputError
from surfcmp_core.predicates import orientation
from surfcmp_core.triangulation.half_edges import half_edges
from surfcmp_core.triangulation.lawson import is_triangulation, make_delaunay
from surfcmp_core.triangulation.outside import WORTH_A_PROCESS, delaunay_outside


class Triangulation(NamedTuple):
    """The Delaunay triangulation of a grid under the perturbed predicate (paper: T1 or T2).

    Kernels take it as it is.

    Attributes
    ----------
    nodes : (n, 2) float64
        The grid's nodes.
    start : (3 (m + h),) int32
        Half-edges, three a triangle, half-edge ``3 t + i``: the node it starts from;
        the first m triangles are real and counter-clockwise, the last h are ghosts, one for
        each hull edge, whose third node is -1.
    twin : (3 (m + h),) int32
        The half-edge of the neighbouring triangle along the same edge; never -1.
    real : int
        m, the number of real triangles.
    """

    nodes: NDArray[np.float64]
    start: NDArray[np.int32]
    twin: NDArray[np.int32]
    real: int

    @property
    def triangles(self) -> NDArray[np.int32]:
        """(m, 3) int32, counter-clockwise."""
        return self.start[: 3 * self.real].reshape(-1, 3)


def _delaunay(nodes: NDArray[np.float64]) -> NDArray[np.int32]:
    if len(nodes) >= WORTH_A_PROCESS:
        found = delaunay_outside(nodes)
        if found is not None:
            return found
    return np.asarray(triangular.delaunay(nodes), np.int32)


def _slow_delaunay(nodes: NDArray[np.float64]) -> NDArray[np.int32]:
    order = pythoncdt.VertexInsertionOrder.AUTO
    crossing = pythoncdt.IntersectingConstraintEdges.NOT_ALLOWED
    builder = pythoncdt.Triangulation(order, crossing, 0.0)
    builder.insert_vertices(nodes)
    builder.erase_super_triangle()
    return np.array([triangle.vertices for triangle in builder.triangles], np.int32)


def _counter_clockwise(nodes: NDArray[np.float64], model: NDArray[np.int32]) -> NDArray[np.int32]:
    """Turn a model round as a whole where its first triangle looks the other way."""
    a, b, c = nodes[model[0]]
    clockwise = orientation(*a, *b, *c) < 0.0
    return np.ascontiguousarray(model[:, ::-1]) if clockwise else model


def _checked(nodes: NDArray[np.float64], triangles: NDArray[np.int32]) -> Triangulation | None:
    if len(triangles) == 0:
        return None
    edges = half_edges(triangles, len(nodes))
    if edges is None or not is_triangulation(nodes, *edges, len(triangles)):
        return None
    make_delaunay(nodes, *edges, len(triangles))
    return Triangulation(nodes, *edges, len(triangles))


def triangulate(
    nodes: NDArray[np.float64],
    *,
    name: str = "grid",
    model: NDArray[np.int32] | None = None,
) -> Triangulation:
    """Triangulate a grid.

    A library's triangles are never believed: they are verified exactly and brought into the
    unique Delaunay triangulation by Lawson flips.

    Parameters
    ----------
    nodes : (n, 2) float64
        Distinct, within the range of :func:`surfcmp_core.grid.safe_scale`; best along a
        space-filling curve.
    name : str
        How the message calls the grid.
    model : (m, 3) int32, optional
        Triangles of a model on these nodes; where they cover the convex hull they are taken and
        repaired in linear time, else the nodes are triangulated.

    Returns
    -------
    Triangulation

    Raises
    ------
    InputError
        Where all nodes are collinear, or no library gives a valid triangulation.

    References
    ----------
    Stage 1 of the paper's section 3.2.
    """
    if model is not None and len(model) >= len(nodes) - 2:
        found = _checked(nodes, _counter_clockwise(nodes, model))
        if found is not None:
            return found
    if is_flat(nodes):
        raise InputError("all nodes lie on one line in the plane", where=(name,))
    for builder in (_delaunay, _slow_delaunay):
        found = _checked(nodes, builder(nodes))
        if found is not None:
            return found
    raise InputError("no library triangulates these nodes correctly", where=(name,))


def is_flat(nodes: NDArray[np.float64]) -> bool:
    """Whether nodes cannot be triangulated: fewer than three, or all on one line.

    Parameters
    ----------
    nodes : (n, 2) float64
        Distinct.

    Returns
    -------
    bool
    """
    if len(nodes) < 3:
        return True
    (ax, ay), (bx, by) = nodes[0], nodes[1]
    return all(orientation(ax, ay, bx, by, x, y) == 0.0 for x, y in nodes[2:])
