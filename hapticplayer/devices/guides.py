"""The set-up page of each kind of device: what it is and what it needs.

An entry of the registry names its `Guide`; one without gets a page from its capability
record. Nothing of this is loaded by the haptics process.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from hapticplayer.devices import DeviceEntry
from hapticplayer.devices.checks import Check, until_unmet
from hapticplayer.errors import Message, message_of
from hapticplayer.extension import load
from hapticplayer.installation import how_to_get
from hapticplayer.model.device import DeviceCapabilities, Signal

Checks = Callable[[Any], Iterable[Check]]
WEBSOCKETS = Message(
    "Install hapticplayer[websockets]: {how}", how=how_to_get("websockets")
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
        variants: kinds of it that lists offer, each with its title for people and an
            example of what follows it.
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
    variants: Mapping[str, tuple[str, str]] = field(default_factory=dict)
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


SIMULATED = Guide(
    Message(
        "Simulated Falcon, held by a simulated hand: for trying everything without "
        "hardware."
    ),
    Message("Nothing has to be connected."),
    hold=Message("Nothing moves but the picture."),
)
