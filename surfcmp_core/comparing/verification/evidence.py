"""The input of a comparison that broke what must hold, kept so that it can be reported."""

import json
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import BinaryIO

import numpy as np
from platformdirs import user_state_path

from surfcmp_core.comparing.options import Options
from surfcmp_core.errors import Violation
from surfcmp_core.surface import Surface
from surfcmp_core.system.whole_files import OutputError, write_all


@contextmanager
def keeping(surfaces: tuple[Surface, Surface], options: Options) -> Iterator[None]:
    """Where something within is violated, keep the input and say where.

    Parameters
    ----------
    surfaces : two Surface
        As they were compared: where they lie, seen along z.
    options : Options

    Raises
    ------
    Violation
        With the name of an .npz in the user's folder of this program's state: `points_1`,
        `points_2`, `faces_1`, `faces_2` (none of a cloud) and, as .json, `options`.
    """
    try:
        yield
    except Violation as fault:
        names = " and ".join(surface.name for surface in surfaces)
        try:
            kept = f"the input is kept in {_keep(surfaces, options)}"
        except (OutputError, OSError) as disk:
            kept = f"the input could not be kept: {disk}"
        raise Violation(
            f"{names}: a fault of this program, please report it: {fault}; {kept}"
        ) from None


def _keep(surfaces: tuple[Surface, Surface], options: Options) -> Path:

    folder = user_state_path("surfcmp") / "violations"
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{time.strftime('%Y-%m-%d_%H-%M-%S')}_{time.time_ns() % 10**9:09}.npz"
    arrays = {"options": np.array(json.dumps(asdict(options), default=str))}
    for number, surface in enumerate(surfaces, 1):
        arrays[f"points_{number}"] = surface.points
        if surface.faces is not None:
            arrays[f"faces_{number}"] = surface.faces

    def write(stream: BinaryIO) -> None:
        np.savez_compressed(stream, **arrays)  # type: ignore[arg-type]

    write_all({path: write})
    return path
