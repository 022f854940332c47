"""One piece of long work at a time, beside the window."""

import threading
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Generic, TypeVar

from hapticplayer.errors import Cancelled

Result = TypeVar("Result")
Progress = Callable[[float, str], None]
Work = Callable[[Progress], Result]


@dataclass(frozen=True, slots=True)
class JobState:
    """What there is to show of a job."""

    title: str
    fraction: float
    step: str


class Job(Generic[Result]):
    """Work in a Python thread, looked at by polling: nothing crosses into Qt.

    Args:
        title: for people.
        work: called in the thread with a progress callback, which raises
            `Cancelled` once the job is to stop.
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
        except BaseException as problem:  # noqa: BLE001 - a thread's top: the window tells
            self.problem = problem


class Jobs:
    """Runs one job and hands its outcome over on the thread that polls.

    Args:
        failed: told what went wrong; a cancelled job is no failure.
    """

    def __init__(self, failed: Callable[[BaseException], None]) -> None:
        self._failed = failed
        self._job: Job[Any] | None = None
        self._done: Callable[[Any], None] = _ignore

    @property
    def is_busy(self) -> bool:
        """Whether a job runs."""
        return self._job is not None

    def state(self) -> JobState | None:
        """Return what runs, None when nothing does."""
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

    def poll(self) -> None:
        """Hand over the outcome if the job has ended."""
        job = self._job
        if job is None or not job.is_done:
            return
        self._job = None
        if job.problem is None:
            self._done(job.result)
        elif not isinstance(job.problem, Cancelled):
            self._failed(job.problem)

    def close(self) -> None:
        """Stop what runs and wait for it; its outcome is dropped."""
        if self._job:
            self._job.cancel()
            self._job.join()
            self._job = None


def _ignore(_result: Any) -> None:
    """Drop a result."""
