"""A study as a BIDS dataset: answers (beh), and the device at 1 kHz (motion).

Source: BIDS specification 1.10, behavioural and motion data. BIDS has no type for
force: it is MISC with the unit N.
"""

import datetime as dt
from collections.abc import Iterator, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from hapticplayer import __version__, storage
from hapticplayer.extras.research.bids_ratings import (
    RECORDING,
    physio_tables,
    write_physio,
)
from hapticplayer.haptics.record_reader import RecordReader
from hapticplayer.storage import json_text
from hapticplayer.study.answers import simulated_mark
from hapticplayer.study.data_table import DataColumn, DataTable, separated
from hapticplayer.study.definition import OF_TRIALS, Definition, When
from hapticplayer.study.intervals import played_as
from hapticplayer.study.scoring import Scoring
from hapticplayer.study.session_folder import StoredSession
from hapticplayer.study.steps import AnsweredTrial, answered_trials
from hapticplayer.study.study_csv import (
    FELT,
    INTERVAL,
    GivenColumn,
    answer_columns,
    factor_columns,
    participants,
    trial_force_cells,
)
from hapticplayer.study.study_data import (
    StudyData,
    markers_of,
)
from hapticplayer.study.ticks import tick_files
from hapticplayer.study.trial_force import TrialForce

VERSION = "1.10.0"
TASK, SYSTEM, RATE_HZ = "qoe", "falcon", 1000
_BEH = (
    DataColumn("trial_index", "place in this participant's order, from 1"),
    DataColumn("attempt", "from 1; more if the trial was repeated"),
    DataColumn("sequence", "key of the sequence"),
    DataColumn("feedback", "force condition"),
    DataColumn("delay_s", "delay of the force"),
    DataColumn("gain", "of the force, 1 as recorded"),
    INTERVAL,
    DataColumn("is_valid", "whether the playback was valid"),
    *FELT,
    DataColumn("response_time", "from the questions to the answer"),
)
_CHANNELS = (
    # name, component, type, unit, decimals
    ("latency", "n/a", "LATENCY", "s", 6),
    ("media", "n/a", "MISC", "s", 4),
    *[(f"grip_{axis}", axis, "POS", "m", 6) for axis in "xyz"],
    *[(f"force_{axis}", axis, "MISC", "N", 4) for axis in "xyz"],
)
_KINDS = (
    *("ACCEL", "ANGACCEL", "GYRO", "JNTANG", "LATENCY"),
    *("MAGN", "MISC", "ORNT", "POS", "VEL"),
)
_TABLES = {
    "participants.tsv": "a row for each participant",
    "sub-*/beh/*_beh.tsv": "answers of each trial",
    "sub-*/beh/*_physio.tsv.gz": "what was rated while clips played, 50 rows a second from "
    "the first clip to the last; StartTime is 0, and the scans table says when each begins",
    "sub-*/motion/*_motion.tsv": "the haptic device in the participant's hand at "
    "1 kHz, in the frame of the device: x right, y up, z towards the participant; "
    "force_x to force_z is the force that was sent (type MISC, BIDS has no type for "
    "force), media the position in the clip",
    "sub-*/motion/*_channels.tsv": "columns of the motion table",
    "sub-*/motion/*_events.tsv": "start and end of each trial, with its condition, and "
    "interruptions",
    "sub-*/*_scans.tsv": "when each motion table begins after the first one, which begins "
    "at 1925-01-01T00:00:00, so that neither date nor hour tells who took part",
}
_MAKERS = {"falcon": ("Novint", "Falcon")}
_FIRST = dt.datetime(1925, 1, 1, tzinfo=dt.UTC)
"""Dates that are shifted lie in 1925 or before, says BIDS."""

_AT_ONCE = dt.timedelta()

# the end of a run is marked shortly after its last tick
_MARKED_WITHIN_S = 1.0


def write_bids(data: StudyData, folder: Path) -> None:
    """Write a dataset into an empty folder."""
    definition = data.definition
    _json(folder / "dataset_description.json", _dataset(definition))
    _participants(data, folder)
    _json(folder / f"task-{TASK}_beh.json", _beh_sidecar(definition))
    for session in data.sessions:
        _subject(session, data, folder / f"sub-{session.code}")
    if any(folder.rglob("*_events.tsv")):  # a sidecar without data is an error
        _json(folder / f"task-{TASK}_events.json", _events_sidecar())
    storage.write_private(folder / "README", _readme(data, folder))


def _dataset(definition: Definition) -> dict[str, Any]:
    return {
        "Name": definition.title,
        "BIDSVersion": VERSION,
        "DatasetType": "raw",
        "GeneratedBy": [{"Name": "hapticplayer", "Version": __version__}],
    }


def _readme(data: StudyData, folder: Path) -> bytes:
    """Return a description of the tables that are in the folder."""
    definition = data.definition
    mark = simulated_mark(data.answers.participants)
    mark = mark and f"{mark.capitalize()}: no person gave these answers.\n\n"
    tables = [
        f"- {pattern}: {text}\n"
        for pattern, text in _TABLES.items()
        if any(folder.glob(pattern))
    ]
    text = (
        f"{definition.title}\n\n"
        f"{mark}"
        "Participants watched clips and answered questions after each. Codes were made "
        "by the program.\n\n"
        f"{''.join(tables)}\n"
        f"{definition.texts.retention[definition.languages[0]]}\n"
    )
    return text.encode(errors="replace")


def _participants(data: StudyData, folder: Path) -> None:
    """Write the participants, as in the CSV export."""
    name, columns, rows = participants(data)
    first, *others = columns
    table = DataTable(
        name,
        (DataColumn("participant_id", first.meaning), *others),
        [(f"sub-{code}", *values) for code, *values in rows],
    )
    _table(folder / "participants.tsv", table)
    sidecar = {column.name: _described(column) for column in others}
    definition = data.definition
    asked = answer_columns(definition, When.BEFORE, When.AFTER, taken=others[-2:])
    sidecar |= {one.column.name: _asked(one) for one in asked}
    _json(folder / "participants.json", sidecar)


def _described(column: DataColumn) -> dict[str, Any]:
    made: dict[str, Any] = {"Description": column.meaning}
    if column.levels == "true|false":
        made["Levels"] = {"true": "yes", "false": "no"}
    return made


def _asked(given: GivenColumn) -> dict[str, Any]:
    """The description of a column of answers."""
    made: dict[str, Any] = {"LongName": given.name, "Description": given.column.meaning}
    if given.column.texts:
        made["Levels"] = dict(given.column.texts)
    if given.column.levels != "|".join(given.column.texts):
        made["Description"] += f" ({given.column.levels})"
    if given.part.unit:
        made["Units"] = given.part.unit
    return made


def _task(definition: Definition) -> dict[str, Any]:
    """Return the description of the task."""
    language = definition.languages[0]
    return {
        "TaskName": TASK,
        "TaskDescription": "watching clips with a haptic device in the hand, and "
        "answering questions after each",
        "Instructions": definition.texts.consent[language],
    }


def _events_sidecar() -> dict[str, Any]:
    return {
        "trial_type": {"Description": "what happened; in a trial, and its condition"},
        "StimulusPresentation": {
            "SoftwareName": "hapticplayer",
            "SoftwareVersion": __version__,
        },
    }


def _beh_sidecar(definition: Definition) -> dict[str, Any]:
    made = _task(definition)
    for column in _BEH:
        made[column.name] = {"Description": column.meaning}
    for name in ("delay_s", "response_time"):
        made[name]["Units"] = "s"
    for column in FELT:
        if column.levels in ("N", "m", "s"):
            made[column.name]["Units"] = column.levels
    made["feedback"]["Levels"] = {
        one.name: one.text for one in definition.chosen_feedbacks
    }
    own = _beh_columns(definition)
    for column in own[len(_BEH) :]:
        levels = {level: level for level in column.levels.split("|")}
        made[column.name] = {"Description": column.meaning, "Levels": levels}
    for one in answer_columns(definition, *OF_TRIALS, taken=own):
        made[one.column.name] = _asked(one)
    return made


def _beh_columns(definition: Definition) -> tuple[DataColumn, ...]:
    return (*_BEH, *factor_columns(definition, _BEH))


def _subject(session: StoredSession, data: StudyData, folder: Path) -> None:
    name = folder.name
    behaviour = folder / "beh"
    folder.mkdir(mode=storage.PRIVATE_FOLDER)
    behaviour.mkdir(mode=storage.PRIVATE_FOLDER)
    own = _beh_columns(data.definition)
    given = answer_columns(data.definition, *OF_TRIALS, taken=own)
    columns = [*own, *(one.column for one in given)]
    forces = data.trial_forces(session)
    scoring = Scoring(data.definition, *OF_TRIALS)
    rows = [
        (
            *_beh_row(
                data.definition, trial, forces.get((trial.position, trial.attempt))
            ),
            *data.definition.levels_of(trial.condition.sequence),
            *(one.cell(scoring.completed(trial.values)) for one in given),
        )
        for trial in answered_trials(session.records)
    ]
    table = DataTable(f"{name}_task-{TASK}_beh.tsv", columns, rows)
    _table(behaviour / table.name, table)
    scans: dict[str, tuple[float, dt.datetime]] = {}
    if data.definition.while_watching:
        scans |= _physio(session, data, behaviour)
    for number, path in enumerate(tick_files(session), 1):
        base = f"{name}_task-{TASK}_tracksys-{SYSTEM}_run-{number}"
        span_s = _motion(session, path, folder / "motion" / base, data)
        if span_s is not None:
            _events(session, span_s, folder / "motion" / f"{base}_events.tsv")
            begun = span_s[0], _utc(session, span_s[0])
            scans[f"motion/{base}_motion.tsv"] = begun
    if scans:
        scans = dict(sorted(scans.items(), key=lambda one: one[1][1]))
        begins = begins_of(list(scans.values()))
        rows = [
            (table, at.strftime("%Y-%m-%dT%H:%M:%S.%fZ"))
            for table, at in zip(scans, begins, strict=True)
        ]
        _rows(folder / f"{name}_scans.tsv", ("filename", "acq_time"), rows)


def _physio(
    session: StoredSession, data: StudyData, folder: Path
) -> dict[str, tuple[float, dt.datetime]]:
    """Write what was rated while clips played; when each table begins, by its name."""
    scans = {}
    for run, made in enumerate(physio_tables(session, data.ratings(session)), 1):
        name = f"sub-{session.code}_task-{TASK}_run-{run}_recording-{RECORDING}"
        write_physio(folder / name, made)
        begun = made.begin_s, _utc(session, made.begin_s)
        scans[f"beh/{name}_physio.tsv.gz"] = begun
    return scans


def begins_of(runs: Sequence[tuple[float, dt.datetime]]) -> Iterator[dt.datetime]:
    """Yield when runs begin after the first one, which begins at `_FIRST`.

    By the monotonic clock, as the other one may be put back; by that one where the
    machine was started in between.

    Args:
        runs: monotonic time, s, and UTC of their begins.
    """
    at = _FIRST
    for (before_s, before), (now_s, now) in pairwise([runs[0], *runs]):
        later = dt.timedelta(seconds=now_s - before_s)
        at += later if later >= _AT_ONCE else max(now - before, _AT_ONCE)
        yield at


def _beh_row(
    definition: Definition, trial: AnsweredTrial, force: TrialForce | None
) -> tuple[Any, ...]:
    condition, (played, interval) = trial.condition, played_as(definition, trial)
    return (
        trial.position,
        trial.attempt,
        condition.sequence,
        condition.feedback,
        played.delay_s,
        played.gain,
        interval,
        trial.is_valid,
        *trial_force_cells(force),
        trial.response_s,
    )


def _motion(
    session: StoredSession, path: Path, base: Path, data: StudyData
) -> tuple[float, float] | None:
    """Write the ticks of one run; return the monotonic times of first and last."""
    begun_s: float | None = None
    count, last_s = 0, 0.0
    base.parent.mkdir(mode=storage.PRIVATE_FOLDER, exist_ok=True)
    table = base.with_name(f"{base.name}_motion.tsv")
    with storage.private_writer(table) as out:
        for ticks in data.ticks(session, path):
            time_s = np.asarray(ticks["monotonic_s"], np.float64)
            begun_s = float(time_s[0]) if begun_s is None else begun_s
            out.write(_motion_lines(ticks, begun_s))
            count, last_s = count + len(ticks), float(time_s[-1]) - begun_s
    if begun_s is None or count < 2:
        table.unlink()
        return None
    _describe_channels(base)
    timing = {
        "SamplingFrequency": RATE_HZ,
        "SamplingFrequencyEffective": round((count - 1) / max(last_s, 1e-9), 4),
        "RecordingDuration": round(last_s, 6),
        "RecordingType": "continuous",
    }
    sidecar = {**_task(data.definition), **timing, **_system(path)}
    _json(base.with_name(f"{base.name}_motion.json"), sidecar)
    return begun_s, begun_s + last_s


def _motion_lines(ticks: Any, begun_s: float) -> bytes:
    columns = [ticks["monotonic_s"] - begun_s, ticks["media_s"]]
    columns += [*ticks["position_m"].T, *ticks["force_n"].T]
    texts = [
        [f"{v:.{channel[4]}f}" if np.isfinite(v) else "n/a" for v in values.tolist()]
        for values, channel in zip(columns, _CHANNELS, strict=True)
    ]
    return "".join("\t".join(row) + "\n" for row in zip(*texts, strict=True)).encode()


def _describe_channels(base: Path) -> None:
    head = ("name", "component", "type", "tracked_point", "units", "reference_frame")
    rows = [
        (name, part, kind, "n/a" if part == "n/a" else "Hand", unit, "device")
        for name, part, kind, unit, _ in _CHANNELS
    ]
    _rows(base.with_name(f"{base.name}_channels.tsv"), head, rows)
    frame = {
        "SpatialAxes": "RSP",
        "RotationRule": "n/a",
        "RotationOrder": "n/a",
        "Description": "x right, y up, z towards the participant",
    }
    sidecar = base.with_name(f"{base.name}_channels.json")
    _json(sidecar, {"reference_frame": {"Levels": {"device": frame}}})


def _system(path: Path) -> dict[str, Any]:
    """Return the description of the device."""
    with RecordReader(path) as reader:
        device = str(reader.header.get("device", ""))
    maker, model = _MAKERS.get(device, ("n/a", device or "n/a"))
    kinds = [channel[2] for channel in _CHANNELS]
    return {
        "TrackingSystemName": SYSTEM,
        "MotionChannelCount": len(_CHANNELS),
        **{f"{kind}ChannelCount": kinds.count(kind) for kind in _KINDS},
        "TrackedPointsCount": 1,
        "MissingValues": "n/a",
        "Manufacturer": maker,
        "ManufacturersModelName": model,
        "SoftwareVersions": f"hapticplayer {__version__}",
    }


def _events(session: StoredSession, span_s: tuple[float, float], path: Path) -> None:
    begun_s, ended_s = span_s
    rows = [
        (f"{marker.monotonic_s - begun_s:.6f}", "n/a", marker.text)
        for marker in markers_of(session)
        if begun_s <= marker.monotonic_s <= ended_s + _MARKED_WITHIN_S
    ]
    _rows(path, ("onset", "duration", "trial_type"), rows)


def _utc(session: StoredSession, monotonic_s: float) -> dt.datetime:
    """Return the UTC time of a monotonic time, by the nearest record."""
    near = min(session.records.intact, key=lambda r: abs(r.monotonic_s - monotonic_s))
    at = dt.datetime.fromisoformat(near.utc)
    at += dt.timedelta(seconds=monotonic_s - near.monotonic_s)
    return at.astimezone(dt.UTC)


def _json(path: Path, content: Any) -> None:
    storage.write_private(path, json_text(content))


def _table(path: Path, table: DataTable) -> None:
    storage.write_private(path, separated(table, "\t", "n/a"))


def _rows(path: Path, head: Sequence[str], rows: Sequence[Sequence[Any]]) -> None:
    _table(path, DataTable(path.name, [DataColumn(name, "") for name in head], rows))
