"""Who goes first where several threads want a processor."""

import os
import sys
import threading

DRAWING, COMPUTING = 1, 3
"""How far pictures and computations step back behind the window's own thread.

A little is enough; more would starve them beside other programs.
"""


def give_way(steps: int) -> None:
    """Lower the calling thread's priority, and that of the threads it begins.

    Elsewhere than on Linux priorities belong to whole processes, and nothing is done.
    """
    if sys.platform == "linux":
        os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), steps)
