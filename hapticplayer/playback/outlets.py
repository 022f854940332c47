"""What plays beside the device: any number of outlets, each with processes of its own.

All of them read the same playback clock, each ahead by its own latency. What happens to
one leaves the others alone.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from hapticplayer.clock import Clock
from hapticplayer.devices import NO_DEVICE, find_device
from hapticplayer.errors import Message, UsageError
from hapticplayer.haptics.block import REFUSED
from hapticplayer.haptics.processes import HapticsProcesses
from hapticplayer.haptics.scheduling import Scheduling
from hapticplayer.model import (
    Feedback,
    ForceTrack,
    MotionTrack,
    PlaybackClock,
    RigTrack,
)
from hapticplayer.model.device import Signal
from hapticplayer.playback.force_output import ForceOutput
from hapticplayer.playback.latch import StopLatch
from hapticplayer.playback.latency import Latencies
from hapticplayer.playback.log import Reporter
from hapticplayer.playback.snapshot import OutletState
from hapticplayer.rendering import rig_track

NO_TRACK = ""  # no force; what comes after it fades in
NO_MOTION = Message(
    "a rig moves only with the realistic feedback of a sequence that has its motion"
)
LENT = Message("in test, or being set up")
NOBODY_LISTENS = Message("nobody listens at {address}: start the rig's software")


class _Tagged(Reporter):
    """Reports what happens to an outlet under its name."""

    def __init__(self, clock: Clock, whole: Reporter, outlet: str) -> None:
        self._whole, self._outlet = whole, outlet
        super().__init__(clock)
        self.log = None  # it takes no ticks of an outlet

    def notify(self, sentence: str) -> None:
        """Add a notice."""
        named = Message("{outlet}: {what}", outlet=self._outlet, what=sentence)
        self._whole.notify(named)

    def line(self, kind: str, **fields: Any) -> None:
        """Log one line of a kind."""
        self._whole.line(kind, outlet=self._outlet, **fields)


class Outlet:
    """One of them; it waits in neutral until those that were released are at rest.

    They may drive the same rig, and packets of both would alternate.
    """

    def __init__(
        self, name: str, output: ForceOutput, before: Sequence[ForceOutput] = ()
    ) -> None:
        self._before = before
        entry = find_device(name)
        chosen = entry.settings
        self.name, self.output = name, output
        self.takes_motion = entry.capabilities.signal is Signal.MOTION
        self.gain = chosen.gain
        self.address = chosen.address
        self.latency_s, self.latency_source = Latencies().of_device(name)
        self.is_muted, self.feedback = False, ""
        self.is_lent = False
        self._names: set[str] = set()

    def lend(self) -> None:
        """Let go of the device, so that a test can have it."""
        if not self.is_lent:
            self.is_lent = True
            self.output.use(NO_DEVICE)

    def take_back(self) -> None:
        """Open the device again; what was stopped stays stopped."""
        if self.is_lent:
            self.is_lent = False
            self.output.use(self.name)

    def set_latencies(self, latencies: Latencies) -> None:
        """Take what is known of this outlet."""
        self.latency_s, self.latency_source = latencies.of_device(self.name)

    def load(self, tracks: Mapping[str, ForceTrack], rig: RigTrack | None) -> None:
        """Hand over the signal of each condition."""
        if not self.takes_motion:
            self._names = set(tracks)
            self.output.load(tracks)
            return
        signals = {} if rig is None else {Feedback.REALISTIC.value: rig}
        self._names = set(signals)
        self.output.processes.load(signals)

    def replace(self, name: str, track: ForceTrack) -> None:
        """Hand over another version of a force; a rig moves as it did."""
        if not self.takes_motion and name in self._names:
            self.output.replace(name, track)

    def publish(self, clock: PlaybackClock, feedback: str) -> None:
        """Publish where the clip is, with the condition that the player plays."""
        wanted = (self.feedback or feedback) if feedback else NO_TRACK
        is_on = wanted in self._names and not self.is_muted
        is_on = is_on and not any(one.is_releasing for one in self._before)
        ahead = clock.ahead(self.latency_s)
        self.output.processes.publish(ahead, wanted if is_on else NO_TRACK)

    def state(self, feedback: str) -> OutletState:
        """The snapshot for front ends; `feedback` is the player's."""
        tick, processes = self.output.history.latest(), self.output.processes
        mode, cause = self.output.activity()
        return OutletState(
            self.name,
            processes.health,
            self.output.problem,
            self._note(tick, self.feedback or feedback),
            self.feedback or feedback,
            self.is_muted,
            self.gain,
            self.latency_s,
            self.latency_source,
            mode,
            cause,
            processes.pids.get("loop"),
            processes.levels,
        )

    def _note(self, tick: Any, feedback: str) -> Message | str:
        if self.is_lent:
            return LENT
        if not self.takes_motion:
            return ""
        if feedback not in {*self._names, NO_TRACK, Feedback.NONE.value}:
            return NO_MOTION
        is_refused = tick is not None and tick["buttons"] & REFUSED
        return Message(NOBODY_LISTENS, address=self.address) if is_refused else ""


class Outlets:
    """All of them, by name."""

    def __init__(
        self,
        clock: Clock,
        reporter: Reporter,
        scheduling: Scheduling | None,
        make: Callable[..., HapticsProcesses],
        latch: StopLatch | None = None,
    ) -> None:
        self._clock, self._reporter, self._latch = clock, reporter, latch
        self._scheduling, self._make = scheduling, make
        self._all: dict[str, Outlet] = {}
        self._released: list[ForceOutput] = []
        self._latencies = Latencies()
        self._tracks: Mapping[str, ForceTrack] = {}
        self._motion: MotionTrack | None = None

    def __iter__(self) -> Any:
        return iter(self._all.values())

    def __getitem__(self, name: str) -> Outlet:
        """Return one; raises UsageError for a name that is none."""
        if name not in self._all:
            raise UsageError("there is no outlet {name!r}", name=name)
        return self._all[name]

    @property
    def lead_s(self) -> float:
        """The largest latency."""
        return max((one.latency_s for one in self), default=0.0)

    def use(self, names: Sequence[str]) -> None:
        """Release those that are not named, and open those that are new.

        Raises:
            DeviceError: for a name or settings that are not allowed.
            UsageError: when two of them send the same to one address.
            HapticsError: when processes cannot be started.
        """
        _refuse_alike(names)
        for name in self._all.keys() - set(names):
            released = self._all.pop(name).output
            released.release()
            self._released.append(released)
        self._released = [one for one in self._released if one.is_releasing]
        new = [name for name in names if name not in self._all]
        for name in new:
            reporter = _Tagged(self._clock, self._reporter, name)
            output = ForceOutput(
                *(self._clock, reporter, name, self._scheduling, self._make),
                latch=self._latch,
            )
            self._all[name] = Outlet(name, output, tuple(self._released))
            self._all[name].set_latencies(self._latencies)
        self._hand_over(self._all[name] for name in new)

    def set_latencies(self, latencies: Latencies) -> None:
        """Take what was measured on this machine."""
        self._latencies = latencies
        for one in self:
            one.set_latencies(latencies)

    def load(
        self, tracks: Mapping[str, ForceTrack], motion: MotionTrack | None
    ) -> None:
        """Hand over the tracks and the motion of a clip in place of those before."""
        self._tracks, self._motion = tracks, motion
        self._hand_over(self)

    def replace(self, name: str, track: ForceTrack) -> None:
        """Hand over another version of one of the tracks, also while it plays."""
        self._tracks = {**self._tracks, name: track}
        for one in self:
            one.replace(name, track)

    def _hand_over(self, outlets: Any) -> None:
        rig: RigTrack | None = None
        for one in outlets:
            if one.takes_motion and rig is None and self._motion is not None:
                rig = rig_track(self._motion)
            one.load(self._tracks, rig)

    def wait_ready(self) -> None:
        """Wait for all; see `HapticsProcesses.wait_ready`."""
        for one in self:
            one.output.processes.wait_ready()

    def stop(self) -> None:
        """Bring all of them to rest, until `rearm`."""
        for one in self:
            one.output.processes.stop_force()

    def rearm(self) -> None:
        """Let all of them fade in again after a stop."""
        for one in self:
            one.output.processes.rearm()

    def lend(self, name: str) -> None:
        """Let go of a device, for a test or a set-up, until `take_back`.

        Raises:
            UsageError: when there is no such outlet.
        """
        self[name].lend()
        self._reporter.event("outlet", outlet=name, lent=True)

    def is_free(self, name: str) -> bool:
        """Whether a device that was lent has come to rest, so that others can open it."""
        return not self[name].output.is_releasing

    def take_back(self, name: str) -> None:
        """Open a device again, if it was lent, with the tracks of the clip.

        What was stopped stays stopped.

        Raises:
            UsageError: when there is no such outlet.
            HapticsError: when its processes cannot be started.
        """
        one = self[name]
        if one.is_lent:
            self._reporter.event("outlet", outlet=name, lent=False)
            one.take_back()
            self._hand_over([one])

    def read(self) -> None:
        """Read what they have done since."""
        for one in self:
            one.output.poll()

    def publish(self, clock: PlaybackClock, feedback: str) -> None:
        """Beat, and publish the clock."""
        for one in self:
            one.output.processes.beat()
            one.publish(clock, feedback)

    def note_frame(self, seen_s: float, frame_s: float) -> None:
        """Note that a frame was seen, to be compared with what the outlets did."""
        for one in self:
            one.output.video.event(seen_s - one.latency_s, frame_s)

    def restart_meters(self) -> None:
        """Measure from here on."""
        for one in self:
            one.output.restart_meters()

    def states(self, feedback: str) -> tuple[OutletState, ...]:
        """The snapshot for front ends."""
        return tuple(one.state(feedback) for one in self)

    def summary(self) -> dict[str, Any]:
        """The figures of each, for the end of a log."""
        return {one.name: one.output.summary() for one in self}

    def close(self) -> None:
        """Bring all of them to rest and end their processes."""
        for one in self:
            one.output.close()
        for output in self._released:
            output.wait_released()


def _refuse_alike(names: Sequence[str]) -> None:
    taken = set()
    for name in names:
        use = find_device(name).settings.sole_use
        if use and use in taken:
            raise UsageError("two outlets send {what}; keep one of them", what=use)
        taken.add(use)
