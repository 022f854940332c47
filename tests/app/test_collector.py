"""Garbage: collected on the window's thread, in portions, and nowhere else."""

import gc
import threading
import weakref

import pytest

from app.bridge import collector as module
from app.bridge.collector import Collector


class Ring:
    """Refers to itself: only a collection frees it."""

    def __init__(self) -> None:
        self.me = self


@pytest.fixture
def collector(qapp):
    made = Collector()
    made.begin()
    yield made
    made.end()


def test_rings_are_freed_on_the_windows_thread_and_on_no_other(collector, wait_for):
    freed_in: list[int] = []
    ring = Ring()
    weakref.finalize(ring, lambda: freed_in.append(threading.get_ident()))
    del ring

    def litter() -> None:
        for _ in range(5000):
            Ring()

    thread = threading.Thread(target=litter)
    thread.start()
    thread.join()
    assert freed_in == []
    wait_for(lambda: bool(freed_in))
    assert freed_in == [threading.get_ident()]


def test_old_garbage_is_freed_by_the_full_collection(collector, monkeypatch):
    monkeypatch.setattr(module, "FULL_EVERY", 4)
    ring = Ring()
    gone = weakref.ref(ring)
    for _ in range(3):
        collector.collect()
    del ring
    gc.collect(1)
    assert gone() is not None  # it is old by now
    collector.collect()
    assert gone() is None


def test_a_full_collection_gives_memory_back(collector, monkeypatch):
    given: list[int] = []
    monkeypatch.setattr(module, "FULL_EVERY", 4)
    monkeypatch.setattr(module, "give_back_freed_memory", lambda: given.append(1))
    for _ in range(8):
        collector.collect()
    assert len(given) == 2


def test_many_that_live_on_are_not_looked_at_again(collector, monkeypatch):
    monkeypatch.setattr(module, "COUNTED_EVERY", 1)
    before = gc.get_freeze_count()
    kept = [[] for _ in range(module.MOST + 1)]
    collector.collect()
    assert gc.get_freeze_count() >= before + len(kept)


def test_afterwards_python_collects_by_itself_again(qapp):
    made = Collector()
    made.begin()
    assert not gc.isenabled()
    made.end()
    assert gc.isenabled()
    assert gc.get_freeze_count() == 0
