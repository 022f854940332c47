"""Standstills of what brings the sound, used by benchmarks/sync.py.

A busy computer lets the sound server or the player's sound process wait. Stopping them
for as long does the same on purpose.
"""

import contextlib
import os
import signal
import subprocess
import threading
import time
from collections.abc import Callable, Iterator

import numpy as np
from common import Usage

FIRST_S = 4.0
LASTS_S = {"stalled": (0.05, 0.1), "starved": (0.1, 0.3)}
"""The server, for less than what it has; the player's process, for more than that."""
EVERY_S = {"stalled": (0.5, 1.5), "starved": (2.0, 6.0)}
AFTER_S = 0.15  # what was handed over before sounds so much later
SOUND_PROCESS = "playback.sound_device"

Span = tuple[float, float]


@contextlib.contextmanager
def standstills(
    case: str, player: "subprocess.Popen[bytes]", server: int
) -> Iterator[list[Span]]:
    """Stop the server or the sound process now and then inside the block.

    Yields:
        The times in which a beep can't be heard, complete at the end.
    """
    spans: list[Span] = []
    is_over = threading.Event()
    if case not in LASTS_S:
        yield spans
        return

    def pids() -> list[int]:
        return [server] if case == "stalled" else _sound_processes(player.pid)

    thread = threading.Thread(
        target=_stop_now_and_then, args=(pids, case, spans, is_over)
    )
    thread.start()
    try:
        yield spans
    finally:
        is_over.set()
        thread.join()
        if case == "stalled":
            spans.clear()  # nothing is too late then


def _stop_now_and_then(
    pids: Callable[[], list[int]],
    case: str,
    spans: list[Span],
    is_over: threading.Event,
) -> None:
    random = np.random.default_rng(7)
    wait_s = FIRST_S
    while not is_over.wait(wait_s):
        begin_s = time.monotonic()
        with contextlib.ExitStack() as stopped:
            for pid in pids():
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGSTOP)
                    stopped.callback(_go_on, pid)
            time.sleep(random.uniform(*LASTS_S[case]))
        spans.append((begin_s, time.monotonic() + AFTER_S))
        wait_s = random.uniform(*EVERY_S[case])


def _go_on(pid: int) -> None:
    with contextlib.suppress(ProcessLookupError):
        os.kill(pid, signal.SIGCONT)


def _sound_processes(player: int) -> list[int]:
    usage = Usage(player)
    usage.sample_cpu()
    named = usage.by_pid.items()
    return [pid for pid, (command, _) in named if SOUND_PROCESS in command]
