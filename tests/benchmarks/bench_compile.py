"""Cold compilation of everything on first use, in an empty cache."""

import os
import subprocess
import sys
import tempfile
from time import perf_counter

_PROGRAM = """
from surfcmp_core.comparing.request import compare
from tests.benchmarks.surfaces import uniform_surface
compare(uniform_surface(500, 1), uniform_surface(500, 2))
"""

if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "NUMBA_CACHE_DIR": folder}
        for state in ("cold", "warm"):
            begin = perf_counter()
            subprocess.run([sys.executable, "-c", _PROGRAM], check=True, env=environment)
            print(
                f"first comparison, {state} cache: {perf_counter() - begin:.2f} s, imports included"
            )
