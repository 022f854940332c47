"""What records of the haptic loop can be exported as, one line for each format."""

from collections.abc import Callable
from typing import Any, BinaryIO, NamedTuple

from hapticplayer.errors import Progress
from hapticplayer.haptics.record_reader import RecordReader
from hapticplayer.playback.record_csv import is_csv, write_csv
from hapticplayer.storage import IsOurs


class RecordExporter(NamedTuple):
    """A format.

    Attributes:
        name: for `export --format`.
        text: for people.
        write: writes all intact ticks of a record, and returns what to report of them.
        is_ours: recognises its files, to overwrite them.
    """

    name: str
    text: str
    write: Callable[[RecordReader, BinaryIO, Progress], dict[str, Any]]
    is_ours: IsOurs


_EXPORTERS = (
    RecordExporter(
        "csv", "a line per tick with the units in the names", write_csv, is_csv
    ),
)
RECORD_EXPORTERS: dict[str, RecordExporter] = {one.name: one for one in _EXPORTERS}
