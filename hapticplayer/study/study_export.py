"""Export of a study into a new folder.

Exports identify participants by their codes only; they contain no paths, no host names
and no texts that have not been reviewed.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from hapticplayer import extension, storage
from hapticplayer.errors import Message, Progress, StudyError, entry_named, joined
from hapticplayer.study.answers import collect_answers
from hapticplayer.study.study_csv import write_csv, write_csv_for_excel
from hapticplayer.study.study_data import StudyData
from hapticplayer.study.study_folder import Study


@dataclass(frozen=True, slots=True)
class Exporter:
    """A format of `study export`.

    Attributes:
        name: of `--format`.
        text: description for people, translated in the window.
        write: fills an empty folder.
        left_out: what a study has that the format does not hold.
    """

    name: str
    text: str
    write: Callable[[StudyData, Path], None]
    left_out: tuple[Message, ...] = ()


_DEVICE_LEFT_OUT = (
    Message("each tick of the device"),
    Message("when each trial and interruption was"),
)
ANSWERS, TEXT_ANSWERS = Message("answers"), Message("text answers")
REST_OF_TICKS = Message("planned force, velocity, buttons and timing of each tick")

EXPORTERS = (
    Exporter(
        "csv",
        Message("tidy CSV with a data dictionary"),
        write_csv,
        _DEVICE_LEFT_OUT,
    ),
    Exporter(
        "excel",
        Message("CSV for Excel (UTF-8 with a byte order mark)"),
        write_csv_for_excel,
        _DEVICE_LEFT_OUT,
    ),
)
"""Those of the core."""


def study_exporters() -> dict[str, Exporter]:
    found = extension.rows("study_exporters", Exporter, EXPORTERS)
    return {one.name: one for one in found}


def export_study(
    study: Study,
    target: Path,
    form: str,
    progress: Progress = lambda _fraction, _step: None,
) -> dict[str, Any]:
    """Export a study into a new folder, and return a report.

    Args:
        study: opened.
        target: folder, must not exist yet.
        form: name of an exporter.
        progress: called with the fraction done and the step; raises to cancel.
    """
    exporter = entry_named(study_exporters(), form, Message("format"))
    answers = collect_answers(study)
    if not answers.participants:
        raise StudyError(
            "has no answers yet", where=study.folder.name, remedy="run a participant"
        )
    known = {participant.code for participant in answers.participants}
    sessions = [s for s in study.sessions()[0] if s.code in known]
    notices: list[str] = list(answers.notices)
    left_out = sum(not answer.reviewed for answer in answers.open_answers)
    if left_out:
        notices.append(
            Message(
                "{count} text answers were left out: they have not been reviewed",
                count=left_out,
            )
        )
    with storage.folder_written_aside(
        target.absolute(), storage.PRIVATE_FOLDER
    ) as folder:
        data = StudyData(study.definition, answers, sessions, notices, progress)
        exporter.write(data, folder)
    what = joined(", ", exporter.left_out)
    return {
        "format": form,
        "left_out": Message("left out: {what}", what=what) if what else "",
        "participants": len(answers.participants),
        "files": sorted(
            str(path.relative_to(target))
            for path in target.rglob("*")
            if path.is_file()
        ),
        "remarks": notices,
    }
