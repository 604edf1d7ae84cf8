"""Stage: from two surfaces as they were read to two that are compared along z."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.alignment import FitRecord, best_fit, record_of_motion
from surfcmp_core.comparing.options import NOT_MOVED, Motion, Options
from surfcmp_core.compiled.linear_algebra import composed
from surfcmp_core.errors import InputError
from surfcmp_core.io.motion import read_motion
from surfcmp_core.projection import moved
from surfcmp_core.projection.placement import place
from surfcmp_core.surface import Surface
from surfcmp_core.surface.refusals import fault_of_motion, refuse_pair, refuse_surface
from surfcmp_core.surface.together import bring_together, carried
from surfcmp_core.surface.used import used_part
from surfcmp_core.system.progress import Progress


@dataclass(frozen=True, slots=True, eq=False)
class Placed:
    """Two surfaces, and how they came to lie as they are compared.

    Attributes
    ----------
    surfaces : two Surface
        Along z, one above the other.
    as_read : two Surface
        The same before they were moved, but in one unit and the same axes.
    frame, transform : (4, 4) float64
        From the coordinates of `as_read` to those of `surfaces`, for surface 1 and for surface 2.
    alignment : FitRecord
        How surface 2 was moved onto surface 1.
    reversed : two bool, or None
        Which surfaces are looked at from their backs; None where nobody looked for their sides.
    warnings : tuple of str
        What was taken for granted, what is doubtful, what is not seen.
    """

    surfaces: tuple[Surface, Surface]
    as_read: tuple[Surface, Surface]
    frame: NDArray[np.float64]
    transform: NDArray[np.float64]
    alignment: FitRecord
    reversed: tuple[bool, bool] | None
    warnings: tuple[str, ...]

    def exchanged(self) -> "Placed":
        """Give the same with the roles of the surfaces exchanged, from where they lie now on."""
        both = self.surfaces[::-1]
        here = np.eye(4)
        return Placed(both, both, here, here, record_of_motion("none", here), None, ())


def placed(surface_1: Surface, surface_2: Surface, options: Options, progress: Progress) -> Placed:
    """Bring two surfaces to one unit and the same axes, move 2 onto 1, and look at both.

    Parameters
    ----------
    surface_1, surface_2 : Surface
    options : Options
        Of which `align` and `project` count.
    progress : Progress
        Told of the search for a fit.

    Returns
    -------
    Placed

    Raises
    ------
    InputError
        Unlike units; a motion that is none; nothing is seen; coordinates that give no numbers.
    """
    together = bring_together(used_part(surface_1), used_part(surface_2))
    one, two = together.surfaces
    motion, alignment, doubts = _aligned(one, two, options, progress)
    warnings = (*together.warnings, *doubts)
    view = options.view
    if view is None:
        frame = np.eye(4)
        transform = frame if motion is None else composed(frame, motion)
        surfaces = _lying(one, frame), _lying(two, transform)
        found = Placed(surfaces, (one, two), frame, transform, alignment, None, warnings)
    else:
        if view != "auto" and one.turned:
            view = -view[0], -view[1], view[2]
        seen = place(one, two, view, motion)
        part_1, part_2 = seen.surfaces
        found = Placed(
            (_lying(part_1, np.eye(4)), _lying(part_2, np.eye(4))),
            (replace(one, dropped=part_1.dropped), replace(two, dropped=part_2.dropped)),
            *seen.motions,
            alignment,
            (seen.removed[0].reversed, seen.removed[1].reversed),
            (*warnings, *seen.warnings),
        )
    refuse_pair(*found.surfaces)
    return found


def _aligned(
    one: Surface, two: Surface, options: Options, progress: Progress
) -> tuple[NDArray[np.float64] | None, FitRecord, tuple[str, ...]]:
    """Give the motion of surface 2 (None: none), its record, and why it may be wrong.

    What is known of a motion is told in the unit and axes of surface 1's file; what is returned
    is in those of the comparison.
    """
    align = options.align
    if align == "icp":
        fit = best_fit(one, two, progress=progress)
        return fit.matrix, fit.record(), tuple(f"--align icp: {doubt}" for doubt in fit.doubts)
    if isinstance(align, Motion):
        if align == NOT_MOVED:
            return None, record_of_motion("none", np.eye(4)), ()
        matrix = np.array(align.matrix)
        fault = fault_of_motion(matrix)
        if fault:
            raise InputError(fault, where=(f"the motion of {two.name}",))
        record = record_of_motion(align.method, matrix) | align.fit
    else:
        matrix = read_motion(align)
        record = record_of_motion("file", matrix)
    return carried(matrix, one.scale, one.turned), record, tuple(record["doubts"])


def _lying(surface: Surface, motion: NDArray[np.float64]) -> Surface:
    lying = moved(surface, motion)
    refuse_surface(lying)
    if len(lying.points) < 3:
        raise InputError(f"{len(lying.points)} nodes; at least 3 are needed", where=(lying.name,))
    return lying
