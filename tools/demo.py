"""Make the demo that ships, resources/demo.mkv: `python -m tools.demo [FILE]`.

The scene `tour` of the simulator, imported and packed with its motion. The same encoder
gives the same bytes, another one the same ride. Takes a minute.
"""

import sys
import tempfile
from pathlib import Path

from hapticplayer.extras.rides.recording import simulate
from hapticplayer.extras.rides.recordings import DEMO_SEED
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.sequence.build import Choices, write_sequence
from hapticplayer.sequence.pack import pack
from hapticplayer.shipped import DEMO

SCENE, TITLE = "tour", "A ride by bicycle (simulated)"
RATE_FACTOR = 30.0
MOST_BYTES = 5_000_000


def make_demo(target: Path) -> None:
    """Draw, import and pack the ride; an older file is replaced."""
    recorded = simulate(SCENE, DEMO_SEED)
    film = recorded.film
    with tempfile.TemporaryDirectory(prefix="demo-") as name:
        clip, folder, packed = (
            Path(name) / n for n in ("demo.mp4", "demo", "demo.mkv")
        )
        write_clip(
            clip,
            film.frames(0, film.frame_count),
            frame_rate_hz=film.frame_rate_hz,
            audio=recorded.audio,
            audio_rate_hz=recorded.audio_rate_hz,
            rate_factor=RATE_FACTOR,
        )
        choices = Choices(title=TITLE, seed=DEMO_SEED)
        write_sequence(probe(clip), recorded.recording(), folder, choices=choices)
        pack(folder, packed, with_motion=True)
        content = packed.read_bytes()
    if len(content) > MOST_BYTES:
        raise SystemExit(
            f"the demo has {1e-6 * len(content):.1f} MB; raise RATE_FACTOR"
        )
    target.write_bytes(content)
    print(f"{target}: {1e-6 * len(content):.2f} MB")


if __name__ == "__main__":
    make_demo(Path(*sys.argv[1:2]) if sys.argv[1:] else DEMO)
