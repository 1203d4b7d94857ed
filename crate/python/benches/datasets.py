"""What the pieces of data sets cost: reading, building, rows and memory, of a sphere of N rings (2 N² vertices).

pip install ./crate/python; python crate/python/benches/datasets.py RINGS METHOD ROWS
"""

from __future__ import annotations

import resource
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

import heatwalk  # noqa: E402
import meshes  # noqa: E402
import numpy as np  # noqa: E402


def ball(rings: int) -> tuple[meshes.Floats, meshes.Integers]:
    """A unit sphere of latitude and longitude, as quick to make as to build."""
    columns = 2 * rings
    polar, around = np.linspace(0.01, np.pi - 0.01, rings), np.arange(columns) * (2 * np.pi / columns)
    p, a = (axis.ravel() for axis in np.meshgrid(polar, around, indexing="ij"))
    corner = np.arange((rings - 1) * columns).reshape(rings - 1, columns)
    following = np.roll(corner, -1, axis=1)
    corner, following = corner.ravel(), following.ravel()
    lower = np.column_stack([corner, corner + columns, following + columns])
    upper = np.column_stack([corner, following + columns, following])
    vertices = np.column_stack([np.sin(p) * np.cos(a), np.sin(p) * np.sin(a), np.cos(p)])
    return vertices, np.concatenate([lower, upper])


def peak() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20


def main() -> None:
    rings, method, count = int(sys.argv[1]), sys.argv[2], int(sys.argv[3])
    arrays = ball(rings)
    print(f"{len(arrays[0]):,} vertices, {len(arrays[1]):,} triangles; arrays: {peak():.2f} GiB")
    begun = time.process_time()
    mesh = heatwalk.Mesh(*arrays, threads=1)
    print(f"building: {time.process_time() - begun:.2f} s of a processor; {peak():.2f} GiB")
    for sources in [[0], list(range(1, count + 1))]:
        begun = time.process_time()
        mesh.matrix(sources, method=method, threads=1, dtype="float32")  # type: ignore[arg-type]
        seconds = (time.process_time() - begun) / len(sources)
        print(f"{len(sources)} rows by {method}: {seconds:.3f} s of a processor each; {peak():.2f} GiB", flush=True)


if __name__ == "__main__":
    main()
