"""The simulated rig: what it reads of each format, and how it judges a sender."""

import contextlib
import socket

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.clock import SystemClock
from hapticplayer.errors import InputError
from hapticplayer.extras.rigs.decode import decode
from hapticplayer.extras.rigs.packets import FORMATS, in_world
from hapticplayer.extras.rigs.receiver import PacketReceiver, SimulatedRig
from hapticplayer.extras.rigs.settings import RigSettings
from hapticplayer.model.rig import NEUTRAL, RigMotion

small = st.floats(-1.25, 1.25, width=32)
vector = st.floats(-20.0, 20.0, width=32)
motions = st.builds(RigMotion, *[vector] * 3, *[small] * 3, *[vector] * 9)


def packet(name, motion, time_s=2.0, **chosen):
    return FORMATS[name].encode(motion, time_s, RigSettings(FORMATS[name], **chosen))


@given(motions, st.sampled_from(sorted(FORMATS)))
def test_each_format_is_read_as_it_was_meant(motion, name):
    heard = decode(packet(name, motion))
    assert heard.format == name
    angles = (heard.pitch_rad, heard.roll_rad, heard.heading_rad)
    assert angles == pytest.approx(motion[3:6], abs=2e-3)
    velocity = in_world(motion, motion[12:15])
    assert heard.velocity_mps == pytest.approx(velocity, abs=1e-4)
    acceleration = motion[0:3]
    if name == "outsim":
        acceleration = in_world(motion, acceleration)
    if name == "codemasters":
        acceleration = (*acceleration[:2], 0.0)
    assert heard.acceleration_mps2 == pytest.approx(acceleration, abs=1e-3)


@pytest.mark.parametrize("name", FORMATS)
def test_neutral_is_told_from_motion(name):
    assert decode(packet(name, NEUTRAL)).is_neutral
    assert not decode(packet(name, NEUTRAL._replace(pitch_rad=0.01))).is_neutral
    assert not decode(packet(name, NEUTRAL._replace(front_mps2=0.1))).is_neutral


@given(st.binary(max_size=300))
def test_anything_else_is_not_a_packet(data):
    assert decode(data) is None or len(data) in (64, 68, 88, 264)


def sent(rig, moves, start_s=0.0):
    """Send a motion or NEUTRAL every 10 ms, each with its time."""
    for number, (time_s, motion) in enumerate(moves):
        rig.hear(start_s + 0.01 * number, packet("outsim", motion, time_s))


def test_a_rig_reports_how_it_was_left():
    rig, moved = SimulatedRig(), NEUTRAL._replace(up_mps2=3.0)
    sent(rig, [(0.01 * k, moved if k < 100 else NEUTRAL) for k in range(301)])
    report = rig.report(3.1)
    assert report["packets"] == 301
    assert report["rate_hz"] == 100.0
    assert report["peak_mps2"] == 3.0
    assert (report["is_neutral"], report["neutral_s"]) == (True, 2.0)
    assert not report["is_silent"]
    assert rig.report(4.0)["is_silent"]


def test_time_may_go_back_from_neutral_only():
    rig, moved = SimulatedRig(), NEUTRAL._replace(up_mps2=3.0)
    sent(rig, [(1.0, moved), (1.01, NEUTRAL), (0.0, NEUTRAL), (0.5, moved)])
    assert rig.report(0.0)["time_went_back"] == 0
    sent(rig, [(0.4, moved)])
    assert rig.report(0.0)["time_went_back"] == 1


def test_ears_know_when_a_packet_came():
    clock = SystemClock()
    with contextlib.closing(PacketReceiver(clock, [0, 0])) as receiver:
        first, second = receiver.rigs
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as end:
            before_s = clock.now_s()
            end.sendto(packet("beamng", NEUTRAL), ("127.0.0.1", second))
            end.sendto(b"hello", ("127.0.0.1", first))
            after_s = clock.now_s()
        heard = list(receiver.listen(5.0))
        heard += list(receiver.listen(0.0))
        assert [port for port, *_ in heard] == [second]
        # the kernel's clock and ours are two readings, taken one after the other
        assert before_s - 1e-3 <= heard[0][1] <= after_s + 1e-3
        assert receiver.report()[first]["unknown"] == 1


def test_a_port_that_is_taken_is_named():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as end:
        end.bind(("127.0.0.1", 0))
        port = end.getsockname()[1]
        with pytest.raises(InputError, match=f"port {port} cannot be opened"):
            PacketReceiver(SystemClock(), [0, port])
