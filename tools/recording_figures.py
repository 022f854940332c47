"""Draws the pictures of docs/recording.md, from simulated recordings.

python -m tools.recording_figures
"""

import sys
from pathlib import Path

from hapticplayer.capture import synchronize
from hapticplayer.capture.sync.result import ClipSound
from hapticplayer.cli.plots import draw_sync
from tests.material.sync_clips import simulate_pats

DOCS = Path(__file__).parents[1] / "docs"
PICTURES = {
    "recording-good.png": (False, 200, 100_003, "still, 200 Hz: the pats stand out"),
    "recording-30hz.png": (False, 30, 100_003, "the same pats, averaged to 30 Hz"),
    "recording-hard.png": (True, 30, 100_009, "pats while walking in wind, 30 Hz"),
}


def main() -> int:
    """Draw all of them in place of the old ones."""
    for name, (hard, rate_hz, seed, title) in PICTURES.items():
        clip = simulate_pats(seed, hard=hard, rate_hz=rate_hz)
        found = synchronize(clip.imu, clip.audio, clip.audio_rate_hz)
        confidence = f"confidence {found.clock_map.confidence:.2f}"
        path = DOCS / name
        path.unlink(missing_ok=True)
        sound = ClipSound(clip.audio, clip.audio_rate_hz)
        draw_sync(path, sound, clip.imu, found, f"{title}; {confidence}")
        print(path.name, confidence)
    return 0


if __name__ == "__main__":
    sys.exit(main())
