"""Making meshes, of arrays and of files; what is refused."""

from __future__ import annotations

import copy
import gzip
import pickle
from pathlib import Path

import heatwalk
import meshes
import numpy as np
import pytest
from heatwalk import HeatwalkError

OBJ = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n"


@pytest.mark.parametrize("kind", [np.float64, np.float32, np.int32])
@pytest.mark.parametrize("order", ["C", "F"])
@pytest.mark.parametrize("index", [np.int64, np.int32, np.uint32, np.uint64, np.int8])
def test_arrays_of_any_layout_are_taken(kind: type, order: str, index: type) -> None:
    V, F = meshes.cube()
    mesh = heatwalk.Mesh(V.astype(kind, order=order), F.astype(index, order=order))
    assert np.array_equal(mesh.vertices, V) and np.array_equal(mesh.faces, F)
    assert mesh.vertices.dtype == np.float64 and mesh.faces.dtype == np.int64
    # Over two faces of the unit cube.
    assert mesh.distance(0)[7] == pytest.approx(np.sqrt(5), abs=1e-12)
    assert np.array_equal(heatwalk.Mesh(V[::-1][::-1].tolist(), F.tolist()).distance(0), mesh.distance(0))


def refused(V: object, F: object, code: str, *words: str, **options: object) -> None:
    with pytest.raises(HeatwalkError) as caught:
        heatwalk.Mesh(V, F, **options)
    assert caught.value.code == code, str(caught.value)
    for word in words:
        assert word in str(caught.value)
    assert isinstance(caught.value, ValueError)


def test_arrays_that_make_no_mesh_are_refused_with_a_sentence() -> None:
    V, F = meshes.cube()
    refused(V[:, :2], F, "bad-shape", "V has the shape [8, 2]", "(n, 3)")
    refused(V.ravel(), F, "bad-shape", "V has the shape [24]")
    refused(V, F[:, :2], "bad-shape", "F has the shape [12, 2]", "(m, 3)")
    refused([[0, 0, 0], [1, 1]], F, "bad-shape", "V is no array")
    refused(V.astype(complex), F, "bad-dtype", "complex128")
    refused(V.astype(str), F, "bad-dtype", "V has the dtype")
    refused(V.astype(object), F, "bad-dtype", "object")
    refused(None, F, "bad-shape", "V has the shape []")
    refused(V, F.astype(float), "bad-dtype", "F has the dtype float64", "integers")
    refused(V, F > 0, "bad-dtype", "bool")
    refused(V, -F, "negative-index", "F holds -1")
    refused(V, F + 1, "index-out-of-range", "triangle 2 refers to vertex 8", "8 vertices")
    refused(V, F.astype(np.uint64) + np.uint64(2**63), "index-out-of-range", str(2**63))
    refused(V, F[:0], "empty", "no triangles")
    refused(np.zeros((0, 3)), F[:0], "empty")
    refused([], [], "bad-shape")
    refused(V * 0, F, "empty", "no triangles")
    for number in [np.nan, np.inf, -np.inf]:
        bad = V.copy()
        bad[5, 1] = number
        refused(bad, F, "not-finite", "vertex 5")
    refused(V * 1e200, F, "too-far", "1e150")
    refused(V, F, "bad-parameter", "weld", weld="much")
    refused(V, F, "bad-parameter", "bridge", bridges="no")
    refused(V, F, "bad-parameter", "threads is 0", threads=0)
    refused(V, F, "bad-shape", "costs", costs=[1.0])
    refused(V, F, "bad-parameter", "cost", costs=np.zeros(12))
    refused(V, F, "no-such-triangle", "triangle 12", walls=[12])
    refused(V, F, "no-such-triangle", "triangle 99", inactive=[99])


def test_what_is_kept_at_work_is_a_copy() -> None:
    V, F = meshes.cube()
    mesh = heatwalk.Mesh(V, F)
    before = mesh.distance(0)
    V[:] = 0
    mesh.vertices[:] = 0
    assert np.array_equal(mesh.distance(0), before)


def test_triangles_are_cleaned_and_the_report_tells() -> None:
    V, F = meshes.cube()
    flipped = np.concatenate([F[:5], F[5:, ::-1], F[:1], [[0, 0, 1]]])
    mesh = heatwalk.Mesh(np.concatenate([V, [[9, 9, 9]]]), flipped)
    report = mesh.report
    assert report["duplicate_faces"] == 1 and report["degenerate_faces"] == 1 and report["flipped_faces"] in (5, 7)
    assert report["unreferenced_vertices"] == 1 and report["components"] == 1 and report["euler_characteristic"] == 2
    distances = mesh.distance(0)
    assert len(distances) == 9 and distances[8] == np.inf and np.isfinite(distances[:8]).all()
    assert np.array_equal(distances[:8], heatwalk.Mesh(V, F).distance(0))


def test_vertices_of_one_place_are_one_and_each_has_its_distance() -> None:
    V, F = meshes.grid(4)
    soup = V[F.ravel()]
    mesh = heatwalk.Mesh(soup, np.arange(len(soup)).reshape(-1, 3))
    assert np.allclose(mesh.distance(0), heatwalk.Mesh(V, F).distance(0)[F.ravel()], atol=1e-12, rtol=0)


def test_repr_and_numbers() -> None:
    mesh = heatwalk.Mesh(*meshes.grid(1))
    assert repr(mesh) == "<heatwalk.Mesh: 4 vertices, 2 faces, 1 component, 1 boundary loop>"
    assert mesh.unit is None and mesh.warnings == []
    assert mesh.mean_edge == pytest.approx((4 + np.sqrt(2)) / 5)


def test_pickles_are_the_arrays_and_options() -> None:
    V, F = meshes.grid(6)
    costs = np.linspace(1, 3, len(F))
    mesh = heatwalk.Mesh(V, F, weld=0.001, bridges="off", threads=1, costs=costs, walls=[9], inactive=[3, 4, 40])
    again = pickle.loads(pickle.dumps(mesh))
    assert np.array_equal(again.vertices, V) and np.array_equal(again.faces, F)
    assert np.array_equal(again.distance(0), mesh.distance(0))
    assert again.__getnewargs_ex__()[1].keys() == mesh.__getnewargs_ex__()[1].keys()
    assert not np.array_equal(mesh.distance(0), heatwalk.Mesh(V, F).distance(0))
    assert copy.copy(mesh) is mesh
    assert np.array_equal(copy.deepcopy(mesh).distance(0), mesh.distance(0))
    error = pickle.loads(pickle.dumps(HeatwalkError("a sentence", "a-code")))
    assert (str(error), error.code) == ("a sentence", "a-code")


def test_files_and_bytes_are_read(tmp_path: Path) -> None:
    path = tmp_path / "square.obj"
    path.write_bytes(OBJ)
    packed = tmp_path / "square.obj.gz"
    packed.write_bytes(gzip.compress(OBJ))
    for mesh in [
        heatwalk.read(path),
        heatwalk.read(str(path)),
        heatwalk.read(packed),
        heatwalk.read(OBJ, name="square.obj"),
    ]:
        assert mesh.distance(0)[3] == pytest.approx(np.sqrt(2))
    parts = heatwalk.read(OBJ.replace(b"f 2", b"g two\nf 2"), name="m.obj", parts=[1])
    assert parts.distance(1)[0] == np.inf
    assert np.array_equal(pickle.loads(pickle.dumps(parts)).distance(1), parts.distance(1))


def test_files_that_are_no_meshes_are_refused(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="missing.obj"):
        heatwalk.read(tmp_path / "missing.obj")
    with pytest.raises(OSError, match="not a file"):
        heatwalk.read(tmp_path)
    with pytest.raises(HeatwalkError, match="not a mesh format") as caught:
        heatwalk.read(b"what is this?", name="a.what")
    assert caught.value.code == "unknown-format"
    with pytest.raises(HeatwalkError) as caught:
        heatwalk.read(b"# nothing\n", name="a.obj")
    assert caught.value.code == "empty"
    with pytest.raises(TypeError, match="neither a path nor bytes"):
        heatwalk.read(5)
    with pytest.raises(HeatwalkError, match="no part 7"):
        heatwalk.read(OBJ, name="a.obj", parts=[7])
    secret = tmp_path / "secret.bin"
    secret.write_bytes(b"0" * 36)
    gltf = b'{"asset":{"version":"2.0"},"buffers":[{"uri":"%s","byteLength":36}]}' % bytes(secret)
    with pytest.raises(HeatwalkError):
        heatwalk.read(gltf, name="a.gltf")


def test_shapes_are_called_by_name() -> None:
    assert heatwalk.shape("icosphere").report["euler_characteristic"] == 2
    with pytest.raises(HeatwalkError, match="icosphere"):
        heatwalk.shape("cow")
