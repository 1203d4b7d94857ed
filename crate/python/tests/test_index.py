"""Indices of distances: bounds, files, what is refused."""

from __future__ import annotations

from pathlib import Path

import heatwalk
import meshes
import numpy as np
import pytest
from heatwalk import HeatwalkError


def test_bounds_hold_exact_distances() -> None:
    mesh = heatwalk.Mesh(*meshes.sphere())
    index = heatwalk.Index(mesh, threads=2)
    sources = np.arange(0, len(mesh.vertices), 50)
    exact = mesh.matrix(sources, method="exact")
    starts, ends = (pairs.ravel() for pairs in np.meshgrid(sources, np.arange(len(mesh.vertices)), indexing="ij"))
    found = index.distance(starts, ends)
    assert (found.at_least <= exact.ravel() * (1 + 1e-9)).all()
    assert (found.distances >= exact.ravel() * (1 - 1e-9)).all()
    apart = starts != ends
    assert np.mean(found.distances[apart] / exact.ravel()[apart] - 1) < 0.005
    assert (found.distances[~apart] == 0).all()
    assert index.labels > len(mesh.vertices)


def test_an_index_is_kept_in_a_file(tmp_path: Path) -> None:
    mesh = heatwalk.Mesh(*meshes.grid(12))
    index = heatwalk.Index(mesh)
    path = tmp_path / "grid.hwindex"
    index.save(path)
    again = heatwalk.Index.load(path, mesh)
    starts, ends = np.arange(169), np.arange(169)[::-1]
    assert np.array_equal(again.distance(starts, ends), index.distance(starts, ends))
    path.write_bytes(path.read_bytes()[:-9])
    for mesh_of, code in [(mesh, "malformed")]:
        with pytest.raises(HeatwalkError) as caught:
            heatwalk.Index.load(path, mesh_of)
        assert caught.value.code == code
    index.save(path)
    with pytest.raises(HeatwalkError, match="another mesh"):
        heatwalk.Index.load(path, heatwalk.Mesh(*meshes.cube()))
    with pytest.raises(FileNotFoundError):
        heatwalk.Index.load(tmp_path / "missing", mesh)
    with pytest.raises(OSError, match="cannot write"):
        index.save(tmp_path / "no" / "such")


def test_what_an_index_does_not_know_is_refused() -> None:
    V, F = meshes.grid(4)
    mesh = heatwalk.Mesh(V, F)
    index = heatwalk.Index(mesh)
    for starts, ends, code in [
        ([0], [25], "vertex-out-of-range"),
        ([0], [-1], "negative-index"),
        ([0, 1], [1], "bad-shape"),
        ([0.5], [1], "bad-dtype"),
    ]:
        with pytest.raises(HeatwalkError) as caught:
            index.distance(starts, ends)
        assert caught.value.code == code, str(caught.value)
    with pytest.raises(HeatwalkError, match="without costs"):
        heatwalk.Index(heatwalk.Mesh(V, F, costs=np.linspace(1, 2, len(F))))
    with pytest.raises(HeatwalkError) as cancelled:
        heatwalk.Index(heatwalk.Mesh(*meshes.sphere()), progress=lambda done, stage: False)
    assert cancelled.value.code == "cancelled"
    assert len(index.distance([], []).distances) == 0
