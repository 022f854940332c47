"""The three packets against golden bytes, and OutSim against a decoder of others."""

import math
import struct
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.extras.rigs.packets import FORMATS, in_world
from hapticplayer.extras.rigs.settings import RigSettings
from hapticplayer.model.rig import NEUTRAL, RigMotion

LEVEL = RigMotion(
    *(1.0, -2.0, 0.5),
    *(0.0, 0.0, 0.0),
    *(0.25, -0.125, 4.0),
    *(8.0, 16.0, -32.0),
    *(3.0, 0.0, 4.0),
)
finite = st.floats(-50.0, 50.0, width=32)
motions = st.builds(RigMotion, *[finite] * 15)


def packet(name, motion=LEVEL, time_s=1.5, **settings):
    return FORMATS[name].encode(motion, time_s, RigSettings(FORMATS[name], **settings))


def test_outsim_is_these_64_bytes():
    golden = "dc0500000000803e000000be00008040000000000000000000000000"
    golden += "0000803f000000c00000003f000040400000000000008040"
    golden += 12 * "00"
    assert packet("outsim").hex() == golden
    assert len(packet("outsim")) == 64


def test_outsim_with_an_id_has_68_bytes():
    data = packet("outsim", id=-2)
    assert data[:64] == packet("outsim")
    assert data[64:].hex() == "feffffff"


def test_beamng_is_these_88_bytes():
    golden = b"BNG1".hex() + 12 * "00" + "000040400000000000008040"
    golden += "0000803f000000c00000003f00000000000000000000803f" + 12 * "00"
    golden += "000000be0000803e000080400000804100000041000000c2"
    assert packet("beamng").hex() == golden
    assert len(packet("beamng")) == 88


def test_codemasters_is_these_264_bytes():
    g = 9.80665
    golden = {0: 1.5, 1: 1.5, 7: 5.0, 8: 3.0, 9: 4.0, 11: 1.0, 16: 1.0}
    golden |= {34: 1.0 / g, 35: -2.0 / g}
    data = packet("codemasters")
    assert len(data) == 264
    values = np.frombuffer(data, "<f4")
    expected = np.zeros(66, "<f4")
    expected[list(golden)] = list(golden.values())
    assert values.tobytes() == expected.tobytes()
    swapped = np.frombuffer(packet("codemasters", forward_first=True), "<f4")
    assert swapped[11:14].tolist() == values[14:17].tolist()
    assert swapped[14:17].tolist() == values[11:14].tolist()


def test_neutral_has_no_motion_but_a_time():
    assert packet("outsim", NEUTRAL, 0.0) == bytes(64)
    beamng = struct.unpack("<4s21f", packet("beamng", NEUTRAL))
    assert [i for i, value in enumerate(beamng) if value] == [0, 12]  # mark, up
    codemasters = np.frombuffer(packet("codemasters", NEUTRAL), "<f4")
    assert np.flatnonzero(codemasters).tolist() == [0, 1, 11, 16]


@given(motions, st.floats(0.0, 4e6), st.integers(-(2**31), 2**31 - 1))
def test_outsim_is_read_alike_by_lfs_insim(motion, time_s, identity):
    oracle = pytest.importorskip("lfs_insim.packets")
    read = oracle.OutSimPack.unpack(packet("outsim", motion, time_s, id=identity))
    assert read.Time == int(1e3 * time_s)
    assert (read.ID or 0) == identity
    attitude = (read.Pitch, read.Roll, read.Heading)
    assert attitude == motion[3:6]
    for vector, own in (
        (read.AngVel, motion[6:9]),
        (read.Accel, motion[0:3]),
        (read.Vel, motion[12:15]),
    ):
        found = (vector.X, vector.Y, vector.Z)
        assert found == pytest.approx(turned(attitude, own), abs=1e-4)


@given(motions)
def test_the_two_others_agree_with_outsim(motion):
    outsim = np.frombuffer(packet("outsim", motion)[4:52], "<f4")
    beamng = np.frombuffer(packet("beamng", motion)[4:], "<f4")
    codemasters = np.frombuffer(packet("codemasters", motion), "<f4")
    np.testing.assert_allclose(beamng[3:6], outsim[9:12], atol=1e-4)
    np.testing.assert_allclose(codemasters[8:11], outsim[[9, 11, 10]], atol=1e-4)
    np.testing.assert_allclose(beamng[6:9], motion[0:3], rtol=1e-6)
    np.testing.assert_allclose(9.80665 * codemasters[34:36], motion[0:2], atol=1e-4)
    # forward and right are at right angles, and up is across both
    right, forward = codemasters[[11, 13, 12]], codemasters[[14, 16, 15]]
    np.testing.assert_allclose(np.cross(right, forward), beamng[9:12], atol=1e-5)


def turned(attitude_rad, vector):
    """Return a vector in the world, by matrices."""
    pitch, roll, heading = attitude_rad
    c, s = math.cos(pitch), math.sin(pitch)
    about_x = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    c, s = math.cos(roll), math.sin(roll)
    about_y = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    c, s = math.cos(heading), math.sin(heading)
    about_z = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    return about_z @ about_x @ about_y @ vector


def test_angles_turn_the_way_that_lfs_says():
    nose_up = replace_motion(pitch_rad=0.1)
    assert in_world(nose_up, (0.0, 1.0, 0.0))[2] > 0.0
    right_down = replace_motion(roll_rad=0.1)
    assert in_world(right_down, (1.0, 0.0, 0.0))[2] < 0.0
    to_the_left = replace_motion(heading_rad=0.1)
    assert in_world(to_the_left, (0.0, 1.0, 0.0))[0] < 0.0


def replace_motion(**values):
    return NEUTRAL._replace(**values)


def test_the_time_of_outsim_starts_again_after_49_days():
    late_s = 2**32 / 1e3 + 0.25
    assert packet("outsim", time_s=late_s)[:4] == struct.pack("<I", 250)


def test_signs_and_gain_are_factors_of_one_axis_each():
    settings = replace(RigSettings(), gain=0.5, invert=frozenset({"sway", "yaw"}))
    factors = dict(zip(RigMotion._fields, settings.factors(), strict=True))
    turned_names = {name for name, factor in factors.items() if factor < 0.0}
    expected = {"right_mps2", "right_mps", "heading_rad", "yaw_radps", "yaw_radps2"}
    assert turned_names == expected
    assert {abs(factor) for factor in factors.values()} == {0.5}
