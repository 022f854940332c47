"""A sensor's calibration in a file: written from one recording, read for another."""

import dataclasses
from pathlib import Path
from typing import Annotated, Any

from msgspec import Meta, Struct, structs

from hapticplayer import storage
from hapticplayer.capture.mounting import axes_matrix
from hapticplayer.errors import InputError, Message
from hapticplayer.model.calibration import (
    UNKNOWN_BIAS_SIGMA_MPS2,
    UNKNOWN_BIAS_SIGMA_RADPS,
    UNKNOWN_SCALE_SIGMA,
    SensorCalibration,
)
from hapticplayer.model.limits import (
    ACCEL_SCALES,
    MAX_ACCEL_BIAS_MPS2,
    MAX_GYRO_BIAS_RADPS,
)
from hapticplayer.storage import FILE, IsOurs, refuse_existing
from hapticplayer.structures import check_schema, convert, read_json
from hapticplayer.untrusted import parse_json

SCHEMA, VERSION = "hapticplayer.calibration", 1
MAX_BYTES = 1 << 16
_LEAST_SIGMA = 1e-9
_OTHER_RECORDING = Message("keep the calibration of another recording")
_REMEDY = Message(
    "write one from a long log (`hapticplayer process LOG --save-calibration FILE`)"
)

_Text = Annotated[str, Meta(max_length=300)]
_Radps = Annotated[float, Meta(ge=-MAX_GYRO_BIAS_RADPS, le=MAX_GYRO_BIAS_RADPS)]
_RadpsSigma = Annotated[float, Meta(ge=_LEAST_SIGMA, le=UNKNOWN_BIAS_SIGMA_RADPS)]
_Mps2 = Annotated[float, Meta(ge=-MAX_ACCEL_BIAS_MPS2, le=MAX_ACCEL_BIAS_MPS2)]
_Mps2Sigma = Annotated[float, Meta(ge=_LEAST_SIGMA, le=UNKNOWN_BIAS_SIGMA_MPS2)]


class _CalibrationFile(Struct):
    sensor: _Text
    source: _Text
    created_utc: _Text
    gyro_bias_radps: tuple[_Radps, _Radps, _Radps]
    gyro_bias_sigma_radps: tuple[_RadpsSigma, _RadpsSigma, _RadpsSigma]
    accelerometer_bias_mps2: tuple[_Mps2, _Mps2, _Mps2]
    accelerometer_bias_sigma_mps2: tuple[_Mps2Sigma, _Mps2Sigma, _Mps2Sigma]
    accelerometer_scale: Annotated[float, Meta(ge=ACCEL_SCALES[0], le=ACCEL_SCALES[1])]
    accelerometer_scale_sigma: Annotated[
        float, Meta(ge=_LEAST_SIGMA, le=UNKNOWN_SCALE_SIGMA)
    ]


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
        InputError: for errors that no sensor has, so that nothing could read them.
    """
    content = {
        "schema": SCHEMA,
        "version": VERSION,
        "sensor": stored.sensor,
        "source": stored.source,
        "created_utc": stored.created_utc,
        **dataclasses.asdict(stored.values),
    }
    convert(content, _CalibrationFile, stored.source, InputError, _OTHER_RECORDING)
    with storage.file_written_aside(path, overwritten(overwrite)) as part:
        storage.write_json(part, content)


def refuse_existing_calibration(path: Path, *, overwrite: bool = False) -> None:
    """Refuse a target that exists, before long work starts."""
    refuse_existing(path, FILE, overwritten(overwrite))


def overwritten(overwrite: bool) -> IsOurs | None:
    return _is_calibration if overwrite else None


def read_calibration(path: Path) -> StoredCalibration:
    """Return the calibration in a file."""
    content = read_json(path, dict[str, Any], InputError, _REMEDY, MAX_BYTES)
    other = Message("is not a calibration of a sensor"), _REMEDY
    check_schema(content, (SCHEMA, VERSION), str(path), other)
    held = structs.asdict(
        convert(content, _CalibrationFile, str(path), InputError, _REMEDY)
    )
    texts = {name: held.pop(name) for name in ("sensor", "source", "created_utc")}
    return StoredCalibration(SensorCalibration(**held), **texts)


def _is_calibration(head: bytes) -> bool:
    try:
        content = parse_json(head, "", InputError, "")
    except InputError:
        return False
    return isinstance(content, dict) and content.get("schema") == SCHEMA
