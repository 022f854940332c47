"""The one hierarchy of errors that a person may get to read.

Every message says what is wrong, where, and what to do, in one sentence; the
command line prints it on stderr, the window shows it.
"""


class HapticPlayerError(Exception):
    """Root: something was refused or failed, and the message says why."""


class InputError(HapticPlayerError):
    """A file or value that came from outside cannot be used."""

    def __init__(self, what: str, *, where: str = "", remedy: str = "") -> None:
        parts = [f"{where}: {what}" if where else what]
        if remedy:
            parts.append(remedy)
        super().__init__("; ".join(parts))
        self.what = what
        self.where = where
        self.remedy = remedy


class MediaError(InputError):
    """A media file cannot be opened or decoded."""


class TelemetryError(InputError):
    """A recording holds no motion that can be used."""


class SequenceError(InputError):
    """A sequence folder is missing something, damaged, or cannot be written."""


class StudyError(InputError):
    """A study's definition, order or answers cannot be used, or cannot be kept."""


class DeviceError(HapticPlayerError):
    """A haptic device is missing, refused the connection or failed."""


class HapticsError(HapticPlayerError):
    """The haptics process could not be started or has died."""


class UsageError(HapticPlayerError):
    """The call is wrong, or a decision is needed (exit status 2)."""


class Cancelled(HapticPlayerError):  # noqa: N818 - a decision, not a fault
    """The user stopped a long piece of work; nothing was left behind."""

    def __init__(self) -> None:
        super().__init__("cancelled; nothing was written")
