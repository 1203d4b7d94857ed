"""Contours of functions on vertices."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from heatwalk._answers import Floats, Integers
from heatwalk._errors import HeatwalkError
from heatwalk.potpourri3d._elements import checked, edges_of

Contour = list[tuple[int, list[float]]]


class MeshMarchingTrianglesSolver:
    """Contours of functions that are linear on each triangle."""

    def __init__(self, V: ArrayLike, F: ArrayLike) -> None:
        vertices, self._faces = checked(V, F)
        self._count = len(vertices)
        self._ends, self._sides = edges_of(self._faces)

    def marching_triangles(self, u: ArrayLike, isoval: float = 0.0) -> list[Contour]:
        """The curves where `u`, (n,) floats, is `isoval`: lists of points `(edge, [t])`, t the share of the way along it.

        Closed curves end with their first point. A vertex at the value counts as above it.
        """
        values = np.asarray(u, dtype=np.float64).ravel()
        if len(values) != self._count:
            raise HeatwalkError(f"u has {len(values)} numbers; give one for each of {self._count} vertices", "bad-shape")
        if np.isnan(values).any():
            raise HeatwalkError(f"u is not a number at vertex {int(np.isnan(values).argmax())}", "not-finite")
        return [self._points(curve, values, isoval) for curve in _chains(self._crossed(values >= isoval))]

    def _crossed(self, is_above: np.ndarray[tuple[int, ...], np.dtype[np.bool_]]) -> Integers:
        """(k, 2) edges where each triangle with corners on both sides is crossed."""
        start = is_above[self._faces]
        is_crossed = start != np.roll(start, -1, axis=1)
        crossed: Integers = self._sides[is_crossed].reshape(-1, 2)
        return crossed

    def _points(self, edges: list[int], values: Floats, isoval: float) -> Contour:
        ends = values[self._ends[edges]]
        shares = (isoval - ends[:, 0]) / (ends[:, 1] - ends[:, 0])
        return [(edge, [float(share)]) for edge, share in zip(edges, shares)]


def _chains(pairs: Integers) -> list[list[int]]:
    """Edges in the order in which triangles join them; open chains first from their ends."""
    beside: dict[int, list[int]] = {}
    for segment, (one, other) in enumerate(pairs.tolist()):
        beside.setdefault(one, []).append(segment)
        beside.setdefault(other, []).append(segment)
    is_walked = np.zeros(len(pairs), dtype=bool)

    def unwalked(segments: list[int]) -> int | None:
        return next((segment for segment in segments if not is_walked[segment]), None)

    chains: list[list[int]] = []
    ends = [edge for edge, segments in beside.items() if len(segments) != 2]
    for start in [*ends, *beside]:
        while unwalked(beside[start]) is not None:
            chain = [start]
            onward = unwalked(beside[start])
            while onward is not None:
                is_walked[onward] = True
                one, other = pairs[onward].tolist()
                chain.append(other if one == chain[-1] else one)
                segments = beside[chain[-1]]
                # At an edge of three triangles or more, curves end.
                onward = unwalked(segments) if len(segments) == 2 else None
            chains.append(chain)
    return chains


def marching_triangles(V: ArrayLike, F: ArrayLike, u: ArrayLike, isoval: float = 0.0) -> list[Contour]:
    """As `MeshMarchingTrianglesSolver(V, F).marching_triangles(u, isoval)`."""
    return MeshMarchingTrianglesSolver(V, F).marching_triangles(u, isoval)
