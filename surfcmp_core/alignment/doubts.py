"""Why a pose may be wrong, in words for the user.

The bounds were found on some 600 fits of real scans (heads, jaws, skin on bone, terrain) turned by
up to 180 degrees: no wrong pose among them is without a word.
"""

from surfcmp_core.alignment.account import Account
from surfcmp_core.alignment.other_poses import Better

FARTHEST_TURN = 30.0
"""Degrees from which on a best fit may end anywhere."""
_FARTHEST_SHIFT = 0.2
"""Share of the extent, likewise."""
_AGREEMENT = 0.4
"""Right poses have 0.42 and more (skin on bone); of wrong ones only those that are turned by about
half have as much, up to 0.54, and there another pose fits better."""
UNSURE = 0.75
"""Agreement below which other poses are tried."""
_OVERLAP = 0.5
_RESIDUAL = 0.02
"""Share of the extent."""


def doubts_of(
    account: Account,
    better: Better | None,
    converged: bool,
    residual: float,
    extent: float,
    unit: str,
) -> tuple[str, ...]:
    """Name what speaks against a best fit.

    Parameters
    ----------
    account : Account
    better : Better or None
        Another pose.
    converged : bool
    residual : float
        Root mean square of the pairs kept.
    extent : float
        Of the smaller surface, in the same unit.
    unit : str
        How to call that unit.

    Returns
    -------
    tuple of str
        One sentence for each doubt, without a full stop.
    """
    doubts = []
    if not converged:
        doubts.append("the best fit has not settled; check the alignment")
    if account.turned > FARTHEST_TURN or account.shifted > _FARTHEST_SHIFT * extent:
        doubts.append(
            f"the best fit turned surface 2 by {account.turned:.3g}° and shifted it by"
            f" {account.shifted:.3g} {unit}: from so far it may end in a wrong pose; look at it, or"
            " begin with landmarks"
        )
    if better is not None:
        doubts.append(
            f"another pose fits better, turned by about half: residual {better.residual:.3g}"
            f" {unit}, agreement {better.agreement:.2f} in place of {residual:.3g} {unit},"
            f" {account.agreement:.2f}"
        )
    if account.agreement < _AGREEMENT and not account.free:
        doubts.append(
            "the best fit pairs places that are directed differently (agreement"
            f" {account.agreement:.2f}; 1: alike, 0: as by chance): the pose is wrong, or the"
            " surfaces are of different form"
        )
    if max(account.overlaps) < _OVERLAP:
        one, two = (f"{100.0 * share:.3g} %" for share in account.overlaps)
        doubts.append(
            f"the best fit rests on a small overlap: {one} of the nodes of surface 1 and {two} of"
            " those of surface 2 have a partner"
        )
    if residual > _RESIDUAL * extent:
        doubts.append(
            f"the best fit leaves a residual of {residual:.3g} {unit},"
            f" {100.0 * residual / extent:.2g} % of the extent: check the alignment"
        )
    if account.free:
        doubts.append(
            f"the form of the surfaces leaves the best fit free to {_listed(account.free)}: how"
            " they lie in that respect is not known"
        )
    return tuple(doubts)


def _listed(words: tuple[str, ...]) -> str:
    return " and ".join(part for part in (", ".join(words[:-1]), words[-1]) if part)
