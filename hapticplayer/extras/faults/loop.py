"""The loop with faults in it, for developers; only for simulated devices."""

import math
from typing import Any

from hapticplayer.extras.faults.injected import LATE_S, LOST_S, STALE_S, Fault
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.loop import Loop
from hapticplayer.haptics.messages import MessageKind
from hapticplayer.model.device import Vector

_NANS: Vector = (math.nan, math.nan, math.nan)
_DELAYS_S = {Fault.LOOP_LATE: LATE_S, Fault.LOOP_LOST: LOST_S}


class _NonFiniteTrack:
    """A track of NaN."""

    end_s = math.inf

    def force_at(self, _media_s: float) -> Vector:
        """A track that no check at load can have let through."""
        return _NANS

    def is_silent(self, _now_s: float) -> bool:
        return False


class FaultyLoop(Loop):
    """Injects each requested fault once, as soon as a force may be on."""

    def __post_init__(self) -> None:
        super().__post_init__()
        self._pending: set[Fault] = set()
        self._sound: Any = None

    def tick(self, now_s: float, late_s: float = 0.0, missed: int = 0) -> None:
        """Do one period, then stall if that is requested."""
        super().tick(now_s, late_s, missed)
        for fault, delay_s in _DELAYS_S.items():
            if self._is_due(fault):
                self.clock.sleep_until(now_s + delay_s)

    def _inject(self, text: str) -> None:
        if text in Fault.__members__.values():
            self._pending.add(Fault(text))
        else:
            self.line.send(MessageKind.FAILED, f"there is no fault {text!r}")

    def _is_due(self, fault: Fault) -> bool:
        is_acting = self.state.mode in (Mode.ENTERING, Mode.FOLLOWING)
        if fault not in self._pending or not is_acting:
            return False
        self._pending.discard(fault)
        return True

    def _read_clock(self, count: int) -> None:
        if self._sound is not None:
            self._track, self._sound = self._sound, None
        super()._read_clock(count)
        if self._track is not None and self._is_due(Fault.FORCE_NAN):
            self._sound, self._track = self._track, _NonFiniteTrack()  # type: ignore[assignment]

    def _exchange(self, force_n: Vector, now_s: float) -> None:
        if self._is_due(Fault.STALE_COMMAND):
            self.clock.sleep_until(now_s + STALE_S)
        before = self.reading
        super()._exchange(force_n, now_s)
        if self.reading is None or before is None:
            return
        # a reading that is known already is not checked again
        is_new = self.reading.replied_s > before.replied_s
        if is_new and self._is_due(Fault.POSITION_NAN):
            self.reading = self.reading._replace(position_m=_NANS)
