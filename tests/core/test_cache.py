"""Compiled kernels always find a place that can be written."""

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from surfcmp_core import _cache


@pytest.fixture(autouse=True)
def user_cache(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """The user's cache folder, and nobody's choice of another."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setenv("NUMBA_CACHE_DIR", "")
    monkeypatch.delenv("NUMBA_CACHE_DIR")
    return tmp_path / "cache"


def read_only_package(monkeypatch: pytest.MonkeyPatch) -> None:
    """Make the package's folder look read-only, which root would not notice otherwise."""
    package = Path(_cache.__file__).parent
    truly: Callable[[Path, int], bool] = os.access
    monkeypatch.setattr(_cache.os, "access", lambda p, mode: p != package and truly(p, mode))


def test_package_that_can_be_written_keeps_them() -> None:
    _cache.use_writable_cache()
    assert "NUMBA_CACHE_DIR" not in os.environ


def test_read_only_package_sends_them_to_the_user(
    monkeypatch: pytest.MonkeyPatch, user_cache: Path
) -> None:
    read_only_package(monkeypatch)
    _cache.use_writable_cache()
    assert Path(os.environ["NUMBA_CACHE_DIR"]) == user_cache / "surfcmp" / "kernels"
    assert (user_cache / "surfcmp" / "kernels").is_dir()


def test_user_without_a_folder_gets_a_temporary_one(
    monkeypatch: pytest.MonkeyPatch, user_cache: Path
) -> None:
    read_only_package(monkeypatch)
    user_cache.write_text("in the way")
    _cache.use_writable_cache()
    folder = Path(os.environ["NUMBA_CACHE_DIR"])
    assert folder.is_dir()
    assert folder.stat().st_mode & 0o077 == 0
    assert user_cache not in folder.parents


def test_choice_of_the_user_stands(monkeypatch: pytest.MonkeyPatch) -> None:
    read_only_package(monkeypatch)
    monkeypatch.setenv("NUMBA_CACHE_DIR", "/somewhere")
    _cache.use_writable_cache()
    assert os.environ["NUMBA_CACHE_DIR"] == "/somewhere"
