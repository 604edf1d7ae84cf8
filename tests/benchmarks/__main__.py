"""``python -m tests.benchmarks [NAME...]``: every measurement here, or those named.

Each file `bench_*.py` is one measurement and runs in a process of its own, so that its peak memory
and its compilation are its own too.
"""

import subprocess
import sys
from pathlib import Path


def main(names: list[str]) -> int:
    """Run them one after the other; 1 if any failed."""
    here = Path(__file__).parent
    names = names or sorted(path.stem.removeprefix("bench_") for path in here.glob("bench_*.py"))
    failed = 0
    for name in names:
        print(f"== {name}", flush=True)
        module = f"{__package__}.bench_{name}"
        failed |= subprocess.run([sys.executable, "-m", module], check=False).returncode != 0
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
