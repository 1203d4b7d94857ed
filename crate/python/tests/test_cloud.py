"""Clouds of points: joined to a mesh, which they are."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path

import heatwalk
import heatwalk.potpourri3d as pp3d
import meshes
import numpy as np
import pytest
from heatwalk import HeatwalkError


def sphere() -> np.ndarray:
    """Points of a unit sphere, evenly spread."""
    number = np.arange(2000) + 0.5
    polar, around = np.arccos(1 - 2 * number / 2000), np.pi * (1 + 5**0.5) * number
    return np.column_stack([np.cos(around) * np.sin(polar), np.sin(around) * np.sin(polar), np.cos(polar)])


def test_a_cloud_answers_as_a_mesh() -> None:
    points = sphere()
    cloud = heatwalk.PointCloud(points)
    assert isinstance(cloud, heatwalk.Mesh)
    assert np.array_equal(cloud.vertices, points)
    assert cloud.joined == {"points": 2000, "triangles": 3996, "boundary_loops": 0, "unjoined_points": 0}
    angles = np.arccos(np.clip(points @ points[0], -1, 1))
    assert np.abs(cloud.distance(0) - angles).max() < 0.01
    mesh = heatwalk.Mesh(points, cloud.faces)
    assert np.array_equal(cloud.distance(0), mesh.distance(0))
    assert cloud.path(0, 1999).length == pytest.approx(np.pi, rel=0.01)
    assert len(cloud.sample(10).points) == 10
    assert "2000 points" in repr(cloud)
    # The other way round: normals tell which side is outside.
    turned = heatwalk.PointCloud(points, -points)
    a, b, c = (turned.vertices[turned.faces[:, corner]] for corner in range(3))
    assert ((np.cross(b - a, c - a) * a).sum(axis=1) < 0).all()


def test_clouds_are_copied_and_pickled() -> None:
    points = sphere()
    points[7] = np.nan
    cloud = heatwalk.PointCloud(points, points, bridges="off", threads=1)
    assert cloud.joined["unjoined_points"] == 1
    assert cloud.distance(0)[7] == np.inf
    again = pickle.loads(pickle.dumps(cloud))
    assert isinstance(again, heatwalk.PointCloud)
    assert np.array_equal(again.distance(0), cloud.distance(0)) and np.array_equal(again.faces, cloud.faces)
    assert copy.copy(cloud) is cloud


def test_points_that_make_no_surface_are_refused() -> None:
    line = np.column_stack([np.arange(9.0), np.zeros(9), np.zeros(9)])
    V, _ = meshes.grid(4)
    for points, normals, code in [
        (V[:2], None, "too-few-points"),
        (line, None, "points-on-lines"),
        (V[:, :2], None, "bad-shape"),
        (V, V[:3], "bad-shape"),
        (V.astype(str), None, "bad-dtype"),
    ]:
        with pytest.raises(HeatwalkError) as caught:
            heatwalk.PointCloud(points, normals)
        assert caught.value.code == code, str(caught.value)


def test_what_potpourri3d_does_with_points(tmp_path: Path) -> None:
    points = sphere()
    solver = pp3d.PointCloudHeatSolver(points)
    angles = np.arccos(np.clip(points @ points[0], -1, 1))
    assert np.abs(solver.compute_distance(0) - angles).max() < 0.05
    nearest = solver.compute_distance_multisource([0, 1999])
    assert nearest[1999] == 0 and nearest.max() < 0.6 * np.pi
    x, y, normals = solver.get_tangent_frames()
    assert np.allclose(np.cross(x, y), normals, atol=1e-9)
    assert np.abs(np.abs((normals * points).sum(axis=1)) - 1).max() < 0.01
    assert np.allclose(solver.extend_scalar([0, 5], [3.0, 3.0]), 3)
    carried = solver.transport_tangent_vector(0, [0.0, 2.0])
    assert np.allclose(np.hypot(*carried.T), 2)
    assert np.allclose(solver.transport_tangent_vectors([0], [[0.0, 2.0]]), carried)
    assert np.abs(np.hypot(*solver.compute_log_map(0).T) - angles).max() < 0.01

    # Around the middle, from west to east: the north is on the left as seen from outside.
    equator = np.flatnonzero(np.abs(points[:, 2]) < 0.02)
    equator = equator[np.argsort(np.arctan2(points[equator, 1], points[equator, 0]))]
    curve = [[*equator, equator[0]]]
    latitude = np.arcsin(points[:, 2])
    signed = solver.compute_signed_distance(curve, points)
    assert np.abs(signed - latitude).max() < 0.03
    assert np.abs(solver.compute_signed_distance(curve, -points) + latitude).max() < 0.03
    with pytest.raises(HeatwalkError, match="there is no constraint"):
        solver.compute_signed_distance(curve, points, level_set_constraint="Some")

    path = tmp_path / "points.ply"
    pp3d.write_point_cloud(points, path)
    assert np.array_equal(pp3d.read_point_cloud(path), points)
    cloud = heatwalk.read(path)
    assert isinstance(cloud, heatwalk.PointCloud) and cloud.joined["triangles"] == 3996
    text = "".join("%.17g %.17g %.17g\n" % tuple(point) for point in points).encode()
    assert np.array_equal(heatwalk.read(text, name="points.xyz").faces, cloud.faces)
    with pytest.raises(HeatwalkError) as none:
        heatwalk.read(b"0 0 0\n1 0 0\n2 0 0\n", name="line.xyz")
    assert none.value.code == "points-on-lines"
    with pytest.raises(HeatwalkError, match="PLY"):
        pp3d.write_point_cloud(points, tmp_path / "points.obj")
