"""Builders that the conditioning tests share."""

import numpy as np
import pytest

from hapticplayer.model import STANDARD_GRAVITY_MPS2, ImuLog, MotionTrack
from hapticplayer.model import quaternions as quat


@pytest.fixture
def make_log():
    def build(time_s, force=None, rate=None, **more):
        zeros = np.zeros((len(time_s), 3))
        force = zeros if force is None else np.broadcast_to(force, zeros.shape)
        rate = zeros if rate is None else np.broadcast_to(rate, zeros.shape)
        return ImuLog(time_s, force, rate, **more)

    return build


@pytest.fixture
def make_track():
    def build(time_s, acceleration, valid=None, sigma=None):
        """A track that rolls by 0.4 rad/s, with an acceleration on all axes."""
        roll = np.outer(0.4 * time_s, [1.0, 0, 0])
        q = quat.from_rotation_vector(roll)
        ones = np.ones((len(time_s), 3))
        return MotionTrack(
            time_s=time_s,
            acceleration_mps2=np.asarray(acceleration)[:, None] * ones,
            gravity_mps2=STANDARD_GRAVITY_MPS2 * quat.vertical(q),
            accelerometer_gain=1.01,
            quaternion_wxyz=q,
            gravity_sigma_mps2=sigma,
            valid=np.ones(len(time_s), bool) if valid is None else valid,
        )

    return build
