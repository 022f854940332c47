import itertools

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.signal import butter, sosfiltfilt

from hapticplayer.capture import read_recording
from hapticplayer.capture.gopro import read_gopro
from hapticplayer.capture.gopro_axes import FRAME_A_FROM_CAMERA, frame_a_from_stored
from hapticplayer.capture.gopro_streams import (
    collect,
    first_stamp_us,
    parse_packets,
    split_raw,
)
from hapticplayer.capture.gopro_timing import TimeReference, sample_times
from hapticplayer.capture.gpmf import GpmfEntry, parse
from hapticplayer.media.frames import FrameConverter
from hapticplayer.media.telemetry import read_telemetry_packets
from hapticplayer.media.video import VideoDecoder
from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats
from tests.unit.capture.conftest import floats, nested, recorded, sensor, text


def signed_permutations() -> list[NDArray[np.float64]]:
    return [
        np.eye(3)[list(order)] * np.array(signs)[:, None]
        for order in itertools.permutations(range(3))
        for signs in itertools.product((1.0, -1.0), repeat=3)
    ]


def hero9_rotation() -> tuple[ImuLog, Floats, Floats]:
    """A log, and times (M,) and directions (M, 3, unit, frame A) of GRAV.

    Its three values are the direction of the specific force along the camera's
    X, Z and Y (measured on MAX, HERO9 and HERO11).
    """
    path = recorded("gopro/hero9_rotation.gpmd")
    payloads, _ = parse_packets(split_raw(path.read_bytes()))
    stream = collect(payloads, "GRAV")
    assert stream is not None
    clock = TimeReference(first_stamp_us(payloads, ("SHUT",)), has_packet_times=False)
    unit = stream.values[:, [0, 2, 1]]
    unit /= np.linalg.norm(unit, axis=1, keepdims=True)
    time_s = sample_times(stream, clock).time_s
    return read_recording(path).imu, time_s, unit @ FRAME_A_FROM_CAMERA.T


def test_gravity_of_the_camera_agrees_with_these_axes_only():
    """GRAV of a HERO9 in strong rotation, against the low-passed accelerometer.

    0.65 m/s2 RMS with a zero-phase low-pass of 0.5 Hz (the reference found 0.648);
    the next best of all 48 signed permutations is off by 1.07.
    """
    imu, time_s, direction = hero9_rotation()
    low_pass = butter(2, 0.5, fs=imu.rate_hz, output="sos")
    slow = sosfiltfilt(low_pass, imu.specific_force_mps2, axis=0)
    slow /= np.linalg.norm(slow, axis=1, keepdims=True)
    at_gravity = np.stack(
        [np.interp(time_s, imu.time_s, axis) for axis in slow.T],
        axis=1,
    )
    errors = {
        index: 9.80665
        * np.sqrt(np.mean(np.sum((at_gravity - direction @ m.T) ** 2, axis=1)))
        for index, m in enumerate(signed_permutations())
    }
    ours = next(
        index
        for index, m in enumerate(signed_permutations())
        if np.array_equal(m, np.eye(3))
    )
    best, second = sorted(errors.values())[:2]
    assert errors[ours] == best
    assert best < 0.75
    assert second > 1.0


def test_gyro_rotates_the_gravity_of_the_camera():
    """d/dt of GRAV = -rate x GRAV: only the right axes of the gyro predict it."""
    imu, time_s, direction = hero9_rotation()
    angle = np.cumsum(imu.angular_rate_radps[1:] * np.diff(imu.time_s)[:, None], axis=0)
    at_gravity = np.stack(
        [np.interp(time_s, imu.time_s[1:], axis) for axis in angle.T], axis=1
    )
    steps_s = np.diff(time_s)[:, None]
    rate = np.diff(at_gravity, axis=0) / steps_s
    slope = np.diff(direction, axis=0) / steps_s
    middle = 0.5 * (direction[1:] + direction[:-1])
    errors = [
        np.sqrt(np.mean(np.sum((slope + np.cross(rate @ m.T, middle)) ** 2, axis=1)))
        for m in signed_permutations()
        if np.linalg.det(m) > 0.0
    ]
    identity = [
        i
        for i, m in enumerate(m for m in signed_permutations() if np.linalg.det(m) > 0)
        if np.array_equal(m, np.eye(3))
    ]
    assert int(np.argmin(errors)) == identity[0]
    assert min(errors) < 0.13  # rad/s; GRAV moves with 0.51 RMS
    assert sorted(errors)[1] > 0.3


def shift_px(before: NDArray[np.complex128], after: NDArray[np.complex128],
             shape: tuple[int, int]) -> tuple[float, float]:  # fmt: skip
    """Return how far the content moved to the right and down (phase correlation)."""
    cross = np.conj(before) * after
    fy = np.fft.fftfreq(shape[0])[:, None]
    fx = np.fft.rfftfreq(shape[1])[None, :]
    soft = np.exp(-(fy**2 + fx**2) / (2 * 0.15**2))
    surface = np.fft.fftshift(
        np.fft.irfft2(cross / (np.abs(cross) + 1e-9) * soft, s=shape)
    )
    y, x = np.unravel_index(surface.argmax(), shape)

    def vertex(left: float, middle: float, right: float) -> float:
        return 0.5 * (left - right) / (left + right - 2.0 * middle)

    dx = x - shape[1] // 2 + vertex(*surface[y, x - 1 : x + 2])
    dy = y - shape[0] // 2 + vertex(*surface[y - 1 : y + 2, x])
    return float(dx), float(dy)


def test_image_moves_with_the_gyro():
    """Frame A is x right, y front, z up, and not its half turn x left, y back.

    Turning left (rate about z > 0) moves the picture to the right; lifting the nose
    (rate about x > 0) moves it down. Both together exclude the half turn about z,
    which the gravity tests above cannot see. On karma.mp4 the gimbal leaves little
    pitch, so its coefficient is only known to be positive: 10 standard errors.
    """
    path = recorded("gopro/karma.mp4")
    imu = read_gopro(read_telemetry_packets(path)).imu
    window = np.outer(np.hanning(90), np.hanning(160))
    spectra, times_s = [], []
    with VideoDecoder(path) as decoder:
        for frame in decoder.frames():
            grey = (
                FrameConverter().convert(frame, 160, 90).as_rgb()[:, :, 1].astype(float)
            )
            spectra.append(np.fft.rfft2((grey - grey.mean()) * window))
            times_s.append(frame.pts_s)
    moved = np.array(
        [shift_px(a, b, (90, 160)) for a, b in itertools.pairwise(spectra)]
    )
    steps_s = np.diff(imu.time_s, prepend=imu.time_s[0] - 1.0 / imu.rate_hz)
    angle = np.cumsum(imu.angular_rate_radps * steps_s[:, None], axis=0)
    lag_s = 0.02  # this camera does not timestamp; 10 to 30 ms are known
    at_frames = [
        np.interp(np.array(times_s) - lag_s, imu.time_s, axis) for axis in angle.T
    ]
    turned = np.diff(np.stack(at_frames, axis=1), axis=0)
    design = np.column_stack([turned, np.ones(len(turned))])
    for axis, column, share in ((2, 0, 0.95), (0, 1, 0.2)):
        weights, rest, *_ = np.linalg.lstsq(design, moved[:, column], rcond=None)
        variance = rest[0] / (len(design) - 4) * np.linalg.inv(design.T @ design)
        explained = 1.0 - rest[0] / np.sum(
            (moved[:, column] - moved[:, column].mean()) ** 2
        )
        assert weights[axis] > 5.0 * np.sqrt(variance[axis, axis])
        assert explained > share


def stream(*entries: bytes) -> GpmfEntry:
    return parse(nested("STRM", *entries)).children[0]


# what each camera stores when its own X, Y, Z axes measure 1, 2, 3
STORED = {
    ("ZXY", "HERO9 Black"): (3.0, 1.0, 2.0),
    ("YxZ", "Hero7 Black"): (2.0, -1.0, 3.0),
    ("zxY", "HERO8 Black"): (-3.0, -1.0, 2.0),
    ("XzY", "GoPro Max"): (1.0, -3.0, 2.0),
    ("", "Hero6 Black"): (2.0, -1.0, 3.0),
    ("", "Fusion"): (-2.0, 1.0, 3.0),
    ("", "Hero5 Black"): (3.0, 1.0, 2.0),
    ("", "Camera"): (3.0, 1.0, 2.0),
}


@pytest.mark.parametrize(("orin", "camera"), STORED)
def test_each_camera_ends_in_frame_a(orin, camera):
    """Camera X is left and Y is back, so (1, 2, 3) is (-1, -2, 3) in frame A."""
    entry = stream(text("ORIN", orin)) if orin else stream(text("STNM", "ACCL"))
    rotation = frame_a_from_stored(entry, camera)
    np.testing.assert_array_equal(
        rotation @ np.array(STORED[orin, camera]), [-1.0, -2.0, 3.0]
    )


@pytest.mark.parametrize(
    ("orin", "matrix"),
    [
        ("YxZ", [[0, 0, 1], [0, -1, 0], [1, 0, 0]]),
        ("zxY", [[-1, 0, 0], [0, -1, 0], [0, 0, 1]]),
        ("XzY", [[0, -1, 0], [1, 0, 0], [0, 0, 1]]),
    ],
)
def test_matrix_and_letters_agree(orin, matrix):
    by_letters = frame_a_from_stored(stream(text("ORIN", orin)), "")
    by_matrix = frame_a_from_stored(
        stream(floats("MTRX", [np.ravel(matrix)]), text("ORIO", "ZXY")), ""
    )
    np.testing.assert_array_equal(by_letters, by_matrix)


def test_unknown_camera_without_axes_is_noted():
    from hapticplayer.media.telemetry import TelemetryPacket
    from tests.unit.capture.conftest import device

    rng = np.random.default_rng(1)

    def payload():
        values = rng.normal(5.7, 0.01, (2, 200, 3))
        pairs = zip(("ACCL", "GYRO"), values, strict=True)
        return device("Mystery", *(sensor(key, rows, orin="") for key, rows in pairs))

    packets = [TelemetryPacket(float(k), 1.0, payload()) for k in range(4)]
    assert any("those of a HERO5" in note for note in read_gopro(packets).notes)
