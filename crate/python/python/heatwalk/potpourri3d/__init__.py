"""The names, arguments and defaults of potpourri3d 1.4, answered by Heatwalk: `import heatwalk.potpourri3d as pp3d`.

What differs: vertices that nothing reaches are infinitely far; distances from curves and log maps are exact; the paths that `find_geodesic_path`
gives are the shortest; with the default `t_coef` heat flows for a time that is chosen for the mesh, which is more accurate. Errors
are ValueErrors with a sentence. Points are joined by triangles (`heatwalk.PointCloud`). Polygons and local triangulations raise
NotImplementedError.
"""

from heatwalk.potpourri3d._clouds import PointCloudHeatSolver, read_point_cloud, write_point_cloud
from heatwalk.potpourri3d._contours import MeshMarchingTrianglesSolver, marching_triangles
from heatwalk.potpourri3d._distance import (
    MeshFastMarchingDistanceSolver,
    MeshHeatMethodDistanceSolver,
    MeshSignedHeatSolver,
    compute_distance,
    compute_distance_multisource,
)
from heatwalk.potpourri3d._files import read_mesh, write_mesh
from heatwalk.potpourri3d._measures import cotan_laplacian, edges, face_areas, vertex_areas
from heatwalk.potpourri3d._missing import PointCloudLocalTriangulation, PolygonMeshHeatSolver, read_polygon_mesh
from heatwalk.potpourri3d._paths import EdgeFlipGeodesicSolver, GeodesicTracer
from heatwalk.potpourri3d._vectors import MeshVectorHeatSolver

__all__ = [
    "EdgeFlipGeodesicSolver",
    "GeodesicTracer",
    "MeshFastMarchingDistanceSolver",
    "MeshHeatMethodDistanceSolver",
    "MeshMarchingTrianglesSolver",
    "MeshSignedHeatSolver",
    "MeshVectorHeatSolver",
    "PointCloudHeatSolver",
    "PointCloudLocalTriangulation",
    "PolygonMeshHeatSolver",
    "compute_distance",
    "compute_distance_multisource",
    "cotan_laplacian",
    "edges",
    "face_areas",
    "marching_triangles",
    "read_mesh",
    "read_point_cloud",
    "read_polygon_mesh",
    "vertex_areas",
    "write_mesh",
    "write_point_cloud",
]
