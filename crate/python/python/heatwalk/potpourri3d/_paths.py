"""Paths and walks."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from heatwalk._answers import Floats
from heatwalk._errors import HeatwalkError
from heatwalk.potpourri3d._elements import mesh_of, vertices_of


class EdgeFlipGeodesicSolver:
    """Geodesic paths. They are found whole, so that `max_iterations` and `max_relative_length_decrease` have no effect."""

    def __init__(self, V: ArrayLike, F: ArrayLike, t_coef: float = 1.0) -> None:
        self._mesh = mesh_of(V, F)

    def find_geodesic_path(
        self,
        v_start: int,
        v_end: int,
        max_iterations: int | None = None,
        max_relative_length_decrease: float | None = None,
    ) -> Floats:
        """(k, 3) floats, the points of a shortest path."""
        start, end = vertices_of([v_start, v_end])
        return self._mesh.path(start, end, kind="exact").points

    def find_geodesic_path_poly(
        self,
        v_list: ArrayLike,
        max_iterations: int | None = None,
        max_relative_length_decrease: float | None = None,
    ) -> Floats:
        """(k, 3) floats, the points of a locally shortest path from the first vertex to the last, beside one through the others."""
        return self._mesh.path_through(vertices_of(v_list)).points

    def find_geodesic_loop(
        self,
        v_list: ArrayLike,
        max_iterations: int | None = None,
        max_relative_length_decrease: float | None = None,
    ) -> Floats:
        """(k, 3) floats, the points of a closed geodesic, the last of which is the first: what the loop through the vertices tightens to.
        HeatwalkError where that is a point."""
        return self._mesh.closed_geodesic(vertices_of(v_list)).points


class GeodesicTracer:
    """Walks straight on, as far as the part of a vector that is along the surface is long."""

    def __init__(self, V: ArrayLike, F: ArrayLike, t_coef: float = 1.0) -> None:
        self._mesh = mesh_of(V, F)
        self._vertices, self._faces = self._mesh.vertices, self._mesh.faces

    def trace_geodesic_from_vertex(
        self, start_vert: int, direction_xyz: ArrayLike, max_iterations: int | None = None
    ) -> Floats:
        """(k, 3) floats, the points of a walk from a vertex; `max_iterations` has no effect."""
        (start,) = vertices_of([start_vert])
        if not 0 <= start < len(self._vertices):
            sentence = f"vertex {start} does not exist; there are {len(self._vertices)}, counted from 0"
            raise HeatwalkError(sentence, "no-such-vertex")
        face, corner = np.nonzero(self._faces == start)
        a, b, c = (self._vertices[self._faces[face, (corner + k) % 3]] for k in range(3))
        normals = np.cross(b - a, c - a)
        areas = np.linalg.norm(normals, axis=1, keepdims=True)
        angles = np.arctan2(areas, ((b - a) * (c - a)).sum(axis=1, keepdims=True))
        with np.errstate(invalid="ignore", divide="ignore"):
            unit = np.where(areas > 0, normals / areas, 0.0)
        return self._walk(int(start), direction_xyz, (unit * angles).sum(axis=0))

    def trace_geodesic_from_face(
        self,
        start_face: int,
        bary_coords: ArrayLike,
        direction_xyz: ArrayLike,
        max_iterations: int | None = None,
    ) -> Floats:
        """(k, 3) floats, the points of a walk from a place in a face; `max_iterations` has no effect."""
        weights = np.asarray(bary_coords, dtype=np.float64).ravel()
        (face,) = vertices_of([start_face])
        if not 0 <= face < len(self._faces):
            sentence = f"face {face} does not exist; there are {len(self._faces)}, counted from 0"
            raise HeatwalkError(sentence, "no-such-triangle")
        a, b, c = self._vertices[self._faces[face]]
        return self._walk((int(face), weights), direction_xyz, np.cross(b - a, c - a))

    def _walk(self, start: int | tuple[int, Floats], direction_xyz: ArrayLike, normal: Floats) -> Floats:
        direction = np.asarray(direction_xyz, dtype=np.float64).ravel()
        squared = normal @ normal
        along = direction - normal * (direction @ normal / squared) if squared > 0 and len(direction) == 3 else direction
        return self._mesh.walk(start, direction, float(np.linalg.norm(along))).points
