"""Rides, logs and a library for the pictures of all pages; made once, then kept."""

import os
import shutil
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from hapticplayer.capture.choices import LogQuestion
from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.extras.rides.recording import simulate, write_simulated_clip
from hapticplayer.sequence.build import build_sequence
from hapticplayer.sequence.editing import rename_sequence
from hapticplayer.sequence.import_preview import ImportPreview, preview_import
from hapticplayer.sequence.unpack import unpack
from hapticplayer.shipped import DEMO

WIDE, HIGH = 384, 216
SEED = 2012
LATER_S = 6.4  # clock of the log
LONG_NAME = (
    "Twice round the lake and through the forest by the steep path with the roots, "
    "second attempt, front suspension locked, camera on the handlebar"
)
TITLES = ("Bicycle in the park", "Bicycle through the valley", LONG_NAME)


@dataclass(frozen=True, slots=True)
class Material:
    """What pages are about.

    Attributes:
        demo: folder of the demo.
        video: of a ride with three pats.
        log: its motion.
        certain, doubtful: what was found in the video with its own log, and
            with that of another ride.
        question: what is asked about a log without units.
        made: folder of the ride's sequence.
        library: folder with good sequences, a long name, and a damaged one.
        damaged: a video that ends too early.
    """

    demo: Path
    video: Path
    log: Path
    certain: ImportPreview
    doubtful: ImportPreview
    question: LogQuestion
    made: Path
    library: Path
    damaged: Path


def make_material(folder: Path) -> Material:
    """Make everything in an empty folder, in some seconds."""
    demo = folder / "demo"
    unpack(DEMO, demo)
    video, log, other = (folder / n for n in ("ride.mp4", "log.csv", "other.csv"))
    ride, stranger = (simulate(scene, SEED) for scene in ("bike", "horse"))
    write_simulated_clip(replace(ride, width=WIDE, height=HIGH), video)
    for path, ridden in ((log, ride), (other, stranger)):
        write_imu_csv(path, replace(ridden.imu, time_s=ridden.imu.time_s + LATER_S))
    damaged = folder / "damaged.mp4"
    damaged.write_bytes(video.read_bytes()[: video.stat().st_size // 2])
    made = build_sequence(video, folder / "ride", imu_log=log)
    return Material(
        demo,
        video,
        log,
        preview_import(video, log),
        preview_import(video, other),
        _question(video, folder / "other logger.csv"),
        made,
        _library(folder / "library", demo, made),
        damaged,
    )


def _question(video: Path, log: Path) -> LogQuestion:
    """The question about a log whose columns have names but no units."""
    time_s = np.arange(0.0, 20.0, 0.01)
    rows = np.column_stack([time_s, *[np.sin(time_s + k) for k in range(6)]])
    header = "t;ax;ay;az;gx;gy;gz"
    np.savetxt(log, rows, delimiter=";", header=header, fmt="%.6f", comments="")
    try:
        preview_import(video, log)
    except LogQuestion as question:
        return question
    raise RuntimeError("a log without units raises no question any more")


def _library(folder: Path, demo: Path, ride: Path) -> Path:
    """Link the demo and the ride under titles of all lengths, and damage one."""
    folder.mkdir()
    for number, title in enumerate(TITLES):
        made = folder / f"sequence-{number}"
        shutil.copytree(ride if number else demo, made, copy_function=_link)
        rename_sequence(made, title)
    (folder / "broken").mkdir()
    (folder / "broken" / "sequence.json").write_text("{}")
    return folder


def _link(source: str, target: str) -> None:
    try:
        os.link(source, target)
    except OSError:  # the demo lies on another disk
        shutil.copy2(source, target)
