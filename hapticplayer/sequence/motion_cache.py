"""Results of gravity removal, kept by content: the same input is not computed twice.

An entry's name is the SHA-256 over everything that the result depends on: the samples,
the method, its parameters, and the program with what it computes with. Whatever is
wrong with the cache (full, read-only, damaged), the result is computed instead.
"""

import contextlib
import dataclasses
import functools
import hashlib
import json
import math
import os
import tempfile
from collections.abc import Mapping
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np

import hapticplayer
from hapticplayer.errors import InputError
from hapticplayer.model import ImuLog, MotionTrack
from hapticplayer.sequence import files

SWITCH = "HAPTICPLAYER_CACHE"
"""Environment variable; `off` keeps and uses nothing."""

LIMIT_BYTES = 512 << 20
"""Of all entries; about 7 h of motion at 200 Hz."""

_LAYOUT = 1
_ABANDONED_NS = 3600 * 10**9  # a part that is so old belongs to a process that died
_ENDING, _PART = ".npz", ".part"
_ROOMS = ("model", "motion")
_PACKAGES = ("numpy", "scipy", "vqf")


def user_cache(*, wanted: bool = True) -> "MotionCache | None":
    """Return the cache in the user's home, or None where it is switched off."""
    if not wanted or os.environ.get(SWITCH, "").strip().lower() == "off":
        return None
    try:
        return MotionCache(files.cache_home() / "motion")
    except RuntimeError:  # nobody's home is known
        return None


def plain(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return a summary as JSON holds it; what is no finite number becomes None."""
    return {str(name): _plain(held) for name, held in values.items()}


class MotionCache:
    """A folder of results; the oldest go when it grows beyond its limit."""

    def __init__(self, folder: Path, limit_bytes: int = LIMIT_BYTES) -> None:
        self._folder = folder
        self._limit_bytes = limit_bytes

    def key(self, imu: ImuLog, method: str, parameters: Any = None) -> str:
        """Return the name of a result.

        Args:
            imu: the log that gravity is removed from.
            method: its name.
            parameters: a dataclass of the method's, or None for its defaults.
        """
        digest = hashlib.sha256()
        digest.update(repr((_LAYOUT, _program(), method)).encode())
        digest.update(_described(parameters).encode())
        digest.update(imu.sampling.value.encode())
        for name in (f.name for f in dataclasses.fields(imu)):
            values = getattr(imu, name)
            if isinstance(values, np.ndarray):
                digest.update(f"{name} {values.dtype.str} {values.shape}".encode())
                digest.update(np.ascontiguousarray(values).data)
        return digest.hexdigest()

    def load(self, key: str, imu: ImuLog) -> tuple[MotionTrack, dict[str, Any]] | None:
        """Return a result as it was stored, or None where there is none to rely on."""
        path = self._path(key)
        if not path.is_file():
            return None
        try:
            track, summary = _unpacked(files.read_arrays(path), key)
        except (InputError, KeyError, TypeError, ValueError):  # damaged: compute anew
            self._drop(path)
            return None
        if not np.array_equal(track.time_s, imu.time_s):
            return None
        with contextlib.suppress(OSError):
            os.utime(path)  # used just now, so that others go first
        return track, summary

    def store(self, key: str, track: MotionTrack, summary: Mapping[str, Any]) -> bool:
        """Keep a result and return whether that was possible."""
        arrays = {f.name: getattr(track, f.name) for f in dataclasses.fields(track)}
        arrays = {name: held for name, held in arrays.items() if held is not None}
        if sum(np.asarray(held).nbytes for held in arrays.values()) > self._limit_bytes:
            return False
        try:
            self._folder.mkdir(parents=True, exist_ok=True)
            self._write(self._path(key), key=key, summary=json.dumps(summary), **arrays)
            self._prune()
        except OSError:
            return False
        return True

    def _path(self, key: str) -> Path:
        return self._folder / f"{key}{_ENDING}"

    def _write(self, path: Path, **arrays: Any) -> None:
        handle, name = tempfile.mkstemp(suffix=_PART, dir=self._folder)
        part = Path(name)
        try:
            with open(handle, "wb") as writer:  # noqa: PTH123 - an open descriptor
                np.savez(writer, allow_pickle=False, **arrays)
            part.replace(path)
        finally:
            part.unlink(missing_ok=True)

    def _prune(self) -> None:
        """Remove what was not used for longest, and parts that nobody writes."""
        held = []
        for path in self._folder.iterdir():
            with contextlib.suppress(FileNotFoundError):
                status = path.stat()
                held.append((status.st_mtime_ns, status.st_size, path))
        held.sort(key=lambda entry: entry[0], reverse=True)
        total_bytes = 0
        for used_ns, size_bytes, path in held:
            if path.suffix == _PART and held[0][0] - used_ns > _ABANDONED_NS:
                self._drop(path)
            elif path.suffix == _ENDING:
                total_bytes += size_bytes
                if total_bytes > self._limit_bytes:
                    self._drop(path)

    @staticmethod
    def _drop(path: Path) -> None:
        with contextlib.suppress(OSError):
            path.unlink(missing_ok=True)


def _unpacked(arrays: dict[str, Any], key: str) -> tuple[MotionTrack, dict[str, Any]]:
    if str(arrays.pop("key")) != key:
        raise ValueError("of another result")
    summary = json.loads(str(arrays.pop("summary")))
    if not isinstance(summary, dict):
        raise TypeError("no summary")
    arrays.setdefault("gravity_sigma_mps2", None)
    gain = float(arrays.pop("accelerometer_gain"))
    return MotionTrack(accelerometer_gain=gain, **arrays), summary


@functools.cache
def _program() -> str:
    """Return what computes: versions, and the code itself, which changes more often."""
    digest = hashlib.sha256(hapticplayer.__version__.encode())
    root = Path(hapticplayer.__file__).parent
    for path in sorted(p for room in _ROOMS for p in (root / room).rglob("*.py")):
        digest.update(path.relative_to(root).as_posix().encode())
        digest.update(path.read_bytes())
    for name in _PACKAGES:
        with contextlib.suppress(metadata.PackageNotFoundError):
            digest.update(f"{name} {metadata.version(name)}".encode())
    return digest.hexdigest()


def _described(parameters: Any) -> str:
    """Return parameters as text; repr gives every bit of a float."""
    if parameters is None:
        return "defaults"
    return f"{type(parameters).__name__} {sorted(dataclasses.asdict(parameters).items())!r}"


def _plain(value: Any) -> Any:
    if isinstance(value, Mapping):
        return plain(value)
    if isinstance(value, list | tuple | np.ndarray):
        return [_plain(held) for held in value]
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value if isinstance(value, bool | int | float | None) else str(value)
