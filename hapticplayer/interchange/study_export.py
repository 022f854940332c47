"""A study for other programs: tidy CSV, BIDS or XDF, in a folder of its own.

Codes are the only thing that tells participants apart; no paths, no host names, no
text that nobody has reviewed.
"""

from pathlib import Path
from typing import Any

from hapticplayer.errors import StudyError, UsageError
from hapticplayer.interchange.bids import write_bids
from hapticplayer.interchange.session_data import (
    Marker,
    finite,
    markers_of,
    tick_chunks,
    tick_files,
)
from hapticplayer.interchange.study_tables import (
    dictionary_of,
    separated,
    tables_of,
)
from hapticplayer.interchange.xdf import XdfWriter, as_columns, channels_of
from hapticplayer.study import private
from hapticplayer.study.answers import Answers, collect_answers
from hapticplayer.study.session_folder import StoredSession
from hapticplayer.study.study_folder import Study

FORMATS = ("csv", "bids", "xdf")
_DEVICE, _MARKERS = 1, 2


def export_study(study: Study, target: Path, form: str) -> dict[str, Any]:
    """Write a study's data into a new folder, and say what is in it.

    Args:
        study: opened.
        target: folder that does not exist yet.
        form: "csv", "bids" or "xdf".

    Raises:
        UsageError: for another format.
        StudyError: when there are no answers, or it cannot be written; nothing is left then.
    """
    if form not in FORMATS:
        raise UsageError(
            "there is no format {name!r}; there is {known}",
            name=form,
            known=", ".join(FORMATS),
        )
    answers = collect_answers(study)
    if not answers.participants:
        raise StudyError(
            "has no answers yet", where=study.folder.name, remedy="run a participant"
        )
    known = {participant.code for participant in answers.participants}
    sessions = [s for s in study.sessions()[0] if s.code in known]
    remarks = list(answers.remarks)
    left_out = sum(not answer.reviewed for answer in answers.open_answers)
    if left_out:
        remarks.append(
            f"{left_out} answers in words were left out: nobody reviewed them"
        )
    with private.folder_written_aside(target.absolute()) as folder:
        if form == "bids":
            write_bids(study.definition, answers, sessions, folder, remarks)
        elif form == "xdf":
            for session in sessions:
                _write_xdf(session, folder, remarks)
        else:
            _write_csv(answers, sessions, folder)
    return {
        "format": form,
        "participants": len(answers.participants),
        "files": sorted(
            str(path.relative_to(target))
            for path in target.rglob("*")
            if path.is_file()
        ),
        "remarks": remarks,
    }


def _write_csv(answers: Answers, sessions: list[StoredSession], folder: Path) -> None:
    tables = tables_of(answers, sessions)
    for table in [*tables, dictionary_of(tables)]:
        private.write_new(folder / table.name, separated(table))


def _write_xdf(session: StoredSession, folder: Path, remarks: list[str]) -> None:
    """Write one file for each run: the device, and markers on the same clock."""
    markers = markers_of(session)
    if not tick_files(session):
        remarks.append(f"{session.code}: there is no record of a device, markers only")
        _write_markers_alone(folder / f"{session.code}_markers.xdf", markers)
    for number, path in enumerate(tick_files(session), 1):
        target = folder / f"{session.code}_run-{number}.xdf"
        private.write_new(target, b"")
        with target.open("wb") as out:
            writer = XdfWriter(out)
            span_s = _write_device(writer, path, remarks)
            if span_s is not None:
                inside = [
                    (marker.monotonic_s, marker.text)
                    for marker in markers
                    if span_s[0] - 1.0 <= marker.monotonic_s <= span_s[1] + 1.0
                ]
                _write_markers(writer, inside)
            private.sync_file(out)
        if span_s is None:
            target.unlink()


def _write_markers_alone(target: Path, markers: list[Marker]) -> None:
    private.write_new(target, b"")
    with target.open("wb") as out:
        told = [(marker.monotonic_s, marker.text) for marker in markers]
        _write_markers(XdfWriter(out), told)
        private.sync_file(out)


def _write_device(
    writer: XdfWriter, path: Path, remarks: list[str]
) -> tuple[float, float] | None:
    channels = [
        *channels_of(["PositionX", "PositionY", "PositionZ"], "Position", "meters"),
        *channels_of(["ForceX", "ForceY", "ForceZ"], "Force", "newton"),
        ("MediaTime", "Time", "seconds"),
        ("Time", "Time", "seconds"),  # readers that smooth the stamps keep this one
    ]
    writer.begin_stream(_DEVICE, "device", "MoCap", channels, 1000.0)
    first_s, last_s, count = None, 0.0, 0
    for ticks in tick_chunks(path, remarks):
        time_s = finite(ticks["monotonic_s"])
        values = as_columns(
            ticks["position_m"], ticks["force_n"], ticks["media_s"], time_s
        )
        writer.numbers(_DEVICE, time_s, values)
        first_s = float(time_s[0]) if first_s is None else first_s
        last_s, count = float(time_s[-1]), count + len(ticks)
    if first_s is None:
        return None
    writer.end_stream(_DEVICE, first_s, last_s, count)
    return first_s, last_s


def _write_markers(writer: XdfWriter, markers: list[tuple[float, str]]) -> None:
    channel = [("Marker", "Marker", "n/a")]
    writer.begin_stream(_MARKERS, "markers", "Markers", channel, 0.0, is_text=True)
    writer.texts(_MARKERS, markers)
    if markers:
        writer.end_stream(_MARKERS, markers[0][0], markers[-1][0], len(markers))
