"""Interface triangles: chains traced from starters, found one after another over bridges."""

from surfcmp_core.interface.events import Event
from surfcmp_core.interface.extraction import Chains, extract_chains, kernels_are_ready
from surfcmp_core.interface.joined import Joined, join

__all__ = ["Chains", "Event", "Joined", "extract_chains", "join", "kernels_are_ready"]
