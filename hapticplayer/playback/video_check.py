"""Finds out whether a video is the one that its force was made for.

The checksum is of all packets of the video, so it takes as long as reading the file:
0.1 s for 45 s of 720p. It is taken in a thread while the player gets ready, and kept in the
cache folder for as long as the file stays as it is. The clip in the folder of a sequence is
compared with the checksum of the file; it plays with force meanwhile.
"""

import contextlib
import enum
import hashlib
import threading
from pathlib import Path
from typing import Any

import msgspec

from hapticplayer.errors import Cancelled, InputError, Message
from hapticplayer.media.clip_bytes import ClipBytes
from hapticplayer.media.identity import ANOTHER, VideoDigest
from hapticplayer.media.remux import other_head, video_payload
from hapticplayer.storage import cache_home, replace_json, sha256_of
from hapticplayer.structures import read_json
from hapticplayer.untrusted import FileState

_KNOWN, _MOST_KNOWN = "checked-videos.json", 500
_GLANCE_S = 1.0


class Verdict(enum.Enum):
    """What is known of a video."""

    PENDING = enum.auto()
    SAME = enum.auto()
    ANOTHER = enum.auto()
    ACCEPTED = enum.auto()
    """Another one, which a person has agreed to."""


class VideoCheck:
    """Compares a video in a thread, unless it is known from before.

    Of a remote clip only its beginning is read, see `other_head`.

    Args:
        clip: that is played.
        expected: the video that the force was made for, or the SHA-256 of its file.
    """

    def __init__(self, clip: Path | ClipBytes, expected: VideoDigest | str) -> None:
        self._clip, self._expected = clip, expected
        self._is_accepted, self._is_unwanted = False, threading.Event()
        self._entry: list[int | str] = []  # of the file before it is read
        self._is_same: bool | None = None
        self._difference = ANOTHER
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
        """Whether it may be felt; a file that was copied by an import also meanwhile."""
        if self.verdict is Verdict.PENDING:
            return isinstance(self._expected, str)
        return self.verdict is not Verdict.ANOTHER

    @property
    def notice(self) -> Message:
        """What to say of another video."""
        return Message(
            "this is not the video that the force was made for ({reason}): it plays "
            "without force",
            reason=self._difference,
        )

    def accept(self) -> None:
        """Let the force be felt whatever the video is: a person has agreed."""
        self._is_accepted = True

    def wait(self) -> Verdict:
        if self._thread.is_alive() and not self._is_accepted:
            self._thread.join()
        return self.verdict

    def glance(self) -> Verdict:
        """Return the verdict, of a force that is felt meanwhile after a second at most."""
        if isinstance(self._expected, str):
            if self._thread.is_alive():
                self._thread.join(_GLANCE_S)
            return self.verdict
        return self.wait()

    def close(self) -> None:
        """Stop reading the file."""
        self._is_unwanted.set()

    def _run(self) -> None:
        try:
            difference = self._compared()
        except Cancelled:
            return
        except InputError:  # the decoder says what is wrong with the file
            difference = ANOTHER
        self._difference = difference or ANOTHER
        self._is_same = difference is None
        if self._is_same and isinstance(self._clip, Path):
            _note_known(self._clip, self._entry)

    def _compared(self) -> Message | None:
        clip, expected = self._clip, self._expected
        if isinstance(expected, str):
            assert isinstance(clip, Path)
            return None if sha256_of(clip, self._report) == expected else ANOTHER
        if isinstance(clip, ClipBytes):
            return other_head(clip, expected)
        return expected.difference(video_payload(clip, self._report))

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


def _entry(path: Path, expected: VideoDigest | str) -> list[int | str]:
    what = hashlib.sha256(msgspec.json.encode(expected)).hexdigest()
    return [*FileState.of(path)[1:], what]
