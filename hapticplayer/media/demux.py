"""Reads and decodes the packets of one stream, past damaged ones."""

import abc
from collections import deque
from collections.abc import Iterable, Iterator
from typing import Generic, Self, TypeVar, cast

import av.error
from av.container import InputContainer
from av.frame import Frame
from av.stream import Stream
from av.video.frame import VideoFrame

from hapticplayer.errors import MediaError, Message
from hapticplayer.media.clip_bytes import AnyClip
from hapticplayer.media.opening import media_errors, open_media
from hapticplayer.media.packets import (
    MARKED,
    ONE_TO_ONE,
    AnyPacket,
    Continuity,
    Lookahead,
)
from hapticplayer.model.limits import MAX_DAMAGED_IN_A_ROW
from hapticplayer.untrusted import COPY_AGAIN

FrameT = TypeVar("FrameT")


class PacketReader(Generic[FrameT]):
    """Decoded frames of one stream; packets that fail are counted.

    Attributes:
        damaged: packets that could not be decoded so far, frames that are missing,
            and frames that the decoder had to make up in part.
    """

    def __init__(
        self, container: InputContainer, stream: Stream, path: AnyClip
    ) -> None:
        self._container = container
        self._stream = stream
        self._path = path
        self._packets: Iterator[AnyPacket] = container.demux(stream)
        self._frames: deque[FrameT] = deque()
        self._bad_in_a_row = 0
        self._may_be_leading = False
        self._broken = 0
        is_video = stream.type == "video"
        self._continuity = Continuity(stream) if is_video else None
        self._codec = stream.codec_context
        self._lookahead: Lookahead | None = None

    @property
    def damaged(self) -> int:
        """See the class."""
        return self._broken + (self._continuity.missing if self._continuity else 0)

    def seek(self, ticks: int) -> None:
        """Go to the key frame at or before `ticks` of the stream's time base.

        Raises:
            MediaError: when the container cannot be positioned at all.
        """
        self._frames.clear()
        self._end_lookahead()
        self._bad_in_a_row = 0
        self._may_be_leading = True
        if self._continuity:
            self._continuity.restart()
        with media_errors(self._path, Message("cannot be positioned")):
            try:
                self._container.seek(ticks, stream=self._stream, backward=True)
            except (av.error.FFmpegError, OSError):
                # some demuxers refuse positions before their first key frame
                self._container.seek(ticks, stream=self._stream, backward=False)
        self._packets = self._container.demux(self._stream)

    def read_ahead(self, ticks: int) -> int | None:
        """After `seek`: leave out of the decoding what only leads to `ticks`.

        Returns:
            the time stamp of the frame that covers `ticks`, None where unknown.
        """
        if self._codec.name not in ONE_TO_ONE:
            return None
        self._lookahead = Lookahead(is_marked=self._codec.name in MARKED)
        with media_errors(self._path, Message("it cannot be read any further")):
            try:
                self._lookahead.read(self._packets, ticks)
            except av.error.InvalidDataError as error:
                self._count_damage(error)
                self._packets = self._container.demux(self._stream)
        return self._lookahead.wanted

    def _end_lookahead(self) -> None:
        """Decode everything from here on."""
        if self._lookahead:
            self._lookahead = None
            self._codec.skip_frame = "DEFAULT"

    def _next_packet(self) -> AnyPacket | None:
        """Return the next packet, those first that were read ahead."""
        packet = self._lookahead.pop() if self._lookahead else None
        if packet is None:
            self._end_lookahead()
            packet = next(self._packets, None)
        elif self._is_skipped(packet.pts):
            self._codec.skip_frame = "NONREF"
        else:
            self._codec.skip_frame = "DEFAULT"
        return packet

    def _is_skipped(self, pts: int | None) -> bool:
        return self._lookahead is not None and self._lookahead.is_skipped(pts)

    def next_frame(self) -> FrameT | None:
        """Return the next frame, None at the end; raises MediaError if that fails."""
        while not self._frames:
            with media_errors(self._path, Message("it cannot be decoded any further")):
                if not self._decode_next():
                    if self._continuity:
                        self._continuity.end()
                    return None
        return self._frames.popleft()

    def _decode_next(self) -> bool:
        """Read and decode one packet; False at the end of the stream."""
        try:
            packet = self._next_packet()
        except av.error.InvalidDataError as error:
            self._count_damage(error)
            self._packets = self._container.demux(self._stream)
            return True
        if packet is None:
            return False
        if self._continuity and not self._is_skipped(packet.pts):
            self._continuity.send(packet)
        try:
            frames = packet.decode()
        except EOFError:  # the decoder was drained before
            return False
        except MemoryError:
            raise
        except av.error.FFmpegError as error:
            # decoders return all kinds of codes for damage, even EPERM (-1)
            self._count_damage(error)
            return True
        if frames:
            self._bad_in_a_row = 0
            self._note_corrupt(frames)
            self._frames.extend(cast("list[FrameT]", frames))
        return True

    def _note_corrupt(self, frames: Iterable[Frame]) -> None:
        """Count frames with holes.

        After a seek, those before the first key frame lack what they refer to in
        every file with open groups of pictures; that is no damage.
        """
        for frame in frames:
            is_key = not isinstance(frame, VideoFrame) or frame.key_frame
            self._may_be_leading = self._may_be_leading and not is_key
            self._broken += frame.is_corrupt and not self._may_be_leading
            if not isinstance(frame, VideoFrame) or self._is_skipped(frame.pts):
                continue
            if self._continuity:
                self._continuity.receive(frame)

    def _count_damage(self, error: Exception) -> None:
        self._broken += 1
        self._bad_in_a_row += 1
        if self._bad_in_a_row > MAX_DAMAGED_IN_A_ROW:
            raise MediaError(
                "{count} packets in a row are damaged",
                where=str(self._path),
                remedy=COPY_AGAIN,
                count=self._bad_in_a_row,
            ) from error


class ClipDecoder(abc.ABC, Generic[FrameT]):
    """What the decoders of video and of sound share: an open clip and its damage."""

    _WHAT: Message
    """What is said of a clip that cannot be set up."""

    _reader: PacketReader[FrameT]

    def __init__(self, path: AnyClip) -> None:
        self._path = path
        self._container = open_media(path)
        try:
            with media_errors(path, self._WHAT):
                self._set_up()
        except BaseException:
            self._container.close()
            raise

    @abc.abstractmethod
    def _set_up(self) -> None:
        """Choose the stream, and read it with `_reader`."""

    @property
    def damaged(self) -> int:
        """Packets and frames that were not whole so far."""
        return self._reader.damaged

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Release the file and the decoder."""
        self._container.close()
