"""Rows of distances on a cluster of Ray, into one array: an actor a core, each with the mesh.

pip install "ray==2.60.0" ./crate/python; python crate/python/examples/ray_rows.py
"""

from __future__ import annotations

import heatwalk
import numpy as np
import ray
from numpy.typing import NDArray

ROWS = 32


@ray.remote(num_cpus=1, max_restarts=3, max_task_retries=3)  # what a lost actor had is done again
class Solver:
    """Builds the mesh once, when it begins."""

    def __init__(self, V: NDArray[np.float64], F: NDArray[np.int64]) -> None:
        self.mesh = heatwalk.Mesh(V, F, threads=1)

    def rows(self, first: int, last: int) -> tuple[int, NDArray[np.float32]]:
        found = self.mesh.matrix(np.arange(first, last), method="heat", threads=1, dtype="float32")
        return first, found


def all_rows(mesh: heatwalk.Mesh, actors: int) -> NDArray[np.float32]:
    arrays = [ray.put(mesh.vertices), ray.put(mesh.faces)]  # one copy a machine
    solvers = [Solver.remote(*arrays) for _ in range(actors)]
    pool = ray.util.ActorPool(solvers)
    count = len(mesh.vertices)
    result = np.empty((count, count), np.float32)
    starts = range(0, count, ROWS)
    for first, rows in pool.map_unordered(lambda solver, at: solver.rows.remote(at, min(at + ROWS, count)), starts):
        result[first : first + len(rows)] = rows
    return result


def main() -> None:
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    mesh = heatwalk.Mesh(*surface())
    print(all_rows(mesh, actors=2).max())
    ray.shutdown()


def surface(side: int = 16) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """A wavy square."""
    x, y = (axis.ravel() for axis in np.meshgrid(np.linspace(0, 1, side), np.linspace(0, 1, side)))
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    lower = np.column_stack([corner, corner + 1, corner + side + 1])
    upper = np.column_stack([corner, corner + side + 1, corner + side])
    return np.column_stack([x, y, 0.1 * np.sin(7 * x) * np.cos(5 * y)]), np.concatenate([lower, upper])


if __name__ == "__main__":
    main()
