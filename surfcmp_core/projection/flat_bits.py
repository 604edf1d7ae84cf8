"""A mesh as a few thousand small flat bits, to judge views of it quickly."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.compiled.linear_algebra import dots, lengths, turned, weighed_sum
from surfcmp_core.projection.islands import join_pieces
from surfcmp_core.surface import Surface

_WANTED = 16_000
"""Bits of a mesh: enough for a tenth of a degree, few enough for a millisecond a view."""
_DEBRIS = 0.01
"""Connected parts with less than this share of the largest one's area have no say."""


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """Flat bits of a mesh.

    Attributes
    ----------
    places : (k, 3) float64
        Centres, measured from the mesh's centre of area.
    normals : (k, 3) float64
        Unit, outward by the right-hand rule.
    areas : (k,) float64
        As shares of the whole.
    pieces : (k,) int32
        Number of the connected part of the mesh each belongs to, from 0.
    area : float
        Of the whole, in the unit of `places`: the mesh's, times some power of two.
    """

    places: NDArray[np.float64]
    normals: NDArray[np.float64]
    areas: NDArray[np.float64]
    pieces: NDArray[np.int32]
    area: float

    @property
    def openness(self) -> float:
        """Length of the parts' vector areas over their area: 0 if all are closed, 1 if flat."""
        vectors = [np.bincount(self.pieces, self.areas * n) for n in self.normals.T]
        return float(lengths(np.stack(vectors, axis=-1)).sum())

    def thinned(self, step: int) -> "Samples":
        """Give every so manieth bit, all of them for less than two, for a first look."""
        if step < 2:
            return self
        areas = self.areas[::step] / self.areas[::step].sum()
        return replace(
            self,
            places=self.places[::step],
            normals=self.normals[::step],
            areas=areas,
            pieces=np.unique(self.pieces[::step], return_inverse=True)[1].astype(np.int32),
        )

    def hull(self) -> NDArray[np.float64]:
        """Give the (f, 3) vector areas of the facets of the convex hull, as shares of the area.

        None of them for flat meshes.
        """
        from scipy.spatial import ConvexHull, QhullError

        try:
            hull = ConvexHull(self.places)
        except QhullError:
            return np.zeros((0, 3))
        corners = self.places[hull.simplices]
        vectors = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        return np.asarray(vectors / (2.0 * self.area))

    def turned(self, axes: NDArray[np.float64]) -> "Samples":
        """Give the same in other axes, the rows of a rotation."""
        return replace(
            self,
            places=turned(self.places, axes),
            normals=turned(self.normals, axes),
        )


def samples_of(surface: Surface) -> Samples | None:
    """Cut a mesh into bits: every k-th triangle of a fine mesh, parts of those of a coarse one.

    Parameters
    ----------
    surface : Surface

    Returns
    -------
    Samples or None
        None for a cloud, and for a mesh without area.
    """
    if surface.faces is None or not len(surface.faces):
        return None
    piece_of = np.empty(len(surface.points), np.int32)
    join_pieces(surface.faces, np.zeros(len(surface.faces), np.uint8), piece_of)
    faces = surface.faces[:: max(1, len(surface.faces) // _WANTED)]
    corners = surface.points[faces] - surface.points[0]
    # shares and directions are all that counts: a size whose powers are numbers
    corners = np.ldexp(corners, -int(np.frexp(np.abs(corners).max())[1]))
    vector = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    double = lengths(vector)
    real = double > 0.0
    if not real.any():
        return None
    pieces = np.unique(piece_of[faces[:, 0]], return_inverse=True)[1].astype(np.int32)
    by_piece = np.bincount(pieces, double)
    real &= by_piece[pieces] >= _DEBRIS * by_piece.max()
    corners, vector, double = corners[real], vector[real], double[real]
    pieces = np.unique(pieces[real], return_inverse=True)[1].astype(np.int32)
    centres = _centres(max(1, round(np.sqrt(_WANTED / len(double)))))
    places = dots(centres[:, None], corners.transpose(0, 2, 1)[:, None]).reshape(-1, 3)
    areas = np.repeat(double, len(centres)) / (double.sum() * len(centres))
    normals = np.repeat(vector / double[:, None], len(centres), axis=0)
    return Samples(
        places - weighed_sum(areas, places),
        normals,
        areas,
        np.repeat(pieces, len(centres)),
        float(double.sum()) / 2.0,
    )


def _centres(parts: int) -> NDArray[np.float64]:
    """Give barycentric centres of the parts² equal triangles that one is cut into."""
    rows = []
    for i in range(parts):
        for j in range(parts - i):
            rows.append((3 * i + 1, 3 * j + 1))
            if i + j < parts - 1:
                rows.append((3 * i + 2, 3 * j + 2))
    ij = np.array(rows, np.float64) / (3 * parts)
    return np.column_stack((ij, 1.0 - ij.sum(axis=1)))
