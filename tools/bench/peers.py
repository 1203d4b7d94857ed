"""One peer on one mesh that bench_mesh wrote, as JSON in milliseconds: peers.py PEER MESH SOURCE...

Precompute is everything from arrays in memory to ready factors, solve the median over the sources.
"""

import importlib.metadata
import json
import re
import statistics
import sys
import time

import numpy as np


def read(path):
    with open(path, "rb") as file:
        data = file.read()
    header, body = data.split(b"end_header\n", 1)
    vertices, faces = (int(count) for count in re.findall(rb"element \w+ (\d+)", header))
    vertex = np.dtype([("position", "<f8", 3), ("distance", "<f8")])
    face = np.dtype([("corners", "u1"), ("vertices", "<u4", 3)])
    positions = np.frombuffer(body, vertex, vertices)["position"]
    triangles = np.frombuffer(body, face, faces, vertices * vertex.itemsize)["vertices"]
    return np.array(positions), np.array(triangles, dtype=np.int64)


def timed(work):
    start = time.perf_counter()
    answer = work()
    return answer, 1e3 * (time.perf_counter() - start)


def solves(solve, sources):
    return statistics.median(timed(lambda: solve(source))[1] for source in sources)


def potpourri3d(positions, triangles, sources, robust):
    import potpourri3d as pp3d

    def first():
        solver = pp3d.MeshHeatMethodDistanceSolver(positions, triangles, use_robust=robust)
        solver.compute_distance(sources[0])
        return solver

    solver, passed = timed(first)
    solve = solves(solver.compute_distance, sources)
    # The first question factors what the constructor leaves for later.
    return {"precompute": passed - solve, "solve": solve}


def libigl(positions, triangles, sources):
    import igl

    data = igl.HeatGeodesicsData()
    data.use_intrinsic_delaunay = True
    _, precompute = timed(lambda: igl.heat_geodesics_precompute(positions, triangles, data))
    solve = solves(lambda source: igl.heat_geodesics_solve(data, np.array([source])), sources)
    return {"precompute": precompute, "solve": solve}


def matrices(positions, triangles):
    """M / t + L and L with one vertex of each component held, on the triangles as they are, in one pattern."""
    from scipy import sparse
    from scipy.sparse.csgraph import connected_components

    count = len(positions)
    corners = positions[triangles]
    weights, rows, columns, lengths = [], [], [], []
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        u, v = corners[:, i] - corners[:, k], corners[:, j] - corners[:, k]
        double_area = np.linalg.norm(np.cross(u, v), axis=1)
        weights.append(0.5 * np.einsum("ij,ij->i", u, v) / double_area)
        rows.append(triangles[:, i])
        columns.append(triangles[:, j])
        lengths.append(np.linalg.norm(u, axis=1))
    rows, columns, weights = np.concatenate(rows), np.concatenate(columns), np.concatenate(weights)
    off = sparse.coo_matrix((-weights, (rows, columns)), (count, count)).tocsc()
    off = off + off.T
    stiffness = (off - sparse.diags(np.asarray(off.sum(axis=1)).ravel())).tocsc()
    mass = np.bincount(triangles.ravel(), np.repeat(double_area / 6, 3), count)
    step = np.mean(np.concatenate(lengths)) ** 2
    heat = (sparse.diags(mass / step) + stiffness).tocsc()

    held = np.zeros(count, dtype=bool)
    _, component = connected_components(stiffness, directed=False)
    held[np.unique(component, return_index=True)[1]] = True
    grounded = stiffness.copy()
    row, column = grounded.indices, np.repeat(np.arange(count), np.diff(grounded.indptr))
    grounded.data[held[row] | held[column]] = 0.0
    grounded.data[held[row] & (row == column)] = 1.0
    return heat, grounded


def cholmod(positions, triangles, sources):
    """What the heat method cannot do without: both matrices analysed and factored, and one substitution with each."""
    from sksparse.cholmod import analyze

    analyses, factorings, factors = [], [], []
    for matrix in matrices(positions, triangles):
        symbolic, analysing = timed(lambda: analyze(matrix, mode="supernodal", ordering_method="amd"))
        factor, factoring = timed(lambda: symbolic.cholesky(matrix))
        analyses.append(analysing)
        factorings.append(factoring)
        factors.append(factor)

    def solve(source):
        right = np.zeros(len(positions))
        right[source] = 1.0
        return [factor(right) for factor in factors]

    return {
        "factors": sum(analyses) + sum(factorings),
        "analysed_once": min(analyses) + sum(factorings),
        "solve": solves(solve, sources),
        "blas": loaded_blas(),
    }


def loaded_blas():
    with open("/proc/self/maps") as maps:
        names = re.findall(r"/lib/\S*(libopenblas|libmkl|libblis|libblas)\S*", maps.read())
    return "reference BLAS" if set(names) <= {"libblas"} else sorted(set(names) - {"libblas"})[0]


PEERS = {
    "plain": lambda *mesh: potpourri3d(*mesh, robust=False),
    "robust": lambda *mesh: potpourri3d(*mesh, robust=True),
    "libigl": libigl,
    "cholmod": cholmod,
}


def versions():
    packages = ["numpy", "scipy", "potpourri3d", "libigl", "scikit-sparse"]
    installed = {name: package_version(name) for name in packages}
    return {"python": sys.version.split()[0], **{name: version for name, version in installed.items() if version}}


def package_version(name):
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return None


def main():
    peer = sys.argv[1]
    if peer == "versions":
        answer = versions()
    else:
        sources = [int(source) for source in sys.argv[3:]]
        try:
            answer = PEERS[peer](*read(sys.argv[2]), sources)
        except Exception as error:
            answer = {"failed": f"{type(error).__name__}: {error}"}
    print(json.dumps(answer))


if __name__ == "__main__":
    main()
