"""libigl's heat method on a mesh that the example `inside` wrote, as JSON: inside.py MESH

Milliseconds of precompute and of a solve, the median of nine after one from vertex 0, and mean and largest error in per cent. libigl's distances in tetrahedra are larger by a factor that
depends on the mesh, so they are divided by the median of their ratios to the exact ones.
"""

import json
import sys
import time

import igl
import numpy as np


def read(path):
    with open(path) as file:
        vertices, tetrahedra, source = (int(word) for word in file.readline().split())
        rows = [file.readline().split() for _ in range(vertices)]
        table = np.array(rows, dtype=np.float64)
        corners = np.loadtxt(file, dtype=np.int64)
    assert corners.shape == (tetrahedra, 4)
    return np.ascontiguousarray(table[:, :3]), corners, source, table[:, 3]


def timed(work):
    start = time.perf_counter()
    answer = work()
    return answer, 1e3 * (time.perf_counter() - start)


positions, tetrahedra, source, exact = read(sys.argv[1])
data = igl.HeatGeodesicsData()
_, precompute = timed(lambda: igl.heat_geodesics_precompute(positions, tetrahedra, data))
igl.heat_geodesics_solve(data, np.array([0]))
solves = [timed(lambda: igl.heat_geodesics_solve(data, np.array([source]))) for _ in range(9)]
distances = solves[0][0]
solve = float(np.median([milliseconds for _, milliseconds in solves]))
away = exact > 0
ratios = distances[away] / exact[away]
errors = 100 * np.abs(ratios / np.median(ratios) - 1)
print(json.dumps({"precompute": precompute, "solve": solve, "mean": errors.mean(), "max": errors.max()}))
