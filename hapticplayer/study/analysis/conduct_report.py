"""What a report tells of the study itself: identity, participants, orders, playback."""

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from hapticplayer import __version__
from hapticplayer.devices import find_device
from hapticplayer.errors import DeviceError
from hapticplayer.study.analysis.blocks import (
    Heading,
    Paragraph,
    ReportBlock,
    ReportTable,
)
from hapticplayer.study.analysis.question_report import question_table
from hapticplayer.study.analysis.scale_report import scale_tables
from hapticplayer.study.analysis.statistic import listed, number
from hapticplayer.study.answers import Answers, simulated_mark
from hapticplayer.study.conduct import AnsweredPlayback

ALL = "all"
ORDERS = {
    "random": "shuffled for each participant",
    "latin-square": "of a Latin square",
    "williams": "of a Williams design",
    "list": "of a list",
}
_SHOWN = 200
COUNTED = ("frames_shown", "frames_dropped", "silence_s", "missed", "ticks")
"""Figures of a playback that are summed, see `stage`."""
SYNC = {
    "force_minus_video_ms": "force - video, ms",
    "force_minus_sound_ms": "force - sound, ms",
}


def identity(answers: Answers) -> Iterator[ReportBlock]:
    """The identity of the study, its dates, its software and its devices."""
    conduct = answers.conduct
    parts = []
    if conduct.identifier:
        parts.append(f"Study {conduct.identifier}.")
    if conduct.dates:
        parts.append(f"Sessions of {' to '.join(dict.fromkeys(conduct.dates))} (UTC)")
        parts[-1] += f", recorded with {listed(conduct.programs)}."
    parts.append(f"Analysed with hapticplayer {__version__}.")
    if devices := tuple(_devices(conduct.playbacks)):
        parts.append(
            f"{'Device' if len(devices) == 1 else 'Devices'}: {listed(devices)}."
        )
    if mark := simulated_mark(answers.participants):
        parts.append(f"{mark.capitalize()}.")
    yield Paragraph(" ".join(parts))


def _devices(trials: Iterable[AnsweredPlayback]) -> Iterator[str]:
    """Yield the devices of playbacks as people call them, and their names."""
    listed_names = (trial.figures.get("outputs") for trial in trials)
    lists = (names for names in listed_names if isinstance(names, list))
    for name in dict.fromkeys(str(name) for names in lists for name in names):
        try:
            yield f"{find_device(name).label} ({name})"
        except DeviceError:  # of a package that this machine lacks
            yield name


def people(answers: Answers) -> Iterator[ReportBlock]:
    """Yield a table of the participants."""
    yield Heading("Participants")
    everyone, conduct = answers.participants, answers.conduct
    ages = np.array([p.age for p in everyone if p.age is not None], dtype=float)
    used = [p.used_device_before for p in everyone]
    rows = [("participants", str(len(everyone)))]
    if conduct.sessions:
        rows.append(("completed sessions", f"{conduct.complete} of {conduct.sessions}"))
    if any(one.site for one in everyone):
        rows.append(("sites", _counted([one.site or None for one in everyone])))
    rows.append(("age, years", _ages(ages, len(everyone))))
    rows.append(("gender", _counted([p.gender for p in everyone])))
    rows.append(("handedness", _counted([p.handedness for p in everyone])))
    words = {
        True: "had used such a device before",
        False: "had not used one before",
        None: None,
    }
    rows.append(("experience", _counted([words[one] for one in used])))
    yield ReportTable("Participants of the study", ("", "value"), tuple(rows))
    yield from question_table(answers)
    yield from scale_tables(answers)


def _ages(ages: Any, everyone: int) -> str:
    if not len(ages):
        return "not asked"
    spread = f"SD {number(float(ages.std(ddof=1)))}, " if len(ages) > 1 else ""
    known = f", {everyone - len(ages)} unknown" if len(ages) < everyone else ""
    return (
        f"mean {number(float(ages.mean()))}, {spread}range {ages.min():.0f} to "
        f"{ages.max():.0f}{known}"
    )


def _counted(values: Sequence[str | None]) -> str:
    counts = Counter(value or "unknown" for value in values)
    return ", ".join(f"{count} {name}" for name, count in counts.most_common())


def feedback_conditions(answers: Answers) -> Iterator[ReportBlock]:
    """The description of each feedback."""
    rows = tuple(answers.conduct.feedbacks.items())
    if rows:
        yield Heading("Feedbacks")
        yield ReportTable("Feedback conditions", ("feedback", "force"), rows)


def order_balance(answers: Answers) -> Iterator[ReportBlock]:
    """Yield how balanced the orders of the conditions were."""
    conduct = answers.conduct
    if not conduct.order_method:
        return
    yield Heading("Order of the conditions")
    position, after = conduct.at_position, conduct.followed
    yield Paragraph(
        f"Orders were {ORDERS.get(conduct.order_method, conduct.order_method)}. "
        f"Each condition was played {_often(*position)} at each position, and "
        f"{_often(*after)} directly after each other one."
        f"{_positions(conduct.mean_positions)}"
    )


def _often(least: int, most: int) -> str:
    if least < most:
        return f"{least} to {most} times"
    return {0: "never", 1: "once"}.get(most, f"{most} times")


def _positions(means: Mapping[str, float]) -> str:
    """Where in the orders the levels of the sequences' factors were."""
    if not means:
        return ""
    texts = [f"{number(mean)} ({level})" for level, mean in means.items()]
    return f" Mean positions of the trials with each level: {listed(texts)}."


def playback(answers: Answers, feedbacks: Sequence[str]) -> Iterator[ReportBlock]:
    """Yield times to answer and the quality of the playback, by feedback."""
    trials = answers.conduct.playbacks
    if not trials:
        return
    yield Heading("Times to answer and quality of the playback")
    groups = {
        name: [one for one in trials if name in (ALL, one.feedback)]
        for name in (*feedbacks, ALL)
    }
    if _numbers(one.response_s for one in trials):
        yield ReportTable(
            "Time from the questions to the answer, s",
            ("feedback", "n", "median", "quartiles", "range"),
            tuple((name, *_times(group)) for name, group in groups.items()),
        )
    else:
        yield Paragraph("Times to answer were not recorded.")
    yield _quality_table(groups)
    yield from _faults(trials)


def _quality_table(groups: Mapping[str, Sequence[AnsweredPlayback]]) -> ReportTable:
    """How well the clips were played, as far as that was recorded."""
    heads = ("feedback", "trials", "repeated", "not valid")
    played = ("frames dropped", "silence, s", "missed periods", *SYNC.values())
    is_recorded = any(one.figures for one in groups[ALL])
    columns = len(heads) - 1 + len(played) * is_recorded
    return ReportTable(
        "Quality of the playback of answered trials",
        (*heads, *(played if is_recorded else ())),
        tuple((name, *_quality(group)[:columns]) for name, group in groups.items()),
        "Differences between force and video or sound: median of the trials' medians, "
        "smallest 5 % and largest 95 % quantile of a trial; positive where the force "
        "came later. Missed periods are those of the 1 kHz haptic loop."
        if is_recorded
        else "The playback was not recorded.",
    )


def _faults(trials: Sequence[AnsweredPlayback]) -> Iterator[ReportBlock]:
    """Why trials were not valid, and what kept their outputs from playing."""
    reasons = Counter(
        _worded(reason)
        for one in trials
        if not one.is_valid
        for reason in dict.fromkeys(one.reasons)
    )
    if reasons:
        rows = tuple((what, str(count)) for what, count in reasons.most_common())
        title = "Reasons why a playback was not valid"
        yield ReportTable(title, ("reason", "trials"), rows)
    found = [one.figures.get("output_faults") for one in trials]
    faults = Counter(
        (str(name)[:_SHOWN], str(what)[:_SHOWN])
        for each in found
        if isinstance(each, Mapping)
        for name, what in each.items()
    )
    if faults:
        heads = ("output", "what", "trials")
        lines = tuple((*key, str(count)) for key, count in faults.most_common())
        yield ReportTable("What kept outputs from playing", heads, lines)


def _worded(reason: str) -> str:
    kind, colon, more = reason[:_SHOWN].partition(":")
    return kind.replace("_", " ") + (f"{colon} {more}" if more else "")


def _times(trials: Sequence[AnsweredPlayback]) -> tuple[str, ...]:
    found = _numbers(one.response_s for one in trials)
    if not found:
        return "0", "-", "-", "-"
    low, q1, median, q3, high = np.quantile(found, [0.0, 0.25, 0.5, 0.75, 1.0])
    texts = (f"{median:.1f}", f"[{q1:.1f}, {q3:.1f}]", f"[{low:.1f}, {high:.1f}]")
    return str(len(found)), *texts


def _quality(trials: Sequence[AnsweredPlayback]) -> tuple[str, ...]:
    played = [one.figures for one in trials if one.figures]
    shown, dropped, silence_s, missed, ticks = (
        sum(_numbers(one.get(name) for one in played)) for name in COUNTED
    )
    return (
        str(len(trials)),
        str(sum(one.attempt > 1 for one in trials)),
        str(sum(not one.is_valid for one in trials)),
        _share(dropped, shown + dropped),
        f"{silence_s:.2f}" if played else "-",
        _share(missed, ticks),
        *(_difference([one.get(name) for one in played]) for name in SYNC),
    )


def _share(count: float, total: float) -> str:
    return f"{count:.0f} of {total:.0f}" if total else "-"


def _difference(stats: Sequence[Any]) -> str:
    known = [one for one in stats if isinstance(one, Mapping)]
    lows, middles, highs = (
        _numbers(one.get(name) for one in known) for name in ("p05", "p50", "p95")
    )
    if not (lows and middles and highs):
        return "-"
    return f"{float(np.median(middles)):.1f} [{min(lows):.1f}, {max(highs):.1f}]"


def _numbers(values: Iterable[Any]) -> list[float]:
    """Return those that are finite numbers; records can be damaged or edited."""
    return [
        float(one)
        for one in values
        if isinstance(one, int | float) and math.isfinite(one)
    ]
