"""Markers and force as LSL streams, for programs on the same machine.

Nothing leaves the machine: streams are announced on the loopback interface only, and all
sockets of liblsl are bound to it. The streams contain no answers and no codes. Time
stamps are those of the session's records: the clock of liblsl is CLOCK_MONOTONIC.
"""

import importlib
import os
import socket
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import Message, StudyError
from hapticplayer.extras.research.recorder import LabRecorder
from hapticplayer.installation import how_to_get
from hapticplayer.study.session_folder import StoredSession
from hapticplayer.study.streams import Wanted

MARKERS, FORCE = "hapticplayer-markers", "hapticplayer-force"
FORCE_RATE_HZ = 1000.0
_LOOPBACK = b"lo"
_KEPT_S = 30  # buffer for slow readers
_CONFIGURATION = """
[ports]
IPv6 = disable
[multicast]
ResolveScope = machine
ListenAddress = 127.0.0.1
[log]
level = -3
"""
_WITHOUT = Message("leave LSL out")
_NOTHING = Wanted()


class LslStreams:
    """The two streams of a session, until `close`; a `StudyStream`.

    Args:
        wanted: what else of the network has to be there.

    Raises:
        StudyError: when pylsl or LabRecorder is missing, or a stream would be open to
            the network.
    """

    def __init__(self, wanted: Wanted = _NOTHING) -> None:
        library = _library()
        self._needed, self._resolver = wanted.streams, None
        with _bound_to_loopback():
            try:
                self._markers = library.StreamOutlet(_markers(library), 0, _KEPT_S)
                self._force = library.StreamOutlet(_force(library), 0, _KEPT_S)
                if self._needed:
                    self._resolver = library.ContinuousResolver()
            except RuntimeError as problem:
                raise StudyError(
                    "LSL streams cannot be opened ({reason})",
                    remedy=_WITHOUT,
                    reason=problem,
                ) from problem

        self._recorder = LabRecorder(wanted.port) if wanted.recorder else None

    def marker(self, text: str, monotonic_s: float) -> None:
        self._markers.push_sample([text], monotonic_s)

    def force(
        self, monotonic_s: NDArray[np.float64], force_n: NDArray[np.float32]
    ) -> None:
        """Send forces (N, 3) in frame D, N, with their times (N,), s."""
        if len(monotonic_s):
            self._force.push_chunk(
                np.ascontiguousarray(force_n, dtype=np.float32), monotonic_s.tolist()
            )

    def begin(self, session: StoredSession) -> None:
        """Record a session, if that is wanted."""
        if self._recorder is not None:
            self._recorder.begin(session)

    def check(self) -> None:
        """Raise StudyError if a needed stream is missing, or nothing is recorded."""
        if missing := set(self._needed) - self.names_found():
            raise StudyError(
                "these LSL streams are not on this computer: {names}",
                remedy="start them, then begin the trial again",
                names=", ".join(sorted(missing)),
            )
        if self._recorder is not None:
            self._recorder.check()

    def names_found(self) -> set[str]:
        """The streams on this computer, where some are needed."""
        found = self._resolver.results() if self._resolver is not None else ()
        return {one.name() for one in found}

    def close(self) -> None:
        """End the recording, then both streams."""
        if self._recorder is not None:
            self._recorder.close()
        del self._markers, self._force, self._resolver


def _library() -> Any:
    try:
        library: Any = importlib.import_module("pylsl")
        library.set_config_content(_CONFIGURATION)
    except (ImportError, RuntimeError, NotImplementedError) as problem:
        raise StudyError(
            "LSL streams need pylsl 1.18 or newer with its library",
            remedy="install hapticplayer[lsl] ({how}), or {otherwise}",
            how=how_to_get("lsl"),
            otherwise=_WITHOUT,
        ) from problem
    return library


def _markers(library: Any) -> Any:
    return library.StreamInfo(MARKERS, "Markers", 1, 0.0, library.cf_string, MARKERS)


def _force(library: Any) -> Any:
    info = library.StreamInfo(
        FORCE, "Force", 3, FORCE_RATE_HZ, library.cf_float32, FORCE
    )
    channels = info.desc().append_child("channels")
    for axis in "XYZ":
        channel = channels.append_child("channel")
        channel.append_child_value("label", f"Force{axis}")
        channel.append_child_value("type", "Force")
        channel.append_child_value("unit", "newton")
    return info


@contextmanager
def _bound_to_loopback() -> Iterator[None]:
    """Bind the sockets opened in the block to loopback.

    liblsl announces on loopback only, but its ports are open on all interfaces.
    """
    before = _descriptors()
    yield
    for descriptor in _descriptors() - before:
        with suppress(FileNotFoundError):
            _keep_local(descriptor)


def _descriptors() -> set[int]:
    return {int(name) for name in os.listdir("/proc/self/fd")}  # noqa: PTH208


def _keep_local(descriptor: int) -> None:
    try:
        if not stat.S_ISSOCK(os.fstat(descriptor).st_mode):
            return
    except OSError:
        return  # the descriptor of the listing itself
    with socket.socket(fileno=os.dup(descriptor)) as held:
        if held.family not in (socket.AF_INET, socket.AF_INET6):
            return
        if held.getsockname()[0] not in ("0.0.0.0", "::"):  # noqa: S104
            return
        try:
            held.setsockopt(socket.SOL_SOCKET, socket.SO_BINDTODEVICE, _LOOPBACK)
        except OSError as problem:
            raise StudyError(
                "LSL streams cannot be kept on this machine ({reason})",
                remedy=_WITHOUT,
                reason=problem,
            ) from problem
