"""Where a result comes from, as rows for the pages a person reads."""

from typing import Any

from surfcmp_core.report.document import Document
from surfcmp_core.report.numbers import thousands, with_unit

DISCLAIMER = "For research and teaching; not a medical device."

Rows = list[tuple[str, str]]


def base_name(file: str) -> str:
    """Return a file's name without its folders."""
    return file.replace("\\", "/").rsplit("/", 1)[-1]


def key_figures(document: Document) -> list[tuple[str, str, str]]:
    """Return title, figure and unit of the few numbers that are asked for first."""
    measures, unit = document["measures"], document["options"]["unit"]
    rows = [
        ("mean |d|", measures["mean_abs"], 1),
        ("95 % lie below", measures["p95"], 1),
        *(
            (f"within {tolerance} {unit}", share, None)
            for tolerance, share in list(measures["within_tolerance"].items())[-1:]
        ),
        ("compared, of 1", measures["coverage_1"], None),
        ("compared, of 2", measures["coverage_2"], None),
    ]
    return [(title, *with_unit(value, power, unit)) for title, value, power in rows]


def input_rows(document: Document) -> list[Rows]:
    """Return what is known of each of the two inputs."""
    return [_input(one) for one in document["inputs"]]


def _input(one: Document) -> Rows:
    nodes = f"{thousands(one['nodes'])} nodes"
    if one["kind"] == "mesh":
        nodes += f", {thousands(one['triangles'])} triangles"
    rows = [("file", one["file"]), ("kind", f"{one['kind']}, {nodes}")]
    if one["dropped"]:
        dropped = ", ".join(f"{reason}: {thousands(n)}" for reason, n in one["dropped"].items())
        rows.append(("dropped", dropped))
    return [*rows, ("SHA-256", one["sha256"] or "none (not from a file)")]


def count_rows(document: Document) -> Rows:
    """Return nodes, triangles and chains, a row for each kind."""
    n = {key: thousands(value) for key, value in document["counts"].items()}
    return [
        ("nodes", f"{n['nodes_1']} of 1, {n['nodes_2']} of 2, {n['nodes_shared']} shared"),
        ("triangles of T1, T2", f"{n['triangles_1']}, {n['triangles_2']}"),
        ("united triangulation", f"{n['triangles_united']} triangles"),
        ("of these compared", n["triangles_compared"]),
        ("interface triangles", n["triangles_interface"]),
        ("representative triangles", n["triangles_representative"]),
        ("chains", f"{n['chains']} ({n['chains_closed']} closed, {n['chains_open']} open)"),
    ]


def option_rows(document: Document) -> Rows:
    """Return every option as it was used."""
    options = dict(document["options"])
    limits = (
        "no limit" if limit is None else f"{limit:.6g}" for limit in options.pop("max_edge_used")
    )
    if options.pop("max_edge_derived"):
        options["max_edge"] = "derived from the node spacing"
    elif options["max_edge"] is None:
        options["max_edge"] = "no limit"
    rows = [(key, _plain(value)) for key, value in options.items()]
    used = ", ".join(f"{limit} (surface {number})" for number, limit in enumerate(limits, 1))
    return [*rows, ("max_edge used", used)]


def transform_text(document: Document) -> str:
    """Return the 4x4 transform, or a word where it moves nothing."""
    matrix = document["transform"]
    if matrix == [[float(row == column) for column in range(4)] for row in range(4)]:
        return "none: the files' own coordinates"
    return "\n".join("  ".join(f"{value: .9g}".rjust(16) for value in line) for line in matrix)


def versions() -> str:
    """Return the versions of what computed the numbers."""
    import platform
    from importlib.metadata import version

    libraries = ", ".join(f"{name} {version(name)}" for name in ("numpy", "numba", "scipy"))
    return f"Python {platform.python_version()}, {libraries}"


def _plain(value: Any) -> str:
    if value is None:
        return "none"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, dict):  # how it was aligned; its matrix stands as the transform
        return ", ".join(f"{name}: {_plain(v)}" for name, v in value.items() if name != "matrix")
    if isinstance(value, list):
        return ", ".join(_plain(one) for one in value)
    return str(value)
