"""Takes ratings while a clip plays, and writes them beside the answers of the session."""

import os
import threading
from collections import deque
from collections.abc import Callable, Iterable, Mapping
from io import FileIO
from pathlib import Path

from hapticplayer import storage
from hapticplayer.clock import Clock
from hapticplayer.errors import Message
from hapticplayer.study.definition import LiveRating, RatingKind
from hapticplayer.study.journal import write_whole
from hapticplayer.study.live_ratings import HEAD, rating_file, row_text
from hapticplayer.study.rating_rules import start_of

WRITE_PERIOD_S, SYNC_PERIOD_S = 0.25, 1.0
INCOMPLETE, LIMIT = "ratings_incomplete", "limit"
"""Reasons why a trial is not valid; the second one has ":" and the rating's key."""


class RatingWriter:
    """Files of rows; a thread writes and syncs them, so that the clip never waits.

    Args:
        paths: of new files, by the key of the rating.
    """

    def __init__(self, paths: Mapping[str, Path]) -> None:
        self.problem: Message | str = ""
        self._paths = paths
        self._files = {key: self._opened(path) for key, path in paths.items()}
        self._rows = deque((key, f"{HEAD}\n") for key in paths)
        self._is_over = threading.Event()
        self._thread = threading.Thread(target=self._run, name="ratings", daemon=True)
        self._thread.start()

    def _opened(self, path: Path) -> FileIO | None:
        try:
            file = path.open("xb", buffering=0)
            os.fchmod(file.fileno(), storage.PRIVATE_FILE)
        except OSError as problem:
            self.problem = storage.write_problem(problem, path)
            return None
        return file

    def add(self, key: str, row: str) -> None:
        self._rows.append((key, row))

    def _run(self) -> None:
        writes, a_sync = 0, round(SYNC_PERIOD_S / WRITE_PERIOD_S)
        while not self._is_over.wait(WRITE_PERIOD_S):
            writes += 1
            self._write(is_synced=writes % a_sync == 0)
        self._write(is_synced=True)
        for file in filter(None, self._files.values()):
            file.close()

    def _write(self, *, is_synced: bool) -> None:
        rows = [self._rows.popleft() for _ in range(len(self._rows))]
        for key, file in self._files.items():
            lines = "".join(row for of, row in rows if of == key)
            if file is None:
                continue
            try:
                if lines:
                    write_whole(file.fileno(), lines.encode())
                if is_synced:
                    os.fsync(file)
            except OSError as problem:
                self.problem = storage.write_problem(problem, self._paths[key])

    def close(self) -> None:
        """Write what is left."""
        self._is_over.set()
        self._thread.join()


class Watching:
    """The ratings of one clip while it plays.

    The front end tells what a person does, and calls `sample` at `RATE_HZ`.

    Args:
        ratings: of the study.
        folder: of the session.
        trial: its position and attempt.
        clock: of the machine.
        media_s: where the clip is at a monotonic time; None while it does not run.
    """

    def __init__(
        self,
        ratings: Iterable[LiveRating],
        folder: Path,
        trial: tuple[int, int],
        clock: Clock,
        media_s: Callable[[float], float | None],
    ) -> None:
        self.ratings = tuple(ratings)
        self.values = {
            one.key: start_of(one) if one.kind is RatingKind.SLIDER else 0.0
            for one in self.ratings
            if one.kind is not RatingKind.NUMBER
        }
        self.limit: LiveRating | None = None
        """Whose limit was reached: the clip has to end."""
        self._clock, self._media_s = clock, media_s
        self._writer = RatingWriter(
            {one.key: rating_file(folder, *trial, one.key) for one in self.ratings}
        )
        self._open: dict[str, LiveRating] = {}
        self._asked = {one.key: 0 for one in self.ratings if one.every_s}

    @property
    def asking(self) -> LiveRating | None:
        """The number that is to be given now."""
        return next(iter(self._open.values()), None)

    def sample(self) -> None:
        """Keep where everything is, and ask for the numbers that are due."""
        now_s = self._clock.now_s()
        media_s = self._media_s(now_s)
        if media_s is None:
            return
        for key, value in self.values.items():
            self._writer.add(key, row_text(now_s, media_s, value))
        for one in self.ratings:
            due = int(media_s / one.every_s) if one.every_s else 0
            if due > self._asked.get(one.key, 0):
                self._asked[one.key] = due
                self._open[one.key] = one
                self._writer.add(one.key, row_text(now_s, media_s, None))

    def change(self, key: str, value: float) -> None:
        """A slider was moved, or a key was pressed (1) or let go (0)."""
        if self.values[key] == value:
            return
        self.values[key] = value
        self._keep(key, value)

    def give(self, key: str, value: int) -> None:
        """A number was given."""
        self._open.pop(key, None)
        self._keep(key, value)

    def _keep(self, key: str, value: float) -> None:
        now_s = self._clock.now_s()
        media_s = self._media_s(now_s)
        if media_s is None:
            return
        self._writer.add(key, row_text(now_s, media_s, value))
        one = next(one for one in self.ratings if one.key == key)
        if one.stop_at is not None and value >= one.stop_at and self.limit is None:
            self.limit = one

    def finish(self) -> tuple[str, ...]:
        """Write what is left; why the trial is not valid."""
        self._writer.close()
        found = [f"{LIMIT}:{self.limit.key}"] if self.limit else []
        return (*found, *([INCOMPLETE] if self._writer.problem else []))

    @property
    def problem(self) -> Message | str:
        """Why ratings could not be written, "" while all is well."""
        return self._writer.problem
