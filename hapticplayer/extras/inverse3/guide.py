"""Set-up page of the Inverse3."""

from collections.abc import Iterable

from hapticplayer.devices.checks import Check, package, service
from hapticplayer.devices.guides import WEBSOCKETS, Guide
from hapticplayer.devices.options import DeviceOptions
from hapticplayer.errors import Message
from hapticplayer.extras.inverse3.driver import DEFAULT, TITLE


def _inverse(options: DeviceOptions) -> Iterable[Check]:
    yield from package("websockets", WEBSOCKETS)
    yield service(TITLE, options.address)


INVERSE3 = Guide(
    Message("Haply Inverse3: its arm pushes and pulls in three directions."),
    Message(
        "Start Haply's Inverse Service and connect the Inverse3, with its power supply. "
        "Enter HOST:PORT if the service runs on another computer."
    ),
    hold=Message("Hold the grip loosely."),
    checks=_inverse,
    example=DEFAULT,
    tells_latency=True,
)
