"""Small meshes that are made in code."""

from __future__ import annotations

from itertools import permutations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


def grid(columns: int, rows: int | None = None, size: float = 1.0) -> tuple[Floats, Integers]:
    """A flat rectangle of squares in two triangles each, `size` by `size`; normals along z."""
    rows = columns if rows is None else rows
    x, y = np.meshgrid(np.linspace(0, size, columns + 1), np.linspace(0, size, rows + 1))
    vertices = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    corner = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    lower = np.column_stack([corner, corner + 1, corner + columns + 2])
    upper = np.column_stack([corner, corner + columns + 2, corner + columns + 1])
    return vertices, np.concatenate([lower, upper])


def cube() -> tuple[Floats, Integers]:
    """The unit cube, 8 vertices, oriented outward. Vertex 4x + 2y + z is at (x, y, z)."""
    vertices = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
    squares = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = [triangle for a, b, c, d in squares for triangle in ((a, b, c), (a, c, d))]
    return vertices, np.array(faces)


def sphere(rings: int = 24, sectors: int = 48) -> tuple[Floats, Integers]:
    """A unit sphere of latitude and longitude with its poles at vertices 0 and last, oriented outward."""
    polar = np.linspace(0, np.pi, rings + 1)[1:-1]
    around = np.arange(sectors) * (2 * np.pi / sectors)
    p, a = np.meshgrid(polar, around, indexing="ij")
    ring = np.column_stack([(np.sin(p) * np.cos(a)).ravel(), (np.sin(p) * np.sin(a)).ravel(), np.cos(p).ravel()])
    vertices = np.concatenate([[[0, 0, 1]], ring, [[0, 0, -1]]])
    last = len(vertices) - 1
    at = lambda r, s: 1 + r * sectors + s % sectors
    faces = [(0, at(0, s), at(0, s + 1)) for s in range(sectors)]
    for r in range(rings - 2):
        for s in range(sectors):
            faces += [(at(r, s), at(r + 1, s), at(r + 1, s + 1)), (at(r, s), at(r + 1, s + 1), at(r, s + 1))]
    faces += [(at(rings - 2, s), last, at(rings - 2, s + 1)) for s in range(sectors)]
    return vertices, np.array(faces)


def block(size: int) -> tuple[Floats, Integers]:
    """The unit cube in `size`³ cubes of six tetrahedra each (Kuhn); vertices by x, then y, then z."""
    ticks = np.linspace(0, 1, size + 1)
    vertices = np.stack(np.meshgrid(ticks, ticks, ticks, indexing="ij"), axis=-1).reshape(-1, 3)
    steps = np.array([(size + 1) ** 2, size + 1, 1])
    x, y, z = np.meshgrid(*[np.arange(size)] * 3, indexing="ij")
    corner = (x * steps[0] + y * steps[1] + z * steps[2]).ravel()
    ways = [np.cumsum([0, *steps[list(order)]]) for order in permutations(range(3))]
    return vertices, np.concatenate([corner[:, None] + way for way in ways])
