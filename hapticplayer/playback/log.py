"""The playback log: JSON lines of what was shown, heard and felt, and when.

Times are seconds of CLOCK_MONOTONIC. A thread of its own formats and writes; the
callers only put records into a queue.
"""

import json
import queue
import threading
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.clock import Clock
from hapticplayer.errors import InputError, Message
from hapticplayer.storage import make_way, write_problem
from hapticplayer.untrusted import ESCAPED


class PlaybackLog:
    """Writes one log file.

    Raises:
        InputError: when the file exists and is not to be overwritten, or cannot be
            written.
    """

    def __init__(
        self, path: Path, header: dict[str, Any], *, overwrite: bool = False
    ) -> None:
        self.problem, self._path = "", path
        self._queue: queue.SimpleQueue[dict[str, Any] | NDArray[Any] | None]
        self._queue = queue.SimpleQueue()
        make_way(path, is_log if overwrite else None)
        try:
            self._file = path.open("x", encoding="utf-8", errors=ESCAPED)
        except OSError as problem:
            raise InputError(
                "the log cannot be written ({reason})",
                where=str(path),
                remedy="choose another file",
                reason=problem,
            ) from problem
        self._thread = threading.Thread(
            target=self._run, name="playback-log", daemon=True
        )
        self._thread.start()
        self.line("header", **header)

    def line(self, kind: str, **fields: Any) -> None:
        self._queue.put({"kind": kind, **fields})

    def ticks(self, records: NDArray[Any]) -> None:
        """Add a force line for each exchange with the device."""
        if len(records):
            self._queue.put(records)

    def close(self, summary: dict[str, Any]) -> None:
        """Add the summary and finish the file."""
        self.line("summary", **summary)
        self._queue.put(None)
        self._thread.join()
        try:
            self._file.close()
        except OSError as problem:
            self._note(problem)

    def _note(self, problem: Exception) -> None:
        reason: object = problem
        if isinstance(problem, OSError):
            reason = write_problem(problem, self._path)
        self.problem = Message("the log is incomplete ({reason})", reason=reason)

    def _run(self) -> None:
        while (item := self._queue.get()) is not None:
            if not self.problem:
                try:
                    self._file.write(_text(item))
                except Exception as problem:  # noqa: BLE001 - a full disk must not stop the playback
                    self._note(problem)


class Reporter:
    """Takes what happens while playing: events for the log, notices for people."""

    def __init__(self, clock: Clock) -> None:
        self.log: PlaybackLog | None = None
        self.notices: list[str] = []
        self._clock = clock

    def notify(self, sentence: str) -> None:
        self.notices.append(sentence)

    def event(self, name: str, **fields: Any) -> None:
        self.line("event", name=name, monotonic_s=self._clock.now_s(), **fields)

    def line(self, kind: str, **fields: Any) -> None:
        if self.log is not None:
            self.log.line(kind, **fields)


class OutputReporter(Reporter):
    """Reports what happens to an output under its name; the leading one logs ticks."""

    def __init__(self, clock: Clock, whole: Reporter, output: str) -> None:
        super().__init__(clock)
        self._whole, self._output, self.leads = whole, output, False

    def notify(self, sentence: str) -> None:
        """Add a notice."""
        if not self.leads:
            sentence = Message("{output}: {what}", output=self._output, what=sentence)
        self._whole.notify(sentence)

    def line(self, kind: str, **fields: Any) -> None:
        self._whole.line(kind, output=self._output, **fields)

    def ticks(self, records: NDArray[Any]) -> None:
        """Log what was handed to the device."""
        if self.leads and self._whole.log is not None:
            self._whole.log.ticks(records)


def is_log(head: bytes) -> bool:
    """Whether a file begins as a playback log does."""
    try:
        header = json.loads(head.split(b"\n", 1)[0])
        return header["kind"] == "header" and "program" in header
    except (ValueError, KeyError, TypeError, RecursionError):
        return False


def _text(item: dict[str, Any] | NDArray[Any]) -> str:
    if isinstance(item, np.ndarray):
        return _force_lines(item)
    return json.dumps(item, allow_nan=False, ensure_ascii=False) + "\n"


def _force_lines(records: NDArray[Any]) -> str:
    rows = zip(
        records["monotonic_s"].tolist(),
        records["media_s"].tolist(),
        records["force_n"].tolist(),
        records["position_m"].tolist(),
        strict=True,
    )
    return "".join(
        f'{{"kind":"force","monotonic_s":{t:.6f},"media_s":{m:.6f},'
        f'"force_n":[{f[0]:.5f},{f[1]:.5f},{f[2]:.5f}],'
        f'"position_m":[{p[0]:.6f},{p[1]:.6f},{p[2]:.6f}]}}\n'
        for t, m, f, p in rows
    )
