"""Data sets on a cluster of two worker processes, some of which are killed."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import heatwalk
import meshes
import numpy as np
import pytest
from heatwalk import HeatwalkError

pytest.importorskip("distributed")
zarr = pytest.importorskip("zarr")

import dask.array  # noqa: E402
import heatwalk.dask  # noqa: E402
from distributed import Client, LocalCluster  # noqa: E402

ROOT = Path(__file__).parents[3]
BY_HEAT: dict[str, Any] = {"method": "heat", "exact_radius": 0.0}
# Of a block: enough blocks that a process is killed in the middle of a run.
ROWS = 12


@pytest.fixture(scope="module")
def client() -> Iterator[Client]:
    # A task that is lost twice fails: what its mesh does to workers is soon seen.
    told = {"allowed_failures": 1, "dashboard": False}
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, scheduler_kwargs=told, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        yield client


@pytest.fixture(scope="module")
def mesh() -> heatwalk.Mesh:
    return heatwalk.Mesh(*meshes.sphere(24, 48))


@pytest.fixture(scope="module")
def rows(mesh: heatwalk.Mesh) -> np.ndarray:
    """All distances, as an undisturbed process finds them."""
    return mesh.matrix(dtype="float32", **BY_HEAT)


def all_rows(mesh: heatwalk.Mesh) -> dask.array.Array:
    return heatwalk.dask.matrix(mesh, dtype="float32", rows=ROWS, **BY_HEAT)


def kill_a_worker(client: Client) -> None:
    os.kill(next(iter(client.run(os.getpid).values())), signal.SIGKILL)


def refused(code: str, work: Any) -> str:
    with pytest.raises(HeatwalkError) as caught:
        work()
    assert caught.value.code == code, caught.value
    return str(caught.value)


def test_blocks_are_rows_of_the_matrix(client: Client, mesh: heatwalk.Mesh, tmp_path: Path) -> None:
    path = tmp_path / "sphere.off"
    vertices, faces = mesh.vertices, mesh.faces
    lines = [" ".join(map(repr, map(float, vertex))) for vertex in vertices] + [f"3 {a} {b} {c}" for a, b, c in faces]
    path.write_text("\n".join(["OFF", f"{len(vertices)} {len(faces)} 0", *lines, ""]))
    places = [3, (5, (0.2, 0.3, 0.5)), [0.0, 0.6, 0.8], 7, 9]
    targets = [0, 5, 900]
    expected = mesh.matrix(places, targets, max_distance=2.0)
    for given in [mesh, (vertices, faces), path]:
        found = heatwalk.dask.matrix(given, places, targets, rows=2, max_distance=2.0)
        assert found.chunks == ((2, 2, 1), (3,)) and found.dtype == np.float64
        assert np.array_equal(found.compute(), expected)
    assert heatwalk.dask.matrix(mesh, np.array([[0.0, 0.0, 1.0]])).shape == (1, len(vertices))
    without_client = heatwalk.dask.matrix(mesh, places, targets, rows=2, max_distance=2.0)
    assert np.array_equal(without_client.compute(scheduler="synchronous"), expected)


def test_blocks_are_bounded(mesh: heatwalk.Mesh, monkeypatch: pytest.MonkeyPatch) -> None:
    assert heatwalk.dask.matrix(mesh).chunksize == (32, len(mesh.vertices))
    module = sys.modules[heatwalk.dask.matrix.__module__]
    monkeypatch.setattr(module, "BLOCK_BYTES", 10 * 8 * len(mesh.vertices))
    assert heatwalk.dask.matrix(mesh).chunksize == (10, len(mesh.vertices))


def test_a_worker_builds_the_mesh_once(client: Client) -> None:
    def count() -> None:
        from heatwalk.dask import _given

        class Counted(_given.Given):
            built = 0

        def mesh(self: Any, built: Any = _given.Given.mesh) -> Any:
            Counted.built += self._mesh is None
            return built(self)

        _given.Given.counted = Counted  # type: ignore[attr-defined]
        _given.Given.mesh = mesh  # type: ignore[method-assign]

    def built() -> int:
        from heatwalk.dask import _given

        return int(_given.Given.counted.built)  # type: ignore[attr-defined]

    client.run(count)
    heatwalk.dask.matrix(meshes.sphere(20, 40), rows=5, **BY_HEAT).compute()
    assert list(client.run(built).values()) == [1, 1]


@pytest.mark.parametrize("name", ["rows.npy", "rows.zarr"])
def test_what_a_killed_worker_had_is_done_again(
    client: Client, mesh: heatwalk.Mesh, rows: np.ndarray, tmp_path: Path, name: str
) -> None:
    killed = False

    def progress(done: float, stage: str) -> None:
        nonlocal killed
        if not killed and done > 0.2:
            kill_a_worker(client)
            killed = True

    target = tmp_path / name
    saved = heatwalk.dask.save(all_rows(mesh), target, progress=progress)
    assert killed and saved == (len(rows), 0)
    found = np.load(target, mmap_mode="r") if target.suffix == ".npy" else zarr.open_array(target, mode="r")[:]
    assert np.array_equal(found, rows) and found.dtype == rows.dtype
    assert os.listdir(tmp_path) == [name]
    assert "exists" in refused("exists", lambda: heatwalk.dask.save(all_rows(mesh), target))


def test_a_killed_run_is_finished_by_the_next(
    client: Client, mesh: heatwalk.Mesh, rows: np.ndarray, tmp_path: Path
) -> None:
    target, log = tmp_path / "rows.npy", tmp_path / "rows.npy.part.log"
    script = f"""
import heatwalk, heatwalk.dask, meshes
from distributed import Client
with Client({client.scheduler.address!r}):
    mesh = heatwalk.Mesh(*meshes.sphere(24, 48))
    heatwalk.dask.save(heatwalk.dask.matrix(mesh, dtype="float32", rows={ROWS}, **{BY_HEAT!r}), {str(target)!r})
"""
    paths = os.pathsep.join([str(Path(__file__).parent), os.environ.get("PYTHONPATH", "")])
    run = subprocess.Popen([sys.executable, "-c", script], env={**os.environ, "PYTHONPATH": paths})
    try:
        while not log.exists() or log.read_bytes().count(b"\n") < 5:
            assert run.poll() is None
            time.sleep(0.005)
        assert "another run" in refused("busy", lambda: heatwalk.dask.save(all_rows(mesh), target))
    finally:
        run.kill()
        run.wait()
    assert not target.exists()
    saved = heatwalk.dask.save(all_rows(mesh), target)
    assert 0 < saved.rows_before < saved.rows == len(rows)
    assert np.array_equal(np.load(target), rows)
    undisturbed = tmp_path / "undisturbed.npy"
    heatwalk.dask.save(all_rows(mesh), undisturbed)
    assert target.read_bytes() == undisturbed.read_bytes()


@pytest.mark.parametrize("name", ["rows.npy", "rows.zarr"])
def test_nothing_half_written_counts(client: Client, tmp_path: Path, name: str) -> None:
    mesh = heatwalk.Mesh(*meshes.sphere(20, 40))
    whole = heatwalk.dask.matrix(mesh, rows=100, **BY_HEAT)
    target, part, log = (tmp_path / (name + suffix) for suffix in ["", ".part", ".part.log"])
    stop = lambda done, stage: done < 0.5
    kept = refused("cancelled", lambda: heatwalk.dask.save(whole, target, progress=stop))
    assert re.search(r"^cancelled; [45]00 of 762 rows are finished", kept)
    first, *lines = log.read_bytes().splitlines(keepends=True)
    damaged = int(lines[1].split()[0])
    if part.is_dir():
        (part / "c" / str(damaged) / "0").unlink()
    else:
        with open(part, "r+b") as file:
            file.seek(-8 * 762 * (762 - 100 * damaged), os.SEEK_END)
            file.write(b"\xff")
    # The last line of the log was not written as a whole, and one speaks of no block.
    log.write_bytes(b"".join([first, *lines[:-1], b"99 5\n", lines[-1][:3]]))
    other = heatwalk.dask.matrix(mesh, rows=100, method="heat", exact_radius=0.5)
    assert "other options" in refused("another-matrix", lambda: heatwalk.dask.save(other, target))
    saved = heatwalk.dask.save(whole, target)
    whole_lines = sum(int(line.split()[0]) != damaged for line in lines[:-1])
    assert saved.rows_before in {100 * whole_lines, 100 * whole_lines - 38}
    found = np.load(target) if target.suffix == ".npy" else zarr.open_array(target, mode="r")[:]
    assert np.array_equal(found, mesh.matrix(**BY_HEAT))


def test_what_cannot_be_saved_is_told(client: Client, tmp_path: Path) -> None:
    mesh = heatwalk.Mesh(*meshes.cube())
    some = heatwalk.dask.matrix(mesh, rows=3)
    save = lambda array, name: lambda: heatwalk.dask.save(array, tmp_path / name)
    assert ".npy" in refused("bad-parameter", save(some, "rows.csv"))
    refused("bad-shape", save(some.rechunk((3, 2)), "rows.npy"))
    refused("bad-shape", save(some.rechunk(((2, 3, 3), (8,))), "rows.npy"))
    wrong = heatwalk.dask.matrix(mesh, [0, 1, 99], rows=1)
    assert "99" in refused("no-such-vertex", save(wrong, "wrong.npy"))
    refused("bad-parameter", lambda: heatwalk.dask.matrix(mesh, rows=0))
    refused("bad-mesh", lambda: heatwalk.dask.matrix(5))  # type: ignore[arg-type]
    with pytest.raises(OSError, match=r"nowhere"):
        heatwalk.dask.save(some, tmp_path / "nowhere" / "rows.npy")
    with pytest.raises(HeatwalkError, match=r"put the place into a list"):
        heatwalk.dask.matrix(mesh, [0.0, 0.5, 0.5])


def test_a_file_that_is_another_mesh_for_workers_is_told(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "mesh.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    rows = heatwalk.dask.matrix(path)
    path.write_text("v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n")
    assert "mesh.obj" in refused("another-mesh", rows.compute)


def longest(mesh: heatwalk.Mesh) -> float:
    return float(mesh.distance(0).max())


CORNER = (np.eye(3), np.array([[0, 1, 2]]))
FLAWED = (np.full((3, 3), np.nan), np.array([[0, 1, 2]]))


def test_a_bad_mesh_ends_nothing(client: Client, tmp_path: Path) -> None:
    cut_short = tmp_path / "short.ply"
    cut_short.write_bytes(b"ply\nformat ascii 1.0\nelement vertex 9\n")
    many = [CORNER, FLAWED, tmp_path / "missing.obj", cut_short, heatwalk.Mesh(*CORNER), 5]
    rows = sorted(heatwalk.dask.answers(many, longest), key=lambda row: row.number)
    told = lambda row: (row.number, row.path, row.value, str(row.error))
    assert list(map(told, rows)) == list(map(told, heatwalk.dask.bag(many, longest).compute()))
    assert [row.number for row in rows] == [0, 1, 2, 3, 4, 5]
    assert rows[0].value == rows[4].value == pytest.approx(2**0.5)
    assert [row.value for row in rows if row.error] == [None] * 4
    codes = [row.error.code for row in rows if row.error]
    assert codes[0] == "not-finite" and codes[1] == "file-system" and codes[3] == "bad-mesh"
    assert rows[2].path == str(tmp_path / "missing.obj") and "missing.obj" in str(rows[2].error)
    by_function = list(heatwalk.dask.answers([CORNER], lambda mesh: 1 // 0))
    assert by_function[0].error and str(by_function[0].error).startswith("ZeroDivisionError")
    assert by_function[0].error.code == "failed"
    assert heatwalk.dask.bag([CORNER, CORNER], longest).map(lambda row: row.value).sum().compute() > 2.8


def test_answers_take_no_more_meshes_than_they_need(client: Client) -> None:
    taken = 0

    def endless() -> Iterator[Any]:
        nonlocal taken
        while True:
            taken += 1
            yield CORNER

    rows = heatwalk.dask.answers(endless(), longest)
    for _ in range(10):
        assert next(rows).error is None
    rows.close()
    assert taken <= 10 + 4 * 2


def test_a_mesh_that_ends_its_workers_has_a_row(client: Client, tmp_path: Path) -> None:
    once = tmp_path / "once"

    def kill(mesh: heatwalk.Mesh) -> int:
        count = len(mesh.faces)
        is_first = count == 12 and not once.exists()
        if is_first or count == 2:
            once.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return count

    # The cube ends a worker once; what two triangles do, they do each time.
    many = [heatwalk.Mesh(*meshes.cube()), meshes.grid(1), CORNER]
    rows = sorted(heatwalk.dask.answers(many[:1], kill), key=lambda row: row.number)
    assert [row.value for row in rows] == [12] and once.exists()
    rows = sorted(heatwalk.dask.answers(many[1:], kill), key=lambda row: row.number)
    assert rows[0].error is not None and rows[0].error.code == "ended"


def test_the_extra_is_named_where_dask_is_missing() -> None:
    script = "import sys; sys.modules['distributed'] = None; import heatwalk.dask"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
    assert run.returncode == 1 and 'pip install "heatwalk[dask]"' in run.stderr


def test_the_example_of_the_document_runs(
    client: Client, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    text = (ROOT / "docs" / "datasets.md").read_text(encoding="utf-8")
    examples = re.findall(r"^```python\n(.*?)^```", text, re.M | re.S)
    # Its cluster is this one.
    monkeypatch.setattr("distributed.Client", lambda **_: client.as_current())
    monkeypatch.chdir(tmp_path)
    for example in examples:
        exec(compile(example, "datasets.md", "exec"), {"__name__": "__main__"})
    told = capsys.readouterr().out
    assert "file-system" in told and "Saved(rows=64, rows_before=0)" in told
