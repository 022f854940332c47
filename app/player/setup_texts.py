"""What is said while a device is set up: steps, advice, and every kind of trouble."""

from typing import NamedTuple

from PySide6.QtCore import QCoreApplication

from app.bridge.languages import translated
from app.player.homing_view import leg_names
from hapticplayer.devices.falcon.firmware import FirmwareMissingError
from hapticplayer.devices.falcon.homing import Advice
from hapticplayer.devices.falcon.setting_up import Progress, Step
from hapticplayer.devices.falcon.transport import (
    UDEV_RULE,
    FalconBusyError,
    FalconDriverError,
    FalconForbiddenError,
    FalconGoneError,
)
from hapticplayer.errors import message_of

translate = QCoreApplication.translate


class Trouble(NamedTuple):
    """What stands in the way.

    Attributes:
        title: what is wrong.
        text: what to do.
        is_watched: whether to try again by itself: it may have been done.
    """

    title: str
    text: str
    is_watched: bool = True


def trouble(problem: BaseException) -> Trouble:
    """Return a problem in words; what is not known keeps the engine's own."""
    for kind, say in (
        (FalconGoneError, _gone),
        (FalconForbiddenError, _forbidden),
        (FalconBusyError, _busy),
        (FalconDriverError, _driver),
        (FirmwareMissingError, _firmware),
    ):
        if isinstance(problem, kind):
            return say()
    title = translate("SetupTexts", "The Falcon cannot be used")
    return Trouble(title, translated(message_of(problem)))


def _gone() -> Trouble:
    return Trouble(
        translate("SetupTexts", "The Falcon is not plugged in"),
        translate(
            "SetupTexts",
            "Connect its USB cable and its power supply; it is found by itself.",
        ),
    )


def _forbidden() -> Trouble:
    text = translate(
        "SetupTexts",
        "Copy the udev rule {rule} to /etc/udev/rules.d, then unplug the Falcon and "
        "plug it in.",
    )
    title = translate("SetupTexts", "You have no permission to use the Falcon")
    return Trouble(title, text.format(rule=UDEV_RULE))


def _busy() -> Trouble:
    return Trouble(
        translate("SetupTexts", "Another program uses the Falcon"),
        translate("SetupTexts", "Close that program; then it goes on by itself."),
    )


def _driver() -> Trouble:
    return Trouble(
        translate("SetupTexts", "The Falcon has the wrong driver"),
        translate(
            "SetupTexts",
            "Give it the driver WinUSB, with the program Zadig, in place of FTDI's or "
            "Force Dimension's; then unplug it and plug it in.",
        ),
    )


def _firmware() -> Trouble:
    return Trouble(
        translate("SetupTexts", "The Falcon needs its firmware"),
        translate(
            "SetupTexts",
            "It belongs to Novint and may not be passed on with this program. Take "
            "nvent_firmware.bin from a libnifalcon source archive and choose the file "
            "here, once.",
        ),
        is_watched=False,
    )


def advice(progress: Progress) -> str:
    """Return what is happening, or what the person does next."""
    if progress.guidance is not None:
        return {
            Advice.PULL: translate(
                "SetupTexts", "Pull the grip out, as far as it goes"
            ),
            Advice.PUSH: translate("SetupTexts", "Push the grip in, until it locks"),
            Advice.DONE: translate("SetupTexts", "The Falcon is ready"),
        }[progress.guidance.advice]
    return {
        Step.CONNECTING: translate("SetupTexts", "Connecting"),
        Step.LOADING: translate("SetupTexts", "Loading the firmware"),
        Step.HOMING: translate("SetupTexts", "Connecting"),
        Step.READY: translate("SetupTexts", "The Falcon is ready"),
    }[progress.step]


def more(progress: Progress) -> str:
    """Return the second line under the advice."""
    if progress.step is Step.READY:
        if progress.buttons:
            return translate("SetupTexts", "A button on the grip is pressed.")
        return translate("SetupTexts", "Move the grip: the picture follows.")
    if progress.guidance is not None:
        pairs = zip(leg_names(), progress.guidance.homed, strict=True)
        found = ", ".join(name for name, is_homed in pairs if is_homed)
        return translate(
            "SetupTexts",
            "Joints that have found their zero: {legs}. There is no force.",
        ).format(legs=found or translate("SetupTexts", "none yet"))
    return ""


def needs_nothing(device: str) -> tuple[str, str]:
    """Return title and text for a device that needs no setting up."""
    kind = device.partition(":")[0]
    title = translate("SetupTexts", "Nothing has to be set up")
    if kind == "simulated":
        return title, translate(
            "SetupTexts",
            "A Falcon that is only computed, held by a simulated hand: for trying "
            "everything without hardware.",
        )
    if kind == "gamepad":
        return title, translate(
            "SetupTexts",
            "Connect a DualSense or a DualShock 4 by its USB cable. It shakes as "
            "strongly as the force is; it has no direction.",
        )
    return title, translate("SetupTexts", "The clip plays without force.")


def licence() -> str:
    """Return what has to be accepted before the firmware is kept."""
    return translate(
        "SetupTexts",
        "The firmware of the Falcon belongs to Novint Technologies. libnifalcon passes "
        "it on under Novint's SDK licence (its file license/LICENSE_NOVINT.txt): for "
        "personal, noncommercial use, free of charge, and every recipient is bound by "
        "it. Read that licence; by going on you say that you may use this file. It "
        "stays on this computer.",
    )


def unknown_image() -> str:
    """Return what has to be decided about a file that nobody has recorded."""
    return translate(
        "SetupTexts",
        "The file is sound, but it is none of the firmware files that are known. It "
        "would run the motors. Keep it only if you know where it comes from.",
    )
