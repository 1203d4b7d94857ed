"""Dask arrays that are written block by block, so that another run can go on with them."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any, NamedTuple

import dask.array
import distributed
import numpy as np
from numpy.typing import NDArray

from heatwalk._errors import HeatwalkError
from heatwalk.dask._part import Part
from heatwalk.dask._stores import Store, checksum, store_of


class Saved(NamedTuple):
    """What was written."""

    rows: int
    """Rows of the array."""
    rows_before: int
    """Those that an earlier run had finished."""


def save(
    matrix: dask.array.Array,
    target: str | os.PathLike[str],
    *,
    client: distributed.Client | None = None,
    progress: Callable[[float, str], object] | None = None,
) -> Saved:
    """Compute an array of row blocks on the workers of a client, and write it to a file `.npy` or a folder `.zarr`.

    Workers write their blocks themselves, to `target.part`, on a disk that all of them and this process see; nothing else is kept of them.
    `target.part.log` says which blocks are whole on the disk, with their checksums. A run that ends in the middle loses the blocks that it
    was at: the same call goes on from there, and the result is that of an undisturbed run to the last bit. Read it by
    `numpy.load(target, mmap_mode="r")`, `zarr.open_array` or `dask.array.from_zarr`.

    `matrix`: by `heatwalk.dask.matrix`, or made of it; its name tells whether it is the one that was begun. `client`: the
    current one if not given. `progress` is called with the share that is done and "Writing"; where it returns False the work ends with
    the code "cancelled", and can be gone on with.

    What a lost worker had is done again, as often as the setting `distributed.scheduler.allowed-failures` says. Raises HeatwalkError where
    `target` exists, where another run writes it or another matrix was begun there, and what a block raises; OSError where
    nothing can be written. What is finished is kept.
    """
    client = client or distributed.get_client()
    name = os.path.abspath(target)
    store = store_of(name, matrix)
    with Part(name, store, matrix.name) as part:
        before = part.rows()
        _write_missing(client, matrix, part, progress)
        part.finish()
    return Saved(matrix.shape[0], before)


def _write_missing(
    client: distributed.Client, matrix: dask.array.Array, part: Part, progress: Callable[[float, str], object] | None
) -> None:
    blocks = matrix.numblocks[0]
    missing = [block for block in range(blocks) if block not in part.finished]
    if not missing:
        return
    # Its types are those of a function of arrays.
    blockwise: Any = matrix.map_blocks
    written = blockwise(
        _write, part.store, chunks=((1,) * blocks, (1,)), dtype=np.int64, meta=np.empty((0, 0), np.int64)
    )
    tasks = written.to_delayed().ravel()
    futures = client.compute([tasks[block] for block in missing])
    number = dict(zip(futures, missing, strict=True))
    try:
        for future in distributed.as_completed(futures):
            part.add(number[future], _result(future, part))
            if progress is not None and progress(part.rows() / max(1, matrix.shape[0]), "Writing") is False:
                raise HeatwalkError(f"cancelled; {part.kept()}", "cancelled")
    finally:
        client.cancel(futures)


def _result(future: Any, part: Part) -> int:
    try:
        return int(future.result()[0, 0])
    except distributed.KilledWorker as error:
        sentence = (
            "a block ended each of the workers that had it; perhaps memory is short, then use fewer threads a worker or fewer "
            f"rows a block; {part.kept()} ({error})"
        )
        raise HeatwalkError(sentence, "ended") from error


def _write(rows: NDArray[Any], store: Store, block_id: tuple[int, int] = (0, 0)) -> NDArray[np.int64]:
    store.write(block_id[0] * store.rows, rows)
    return np.array([[checksum(rows)]], np.int64)
