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
