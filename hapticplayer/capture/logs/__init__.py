"""Logs of loggers and phones: one module for each format, told by content.

To add a format: a module with `FORMAT`, listed in `registry.FORMATS`.
"""

from hapticplayer.capture.logs.assemble import LogReading
from hapticplayer.capture.logs.choices import (
    LogChoices,
    LogQuestion,
    parse_choices,
    write_template,
)
from hapticplayer.capture.logs.registry import FORMATS, find_format, read_log
from hapticplayer.capture.logs.source import Source, open_source

__all__ = [
    "FORMATS",
    "LogChoices",
    "LogQuestion",
    "LogReading",
    "Source",
    "find_format",
    "open_source",
    "parse_choices",
    "read_log",
    "write_template",
]
