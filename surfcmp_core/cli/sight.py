"""What a comparison would take of one file: the part that is seen, the places with data."""

from surfcmp_core.comparing.cloud_data import data_of_cloud
from surfcmp_core.errors import InputError
from surfcmp_core.projection.placement import look_at
from surfcmp_core.projection.winding import TURNED
from surfcmp_core.report.numbers import figure, thousands, towards
from surfcmp_core.surface import Surface

Rows = list[tuple[str, str]]


def sight_rows(surface: Surface) -> Rows:
    """Return what `--project auto` would keep of one surface, and what not for which reason."""
    try:
        sight = look_at(surface)
    except InputError as fault:
        return [("nothing", str(fault))]
    removed = sight.removed
    nodes = {"kept": len(sight.part.points), **removed.nodes}
    area = {"kept": removed.area_kept, **removed.area} if surface.faces is not None else {}
    rows = [("direction", towards(sight.motion[2, :3].tolist()))]
    if removed.reversed:
        rows.append(("side", "its back: triangles wind clockwise in this view"))
    for reason in dict.fromkeys((*nodes, *area)):
        texts = [f"{thousands(nodes.get(reason, 0))} nodes{_share(reason, nodes)}"]
        if reason in area:
            texts.append(f"{_area(area[reason], surface)}{_share(reason, area)}")
        rows.append((reason, ", ".join(texts)))
    turned = sight.part.changed.get(TURNED, 0) - surface.changed.get(TURNED, 0)
    if turned:
        rows.append(("turned", f"{thousands(turned)} triangles, to wind like their neighbours"))
    return rows


def data_rows(surface: Surface) -> tuple[Rows, float]:
    """Return where a cloud has data when nothing says how far its edges may reach.

    And what share of its nodes lie among nodes of another layer.
    """
    if surface.faces is not None:
        return [], 0.0

    try:
        data = data_of_cloud(surface)
    except InputError as fault:
        return [("nothing", str(fault))], 0.0
    unit = "" if surface.unit is None else f" {surface.unit}"
    areas = {"data": data.area, "gaps": data.hull_area - data.area}
    usual, most = figure(data.usual_edge) + unit, figure(data.max_edge) + unit
    grows = "" if usual == most else f", up to {most} where nodes lie far apart"
    rows = [
        ("max-edge", f"{usual}{grows}"),
        ("with data", f"{_area(data.area, surface)}{_share('data', areas)} of the convex hull"),
    ]
    return rows, data.among_layers


def _share(one: str, of: dict[str, int] | dict[str, float]) -> str:
    part, total = of.get(one, 0), sum(of.values())
    if not total:
        return ""
    share = 100.0 * part / total
    return f" ({share if part == total else min(share, 99.99):.4g} %)"  # all is only all


def _area(area: float, surface: Surface) -> str:
    return f"{figure(area)} {surface.unit}²" if surface.unit else figure(area)
