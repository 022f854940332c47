"""State and covariance of the quaternion Kalman filter, one sample at a time."""

import math

import numpy as np

from hapticplayer.model.arrays import Floats
from hapticplayer.motion.ekf.parameters import EkfParameters
from hapticplayer.motion.ekf.start import Field

Quaternion = tuple[float, float, float, float]

# Share of the field across the vertical below which it shows no heading.
MIN_HORIZONTAL_SHARE = 0.05


class QuaternionFilter:
    """Quaternion, accelerometer bias and, given a field, magnetometer bias.

    The paper's 4 x 4 covariance of the quaternion has rank 3 once q is normalised:
    P_qq = L P_tt L' / 4, with L the last three columns of q's right-multiplication
    matrix and t the rotation error about the earth's axes. P_tt is what is kept: it
    stays regular, needs no projection after a normalisation, and its transition is
    the identity. Without a magnetometer nothing depends on the error about the
    vertical, which would grow without bound; t then has two components.

    Attributes:
        q: orientation, sensor to earth.
        bias: (3,) accelerometer in m/s^2, or (6,) with the magnetometer in uT.
        P: covariance of t (2 or 3) and the biases (3 or 6); symmetric always.
    """

    def __init__(
        self, q: Quaternion, p: EkfParameters, interval_s: float, field: Field | None
    ) -> None:
        self._tilts = 2 if field is None else 3
        biases = [(p.accelerometer_bias_sigma_mps2, p.accelerometer_bias_time_s)]
        if field is not None:
            biases.append((p.magnetometer_bias_sigma_ut, p.magnetometer_bias_time_s))
        sigma = np.repeat([s for s, _ in biases], 3)
        keep = np.repeat([math.exp(-interval_s / tau) for _, tau in biases], 3)
        tilt = [p.start_inclination_sigma_rad] * self._tilts
        # sigma^2 (T/2)^2 Xi Xi' of the paper is this in the coordinates of t
        turn = np.full(self._tilts, p.gyro_noise_radps_rthz**2 * interval_s)
        kept = np.concatenate([np.ones(self._tilts), keep])

        self.q = q
        self.bias = np.zeros(len(sigma))
        self.P = np.diag(np.square(np.concatenate([tilt, sigma])))
        self._p = p
        self._force_variance = p.accelerometer_noise_mps2_rthz**2 / interval_s
        self._field_variance = p.magnetometer_noise_ut_rthz**2 / interval_s
        self._keep = keep
        self._transition = np.outer(kept, kept)
        lost = np.square(sigma) * (1.0 - np.square(keep))
        self._noise = np.diag(np.concatenate([turn, lost]))
        self._H_force = np.zeros((3, len(kept)))
        self._H_force[:, self._tilts : self._tilts + 3] = np.eye(3)
        self._H_field = np.zeros((3, len(kept)))
        self._H_field[:, -3:] = np.eye(3)
        if field is not None:
            self._dip_rad = field.dip_rad
            self._north_ut = field.magnitude_ut * math.cos(field.dip_rad)
            self._up_ut = -field.magnitude_ut * math.sin(field.dip_rad)

    def predict(self, turn: Quaternion) -> None:
        """Rotate by one sample's rotation; let the biases forget."""
        self.q = _product(self.q, turn)
        self.bias *= self._keep
        self.P *= self._transition
        self.P += self._noise

    def use_specific_force(self, force_mps2: Floats) -> None:
        """Take a specific force (3,) for gravity, a = g R' z + b."""
        g = self._p.gravity_mps2
        east, north, up = self._earth_axes()
        H = self._H_force
        H[:, 0] = g * north
        H[:, 1] = -g * east
        residual = force_mps2 - g * up - self.bias[:3]
        self._update(H, residual, self._force_variance)

    def use_field(self, field_ut: Floats) -> bool:
        """Take a field (3,) for the earth's, m = R' h + b, if its dip is right.

        Returns:
            False when the gate refused it.
        """
        east, north, up = self._earth_axes()
        norm = math.sqrt(field_ut.dot(field_ut))
        dip_rad = math.asin(max(-1.0, min(1.0, -float(field_ut.dot(up)) / norm)))
        if abs(dip_rad - self._dip_rad) > self._p.dip_gate_rad:
            return False
        H = self._H_field
        H[:, 0] = self._up_ut * north - self._north_ut * up
        H[:, 1] = -self._up_ut * east
        H[:, 2] = self._north_ut * east
        expected = self._north_ut * north + self._up_ut * up
        residual = field_ut - expected - self.bias[3:]
        self._update(H, residual, self._field_variance)
        return True

    def align_heading(self, field_ut: Floats) -> Quaternion | None:
        """Turn about the vertical until the field (3,) points north.

        Returns:
            The rotation, for what was estimated before; None when the field is too
            near to the vertical to show a heading, and nothing was done.
        """
        east, north, _ = self._earth_axes()
        x, y = float(field_ut.dot(east)), float(field_ut.dot(north))
        if math.hypot(x, y) < MIN_HORIZONTAL_SHARE * math.sqrt(field_ut.dot(field_ut)):
            return None
        half = 0.5 * math.atan2(x, y)
        turn = (math.cos(half), 0.0, 0.0, math.sin(half))
        self.q = _product(turn, self.q)
        self.P[2, :] = 0.0
        self.P[:, 2] = 0.0
        self.P[2, 2] = self._p.start_heading_sigma_rad**2
        return turn

    def _update(self, H: Floats, residual: Floats, variance: float) -> None:
        """Use three components, one after the other, at one point of linearisation.

        P loses w w', which is symmetric to the last bit. The textbook's P - K H P is
        not: it drifts out of symmetry (Bierman 1977).
        """
        P = self.P
        dx = np.zeros(len(P))
        for h, r in zip(H, residual.tolist(), strict=True):
            Ph = P.dot(h)
            scale = 1.0 / math.sqrt(h.dot(Ph) + variance)
            w = Ph * scale
            dx += w * ((r - h.dot(dx)) * scale)
            P -= w[:, None] * w
        self.bias += dx[self._tilts :]
        # the paper's additive update: q + dq, normalised
        half = [*(0.5 * dx[: self._tilts]).tolist(), 0.0]
        a, b, c, d = _product((1.0, half[0], half[1], half[2]), self.q)
        n = 1.0 / math.sqrt(a * a + b * b + c * c + d * d)
        self.q = (a * n, b * n, c * n, d * n)

    def _earth_axes(self) -> Floats:
        """Return east, north and up in the sensor frame, the rows of R(q)."""
        w, x, y, z = self.q
        return np.array(
            (
                (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
                (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
                (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
            )
        )


def _product(left: Quaternion, right: Quaternion) -> Quaternion:
    """Return the Hamilton product of two quaternions; numpy is slower for one."""
    w, x, y, z = left
    a, b, c, d = right
    return (
        w * a - x * b - y * c - z * d,
        w * b + x * a + y * d - z * c,
        w * c - x * d + y * a + z * b,
        w * d + x * c - y * b + z * a,
    )
