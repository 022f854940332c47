"""Effects and events of Linux's force feedback as bytes.

Source: <linux/input.h>, struct ff_effect (48 bytes) and struct input_event. An effect
lasts `LENGTH_MS` and is refreshed while it is on: the effect of a stalled program ends
by itself.
"""

import struct
from collections.abc import Iterator
from typing import NamedTuple

from hapticplayer.devices.paced import FULL_LEVEL, Rumble
from hapticplayer.model.device import Vector

EV_SYN, EV_KEY, EV_FF = 0x00, 0x01, 0x15
FF_RUMBLE, FF_CONSTANT, FF_GAIN = 0x50, 0x52, 0x60
SYN_DROPPED = 3
UPLOAD = 0x40304580  # EVIOCSFF
ERASE = 0x40044581  # EVIOCRMFF
FULL_GAIN = 0xFFFF
LENGTH_MS = 250
REFRESH_S = 0.1
"""Well below LENGTH_MS."""
_FULL_CONSTANT = 32767
_NEW = -1
_LEFT = 0x4000  # direction of a wheel's force: of the one axis that it has
_HEAD = struct.Struct("=HhHHHHHxx")
_CONSTANT = struct.Struct("=hHHHH22x")
_RUMBLE = struct.Struct("=HH28x")
_EVENT = struct.Struct("@llHHi")
EVENT_SIZE = _EVENT.size
_FIRST_BUTTON = 0x100


class InputEvent(NamedTuple):
    """An input event without its time."""

    kind: int
    code: int
    value: int


def constant_effect(level: int) -> bytes:
    """Return a constant force of -32767 to 32767; others raise struct.error."""
    return _effect(FF_CONSTANT, _CONSTANT.pack(level, 0, 0, 0, 0))


def rumble_effect(strong: int, weak: int) -> bytes:
    """Return a rumble, each 0 to 65535; others raise struct.error."""
    return _effect(FF_RUMBLE, _RUMBLE.pack(strong, weak))


def _effect(kind: int, rest: bytes) -> bytes:
    return _HEAD.pack(kind, _NEW, _LEFT, 0, 0, LENGTH_MS, 0) + rest


def with_id(effect: bytes, number: int) -> bytearray:
    changed = bytearray(effect)
    struct.pack_into("=h", changed, 2, number)
    return changed


def id_of(effect: bytes | bytearray) -> int:
    """Return the number of an effect, -1 before the kernel has given one."""
    return int(struct.unpack_from("=h", effect, 2)[0])


def is_off(effect: bytes) -> bool:
    """Return whether an effect exerts nothing."""
    return not any(effect[16:20])


def event_bytes(kind: int, code: int, value: int) -> bytes:
    """Return an input event as it is written."""
    return _EVENT.pack(0, 0, kind, code, value)


def events_of(data: bytes) -> Iterator[InputEvent]:
    """Yield the events of what was read; what is no whole event is left out."""
    for at in range(0, len(data) - EVENT_SIZE + 1, EVENT_SIZE):
        _s, _us, kind, code, value = _EVENT.unpack_from(data, at)
        yield InputEvent(kind, code, value)


class _Buttons:
    """Keeps what is pressed; the kernel tells changes."""

    def __init__(self) -> None:
        self._pressed = 0

    def buttons(self, report: bytes) -> int | None:
        """Return the mask after some events; None where they are none."""
        if not report or len(report) % EVENT_SIZE:
            return None
        for event in events_of(report):
            if event.kind == EV_KEY and event.code >= _FIRST_BUTTON:
                bit = 1 << (event.code & 0x0F)
                self._pressed = self._pressed & ~bit | (bit if event.value else 0)
            elif event.kind == EV_SYN and event.code == SYN_DROPPED:
                self._pressed = 0  # some were lost; a press is reported again
        return self._pressed


class ConstantForceTranslator(_Buttons):
    """A force along one axis as a constant effect (`paced.Translator`).

    Args:
        axis: 0, 1, 2 for x, y, z of frame D.
        full_n: force at which the device does all it can; negative turns it round.
    """

    off = constant_effect(0)

    def __init__(self, axis: int, full_n: float) -> None:
        super().__init__()
        self._axis, self._full_n = axis, full_n

    def command(self, force_n: Vector, _now_s: float) -> bytes:
        """Return the effect of a force; not a number is none."""
        share = force_n[self._axis] / self._full_n
        if not -1e9 < share < 1e9:
            return self.off
        return constant_effect(round(_FULL_CONSTANT * max(-1.0, min(1.0, share))))


class RumbleTranslator(_Buttons):
    """A force without its direction as a rumble (`paced.Translator`)."""

    off = rumble_effect(0, 0)

    def __init__(self) -> None:
        super().__init__()
        self._rumble = Rumble()

    def command(self, force_n: Vector, now_s: float) -> bytes:
        """Return the rumble of a force."""
        strong, weak = self._rumble.levels(force_n, now_s)
        return rumble_effect(
            *(level * 0xFFFF // FULL_LEVEL for level in (strong, weak))
        )
