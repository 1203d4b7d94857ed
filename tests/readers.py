"""What numpy, trimesh and ezdxf, readers of others, find in files that the page saved: a line of JSON.

Arguments: the folder of the files.
"""

import json
import sys
from pathlib import Path

import ezdxf
import numpy
import trimesh

folder = Path(sys.argv[1])


def name(pattern):
    (file,) = folder.glob(pattern)
    return str(file)


def length(points):
    return float(numpy.linalg.norm(numpy.diff(points, axis=0), axis=1).sum())


def lengths_of_dxf(file):
    drawing = ezdxf.readfile(file)
    assert not drawing.audit().errors
    lines = list(drawing.modelspace().query("POLYLINE"))
    assert all(line.is_3d_polyline for line in lines)
    points = [[tuple(vertex.dxf.location) for vertex in line.vertices] for line in lines]
    rings = [line + line[:1] if ring.is_closed else line for line, ring in zip(points, lines)]
    return {"curves": len(lines), "closed": sum(line.is_closed for line in lines), "length": sum(map(length, rings))}


def ply(file):
    mesh = trimesh.load(file, process=False)
    data = mesh.metadata["_ply_raw"]["vertex"]["data"]
    return {"vertices": len(mesh.vertices), "triangles": len(mesh.faces), "farthest": float(data["distance"].max())}


def glb(file):
    (mesh,) = trimesh.load(file, process=False).geometry.values()
    return {"triangles": len(mesh.faces), "farthest": float(mesh.vertex_attributes["_DISTANCE"].max())}


print(
    json.dumps(
        {
            "ply": ply(name("*.distances.ply")),
            "colors": len({tuple(color) for color in trimesh.load(name("*.weights.ply"), process=False).visual.vertex_colors}),
            "glb": glb(name("*.distances.glb")),
            "npy": [float(value) for value in (lambda all: (len(all), all.max()))(numpy.load(name("*.npy")))],
            "dxf": lengths_of_dxf(name("*.isolines.dxf")),
            "strips": float(trimesh.load(name("*.strips.obj"), force="mesh", process=False).area),
            "path": sum(length(curve.vertices) for curve in trimesh.load(name("*.path.glb")).geometry.values()),
        }
    )
)
