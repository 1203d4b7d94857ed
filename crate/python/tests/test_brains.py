"""Files of brains, against nibabel."""

from __future__ import annotations

from pathlib import Path

import heatwalk
import meshes
import nibabel
import numpy as np
import pytest
from heatwalk import HeatwalkError

GIFTI = nibabel.gifti
POINTSET, TRIANGLE = "NIFTI_INTENT_POINTSET", "NIFTI_INTENT_TRIANGLE"


def written_gifti(path: Path, V: meshes.Floats, F: meshes.Integers, encoding: str = "GIFTI_ENCODING_B64GZ", endian: str = "little") -> Path:
    """A surface as nibabel writes it, with a transform that is not to be applied."""
    space = GIFTI.GiftiCoordSystem(1, 3, np.diag([2.0, 2.0, 2.0, 1.0]))
    order = ">" if endian == "big" else "<"
    arrays = [
        GIFTI.GiftiDataArray(V.astype(order + "f4"), POINTSET, "NIFTI_TYPE_FLOAT32", encoding, endian, space),
        GIFTI.GiftiDataArray(F.astype(order + "i4"), TRIANGLE, "NIFTI_TYPE_INT32", encoding, endian),
    ]
    nibabel.save(GIFTI.GiftiImage(darrays=arrays), path)
    return path


@pytest.mark.parametrize("encoding", ["GIFTI_ENCODING_ASCII", "GIFTI_ENCODING_B64BIN", "GIFTI_ENCODING_B64GZ"])
@pytest.mark.parametrize("endian", ["little", "big"])
def test_gifti_surfaces_are_what_nibabel_reads(tmp_path: Path, encoding: str, endian: str) -> None:
    path = written_gifti(tmp_path / "lh.surf.gii", *meshes.sphere(), encoding, endian)
    positions, triangles = nibabel.load(path).agg_data()
    mesh = heatwalk.read(path)
    # Of text, more digits are kept than nibabel keeps.
    assert np.array_equal(mesh.vertices.astype(np.float32), positions) and np.array_equal(mesh.faces, triangles)
    assert mesh.unit == "mm"
    assert np.array_equal(heatwalk.read(path.read_bytes(), name="lh.gii").faces, triangles)


def test_freesurfer_surfaces_are_what_nibabel_reads(tmp_path: Path) -> None:
    V, F = meshes.sphere()
    volume = {
        "head": np.array([2, 0, 20]),
        "valid": "1  # volume info valid",
        "filename": "a.mgz",
        "volume": np.array([256, 256, 256]),
        "voxelsize": np.ones(3),
        "xras": np.array([-1.0, 0.0, 0.0]),
        "yras": np.array([0.0, 0.0, -1.0]),
        "zras": np.array([0.0, 1.0, 0.0]),
        "cras": np.array([5.0, 6.0, 7.0]),
    }
    for name in ["lh.pial", "lh.white", "rh.inflated", "rh.sphere", "lh.sphere.reg"]:
        path = tmp_path / name
        nibabel.freesurfer.write_geometry(path, V, F, "by hand", volume)
        positions, triangles = nibabel.freesurfer.read_geometry(path)
        mesh = heatwalk.read(path)
        assert np.array_equal(mesh.vertices, positions) and np.array_equal(mesh.faces, triangles)
        assert mesh.unit == "mm"


def test_files_without_a_surface_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "lh.shape.gii"
    values = GIFTI.GiftiDataArray(np.zeros(5, np.float32), "NIFTI_INTENT_SHAPE", "NIFTI_TYPE_FLOAT32")
    nibabel.save(GIFTI.GiftiImage(darrays=[values]), path)
    with pytest.raises(HeatwalkError, match="no surface in it"):
        heatwalk.read(path)


def test_values_are_what_nibabel_reads(tmp_path: Path) -> None:
    V, F = meshes.grid(4)
    V = np.concatenate([V, [[9.0, 9, 9]]])
    mesh = heatwalk.Mesh(V, F)
    rows = np.stack([mesh.distance(0), mesh.distance(7)]).astype(np.float32)
    assert rows[0, -1] == np.inf
    for ending, intent in [("shape.gii", "NIFTI_INTENT_SHAPE"), ("func.gii", "NIFTI_INTENT_NONE")]:
        path = tmp_path / f"lh.{ending}"
        mesh.write_values(path, rows)
        image = nibabel.load(path)
        assert np.array_equal(image.agg_data(), rows)
        assert {array.intent for array in image.darrays} == {nibabel.nifti1.intent_codes.code[intent]}
        assert image.darrays[1].meta["Name"] == "1"
    mesh.write_values(tmp_path / "lh.mgh", rows)
    volume = nibabel.load(tmp_path / "lh.mgh")
    assert volume.shape == (26, 1, 1, 2) and np.array_equal(volume.get_fdata()[:, 0, 0].T, rows)
    assert np.isfinite(volume.affine).all()
    mesh.write_values(tmp_path / "lh.distance.curv", rows[1])
    assert np.array_equal(nibabel.freesurfer.read_morph_data(tmp_path / "lh.distance.curv"), rows[1])
    for name, values, code in [
        ("lh.curv", rows, "bad-shape"),
        ("lh.mgh", rows[:, :5], "bad-shape"),
        ("lh.mgh", rows[:0], "bad-shape"),
        ("lh.gii", rows[0], "unknown-format"),
        ("lh.mgh", rows.astype(str), "bad-dtype"),
    ]:
        with pytest.raises(HeatwalkError) as caught:
            mesh.write_values(tmp_path / name, values)
        assert caught.value.code == code, str(caught.value)
    with pytest.raises(OSError, match="cannot write"):
        mesh.write_values(tmp_path / "no" / "such.mgh", rows)


NAMES = ["unknown", "left", "right", "medial_wall", "none here"]


def grid_labels() -> tuple[meshes.Floats, meshes.Integers, meshes.Integers]:
    """A square, and what its vertices are called: a wall in the middle between left and right, and some without a name."""
    V, F = meshes.grid(10)
    labels = np.select([V[:, 1] > 0.85, V[:, 0] < 0.25, V[:, 0] > 0.75], [0, 1, 2], default=-1)
    labels[np.isclose(V[:, 0], 0.5) & (V[:, 1] < 0.85)] = 3
    return V, F, labels


def test_labels_are_what_nibabel_writes(tmp_path: Path) -> None:
    _, _, labels = grid_labels()
    table = np.array([[9 * k + 1, 20 + k, 250 - k, 0, 0] for k in range(len(NAMES))])
    nibabel.freesurfer.write_annot(tmp_path / "lh.annot", labels, table, NAMES, fill_ctab=True)
    annot, _, names = nibabel.freesurfer.read_annot(tmp_path / "lh.annot")
    read = heatwalk.read_labels(tmp_path / "lh.annot")
    assert read.names == NAMES == [name.decode() for name in names]
    assert np.array_equal(read.labels, annot) and np.array_equal(read.labels, labels)
    assert np.array_equal(read.parcels, np.where(labels == 0, -1, labels))

    image = GIFTI.GiftiImage()
    for key, name in enumerate(NAMES):
        label = GIFTI.GiftiLabel(10 * key, 0.1, 0.2, 0.3, 1.0)
        label.label = name
        image.labeltable.labels.append(label)
    keys = np.where(labels < 0, 99, 10 * labels).astype(np.int32)
    image.add_gifti_data_array(GIFTI.GiftiDataArray(keys, "NIFTI_INTENT_LABEL", "NIFTI_TYPE_INT32"))
    nibabel.save(image, tmp_path / "lh.label.gii")
    again = heatwalk.read_labels(tmp_path / "lh.label.gii")
    assert again.names == NAMES and np.array_equal(again.labels, labels)
    with pytest.raises(HeatwalkError, match="no labels in it"):
        heatwalk.read_labels(written_gifti(tmp_path / "lh.surf.gii", *meshes.grid(2)))
    with pytest.raises(FileNotFoundError):
        heatwalk.read_labels(tmp_path / "missing.annot")


def test_parcels_have_mean_and_least_distances() -> None:
    V, F, labels = grid_labels()
    of = heatwalk.Labels(NAMES, labels, np.where(labels == 0, -1, labels))
    mesh = heatwalk.Mesh(V, F)
    exact = mesh.matrix(method="exact")
    for between, reduce in (("mean", np.mean), ("minimum", np.min)):
        found = mesh.parcel_matrix(of.parcels, between, "exact", threads=2)  # type: ignore[arg-type]
        assert found.shape == (4, 4) and np.isinf(found[0]).all() and np.isinf(found[:, 0]).all()
        for a in range(1, 4):
            for b in range(1, 4):
                expected = reduce(exact[np.ix_(of.parcels == a, of.parcels == b)])
                assert found[a, b] == pytest.approx(expected, rel=1e-12, abs=1e-12)
        assert np.array_equal(found, mesh.parcel_matrix(of.parcels, between, "exact", threads=1))  # type: ignore[arg-type]
    for parcels, between, code in [
        (labels[:5], "mean", "bad-shape"),
        (labels * 1.5, "mean", "bad-dtype"),
        (labels, "median", "unknown-choice"),
        (np.where(labels < 0, 10**6, labels), "mean", "bad-parameter"),
    ]:
        with pytest.raises(HeatwalkError) as caught:
            mesh.parcel_matrix(parcels, between)  # type: ignore[arg-type]
        assert caught.value.code == code, str(caught.value)


def test_labels_are_sources_and_walls() -> None:
    V, F, labels = grid_labels()
    of = heatwalk.Labels(NAMES, labels, labels)
    left = of.vertices("left")
    assert (V[left, 0] < 0.25).all() and len(of.vertices("none here")) == 0
    with pytest.raises(HeatwalkError, match="there is no label 'top'"):
        of.vertices("top")
    free = heatwalk.Mesh(V, F).distance(left, "exact")
    walled = heatwalk.Mesh(V, F, walls=of.walls(F, "medial_wall"))
    around = walled.distance(left, "exact")
    right = of.vertices("right")
    assert np.isinf(around[of.vertices("medial_wall")]).all()
    assert np.isfinite(around[right]).all() and around[right[0]] > free[right[0]] + 0.5
    # What is inside of walls is in no parcel.
    found = walled.parcel_matrix(labels, "minimum", "exact")
    assert np.isinf(found[3]).all() and np.isfinite(found[1, 2])
