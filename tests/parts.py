"""What imports what: ``python -m tests.parts`` draws the parts in CONTRIBUTING.md anew."""

import ast
from pathlib import Path

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "CONTRIBUTING.md"
BEGIN, END = "<!-- parts: python -m tests.parts -->\n", "<!-- end of the parts -->\n"


def modules(package: str) -> list[Path]:
    """List the modules of a package, but for the one that it is itself."""
    folder = ROOT / package
    return sorted(path for path in folder.rglob("*.py") if path != folder / "__init__.py")


def imports(path: Path) -> set[str]:
    """Name everything a module imports, wherever in it and be it for its types alone."""
    names = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            names |= {node.module or ""}
            names |= {f"{node.module}.{alias.name}" for alias in node.names}
    return names


def part_of(path: Path) -> str:
    """Name the folder or the single module right below its package."""
    return path.relative_to(ROOT).parts[1].removesuffix(".py")


def arrows(package: str) -> dict[str, set[str]]:
    """Give to each part of a package the others that it imports; the core is one to the window."""
    found: dict[str, set[str]] = {part_of(path): set() for path in modules(package)}
    for path in modules(package):
        own = part_of(path)
        for first, _, rest in (name.partition(".") for name in imports(path)):
            other = rest.split(".")[0] if first == package else first
            if other != own and other in {*found, "surfcmp_core"}:
                found[own].add(other)
    return found


def behind(part: str, found: dict[str, set[str]]) -> set[str]:
    """Give all that a part imports through others."""
    further = [found.get(one, set()) | behind(one, found) for one in found.get(part, set())]
    return set().union(*further)


def picture(package: str) -> str:
    """Draw the arrows, in the way the data go, that do not follow from others."""
    found = arrows(package)
    rows = [
        f"    {other} --> {part}\n"
        for part in sorted(found)
        for other in sorted(found[part] - behind(part, found))
    ]
    return "```mermaid\ngraph TD\n" + "".join(rows) + "```\n"


def drawn(page: str) -> str:
    """Return the page with the pictures as they are now."""
    before, rest = page.split(BEGIN)
    after = rest.split(END)[1]
    both = (f"\n`{package}`:\n\n{picture(package)}" for package in ("surfcmp_core", "app"))
    return before + BEGIN + "".join(both) + "\n" + END + after


if __name__ == "__main__":
    PAGE.write_text(drawn(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
