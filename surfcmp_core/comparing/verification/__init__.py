"""What must hold of every comparison, checked while it runs: a violation is never a number.

`check_cover` and `check_measures` take next to no time and run always; `check_united`,
`check_values`, `check_sums` and `check_exchange` are asked for.
"""

from surfcmp_core.comparing.verification.check_chains import check_chains
from surfcmp_core.comparing.verification.check_cover import check_cover
from surfcmp_core.comparing.verification.check_measures import check_exchange, check_measures
from surfcmp_core.comparing.verification.check_sums import check_sums
from surfcmp_core.comparing.verification.check_united import (
    check_half_edges,
    check_nodes,
    check_united,
)
from surfcmp_core.comparing.verification.check_values import check_values
from surfcmp_core.comparing.verification.evidence import keeping

__all__ = [
    "check_chains",
    "check_cover",
    "check_exchange",
    "check_half_edges",
    "check_measures",
    "check_nodes",
    "check_sums",
    "check_united",
    "check_values",
    "keeping",
]
