"""How much memory a work needs, and whether there is as much: asked before anything is taken."""

import sys
from pathlib import Path

from surfcmp_core.errors import InputError

SMALL = 256 << 20
"""Bytes: works that need less are not asked about."""
_PROCESS_GROUPS = Path("/sys/fs/cgroup")
_OWN_GROUP = Path("/proc/self/cgroup")


def need_memory(needed: float) -> None:
    """Refuse a work that memory does not suffice for.

    Parameters
    ----------
    needed : float
        Bytes.

    Raises
    ------
    InputError
        More is needed than is free.
    """
    if needed < SMALL:
        return
    free = free_memory()
    if needed > free:
        raise InputError(f"needs about {_large(needed)} of memory, {_large(free)} are free")


def free_memory() -> float:
    """Give the bytes that this process may still take, as far as the system tells."""
    import psutil

    free = float(psutil.virtual_memory().available)
    return max(min(free, *_limits()), 0.0) if sys.platform == "linux" else free


def _limits() -> tuple[float, float]:
    """Give what the limits of the process and of its group of processes leave."""
    import resource

    import psutil

    most = resource.getrlimit(resource.RLIMIT_AS)[0]
    address_space = float("inf")
    if most != resource.RLIM_INFINITY:
        address_space = float(most - psutil.Process().memory_info().vms)
    return address_space, _left_to_the_group()


def _left_to_the_group() -> float:
    """Give what a container leaves; files that it only caches count as free."""
    left = float("inf")
    for group in _groups():
        try:
            most = (group / "memory.max").read_text().strip()
            if most == "max":
                continue
            used = int((group / "memory.current").read_text())
            facts = dict(line.split() for line in (group / "memory.stat").read_text().splitlines())
            left = min(left, float(int(most) - used + int(facts.get("inactive_file", 0))))
        except (OSError, ValueError):
            continue
    return left


def _groups() -> list[Path]:
    try:
        own = _OWN_GROUP.read_text().splitlines()
    except OSError:
        return []
    path = next((line[3:] for line in own if line.startswith("0::")), "/")
    group = _PROCESS_GROUPS / path.lstrip("/")
    return [group, *(up for up in group.parents if _PROCESS_GROUPS in (up, *up.parents))]


def _large(size: float) -> str:
    return f"{size / 1e9:.3g} GB"
