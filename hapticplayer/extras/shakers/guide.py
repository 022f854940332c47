"""Set-up page of shakers."""

from collections.abc import Iterable, Sequence

from hapticplayer.devices.checks import Check, package
from hapticplayer.devices.guides import Guide
from hapticplayer.errors import Message
from hapticplayer.extras.shakers.cards import check_card
from hapticplayer.extras.shakers.settings import ShakerSettings


def _shaker(options: ShakerSettings) -> Iterable[Check]:
    yield from package(
        "sounddevice", Message("Install the Python package sounddevice.")
    )
    yield check_card(options)


def _channels(settings: ShakerSettings) -> Sequence[tuple[str, str]]:
    return [(str(channel), settings.alone(channel)) for channel in settings.channels]


SHAKER = Guide(
    Message(
        "Bass shakers or voice coils on a sound output: they vibrate with the force."
    ),
    Message(
        "Connect the amplifier of the shakers to the sound output. By default channels 1 "
        "and 2 play; the settings choose others."
    ),
    hold=Message("Turn the amplifier low."),
    checks=_shaker,
    example="pulse,channels=3+4",
    parts=_channels,
)
