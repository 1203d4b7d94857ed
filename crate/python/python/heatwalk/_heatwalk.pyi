"""The part of the package that is written in Rust."""

from collections.abc import Callable, Sequence
from os import PathLike
from typing import Any, Literal, TypeAlias, TypedDict, final, type_check_only

import numpy as np
from numpy.typing import ArrayLike, NDArray
from typing_extensions import Unpack, disjoint_base

from heatwalk._answers import Answer, Bounds, Cells, Isoline, Labels, LogMap, Mean, Path, Samples, Snapped, TangentFrames, TetPath, Walk

__all__ = ["Index", "Mesh", "PointCloud", "TetMesh", "__version__", "read", "read_labels", "shape"]

__version__: str

_Floats: TypeAlias = NDArray[np.float64]
_Integers: TypeAlias = NDArray[np.int64]
_Weights: TypeAlias = Sequence[float] | NDArray[np.floating[Any]]
# A vertex, a face or a tetrahedron with weights of its corners, or coordinates.
_Place: TypeAlias = int | np.integer[Any] | tuple[int | np.integer[Any], _Weights] | _Weights
_Places: TypeAlias = _Place | Sequence[_Place] | NDArray[np.integer[Any]]
_Curves: TypeAlias = Literal["boundary"] | Sequence[_Place] | Sequence[Sequence[_Place]] | NDArray[np.integer[Any]]
_Progress: TypeAlias = Callable[[float, str], object]
_TetMethod: TypeAlias = Literal["march", "heat"]
_Method: TypeAlias = Literal["auto", "exact", "propagation", "heat"]

@type_check_only
class _Options(TypedDict, total=False):
    max_distance: float
    windows: int | Literal["all"]
    operator: Literal["delaunay", "plain", "relocate"]
    solver: Literal["cholesky", "cg"]
    time_step: float | Literal["auto"]
    boundary: Literal["neumann", "dirichlet", "average"]
    multi_source: Literal["exact", "summed"]
    exact_radius: float | Literal["auto"]

@type_check_only
class _TetOptions(TypedDict, total=False):
    max_distance: float
    solver: Literal["cholesky", "cg"]
    time_step: float | Literal["auto"]
    boundary: Literal["neumann", "dirichlet", "average"]
    multi_source: Literal["exact", "summed"]
    exact_radius: float | Literal["auto"]

def read(
    source: str | PathLike[str] | bytes,
    *,
    name: str | None = None,
    parts: Sequence[int] | None = None,
    weld: float | Literal["auto", "exact"] | None = None,
    bridges: float | Literal["auto", "off"] | None = None,
    links: int = 0,
    threads: int | None = None,
) -> Mesh: ...
def read_labels(path: str | PathLike[str]) -> Labels: ...
def shape(name: str) -> Mesh: ...
@disjoint_base
class Mesh:
    def __new__(
        cls,
        V: ArrayLike,
        F: ArrayLike,
        *,
        weld: float | Literal["auto", "exact"] | None = None,
        bridges: float | Literal["auto", "off"] | None = None,
        links: int = 0,
        threads: int | None = None,
        costs: ArrayLike | None = None,
        walls: ArrayLike | None = None,
        inactive: ArrayLike | None = None,
    ) -> Mesh: ...
    @property
    def vertices(self) -> _Floats: ...
    @property
    def faces(self) -> _Integers: ...
    @property
    def report(self) -> dict[str, int]: ...
    @property
    def mean_edge(self) -> float: ...
    @property
    def unit(self) -> str | None: ...
    @property
    def warnings(self) -> list[str]: ...
    def snap(self, points: ArrayLike) -> Snapped: ...
    def distance(
        self,
        sources: _Places,
        method: _Method = "auto",
        *,
        initial: ArrayLike | None = None,
        progress: _Progress | None = None,
        **options: Unpack[_Options],
    ) -> _Floats: ...
    def solve(
        self,
        sources: _Places,
        method: _Method = "auto",
        *,
        initial: ArrayLike | None = None,
        progress: _Progress | None = None,
        **options: Unpack[_Options],
    ) -> Answer: ...
    def matrix(
        self,
        sources: _Places | None = None,
        targets: ArrayLike | None = None,
        method: _Method = "auto",
        *,
        threads: int | None = None,
        dtype: Any = None,
        progress: _Progress | None = None,
        **options: Unpack[_Options],
    ) -> NDArray[Any]: ...
    def path(
        self,
        start: _Place,
        end: _Place,
        method: _Method = "auto",
        kind: Literal["straight", "descent", "exact"] = "straight",
        *,
        progress: _Progress | None = None,
        **options: Unpack[_Options],
    ) -> Path: ...
    def path_through(self, places: _Places, *, progress: _Progress | None = None) -> Path: ...
    def walk(self, start: _Place, direction: ArrayLike, length: float, *, face: int | None = None) -> Walk: ...
    def bezier(self, places: _Places, *, progress: _Progress | None = None) -> Path: ...
    def loop(self, places: _Places, *, progress: _Progress | None = None) -> Path: ...
    def closed_geodesic(self, places: _Places, *, progress: _Progress | None = None) -> Path: ...
    def handle_loops(self, *, progress: _Progress | None = None) -> list[Path]: ...
    def log_map(
        self,
        source: _Place,
        direction: ArrayLike | None = None,
        method: Literal["exact", "propagation", "heat"] = "exact",
        *,
        progress: _Progress | None = None,
    ) -> LogMap: ...
    def transport(
        self,
        sources: _Places,
        vectors: ArrayLike,
        method: Literal["exact", "heat"] = "exact",
        *,
        progress: _Progress | None = None,
    ) -> _Floats: ...
    def extend(self, sources: _Places, values: ArrayLike, *, progress: _Progress | None = None) -> _Floats: ...
    def tangent_frames(self, *, progress: _Progress | None = None) -> TangentFrames: ...
    def connection_laplacian(
        self, *, progress: _Progress | None = None
    ) -> tuple[_Integers, _Integers, NDArray[np.complex128]]: ...
    def curve_distance(
        self, curves: _Curves, *, closed: bool = False, progress: _Progress | None = None
    ) -> _Floats: ...
    def signed_distance(
        self,
        curves: _Curves,
        *,
        closed: bool = False,
        sign: Literal["auto", "nearest", "heat"] = "auto",
        progress: _Progress | None = None,
    ) -> _Floats: ...
    def isolines(
        self,
        values: ArrayLike,
        levels: ArrayLike | None = None,
        *,
        count: int | None = None,
        spacing: float | None = None,
    ) -> list[Isoline]: ...
    def cells(
        self, sources: _Places, *, initial: ArrayLike | None = None, progress: _Progress | None = None
    ) -> Cells: ...
    def sample(
        self,
        count: int | None = None,
        *,
        radius: float | None = None,
        relax: int = 0,
        start: _Place | None = None,
        progress: _Progress | None = None,
    ) -> Samples: ...
    def mean(
        self, sources: _Places, weights: ArrayLike | None = None, *, progress: _Progress | None = None
    ) -> Mean: ...
    def parcel_matrix(
        self,
        parcels: ArrayLike,
        between: Literal["mean", "minimum"] = "mean",
        method: _Method = "auto",
        *,
        threads: int | None = None,
        progress: _Progress | None = None,
        **options: Unpack[_Options],
    ) -> _Floats: ...
    def write_values(self, path: str | PathLike[str], values: ArrayLike) -> None: ...
    def __getnewargs_ex__(self) -> tuple[tuple[_Floats, _Integers], dict[str, Any]]: ...
    def __copy__(self) -> Mesh: ...
@final
class PointCloud(Mesh):
    def __new__(
        cls,
        points: ArrayLike,
        normals: ArrayLike | None = None,
        *,
        bridges: float | Literal["auto", "off"] | None = None,
        links: int = 0,
        threads: int | None = None,
    ) -> PointCloud: ...
    @property
    def joined(self) -> dict[str, int]: ...
    def __getnewargs_ex__(self) -> tuple[tuple[_Floats], dict[str, Any]]: ...  # type: ignore[override]
@final
class Index:
    def __new__(cls, mesh: Mesh, *, threads: int | None = None, progress: _Progress | None = None) -> Index: ...
    @staticmethod
    def load(path: str | PathLike[str], mesh: Mesh) -> Index: ...
    def save(self, path: str | PathLike[str]) -> None: ...
    def distance(self, starts: ArrayLike, ends: ArrayLike) -> Bounds: ...
    @property
    def labels(self) -> int: ...
@final
class TetMesh:
    def __new__(cls, V: ArrayLike, T: ArrayLike, *, costs: ArrayLike | None = None) -> TetMesh: ...
    @staticmethod
    def read(path: str | PathLike[str]) -> TetMesh: ...
    @property
    def vertices(self) -> _Floats: ...
    @property
    def tetrahedra(self) -> _Integers: ...
    @property
    def boundary_faces(self) -> _Integers: ...
    @property
    def report(self) -> dict[str, int]: ...
    @property
    def volume(self) -> float: ...
    @property
    def mean_edge(self) -> float: ...
    def distance(
        self,
        sources: _Places,
        method: _TetMethod = "march",
        *,
        initial: ArrayLike | None = None,
        progress: _Progress | None = None,
        **options: Unpack[_TetOptions],
    ) -> _Floats: ...
    def solve(
        self,
        sources: _Places,
        method: _TetMethod = "march",
        *,
        initial: ArrayLike | None = None,
        progress: _Progress | None = None,
        **options: Unpack[_TetOptions],
    ) -> Answer: ...
    def matrix(
        self,
        sources: _Places,
        method: _TetMethod = "march",
        *,
        progress: _Progress | None = None,
        **options: Unpack[_TetOptions],
    ) -> _Floats: ...
    def path(
        self,
        start: _Place,
        end: _Place,
        method: _TetMethod = "march",
        *,
        progress: _Progress | None = None,
        **options: Unpack[_TetOptions],
    ) -> TetPath: ...
    def boundary_distance(self) -> _Floats: ...
    def __getnewargs_ex__(self) -> tuple[tuple[_Floats, _Integers], dict[str, Any]]: ...
    def __copy__(self) -> TetMesh: ...
