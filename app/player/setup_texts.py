"""What is said while a device is set up: steps, advice, and every problem of a device."""

from typing import NamedTuple

from PySide6.QtCore import QCoreApplication

from app.bridge.languages import translated
from app.player.homing_view import leg_names
from hapticplayer.devices.falcon.firmware import FirmwareMissingError
from hapticplayer.devices.falcon.homing import Advice
from hapticplayer.devices.falcon.setting_up import Progress, Step
from hapticplayer.devices.falcon.transport import (
    FalconBusyError,
    FalconDriverError,
    FalconForbiddenError,
    FalconGoneError,
)
from hapticplayer.errors import message_of
from hapticplayer.shipped import UDEV_RULE

translate = QCoreApplication.translate


class DeviceProblem(NamedTuple):
    """Why the device is not ready, and what to do.

    `is_watched` is whether to try again by itself: it may have been done.
    """

    title: str
    text: str
    is_watched: bool = True


def describe_problem(problem: BaseException) -> DeviceProblem:
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
    return DeviceProblem(title, translated(message_of(problem)))


def _gone() -> DeviceProblem:
    return DeviceProblem(
        translate("SetupTexts", "The Falcon is not plugged in"),
        translate(
            "SetupTexts",
            "Connect its USB cable and power supply; it is detected automatically.",
        ),
    )


def _forbidden() -> DeviceProblem:
    text = translate(
        "SetupTexts",
        "Copy the udev rule {rule} to /etc/udev/rules.d, then unplug the Falcon and "
        "plug it in.",
    )
    title = translate("SetupTexts", "Permission denied for the Falcon")
    return DeviceProblem(title, text.format(rule=UDEV_RULE))


def _busy() -> DeviceProblem:
    return DeviceProblem(
        translate("SetupTexts", "The Falcon is in use by another program"),
        translate(
            "SetupTexts", "Close that program; setup then continues automatically."
        ),
    )


def _driver() -> DeviceProblem:
    return DeviceProblem(
        translate("SetupTexts", "The Falcon has the wrong driver"),
        translate(
            "SetupTexts",
            "Replace FTDI's or Force Dimension's driver by WinUSB, using "
            "Zadig; then unplug it and plug it in again.",
        ),
    )


def _firmware() -> DeviceProblem:
    return DeviceProblem(
        translate("SetupTexts", "The Falcon needs its firmware"),
        translate(
            "SetupTexts",
            "It belongs to Novint and cannot be distributed with this "
            "program. Take nvent_firmware.bin from a libnifalcon source "
            "archive and choose the file here, once.",
        ),
        is_watched=False,
    )


def advice(progress: Progress) -> str:
    """The state, or the person's next step."""
    if progress.guidance is not None:
        return {
            Advice.PULL: translate("SetupTexts", "Pull the grip all the way out"),
            Advice.PUSH: translate("SetupTexts", "Push the grip in until it locks"),
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
        return translate("SetupTexts", "Move the grip: the drawing follows.")
    if progress.guidance is not None:
        pairs = zip(leg_names(), progress.guidance.homed, strict=True)
        found = ", ".join(name for name, is_homed in pairs if is_homed)
        return translate(
            "SetupTexts",
            "Homed joints: {legs}. The force is off.",
        ).format(legs=found or translate("SetupTexts", "none yet"))
    return ""


def licence() -> str:
    """The terms to accept before the firmware is kept."""
    return translate(
        "SetupTexts",
        "The Falcon's firmware belongs to Novint Technologies. "
        "libnifalcon distributes it under Novint's SDK licence (its "
        "file license/LICENSE_NOVINT.txt): free of charge for personal, "
        "noncommercial use, binding for every recipient. Read that "
        "licence; by continuing you confirm that you may use this file. "
        "It stays on this computer.",
    )


def unknown_image() -> str:
    """The question about a file that is not among the known ones."""
    return translate(
        "SetupTexts",
        "The file is intact but is not a known firmware image. It would "
        "drive the motors. Install it only if you trust its source.",
    )
