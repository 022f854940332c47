"""What a recording may ask of this program, in one place.

Each limit lies far above what sensors record; a file beyond it is damaged or made
to do harm, and is refused before memory is spent on it.
"""

MAX_NESTING = 8
"""Depth of GPMF; cameras nest two deep (DEVC, STRM)."""

MAX_RAW_GPMF_BYTES = 1024**3
"""A raw telemetry dump; 48 h of a GoPro are about 0.8 GB."""

MAX_PAYLOADS = 1_000_000
"""GPMF payloads of one recording; a camera writes one a second."""

MAX_SAMPLES = 100_000_000
"""Rows of one sensor: 34 h of a 800 Hz sensor."""

MAX_CSV_BYTES = 2 * 1024**3
"""A log as text; 10 h at 100 Hz with 10 columns are about 0.4 GB."""

MAX_CSV_ROWS = 50_000_000
"""Rows of a text log: 14 h at 1 kHz."""

MAX_LINE_BYTES = 4096
"""One line of a text log."""

MAX_ACCELERATION_MPS2 = 500.0
"""No hand-held sensor measures 50 g; GoPro's range is 16 g."""

MAX_ANGULAR_RATE_RADPS = 100.0
"""5700 deg/s; sensors end at 2000 or 4000 deg/s."""

MIN_RATE_HZ = 5.0
"""Slower than this is no motion log; mostly it is time in milliseconds."""

MAX_FORCE_N = 1000.0
"""No haptic device of this kind pushes harder; the Falcon ends at 9 N."""

MAX_MEMBERS = 2000
"""Files of one recording in a folder or a zip; apps write about twenty."""

MAX_FOLDER_DEPTH = 4
"""Levels of folders that are looked into: mav0/imu0/data.csv is three deep."""
