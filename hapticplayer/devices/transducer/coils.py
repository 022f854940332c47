"""A DualSense's voice coils: vibration of games and sound exclude each other."""

import contextlib
from collections.abc import Callable, Iterable

from hapticplayer.devices.gamepad.ports import ConnectedPad, HidPort, list_pads
from hapticplayer.devices.gamepad.reports import DUALSENSE, audio_report
from hapticplayer.devices.paced import Port
from hapticplayer.devices.transducer.settings import ShakerSettings
from hapticplayer.errors import DeviceError

CHANNELS = frozenset((3, 4))
"""Of its sound card, which are the left and the right coil."""
_CARD = "dualsense"
_SERVERS = ("", "default", "pipewire", "pulse")
"""Names behind which any card may be."""


def give_coils_to_sound(
    settings: ShakerSettings,
    find: Callable[[], Iterable[ConnectedPad]] = list_pads,
    open_found: Callable[[ConnectedPad], Port] = HidPort,
) -> None:
    """Let the DualSenses that are plugged in play their sound, if it may be theirs.

    A `gamepad` takes the coils back with its next command.
    """
    card = settings.card.lower()
    is_its = card in _SERVERS and not CHANNELS.isdisjoint(settings.channels)
    if not (is_its or _CARD in card):
        return
    with contextlib.suppress(DeviceError):  # no right to its HID side: it may work
        for found in find():
            if found.layout is DUALSENSE:
                with contextlib.closing(open_found(found)) as pad:
                    pad.write(audio_report())
