"""Every text of the window can be translated: Qt's tools find it."""

import ast
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import pytest

import app
from app.panels.alignment_panel import METHODS
from app.views.overlays import LEGEND
from surfcmp_core.report import meanings
from surfcmp_core.report.meanings import EXACT, MEANINGS, NOTES

APP = Path(app.__file__).parent
PLACES = ("panels", "controllers", "views", "drawing", "jobs", "window.py", "actions.py")
"""Where texts are made; `model` and `scene` know no screen, and no language."""
MODULES = sorted(p for place in PLACES for p in [APP / place, *(APP / place).glob("*.py")])
MARKS = {"tr", "translate", "QT_TRANSLATE_NOOP"}
SILENT = {
    "setObjectName",
    "setProperty",
    "setStyleSheet",
    "getattr",
    "QKeySequence",
    "TypeVar",
    "environ",
}
"""Calls whose texts nobody reads."""
NOT_READ = re.compile(
    r"^(<|</|;|Ctrl\+|[A-Z]+$|Esc$|Home$|scans?[ /]|icp |spanning trees$|\.ply )"
    r"|surfcmp|^data:image|cellpadding|^[ ,;:]*$"
)
"""Shortcuts, marks of pages, names in files."""


def unmarked(tree: ast.Module) -> Iterator[str]:
    """Give the literals that look like words for people and are not marked."""
    skipped = set()
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list) and body and isinstance(body[0], ast.Expr):
            skipped.add(body[0].value)  # a docstring
        if isinstance(node, ast.Expr):
            skipped.add(node.value)  # what describes an attribute
        for part in ("annotation", "returns"):
            if getattr(node, part, None) is not None:
                skipped |= set(ast.walk(getattr(node, part)))
        if isinstance(node, ast.Call):
            name = getattr(node.func, "attr", getattr(node.func, "id", ""))
            if name in MARKS | SILENT:
                skipped |= set(ast.walk(node))
        if isinstance(node, ast.Subscript):
            skipped |= set(ast.walk(node.slice))
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node not in skipped:
            text = node.value
            like_words = re.search(r"[A-Za-z]{3}", text) and (" " in text or text[:1].isupper())
            if like_words and not NOT_READ.search(text):
                yield text


@pytest.mark.parametrize(
    "path", [p for p in MODULES if p.suffix == ".py"], ids=lambda p: str(p.relative_to(APP))
)
def test_texts_are_marked_for_translation(path: Path):
    texts = set(unmarked(ast.parse(path.read_text(encoding="utf-8"))))
    if path.name == "aligning.py":
        texts = {part for text in texts for part in text.split(", ") if part} - set(METHODS)
    assert texts - KNOWN.get(path.relative_to(APP).as_posix(), set()) == set()


@pytest.mark.parametrize(
    "path", [p for p in MODULES if p.suffix == ".py"], ids=lambda p: str(p.relative_to(APP))
)
def test_marks_stand_where_they_are_found(path: Path):
    """Qt's tools look neither into f-strings nor behind names."""
    for string in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(string, ast.JoinedStr):
            for call in ast.walk(string):
                if isinstance(call, ast.Call) and getattr(call.func, "attr", "") in MARKS:
                    assert not isinstance(call.args[-1], ast.Constant), ast.unparse(call)


def test_qt_finds_the_texts_of_the_core(tmp_path: Path):
    collect = Path(sys.executable).with_name("pyside6-lupdate")
    found = tmp_path / "core.ts"
    names = ["-tr-function-alias", "QT_TR_NOOP+=said"]
    subprocess.run([collect, *names, meanings.__file__, "-ts", found], check=True)
    (context,) = ElementTree.parse(found).iter("context")
    assert context.findtext("name") == ""
    shown = {*NOTES.values(), *EXACT.values()}
    shown |= {text for one in MEANINGS for text in (one.name, one.group, one.text)}
    assert {text.text for text in context.iter("source")} == shown - {"≤ {}"}


KNOWN = {
    "window.py": {"Fusion"},
    "drawing/renderer.py": {"AbortCheckEvent", "VTK_DEFAULT_OPENGL_WINDOW"},
}


def test_texts_of_legends_are_marked_for_translation():
    tree = ast.parse((APP / "scene" / "furniture.py").read_text(encoding="utf-8"))
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    swatches = [call for call in calls if getattr(call.func, "id", "") == "Swatch"]
    assert {ast.literal_eval(call.args[1]) for call in swatches} == set(LEGEND)
