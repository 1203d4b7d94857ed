"""One question about each of many meshes."""

from __future__ import annotations

import errno
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any, Generic, TypeVar

import dask.bag
import distributed

from heatwalk._errors import HeatwalkError
from heatwalk._heatwalk import Mesh
from heatwalk.dask._given import Given, MeshLike

T = TypeVar("T")

# Meshes a thread that are with the workers at once: one that is answered, and some that wait.
AHEAD = 4


@dataclass(frozen=True)
class Row(Generic[T]):
    """What is known of one mesh."""

    number: int
    """Which mesh of those that were given, from 0."""
    path: str | None
    """Where it was read from; None where it was given as arrays."""
    value: T | None
    """What the function returned; None where there is an error."""
    error: HeatwalkError | None
    """Why there is no value. Its code is that of `heatwalk`, or "file-system", "disk-full" or "out-of-memory", "ended" where it ended
    each worker that had it, "failed" where the function raised something else."""


def answers(
    meshes: Iterable[MeshLike],
    function: Callable[[Mesh], T],
    *,
    client: distributed.Client | None = None,
    **reading: Any,
) -> Iterator[Row[T]]:
    """Ask a function about each mesh, on the workers of a client; rows come as they are found.

    `meshes` may be endless: some are with the workers, those before are let go of. `function` takes a `Mesh` and returns what can be pickled.
    `reading`: keywords of `heatwalk.read` for paths, of `heatwalk.Mesh` for arrays. `client`: the current one if not given.

    An error of a mesh is in its row, and is not tried again. What a lost worker had is done again by another one, as often as the
    setting `distributed.scheduler.allowed-failures` says; a mesh that ended all of those has the error "ended".
    """
    client = client or distributed.get_client()
    asked: dict[distributed.Future[Row[T]], tuple[int, str | None]] = {}
    waiting = enumerate(meshes)
    done = distributed.as_completed()

    def ask_next() -> None:
        for number, mesh in waiting:
            given = _given(mesh, reading)
            future = client.submit(partial(_answer, function), given, number, pure=False)
            asked[future] = number, getattr(given, "path", None)
            done.add(future)
            return

    try:
        for _ in range(AHEAD * max(1, sum(client.nthreads().values()))):
            ask_next()
        for future in done:
            number, path = asked.pop(future)
            row = _told(future, number, path)
            future.release()
            ask_next()
            yield row
    finally:
        client.cancel(list(asked))


def bag(
    meshes: Iterable[MeshLike],
    function: Callable[[Mesh], T],
    *,
    partition_size: int | None = None,
    **reading: Any,
) -> dask.bag.Bag:
    """The rows of `answers` as a bag of Dask, in the order of the meshes, to go on with.

    `partition_size`: meshes a task, so that there are about a hundred tasks if not given. An error of a mesh is in its row; a
    mesh that ends all workers that have it ends the computation, where `answers` has a row.
    """
    numbered = [(_given(mesh, reading), number) for number, mesh in enumerate(meshes)]
    sequence = dask.bag.from_sequence(numbered, partition_size=partition_size)
    rows: dask.bag.Bag = sequence.starmap(partial(_answer, function))
    return rows


def _given(mesh: MeshLike, reading: dict[str, Any]) -> Given | HeatwalkError:
    try:
        return Given(mesh, reading)
    except HeatwalkError as error:
        return error


def _answer(function: Callable[[Mesh], T], given: Given | HeatwalkError, number: int) -> Row[T]:
    if isinstance(given, HeatwalkError):
        return Row(number, None, None, given)
    try:
        return Row(number, given.path, function(given.mesh()), None)
    except Exception as error:
        return Row(number, given.path, None, _typed(error))


def _told(future: distributed.Future[Row[T]], number: int, path: str | None) -> Row[T]:
    """What became of a task."""
    try:
        return future.result()
    except distributed.KilledWorker as error:
        sentence = f"it ended each of the workers that had it; perhaps memory is short, then use fewer threads a worker ({error})"
        return Row(number, path, None, HeatwalkError(sentence, "ended"))
    except distributed.client.FutureCancelledError:
        raise
    except Exception as error:
        return Row(number, path, None, _typed(error))


def _typed(error: Exception) -> HeatwalkError:
    """As the one exception that has a code, and can be pickled."""
    if isinstance(error, HeatwalkError):
        return error
    if isinstance(error, MemoryError):
        return HeatwalkError(f"memory is short: {error}; use fewer threads a worker", "out-of-memory")
    if isinstance(error, OSError):
        return HeatwalkError(str(error), "disk-full" if error.errno == errno.ENOSPC else "file-system")
    return HeatwalkError(f"{type(error).__name__}: {error}", "failed")
