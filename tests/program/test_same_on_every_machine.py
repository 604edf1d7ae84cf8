"""The same numbers to the last bit, whatever the processor, its libraries and the threads."""

import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from surfcmp_core.compiled.cache import use_own_cache
from tests.program.every_machine import COMPARISONS, write_inputs

PROJECT = Path(__file__).parents[2]
FEATURES = np._core._multiarray_umath.__cpu_features__
DISPATCHED = [one for one in np._core._multiarray_umath.__cpu_dispatch__ if FEATURES.get(one)]

GENERIC = {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""}
PLAIN = {
    "NPY_DISABLE_CPU_FEATURES": " ".join(DISPATCHED),
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX512F,-AVX2,-AVX,-FMA,-FMA4",
}
"""Without what numpy and the C library have for younger processors."""
MACHINES: dict[str, tuple[dict[str, str], str, tuple[str, ...]]] = {
    # environment, threads, and what the processor must have
    "generic kernels": (GENERIC, "2", ()),
    "Prescott": ({"OPENBLAS_CORETYPE": "Prescott", "OMP_NUM_THREADS": "1"} | PLAIN, "1", ("SSE3",)),
    "Nehalem": ({"OPENBLAS_CORETYPE": "Nehalem", "OMP_NUM_THREADS": "2"}, "2", ("SSE42",)),
    "Haswell": ({"OPENBLAS_CORETYPE": "Haswell"} | PLAIN, "2", ("AVX2", "FMA3")),
    "Zen": ({"OPENBLAS_CORETYPE": "Zen", "OMP_NUM_THREADS": "1"}, "1", ("AVX2", "FMA3")),
    "SkylakeX": ({"OPENBLAS_CORETYPE": "SkylakeX"}, "2", ("AVX512_SKX",)),
}
pytestmark = pytest.mark.timeout(1800)  # six processes, one of which compiles all kernels
CHANGING = ("created", "seconds", "program")


def _run(inputs: Path, out: Path, machine: dict[str, str], threads: str) -> None:
    out.mkdir()
    environment = os.environ | machine
    if "NUMBA_CPU_NAME" in machine:
        use_own_cache()
        kernels = Path(os.environ["NUMBA_CACHE_DIR"])
        environment["NUMBA_CACHE_DIR"] = str(kernels.with_name(f"{kernels.name}-generic"))
    done = subprocess.run(
        [sys.executable, "-m", "tests.program.every_machine", str(inputs), str(out), threads],
        cwd=PROJECT,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("machines")
    inputs = folder / "inputs"
    inputs.mkdir()
    write_inputs(inputs)
    jobs = {"this one": ({}, "2", ())} | MACHINES
    can = {
        name: (machine, threads)
        for name, (machine, threads, needed) in jobs.items()
        if all(FEATURES.get(one) for one in needed)
    }
    with ThreadPoolExecutor(2) as pool:
        runs = [
            pool.submit(_run, inputs, folder / name, *can[name])
            for name in sorted(can, key=lambda name: name != "generic kernels")  # the longest first
        ]
        for run in runs:
            run.result()
    return {name: folder / name for name in can}


def _document(path: Path) -> dict[str, Any]:
    document: dict[str, Any] = json.loads(path.read_text().replace(path.parent.name, "folder"))
    for key in CHANGING:
        del document[key]
    del document["options"]["threads"]
    return document


@pytest.mark.parametrize("machine", MACHINES)
def test_numbers_are_the_same_to_the_last_bit(results: dict[str, Path], machine: str) -> None:
    if machine not in results:
        pytest.skip(f"this processor is no {machine}")
    here, there = results["this one"], results[machine]
    assert (here / "landmarks.npy").read_bytes() == (there / "landmarks.npy").read_bytes()
    for name in (*COMPARISONS, "thinned"):
        with np.load(here / f"{name}.npz") as one, np.load(there / f"{name}.npz") as other:
            assert one.files == other.files
            for key in one.files:
                assert one[key].tobytes() == other[key].tobytes(), f"{name}: {key}"
    for name in COMPARISONS:
        assert _document(here / f"{name}.json") == _document(there / f"{name}.json"), name


def test_stacked_nodes_of_a_turned_cloud_stay_one_above_the_other(results: dict[str, Path]) -> None:
    document = _document(results["this one"] / "clouds.json")
    assert document["inputs"][0]["dropped"] == {"hidden": 24 * 24}
