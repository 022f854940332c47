"""A study as tidy CSV tables, with a data dictionary."""

import codecs
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from hapticplayer import storage
from hapticplayer.study.answers import Answers
from hapticplayer.study.data_table import (
    DataColumn,
    DataTable,
    guarded,
    separated,
)
from hapticplayer.study.definition import (
    OF_TRIALS,
    Definition,
    Question,
    QuestionKind,
    QuestionPage,
    When,
)
from hapticplayer.study.intervals import played_as
from hapticplayer.study.questions import AnswerColumn, kind_of, range_of
from hapticplayer.study.scoring import PageScores, Scoring, formula_of
from hapticplayer.study.session_folder import StoredSession
from hapticplayer.study.steps import AnsweredTrial, answered_trials
from hapticplayer.study.study_data import StudyData
from hapticplayer.study.trial_force import LEAST_FORCE_N, MOST_ERROR, TrialForce

if TYPE_CHECKING:
    from hapticplayer.study.live_ratings import RatingTrack


_WHO = DataColumn("participant", "code of the participant")
_WHERE = (
    DataColumn("sequence", "key of the sequence"),
    DataColumn("feedback", "key of the force condition"),
)
_IS_VALID = DataColumn("is_valid", "whether the playback was valid", "true|false")
_PLAYED = (
    DataColumn("media_s", "position reached", "s"),
    DataColumn("frames_shown", "frames shown"),
    DataColumn("frames_dropped", "frames dropped"),
    DataColumn("silence_s", "audio dropouts", "s"),
    DataColumn("missed", "missed periods of the 1 kHz haptic loop"),
    DataColumn("ticks", "exchanges with the device"),
)
FELT = (
    DataColumn(
        "force_error",
        "force sent less planned, RMS weighted by frequency, as a share of the planned force; empty where none was planned",
        "1",
    ),
    DataColumn("force_error_n", "the same difference in newtons", "N"),
    DataColumn("force_planned_n", "planned force, RMS weighted by frequency", "N"),
    DataColumn("reach_m", "largest distance of the grip from the centre", "m"),
    DataColumn(
        "faded_s",
        "time with less force than planned: entry, ramps, stops, fade at the edge of the workspace",
        "s",
    ),
    DataColumn(
        "saturated_share",
        "share of the time in which the force cap took something",
        "0 to 1",
    ),
    DataColumn(
        "force_is_off",
        f"force_error_n is above {LEAST_FORCE_N} N and above {MOST_ERROR} of force_planned_n",
        "true|false",
    ),
)
"""What the hand got in a trial, from the record of the device; empty without one."""


def trial_force_cells(force: TrialForce | None) -> tuple[Any, ...]:
    """Return the values of FELT."""
    if force is None:
        return (None,) * len(FELT)
    numbers = (
        *(force.error, force.error_n, force.planned_n),
        *(force.reach_m, force.faded_s, force.saturated_share),
    )
    cells = (None if one is None else float(f"{one:.4g}") for one in numbers)
    return (*cells, force.is_off)


INTERVAL = DataColumn(
    "interval", "which of two clips had this force, the other one the standard", "1|2"
)
_TRIAL_COLUMNS = (
    _WHO,
    DataColumn("position", "place in this participant's order, from 1"),
    DataColumn("attempt", "from 1; more if the trial was repeated"),
    *_WHERE,
    DataColumn("delay_s", "delay of the force", "s"),
    DataColumn("gain", "of the force, 1 as recorded"),
    DataColumn("repeat", "number of the repetition of this condition"),
    INTERVAL,
    _IS_VALID,
    DataColumn("reasons", "why the playback was not valid, separated by semicolons"),
    *_PLAYED,
    DataColumn("response_s", "from the questions to the answer", "s"),
    *FELT,
)


def factor_columns(
    definition: Definition, taken: Iterable[DataColumn]
) -> list[DataColumn]:
    """The factors in which the sequences differ; another name where one is taken."""
    names = {column.name for column in taken}
    return [
        DataColumn(
            f"sequence_{name}" if name in names else name,
            f"{name} of the sequence",
            "|".join(dict.fromkeys(levels)),
        )
        for name, levels in definition.sequence_factors.items()
    ]


class GivenColumn(NamedTuple):
    """A column of answers, of the question or score with this name, or of a part of it."""

    column: DataColumn
    name: str
    part: AnswerColumn

    def cell(self, values: Mapping[str, Any]) -> Any:
        """The cell for the answers of somebody, by name."""
        return self.part.cell(values.get(self.name))


def answer_columns(
    definition: Definition, *when: When, taken: Iterable[DataColumn]
) -> list[GivenColumn]:
    """The columns of the answers to the questions of some pages.

    Args:
        definition: of the study.
        when: the pages are shown.
        taken: other columns of the table, whose names no question gets.
    """
    names = {column.name for column in taken}
    found = []
    for page in (page for at in when for page in definition.pages_at(at)):
        given = [
            *(one for asked in page.questions for one in _of(definition, asked)),
            *_score_columns(page),
        ]
        for one in given:
            column = one.column
            if column.name in names:
                column = column._replace(name=f"answer_{column.name}")
            found.append(one._replace(column=column))
    return found


def _of(definition: Definition, asked: Question) -> Iterator[GivenColumn]:
    feedbacks = definition.feedback_keys if asked.for_each_feedback else ("",)
    for feedback in feedbacks:
        name = f"{asked.key}@{feedback}" if feedback else asked.key
        for part in kind_of(asked).columns:
            column = _answer_column(definition, asked, name, part)
            yield GivenColumn(column, name, part)


def _score_columns(page: QuestionPage) -> Iterator[GivenColumn]:
    limits = PageScores(page).limits
    for score in page.scores:
        meaning = f"{score.text}: {formula_of(score)}"
        levels = "from {:g} to {:g}".format(*limits[score.key])
        column = DataColumn(score.key, meaning, levels)
        yield GivenColumn(column, score.key, AnswerColumn())


def _answer_column(
    definition: Definition, asked: Question, name: str, part: AnswerColumn
) -> DataColumn:
    language = definition.languages[0]
    meaning = definition.wording(asked, language)
    if part.of:
        option = next(one for one in asked.choices if one.key == part.of)
        meaning += f" \u2013 {option.text[language]}"
    texts = {
        level: text.get(language) or {"true": "yes", "false": "no"}[level]
        for level, text in (part.levels or {}).items()
    }
    levels = "|".join(texts)
    if (limits := range_of(asked)) is not None:
        labelled = ", ".join(f"{level}: {text}" for level, text in texts.items())
        levels = f"from {limits[0]} to {limits[1]} {part.unit}".strip()
        levels += f" ({labelled})" * bool(labelled)
        is_scale = asked.kind in (QuestionKind.SCALE, QuestionKind.PAIR)
        points = map(str, range(limits[0], limits[1] + 1)) if is_scale else ()
        texts = {point: texts.get(point, point) for point in points}
    return DataColumn(f"{name}{part.suffix}", meaning, levels, texts)


def write_csv(data: StudyData, folder: Path) -> None:
    """Write all tables that are not empty, and the data dictionary.

    Texts that have not been reviewed are left out.
    """
    for name, content in _files(data):
        storage.write_private(folder / name, content)


def write_csv_for_excel(data: StudyData, folder: Path) -> None:
    """Write the same with the mark by which Excel knows UTF-8."""
    for name, content in _files(data):
        storage.write_private(folder / name, codecs.BOM_UTF8 + content)


def _files(data: StudyData) -> Iterator[tuple[str, bytes]]:
    answers = data.answers
    made = [
        participants(data),
        _ratings(data),
        _judgements(answers),
        _trials(data),
        _while_watching(data),
        _texts(answers),
    ]
    tables = [table for table in made if table.rows]
    for table in [*tables, _dictionary(tables, answers.conduct.feedbacks)]:
        rows = [[guarded(value) for value in row] for row in table.rows]
        yield table.name, separated(table._replace(rows=rows))


def participants(data: StudyData) -> DataTable:
    """Return the table of participants, with their answers before and after the clips."""
    own = (
        DataColumn("complete", "the session was completed", "true|false"),
        DataColumn("simulated", "simulated participant (not the device)", "true|false"),
        DataColumn("site", "where the session took place; empty if that was not said"),
    )
    given = answer_columns(data.definition, When.BEFORE, When.AFTER, taken=(_WHO, *own))
    rows = [
        (
            p.code,
            *(one.cell(p.values) for one in given),
            p.complete,
            p.simulated,
            p.site,
        )
        for p in data.answers.participants
    ]
    columns = (_WHO, *(one.column for one in given), *own)
    return DataTable("participants.csv", columns, rows)


def _ratings(data: StudyData) -> DataTable:
    answers = data.answers
    given = answer_columns(data.definition, When.AFTER_CLIP, taken=())
    scales = "|".join(
        f"{one.name}: {one.column.levels}"
        for one in given
        if one.name in answers.factors
    )
    columns = (
        _WHO,
        *_WHERE,
        DataColumn("factor", "what was rated", "|".join(answers.factors)),
        DataColumn("value", "rating; empty where it is missing", scales),
        _IS_VALID,
    )
    levels_of = data.definition.levels_of
    rows = [
        (
            *(r.participant, r.sequence, r.feedback, r.factor, r.value, r.is_valid),
            *levels_of(r.sequence),
        )
        for r in answers.ratings
    ]
    whole = (*columns, *factor_columns(data.definition, columns))
    return DataTable("ratings.csv", whole, rows)


def _judgements(answers: Answers) -> DataTable:
    columns = (
        _WHO,
        DataColumn("position", "place in this participant's order; 0: not played"),
        *_WHERE,
        DataColumn("delay_s", "delay of the force", "s"),
        DataColumn("gain", "of the force, 1 as recorded"),
        DataColumn(
            "answer",
            "to the question that is analysed; of two clips: whether this force was "
            "chosen, and not the standard",
            "true|false, or a number",
        ),
        _IS_VALID,
    )
    rows = [
        (
            *(j.participant, j.position, j.sequence, j.feedback),
            *(j.delay_s, j.gain, j.answer, j.is_valid),
        )
        for j in answers.judgements
    ]
    return DataTable("judgements.csv", columns, rows)


def _while_watching(data: StudyData) -> DataTable:
    columns = (
        _WHO,
        DataColumn("position", "place in this participant's order, from 1"),
        DataColumn("attempt", "from 1; more if the trial was repeated"),
        *_WHERE,
        DataColumn("rating", "key of the rating"),
        DataColumn("media_s", "of the clip", "s"),
        DataColumn(
            "value",
            "of the slider or number, 1 while the key was held; empty where a number was "
            "asked for",
        ),
    )
    if not data.definition.while_watching:
        return DataTable("while_watching.csv", columns, [])
    rows = [
        (*of, round(media_s, 4), None if math.isnan(value) else value)
        for session in data.sessions
        for track in data.ratings(session)
        for of in [_of_track(session.code, track)]
        for media_s, value in zip(
            track.media_s.tolist(), track.value.tolist(), strict=True
        )
    ]
    return DataTable("while_watching.csv", columns, rows)


def _of_track(code: str, track: "RatingTrack") -> tuple[Any, ...]:
    condition = track.condition
    where = condition.sequence, condition.feedback
    return (code, track.position, track.attempt, *where, track.rating.key)


def rating_columns(definition: Definition) -> list[DataColumn]:
    """The figures of what was rated while the clip played, in a row for each trial."""
    if not definition.while_watching:
        return []
    from hapticplayer.study.live_ratings import FIGURES

    language = definition.languages[0]
    return [
        DataColumn(f"{one.key}.{name}", f"{one.text[language]}: {meaning}", unit)
        for one in definition.while_watching
        for name, (_, meaning, unit) in FIGURES[one.kind].items()
    ]


def rating_cells(
    data: StudyData, session: StoredSession
) -> Callable[[AnsweredTrial], tuple[Any, ...]]:
    """What gives the values of `rating_columns` of a trial of a session."""
    ratings = data.definition.while_watching
    if not ratings:
        return lambda _trial: ()
    from hapticplayer.study.live_ratings import FIGURES

    tracks = {
        (one.position, one.attempt, one.rating.key): one
        for one in data.ratings(session)
    }

    def cells(trial: AnsweredTrial) -> tuple[Any, ...]:
        of = trial.position, trial.attempt
        found = [(one, tracks.get((*of, one.key))) for one in ratings]
        values = [
            figure(track) if track is not None else None
            for one, track in found
            for figure, _, _ in FIGURES[one.kind].values()
        ]
        return tuple(None if one is None else float(f"{one:.6g}") for one in values)

    return cells


def _texts(answers: Answers) -> DataTable:
    columns = (
        _WHO,
        DataColumn("question", "key in the definition"),
        DataColumn("sequence", "key of the sequence that it is about; empty for all"),
        DataColumn("feedback", "subject of the question; empty for all"),
        DataColumn("position", "of the trial that it is about; empty for all"),
        DataColumn(
            "text",
            "as written, reviewed by a person; an apostrophe is put before = + - @ at "
            "the beginning of the text, a line or what follows a semicolon or tab, which "
            "spreadsheets would take for a formula",
        ),
    )
    rows = [
        (a.participant, a.question, a.sequence, a.feedback, a.trial, a.text)
        for a in answers.open_answers
        if a.reviewed
    ]
    return DataTable("texts.csv", columns, rows)


def _trials(data: StudyData) -> DataTable:
    own = (*_TRIAL_COLUMNS, *factor_columns(data.definition, _TRIAL_COLUMNS))
    given = answer_columns(data.definition, *OF_TRIALS, taken=own)
    rated = rating_columns(data.definition)
    columns = (*own, *(one.column for one in given), *rated)
    return DataTable("trials.csv", columns, list(_trial_rows(data, given)))


def _trial_rows(
    data: StudyData, given: Sequence[GivenColumn]
) -> Iterator[Sequence[Any]]:
    """Yield a row for each answered attempt, including repeated ones."""
    scoring = Scoring(data.definition, *OF_TRIALS)
    for session in data.sessions:
        forces, rated = data.trial_forces(session), rating_cells(data, session)
        for trial in answered_trials(session.records):
            condition, values = trial.condition, scoring.completed(trial.values)
            force, interval = played_as(data.definition, trial)
            yield (
                session.code,
                trial.position,
                trial.attempt,
                condition.sequence,
                condition.feedback,
                force.delay_s,
                force.gain,
                condition.repeat,
                interval,
                trial.is_valid,
                ";".join(trial.reasons),
                *(trial.playback.get(column.name) for column in _PLAYED),
                trial.response_s,
                *trial_force_cells(forces.get((trial.position, trial.attempt))),
                *data.definition.levels_of(condition.sequence),
                *(one.cell(values) for one in given),
                *rated(trial),
            )


def _dictionary(tables: Iterable[DataTable], feedbacks: Mapping[str, str]) -> DataTable:
    """Return the data dictionary: the meaning of each column."""
    meanings = {
        "feedback": "|".join(f"{key}: {text}" for key, text in feedbacks.items())
    }
    columns = (
        DataColumn("file", "name of the table"),
        DataColumn("column", "name of the column"),
        DataColumn("meaning", "meaning of the column"),
        DataColumn("unit_or_levels", "SI unit, or the possible values"),
    )
    rows = [
        (t.name, c.name, c.meaning, c.levels or meanings.get(c.name, ""))
        for t in tables
        for c in t.columns
    ]
    return DataTable("data_dictionary.csv", columns, rows)
