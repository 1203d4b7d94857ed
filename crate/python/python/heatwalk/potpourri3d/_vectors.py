"""What is carried over a mesh: numbers, tangent vectors, directions."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from heatwalk._answers import Floats
from heatwalk._errors import HeatwalkError
from heatwalk._heatwalk import Mesh
from heatwalk.potpourri3d._elements import mesh_of, vertices_of

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix

STRATEGIES = ("VectorHeat", "AffineLocal", "AffineAdaptive")


class VectorHeatSolver:
    """What is carried over a mesh by heat. Tangent vectors are two numbers each, in the frames of `get_tangent_frames`."""

    def __init__(self, mesh: Mesh) -> None:
        self._mesh = mesh
        self._frames = self._mesh.tangent_frames()

    def extend_scalar(self, v_inds: ArrayLike, values: ArrayLike) -> Floats:
        """(n,) floats: `values`, (k,) floats at vertices, carried to all others."""
        return self._mesh.extend(vertices_of(v_inds), np.asarray(values, dtype=np.float64))

    def get_tangent_frames(self) -> tuple[Floats, Floats, Floats]:
        """(n, 3) floats each: unit vectors x and y in the plane of each vertex, and its normal."""
        return self._frames.x, self._frames.y, self._frames.normals

    def transport_tangent_vector(self, v_ind: int, vector: ArrayLike) -> Floats:
        """(n, 2) floats: a vector, (2,) floats at a vertex, carried to all others."""
        return self.transport_tangent_vectors([v_ind], np.asarray(vector, dtype=np.float64)[None])

    def transport_tangent_vectors(self, v_inds: ArrayLike, vectors: ArrayLike) -> Floats:
        """(n, 2) floats: vectors, (k, 2) floats at vertices, carried to all others, each to what is nearest."""
        sources, given = vertices_of(v_inds), np.asarray(vectors, dtype=np.float64)
        if given.shape != (len(sources), 2):
            raise HeatwalkError(
                f"the vectors have the shape {given.shape}; give two numbers for each of {len(sources)} vertices", "bad-shape"
            )
        self._require(sources)
        x, y = self._frames.x, self._frames.y
        carried = self._mesh.transport(sources, given[:, :1] * x[sources] + given[:, 1:] * y[sources], "heat")
        return np.column_stack([(carried * x).sum(axis=1), (carried * y).sum(axis=1)])

    def compute_log_map(self, v_ind: int, strategy: str = "AffineLocal") -> Floats:
        """(n, 2) floats: the exact log map in the frame of a vertex. `strategy` is one of potpourri3d's, and makes no difference."""
        if strategy not in STRATEGIES:
            raise HeatwalkError(f"there is no strategy '{strategy}'; choose one of {', '.join(STRATEGIES)}", "unknown-choice")
        (source,) = vertices_of([v_ind])
        self._require(np.array([source]))
        return self._mesh.log_map(int(source), self._frames.x[source]).coordinates

    def _require(self, vertices: np.ndarray[tuple[int, ...], np.dtype[np.int64]]) -> None:
        count = len(self._frames.x)
        for vertex in vertices[(vertices < 0) | (vertices >= count)]:
            raise HeatwalkError(f"vertex {vertex} does not exist; there are {count}, counted from 0", "no-such-vertex")


class MeshVectorHeatSolver(VectorHeatSolver):
    """Tangent vectors are two numbers each, in the frames of `get_tangent_frames`.

    What is carried goes by heat, on the intrinsic Delaunay triangulation, for a time of the squared mean edge, whatever `t_coef` and
    `use_intrinsic_delaunay` are; log maps are exact.
    """

    def __init__(self, V: ArrayLike, F: ArrayLike, t_coef: float = 1.0, use_intrinsic_delaunay: bool = True) -> None:
        super().__init__(mesh_of(V, F))

    def get_connection_laplacian(self) -> csc_matrix:
        """(n, n) complex numbers, the connection Laplacian in these frames."""
        from scipy.sparse import csc_matrix

        rows, columns, values = self._mesh.connection_laplacian()
        count = len(self._frames.x)
        return csc_matrix((values, (rows, columns)), shape=(count, count))
