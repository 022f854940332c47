"""Everything that goes wrong with inertial recordings, one named case each.

A case is a raw recording with its truth, when the fault is over, and what must
become of it: it RECOVERS (from 10 s after the fault on, no error is a degree larger
than the largest of the clean recording), is REFUSED (with a message that says
where), is DEGRADED (information is lost for good; a bound is given), or is REPORTED
(a sensor that errs: its error is shown, and nothing breaks).
"""

import copy
import enum
import functools
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from motion_signal import (
    GRAVITY_MPS2,
    RATE_HZ,
    UP_1_G,
    Raw,
    Scene,
    record,
    usual_acceleration,
)
from scipy.spatial.transform import Rotation

SETTLE_S = 10.0
MAX_EXCESS_DEG = 1.0
FAULT_S = (20.0, 22.0)
ROW = round(FAULT_S[0] * RATE_HZ)
GAP = slice(ROW, round(FAULT_S[1] * RATE_HZ))


class Outcome(enum.Enum):
    """What must become of a case."""

    RECOVERS = "recovers"
    REFUSED = "refused"
    DEGRADED = "degraded"
    REPORTED = "reported"


@dataclass(frozen=True)
class Case:
    """One fault.

    Attributes:
        name: of the row in the table.
        raw: what the logger hands over.
        outcome: what must happen.
        fault_end_s: from when on the recording is whole again.
        says: pattern of the message, for REFUSED.
        bound_deg: RMS error that is allowed for good, for DEGRADED.
        during_deg: RMS error that is allowed while the fault lasts, where a bound
            follows from what is left of the information; else None.
        fault_begin_s: where `during_deg` begins.
        rate_hz: what a user would tell a filter that knows no time stamps.
    """

    name: str
    raw: Raw
    outcome: Outcome = Outcome.RECOVERS
    fault_end_s: float = 0.0
    says: str = ""
    bound_deg: float = 0.0
    during_deg: float | None = None
    fault_begin_s: float = 0.0
    rate_hz: float = RATE_HZ


Edit = Callable[[Raw], None]


def put(name: str, rows, value) -> Edit:
    """Return an edit that overwrites rows of one array."""

    def edit(raw: Raw) -> None:
        getattr(raw, name)[rows] = value

    return edit


def scaled(name: str, factor: float) -> Edit:
    """Return an edit that changes the unit of one array."""

    def edit(raw: Raw) -> None:
        setattr(raw, name, factor * getattr(raw, name))

    return edit


def clipped(name: str, limit: float) -> Edit:
    """Return an edit that cuts one array at a full scale."""

    def edit(raw: Raw) -> None:
        setattr(raw, name, np.clip(getattr(raw, name), -limit, limit))

    return edit


def taken(rows) -> Edit:
    """Return an edit that keeps, repeats or reorders rows."""

    def edit(raw: Raw) -> None:
        raw.__dict__.update(raw.taken(rows).__dict__)

    return edit


def stamped(function) -> Edit:
    """Return an edit that replaces the stamps by a function of them."""

    def edit(raw: Raw) -> None:
        raw.time_s = function(raw.time_s)

    return edit


def believed(raw: Raw) -> None:
    """Edit: nobody knows the true times, the stamps are all there is."""
    raw.time_s = np.arange(len(raw.time_s)) / RATE_HZ
    raw.true_s = raw.time_s.copy()


def typed(convert) -> Edit:
    """Return an edit of the array type of the sensors."""

    def edit(raw: Raw) -> None:
        raw.force, raw.rate, raw.field = map(convert, (raw.force, raw.rate, raw.field))

    return edit


def case(name: str, *edits: Edit, scene: Scene | None = None, **facts) -> Case:
    """Return a case: the scene is recorded and each edit spoils it."""
    raw = copy.deepcopy(_usual() if scene is None else record(scene))
    for edit in edits:
        edit(raw)
    return Case(name, raw, **facts)


@functools.cache
def _usual() -> Raw:
    return record(Scene())


def refused(name: str, says: str, *edits: Edit) -> Case:
    """Return a case that must be refused with a message like `says`."""
    return case(name, *edits, outcome=Outcome.REFUSED, says=says)


def in_gap(name: str, *edits: Edit) -> Case:
    """Return a case whose fault is over after 22 s."""
    return case(name, *edits, fault_end_s=FAULT_S[1])


def all_cases() -> list[Case]:
    """Return every case; a second or so of work."""
    return [
        *_values(),
        *_signals(),
        *_clipping(),
        *_erring(),
        *_magnetometer(),
        *_times(),
        *_arrays(),
        *_refusals(),
    ]


def _values() -> list[Case]:
    nan, inf = np.nan, np.inf
    gaps = [put(name, GAP, nan) for name in ("force", "rate", "field")]
    long_gap = slice(ROW, ROW + 10 * round(RATE_HZ))
    return [
        case("clean"),
        in_gap("acc exactly 0 for 1 s", put("force", slice(ROW, ROW + 100), 0.0)),
        case("first acc sample 0", put("force", 0, 0.0)),
        case("all sensors 0 in the first sample", *_zero_first()),
        in_gap("1 NaN acc sample", put("force", ROW, nan)),
        in_gap("1 NaN gyro sample", put("rate", ROW, nan)),
        in_gap("1 NaN mag sample", put("field", ROW, nan)),
        in_gap("1 inf acc sample", put("force", ROW, inf)),
        in_gap("1 -inf gyro sample", put("rate", (ROW, 1), -inf)),
        in_gap("1 inf mag sample", put("field", ROW, inf)),
        in_gap("1 acc sample of 1e300", put("force", ROW, 1e300)),
        in_gap("NaN in every 10th row", put("force", slice(5, None, 10), nan)),
        in_gap("2 s NaN gap acc", gaps[0]),
        in_gap("2 s NaN gap gyro", gaps[1]),
        in_gap("2 s NaN gap mag", gaps[2]),
        in_gap("2 s NaN gap all", *gaps),
        case(
            "10 s NaN gap gyro",
            put("rate", long_gap, nan),
            fault_end_s=FAULT_S[0] + 10.0,
        ),
        in_gap("NaN in the first 2 s", *[put(n, slice(200), nan) for n in _SENSORS]),
        case(
            "NaN in the last 2 s", *[put(n, slice(-200, None), nan) for n in _SENSORS]
        ),
    ]


_SENSORS = ("force", "rate", "field")


def _zero_first() -> list[Edit]:
    return [put(name, 0, 0.0) for name in _SENSORS]


def _signals() -> list[Case]:
    """Return honest samples of hard motion: nothing is damaged."""
    scene = Scene()
    fall = scene.with_extra(20.0, 26.0, -usual_acceleration(scene.time_s) - UP_1_G)
    braking = scene.with_extra(20.0, 30.0, [0.0, -3.0, 0.0])
    return [
        case("free fall 6 s", scene=fall, fault_end_s=26.0),
        case(
            "sustained 3 m/s2 for 10 s",
            scene=braking,
            fault_begin_s=20.0,
            fault_end_s=30.0,
            # levelled away completely it would be atan(3 / 9.8) = 17 deg
            during_deg=17.0,
        ),
        case("gyro bias 1 deg/s", scene=_biased(1.0)),
        case("gyro bias 4 deg/s", scene=_biased(4.0)),
        case("gyro bias 10 deg/s", scene=_biased(10.0)),
        case(
            "upside-down start",
            scene=Scene(start=Rotation.from_rotvec([np.pi, 0.0, 0.0])),
        ),
        case("0.5 rad per sample", scene=_spinning(0.5)),
        case("1.5 rad per sample", scene=_spinning(1.5)),
        case("4 rad per sample (aliased)", scene=_spinning(4.0)),
    ]


def _biased(degrees_per_s: float) -> Scene:
    axis = np.array([0.6, -0.64, 0.48])
    return Scene(gyro_bias_radps=tuple(np.radians(degrees_per_s) * axis))


def _spinning(angle_rad: float) -> Scene:
    axis = np.array([0.48, 0.6, 0.64])
    return Scene(spin_radps=angle_rad * RATE_HZ * axis)


def _shaken(peak_mps2: float, rate_hz: float) -> Scene:
    scene = Scene()
    phase = 2.0 * np.pi * rate_hz * (scene.time_s - 20.0)
    shake = np.stack([np.sin(phase), 0.5 * np.sin(phase + 1.0), np.sin(phase)], axis=1)
    return scene.with_extra(20.0, 30.0, peak_mps2 * shake)


def _clipping() -> list[Case]:
    """Return motion beyond a sensor's range; what it was there nobody knows."""
    g = GRAVITY_MPS2
    shaking = {"fault_begin_s": 20.0, "fault_end_s": 30.0}
    return [
        case(
            "shaking 30 m/s2 clipped at 16 m/s2",
            clipped("force", 16.0),
            scene=_shaken(30.0, 4.3),
            # the mean of the clipped axis is off by some m/s^2 of 9.8
            during_deg=20.0,
            **shaking,
        ),
        case(
            "shaking 30 m/s2 clipped at +-2 g",
            clipped("force", 2.0 * g),
            scene=_shaken(30.0, 4.3),
            during_deg=20.0,
            **shaking,
        ),
        case(
            "shaking 200 m/s2 clipped at +-16 g",
            clipped("force", 16.0 * g),
            scene=_shaken(200.0, 11.3),
            during_deg=20.0,
            **shaking,
        ),
        case(
            "gyro clipped at 57 deg/s",
            clipped("rate", 1.0),
            scene=Scene(turning=1.5),
            outcome=Outcome.DEGRADED,
            # each swing beyond the rail loses some 10 deg, of the rail's whole minute
            bound_deg=15.0,
        ),
        _saturated_turn(),
    ]


def _saturated_turn() -> Case:
    """Return one turn within 1 s, up to 720 deg/s, with a range of 500 deg/s."""
    raw = copy.deepcopy(_usual())
    rail = np.radians(500.0)
    # the sensor is spun about its own z axis by whole turns, so that all else is kept
    spin = np.zeros(len(raw.rate))
    spin[ROW : ROW + 100] = 4.0 * np.pi * np.sin(np.linspace(0, np.pi, 101)[:-1]) ** 2
    angle = np.cumsum(spin / RATE_HZ)
    angle *= 2.0 * np.pi / angle[-1]
    spin = np.diff(angle, prepend=0.0) * RATE_HZ
    turn = Rotation.from_rotvec(np.outer(angle, [0.0, 0.0, 1.0])).inv()
    for name in ("force", "rate", "field", "up"):
        setattr(raw, name, turn.apply(getattr(raw, name)))
    raw.rate[:, 2] += spin
    raw.rate = np.clip(raw.rate, -rail, rail)
    return Case("gyro saturated in a turn", raw, fault_end_s=21.0)


def railed(raw: Raw) -> None:
    """Edit: the gyro stops at 60 % of its peak, on a rail that wobbles by 0.1 %."""
    rail = 0.6 * np.abs(raw.rate).max()
    wobble = 1.0 + 0.001 * np.random.default_rng(5).standard_normal(raw.rate.shape)
    beyond = np.abs(raw.rate) > rail
    raw.rate[beyond] = (np.sign(raw.rate) * rail * wobble)[beyond]


def g_sensitive(raw: Raw) -> None:
    """Edit: each axis of the gyro shows 0.1 deg/s for each m/s^2 along it."""
    raw.rate += np.radians(0.1) * raw.force


def offset(raw: Raw) -> None:
    """Edit: the accelerometer is off by 0.3 m/s^2."""
    raw.force += 0.3 * np.array([0.6, -0.64, 0.48])


def held(raw: Raw) -> None:
    """Edit: a logger three times as fast as the sensor repeats its samples."""
    rows = np.arange(len(raw.rate)) // 3 * 3
    raw.force, raw.rate, raw.field = raw.force[rows], raw.rate[rows], raw.field[rows]


ERRING: dict[str, Edit] = {
    "gyro on a rail that wobbles": railed,
    "acc scale +5 %": scaled("force", 1.05),
    "acc scale -5 %": scaled("force", 0.95),
    "g-sensitivity 0.1 deg/s per m/s2": g_sensitive,
    "acc offset 0.3 m/s2": offset,
    "samples held at a third of the rate": held,
} | {f"10 s from {row // 100} s": taken(slice(row, row + 1000)) for row in (1000, 4000)}


def _erring() -> list[Case]:
    """Return sensors that err throughout, and clips too short to calibrate one."""
    return [case(name, edit, outcome=Outcome.REPORTED) for name, edit in ERRING.items()]


def _magnetometer() -> list[Case]:
    def parallel(raw: Raw) -> None:
        raw.field = 50.0 * raw.up

    def disturbed(raw: Raw) -> None:
        raw.field[ROW:] += [200.0, 0.0, 0.0]

    def absent(raw: Raw) -> None:
        raw.field = None

    return [
        case("mag 0", put("field", slice(None), 0.0)),
        case("no mag", absent),
        case("mag parallel to gravity", parallel),
        case("mag +200 uT from 20 s", disturbed),
        case("mag NaN throughout", put("field", slice(None), np.nan)),
    ]


def _times() -> list[Case]:
    rng = np.random.default_rng(7)
    count = len(Scene().time_s)
    kept = np.sort(rng.choice(count, round(0.9 * count), replace=False))
    twice = np.sort(np.r_[np.arange(count), rng.choice(count, count // 20)])
    swapped = np.arange(count)
    for row in (700, ROW, 4100):
        swapped[[row, row + 1]] = row + 1, row
    hole = np.r_[0:ROW, ROW + 200 : count]
    uneven = Scene(time_s=Scene().time_s + 0.002 * rng.uniform(-1.0, 1.0, count))
    noise_s = rng.uniform(-1.0, 1.0, count) / RATE_HZ
    return [
        case("10 % dropped", taken(kept)),
        case("2 s dropped", taken(hole), fault_end_s=FAULT_S[1]),
        case("5 % duplicated", taken(twice)),
        case(
            "10 % dropped, stamped as if even",
            taken(kept),
            believed,
            outcome=Outcome.DEGRADED,
            bound_deg=6.0,  # one rotation in ten is lost; VQF 4.9, offlineVQF 3.3
        ),
        case(
            "5 % duplicated, stamped as if even",
            taken(twice),
            believed,
            outcome=Outcome.DEGRADED,
            bound_deg=4.0,  # VQF 3.3, offlineVQF 1.7
        ),
        case("neighbours swapped", taken(swapped)),
        case("uneven sampling", scene=uneven),
        case("jitter 10 %", stamped(lambda t: t + 0.1 * noise_s)),
        case("jitter 20 %", stamped(lambda t: t + 0.2 * noise_s)),
        case("packets of 8 with one stamp", stamped(_packets)),
        case("stamps rounded to 0.02 s", stamped(lambda t: np.floor(50.0 * t) / 50.0)),
        case("NaN stamps", stamped(_with(np.nan, 0, ROW, ROW + 1, 5999))),
        case("one stamp 0, one far ahead", stamped(_with(0.0, ROW)), *_ahead()),
        case("epoch times", _in_epoch, fault_end_s=EPOCH_S),
    ]


EPOCH_S = 1.7e9


def _in_epoch(raw: Raw) -> None:
    raw.time_s = raw.true_s = raw.time_s + EPOCH_S


def _packets(t):
    last = np.minimum(np.arange(len(t)) // 8 * 8 + 7, len(t) - 1)
    return t[last]


def _with(value: float, *rows: int):
    def change(t):
        t = t.copy()
        t[list(rows)] = value
        return t

    return change


def _ahead() -> list[Edit]:
    return [stamped(_with(1e9, 4000))]


def _arrays() -> list[Case]:
    return [
        case("float32", typed(np.float32)),
        case("lists", typed(np.ndarray.tolist)),
        case("not contiguous", typed(lambda a: np.repeat(a, 2, axis=1)[:, ::2])),
        case("Fortran order", typed(np.asfortranarray)),
        case("big-endian", typed(lambda a: a.astype(">f8"))),
    ]


def _refusals() -> list[Case]:
    back = stamped(lambda t: np.where(np.arange(len(t)) < 3000, t, t - 5.0))
    nan = np.nan
    odd, even = slice(1, None, 2), slice(0, None, 2)
    return [
        refused("clock set back by 5 s", "jumps back by 4.99 s at row 3000", back),
        refused("rate 0", "same time", stamped(np.zeros_like)),
        refused("times in ms", "milliseconds", stamped(lambda t: 1000.0 * t)),
        refused(
            "all stamps NaN", "0 of 6000 times can be used", stamped(lambda t: nan * t)
        ),
        refused("1 sample", "number of samples is 1", taken(slice(0, 1))),
        refused("0 samples", "number of samples is 0", taken(slice(0, 0))),
        refused("acc in g", r"multiply it by 9\.80665", scaled("force", 1 / 9.80665)),
        refused("acc in mg", r"by 0\.00980665", scaled("force", 1e3 / 9.80665)),
        refused("acc all 0", "specific_force.* zero", put("force", slice(None), 0.0)),
        refused(
            "acc all NaN", "specific_force.* row 0", put("force", slice(None), nan)
        ),
        refused("gyro all NaN", "angular_rate.* row 0", put("rate", slice(None), nan)),
        refused(
            "gyro NaN from 20 s on",
            "angular_rate.* row 2000",
            put("rate", slice(ROW, None), nan),
        ),
        refused(
            "streams joined",
            "common times",
            put("force", odd, nan),
            put("rate", even, nan),
        ),
        refused(
            "stuck sensor",
            "stuck",
            put("force", slice(None), [0.0, 0.0, 9.8]),
            put("rate", slice(None), 0.01),
        ),
        refused("gravity removed before", "removed already", _without_gravity),
    ]


def _without_gravity(raw: Raw) -> None:
    raw.force -= GRAVITY_MPS2 * raw.up
