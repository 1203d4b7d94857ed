"""What potpourri3d has and Heatwalk has not."""

from __future__ import annotations

from typing import Any, NoReturn

TRIANGLES = "cut polygons into triangles and use MeshHeatMethodDistanceSolver"
SURFACE = "make a triangle mesh of the points and use MeshHeatMethodDistanceSolver"


def _missing(name: str, instead: str) -> NoReturn:
    raise NotImplementedError(f"{name} is not in Heatwalk; {instead}")


class PolygonMeshHeatSolver:
    """Polygons."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        _missing("PolygonMeshHeatSolver", TRIANGLES)


class PointCloudHeatSolver:
    """Points without triangles."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        _missing("PointCloudHeatSolver", SURFACE)


class PointCloudLocalTriangulation:
    """Points without triangles."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        _missing("PointCloudLocalTriangulation", SURFACE)


def read_polygon_mesh(filename: Any) -> NoReturn:
    """Polygons."""
    _missing("read_polygon_mesh", "read_mesh cuts polygons into triangles")


def read_point_cloud(filename: Any) -> NoReturn:
    """Points without triangles."""
    _missing("read_point_cloud", "read_mesh reads files with triangles")


def write_point_cloud(V: Any, filename: Any) -> NoReturn:
    """Points without triangles."""
    _missing("write_point_cloud", "write_mesh writes triangles")
