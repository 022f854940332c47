"""Faults for developers: through the real processes, and never into a real device."""

import subprocess
import sys
from contextlib import contextmanager

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.errors import UsageError
from hapticplayer.extras.faults.injected import RULES_OF, Fault, outcome_of
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.messages import MessageKind
from hapticplayer.haptics.processes import HapticsProcesses, Health
from hapticplayer.haptics.shared import TICK
from hapticplayer.playback.player import Player
from tests.rigs import FeedingPlayer

TRIPS = {
    Fault.UNPLUG,
    Fault.LONG_STALL,
    Fault.NONSENSE,
    Fault.BUTTON,
    Fault.POSITION_NAN,
    Fault.FORCE_NAN,
    Fault.LOOP_LOST,
}


class Bench(FeedingPlayer):
    """A player that plays 1 N for ever."""

    def __init__(self, process):
        super().__init__(process, 1.0)

    def pushes(self, _ticks=()):
        return self.ticks["force_n"][-1, 2] > 0.9

    def play_until_it_pushes(self):
        def is_felt(_ticks):
            if self.has_tripped():  # by what the test did, or by a busy machine
                self.process.rearm()
            return self.pushes()

        self.play_until(is_felt)

    def outcome(self, fault):
        wanted = RULES_OF[fault][-1] if fault in TRIPS else RULES_OF[fault][0]
        at_s = np.inf

        def is_over(_ticks):
            nonlocal at_s
            found = outcome_of(self.ticks, at_s)
            if found and found.zero_s is not None and found.cause is wanted:
                return True
            if found and fault in TRIPS and not found.is_trip and self.pushes():
                at_s = np.inf  # a slow machine met the milder rule; the force is back
            is_other = at_s == np.inf or self.ticks["cause"][-1] != wanted
            if self.has_tripped() and is_other:  # by the machine, or by one before
                at_s = np.inf
                self.process.rearm()
            elif at_s == np.inf and self.pushes():
                at_s = self.process.inject(fault)
            return False

        self.play_until(is_over)
        return outcome_of(self.ticks, at_s)

    def has_tripped(self):
        return self.ticks["mode"][-1] == Mode.TRIPPED


@contextmanager
def bench(device="simulated", **more):
    process = HapticsProcesses(SystemClock(), device, takes_faults=True, **more)
    try:
        yield Bench(process)
    finally:
        process.close()


class Benches:
    """The bench of the last device, until something happens that ends it."""

    def __init__(self):
        self._device, self._made = "", None

    def of(self, device):
        if self._made is None or device != self._device:
            self.close()
            process = HapticsProcesses(SystemClock(), device, takes_faults=True)
            self._device, self._made = device, Bench(process)
        return self._made

    def close(self):
        if self._made is not None:
            self._made.process.close()
        self._made = None


@pytest.fixture(scope="module")
def benches():
    made = Benches()
    yield made
    made.close()


FINAL = (Fault.LOST_HOMING, Fault.UNPLUG)
FAULTS = sorted(set(Fault) - {Fault.LET_GO}, key=lambda f: (f in FINAL, f.value))


@pytest.mark.realtime
@pytest.mark.parametrize(
    ("device", "fault"),
    [
        pytest.param(device, fault, id=f"{device}-{fault.value}")
        for device in ("simulated", "falcon-simulated", "inverse3-simulated")
        for fault in FAULTS
    ],
)
def test_each_fault_meets_its_rule_and_the_force_is_gone(benches, device, fault):
    try:
        made = benches.of(device)
        found = made.outcome(fault)
        assert found.cause in RULES_OF[fault]
        assert found.is_trip is (fault in TRIPS)
        assert found.zero_s >= found.reaction_s >= 0.0
        if not found.is_trip and fault not in FINAL:
            made.play_until(made.pushes)  # it comes back by itself
        elif fault not in FINAL:
            made.play_until_it_pushes()
    except BaseException:
        benches.close()
        raise
    if fault in FINAL:
        benches.close()


@pytest.mark.realtime
def test_after_a_trip_a_person_re_arms():
    with bench() as made:
        assert made.outcome(Fault.POSITION_NAN).is_trip
        count = len(made.ticks)
        made.play_until(lambda ticks: len(ticks) > count + 50)
        assert not made.ticks["force_n"][count:].any()
        made.process.rearm()
        made.play_until(made.pushes)


@pytest.mark.realtime
def test_a_fault_waits_until_there_is_a_force_to_take_away():
    with bench() as made:
        made.process.inject(Fault.FORCE_NAN)
        made.play_until(lambda ticks: ticks["mode"][-1] == Mode.TRIPPED)
        assert Mode.ENTERING in made.ticks["mode"]
        assert made.ticks["cause"][-1] == Cause.NOT_FINITE


@pytest.mark.realtime
def test_without_leave_the_player_and_the_loop_refuse():
    process = HapticsProcesses(SystemClock(), "simulated")
    try:
        made = Bench(process)
        made.play_until(made.pushes)
        with pytest.raises(UsageError, match="simulated device that was opened"):
            process.inject(Fault.POSITION_NAN)
        process._line.send(MessageKind.FAULT, Fault.POSITION_NAN.value)  # all the same
        made.play_until(lambda _: bool(process.problem))
        assert "does not accept" in process.problem
        assert process.health is Health.READY
        assert made.pushes()
    finally:
        process.close()


def test_a_real_device_takes_none_at_any_level():
    with pytest.raises(UsageError, match="real device"):
        HapticsProcesses(SystemClock(), "falcon", takes_faults=True)
    options = ["--block", "0", "--line", "0", "--lifeline", "0", "--handle", "0"]
    options += ["--alarm", "0", "--held", "0", "--faults"]
    done = subprocess.run(
        [sys.executable, "-m", "hapticplayer.haptics", "--device", "falcon", *options],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    assert "real device does not accept" in done.stderr


def test_faults_are_injected_only_on_request():
    player = Player(SystemClock(), audio=None)
    player.set_outputs(["simulated"])
    try:
        assert not player.snapshot().leading.takes_faults
        with pytest.raises(UsageError):
            player.inject(Fault.UNPLUG)
    finally:
        player.close()
    with pytest.raises(UsageError, match="simulated device that was opened"):
        HapticsProcesses(SystemClock(), "none").inject(Fault.UNPLUG)


def ticks(*rows):
    """Return ticks of (ms, mode, cause, force)."""
    made = np.zeros(len(rows), TICK)
    for tick, (ms, mode, cause, force_n) in zip(made, rows, strict=True):
        tick["monotonic_s"], tick["mode"], tick["cause"] = 10 + ms / 1e3, mode, cause
        tick["force_n"] = (0, force_n, 0)
    return made


def test_an_outcome_tells_the_trip_and_the_times_from_the_fault():
    going = (0, Mode.FOLLOWING, Cause.NONE, 1.0)
    assert outcome_of(ticks(going), 10.0) is None
    ramp = (21, Mode.RAMPING, Cause.REPLY_LATE, 0.5)
    found = outcome_of(ticks(going, ramp), 10.0)
    assert found == (Cause.REPLY_LATE, False, pytest.approx(0.021), None)
    zero, trip = (30, Mode.IDLE, 14, 0.0), (101, Mode.TRIPPED, Cause.REPLY_LOST, 0.0)
    found = outcome_of(ticks(going, ramp, zero, trip), 10.0)
    assert found.cause is Cause.REPLY_LOST
    assert found.is_trip
    assert found.reaction_s == pytest.approx(0.021)
    assert found.zero_s == pytest.approx(0.030)
    before = (-5, Mode.TRIPPED, Cause.STOPPED, 0.0)
    assert outcome_of(ticks(before, going), 10.0) is None
