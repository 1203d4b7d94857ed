"""Files that workers write rows to, in any order."""

from __future__ import annotations

import io
import os
import shutil
import zlib
from dataclasses import dataclass
from typing import Any, Protocol

import dask.array
import numpy as np
from numpy.typing import NDArray

from heatwalk._errors import HeatwalkError

# Bytes of a chunk of Zarr at most, unless a block is less: chunks are compressed in memory.
CHUNK_BYTES = 64 << 20


class Store(Protocol):
    """An array on the disk, (k, l), that is written in blocks of `rows`."""

    path: str
    rows: int
    shape: tuple[int, int]

    def create(self) -> None:
        """Replaces what was begun."""

    def exists(self) -> bool: ...
    def write(self, first: int, rows: NDArray[Any]) -> None:
        """Puts rows at `first`. Other rows are not touched."""

    def read(self, first: int) -> NDArray[Any]:
        """The block at `first`."""

    def sync(self) -> None:
        """Comes back once all is on the disk."""


@dataclass
class NpyFile:
    """A file of NumPy."""

    path: str
    rows: int
    shape: tuple[int, int]
    dtype: str

    def _header(self) -> bytes:
        header = io.BytesIO()
        told = {"descr": self.dtype, "fortran_order": False, "shape": self.shape}
        np.lib.format.write_array_header_1_0(header, told)
        return header.getvalue()

    def _at(self, row: int) -> int:
        return len(self._header()) + row * self.shape[1] * np.dtype(self.dtype).itemsize

    def create(self) -> None:
        with open(self.path, "wb") as file:
            file.write(self._header())
            file.truncate(self._at(self.shape[0]))
            os.fsync(file.fileno())

    def exists(self) -> bool:
        return os.path.isfile(self.path) and os.path.getsize(self.path) == self._at(self.shape[0])

    def write(self, first: int, rows: NDArray[Any]) -> None:
        # Not through a mapping of memory: there, a full disk ends the process.
        with open(self.path, "r+b") as file:
            file.seek(self._at(first))
            file.write(np.ascontiguousarray(rows, self.dtype).data)
            file.flush()
            os.fsync(file.fileno())

    def read(self, first: int) -> NDArray[Any]:
        width = self.shape[1]
        count = min(self.rows, self.shape[0] - first) * width
        return np.fromfile(self.path, self.dtype, count, offset=self._at(first)).reshape(-1, width)

    def sync(self) -> None:
        """Each block is, since it was written."""


@dataclass
class ZarrFolder:
    """An array of Zarr in a folder."""

    path: str
    rows: int
    shape: tuple[int, int]
    dtype: str

    def create(self) -> None:
        import zarr

        if os.path.isdir(self.path):
            shutil.rmtree(self.path)
        row = self.rows * np.dtype(self.dtype).itemsize
        columns = max(1, min(self.shape[1], CHUNK_BYTES // row))
        chunks = (max(1, min(self.rows, self.shape[0])), columns)
        zarr.create_array(self.path, shape=self.shape, chunks=chunks, dtype=self.dtype, fill_value=0)

    def _array(self, mode: Any) -> Any:
        import zarr

        return zarr.open_array(self.path, mode=mode)

    def exists(self) -> bool:
        return os.path.isfile(os.path.join(self.path, "zarr.json"))

    def write(self, first: int, rows: NDArray[Any]) -> None:
        self._array("r+")[first : first + len(rows)] = rows

    def read(self, first: int) -> NDArray[Any]:
        found: NDArray[Any] = self._array("r")[first : first + self.rows]
        return found

    def sync(self) -> None:
        if hasattr(os, "sync"):
            os.sync()


def store_of(target: str, matrix: dask.array.Array) -> Store:
    """What `target` is written as, by its extension, before it is whole."""
    if os.path.lexists(target):
        raise HeatwalkError(f"{target} exists; remove it, or choose another name", "exists")
    if matrix.ndim != 2 or matrix.numblocks[1] > 1 or np.isnan(matrix.shape).any():
        raise HeatwalkError("only arrays in blocks of whole rows are saved: matrix.rechunk({1: -1})", "bad-shape")
    sizes = matrix.chunks[0]
    if any(size != sizes[0] for size in sizes[:-1]) or sizes[-1] > sizes[0]:
        raise HeatwalkError('blocks have different numbers of rows: matrix.rechunk({0: "auto", 1: -1})', "bad-shape")
    kinds: dict[str, type[NpyFile] | type[ZarrFolder]] = {".npy": NpyFile, ".zarr": ZarrFolder}
    kind = kinds.get(os.path.splitext(target)[1].lower())
    if kind is None:
        raise HeatwalkError(f"{target} is neither .npy nor .zarr; name it one of these", "bad-parameter")
    if kind is ZarrFolder:
        _require_zarr()
    rows = max(1, sizes[0])
    return kind(f"{target}.part", rows, matrix.shape, matrix.dtype.str)


def _require_zarr() -> None:
    try:
        import zarr  # noqa: F401
    except ImportError as error:
        raise ImportError('.zarr needs Zarr: pip install "heatwalk[dask]", or save as .npy') from error


def checksum(rows: NDArray[Any]) -> int:
    return zlib.crc32(np.ascontiguousarray(rows).data)
