"""A study as tidy tables: a row for each observation, each column explained."""

import csv
import io
import json
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from hapticplayer.interchange.study_data import StudyData
from hapticplayer.study import private
from hapticplayer.study.answers import Answers
from hapticplayer.study.session_folder import StoredSession
from hapticplayer.study.steps import answered_trials


class Column(NamedTuple):
    """One column: its name, what it holds, and its unit or levels."""

    name: str
    meaning: str
    levels: str = ""


class Table(NamedTuple):
    """A table: name of the file, columns, rows."""

    name: str
    columns: Sequence[Column]
    rows: Sequence[Sequence[Any]]


_WHO = Column("participant", "code made by the program")
_WHERE = (Column("sequence", "what was played"), Column("feedback", "force condition"))
_SOUND = Column("sound", "whether the playback was without a fault", "true|false")
_PLAYED = (
    Column("media_s", "position reached", "s"),
    Column("pictures_shown", "pictures on the screen"),
    Column("pictures_dropped", "pictures that came too late"),
    Column("silence_s", "sound that was missing", "s"),
    Column("missed", "skipped periods of the 1 kHz force loop"),
    Column("ticks", "exchanges with the device"),
)
_TRIAL_COLUMNS = (
    _WHO,
    Column("position", "place in this participant's order, from 1"),
    Column("attempt", "1, or more where the trial was repeated"),
    *_WHERE,
    Column("delay_s", "by which the force came later than recorded", "s"),
    Column("gain", "of the force, 1 as recorded"),
    Column("repeat", "number of the repetition of this condition"),
    _SOUND,
    Column("reasons", "why it was not, separated by semicolons"),
    *_PLAYED,
    Column("response_s", "from the page of questions to its answer", "s"),
    Column("answers", "all answers as JSON"),
)


def write_csv(data: StudyData, folder: Path) -> None:
    """Write all tables that hold something, and what each column means.

    Texts that nobody reviewed are left out.
    """
    answers = data.answers
    made = [
        participants(answers),
        _ratings(answers),
        _judgements(answers),
        Table("trials.csv", _TRIAL_COLUMNS, list(_trial_rows(data.sessions))),
        _texts(answers),
    ]
    tables = [table for table in made if table.rows]
    for table in [*tables, _dictionary(tables)]:
        private.write_new(folder / table.name, separated(table))


def participants(answers: Answers) -> Table:
    """Return who took part."""
    columns = (
        _WHO,
        Column("age", "age of the participant", "years"),
        Column("gender", "as answered"),
        Column("handedness", "hand that writes"),
        Column("used_device_before", "knew such a device", "true|false"),
        Column("complete", "the session came to its end", "true|false"),
        Column("simulated", "made by the program, nobody sat there", "true|false"),
    )
    rows = [
        (
            *(p.code, p.age, p.gender, p.handedness, p.used_device_before),
            *(p.complete, p.simulated),
        )
        for p in answers.participants
    ]
    return Table("participants.csv", columns, rows)


def _ratings(answers: Answers) -> Table:
    columns = (
        _WHO,
        *_WHERE,
        Column("factor", "what was rated", "|".join(answers.factors)),
        Column(
            "value", "rating; empty where it is missing", "1 not at all to 5 totally"
        ),
        _SOUND,
    )
    rows = [
        (r.participant, r.sequence, r.feedback, r.factor, r.value, r.sound)
        for r in answers.ratings
    ]
    return Table("ratings.csv", columns, rows)


def _judgements(answers: Answers) -> Table:
    columns = (
        _WHO,
        _WHERE[0],
        Column("delay_s", "by which the force came later than recorded", "s"),
        Column("gain", "of the force, 1 as recorded"),
        Column("consistent", "felt as consistent with the picture", "true|false"),
        _SOUND,
    )
    rows = [
        (j.participant, j.sequence, j.delay_s, j.gain, j.consistent, j.sound)
        for j in answers.judgements
    ]
    return Table("judgements.csv", columns, rows)


def _texts(answers: Answers) -> Table:
    columns = (
        _WHO,
        Column("question", "key in the definition"),
        Column("feedback", "that it is about; empty where it is about all"),
        Column("text", "as written; a person has read it and let it pass"),
    )
    rows = [
        (a.participant, a.question, a.feedback, a.text)
        for a in answers.open_answers
        if a.reviewed
    ]
    return Table("texts.csv", columns, rows)


def _trial_rows(sessions: Iterable[StoredSession]) -> Iterator[Sequence[Any]]:
    """Yield a row for each answered attempt, also those that were repeated later."""
    for session in sessions:
        for trial in answered_trials(session.records):
            condition = trial.condition
            yield (
                session.code,
                trial.position,
                trial.attempt,
                condition.sequence,
                condition.feedback,
                condition.delay_s,
                condition.gain,
                condition.repeat,
                trial.sound,
                ";".join(trial.reasons),
                *(trial.playback.get(column.name) for column in _PLAYED),
                trial.response_s,
                json.dumps(dict(trial.values), sort_keys=True),
            )


def _dictionary(tables: Iterable[Table]) -> Table:
    """Return the data dictionary: what each column of each table means."""
    columns = (
        Column("file", "name of the table"),
        Column("column", "name of the column"),
        Column("meaning", "what it holds"),
        Column("unit_or_levels", "SI unit, or what values there are"),
    )
    rows = [(t.name, c.name, c.meaning, c.levels) for t in tables for c in t.columns]
    return Table("data_dictionary.csv", columns, rows)


def separated(table: Table, mark: str = ",", missing: str = "") -> bytes:
    """Return a table as text.

    Args:
        table: to be written.
        mark: between columns.
        missing: stands for what is not there.
    """
    out = io.StringIO()
    writer = csv.writer(out, delimiter=mark, lineterminator="\n")
    writer.writerow([column.name for column in table.columns])
    writer.writerows([_cell(value, missing) for value in row] for row in table.rows)
    return out.getvalue().encode()


def _cell(value: Any, missing: str) -> Any:
    if value is None or value == "":
        return missing
    return str(value).lower() if isinstance(value, bool) else value
