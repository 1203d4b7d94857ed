"""The names of other packages: what they answer on meshes where the answer is known, and how."""

from __future__ import annotations

import inspect
from pathlib import Path

import heatwalk
import heatwalk.gdist as gdist
import heatwalk.potpourri3d as pp3d
import heatwalk.pygeodesic.geodesic as geodesic
import meshes
import numpy as np
import pytest
from heatwalk import HeatwalkError

CLOSE = {"atol": 1e-10, "rtol": 0}
V, F = meshes.grid(3)
FAR = np.linalg.norm(V, axis=1)
# Along x at y = 1/3.
LINE = [(4, []), (5, []), (6, []), (7, [])]


def test_names_arguments_and_defaults_are_those_of_potpourri3d() -> None:
    expected = {
        pp3d.MeshHeatMethodDistanceSolver: "(V, F, t_coef=1.0, use_robust=True)",
        pp3d.MeshFastMarchingDistanceSolver: "(V, F)",
        pp3d.MeshMarchingTrianglesSolver: "(V, F)",
        pp3d.MeshVectorHeatSolver: "(V, F, t_coef=1.0, use_intrinsic_delaunay=True)",
        pp3d.MeshSignedHeatSolver: "(V, F, t_coef=1.0)",
        pp3d.EdgeFlipGeodesicSolver: "(V, F, t_coef=1.0)",
        pp3d.GeodesicTracer: "(V, F, t_coef=1.0)",
        pp3d.MeshHeatMethodDistanceSolver.compute_distance: "(v_ind)",
        pp3d.MeshHeatMethodDistanceSolver.compute_distance_multisource: "(v_inds)",
        pp3d.MeshFastMarchingDistanceSolver.compute_distance: "(curves, distances=(), sign=False)",
        pp3d.MeshMarchingTrianglesSolver.marching_triangles: "(u, isoval=0.0)",
        pp3d.MeshVectorHeatSolver.extend_scalar: "(v_inds, values)",
        pp3d.MeshVectorHeatSolver.transport_tangent_vector: "(v_ind, vector)",
        pp3d.MeshVectorHeatSolver.transport_tangent_vectors: "(v_inds, vectors)",
        pp3d.MeshVectorHeatSolver.compute_log_map: "(v_ind, strategy='AffineLocal')",
        pp3d.MeshSignedHeatSolver.compute_distance: "(curves, curve_signs=(), points=(), preserve_source_normals=False, "
        "level_set_constraint='ZeroSet', soft_level_set_weight=-1)",
        pp3d.EdgeFlipGeodesicSolver.find_geodesic_path: "(v_start, v_end, max_iterations=None, max_relative_length_decrease=None)",
        pp3d.EdgeFlipGeodesicSolver.find_geodesic_path_poly: "(v_list, max_iterations=None, max_relative_length_decrease=None)",
        pp3d.EdgeFlipGeodesicSolver.find_geodesic_loop: "(v_list, max_iterations=None, max_relative_length_decrease=None)",
        pp3d.GeodesicTracer.trace_geodesic_from_vertex: "(start_vert, direction_xyz, max_iterations=None)",
        pp3d.GeodesicTracer.trace_geodesic_from_face: "(start_face, bary_coords, direction_xyz, max_iterations=None)",
        pp3d.compute_distance: "(V, F, v_ind)",
        pp3d.compute_distance_multisource: "(V, F, v_inds)",
        pp3d.marching_triangles: "(V, F, u, isoval=0.0)",
        pp3d.cotan_laplacian: "(V, F, denom_eps=0.0)",
        pp3d.face_areas: "(V, F)",
        pp3d.vertex_areas: "(V, F)",
        pp3d.edges: "(V, F)",
        pp3d.read_mesh: "(filename)",
        pp3d.write_mesh: "(V, F, filename, UV_coords=None, UV_type=None)",
    }
    for function, signature in expected.items():
        parameters = [p.replace(annotation=p.empty) for p in inspect.signature(function).parameters.values()]
        plain = inspect.Signature([p for p in parameters if p.name != "self"])
        assert str(plain) == signature, function


def test_heat_distances() -> None:
    sphere = meshes.sphere()
    exact = heatwalk.Mesh(*sphere).distance(0)
    for options in [{}, {"t_coef": 1.0, "use_robust": False}, {"t_coef": 2.0}]:
        distances = pp3d.MeshHeatMethodDistanceSolver(*sphere, **options).compute_distance(0)
        # The heat method's own error on a mesh of so many rings, a twentieth at most.
        assert np.abs(distances - exact).max() < 0.05 * np.pi
    both = pp3d.compute_distance_multisource(*sphere, [0, len(exact) - 1])
    assert both.min() == 0 and np.abs(both - np.minimum(exact, exact[::-1])).max() < 0.05 * np.pi
    assert np.array_equal(pp3d.compute_distance(V, F, 0), pp3d.MeshHeatMethodDistanceSolver(V, F).compute_distance(0))
    with pytest.raises(HeatwalkError, match="vertex 99 does not exist"):
        pp3d.compute_distance(V, F, 99)


def test_distances_from_curves_and_points_by_elements() -> None:
    solver = pp3d.MeshFastMarchingDistanceSolver(V, F)
    assert np.allclose(solver.compute_distance([LINE]), np.abs(V[:, 1] - 1 / 3), **CLOSE)
    # Negative on the left, with larger y.
    assert np.allclose(solver.compute_distance([LINE], sign=True), 1 / 3 - V[:, 1], **CLOSE)
    edge, of_faces = pp3d.edges(V, F), F
    for element, point in [
        ((5, []), V[5]),
        ((5,), V[5]),
        ((2, [0.25]), 0.75 * V[edge[2, 0]] + 0.25 * V[edge[2, 1]]),
        ((0, [0.7, 0.2]), np.array([0.7, 0.2, 0.1]) @ V[of_faces[0]]),
        ((3, [0.1, 0.2, 0.7]), np.array([0.1, 0.2, 0.7]) @ V[of_faces[3]]),
    ]:
        distances = solver.compute_distance([[element]])
        assert np.allclose(distances, np.linalg.norm(V - point, axis=1), **CLOSE)
    # Points that are in no face together are points, in one list or in two.
    apart = np.minimum(FAR, FAR[::-1])
    assert np.allclose(solver.compute_distance([[(0, []), (15, [])]]), apart, **CLOSE)
    started = solver.compute_distance([[(0, [])], [(15, [])]], distances=[[0.25], [0.0]])
    assert np.allclose(started, np.minimum(FAR + 0.25, FAR[::-1]), **CLOSE)
    with pytest.raises(NotImplementedError, match="curves start from the distance 0"):
        solver.compute_distance([LINE], distances=[[0.0, 0.1, 0.2, 0.3]])
    for bad in [[(99, [])], [(99, [0.5])], [(99, [0.5, 0.5])], [(0, [0.1] * 4)]]:
        with pytest.raises(HeatwalkError):
            solver.compute_distance([bad])


def test_signed_distances_have_the_signs_of_potpourri3d() -> None:
    solver = pp3d.MeshSignedHeatSolver(V, F)
    assert np.allclose(solver.compute_distance([LINE]), V[:, 1] - 1 / 3, **CLOSE)
    assert np.allclose(solver.compute_distance([LINE], [False]), np.abs(V[:, 1] - 1 / 3), **CLOSE)
    for points in [[15], [(15, [])]]:
        mixed = solver.compute_distance([LINE], points=points)
        line, point = V[:, 1] - 1 / 3, FAR[::-1]
        assert np.allclose(mixed, np.where(np.abs(line) <= point + 1e-12, line, point), **CLOSE)
    assert np.allclose(solver.compute_distance([], points=[(0, [])]), FAR, **CLOSE)
    with pytest.raises(HeatwalkError, match="ZeroSet, None, Multiple"):
        solver.compute_distance([LINE], level_set_constraint="Some")
    with pytest.raises(NotImplementedError, match="soft_level_set_weight"):
        solver.compute_distance([LINE], soft_level_set_weight=2.0)
    with pytest.raises(HeatwalkError, match="no source"):
        solver.compute_distance([])


def test_contours_are_points_on_edges() -> None:
    (curve,) = pp3d.marching_triangles(V, F, V[:, 0], 0.4)
    ends = pp3d.edges(V, F)
    points = np.array([(1 - t) * V[ends[e, 0]] + t * V[ends[e, 1]] for e, (t,) in curve])
    assert len(curve) == 7 and np.allclose(points[:, 0], 0.4) and abs(points[-1, 1] - points[0, 1]) == 1.0
    assert (np.diff(points[:, 1]) > 0).all() or (np.diff(points[:, 1]) < 0).all()
    sphere = meshes.sphere(6, 8)
    (ring,) = pp3d.MeshMarchingTrianglesSolver(*sphere).marching_triangles(sphere[0][:, 2], 0.1)
    assert ring[0] == ring[-1] and len(ring) == 17
    assert pp3d.marching_triangles(V, F, V[:, 0], 5.0) == []
    for u, words in [(V[:5, 0], "5 numbers"), (V[:, 0] * np.nan, "not a number")]:
        with pytest.raises(HeatwalkError, match=words):
            pp3d.marching_triangles(V, F, u)


def test_vectors_are_in_the_frames_that_are_told() -> None:
    sphere = meshes.sphere()
    solver = pp3d.MeshVectorHeatSolver(*sphere)
    x, y, normals = solver.get_tangent_frames()
    for one, other in [(x, y), (y, normals), (normals, x)]:
        assert np.allclose((one * other).sum(axis=1), 0, **CLOSE) and np.allclose((one * one).sum(axis=1), 1, **CLOSE)
    assert np.allclose(np.cross(x, y), normals, **CLOSE)
    assert np.allclose(normals, sphere[0], atol=0.01)
    carried = solver.transport_tangent_vector(0, [0.6, 0.8])
    assert carried.shape == (len(x), 2) and np.allclose(np.linalg.norm(carried, axis=1), 1, atol=1e-6)
    # The solution of a diffusion at its source is the vector that was put there, but for what flows back around a pole.
    assert np.allclose(carried[0], [0.6, 0.8], atol=1e-3)
    flat = pp3d.MeshVectorHeatSolver(V, F)
    fx, fy, _ = flat.get_tangent_frames()
    parallel = flat.transport_tangent_vectors([0, 15], [[1.0, 0.0], [fx[0] @ fx[15], fx[0] @ fy[15]]])
    assert np.allclose(parallel[:, :1] * fx + parallel[:, 1:] * fy, fx[0], atol=1e-6)
    log = flat.compute_log_map(5)
    assert np.allclose(log[:, :1] * fx[5] + log[:, 1:] * fy[5], V - V[5], **CLOSE)
    assert np.allclose(flat.extend_scalar([3], [2.5]), 2.5)
    with pytest.raises(HeatwalkError, match="VectorHeat, AffineLocal, AffineAdaptive"):
        flat.compute_log_map(5, "Best")
    with pytest.raises(HeatwalkError, match="two numbers"):
        flat.transport_tangent_vectors([0, 1], [[1.0, 0.0]])
    with pytest.raises(HeatwalkError, match="vertex 16 does not exist"):
        flat.transport_tangent_vector(16, [1.0, 0.0])


def test_the_connection_laplacian_leaves_parallel_vectors_of_the_plane() -> None:
    solver = pp3d.MeshVectorHeatSolver(V, F)
    matrix = solver.get_connection_laplacian()
    assert matrix.shape == (16, 16) and matrix.dtype == np.complex128 and matrix.format == "csc"
    dense = matrix.toarray()
    assert np.allclose(dense, dense.conj().T, **CLOSE) and np.linalg.eigvalsh(dense).min() > -1e-12
    x, y, _ = solver.get_tangent_frames()
    parallel = x @ [1.0, 2.0, 0.0] + 1j * (y @ [1.0, 2.0, 0.0])
    # Angles sum to 2π inside; at the boundary of a square they are scaled by potpourri3d alone.
    assert np.allclose(dense @ parallel, 0, atol=1e-10)


def test_paths_and_walks() -> None:
    solver = pp3d.EdgeFlipGeodesicSolver(V, F)
    path = solver.find_geodesic_path(0, 11)
    assert np.allclose(path[[0, -1]], V[[0, 11]]) and np.allclose(np.cross(path, V[11]), 0, **CLOSE)
    through = solver.find_geodesic_path_poly([0, 3, 15])
    assert np.allclose(through[[0, -1]], V[[0, 15]])
    # There is nothing between in the plane, so that it is the straight line.
    assert np.linalg.norm(np.diff(through, axis=0), axis=1).sum() == pytest.approx(np.sqrt(2))
    # In the plane every loop shrinks to a point.
    with pytest.raises(HeatwalkError, match="point"):
        solver.find_geodesic_loop([5, 6, 10])
    torus = heatwalk.shape("torus")
    loop = pp3d.EdgeFlipGeodesicSolver(torus.vertices, torus.faces).find_geodesic_loop([0, 40, 80])
    assert np.allclose(loop, torus.closed_geodesic([0, 40, 80]).points)
    tracer = pp3d.GeodesicTracer(V, F)
    # As far as the part along the surface is long.
    for direction in [(0.3, 0.1, 0.0), [0.3, 0.1, 1.0]]:
        assert np.allclose(tracer.trace_geodesic_from_vertex(5, direction)[-1], V[5] + [0.3, 0.1, 0])
    walk = tracer.trace_geodesic_from_face(0, [0.3, 0.3, 0.4], [0.3, 0.1, 2.0])
    start = np.array([0.3, 0.3, 0.4]) @ V[F[0]]
    assert np.allclose(walk[[0, -1]], [start, start + [0.3, 0.1, 0]])
    for call in [lambda: tracer.trace_geodesic_from_vertex(99, [1, 0, 0]), lambda: tracer.trace_geodesic_from_face(99, [1, 0, 0], [1, 0, 0])]:
        with pytest.raises(HeatwalkError, match="99 does not exist"):
            call()


def test_areas_edges_and_weights() -> None:
    assert np.allclose(pp3d.face_areas(V, F), 1 / 18)
    assert pp3d.vertex_areas(V, F).sum() == pytest.approx(1) and pp3d.vertex_areas(V, F)[5] == pytest.approx(1 / 9)
    edges = pp3d.edges(V, F)
    assert edges.shape == (33, 2) and edges[:3].tolist() == [[0, 1], [1, 5], [5, 0]] and edges.dtype == np.int64
    laplacian = pp3d.cotan_laplacian(V, F)
    assert laplacian.format == "csr" and np.allclose(laplacian @ np.ones(16), 0, **CLOSE)
    # The energy of a function of slope 1 on a square of area 1.
    assert V[:, 0] @ (laplacian @ V[:, 0]) == pytest.approx(1)
    flat = np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]])
    assert np.isfinite(pp3d.cotan_laplacian(flat, np.array([[0, 1, 2]]), denom_eps=1e-6).toarray()).all()
    for bad_v, bad_f in [(V[:, :2], F), (V, F[:, :2]), (V, F + 1), (V, F.astype(float))]:
        with pytest.raises(ValueError, match="V|F"):
            pp3d.edges(bad_v, bad_f)


def test_files_are_written_as_they_are_read(tmp_path: Path) -> None:
    path = tmp_path / "grid.obj"
    pp3d.write_mesh(V, F, str(path))
    vertices, faces = pp3d.read_mesh(path)
    assert np.array_equal(vertices, V) and np.array_equal(faces, F)
    for kind, count in [("per-vertex", 16), ("per-face", 18), ("per-corner", 54)]:
        uv = np.random.default_rng(1).random((count, 2))
        pp3d.write_mesh(V, F, path, uv, kind)
        assert np.array_equal(pp3d.read_mesh(str(path))[1], F) and path.read_text().count("vt ") == count
        with pytest.raises(HeatwalkError, match=f"{kind} it is"):
            pp3d.write_mesh(V, F, path, uv[1:], kind)
    with pytest.raises(HeatwalkError, match="per-vertex, per-face, per-corner"):
        pp3d.write_mesh(V, F, path, V[:, :2], "per-edge")
    with pytest.raises(HeatwalkError, match=".obj"):
        pp3d.write_mesh(V, F, tmp_path / "grid.ply")
    with pytest.raises(OSError, match="missing"):
        pp3d.read_mesh("missing.obj")


def test_what_is_missing_says_so() -> None:
    for name in ["PolygonMeshHeatSolver", "PointCloudLocalTriangulation", "read_polygon_mesh"]:
        with pytest.raises(NotImplementedError, match=f"{name} is not in Heatwalk; "):
            getattr(pp3d, name)(1)


def test_pygeodesic(tmp_path: Path) -> None:
    algorithm = geodesic.PyGeodesicAlgorithmExact(V, F)
    length, path = algorithm.geodesicDistance(0, 11)
    # From the target to the source.
    assert length == pytest.approx(np.linalg.norm(V[11])) and np.allclose(path[[0, -1]], V[[11, 0]])
    assert algorithm.geodesicDistance(3, 3)[0] == 0.0
    distances, nearest = algorithm.geodesicDistances(np.array([0, 15]), np.array([3, 5, 15]))
    assert np.allclose(distances, [1, np.sqrt(2) / 3, 0]) and nearest.tolist()[1:] == [0, 1] and nearest.dtype == np.int32
    assert np.allclose(algorithm.geodesicDistances(None, None)[0], FAR, **CLOSE)
    assert np.allclose(algorithm.geodesicDistances()[0], FAR, **CLOSE)
    near, of = algorithm.geodesicDistances([0], None, 0.5)
    assert np.array_equal(np.isinf(near), FAR > 0.5) and (of[FAR > 0.5] == -1).all()
    two = geodesic.PyGeodesicAlgorithmExact(np.concatenate([V, V + 5]), np.concatenate([F, F + 16]))
    length, path = two.geodesicDistance(0, 20)
    assert length == np.inf and path.shape == (0, 3)
    for call in [lambda: algorithm.geodesicDistance(0, 99), lambda: algorithm.geodesicDistance(-1, 0), lambda: algorithm.geodesicDistances([99])]:
        with pytest.raises(HeatwalkError, match="does not exist"):
            call()
    file = tmp_path / "mesh.txt"
    file.write_text("3 1\n0 0 0\n1 0 0\n0\t1 0\n0 1 2\n")
    points, faces = geodesic.read_mesh_from_file(file)
    assert points.shape == (3, 3) and faces.tolist() == [[0, 1, 2]]
    file.write_text("3 1\n0 0 0\n")
    with pytest.raises(HeatwalkError, match="two counts"):
        geodesic.read_mesh_from_file(file)


def test_gdist() -> None:
    sources, targets = np.array([0], dtype=np.int32), np.array([3, 15], dtype=np.int32)
    triangles = F.astype(np.int32)
    assert np.allclose(gdist.compute_gdist(V, triangles), FAR, **CLOSE)
    assert np.allclose(gdist.compute_gdist(V, triangles, sources, targets), FAR[[3, 15]], **CLOSE)
    assert np.allclose(gdist.compute_gdist(V, triangles, sources, targets, 0.5), FAR[[3, 15]], **CLOSE)
    near = gdist.compute_gdist(V, triangles, source_indices=sources, max_distance=0.5)
    assert np.allclose(near[FAR <= 0.5], FAR[FAR <= 0.5], **CLOSE) and np.isinf(near[FAR > 0.5]).all()
    assert np.allclose(gdist.compute_gdist(V, triangles + 1, is_one_indexed=True), FAR, **CLOSE)
    between = np.linalg.norm(V[:, None] - V[None], axis=2)
    matrix = gdist.local_gdist_matrix(V, triangles, max_distance=0.5)
    assert matrix.format == "csc" and np.allclose(matrix.toarray(), np.where(between <= 0.5, between, 0), **CLOSE)
    assert gdist.local_gdist_matrix(V, triangles).nnz == 240
    # Distances that are the limit up to rounding, both ways.
    wide = meshes.grid(10, size=2.0)
    matrix = gdist.local_gdist_matrix(*wide, max_distance=1.0)
    apart = np.linalg.norm(wide[0][:, None] - wide[0][None], axis=2)
    assert matrix.nnz == ((apart > 0) & (apart < 1 + 1e-9)).sum() and matrix.max() == 1.0
    assert abs(matrix - matrix.T).max() < 1e-12
    some = gdist.distance_matrix_of_selected_points(V, triangles, np.array([2, 5, 10]))
    assert some.nnz == 6 and some[5, 2] == pytest.approx(between[5, 2])
    with pytest.raises(HeatwalkError, match="vertex 99"):
        gdist.compute_gdist(V, triangles, sources, np.array([99]))
    with pytest.raises(HeatwalkError, match="holds -1"):
        gdist.compute_gdist(V, triangles, np.array([-1]))
    with pytest.raises(HeatwalkError, match="dtype float64"):
        gdist.distance_matrix_of_selected_points(V, triangles, [0.5])
