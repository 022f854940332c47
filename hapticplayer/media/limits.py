"""What a media file may ask of this program, in one place.

Each limit lies far above what cameras write; a file beyond it is damaged or made
to do harm, and is refused before memory is spent on it.
"""

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

MAX_REMOTE_SAMPLES = 20_000_000
"""In the index of a clip whose size a server states; FFmpeg keeps 480 MB for them."""

INDEX_TAIL = 4096
"""Last entries of each stream's index that are held against the file's size."""

MAX_DAMAGED_IN_A_ROW = 500
"""Damaged packets after one another after which a stream is given up."""

MAX_AHEAD_BYTES, MAX_AHEAD_PACKETS = 64 * 1024**2, 4096
"""Read ahead of a seek; one second of 4K from a camera is 12 MB."""
