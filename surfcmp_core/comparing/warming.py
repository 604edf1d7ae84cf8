"""First use: another process compiles the later stages while this one compiles the first.

numba compiles one kernel at a time in a process; both leave what they compile in the same cache.
"""

import contextlib
import os
import subprocess
import sys
import threading
from functools import cache
from pathlib import Path
from typing import BinaryIO

import numpy as np

import surfcmp_core.compiled.kernel  # noqa: F401 - says where the cache is
from surfcmp_core.domain import footprint_of_cloud, reasons
from surfcmp_core.domain.footprint import states_at, states_of_triangles
from surfcmp_core.errors import Cancelled
from surfcmp_core.interpolation import interpolate
from surfcmp_core.localisation import locate_along_tree
from surfcmp_core.measures import Covered, hausdorff, measure, triangle_areas
from surfcmp_core.system.children import child
from surfcmp_core.system.lock import make_held, take_over
from surfcmp_core.triangulation import Triangulation

_PROGRAM = "from surfcmp_core.comparing.warming import compile_once; compile_once()"


@cache
def begin_to_compile() -> None:
    """Start the other process, where there is a second processor for it, and leave it to itself.

    Once: many comparisons may begin before the first one ends, or end at once.
    """
    if sys.executable and (os.cpu_count() or 1) > 1:
        threading.Thread(target=_run, name="compiling", daemon=True).start()


def _run() -> None:
    with (
        contextlib.suppress(OSError, Cancelled),  # what is not compiled there is compiled here
        child(_PROGRAM, pipe=subprocess.DEVNULL) as process,
    ):
        process.wait()


def compile_once() -> None:
    """Compile the later stages, unless some other process is at it for the same cache."""
    held = _held(Path(os.environ["NUMBA_CACHE_DIR"]) / "compiling")
    if held is not None:
        with held:
            compile_later_stages()


def _held(path: Path) -> BinaryIO | None:
    with contextlib.suppress(OSError):
        return take_over(path) if path.exists() else make_held(path)
    return None


def compile_later_stages() -> None:
    """Locate, interpolate and measure on one triangle: what comes after trees and chains."""
    nodes = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    z = np.array([0.0, 1.0, 2.0])
    start = np.array([0, 1, 2, 1, 0, -1, 2, 1, -1, 0, 2, -1], np.int32)
    twin = np.array([3, 6, 9, 0, 11, 7, 1, 5, 10, 2, 8, 4], np.int32)
    t = Triangulation(nodes, start, twin, 1)
    tree = np.array([[0, 1], [0, 2]], np.int32)
    found = locate_along_tree(t, nodes, tree)
    filled = interpolate(t, z, nodes, found)
    hausdorff(nodes, z, nodes, z, t, found)
    footprint = footprint_of_cloud(t, tree, None)
    at_nodes = states_at(footprint, nodes, found)
    triangles = t.triangles.copy()
    states = states_of_triangles(footprint, nodes, triangles, at_nodes, found, ask_centroids=True)
    compared = reasons(states, states, triangle_areas(nodes, triangles)) == 0
    measure(
        nodes,
        np.array([1, 2, 3], np.uint8),
        triangles,
        filled,
        z + 0.5,
        compared,
        tolerances=(1.0,),
        footprint_1=Covered(1.0),
        footprint_2=Covered(1.0),
        hausdorff=(0.0, 0.0),
    )
