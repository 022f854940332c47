import json
import sys
import threading

import numpy as np
import pytest

from app.bridge.errors import ErrorGateway
from app.bridge.jobs import Jobs
from app.bridge.pump import (
    LONGEST_MS,
    REST_AFTER_S,
    REST_GAP_S,
    Cadence,
    Pump,
    delay_ms,
)
from app.bridge.settings import Settings, default_path
from hapticplayer.clock import ManualClock, SystemClock
from hapticplayer.errors import InputError

# --- the pump ----------------------------------------------------------------


@pytest.mark.parametrize(
    ("remaining_s", "interval_ms"),
    [
        (-1.0, 1),
        (0.0, 1),
        (0.0105, 10),
        (0.5, LONGEST_MS),
        (float("inf"), LONGEST_MS),
        (float("nan"), LONGEST_MS),
    ],
)
def test_the_interval_is_early_and_never_long(remaining_s, interval_ms):
    assert delay_ms(remaining_s) == interval_ms


def test_the_pump_calls_until_it_is_stopped(qapp, wait_for):
    clock, calls = SystemClock(), []

    def poll() -> float:
        calls.append(1)
        return clock.now_s() + 0.002

    pump = Pump(poll, clock, lambda: None)
    pump.start()
    wait_for(lambda: len(calls) > 5)
    pump.stop()
    assert not pump.timer.isActive()


def test_the_pump_survives_an_error_in_a_poll(qapp, wait_for, qtbot):
    calls = []

    def poll() -> float:
        calls.append(1)
        raise ValueError("once")

    pump = Pump(poll, SystemClock(), lambda: None)
    with qtbot.captureExceptions() as caught:
        pump.start()
        wait_for(lambda: len(calls) > 2)
        pump.stop()
    assert isinstance(caught[0][1], ValueError)


def test_a_pump_rests_until_a_person_comes(qapp):
    clock, gaps, due_s = ManualClock(), [], [0.034]

    def poll() -> float:
        return clock.now_s() + due_s[0]

    def beat(seconds: float, every_s: float) -> int:
        before = len(gaps)
        for _ in range(round(seconds / every_s)):
            clock.advance(every_s)
            pump.beat()
        return len(gaps) - before

    pump, told = Pump(poll, clock, lambda: gaps.append(1), rests=True), []
    pump.rested.connect(told.append)
    beat(REST_AFTER_S - 1.0, 0.1)
    assert not pump.is_resting
    beat(2.0, 0.1)
    assert pump.is_resting
    assert beat(10.0, 0.1) == pytest.approx(10.0 / REST_GAP_S, abs=4)
    pump.wake()
    beat(0.1, 0.1)
    assert not pump.is_resting
    due_s[0] = 0.02  # a clip plays
    beat(2.0 * REST_AFTER_S, 0.1)
    assert not pump.is_resting
    assert told == [True, False]


def test_the_gap_is_used_when_nothing_is_due_soon(qapp):
    clock, gaps = ManualClock(), []
    pump = Pump(lambda: clock.now_s() + 0.02, clock, lambda: gaps.append(1))
    pump.beat()
    assert len(gaps) == 1


def test_a_picture_that_is_due_soon_comes_before_the_gap(qapp):
    clock, gaps = ManualClock(), []
    pump = Pump(lambda: clock.now_s() + 0.004, clock, lambda: gaps.append(1))
    pump.beat()  # the first gap is overdue
    pump.beat()
    clock.advance(0.004)
    pump.beat()
    assert len(gaps) == 1
    clock.advance(0.2)
    pump.beat()
    assert len(gaps) == 2


def test_the_rest_of_the_wait_is_slept_away(qapp):
    clock, polled = ManualClock(), []

    def poll() -> float:
        polled.append(clock.now_s())
        return clock.now_s() + 0.0105

    pump = Pump(poll, clock, lambda: None)
    pump.beat()
    clock.advance(0.0098)
    pump.beat()
    assert polled[1] - polled[0] == pytest.approx(0.0105)


def test_a_cadence_does_not_burst_after_a_stall():
    turn = Cadence(10.0)
    assert turn.is_due(0.0)
    assert not turn.is_due(0.05)
    assert turn.is_due(5.0)
    assert not turn.is_due(5.05)
    assert turn.is_due(5.11)


def test_frames_a_little_early_or_late_are_all_shown(rng):
    turn = Cadence(30.0)
    times_s = np.arange(300) / 30.0 + rng.uniform(-0.004, 0.004, 300)
    assert sum(turn.is_due(t) for t in times_s) >= 298
    fast = Cadence(30.0)  # asked at 120 Hz it stays at its own rate
    assert sum(fast.is_due(k / 120.0) for k in range(1200)) in range(299, 303)


# --- jobs --------------------------------------------------------------------


def run_to_the_end(jobs: Jobs, wait_for) -> None:
    def is_over() -> bool:
        jobs.poll()
        return not jobs.is_busy

    wait_for(is_over)


def test_a_job_hands_its_result_over_on_the_thread_that_polls(wait_for):
    results, failures = [], []
    jobs = Jobs(failures.append)
    jobs.run(
        "count",
        lambda progress: progress(1.0, "done") or 42,
        lambda result: results.append((result, threading.current_thread())),
    )
    run_to_the_end(jobs, wait_for)
    assert results == [(42, threading.main_thread())]
    assert not failures


def test_a_job_that_fails_reports_it(wait_for):
    failures = []
    jobs = Jobs(failures.append)

    def work(_progress):
        raise InputError("is broken", where="clip.mp4")

    jobs.run("open", work, lambda _: None)
    run_to_the_end(jobs, wait_for)
    assert str(failures[0]) == "clip.mp4: is broken"


def test_a_cancelled_job_stops_and_is_no_failure(wait_for):
    results, failures = [], []
    jobs = Jobs(failures.append)

    def work(progress):
        while True:
            progress(0.25, "for ever")

    jobs.run("endless", work, results.append)
    wait_for(lambda: jobs.state().step == "for ever")
    assert jobs.state().title == "endless"
    jobs.cancel()
    run_to_the_end(jobs, wait_for)
    assert not results
    assert not failures


def test_closing_waits_for_the_thread(wait_for):
    jobs = Jobs(lambda _: None)

    def work(progress):
        while True:
            progress(0.0, "")

    jobs.run("endless", work, lambda _: None)
    jobs.close()
    assert "job" not in [thread.name for thread in threading.enumerate()]


# --- errors ------------------------------------------------------------------


@pytest.fixture
def calls() -> list:
    return []


@pytest.fixture
def gateway(calls) -> ErrorGateway:
    return ErrorGateway(
        lambda text, _is_over: calls.append(("show", text)),
        lambda: calls.append(("halt", "")),
    )


def test_a_refusal_of_the_engine_is_shown_as_it_is(gateway, calls):
    gateway.report(InputError("is broken", where="clip.mp4", remedy="copy it again"))
    assert calls == [("show", "clip.mp4: is broken; copy it again")]


def test_a_fault_halts_first_and_is_told_once(gateway, calls, capsys):
    def fail():
        raise KeyError("inside")

    for _ in range(3):
        try:
            fail()
        except KeyError as problem:
            gateway.report(problem)
    assert [kind for kind, _ in calls] == ["halt", "show", "halt", "halt"]
    assert "inside" in calls[1][1]
    assert "See the terminal" in calls[1][1]
    assert capsys.readouterr().err.count("Traceback") == 1


def test_faults_of_threads_wait_for_the_window(gateway, calls, capsys):
    before = (sys.excepthook, threading.excepthook)
    gateway.install()
    try:
        thread = threading.Thread(target=lambda: {}["inside"])
        thread.start()
        thread.join()
        assert not calls
        gateway.poll()
    finally:
        gateway.uninstall()
    assert [kind for kind, _ in calls] == ["halt", "show"]
    assert (sys.excepthook, threading.excepthook) == before
    assert "KeyError" in capsys.readouterr().err


# --- settings ----------------------------------------------------------------


def test_settings_come_back(tmp_path):
    path = tmp_path / "folder" / "window.json"
    first = Settings(path)
    first.keep("folder", "/videos")
    first.keep("plots", False)
    first.save()
    again = Settings(path)
    assert again.text("folder") == "/videos"
    assert again.flag("plots", default=True) is False
    assert again.text("plots", "text") == "text"


@pytest.mark.parametrize("content", ["", "[1]", "{broken", '{"folder": 3}', "\0" * 9])
def test_broken_settings_are_like_none(tmp_path, content):
    path = tmp_path / "window.json"
    path.write_text(content)
    assert Settings(path).text("folder", "home") == "home"


def test_settings_that_cannot_be_written_are_no_error(tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("")
    settings = Settings(blocked / "window.json")
    settings.keep("folder", "x")
    settings.save()
    assert blocked.read_text() == ""


def test_settings_lie_where_the_platform_wants_them(tmp_path):
    assert default_path() == tmp_path / "config" / "hapticplayer" / "window.json"
    assert json.dumps(str(default_path()))
