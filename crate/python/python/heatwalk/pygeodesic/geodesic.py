"""Exact distances and paths, as `pygeodesic.geodesic` has them.

What differs: errors are raised, as ValueErrors with a sentence, where pygeodesic prints them and returns None; what nothing reaches is
infinitely far, without a path, and of no source (-1); vertices that no face uses may be there.
"""

from __future__ import annotations

from os import PathLike

import numpy as np
from numpy.typing import ArrayLike, NDArray

from heatwalk._answers import Floats, Integers
from heatwalk._errors import HeatwalkError
from heatwalk._heatwalk import Mesh

__all__ = ["PyGeodesicAlgorithmExact", "read_mesh_from_file"]


class PyGeodesicAlgorithmExact:
    """Exact distances on a mesh: `_points` (n, 3) numbers, `_faces` (m, 3) integers."""

    def __init__(self, _points: ArrayLike, _faces: ArrayLike) -> None:
        faces = np.asarray(_faces)
        if faces.dtype.kind == "f" and (faces == np.floor(faces)).all():
            faces = faces.astype(np.int64)
        self._mesh = Mesh(np.asarray(_points, dtype=np.float64), faces, weld="exact", bridges="off")
        self._count = len(np.asarray(_points))

    def geodesicDistance(self, sourceIndex: int, targetIndex: int) -> tuple[float, Floats]:
        """The distance between two vertices, and (k, 3) floats, the points of a shortest path from the target to the source."""
        source, target = self._vertices([sourceIndex, targetIndex], "index")
        try:
            path = self._mesh.path(target, source, kind="exact")
        except HeatwalkError as error:
            if error.code != "unreachable":
                raise
            return float("inf"), np.zeros((0, 3))
        return path.length, path.points

    def geodesicDistances(
        self,
        source_indices: ArrayLike | None = None,
        target_indices: ArrayLike | None = None,
        max_distance: float = np.inf,
    ) -> tuple[Floats, NDArray[np.int32]]:
        """The distance of each target from the nearest source, and the number of that source among these.

        Without sources, vertex 0 is one; without targets, all vertices are. Targets farther than `max_distance` are infinitely far.
        """
        sources = self._vertices([0] if source_indices is None else source_indices, "source_indices")
        cells = self._mesh.cells(sources)
        distances, nearest = cells.distances.copy(), cells.nearest.astype(np.int32)
        is_far = distances > max_distance
        distances[is_far], nearest[is_far] = np.inf, -1
        if target_indices is None:
            return distances, nearest
        targets = self._vertices(target_indices, "target_indices")
        return distances[targets], nearest[targets]

    def _vertices(self, given: ArrayLike, name: str) -> Integers:
        vertices = np.asarray(given)
        if vertices.ndim != 1 or (vertices.size and vertices.dtype.kind not in "iu"):
            raise HeatwalkError(f"{name} is no list of integers", "bad-shape")
        outside = vertices[(vertices < 0) | (vertices >= self._count)]
        if outside.size:
            sentence = f"vertex {outside[0]} of {name} does not exist; there are {self._count}, counted from 0"
            raise HeatwalkError(sentence, "no-such-vertex")
        return vertices.astype(np.int64)


def read_mesh_from_file(filename: str | PathLike[str]) -> tuple[Floats, Integers]:
    """Points and faces of a text file: how many there are of both, then a row each."""
    with open(filename, encoding="ascii") as file:
        rows = [row.split() for row in file if row.strip()]
    try:
        points, faces = (int(count) for count in rows[0])
        vertices = np.array(rows[1 : 1 + points], dtype=np.float64).reshape(points, 3)
        triangles = np.array(rows[1 + points : 1 + points + faces], dtype=np.int64).reshape(faces, 3)
    except (ValueError, IndexError) as error:
        raise HeatwalkError(f"{filename}: {error}; write two counts, then rows of three numbers", "malformed") from error
    return vertices, triangles
