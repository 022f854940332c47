"""Plausible numbers and sizes of recordings, clips and forces, each once, with its source.

Numbers are those of a sensor in a hand or on a vehicle; others are in another unit or damaged.
Larger files are damaged or made to do harm, and are refused before memory is spent on them.
"""

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError, Message

# --- time ------------------------------------------------------------------------

GAP_STEPS = 3.0
"""A step of more than this many median steps of a log is a gap."""

MISSING_ROW_STEPS, LEAST_MISSING_S = 1.75, 0.02
"""One row of a 30 Hz log that is missing; stamps may jitter by a fifth."""

MIN_RATE_HZ = 5.0
"""Slower than this is no motion log; mostly it is time in another unit."""

MAX_USUAL_RATE_HZ = 2000.0
"""Faster than motion sensors are logged."""

MAX_RATE_HZ = 10_000.0
"""Faster than an inertial sensor is read; mostly it is time in another unit."""

MAX_TIME = 1e20
"""No clock counts so far, not even in nanoseconds since 1970."""

MAX_GAP_S = 3600.0
"""Silence beyond it: the rows belong to two recordings, or a time is wrong."""

MAX_REACH_S = 1.0
"""Longest extrapolation of a slow sensor (compass, gravity)."""

MAX_SECONDS = 48 * 3600.0
"""Longer than any clip; times of force beyond it are damage."""

FIRST_FRAME_S = -60.0
"""A video that begins earlier than this before its log does not belong to it."""

# --- samples ---------------------------------------------------------------------

MAX_SAMPLES = 100_000_000
"""Rows of one sensor: 34 h of an 800 Hz sensor."""

MAX_MISSING = 0.5
"""Larger shares of a sensor's samples cannot be filled in."""

LEAST_REPEATS = 40
"""Equal readings in a row that are no chance: one whose noise is half a step repeats every
other time, 2^-40."""

MIN_UNPAIRED = 0.1
"""Share of rows with one sensor only, of each kind, that means two streams."""

MAX_ANY_FORCE, MAX_ANY_RATE, MAX_ANY_FIELD = 1e5, 1e4, 1e7
"""Numbers beyond these are damage in any unit: 16 g are 16000 mg; 4000 deg/s; a
magnet at the sensor shows 1e6 nT."""

# --- specific force ------------------------------------------------------------

MAX_ACCELERATION_MPS2 = 500.0
"""No hand-held sensor measures 50 g; GoPro's range is 16 g."""


def refuse_absurd(acceleration_mps2: NDArray[np.floating], name: str) -> None:
    """Raise InputError for far more than sensors measure; spikes may be in it."""
    largest_mps2 = float(np.abs(acceleration_mps2).max(initial=0.0))
    if not largest_mps2 <= 10.0 * MAX_ACCELERATION_MPS2:
        raise InputError(
            "{name} reaches {largest_mps2:.3g} m/s2, beyond what sensors measure",
            name=name,
            largest_mps2=largest_mps2,
        )


REST_MPS2 = (8.5, 11.0)
"""Norm where the gyro shows rest, so that only cheap accelerometers widen it, by up to
10 %; `PLAUSIBLE_NORM_MPS2` of motion is of moving hands too."""

COARSE_REST_MPS2 = (7.0, 13.0)
"""Median norm that separates an accelerometer's file from a gyroscope's."""

REST_G = (0.6, 1.5)
"""Median norm of the first rows of a log in g."""

PLAUSIBLE_NORM_MPS2 = (4.0, 40.0)
"""Norm of the specific force in calm windows: 1 g at rest, 1.8 g in a runner's hand."""

SURELY_G = (0.8, 1.25)
"""The same of a log in g that needs no second look."""

EARTH_FIELD_UT = (20.0, 70.0)
"""Norm of the magnetic field, 22 to 67 uT on the ground: as m/s2 it is a compass's."""

UPRIGHT = 0.7
"""Cosine of 45 degrees: an axis farther from up is not z."""

MIN_MEAN_SHARE = 0.5
"""Mean vector over mean norm; below it the sensor rotated too much to show an axis."""

# --- errors of a sensor ----------------------------------------------------------

MAX_ACCEL_BIAS_MPS2 = 2.5
"""ADXL345, the worst in use: 150 mg in x and y, 250 mg in z."""

ACCEL_SCALES = (0.8, 1.25)
"""ADXL345: 230 to 282 counts per g for 256; cameras read up to 10.8 m/s2 at rest."""

MAX_GYRO_BIAS_RADPS = 0.7
"""ITG-3200: 40 deg/s; later gyros have a tenth."""

# --- angular rate ----------------------------------------------------------------

MAX_ANGULAR_RATE_RADPS = 100.0
"""5700 deg/s; sensors saturate at 2000 or 4000 deg/s."""

MAX_SI_RATE_RADPS = 40.0
"""2300 deg/s: no hand rotates faster, so a larger number is in another unit."""

MAX_USUAL_RATE_RADPS = 35.0
"""Sensors saturate at 2000 deg/s; no hand rotates faster for long."""

# --- force of a device -----------------------------------------------------------

AT_LIMIT = 0.99
"""Share of the force limit from which a force counts as saturated: between two entries
at the limit a line is a little shorter."""

MAX_FORCE_N = 1000.0
"""Beyond any haptic device of this kind, the Falcon has 9 N: it is in another unit."""


def are_gaps(
    steps_s: NDArray[np.floating], usual_s: float | None = None
) -> NDArray[np.bool_]:
    """Whether each step between samples is a gap.

    Args:
        steps_s: (N,).
        usual_s: the median step, if it is known.
    """
    if not steps_s.size:
        return np.zeros(0, np.bool_)
    usual_s = float(np.median(steps_s)) if usual_s is None else usual_s
    return np.asarray(steps_s > GAP_STEPS * usual_s)


def are_unpaired(has_one: NDArray[np.bool_], has_other: NDArray[np.bool_]) -> bool:
    """Whether the rows (N,) of one table hold two streams with times of their own."""
    alone = (has_one & ~has_other, has_other & ~has_one)
    return bool(min(map(np.count_nonzero, alone)) > MIN_UNPAIRED * len(has_one))


def refuse_large_force(
    force_n: NDArray[np.floating], where: str, remedy: Message | None = None
) -> None:
    """Raise InputError for forces beyond any device."""
    largest_n = float(np.abs(force_n).max(initial=0.0))
    if not largest_n <= MAX_FORCE_N:
        raise InputError(
            "holds a force of {largest_n:.3g} N, beyond any device",
            where=where,
            remedy=remedy or Message("give the forces in newton"),
            largest_n=largest_n,
        )


def refuse_far_times(time_s: NDArray[np.floating], name: str) -> None:
    """Raise InputError for times that no clip has."""
    farthest_s = float(np.abs(time_s).max(initial=0.0))
    if not farthest_s <= MAX_SECONDS:
        raise InputError(
            "{name} reaches {farthest_s:.3g} s, beyond any clip",
            remedy=Message("give times in seconds of media time"),
            name=name,
            farthest_s=farthest_s,
        )


# --- sizes of recordings: far above what recorders write ----------------------------

MAX_NESTING = 8
"""Depth of GPMF; cameras nest two deep (DEVC, STRM)."""

MAX_RAW_GPMF_BYTES = 1024**3
"""A raw telemetry dump; 48 h of a GoPro are about 0.8 GB."""

MAX_PAYLOADS = 1_000_000
"""GPMF payloads of one recording; a camera writes one a second."""

MAX_CSV_BYTES = 2 * 1024**3
"""A log as text; 10 h at 100 Hz with 10 columns are about 0.4 GB."""

MAX_CSV_ROWS = 50_000_000
"""Rows of a text log: 14 h at 1 kHz."""

MAX_LINE_BYTES = 4096
"""One line of a text log."""

MAX_DAMAGED_SHARE = 0.05
"""A log with a larger share of damaged lines is rejected."""

MAX_MEMBERS = 2000
"""Files of one recording in a folder or a zip; apps write about twenty."""

MAX_FOLDER_DEPTH = 4
"""Levels of folders: mav0/imu0/data.csv is three deep."""

MAX_TEMPLATE_BYTES = 65_536
"""Answers about a log, as JSON."""

MAX_VIDEO_BYTES = 16 << 30
MAX_ANSWER_BYTES = 1 << 30
MEMORY_BYTES = 2 << 30
TIME_LIMIT_S = 60.0
"""Of telemetry-parser: its input, its output, its process."""


# --- what a media file may ask: far above what cameras write -------------------------

MAX_PIXELS = 8192 * 4320
"""Largest frame area, px: 8K video. An 8192 x 8192 bomb of 199 kB took 696 MB."""

MAX_SIDE_PX = 16_384
"""Longest side of a frame, px."""

MAX_STREAMS = 64
"""Streams in one container; cameras write up to seven."""

MAX_DURATION_S = 48 * 3600.0
"""Longest clip, s."""

MAX_AUDIO_RATE_HZ = 768_000
"""Fastest sound that is decoded, Hz."""

MAX_AUDIO_CHANNELS = 64
"""Most channels of sound that are mixed down."""

MAX_TELEMETRY_PACKETS = 1_000_000
"""Telemetry payloads of one file; GoPro writes one a second."""

MAX_TELEMETRY_PACKET_BYTES = 8 * 1024**2
"""Largest telemetry payload; the largest seen is 26 kB."""

MAX_TELEMETRY_BYTES = 1024**3
"""All telemetry of one file; 48 h of a GoPro are about 0.8 GB."""

MAX_INDEXED = 3_000_000
"""In all tables of an MP4: ten hours of 60 fps with sound; FFmpeg keeps 60 bytes of each."""

MAX_BOXES = 400_000
"""Of an MP4: ten hours in fragments of 1 s have 11 each."""

MAX_HEADER_BYTES = 48 * 1024**2
"""Read at opening: the tables of so many samples, and what is no frame."""

MAX_OPENING_BYTES = 180 * 1024**2
"""By which the process may grow at opening."""

MAX_BLOCK_BYTES = 128 * 1024**2
"""In one piece of memory that FFmpeg requests: a packet, a frame, a table."""

INDEX_TAIL = 4096
"""Last entries of each stream's index that are held against the file's size."""

MAX_DAMAGED_IN_A_ROW = 500
"""Damaged packets after one another after which a stream is given up."""

MAX_AHEAD_BYTES, MAX_AHEAD_PACKETS = 64 * 1024**2, 4096
"""Read ahead of a seek; one second of 4K from a camera is 12 MB."""
