"""The paper's board: ADXL345, ITG-3200 and HMC5843 that log to a microSD card.

Its firmware reads the sensors 200 times a second, averages to 30 Hz, and stamps each
row with its own clock in milliseconds. While the card is busy nothing is read: the
row's mean, and its time, are those of the readings that were taken.

Sources: data sheets of the three parts; noise at 200 Hz and bias as measured in
SisFall, whose recorder has the first two; gains of the HMC5843 from the stock
firmware of the board (ryowens84/Ultimate-IMU). Assumed, without a source: the stalls
of a card, the self-heating, the clock's error of an uncompensated quartz (30 ppm SD).
"""

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from hapticplayer.extras.rides.sensors import (
    IDEAL,
    PAPER_BOARD,
    SensorErrors,
    SensorModel,
    window_means,
)
from hapticplayer.extras.rides.trajectory import Trajectory
from hapticplayer.model import ClockMap, ImuLog, Sampling
from hapticplayer.model.arrays import Floats
from hapticplayer.model.quaternions import conjugate, rotate

EARTH_FIELD_UT = (0.0, 21.0, -42.6)
"""East, north, up at 48 N, 2 W (47.5 uT, 64 deg down), as the IGRF has it about 2012."""

_MG = 9.80665e-3
_DEGREE = np.pi / 180.0


@dataclass(frozen=True, slots=True)
class LoggerBoard:
    """A logger."""

    sensor: SensorModel = IDEAL  # accelerometer and gyro, rate and averaging
    magnetometer: SensorErrors = field(default_factory=SensorErrors)  # errors in uT
    magnetometer_hz: float = 50.0  # readings between two of its samples repeat it
    # SD of the gyro's error by specific force, rad/s per m/s2
    rate_per_mps2: float = 0.0
    heating_k: float = 0.0  # by how much it warms up, in the end
    heating_s: float = 150.0  # time constant of that
    stall_every_s: float = 0.0  # mean time between two stalls of the card; 0 for none
    stall_s: tuple[float, float] = (0.02, 0.08)  # their shortest and longest length
    clock_ppm: float = 0.0  # SD of the clock's error
    # shortest and longest time from the clock's zero to the first reading
    boot_s: tuple[float, float] = (0.0, 0.0)
    stamp_s: float = 0.0  # resolution of the time stamps; 0 for exact ones


PAPER = LoggerBoard(
    sensor=replace(
        PAPER_BOARD,
        name="ADXL345, ITG-3200, HMC5843",
        accelerometer=replace(
            PAPER_BOARD.accelerometer,
            cross=0.01,
            per_kelvin=(0.4 * _MG, 0.4 * _MG, 1.2 * _MG),
        ),
        gyro=replace(PAPER_BOARD.gyro, cross=0.01, per_kelvin=(0.15 * _DEGREE,) * 3),
    ),
    magnetometer=SensorErrors(
        noise=0.5, bias=3.0, scale=0.03, cross=0.02, limit=100.0, step=100.0 / 1300.0
    ),
    rate_per_mps2=0.1 * _DEGREE / 9.80665,
    heating_k=3.0,
    stall_every_s=8.0,
    clock_ppm=30.0,
    boot_s=(0.8, 2.5),
    stamp_s=0.001,
)
"""The paper's board, mounted by hand."""


@dataclass(frozen=True, slots=True, eq=False)
class BoardLog:
    """What a board wrote, and what is true of it."""

    imu: ImuLog  # on the board's own clock, frame A
    clock_map: ClockMap  # the true way from that clock to media time
    stalls_s: Floats  # (K, 2) begin and end of each stall, media time


def record(
    trajectory: Trajectory,
    span_s: tuple[float, float],
    board: LoggerBoard,
    rng: np.random.Generator,
) -> BoardLog:
    """Let a board record a span of media time of a trajectory.

    The trajectory reaches from at least one reading before the span on.
    """
    step_s = 1.0 / board.sensor.rate_hz
    count = int((span_s[1] - span_s[0]) * board.sensor.rate_hz + 1e-6)
    time_s = np.asarray(span_s[0] + (np.arange(count) + 0.5) * step_s, np.float64)
    values = _readings(trajectory, time_s, board, rng)
    stalls_s = _stalls(span_s, board, rng)
    starts = np.searchsorted(stalls_s[:, 0], time_s, side="right") - 1
    is_read = np.ones(count, dtype=bool)
    inside = starts >= 0
    is_read[inside] = time_s[inside] >= stalls_s[starts[inside], 1]
    rows = _averaged(np.column_stack([time_s, values]), is_read, board.sensor)
    rate = 1.0 + 1e-6 * board.clock_ppm * float(rng.standard_normal())
    boot_s = float(rng.uniform(*board.boot_s))
    # media = rate * own + offset, and the span begins boot_s after the clock's zero
    clock = ClockMap(offset_s=span_s[0] - rate * boot_s, rate=rate)
    own_s = (rows[:, 0] - clock.offset_s) / rate
    if board.stamp_s > 0.0:
        own_s = np.round(own_s / board.stamp_s) * board.stamp_s
    averaged = board.sensor.averaged_to_hz is not None
    imu = ImuLog(
        time_s=own_s,
        specific_force_mps2=rows[:, 1:4],
        angular_rate_radps=rows[:, 4:7],
        magnetic_field_ut=rows[:, 7:10],
        sampling=Sampling.AVERAGED if averaged else Sampling.INSTANT,
        source=board.sensor.name,
    )
    return BoardLog(imu, clock, stalls_s)


def _readings(
    trajectory: Trajectory, time_s: Floats, board: LoggerBoard, rng: np.random.Generator
) -> Floats:
    """Return (N, 9): force, rate and field as the sensors give them."""
    rate_hz = board.sensor.rate_hz
    truth = trajectory.at(time_s)
    since_s = time_s - time_s[0]
    warmer_k = board.heating_k * (1.0 - np.exp(-since_s / board.heating_s))
    force = truth.specific_force_mps2
    # the force is taken in the middle of the interval over which the gyro integrates
    rate = trajectory.mean_rate_radps(time_s + 0.5 / rate_hz, 1.0 / rate_hz)
    if board.rate_per_mps2 > 0.0:
        rate = rate + force @ (board.rate_per_mps2 * rng.standard_normal((3, 3)))
    earth = np.broadcast_to(np.array(EARTH_FIELD_UT), force.shape)
    field_ut = rotate(conjugate(truth.quaternion_wxyz), earth)
    every = max(1, round(rate_hz / board.magnetometer_hz))
    sampled = board.magnetometer.applied(field_ut[::every], board.magnetometer_hz, rng)
    return np.column_stack(
        [
            board.sensor.accelerometer.applied(force, rate_hz, rng, warmer_k),
            board.sensor.gyro.applied(rate, rate_hz, rng, warmer_k),
            np.repeat(sampled, every, axis=0)[: len(force)],
        ]
    )


def _stalls(
    span_s: tuple[float, float], board: LoggerBoard, rng: np.random.Generator
) -> Floats:
    stalls, at_s = [], span_s[0]
    while board.stall_every_s > 0.0:
        at_s += float(rng.exponential(board.stall_every_s))
        if at_s >= span_s[1]:
            break
        end_s = at_s + float(rng.uniform(*board.stall_s))
        stalls.append((at_s, end_s))
        at_s = end_s
    return np.array(stalls).reshape(-1, 2)


def _averaged(
    values: Floats, is_read: NDArray[np.bool_], sensor: SensorModel
) -> Floats:
    """Return the means over windows of what was read; none for an empty window."""
    if sensor.averaged_to_hz is None:
        return np.asarray(values[is_read])
    per_window = sensor.rate_hz / sensor.averaged_to_hz
    weights = np.where(is_read, 1.0, 0.0)[:, None]
    share = window_means(weights, per_window)
    means = window_means(values * weights, per_window)
    some = share[:, 0] > 0.5 / per_window
    return np.asarray(means[some] / share[some])
