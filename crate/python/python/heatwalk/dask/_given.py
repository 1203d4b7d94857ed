"""Meshes as they travel to workers."""

from __future__ import annotations

import hashlib
import os
import pickle
import threading
from collections.abc import Callable
from functools import partial
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from heatwalk._errors import HeatwalkError
from heatwalk._heatwalk import Mesh, read

MeshLike: TypeAlias = str | os.PathLike[str] | Mesh | tuple[ArrayLike, ArrayLike]
"""A path that every worker sees, a mesh, or its arrays `(V, F)`."""


class Given:
    """A mesh that is built where it is asked for, once in each process.

    A pickled `Mesh` is built again wherever it passes, the scheduler too; this one is a path or bytes until then.
    """

    path: str | None
    """Where it is read from."""

    def __init__(self, mesh: MeshLike, reading: dict[str, Any]) -> None:
        self.path = None
        self._known: str | None = None
        self._make: Callable[[], Mesh]
        if isinstance(mesh, Mesh):
            # Its arrays would be read by whoever passes it on.
            self._make = partial(pickle.loads, pickle.dumps(mesh))
        elif isinstance(mesh, (str, os.PathLike)):
            self.path = os.path.abspath(mesh)
            self._make = partial(read, self.path, **reading)
        elif isinstance(mesh, tuple) and len(mesh) == 2:
            self._make = partial(Mesh, *mesh, **reading)
        else:
            raise HeatwalkError(
                f"a mesh is a path, a heatwalk.Mesh or a pair of arrays (V, F), not {type(mesh).__name__}", "bad-mesh"
            )
        self._begin()

    def _begin(self) -> None:
        self._lock = threading.Lock()
        self._mesh: Mesh | None = None

    def mesh(self) -> Mesh:
        """Builds it at the first call; the threads of a process wait for the one that does."""
        with self._lock:
            if self._mesh is None:
                mesh = self._make()
                if self._known is not None and digest(mesh) != self._known:
                    raise HeatwalkError(
                        f"{self.path} is another mesh for this worker than where the matrix was made; give all the same file",
                        "another-mesh",
                    )
                self._mesh = mesh
            return self._mesh

    def pin(self) -> str:
        """What is built elsewhere must be what is built here. Returns its digest."""
        known = digest(self.mesh())
        if self.path is not None:
            self._known = known
        return known

    def __getstate__(self) -> tuple[str | None, str | None, Callable[[], Mesh]]:
        return self.path, self._known, self._make

    def __setstate__(self, state: tuple[str | None, str | None, Callable[[], Mesh]]) -> None:
        self.path, self._known, self._make = state
        self._begin()


def digest(mesh: Mesh) -> str:
    """Of all that its answers depend on."""
    (vertices, faces), options = mesh.__getnewargs_ex__()
    hashed = hashlib.sha256()
    for name, value in [("V", vertices), ("F", faces), *sorted(options.items())]:
        if isinstance(value, np.ndarray):
            hashed.update(f"{name} {value.dtype.str} {value.shape}\n".encode())
            hashed.update(np.ascontiguousarray(value).data)
        elif name != "threads":
            hashed.update(f"{name} {value!r}\n".encode())
    return hashed.hexdigest()
