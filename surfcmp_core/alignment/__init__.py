"""Moving surface 2 onto surface 1: landmarks, then best fit."""

from surfcmp_core.alignment.alignment import Alignment, Method
from surfcmp_core.alignment.best_fit import best_fit
from surfcmp_core.alignment.landmarks import fit_landmarks

__all__ = ["Alignment", "Method", "best_fit", "fit_landmarks"]
