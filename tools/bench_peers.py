"""Precompute and solve of potpourri3d's two heat-method solvers, as JSON: bench_peers.py MESH SOURCES."""

import json
import statistics
import sys
import time

import numpy as np
import potpourri3d as pp3d


def read_off(path):
    words = open(path).read().split()
    vertices, faces = int(words[1]), int(words[2])
    numbers = words[4:]
    positions = np.array(numbers[: 3 * vertices], dtype=float).reshape(-1, 3)
    triangles = np.array(numbers[3 * vertices :], dtype=int).reshape(-1, 4)[:faces, 1:]
    return positions, triangles


def measure(positions, triangles, sources, robust):
    start = time.perf_counter()
    solver = pp3d.MeshHeatMethodDistanceSolver(positions, triangles, use_robust=robust)
    solver.compute_distance(0)
    first = time.perf_counter() - start
    times = []
    for source in sources:
        start = time.perf_counter()
        solver.compute_distance(int(source))
        times.append(time.perf_counter() - start)
    solve = statistics.median(times)
    # The first query factors what the constructor leaves for later.
    return {"precompute": 1e3 * (first - solve), "solve": 1e3 * solve}


def main():
    path, count = sys.argv[1], int(sys.argv[2])
    positions, triangles = read_off(path) if path.endswith(".off") else pp3d.read_mesh(path)
    sources = np.random.default_rng(1).integers(0, len(positions), count)
    print(
        json.dumps(
            {
                "plain": measure(positions, triangles, sources, robust=False),
                "robust": measure(positions, triangles, sources, robust=True),
            }
        )
    )


if __name__ == "__main__":
    main()
