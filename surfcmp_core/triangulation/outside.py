"""Large grids are triangulated in a process of their own.

The library holds Python's lock all the while it works: within this process it would keep the window
from answering and the other grid from being triangulated meanwhile.
"""

import subprocess
import sys

import numpy as np
from numpy.typing import NDArray

WORTH_A_PROCESS = 300_000
"""Nodes from which on the work takes longer than to start a process for it."""

_PROGRAM = """
import sys
import numpy as np
from triangular import delaunay
nodes = np.frombuffer(sys.stdin.buffer.read()).reshape(-1, 2)
sys.stdout.buffer.write(np.ascontiguousarray(delaunay(nodes), np.int32))
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
    """
    if not sys.executable:
        return None
    try:
        done = subprocess.run(
            [sys.executable, "-c", _PROGRAM],
            input=np.ascontiguousarray(nodes).data.cast("B"),
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            check=True,
        )
    except (OSError, subprocess.CalledProcessError):
        return None
    return np.frombuffer(bytearray(done.stdout), np.int32).reshape(-1, 3)
