"""The three packets against golden bytes and signs, and OutSim by a decoder of others."""

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
    golden += "0000803f000000c00000003f00000000000000000000803f"
    golden += 8 * "00" + "00000080"
    golden += "000000be0000803e000080c00000804100000041" + "00000042"
    assert packet("beamng").hex() == golden
    assert len(packet("beamng")) == 88


def test_codemasters_is_these_264_bytes():
    g = 9.80665
    golden = {0: 1.5, 1: 1.5, 7: 5.0, 8: -3.0, 9: 4.0, 11: -1.0, 16: 1.0}
    golden |= {34: -1.0 / g, 35: -2.0 / g}
    data = packet("codemasters")
    assert len(data) == 264
    values = np.frombuffer(data, "<f4")
    expected = np.zeros(66, "<f4")
    expected[list(golden)] = list(golden.values())
    assert values.tolist() == expected.tolist()


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
    unmirrored = codemasters[[8, 10, 9]] * (-1, 1, 1)
    np.testing.assert_allclose(unmirrored, outsim[9:12], atol=1e-4)
    np.testing.assert_allclose(beamng[6:9], motion[0:3], rtol=1e-6)
    left_front = 9.80665 * codemasters[34:36] * (-1, 1)
    np.testing.assert_allclose(left_front, motion[0:2], atol=1e-4)
    # forward and right are at right angles, and up is across both
    right, forward = codemasters[[11, 13, 12]], codemasters[[14, 16, 15]]
    right, forward = right * (-1, 1, 1), forward * (-1, 1, 1)
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


# What a game says of a moment of a drive, by the names of its own format and from its own
# documentation; everything else is 0.
CURVE = {"right_mps2": -5.0, "yaw_radps": 0.5, "front_mps": 10.0}  # to the left
DRIVES = {
    "left curve": CURVE,
    "right curve": {**CURVE, "right_mps2": 5.0, "yaw_radps": -0.5},
    "braking": {"front_mps2": -6.0, "pitch_rad": -0.1, "front_mps": 10.0},
    "bump": {"up_mps2": 8.0, "up_mps": 0.4, "front_mps": 10.0},
}
DOWN, FLAT = math.sin(0.1), math.cos(0.1)
"""Of a nose that dips by 0.1 rad."""
SAID = {
    "outsim": {
        "left curve": {"AngVel z": 0.5, "Accel x": -5.0, "Vel y": 10.0},
        "right curve": {"AngVel z": -0.5, "Accel x": 5.0, "Vel y": 10.0},
        # in the world: the front of the car points down
        "braking": {"Pitch": -0.1, "Accel y": -6.0 * FLAT, "Accel z": 6.0 * DOWN}
        | {"Vel y": 10.0 * FLAT, "Vel z": -10.0 * DOWN},
        "bump": {"Accel z": 8.0, "Vel y": 10.0, "Vel z": 0.4},
    },
    "beamng": {
        "left curve": {"velY": 10.0, "accX": -5.0, "upZ": 1.0, "yawRate": -0.5},
        "right curve": {"velY": 10.0, "accX": 5.0, "upZ": 1.0, "yawRate": 0.5},
        "braking": {"velY": 10.0 * FLAT, "velZ": -10.0 * DOWN, "accY": -6.0}
        | {"upY": DOWN, "upZ": FLAT, "pitchPos": -0.1},
        "bump": {"velY": 10.0, "velZ": 0.4, "accZ": 8.0, "upZ": 1.0},
    },
    "codemasters": {
        "left curve": {"speed": 10.0, "vz": 10.0, "rx": -1.0, "fz": 1.0}
        | {"g_lat": 5.0 / 9.80665},
        "right curve": {"speed": 10.0, "vz": 10.0, "rx": -1.0, "fz": 1.0}
        | {"g_lat": -5.0 / 9.80665},
        "braking": {"speed": 10.0, "vy": -10.0 * DOWN, "vz": 10.0 * FLAT, "rx": -1.0}
        | {"fy": -DOWN, "fz": FLAT, "g_lon": -6.0 / 9.80665},
        "bump": {"speed": math.hypot(10.0, 0.4), "vy": 0.4, "vz": 10.0, "rx": -1.0}
        | {"fz": 1.0},
    },
}
FIELDS = {
    "outsim": ["AngVel x", "AngVel y", "AngVel z", "Heading", "Pitch", "Roll"]
    + [f"{name} {axis}" for name in ("Accel", "Vel") for axis in "xyz"],
    "beamng": [
        f"{name}{axis}" for name in ("pos", "vel", "acc", "up") for axis in "XYZ"
    ]
    + [
        f"{axis}{n}"
        for n in ("Pos", "Rate", "Acc")
        for axis in ("roll", "pitch", "yaw")
    ],
    "codemasters": [
        *"abcd",
        *("x", "y", "z", "speed", "vx", "vy", "vz", "rx", "ry", "rz", "fx", "fy", "fz"),
        *map(str, range(17, 34)),
        *("g_lat", "g_lon"),
    ],
}
FIRST = {"outsim": 4, "beamng": 4, "codemasters": 0}


@pytest.mark.parametrize("drive", DRIVES)
@pytest.mark.parametrize("name", SAID)
def test_a_drive_is_told_as_the_game_tells_it(name, drive):
    motion = NEUTRAL._replace(**DRIVES[drive])
    said = np.frombuffer(packet(name, motion, 0.0)[FIRST[name] :], "<f4")
    found = dict(zip(FIELDS[name], said.tolist(), strict=False))
    expected = dict.fromkeys(FIELDS[name], 0.0) | SAID[name][drive]
    assert found == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize("kind", FORMATS.values(), ids=lambda kind: kind.name)
def test_each_number_is_positive_as_its_row_says(kind):
    for sign in kind.signs:
        for share in (0.1, -0.1):
            motion = RigMotion(*(share * value for value in sign.motion))
            (found,) = struct.unpack_from(
                "<f", packet(kind.name, motion, 0.0), sign.offset
            )
            assert found * share > 0.0, sign.field
        assert sign.source


def test_the_time_of_outsim_starts_again_after_49_days():
    late_s = 2**32 / 1e3 + 0.25
    assert packet("outsim", time_s=late_s)[:4] == struct.pack("<I", 250)


def test_signs_are_of_one_axis_each():
    settings = replace(RigSettings(), invert=frozenset({"sway", "yaw"}))
    signs = dict(zip(RigMotion._fields, settings.signs(), strict=True))
    turned_names = {name for name, sign in signs.items() if sign < 0.0}
    expected = {"right_mps2", "right_mps", "heading_rad", "yaw_radps", "yaw_radps2"}
    assert turned_names == expected
    assert {abs(sign) for sign in signs.values()} == {1.0}
