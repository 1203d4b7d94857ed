"""One peer's distances on a welded mesh, as JSON: accuracy_peers.py robust|exact MESH SOURCE EXACT.csv."""

import json
import sys
import time

import numpy as np
import potpourri3d as pp3d


def read_off(path):
    """Positions and triangles of a text file without comments; potpourri3d reads other formats only."""
    with open(path) as file:
        numbers = file.read().split()[1:]
    vertices, faces = int(numbers[0]), int(numbers[1])
    rows = 3 + 3 * vertices
    positions = np.array(numbers[3:rows], dtype=float).reshape(-1, 3)
    triangles = np.array(numbers[rows : rows + 4 * faces], dtype=int).reshape(-1, 4)[:, 1:]
    return positions, triangles


def robust(positions, triangles, source, exact):
    """Error of geometry-central's robust heat method against exact distances, in per cent."""
    solver = pp3d.MeshHeatMethodDistanceSolver(positions, triangles, use_robust=True)
    distance = solver.compute_distance(source)
    measured = (exact > 0) & np.isfinite(exact)
    error = 100 * np.abs(distance[measured] - exact[measured]) / exact[measured]
    return {"mean": error.mean(), "max": error.max()}


def exactly(positions, triangles, source, exact):
    """Time of pygeodesic and the largest relative difference of its distances."""
    from pygeodesic import geodesic

    algorithm = geodesic.PyGeodesicAlgorithmExact(positions, triangles)
    start = time.perf_counter()
    distance, _ = algorithm.geodesicDistances(np.array([source]), None)
    ms = 1e3 * (time.perf_counter() - start)
    measured = (exact > 0) & np.isfinite(exact)
    difference = np.abs(distance[measured] - exact[measured]) / exact[measured]
    return {"ms": ms, "max_difference": difference.max()}


def main():
    what, path, source, exact_path = sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4]
    positions, triangles = read_off(path) if path.endswith(".off") else pp3d.read_mesh(path)
    exact = np.loadtxt(exact_path, delimiter=",", skiprows=1, usecols=1)
    print(json.dumps({"robust": robust, "exact": exactly}[what](positions, triangles, source, exact)))


main()
