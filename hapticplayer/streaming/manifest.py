"""The manifest of a stream: what a client reads before it requests anything."""

import json
from dataclasses import dataclass
from typing import Annotated

from msgspec import Meta, Struct

from hapticplayer import __version__
from hapticplayer.errors import Message, NetworkError
from hapticplayer.haptics.streamed_track import PACKET_SAMPLES, RATE_HZ
from hapticplayer.structures import check_version, convert
from hapticplayer.untrusted import (
    MAX_STREAM_S,
    MAX_STREAM_TRACKS,
    parse_json,
    without_controls,
)

SCHEMA, VERSION = "hapticplayer.stream", 1
MANIFEST = "manifest.json"
_UPDATE = Message("update hapticplayer here and where the clip is served")

_Text = Annotated[str, Meta(min_length=1, max_length=200)]


class _Clip(Struct):
    name: _Text
    size_bytes: Annotated[int, Meta(ge=1, le=1 << 62)]


class _Force(Struct):
    rate_hz: Annotated[int, Meta(ge=int(RATE_HZ), le=int(RATE_HZ))]
    samples_per_packet: Annotated[int, Meta(ge=PACKET_SAMPLES, le=PACKET_SAMPLES)]
    samples: Annotated[int, Meta(ge=1, le=int(MAX_STREAM_S * RATE_HZ))]
    tracks: Annotated[list[_Text], Meta(min_length=1, max_length=MAX_STREAM_TRACKS)]
    feedback: _Text


class _ManifestDocument(Struct):
    title: _Text
    clip: _Clip
    force: _Force


@dataclass(frozen=True, slots=True)
class Manifest:
    """What a stream consists of.

    Attributes:
        title: for people.
        clip_name: of the clip's file, without a folder.
        clip_bytes: its size.
        samples: of each force track, 1 ms apart from media time 0.
        tracks: their names; a track is asked for by its place in this list.
        feedback: the one to begin with.
    """

    title: str
    clip_name: str
    clip_bytes: int
    samples: int
    tracks: tuple[str, ...]
    feedback: str

    def to_json(self) -> bytes:
        """Return the manifest as it is sent."""
        content = {
            "schema": SCHEMA,
            "version": VERSION,
            "program": f"hapticplayer {__version__}",
            "title": self.title,
            "clip": {"name": self.clip_name, "size_bytes": self.clip_bytes},
            "force": {
                "rate_hz": int(RATE_HZ),
                "samples_per_packet": PACKET_SAMPLES,
                "samples": self.samples,
                "tracks": self.tracks,
                "feedback": self.feedback,
            },
        }
        return json.dumps(content, indent=1).encode()


def read_manifest(content: bytes, where: str) -> Manifest:
    """Return the manifest that a server has sent.

    Raises:
        NetworkError: when it is not one that this program can play.
    """
    value = parse_json(content, where, NetworkError, _UPDATE)
    check_version(value, SCHEMA, VERSION, where, NetworkError, _UPDATE)
    given = convert(value, _ManifestDocument, where, NetworkError, _UPDATE)
    tracks = tuple(map(without_controls, given.force.tracks))
    feedback = without_controls(given.force.feedback)
    if len(set(tracks)) < len(tracks) or feedback not in tracks:
        raise NetworkError(
            "must have different tracks, among them the feedback",
            where=f"{where}, force",
            remedy=_UPDATE,
        )
    return Manifest(
        without_controls(given.title),
        without_controls(given.clip.name).replace("/", "?"),
        given.clip.size_bytes,
        given.force.samples,
        tracks,
        feedback,
    )
