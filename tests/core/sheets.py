"""Sheets over a square lattice, as meshes."""

import numpy as np

from surfcmp_core.surface import Surface


def sheet(height, n=30, wide=1.0) -> Surface:
    x, y = np.meshgrid(np.linspace(-wide, wide, n), np.linspace(-1.0, 1.0, n))
    number = np.arange(n * n, dtype=np.int32).reshape(n, n)
    a, b, c, d = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    faces = np.concatenate([np.stack(t, -1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])
    return Surface(np.column_stack((x.ravel(), y.ravel(), height(x, y).ravel())), faces)
