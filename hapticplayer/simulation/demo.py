"""The built-in demo: a simulated ride with known truth, as a sequence."""

import shutil
from pathlib import Path

from hapticplayer import __version__
from hapticplayer.errors import Message, SequenceError
from hapticplayer.media.clip_info import probe
from hapticplayer.sequence import files
from hapticplayer.sequence.build import Choices, write_sequence
from hapticplayer.sequence.store import open_sequence
from hapticplayer.simulation.rides.recording import simulate, write_simulated_clip

DEMO_SEED = 2012


def write_simulated_sequence(
    scenario: str,
    target: Path,
    *,
    seed: int = DEMO_SEED,
    progress: files.Progress = files.no_progress,
) -> Path:
    """Simulate a recording and import it; its truth is kept as truth.npz.

    Raises:
        UsageError: for a scenario that does not exist.
        SequenceError: when the target exists or cannot be written.
    """
    recorded = simulate(scenario, seed)
    with files.scratch_beside(target) as scratch:
        path = scratch / f"{scenario}.mp4"
        write_simulated_clip(
            recorded, path, lambda f: progress(0.8 * f, Message("drawing the ride"))
        )
        return write_sequence(
            probe(path),
            recorded.recording(),
            target,
            choices=Choices(title=f"Simulated ride: {scenario}", seed=seed),
            extras={"truth": recorded.truth.arrays()},
            progress=lambda f, step: progress(0.8 + 0.2 * f, step),
        )


def demo_folder(progress: files.Progress = files.no_progress) -> Path:
    """Return the folder of the demo, made on first use in the user's cache."""
    target = files.cache_root() / f"demo-{__version__}"
    try:
        open_sequence(target)
    except SequenceError:
        if target.exists():  # of an interrupted disk or an older layout
            shutil.rmtree(target)
        try:
            write_simulated_sequence("demo", target, progress=progress)
        except SequenceError:
            open_sequence(target)  # another process made it meanwhile
    return target
