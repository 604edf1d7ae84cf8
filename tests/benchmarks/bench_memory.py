"""Peak memory of a comparison above the imports, for each input node."""

import subprocess
import sys

_PROGRAM = """
import resource, sys
from surfcmp_core.comparing.request import compare
from tests.benchmarks.surfaces import uniform_surface
count = int(sys.argv[1])
small = uniform_surface(500, 1), uniform_surface(500, 2)
compare(*small)
pair = uniform_surface(count, 1), uniform_surface(count, 2)
def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
before = peak()
compare(*pair)
print((peak() - before) / (2 * count))
"""

if __name__ == "__main__":
    for count in (100_000, 1_000_000):
        out = subprocess.run(
            [sys.executable, "-c", _PROGRAM, str(count)], capture_output=True, text=True, check=True
        ).stdout
        print(f"{count} + {count} nodes: {float(out):.0f} bytes a node above imports and input")
