"""The manifest of a stream: what a client reads before it requests anything."""

import json
from dataclasses import dataclass
from typing import Any

from hapticplayer import __version__
from hapticplayer.errors import Message, NetworkError
from hapticplayer.haptics.arriving import PACKET_SAMPLES, RATE_HZ
from hapticplayer.untrusted import (
    MAX_STREAM_S,
    MAX_STREAM_TRACKS,
    parse_json,
    without_controls,
)

SCHEMA, VERSION = "hapticplayer.stream", 1
MANIFEST = "manifest.json"
_MAX_TEXT = 200
_UPDATE = Message("update hapticplayer here and where the clip is served")


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
    try:
        _check_version(value, where)
        clip, force = value["clip"], value["force"]
        tracks = force["tracks"]
        made = Manifest(
            _text(value["title"]),
            _text(clip["name"]).replace("/", "?"),
            _count(clip["size_bytes"], 1 << 62),
            _count(force["samples"], int(MAX_STREAM_S * RATE_HZ)),
            tuple(_text(name) for name in _listed(tracks)),
            _one_of(tracks, force["feedback"]),
        )
    except (KeyError, TypeError, ValueError, AttributeError) as problem:
        raise NetworkError(
            "an entry is missing or of the wrong kind ({reason})",
            where=where,
            remedy=_UPDATE,
            reason=without_controls(str(problem)[:_MAX_TEXT]),
        ) from problem
    return made


def _check_version(value: Any, where: str) -> None:
    force = value["force"]
    found = [
        value["schema"],
        value["version"],
        force["rate_hz"],
        force["samples_per_packet"],
    ]
    if found != [SCHEMA, VERSION, RATE_HZ, PACKET_SAMPLES]:
        raise NetworkError(
            "is a stream of another version ({found})",
            where=where,
            remedy=_UPDATE,
            found=without_controls(str(found[1])[:40]),
        )


def _listed(value: Any) -> list[Any]:
    if not isinstance(value, list) or not 1 <= len(value) <= MAX_STREAM_TRACKS:
        raise ValueError("tracks")
    if len(set(value)) < len(value):
        raise ValueError("tracks")
    return value


def _one_of(tracks: list[Any], value: Any) -> str:
    if value not in tracks:
        raise ValueError("feedback")
    return _text(value)


def _text(value: Any) -> str:
    if not isinstance(value, str) or not 1 <= len(value) <= _MAX_TEXT:
        raise ValueError("text")
    return without_controls(value)


def _count(value: Any, most: int) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or not 1 <= value <= most:
        raise ValueError("number")
    return value
