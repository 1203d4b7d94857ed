"""Meshes and their elements, counted as potpourri3d does."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from heatwalk._answers import Floats, Integers, Place
from heatwalk._errors import HeatwalkError
from heatwalk._heatwalk import Mesh

# An element and weights: of a vertex none, of an edge the share of the way along it, of a face those of two or three corners.
Point = tuple[Any, ...]


def checked(V: ArrayLike, F: ArrayLike) -> tuple[Floats, Integers]:
    """Both as arrays, of triangles whose vertices are there."""
    vertices, faces = np.asarray(V), np.asarray(F)
    if vertices.ndim != 2 or vertices.shape[1] != 3:
        raise HeatwalkError(f"V has the shape {vertices.shape}; give floats of the shape (n, 3)", "bad-shape")
    if faces.ndim != 2 or faces.shape[1] != 3:
        raise HeatwalkError(f"F has the shape {faces.shape}; give integer triangles of the shape (m, 3)", "bad-shape")
    if faces.dtype.kind not in "iu":
        raise HeatwalkError(f"F has the dtype {faces.dtype}; give integers", "bad-dtype")
    if faces.size and (faces.min() < 0 or faces.max() >= len(vertices)):
        raise HeatwalkError(f"F refers to vertices that are not there; V has {len(vertices)}", "index-out-of-range")
    return vertices.astype(np.float64), faces.astype(np.int64)


def mesh_of(V: ArrayLike, F: ArrayLike) -> Mesh:
    """A mesh whose components stay apart, as they do for potpourri3d."""
    return Mesh(V, F, weld="exact", bridges="off")


def edges_of(F: Integers) -> tuple[Integers, Integers]:
    """(e, 2) edges in the order and direction in which faces first go along them; (m, 3) the edge from each corner to the next."""
    ends = np.stack([F, np.roll(F, -1, axis=1)], axis=2).reshape(-1, 2)
    _, first, number = np.unique(np.sort(ends, axis=1), axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return ends[first[order]], rank[number.ravel()].reshape(-1, 3)


class Elements:
    """The places of points that are given by elements."""

    def __init__(self, mesh: Mesh) -> None:
        self.faces = mesh.faces
        self.vertex_count = len(mesh.vertices)
        self._edges: tuple[Integers, Integers] | None = None

    def edges(self) -> tuple[Integers, Integers]:
        """As `edges_of`."""
        if self._edges is None:
            self._edges = edges_of(self.faces)
        return self._edges

    def place(self, point: Point) -> int | Place:
        """Of `(vertex, [])`, `(edge, [t])` or `(face, [a, b])`, with or without the third weight."""
        element = int(point[0])
        weights = [float(weight) for weight in point[1]] if len(point) > 1 else []
        if not weights:
            return element
        if len(weights) == 1:
            return self._on_edge(element, weights[0])
        if len(weights) == 2:
            weights.append(1.0 - weights[0] - weights[1])
        if len(weights) != 3:
            raise HeatwalkError(f"a point has {len(weights)} weights; give none, one, two or three", "bad-place")
        return Place(element, (weights[0], weights[1], weights[2]))

    def _on_edge(self, edge: int, t: float) -> Place:
        ends, of_faces = self.edges()
        if not 0 <= edge < len(ends):
            raise HeatwalkError(f"edge {edge} does not exist; there are {len(ends)}, counted from 0", "no-such-edge")
        face, side = (int(k) for k in np.argwhere(of_faces == edge)[0])
        weights = [0.0, 0.0, 0.0]
        is_along = self.faces[face, side] == ends[edge, 0]
        weights[side], weights[(side + 1) % 3] = (1.0 - t, t) if is_along else (t, 1.0 - t)
        return Place(face, (weights[0], weights[1], weights[2]))

    def faces_at(self, place: int | Place) -> set[int]:
        """The faces that a place is on."""
        if isinstance(place, Place):
            if not 0 <= place.face < len(self.faces):
                return set()
            corners = self.faces[place.face][np.array(place.weights) > 0]
        else:
            corners = np.array([place])
        around = np.isin(self.faces, corners).sum(axis=1) == len(corners)
        return set(np.flatnonzero(around).tolist())

    def courses(self, curve: Iterable[Point]) -> list[list[int | Place]]:
        """A curve as the pieces whose points are each in a face with the one before."""
        pieces: list[list[int | Place]] = []
        before: set[int] = set()
        for point in curve:
            place = self.place(point)
            faces = self.faces_at(place)
            if pieces and before & faces:
                pieces[-1].append(place)
            else:
                pieces.append([place])
            before = faces
        return pieces


def vertices_of(v_inds: ArrayLike | Sequence[int]) -> NDArray[Any]:
    """Vertices in a list of numbers."""
    vertices = np.atleast_1d(np.asarray(v_inds))
    if vertices.dtype.kind not in "iu" and vertices.size:
        raise HeatwalkError(f"vertices have the dtype {vertices.dtype}; give integers", "bad-dtype")
    return vertices.ravel().astype(np.int64)
