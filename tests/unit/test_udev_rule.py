"""The rule that lets a person use the device, read as udev reads it."""

import re
from pathlib import Path

from hapticplayer.devices.falcon.transport import PRODUCT_ID, VENDOR_ID
from hapticplayer.doctor import ROOT
from hapticplayer.shipped import UDEV_RULE

PATH = ROOT / UDEV_RULE


def rules():
    lines = PATH.read_text(encoding="utf-8").splitlines()
    return [
        re.findall(r'([A-Z]+(?:\{\w+\})?)(==|\+=|=)"([^"]*)"(?:, |$)', line)
        for line in lines
        if line and not line.startswith("#")
    ]


def test_the_rule_comes_before_the_one_that_reads_uaccess():
    assert Path(UDEV_RULE).name < "73-seat-late.rules"
    assert Path(UDEV_RULE).suffix == ".rules"


def test_the_falcon_is_given_to_the_seated_user_only():
    rule = rules()[0]
    matched = {key: value for key, operator, value in rule if operator == "=="}
    assert matched == {
        "SUBSYSTEM": "usb",
        "ENV{DEVTYPE}": "usb_device",
        "ATTR{idVendor}": f"{VENDOR_ID:04x}",
        "ATTR{idProduct}": f"{PRODUCT_ID:04x}",
    }
    assert ("TAG", "+=", "uaccess") in rule
    assert ("MODE", "=", "0660") in rule


def test_every_line_is_understood_to_its_end():
    for line in PATH.read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            parts = re.findall(r'[A-Z]+(?:\{\w+\})?(?:==|\+=|=)"[^"]*"', line)
            assert ", ".join(parts) == line
            assert 'TAG+="uaccess"' in parts
            assert 'MODE="0660"' in parts
