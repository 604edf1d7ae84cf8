"""Interface triangles: chains traced from starters, found one after another over bridges."""

from surfcmp_core.interface.extraction import Chains, extract_chains
from surfcmp_core.interface.joined import PASSED, Joined, join

__all__ = ["PASSED", "Chains", "Joined", "extract_chains", "join"]
