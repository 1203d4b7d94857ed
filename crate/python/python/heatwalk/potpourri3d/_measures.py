"""Areas, edges and weights of triangles."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from heatwalk._answers import Floats, Integers
from heatwalk.potpourri3d._elements import checked, edges_of

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix


def face_areas(V: ArrayLike, F: ArrayLike) -> Floats:
    """(m,) floats, the area of each face."""
    vertices, faces = checked(V, F)
    return _doubled_areas(vertices, faces) / 2


def vertex_areas(V: ArrayLike, F: ArrayLike) -> Floats:
    """(n,) floats, a third of the faces around each vertex."""
    vertices, faces = checked(V, F)
    thirds = np.repeat(_doubled_areas(vertices, faces) / 6, 3)
    areas: Floats = np.bincount(faces.ravel(), thirds, minlength=len(vertices)).astype(np.float64)
    return areas


def edges(V: ArrayLike, F: ArrayLike) -> Integers:
    """(e, 2) integers, the ends of each edge, in the order in which faces first go along them."""
    return edges_of(checked(V, F)[1])[0]


def cotan_laplacian(V: ArrayLike, F: ArrayLike, denom_eps: float = 0.0) -> csr_matrix:
    """(n, n) floats, the cotan Laplacian, positive semidefinite.

    Half the cotangents of the angles that face an edge are its weight; `denom_eps` is added to their denominators, twice the areas.
    """
    from scipy.sparse import csr_matrix

    vertices, faces = checked(V, F)
    denominators = _doubled_areas(vertices, faces) + denom_eps
    corners = vertices[faces]
    ends, weights = [], []
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        dots = np.einsum("ij,ij->i", corners[:, i] - corners[:, k], corners[:, j] - corners[:, k])
        with np.errstate(divide="ignore", invalid="ignore"):
            weights.append(dots / denominators / 2)
        ends.append(faces[:, [i, j]])
    (start, end), weight = np.concatenate(ends).T, np.concatenate(weights)
    rows = np.concatenate([start, end, start, end])
    columns = np.concatenate([end, start, start, end])
    values = np.concatenate([-weight, -weight, weight, weight])
    return csr_matrix((values, (rows, columns)), shape=(len(vertices), len(vertices)))


def _doubled_areas(vertices: Floats, faces: Integers) -> Floats:
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    doubled: Floats = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return doubled
