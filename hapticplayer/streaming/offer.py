"""What a server offers: a clip and its force by name, nothing else."""

import re
from collections.abc import Callable
from dataclasses import dataclass
from http import HTTPStatus
from typing import BinaryIO

import numpy as np

from hapticplayer.errors import InputError, NetworkError
from hapticplayer.haptics.streamed_track import RATE_HZ
from hapticplayer.model import ForceTrack
from hapticplayer.playback.source import Source
from hapticplayer.streaming.manifest import MANIFEST, Manifest
from hapticplayer.streaming.packets import encoded, packets_of
from hapticplayer.untrusted import (
    MAX_PACKETS_AT_ONCE,
    MAX_STREAM_S,
    MAX_STREAM_TRACKS,
    FileState,
    open_regular,
)

_CLIP, _FORCE = "clip", re.compile(r"force/(\d{1,2})/(\d{1,8})-(\d{1,8})")
_BYTES = re.compile(r"bytes=(\d{0,18})-(\d{0,18})")
_MEDIA_TYPES = {
    ".mkv": "video/x-matroska",
    ".mp4": "video/mp4",
    ".mov": "video/quicktime",
    ".webm": "video/webm",
}


@dataclass(frozen=True, slots=True)
class Response:
    """An answer to a request.

    Attributes:
        status: of HTTP.
        media_type: of the content.
        content: in memory.
        headers: besides length and type.
        open_clip: opens the clip where a part of it is the content.
        first, count: that part, bytes.
    """

    status: HTTPStatus
    media_type: str = "text/plain"
    content: bytes = b""
    headers: tuple[tuple[str, str], ...] = ()
    open_clip: Callable[[], BinaryIO] | None = None
    first: int = 0
    count: int = 0

    @property
    def size_bytes(self) -> int:
        """Length of the content."""
        return self.count if self.open_clip else len(self.content)


class Offer:
    """The resources of one source.

    Raises:
        NetworkError: when there is no force in it, or it is too long.
        InputError: when the clip cannot be read.
    """

    def __init__(self, source: Source) -> None:
        path, duration_s = source.clip.path, source.clip.duration_s
        named = dict(list(source.tracks.items())[:MAX_STREAM_TRACKS])
        if not any(track.peak_n() > 0.0 for track in named.values()):
            raise NetworkError(
                "holds no force",
                where=str(source.path),
                remedy="import it with its motion, or serve a file that was packed",
            )
        if duration_s > MAX_STREAM_S:
            raise NetworkError(
                "is longer than {most_h:g} h",
                where=str(source.path),
                remedy="send it as a file",
                most_h=MAX_STREAM_S / 3600.0,
            )
        self._state = FileState.of(path)
        self._tracks: tuple[ForceTrack, ...] = tuple(named.values())
        self.manifest = Manifest(
            source.title[:200],
            path.name,
            self._state.size_bytes,
            int(np.ceil(duration_s * RATE_HZ)) + 1,
            tuple(named),
            source.feedback,
        )

    def answer(self, resource: str, byte_range: str | None) -> Response:
        """Return what is to be sent for the name of a resource."""
        if resource in ("", MANIFEST):
            return Response(HTTPStatus.OK, "application/json", self.manifest.to_json())
        if resource == _CLIP:
            return self._clip(byte_range)
        if found := _FORCE.fullmatch(resource):
            return self._force(*map(int, found.groups()))
        return Response(HTTPStatus.NOT_FOUND)

    def _force(self, track: int, first: int, last: int) -> Response:
        end = min(
            last + 1,
            first + MAX_PACKETS_AT_ONCE,
            packets_of(self.manifest.samples),
        )
        if track >= len(self._tracks) or first >= end:
            return Response(HTTPStatus.NOT_FOUND)
        content = encoded(self._tracks[track], track, first, end)
        return Response(HTTPStatus.OK, "application/octet-stream", content)

    def _clip(self, byte_range: str | None) -> Response:
        try:
            self._state.refuse_changed()
        except InputError:
            return Response(HTTPStatus.GONE)
        size = self._state.size_bytes
        media_type = _MEDIA_TYPES.get(
            self._state.path.suffix.lower(), "application/octet-stream"
        )
        span = wanted_bytes(byte_range, size)
        if span is None:
            whole = (("Content-Range", f"bytes */{size}"),)
            return Response(HTTPStatus.REQUESTED_RANGE_NOT_SATISFIABLE, headers=whole)
        first, end = span
        headers: tuple[tuple[str, str], ...] = (("Accept-Ranges", "bytes"),)
        status = HTTPStatus.OK
        if byte_range and _BYTES.fullmatch(byte_range):
            status = HTTPStatus.PARTIAL_CONTENT
            headers += (("Content-Range", f"bytes {first}-{end - 1}/{size}"),)
        return Response(
            status, media_type, b"", headers, self._open, first, end - first
        )

    def _open(self) -> BinaryIO:
        return open_regular(self._state.path)


def wanted_bytes(byte_range: str | None, size: int) -> tuple[int, int] | None:
    """Return begin and end of a range, None where it cannot be met (RFC 9110, 14.2).

    A header that is not one range of bytes is ignored.
    """
    found = _BYTES.fullmatch(byte_range or "")
    if found is None or found.groups() == ("", ""):
        return 0, size
    first, last = found.groups()
    if not first:
        begin, end = max(0, size - int(last)), size
    else:
        begin, end = int(first), min(size, int(last) + 1) if last else size
    return (begin, end) if begin < end else None
