"""Points without triangles."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike, fspath

import numpy as np
from numpy.typing import ArrayLike

from heatwalk._answers import Floats
from heatwalk._errors import HeatwalkError
from heatwalk._heatwalk import PointCloud, read
from heatwalk.potpourri3d._distance import HeatDistanceSolver, require_level_set
from heatwalk.potpourri3d._elements import vertices_of
from heatwalk.potpourri3d._vectors import VectorHeatSolver


class PointCloudHeatSolver(HeatDistanceSolver, VectorHeatSolver):
    """Distance and what is carried over the surface of points, (n, 3) floats, which are joined by triangles.

    `t_coef`: heat of distances flows for so many squares of the mean edge; 1 chooses. Log maps and signed distance are exact.
    """

    def __init__(self, P: ArrayLike, t_coef: float = 1.0) -> None:
        cloud = PointCloud(P, bridges="off")
        HeatDistanceSolver.__init__(self, cloud, t_coef)
        VectorHeatSolver.__init__(self, cloud)

    def compute_signed_distance(
        self,
        curves: Sequence[Sequence[int]],
        cloud_normals: ArrayLike,
        preserve_source_normals: bool = False,
        level_set_constraint: str = "ZeroSet",
        soft_level_set_weight: float = -1,
    ) -> Floats:
        """(n,) floats, positive on the left of curves as seen from where `cloud_normals`, (n, 3) floats, point to.

        `curves`: points each, from one to the next of which a curve takes the shortest path.
        """
        require_level_set(level_set_constraint, soft_level_set_weight)
        cloud = PointCloud(self._mesh.vertices, cloud_normals, bridges="off")
        # What is on the left of a curve is on the right of the reversed one.
        return cloud.signed_distance([vertices_of(curve)[::-1] for curve in curves])


def read_point_cloud(filename: str | PathLike[str]) -> Floats:
    """(n, 3) floats, the points of a file of any format that `heatwalk.read` takes."""
    return read(filename).vertices


def write_point_cloud(V: ArrayLike, filename: str | PathLike[str]) -> None:
    """Writes (n, 3) floats as a PLY file."""
    points = np.asarray(V, dtype=np.float64)
    if points.ndim != 2 or points.shape[1] != 3:
        raise HeatwalkError(f"V has the shape {points.shape}; give floats of the shape (n, 3)", "bad-shape")
    if not fspath(filename).lower().endswith(".ply"):
        raise HeatwalkError(f"{fspath(filename)}: points are written as PLY files; end the name with .ply", "unknown-format")
    coordinates = "".join(f"property double {axis}\n" for axis in "xyz")
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n{coordinates}end_header\n"
    with open(filename, "wb") as file:
        file.write(header.encode("ascii") + points.astype("<f8").tobytes())
