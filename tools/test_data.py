"""Exact distances and the errors of another heat method on the test meshes: test_data.py MESHES DATA."""

import sys
from pathlib import Path

import numpy as np
import potpourri3d as pp3d
from pygeodesic import geodesic

sys.path.append(str(Path(__file__).parent / "bench"))
from peers import read  # noqa: E402

SOURCES = {
    "bunny": [0, 919],
    "hemisphere": [0, 400],
    "high_genus": [0, 400],
    "triceratops": [0, 400],
    "slivers": [0, 750],
}


def main():
    meshes, data = map(Path, sys.argv[1:])
    lines = ["mesh,source,mean,maximum"]
    for name, sources in SOURCES.items():
        positions, triangles = read(meshes / f"{name}.ply")
        algorithm = geodesic.PyGeodesicAlgorithmExact(positions, triangles)
        solver = pp3d.MeshHeatMethodDistanceSolver(positions, triangles, use_robust=True)
        for source in sources:
            exact, _ = algorithm.geodesicDistances(np.array([source]), None)
            np.save(data / f"{name}.{source}.npy", np.asarray(exact, dtype="<f8"))
            others = np.arange(len(exact)) != source
            error = np.abs(solver.compute_distance(source) - exact)[others] / exact[others]
            lines.append(f"{name},{source},{100 * error.mean():.4f},{100 * error.max():.4f}")
    (data / "robust.csv").write_text("\n".join(lines) + "\n")


main()
