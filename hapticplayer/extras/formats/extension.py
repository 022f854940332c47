"""Formats of force that other programs read or write, and the command `convert`."""

from typing import TYPE_CHECKING

from hapticplayer.errors import Message

if TYPE_CHECKING:
    from hapticplayer.cli import Command
    from hapticplayer.sequence.force_files import ForceFormat
    from hapticplayer.sequence.sharing import ForceAttachment

_HERE = "hapticplayer.extras.formats"


def commands() -> "tuple[Command, ...]":
    """The command `convert`."""
    from hapticplayer.cli import Command

    summary = "convert force from one format to another"
    return (Command("convert", summary, f"{_HERE}.convert"),)


def attachments() -> "tuple[ForceAttachment, ...]":
    """The force as hjif in a video that is shared."""
    from hapticplayer.sequence.sharing import ForceAttachment

    return (ForceAttachment("hjif", f"{_HERE}.hjif:attached"),)


def force_formats() -> "tuple[ForceFormat, ...]":
    """Those that are read, written or both."""
    from hapticplayer.extras.formats import (
        ahap,
        funscript,
        hjif,
        hjif_read,
        mpegv,
        mpegv_read,
        wav,
        wav_read,
    )
    from hapticplayer.sequence.force_files import ForceFormat
    from hapticplayer.sequence.force_formats import read_back

    return (
        ForceFormat(
            "hjif",
            ".hjif",
            Message("MPEG haptics (ISO/IEC 23090-31), as JSON"),
            Message("the force in newtons on three axes, within the tolerance"),
            hjif.is_ours,
            hjif.write,
            hjif_read.read,
            read_back(hjif_read.read),
        ),
        ForceFormat(
            "wav",
            ".wav",
            Message("audio of three channels, for transducers"),
            Message("the force in newtons, at the sample rate"),
            wav.is_ours,
            wav.write,
            wav_read.read,
            read_back(wav_read.read),
            is_sampled=True,
        ),
        ForceFormat(
            "mpegv",
            ".sem",
            Message("MPEG-V sensory effects (ISO/IEC 23005-3), as XML"),
            Message("the force in newtons on three axes, within the tolerance"),
            mpegv.is_ours,
            mpegv.write,
            mpegv_read.read,
            read_back(mpegv_read.read),
            (".xml",),
            takes_motion=True,
        ),
        ForceFormat(
            "funscript",
            ".funscript",
            Message("positions of a hand, for motion devices"),
            Message("the excursion that a normal hand would make; no newtons"),
            funscript.is_ours,
            funscript.write,
            funscript.read,
            funscript.no_newtons,
            parts=funscript.parts,
        ),
        ForceFormat(
            "ahap",
            ".ahap",
            Message("haptic pattern for iPhones"),
            Message("the size of the force and its frequency; no direction"),
            ahap.is_ours,
            ahap.write,
            None,
            ahap.loss,
        ),
    )
