"""Mesh files."""

from __future__ import annotations

from os import PathLike, fspath

import numpy as np
from numpy.typing import ArrayLike

from heatwalk._answers import Floats, Integers
from heatwalk._errors import HeatwalkError
from heatwalk._heatwalk import read
from heatwalk.potpourri3d._elements import checked


def read_mesh(filename: str | PathLike[str]) -> tuple[Floats, Integers]:
    """(n, 3) floats and (m, 3) integers, the vertices and triangles of a file of any format that `heatwalk.read` takes."""
    mesh = read(filename)
    return mesh.vertices, mesh.faces


def write_mesh(
    V: ArrayLike,
    F: ArrayLike,
    filename: str | PathLike[str],
    UV_coords: ArrayLike | None = None,
    UV_type: str | None = None,
) -> None:
    """Writes an OBJ file, with texture coordinates (k, 2) "per-vertex", "per-face" or "per-corner" where these are given."""
    vertices, faces = checked(V, F)
    if not fspath(filename).lower().endswith(".obj"):
        raise HeatwalkError(f"{fspath(filename)}: meshes are written as OBJ files; end the name with .obj", "unknown-format")
    lines = ["v %.17g %.17g %.17g" % tuple(vertex) for vertex in vertices]
    corners = [[str(corner) for corner in face] for face in (faces + 1).tolist()]
    if UV_type is not None:
        numbers = _texture_numbers(faces, len(vertices), UV_type)
        uv = np.asarray(UV_coords, dtype=np.float64)
        count = int(numbers.max(initial=-1)) + 1 if UV_type != "per-vertex" else len(vertices)
        if uv.shape != (count, 2):
            raise HeatwalkError(f"UV_coords has the shape {uv.shape}; {UV_type} it is ({count}, 2)", "bad-shape")
        lines += ["vt %.17g %.17g" % tuple(place) for place in uv]
        corners = [
            [f"{corner}/{number + 1}" for corner, number in zip(face, row)] for face, row in zip(corners, numbers.tolist())
        ]
    lines += ["f " + " ".join(face) for face in corners]
    with open(filename, "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")


def _texture_numbers(faces: Integers, vertices: int, kind: str) -> Integers:
    """(m, 3), the texture coordinates of corners."""
    if kind == "per-vertex":
        return faces
    if kind == "per-face":
        return np.repeat(np.arange(len(faces))[:, None], 3, axis=1)
    if kind == "per-corner":
        return np.arange(3 * len(faces)).reshape(-1, 3)
    raise HeatwalkError(f"there is no UV_type '{kind}'; choose one of per-vertex, per-face, per-corner", "unknown-choice")
