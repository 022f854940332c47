"""XDF, the file format of LabRecorder: streams with time stamps in one file.

Source: the XDF 1.0 specification (sccn/xdf). A chunk is: bytes of its length field,
its length, a tag, its content; numbers are little-endian. The header of a file and of
a stream are XML.
"""

import struct
import uuid
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, BinaryIO
from xml.sax.saxutils import escape

import numpy as np
from numpy.typing import NDArray

from hapticplayer import storage
from hapticplayer.errors import Message
from hapticplayer.study.session_folder import StoredSession
from hapticplayer.study.study_data import (
    StudyData,
    markers_of,
)
from hapticplayer.study.ticks import tick_files

_FILE_HEADER, _STREAM_HEADER, _SAMPLES, _OFFSET, _FOOTER = 1, 2, 3, 4, 6
_WIDE = b"\x08"  # a length in eight bytes, a time stamp follows
_CHUNK_SAMPLES = 10_000
_DEVICE, _MARKERS = 1, 2  # numbers of the streams


class XdfWriter:
    """Writes one file; samples of a stream in order of time.

    Args:
        out: opened for writing in binary.
        name: of the file; the identifiers of its streams follow from it.
        created_s: when the recording began.
    """

    def __init__(self, out: BinaryIO, name: str, created_s: float) -> None:
        self._out, self._name, self._created_s = out, name, created_s
        out.write(b"XDF:")
        header = "<?xml version='1.0'?><info><version>1.0</version></info>"
        self._chunk(_FILE_HEADER, header.encode())

    def begin_stream(
        self,
        stream: int,
        name: str,
        kind: str,
        channels: Sequence[tuple[str, str, str]],
        rate_hz: float,
        *,
        is_text: bool = False,
    ) -> None:
        """Write the header of a stream, with the clock of the machine.

        Args:
            stream: number of the stream, 1 and up.
            name: of the stream.
            kind: content type, such as Markers or MoCap.
            channels: (label, type, unit) of each.
            rate_hz: nominal; 0 for irregular samples.
            is_text: one string per sample instead of float64 numbers.
        """
        listed = "".join(
            f"<channel><label>{escape(label)}</label><type>{escape(of)}</type>"
            f"<unit>{escape(unit)}</unit></channel>"
            for label, of, unit in channels
        )
        form = "string" if is_text else "double64"
        xml = (
            f"<?xml version='1.0'?><info><name>{escape(name)}</name>"
            f"<type>{escape(kind)}</type><channel_count>{len(channels)}</channel_count>"
            f"<nominal_srate>{rate_hz:g}</nominal_srate>"
            f"<channel_format>{form}</channel_format>"
            f"<source_id>hapticplayer-{escape(name)}</source_id>"
            f"{self._origin(stream)}"
            f"<desc><channels>{listed}</channels></desc></info>"
        )
        self._chunk(_STREAM_HEADER, struct.pack("<I", stream) + xml.encode())

    def _origin(self, stream: int) -> str:
        """The elements that LSL adds; readers expect them. No host is named."""
        uid = uuid.uuid5(uuid.NAMESPACE_OID, f"{self._name}/{stream}")
        texts = {
            "version": "1.1",
            "created_at": f"{self._created_s!r}",
            "uid": f"{uid}",
            "session_id": "default",
            "hostname": "n/a",
        }
        return "".join(f"<{name}>{text}</{name}>" for name, text in texts.items())

    def numbers(
        self, stream: int, time_s: NDArray[np.float64], values: NDArray[np.float64]
    ) -> None:
        """Write samples (N, channels) with their times (N,), s."""
        width = values.shape[1]
        row = np.dtype([("flag", "u1"), ("time", "<f8"), ("values", "<f8", (width,))])
        for begin in range(0, len(time_s), _CHUNK_SAMPLES):
            part = slice(begin, begin + _CHUNK_SAMPLES)
            rows = np.empty(len(time_s[part]), dtype=row)
            rows["flag"] = 8
            rows["time"], rows["values"] = time_s[part], values[part]
            self._samples(stream, len(rows), rows.tobytes())

    def texts(self, stream: int, samples: Iterable[tuple[float, str]]) -> None:
        """Write (time in s, text) samples of a stream with one channel."""
        parts = []
        for time_s, text in samples:
            content = text.encode(errors="replace")
            length = b"\x04" + struct.pack("<I", len(content))
            parts.append(_WIDE + struct.pack("<d", time_s) + length + content)
        if parts:
            self._samples(stream, len(parts), b"".join(parts))

    def end_stream(
        self, stream: int, first_s: float, last_s: float, count: int
    ) -> None:
        """Write the footer of a stream; its clock offset is zero."""
        offset = struct.pack("<Idd", stream, last_s, 0.0)
        self._chunk(_OFFSET, offset)
        xml = (
            "<?xml version='1.0'?><info>"
            f"<first_timestamp>{first_s!r}</first_timestamp>"
            f"<last_timestamp>{last_s!r}</last_timestamp>"
            f"<sample_count>{count}</sample_count><clock_offsets><offset>"
            f"<time>{last_s!r}</time><value>0.0</value></offset></clock_offsets></info>"
        )
        self._chunk(_FOOTER, struct.pack("<I", stream) + xml.encode())

    def _samples(self, stream: int, count: int, content: bytes) -> None:
        head = struct.pack("<I", stream) + b"\x04" + struct.pack("<I", count)
        self._chunk(_SAMPLES, head + content)

    def _chunk(self, tag: int, content: bytes) -> None:
        self._out.write(b"\x08" + struct.pack("<QH", len(content) + 2, tag))
        self._out.write(content)


def write_xdf(data: StudyData, folder: Path) -> None:
    """Write a file for each run of a session, or markers only without a device."""
    for session in data.sessions:
        _write_session(session, folder, data)


def _write_session(session: StoredSession, folder: Path, data: StudyData) -> None:
    """Write the files of a session, device and markers on the same clock."""
    markers = markers_of(session)
    created_s = session.records.intact[0].monotonic_s

    def writer_of(out: BinaryIO, target: Path) -> XdfWriter:
        return XdfWriter(out, f"{session.plan.study}/{target.name}", created_s)

    if not tick_files(session):
        what = Message("{code}: no record of a device, markers only", code=session.code)
        data.notices.append(what)
        target = folder / f"{session.code}_markers.xdf"
        with storage.private_writer(target) as out:
            samples = [(marker.monotonic_s, marker.text) for marker in markers]
            _write_markers(writer_of(out, target), samples, created_s)
    for number, path in enumerate(tick_files(session), 1):
        target = folder / f"{session.code}_run-{number}.xdf"
        with storage.private_writer(target) as out:
            writer = writer_of(out, target)
            span_s = _write_device(writer, data.ticks(session, path))
            if span_s is not None:
                inside = [
                    (marker.monotonic_s, marker.text)
                    for marker in markers
                    if span_s[0] - 1.0 <= marker.monotonic_s <= span_s[1] + 1.0
                ]
                _write_markers(writer, inside, created_s)
        if span_s is None:
            target.unlink()


def _write_device(
    writer: XdfWriter, chunks: Iterable[NDArray[Any]]
) -> tuple[float, float] | None:
    channels = [
        *_channels(["PositionX", "PositionY", "PositionZ"], "Position", "meters"),
        *_channels(["ForceX", "ForceY", "ForceZ"], "Force", "newton"),
        ("MediaTime", "Time", "seconds"),
        (
            "Time",
            "Time",
            "seconds",
        ),  # some readers smooth the time stamps of the stream
    ]
    writer.begin_stream(_DEVICE, "device", "MoCap", channels, 1000.0)
    first_s, last_s, count = None, 0.0, 0
    for ticks in chunks:
        time_s = np.asarray(ticks["monotonic_s"], np.float64)
        values = _columns(
            ticks["position_m"], ticks["force_n"], ticks["media_s"], time_s
        )
        writer.numbers(_DEVICE, time_s, values)
        first_s = float(time_s[0]) if first_s is None else first_s
        last_s, count = float(time_s[-1]), count + len(ticks)
    if first_s is None:
        return None
    writer.end_stream(_DEVICE, first_s, last_s, count)
    return first_s, last_s


def _write_markers(
    writer: XdfWriter, markers: list[tuple[float, str]], created_s: float
) -> None:
    """Write a stream of texts; an empty one has a footer, too: readers expect it."""
    channel = [("Marker", "Marker", "n/a")]
    writer.begin_stream(_MARKERS, "markers", "Markers", channel, 0.0, is_text=True)
    writer.texts(_MARKERS, markers)
    first_s, last_s = (markers[0][0], markers[-1][0]) if markers else (created_s,) * 2
    writer.end_stream(_MARKERS, first_s, last_s, len(markers))


def _channels(names: Sequence[str], kind: str, unit: str) -> list[tuple[str, str, str]]:
    """Return the description of channels that share kind and unit."""
    return [(name, kind, unit) for name in names]


def _columns(*columns: Any) -> NDArray[np.float64]:
    """Return (N, channels) of vectors (N,) and matrices (N, k) side by side."""
    parts = [np.atleast_2d(np.asarray(c, dtype=np.float64).T).T for c in columns]
    return np.concatenate(parts, axis=1)
