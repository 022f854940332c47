"""SIGKILL at seeded moments of a scripted session: is an acknowledged answer ever lost?

The real program runs offscreen (benchmarks/kill_victim.py), is killed, and resumed
until its session ends; then another begins. `python benchmarks/kill.py --kills 500 --keep`
adds to what earlier runs have kept, until there are so many; `--for-s` stops it earlier.
"""

import argparse
import contextlib
import json
import math
import os
import signal
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from hapticplayer.capture.recording import Recording  # noqa: E402
from hapticplayer.clock import SystemClock  # noqa: E402
from hapticplayer.errors import StudyError  # noqa: E402
from hapticplayer.media import probe, write_clip  # noqa: E402
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ClockMap, ImuLog  # noqa: E402
from hapticplayer.sequence.build import Choices, write_sequence  # noqa: E402
from hapticplayer.sequence.files import replace_json  # noqa: E402
from hapticplayer.study.creation import change_definition, create_study  # noqa: E402
from hapticplayer.study.session_folder import State, StoredSession  # noqa: E402
from hapticplayer.study.study_folder import Study  # noqa: E402

RESULTS = ROOT / "benchmarks" / "results" / "kill.json"
VICTIM = Path(__file__).with_name("kill_victim.py")
LATEST_S = 1.5  # after the session is about to be made or opened
NEVER_S = 600.0
KEYS = ("bike", "horse", "car-turning", "car-braking")


@dataclass
class Tally:
    """What was seen over all kills."""

    kills: int = 0
    acknowledged: int = 0
    lost: int = 0
    unreadable: int = 0
    not_resumed: int = 0
    torn: int = 0
    completed: int = 0
    told: list[str] = field(default_factory=list)


def make_study(folder: Path) -> Study:
    """Make a study whose four sequences are one clip of a second."""
    clip = folder / "clip.mp4"
    pictures = (np.full((36, 64, 3), 5 * i, np.uint8) for i in range(25))
    write_clip(clip, pictures, frame_rate_hz=25)
    time_s = np.arange(0.0, 1.0, 1 / 200)
    force = np.zeros((len(time_s), 3))
    force[:, 2] = STANDARD_GRAVITY_MPS2 + np.sin(12.0 * time_s)
    log = ImuLog(time_s, force, np.zeros_like(force), source="shake")
    recording = Recording(log, ClockMap(), "made")
    target = write_sequence(
        probe(clip), recording, folder / "sequence", choices=Choices(title="s", seed=1)
    )
    study = create_study(folder / "study", folders=dict.fromkeys(KEYS, Path(target)))
    content = json.loads(study.content)
    content["checks"].update(device=False, sound=False, disk_free_mb=1)
    return change_definition(study, content)


class Program:
    """The program under test; each run is a process that can be killed."""

    def __init__(self, study: Study) -> None:
        self._study = study
        self._forks = subprocess.Popen(
            [sys.executable, str(VICTIM), str(study.folder)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env={**os.environ, "PYTHONPATH": str(ROOT)},
            text=True,
        )

    def run(self, code: str, kill_after_s: float) -> tuple[str, list[str], bool]:
        """Run a session, and kill the program some time after it is ready.

        Returns:
            The code that it told, what it acknowledged, and whether it came to its
            end before it was killed.
        """
        assert self._forks.stdin is not None
        assert self._forks.stdout is not None
        self._forks.stdin.write(f"{code}\n")
        self._forks.stdin.flush()
        said, acknowledged, has_ended, pid = "", [], False, 0
        timer = threading.Timer(kill_after_s, lambda: os.kill(pid, signal.SIGKILL))
        for line in self._forks.stdout:
            word, _, rest = line.strip().partition(" ")
            if word == "pid":
                pid = int(rest)
            elif word == "begin":
                timer.start()
            elif word == "code":
                said = rest
            elif word == "ack":
                acknowledged.append(rest)
            elif word == "end":
                timer.cancel()
                has_ended = True
            elif word == "gone":
                break
        timer.cancel()
        return said, acknowledged, has_ended

    def close(self) -> None:
        """Let the program end."""
        assert self._forks.stdin is not None
        assert self._forks.stdout is not None
        self._forks.stdin.close()
        self._forks.wait()
        self._forks.stdout.close()


def kept_answers(session: StoredSession) -> set[tuple[str, int, str]]:
    """Return (step, attempt, values) of all answers on the disk."""
    return {
        (
            str(record.content["step"]),
            int(record.content.get("attempt", 0)),
            _plain(record.content["values"]),
        )
        for record in session.records.intact
        if record.kind == "answers"
    }


def _plain(values: dict[str, Any]) -> str:
    return json.dumps(values, sort_keys=True)


def check(study: Study, code: str, acknowledged: list[str], tally: Tally) -> State:
    """Compare what was acknowledged with what is on the disk."""
    try:
        session = study.session(code)
    except StudyError as problem:
        tally.unreadable += 1
        tally.told.append(str(problem))
        return State.STOPPED
    kept = kept_answers(session)
    tally.torn = max(tally.torn, len(session.records.damaged))
    for text in acknowledged:
        step, attempt, values = text.split(" ", 2)
        missing = f"{code}: {text}"
        wanted = (step, int(attempt), _plain(json.loads(values)))
        if wanted not in kept and missing not in tally.told:
            tally.lost += 1
            tally.told.append(missing)
    return session.state


def measure(
    tally: Tally,
    kills: int,
    seed: int,
    until_s: float = math.inf,
    progress: Callable[[int], None] = lambda _n: None,
) -> Tally:
    """Kill the program until so many kills are counted, then let it end its session.

    Args:
        tally: what was counted before; goes on being counted.
        kills: how many there are to be in all.
        seed: of the moments.
        until_s: no kill later than this on the machine's clock.
        progress: told how many there were.
    """
    rng = np.random.default_rng([seed, tally.kills])
    with tempfile.TemporaryDirectory() as folder:
        study = make_study(Path(folder))
        with contextlib.closing(Program(study)) as program:
            run = _Run(program, study, tally)
            while tally.kills < kills and SystemClock().now_s() < until_s:
                run.go_on(float(rng.uniform(0.0, LATEST_S)))
                progress(tally.kills)
            if run.code:
                run.go_on(NEVER_S)
            tally.not_resumed += bool(run.code)
    return tally


class _Run:
    """Session after session of one program; `code` is the one that is open."""

    def __init__(self, program: Program, study: Study, tally: Tally) -> None:
        self.program, self.study, self.tally = program, study, tally
        self.code = ""
        self.acknowledged: list[str] = []

    def go_on(self, kill_after_s: float) -> None:
        """Run the program until it is killed, and look at what is on the disk."""
        tally = self.tally
        said, new, has_ended = self.program.run(self.code, kill_after_s)
        self.acknowledged += new
        tally.acknowledged += len(new)
        tally.kills += not has_ended
        tally.not_resumed += bool(self.code) and said not in ("", self.code)
        self.code = said or self.code or unfinished(self.study)
        if not self.code:
            return  # killed before there was a session
        state = check(self.study, self.code, self.acknowledged, tally)
        if state is not State.UNFINISHED:
            tally.completed += 1
            self.code, self.acknowledged = "", []


def unfinished(study: Study) -> str:
    """Return the session that was just begun, if there is one."""
    sessions, remarks = study.sessions()
    assert not remarks, remarks
    left = [s.code for s in sessions if s.state is State.UNFINISHED]
    assert len(left) <= 1
    return left[0] if left else ""


def main() -> int:
    """Print and keep the result."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=500)
    parser.add_argument("--seed", type=int, default=2012)
    parser.add_argument("--for-s", type=float, default=math.inf)
    parser.add_argument("--keep", action="store_true", help="write results/kill.json")
    options = parser.parse_args()
    tally = _kept(options.seed) if options.keep else Tally()
    until_s = SystemClock().now_s() + options.for_s

    def progress(kills: int) -> None:
        print(f"\r{kills}", end="", file=sys.stderr)

    measure(tally, options.kills, options.seed, until_s, progress)
    report = {"seed": options.seed, **vars(tally)}
    print(json.dumps(report, indent=1))
    if options.keep:
        replace_json(RESULTS, report)
    return 1 if tally.lost or tally.unreadable or tally.not_resumed else 0


def _kept(seed: int) -> Tally:
    """Return what earlier runs with this seed have counted."""
    if not RESULTS.exists():
        return Tally()
    report = json.loads(RESULTS.read_text(encoding="utf-8"))
    return Tally(**report) if report.pop("seed") == seed else Tally()


if __name__ == "__main__":
    sys.exit(main())
