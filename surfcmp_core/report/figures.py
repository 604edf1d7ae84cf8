"""Pictures of a comparison without a display: heatmaps and the histogram."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.colours.maps import ABOVE, BELOW, NOT_COMPARED, Rgb, difference_map
from surfcmp_core.colours.scale import Scale, band_colours, band_edges, bands_of, scale_of
from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.report.provenance import base_name, key_figures
from surfcmp_core.report.record import Record

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.colorbar import Colorbar
    from matplotlib.colors import Colormap
    from matplotlib.figure import Figure

INK = "#1f2430"
QUIET = "#6b7280"
NOT_COMPARED_INK = "#868c97"
MAP_MARGINS = (0.75, 0.6, 1.15)
"""Inches left of a map, below it, and right of it for a scale that stands."""
LYING = 0.75
"""Inches below a map's axes for a scale that lies."""
BINS = 80
LABEL_WIDTH = 0.6
"""Inches beside a tolerance's line for its label."""
_STYLE: Any = {
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


def heatmap(
    comparison: Comparison, document: Record, *, signed: bool = False, titled: bool = True
) -> "Figure":
    """Draw the mean difference of each triangle as a map, to scale.

    Parameters
    ----------
    comparison, document
        The comparison and its .json document.
    signed
        d itself on a diverging scale with zero in the middle, else |d|.
    titled
        Whether files and the main numbers stand above the map; without them it is smaller.

    Returns
    -------
    matplotlib.figure.Figure
        Triangles beyond the scale are magenta (violet below a signed one), those that were not
        compared are grey.
    """
    width, height = map_size(comparison, *((6.4, 7.0) if titled else (4.2, 5.0)))
    left, bottom, right, top = *MAP_MARGINS, 0.85 if titled else 0.3
    page = (max(left + width + right, 6.2 if titled else 0.0), bottom + height + top)
    figure = sheet(*page)
    draw_map(figure, comparison, document, (left, bottom, width, height), signed=signed)
    if titled:
        for down, text, style in (
            (0.28, title(document), {"fontsize": 11.5, "fontweight": "bold", "color": INK}),
            (0.5, _summary(document), {"color": QUIET}),
        ):
            figure.text(left / page[0], 1 - down / page[1], text, parse_math=False, **style)
    return figure


def sheet(width: float, height: float) -> "Figure":
    """Return an empty figure of a size in inches."""
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), dpi=160)


def map_size(comparison: Comparison, most_width: float, most_height: float) -> tuple[float, float]:
    """Return width and height of the map to scale, at most as large as said."""
    low, high = _frame(comparison)
    width, height = (high - low) * min((most_width, most_height) / (high - low))
    return float(width), float(height)


def draw_map(
    figure: "Figure",
    comparison: Comparison,
    document: Record,
    place: tuple[float, float, float, float],
    *,
    signed: bool,
    lying: bool = False,
) -> None:
    """Draw the map and its scale.

    Parameters
    ----------
    figure
        Where to.
    comparison, document
        The comparison and its .json document.
    place
        Left, bottom, width and height in inches, without `MAP_MARGINS`.
    signed
        d itself, else |d|.
    lying
        The scale lies below the map, else it stands right of it.
    """
    import matplotlib as mpl

    unit = document["options"]["unit"]
    scale = replace(scale_of(comparison, document), signed=signed)
    low, high = _frame(comparison)
    left, bottom, width, height = place
    values = comparison.mean_signed if signed else comparison.mean_abs
    with mpl.rc_context(_STYLE):
        axes = figure.add_axes(_inches(figure, left, bottom, width, height))
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        axes.set(xlabel=f"x ({unit})", ylabel=f"y ({unit})")
        axes.locator_params(axis="x", nbins=max(2, int(width / 0.9)))
        axes.locator_params(axis="y", nbins=max(2, int(height / 0.6)))
        if scale.bands:
            table = band_colours(scale)
            span = (-0.5, len(table) - 0.5)
            _paint(axes, comparison, bands_of(values, scale), _listed(table), span)
        else:
            _paint(axes, comparison, values, colours(signed), (scale.low, scale.end))
        if lying:
            beside = (left, bottom - LYING, width, 0.12)
        else:
            tall = max(min(height, 3.6), 1.2)
            beside = (left + width + 0.2, bottom + (height - tall) / 2, 0.14, tall)
        bar = _scale_bar(figure, beside, scale, _beyond(values, scale), lying)
        bar.set_label(f"{'z₁ − z₂' if signed else '|z₁ − z₂|'} ({unit})")
        if not comparison.compared.all():
            axes.annotate(
                "■ not compared",
                (1, 1),
                xytext=(0, 6),
                xycoords="axes fraction",
                textcoords="offset points",
                ha="right",
                color=NOT_COMPARED_INK,
                fontsize=8,
            )


def _beyond(values: NDArray[np.float64], scale: Scale) -> str:
    """Say, in matplotlib's words, at which ends of the scale values lie beyond it."""
    over = bool(np.nanmax(values, initial=0.0) > scale.end)
    under = bool(scale.signed and np.nanmin(values, initial=0.0) < scale.low)
    return {(0, 0): "neither", (1, 0): "max", (0, 1): "min", (1, 1): "both"}[over, under]


def _scale_bar(
    figure: "Figure",
    place: tuple[float, float, float, float],
    scale: Scale,
    extend: str,
    lying: bool,
) -> "Colorbar":
    """Draw a scale at left, bottom, width and height in inches."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import BoundaryNorm, Normalize

    kind: dict[str, Any] = {"orientation": "horizontal" if lying else "vertical"}
    if scale.bands:
        table = band_colours(scale)
        edges = band_edges(scale).tolist()
        inner = table[1:-1] if scale.signed else table[:-1]
        cmap = _listed(inner).with_extremes(over=table[-1] / 255, under=table[0] / 255)
        edges = edges if scale.signed else [0.0, *edges]
        source = ScalarMappable(BoundaryNorm(edges, len(inner)), cmap)
        kind |= {"extend": "both" if scale.signed else "max", "spacing": "uniform", "ticks": edges}
        kind |= {"extendfrac": "auto", "extendrect": True, "drawedges": True}
    else:
        source = ScalarMappable(Normalize(scale.low, scale.end), colours(scale.signed))
        kind |= {"extend": extend, "extendfrac": 0.05}
    bar = figure.colorbar(source, cax=figure.add_axes(_inches(figure, *place)), **kind)
    if scale.bands:
        bar.dividers.set_linewidth(0.4)
        bar.ax.set(**{"xticklabels" if lying else "yticklabels": [_short(edge) for edge in edges]})
    bar.outline.set_linewidth(0.6)
    return bar


def _short(value: float) -> str:
    return f"{value:g}".replace("-", "−")


def _listed(table: NDArray[np.uint8]) -> "Colormap":
    from matplotlib.colors import ListedColormap

    return ListedColormap(table / 255).with_extremes(bad=_shares(NOT_COMPARED))


def colours(signed: bool) -> "Colormap":
    """Return the colour map of a continuous scale."""
    beyond = {"over": _shares(ABOVE), "under": _shares(BELOW)}
    return _listed(difference_map(signed)).with_extremes(bad=_shares(NOT_COMPARED), **beyond)


def _shares(colour: Rgb) -> tuple[float, float, float]:
    red, green, blue = colour
    return red / 255, green / 255, blue / 255


def histogram(comparison: Comparison, document: Record) -> "Figure":
    """Draw how the compared area is spread over |d|, with the tolerances as lines."""
    figure = sheet(7.4, 2.4)
    draw_histogram(figure, comparison, document, (0.7, 0.5, 6.55, 1.8))
    return figure


def draw_histogram(
    figure: "Figure",
    comparison: Comparison,
    document: Record,
    place: tuple[float, float, float, float],
) -> None:
    """Draw the histogram at left, bottom, width and height in inches."""
    import matplotlib as mpl
    from matplotlib.ticker import FuncFormatter, MaxNLocator

    unit = document["options"]["unit"]
    scale = replace(scale_of(comparison, document), signed=False)
    compared = comparison.compared
    values, area = comparison.mean_abs[compared], comparison.area[compared]
    total = float(area.sum()) or 1.0
    edges = np.linspace(0, scale.end, BINS + 1)
    middle = (edges[1:] + edges[:-1]) / 2
    share = np.histogram(values, bins=edges, weights=area)[0] / total
    beyond = float(area[values > scale.end].sum()) / total
    if scale.bands:
        colour = band_colours(scale)[bands_of(middle, scale).astype(np.intp)]
    else:
        colour = difference_map(signed=False)[(256 * middle / scale.end).astype(np.intp)]
    with mpl.rc_context(_STYLE):
        axes = figure.add_axes(_inches(figure, *place))
        style: Any = {"edgecolor": QUIET, "linewidth": 0.3}
        axes.bar(middle, share, width=np.diff(edges), color=colour / 255, **style)
        before, line = -np.inf, 0
        for tolerance in sorted(comparison.options.tolerances):
            if tolerance < scale.end:
                axes.axvline(tolerance, color=INK, linewidth=0.9, linestyle=(0, (4, 3)))
                near = (tolerance - before) * place[2] < LABEL_WIDTH * scale.end
                before, line = tolerance, line + 1 if near else 0
                axes.annotate(
                    f" {tolerance:g} {unit}",
                    (tolerance, 1),
                    xytext=(0, -11 * line),
                    xycoords=("data", "axes fraction"),
                    textcoords="offset points",
                    va="top",
                    fontsize=8,
                    bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.4},
                )
        last = f"; {100 * beyond:.2g} % of the area lie beyond" if beyond > 0 else ""
        axes.set(xlim=(0, scale.end), xlabel=f"mean |z₁ − z₂| of each triangle ({unit}{last})")
        axes.set_ylabel("share of the area")
        axes.yaxis.set_major_locator(MaxNLocator(4))
        axes.yaxis.set_major_formatter(FuncFormatter(lambda part, _: f"{100 * part:g}\u2009%"))
        axes.spines[["top", "right"]].set_visible(False)


def _frame(comparison: Comparison) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return lower left and upper right of the map, with a small margin."""
    nodes = comparison.united.nodes
    low, high = nodes.min(axis=0), nodes.max(axis=0)
    margin = 0.02 * (high - low).max()
    return low - margin, high + margin


def _inches(
    figure: "Figure", left: float, bottom: float, width: float, height: float
) -> tuple[float, float, float, float]:
    across, up = figure.get_size_inches()
    return left / across, bottom / up, width / across, height / up


def save(figure: "Figure", stream: Any, kind: str, dpi: int = 160) -> None:
    """Write a figure as "png" or "pdf" without a trace of the machine it was made on."""
    quiet = {"png": {"Software": None}, "pdf": {"Creator": None, "Producer": None}}[kind]
    with any_script():
        figure.savefig(stream, format=kind, dpi=dpi, metadata=quiet)


@contextmanager
def any_script() -> Iterator[None]:
    """Draw boxes, without a word, for characters of names that the font does not have."""
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message="Glyph .* missing")
        yield


def _paint(
    axes: "Axes",
    comparison: Comparison,
    values: NDArray[np.float64],
    cmap: "Colormap",
    span: tuple[float, float],
) -> None:
    """Paint each triangle in one colour, without the seams of antialiased polygons."""
    from matplotlib.tri import Triangulation

    triangles = comparison.united.triangles
    corners = comparison.united.nodes[triangles].reshape(-1, 2)
    numbers = np.arange(len(corners), dtype=np.int32).reshape(-1, 3)
    axes.tripcolor(
        Triangulation(corners[:, 0], corners[:, 1], numbers),
        np.ma.masked_invalid(np.repeat(values, 3)),
        shading="gouraud",
        rasterized=True,
        cmap=cmap,
        vmin=span[0],
        vmax=span[1],
    )


def title(document: Record) -> str:
    """Return the names of both files, shortened."""
    first, second = (short_name(one["file"]) for one in document["inputs"])
    return f"{first}  −  {second}"


def short_name(file: str, limit: int = 40) -> str:
    """Return a file's name without its folders, its middle left out where it is long."""
    name = base_name(file)
    if len(name) > limit:
        name = name[: limit // 2 - 1] + "…" + name[-limit // 2 :]
    return name


def _summary(document: Record) -> str:
    rows = key_figures(document)[:3]
    return "   ·   ".join(f"{title}  {value} {unit}" for title, value, unit in rows)
