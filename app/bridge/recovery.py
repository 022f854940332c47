"""Work that is not saved yet, kept aside so that a kill loses a second of it at most."""

import contextlib
import hashlib
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Annotated, Any
from urllib.parse import quote_from_bytes, unquote_to_bytes

from msgspec import Meta, Struct, to_builtins
from PySide6.QtCore import QObject, QTimer, Signal

from app.bridge.jobs import Job
from hapticplayer import storage
from hapticplayer.clock import utc_now_iso
from hapticplayer.errors import HapticPlayerError, InputError, Progress
from hapticplayer.structures import read_json

WAIT_MS = 500
_FILE = "kept.json"
Content = dict[str, Any]
_Short = Annotated[str, Meta(max_length=200)]


class Kept(Struct, frozen=True, forbid_unknown_fields=True):
    """What a file of this kind holds.

    Attributes:
        kind: of document, such as "effects".
        place: path of the document, quoted: it may have bytes that are no text.
        title: of the document, for people.
        base: of what the document was when it was opened, see `fingerprint`.
        kept_utc: when it was kept.
        content: as the document's own file would have it.
    """

    kind: _Short
    place: Annotated[str, Meta(max_length=12288)]
    title: str
    base: _Short
    kept_utc: _Short
    content: Content

    @property
    def path(self) -> Path:
        return Path(os.fsdecode(unquote_to_bytes(self.place)))


def fingerprint(content: Content) -> str:
    """A text that is the same for the same content of a document."""
    return hashlib.sha256(storage.json_text(content)).hexdigest()


def _home() -> Path:
    return storage.data_home() / "recovery"


def _folder_of(kind: str, path: Path) -> Path:
    name = hashlib.sha256(os.fsencode(path.resolve())).hexdigest()[:24]
    return _home() / f"{kind}-{name}"


class Recovery(QObject):
    """Keeps one document while it is edited, and finds what a kill has left of it.

    Written by a thread, aside and then renamed. The folder is locked as long as this
    lives, or its process: in a second window of the same document nothing is kept or
    found.
    """

    failed = Signal(object)
    """It cannot be kept."""

    def __init__(self, kind: str, path: Path, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._kind, self._path = kind, path
        self._lock: int | None = None
        self._next: Callable[[], Kept] | None = None
        self._job: Job[None] | None = None
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(WAIT_MS)
        self._timer.timeout.connect(self._write)

    @property
    def file(self) -> Path:
        return _folder_of(self._kind, self._path) / _FILE

    def open(self) -> Kept | None:
        """Begin, and return what was left; raises InputError where it is damaged."""
        folder = self.file.parent
        with contextlib.suppress(RuntimeError):  # without a home nothing is kept
            storage.make_folder(folder)
            self._lock = storage.lock_folder(folder)
        is_there = self._lock is not None and self.file.is_file()
        return read_json(self.file, Kept) if is_there else None

    def keep(self, title: str, base: str, content: Callable[[], Content]) -> None:
        """Keep this instead of what was kept before, soon; `content` runs in a thread."""
        if self._lock is None:
            return
        place = quote_from_bytes(os.fsencode(self._path.resolve()))
        self._next = lambda: Kept(
            self._kind, place, title, base, utc_now_iso(), content()
        )
        if not self._timer.isActive():
            self._timer.start()

    def forget(self) -> None:
        """It is saved, or a person does not want it."""
        self._next = None
        self._timer.stop()
        self._join()
        if self._lock is not None:
            self.file.unlink(missing_ok=True)

    def close(self) -> None:
        """Write what waits, and let others have the document."""
        self._join()
        self._write()
        self._join()
        self._timer.stop()
        if self._lock is not None:
            with contextlib.suppress(OSError):  # it is not empty
                self.file.parent.rmdir()
            os.close(self._lock)
            self._lock = None

    def _join(self) -> None:
        if self._job is not None:
            self._job.join()
            self._end_job()

    def _end_job(self) -> None:
        job, self._job = self._job, None
        problem = job.problem if job else None
        if isinstance(problem, HapticPlayerError):
            self.failed.emit(problem)
        elif problem is not None:
            raise problem

    def _write(self) -> None:
        """Begin, or look whether it went well; of what waits only the last counts."""
        if self._job is not None:
            if not self._job.is_done:
                self._timer.start()
                return
            self._end_job()
        if (make := self._next) is None:
            return
        self._next, file = None, self.file

        def work(_progress: Progress) -> None:
            text = storage.json_text(to_builtins(make()))
            storage.replace_file(file, text, storage.PRIVATE_FILE)

        self._job = Job("", work)
        self._job.start()
        self._timer.start()


def left_behind(kind: str) -> Iterator[Kept]:
    """What windows that are gone have left, the newest first; without damaged files."""
    try:
        files = list(_home().glob(f"{kind}-*/{_FILE}"))
    except RuntimeError:  # no home
        return
    for file in sorted(files, key=lambda one: one.stat().st_mtime_ns, reverse=True):
        lock = storage.lock_folder(file.parent)
        if lock is None:
            continue
        os.close(lock)
        with contextlib.suppress(InputError):  # the document's own editor tells
            yield read_json(file, Kept)


def forget(kept: Kept) -> None:
    """Remove what a person does not want back."""
    (_folder_of(kept.kind, kept.path) / _FILE).unlink(missing_ok=True)
