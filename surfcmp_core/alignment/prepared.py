"""One surface made ready for the search of closest points."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from small_gicp import KdTree, PointCloud, estimate_normals_covariances

from surfcmp_core.compiled.linear_algebra import length
from surfcmp_core.errors import InputError
from surfcmp_core.surface import Surface
from surfcmp_core.surface.used import nodes_in_use, used_part

FEWEST = 10
"""Nodes that must be left to find six unknowns with some certainty."""
_NEIGHBOURS = 10
"""Nodes that give a tangent plane."""
_MOVING = 100_000
"""Most nodes that are moved; the surface they are moved onto is used whole."""


@dataclass(frozen=True, slots=True, eq=False)
class Prepared:
    """A surface's nodes, their tangent planes, and which of them may be used.

    Attributes
    ----------
    name : str
        How messages call the surface.
    places : (n, 3) float64
        Nodes, measured from the common origin.
    normals : (n, 3) float64
        Unit, of either sign.
    spacing : (n,) float64
        Distance to the neighbours.
    may : (n,) bool
        Nodes that may be used: of the region.
    inner : (n,) bool
        Those of them that are not on a mesh's border.
    moving : (k, 3) float64
        The places of those that are moved.
    tree : small_gicp.KdTree
        Finds the nearest of `places`.
    """

    name: str
    places: NDArray[np.float64]
    normals: NDArray[np.float64]
    spacing: NDArray[np.float64]
    may: NDArray[np.bool_]
    inner: NDArray[np.bool_]
    moving: NDArray[np.float64]
    tree: Any

    @property
    def extent(self) -> float:
        """Diagonal of the box around the nodes that are moved."""
        return length(np.ptp(self.moving, axis=0))

    def nearest(self, places: NDArray[np.float64]) -> NDArray[np.intp]:
        """Give the node nearest to each place."""
        return np.asarray(self.tree.batch_nearest_neighbor_search(places)[0], np.intp)


def prepared(
    surface: Surface, region: NDArray[np.bool_] | None, origin: NDArray[np.float64]
) -> Prepared:
    """Make a surface ready.

    Parameters
    ----------
    surface : Surface
        Without nodes that no triangle uses (:func:`used_of`).
    region : (n,) bool, optional
        Nodes that may be used.
    origin : (3,) float64
        Near the surface: far from it, digits are lost.

    Returns
    -------
    Prepared

    Raises
    ------
    InputError
        The region leaves too few nodes.
    """
    may = _may_be_used(surface, region)
    places = surface.points - origin
    cloud = PointCloud(places)
    tree = KdTree(cloud)
    estimate_normals_covariances(cloud, tree, num_neighbors=_NEIGHBOURS)
    squares = np.asarray(tree.batch_knn_search(places, 4)[1])[:, 1:]
    moving = places[may]
    return Prepared(
        surface.name,
        places,
        cloud.normals()[:, :3],
        np.sqrt(squares.mean(axis=1)),
        may,
        may & ~_on_border(surface),
        moving[:: -(-len(moving) // _MOVING)],
        tree,
    )


def used_of(
    surface: Surface, region: NDArray[np.bool_] | None
) -> tuple[Surface, NDArray[np.bool_] | None]:
    """Leave out what is no part of a surface, in its region too.

    Parameters
    ----------
    surface : Surface
        n nodes.
    region : (n,) bool, optional

    Returns
    -------
    Surface
        Its :func:`surfcmp_core.surface.used.used_part`, k nodes.
    (k,) bool or None
        The region's part of them.

    Raises
    ------
    InputError
        The region is not one bool for each node.
    """
    used = used_part(surface)
    if region is None:
        return used, None
    region = np.asarray(region)
    if region.dtype != np.bool_ or region.shape != (len(surface.points),):
        raise InputError("the region is not one bool for each node", where=(surface.name,))
    return used, region if used is surface else region[nodes_in_use(surface)]


def _may_be_used(surface: Surface, region: NDArray[np.bool_] | None) -> NDArray[np.bool_]:
    may = np.ones(len(surface.points), bool) if region is None else region
    if np.count_nonzero(may) < FEWEST:
        raise InputError(
            f"{np.count_nonzero(may)} nodes to align; at least {FEWEST} are needed",
            where=(surface.name,),
        )
    return may


def _on_border(surface: Surface) -> NDArray[np.bool_]:
    """Give the nodes of edges that one triangle alone has; none of a cloud."""
    border = np.zeros(len(surface.points), bool)
    if surface.faces is not None:
        faces = surface.faces.astype(np.int64)
        ends = np.concatenate((faces[:, :2], faces[:, 1:], faces[:, ::2]))
        keys, counts = np.unique(
            ends.min(axis=1) * len(border) + ends.max(axis=1), return_counts=True
        )
        lone = keys[counts == 1]
        border[lone // len(border)] = True
        border[lone % len(border)] = True
    return border
