"""What must hold between the measures themselves, and between those of either way round."""

import math
from dataclasses import asdict, fields
from itertools import pairwise

from surfcmp_core.comparing.verification.holds import hold
from surfcmp_core.measures import Measures

_ROUNDING = 1e-9
"""Share by which sums may be off that rounding has met in another order."""
_LEAST = 1e-290
"""Below this numbers lose their digits."""
_EXCHANGED = {
    "volume_above": "volume_below",
    "volume_below": "volume_above",
    "coverage_1": "coverage_2",
    "coverage_2": "coverage_1",
    "hausdorff_1_2": "hausdorff_2_1",
    "hausdorff_2_1": "hausdorff_1_2",
}
_OF_NOTHING = {
    "mean_abs",
    "mean_abs_interface",
    "mean_signed",
    "rms",
    "max_abs",
    "p50",
    "p90",
    "p95",
}


def _at_most(one: float, other: float) -> bool:
    return one <= other + _ROUNDING * abs(other) + _LEAST


def check_measures(measures: Measures) -> None:
    """Check that measures are finite, and in the order in which they must be.

    Parameters
    ----------
    measures : Measures
        Of either reading. Without area means are NaN.

    Raises
    ------
    Violation
    """
    m = measures
    nothing = {"mean_abs_interface"} if m.area_interface == 0.0 else set()
    for name, value in asdict(m).items():
        if isinstance(value, float):
            empty = name in nothing or (m.area_compared == 0.0 and name in _OF_NOTHING)
            hold(math.isfinite(value) or empty, f"{name} is {value}")
    hold(_at_most(m.area_interface, m.area_compared), "the interface is larger than the whole")
    hold(_at_most(m.rho_delta_V, m.rho_V), "rho_delta_V is above rho_V")
    for name in ("coverage_1", "coverage_2"):
        hold(0.0 <= getattr(m, name) <= 1.0, f"{name} is {getattr(m, name)}, no share")
    if m.area_compared == 0.0:
        return
    for low, high in pairwise(("mean_abs", "rms", "max_abs")):
        hold(_at_most(getattr(m, low), getattr(m, high)), f"{low} is above {high}")
    hold(_at_most(abs(m.mean_signed), m.mean_abs), "mean_signed is above mean_abs")
    for low, high in pairwise(("p50", "p90", "p95", "max_abs")):
        hold(_at_most(getattr(m, low), getattr(m, high)), f"{low} is above {high}")
    volume = m.mean_abs * m.area_compared
    slack = _ROUNDING * volume + _LEAST
    hold(
        abs(m.volume_above + m.volume_below - volume) <= slack
        and abs(m.volume_above - m.volume_below - m.mean_signed * m.area_compared) <= slack,
        "the volumes above and below are not the means times the area",
    )
    shares = [share for _, share in sorted((float(k), v) for k, v in m.within_tolerance.items())]
    hold(all(0.0 <= share <= 1.0 + _ROUNDING for share in shares), "a share is beyond 0 to 1")
    hold(all(_at_most(low, high) for low, high in pairwise(shares)), "a larger tolerance has less")


def check_exchange(measures: Measures, exchanged: Measures) -> None:
    """Check that the other way round signs change and nothing else, to the last bit.

    Parameters
    ----------
    measures, exchanged : Measures
        Of the surfaces, and with their roles exchanged.

    Raises
    ------
    Violation
    """
    for field in fields(measures):
        one = getattr(measures, field.name)
        other = getattr(exchanged, _EXCHANGED.get(field.name, field.name))
        if isinstance(one, Measures):
            hold(other is not None, "the exact reading is there one way round alone")
            check_exchange(one, other)
        elif field.name == "mean_signed":
            hold(one == -other or one != one, f"the other way round mean_signed is {other!r}")
        else:
            alike = one == other or (one != one and other != other)
            hold(alike, f"{field.name} is {one!r}, the other way round {other!r}")
