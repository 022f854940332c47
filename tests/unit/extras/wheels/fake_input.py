"""A kernel with one device of force feedback: effects, gain, and who owns them.

As drivers/input/ff-core.c and ff-memless.c: an effect belongs to the file that uploaded
it, ends after its length, is erased when its file is closed; the gain is the device's.
"""

import ctypes
import errno
import os
from collections import deque

from hapticplayer.extras.wheels import ports


class Envelope(ctypes.Structure):
    _fields_ = tuple((name, ctypes.c_uint16) for name in ("al", "a", "fl", "f"))


class Constant(ctypes.Structure):
    _fields_ = (("level", ctypes.c_int16), ("envelope", Envelope))


class Rumble(ctypes.Structure):
    _fields_ = (("strong", ctypes.c_uint16), ("weak", ctypes.c_uint16))


class Periodic(ctypes.Structure):
    """Its pointer gives the union its size and alignment."""

    _fields_ = (
        ("waveform", ctypes.c_uint16),
        ("period", ctypes.c_uint16),
        ("magnitude", ctypes.c_int16),
        ("offset", ctypes.c_int16),
        ("phase", ctypes.c_uint16),
        ("envelope", Envelope),
        ("custom_len", ctypes.c_uint32),
        ("custom_data", ctypes.c_void_p),
    )


class Kinds(ctypes.Union):
    _fields_ = (("constant", Constant), ("rumble", Rumble), ("periodic", Periodic))


class Effect(ctypes.Structure):
    """struct ff_effect of <linux/input.h>, laid out by the C compiler's rules."""

    _fields_ = (
        ("type", ctypes.c_uint16),
        ("id", ctypes.c_int16),
        ("direction", ctypes.c_uint16),
        ("button", ctypes.c_uint16),
        ("interval", ctypes.c_uint16),
        ("length", ctypes.c_uint16),
        ("delay", ctypes.c_uint16),
        ("u", Kinds),
    )


class InputEvent(ctypes.Structure):
    """struct input_event."""

    _fields_ = (
        ("sec", ctypes.c_long),
        ("usec", ctypes.c_long),
        ("type", ctypes.c_uint16),
        ("code", ctypes.c_uint16),
        ("value", ctypes.c_int32),
    )


class FakeInput:
    """Stands in for os and fcntl in `ports`; times are those of a manual clock."""

    O_RDWR, O_NONBLOCK = os.O_RDWR, os.O_NONBLOCK

    def __init__(self, clock, monkeypatch, title="Wheel"):
        self.clock, self.title = clock, title
        self.is_plugged, self.is_allowed = True, True
        self.gain, self.garbage, self.refusal = 0xFFFF, 0, 0
        self.effects, self.playing = {}, {}
        self.waiting = deque()
        self._next = 10**6  # no descriptor of this process
        monkeypatch.setattr(ports, "os", self)
        monkeypatch.setattr(ports, "fcntl", self)
        monkeypatch.setattr(
            ports,
            "list_devices",
            lambda _kind: [ports.InputDevice("event3", self.title)],
        )

    def open(self, path, flags):
        assert flags == os.O_RDWR | os.O_NONBLOCK
        self._check()
        if not self.is_allowed:
            raise PermissionError(errno.EACCES, "no", str(path))
        self._next += 1
        return self._next

    def close(self, file):
        for number in [n for n, (owner, _) in self.effects.items() if owner == file]:
            self._erase(number)

    def read(self, _file, _size):
        self._check()
        if self.garbage:
            self.garbage -= 1
            return b"\x01" * 7
        if not self.waiting:
            raise BlockingIOError
        return self.waiting.popleft()

    def write(self, _file, data):
        self._check()
        event = InputEvent.from_buffer_copy(data)
        assert event.type == 0x15
        if event.code == 0x60:
            self.gain = event.value
        elif event.value:
            self.playing[event.code] = self.clock.now_s()
        else:
            self.playing.pop(event.code, None)
        return len(data)

    def ioctl(self, file, request, argument):
        self._check()
        if request == 0x40044581:
            self._erase(argument)
            return 0
        assert request == 0x40304580
        if self.refusal:
            raise OSError(self.refusal, os.strerror(self.refusal))
        effect = Effect.from_buffer(argument)
        if effect.id == -1:
            effect.id = len(self.effects)
        elif self.effects[effect.id][0] != file:
            raise PermissionError(errno.EACCES, "not yours")
        self.effects[effect.id] = (file, Effect.from_buffer_copy(argument))
        return 0

    def press(self, code, value=1):
        self.waiting.append(bytes(InputEvent(0, 0, 1, code, value)))

    @property
    def felt(self):
        """The parts of the union that play now: a level, or strong and weak."""
        found = []
        for number, begun_s in self.playing.items():
            effect = self.effects[number][1]
            if self.clock.now_s() - begun_s < effect.length / 1000.0:
                found.append(effect)
        if not found or not self.gain:
            return (0, 0)
        effect = found[-1]
        if effect.type == 0x52:
            return (effect.u.constant.level, 0)
        return (effect.u.rumble.strong, effect.u.rumble.weak)

    def _erase(self, number):
        self.effects.pop(number, None)
        self.playing.pop(number, None)

    def _check(self):
        if not self.is_plugged:
            raise OSError(errno.ENODEV, "gone")
