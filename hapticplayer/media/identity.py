"""Tells whether two files show the same video at the same times, whatever containers they are in.

The checksum is of the payloads of the packets in stored order. It leaves out what
MKVToolNix removes or repeats (access unit delimiters, filler, parameter sets of HEVC): of a
stream without those, `ffmpeg -i FILE -map 0:v:0 -c copy -f streamhash -` computes it too. Times are compared
within what containers round and what muxers move: video and sound together to 0.
"""

import hashlib
import math
from collections.abc import Iterator
from statistics import median

import numpy as np
from av.container import InputContainer
from av.stream import Stream
from av.video.stream import VideoStream
from msgspec import Struct

from hapticplayer.errors import Message
from hapticplayer.media.opening import context_of, origin_s
from hapticplayer.media.packets import AnyPacket

HEAD_PACKETS, _HEAD_OF_SOUND = 32, 8
_PARTS = 64
_LEAST_KEYS = 8
_MOST_WITHOUT_SOUND = 300
CLOSE_MS, _SOUND_CLOSE_MS, _START_CLOSE_MS, _END_CLOSE_MS = 2.0, 40.0, 500.0, 100.0
"""Containers round to 1 ms; muxers let go of the first packet of sound, or displace it."""
_LEFT_OUT = {
    "h264": frozenset((9, 12)),
    "hevc": frozenset((32, 33, 34, 35, 38, 39, 40)),
}
"""Units that other programs remove; of HEVC those that they repeat, too: parameters, SEI."""

_LENGTH_SIZE_AT = {"h264": 4, "hevc": 21}
"""In the decoder's configuration (ISO/IEC 14496-15): the size of a unit's length, less 1."""


class Times(Struct, frozen=True):
    """When the packets of a clip are shown and heard, ms after its first frame.

    Attributes:
        start_ms: of the first frame, by the container's clock.
        parts_ms: mean time of the frames in each of up to 64 equal parts of the video.
        steps_ms: longest step from a frame to the next one in each of these parts.
        head_ms: times of the first packets, as they are stored.
        end_ms: of the last frame.
        sound_ms: begins of the first packets of the first sound, and its end; none without.
    """

    start_ms: float
    parts_ms: tuple[float, ...]
    steps_ms: tuple[float, ...]
    head_ms: tuple[float, ...]
    end_ms: float
    sound_ms: tuple[float, ...] = ()


class VideoDigest(Struct, frozen=True):
    """The video of a clip, whatever container it is in.

    Attributes:
        sha256: of the payloads of its packets, one after the other.
        packets: their number.
        size_bytes: of all of them.
        head_sha256: of the first 32 packets, which tell where not all can be read.
        times: of its packets, and of the sound.
        keys: of some key frames behind the first packets the time, ms, and the SHA-256.
    """

    sha256: str
    packets: int
    size_bytes: int
    head_sha256: str
    times: Times
    keys: tuple[tuple[float, str], ...] = ()

    def difference(self, other: "VideoDigest") -> Message | None:
        """How another video is not this one; None if it is."""
        mine = self.sha256, self.packets, self.size_bytes
        if mine != (other.sha256, other.packets, other.size_bytes):
            return ANOTHER
        return self._other_times(other)

    def other_head(
        self, other: "VideoDigest", ends_ms: tuple[float, ...]
    ) -> Message | None:
        """The same where only the beginning of the other one was read.

        Args:
            other: of the first packets.
            ends_ms: where the whole clip may end by its container, none: unknown.
        """
        if other.head_sha256 != self.head_sha256:
            return ANOTHER
        mine, found = self.times, other.times
        step_ms = mine.end_ms / max(1, self.packets - 1)
        end_ms = max([mine.end_ms + step_ms, *mine.sound_ms[-1:]])
        if ends_ms and all(abs(one - end_ms) > _END_CLOSE_MS for one in ends_ms):
            return RETIMED
        return _differ(mine, found, mine.head_ms, found.head_ms)

    def _other_times(self, other: "VideoDigest") -> Message | None:
        mine, found = self.times, other.times
        before = *mine.parts_ms, *mine.steps_ms, *mine.head_ms, mine.end_ms
        after = *found.parts_ms, *found.steps_ms, *found.head_ms, found.end_ms
        return _differ(mine, found, before, after, is_whole=True)


ANOTHER = Message("its checksum differs")
RETIMED = Message("its frames are shown at other times")
SOUND_MOVED = Message("its sound is heard at other times")


def _differ(
    mine: Times,
    found: Times,
    before: tuple[float, ...],
    after: tuple[float, ...],
    *,
    is_whole: bool = False,
) -> Message | None:
    # every muxer may let a clip begin at 0, none puts it off
    if min(abs(found.start_ms), abs(found.start_ms - mine.start_ms)) > _START_CLOSE_MS:
        return RETIMED
    pairs = zip(before, after, strict=False)
    if len(before) != len(after) or any(abs(a - b) > CLOSE_MS for a, b in pairs):
        return RETIMED
    if mine.sound_ms and found.sound_ms:
        begins = zip(mine.sound_ms[:-1], found.sound_ms[:-1], strict=False)
        moved_ms = [median(b - a for a, b in begins)]
        moved_ms += [found.sound_ms[-1] - mine.sound_ms[-1]] * is_whole
        if max(map(abs, moved_ms)) > _SOUND_CLOSE_MS:
            return SOUND_MOVED
    return None


class Counter:
    """Takes the identity of a clip from the packets of its video and its first sound."""

    def __init__(self, container: InputContainer, video: VideoStream) -> None:
        self._digest, self._head = hashlib.sha256(), hashlib.sha256()
        self._packets = self._size_bytes = 0
        self.video, self._container = video, container
        self._sound = next((s for s in container.streams.audio if context_of(s)), None)
        self._origin_ms = 1000.0 * origin_s(container)
        self._units = _units_of(video)
        self._times_ms: list[float] = []
        self._sound_ms: list[float] = []
        self._sound_end_ms = -math.inf
        self._keys: list[tuple[float, str]] = []
        self._key_number, self._key_step = 0, 1

    @property
    def streams(self) -> list[Stream]:
        return [self.video, *([self._sound] if self._sound else [])]

    @property
    def has_head(self) -> bool:
        """Whether so much was taken as a remote clip is known by."""
        is_heard = self._sound is None or len(self._sound_ms) == _HEAD_OF_SOUND
        is_enough = is_heard or self._packets >= _MOST_WITHOUT_SOUND
        return self._packets >= HEAD_PACKETS and is_enough

    @property
    def promised(self) -> int:
        """How many packets the index of the video names; 0: unknown, as of fragments."""
        count = self.video.frames
        return count if count == len(self.video.index_entries) else 0

    @property
    def ends_ms(self) -> tuple[float, ...]:
        """Where the container says that it ends: in Matroska from 0 or from its first packet."""
        length = self._container.duration or 0
        starts = {self._container.start_time or 0}
        if "matroska" in self._container.format.name:
            starts.add(0)
        ends = (length + start for start in starts if length)
        return tuple(end / 1000.0 - self._origin_ms for end in ends)

    def add(self, packet: AnyPacket) -> None:
        """Take the next packet of any stream."""
        if packet.stream_index == self.video.index:
            self._add_video(packet)
        elif self._sound is not None and packet.stream_index == self._sound.index:
            at_ms = self.at_ms(packet)
            end_ms = at_ms + _ms(packet.duration or 0, packet)
            self._sound_end_ms = max(self._sound_end_ms, end_ms)
            if len(self._sound_ms) < _HEAD_OF_SOUND:
                self._sound_ms.append(at_ms)

    def _add_video(self, packet: AnyPacket) -> None:
        is_head = self._packets < HEAD_PACKETS
        for part in self._units(packet):
            self._digest.update(part)
            self._size_bytes += len(part)
            if is_head:
                self._head.update(part)
        self._packets += 1
        self._times_ms.append(self.at_ms(packet))
        if packet.is_keyframe and not is_head:
            self._add_key(packet)

    def _add_key(self, packet: AnyPacket) -> None:
        """Keep every so many of them, of which there are at most twice as many as needed."""
        self._key_number += 1
        if self._key_number % self._key_step == 0:
            self._keys.append((round(self.at_ms(packet), 3), self.sha256(packet)))
        if len(self._keys) == 2 * _LEAST_KEYS:
            del self._keys[::2]
            self._key_step *= 2

    def sha256(self, packet: AnyPacket) -> str:
        """The checksum of what counts of a packet of the video."""
        return hashlib.sha256(b"".join(self._units(packet))).hexdigest()

    def at_ms(self, packet: AnyPacket) -> float:
        """When a packet is shown or heard after the first frame."""
        stamp = packet.dts if packet.pts is None else packet.pts
        return _ms(stamp or 0, packet) - self._origin_ms

    def ticks(self, at_ms: float) -> int:
        """The time stamp of a frame of the video."""
        at_s = (at_ms + self._origin_ms) / 1000.0
        return round(at_s / (self.video.time_base or 1))

    def digest(self) -> VideoDigest:
        """The identity of what was taken."""
        return VideoDigest(
            self._digest.hexdigest(),
            self._packets,
            self._size_bytes,
            self._head.hexdigest(),
            self._times(),
            tuple(self._keys),
        )

    def _times(self) -> Times:
        stored = np.array(self._times_ms, np.float64)
        shown = np.sort(stored)
        parts = [part for part in np.array_split(stored, _PARTS) if part.size]
        steps = [part for part in np.array_split(np.diff(shown), _PARTS) if part.size]
        sound_end = [self._sound_end_ms] if self._sound_ms else []
        return Times(
            round(self._origin_ms, 3),
            tuple(round(float(part.mean()), 3) for part in parts),
            tuple(round(float(part.max()), 3) for part in steps),
            tuple(round(one, 3) for one in self._times_ms[:HEAD_PACKETS]),
            round(float(shown[-1]), 3) if shown.size else 0.0,
            tuple(round(one, 3) for one in (*self._sound_ms, *sound_end)),
        )


def _ms(ticks: int, packet: AnyPacket) -> float:
    base = packet.time_base
    return 1000.0 * ticks * base.numerator / base.denominator if base else 0.0


class _units_of:  # noqa: N801 - used as a function
    """Yields the parts of a packet that count."""

    def __init__(self, video: VideoStream) -> None:
        codec = video.codec_context.name
        extradata = video.codec_context.extradata or b""
        self._left_out = _LEFT_OUT.get(codec, frozenset())
        # MKVToolNix puts the header of MPEG-4 part 2 before the first frame
        self._header = extradata if codec == "mpeg4" else b""
        at = _LENGTH_SIZE_AT.get(codec, 0)
        self._is_hevc = codec == "hevc"
        has_lengths = len(extradata) > at > 0 and extradata[0] == 1
        self._size = (extradata[at] & 3) + 1 if has_lengths else 0

    def __call__(self, packet: AnyPacket) -> Iterator[memoryview]:
        content = memoryview(packet)
        if not self._size:
            begin = len(self._header)
            is_headed = begin and content[:begin] == self._header
            yield content[begin:] if is_headed else content
            return
        begin = at = 0
        while at + self._size < len(content):
            length = int.from_bytes(content[at : at + self._size], "big")
            head = content[at + self._size]
            kind = head >> 1 & 0x3F if self._is_hevc else head & 0x1F
            end = at + self._size + length
            if kind in self._left_out:
                yield content[begin:at]
                begin = min(end, len(content))
            at = end
        yield content[begin:]
