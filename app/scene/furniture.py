"""Titles, legends and the colour bar: what explains the views."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from app.model.view_state import ChainsBy, Heatmap, ViewState
from app.scene.chain_colours import FEW, FEW_OPEN, OPEN, by_length, oklch
from app.scene.content import Content
from app.scene.quiet_colours import palette
from app.scene.scene import TRUST_COLOURS, height_range
from app.scene.ticks import ticks
from app.scene.values import Trust
from surfcmp_core.colours.maps import ABOVE, BELOW, Colours, Rgb, difference_map, height_map
from surfcmp_core.colours.scale import band_colours, band_edges

if TYPE_CHECKING:  # the window is on the screen before the core is loaded
    from surfcmp_core.comparing.comparison import Comparison


@dataclass(frozen=True, slots=True)
class Swatch:
    """One line of a legend: colours side by side and what they mean."""

    colours: tuple[Rgb, ...]
    text: str
    """As it stands in the program; views translate it."""
    count: int | None = None
    """Stands in the text in place of {}."""


@dataclass(frozen=True, slots=True, eq=False)
class ColourBar:
    """A scale: colours from low to high, where the numbers stand, and what lies beyond.

    Attributes
    ----------
    colours : (k, 3) uint8
        Equally wide pieces from the low end to the high end.
    ticks : tuple of (float, float)
        Place in [0, 1] and the value there, in the unit.
    below, above : colour or None
        Of values beyond the ends; None where nothing lies there.
    """

    colours: Colours
    ticks: tuple[tuple[float, float], ...]
    below: Rgb | None
    above: Rgb | None
    no_data: Rgb


def colour_bar(comparison: Comparison, state: ViewState) -> ColourBar | None:
    """Return the heatmap's scale, or None where its colours stand for kinds."""
    if state.heatmap is Heatmap.TRUST:
        return None
    quiet = palette(state.dark)
    scale = state.colours
    if state.heatmap.of_difference and scale.bands:
        edges, bands = band_edges(scale), band_colours(scale)
        marks = tuple(((k + 1) / len(bands), float(edge)) for k, edge in enumerate(edges))
        return ColourBar(bands, marks, None, None, quiet.no_data)
    if state.heatmap.of_difference:
        table, low, high = difference_map(scale.signed), scale.low, scale.end
        below, above = (BELOW if scale.signed else None), ABOVE
    else:
        table, (low, high), below, above = height_map(), height_range(comparison), None, None
    span = high - low or 1.0
    marks = tuple(((value - low) / span, value) for value in ticks(low, high))
    return ColourBar(table, marks, below, above, quiet.no_data)


def legend(content: Content, state: ViewState, view: int) -> tuple[Swatch, ...]:
    """Return the legend of one view."""
    quiet = palette(state.dark)
    if view == 2:
        lines = (
            (True, Swatch((quiet.surface_1,), "only nodes of 1 (clouts)")),
            (True, Swatch((quiet.surface_2,), "only nodes of 2 (clouts)")),
            (content.counts["nodes_shared"], Swatch((quiet.shared,), "only shared nodes")),
            *_of_chains(content, state),
        )
        return tuple(swatch for there, swatch in lines if there)
    if view == 3 and state.heatmap is Heatmap.TRUST:
        return (
            Swatch((TRUST_COLOURS[Trust.BOTH],), "rests on both grids"),
            Swatch((TRUST_COLOURS[Trust.ONLY_1],), "on grid 1 only"),
            Swatch((TRUST_COLOURS[Trust.ONLY_2],), "on grid 2 only"),
            Swatch((quiet.no_data,), "not compared"),
        )
    return ()


def _of_chains(content: Content, state: ViewState) -> tuple[tuple[int, Swatch], ...]:
    """Return what tells of chains in the legend, and how many each line is about."""
    count = content.chains.counts
    every = len(content.chains.closed)
    if state.chains_by is ChainsBy.LENGTH:
        return ((every, Swatch(_steps(height_map()), "chains, short to long: {}", every)),)
    if state.chains_by is ChainsBy.ORDER:
        return ((every, Swatch(_steps(height_map()), "chains, first to last found: {}", every)),)
    if state.chains_by is ChainsBy.MEAN:
        table = difference_map(signed=False)
        return ((every, Swatch(_steps(table), "chains by their mean |d|: {}", every)),)
    if every <= FEW:
        closed = count["rings"] + count["longer"]
        return (
            (closed, Swatch(_some(5.0, 95.0), "closed chains: {}", closed)),
            (count["open"], Swatch(_some(185.0, 300.0), "open chains: {}", count["open"])),
        )
    length = _steps(by_length(np.array([2, 4, 8, 16])))
    few = count["open"] <= FEW_OPEN
    strong = _some(185.0, 300.0) if few else _steps(oklch(*(np.full(1, part) for part in OPEN)))
    ring = palette(state.dark).ring
    return (
        (count["rings"], Swatch((ring,), "rings round one node: {}", count["rings"])),
        (count["longer"], Swatch(length, "longer closed chains: {}", count["longer"])),
        (count["open"], Swatch(strong, "open chains: {}", count["open"])),
    )


def _steps(table: Colours) -> tuple[Rgb, ...]:
    """Return at most four colours of a table."""
    some = table[np.linspace(0, len(table) - 1, min(4, len(table))).astype(np.intp)]
    return tuple((int(r), int(g), int(b)) for r, g, b in some)


def _some(first: float, last: float) -> tuple[Rgb, ...]:
    """Return four colours out of a family of chains."""
    hues = np.linspace(first, last, 4)
    return _steps(oklch(np.full(4, 0.68), np.full(4, 0.135), hues))
