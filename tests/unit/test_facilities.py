"""What only Linux gives, and how the program is without it."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from hapticplayer import doctor
from hapticplayer.clock import SystemClock
from hapticplayer.facilities import FACILITIES, has, session_bus
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.lifeline import Lifeline
from hapticplayer.haptics.processes import HapticsProcesses
from hapticplayer.linux import CPU_LATENCY, SWITCH, knows_slices
from hapticplayer.model import ForceTrack
from tests.unit.haptics.test_process import follow


def is_open(process, name):
    links = Path(f"/proc/{process.pids['loop']}/fd").iterdir()
    return any(name in str(link.readlink()) for link in links)


def has_locked_memory(process):
    words = Path(f"/proc/{process.pids['loop']}/status").read_text().split()
    return int(words[words.index("VmLck:") + 1]) > 0


USED_BY_THE_LOOP = {
    "memfd": lambda process: is_open(process, "memfd:hapticplayer-loop"),
    "robust-mutex": lambda process: Lifeline(process.block.lifeline).wakes(),
    "fifo": lambda process: process.scheduling == "fifo",
    "fifo,slice": lambda process: process.scheduling != "normal",
    "mlock": has_locked_memory,
    "cpu-latency": lambda process: is_open(process, CPU_LATENCY),
}


def played(is_used):
    """The force of a loop of its own; whether it used a facility meanwhile."""
    clock, process = SystemClock(), None
    track = ForceTrack(np.arange(100.0), np.full((100, 3), 1.0))
    try:
        process = HapticsProcesses(clock)
        process.wait_ready()
        process.load({"track": track})
        ticks = follow(
            process, clock, lambda r: np.sum(r["mode"] == Mode.FOLLOWING) > 100
        )
        return ticks["force_n"], is_used(process)
    finally:
        if process:
            process.close()


@pytest.mark.realtime
@pytest.mark.parametrize("names", USED_BY_THE_LOOP)
def test_the_force_is_played_without_a_facility(monkeypatch, names):
    is_used = USED_BY_THE_LOOP[names]
    monkeypatch.setenv(SWITCH, names)
    force_n, was_used = played(is_used)
    assert not was_used
    assert force_n[-1] == pytest.approx(1.0)
    monkeypatch.delenv(SWITCH)
    if any(map(has, names.split(","))):
        assert played(is_used)[1]


@pytest.mark.parametrize("name", FACILITIES)
def test_the_doctor_tells_a_facility_that_is_taken_away(monkeypatch, name):
    monkeypatch.setenv(SWITCH, name)
    check = next(each for each in doctor.check() if each.name == name)
    assert not check.ok
    assert check.detail == FACILITIES[name].without
    assert SWITCH in check.remedy


@pytest.mark.parametrize(
    ("release", "knows"), [("6.12-rc1", True), ("6.12+", True), ("6.1.0-28-amd64", False), ("7", True), ("", False)]
)  # fmt: skip
def test_every_name_of_a_kernel_is_understood(monkeypatch, release, knows):
    system = SimpleNamespace(machine="x86_64", release=release)
    monkeypatch.setattr("os.uname", lambda: system)
    assert knows_slices() == knows


def test_the_session_bus_is_taken_away(monkeypatch):
    monkeypatch.setenv("DBUS_SESSION_BUS_ADDRESS", "unix:path=/here")
    assert session_bus() == "unix:path=/here"
    monkeypatch.setenv(SWITCH, "session-bus")
    assert session_bus() == ""
