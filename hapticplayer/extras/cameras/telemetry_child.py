"""Reads one video with `telemetry-parser`, in a process of its own.

    python -m hapticplayer.extras.cameras.telemetry_child VIDEO OUT.npz MEMORY_BYTES CPU_S

The library is native code that has panicked on damaged files, so it runs isolated, with
limits. Writes time_s, specific_force_mps2 and angular_rate_degps, NaN where a sample has
none, and prints camera and model as JSON. Exit status 3 and a sentence on stderr if it
fails.
"""

import importlib
import json
import resource
import sys
from pathlib import Path
from typing import Any

import numpy as np

COLUMNS = ("time_s", "specific_force_mps2", "angular_rate_degps")
REFUSED = 3
_MISSING = (np.nan, np.nan, np.nan)


def main(arguments: list[str]) -> int:
    """Read the video and return the exit status."""
    video, target, memory_bytes, cpu_s = arguments
    resource.setrlimit(resource.RLIMIT_AS, (int(memory_bytes), int(memory_bytes)))
    resource.setrlimit(resource.RLIMIT_CPU, (int(cpu_s), int(cpu_s)))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    try:
        parsed = importlib.import_module("telemetry_parser").Parser(video)
        samples = parsed.normalized_imu()
        _write(samples, Path(target))
        about = {"camera": str(parsed.camera), "model": str(parsed.model or "")}
    except BaseException as error:  # noqa: BLE001 - its panics are not Exceptions
        sys.stderr.write(f"{type(error).__name__}: {error}\n")
        return REFUSED
    sys.stdout.write(json.dumps(about))
    return 0


def _write(samples: list[dict[str, Any]], target: Path) -> None:
    parts = [
        np.array([sample["timestamp_ms"] for sample in samples], float) / 1000.0,
        np.array([sample.get("accl") or _MISSING for sample in samples], float),
        np.array([sample.get("gyro") or _MISSING for sample in samples], float),
    ]
    with target.open("xb") as writer:
        np.savez(writer, allow_pickle=False, **dict(zip(COLUMNS, parts, strict=True)))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
