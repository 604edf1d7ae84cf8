"""What another process compiles at first use is what a comparison needs."""

import json
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from surfcmp_core.comparing import warming
from surfcmp_core.system.lock import make_held

_SIGNATURES = """
import gc, json
from numba.core.dispatcher import Dispatcher
print(json.dumps(sorted(
    f"{one.py_func.__module__}.{one.py_func.__name__} {signature}"
    for one in gc.get_objects() if isinstance(one, Dispatcher)
    for signature in one.signatures
    if one.py_func.__module__.startswith("surfcmp_core")
)))
"""
_COMPARISON = """
import numpy as np
from surfcmp_core.comparing.request import compare
from surfcmp_core.surface import Surface
compare(*(Surface(np.random.default_rng(k).random((100, 3)), unit="mm") for k in (1, 2)))
"""
_LATER_STAGES = (
    "from surfcmp_core.comparing.warming import compile_later_stages; compile_later_stages()"
)


def _signatures(program: str) -> set[str]:
    """Give those that Python asks for, which are loaded alone where all are in the cache."""
    command = [sys.executable, "-c", program + _SIGNATURES]
    subprocess.run(command, check=True, capture_output=True)
    return set(json.loads(subprocess.run(command, check=True, capture_output=True).stdout))


def test_nothing_is_compiled_that_no_comparison_uses() -> None:
    later = _signatures(_LATER_STAGES)
    assert later <= _signatures(_COMPARISON)
    for part in ("measures", "localisation", "domain"):
        assert any(signature.startswith(f"surfcmp_core.{part}.") for signature in later)


def test_the_other_process_is_started_and_may_fail(monkeypatch: pytest.MonkeyPatch) -> None:
    begun = threading.Event()

    def refused(*_: object, **__: object) -> None:
        begun.set()
        raise OSError

    monkeypatch.setattr(subprocess, "Popen", refused)
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    warming.begin_to_compile.cache_clear()
    warming.begin_to_compile()
    assert begun.wait(10.0)


def test_one_process_at_a_time_compiles_for_a_cache(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    done: list[int] = []
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(warming, "compile_later_stages", lambda: done.append(len(done)))
    with make_held(tmp_path / "compiling"):
        warming.compile_once()
        assert done == []
    warming.compile_once()  # the file that a dead process left is in nobody's way
    warming.compile_once()
    assert done == [0, 1]
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "nowhere"))
    warming.compile_once()
    assert done == [0, 1]
