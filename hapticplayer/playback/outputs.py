"""The list of outputs: what plays, in order; the first one leads."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from hapticplayer.devices import NO_DEVICE, find_device
from hapticplayer.errors import HapticPlayerError, UsageError
from hapticplayer.model import ForceTrack, MotionTrack, PlaybackClock, RigTrack
from hapticplayer.playback.latency import Latencies
from hapticplayer.playback.output import Force, Output, OutputContext
from hapticplayer.playback.snapshot import OutputSnapshot


class Outputs:
    """All outputs of a player, by name; what is chosen comes back after it was lent."""

    def __init__(self, context: OutputContext) -> None:
        self._context = context
        self._none = Output(context, NO_DEVICE)
        self._all: dict[str, Output] = {}
        self._released: list[Output] = []
        self._lends = 0
        self._latencies = Latencies()
        self._tracks: Mapping[str, Force] = {}
        self._motion: MotionTrack | None = None
        self._order()

    def __iter__(self) -> Iterator[Output]:
        return iter(tuple(self._all.values()) or (self._none,))

    def __getitem__(self, name: str) -> Output:
        if name not in self._all:
            raise UsageError("there is no output {name!r}", name=name)
        return self._all[name]

    @property
    def leading(self) -> Output:
        """The first; one without a device where the list is empty."""
        return next(iter(self))

    @property
    def lead_s(self) -> float:
        return max(one.latency_s for one in self)

    def use(
        self,
        names: Sequence[str],
        record: Path | None = None,
        *,
        takes_faults: bool = False,
    ) -> None:
        """Play on these, in this order, and on no others.

        What is open already stays open, but what has failed; the first is opened again
        for a record, and where faults are to be injected or no longer. Waits for what
        is released only where hardware is opened.
        """
        if isinstance(names, str):  # a sequence of names, too: its letters
            raise TypeError(f"outputs are a list of names, not {names!r}")
        names = [name for name in names if name != NO_DEVICE]
        _refuse_alike(names)
        before = dict(self._all)
        first = before.get(names[0]) if names else None
        faults = first.processes.takes_faults if first else False
        if first and (record is not None or faults is not takes_faults):
            self._release(first)
        for one in tuple(self._all.values()):
            if one.name not in names or one.is_dead:
                self._release(one)
        self._released = [one for one in self._released if one.is_releasing]
        try:
            for name in names:
                if name not in self._all:
                    options = {"record": record, "takes_faults": takes_faults}
                    options = options if name == names[0] else {}
                    self._open(name, before.get(name), **options)
        finally:
            self._all = {name: self._all[name] for name in names if name in self._all}
            self._order()

    def _release(self, one: Output) -> None:
        del self._all[one.name]
        one.release()
        self._released.append(one)

    def _open(self, name: str, like: Output | None, **options: Any) -> None:
        if is_hardware(name) and not self._lends:
            self.wait_released(hardware_only=True)
        before, is_lent = tuple(self._released), self._lends > 0
        made = Output(self._context, name, before, is_lent=is_lent, **options)
        if like is not None:
            made.choose_as(like)
        made.set_latencies(self._latencies)
        self._all[name] = made
        self._hand_over([made])

    def _order(self) -> None:
        for one in self:
            one.lead(is_wanted=one is self.leading)

    def set_latencies(self, latencies: Latencies) -> None:
        """Take what was measured on this machine."""
        self._latencies = latencies
        for one in (self._none, *self._all.values()):
            one.set_latencies(latencies)

    def load(self, tracks: Mapping[str, Force], motion: MotionTrack | None) -> None:
        """Hand over the tracks and the motion of a clip in place of those before."""
        self._tracks, self._motion = tracks, motion
        self._none.load(tracks, None)
        self._hand_over(self._all.values())

    def replace(self, name: str, track: ForceTrack) -> None:
        """Hand over another version of one of the tracks, also while it plays."""
        self._tracks = {**self._tracks, name: track}
        for one in self:
            one.replace(name, track)

    def _hand_over(self, outputs: Any) -> None:
        rig: RigTrack | None = None
        for one in outputs:
            if one.takes_motion and rig is None and self._motion is not None:
                from hapticplayer.rendering.rig import rig_track

                rig = rig_track(self._motion)
            one.load(self._tracks, rig)

    def wait_ready(self) -> None:
        """Wait for all; see `HapticsProcesses.wait_ready`."""
        for one in self:
            one.processes.wait_ready()

    def stop(self) -> None:
        """Bring all of them to rest."""
        for one in self:
            one.processes.stop_force()

    def rearm(self) -> None:
        """Let all of them fade in again after a stop."""
        for one in self:
            one.processes.rearm()

    def lend(self, name: str = "") -> None:
        """Let go of one device, or of all, until `take_back`: others may have them.

        All stay lent until each borrower has given them back; what is chosen meanwhile is
        opened then.
        """
        self._lends += not name
        for one in [self[name]] if name else self._all.values():
            one.lend()

    @property
    def are_free(self) -> bool:
        """Whether every device that was lent or released has come to rest."""
        return not any(
            one.is_releasing for one in (*self._all.values(), *self._released)
        )

    def take_back(self, name: str = "") -> None:
        """Open one device, or all, again: the end of a `lend`."""
        self._lends = max(0, self._lends - (not name))
        if self._lends:
            return
        problem: Exception | None = None
        for one in [self[name]] if name in self._all else self._all.values():
            try:
                one.take_back()
            except HapticPlayerError as found:
                problem = found
        if problem is not None:
            raise problem

    def wait_released(self, *, hardware_only: bool = False) -> None:
        """Wait until others can open what was lent or released."""
        for one in (*self._all.values(), *self._released):
            if not hardware_only or is_hardware(one.name):
                one.wait_released()

    def publish(self, clock: PlaybackClock, feedback: str) -> None:
        """Publish where the clip is, each ahead by its latency."""
        for one in self:
            one.publish(clock, feedback)

    def note_frame(self, seen_s: float, frame_s: float) -> None:
        for one in self:
            one.video.event(seen_s - one.latency_s, frame_s)

    def note_sound(self, heard_s: float, media_s: float) -> None:
        for one in self:
            one.audio.event(heard_s - one.latency_s, media_s)

    def states(self, feedback: str) -> tuple[OutputSnapshot, ...]:
        """What a front end shows."""
        return tuple(one.state(feedback) for one in self._all.values())

    def summary(self) -> dict[str, Any]:
        """What was measured of each, for the end of a log."""
        return {one.name: one.summary() for one in self._all.values()}

    def close(self) -> None:
        """Bring all of them to rest and end their processes."""
        for one in self:
            one.close()
        self.wait_released()


def _refuse_alike(names: Sequence[str]) -> None:
    taken = set()
    for name in names:
        if names.count(name) > 1:
            raise UsageError("the output {name} appears twice", name=name)
        use = find_device(name).settings.sole_use
        if use and use in taken:
            raise UsageError("two outputs send {what}; keep one of them", what=use)
        taken.add(use)


def is_hardware(device: str) -> bool:
    """Whether only one process can have the device at a time."""
    if device == NO_DEVICE:
        return False
    entry = find_device(device)
    return not (entry.server or entry.takes_motion)
