"""What a file is that was given as a log and is none, and what to do with it."""

import re
import zipfile
from typing import NamedTuple

from hapticplayer.capture import formats
from hapticplayer.capture.csv_table import foreign_digits, header_fault, nul_bytes
from hapticplayer.capture.source import LogSource, is_plain_text
from hapticplayer.errors import InputError, Message, TelemetryError
from hapticplayer.untrusted import open_regular

_NEW_EXCEL = "xl/"
_UTF16_SHARE = 0.9
"""Of every second byte that is zero."""


class _FileKind(NamedTuple):
    """A kind of file that is known by its magic bytes."""

    magic: bytes
    what: Message
    remedy: Message
    offset: int = 0


_WORKBOOK = (
    Message("is an Excel workbook"),
    Message("export the recording as CSV"),
)
_UTF16 = (Message("is text in UTF-16"), Message("save it as text in UTF-8"))
_ARCHIVE = (
    Message("is an archive that is not a zip"),
    Message("unpack it and give the folder"),
)
_CERTAIN = (
    _FileKind(b"\xff\xfe", *_UTF16),
    _FileKind(b"\xfe\xff", *_UTF16),
    _FileKind(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", *_WORKBOOK),
    _FileKind(
        b"H Product:Blackbox",
        Message("is a blackbox log of a flight controller"),
        Message("convert it to CSV with blackbox_decode"),
    ),
    _FileKind(
        b".FIT",
        Message("is a FIT file of a sports watch or cycle computer"),
        Message("export its accelerometer and gyroscope as CSV, with FitCSVTool"),
        offset=8,
    ),
    _FileKind(
        b"\x1f\x8b\x08",
        Message("is compressed with gzip"),
        Message("unpack it and give the file in it"),
    ),
    _FileKind(b"7z\xbc\xaf\x27\x1c", *_ARCHIVE),
    _FileKind(b"Rar!\x1a\x07", *_ARCHIVE),
    _FileKind(b"\xfd7zXZ\x00", *_ARCHIVE),
    _FileKind(b"BZh", *_ARCHIVE),
    _FileKind(b"\x28\xb5\x2f\xfd", *_ARCHIVE),
)
_MARKUP = (
    (r"\s*(?:\{|\[\s*[\[{])", Message("is JSON, not a table")),
    (r"\s*<[?!a-zA-Z]", Message("is XML or a web page, not a table")),
)


def refuse_foreign(source: LogSource) -> None:
    """Reject what its first bytes name."""
    content = source.beginning(source.names[0]) if source.is_one_file else b""
    for kind in _CERTAIN:
        if content[kind.offset :].startswith(kind.magic):
            raise InputError(kind.what, where=str(source.path), remedy=kind.remedy)


def why_unreadable(source: LogSource) -> InputError | None:
    """The kind of a file that could not be read as a video, or None."""
    if not source.is_binary:
        return None
    what, remedy = _named(source, source.beginning(source.names[0]))
    return InputError(what, where=str(source.path), remedy=remedy) if what else None


def _named(source: LogSource, content: bytes) -> tuple[str, str]:
    """The kind of a file and the remedy, or nothing."""
    if _is_utf16(content):
        return _UTF16
    if not content.strip(b"\0"):
        return (
            Message("begins with {count} NUL bytes", count=len(content)),
            Message("copy it again from the recorder"),
        )
    if is_plain_text(content.replace(b"\0", b"")):
        return nul_bytes()
    if _is_padded_zip(source):
        return (
            Message("is a zip with other bytes before it"),
            Message("unpack it and give the folder"),
        )
    return "", ""


def _is_utf16(content: bytes) -> bool:
    """Whether every second byte of a plain text is zero."""
    for zeros, letters in (
        (content[1::2], content[::2]),
        (content[::2], content[1::2]),
    ):
        if zeros and zeros.count(0) >= _UTF16_SHARE * len(zeros):
            return is_plain_text(letters)
    return False


def _is_padded_zip(source: LogSource) -> bool:
    try:
        with open_regular(source.path) as reader, zipfile.ZipFile(reader) as archive:
            return bool(archive.infolist())
    except (zipfile.BadZipFile, InputError, OSError, ValueError, NotImplementedError):
        return False


def unknown(source: LogSource) -> InputError:
    """Return why a source of no known format cannot be read."""
    where = str(source.path)
    if any(name.startswith(_NEW_EXCEL) for name in source.names):
        what, remedy = _WORKBOOK
        return InputError(what, where=where, remedy=remedy)
    if not source.is_one_file:
        return InputError(
            "holds no log of a known format",
            where=where,
            remedy="give the folder or zip that the logger has written, or a sequence",
        )
    if source.is_binary:
        return TelemetryError(
            "holds no motion that can be read",
            where=where,
            remedy="give the log of a motion sensor, too (--imu LOG)",
        )
    head = source.head(source.names[0])
    for pattern, what in _MARKUP:
        if re.match(pattern, head):
            return InputError(what, where=where, remedy="export the recording as CSV")
    reasons = (row.reader().why_not(source) for row in formats.recording_formats())
    fault = next((reason for reason in reasons if reason), None)
    return foreign_digits(head, where) or fault or header_fault(source)
