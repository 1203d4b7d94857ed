"""Rows of distances as a dask array."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import dask
import dask.array
import distributed
import numpy as np
from dask.base import tokenize
from numpy.typing import ArrayLike, NDArray

from heatwalk._errors import HeatwalkError
from heatwalk._heatwalk import __version__
from heatwalk.dask._given import Given, MeshLike

# Bytes of a block, unless one row is more.
BLOCK_BYTES = 64 << 20
# Rows of a block: what a worker that is lost was at is soon done again.
ROWS = 32
# Blocks of a matrix, beyond which they have more rows: Dask takes about a millisecond for each.
BLOCKS = 10_000


def matrix(
    mesh: MeshLike,
    sources: Sequence[Any] | NDArray[Any] | None = None,
    targets: ArrayLike | None = None,
    method: str = "auto",
    *,
    rows: int | None = None,
    dtype: Any = "float64",
    **options: Any,
) -> dask.array.Array:
    """Distances from each source by itself, as `Mesh.matrix` finds them to the last bit, in blocks of rows that workers compute.

    `mesh`: a path that every worker sees, a mesh, or `(V, F)`. It is read here once, to count its vertices, and once by each worker that
    computes a block. `sources`: a list of places, or an array of vertices or of coordinates, (k,) or (k, 3); all vertices if not given.
    `targets`, `method`, `dtype` ("float64" or "float32") and `options` are those of `Mesh.matrix`.

    `rows` of a block: 32 if not given, or more where there would be over 10,000 blocks, and 64 MiB at most or one row. A worker
    holds a block, and a search, for each of its threads.

    Returns a dask array (k, l). Raises HeatwalkError as `Mesh.matrix`; what is wrong with a source is raised where its block is computed.
    """
    given = Given(mesh, {})
    built = given.mesh()
    kind = np.dtype(dtype)
    if targets is not None:
        targets = np.asarray(targets)
    # Without columns or rows nothing is searched, and the arguments are checked.
    count = len(built.matrix(sources, [], method, dtype=kind, **options))  # type: ignore[arg-type]
    width = built.matrix([], targets, method, dtype=kind, **options).shape[1]  # type: ignore[arg-type]
    places: Any = np.arange(count) if sources is None else sources
    if len(places) != count:
        raise HeatwalkError("sources of a matrix are a list of places or an array; put the place into a list: [place]")
    if rows is None:
        rows = min(max(ROWS, -(-count // BLOCKS)), max(1, BLOCK_BYTES // max(1, width * kind.itemsize)))
    elif rows < 1:
        raise HeatwalkError(f"a block has {rows} rows; it must have 1 or more")

    token = tokenize(__version__, given.pin(), places, targets, method, kind, sorted(options.items()), rows)
    parameters = (given, places, targets, method, kind, options)
    question = dask.delayed(Question)(*parameters, dask_key_name=f"heatwalk-question-{token}")  # type: ignore[attr-defined]
    numbers = dask.array.arange(count, chunks=rows)[:, None]
    blocks: dask.array.Array = dask.array.map_blocks(
        _rows,
        numbers,
        question,
        name=f"heatwalk-matrix-{token}",
        chunks=(numbers.chunks[0], (width,)),
        dtype=kind,
        meta=np.empty((0, 0), kind),
    )
    return blocks


class Question:
    """What all blocks have in common; a worker has one of it."""

    def __init__(
        self,
        given: Given,
        places: Any,
        targets: NDArray[Any] | None,
        method: str,
        dtype: np.dtype[Any],
        options: dict[str, Any],
    ) -> None:
        self._given = given
        self._places = places
        self._targets = targets
        self._method: Any = method
        self._dtype = dtype
        self._options = options

    def rows(self, first: int, last: int) -> NDArray[Any]:
        """Of the sources from `first` to before `last`."""
        mesh = self._given.mesh()
        places = self._places[first:last]
        return mesh.matrix(
            places, self._targets, self._method, threads=_threads(), dtype=self._dtype, **self._options
        )


def _rows(numbers: NDArray[np.int64], question: Question) -> NDArray[Any]:
    first = int(numbers[0, 0]) if len(numbers) else 0
    return question.rows(first, first + len(numbers))


def _threads() -> int | None:
    """Those that this worker may use; all of the machine where there is no worker."""
    try:
        return distributed.get_worker().state.nthreads
    except ValueError:
        return None
