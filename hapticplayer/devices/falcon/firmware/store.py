"""Where the user's own copy of the firmware is kept. It is never fetched from anywhere."""

import os
from pathlib import Path

from hapticplayer.devices.falcon.firmware.image import (
    KNOWN_IMAGES,
    MAX_IMAGE_BYTES,
    FirmwareImage,
    parse_image,
)
from hapticplayer.errors import DeviceError, InputError, UsageError, message_of
from hapticplayer.storage import data_home, replace_file
from hapticplayer.untrusted import read_regular

OVERRIDE = "HAPTICPLAYER_FALCON_FIRMWARE"
"""Environment variable with the path of an image to be used instead of the kept one."""

LICENCE_NOTE = """\
The firmware of the Falcon belongs to Novint Technologies. It is not part of this
program. libnifalcon passes it on under Novint's SDK licence (its file
license/LICENSE_NOVINT.txt): for personal, noncommercial use, free of charge, and every
recipient is bound by it. Read that licence; by installing the file you say that you
may use it. The file stays on this computer."""


class UnknownFirmwareError(UsageError):
    """The file is intact but unknown: a decision is needed."""


class FirmwareMissingError(DeviceError):
    """The user has not given the Falcon's firmware yet."""


_FILE_NAME = "falcon-firmware.bin"


def kept_path() -> Path:
    """Return where the firmware is kept, or would be.

    `$HAPTICPLAYER_FALCON_FIRMWARE`, else `hapticplayer/falcon-firmware.bin` in the
    user's folder for data (`$XDG_DATA_HOME`, by default ~/.local/share).
    """
    override = os.environ.get(OVERRIDE)
    if override:
        return Path(override).expanduser()
    try:
        return data_home() / _FILE_NAME
    except RuntimeError as problem:
        raise DeviceError(
            "the home folder is unknown; set {variable} to the firmware's path",
            variable=OVERRIDE,
        ) from problem


def find_image() -> FirmwareImage:
    """Return the user's firmware.

    Raises:
        FirmwareMissingError: when there is none.
        DeviceError: when the file is damaged.
    """
    path = kept_path()
    if not path.exists():
        raise FirmwareMissingError(
            "the Falcon's firmware is missing ({path}); it may not be passed on "
            "with this program: take nvent_firmware.bin from a libnifalcon source "
            "archive and install it: Device > Set up the device "
            "(`hapticplayer device upload-firmware FILE`)",
            path=path,
        )
    return read_image(path)


def read_image(path: Path) -> FirmwareImage:
    """Return the firmware in a file; raises DeviceError if it is unreadable or none."""
    try:
        data = read_regular(path, MAX_IMAGE_BYTES + 1)
    except InputError as problem:
        raise DeviceError(message_of(problem)) from problem
    try:
        return parse_image(data)
    except DeviceError as problem:
        raise DeviceError("{path}: {reason}", path=path, reason=problem) from problem


def install_image(source: Path, *, accept_unknown: bool = False) -> FirmwareImage:
    """Check a firmware file and keep a copy of it; show `LICENCE_NOTE` before.

    Raises:
        UnknownFirmwareError: when it is an unknown one and that was not accepted.
    """
    image = read_image(source)
    if not image.known_name and not accept_unknown:
        raise UnknownFirmwareError(
            "{source}: sound, but none of the known images ({known}; SHA-256 "
            "{sha256}...); it would run the motors: say that you want it "
            "(--accept-unknown)",
            source=source,
            known=", ".join(sorted(KNOWN_IMAGES.values())),
            sha256=image.sha256[:16],
        )
    target = kept_path()
    try:
        replace_file(target, image.data)
    except InputError as problem:
        raise DeviceError(
            "{reason}, or set {variable} to another path",
            reason=problem,
            variable=OVERRIDE,
        ) from problem
    return image
