"""A DualSense's voice coils: vibration of games and sound exclude each other.

Report: Linux, drivers/hid/hid-playstation.c, dualsense_output_report_common, whose flags
of vibration are clear. Only Linux has the files that are used here.
"""

import contextlib
from pathlib import Path

from hapticplayer.extras.shakers.settings import ShakerSettings

CHANNELS = frozenset((3, 4))
"""Of its sound card, which are the left and the right coil."""
SOUND_REPORT = b"\x02" + bytes(47)
_CARD = "dualsense"
_SERVERS = ("", "default", "pipewire", "pulse")
"""Names behind which any card may be."""
_ON_USB = ("0003:0000054C:00000CE6", "0003:0000054C:00000DF2")  # DualSense and Edge


def give_coils_to_sound(
    settings: ShakerSettings,
    known: Path = Path("/sys/class/hidraw"),
    nodes: Path = Path("/dev"),
) -> None:
    """Let the DualSenses that are plugged in play their sound, if it may be theirs.

    `rumble` takes the coils back with its next command.
    """
    card = settings.address.lower()
    is_its = card in _SERVERS and not CHANNELS.isdisjoint(settings.channels)
    if not (is_its or _CARD in card):
        return
    for found in known.glob("hidraw*"):
        with contextlib.suppress(OSError):  # no right to its HID side: it may work
            if any(pad in (found / "device/uevent").read_text() for pad in _ON_USB):
                with (nodes / found.name).open("r+b", buffering=0) as pad:
                    pad.write(SOUND_REPORT)
