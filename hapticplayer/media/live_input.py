"""Cameras and microphones, read live, with stamps on the machine's monotonic clock.

A device stamps its frames by one of the machine's two clocks (`v4l2` the monotonic one,
`alsa` the wall clock). The first stamp tells which; one of neither is refused.
"""

import os
from collections.abc import Iterator
from contextlib import AbstractContextManager
from fractions import Fraction
from typing import NamedTuple

import av
import av.error
from av.audio.stream import AudioStream
from av.container import InputContainer
from av.device import enumerate_input_devices
from av.video.stream import VideoStream

from hapticplayer.clock import Clock, realtime_minus_monotonic_s
from hapticplayer.errors import InputError, Message
from hapticplayer.media.opening import media_errors
from hapticplayer.media.packets import AnyPacket

CAMERAS, MICROPHONES, TEST = "v4l2", "alsa", "lavfi"
"""Formats of FFmpeg; the last one is a test source, as `lavfi:GRAPH`."""

MOST_APART_S = 1.0
"""A stamp farther from now was not taken by this clock."""

_BY_NOW = {
    CAMERAS: ("setpts", "settb=1/1000000,realtime,setpts=RTCTIME/1000000/TB"),
    MICROPHONES: ("asetpts", "asettb=1/1000000,arealtime,asetpts=RTCTIME/1000000/TB"),
}
"""Of a test source that does not stamp: in real time, by the wall clock."""

_USUAL_RATE_HZ = Fraction(30)
_COPIED = ("h264", "mjpeg")
"""What a camera has compressed is kept as it is."""


class Live(NamedTuple):
    """A packet, and when the machine's monotonic clock says that it was taken."""

    packet: AnyPacket
    host_s: float


class Stamps:
    """Turns the stamps of a device into times of the monotonic clock."""

    def __init__(self, name: str, wall_minus_monotonic_s: float) -> None:
        self._name, self._wall_s = name, wall_minus_monotonic_s
        self._origin_s: float | None = None

    def host_s(self, stamp_s: float | None, now_s: float) -> float | None:
        """The time of a stamp; None for one that cannot be.

        Raises:
            InputError: when the first one is of neither of the machine's clocks.
        """
        if stamp_s is None:
            return None
        if self._origin_s is None:
            self._origin_s = self._find_origin_s(stamp_s, now_s)
        host_s = stamp_s - self._origin_s
        return host_s if abs(host_s - now_s) < MOST_APART_S else None

    def _find_origin_s(self, stamp_s: float, now_s: float) -> float:
        for origin_s in (0.0, self._wall_s):
            if abs(stamp_s - origin_s - now_s) < MOST_APART_S:
                return origin_s
        raise InputError(
            "its time stamps are {apart_s:.1f} s from this machine's clock, so nothing "
            "could be synchronised with it",
            where=self._name,
            remedy="choose another camera or microphone, or unload and load the driver "
            "(uvcvideo with clock=CLOCK_MONOTONIC)",
            apart_s=stamp_s - now_s,
        )

    @property
    def clock(self) -> str:
        """Which one, for the description of a recording."""
        return "wall" if self._origin_s else "monotonic"


class LiveInput:
    """An open camera or microphone.

    Args:
        name: of the device, as listed, with options of FFmpeg's behind commas
            (`/dev/video0,video_size=1280x720`); or `lavfi:GRAPH`.
        kind: `CAMERAS` or `MICROPHONES`.
        clock: the machine's.
    """

    def __init__(self, name: str, kind: str, clock: Clock) -> None:
        self.name, self._kind, self._clock = name, kind, clock
        self._stamps = Stamps(name, realtime_minus_monotonic_s())
        self.undated = 0
        with self._failing("cannot be opened"):
            self._container = open_device(name, kind)
            found = self._container.streams
            self._stream = (found.video if kind == CAMERAS else found.audio)[0]

    @property
    def clock_name(self) -> str:
        return self._stamps.clock

    @property
    def video(self) -> VideoStream:
        assert isinstance(self._stream, VideoStream)
        return self._stream

    @property
    def sound(self) -> AudioStream:
        assert isinstance(self._stream, AudioStream)
        return self._stream

    @property
    def rate_hz(self) -> Fraction:
        """That a camera promises."""
        return self.video.average_rate or self.video.guessed_rate or _USUAL_RATE_HZ

    @property
    def is_copied(self) -> bool:
        """Whether its packets are kept as they are."""
        return self._kind == CAMERAS and self.video.codec_context.name in _COPIED

    def packets(self) -> Iterator[Live]:
        """What it delivers from now on.

        Raises:
            InputError: when it stops, as one that is unplugged does.
        """
        with self._failing("delivers nothing more"):
            for packet in self._container.demux(self._stream):
                now_s = self._clock.now_s()
                if not packet.size:
                    break
                stamp_s = (
                    None if packet.pts is None else float(packet.pts * _base(packet))
                )
                host_s = self._stamps.host_s(stamp_s, now_s)
                if host_s is None:
                    self.undated += 1
                else:
                    yield Live(packet, host_s)
        raise InputError(
            "delivers nothing more (it has ended)",
            where=self.name,
            remedy="check its cable and record again",
        )

    def close(self) -> None:
        self._container.close()

    def _failing(self, what: str) -> AbstractContextManager[None]:
        return media_errors(
            self.name,
            Message(what),
            Message("check its cable and its name (`hapticplayer record --list`)"),
        )


def _base(packet: AnyPacket) -> float:
    assert packet.time_base is not None
    return float(packet.time_base)


def open_device(name: str, kind: str) -> InputContainer:
    if name.startswith(f"{TEST}:"):
        graph = name.partition(":")[2]
        has, by_now = _BY_NOW[kind]
        stamped = graph if has in graph else f"{graph},{by_now}"
        return av.open(stamped, "r", format=TEST)
    # the library that PyAV brings along looks for it where it was built
    os.environ.setdefault("ALSA_CONFIG_PATH", "/usr/share/alsa/alsa.conf")
    device, *settings = name.split(",")
    options = dict(one.partition("=")[::2] for one in settings)
    return av.open(device, "r", format=kind, options=options)


def device_names(kind: str) -> tuple[tuple[str, str], ...]:
    """Names and descriptions of the cameras or microphones that are plugged in."""
    try:
        found = enumerate_input_devices(kind)
    except (av.error.FFmpegError, OSError, ValueError, RuntimeError):
        return ()
    return tuple((one.name, one.description) for one in found)
