"""Logs whose axes, signs, units or sensors are mistaken, and right ones.

Each recording of ../shared/data and simulated rides, whole and in pieces of 20 s, is read as
a log in memory, by what every reader of logs calls. It is right, or changed as a logger or a
person mistakes it. Right is no question about a right log, and one about a changed log where
gravity turns by 30 degrees and more. Where it turns about one axis, the others tell nothing:
a change counts as seen where it also turns gravity by 30 degrees otherwise than it is.
"""

import argparse
import itertools
import re
import sys
import zlib
from collections.abc import Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial

import numpy as np

from benchmarks.common import DATA, Report, on_one_thread
from benchmarks.motion.recordings import ORIENTATION, comma
from hapticplayer.capture import read_recording
from hapticplayer.capture.assemble import assemble
from hapticplayer.capture.choices import parse_choices
from hapticplayer.capture.mounting import (
    AS_RECORDED,
    all_mountings,
    axes_matrix,
    is_fallen,
    mean_up,
    mounted,
    up_in_frame_a,
)
from hapticplayer.capture.streams import RawLog, SensorStream
from hapticplayer.errors import HapticPlayerError
from hapticplayer.extras.rides.motion_scenes import MOTION_SCENES, simulate_motion
from hapticplayer.model import ImuLog
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.motion import remove_gravity
from tools.optical import read_log

PIECE_S, LEAST_ROWS, TURNS_RAD = 20.0, 100, np.radians(30.0)
RIDES, QUICK_RIDES, QUICK_ONE_IN, EVERY, QUICK_EVERY = 200, 7, 12, 5, 20
RIDE_SENSORS = ("camera", "phone", "paper-board")
MOST_DIRECTIONS = 300
LEAST_ASKED = 0.95
KEPT = np.eye(3)
ONE_NEGATED = [KEPT - 2.0 * np.diag(axis) for axis in KEPT]
PERMUTED = [np.array(p) for p in itertools.permutations(KEPT)][1:]
Change = tuple[Floats, Floats]
CHANGES: dict[str, list[Change]] = {
    "an axis of both mirrored": [(one, one) for one in ONE_NEGATED],
    "gyro reversed": [(KEPT, -KEPT)],
    "an axis of the gyro negated": [(KEPT, one) for one in ONE_NEGATED],
    "axes of the gyro permuted": [(KEPT, one) for one in PERMUTED],
    "gyro 57 times too high": [(KEPT, np.degrees(KEPT))],
    "gyro 57 times too low": [(KEPT, np.radians(KEPT))],
    "accelerometer and gyro swapped": [(KEPT, KEPT)],
    "accelerometer reversed": [(-KEPT, KEPT)],
}
"""What becomes of accelerometer and gyro, (3, 3) each."""
SWAPPED, REVERSED = "accelerometer and gyro swapped", "accelerometer reversed"


@dataclass(frozen=True, eq=False)
class Piece:
    """A recording or a part of it, upright as far as gravity tells.

    Attributes:
        name: of the recording.
        family: that it is of.
        is_whole: not a piece of 20 s.
        imu: the log.
        up: (N, 3) up in its axes, by the smoother over the whole recording.
        turns_rad: (N - 1, 3) its rotation between samples.
    """

    name: str
    family: str
    is_whole: bool
    imu: ImuLog
    up: Floats
    turns_rad: Floats

    def turned_rad(self) -> float:
        """By which gravity turns: the largest angle between two directions of up."""
        return largest_angle_rad(self.up)

    def shown_rad(self, accel: Floats, rate: Floats) -> float:
        """By which gravity turns in a changed log if its gyro is believed."""
        wrong = quat.chained(quat.from_rotation_vector(self.turns_rad @ rate.T))
        return largest_angle_rad(quat.rotate(wrong, self.up[1:] @ accel.T))


def largest_angle_rad(directions: Floats) -> float:
    """Between any two of directions (N, 3)."""
    some = directions[:: 1 + len(directions) // MOST_DIRECTIONS]
    some = some / np.linalg.norm(some, axis=1, keepdims=True)
    return float(np.arccos(np.clip((some @ some.T).min(), -1.0, 1.0)))


def pieces_of(name: str, family: str, imu: ImuLog) -> Iterator[Piece]:
    """A recording and its parts."""
    attitude = remove_gravity(imu).quaternion_wxyz
    count = int((imu.time_s[-1] - imu.time_s[0]) // PIECE_S)
    edges_s = imu.time_s[0] + PIECE_S * np.arange(count + 1)
    edges = np.searchsorted(imu.time_s, edges_s).tolist()
    for low, high in [(0, len(imu)), *itertools.pairwise(edges)]:
        part = slice(low, high)
        if high - low < LEAST_ROWS:  # a gap
            continue
        log, held = imu.part(part), attitude[part]
        upright = axes_matrix(axes_by_gravity(log))
        steps = quat.multiply(quat.conjugate(held[:-1]), held[1:])
        yield Piece(
            name,
            family,
            part == slice(0, len(imu)),
            mounted(log, axes_by_gravity(log)),
            quat.vertical(held) @ upright.T,
            quat.to_rotation_vector(steps) @ upright.T,
        )


def axes_by_gravity(imu: ImuLog) -> str:
    mean = mean_up(imu)
    if mean is None:
        return AS_RECORDED
    return max(all_mountings(), key=lambda axes: float(up_in_frame_a(mean, axes)[2]))


@dataclass(frozen=True)
class Outcome:
    """What became of a right or a changed piece.

    Attributes:
        family: of the recording.
        is_whole: not a piece of 20 s.
        change: a key of CHANGES, "" for a right one.
        is_shown: gravity turns by 30 degrees otherwise.
        is_asked: a person is asked, or it is refused.
        is_first: the answer named first leads to the right log.
        is_named: one of the answers does.
        words: of the question.
    """

    family: str
    is_whole: bool
    change: str
    is_shown: bool
    is_asked: bool
    is_first: bool = False
    is_named: bool = False
    words: str = ""


def outcomes(piece: Piece, number: int, every: int) -> Iterator[Outcome]:
    """Of a right piece, and of a change of each kind to one in `every`.

    Args:
        piece: of a recording.
        number: of the piece, which chooses among the changes of a kind.
        every: of those of 20 s; whole ones are all changed.
    """
    imu = piece.imu
    answers = "axes=x,y,z" if is_fallen(imu) else ""
    right, words = heard(imu, (KEPT, KEPT), "", answers)
    what = f"{piece.name}: {words}" if words else ""
    yield Outcome(piece.family, piece.is_whole, "", False, bool(words), words=what)
    if right is None or piece.turned_rad() < TURNS_RAD:
        return
    if number % every != 1 and not piece.is_whole:
        return
    for kind, changes in CHANGES.items():
        if kind == REVERSED and (answers or mean_up(imu) is None):
            continue
        change = changes[number % len(changes)]
        is_shown = kind in {SWAPPED, REVERSED}
        is_shown = is_shown or piece.shown_rad(*change) >= TURNS_RAD
        _, words = heard(imu, change, kind, answers)
        tried = (
            is_alike(heard(imu, change, kind, f"{answers} {one}")[0], right)
            for one in answers_in(words)
        )
        is_first = next(tried, False)
        yield Outcome(
            piece.family, piece.is_whole, kind, is_shown, bool(words),
            is_first, is_first or any(tried),
        )  # fmt: skip


def heard(
    imu: ImuLog, change: Change, kind: str, answers: str
) -> tuple[ImuLog | None, str]:
    """What is read from a changed log with answers, and else what is asked."""
    accel, rate = imu.specific_force_mps2, imu.angular_rate_radps
    streams = [
        SensorStream(imu.time_s, values @ matrix.T)
        for values, matrix in zip((accel, rate), change, strict=True)
    ]
    if kind == SWAPPED:
        streams.reverse()
    choices = parse_choices(answers.split())
    try:
        return assemble(RawLog("a log", *streams), choices, "log").imu, ""
    except HapticPlayerError as error:
        return None, str(error)


def answers_in(words: str) -> list[str]:
    """The answers in a question, as a person gives them."""
    _, _, said = words.partition("decide with --read-as ")
    each = r"[a-z]+(?:-[a-z]+)?=[^\s;]+"
    ones = re.findall(rf"{each}(?:(?: and)? {each})*", said)
    return [one.replace(" and ", " ").rstrip(",") for one in ones]


def is_alike(found: ImuLog | None, right: ImuLog) -> bool:
    if found is None or len(found) != len(right):
        return False
    pairs = (
        (found.specific_force_mps2, right.specific_force_mps2),
        (found.angular_rate_radps, right.angular_rate_radps),
    )
    return all(np.allclose(ours, theirs, 1e-3, 1e-3) for ours, theirs in pairs)


Source = tuple[str, str]
"""Kind and name of a recording: read where it is used, as it is large."""


def sources(rides: int, one_in: int) -> list[Source]:
    folders = ("native", "averaged_30hz")
    found = [
        ("optical", f"{folder}/{path.name}")
        for folder in folders
        for path in sorted((ORIENTATION / folder).glob("*.npz"))
    ]
    cameras = sorted((DATA / "capture" / "gopro").iterdir())
    found += [("gopro", path.name) for path in cameras if "timelapse" not in path.name]
    found += [("car", "comma2k19")]
    scenes = itertools.cycle(MOTION_SCENES)
    return found[::one_in] + [
        ("simulated", f"{scene},{RIDE_SENSORS[number // 14 % 3]},{1 + number // 14}")
        for number, scene in zip(range(rides), scenes, strict=False)
    ]


def read(source: Source) -> tuple[str, ImuLog]:
    """The family of a recording, and the recording."""
    kind, name = source
    if kind == "optical":
        path = ORIENTATION / name
        return path.name.split("_")[0], read_log(path)
    if kind == "gopro":
        return kind, read_recording(DATA / "capture" / "gopro" / name).imu
    if kind == "car":
        return kind, comma().imu
    scene, sensor, seed = name.split(",")
    return f"simulated {scene}", simulate_motion(scene, int(seed), sensor=sensor).imu


def outcomes_of(source: Source, *, every: int) -> list[Outcome]:
    family, imu = read(source)
    first = zlib.crc32(source[1].encode()) % 60
    found = enumerate(pieces_of(source[1], family, imu), first)
    return [one for number, piece in found for one in outcomes(piece, number, every)]


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--jobs", type=int, default=1, help="processes (1)")
    parser.add_argument("--one-in", type=int, default=1, help="of recordings (1)")
    text = f"simulated rides ({RIDES})"
    parser.add_argument("--rides", type=int, default=RIDES, help=text)


def run(options: argparse.Namespace, report: Report) -> None:
    """Read each piece right and wrong."""
    if not ORIENTATION.is_dir():
        sys.exit(f"the recordings are not on this machine: {ORIENTATION}")
    on_one_thread()
    every = QUICK_EVERY if options.quick else EVERY
    rides, one_in = options.rides, options.one_in
    if options.quick:
        rides, one_in = QUICK_RIDES, QUICK_ONE_IN
    one = partial(outcomes_of, every=every)
    with ProcessPoolExecutor(options.jobs) as pool:
        parts = pool.map(one, sources(rides, one_in))
        found = [outcome for part in parts for outcome in part]
    _tell(found, report)


def _tell(found: list[Outcome], report: Report) -> None:
    right = [one for one in found if not one.change]
    asked = [one.words for one in right if one.is_asked]
    report.figures |= {"right": len(right), "right, asked about": asked}
    report.target("right recordings and pieces, asked about", len(asked), ("<=", 0))
    rows = []
    for change in CHANGES:
        turning = [one for one in found if one.change == change]
        shown = [one for one in turning if one.is_shown]
        for name, is_whole in (("whole", True), ("20 s", False)):
            ones = [one for one in shown if one.is_whole == is_whole]
            rows.append([change, name, len(ones), *shares(ones)])
            rows[-1].append(shares(o for o in turning if o.is_whole == is_whole)[0])
        asked_share, _, _ = shares(shown)
        report.target(f"{change}: share asked about", asked_share, (">=", LEAST_ASKED))
    wrong = [one for one in found if one.change and one.is_shown]
    _, first, named = shares(wrong)
    report.figures |= {"first answer is right": first, "named answer is right": named}
    header = ["change", "of", "number", "asked", "first is right", "one is right"]
    header += ["asked, of all that turn"]
    report.table(f"{len(right)} right, {len(asked)} asked about", header, rows, "axes")


def shares(ones: Iterable[Outcome]) -> list[float]:
    """Asked about; of those with the right answer first; with the right one named."""
    ones = list(ones)
    asked = [one for one in ones if one.is_asked]
    count = len(asked) or 1
    first, named = (sum(getattr(o, k) for o in asked) for k in ("is_first", "is_named"))
    return [len(asked) / (len(ones) or 1), first / count, named / count]
