"""What one surface is, ahead of any comparison: size, extents, and whether z = F(x, y)."""

from dataclasses import dataclass

import numpy as np

from surfcmp_core.surface import Surface
from surfcmp_core.surface.used import used_part


@dataclass(frozen=True, slots=True)
class Facts:
    """What `surfcmp info` tells of a surface without triangulating it."""

    name: str
    kind: str
    """``"mesh"`` or ``"cloud"``."""
    nodes: int
    """All of the file, those that `dropped` counts too."""
    triangles: int
    low: tuple[float, float, float]
    """Least x, y, z of the surface, in `unit`."""
    high: tuple[float, float, float]
    """Greatest x, y, z of the surface, in `unit`."""
    unit: str | None
    space: str | None
    """Its axes, RAS or LPS, where the file says so."""
    sha256: str
    dropped: dict[str, int]
    changed: dict[str, int]
    repeated: int
    """Nodes equal in x, y and z to an earlier one."""
    contradicting: int
    """Nodes that share x and y with one of another z."""
    folded: float
    """Share of the mesh's projected area that is turned against the rest; 0 for a cloud."""

    @property
    def one_valued(self) -> bool:
        """Whether z = F(x, y) holds at all nodes, and no triangle is turned over."""
        return self.contradicting == 0 and self.folded == 0


def facts_of(surface: Surface) -> Facts:
    """Look at one surface along z.

    Parameters
    ----------
    surface : Surface

    Returns
    -------
    Facts
    """
    nodes = len(surface.points)
    surface = used_part(surface)
    points = surface.points
    repeated, contradicting = _duplicates(surface)
    low, high = points.min(axis=0), points.max(axis=0)
    return Facts(
        name=surface.name,
        kind=surface.kind,
        nodes=nodes,
        triangles=0 if surface.faces is None else len(surface.faces),
        low=(float(low[0]), float(low[1]), float(low[2])),
        high=(float(high[0]), float(high[1]), float(high[2])),
        unit=surface.unit,
        space=surface.space,
        sha256=surface.sha256,
        dropped=dict(surface.dropped),
        changed=dict(surface.changed),
        repeated=repeated,
        contradicting=contradicting,
        folded=folded_share(surface),
    )


def _duplicates(surface: Surface) -> tuple[int, int]:
    x, y, z = np.ascontiguousarray(surface.points.T)
    order = np.lexsort((z, y, x))
    x, y, z = x[order], y[order], z[order]
    same_place = (x[1:] == x[:-1]) & (y[1:] == y[:-1])
    same = same_place & (z[1:] == z[:-1])
    place = np.concatenate(([0], np.cumsum(~same_place)))
    torn = np.zeros(place[-1] + 1, np.bool_)
    torn[place[1:][same_place & ~same]] = True
    return int(same.sum()), int(torn[place].sum())


def folded_share(surface: Surface) -> float:
    """Give the share of a mesh's projected area that is turned against the rest.

    Parameters
    ----------
    surface : Surface

    Returns
    -------
    float
        0 for a cloud and for a mesh that is one-valued along z.
    """
    if surface.faces is None:
        return 0.0
    xy = surface.points[:, :2]
    xy = (xy - xy.min(axis=0)) / max(float(np.ptp(xy)), np.finfo(np.float64).tiny)
    a, b, c = (xy[corners] for corners in surface.faces.T)
    twice = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    up, down = float(twice[twice > 0].sum()), -float(twice[twice < 0].sum())
    return min(up, down) / (up + down) if up + down else 0.0
