"""All pairs of a closed body of 6,890 vertices, by a matrix and by a loop over potpourri3d; and one exact distance.

pip install ./crate/python potpourri3d==1.4.0; python crate/python/benches/matrix.py [MESH]
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable
from pathlib import Path

for library in ("OMP", "OPENBLAS", "MKL"):
    os.environ[f"{library}_NUM_THREADS"] = "1"

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

import heatwalk  # noqa: E402
import meshes  # noqa: E402
import numpy as np  # noqa: E402
import potpourri3d  # noqa: E402


def body() -> tuple[meshes.Floats, meshes.Integers]:
    """A sphere with bumps, 6,890 vertices and 13,776 faces."""
    vertices, faces = meshes.sphere(83, 84)
    x, y, z = vertices.T
    radius = 1 + 0.25 * np.sin(3 * x + 1) * np.sin(4 * y) + 0.2 * np.cos(5 * z)
    return vertices * radius[:, None], faces


def timed(what: str, work: Callable[[], object], rows: int) -> object:
    begun, cpu = time.perf_counter(), time.process_time()
    result = work()
    seconds, used = time.perf_counter() - begun, time.process_time() - cpu
    print(f"{what:44} {seconds:8.2f} s, {used:8.2f} s of processors, {1e3 * used / rows:8.3f} ms a row", flush=True)
    return result


def main() -> None:
    V, F = body()
    count = len(V)
    mesh = heatwalk.Mesh(V, F)
    exact = mesh.matrix(np.arange(0, count, 500), method="exact")

    def error(rows: np.ndarray) -> str:
        some = rows[::500]
        valid = (exact > 0) & np.isfinite(exact)
        relative = np.abs(some - exact)[valid] / exact[valid]
        return f"    relative error: mean {100 * relative.mean():.3f} %, maximum {100 * relative.max():.2f} %"

    def loop() -> np.ndarray:
        solver = potpourri3d.MeshHeatMethodDistanceSolver(V, F)
        return np.stack([solver.compute_distance(source) for source in range(count)])

    print(error(timed("potpourri3d, a loop", loop, count)))
    for threads in (1, os.cpu_count() or 1):
        for options in ({"exact_radius": 0.0}, {}):
            name = f"heatwalk, heat {options or ''}, {threads} threads"
            work = lambda: mesh.matrix(method="heat", threads=threads, dtype="float32", **options)  # noqa: B023, E731
            print(error(timed(name, work, count)))
    some = np.arange(0, count, 10)
    timed("heatwalk, propagation, every tenth row", lambda: mesh.matrix(some, method="propagation", threads=1), len(some))
    timed("heatwalk, exact, every tenth row", lambda: mesh.matrix(some, method="exact", threads=1), len(some))

    if len(sys.argv) > 1:
        large = heatwalk.read(sys.argv[1], threads=1)
        large.distance(0, "exact")
        times = []
        for _ in range(5):
            cpu = time.process_time()
            large.distance(0, "exact")
            times.append(time.process_time() - cpu)
        print(f"one exact distance on {sys.argv[1]}: {1e3 * sorted(times)[2]:.0f} ms of a processor")


if __name__ == "__main__":
    main()
