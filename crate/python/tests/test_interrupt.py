"""Long work: it lets other threads run, tells how far it is, and ends at once when asked to."""

from __future__ import annotations

import signal
import threading
import time

import heatwalk
import numpy as np
import pytest
from heatwalk import HeatwalkError

# What a person takes for at once.
AT_ONCE = 0.2


@pytest.fixture(scope="module")
def large() -> heatwalk.Mesh:
    """What takes seconds to answer exactly from many sources."""
    return heatwalk.shape("animal")


def interrupted(after: float, work: object) -> float:
    """How many seconds work goes on after Ctrl-C."""
    sent: list[float] = []

    def send() -> None:
        time.sleep(after)
        sent.append(time.perf_counter())
        signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)

    thread = threading.Thread(target=send)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        work()
    ended = time.perf_counter()
    thread.join()
    return ended - sent[0]


def test_ctrl_c_ends_work_at_once_and_leaves_the_mesh_usable(large: heatwalk.Mesh) -> None:
    before = large.distance(0)
    for threads in [1, 2]:
        assert interrupted(0.3, lambda: large.matrix(method="exact", threads=threads)) < AT_ONCE
    assert interrupted(0.3, lambda: [large.distance(0, "exact") for _ in range(10_000)]) < AT_ONCE
    assert interrupted(0.3, lambda: large.sample(100_000, relax=50)) < AT_ONCE
    assert np.array_equal(large.distance(0), before)


def test_other_threads_run_meanwhile(large: heatwalk.Mesh) -> None:
    turns = 0
    is_done = threading.Event()

    def work() -> None:
        large.matrix(np.arange(40), method="exact", threads=1)
        is_done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not is_done.is_set():
        turns += 1
        time.sleep(0.001)
    thread.join()
    # Held, the lock would let this thread run once or twice.
    assert turns > 20


def test_progress_is_told_in_order_and_ends_with_one(large: heatwalk.Mesh) -> None:
    told: list[tuple[float, str]] = []
    large.matrix(np.arange(30), method="exact", threads=1, progress=lambda done, stage: told.append((done, stage)))
    shares = [done for done, stage in told if stage == "Answering"]
    assert shares == sorted(shares) and shares[-1] == 1.0 and len(shares) > 2 and shares[0] < 0.5
    told.clear()
    large.distance(0, "heat", time_step=3.0, progress=lambda done, stage: told.append((done, stage)))
    assert {"Assembling", "Ordering", "Analysing", "Factoring"} <= {stage for _, stage in told}
    assert all(0.0 <= done <= 1.0 for done, _ in told)


def test_progress_may_end_the_work(large: heatwalk.Mesh) -> None:
    with pytest.raises(HeatwalkError) as caught:
        large.matrix(method="exact", progress=lambda done, stage: done < 0.002)
    assert caught.value.code == "cancelled"

    def fail(done: float, stage: str) -> None:
        raise ZeroDivisionError("of the callback")

    with pytest.raises(ZeroDivisionError, match="of the callback"):
        large.matrix(method="exact", progress=fail)
    with pytest.raises(TypeError, match="progress is no function"):
        large.distance(0, progress=5)


def test_a_callback_that_asks_the_mesh_at_work_is_told_so(large: heatwalk.Mesh) -> None:
    def ask(done: float, stage: str) -> None:
        large.distance(1)

    with pytest.raises(HeatwalkError) as caught:
        large.distance(0, "exact", progress=ask)
    assert caught.value.code == "busy"
    assert np.isfinite(large.distance(1)).all()


def test_threads_take_turns_on_one_mesh(large: heatwalk.Mesh) -> None:
    expected = [large.distance(source) for source in range(8)]
    found: dict[int, object] = {}

    def ask(source: int) -> None:
        found[source] = large.distance(source)

    threads = [threading.Thread(target=ask, args=(source,)) for source in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(found[source], expected[source]) for source in range(8))
