"""What memory does not suffice for is refused before it is begun."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from app.__main__ import main
from surfcmp_core import compare
from surfcmp_core.comparing.memory_needed import COMPARING
from surfcmp_core.errors import InputError
from surfcmp_core.surface import Surface
from surfcmp_core.system import memory


@pytest.fixture
def little(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let a megabyte be free, and every work be asked about."""
    monkeypatch.setattr(memory, "free_memory", lambda: 1e6)
    monkeypatch.setattr(memory, "SMALL", 0)


def grid(count: int, z: float) -> Surface:
    x, y = np.meshgrid(np.arange(float(count)), np.arange(float(count)))
    return Surface(np.column_stack((x.ravel(), y.ravel(), np.full(x.size, z))), name=f"grid {z}")


@pytest.mark.usefixtures("little")
def test_a_comparison_is_refused_before_it_is_begun(monkeypatch: pytest.MonkeyPatch) -> None:
    begun = []
    monkeypatch.setattr("surfcmp_core.comparing.stages.grid_of", lambda *_a, **_k: begun.append(1))
    with pytest.raises(InputError, match=r"grid 0 and grid 1: needs about 0\.007 GB of memory"):
        compare(grid(100, 0), grid(100, 1))
    assert not begun


@pytest.mark.usefixtures("little")
def test_what_fits_is_done() -> None:
    assert compare(grid(20, 0), grid(20, 1)).measures.mean_abs == 1.0


def test_exact_needs_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(memory, "SMALL", 0)
    monkeypatch.setattr(memory, "free_memory", lambda: 800.0 * COMPARING * 1.2)
    compare(grid(20, 0), grid(20, 1))
    with pytest.raises(InputError, match="needs about"):
        compare(grid(20, 0), grid(20, 1), exact=True)


@pytest.mark.usefixtures("little")
@pytest.mark.parametrize("options", [[], ["--project", "auto", "--align", "icp"]])
def test_the_command_line_names_the_files(
    options: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    files = [str(tmp_path / name) for name in ("one.npy", "two.npy")]
    for file in files:
        np.save(file, np.random.default_rng(0).random((5000, 3)))
    assert main(["compare", *files, "--quiet", *options]) == 3
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert said.startswith(f"surfcmp: {files[0]} and {files[1]}: needs about 0.0")
    assert "of memory, 0.001 GB are free" in said


def test_a_file_that_is_too_large_is_not_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(memory, "SMALL", 0)
    monkeypatch.setattr(memory, "free_memory", lambda: 1000.0)
    path = tmp_path / "one.xyz"
    path.write_text("0 0 0\n" * 1000)
    assert main(["info", str(path)]) == 3
    assert capsys.readouterr().err.startswith(f"surfcmp: {path}: needs about ")


def test_no_memory_is_not_called_damage(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from surfcmp_core.io import read

    def full(_data: bytes) -> None:
        raise MemoryError

    monkeypatch.setitem(read.READERS, ".xyz", full)
    path = tmp_path / "one.xyz"
    path.write_text("0 0 0\n")
    assert main(["info", str(path)]) == 3
    assert capsys.readouterr().err == f"surfcmp: {path}: not enough memory to read it\n"


def test_free_memory_is_that_of_the_system_and_its_limits(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import psutil

    free = memory.free_memory()
    assert 0.0 < free <= psutil.virtual_memory().total
    if sys.platform != "linux":
        return
    group = tmp_path / "a" / "b"
    group.mkdir(parents=True)
    (tmp_path / "own").write_text("0::/a/b\n")
    for folder, most, used in ((group, "max", 10), (group.parent, "5000000", 3000000)):
        (folder / "memory.max").write_text(f"{most}\n")
        (folder / "memory.current").write_text(f"{used}\n")
        (folder / "memory.stat").write_text("anon 5\ninactive_file 1000000\n")
    monkeypatch.setattr(memory, "_PROCESS_GROUPS", tmp_path)
    monkeypatch.setattr(memory, "_OWN_GROUP", tmp_path / "own")
    assert memory.free_memory() == 3e6


LIMITED = """
import resource, sys
from surfcmp_core.system.memory import free_memory
limit = 1 << 32
resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
print(0 < free_memory() < limit)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="no such limit")
def test_a_limit_of_the_process_counts() -> None:
    said = subprocess.run(
        [sys.executable, "-c", LIMITED], capture_output=True, text=True, check=True
    )
    assert said.stdout == "True\n"
