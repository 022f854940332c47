"""What records of the haptic loop can be exported as, one line for each format."""

from collections.abc import Callable
from typing import Any, BinaryIO, NamedTuple

from hapticplayer.haptics.record_reader import RecordReader
from hapticplayer.interchange.record_csv import write_csv
from hapticplayer.sequence.files import Progress


class RecordExporter(NamedTuple):
    """A format.

    Attributes:
        name: for `export --format`.
        text: for people.
        write: writes all intact ticks of a record, and returns what to report of them.
    """

    name: str
    text: str
    write: Callable[[RecordReader, BinaryIO, Progress], dict[str, Any]]


_EXPORTERS = (
    RecordExporter("csv", "a line per tick with the units in the names", write_csv),
)
RECORD_EXPORTERS: dict[str, RecordExporter] = {one.name: one for one in _EXPORTERS}
