"""Pictures of a comparison without a display: heatmaps and the histogram."""

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparison import Comparison
from surfcmp_core.report.document import Document
from surfcmp_core.report.numbers import with_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

INK = "#1f2430"
QUIET = "#6b7280"
NOT_COMPARED = "#c9ccd1"
_STYLE = {
    "font.family": "sans-serif",
    "font.size": 9.0,
    "axes.edgecolor": "#b6bbc4",
    "axes.labelcolor": QUIET,
    "axes.linewidth": 0.8,
    "xtick.color": QUIET,
    "ytick.color": QUIET,
    "text.color": INK,
    "axes.formatter.useoffset": False,
}


def round_up(value: float) -> float:
    """Return the next round number, for the end of a colour scale; 1 where there is nothing."""
    if not math.isfinite(value) or value <= 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    steps = (1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10)
    return next(step * power for step in steps if step * power >= value * (1 - 1e-12))


def heatmap(
    comparison: Comparison, document: Document, *, signed: bool = False, titled: bool = True
) -> "Figure":
    """Draw the mean difference of each triangle as a map, to scale.

    Parameters
    ----------
    comparison, document
        The comparison and its .json document.
    signed
        d itself on a diverging scale with zero in the middle, else |d|.
    titled
        Whether files and the main numbers stand above the map.

    Returns
    -------
    matplotlib.figure.Figure
        The scale ends at the next round number above the 95th percentile; triangles that were
        not compared are grey.
    """
    import matplotlib as mpl
    from cmcrameri import cm
    from matplotlib.figure import Figure

    unit = document["options"]["unit"]
    end = round_up(document["measures"]["p95"] or 0.0)
    nodes = comparison.united.nodes
    low, high = nodes.min(axis=0), nodes.max(axis=0)
    span = np.maximum(high - low, 1e-9 * (high - low).max())
    shrink = 6.2 / max(span[0], 1.05 * span[1], 1e-300)
    with mpl.rc_context(_STYLE):
        width, height = np.maximum(shrink * span, 1.6) + (2.0, 1.5 if titled else 0.75)
        figure = Figure(figsize=(max(width, 6.4), height), dpi=160, layout="constrained")
        axes = figure.add_subplot()
        map_ = _paint(
            axes,
            comparison,
            comparison.mean_signed if signed else comparison.mean_abs,
            cmap=(cm.vik if signed else cm.lajolla_r).with_extremes(bad=NOT_COMPARED),
            vmin=-end if signed else 0.0,
            vmax=end,
        )
        bar = figure.colorbar(
            map_, ax=axes, extend="both" if signed else "max", fraction=0.05, pad=0.02, aspect=28
        )
        what = "z₁ − z₂" if signed else "|z₁ − z₂|"
        bar.set_label(f"{what}, mean of each triangle ({unit})")
        bar.outline.set_linewidth(0.6)
        axes.set(aspect="equal", xlabel=f"x ({unit})", ylabel=f"y ({unit})")
        axes.locator_params(nbins=6)
        axes.margins(0.02)
        if not comparison.compared.all():
            axes.text(
                1.0,
                1.008,
                "■ not compared",
                transform=axes.transAxes,
                ha="right",
                va="bottom",
                color="#9aa0aa",
                fontsize=8,
            )
        if titled:
            axes.set_title(
                _title(document), loc="left", fontsize=11.5, fontweight="bold", pad=26, color=INK
            )
            axes.annotate(
                _summary(document),
                (0, 1),
                xytext=(0, 16),
                xycoords="axes fraction",
                textcoords="offset points",
                va="center",
                color=QUIET,
            )
    return figure


def histogram(comparison: Comparison, document: Document) -> "Figure":
    """Draw how the compared area is spread over |d|, with the tolerances as lines."""
    import matplotlib as mpl
    from cmcrameri import cm
    from matplotlib.figure import Figure
    from matplotlib.ticker import PercentFormatter

    unit = document["options"]["unit"]
    compared = comparison.compared
    values, area = comparison.mean_abs[compared], comparison.area[compared]
    total = float(area.sum()) or 1.0
    end = 1.5 * round_up(document["measures"]["p95"] or 0.0)
    edges = np.linspace(0, end, 61)
    share = np.histogram(np.minimum(values, end), bins=edges, weights=area)[0] / total
    with mpl.rc_context(_STYLE):
        figure = Figure(figsize=(7.4, 2.3), dpi=160, layout="constrained")
        axes = figure.add_subplot()
        middle = (edges[1:] + edges[:-1]) / 2
        colours = cm.lajolla_r(np.minimum(middle / (end / 1.5), 1.0))
        axes.bar(middle, share, width=np.diff(edges), color=colours, edgecolor=INK, linewidth=0.3)
        for tolerance in comparison.options.tolerances:
            if tolerance < end:
                axes.axvline(tolerance, color=INK, linewidth=0.9, linestyle=(0, (4, 3)))
                axes.annotate(
                    f" {tolerance:g} {unit}",
                    (tolerance, 1),
                    xycoords=("data", "axes fraction"),
                    va="top",
                    fontsize=8,
                )
        beyond = float(area[values > end].sum()) / total
        last = f" (last bar: {beyond:.2%} beyond)" if beyond > 0 else ""
        axes.set(xlim=(0, end), xlabel=f"mean |z₁ − z₂| of each triangle ({unit}){last}")
        axes.set_ylabel("share of the area")
        axes.yaxis.set_major_formatter(PercentFormatter(1.0, symbol="\u2009%"))
        axes.spines[["top", "right"]].set_visible(False)
    return figure


def save(figure: "Figure", stream: Any, kind: str, dpi: int = 160) -> None:
    """Write a figure as "png" or "pdf" without a trace of the machine it was made on."""
    quiet = {"png": {"Software": None}, "pdf": {"Creator": None, "Producer": None}}[kind]
    figure.savefig(stream, format=kind, dpi=dpi, metadata=quiet)


def _paint(
    axes: "Axes", comparison: Comparison, values: NDArray[np.float64], **scale: Any
) -> Any:
    """Paint each triangle in one colour, without the seams of antialiased polygons."""
    from matplotlib.tri import Triangulation

    triangles = comparison.united.triangles
    corners = comparison.united.nodes[triangles].reshape(-1, 2)
    numbers = np.arange(len(corners), dtype=np.int32).reshape(-1, 3)
    return axes.tripcolor(
        Triangulation(corners[:, 0], corners[:, 1], numbers),
        np.ma.masked_invalid(np.repeat(values, 3)),
        shading="gouraud",
        rasterized=True,
        **scale,
    )


def _title(document: Document) -> str:
    first, second = (short_name(one["file"]) for one in document["inputs"])
    return f"{first}  −  {second}"


def short_name(file: str, limit: int = 40) -> str:
    """Return a file's name without its folders, its middle left out where it is long."""
    name = file.replace("\\", "/").rsplit("/", 1)[-1]
    if len(name) > limit:
        name = name[: limit // 2 - 1] + "…" + name[-limit // 2 :]
    return name.replace("$", r"\$")


def _summary(document: Document) -> str:
    measures, unit = document["measures"], document["options"]["unit"]
    mean, p95 = (" ".join(with_unit(measures[key], 1, unit)) for key in ("mean_abs", "p95"))
    parts = [f"mean |d| {mean}", f"95 % of the area below {p95}"]
    for tolerance, share in list(measures["within_tolerance"].items())[-1:]:
        value, per_cent = with_unit(share, None, unit)
        parts.append(f"{value} {per_cent} within {tolerance} {unit}")
    return "   ·   ".join(parts)
