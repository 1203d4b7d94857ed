"""Distances and matrices."""

from __future__ import annotations

import heatwalk
import meshes
import numpy as np
import pytest
from heatwalk import HeatwalkError


@pytest.fixture(scope="module")
def flat() -> heatwalk.Mesh:
    return heatwalk.Mesh(*meshes.grid(12))


def straight(mesh: heatwalk.Mesh, point: object) -> meshes.Floats:
    return np.linalg.norm(mesh.vertices - np.asarray(point), axis=1)


@pytest.mark.parametrize(
    "sources",
    [5, np.int32(5), [5], (5,), np.array([5]), np.array(5), [np.uint8(5)]],
)
def test_in_the_plane_distance_is_straight(flat: heatwalk.Mesh, sources: object) -> None:
    distances = flat.distance(sources)
    assert distances.dtype == np.float64 and distances.shape == (169,)
    assert np.allclose(distances, straight(flat, flat.vertices[5]), atol=1e-12, rtol=0)


def test_sources_are_vertices_places_and_coordinates(flat: heatwalk.Mesh) -> None:
    corners = flat.vertices[flat.faces[20]]
    weights = (0.5, 0.25, 0.25)
    point = np.array(weights) @ corners
    expected = straight(flat, point)
    array = np.array(weights)
    for sources in [(20, weights), [(20, weights)], (np.int64(20), array), heatwalk.Place(20, weights), point, list(point), point[None]]:
        assert np.allclose(flat.distance(sources), expected, atol=1e-12, rtol=0)
    several = flat.distance([5, (20, weights), point + [0, 0, 0.01]])
    assert np.allclose(several, np.minimum(expected, straight(flat, flat.vertices[5])), atol=1e-12, rtol=0)


def test_coordinates_are_snapped_and_told_how_far(flat: heatwalk.Mesh) -> None:
    above = np.array([[0.3, 0.4, 0.05], [2.0, 0.5, 0.0]])
    snapped = flat.snap(above)
    assert np.allclose(snapped.distances, [0.05, 1.0]) and np.allclose(snapped.points, [[0.3, 0.4, 0], [1, 0.5, 0]])
    on_faces = np.einsum("ij,ijk->ik", snapped.weights, flat.vertices[flat.faces[snapped.faces]])
    assert np.allclose(on_faces, snapped.points, atol=1e-12)
    with pytest.warns(UserWarning, match="place 1 is 1 away from the surface"):
        distances = flat.distance(above)
    assert np.allclose(distances, np.minimum(*(straight(flat, point) for point in snapped.points)), atol=1e-12)
    for bad in [np.nan, np.inf, 1e300]:
        with pytest.raises(HeatwalkError, match="finite"):
            flat.distance([bad, 0.0, 0.0])


def test_initial_distances_are_where_sources_start(flat: heatwalk.Mesh) -> None:
    distances = flat.distance([0, 168], initial=[0.5, 0.0])
    expected = np.minimum(straight(flat, [0, 0, 0]) + 0.5, straight(flat, [1, 1, 0]))
    assert np.allclose(distances, expected, atol=1e-12)
    for initial, code in [([0.5], "bad-shape"), ([-1, 0], "bad-parameter"), ([np.nan, 0], "bad-parameter")]:
        with pytest.raises(HeatwalkError) as caught:
            flat.distance([0, 168], initial=initial)
        assert caught.value.code == code


@pytest.mark.parametrize(
    ("sources", "code"),
    [
        (169, "no-such-vertex"),
        (10**30, "no-such-vertex"),
        (-1, "negative-index"),
        ([0, -5], "negative-index"),
        (np.array([0, -5]), "negative-index"),
        ([], "no-source"),
        (np.zeros(0, int), "no-source"),
        (True, "bad-place"),
        ("0", "bad-place"),
        (None, "bad-place"),
        (1.5, "bad-place"),
        ([1.5], "bad-place"),
        ((288, (1, 0, 0)), "no-such-triangle"),
        ((0, (1, 1, 0)), "bad-weights"),
        ((0, (np.nan, 1, 0)), "bad-weights"),
        ((0, (1, 0)), "bad-place"),
        ((-1, (1, 0, 0)), "negative-index"),
        (np.zeros((4, 2)), "bad-shape"),
        (np.zeros((2, 3), int), "bad-dtype"),
    ],
)
def test_sources_that_are_not_there_are_refused(flat: heatwalk.Mesh, sources: object, code: str) -> None:
    with pytest.raises(HeatwalkError) as caught:
        flat.distance(sources)
    assert caught.value.code == code, str(caught.value)


def test_options_are_those_of_the_crate() -> None:
    mesh = heatwalk.Mesh(*meshes.sphere())
    exact = mesh.distance(0, "exact")
    # Chords are shorter than arcs: edges of a unit sphere's 24 rings by a thousandth.
    assert exact.max() == pytest.approx(np.pi, rel=2e-3)
    near = mesh.distance(0, max_distance=1.0)
    assert np.isinf(near[exact > 1.0]).all() and np.array_equal(near[exact <= 1.0], exact[exact <= 1.0])
    assert np.array_equal(mesh.distance(0, "propagation", windows="all"), exact)
    assert np.abs(mesh.distance(0, "propagation", windows=2) - exact).max() < 0.01 * np.pi
    for options in [{}, {"operator": "plain", "time_step": 1, "boundary": "dirichlet"}, {"solver": "cg"}, {"exact_radius": 3}]:
        heat = mesh.distance(0, "heat", **options)
        # The heat method's own error on a mesh of so many rings, a twentieth at most.
        assert np.abs(heat - exact).max() < 0.05 * np.pi
    assert not np.array_equal(mesh.distance(0, "heat", time_step=10.0), mesh.distance(0, "heat", time_step=1.0))


@pytest.mark.parametrize(
    ("method", "options", "words"),
    [
        ("fast", {}, "auto, propagation, heat, exact"),
        ("heat", {"operator": "best"}, "delaunay, plain, relocate"),
        ("heat", {"boundary": "cold"}, "neumann, dirichlet, average"),
        ("heat", {"solver": "lu"}, "cholesky, cg"),
        ("heat", {"multi_source": "all"}, "exact, summed"),
        ("heat", {"time_step": -1.0}, "positive"),
        ("heat", {"exact_radius": "near"}, "auto"),
        ("heat", {"max_distance": 1.0}, "max_distance has no effect"),
        ("auto", {"operator": "plain"}, "operator is an option of the heat method"),
        ("exact", {"windows": 2}, "windows has no effect"),
        ("auto", {"windows": 0}, "1 to 65535"),
        ("auto", {"max_distance": -1.0}, "positive"),
    ],
)
def test_unknown_choices_are_answered_with_those_there_are(
    flat: heatwalk.Mesh, method: str, options: dict[str, object], words: str
) -> None:
    with pytest.raises(ValueError, match=words):
        flat.distance(0, method, **options)


def test_unknown_names_of_options_are_type_errors(flat: heatwalk.Mesh) -> None:
    with pytest.raises(TypeError, match="there is no option t_coef; the options are windows"):
        flat.distance(0, t_coef=1.0)
    with pytest.raises(TypeError):
        flat.distance(0, windows=[1])


def test_what_nothing_reaches_is_infinitely_far() -> None:
    V, F = meshes.cube()
    two = np.concatenate([V, V + 10])
    faces = np.concatenate([F, F + 8])
    distances = heatwalk.Mesh(two, faces).distance(0)
    assert np.isfinite(distances[:8]).all() and np.isinf(distances[8:]).all()
    linked = heatwalk.Mesh(two, faces, links=1).distance(0)
    # Between the nearest corners, and over two faces of the cube at most.
    assert np.isfinite(linked).all() and linked[8] == pytest.approx(np.sqrt(5) + 9 * np.sqrt(3))


def test_costs_and_walls_are_heeded() -> None:
    V, F = meshes.grid(10)
    assert np.allclose(heatwalk.Mesh(V, F, costs=np.full(len(F), 2.0)).distance(0), 2 * heatwalk.Mesh(V, F).distance(0))
    middle = V[F].mean(axis=1)
    walls = np.flatnonzero((np.abs(middle[:, 0] - 0.55) < 0.05) & (middle[:, 1] < 0.9))
    around = heatwalk.Mesh(V, F, walls=walls).distance(0)
    end = np.flatnonzero((V[:, 0] == 1) & (V[:, 1] == 0))[0]
    assert around[end] == pytest.approx(np.hypot(0.5, 0.9) + 0.1 + np.hypot(0.4, 0.9), rel=1e-6)
    with pytest.raises(HeatwalkError) as caught:
        heatwalk.Mesh(V, F, costs=np.linspace(1, 2, len(F))).distance(0, "exact")
    assert caught.value.code == "not-exact"


def test_answers_tell_how_they_were_found(flat: heatwalk.Mesh) -> None:
    answer = flat.solve(0)
    assert answer.method == "exact" and answer.exact_below == np.inf and answer.windows > 0
    assert np.array_equal(answer.distances, flat.distance(0))
    assert flat.solve(0, "heat").method == "heat" and flat.solve(0, "heat").windows == 0


@pytest.mark.parametrize("method", ["auto", "heat"])
def test_rows_of_matrices_are_distances_for_any_number_of_threads(flat: heatwalk.Mesh, method: str) -> None:
    whole = flat.matrix(method=method, threads=1)
    assert whole.shape == (169, 169) and whole.dtype == np.float64
    assert np.array_equal(whole[17], flat.distance(17, method))
    for threads in [2, 3, None]:
        assert np.array_equal(flat.matrix(method=method, threads=threads), whole)
    some = flat.matrix([3, 140, (7, (1.0, 0.0, 0.0))], [0, 0, 168], method, dtype=np.float32)
    assert some.dtype == np.float32 and np.array_equal(some[:2], whole[[3, 140]][:, [0, 0, 168]].astype(np.float32))
    assert np.array_equal(some[2], whole[flat.faces[7, 0]][[0, 0, 168]].astype(np.float32))


def test_matrices_of_odd_sizes(flat: heatwalk.Mesh) -> None:
    assert flat.matrix([], [0, 1]).shape == (0, 2)
    assert flat.matrix([0, 1], []).shape == (2, 0)
    V, F = meshes.cube()
    loose = heatwalk.Mesh(np.concatenate([V, [[5, 5, 5]]]), F)
    matrix = loose.matrix()
    assert np.isinf(matrix[8]).all() and np.isinf(matrix[:, 8]).all() and np.isfinite(matrix[:8, :8]).all()
    assert np.allclose(matrix, matrix.T)
    with pytest.raises(HeatwalkError, match="float64, float32"):
        flat.matrix(dtype="int32")
    with pytest.raises(HeatwalkError) as caught:
        flat.matrix([0], [169])
    assert caught.value.code == "no-such-vertex"
    with pytest.raises(HeatwalkError, match="GiB"):
        flat.matrix(np.zeros(2_000_000, int), np.zeros(2_000_000, int))
