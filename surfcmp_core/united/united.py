"""The united triangulation with provenance and chains."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, eq=False)
class United:
    """The Delaunay triangulation T of both grids (paper: the general triangulation).

    Attributes
    ----------
    nodes : (N, 2) float64
        All nodes of grid 1, then those of grid 2 that are not shared.
    label : (N,) uint8
        1: node of G1 alone, 2: of G2 alone, 3: shared.
    node_1, node_2 : (n1,), (n2,) int32
        Number in `nodes` of each node of grid 1 and of grid 2.
    triangles : (M, 3) int32
        Counter-clockwise; triangles of one chain stand together, in the order of the chain.
    origin : (M,) uint8
        Bit 1: triangle of T1, bit 2: of T2, 0: of neither.
    chain : (M,) int32
        Number of its chain, -1 for none.
    chain_closed : (C,) bool
        Whether the chain returns to its first triangle; an open one ends on the hull of T
        or at shared nodes.
    tree1, tree2 : (n1 - 1, 2), (n2 - 1, 2) int32
        Minimum spanning trees of T1 and T2, in numbers of `nodes`.
    """

    nodes: NDArray[np.float64]
    label: NDArray[np.uint8]
    node_1: NDArray[np.int32]
    node_2: NDArray[np.int32]
    triangles: NDArray[np.int32]
    origin: NDArray[np.uint8]
    chain: NDArray[np.int32]
    chain_closed: NDArray[np.bool_]
    tree1: NDArray[np.int32]
    tree2: NDArray[np.int32]

    @property
    def representative(self) -> NDArray[np.bool_]:
        """(M,) bool: triangles whose nodes include one of G1 and one of G2 (formula (3))."""
        seen = np.bitwise_or.reduce(self.label[self.triangles], axis=1)
        return np.asarray(seen == 3)
