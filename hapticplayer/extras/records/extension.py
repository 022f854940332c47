"""Formats of `export RECORD`."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.cli.export import RecordExporter


def record_exporters() -> "tuple[RecordExporter, ...]":
    """CSV."""
    from hapticplayer.cli.export import RecordExporter
    from hapticplayer.extras.records.record_csv import is_csv, write_csv

    text = "a line per tick with the units in the names"
    return (RecordExporter("csv", text, write_csv, is_csv),)
