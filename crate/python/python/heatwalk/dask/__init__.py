"""Data sets on a cluster of Dask: many meshes, and matrices that are too large for one machine.

`answers` and `bag` ask a function about each of many meshes; `matrix` is a dask array of rows of distances, and `save` writes such an
array to `.npy` or `.zarr` so that a run that ended in the middle is finished by the next. What schedules and repeats is Dask.

Needs `pip install "heatwalk[dask]"`.
"""

try:
    import dask.array
    import dask.bag
    import distributed
except ImportError:
    # The cause is told as the context.
    raise ImportError('heatwalk.dask needs Dask and its workers: pip install "heatwalk[dask]"')  # noqa: B904

from heatwalk.dask._given import MeshLike
from heatwalk.dask._many import Row, answers, bag
from heatwalk.dask._matrix import matrix
from heatwalk.dask._save import Saved, save

__all__ = ["MeshLike", "Row", "Saved", "answers", "bag", "matrix", "save"]
