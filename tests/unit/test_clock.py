"""The machine's clock on a machine that wakes up late by known amounts."""

import types

import numpy as np
import pytest

from hapticplayer import clock as clock_module
from hapticplayer.clock import LEAST_WAKE_UP_S, MOST_WAKE_UP_S, SystemClock


class Machine:
    """Time that passes while one looks at it, and sleeps that take longer."""

    def __init__(self, wake_up_s):
        self.now_s, self.slept_s = 100.0, 0.0
        self.wake_up_s = iter(wake_up_s)

    def monotonic(self):
        self.now_s += 1e-7
        return self.now_s

    def sleep(self, duration_s):
        self.now_s += duration_s + next(self.wake_up_s)
        self.slept_s += duration_s


def lateness_s(monkeypatch, wake_up_s):
    machine = Machine(wake_up_s)
    fake = types.SimpleNamespace(monotonic=machine.monotonic, sleep=machine.sleep)
    monkeypatch.setattr(clock_module, "time", fake)
    clock = SystemClock()
    found = []
    for tick in range(len(wake_up_s)):
        deadline_s = 100.001 + tick * 0.001
        clock.sleep_until(deadline_s)
        found.append(machine.now_s - deadline_s)
    spun_s = 0.001 - machine.slept_s / len(wake_up_s) - np.mean(wake_up_s)
    return np.array(found), spun_s


def test_a_machine_that_wakes_fast_costs_no_more_than_the_least(monkeypatch):
    late_s, spun_s = lateness_s(monkeypatch, np.full(5000, 15e-6))
    assert late_s.max() < 0.3e-6
    assert spun_s == pytest.approx(LEAST_WAKE_UP_S - 15e-6, abs=0.5e-6)


def test_one_wake_up_in_a_hundred_is_late_on_a_slower_machine(monkeypatch):
    wake_up_s = np.random.default_rng(1).normal(30e-6, 4e-6, 60_000)
    late_s, _ = lateness_s(monkeypatch, wake_up_s)
    settled = late_s[10_000:] > 0.5e-6
    assert 0.006 < settled.mean() < 0.014


def test_the_time_spent_waiting_is_bounded(monkeypatch):
    late_s, spun_s = lateness_s(monkeypatch, np.full(3000, 90e-6))
    assert late_s[-1] == pytest.approx(90e-6 - MOST_WAKE_UP_S, abs=0.5e-6)
    assert spun_s < 1e-6


def test_a_deadline_that_has_passed_is_not_slept_for(monkeypatch):
    machine = Machine([])
    fake = types.SimpleNamespace(monotonic=machine.monotonic, sleep=machine.sleep)
    monkeypatch.setattr(clock_module, "time", fake)
    SystemClock().sleep_until(99.0)
    assert machine.slept_s == 0.0
