"""Reruns of real-time tests, and the judge who allows them."""

import os
import subprocess
import sys
from contextlib import nullcontext

import pytest

from hapticplayer.clock import SystemClock
from tests.realtime import RealTime, fault_of
from tools.witness import Seen, machine_witness

TRIED = """
    import pytest
    from pathlib import Path

    @pytest.mark.realtime
    def test_tried():
        with Path("tries").open("a+") as tries:
            tries.write(".")
            assert tries.tell() == {attempt}, "too early"
"""

TRIED_FOR_ALL = """
    import pytest
    from pathlib import Path

    @pytest.fixture(scope="module")
    def tries():
        with Path("tries").open("a+") as tries:
            tries.write(".")
            assert tries.tell() == {attempt}, "too early"

    @pytest.mark.realtime
    def test_tried(tries):
        pass

    def test_next(tries):
        pass
"""


class Silent(nullcontext):
    """A witness that has seen nothing."""

    def __enter__(self):
        return self

    def forget(self):
        pass

    def seen(self):
        return Seen([])


@pytest.fixture
def outcome(pytester):
    """Run a test that passes at one attempt only, on a machine with a fault."""
    pytester.makeini("[pytest]\nmarkers = realtime")
    locks = pytester.path / "door", pytester.path / "inside"
    for lock in locks:
        lock.touch()

    def run(attempt, fault):
        (pytester.path / "tries").unlink(missing_ok=True)
        pytester.makepyfile(TRIED.format(attempt=attempt))
        return pytester.runpytest_inprocess(
            "-p", "no:xdist", plugins=[RealTime(lambda _: fault, locks, Silent)]
        )

    return run


def test_a_late_machine_lets_a_test_run_again_and_counts_it(outcome):
    result = outcome(2, "a core stalled")
    result.assert_outcomes(passed=1)
    result.stdout.fnmatch_lines(["*1 reruns because the machine was at fault*"])
    result.stdout.fnmatch_lines(["*::test_tried: a core stalled: *too early*"])


def test_a_fixture_of_a_module_is_made_again(outcome, monkeypatch):
    monkeypatch.setitem(globals(), "TRIED", TRIED_FOR_ALL)
    outcome(2, "a core stalled").assert_outcomes(passed=2)


def test_a_test_runs_again_at_most_twice(outcome):
    outcome(3, "a core stalled").assert_outcomes(passed=1)
    result = outcome(4, "a core stalled")
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*2 reruns because the machine was at fault*"])


def test_a_punctual_machine_lets_a_test_fail_at_once(outcome):
    result = outcome(2, "")
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*was not at fault*"])
    result.stdout.no_fnmatch_line("*reruns because*")


def test_a_mistake_in_the_code_is_not_blamed_on_a_machine(outcome, monkeypatch):
    monkeypatch.setitem(globals(), "TRIED", TRIED.replace("assert tries", "tried"))
    result = outcome(1, "a core stalled")
    result.assert_outcomes(failed=1)
    result.stdout.no_fnmatch_line("*reruns because*")


def test_a_test_that_passes_is_not_judged(outcome):
    result = outcome(1, "a core stalled")
    result.assert_outcomes(passed=1)
    result.stdout.no_fnmatch_line("*reruns because*")


@pytest.mark.parametrize(
    ("stalls", "waits", "fault"),
    [
        ([(1.0, 0.008), (2.0, 0.009)], [], ""),
        ([(1.0, 0.012)], [], "a core stalled for 12 ms"),
        ([], [(1.0, 1.04, 0.03), (1.2, 1.24, 0.03), (2.0, 2.04, 0.03)], ""),
        (
            [],
            [(1.0, 1.04, 0.03), (1.04, 1.08, 0.04), (1.08, 1.12, 0.02)],
            "a thread had no core for 90 of 150 ms",
        ),
    ],
    ids=["late", "stalled", "waits-apart", "waits-together"],
)
def test_a_machine_is_at_fault_for_a_long_stall_or_wait(stalls, waits, fault):
    assert fault_of(Seen([[], stalls], waits)) == fault


@pytest.mark.realtime
def test_two_busy_loops_on_one_core_are_seen_to_wait():
    clock, core = SystemClock(), min(os.sched_getaffinity(0))
    busy = f"import os; os.sched_setaffinity(0, {{{core}}})\nwhile True: pass"
    with machine_witness() as witness:
        loops = [subprocess.Popen([sys.executable, "-c", busy]) for _ in range(2)]
        try:
            end_s = clock.now_s() + 60.0
            while "no core" not in fault_of(Seen([[]], witness.seen().waits)):
                assert clock.now_s() < end_s
                clock.sleep_until(clock.now_s() + 0.05)
        finally:
            for loop in loops:
                loop.kill()
                loop.wait()
