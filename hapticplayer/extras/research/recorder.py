"""Starts and stops LabRecorder by its remote control, and knows whether it records.

LabRecorder answers "OK" to each line, whatever came of it: that its file exists shows
that it records, and that it has kept the connection open shows that it still runs.
Older versions lose a line that arrives together with another one, so each is sent after
the answer to the one before. A start takes seconds, because streams are looked for: a
thread waits for it.
"""

import socket
from contextlib import suppress
from pathlib import Path
from threading import Thread

from hapticplayer.errors import Message, StudyError, message_of
from hapticplayer.extras.research.bids import TASK
from hapticplayer.study.session_folder import StoredSession

_ANSWER, _ANSWER_S = b"OK", 10.0
_BEGUN = ("begin", "resume")
_NO_ANSWER = Message("LabRecorder does not answer at port {port} ({reason})")
_CLOSED = Message("LabRecorder was closed at port {port} ({reason})")
_NOT_STARTED = Message("LabRecorder did not start at port {port} ({reason})")
_IN_LABRECORDER = Message(
    "start LabRecorder on this computer, tick 'Enable RCS' and look at its window, then "
    "begin the session again"
)


class LabRecorder:
    """A running LabRecorder on this computer.

    Args:
        port: of its remote control.

    Attributes:
        starting: sends what begins a recording; None before that.

    Raises:
        StudyError: when it does not answer.
    """

    def __init__(self, port: int) -> None:
        self._port, self._file = port, Path()
        self._problem: StudyError | None = None
        self.starting: Thread | None = None
        try:
            self._wire = socket.create_connection(("127.0.0.1", port), _ANSWER_S)
        except OSError as problem:
            raise self._refused(_NO_ANSWER, problem) from problem

    def begin(self, session: StoredSession) -> None:
        """Record this session from now on, in its folder; returns at once."""
        run = 1 + sum(one.kind in _BEGUN for one in session.records.intact)
        name = f"sub-{session.code}_task-{TASK}_run-{run:03d}_beh.xdf"
        self._file = session.folder / name
        lines = _lines(session, run)
        self.starting = Thread(target=self._send_all, args=(lines,), daemon=True)
        self.starting.start()

    def check(self) -> None:
        """Raise StudyError unless the session is being recorded."""
        if self.starting is None or self.starting.is_alive():
            raise StudyError("LabRecorder is still starting", remedy="wait a moment")
        if self._problem is not None:
            raise self._problem
        if not self._is_connected():
            raise self._refused(_CLOSED, None)
        if not self._file.is_file():
            raise StudyError(
                "LabRecorder has not begun its file",
                where=str(self._file),
                remedy="stop what it records, then begin the session again",
            )

    def close(self) -> None:
        """Stop the recording, if it was begun, and let go of LabRecorder."""
        if self.starting is not None:
            self.starting.join()
            with suppress(OSError):  # it was closed before
                self._send("stop")
        self._wire.close()

    def _send_all(self, lines: list[str]) -> None:
        try:
            for line in lines:
                self._send(line)
        except OSError as problem:
            self._problem = self._refused(_NOT_STARTED, problem)

    def _send(self, line: str) -> None:
        self._wire.sendall(f"{line}\n".encode())
        answer = b""
        while not answer.endswith(_ANSWER):
            if not (part := self._wire.recv(64)):
                raise ConnectionError("it was closed")
            answer += part

    def _is_connected(self) -> bool:
        self._wire.setblocking(False)
        try:
            return self._wire.recv(64) != b""
        except BlockingIOError:
            return True
        except OSError:
            return False
        finally:
            self._wire.settimeout(_ANSWER_S)

    def _refused(self, what: str, reason: OSError | None) -> StudyError:
        why = message_of(reason) if reason else Message("connection ended")
        what = Message(what, port=self._port, reason=why)
        return StudyError(what, remedy=_IN_LABRECORDER)


def _lines(session: StoredSession, run: int) -> list[str]:
    """What starts a recording; placeholders, since a template is put in lower case."""
    root = str(session.folder.resolve())
    if set(root) & set("{}\n"):
        raise StudyError(
            "LabRecorder cannot write into a folder with braces in its name",
            where=root,
            remedy="rename it",
        )
    template = "sub-%p_task-%b_run-%n_beh.xdf"
    named = f"{{participant:{session.code}}} {{task:{TASK}}} {{run:{run}}}"
    where = f"{{root:{root}}} {{template:{template}}}"
    return ["update", "select all", f"filename {where} {named}", "start"]
