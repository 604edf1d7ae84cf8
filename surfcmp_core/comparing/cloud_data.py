"""Where a cloud has data when nothing is said of it."""

from dataclasses import dataclass

import numpy as np

from surfcmp_core.domain import footprint_of_cloud
from surfcmp_core.domain.layers import share_among_layers
from surfcmp_core.domain.spacing import limits_of_edges
from surfcmp_core.grid import grid_of, safe_scale
from surfcmp_core.measures import triangle_areas
from surfcmp_core.spanning_tree import spanning_tree, tree_ends
from surfcmp_core.surface import Surface
from surfcmp_core.triangulation import triangulate


@dataclass(frozen=True, slots=True, eq=False)
class CloudData:
    """Where a cloud has data, in short.

    Attributes
    ----------
    max_edge : float
        Longest edge over which it may have data, where its nodes lie farthest apart.
    usual_edge : float
        The same at half of its nodes or more.
    area, hull_area : float
        With data, and of the convex hull, in the plane.
    among_layers : float
        Share of its nodes that lie among nodes of another layer.
    """

    max_edge: float
    usual_edge: float
    area: float
    hull_area: float
    among_layers: float


def data_of_cloud(cloud: Surface) -> CloudData:
    """Tell how much of its convex hull a cloud has data in, seen along z, where nothing is said.

    Parameters
    ----------
    cloud : Surface
        Of nodes at one place the highest counts.

    Returns
    -------
    CloudData

    Raises
    ------
    InputError
        Nodes that cannot be triangulated.
    """
    grid = grid_of(cloud, duplicates="max")
    scale = safe_scale(grid.nodes)
    t = triangulate(grid.nodes * scale, name=cloud.name)
    tree = tree_ends(t, spanning_tree(t))
    usual = float(np.median(limits_of_edges(t, tree)))
    found = footprint_of_cloud(t, tree, None)
    hull = float(triangle_areas(t.nodes, t.triangles).sum())
    return CloudData(
        found.max_edge / scale,
        usual / scale,
        found.area / scale / scale,
        hull / scale / scale,
        share_among_layers(t, grid.z * scale),
    )
