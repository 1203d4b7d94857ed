"""What potpourri3d has and Heatwalk has not."""

from __future__ import annotations

from typing import Any, NoReturn

TRIANGLES = "cut polygons into triangles and use MeshHeatMethodDistanceSolver"


def _missing(name: str, instead: str) -> NoReturn:
    raise NotImplementedError(f"{name} is not in Heatwalk; {instead}")


class PolygonMeshHeatSolver:
    """Polygons."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        _missing("PolygonMeshHeatSolver", TRIANGLES)


class PointCloudLocalTriangulation:
    """Points without triangles."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        _missing("PointCloudLocalTriangulation", "use heatwalk.PointCloud(P).faces, the triangles that join the points")


def read_polygon_mesh(filename: Any) -> NoReturn:
    """Polygons."""
    _missing("read_polygon_mesh", "read_mesh cuts polygons into triangles")
