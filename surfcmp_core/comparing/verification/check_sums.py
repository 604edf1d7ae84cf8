"""The nodal measures once more, the slow way and by other formulas."""

import math

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.comparing.verification.holds import hold

_ROUNDING = 1e-9
_EPSILON = 2.0**-53


def _mean_below(d: NDArray[np.float64]) -> NDArray[np.float64]:
    """Mean of max(−d, 0) over triangles with d linear, from (k, 3) sorted values.

    Where one node is below 0 it cuts off a corner, whose volume is a cubic form; where two are, the
    mean of max(d, 0) is that of the corner of the third.
    """
    lo, mid, hi = d.T
    with np.errstate(divide="ignore", invalid="ignore"):
        corner = -lo * (lo / (lo - mid)) * (lo / (lo - hi)) / 3.0
        other = hi * (hi / (hi - mid)) * (hi / (hi - lo)) / 3.0
    mean = d.sum(axis=1) / 3.0
    below = np.where(mid >= 0.0, corner, other - mean)
    return np.asarray(np.where(lo >= 0.0, 0.0, np.where(hi <= 0.0, -mean, below)))


def _areas(nodes: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
    """Areas of triangles of (k, 3, 2) corners, and by how much all may be off.

    Each is measured from the corner between its shorter sides: from one far away the others are
    one place.
    """
    sides = np.roll(nodes, -1, axis=1) - nodes  # from each corner to the next
    lengths = np.hypot(sides[:, :, 0], sides[:, :, 1])
    base = np.argmin(lengths * np.roll(lengths, 1, axis=1), axis=1)
    every = np.arange(len(nodes))
    u, v = sides[every, base], -sides[every, base - 1]
    left, right = u[:, 0] * v[:, 1], u[:, 1] * v[:, 0]
    return 0.5 * (left - right), 4.0 * _EPSILON * math.fsum(np.abs(left) + np.abs(right))


def check_sums(comparison: Comparison) -> None:
    """Check areas, means, volumes, the paper's sums and the percentiles of the nodal reading.

    Parameters
    ----------
    comparison : Comparison

    Raises
    ------
    Violation
    """
    united, m, compared = comparison.united, comparison.measures, comparison.compared
    triangles = united.triangles[compared]
    corners = united.nodes[triangles]
    # in units that keep products of a hundred magnitudes from over- and underflow
    size = 2.0 ** float(np.frexp(np.ptp(corners, axis=(0, 1)).max())[1])
    area, off = _areas(corners / size)
    d = np.sort((comparison.z1 - comparison.z2)[triangles], axis=1)
    high = float(np.abs(d).max()) or 1.0
    d /= high
    signed = d.sum(axis=1) / 3.0
    below = _mean_below(d)
    absolute = signed + 2.0 * below
    square = (np.square(d).sum(axis=1) + np.square(d.sum(axis=1))) / 12.0
    representative = united.representative[compared]
    whole = math.fsum(area)
    interface = math.fsum(area[representative])

    def agree(name: str, expected: float, scale: float) -> None:
        found = getattr(m, name)
        hold(
            abs(found - expected) <= (_ROUNDING + off / whole) * scale,
            f"{name} is {found!r}, the slow way {expected!r}",
        )

    mean = math.fsum(area * absolute) / whole * high
    agree("area_compared", whole * size * size, whole * size * size)
    agree("area_interface", interface * size * size, whole * size * size)
    agree("mean_abs", mean, high)
    agree("mean_signed", math.fsum(area * signed) / whole * high, high)
    agree("rms", math.sqrt(math.fsum(area * square) / whole) * high, high)
    agree("max_abs", high * float(np.abs(d).max()), high)
    rho = math.fsum(absolute) * high
    agree("rho_V", rho, high * len(area))
    agree("rho_delta_V", math.fsum(absolute[representative]) * high, high * len(area))
    agree("volume_below", math.fsum(area * below) * size * size * high, whole * size * size * high)
    if interface > _ROUNDING * whole:
        slow = math.fsum((area * absolute)[representative]) / interface * high
        agree("mean_abs_interface", slow, high)
    _check_percentiles(comparison)


def _check_percentiles(comparison: Comparison) -> None:
    """Check that less of the area lies below a percentile than it says, or as much with it."""
    area, values = (array[comparison.compared] for array in (comparison.area, comparison.mean_abs))
    whole = math.fsum(area)
    for percent in (50, 90, 95):
        value = getattr(comparison.measures, f"p{percent}")
        under = math.fsum(area[values < value]) / whole
        upto = math.fsum(area[values <= value]) / whole
        hold(
            under <= percent / 100.0 + _ROUNDING and upto >= percent / 100.0 - _ROUNDING,
            f"p{percent} is {value!r}, but {100 * under:.6g} % of the area lies below it and "
            f"{100 * upto:.6g} % not above",
        )
