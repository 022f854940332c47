"""Limits of sizes and of plausible numbers in recordings.

Sizes are far above what recorders write: a larger file is damaged or malicious, and is
rejected before memory is used. Plausible numbers are those of a sensor in a hand or on a
vehicle; others are in another unit or damaged.
"""

# --- sizes ---------------------------------------------------------------------

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

# --- specific force ------------------------------------------------------------

MAX_ACCELERATION_MPS2 = 500.0
"""No hand-held sensor measures 50 g; GoPro's range is 16 g."""

REST_MPS2 = (8.5, 11.0)
"""Norm where the gyro shows rest, so that only cheap accelerometers widen it, by up to
10 %; `PLAUSIBLE_NORM_MPS2` of motion is of moving hands too."""

COARSE_REST_MPS2 = (7.0, 13.0)
"""Median norm that separates an accelerometer's file from a gyroscope's."""

REST_G = (0.6, 1.5)
"""Median norm of the first rows of a log in g."""

UPRIGHT = 0.7
"""Cosine of 45 degrees: an axis farther from up is not z."""

MIN_MEAN_SHARE = 0.5
"""Mean vector over mean norm; below it the sensor rotated too much to show an axis."""

# --- angular rate, time and the rest ---------------------------------------------

MAX_ANGULAR_RATE_RADPS = 100.0
"""5700 deg/s; sensors saturate at 2000 or 4000 deg/s."""

MAX_SI_RATE_RADPS = 40.0
"""2300 deg/s: no hand rotates faster, so a larger number is in another unit."""

MAX_USUAL_RATE_RADPS = 35.0
"""Sensors saturate at 2000 deg/s; no hand rotates faster for long."""

MAX_REACH_S = 1.0
"""Longest extrapolation of a slow sensor (compass, gravity)."""

FIRST_FRAME_S = -60.0
"""A video that begins earlier than this before its log does not belong to it."""
