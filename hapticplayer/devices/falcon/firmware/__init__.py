"""The Falcon's firmware: checked, kept for its owner, and loaded at each power-up.

It belongs to Novint and is neither part of this program nor fetched by it.
"""

from hapticplayer.devices.falcon.firmware.image import (
    KNOWN_IMAGES,
    FirmwareImage,
    MemoryBlock,
    build_image,
    parse_image,
)
from hapticplayer.devices.falcon.firmware.loader import (
    RETRY_LIMITS,
    Progress,
    RetryLimits,
    UploadError,
    is_running,
    open_running,
    upload,
)
from hapticplayer.devices.falcon.firmware.store import (
    LICENCE_NOTE,
    OVERRIDE,
    FirmwareMissingError,
    UnknownFirmwareError,
    find_image,
    install_image,
    kept_path,
    read_image,
)

__all__ = [
    "KNOWN_IMAGES",
    "LICENCE_NOTE",
    "OVERRIDE",
    "RETRY_LIMITS",
    "FirmwareImage",
    "FirmwareMissingError",
    "MemoryBlock",
    "Progress",
    "RetryLimits",
    "UnknownFirmwareError",
    "UploadError",
    "build_image",
    "find_image",
    "install_image",
    "is_running",
    "kept_path",
    "open_running",
    "parse_image",
    "read_image",
    "upload",
]
