"""`surfcmp thin FILE`."""

from pathlib import Path
from typing import Annotated

import typer

from surfcmp_core.cli.ends import WrongUsage, ending
from surfcmp_core.cli.shared_options import NoDataOption, QuietOption, UnitOption
from surfcmp_core.grid.thinning import thin_random, thin_to_spacing
from surfcmp_core.io import read_surface
from surfcmp_core.io.clouds import CLOUD_WRITERS
from surfcmp_core.report.outputs import check_outputs
from surfcmp_core.surface.used import without_unused
from surfcmp_core.system.whole_files import OutputError, write_all

File = Annotated[Path, typer.Argument(metavar="FILE", help="A surface.", show_default=False)]
OutOption = Annotated[
    Path,
    typer.Option("--out", metavar="FILE", help="Write the nodes kept: .ply .npz .xyz"),
]
KeepOption = Annotated[
    float | None,
    typer.Option("--keep", metavar="SHARE", help="Keep this share of the nodes, at random."),
]
SpacingOption = Annotated[
    float | None,
    typer.Option("--spacing", metavar="X", help="Keep no two nodes nearer than X in space."),
]
SeedOption = Annotated[int, typer.Option("--seed", metavar="N", help="Another choice of nodes.")]


@ending
def command(
    file: File,
    out: OutOption,
    keep: KeepOption = None,
    spacing: SpacingOption = None,
    seed: SeedOption = 0,
    unit: UnitOption = None,
    no_data: NoDataOption = None,
    quiet: QuietOption = False,
) -> None:
    """Keep some nodes of a surface, for experiments: a cloud."""
    if (keep is None) == (spacing is None):
        raise WrongUsage("thin: one of --keep and --spacing is needed")
    if keep is not None and not 0.0 < keep <= 1.0:
        raise WrongUsage("--keep: must be above 0 and at most 1")
    if spacing is not None and not 0.0 < spacing < float("inf"):
        raise WrongUsage("--spacing: must be above 0")
    if seed < 0:
        raise WrongUsage("--seed: must not be negative")
    try:
        check_outputs([out], [file], CLOUD_WRITERS)
    except OutputError as fault:
        raise WrongUsage(f"--out {fault}") from None
    surface = without_unused(read_surface(file, unit=unit, no_data=no_data or ()))
    if keep is not None:
        thinned = thin_random(surface, keep, seed=seed)
    else:
        assert spacing is not None
        thinned = thin_to_spacing(surface, spacing, seed=seed)
    write = CLOUD_WRITERS[out.suffix.lower()]
    write_all({out: lambda stream: write(thinned, stream)})
    if not quiet:
        kept, before = len(thinned.points), len(surface.points)
        typer.echo(f"{kept} of {before} nodes kept ({100.0 * kept / before:.3g} %)")
