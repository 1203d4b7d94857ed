"""Geodesic distance, shortest paths and more on triangle meshes: exact, or by heat.

>>> import heatwalk
>>> mesh = heatwalk.shape("torus")
>>> distances = mesh.distance(0)
>>> path = mesh.path(0, int(distances.argmax()))
>>> bool(abs(path.length - distances.max()) < 1e-9)
True

`Mesh` takes arrays, `read` files; `PointCloud` points without triangles, `TetMesh` tetrahedra. `heatwalk.potpourri3d`, `heatwalk.pygeodesic` and `heatwalk.gdist` have the names of those
packages.
"""

from heatwalk._answers import (
    Answer,
    Bounds,
    Cells,
    Curve,
    Isoline,
    Labels,
    LogMap,
    Mean,
    Path,
    Place,
    Samples,
    Snapped,
    TangentFrames,
    TetPath,
    Walk,
)
from heatwalk._errors import HeatwalkError
from heatwalk._heatwalk import Index, Mesh, PointCloud, TetMesh, __version__, read, read_labels, shape

__all__ = [
    "Answer",
    "Bounds",
    "Cells",
    "Curve",
    "HeatwalkError",
    "Index",
    "Isoline",
    "Labels",
    "LogMap",
    "Mean",
    "Mesh",
    "Path",
    "Place",
    "PointCloud",
    "Samples",
    "Snapped",
    "TangentFrames",
    "TetMesh",
    "TetPath",
    "Walk",
    "__version__",
    "read",
    "read_labels",
    "shape",
]
