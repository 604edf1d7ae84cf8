"""What the README shows is what happens."""

import re
import shlex
import subprocess
import sys
from pathlib import Path

from surfcmp_core.io.read import READERS
from surfcmp_core.report import WRITERS

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def lines_of(block: str) -> list[str]:
    return [" ".join(line.split()) for line in block.splitlines() if line.strip()]


def run(*arguments: str) -> str:
    done = subprocess.run(
        [sys.executable, *arguments], cwd=ROOT, capture_output=True, encoding="utf-8", timeout=110
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_python_example_prints_what_it_says() -> None:
    found = re.search(r"```python\n((?:.*\n)*?)```\n\nprints\n\n((?: {4}.*\n)+)", README)
    assert found
    assert lines_of(run("-c", found[1])) == lines_of(found[2])


def test_comparison_shown_is_the_one_made(tmp_path: Path) -> None:
    found = re.search(r"\n {4}\$ surfcmp (.*)\n((?:.*\n)*?) {4}\[\.\.\.\]\n", README)
    assert found
    page = tmp_path / "page.html"
    command = [str(page) if word == "page.html" else word for word in shlex.split(found[1])]
    shown = lines_of(found[2])
    assert len(shown) > 5
    assert lines_of(run("-m", "app", *command))[: len(shown)] == shown
    assert page.read_text(encoding="utf-8").lower().startswith("<!doctype html>")


def test_formats_named_are_those_read_and_written() -> None:
    for what, known in (("read", READERS), ("write", WRITERS)):
        found = re.search(rf"^\| {what} \| (.*) \|$", README, re.MULTILINE)
        assert found
        assert found[1].split() == list(known)


def test_targets_named_exist() -> None:
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    for target in set(re.findall(r"`?make ([a-z-]+)`?$|`make ([a-z-]+)`", README, re.MULTILINE)):
        assert re.search(rf"^{''.join(target)}:", makefile, re.MULTILINE), target
