"""Writes simulated rides: as a camera and a logger would have, or imported already."""

from dataclasses import asdict
from pathlib import Path
from typing import Any

from hapticplayer import storage
from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.errors import Message, Progress, entry_named, no_progress
from hapticplayer.extras.rides.board import EARTH_FIELD_UT, PAPER
from hapticplayer.extras.rides.catalogue import RIDES
from hapticplayer.extras.rides.recording import (
    SimulatedRecording,
    simulate,
    write_gopro_clip,
    write_simulated_clip,
)
from hapticplayer.media.clip_info import probe
from hapticplayer.sequence.arrays import write_arrays
from hapticplayer.sequence.build import Choices, write_sequence

CLIP, LOG, TRUTH, ABOUT, GOPRO = (
    "clip.mp4",
    "imu.csv",
    "truth.npz",
    "recording.json",
    "gopro.mp4",
)
READ_AS = "sampling=averaged"
"""What the log does not say of itself: its samples are means over windows."""

_SCHEMA = 1


def write_simulated_recording(
    scenario: str,
    target: Path,
    *,
    seed: int,
    with_gopro: bool = False,
    progress: Progress = no_progress,
) -> Path:
    """Simulate a ride and write what a camera and a board would have, and the truth.

    The same seed gives the same files, bit for bit; `with_gopro` adds the clip with a
    telemetry track, as a GoPro writes it.
    """
    entry_named(RIDES, scenario, Message("ride"))
    with storage.folder_written_aside(target) as aside:
        progress(0.0, Message("riding"))
        recorded = simulate(scenario, seed)
        assert recorded.board is not None
        clip = aside / CLIP
        write_simulated_clip(
            recorded,
            clip,
            lambda f: progress(0.02 + 0.93 * f, Message("drawing the ride")),
        )
        if with_gopro:
            progress(0.95, Message("adding telemetry"))
            write_gopro_clip(recorded, clip, aside / GOPRO)
        progress(0.97, Message("writing the logs"))
        write_imu_csv(aside / LOG, recorded.board.imu)
        write_arrays(aside / TRUTH, **recorded.truth.arrays())
        storage.write_json(aside / ABOUT, describe(recorded))
    return target


def describe(recorded: SimulatedRecording) -> dict[str, Any]:
    """Return the parameters of a ride and what is true of it, for `recording.json`."""
    scene, board = recorded.scene, recorded.board
    assert board is not None
    return {
        "schema": _SCHEMA,
        "scenario": scene.name,
        "title": scene.title,
        "seed": recorded.seed,
        "duration_s": scene.duration_s,
        "clock": {
            "media_s": "rate * imu_s + offset_s",
            "rate": board.clock_map.rate,
            "offset_s": board.clock_map.offset_s,
        },
        "pats": [asdict(pat) for pat in scene.pats],
        "stalls_s": board.stalls_s.tolist(),
        "log": {"file": LOG, "read_as": READ_AS, "rate_hz": board.imu.rate_hz},
        "board": _plain(asdict(PAPER)),
        "earth_field_ut": {"east_north_up": EARTH_FIELD_UT},
    }


def _plain(value: Any) -> Any:
    """Return a value with None for what JSON has no number for."""
    if isinstance(value, dict):
        return {key: _plain(one) for key, one in value.items()}
    return None if value == float("inf") else value


DEMO_SEED = 2012


def write_simulated_sequence(
    scenario: str,
    target: Path,
    *,
    seed: int = DEMO_SEED,
    progress: Progress = no_progress,
) -> Path:
    """Simulate a recording and import it; its truth is kept as truth.npz."""
    storage.refuse_existing(target, storage.FOLDER)
    recorded = simulate(scenario, seed)
    with storage.scratch_beside(target) as scratch:
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
