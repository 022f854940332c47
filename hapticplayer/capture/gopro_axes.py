"""Turns the stored order of a GoPro's sensors into frame A.

GoPro's own camera axes, to which ORIN refers, are **X left, Y back, Z up** as seen
by the camera, although the stream names say "right/left, forward/back". Evidence:
a camera-to-IMU calibration of a HERO9 against a chequerboard (urbste's OpenICC,
published with cheng-chi/ORB_SLAM3) has the rows (-1,0,0), (0,0,-1), (0,-1,0) on
OpenCV's axes; GoPro's issue #100 says that Y points backwards; and in karma.mp4 a
positive rate about X moves the image up (`tests/unit/capture/test_gopro_axes.py`).
Frame A (x right, y front, z up) is therefore half a turn about Z away.

Source: github.com/gopro/gpmf-parser, issues #56, #100, #132, #165 (ORIN, ORIO, MTRX).
"""

import numpy as np

from hapticplayer.capture.gpmf import GpmfEntry, numbers_of, text_of
from hapticplayer.errors import TelemetryError
from hapticplayer.model.arrays import Floats

FRAME_A_FROM_CAMERA: Floats = np.diag([-1.0, -1.0, 1.0])
"""Camera axes (X left, Y back, Z up) to frame A (x right, y front, z up)."""

_AXES = "XYZ"
_WITHOUT_ORIN = (("fusion", "yXZ"), ("hero6", "YxZ"))
_HERO5 = "ZXY"


def frame_a_from_stored(stream: GpmfEntry, camera: str) -> Floats:
    """Return the rotation (3, 3) from stored components to frame A.

    Args:
        stream: the STRM entry with ACCL or GYRO.
        camera: device name, used if the stream does not declare its axes.

    Raises:
        TelemetryError: when the axes are not a proper rotation.
    """
    orin, matrix = stream.find("ORIN"), stream.find("MTRX")
    if orin is None and matrix is not None:
        stored_order = _camera_from(text_of(stream.find("ORIO")) or _HERO5)
        rotation = stored_order @ _matrix(matrix)
    else:
        rotation = _camera_from(text_of(orin) or _default_order(camera))
    if not np.isclose(np.linalg.det(rotation), 1.0, atol=1e-3):
        raise TelemetryError(
            "its axes ({axes}) mirror the camera, so the telemetry is damaged",
            axes=text_of(orin) or "MTRX",
        )
    return np.asarray(FRAME_A_FROM_CAMERA @ rotation)


def is_order_known(stream: GpmfEntry, camera: str) -> bool:
    name = camera.lower()
    known = (*(hint for hint, _ in _WITHOUT_ORIN), "hero5", "camera")
    return has_own_axes(stream) or any(hint in name for hint in known)


def has_own_axes(stream: GpmfEntry) -> bool:
    return stream.find("ORIN") is not None


def _default_order(camera: str) -> str:
    name = camera.lower()
    return next((order for hint, order in _WITHOUT_ORIN if hint in name), _HERO5)


def _camera_from(order: str) -> Floats:
    """Return the matrix from components stored as e.g. "YxZ" to X, Y, Z.

    Lower case means that the stored component is negated.
    """
    if sorted(order.upper()) != list(_AXES):
        raise TelemetryError(
            "{order!r} are not axes, so the telemetry is damaged", order=order
        )
    matrix = np.zeros((3, 3))
    for column, letter in enumerate(order):
        matrix[_AXES.index(letter.upper()), column] = 1.0 if letter.isupper() else -1.0
    return matrix


def _matrix(entry: GpmfEntry) -> Floats:
    values = numbers_of(entry).ravel()
    if values.size != 9 or not np.isfinite(values).all():
        raise TelemetryError("its axes (MTRX) are not a matrix, so it is damaged")
    return values.reshape(3, 3)
