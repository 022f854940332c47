"""What a device needs: permission, a service at its port, a receiver, a sound card."""

import os
import socket
from pathlib import Path

import pytest

from hapticplayer.devices import find_device, guides, installed_devices
from hapticplayer.devices.checks import Check, receiver, service, until_unmet, usable
from hapticplayer.devices.falcon import guide
from hapticplayer.devices.falcon.transport import FalconAddress, FalconForbiddenError
from hapticplayer.devices.guides import checks_of, guide_of, hold_text
from hapticplayer.errors import Message
from tests.needed_extras import needs

REMEDY = Message("do it")


def states(name):
    """Return what a device needs, by its thing."""
    return {str(check.what): check.is_met for check in checks_of(find_device(name))}


def port_of(end):
    return f"127.0.0.1:{end.getsockname()[1]}"


@needs("faults")
def test_every_device_has_a_guide_of_its_own():
    real = [one for one in installed_devices().values() if not one.is_for_developers]
    for entry in real:
        page = guide_of(entry)
        assert entry.guide, entry.name
        assert len(page.what) > 20, entry.name
        assert hold_text(page, entry.capabilities).endswith("."), entry.name
    assert guide_of(find_device("falcon-simulated")).what.startswith("the Falcon's own")


@needs("toys")
def test_a_service_is_reached_at_its_port_or_is_not():
    with socket.create_server(("127.0.0.1", 0)) as server:
        where = port_of(server)
        assert service("It", where).is_met
        assert states(f"buttplug:{where}") == {f"Intiface at {where}": True}
    assert service("It", where) == (f"It at {where}", False, "Start It.")
    assert "not HOST:PORT" in service("It", "here").remedy


@needs("rigs")
@needs("toys")
def test_a_receiver_is_seen_without_sending_to_it():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as end:
        end.bind(("127.0.0.1", 0))
        end.setblocking(False)
        where = port_of(end)
        assert states(f"rig:outsim,{where}") == {
            f"Program that listens at {where}": True
        }
        assert states(f"tcode:{where}")[f"Program that listens at {where}"]
        with pytest.raises(BlockingIOError):
            end.recv(1)
    assert receiver(where, REMEDY).is_met is False
    assert receiver("192.0.2.1:4123", REMEDY).is_met is None  # another computer
    assert "not HOST:PORT" in receiver("here", REMEDY).remedy


@needs("toys")
def test_permission_is_that_of_this_user(tmp_path, monkeypatch):
    node = tmp_path / "event5"
    node.touch()
    assert usable(str(node), REMEDY).is_met
    monkeypatch.setattr(os, "access", lambda path, _: not str(path).startswith("/dev"))
    assert usable("/dev/null", REMEDY) == ("Permission for /dev/null", False, "do it")
    assert states("tcode:/dev/ttyACM0,channel=V1") == {
        "Permission for /dev/ttyACM0": False
    }


def test_a_falcon_needs_cable_rule_and_firmware(monkeypatch, tmp_path):
    found = []
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    monkeypatch.setattr(guide, "list_falcons", lambda: found)
    assert states("falcon") == {"Falcon on USB": False}
    found.append(FalconAddress("ABC", 3, 7))
    monkeypatch.setattr(guide, "NODE", f"{tmp_path}/{{:03}}-{{:03}}")
    (tmp_path / "003-007").touch()
    monkeypatch.setattr(os, "access", lambda *_: False)
    rule = checks_of(find_device("falcon:ABC"))[-1]
    assert rule.what == f"Permission for {tmp_path}/003-007"
    assert "70-novint-falcon.rules" in rule.remedy
    monkeypatch.setattr(os, "access", lambda *_: True)
    assert states("falcon")["Firmware"] is False
    assert states("falcon:OTHER") == {"Falcon on USB": False}

    def refuse():
        raise refused

    monkeypatch.setattr(guide, "list_falcons", refuse)
    for refused in (FalconForbiddenError("libusb is missing"), OSError(5, "broken")):
        (check,) = checks_of(find_device("falcon"))
        assert (check.is_met, check.remedy) == (False, str(refused.args[-1]))


def test_checks_after_an_unmet_one_are_left_out():
    steps = [Check(REMEDY, met) for met in (True, None, False, True)]
    assert until_unmet(steps) == steps[:3]


def test_guides_are_not_loaded_with_the_registry():
    root = Path(guides.__file__).parents[1]
    text = (root / "devices" / "__init__.py").read_text(encoding="utf-8")
    assert "import guides" not in text
