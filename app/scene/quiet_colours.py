"""Colours that carry no quantity: backgrounds, the two surfaces, edges, no data."""

from dataclasses import dataclass

from surfcmp_core.colours.maps import NOT_COMPARED, Rgb


@dataclass(frozen=True, slots=True)
class Palette:
    """One set of quiet colours, for a dark or a light window."""

    background: Rgb
    surface_1: Rgb
    surface_2: Rgb
    shared: Rgb
    """Triangles whose nodes are all shared."""
    node_1: Rgb
    node_2: Rgb
    edge: Rgb
    no_data: Rgb
    ring: Rgb
    """Chains round one node."""
    accent: Rgb
    """The picked triangle and the chosen chain."""


LIGHT = Palette(
    background=(247, 248, 250),
    surface_1=(176, 196, 214),
    surface_2=(222, 206, 178),
    shared=(206, 206, 206),
    node_1=(28, 78, 130),
    node_2=(150, 84, 10),
    edge=(32, 40, 52),
    no_data=NOT_COMPARED,
    ring=(240, 232, 226),
    accent=(0, 122, 204),
)
DARK = Palette(
    background=(24, 26, 31),
    surface_1=(126, 150, 174),
    surface_2=(180, 160, 126),
    shared=(130, 130, 130),
    node_1=(140, 200, 255),
    node_2=(255, 196, 110),
    edge=(8, 10, 14),
    no_data=(84, 89, 98),
    ring=(72, 66, 66),
    accent=(92, 188, 255),
)


def palette(dark: bool) -> Palette:
    """Return the colours for a dark or a light window."""
    return DARK if dark else LIGHT
