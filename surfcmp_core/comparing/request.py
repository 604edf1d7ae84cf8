"""One comparison for everyone who asks for it: command line, batch, window and Python."""

import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparing.cautions import cautions, nothing_common
from surfcmp_core.comparing.clock import Clock
from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.comparing.memory_needed import check_comparison
from surfcmp_core.comparing.options import DEFAULTS, NOT_MOVED, Domain, Motion, Options, Weight
from surfcmp_core.comparing.placing import Placed, placed
from surfcmp_core.comparing.stages import filled, max_edges, measured, merged, triangulated
from surfcmp_core.comparing.verification import (
    check_cover,
    check_exchange,
    check_measures,
    check_sums,
    check_united,
    check_values,
    keeping,
)
from surfcmp_core.comparing.warming import begin_to_compile
from surfcmp_core.comparing.weight import read_weight
from surfcmp_core.domain.layers import share_among_layers
from surfcmp_core.errors import InputError
from surfcmp_core.interface import kernels_are_ready
from surfcmp_core.io import read_surface
from surfcmp_core.surface import Duplicates, Surface
from surfcmp_core.surface.refusals import motion_of, refuse_surface
from surfcmp_core.surface.together import carried
from surfcmp_core.system.progress import Progress, silent


def compare(
    surface_1: Surface,
    surface_2: Surface,
    *,
    domain: Domain = "data",
    max_edge: float | None = None,
    exact: bool = False,
    tolerances: Sequence[float] = (0.5, 1.0, 2.0),
    weight: Path | Weight | None = None,
    duplicates: Duplicates = "refuse",
    threads: int = 2,
    align: NDArray[np.float64] | Motion | Path | Literal["icp"] | None = None,
    project: str = "z",
    verify: bool = False,
    progress: Progress = silent,
) -> Comparison:
    """Compare two surfaces z = F(x, y).

    Parameters
    ----------
    surface_1, surface_2 : Surface
        n1 and n2 nodes; brought to one unit and the same axes by
        :func:`surfcmp_core.surface.together.bring_together`. Where a unit or axes are missing, or
        one surface is converted, the result's warnings say so.
    domain, max_edge, exact, tolerances, weight, duplicates, threads, project, verify
        As in :class:`surfcmp_core.comparing.options.Options`.
    align : (4, 4) float64, "icp", Path or Motion, optional
        Rigid motion of surface 2 onto surface 1, in the unit and axes of `surface_1`; or how to
        find it, as in `Options`.
    progress : callable
        Told the stage and the share done; may raise `Cancelled`.

    Returns
    -------
    Comparison

    Raises
    ------
    InputError
        The surfaces cannot be compared, or the weight gives no numbers from 0 on.
    OptionError
        A ValueError: an option that means nothing.
    Violation
        What must hold of every comparison does not; the input is kept, the message says where.
    Cancelled
        From `progress`.

    References
    ----------
    Stages 1 to 6 of the paper's section 3.2; formulas (1) to (3).
    """
    options = Options(
        domain=domain,
        max_edge=max_edge,
        exact=exact,
        tolerances=tuple(tolerances),
        duplicates=duplicates,
        threads=threads,
        weight=weight,
        align=_asked(align, surface_1),
        project=project,
        verify=verify,
    )
    return compare_surfaces(surface_1, surface_2, options, progress)


def compare_files(
    first: Path, second: Path, options: Options = DEFAULTS, progress: Progress = silent
) -> Comparison:
    """Read two files and compare them.

    Raises
    ------
    InputError
        One line that names the file and the fault.
    """
    start = time.perf_counter()
    progress("read", 0.0)
    one, two = (
        read_surface(path, unit=options.unit, no_data=options.no_data) for path in (first, second)
    )
    return compare_surfaces(one, two, options, progress, time.perf_counter() - start)


def compare_surfaces(
    surface_1: Surface,
    surface_2: Surface,
    options: Options = DEFAULTS,
    progress: Progress = silent,
    read_seconds: float = 0.0,
) -> Comparison:
    """Compare two surfaces that were read.

    Parameters
    ----------
    surface_1, surface_2 : Surface
        As read: with the unit that `options` asks for, and without its `no_data`.
    options : Options
    progress : Progress
    read_seconds : float
        Time it took to read the surfaces, for the record.

    Returns
    -------
    Comparison

    Raises
    ------
    InputError
        One line that names a file and the fault.
    Violation
        As for :func:`compare`.
    """
    for surface in (surface_1, surface_2):
        refuse_surface(surface)
    check_comparison(surface_1, surface_2, options.exact)
    clock = Clock(_explained(progress), read_seconds)
    lying = placed(surface_1, surface_2, options, clock.tell)
    weight = options.weight
    if isinstance(weight, Path):
        weight = read_weight(weight, options.duplicates)
    try:
        return _compared(lying, weight, options, clock)
    except InputError as fault:
        files = (str(one.path or one.name) for one in (surface_1, surface_2))
        suspects = (
            f"{one.name} has {count} {note}"
            for one in (surface_1, surface_2)
            for note, count in one.changed.items()
            if "--no-data" in note
        )
        raise fault.at(*files).with_hints(*suspects) from None


def _asked(
    align: NDArray[np.float64] | Motion | Path | Literal["icp"] | None, surface: Surface
) -> Motion | Path | Literal["icp"]:
    """Tell a matrix in a surface's unit and axes as the options have it: in those of its file."""
    if align is None:
        return NOT_MOVED
    if isinstance(align, Motion | Path | str):
        return align
    matrix = carried(motion_of(align, "align"), 1 / surface.scale, surface.turned)
    return Motion(tuple(map(tuple, matrix.tolist())), "given")


def _explained(progress: Progress) -> Progress:
    """Say so where the first use of the program compiles its kernels, which takes its time."""
    if kernels_are_ready():
        return progress
    begin_to_compile()
    return lambda stage, share: progress(f"{stage} (compiling, on first use only)", share)


def _compared(lying: Placed, weight: Weight | None, options: Options, clock: Clock) -> Comparison:
    """Take two surfaces that lie in place through the stages, and check what must hold."""
    made = triangulated(lying, options, clock)
    union = merged(made, options, clock)
    with keeping(lying.surfaces, options):
        check_cover(union.scaled, *made.triangulations, union.areas, options.threads)
    values = filled(made, union, options, clock)
    limits = max_edges(made, union)
    if not values.compared.any():
        derived = options.max_edge is None
        raise nothing_common(*lying.surfaces, limits, derived=derived)
    found = measured(made, union, values, weight, options, clock)
    among_layers = [
        share_among_layers(t, grid.z * made.scale) if grid.faces is None else 0.0
        for t, grid in zip(made.triangulations, made.grids, strict=True)
    ]
    exact = found.exact_values
    result = Comparison(
        surfaces=lying.as_read,
        grids=made.grids,
        triangulations=made.in_unit(),
        united=union.united,
        z1=values.z[0],
        z2=values.z[1],
        weight=found.weight,
        reason=values.reason,
        area=found.values.area,
        mean_abs=found.values.mean_abs,
        mean_signed=found.values.mean_signed,
        measures=found.measures,
        options=options,
        transform=lying.transform,
        max_edges=limits,
        mean_abs_exact=None if exact is None else exact.mean_abs,
        mean_signed_exact=None if exact is None else exact.mean_signed,
        frame=lying.frame,
        alignment=lying.alignment,
        reversed=lying.reversed,
        seconds=clock.seconds(),
        warnings=(*lying.warnings, *cautions(lying.surfaces, among_layers, found.faces)),
        footprints=found.covered,
        faces=found.faces,
    )
    with keeping(lying.surfaces, options):
        for measures in filter(None, (result.measures, result.measures.exact)):
            check_measures(measures)
        if options.verify:
            clock.tell("verify", 0.9)
            check_united(union.scaled, *made.triangulations)
            check_values(result)
            check_sums(result)
            exchanged = _compared(
                lying.exchanged(), weight, replace(options, verify=False), Clock()
            )
            check_exchange(result.measures, exchanged.measures)
    clock.tell("done", 1.0)
    return result
