"""What docstrings cite stands in the bibliography, and what stands there is cited."""

import re
from pathlib import Path

import surfcmp_core

CORE = Path(surfcmp_core.__file__).parent
KEY = re.compile(r"\[([A-Z][A-Za-z]+(?:1[89]|20)\d{2})\]")


def test_each_key_stands_once_and_is_cited() -> None:
    text = (CORE / "bibliography.md").read_text(encoding="utf-8")
    keys = re.findall(rf"^- {KEY.pattern} ", text, re.MULTILINE)
    assert keys == sorted(set(keys))
    cited = {
        key for path in CORE.rglob("*.py") for key in KEY.findall(path.read_text(encoding="utf-8"))
    }
    assert cited == set(keys)
