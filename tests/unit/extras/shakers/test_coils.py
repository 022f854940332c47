"""Opening a shaker gives a DualSense's coils to the sound, and leaves other pads alone."""

import pytest

from hapticplayer.extras.shakers.coils import SOUND_REPORT, give_coils_to_sound
from hapticplayer.extras.shakers.settings import shaker_settings

PADS = {  # bus, vendor, product: DualShock 4; DualSense by USB and by Bluetooth
    "hidraw3": "0003:0000054C:000009CC",
    "hidraw5": "0003:0000054C:00000CE6",
    "hidraw7": "0005:0000054C:00000CE6",
}


@pytest.fixture
def written(tmp_path):
    """Names and bytes of the device files that were written to."""
    for name, identity in PADS.items():
        (tmp_path / "known" / name / "device").mkdir(parents=True)
        (tmp_path / "known" / name / "device/uevent").write_text(
            f"DRIVER=playstation\nHID_ID={identity}\nHID_NAME=Wireless Controller\n"
        )
        (tmp_path / name).touch()

    def after(text):
        give_coils_to_sound(shaker_settings(text), tmp_path / "known", tmp_path)
        return {name: data for name in PADS if (data := (tmp_path / name).read_bytes())}

    return after


@pytest.mark.parametrize(
    "text",
    ["DualSense Wireless Controller,channels=1", "pulse,channels=3+4", ",channels=4"],
)
def test_dualsense_by_usb_gets_a_report_with_clear_flags(written, text):
    assert written(text) == {"hidraw5": SOUND_REPORT}
    assert (len(SOUND_REPORT), SOUND_REPORT[:2]) == (48, b"\x02\x00")


@pytest.mark.parametrize("text", ["", "pulse,channels=1+2", "Shaker Amp,channels=3+4"])
def test_sound_that_is_not_its_leaves_it_alone(written, text):
    assert written(text) == {}


def test_without_the_device_file_the_sound_is_tried(written, tmp_path):
    (tmp_path / "hidraw5").unlink()
    (tmp_path / "hidraw5").mkdir()
    give_coils_to_sound(
        shaker_settings("pulse,channels=3+4"), tmp_path / "known", tmp_path
    )
