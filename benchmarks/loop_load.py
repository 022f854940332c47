"""The player under a load, with a count of the commands that grew too old.

Run as `python loop_load.py LOAD SEEN SECONDS play ...` by `loop`: plays as `python -m
app` does, but is closed after some seconds: held up like this, a clip ends much later.
"""

import functools
import json
import os
import random
import signal
import sys
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np

LOADS = ("playback", "stress")
HOLD_S, EVERY_S = 2.0, 7.0
# What a window costs while it opens is not looked at, of no loop; held up meanwhile, it
# would be closed before it plays.
STARTING_S = 2.0
_TRIAL = 200_000
_REARM_S = 0.5


def loaded_player(load: str, seen: Path, seconds: float, *arguments: str) -> list[str]:
    """Return the command of the player in this checkout under a load."""
    return [sys.executable, __file__, load, str(seen), str(seconds), *arguments]


def hold_interpreter() -> None:
    """Sort long lists for ever: one call of C that lets no other thread run."""
    time.sleep(STARTING_S)
    dice = random.Random(1)  # noqa: S311 - chance, not secrecy
    values = [dice.random() for _ in range(_TRIAL)]
    begun_s = time.monotonic()
    sorted(values)
    cost_s = time.monotonic() - begun_s
    values *= max(1, round(HOLD_S / cost_s))
    dice.shuffle(values)
    while True:
        begun_s = time.monotonic()
        sorted(values)
        time.sleep(max(0.0, EVERY_S - (time.monotonic() - begun_s)))


def churn() -> None:
    """Make dicts and cycles for ever, for the collector of garbage to find."""
    time.sleep(STARTING_S)
    kept: dict[int, Any] = {}
    for number in range(sys.maxsize):
        entry: dict[str, Any] = {"number": number, "text": str(number)}
        entry["self"] = entry
        kept[number % 50_000] = entry
        if number % 2000 == 0:
            time.sleep(0.005)


def percentiles_us(lateness_s: list[Any]) -> dict[str, float]:
    """Return how late the ticks were, and how many periods a minute were missed."""
    late_us = 1e6 * np.concatenate([*lateness_s, np.empty(0)])
    if not len(late_us):
        return {}
    middle, p99, p999 = np.percentile(late_us, (50.0, 99.0, 99.9)).tolist()
    return {
        "p50": middle,
        "p99": p99,
        "p999": p999,
        "max": float(late_us.max()),
        "missed_per_min": 60_000 * float((late_us // 1000).sum()) / len(late_us),
    }


def main() -> int:
    """Play, and write down what was withheld or refused."""
    begun_s = time.monotonic()
    load, seen, seconds, *arguments = sys.argv[1:]
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
    from app.__main__ import main as play
    from hapticplayer.haptics.contract import Cause, Mode
    from hapticplayer.haptics.processes import HapticsProcesses
    from hapticplayer.playback import player as player_module
    from hapticplayer.simulation.falcon.record_reader import read_record

    withheld = 0
    ages_s: list[Any] = []
    lateness_s: list[Any] = []

    class Counted(HapticsProcesses):
        """Re-arms after each hold, so that there is a force to be late with."""

        _rearmed_s = 0.0

        def read_ticks(self) -> tuple[Any, int]:
            nonlocal withheld
            ticks, lost = super().read_ticks()
            ages_s.append(ticks["reply_age_s"][ticks["mode"] == Mode.FOLLOWING])
            is_old = (ticks["cause"] == Cause.COMMAND_STALE).astype(int)
            withheld += int(np.count_nonzero(np.diff(is_old, prepend=0) > 0))
            settled = (ticks["monotonic_s"] > begun_s + STARTING_S) & (
                ticks["monotonic_s"] < begun_s + float(seconds)
            )
            lateness_s.append(ticks["lateness_s"][settled].copy())
            is_tripped = len(ticks) and ticks["mode"][-1] == Mode.TRIPPED
            if is_tripped and time.monotonic() > self._rearmed_s + _REARM_S:
                self._rearmed_s = time.monotonic()
                self.rearm()
            return ticks, lost

    descriptor = os.memfd_create("device")
    player_module.HapticsProcesses = functools.partial(  # type: ignore[assignment,misc]
        Counted,
        device_options=["--record", str(descriptor)],
        device_descriptors=[descriptor],
    )
    if load == "stress":
        for work in (hold_interpreter, churn):
            threading.Thread(target=work, daemon=True).start()
    end = threading.Timer(float(seconds), os.kill, args=(os.getpid(), signal.SIGTERM))
    end.daemon = True
    end.start()
    status = play(arguments)
    has_device = os.fstat(descriptor).st_size > 0
    refused = int(read_record(descriptor)["refused"][-1]) if has_device else 0
    told = {"withheld": withheld, "refused": refused, "age_p99_us": _p99_us(ages_s)}
    Path(seen).write_text(json.dumps({**told, **percentiles_us(lateness_s)}))
    return status


def _p99_us(ages_s: list[Any]) -> float:
    """Return the 99th percentile of how old the answers were that were acted on."""
    joined = np.concatenate(ages_s) if ages_s else np.empty(0)
    return 1e6 * float(np.percentile(joined, 99)) if len(joined) else 0.0


if __name__ == "__main__":
    sys.exit(main())
