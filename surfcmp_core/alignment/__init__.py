"""Moving surface 2 onto surface 1: landmarks, then best fit."""

from surfcmp_core.alignment.best_fit import best_fit
from surfcmp_core.alignment.fit import Alignment, FitRecord, Method, record_of_motion
from surfcmp_core.alignment.landmarks import fit_landmarks

__all__ = ["Alignment", "FitRecord", "Method", "best_fit", "fit_landmarks", "record_of_motion"]
