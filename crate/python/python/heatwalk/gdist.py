"""Exact distances as gdist (tvb-gdist) has them: `import heatwalk.gdist as gdist`. Matrices are those of scipy.

What differs: with `max_distance` and without targets, what is farther is infinitely far and what is nearer exact, where gdist gives
some of the former and 1e100 for the rest; integers may be of any size; errors are ValueErrors with a sentence.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from heatwalk._answers import Floats, Integers
from heatwalk._errors import HeatwalkError
from heatwalk._heatwalk import Mesh

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix

__all__ = ["compute_gdist", "distance_matrix_of_selected_points", "local_gdist_matrix"]

# What stands for no limit.
UNLIMITED = 1e100
# Distances that are the limit up to rounding are within it.
ROUNDING = 1e-12
# Numbers of a block of rows, some megabytes.
BLOCK = 1 << 20


def compute_gdist(
    vertices: ArrayLike,
    triangles: ArrayLike,
    source_indices: ArrayLike | None = None,
    target_indices: ArrayLike | None = None,
    max_distance: float = UNLIMITED,
    is_one_indexed: bool = False,
) -> Floats:
    """The distance of each target from the nearest source; without sources vertex 0 is one, without targets all vertices are.

    `max_distance` limits what is searched where no targets are given.
    """
    mesh = _mesh(vertices, triangles, is_one_indexed)
    sources = np.zeros(1, dtype=np.int64) if source_indices is None else _indices(source_indices, "source_indices")
    if target_indices is None:
        return _within(mesh, sources, max_distance)
    targets = _indices(target_indices, "target_indices")
    count = len(mesh.vertices)
    if targets.size and targets.max() >= count:
        sentence = f"vertex {targets.max()} of target_indices does not exist; there are {count}, counted from 0"
        raise HeatwalkError(sentence, "no-such-vertex")
    return _within(mesh, sources, UNLIMITED)[targets]


def local_gdist_matrix(
    vertices: ArrayLike, triangles: ArrayLike, max_distance: float = UNLIMITED, is_one_indexed: bool = False
) -> csc_matrix:
    """(n, n) floats, the distances between all vertices that are not farther apart than `max_distance`; without the diagonal."""
    mesh = _mesh(vertices, triangles, is_one_indexed)
    every = np.arange(len(mesh.vertices))
    return _matrix(mesh, every, every, max_distance)


def distance_matrix_of_selected_points(
    vertices: ArrayLike,
    triangles: ArrayLike,
    points: ArrayLike,
    max_distance: float = UNLIMITED,
    is_one_indexed: bool = False,
) -> csc_matrix:
    """(n, n) floats, the distances between some vertices that are not farther apart than `max_distance`; nothing elsewhere."""
    mesh = _mesh(vertices, triangles, is_one_indexed)
    selected = np.unique(_indices(points, "points"))
    return _matrix(mesh, selected, selected, max_distance)


def _mesh(vertices: ArrayLike, triangles: ArrayLike, is_one_indexed: bool) -> Mesh:
    faces = np.asarray(triangles)
    return Mesh(vertices, faces - 1 if is_one_indexed else faces, weld="exact", bridges="off")


def _indices(given: ArrayLike, name: str) -> Integers:
    indices = np.atleast_1d(np.asarray(given))
    if indices.ndim != 1 or (indices.size and indices.dtype.kind not in "iu"):
        raise HeatwalkError(f"{name} has the dtype {indices.dtype} and the shape {indices.shape}; give a list of integers", "bad-dtype")
    if indices.size and indices.min() < 0:
        raise HeatwalkError(f"{name} holds {indices.min()}; vertices count from 0", "negative-index")
    return indices.astype(np.int64)


def _within(mesh: Mesh, sources: Integers, max_distance: float) -> Floats:
    if max_distance >= UNLIMITED:
        return mesh.distance(sources, "exact")
    distances = mesh.distance(sources, "exact", max_distance=max_distance * (1 + ROUNDING))
    return np.where(np.isfinite(distances), np.minimum(distances, max_distance), np.inf)


def _matrix(mesh: Mesh, sources: Integers, targets: Integers, max_distance: float) -> csc_matrix:
    from scipy.sparse import csc_matrix

    count = len(mesh.vertices)
    limit = np.inf if max_distance >= UNLIMITED else max_distance
    blocks: list[tuple[Integers, Integers, Floats]] = []
    step = max(1, BLOCK // max(1, len(targets)))
    for first in range(0, len(sources), step):
        own = sources[first : first + step]
        distances = mesh.matrix(own, targets, "exact", max_distance=limit * (1 + ROUNDING))
        # Distances are the same both ways: rows of sources are columns.
        column, row = np.nonzero(np.isfinite(distances) & (distances > 0))
        blocks.append((targets[row], own[column], np.minimum(distances[column, row], limit)))
    rows, columns, values = (np.concatenate([block[k] for block in blocks] or [np.zeros(0)]) for k in range(3))
    return csc_matrix((values, (rows, columns)), shape=(count, count))
