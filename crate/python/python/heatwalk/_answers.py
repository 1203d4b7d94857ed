"""What questions on a mesh are answered with. Faces and vertices are the caller's; lengths are in the unit of the mesh."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from heatwalk._errors import HeatwalkError

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


class Place(NamedTuple):
    """A place on a mesh, which can be a source: a face, and barycentric weights of its corners."""

    face: int
    weights: tuple[float, float, float]


class Answer(NamedTuple):
    """Distances, and how they were found."""

    distances: Floats
    """(n,), inf where nothing is reached."""
    method: str
    """What found them: "exact", "propagation" or "heat"."""
    exact_below: float
    """Distances below this are exact; inf where all are."""
    windows: int
    """Windows that crossed a face; 0 by heat."""


class Bounds(NamedTuple):
    """Distances of pairs, as an index knows them."""

    distances: Floats
    """(k,), lengths of paths, which shortest ones do not exceed; inf where none leads from one to the other."""
    at_least: Floats
    """(k,), what distances are no less than."""


class Path(NamedTuple):
    """A path on a surface, straight from point to point."""

    points: Floats
    """(k, 3), from the start to the end."""
    faces: Integers
    """(k,), the face after each point; of the last one the face before."""
    weights: Floats
    """(k, 3), barycentric weights of each point in its face."""
    length: float
    cost: float
    """What it costs: the length, where faces have no costs."""


class TetPath(NamedTuple):
    """A path inside of tetrahedra, straight from point to point."""

    points: Floats
    """(k, 3), from the start to the end."""
    length: float
    """In the unit of the mesh."""
    cost: float
    """The length, each part times what that costs."""


class Walk(NamedTuple):
    """A walk straight on."""

    points: Floats
    """(k, 3), from the start on."""
    faces: Integers
    """(k,), the face after each point; of the last one the face before."""
    weights: Floats
    """(k, 3), barycentric weights of each point in its face."""
    length: float
    direction: Floats
    """(3,), the unit vector along the walk at its end."""
    at_boundary: bool
    """Whether the surface ended before the length was walked."""


class Labels(NamedTuple):
    """What each vertex of a surface is called, such as the parcels of an atlas."""

    names: list[str]
    """Of labels, in the order of the file."""
    labels: Integers
    """(n,), the label of each vertex, an index of `names`; -1 where the file names none."""
    parcels: Integers
    """(n,), the same with -1 also for names by which programs say that there is no label: `???`, `unknown`."""

    def vertices(self, name: str) -> Integers:
        """(k,), the vertices of a label. Raises HeatwalkError where there is none of this name."""
        if name not in self.names:
            raise HeatwalkError(f"there is no label '{name}'; there are {', '.join(self.names)}", "unknown-choice")
        return np.flatnonzero(np.isin(self.labels, [label for label, own in enumerate(self.names) if own == name]))

    def walls(self, faces: Integers, name: str) -> Integers:
        """(k,), the faces, of (m, 3), with a vertex of a label: as `walls` of a `Mesh` they keep paths from crossing it."""
        return np.flatnonzero(np.isin(faces, self.vertices(name)).any(axis=1))


class LogMap(NamedTuple):
    """Directions and lengths of the shortest paths from a source."""

    coordinates: Floats
    """(n, 2), u and v, as long as the distance; NaN where nothing is reached."""
    distances: Floats
    """(n,), inf where nothing is reached."""
    axes: Floats
    """(2, 3), unit vectors in space along u and v, at the source."""


class Cells(NamedTuple):
    """What is nearest to each of several sources."""

    nearest: Integers
    """(n,), the number of the nearest source of each vertex; -1 where none is reached."""
    distances: Floats
    """(n,), inf where none is reached."""


class Samples(NamedTuple):
    """Samples spread over a surface."""

    faces: Integers
    """(k,), a face that each is on."""
    weights: Floats
    """(k, 3), barycentric weights of each in its face."""
    points: Floats
    """(k, 3), where they are."""
    vertices: Integers | None
    """(k,), the vertices that they are; None where they were moved."""
    covering_radius: float
    """How far the farthest vertex is from a sample; inf on components without one."""


class Mean(NamedTuple):
    """Where squared distances from weighted places sum to least."""

    place: Place
    point: Floats
    """(3,), where that is."""
    variance: float
    """The weighted mean of squared distances there."""


class Curve(NamedTuple):
    """A part of an isoline that is in one piece."""

    points: Floats
    """(k, 3); of a closed one, the first is not repeated at the end."""
    faces: Integers
    """The face after each point; of an open one, none after the last."""
    is_closed: bool
    length: float


class Isoline(NamedTuple):
    """All places at one value."""

    value: float
    curves: list[Curve]
    length: float
    """Of all curves."""
    enclosed_area: float
    """Of what is below the value."""


class Snapped(NamedTuple):
    """The places of a surface that are nearest to points in space."""

    faces: Integers
    """(k,)."""
    weights: Floats
    """(k, 3), barycentric weights in these faces."""
    points: Floats
    """(k, 3), where the places are."""
    distances: Floats
    """(k,), how far each is from its point."""


class TangentFrames(NamedTuple):
    """The tangent planes of vertices: unit vectors that are square to each other, right-handed."""

    x: Floats
    """(n, 3)."""
    y: Floats
    """(n, 3)."""
    normals: Floats
    """(n, 3), outward."""
