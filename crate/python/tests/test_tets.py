"""Tetrahedra: distances and paths inside of them."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path

import heatwalk
import meshes
import numpy as np
import pytest
from heatwalk import HeatwalkError, TetMesh


def test_lines_are_straight_inside() -> None:
    V, T = meshes.block(5)
    mesh = TetMesh(V, T)
    straight = np.linalg.norm(V - V[7], axis=1)
    assert np.allclose(mesh.distance(7), straight, rtol=1e-12)
    answer = mesh.solve([7, 100])
    assert answer.method == "march" and answer.exact_below == np.inf
    assert np.allclose(answer.distances, np.minimum(straight, np.linalg.norm(V - V[100], axis=1)))
    assert np.abs(mesh.distance(7, "heat") - straight).max() < 0.15
    rows = mesh.matrix([7, 100])
    assert rows.shape == (2, len(V)) and np.array_equal(rows[0], mesh.distance(7))
    path = mesh.path(7, [0.9, 0.8, 0.7])
    assert path.length == pytest.approx(np.linalg.norm(V[7] - [0.9, 0.8, 0.7])) and path.cost == path.length
    assert np.allclose(path.points[[0, -1]], [V[7], [0.9, 0.8, 0.7]])
    assert np.allclose(mesh.boundary_distance(), np.minimum(V, 1 - V).min(axis=1))
    assert mesh.volume == pytest.approx(1) and 0.2 < mesh.mean_edge < 0.4
    assert mesh.report["tetrahedra"] == len(T) and mesh.report["components"] == 1
    assert "216 vertices, 750 tetrahedra" in repr(mesh)
    assert np.isinf(mesh.distance(7, max_distance=0.5)[straight > 0.51]).all()


def test_places_of_all_kinds() -> None:
    V, T = meshes.block(3)
    mesh = TetMesh(V, T)
    weights = (0.1, 0.2, 0.3, 0.4)
    inside = weights @ V[T[5]]
    for source in [(5, weights), inside, tuple(inside), [(5, weights)], inside[None]]:
        assert np.allclose(mesh.distance(source), np.linalg.norm(V - inside, axis=1))
    later = mesh.distance([0, 63], initial=[0.0, 0.5])
    assert np.allclose(later, np.minimum(np.linalg.norm(V, axis=1), 0.5 + np.linalg.norm(V - 1, axis=1)))


def test_the_boundary_is_a_surface() -> None:
    V, T = meshes.block(2)
    mesh = TetMesh(V, T[:, [1, 0, 2, 3]])
    surface = heatwalk.Mesh(mesh.vertices, mesh.boundary_faces)
    assert len(mesh.boundary_faces) == 48 and surface.report["euler_characteristic"] == 2
    a, b, c = (V[mesh.boundary_faces[:, corner]] for corner in range(3))
    assert ((np.cross(b - a, c - a) * (a + b + c - 1.5)).sum(axis=1) > 0).all()


def test_costs_and_walls() -> None:
    V, T = meshes.block(4)
    middle = V[T].mean(axis=1)
    slow = TetMesh(V, T, costs=np.full(len(T), 3.0))
    assert np.allclose(slow.distance(0), 3 * np.linalg.norm(V, axis=1))
    # A wall across half of the cube.
    wall = (middle[:, 0] > 0.5) & (middle[:, 0] < 0.75) & (middle[:, 1] < 0.5)
    around = TetMesh(V, T, costs=np.where(wall, np.inf, 1.0))
    end = int(np.flatnonzero((V == [1, 0, 0]).all(axis=1))[0])
    expected = np.hypot(0.5, 0.5) + 0.25 + np.hypot(0.25, 0.5)
    assert around.distance(0)[end] == pytest.approx(expected, rel=1e-9)
    assert around.path(0, end).length == pytest.approx(expected, rel=1e-9)


def test_meshes_are_copied_pickled_and_read(tmp_path: Path) -> None:
    V, T = meshes.block(2)
    mesh = TetMesh(V, T, costs=np.linspace(1, 2, len(T)))
    again = pickle.loads(pickle.dumps(mesh))
    assert np.array_equal(again.distance(0), mesh.distance(0)) and np.array_equal(again.tetrahedra, T)
    assert copy.copy(mesh) is mesh
    path = tmp_path / "block.mesh"
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(V))]
    lines += ["%.17g %.17g %.17g 0" % tuple(vertex) for vertex in V]
    lines += ["Tetrahedra", str(len(T)), *["%d %d %d %d 0" % tuple(corners + 1) for corners in T], "End"]
    path.write_text("\n".join(lines))
    read = TetMesh.read(path)
    assert np.array_equal(read.vertices, V) and np.array_equal(read.tetrahedra, T)
    (tmp_path / "tri.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    with pytest.raises(HeatwalkError, match="no tetrahedra"):
        TetMesh.read(tmp_path / "tri.off")
    with pytest.raises(FileNotFoundError):
        TetMesh.read(tmp_path / "missing.mesh")


def test_what_is_wrong_is_refused() -> None:
    V, T = meshes.block(2)
    for points, tetrahedra, costs, code in [
        (V[:, :2], T, None, "bad-shape"),
        (V, T[:, :3], None, "bad-shape"),
        (V, T.astype(float), None, "bad-dtype"),
        (V, T + 1, None, "index-out-of-range"),
        (V, T - 1, None, "negative-index"),
        (np.where(V == 0.5, np.nan, V), T, None, "not-finite"),
        (V, T[:0], None, "no-tetrahedra"),
        (V, T, [1.0], "bad-shape"),
        (V, T, np.zeros(len(T)), "bad-cost"),
    ]:
        with pytest.raises(HeatwalkError) as caught:
            TetMesh(points, tetrahedra, costs=costs)
        assert caught.value.code == code, str(caught.value)
    mesh = TetMesh(np.concatenate([V, [[2, 2, 2]]]), T)
    assert mesh.distance(0)[-1] == np.inf
    places: list[tuple[object, str]] = [
        (28, "no-such-vertex"),
        (27, "unreferenced-vertex"),
        ((99, (0.25, 0.25, 0.25, 0.25)), "no-such-tetrahedron"),
        ((0, (1.0, 1.0, 0.0, 0.0)), "bad-weights"),
        ([3.0, 0.0, 0.0], "outside"),
        ("here", "bad-place"),
        ([], "no-source"),
    ]
    for place, code in places:
        with pytest.raises(HeatwalkError) as caught:
            mesh.distance(place)  # type: ignore[arg-type]
        assert caught.value.code == code, str(caught.value)
    for options in [{"method": "exact"}, {"method": "march", "time_step": 1.0}, {"max_distance": -1.0}]:
        with pytest.raises(HeatwalkError) as caught:
            mesh.distance(0, **options)  # type: ignore[arg-type]
        assert caught.value.code == "bad-parameter", str(caught.value)
    with pytest.raises(TypeError, match="no option operator"):
        mesh.distance(0, "heat", operator="plain")  # type: ignore[call-arg]
