"""Where a result comes from, as rows for the pages a person reads."""

import platform
from typing import Any

from surfcmp_core.alignment import FitRecord
from surfcmp_core.report.numbers import thousands, towards, with_unit
from surfcmp_core.report.record import Record

DISCLAIMER = "For research and teaching; not a medical device."

Rows = list[tuple[str, str]]


def base_name(file: str) -> str:
    """Return a file's name without its folders."""
    return file.replace("\\", "/").rsplit("/", 1)[-1]


def key_figures(document: Record) -> list[tuple[str, str, str]]:
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


def input_rows(document: Record) -> list[Rows]:
    """Return what is known of each of the two inputs."""
    return [_input(one) for one in document["inputs"]]


def _input(one: Record) -> Rows:
    nodes = f"{thousands(one['nodes'])} nodes"
    if one["kind"] == "mesh":
        nodes += f", {thousands(one['triangles'])} triangles"
    rows = [("file", one["file"]), ("kind", f"{one['kind']}, {nodes}")]
    if one["dropped"]:
        rows.append(("dropped", _dropped(one)))
    return [*rows, ("SHA-256", one["sha256"] or "none (not from a file)")]


def left_out_rows(document: Record) -> Rows:
    """Return the nodes left out of each input by reason, where there are any."""
    numbered = enumerate(document["inputs"], 1)
    return [(f"left out of {k}", _dropped(one)) for k, one in numbered if one["dropped"]]


def _dropped(one: Record) -> str:
    return ", ".join(f"{reason}: {thousands(n)}" for reason, n in one["dropped"].items())


def view_rows(document: Record) -> Rows:
    """Return from where both surfaces are looked at, and whose back is seen."""
    options = document["options"]
    if options.get("view") is None:
        return [("seen from", "+z of the files")]
    how = "found from the surfaces" if options.get("project") == "auto" else "as given"
    rows = [("seen from", f"{towards(options['view'])}, {how}")]
    backs = [str(k) for k, behind in enumerate(options.get("reversed", ()), 1) if behind]
    if backs:
        rows.append(("from its back", f"surface {' and '.join(backs)}"))
    return rows


def count_rows(document: Record) -> Rows:
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
        *_face_rows(document),
    ]


def _face_rows(document: Record) -> Rows:
    """Return how many faces of either mesh T1 and T2 have turned, and how far that carries."""
    unit = document["options"]["unit"]
    rows = []
    for k, one in enumerate(document["inputs"], 1):
        faces = one.get("faces")
        if faces is None:
            continue
        text = f"{thousands(faces['replaced'])} of {thousands(one['triangles'])}"
        if faces["replaced"]:
            mean, largest = (
                " ".join(with_unit(faces[key], 1, unit))
                for key in ("mean_difference", "largest_difference")
            )
            text += f"; the file's surface differs by {mean} in the mean, {largest} at most"
        rows.append((f"faces of {k} not in T{k}", text))
    return rows


def option_rows(document: Record) -> Rows:
    """Return every option as it was used."""
    options = dict(document["options"])
    limits = (
        "no limit" if limit is None else f"{limit:.6g}" for limit in options.pop("max_edge_used")
    )
    if options.pop("max_edge_derived"):
        options["max_edge"] = "derived from the node spacing"
    elif options["max_edge"] is None:
        options["max_edge"] = "no limit"
    rows = [(key, _plain(value)) for key, value in options.items() if key != "align"]
    used = ", ".join(f"{limit} (surface {number})" for number, limit in enumerate(limits, 1))
    return [*rows, ("max_edge used", used)]


def alignment_rows(document: Record) -> Rows:
    """Return how surface 2 was moved onto surface 1, and how well that went."""
    asked = document["options"].get("align")
    file = asked.get("file") if isinstance(asked, dict) else None
    rows = fit_rows(document["alignment"], document["options"]["unit"])
    return [rows[0], *([("file", file)] if file else []), *rows[1:]]


def fit_rows(found: FitRecord, unit: str) -> Rows:
    """Return what the record of an alignment says; of what is not known nothing."""

    def length(value: float) -> str:
        return " ".join(with_unit(value, 1, unit))

    rows = [("method", str(found["method"]))]
    if found["rms_kept"] is not None:
        kept = f"{length(found['rms_kept'])}, root mean square of {thousands(found['pairs_kept'])}"
        rows.append(("residual", f"{kept} pairs kept"))
        every = (
            f"{length(found['rms_region'])}, root mean square of all {thousands(found['pairs'])}"
        )
        rows.append(("residual of all", every + " pairs"))
    rows += [
        (f"landmark {mark['name']}", f"{length(mark['residual'])} left")
        for mark in found["landmarks"]
    ]
    if found["rounds"]:
        one, two = (100.0 * found[f"overlap_{number}"] for number in (1, 2))
        rows.append(("overlap", f"{one:.1f} % of the nodes of 1, {two:.1f} % of those of 2"))
        rows.append(
            ("agreement", f"{found['agreement']:.2f} of directions (0: by chance, 1: alike)")
        )
    if found["turned"] is not None:
        rows.append(
            ("reach", f"turned by {found['turned']:.3g}°, shifted by {length(found['shifted'])}")
        )
    if found["rounds"]:
        rows.append(("free to", ", ".join(found["free"]) or "nothing: held in every direction"))
        rows.append(("rounds", f"{found['rounds']}, {'' if found['converged'] else 'not '}settled"))
    return rows


REGION_COLUMNS = (
    ("area_compared", "area", 2),
    ("mean_abs", "mean |d|", 1),
    ("mean_signed", "mean d", 1),
    ("rms", "RMS", 1),
    ("p95", "P95", 1),
)


def region_table(document: Record) -> list[list[str]]:
    """Return a row of heads, one for each region, for the rest, and for the whole; or nothing.

    Columns: name, µ, and those of `REGION_COLUMNS`, and the share within the last tolerance.
    """
    regions = document.get("regions")
    if not regions:
        return []
    unit = document["options"]["unit"]
    within = list(document["measures"]["within_tolerance"])[-1:]
    heads = [f"{title} ({with_unit(1.0, power, unit)[1]})" for _, title, power in REGION_COLUMNS]
    table = [["region", "µ", *heads, *(f"≤ {tolerance} {unit}" for tolerance in within)]]
    parts = [
        (part["name"] or "the rest", f"{part['weight']:g}", part["measures"]) for part in regions
    ]
    for name, weight, measures in [*parts, ("the whole", "", document["measures"])]:
        row = [name, weight]
        for key, _title, power in REGION_COLUMNS:
            row.append(with_unit(measures[key] if measures else None, power, unit)[0])
        for tolerance in within:
            share = measures["within_tolerance"][tolerance] if measures else None
            row.append(" ".join(with_unit(share, None, unit)).strip())
        table.append(row)
    return table


def transform_text(document: Record) -> str:
    """Return the 4x4 transform, or a word where it moves nothing."""
    matrix = document["transform"]
    if matrix == [[float(row == column) for column in range(4)] for row in range(4)]:
        return "none: the files' own coordinates"
    return "\n".join("  ".join(f"{value: .9g}".rjust(16) for value in line) for line in matrix)


def versions() -> str:
    """Return the versions of what computed the numbers."""
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
    if isinstance(value, list):
        return ", ".join(_plain(one) for one in value)
    return str(value)
