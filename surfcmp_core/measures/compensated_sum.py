"""Sums that do not depend on the order of their terms."""

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.kernel import kernel


@kernel
def add(sums: NDArray[np.float64], i: int, term: float) -> None:
    """Add a term to a sum kept in two parts, what rounding drops in the second.

    The sum of the two parts of n terms is off by about n u² times the sum of the |terms|,
    u = 2⁻⁵³ (Sum2 of [OgitaRumpOishi2005]): rounded to one number it is the same in every order,
    but for one case in millions of millions.

    Parameters
    ----------
    sums : (k, 2) float64
        All sums; the value of the i-th is ``sums[i, 0] + sums[i, 1]``.
    i : int
        The sum to add to.
    term : float
        What to add.
    """
    before = sums[i, 0]
    after = before + term
    added = after - before
    sums[i, 0] = after
    sums[i, 1] += (before - (after - added)) + (term - added)
