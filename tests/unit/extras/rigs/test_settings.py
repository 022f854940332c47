"""What a person may write after `rig:`."""

import pytest

from hapticplayer.devices import find_device
from hapticplayer.errors import DeviceError
from hapticplayer.extras.rigs.settings import LOOPBACK


def rig_settings(text):
    return find_device(f"rig:{text}").settings


def test_empty_settings_are_outsim_to_this_machine():
    settings = rig_settings("")
    assert (settings.format.name, settings.address) == ("outsim", "127.0.0.1:4123")
    assert (settings.rate_hz, settings.id, settings.gain) == (200.0, 0, 1.0)


@pytest.mark.parametrize(
    ("name", "port"), [("outsim", 4123), ("codemasters", 20777), ("beamng", 4444)]
)
def test_each_format_has_its_port_and_stays_here(name, port):
    settings = rig_settings(name)
    assert (settings.format.name, settings.address) == (name, f"{LOOPBACK}:{port}")


def test_everything_can_be_said():
    settings = rig_settings(
        "outsim,192.168.1.7:30500,rate=500,id=7,gain=0.5,latency_ms=40,invert=sway+yaw"
    )
    assert settings.address == "192.168.1.7:30500"
    assert (settings.rate_hz, settings.id, settings.gain) == (500.0, 7, 0.5)
    assert settings.latency_s == pytest.approx(0.040)
    assert settings.invert == {"sway", "yaw"}


def test_an_address_of_version_6_is_in_brackets():
    settings = rig_settings("outsim,[::1]:4123")
    assert settings.address == "[::1]:4123"


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("insim", "outsim, codemasters, beamng"),
        ("outsim,4123", "outsim, codemasters, beamng"),
        ("outsim,4123:", "port must be"),
        ("outsim,here:", "port must be a whole number"),
        ("outsim,here:70000", "between 1 and 65535"),
        ("outsim,rate=501", "between 50 and 500 Hz"),
        ("outsim,rate=nan", "between 50 and 500 Hz"),
        ("outsim,gain=-1", "between 0 and 4"),
        ("outsim,invert=up", "surge, sway, heave, roll, pitch, yaw"),
        ("outsim,speed=3", "rate, id, latency_ms, invert, gain"),
        ("outsim,rate=90,rate=80", "say it once"),
    ],
)
def test_forbidden_settings_are_refused_with_the_allowed_ones(text, why):
    with pytest.raises(DeviceError, match=why):
        rig_settings(text)
