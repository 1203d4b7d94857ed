"""The worked example with Ray."""

from __future__ import annotations

import sys
from pathlib import Path

import heatwalk
import numpy as np
import pytest

ray = pytest.importorskip("ray")
sys.path.insert(0, str(Path(__file__).parents[1] / "examples"))


def test_rows_on_a_cluster_of_ray_are_those_of_the_matrix() -> None:
    import ray_rows

    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        mesh = heatwalk.Mesh(*ray_rows.surface())
        assert np.array_equal(ray_rows.all_rows(mesh, actors=2), mesh.matrix(method="heat", dtype="float32"))
    finally:
        ray.shutdown()
