"""Devices under /dev/input that can exert a force: the only place that opens them."""

import contextlib
import errno
import fcntl
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from hapticplayer.devices.paced import QuietPort, Translator
from hapticplayer.errors import DeviceError
from hapticplayer.extras.wheels import effects

DEVICES = Path("/dev/input")
CLASS = Path("/sys/class/input")
_WORD_BITS = 64
_GONE = (errno.ENODEV, errno.ENOENT, errno.ENXIO, errno.EIO)
_READ = 16 * effects.EVENT_SIZE


@dataclass(frozen=True, slots=True)
class InputDevice:
    """A device with force feedback: its name under /dev/input, and for people."""

    node: str
    title: str


def list_devices(effect: int, folder: Path = CLASS) -> list[InputDevice]:
    """Return the devices that know a kind of effect, in the order of their numbers."""
    found = []
    nodes = folder.glob("event*") if folder.is_dir() else ()
    for node in sorted(nodes, key=lambda path: (len(path.name), path.name)):
        with contextlib.suppress(OSError, ValueError):  # it was unplugged just now
            if _has_bit((node / "device/capabilities/ff").read_text(), effect):
                title = (node / "device/name").read_text().strip()
                found.append(InputDevice(node.name, title))
    return found


def _has_bit(words: str, bit: int) -> bool:
    """Read a bit mask of the kernel: words of 64 bits in hex, the highest first."""
    numbers = [int(word, 16) for word in words.split()]
    word, place = divmod(bit, _WORD_BITS)
    return word < len(numbers) and bool(numbers[-1 - word] >> place & 1)


class EventPort(QuietPort):
    """An open device (`paced.Port`); the kernel erases its effect when it is closed.

    Raises:
        DeviceError: when it cannot be opened.
    """

    def __init__(self, path: Path, title: str, translator: Translator) -> None:
        self.translator, self._title = translator, title
        self._number = -1
        self._left = b""
        try:
            self._file: int | None = os.open(path, os.O_RDWR | os.O_NONBLOCK)
        except PermissionError as problem:
            raise DeviceError(
                "{title}: permission denied for {path}; add yourself to the group input "
                "and log in again",
                title=title,
                path=str(path),
            ) from problem
        except OSError as problem:
            raise self._failed(problem) from problem

    def write(self, command: bytes) -> None:
        """Upload an effect and start it, or stop it; a blocking call of some ms."""
        effect = effects.with_id(command, self._number)
        count = 0 if effects.is_off(command) else 1
        try:
            fcntl.ioctl(self._descriptor(), effects.UPLOAD, effect)
            self._number = effects.id_of(effect)
            # the guard may have taken the gain away while this loop stood still
            self._tell(effects.FF_GAIN, effects.FULL_GAIN)
            self._tell(self._number, count)
        except OSError as problem:
            raise self._failed(problem) from problem

    def read(self) -> bytes:
        """Return the events that have come."""
        try:
            return os.read(self._descriptor(), _READ)
        except BlockingIOError:
            return b""
        except OSError as problem:
            raise self._failed(problem) from problem

    def close(self) -> None:
        """Erase the effect and let go."""
        if self._file is None:
            return
        with contextlib.suppress(OSError):  # it is gone, and its force with it
            if self._number >= 0:
                fcntl.ioctl(self._file, effects.ERASE, self._number)
        os.close(self._file)
        self._file, self._number = None, -1

    def _descriptor(self) -> int:
        if self._file is None:
            raise self._gone()
        return self._file

    def _tell(self, code: int, value: int) -> None:
        data = effects.event_bytes(effects.EV_FF, code, value)
        os.write(self._descriptor(), data)

    def _failed(self, problem: OSError) -> DeviceError:
        """Why a call failed: unplugged, or what the driver says."""
        if problem.errno in _GONE:
            return self._gone()
        return DeviceError(
            "{title} refuses the effect ({reason}); close other programs that use it, and "
            "choose the device again",
            title=self._title,
            reason=problem.strerror or str(problem),
        )

    def _gone(self) -> DeviceError:
        return DeviceError(
            "{title} was unplugged; plug it in and choose the device again",
            title=self._title,
        )


class GainPort(EventPort):
    """The same device for the guard: whatever is written, nothing is felt any more.

    Effects belong to the program that has uploaded them; the gain to whoever opens the
    device.
    """

    def write(self, _command: bytes) -> None:
        """Take the gain of the whole device away."""
        try:
            self._tell(effects.FF_GAIN, 0)
        except OSError as problem:
            raise self._failed(problem) from problem


def open_first(
    effect: int,
    node: str,
    translate: Callable[[], Translator],
    kind: type[EventPort] = EventPort,
) -> EventPort:
    """Return the device of that name, or the first that knows the effect, open."""
    found = list_devices(effect)
    chosen = [one for one in found if node in ("", one.node)]
    if chosen:
        path = DEVICES / chosen[0].node
        return kind(path, chosen[0].title, translate())
    if node:
        known = ", ".join(f"{one.node} ({one.title})" for one in found) or "none"
        raise DeviceError(
            "/dev/input/{node}: it has no such force feedback; devices that have: {known}",
            node=node,
            known=known,
        )
    raise DeviceError(
        "no device with such force feedback is plugged in; connect it, and see whether "
        "its driver is loaded"
    )
