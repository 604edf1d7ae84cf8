"""Compiled kernels always find a place that can be written."""

import os
import re
import shutil
from pathlib import Path

import pytest

from surfcmp_core.compiled import cache as _cache


@pytest.fixture(autouse=True)
def user_cache(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """The user's cache folder, and nobody's choice of another."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setenv("NUMBA_CACHE_DIR", "")
    monkeypatch.delenv("NUMBA_CACHE_DIR")
    return tmp_path / "cache"


def test_kernels_go_to_the_user_and_belong_to_the_sources(
    monkeypatch: pytest.MonkeyPatch, user_cache: Path
) -> None:
    _cache.use_own_cache()
    folder = Path(os.environ.pop("NUMBA_CACHE_DIR"))
    assert folder.parent == user_cache / "surfcmp" / "kernels"
    assert folder.is_dir()
    _cache.use_own_cache()
    assert Path(os.environ.pop("NUMBA_CACHE_DIR")) == folder

    changed = user_cache / "changed"
    shutil.copytree(Path(_cache.__file__).parents[1], changed)
    monkeypatch.setattr(_cache, "__file__", str(changed / "compiled" / "cache.py"))
    with (changed / "io" / "read.py").open("a") as source:
        source.write("# no kernel is compiled from this\n")
    _cache.use_own_cache()
    assert Path(os.environ.pop("NUMBA_CACHE_DIR")) == folder
    with (changed / "predicates" / "orientation.py").open("a") as source:
        source.write("# changed\n")
    _cache.use_own_cache()
    assert Path(os.environ["NUMBA_CACHE_DIR"]) != folder


def test_kernels_of_sources_long_gone_are_dropped(user_cache: Path) -> None:
    old, recent = (user_cache / "surfcmp" / "kernels" / name for name in ("old", "recent"))
    old.mkdir(parents=True)
    recent.mkdir()
    os.utime(old, (0.0, 0.0))
    _cache.use_own_cache()
    assert not old.exists()
    assert recent.is_dir()


def test_user_without_a_folder_gets_a_temporary_one(user_cache: Path) -> None:
    user_cache.write_text("in the way")
    _cache.use_own_cache()
    folder = Path(os.environ["NUMBA_CACHE_DIR"])
    assert folder.is_dir()
    assert folder.stat().st_mode & 0o077 == 0
    assert user_cache not in folder.parents


def test_choice_of_the_user_stands(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NUMBA_CACHE_DIR", "/somewhere")
    _cache.use_own_cache()
    assert os.environ["NUMBA_CACHE_DIR"] == "/somewhere"


def test_no_kernel_is_compiled_from_parts_that_do_not_count() -> None:
    core = Path(_cache.__file__).parents[1]
    kernel = re.compile("^@(kernel|inlined)$", re.MULTILINE)
    files = [path for path in core.rglob("*.py") if kernel.search(path.read_text("utf-8"))]
    assert len(files) > 30
    for path in files:
        assert path.relative_to(core).parts[0] not in _cache.WITHOUT_KERNELS, path
        for part in _cache.WITHOUT_KERNELS:
            assert f"surfcmp_core.{part}" not in path.read_text("utf-8"), f"{path} imports {part}"
