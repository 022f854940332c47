"""Each option of each device is applied, or refused by its name."""

import re

import pytest

from hapticplayer.devices import find_device, installed_devices
from hapticplayer.errors import DeviceError
from tests.needed_extras import needs

VALUES = {
    "axis": "z",
    "band": "30-90",
    "channel": "V3",
    "channels": "3+4",
    "full": "7",
    "gain": "0.5",
    "id": "7",
    "invert": "sway+yaw",
    "latency_ms": "77",
    "rate": "123",
    "sign": "-",
}


def options_of(name):
    """The options of a device, as its refusal of an unknown one lists them."""
    with pytest.raises(DeviceError) as refusal:
        find_device(f"{name}:none-such=1")
    listed = re.search(r"'none-such' is unknown; use ([a-z_, ]+)", str(refusal.value))
    return listed[1].split(", ") if listed else []


@pytest.mark.parametrize(
    "name", [n for n, one in installed_devices().items() if one.options]
)
def test_each_option_changes_what_a_device_does(name):
    plain = find_device(name).settings
    for option in options_of(name):
        chosen = find_device(f"{name}:{option}={VALUES[option]}").settings
        assert chosen != plain, option
        with pytest.raises(DeviceError, match="once"):
            find_device(f"{name}:{option}={VALUES[option]},{option}={VALUES[option]}")


@pytest.mark.parametrize(
    "name", [n for n, one in installed_devices().items() if one.options]
)
@pytest.mark.parametrize(
    "odd", ["none-such=1", "gain=5", "gain=1,gain=2", "=", "a=b=c"]
)
def test_an_odd_option_is_refused_and_names_the_known(name, odd):
    with pytest.raises(DeviceError) as refusal:
        find_device(f"{name}:{odd}")
    assert "gain" in str(refusal.value)
    assert re.search("use |must be|once|see ", str(refusal.value))


@needs("inverse3", "toys")
@pytest.mark.parametrize("name", ["inverse3", "buttplug", "tcode"])
@pytest.mark.parametrize(
    "part", ["rate=3", "here", "h:1,latency_ms=3", "h:0", "a:1,b:2"]
)
def test_a_wrong_address_of_a_service_is_named(name, part):
    with pytest.raises(DeviceError, match=r"option '(rate|here|latency|h:0|b:2).*': "):
        find_device(f"{name}:{part}")


@needs("rigs")
def test_options_of_a_rig_change_its_packets_or_are_refused():
    from hapticplayer.extras.rigs.packets import FORMATS
    from hapticplayer.extras.rigs.settings import AXES, rig_settings
    from hapticplayer.model.rig import RigMotion

    motion = RigMotion(*(0.1 + 0.01 * k for k in range(len(RigMotion._fields))))

    def packet(settings):
        signed = RigMotion(
            *(a * b for a, b in zip(motion, settings.signs(), strict=True))
        )
        return settings.format.encode(signed, 1.0, settings)

    for name in FORMATS:
        plain = packet(rig_settings(name))
        for axis in AXES:
            assert packet(rig_settings(f"{name},invert={axis}")) != plain
        if name == "outsim":
            assert packet(rig_settings(f"{name},id=7")) != plain
        else:
            with pytest.raises(
                DeviceError, match=r"id=7 has no effect: .*; leave it out"
            ):
                rig_settings(f"{name},id=7")
