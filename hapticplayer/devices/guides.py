"""The set-up page of each kind of device: what it is and what it needs.

An entry of the registry names its `Guide`; one without gets a page from its capability
record. Nothing of this is loaded by the haptics process.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from hapticplayer.devices import UDEV_RULE, DeviceEntry
from hapticplayer.devices import buttplug as _intiface
from hapticplayer.devices import tcode as _tcode
from hapticplayer.devices.checks import (
    Check,
    on_linux,
    package,
    receiver,
    service,
    until_unmet,
    usable,
)
from hapticplayer.devices.evdev.effects import FF_CONSTANT, FF_RUMBLE
from hapticplayer.devices.evdev.ports import DEVICES as _NODES
from hapticplayer.devices.evdev.ports import list_devices
from hapticplayer.devices.falcon import firmware
from hapticplayer.devices.falcon.transport import list_falcons
from hapticplayer.devices.falcon.usbfs import NODE
from hapticplayer.devices.inverse3 import driver as _inverse3
from hapticplayer.devices.options import DeviceOptions
from hapticplayer.devices.rig.packets import FORMATS
from hapticplayer.devices.rig.settings import LOOPBACK
from hapticplayer.devices.transducer.cards import check_card
from hapticplayer.devices.transducer.settings import ShakerSettings
from hapticplayer.errors import HapticPlayerError, Message, message_of
from hapticplayer.extension import load
from hapticplayer.model.device import DeviceCapabilities, Signal

Checks = Callable[[Any], Iterable[Check]]
_WEBSOCKETS = Message("Install hapticplayer with its extra websockets.")
_RULE = Message(
    "Copy the udev rule {rule} to /etc/udev/rules.d, then unplug the device and plug it "
    "in.",
    rule=UDEV_RULE,
)


def _nothing(_options: Any) -> Iterable[Check]:
    return ()


@dataclass(frozen=True, slots=True)
class Guide:
    """The set-up page of a kind of device; `options` is what its parser returns.

    Attributes:
        what: what it is and does, a sentence.
        connect: how to connect it, some sentences.
        hold: what a person does before it moves; "" for what suits its capabilities.
        checks: called with `options`, in a thread, returns what it needs.
        example: of what follows the name and a colon.
        variants: kinds of it that lists offer, each with an example of what follows it.
        parts: called with `options`, returns label and device name of each part that is
            tested by itself; for devices with several channels.
        tells_latency: whether it answers each command when it acts on it: half the age
            of its answers is its latency.
    """

    what: Message
    connect: Message
    hold: Message | str = ""
    checks: Checks = _nothing
    example: str = ""
    variants: Mapping[str, str] = field(default_factory=dict)
    parts: Callable[[Any], Sequence[tuple[str, str]]] | None = None
    tells_latency: bool = False


def guide_of(entry: DeviceEntry) -> Guide:
    """Return the guide of a device, or a plain one."""
    if entry.guide:
        guide: Guide = load(entry.guide)
        return guide
    return Guide(Message(entry.title), Message("Connect it as its maker says."))


def hold_text(guide: Guide, record: DeviceCapabilities) -> Message:
    """The steps of a person before the device moves."""
    if guide.hold:
        return Message(guide.hold)
    if record.signal is Signal.MOTION:
        return Message("Nobody sits on it yet; its emergency stop is at hand.")
    return Message("Hold it loosely.") if record.axes else Message("Hold it.")


def checks_of(entry: DeviceEntry) -> list[Check]:
    """The needs of a device, up to the first that is not met."""
    try:
        return until_unmet(guide_of(entry).checks(entry.settings))
    except Exception as problem:  # noqa: BLE001 - of any package: the page shows it
        what = Message("Search on this computer")
        return [Check(what, False, message_of(problem))]


# --- what each of them needs ----------------------------------------------------


def _falcon(options: DeviceOptions) -> Iterable[Check]:
    remedy = Message("Connect its power supply and its USB cable.")
    found = [
        one
        for one in list_falcons()
        if options.address in ("", one.serial) or not one.serial
    ]
    yield Check(Message("Falcon on USB"), bool(found), remedy)
    for one in found[:1]:
        node = Path(NODE.format(one.bus, one.address))
        if node.exists():  # on Linux
            yield usable(str(node), _RULE)
    try:
        firmware.find_image()
    except HapticPlayerError as problem:
        yield Check(Message("Firmware"), False, message_of(problem))
    else:
        yield Check(Message("Firmware"), True)


def _inverse(options: DeviceOptions) -> Iterable[Check]:
    yield from package("websockets", _WEBSOCKETS)
    yield service(_inverse3.TITLE, options.address)


def _buttplug(options: DeviceOptions) -> Iterable[Check]:
    yield from package("websockets", _WEBSOCKETS)
    yield service(_intiface.TITLE, options.address)


def _event(node: str, effect: int, kind: Message) -> Iterable[Check]:
    yield from on_linux()
    found = [one for one in list_devices(effect) if node in ("", one.node)]
    title = found[0].title if found else kind
    yield Check(
        Message(title),
        bool(found),
        Message(
            "Connect it; if it is connected, its driver is missing or has no such force "
            "feedback."
        ),
    )
    group = Message("Add yourself to the group input, log out and log in again.")
    for one in found[:1]:
        yield usable(str(_NODES / one.node), group)


def _wheel(options: DeviceOptions) -> Iterable[Check]:
    return _event(
        options.address, FF_CONSTANT, Message("Wheel or joystick with a motor")
    )


def _rumble(options: DeviceOptions) -> Iterable[Check]:
    return _event(options.address, FF_RUMBLE, Message("Game pad that Linux can rumble"))


def _rig(options: DeviceOptions) -> Iterable[Check]:
    yield receiver(options.address, Message("Start the rig's software."))


def _shaker(options: ShakerSettings) -> Iterable[Check]:
    yield from package(
        "sounddevice", Message("Install the Python package sounddevice.")
    )
    yield check_card(options)


def _board(options: DeviceOptions) -> Iterable[Check]:
    where = options.address
    if where.startswith("/"):
        group = Message("Connect the board, and add yourself to the group dialout.")
        yield usable(where, group)
    else:
        yield receiver(
            where, Message("Start the program that passes TCode on to the board.")
        )


def _channels(settings: ShakerSettings) -> Sequence[tuple[str, str]]:
    return [(str(channel), settings.alone(channel)) for channel in settings.channels]


# --- the guides -------------------------------------------------------------------

SIMULATED = Guide(
    Message(
        "Simulated Falcon, held by a simulated hand: for trying everything without "
        "hardware."
    ),
    Message("Nothing has to be connected."),
    hold=Message("Only its picture moves."),
)
FALCON = Guide(
    Message("Novint Falcon: its grip pushes and pulls in three directions."),
    Message("Connect its USB cable and power supply; it is detected automatically."),
    hold=Message("Hold the grip loosely."),
    checks=_falcon,
    tells_latency=True,
)
INVERSE3 = Guide(
    Message("Haply Inverse3: its arm pushes and pulls in three directions."),
    Message(
        "Start Haply's Inverse Service and connect the Inverse3, with its power supply. "
        "Enter HOST:PORT if the service runs on another computer."
    ),
    hold=Message("Hold the grip loosely."),
    checks=_inverse,
    example=_inverse3.DEFAULT,
    tells_latency=True,
)
WHEEL = Guide(
    Message(
        "Wheel or joystick with a motor: it exerts one axis of the force, by default "
        "sideways."
    ),
    Message(
        "Connect its USB cable and its power supply. axis=y chooses another axis, sign=- "
        "turns its direction round."
    ),
    hold=Message("Hold it with both hands."),
    checks=_wheel,
    example="event5,axis=x,sign=-",
)
RUMBLE = Guide(
    Message(
        "Game pad that Linux can rumble: its vibration follows the strength of the force, "
        "not its direction."
    ),
    Message("Connect it by cable or by Bluetooth."),
    checks=_rumble,
    example="event5",
)
SHAKER = Guide(
    Message(
        "Bass shakers or voice coils on a sound output: they vibrate with the force."
    ),
    Message(
        "Connect the amplifier of the shakers to the sound output. By default channels 1 "
        "and 2 play; pulse,channels=3+4 chooses others."
    ),
    hold=Message("Turn the amplifier low."),
    checks=_shaker,
    example="pulse,channels=3+4",
    parts=_channels,
)
BUTTPLUG = Guide(
    Message(
        "Toys through Intiface: their vibration follows the strength of the force, not "
        "its direction."
    ),
    Message("Start Intiface, start its server and connect what vibrates there."),
    checks=_buttplug,
    example=_intiface.DEFAULT,
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
    example=_tcode.DEFAULT,
)
RIG = Guide(
    Message(
        "Software of a motion rig: it gets the motion of the recording by UDP, as from a "
        "game."
    ),
    Message(
        "Choose this game in the rig's software. Packets stay on this computer unless you "
        "enter another address."
    ),
    checks=_rig,
    variants={name: f"{LOOPBACK}:{kind.port}" for name, kind in FORMATS.items()},
)
