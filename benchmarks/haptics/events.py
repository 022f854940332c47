"""Events that are found in simulated rides, beside those that the rides hold.

Every scene, with a camera at 200 Hz and with the paper's board (means at 30 Hz). Impacts
(taps, kerbs, landings, catches) are known from how the ride was made, braking, turns and
stillness from its exact motion; saturation from a sensor of 2 g and 250 deg/s, artefacts
from stalls of the board's card and from spikes and gaps put into the camera's log. Events
near a limit may be found, but need not be. The thresholds were chosen on seeds 100 and 101.
"""

import argparse
import dataclasses
from collections import defaultdict
from collections.abc import Iterator
from typing import Any

import numpy as np

from benchmarks.common import Report, on_one_thread
from hapticplayer.extras.events.detectors import DETECTORS, find_events
from hapticplayer.extras.events.inputs import LowSound, low_sound
from hapticplayer.extras.rides.catalogue import RIDES, SCENES
from hapticplayer.extras.rides.motion_scenes import MOTION_SCENES, simulate_motion
from hapticplayer.extras.rides.recording import simulate
from hapticplayer.extras.rides.sensors import CAMERA, SensorErrors
from hapticplayer.model import ImuLog
from hapticplayer.motion import remove_gravity
from hapticplayer.sequence.events import Event
from hapticplayer.sequence.store import in_media_time
from tests.material.known_events import (
    KnownEvent,
    Score,
    known_events,
    known_taps,
    score,
    spans_of,
)

LEAST_PRECISION = {"camera": 0.95, "board": 0.9}
LEAST_RECALL = {"camera": 0.95, "board": 0.85}
RANGE_MPS2, RANGE_RADPS = 2.0 * 9.80665, np.radians(250.0)
LONGEST_S = 60.0
NOTHING = Score(0, 0, 0, 0)


@dataclasses.dataclass(frozen=True)
class Case:
    """A recording with its known events."""

    ride: str
    sensor: str
    imu: ImuLog
    sound: LowSound | None
    known: list[KnownEvent]
    duration_s: float
    kinds: tuple[str, ...] = tuple(DETECTORS)


def options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--seeds", type=int, help="0 and up (3)")
    parser.add_argument("--first-seed", type=int, default=0)


def run(options: argparse.Namespace, report: Report) -> None:
    """Measure precision and recall of each kind."""
    on_one_thread()
    seeds = range(options.seeds or (1 if options.quick else 3))
    scores: dict[tuple[str, str], Score] = defaultdict(lambda: NOTHING)
    unheard: dict[str, Score] = defaultdict(lambda: NOTHING)
    sure: dict[bool, list[bool]] = {True: [], False: []}
    for seed in seeds:
        for case in cases(options.first_seed + seed, quick=options.quick):
            found = events_in(case, case.sound)
            for kind in case.kinds:
                got = score(kind, found, case.known)
                scores[case.sensor, kind] = scores[case.sensor, kind].plus(got)
            for event in found:
                is_right = score(event.kind, [event], case.known).right
                sure[event.confidence >= 0.75].append(bool(is_right))
            if case.sound is not None:
                silent = score("impact", events_in(case, None), case.known)
                unheard[case.sensor] = unheard[case.sensor].plus(silent)
                heard = score("impact", found, case.known)
                both = f"{case.sensor}, with sound"
                unheard[both] = unheard[both].plus(heard)
    _tell(report, scores, unheard, sure)


def _tell(
    report: Report,
    scores: dict[tuple[str, str], Score],
    unheard: dict[str, Score],
    sure: dict[bool, list[bool]],
) -> None:
    header = ["sensor", "kind", "found", "right", "known", "hit", "precision", "recall"]
    rows = [
        [*key, *dataclasses.astuple(one), one.precision, one.recall]
        for key, one in sorted(scores.items())
    ]
    report.table("Events of simulated rides", header, rows)
    report.figures |= {"columns": header, "rows": rows}
    header = ["rides with sound", "precision", "recall"]
    heard = [[name, one.precision, one.recall] for name, one in unheard.items()]
    report.table("Impacts without and with the sound", header, heard)
    report.figures["impacts without and with sound"] = heard
    right = {
        "right of confidence from 0.75": float(np.mean(sure[True])),
        "right of confidence below 0.75": float(np.mean(sure[False] or [1.0])),
    }
    report.figures |= right
    print("; ".join(f"{name}: {share:.3f}" for name, share in right.items()))
    for sensor in ("camera", "board"):
        one = [(k, s) for (name, k), s in scores.items() if name == sensor]
        kind, worst = min(one, key=lambda pair: pair[1].precision)
        least = LEAST_PRECISION[sensor]
        what = f"{sensor}: precision of the worst kind ({kind})"
        report.target(what, worst.precision, (">=", least))
        kind, worst = min(one, key=lambda pair: pair[1].recall)
        what = f"{sensor}: recall of the worst kind ({kind})"
        report.target(what, worst.recall, (">=", LEAST_RECALL[sensor]))


def events_in(case: Case, sound: LowSound | None) -> list[Event]:
    """Return the events found while the clip plays."""
    found = find_events(remove_gravity(case.imu), case.imu, sound)
    return [
        one
        for one in found
        if one.end_s > 0.0 and one.start_s < case.duration_s and one.kind in case.kinds
    ]


def cases(seed: int, *, quick: bool) -> Iterator[Case]:
    """Yield all recordings of a seed."""
    for name in list(SCENES)[:: 3 if quick else 1]:
        yield from _filmed(name, seed)
    for name in list(MOTION_SCENES)[:: 4 if quick else 1]:
        for sensor, model in (("camera", "camera"), ("board", "paper-board")):
            ride = simulate_motion(name, seed, duration_s=LONGEST_S, sensor=model)
            known = known_events(ride.trajectory, LONGEST_S)
            yield Case(name, sensor, ride.imu, None, known, LONGEST_S)
    for name in ("run", "mountain-bike", "handheld-brisk", "car-hard"):
        yield _clipped(name, seed)
    for name in ("walk", "bicycle"):
        yield _flawed(name, seed)


def _filmed(name: str, seed: int) -> Iterator[Case]:
    ride = simulate(name, seed)
    sound = low_sound(ride.audio.mean(axis=1), ride.audio_rate_hz)
    length_s = ride.scene.duration_s
    known = known_events(ride.scene.trajectory, length_s) + known_taps(ride.scene)
    yield Case(name, "camera", ride.imu, sound, known, length_s)
    if name not in RIDES or ride.board is None:
        return
    imu = in_media_time(ride.board.imu, ride.board.clock_map)
    known += [
        KnownEvent("artefact", begin, end, end - begin > 2.0 / 30.0)
        for begin, end in ride.board.stalls_s.tolist()
        if end > 0.0 and begin < length_s
    ]
    yield Case(name, "board", imu, sound, known, length_s)


def _clipped(name: str, seed: int) -> Case:
    """Return a ride with a sensor whose ranges are too small for it."""
    model = dataclasses.replace(
        CAMERA,
        name="small range",
        accelerometer=SensorErrors(noise=0.035, bias=0.04, limit=RANGE_MPS2),
        gyro=SensorErrors(noise=0.003, bias=0.004, limit=RANGE_RADPS),
    )
    ride = simulate_motion(name, seed, duration_s=LONGEST_S, sensor=model)
    time_s = ride.imu.time_s
    known = []
    for values, limit in (
        (ride.imu.specific_force_mps2, RANGE_MPS2),
        (ride.imu.angular_rate_radps, RANGE_RADPS),
    ):
        is_clipped = (np.abs(values) >= limit).any(axis=1)
        known += spans_of("saturation", is_clipped, time_s)
    # the motion of such a sensor is wrong, so the other kinds are not known
    return Case(name, "camera", ride.imu, None, known, LONGEST_S, ("saturation",))


def _flawed(name: str, seed: int) -> Case:
    """Return a ride into which spikes and gaps were put."""
    ride = simulate_motion(name, seed, duration_s=LONGEST_S)
    rng = np.random.default_rng([seed, 35])
    imu, known = ride.imu, known_events(ride.trajectory, LONGEST_S)
    places = np.sort(rng.choice(np.arange(200, len(imu) - 200, 100), 12, replace=False))
    force = imu.specific_force_mps2.copy()
    for place in places[::2].tolist():
        force[place, rng.integers(3)] += rng.choice((-1.0, 1.0)) * rng.uniform(25, 60)
        at_s = float(imu.time_s[place])
        known.append(KnownEvent("artefact", at_s, at_s))
    keep = np.ones(len(imu), np.bool_)
    for place in places[1::2].tolist():
        last = place + int(rng.integers(8, 60))
        keep[place:last] = False
        begin_s, end_s = imu.time_s[[place - 1, last]].tolist()
        known.append(KnownEvent("artefact", begin_s, end_s))
    kept: dict[str, Any] = {
        "time_s": imu.time_s[keep],
        "specific_force_mps2": force[keep],
        "angular_rate_radps": imu.angular_rate_radps[keep],
    }
    flawed = ImuLog(**kept, sampling=imu.sampling, source=imu.source)
    return Case(name, "camera", flawed, None, known, LONGEST_S)
