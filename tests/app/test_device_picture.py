"""Pictures of what a device is sent, chosen by its capability record."""

import math
from dataclasses import replace

import hearing
import numpy as np
import pytest

from app.plots.device_picture import (
    ENLARGED,
    BarsPicture,
    DevicePicture,
    GripPicture,
    RigPicture,
    WheelPicture,
    picture_of,
)
from hapticplayer.devices import installed_devices
from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.shared import TICK
from hapticplayer.model.device import ChannelLevel
from tests.needed_extras import needs

RECORDS = {name: one.capabilities for name, one in installed_devices().items()}


def ticks(count=3, **fields):
    made = np.zeros(count, TICK)
    made["mode"] = Mode.FOLLOWING
    made["monotonic_s"] = 0.001 * np.arange(count)
    for name, value in fields.items():
        made[name] = value
    return made


def pixels(picture):
    picture.resize(300, 220)
    image = picture.grab().toImage()
    return bytes(image.constBits())


@needs("inverse3", "rigs", "wheels", "shakers", "toys")
def test_the_picture_follows_from_the_record(application, qtbot):
    kinds = {
        "falcon": GripPicture,
        "inverse3": GripPicture,
        "simulated": GripPicture,
        "rig": RigPicture,
        "wheel": WheelPicture,
        **dict.fromkeys(("shaker", "rumble", "buttplug", "tcode"), BarsPicture),
    }
    for name, kind in kinds.items():
        picture = picture_of(RECORDS[name])
        qtbot.addWidget(picture)
        assert type(picture) is kind, name
        assert picture.accessibleName()
    seat = picture_of(replace(RECORDS["falcon"], axes=2))
    qtbot.addWidget(seat)
    assert type(seat) is GripPicture


@pytest.mark.parametrize(
    "name",
    [
        "falcon",
        pytest.param("rig", marks=needs("rigs")),
        pytest.param("wheel", marks=needs("wheels")),
        pytest.param("rumble", marks=needs("wheels")),
    ],
)
def test_a_device_picture_moves_with_its_force_and_comes_to_rest(
    application, qtbot, name
):
    picture = DevicePicture()
    qtbot.addWidget(picture)
    picture.set_record(RECORDS[name])
    at_rest = pixels(picture)
    picture.show_sent(ticks(force_n=(1.0, 0.2, 0.1), planned_n=(1.0, 0.5, 0.2)), ())
    assert pixels(picture) != at_rest
    picture.set_record(RECORDS[name])
    assert pixels(picture) == at_rest


@needs("wheels")
def test_a_wheel_turns_by_its_own_axis_to_the_side_of_the_force(application, qtbot):
    wheel = picture_of(replace(RECORDS["wheel"], first_axis=1))
    qtbot.addWidget(wheel)
    full_n = RECORDS["wheel"].peak_force_n
    wheel.show_sent(ticks(force_n=(full_n, -0.5 * full_n, 0.0)), ())
    assert wheel.share == pytest.approx(-0.5)
    assert hearing.value(wheel) == "\u221250\u00a0%"
    wheel.show_sent(ticks(force_n=(0.0, 9.0 * full_n, 0.0)), ())
    assert wheel.share == 1.0
    wheel.show_sent(ticks(force_n=(0.0, np.nan, 0.0)), ())
    assert wheel.share == 0.0


@needs("shakers")
def test_bars_show_the_strength_or_the_level_of_each_channel(application, qtbot):
    bars = picture_of(RECORDS["shaker"])
    qtbot.addWidget(bars)
    full_n = RECORDS["shaker"].peak_force_n
    bars.show_sent(ticks(force_n=(0.3 * full_n, 0.4 * full_n, 0.0)), ())
    assert [bar.share for bar in bars.bars] == [pytest.approx(0.5)]
    assert hearing.value(bars) == "50\u00a0%"
    levels = (ChannelLevel(3, 1.0, True), ChannelLevel(4, 10 ** (-24 / 20), False))
    bars.show_sent(ticks(), levels)
    assert [(bar.label, bar.is_limited) for bar in bars.bars] == [
        ("3", True),
        ("4", False),
    ]
    assert [bar.share for bar in bars.bars] == [pytest.approx(1.0), pytest.approx(0.5)]
    assert hearing.value(bars) == "3 100\u00a0%, 4 50\u00a0%"


@needs("rigs")
def test_a_platform_does_what_the_packet_says(application, qtbot):
    rig = picture_of(RECORDS["rig"])
    qtbot.addWidget(rig)
    # columns of a RigMotion: right, front, up (m/s^2), pitch, roll, heading (rad)
    rig.show_sent(ticks(planned_n=(0.0, 0.0, 0.5), force_n=(0.02, -0.01, 0.0)), ())
    assert rig.pose.up_m == pytest.approx(ENLARGED * 0.01)
    angles = rig.pose.pitch_rad, rig.pose.roll_rad
    assert angles == pytest.approx((ENLARGED * 0.02, ENLARGED * -0.01))
    assert not rig.is_clamped
    roll, pitch = (round(math.degrees(angle)) for angle in angles[::-1])
    assert f"up {1000 * rig.pose.up_m:.0f} mm" in hearing.value(rig)
    assert f"roll \u2212{-roll}, pitch {pitch}" in hearing.value(rig)
    rig.show_sent(ticks(planned_n=(0.0, 0.0, 5.0)), ())
    assert rig.is_clamped
    assert "at the end of its reach" in hearing.value(rig)
