"""What another process compiles at first use is what a comparison needs."""

import json
import subprocess
import sys
import threading

import pytest

from surfcmp_core import warming

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
from surfcmp_core.compare import compare
from surfcmp_core.surface import Surface
compare(*(Surface(np.random.default_rng(k).random((100, 3)), unit="mm") for k in (1, 2)))
"""
_LATER_STAGES = "from surfcmp_core.warming import compile_later_stages; compile_later_stages()"


def _signatures(program: str) -> set[str]:
    """Give those that Python asks for, which are loaded alone where all are in the cache."""
    command = [sys.executable, "-c", program + _SIGNATURES]
    subprocess.run(command, check=True, capture_output=True)
    return set(json.loads(subprocess.run(command, check=True, capture_output=True).stdout))


def test_nothing_is_compiled_that_no_comparison_uses() -> None:
    later = _signatures(_LATER_STAGES)
    assert later <= _signatures(_COMPARISON)
    for kernel in ("measure._pass", "localisation._locate_along_tree", "spacing._medians"):
        assert any(f"{kernel} " in signature for signature in later)


def test_the_other_process_is_started_and_may_fail(monkeypatch: pytest.MonkeyPatch) -> None:
    begun = threading.Event()

    def refused(*_: object, **__: object) -> None:
        begun.set()
        raise OSError

    monkeypatch.setattr(subprocess, "Popen", refused)
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    warming.begin_to_compile()
    assert begun.wait(10.0)
