"""Work for processes of their own, done by threads: no Python has to start for it."""

import multiprocessing
import os
import threading
from multiprocessing.connection import Connection
from multiprocessing.reduction import ForkingPickler

import pytest


class Threads:
    """Stands for `multiprocessing` in app/bridge/jobs.py.

    What goes to the work and what comes back is pickled as it is for a process.
    """

    Pipe = staticmethod(multiprocessing.Pipe)

    def get_context(self, _method):
        return self

    class Process:
        """A thread with an end of the line of its own."""

        pid = exitcode = None

        def __init__(self, target, args, daemon):
            line, *rest = args
            self._line = Connection(os.dup(line.fileno()))
            self._target, self._rest = target, bytes(ForkingPickler.dumps(rest))
            self._thread = threading.Thread(target=self._run, daemon=daemon)
            self.start, self.join = self._thread.start, self._thread.join

        def _run(self):
            with self._line:
                self._target(self._line, *ForkingPickler.loads(self._rest))


@pytest.fixture(autouse=True)
def threads_for_children(request, monkeypatch) -> None:
    """Use threads, but where a test wants `real_children`."""
    if "real_children" not in request.fixturenames:
        monkeypatch.setattr("app.bridge.jobs.multiprocessing", Threads())


@pytest.fixture
def real_children(monkeypatch) -> list[int]:
    """Return the processes that only get what others leave; here they get their share.

    On a busy machine they would not come to their end.
    """
    asked, really = [], os.sched_setscheduler

    def set_scheduler(pid: int, policy: int, parameter: os.sched_param) -> None:
        if policy == os.SCHED_IDLE:
            asked.append(pid)
        else:
            really(pid, policy, parameter)

    monkeypatch.setattr(os, "sched_setscheduler", set_scheduler)
    return asked
