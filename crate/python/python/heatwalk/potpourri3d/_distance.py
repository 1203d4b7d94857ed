"""Distances."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from heatwalk._answers import Floats, Place
from heatwalk._errors import HeatwalkError
from heatwalk._heatwalk import Mesh
from heatwalk.potpourri3d._elements import Elements, Point, mesh_of, vertices_of

CONSTRAINTS = ("ZeroSet", "None", "Multiple")


class HeatDistanceSolver:
    """Distance by the heat method on a mesh, for so many squares of the mean edge; 1 chooses."""

    def __init__(self, mesh: Mesh, t_coef: float, operator: Literal["delaunay", "plain"] = "delaunay") -> None:
        self._mesh = mesh
        self._operator: Literal["delaunay", "plain"] = operator
        self._time_step: float | Literal["auto"] = "auto" if t_coef == 1.0 else float(t_coef)

    def compute_distance(self, v_ind: int) -> Floats:
        """(n,) floats, the distance of each vertex from one; inf where it does not reach."""
        return self.compute_distance_multisource([v_ind])

    def compute_distance_multisource(self, v_inds: ArrayLike) -> Floats:
        """(n,) floats, the distance of each vertex from the nearest of several."""
        sources = vertices_of(v_inds)
        return self._mesh.distance(sources, "heat", operator=self._operator, time_step=self._time_step)


class MeshHeatMethodDistanceSolver(HeatDistanceSolver):
    """Distance by the heat method.

    `t_coef`: heat flows for so many squares of the mean edge; 1 chooses. `use_robust`: on the intrinsic Delaunay triangulation.
    """

    def __init__(self, V: ArrayLike, F: ArrayLike, t_coef: float = 1.0, use_robust: bool = True) -> None:
        super().__init__(mesh_of(V, F), t_coef, "delaunay" if use_robust else "plain")


def compute_distance(V: ArrayLike, F: ArrayLike, v_ind: int) -> Floats:
    """As `MeshHeatMethodDistanceSolver(V, F).compute_distance(v_ind)`."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance(v_ind)


def compute_distance_multisource(V: ArrayLike, F: ArrayLike, v_inds: ArrayLike) -> Floats:
    """As `MeshHeatMethodDistanceSolver(V, F).compute_distance_multisource(v_inds)`."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance_multisource(v_inds)


class _CurveSolver:
    """Exact distance from curves and points, whose points are given by elements."""

    def __init__(self, V: ArrayLike, F: ArrayLike) -> None:
        self._mesh = mesh_of(V, F)
        self._elements = Elements(self._mesh)

    def _parted(self, curves: Sequence[Sequence[Point]]) -> tuple[list[list[int | Place]], list[int | Place]]:
        """What has a length, and single points."""
        pieces = [piece for curve in curves for piece in self._elements.courses(curve)]
        points = [piece[0] for piece in pieces if len(piece) == 1]
        return [piece for piece in pieces if len(piece) > 1], points

    def _unsigned(self, curves: list[list[int | Place]], points: list[int | Place]) -> Floats:
        distances = np.full(self._elements.vertex_count, np.inf)
        if curves:
            distances = self._mesh.curve_distance(curves)
        if points:
            distances = np.minimum(distances, self._mesh.distance(points, "exact"))
        return distances

    def _distance(
        self,
        signed: list[list[int | Place]],
        unsigned: list[list[int | Place]],
        points: list[int | Place],
    ) -> Floats:
        """Negative on the left of signed curves where these are nearest."""
        if not signed and not unsigned and not points:
            raise HeatwalkError("no source: give at least one", "no-source")
        others = self._unsigned(unsigned, points)
        if not signed:
            return others
        distances = self._mesh.signed_distance(signed)
        return np.where(np.abs(distances) <= others, distances, others)


class MeshFastMarchingDistanceSolver(_CurveSolver):
    """Distance from curves and points: exact, where potpourri3d marches."""

    def compute_distance(
        self,
        curves: Sequence[Sequence[Point]],
        distances: Sequence[Sequence[float]] = (),
        sign: bool = False,
    ) -> Floats:
        """(n,) floats; with `sign`, negative on the left of curves.

        `distances` from which the points of curves start may differ from 0 for curves of one point alone.
        """
        parts, points = self._parted(curves)
        if np.any([distance != 0 for row in distances for distance in row]):
            return self._from(curves, distances, parts, sign)
        return self._distance(parts, [], points) if sign else self._distance([], parts, points)

    def _from(
        self,
        curves: Sequence[Sequence[Point]],
        distances: Sequence[Sequence[float]],
        parts: list[list[int | Place]],
        sign: bool,
    ) -> Floats:
        if parts or sign:
            raise NotImplementedError(
                "curves start from the distance 0; give points with initial distances, each as a curve of its own, without sign"
            )
        places = [self._elements.place(point) for curve in curves for point in curve]
        initial = [distance for row in distances for distance in row]
        return self._mesh.distance(places, "exact", initial=initial)


def require_level_set(constraint: str, soft_weight: float) -> None:
    """Refuses what there is not: distance is 0 on curves, whatever the constraint."""
    if constraint not in CONSTRAINTS:
        names = ", ".join(CONSTRAINTS)
        raise HeatwalkError(f"there is no constraint '{constraint}'; choose one of {names}", "unknown-choice")
    if soft_weight > 0:
        raise NotImplementedError("distance is 0 on curves exactly; leave soft_level_set_weight at -1")


class MeshSignedHeatSolver(_CurveSolver):
    """Signed distance from curves: as large as the exact distance, with a sign that broken curves have by heat.

    Distance is 0 on curves whatever `level_set_constraint` and `preserve_source_normals` are, and `t_coef` makes no difference to it.
    """

    def __init__(self, V: ArrayLike, F: ArrayLike, t_coef: float = 1.0) -> None:
        super().__init__(V, F)

    def compute_distance(
        self,
        curves: Sequence[Sequence[Point]],
        curve_signs: Sequence[bool] = (),
        points: Sequence[int | Point] = (),
        preserve_source_normals: bool = False,
        level_set_constraint: str = "ZeroSet",
        soft_level_set_weight: float = -1,
    ) -> Floats:
        """(n,) floats, positive on the left of curves.

        `curve_signs`: whether each curve has sides; all if not given. `points`: sources without sides, vertices or points by elements.
        """
        require_level_set(level_set_constraint, soft_level_set_weight)
        signs = [*curve_signs, *[True] * (len(curves) - len(curve_signs))]
        signed, alone = self._parted([curve for curve, sign in zip(curves, signs) if sign])
        plain, others = self._parted([curve for curve, sign in zip(curves, signs) if not sign])
        places = [self._elements.place(point if isinstance(point, tuple) else (point,)) for point in points]
        # What is on the left of a curve is on the right of the reversed one.
        return self._distance([piece[::-1] for piece in signed], plain, [*alone, *others, *places])
