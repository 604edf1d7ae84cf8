"""The core knows no screen, and its imports run one way."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import surfcmp_core
from tests.parts import PAGE, drawn, imports, modules, part_of

CORE = Path(surfcmp_core.__file__).parent
FOREIGN = {"PySide6", "shiboken6", "vtk", "vtkmodules", "pyvista", "pyvistaqt", "pyqtgraph"}
FOREIGN |= {"superqt", "qtpy", "app", "matplotlib.pyplot"}

ORDER = (
    {"names"},
    {"errors"},
    {"compiled", "system"},
    {"predicates", "surface"},
    {"cells", "grid", "io"},
    {"triangulation", "projection"},
    {"alignment"},
    {"spanning_tree"},
    {"localisation"},
    {"interpolation"},
    {"interface"},
    {"united"},
    {"domain"},
    {"measures"},
    {"comparing"},
    {"colours"},
    {"report"},
    {"cli"},
)
"""Each part may import those in the rows above it, and itself."""
RANK = {part: rank for rank, parts in enumerate(ORDER) for part in parts}

MODULES = modules("surfcmp_core")


def part(name: str) -> str | None:
    """Give the part of the core that a dotted name lies in, None for the package itself."""
    words = name.split(".")
    return words[1] if words[0] == "surfcmp_core" and len(words) > 1 else None


@pytest.mark.parametrize("path", [CORE / "__init__.py", *MODULES], ids=lambda p: str(p.name))
def test_no_module_of_the_core_names_a_screen(path: Path) -> None:
    wrong = {
        name
        for name in imports(path)
        if name.split(".")[0] in FOREIGN or any(name.startswith(f) for f in FOREIGN if "." in f)
    }
    assert not wrong


@pytest.mark.parametrize("path", MODULES, ids=lambda p: str(p.relative_to(CORE)))
def test_imports_run_with_the_stream(path: Path) -> None:
    own = part_of(path)
    assert own in RANK, f"{own} has no place in the order"
    for name in imports(path):
        other = part(name)
        if other is None or other == own:
            continue
        assert other in RANK, f"{path}: {name} has no place in the order"
        assert RANK[other] < RANK[own], f"{own} imports {name}, which is no further up"


def test_the_picture_of_the_parts_is_as_the_imports_are() -> None:
    page = PAGE.read_text(encoding="utf-8")
    assert page == drawn(page), "python -m tests.parts draws it anew"


PUT_OFF = {"importlib", "laspy", "matplotlib", "numba", "psutil", "resource", "scipy"}
PUT_OFF |= {"surfcmp_core.cli", "surfcmp_core.compiled"}
"""What only a function that needs it imports: it takes long, or is not there on every system."""


@pytest.mark.parametrize("path", MODULES, ids=lambda p: str(p.relative_to(CORE)))
def test_functions_import_only_what_takes_long(path: Path) -> None:
    for function in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(function, ast.FunctionDef):
            for node in ast.walk(function):
                names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
                if isinstance(node, ast.ImportFrom):
                    names = [node.module or ""]
                for name in names:
                    start = ".".join(name.split(".")[: 2 if name.startswith("surfcmp") else 1])
                    assert start in PUT_OFF, f"{function.name} imports {name}"


def test_comparing_loads_no_screen(tmp_path: Path) -> None:
    for name, height in (("a", 0), ("b", 1)):
        (tmp_path / f"{name}.xyz").write_text(
            "".join(f"{x} {y} {height}\n" for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)))
        )
    code = (
        "import sys\n"
        "from app.__main__ import main\n"
        "status = main(sys.argv[1:])\n"
        f"wrong = {sorted(FOREIGN - {'app'})!r}\n"
        "print(status, sorted(set(wrong) & set(sys.modules)), file=sys.stderr)\n"
    )
    files = [str(tmp_path / "a.xyz"), str(tmp_path / "b.xyz")]
    done = subprocess.run(
        [sys.executable, "-c", code, "compare", *files, "--quiet"],
        capture_output=True,
        text=True,
        check=True,
        cwd=Path(__file__).parents[2],
    )
    assert done.stderr.split("\n")[-2] == "0 []"
    assert done.stdout == ""
