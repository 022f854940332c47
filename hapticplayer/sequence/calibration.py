"""A sensor's calibration in a file: written from one recording, read for another."""

import dataclasses
from pathlib import Path
from typing import Any

from hapticplayer.capture.mounting import axes_matrix
from hapticplayer.errors import InputError, Message
from hapticplayer.model.calibration import (
    UNKNOWN_BIAS_SIGMA_MPS2,
    UNKNOWN_BIAS_SIGMA_RADPS,
    UNKNOWN_SCALE_SIGMA,
    SensorCalibration,
)
from hapticplayer.model.ranges import Range
from hapticplayer.outputs import FILE, IsOurs, refuse_existing
from hapticplayer.sequence import files
from hapticplayer.untrusted import parse_json, read_regular

SCHEMA, VERSION = "hapticplayer.calibration", 1
MAX_BYTES = 1 << 16
MAX_TEXT = 300
_LEAST_SIGMA = 1e-9
_RANGES = {
    "gyro_bias_radps": Range(-1.0, 1.0, "rad/s"),
    "gyro_bias_sigma_radps": Range(_LEAST_SIGMA, UNKNOWN_BIAS_SIGMA_RADPS, "rad/s"),
    "accelerometer_bias_mps2": Range(-5.0, 5.0, "m/s^2"),
    "accelerometer_bias_sigma_mps2": Range(
        _LEAST_SIGMA, UNKNOWN_BIAS_SIGMA_MPS2, "m/s^2"
    ),
    "accelerometer_scale": Range(0.5, 2.0),
    "accelerometer_scale_sigma": Range(_LEAST_SIGMA, UNKNOWN_SCALE_SIGMA),
}
_REMEDY = Message("write one with `hapticplayer process LOG --save-calibration FILE`")


@dataclasses.dataclass(frozen=True, slots=True)
class StoredCalibration:
    """A calibration and where it comes from.

    Attributes:
        values: in the recorder's axes.
        sensor: camera or format of the recording it was found in.
        source: name of that recording.
        created_utc: when.
    """

    values: SensorCalibration
    sensor: str
    source: str
    created_utc: str

    def mounted(self, axes: str) -> "StoredCalibration":
        """Return it in frame A.

        Args:
            axes: of the mounting; "" for as it is.

        Raises:
            UsageError: when they are not axes, or mirrored.
        """
        if not axes:
            return self
        return dataclasses.replace(self, values=self.values.turned(axes_matrix(axes)))

    def dismounted(self, axes: str) -> "StoredCalibration":
        """Return it in the recorder's axes, from frame A; the inverse of `mounted`."""
        if not axes:
            return self
        rotation = axes_matrix(axes).T
        return dataclasses.replace(self, values=self.values.turned(rotation))

    def notes(self, sensor: str) -> tuple[str, ...]:
        """Return a note where it is of another kind of sensor than a recording."""
        if sensor == self.sensor:
            return ()
        return (
            Message(
                "the calibration is of {theirs}, the recording of {ours}; a calibration "
                "helps only if both are one sensor",
                theirs=self.sensor or "?",
                ours=sensor or "?",
            ),
        )


def write_calibration(
    path: Path, stored: StoredCalibration, *, overwrite: bool = False
) -> None:
    """Write a calibration as JSON.

    Raises:
        SequenceError: when the file exists and is not a calibration to be overwritten,
            or cannot be written.
    """
    content = {
        "schema": SCHEMA,
        "version": VERSION,
        "sensor": stored.sensor,
        "source": stored.source,
        "created_utc": stored.created_utc,
        **dataclasses.asdict(stored.values),
    }
    with files.file_written_aside(path, overwritten(overwrite)) as part:
        files.write_json(part, content)


def refuse_existing_calibration(path: Path, *, overwrite: bool = False) -> None:
    """Refuse a target that exists, before long work starts.

    Raises:
        InputError: when it does.
    """
    refuse_existing(path, FILE, overwritten(overwrite))


def overwritten(overwrite: bool) -> IsOurs | None:
    """Return what recognises a calibration that may be overwritten."""
    return _is_calibration if overwrite else None


def read_calibration(path: Path) -> StoredCalibration:
    """Return the calibration in a file.

    Raises:
        InputError: when it cannot be read or holds anything else.
    """
    text = read_regular(path, MAX_BYTES, InputError, _REMEDY)
    content = parse_json(text, str(path), InputError, _REMEDY)
    if not isinstance(content, dict) or content.get("schema") != SCHEMA:
        raise InputError(
            "is not a calibration of a sensor", where=str(path), remedy=_REMEDY
        )
    if content.get("version") != VERSION:
        raise InputError(
            "is of version {version!r} of the format; this program reads {known}",
            where=str(path),
            remedy=_REMEDY,
            version=content.get("version"),
            known=VERSION,
        )
    values: dict[str, Any] = {}
    for name, within in _RANGES.items():
        count = 1 if name.startswith("accelerometer_scale") else 3
        values[name] = _numbers(content.get(name), count, within, name, path)
    texts = [
        _text(content.get(name), name, path)
        for name in ("sensor", "source", "created_utc")
    ]
    return StoredCalibration(SensorCalibration(**values), *texts)


def _numbers(held: object, count: int, within: Range, name: str, path: Path) -> Any:
    given = held if isinstance(held, list) and count > 1 else [held]
    if len(given) == count and all(_is_number(value, within) for value in given):
        numbers = tuple(map(float, given))
        return numbers if count > 1 else numbers[0]
    one = Message("{name} must be a number between {least:g} and {largest:g}{unit}")
    three = Message(
        "{name} must be three numbers between {least:g} and {largest:g}{unit}"
    )
    raise InputError(
        (three if count > 1 else one).template,
        where=str(path),
        remedy=_REMEDY,
        name=name,
        least=within.least,
        largest=within.largest,
        unit=f" {within.unit}" if within.unit else "",
    )


def _is_number(value: object, within: Range) -> bool:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return is_number and within.least <= value <= within.largest  # type: ignore[operator]


def _text(held: object, name: str, path: Path) -> str:
    if not isinstance(held, str) or len(held) > MAX_TEXT:
        raise InputError(
            "{name} must be a text of at most {most} characters",
            where=str(path),
            remedy=_REMEDY,
            name=name,
            most=MAX_TEXT,
        )
    return held


def _is_calibration(head: bytes) -> bool:
    try:
        content = parse_json(head, "", InputError, "")
    except InputError:
        return False
    return isinstance(content, dict) and content.get("schema") == SCHEMA
