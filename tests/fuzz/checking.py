"""What must hold of a trial, however odd."""

import json
import math
import traceback
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import asdict, replace
from io import StringIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from surfcmp_core import Comparison, InputError
from surfcmp_core.cli.main import run
from surfcmp_core.comparing.options import NOT_MOVED, Options
from surfcmp_core.comparing.request import compare_files, compare_surfaces
from surfcmp_core.comparing.verification import check_chains
from surfcmp_core.grid import safe_scale
from surfcmp_core.io import read_surface
from surfcmp_core.measures.measures import Measures
from surfcmp_core.surface import Surface
from surfcmp_core.triangulation import triangulate
from tests.fuzz.trials import Model, Trial
from tests.fuzz.writing import write
from tests.invariants import codes, ranks, same

EXCHANGED = {
    "volume_above": "volume_below",
    "coverage_1": "coverage_2",
    "hausdorff_1_2": "hausdorff_2_1",
}
FLAGS = {"domain", "max_edge", "duplicates", "unit", "threads", "project"}


def fault_of(trial: Trial) -> str:
    """Say what is wrong with a trial, and where, up to a colon; empty where nothing is."""
    try:
        check(trial)
    except Exception as error:  # whatever it is, it is a find
        place = traceback.extract_tb(error.__traceback__)[-1]
        return f"{type(error).__name__} in {place.name}, line {place.lineno}: {error}"
    return ""


def has_fault(trial: Trial, fault: str) -> bool:
    """Whether the same is wrong with a trial."""
    return fault_of(trial).partition(":")[0] == fault.partition(":")[0]


def check(trial: Trial) -> str:
    """Compare files, arrays, exchanged roles and the command line; give the refusal, if any."""
    with TemporaryDirectory() as name:
        folder = Path(name)
        files = tuple(write(m, folder, f"file_{k}") for k, m in enumerate(trial.models))
        options = _options(trial, folder)
        try:
            found = compare_files(files[0], files[1], options)
        except InputError as refusal:
            said = str(refusal)
            assert said.isprintable(), said
            _check_refused(trial, options, files, said)
            return said
        _check_numbers(found)
        _check_triangulation(found)
        _check_alike(_from_arrays(trial, options, files), found)
        if options.align == NOT_MOVED and options.project == "z" and options.weight is None:
            exchanged = compare_files(files[1], files[0], options)
            _check_exchanged(found.measures, exchanged.measures)
        _check_command_line(trial, options, files, found)
    return ""


def _options(trial: Trial, folder: Path) -> Options:
    options: dict[str, Any] = {
        "domain": "data",
        "max_edge": None,
        "exact": False,
        "duplicates": "refuse",
        "unit": None,
        "weight": None,
        "align": NOT_MOVED,
        "project": "z",
        "threads": 1,
        **trial.options,
    }
    options["tolerances"] = tuple(options.get("tolerances", (0.5, 1.0, 2.0)))
    for name in ("weight", "align"):
        if isinstance(options[name], list):
            path = folder / f"{name}.{'txt' if name == 'align' else 'npy'}"
            if name == "align":
                rows = (" ".join(map(repr, row)) for row in options[name])
                path.write_text("".join(row + "\n" for row in rows))
            else:
                np.save(path, np.array(options[name]))
            options[name] = path
    return Options(**options)


def _surfaces(trial: Trial, files: tuple[Path, ...], unit: str | None) -> list[Surface]:
    """Put the arrays of the models in the place of what was read; polygons as the reader splits."""
    surfaces = []
    for model, file in zip(trial.models, files, strict=True):
        read = read_surface(file, unit=unit)
        _check_read(read, model)
        points = np.array(model.points)
        if read.unit is not None and read.scale != 1:
            points = read.points
        surfaces.append(replace(read, points=points))
    return surfaces


def _check_read(read: Surface, model: Model) -> None:
    """All nodes are there, to the last bit where no unit is converted, and triangles as given."""
    assert len(read.points) == len(model.points)
    if read.scale == 1:
        assert np.array_equal(read.points, np.array(model.points))
    else:
        scaled = np.array(model.points) * float(read.scale)
        assert np.allclose(read.points, scaled, rtol=1e-15, atol=0.0)
    if model.polygons is None:
        assert read.faces is None
    else:
        assert read.faces is not None
        most = sum(len(one) - 2 for one in model.polygons)
        # corners in line need no triangle of their own; what was done is counted
        counted = any("polygons" in what for what in read.changed)
        assert len(read.faces) == most or (len(read.faces) < most and counted)
        if all(len(one) == 3 for one in model.polygons):
            assert np.array_equal(read.faces, np.array(model.polygons))


def _from_arrays(trial: Trial, options: Options, files: tuple[Path, ...]) -> Comparison:
    one, two = _surfaces(trial, files, options.unit)
    other = replace(options, threads=3 - options.threads)
    return compare_surfaces(one, two, other)


def _check_refused(trial: Trial, options: Options, files: tuple[Path, ...], said: str) -> None:
    """Arrays are refused for the same reason."""
    try:
        _from_arrays(trial, options, files)
    except InputError as refusal:
        other = str(refusal)
    else:
        other = ""
    assert other == said, "refused as files, not so as arrays"


def _check_triangulation(found: Comparison) -> None:
    united = found.united
    name = ranks(united.nodes)
    whole = triangulate(united.nodes * safe_scale(united.nodes)).triangles
    count = len(united.nodes)
    same(codes(united.triangles, name, count), codes(whole, name, count), "triangles of T")
    check_chains(united)


def _check_numbers(found: Comparison) -> None:
    m = found.measures
    assert found.compared.any()
    slack = 1.0 + 1e-9
    assert 0.0 <= m.mean_abs <= m.rms * slack
    assert m.rms <= m.max_abs * slack
    assert m.p50 <= m.p90 <= m.p95 <= m.max_abs * slack
    assert abs(m.mean_signed) <= m.mean_abs * slack
    assert 0.0 <= m.coverage_1 <= slack, m.coverage_1
    assert 0.0 <= m.coverage_2 <= slack, m.coverage_2
    assert all(0.0 <= share <= slack for share in m.within_tolerance.values())
    assert math.isclose(np.nansum(found.area), m.area_compared, rel_tol=1e-9)
    volume = m.mean_abs * m.area_compared
    assert math.isclose(m.volume_above + m.volume_below, volume, rel_tol=1e-9, abs_tol=1e-300)
    if m.exact is not None and m.exact.area_compared > 0.0:
        assert 0.0 <= m.exact.mean_abs <= m.exact.rms * slack
        assert abs(m.exact.mean_signed) <= m.exact.mean_abs * slack


def _check_alike(found: Comparison, other: Comparison) -> None:
    """The same to the last bit."""
    for name in ("nodes", "triangles", "label", "origin", "chain"):
        assert np.array_equal(getattr(found.united, name), getattr(other.united, name)), name
    for name in ("z1", "z2", "reason", "area", "mean_abs", "mean_signed"):
        one, two = getattr(found, name), getattr(other, name)
        assert np.array_equal(one, two, equal_nan=name != "reason"), name
    assert _text(asdict(found.measures)) == _text(asdict(other.measures))


def _check_exchanged(found: Measures, other: Measures) -> None:
    """Exchanged roles change signs and nothing else."""
    for one, two in _readings(found, other):
        for first, second in EXCHANGED.items():
            if first in two:
                two[first], two[second] = two[second], two[first]
        two["mean_signed"] = 0.0 - two["mean_signed"]
        one["mean_signed"] = 0.0 + one["mean_signed"]
        assert _text(one) == _text(two), "exchange"


def _readings(found: Measures, other: Measures) -> list[tuple[dict[str, Any], dict[str, Any]]]:
    one, two = asdict(found), asdict(other)
    pairs = [(one.pop("exact"), two.pop("exact"))]
    return [(one, two), *((a, b) for a, b in pairs if a is not None)]


def _text(values: dict[str, Any]) -> str:
    return json.dumps({str(k): v for k, v in values.items()}, default=str, sort_keys=True)


def _check_command_line(
    trial: Trial, options: Options, files: tuple[Path, ...], found: Comparison
) -> None:
    out = files[0].parent / "out.npz"
    words = ["compare", *map(str, files), "--quiet", "--out", str(out)]
    for name in FLAGS & set(trial.options):
        words += [f"--{name.replace('_', '-')}", str(trial.options[name])]
    for tolerance in trial.options.get("tolerances", ()):
        words += ["--tolerance", repr(tolerance)]
    words += ["--exact"] * options.exact
    words += ["--weight", str(options.weight)] if options.weight else []
    words += ["--align", str(options.align)] if options.align != NOT_MOVED else []
    said = StringIO()
    with redirect_stderr(said), redirect_stdout(said):
        status = run(words, lambda _: 1)
    assert status == 0, said.getvalue()
    with np.load(out) as arrays:
        assert np.array_equal(arrays["nodes"], found.united.nodes)
        assert np.array_equal(arrays["triangles"], found.united.triangles)
        for name in ("z1", "z2", "mean_abs", "mean_signed", "area"):
            assert np.array_equal(arrays[name], getattr(found, name), equal_nan=True), name
