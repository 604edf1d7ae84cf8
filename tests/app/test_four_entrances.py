"""Command line, batch, window and Python give the same numbers, to the last bit."""

import json
from contextlib import redirect_stderr
from dataclasses import asdict
from io import StringIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from app.__main__ import main
from app.jobs.comparing import compared
from app.model.document import Document
from surfcmp_core import Surface, compare, read_surface
from surfcmp_core.comparing.options import Motion, Options
from surfcmp_core.compiled.linear_algebra import rotation
from surfcmp_core.errors import InputError
from surfcmp_core.report import make_record
from surfcmp_core.system.progress import silent

Record = dict[str, Any]

shifts = st.tuples(*[st.floats(-0.3, 0.3)] * 3)
turns = st.tuples(*[st.floats(-0.1, 0.1)] * 3)
asked = st.fixed_dictionaries(
    {
        "domain": st.sampled_from(["data", "hull", "plane"]),
        "max_edge": st.sampled_from([None, 0.7, 3.0, np.inf]),
        "exact": st.booleans(),
        "tolerances": st.lists(st.floats(0.0, 2.0), min_size=1, max_size=3).map(tuple),
        "duplicates": st.sampled_from(["refuse", "mean", "max", "min"]),
        "threads": st.integers(1, 2),
        "unit": st.sampled_from([None, "mm", "cm", "in"]),
        "project": st.sampled_from(["z", "auto", "view:0.1,-0.2,1"]),
    }
)


def _file(folder: Path, name: str, rng: np.random.Generator, mesh: bool) -> Path:
    x, y = np.meshgrid(np.arange(9.0), np.arange(7.0))
    places = np.column_stack((x.ravel(), y.ravel())) + 0.3 * rng.random((63, 2))
    points = np.column_stack((places, np.sin(places).sum(axis=1) + 0.1 * rng.random(63)))
    path = folder / name
    if mesh:
        corner = np.flatnonzero((np.arange(63) % 9 < 8) & (np.arange(63) < 54))
        low = np.column_stack((corner, corner + 1, corner + 10))
        high = np.column_stack((corner, corner + 10, corner + 9))
        np.savez(path, points=points, faces=np.concatenate((low, high)).astype(np.int32))
    else:
        np.savez(path, points=points)
    return path


def _numbers(record: Record | InputError) -> Record:
    """What was found, but for what tells how long it took and how it was asked; or the refusal."""
    if isinstance(record, InputError):
        return {"error": str(record)}
    if "error" in record:
        return {"error": record["error"]}
    found = {key: record[key] for key in ("inputs", "transform", "counts", "measures")}
    found |= {"alignment": record["alignment"]["matrix"], "warnings": sorted(record["warnings"])}
    return json.loads(json.dumps(found))  # type: ignore[no-any-return]


def _by_command(files: tuple[Path, Path], words: list[str], folder: Path) -> Record:
    out, said = folder / "result.json", StringIO()
    with redirect_stderr(said):
        status = main(["compare", *map(str, files), *words, "--quiet", "--out", str(out)])
    if status == 3:
        return {"error": said.getvalue().removeprefix("surfcmp: ").strip()}
    return json.loads(out.read_text())  # type: ignore[no-any-return]


def _by_batch(files: tuple[Path, Path], words: list[str], folder: Path) -> Record:
    out = folder / "table.json"
    with redirect_stderr(StringIO()):
        main(["batch", *map(str, files), *words, "--quiet", "--out", str(out)])
    (record,) = json.loads(out.read_text())["pairs"]
    return record  # type: ignore[no-any-return]


def _by_window(files: tuple[Path, Path], options: Options) -> Record | InputError:
    try:
        return compared(Document(files, options), None, silent).record
    except InputError as refusal:
        return refusal


def _by_python(files: tuple[Path, Path], options: Options) -> Record | InputError:
    surfaces: list[Surface] = [read_surface(path, unit=options.unit) for path in files]
    kept = {key: value for key, value in asdict(options).items() if key not in {"unit", "no_data"}}
    if isinstance(options.align, Motion) and surfaces[0].scale == 1:  # else in another unit
        kept["align"] = np.array(options.align.matrix)
    else:
        kept["align"] = options.align
    try:
        return make_record(compare(*surfaces, **kept))
    except InputError as refusal:
        return refusal


@settings(max_examples=25)
@given(asked, st.none() | st.tuples(shifts, turns), st.tuples(st.booleans(), st.booleans()))
def test_all_entrances_lead_to_the_same_numbers(
    given_: Record,
    moved: tuple[tuple[float, ...], tuple[float, ...]] | None,
    mesh: tuple[bool, bool],
) -> None:
    words = []
    for name, value in given_.items():
        flag = "--" + {"tolerances": "tolerance"}.get(name, name).replace("_", "-")
        if name == "exact":
            words += [flag] * value
        elif value is not None:
            words += [word for v in np.atleast_1d(value) for word in (flag, str(v))]
    rng = np.random.default_rng(len(words))
    with TemporaryDirectory() as name:
        folder = Path(name)
        files = _file(folder, "one.npz", rng, mesh[0]), _file(folder, "two.npz", rng, mesh[1])
        options = Options(**given_)
        if moved is not None:
            matrix = np.eye(4)
            matrix[:3, 3], matrix[:3, :3] = moved[0], rotation([1.0, *moved[1]])
            np.save(folder / "motion.npy", matrix)
            words += ["--align", str(folder / "motion.npy")]
            motion = Motion(tuple(map(tuple, matrix.tolist())), "by hand")
            options = Options(**given_, align=motion)
        by_command = _numbers(_by_command(files, words, folder))
        assert _numbers(_by_batch(files, words, folder)) == by_command
        assert _numbers(_by_window(files, options)) == by_command
        assert _numbers(_by_python(files, options)) == by_command
