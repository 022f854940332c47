"""LSL streams as another program on the machine reads them."""

import os
import socket
import subprocess
import sys

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.errors import StudyError
from hapticplayer.extras.research.lsl import FORCE, MARKERS, LslStreams

WAIT_S = 20.0


@pytest.fixture
def library():
    try:
        import pylsl
    except (ImportError, RuntimeError) as problem:
        pytest.skip(f"pylsl cannot be used: {problem}")
    return pylsl


@pytest.fixture
def streams(library):
    made = LslStreams()
    yield made
    made.close()


@pytest.fixture
def read(library, streams):
    """Open an inlet that hands on time stamps as they were sent."""
    opened = []

    def open_inlet(name):
        found = library.resolve_byprop("name", name, timeout=WAIT_S)
        if not found:
            pytest.skip("streams cannot be found on this machine's loopback")
        inlet = library.StreamInlet(found[0])
        inlet.open_stream(WAIT_S)
        opened.append(inlet)
        return inlet

    yield open_inlet
    for inlet in opened:
        inlet.close_stream()


def test_the_clock_of_the_streams_is_the_one_of_the_records(library):
    before_s = SystemClock().now_s()
    assert before_s <= library.local_clock() <= SystemClock().now_s()


def test_markers_arrive_with_the_time_at_which_they_happened(read, streams):
    inlet, now_s = read(MARKERS), SystemClock().now_s()
    sent = [("trial-01 begin bike/none", now_s - 3.5), ("trial-01 end é", now_s)]
    for text, at_s in sent:
        streams.marker(text, at_s)
    got = [inlet.pull_sample(WAIT_S) for _ in sent]
    assert [(sample[0], at_s) for sample, at_s in got] == sent


def test_forces_arrive_tick_for_tick_in_newtons(read, streams):
    inlet = read(FORCE)
    times_s = SystemClock().now_s() + 1e-3 * np.arange(500)
    forces_n = np.random.default_rng(1).normal(size=(500, 3)).astype(np.float32)
    streams.force(times_s[:0], forces_n[:0])
    for begin in range(0, 500, 33):
        part = slice(begin, begin + 33)
        streams.force(times_s[part], forces_n[part][:, ::-1][:, ::-1])
    got, at_s = [], []
    while len(got) < 500:
        sample, time_s = inlet.pull_sample(WAIT_S)
        got.append(sample)
        at_s.append(time_s)
    np.testing.assert_array_equal(np.array(got, np.float32), forces_n)
    np.testing.assert_array_equal(at_s, times_s)
    channel = inlet.info().desc().child("channels").first_child()
    assert channel.child_value("label") == "ForceX"
    assert channel.child_value("unit") == "newton"


def test_another_program_finds_both_streams(streams):
    script = (
        "import pylsl;"
        "print(sorted(pylsl.resolve_byprop('name', n, timeout=20)[0].name()"
        f" for n in {[FORCE, MARKERS]!r}))"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip().endswith(str([FORCE, MARKERS]))


def test_no_port_answers_another_machine(streams):
    checked = 0
    for name in os.listdir("/proc/self/fd"):  # noqa: PTH208
        try:
            held = socket.socket(fileno=os.dup(int(name)))
        except OSError:
            continue
        with held:
            if held.family in (socket.AF_INET, socket.AF_INET6):
                device = held.getsockopt(socket.SOL_SOCKET, socket.SO_BINDTODEVICE, 16)
                is_local = held.getsockname()[0] in ("127.0.0.1", "::1")
                assert is_local or device.startswith(b"lo\0"), held
                checked += 1
    assert checked >= 6  # announcing, time and data of two streams


def test_a_missing_library_is_said_in_one_sentence(monkeypatch):
    monkeypatch.setitem(sys.modules, "pylsl", None)
    with pytest.raises(StudyError, match=r"need pylsl.*; install") as refused:
        LslStreams()
    assert "\n" not in str(refused.value)
