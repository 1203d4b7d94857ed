"""Paths, walks, directions, curves, samples: against what is known in the plane and on the sphere."""

from __future__ import annotations

import heatwalk
import meshes
import numpy as np
import pytest
from heatwalk import HeatwalkError

# Rounding of some hundred additions.
CLOSE = {"atol": 1e-10, "rtol": 0}


@pytest.fixture(scope="module")
def flat() -> heatwalk.Mesh:
    return heatwalk.Mesh(*meshes.grid(12))


@pytest.fixture(scope="module")
def ball() -> heatwalk.Mesh:
    return heatwalk.Mesh(*meshes.sphere())


def on_faces(mesh: heatwalk.Mesh, faces: meshes.Integers, weights: meshes.Floats) -> meshes.Floats:
    return np.einsum("ij,ijk->ik", weights, mesh.vertices[mesh.faces[faces]])


@pytest.mark.parametrize("kind", ["straight", "exact"])
def test_paths_in_the_plane_are_straight_and_tied_to_the_mesh(flat: heatwalk.Mesh, kind: str) -> None:
    path = flat.path(2, (250, (0.2, 0.3, 0.5)), kind=kind)
    start, end = flat.vertices[2], np.array([0.2, 0.3, 0.5]) @ flat.vertices[flat.faces[250]]
    assert np.allclose(path.points[0], start, **CLOSE) and np.allclose(path.points[-1], end, **CLOSE)
    assert path.length == pytest.approx(np.linalg.norm(end - start), abs=1e-12) and path.cost == path.length
    assert np.allclose(np.cross(path.points - start, end - start), 0, **CLOSE)
    assert np.allclose(on_faces(flat, path.faces, path.weights), path.points, **CLOSE)
    assert len(path.points) > 5 and path.faces.dtype == np.int64


def test_paths_descend_heat_too(ball: heatwalk.Mesh) -> None:
    down = ball.path(0, 700, "heat", "descent")
    straight = ball.path(0, 700, "heat")
    exact = ball.path(0, 700, kind="exact")
    # What descends a field of heat is longer than the shortest by some hundredths.
    assert exact.length <= straight.length + 1e-12 <= down.length + 2e-12 <= 1.1 * exact.length
    assert exact.length == pytest.approx(ball.distance(0)[700], abs=1e-12)
    with pytest.raises(HeatwalkError, match="descent, straight, exact"):
        ball.path(0, 700, kind="short")


def test_paths_between_what_is_not_joined_are_refused() -> None:
    V, F = meshes.cube()
    two = heatwalk.Mesh(np.concatenate([V, V + 5]), np.concatenate([F, F + 8]))
    for kind in ["straight", "descent", "exact"]:
        with pytest.raises(HeatwalkError) as caught:
            two.path(0, 8, kind=kind)
        assert caught.value.code == "unreachable"
    there = two.path(3, 3)
    assert len(there.points) == 1 and there.length == 0.0


def test_walks_go_straight_on_over_edges() -> None:
    mesh = heatwalk.Mesh(*meshes.cube())
    # From the middle of the side x = 0 upward over the top.
    walk = mesh.walk([0.0, 0.5, 0.5], [0, 0, 1], 1.0)
    assert walk.length == pytest.approx(1.0) and not walk.at_boundary
    assert np.allclose(walk.points[-1], [0.5, 0.5, 1], **CLOSE) and np.allclose(walk.direction, [1, 0, 0], **CLOSE)
    flat = heatwalk.Mesh(*meshes.grid(3))
    over = flat.walk(5, [1.0, 0.5, 7.0], 10.0)
    assert over.at_boundary and over.points[-1][0] == pytest.approx(1.0)
    assert flat.walk(0, [1, 1, 0], 0.5, face=0).length == pytest.approx(0.5)
    for direction, words in [([0, 0, 1], "square"), ([0, 0, 0], "direction"), ([np.nan, 0, 1], "direction")]:
        with pytest.raises(HeatwalkError, match=words):
            flat.walk(5, direction, 1.0)
    with pytest.raises(HeatwalkError, match=r"direction has the shape \[2\]"):
        flat.walk(5, [0, 1], 1.0)
    with pytest.raises(HeatwalkError, match="length"):
        flat.walk(5, [1, 0, 0], -1.0)
    with pytest.raises(HeatwalkError, match="triangle 99"):
        flat.walk(5, [1, 0, 0], 1.0, face=99)


def test_log_maps_of_the_plane_are_the_plane(flat: heatwalk.Mesh) -> None:
    map = flat.log_map(84, [0.0, 2.0, 0.0])
    offset = flat.vertices - flat.vertices[84]
    assert np.allclose(map.coordinates, np.column_stack([offset[:, 1], -offset[:, 0]]), **CLOSE)
    assert np.allclose(map.axes, [[0, 1, 0], [-1, 0, 0]], **CLOSE)
    assert np.allclose(map.distances, np.linalg.norm(map.coordinates, axis=1), **CLOSE)
    assert np.allclose(flat.log_map(84).axes, [[1, 0, 0], [0, 1, 0]], **CLOSE)
    for method in ["propagation", "heat"]:
        other = flat.log_map(84, [0.0, 2.0, 0.0], method)
        assert np.allclose(other.coordinates, map.coordinates, atol=1e-6)
        assert np.allclose(other.axes, map.axes, **CLOSE)
    with pytest.raises(HeatwalkError, match="log maps are not made by auto; choose one of exact, propagation, heat"):
        flat.log_map(84, None, "auto")


def test_loops_go_around_a_torus() -> None:
    torus = heatwalk.shape("torus")
    held = torus.loop([0, 40, 80])
    assert np.allclose(held.points[0], held.points[-1]) and held.length > 0
    free = torus.closed_geodesic([0, 40, 80])
    assert np.allclose(free.points[0], free.points[-1]) and free.length <= held.length * (1 + 1e-12)
    handles = torus.handle_loops()
    assert len(handles) == 2 and handles[0].length <= handles[1].length
    assert handles[0].length == pytest.approx(torus.loop(0).length, rel=0.05)
    ball = heatwalk.shape("icosphere")
    assert ball.handle_loops() == []
    for shrinking in [lambda: ball.loop([0]), lambda: ball.closed_geodesic([0, 1, 2])]:
        with pytest.raises(HeatwalkError, match="point"):
            shrinking()


def test_bezier_curves_of_the_plane_are_polynomials(flat: heatwalk.Mesh) -> None:
    ends = flat.vertices[[0, 40, 84]]
    curve = flat.bezier([0, 40, 84])
    assert np.allclose(curve.points[[0, -1]], ends[[0, 2]], **CLOSE)
    t = np.linspace(0, 1, 2001)[:, None]
    samples = (1 - t) ** 2 * ends[0] + 2 * t * (1 - t) * ends[1] + t**2 * ends[2]
    assert curve.length == pytest.approx(np.linalg.norm(np.diff(samples, axis=0), axis=1).sum(), rel=1e-3)


def test_vectors_are_carried_along_the_surface(flat: heatwalk.Mesh, ball: heatwalk.Mesh) -> None:
    for method in ["exact", "heat"]:
        carried = flat.transport(84, [3.0, 4.0, 5.0], method)
        assert np.allclose(carried, [3, 4, 0], atol=1e-6)
    tangent = ball.transport([0, len(ball.vertices) - 1], [[1, 0, 0], [0, 2, 0]], "heat")
    assert tangent.shape == ball.vertices.shape
    assert np.linalg.norm(tangent[0]) == pytest.approx(1, rel=0.01)
    assert np.linalg.norm(tangent[-1]) == pytest.approx(2, rel=0.01)
    for vectors, method, code in [
        ([[1, 0, 0]], "exact", "bad-shape"),
        ([[0, 0, 1], [1, 0, 0]], "exact", "bad-parameter"),
        ([[0, 0, 1], [1, 0, 0]], "heat", "bad-parameter"),
        ([[1, 0, 0], [1, 0, 0]], "auto", "unknown-choice"),
        ([[1, 0], [1, 0]], "exact", "bad-shape"),
    ]:
        with pytest.raises(HeatwalkError) as caught:
            ball.transport([0, len(ball.vertices) - 1], vectors, method)
        assert caught.value.code == code


def test_numbers_are_extended_from_the_nearest_place(ball: heatwalk.Mesh) -> None:
    last = len(ball.vertices) - 1
    values = ball.extend([0, last], [1.0, 3.0])
    near = ball.cells([0, last]).nearest
    # Across the middle they go over into each other within some edges.
    far_from_middle = np.abs(ball.vertices[:, 2]) > 0.3
    assert np.allclose(values[far_from_middle], np.where(near == 0, 1.0, 3.0)[far_from_middle], atol=0.01)


def test_distance_from_curves_is_that_from_all_of_their_points(flat: heatwalk.Mesh) -> None:
    V = flat.vertices
    middle = [int(v) for v in np.flatnonzero(V[:, 1] == 0.5)]
    expected = np.abs(V[:, 1] - 0.5)
    for curves in [middle, [middle], [middle[::4], middle[::-3]], V[middle], np.array(middle), [middle[0], (int(flat.faces.shape[0] // 2), (1.0, 0.0, 0.0)), middle[-1]]]:
        distances = flat.curve_distance(curves)
        if curves is not None and len(curves) == 3:
            assert distances.shape == (169,)
            continue
        assert np.allclose(distances, expected, **CLOSE)
    signed = flat.signed_distance([middle])
    # Toward x, so that larger y is on the left.
    assert np.allclose(signed, 0.5 - V[:, 1], **CLOSE)
    border = np.minimum.reduce([V[:, 0], V[:, 1], 1 - V[:, 0], 1 - V[:, 1]])
    assert np.allclose(flat.curve_distance("boundary"), border, **CLOSE)


def test_closed_curves_have_an_inside(flat: heatwalk.Mesh) -> None:
    V = flat.vertices
    corners = [int(np.flatnonzero(np.all(np.isclose(V[:, :2], c), axis=1))[0]) for c in [(0.25, 0.25), (0.75, 0.25), (0.75, 0.75), (0.25, 0.75)]]
    inside = (np.abs(V[:, :2] - 0.5) < 0.25 - 1e-9).all(axis=1)
    for curves, options in [([corners], {"closed": True}), ([[*corners, corners[0]]], {}), (corners, {"closed": True, "sign": "heat"})]:
        signed = flat.signed_distance(curves, **options)
        assert np.array_equal(signed < -1e-9, inside)
        assert np.allclose(np.abs(signed), flat.curve_distance([corners], closed=True), **CLOSE)
    for curves, words in [([], "source"), ([[3]], "two different places"), ("edge", "place"), (3, "no list"), ([[0, 999]], "vertex 999")]:
        with pytest.raises(HeatwalkError, match=words):
            flat.signed_distance(curves)
    with pytest.raises(HeatwalkError, match="auto, nearest, heat"):
        flat.signed_distance([corners], sign="left")
    with pytest.raises(HeatwalkError, match="no boundary"):
        heatwalk.Mesh(*meshes.cube()).curve_distance("boundary")


def test_isolines_are_curves_on_faces(flat: heatwalk.Mesh) -> None:
    values = flat.vertices[:, 0]
    first, second = flat.isolines(values, [0.7, 0.31])
    assert (first.value, second.value) == (0.31, 0.7)
    assert first.length == pytest.approx(1.0) and first.enclosed_area == pytest.approx(0.31)
    (curve,) = second.curves
    assert not curve.is_closed and np.allclose(curve.points[:, 0], 0.7) and len(curve.faces) == len(curve.points) - 1
    assert len(flat.isolines(values, count=3)) == 3 and len(flat.isolines(values, spacing=0.3)) == 3
    around = heatwalk.Mesh(*meshes.sphere())
    (ring,) = around.isolines(around.distance(0), [1.0])
    assert ring.curves[0].is_closed and ring.length == pytest.approx(2 * np.pi * np.sin(1), rel=0.01)
    for options, words in [({}, "one of"), ({"levels": [1.0], "count": 2}, "one of"), ({"levels": [np.nan]}, "finite")]:
        with pytest.raises(HeatwalkError, match=words):
            flat.isolines(values, **options)
    with pytest.raises(HeatwalkError, match="169"):
        flat.isolines(values[:5], [0.5])
    with pytest.raises(HeatwalkError):
        flat.isolines(values * np.nan, [0.5])


def test_cells_tell_the_nearest_source(flat: heatwalk.Mesh) -> None:
    sources = [0, 12, 156]
    cells = flat.cells(sources)
    each = np.stack([flat.distance(source) for source in sources])
    assert np.allclose(cells.distances, each.min(axis=0), **CLOSE)
    assert np.allclose(each[cells.nearest, np.arange(169)], cells.distances, **CLOSE)
    V, F = meshes.cube()
    two = heatwalk.Mesh(np.concatenate([V, V + 5]), np.concatenate([F, F + 8]))
    assert (two.cells([0]).nearest[8:] == -1).all()


def test_samples_are_spread(flat: heatwalk.Mesh) -> None:
    samples = flat.sample(4)
    assert samples.vertices is not None and set(samples.vertices) == {0, 12, 156, 168}
    assert samples.covering_radius == pytest.approx(np.sqrt(0.5))
    assert np.array_equal(samples.points, flat.vertices[samples.vertices])
    assert flat.sample(1, start=84).vertices == [84]
    within = flat.sample(radius=0.2)
    assert within.covering_radius <= 0.2
    relaxed = flat.sample(4, relax=20)
    assert relaxed.vertices is None and relaxed.covering_radius < samples.covering_radius
    assert np.allclose(on_faces(flat, relaxed.faces, relaxed.weights), relaxed.points, **CLOSE)
    for options in [{}, {"count": 0}, {"radius": -1.0}, {"count": 2, "radius": 1.0}, {"count": 1, "start": 999}]:
        with pytest.raises(HeatwalkError):
            flat.sample(**options)
    with pytest.raises(HeatwalkError, match="no vertex"):
        flat.sample(3, start=(0, (0.5, 0.25, 0.25)))


def test_means_are_between(flat: heatwalk.Mesh) -> None:
    mean = flat.mean([0, 168], [3.0, 1.0])
    assert np.allclose(mean.point, [0.25, 0.25, 0], atol=1e-6)
    assert mean.variance == pytest.approx((3 * 0.125 + 1.125) / 4)
    assert np.allclose(flat.distance(mean.place), np.linalg.norm(flat.vertices - mean.point, axis=1), atol=1e-6)
    assert np.allclose(flat.mean([0, 12, 156, 168]).point, [0.5, 0.5, 0], atol=1e-6)
    for weights in [[1.0], [0.0, 1.0], [np.nan, 1.0]]:
        with pytest.raises(HeatwalkError):
            flat.mean([0, 168], weights)
