"""Exports of studies, and streams of a session, for other programs."""

from typing import TYPE_CHECKING

from hapticplayer.errors import Message

if TYPE_CHECKING:
    from hapticplayer.study.streams import StreamKind
    from hapticplayer.study.study_export import Exporter

_HERE = "hapticplayer.extras.research"


def study_exporters() -> "tuple[Exporter, ...]":
    """BIDS and XDF."""
    from hapticplayer.extras.research.bids import write_bids
    from hapticplayer.extras.research.xdf import write_xdf
    from hapticplayer.study.study_export import (
        ANSWERS,
        REST_OF_TICKS,
        TEXT_ANSWERS,
        Exporter,
    )

    bids = Message("BIDS (behaviour, and motion at 1 kHz)")
    xdf = Message("XDF, a file for each run")
    return (
        Exporter("bids", bids, write_bids, (TEXT_ANSWERS, REST_OF_TICKS)),
        Exporter("xdf", xdf, write_xdf, (ANSWERS, REST_OF_TICKS)),
    )


def study_streams() -> "tuple[StreamKind, ...]":
    """LSL."""
    from hapticplayer.study.streams import StreamKind

    return (StreamKind("lsl", f"{_HERE}.lsl:LslStreams"),)
