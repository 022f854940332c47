"""Long work beside the window: in a thread, and where it computes in a process of its own."""

import contextlib
import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QObject, QTimer, Signal

from hapticplayer.errors import Cancelled, HapticPlayerError, Progress
from hapticplayer.facilities import has

Result = TypeVar("Result")
Work = Callable[[Progress], Result]


@dataclass(frozen=True, slots=True)
class JobState:
    """What there is to show of a job."""

    title: str
    fraction: float
    step: str


class Job(Generic[Result]):
    """Work in a Python thread, looked at by polling: nothing crosses into Qt.

    The progress callback raises `Cancelled` once the job is to stop.
    """

    def __init__(self, title: str, work: Work[Result]) -> None:
        self.result: Result | None = None
        self.problem: BaseException | None = None
        self._title = title
        self._work = work
        self._progress = (0.0, "")
        self._is_cancelled = threading.Event()
        self._thread = threading.Thread(target=self._run, name="job", daemon=True)

    def start(self) -> None:
        """Begin."""
        self._thread.start()

    def cancel(self) -> None:
        """Ask the work to stop at its next progress report."""
        self._is_cancelled.set()

    def join(self) -> None:
        """Wait for the end."""
        self._thread.join()

    @property
    def is_done(self) -> bool:
        """Whether the thread has ended."""
        return not self._thread.is_alive()

    @property
    def is_cancelled(self) -> bool:
        """Whether it was asked to stop."""
        return self._is_cancelled.is_set()

    def state(self) -> JobState:
        """Return how far it is."""
        return JobState(self._title, *self._progress)

    def _report(self, fraction: float, step: str) -> None:
        if self._is_cancelled.is_set():
            raise Cancelled
        self._progress = (fraction, step)

    def _run(self) -> None:
        try:
            self.result = self._work(self._report)
        except BaseException as problem:  # noqa: BLE001 - a thread's top: the window reports it
            self.problem = problem


class Jobs:
    """Runs one job and hands its outcome over on the thread that polls.

    A cancelled job is not a failure.
    """

    def __init__(self, failed: Callable[[BaseException], None]) -> None:
        self._failed = failed
        self._job: Job[Any] | None = None
        self._done: Callable[[Any], None] = _ignore

    @property
    def is_busy(self) -> bool:
        return self._job is not None

    def state(self) -> JobState | None:
        """The running job, None when nothing runs."""
        return self._job.state() if self._job else None

    def run(
        self, title: str, work: Work[Result], done: Callable[[Result], None]
    ) -> None:
        """Start a job; the caller has seen that none runs."""
        assert self._job is None
        self._job, self._done = Job(title, work), done
        self._job.start()

    def cancel(self) -> None:
        """Stop what runs as soon as it looks."""
        if self._job:
            self._job.cancel()

    def poll(self) -> bool:
        """Hand over the outcome if the job has ended; False while one goes on or none was."""
        job = self._job
        if job is None or not job.is_done:
            return False
        self._job = None
        if job.problem is None:
            self._done(job.result)
        elif not isinstance(job.problem, Cancelled):
            self._failed(job.problem)
        return not self.is_busy

    def close(self) -> None:
        """Stop what runs and wait for it; its outcome is dropped."""
        if self._job:
            self._job.cancel()
            self._job.join()
            self._job = None


def _ignore(_result: Any) -> None:
    """Drop a result."""


_LOOK_S = 0.05
_DONE, _FAILED, _STEP = "done", "failed", "step"


def in_child(
    work: Callable[..., Result],
    *arguments: Any,
    progress: Progress,
    **options: Any,
) -> Result:
    """The result of the work; called in a thread, it leaves the others alone.

    Args:
        work: a function of a module, which takes `progress`.
        *arguments: handed to it; values and paths.
        **options: the same, by name.
        progress: called here; when it raises, the work is asked to stop, which it
            does at its next report, and the exception is raised again once it has.
    """
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(
        target=_serve, args=(theirs, work, arguments, options), daemon=True
    )
    with ours:
        with _deaf_to_ctrl_c():
            process.start()
        theirs.close()
        if process.pid is not None:
            _stand_back(process.pid)
        try:
            return _follow(ours, progress)  # type: ignore[no-any-return]
        except EOFError:
            process.join()
            raise HapticPlayerError(
                "the process was killed (exit status {status}), perhaps for "
                "want of memory; nothing was written",
                status=process.exitcode,
            ) from None
        finally:
            ours.close()  # which the work takes for the wish to stop
            process.join()


@contextlib.contextmanager
def _deaf_to_ctrl_c() -> Iterator[None]:
    """Keep SIGINT, which a terminal sends to all, from what this thread starts.

    The window hears it, and closes the line to the work.
    """
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [])
    resource_tracker.ensure_running()  # else `start` does, and lets SIGINT through again
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _stand_back(pid: int) -> None:
    """Let a process compute only on cores that nobody else wants, from its start on.

    The kernel wakes the window at once on a core that runs such a process; behind one
    of lower niceness it had to wait up to 80 ms.
    """
    with contextlib.suppress(OSError):  # gone already
        if has("idle"):
            os.sched_setscheduler(pid, os.SCHED_IDLE, os.sched_param(0))


def _follow(line: Connection, progress: Progress) -> Any:
    """Hand on the progress until the work is done."""
    latest = (0.0, "")
    while True:
        if not line.poll(_LOOK_S):
            progress(*latest)  # it may want to stop between reports
            continue
        kind, value = line.recv()
        if kind == _DONE:
            return value
        if kind == _FAILED:
            raise value
        latest = value
        progress(*latest)


def _serve(
    line: Connection,
    work: Callable[..., Any],
    arguments: tuple[Any, ...],
    options: dict[str, Any],
) -> None:
    """Do the work in the child."""

    def report(fraction: float, step: str) -> None:
        try:
            line.send((_STEP, (fraction, step)))
            is_unwanted = line.poll()
        except OSError:
            is_unwanted = True
        if is_unwanted:
            raise Cancelled

    try:
        answer = (_DONE, work(*arguments, progress=report, **options))
    except Exception as problem:  # noqa: BLE001 - it is raised again in the window's process
        answer = (_FAILED, problem)
    with contextlib.suppress(OSError):  # nobody may wait any more
        line.send(answer)


POLL_MS = 50


class BackgroundLookup(QObject):
    """Runs a lookup of names in a thread when asked to; keeps the result."""

    changed = Signal()

    def __init__(
        self, work: Callable[[Progress], list[str]], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self.found: list[str] = []
        self._work = work
        self._jobs = Jobs(lambda _problem: self._take([]))
        self._timer = QTimer(self)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(self._poll)

    @property
    def is_busy(self) -> bool:
        """Whether it looks now."""
        return self._jobs.is_busy

    def refresh(self) -> None:
        """Start a lookup unless one runs."""
        if not self._jobs.is_busy:
            self._jobs.run("", self._work, self._take)
            self._timer.start()

    def close(self) -> None:
        """Wait until nothing is looked for."""
        self._timer.stop()
        self._jobs.close()

    def _poll(self) -> None:
        self._jobs.poll()
        if not self._jobs.is_busy:
            self._timer.stop()

    def _take(self, found: list[str]) -> None:
        if found != self.found:
            self.found = found
            self.changed.emit()
