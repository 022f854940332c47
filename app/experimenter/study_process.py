"""A session in a program of its own, watched until it ends."""

import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence

from PySide6.QtCore import QObject, QSocketNotifier, Signal

_PREFIX = "hapticplayer: "


class StudyProcess(QObject):
    """One at a time; it goes on when this window is closed.

    Signals:
        ended: what it complained of, "" where nothing.
    """

    ended = Signal(str)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._notifier: QSocketNotifier | None = None
        self._process: subprocess.Popen[bytes] | None = None

    @property
    def is_running(self) -> bool:
        """Whether a session is open."""
        return self._process is not None

    def start(self, arguments: Sequence[str]) -> None:
        """Start `hapticplayer` with arguments.

        Raises:
            OSError: when the system refuses.
        """
        self._told = tempfile.TemporaryFile()  # noqa: SIM115 - read when it has ended
        self._process = subprocess.Popen(
            [sys.executable, "-m", "app", *arguments],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=self._told,
            start_new_session=True,
        )
        self._handle = os.pidfd_open(self._process.pid)
        self._notifier = QSocketNotifier(self._handle, QSocketNotifier.Type.Read, self)
        self._notifier.activated.connect(self._on_ended)

    def leave(self) -> None:
        """Watch it no longer; it goes on."""
        if self._process is None:
            return
        assert self._notifier is not None
        self._notifier.setEnabled(False)
        self._notifier.deleteLater()
        os.close(self._handle)
        self._told.close()
        self._process = self._notifier = None

    def _on_ended(self) -> None:
        assert self._process is not None
        status = self._process.wait()
        self._told.seek(0)
        lines = self._told.read().decode(errors="replace").splitlines()
        self.leave()
        said = [line for line in lines if line.startswith(_PREFIX)]
        told = said[-1].removeprefix(_PREFIX) if said else "".join(lines[-1:])
        exited = self.tr("The session has ended with status {0}").format(status)
        self.ended.emit((told or exited) if status else "")
