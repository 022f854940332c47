"""Heavy work in a process of its own, so that the window's interpreter stays free.

A thread that loads scipy or compiles holds the interpreter for longer than the loop
waits for a heartbeat (163 ms were measured; `docs/safety.md`): the force would ramp.
"""

import contextlib
import multiprocessing
import os
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any, TypeVar

from hapticplayer.errors import Cancelled, HapticPlayerError

Result = TypeVar("Result")
Progress = Callable[[float, str], None]

_LOOK_S = 0.05
_DONE, _FAILED, _STEP = "done", "failed", "step"


def in_child(
    work: Callable[..., Result],
    *arguments: Any,
    progress: Progress,
    **options: Any,
) -> Result:
    """Return what the work returns; called in a thread, it leaves the others alone.

    Args:
        work: a function of a module, which takes `progress`.
        *arguments: handed to it; values and paths.
        **options: the same, by name.
        progress: called here; when it raises, the work is asked to stop, which it
            does at its next report, and the exception goes on once it has.

    Raises:
        HapticPlayerError: what the work raised, or that its process has died.
    """
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(
        target=_serve, args=(theirs, work, arguments, options), daemon=True
    )
    with ours:
        process.start()
        theirs.close()
        if process.pid is not None:
            _stand_back(process.pid)
        try:
            return _follow(ours, progress)  # type: ignore[no-any-return]
        except EOFError:
            process.join()
            raise HapticPlayerError(
                "the work was ended from outside (exit status {status}), perhaps for "
                "want of memory; nothing was written",
                status=process.exitcode,
            ) from None
        finally:
            ours.close()  # which the work takes for the wish to stop
            process.join()


def _stand_back(pid: int) -> None:
    """Let a process compute only on cores that nobody else wants, from its start on.

    The kernel wakes the window at once on a core that runs such a process; behind one
    of lower niceness it had to wait up to 80 ms.
    """
    with contextlib.suppress(OSError):  # gone already
        os.sched_setscheduler(pid, os.SCHED_IDLE, os.sched_param(0))


def _follow(line: Connection, progress: Progress) -> Any:
    """Hand on the progress until the work is done."""
    latest = (0.0, "")
    while True:
        if not line.poll(_LOOK_S):
            progress(*latest)  # it may want to stop while nothing is told
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
