"""The window's imports run one way, and only what draws knows pyvista."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import app
from tests.parts import imports, modules, part_of

APP = Path(app.__file__).parent
ORDER = (
    {"model"},
    {"look", "settings"},
    {"scene"},
    {"jobs"},
    {"drawing"},
    {"views", "panels"},
    {"controllers"},
    {"actions"},
    {"window"},
    {"screenshot", "__main__"},
)
"""Each part may import those in the rows above it, and itself."""
RANK = {part: rank for rank, parts in enumerate(ORDER) for part in parts}
MODULES = modules("app")


@pytest.mark.parametrize("path", MODULES, ids=lambda path: str(path.relative_to(APP)))
def test_imports_run_with_the_stream(path: Path):
    own = part_of(path)
    for name in imports(path):
        words = name.split(".")
        if words[0] == "app" and words[1:] and words[1] != own:
            assert RANK[words[1]] < RANK[own], f"{own} imports {name}, which is no further up"


@pytest.mark.parametrize("path", MODULES, ids=lambda path: str(path.relative_to(APP)))
def test_model_and_scene_know_no_screen(path: Path):
    own = path.relative_to(APP).parts[0]
    roots = {name.split(".")[0] for name in imports(path)}
    if own in {"model", "scene"}:
        assert not roots & {"PySide6", "pyvista", "vtkmodules"}
    if own != "drawing":
        assert not roots & {"pyvista", "vtkmodules"}


def test_no_imports_run_in_a_circle():
    names = {".".join(path.relative_to(APP.parent).with_suffix("").parts): path for path in MODULES}
    after = {}
    for name, path in names.items():
        found = imports(path)
        after[name] = {
            one for one in names if one in found or any(n.startswith(f"{one}.") for n in found)
        }
    while ends := [name for name, others in after.items() if not others]:
        after = {name: others - set(ends) for name, others in after.items() if name not in ends}
    assert not after


def test_the_window_is_there_before_the_core():
    code = "import sys, app.window; print({'numba', 'scipy', 'matplotlib'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "set()\n"


TESTS = [
    path
    for room in ("app", "window", "benchmarks")
    for path in sorted((Path(__file__).parents[1] / room).glob("*.py"))
]


@pytest.mark.parametrize("path", TESTS, ids=lambda path: "/".join(path.parts[-2:]))
def test_no_test_reaches_into_what_is_private(path: Path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    reached = [node for node in ast.walk(tree) if isinstance(node, ast.Attribute)]
    names = {node.attr for node in reached if ast.unparse(node.value) not in {"self", "os"}}
    names |= {name.rsplit(".", 1)[-1] for name in imports(path) if name.startswith("app.")}
    assert not {name for name in names if name.startswith("_") and not name.startswith("__")}
