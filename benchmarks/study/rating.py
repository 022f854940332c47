"""Ratings while a clip plays: their media time, and what a kill loses.

The real program runs offscreen with a participant whose key changes with every frame that
is shown: each change has to bear the time of its frame. Then it is killed at seeded
moments of clips, while a slider moves 50 times a second.
"""

import argparse
import contextlib
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import Qt, QTimer
from PySide6.QtTest import QTest

from app.participant.application import StudySession
from app.player.application import make_application
from app.player.video_surface import VideoSurface
from benchmarks.common import ROOT, Report, positive
from hapticplayer.clock import SystemClock
from hapticplayer.media.encode import write_clip
from hapticplayer.media.frames import DecodedFrame
from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.live_ratings import read_ratings
from hapticplayer.study.pages import PageKind
from hapticplayer.study.session_setup import load_study_sources
from hapticplayer.study.study_folder import Study, open_study
from tests.material.shaken import write_shaken_sequence

RATE_HZ, SIZE = 25, (36, 64)
TOLD_MS, EARLIEST_S, LATEST_S, NEVER_S = 20, 0.3, 3.0, 60.0
LANGUAGES = ("en", "fr", "de")
Say = Callable[[str, float], list[dict[str, Any]]]
"""Runs a session for a task, kills it after so long, and returns what it said."""


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--kills", type=positive, help="(50)")
    parser.add_argument("--seed", type=int, default=2012)


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure times of one clip, then kill the program so often."""
    kills = options.kills or (10 if options.quick else 50)
    rng = np.random.default_rng(options.seed)
    with tempfile.TemporaryDirectory() as folder:
        study = make_study(Path(folder), 10.0 if options.quick else 60.0)
        with _program(study) as say:
            told = say("times", NEVER_S + 60.0)
            errors_ms = 1e3 * _errors_s(study, told)
            lost_s = [_loss_s(study, say, rng) for _ in range(kills)]
    p50, p95, most = np.percentile(np.abs(errors_ms), [50, 95, 100])
    rows = [["changes", len(errors_ms)], ["p50, ms", p50], ["p95, ms", p95]]
    report.table("Rating less frame", ["", ""], [*rows, ["largest, ms", most]])
    known = [one for one in lost_s if one is not None]
    report.table(
        "Kills",
        ["", ""],
        [["kills", len(lost_s)], ["most lost, s", max(known, default=np.nan)]],
    )
    report.target("media time of a rating, p95, ms", p95, ("<=", 10.0))
    report.target("files unreadable", len(lost_s) - len(known), ("<=", 0))
    report.target("most that a kill lost, s", max(known, default=np.nan), ("<=", 1.0))
    report.figures |= {"seed": options.seed, "changes": len(errors_ms), "kills": kills}


def make_study(folder: Path, clip_s: float) -> Study:
    """Make a study that rates by a slider and a held key."""
    clip = folder / "clip.mp4"
    count = round(RATE_HZ * clip_s)
    frames = (np.full((*SIZE, 3), i % 250, np.uint8) for i in range(count))
    write_clip(clip, frames, frame_rate_hz=RATE_HZ)
    target = write_shaken_sequence(clip, folder / "sequence")
    made = create_study(folder / "study", folders={"bike": target})
    content = json.loads(made.content)
    content["sequences"] = content["sequences"][:1]
    content["checks"].update(device=False, sound=False, disk_free_mb=1)
    text = dict.fromkeys(LANGUAGES, "x")
    slider = {"key": "slider", "kind": "slider", "least": 0, "most": 999_999}
    content["while_watching"] = [
        {**slider, "text": text, "by": ["keys"]},
        {"key": "held", "kind": "held-key", "text": text, "hold": "v"},
    ]
    return change_definition(made, content)


def _errors_s(study: Study, told: list[dict[str, Any]]) -> np.ndarray[Any, Any]:
    """Media time of each change of the key less that of the frame that it answered."""
    (code,) = open_study(study.folder).codes()
    held = next(
        one for one in read_ratings(study.session(code), []) if one.rating.key == "held"
    )
    changed = np.flatnonzero(np.diff(held.value, prepend=0.0))
    answered_s = np.array([one["frame_s"] for one in told if "frame_s" in one])
    rated_s = held.media_s[changed]
    count = min(len(rated_s), len(answered_s))
    assert count > 0.9 * len(answered_s), (len(rated_s), len(answered_s))
    return rated_s[:count] - answered_s[:count]


def _loss_s(study: Study, say: Say, rng: np.random.Generator) -> float | None:
    """Kill the program during a clip; time between its last word and the last row."""
    before = set(open_study(study.folder).codes())
    told = say("kill", float(rng.uniform(EARLIEST_S, LATEST_S)))
    (code,) = set(open_study(study.folder).codes()) - before
    notices: list[str] = []
    found = read_ratings(open_study(study.folder).session(code), notices)
    slider = next(one for one in found if one.rating.key == "slider")
    moved = [one for one in told if "moved" in one]
    if notices or not moved:
        return None
    kept = slider.monotonic_s[-1] if len(slider.value) else moved[0]["moved"]
    return max(0.0, float(moved[-1]["moved"] - kept))


# --- the program under test ---------------------------------------------------------


@contextlib.contextmanager
def _program(study: Study) -> Iterator[Say]:
    """Give what runs a session, kills it, and returns what it has said."""
    command = [sys.executable, "-m", "benchmarks.study.rating", str(study.folder)]
    with subprocess.Popen(
        command,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
        cwd=ROOT,
        text=True,
    ) as process:

        def say(task: str, kill_after_s: float) -> list[dict[str, Any]]:
            assert process.stdin is not None
            assert process.stdout is not None
            process.stdin.write(f"{task} {kill_after_s}\n")
            process.stdin.flush()
            told: list[dict[str, Any]] = []
            for line in process.stdout:
                told.append(json.loads(line))
                if "gone" in told[-1]:
                    break
            return told

        yield say
        assert process.stdin is not None
        process.stdin.close()


def tell(**content: Any) -> None:
    sys.stdout.write(f"{json.dumps(content)}\n")
    sys.stdout.flush()


class Answered:
    """Shows frames, and tells of each that it is on the screen."""

    def __init__(
        self, surface: VideoSurface, answer: Callable[[DecodedFrame], None]
    ) -> None:
        self._surface, self._answer = surface, answer

    def show(self, frame: DecodedFrame) -> None:
        self._surface.present(frame)
        self._answer(frame)


def watch(folder: Path, task: str, kill_after_s: float) -> None:
    """Begin a session, play its first clip, and rate it."""
    application = make_application()
    study = open_study(folder)
    session = StudySession(
        study, load_study_sources(study), (), SystemClock(), audio=None
    )
    session.show(windowed=True)
    session.begin_session("", "en")
    runner = session.runner
    assert runner is not None
    runner.consent(given=True)
    while runner.page.kind is not PageKind.DEMONSTRATION:
        runner.skip("not of interest")
    runner.proceed()
    runner.proceed()
    session.participant.refresh()
    clock, shown = SystemClock(), [0]

    def answer(frame: DecodedFrame) -> None:
        if runner.watching is None or session.player.snapshot().media_s <= 0.0:
            return
        shown[0] += 1
        press = QTest.keyPress if shown[0] % 2 else QTest.keyRelease
        press(session.participant, Qt.Key.Key_V)
        if task == "times":
            tell(frame_s=frame.pts_s)

    def move() -> None:
        if runner.watching is not None:
            if (media_s := session.player.snapshot().media_s) > 0.0:
                value = runner.watching.values["slider"] + 1
                runner.watching.change("slider", value)
                tell(moved=clock.now_s())
            if task == "kill" and media_s > kill_after_s:
                os.kill(os.getpid(), signal.SIGKILL)
        else:
            session.close()
            application.quit()

    session.player.set_sink(Answered(session.surface, answer))
    timer = QTimer()
    timer.timeout.connect(move)
    timer.start(TOLD_MS)
    application.exec()


def be_the_program(folder: str) -> None:
    """Run a session for each line `TASK SECONDS` on stdin; each is a fork."""
    for line in sys.stdin:
        task, seconds = line.split()
        child = os.fork()
        if not child:
            watch(Path(folder), task, float(seconds))
            os._exit(0)
        os.waitpid(child, 0)
        tell(gone=time.monotonic())


if __name__ == "__main__":
    be_the_program(sys.argv[1])
