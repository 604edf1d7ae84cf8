"""Large grids are triangulated in a process of their own.

The library holds Python's lock all the while it works: within this process it would keep the window
from answering and the other grid from being triangulated meanwhile.
"""

import sys
from io import BufferedReader, BufferedWriter
from typing import cast

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.system.children import child

WORTH_A_PROCESS = 300_000
"""Nodes from which on the work takes longer than to start a process for it."""

_PROGRAM = """
import sys
import numpy as np
from triangular import delaunay
nodes = np.empty((int(sys.argv[1]), 2))
if sys.stdin.buffer.readinto(nodes.data.cast("B")) < nodes.nbytes:
    sys.exit(1)
triangles = np.ascontiguousarray(delaunay(nodes), np.int32)
sys.stdout.buffer.write(len(triangles).to_bytes(8, "little"))
sys.stdout.buffer.write(triangles)
"""


def delaunay_outside(nodes: NDArray[np.float64]) -> NDArray[np.int32] | None:
    """Triangulate in another process.

    Parameters
    ----------
    nodes : (n, 2) float64

    Returns
    -------
    (m, 3) int32 or None
        None where no such process could be run.

    Raises
    ------
    Cancelled
        The work is given up.
    """
    if not sys.executable:
        return None
    try:
        with child(_PROGRAM, [str(len(nodes))]) as process:
            with cast(BufferedWriter, process.stdin) as to_child:
                to_child.write(np.ascontiguousarray(nodes).data)
            from_child = cast(BufferedReader, process.stdout)
            count = int.from_bytes(from_child.read(8), "little")
            flat = np.empty(3 * count, np.int32)
            whole = count > 0 and from_child.readinto(flat.data) == flat.nbytes
    except OSError:
        return None
    return flat.reshape(-1, 3) if whole and process.returncode == 0 else None
