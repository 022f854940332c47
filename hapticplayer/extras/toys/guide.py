"""Set-up pages of toys."""

from collections.abc import Iterable

from hapticplayer.devices.checks import Check, package, receiver, service, usable
from hapticplayer.devices.guides import WEBSOCKETS, Guide
from hapticplayer.devices.options import DeviceOptions
from hapticplayer.errors import Message
from hapticplayer.extras.toys import buttplug, tcode


def _buttplug(options: DeviceOptions) -> Iterable[Check]:
    yield from package("websockets", WEBSOCKETS)
    yield service(buttplug.TITLE, options.address)


def _board(options: DeviceOptions) -> Iterable[Check]:
    where = options.address
    if where.startswith("/"):
        group = Message("Connect the board, and add yourself to the group dialout.")
        yield usable(where, group)
    else:
        yield receiver(
            where, Message("Start the program that passes TCode on to the board.")
        )


BUTTPLUG = Guide(
    Message(
        "Toys through Intiface: their vibration follows the strength of the force, not "
        "its direction."
    ),
    Message("Start Intiface, start its server and connect what vibrates there."),
    checks=_buttplug,
    example=buttplug.DEFAULT,
)
TCODE = Guide(
    Message(
        "Board that takes TCode: its vibration follows the strength of the force, not its "
        "direction."
    ),
    Message(
        "Enter HOST:PORT of a board or program that takes TCode by UDP, or a serial port "
        "such as /dev/ttyUSB0."
    ),
    checks=_board,
    example=tcode.DEFAULT,
)
