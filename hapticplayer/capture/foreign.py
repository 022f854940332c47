"""Files that people export by mistake, and what to export instead."""

import re

from hapticplayer.errors import InputError

_UTF16 = (b"\xff\xfe", b"\xfe\xff")
_OLD_EXCEL = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"
_NEW_EXCEL = "xl/"
_DATE = re.compile(r'^"?(\d{4}-\d\d-\d\d[T ]\d\d:\d\d[^,;\t"]*)', re.MULTILINE)


def refuse_foreign(head: bytes, where: str) -> None:
    """Refuse a file by its first bytes.

    Raises:
        InputError: for text in UTF-16 and for an old Excel workbook.
    """
    if head.startswith(_UTF16):
        raise InputError(
            "is text in UTF-16", where=where, remedy="save it as text in UTF-8"
        )
    if head.startswith(_OLD_EXCEL):
        raise _workbook(where)


def refuse_workbook(names: tuple[str, ...], where: str) -> None:
    """Refuse a zip that is a newer Excel workbook, by the names of its members.

    Raises:
        InputError: saying what to export.
    """
    if any(name.startswith(_NEW_EXCEL) for name in names):
        raise _workbook(where)


def refuse_dates(head: str, where: str) -> None:
    """Refuse a table whose rows begin with dates.

    Raises:
        InputError: showing the first of them.
    """
    if found := _DATE.search(head):
        raise InputError(
            f"writes its times as dates ({found[1].strip()[:40]})",
            where=where,
            remedy="export the times as numbers, in s, ms, us or ns",
        )


def _workbook(where: str) -> InputError:
    return InputError(
        "is an Excel workbook", where=where, remedy="export the recording as CSV"
    )
