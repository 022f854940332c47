"""Clocks of live sources: a serial IMU and a phone, simulated on a virtual clock.

A clip with three taps is heard by the machine while its IMU is read through the program's
own decoders. The serial IMU sends WT901 frames at 115200 baud; its clock is 40 ppm fast,
and its adapter hands over batches every 1 to 16 ms, which are read 1 ms later and more (0.5 ms,
exponentially). The phone answers as phyphox does, ten
times a second; an answer takes 2 to 80 ms, evenly distributed, 2 % are lost, and its clock
is off by up to 50 ppm. An error is that of a sample's time on the machine's clock, against
when it was taken. "So far" is the estimate when the sample comes, from 10 s on; "at the end"
that of all pairs, before anything corrects it; "after taps" what `synchronize` makes of it.

"After frames" are other clips, without sound: a test camera whose picture rolls by two sines
of random sizes and rates, filmed by the recorder's own writer, and its log through the same
sources. The camera stamps its frames up to 20 ms late, which no clock shows; the truth is that
of the frames, and "before frames" what the recorder's clock makes of them.
"""

import argparse
import itertools
import json
import math
import struct
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from benchmarks.common import Report, on_one_thread
from hapticplayer.capture import synchronize
from hapticplayer.capture.clock_lag import FRAMES, stamped_here
from hapticplayer.capture.frames import FrameRotation
from hapticplayer.capture.live.byte_stream import ByteSource, SampleCount
from hapticplayer.capture.live.phones import phyphox_events
from hapticplayer.capture.live.sensor_join import ACCEL, RATE, SensorJoin
from hapticplayer.capture.live.serial_imus import Wt901Decoder
from hapticplayer.capture.live.source import Samples
from hapticplayer.capture.live.source_clock import (
    COUNTED_SIGMA,
    QUARTZ_SIGMA,
    SourceClock,
)
from hapticplayer.capture.sync.result import ClipSound, SyncInput
from hapticplayer.capture.sync.synchronize import automatic
from hapticplayer.clock import ManualClock
from hapticplayer.errors import Message, no_progress
from hapticplayer.media.clip_info import probe
from hapticplayer.media.live_clip import LiveClip
from hapticplayer.media.live_input import CAMERAS, LiveInput
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ClockMap, ImuLog
from hapticplayer.model.arrays import Floats
from hapticplayer.sequence.synchronizing import watch
from tests.material.sync_clips import PatClip, simulate_pats

HOST_S = 5000.0
"""Machine's time of the clip's beginning."""
RATE_HZ, BAUD, SERIAL_PPM = 200.0, 115_200, 40.0
BATCH_S, POLL_S, DELAY_S, LOST, PHONE_PPM = (
    (0.001, 0.016),
    0.1,
    (0.002, 0.08),
    0.02,
    50.0,
)
USB_S, WAKE_UP_S = 0.001, 0.0005
SETTLED_S = 10.0
Seen = list[FrameRotation]
"""What frames have told, once they were followed."""
MOST_MS = {"serial": 5.0, "phone": 15.0}
MOST_AFTER_MS = 3.0
FILM_S, FRAME_RATE_HZ, CAMERA_LATE_S = 30.0, 30.0, 0.02
ROLLS, ROLL_RAD, ROLL_HZ = 2, (0.1, 0.5), (0.3, 1.0)
BUFFERS = {
    ACCEL: ("acc_time", "accX", "accY", "accZ"),
    RATE: ("gyr_time", "gyrX", "gyrY", "gyrZ"),
}


@dataclass(frozen=True)
class Taken:
    """What a source has given: samples, when they were taken, the clock's times so far."""

    samples: Samples
    true_s: Floats
    so_far_s: Floats
    clock: SourceClock


class Batches:
    """An adapter that hands over the bytes that were on the line by then."""

    byte_s = 10.0 / BAUD

    def __init__(self) -> None:
        self.waiting = b""

    def read(self, timeout_s: float) -> bytes:  # noqa: ARG002 - of the protocol
        """What has come."""
        data, self.waiting = self.waiting, b""
        return data

    def close(self) -> None:
        """Nothing is held."""


class Motion(Protocol):
    """What the sensor goes through."""

    duration_s: float

    def at(self, true_s: Floats) -> tuple[Floats, Floats]:
        """Specific force and angular rate (N, 3) at times of the clip."""
        ...


@dataclass(frozen=True)
class Tapped:
    """The motion of a clip with taps, which does not turn."""

    clip: PatClip

    @property
    def duration_s(self) -> float:
        return self.clip.duration_s

    def at(self, true_s: Floats) -> tuple[Floats, Floats]:
        imu, clock = self.clip.imu, self.clip.clock_map
        media_s = clock.rate * imu.time_s + clock.offset_s
        columns = [np.interp(true_s, media_s, one) for one in imu.specific_force_mps2.T]
        return np.stack(columns, axis=1), np.zeros((len(true_s), 3))


@dataclass(frozen=True)
class Rolled:
    """A camera that rolls by sines (size in rad, Hz, phase), and stamps its frames late."""

    sines: tuple[tuple[float, float, float], ...]
    late_s: float
    duration_s: float = FILM_S

    @classmethod
    def of(cls, rng: np.random.Generator) -> "Rolled":
        rolls = [
            (rng.uniform(*ROLL_RAD), rng.uniform(*ROLL_HZ), rng.uniform(0.0, math.tau))
            for _ in range(ROLLS)
        ]
        return cls(tuple(rolls), float(rng.uniform(0.0, CAMERA_LATE_S)))

    def angle_rad(self, media_s: Floats) -> Floats:
        return np.asarray(
            sum(a * np.sin(math.tau * hz * media_s + at) for a, hz, at in self.sines)
        )

    def at(self, true_s: Floats) -> tuple[Floats, Floats]:
        media_s, zero = true_s + self.late_s, np.zeros(len(true_s))
        angle = self.angle_rad(media_s)
        rate = RATE_HZ * (angle - self.angle_rad(media_s - 1.0 / RATE_HZ))
        force = np.column_stack([-np.sin(angle), zero, np.cos(angle)])
        return STANDARD_GRAVITY_MPS2 * force, np.column_stack([zero, rate, zero])

    def film(self, path: Path) -> None:
        """Write it by the recorder's writer, each frame with the time that it shows."""
        roll = "+".join(f"{a}*sin(2*PI*{hz}*t+{at})" for a, hz, at in self.sines)
        graph = f"testsrc2=size=320x240:rate=30:duration={FILM_S},setpts=PTS"
        clock = ManualClock(0.0)
        camera = LiveInput(f"lavfi:{graph},rotate='{roll}'", CAMERAS, clock)
        clip = LiveClip(path, camera, None, 0.0)
        count = round(FILM_S * FRAME_RATE_HZ)
        for live in itertools.islice(camera.packets(), count):
            clip.add(live, is_shown=False)
            clock.advance(1.0 / FRAME_RATE_HZ)
        clip.close()
        camera.close()


def wt901_frames(force: Floats, rate: Floats) -> list[bytes]:
    """The two frames of each sample, by an encoder of its own."""
    units = 16.0 * STANDARD_GRAVITY_MPS2 / 32768.0, math.radians(2000.0) / 32768.0
    accel, gyro = (
        np.round(values / unit).clip(-32768, 32767).astype(int).tolist()
        for values, unit in zip((force, rate), units, strict=True)
    )
    return [
        _with_sum(b"\x55\x51" + struct.pack("<4h", *one, 2500))
        + _with_sum(b"\x55\x52" + struct.pack("<4h", *other, 2500))
        for one, other in zip(accel, gyro, strict=True)
    ]


def _with_sum(frame: bytes) -> bytes:
    return frame + bytes((sum(frame) & 0xFF,))


def serial(motion: Motion, rng: np.random.Generator) -> Taken:
    """Read a motion through a serial port."""
    step_s = 1.0 / RATE_HZ / (1.0 + SERIAL_PPM * 1e-6)
    true_s = np.arange(0.0, motion.duration_s, step_s)
    frames = wt901_frames(*motion.at(true_s))
    # each byte is on the line when the sample was taken and those before were sent
    ends_s = true_s[:, None] + Batches.byte_s * np.arange(1, len(frames[0]) + 1)
    stream, ends_s = b"".join(frames), ends_s.ravel()
    clock, link = ManualClock(HOST_S), Batches()
    count = SampleCount(None, (50.0, 100.0, 200.0))
    source = ByteSource(link, Wt901Decoder(), clock, count, "serial", Message("none"))
    found, at, batch_s = SourceClock(COUNTED_SIGMA), 0, 0.0
    parts, times = [], []
    while at < len(stream):
        batch_s += rng.uniform(*BATCH_S)
        end = int(np.searchsorted(ends_s, batch_s, side="right"))
        link.waiting, at = stream[at:end], end
        clock.sleep_until(HOST_S + batch_s + USB_S + rng.exponential(WAKE_UP_S))
        _read(source.read(0.0), found, parts, times)
    samples, so_far_s = _joined(parts), np.concatenate(times)
    # the first samples measure the period: those that came are the last ones
    return Taken(samples, true_s[len(true_s) - len(so_far_s) :], so_far_s, found)


def _read(
    samples: Samples, clock: SourceClock, parts: list[Samples], times: list[Floats]
) -> None:
    clock.add(samples.stamp_s, samples.arrival_s)
    parts.append(samples)
    times.append(clock.host_s(samples.stamp_s))


def _joined(parts: list[Samples]) -> Samples:
    return Samples(*(np.concatenate(part) for part in zip(*parts, strict=True)))


def phone(motion: Motion, rng: np.random.Generator) -> Taken:
    """Read a motion from a phone over a slow link."""
    ppm, begun_s = rng.uniform(-PHONE_PPM, PHONE_PPM), rng.uniform(1.0, 100.0)
    true_s = np.arange(0.0, motion.duration_s, 1.0 / RATE_HZ)
    stamp_s = begun_s + true_s * (1.0 + ppm * 1e-6)
    force, rate = motion.at(true_s)
    join, found = SensorJoin(), SourceClock(QUARTZ_SIGMA, 0.006)
    parts: list[Samples] = []
    times: list[Floats] = []
    sent, arrived_s = 0, 0.0
    for at_s in np.arange(POLL_S, motion.duration_s, POLL_S):
        end = int(np.searchsorted(true_s, at_s, side="right"))
        part, sent = slice(sent, end), end
        if rng.random() < LOST:
            continue
        arrived_s = max(arrived_s, HOST_S + at_s + rng.uniform(*DELAY_S))
        answer = phyphox_answer(stamp_s[part], force[part], rate[part])
        for sensor, stamp, values in phyphox_events(answer, BUFFERS, "phone"):
            join.add(sensor, stamp, values, arrived_s)
        _read(join.take(), found, parts, times)
    samples = _joined(parts)
    rows = np.searchsorted(stamp_s, samples.stamp_s - 1e-6)
    return Taken(samples, true_s[rows], np.concatenate(times), found)


def phyphox_answer(stamp_s: Floats, force: Floats, rate: Floats) -> bytes:
    """An answer as the app writes it, by an encoder of its own."""
    columns = {}
    for (time, *axes), values in zip(BUFFERS.values(), (force, rate), strict=True):
        columns[time] = stamp_s
        columns |= dict(zip(axes, values.T, strict=True))
    buffers = {
        name: {"size": 0, "updateMode": "partial", "buffer": one.tolist()}
        for name, one in columns.items()
    }
    return json.dumps({"buffer": buffers, "status": {"measuring": True}}).encode()


def by_taps(taken: Taken, clip: PatClip) -> dict[str, float]:
    """The errors of one recording with taps, ms."""
    stamp_s = taken.samples.stamp_s
    media_s = taken.clock.host_s(stamp_s) - HOST_S
    is_settled = taken.true_s > SETTLED_S
    so_far = taken.so_far_s[is_settled] - HOST_S - taken.true_s[is_settled]
    log = ImuLog(media_s, taken.samples.accel_mps2, taken.samples.rate_radps)
    found = synchronize(log, clip.audio, clip.audio_rate_hz, method="pats")
    after_s = found.clock_map.rate * media_s + found.clock_map.offset_s
    return {
        "so_far": _p95_ms(so_far),
        "at_end": _p95_ms(media_s - taken.true_s),
        "after": _p95_ms(after_s - taken.true_s),
        "stated": 1e3 * taken.clock.residual_s,
        "is_confident": float(found.is_confident),
    }


def by_frames(taken: Taken, motion: Rolled, film: Path, seen: Seen) -> dict[str, float]:
    """The errors of one recording without sound, ms, as its import makes them.

    The frames are followed once for both sources, whose clocks are some ms apart.
    """
    media_s = taken.clock.host_s(taken.samples.stamp_s) - HOST_S
    log = ImuLog(media_s, taken.samples.accel_mps2, taken.samples.rate_radps)
    residual_s = taken.clock.residual_s

    def look() -> FrameRotation:
        if not seen:
            seen.append(watch(probe(film), no_progress, log))
        return seen[0]

    inputs = SyncInput(
        log,
        lambda: ClipSound(np.zeros(0)),
        own=ClockMap(0.0, 1.0, residual_s, 1.0),
        look=look,
        lag=stamped_here(residual_s),
    )
    found = automatic(inputs)
    after_s = found.clock_map.rate * media_s + found.clock_map.offset_s
    truth_s = taken.true_s + motion.late_s
    return {
        "before": _p95_ms(media_s - truth_s),
        "after": _p95_ms(after_s - truth_s),
        "is_corrected": float(
            found.lag is not None and found.lag.measured_by == FRAMES
        ),
    }


def _p95_ms(error_s: Floats) -> float:
    return float(1e3 * np.percentile(np.abs(error_s), 95))


SOURCES = {"serial": serial, "phone": phone}


def options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "--clips", type=int, help="of 60 s, each source, and half as many films (40)"
    )
    parser.add_argument("--seed", type=int, default=200_000)


def run(options: argparse.Namespace, report: Report) -> None:
    """Record all clips from both sources."""
    on_one_thread()
    clips = options.clips or (6 if options.quick else 40)
    rows: list[list[Any]] = []
    tapped: dict[str, list[dict[str, float]]] = {name: [] for name in SOURCES}
    filmed: dict[str, list[dict[str, float]]] = {name: [] for name in SOURCES}
    for seed in range(options.seed, options.seed + clips):
        clip = simulate_pats(seed, hard=False, rate_hz=200)
        for name, take in SOURCES.items():
            taken = take(Tapped(clip), np.random.default_rng(seed))
            tapped[name].append(by_taps(taken, clip))
    for seed in range(options.seed, options.seed + math.ceil(clips / 2)):
        motion = Rolled.of(np.random.default_rng([seed, 1]))
        with tempfile.TemporaryDirectory(prefix="hp-live-") as folder:
            film = Path(folder) / "clip.mkv"
            motion.film(film)
            seen: Seen = []
            for name, take in SOURCES.items():
                taken = take(motion, np.random.default_rng([seed, 2]))
                filmed[name].append(by_frames(taken, motion, film, seen))
    for name in SOURCES:
        figures = _figures(tapped[name], filmed[name])
        report.figures[name] = figures
        rows.append([name, *figures.values()])
        _targets(name, figures, report)
    head = ["source", "so far", "at the end", "stated", "after taps", "taps found"]
    head += ["before frames", "after frames", "frames used", "clips", "films"]
    report.table(
        "p95 of the error of time stamps, ms: the 95 % of clips", head, rows, "live"
    )


def _figures(
    tapped: list[dict[str, float]], filmed: list[dict[str, float]]
) -> dict[str, float]:
    sure = [one for one in tapped if one["is_confident"]]
    return {
        "so_far_ms": _of(tapped, "so_far"),
        "at_end_ms": _of(tapped, "at_end"),
        "stated_ms": float(np.median([one["stated"] for one in tapped])),
        "after_taps_ms": _of(sure, "after"),
        "confident": len(sure),
        "before_frames_ms": _of(filmed, "before"),
        "after_frames_ms": _of(filmed, "after"),
        "corrected": int(sum(one["is_corrected"] for one in filmed)),
        "clips": len(tapped),
        "films": len(filmed),
    }


def _targets(name: str, figures: dict[str, float], report: Report) -> None:
    for what, key, most in (
        ("p95 at the end, ms", "at_end_ms", MOST_MS[name]),
        ("p95 after taps, ms", "after_taps_ms", MOST_AFTER_MS),
        ("p95 after frames, ms", "after_frames_ms", MOST_AFTER_MS),
    ):
        report.target(f"{name}: {what}", figures[key], ("<=", most))
    for what, key, of in (
        ("taps found", "confident", "clips"),
        ("frames used", "corrected", "films"),
    ):
        report.target(f"{name}: {what}", figures[key] / figures[of], (">=", 0.9))


def _of(found: list[dict[str, float]], key: str) -> float:
    """The p95 over clips of their p95."""
    return float(np.percentile([one[key] for one in found], 95))
