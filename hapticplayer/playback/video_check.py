"""Finds out whether a video is the one that its force was made for.

The checksum is of all packets of the video, so it takes as long as reading the file:
0.1 s for 45 s of 720p. It is taken in a thread while the player gets ready, and kept in the
cache folder for as long as the file stays as it is.
"""

import contextlib
import enum
import threading
from pathlib import Path
from typing import Any

from hapticplayer.errors import Cancelled, InputError, Message
from hapticplayer.media.clip_bytes import ClipBytes
from hapticplayer.media.remux import VideoDigest, has_head, video_payload
from hapticplayer.storage import cache_home, replace_json
from hapticplayer.structures import read_json
from hapticplayer.untrusted import FileState

ANOTHER_VIDEO = Message(
    "this is not the video that the force was made for (its checksum differs): it plays "
    "without force"
)
_KNOWN, _MOST_KNOWN = "checked-videos.json", 500


class Verdict(enum.Enum):
    """What is known of a video."""

    PENDING = enum.auto()
    SAME = enum.auto()
    ANOTHER = enum.auto()
    ACCEPTED = enum.auto()
    """Another one, which a person has agreed to."""


class VideoCheck:
    """Takes the checksum of a video in a thread, unless it is known from before.

    Of a remote clip only its beginning is read, see `has_head`.
    """

    def __init__(self, clip: Path | ClipBytes, expected: VideoDigest) -> None:
        self._clip, self._expected = clip, expected
        self._is_accepted, self._is_unwanted = False, threading.Event()
        self._entry: list[int | str] = []  # of the file before it is read
        self._is_same: bool | None = None
        if isinstance(clip, Path):
            self._entry = _entry(clip, expected)
            self._is_same = _known().get(str(clip)) == self._entry or None
        self._thread = threading.Thread(
            target=self._run, name="video-check", daemon=True
        )
        if self._is_same is None:
            self._thread.start()

    @property
    def verdict(self) -> Verdict:
        """What is known now."""
        if self._is_same:
            return Verdict.SAME
        if self._is_accepted:
            return Verdict.ACCEPTED
        return Verdict.PENDING if self._is_same is None else Verdict.ANOTHER

    @property
    def allows_force(self) -> bool:
        return self.verdict in {Verdict.SAME, Verdict.ACCEPTED}

    def accept(self) -> None:
        """Let the force be felt whatever the video is: a person has agreed."""
        self._is_accepted = True

    def wait(self) -> Verdict:
        """Return the verdict once it is there."""
        if self._thread.is_alive() and not self._is_accepted:
            self._thread.join()
        return self.verdict

    def close(self) -> None:
        """Stop reading the file."""
        self._is_unwanted.set()

    def _run(self) -> None:
        try:
            self._is_same = self._matches()
        except Cancelled:
            return
        except InputError:  # the decoder says what is wrong with the file
            self._is_same = False
        if self._is_same and isinstance(self._clip, Path):
            _note_known(self._clip, self._entry)

    def _matches(self) -> bool:
        if isinstance(self._clip, ClipBytes):
            return has_head(self._clip, self._expected)
        return video_payload(self._clip, self._report) == self._expected

    def _report(self, _share: float) -> None:
        if self._is_unwanted.is_set():
            raise Cancelled


def _note_known(path: Path, entry: list[int | str]) -> None:
    with contextlib.suppress(InputError, OSError, RuntimeError):  # only a short cut
        known = {k: v for k, v in _known().items() if k != str(path)}
        latest = dict(list(known.items())[-_MOST_KNOWN + 1 :])
        replace_json(cache_home() / _KNOWN, {**latest, str(path): entry})


def _known() -> dict[str, Any]:
    try:
        return read_json(cache_home() / _KNOWN, dict[str, Any])
    except (InputError, RuntimeError):  # no home folder, or nothing yet
        return {}


def _entry(path: Path, expected: VideoDigest) -> list[int | str]:
    return [*FileState.of(path)[1:], expected.sha256]
