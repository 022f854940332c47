"""Limits of sizes of recordings; those of plausible numbers are in `model.limits`.

They are far above what recorders write: a larger file is damaged or malicious, and is
rejected before memory is used.
"""

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
