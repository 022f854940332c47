"""Scores of scales in the report: summaries, reliability, and change in a session."""

from collections.abc import Iterator
from dataclasses import asdict
from typing import Any

import numpy as np

from hapticplayer.study.analysis.blocks import (
    Heading,
    Paragraph,
    ReportBlock,
    ReportTable,
)
from hapticplayer.study.analysis.rank_tests import WILCOXON, signed_rank
from hapticplayer.study.analysis.reliability import Reliability, reliability
from hapticplayer.study.analysis.statistic import number, plain
from hapticplayer.study.answers import Answers
from hapticplayer.study.definition import When
from hapticplayer.study.scales import read_scale, scale_names
from hapticplayer.study.score_answers import ScoreAnswers
from hapticplayer.study.scoring import formula_of

_NOTE = (
    "Alpha (Cronbach L. J., 1951, Psychometrika 16, 297-334) and omega of one factor "
    "(McDonald R. P., 1999, Test theory) are of the items, each once and in the direction "
    "of the score, and of those who answered all ('whole'); -: fewer than two items (omega: "
    "three) or participants, an item that all answered alike, or a score that is made of "
    "scores. After clips they are of the "
    "participants' means over the sequences, which are more reliable than single answers. "
    "With few participants both are rough."
)
_CHANGE = (
    "Wilcoxon's signed-rank test, p without a correction for the number of scores. "
    f"{WILCOXON.note}"
)


def scale_summary(answers: Answers) -> dict[str, Any]:
    """The scores as JSON, by key; of those after a clip by feedback."""
    found: dict[str, Any] = {}
    for one in answers.scores:
        about = {"text": one.score.text, "scale": one.page.scale}
        place = found.setdefault(one.score.key, {**about, "by": formula_of(one.score)})
        part = {**_summary(one), **asdict(_reliability(one))}
        if one.feedback:
            place.setdefault("feedbacks", {})[one.feedback] = part
        else:
            place.update(part)
    for first, last in _repeated(answers):
        found[last.score.key]["change_from"] = first.score.key
        found[last.score.key]["change"] = _change(first, last)
    return found


def _summary(one: ScoreAnswers) -> dict[str, Any]:
    values = np.array([value for value in one.values if value is not None])
    if not len(values):
        return {"answered": 0, "mean": None, "sd": None, "median": None}
    return {
        "answered": len(values),
        "mean": float(values.mean()),
        "sd": float(values.std(ddof=1)) if len(values) > 1 else None,
        "median": float(np.median(values)),
    }


def _repeated(answers: Answers) -> Iterator[tuple[ScoreAnswers, ScoreAnswers]]:
    """Yield the scores of a scale that was asked before and after the clips."""
    first: dict[tuple[str | None, str], ScoreAnswers] = {
        (one.page.scale, one.score.text): one
        for one in answers.scores
        if one.page.scale and one.page.when is When.BEFORE
    }
    for one in answers.scores:
        before = first.get((one.page.scale, one.score.text))
        if before is not None and one.page.when is When.AFTER:
            yield before, one


def _change(first: ScoreAnswers, last: ScoreAnswers) -> dict[str, Any]:
    pairs = zip(first.values, last.values, strict=True)
    known = np.array([(a, b) for a, b in pairs if a is not None and b is not None])
    if not len(known):
        return {}
    change = {"mean": float((known[:, 1] - known[:, 0]).mean())}
    found: dict[str, Any] = plain(signed_rank(known[:, 0], known[:, 1]))
    return {**change, **found}


def _reliability(one: ScoreAnswers) -> Reliability:
    width = len(one.parts[0]) if one.parts else 0
    return reliability(np.array(one.parts, np.float64).reshape(len(one.parts), width))


def scale_tables(answers: Answers) -> Iterator[ReportBlock]:
    """Yield the scores of scales, if there are any."""
    if not answers.scores:
        return
    yield Heading("Scores of scales")
    for text in _sources(answers):
        yield Paragraph(text)
    head = ("score", "shown", "n", "mean", "SD", "median", "range of the scale")
    rows = tuple(_row(one) for one in answers.scores)
    yield ReportTable("Scores", (*head, "whole", "alpha", "omega"), rows, _NOTE)
    if changes := tuple(_change_row(*pair) for pair in _repeated(answers)):
        columns = (one.head for one in WILCOXON.columns if one.key != "p_holm")
        heads = ("score", "from", "mean change", *columns)
        yield ReportTable("Change from before to after", heads, changes, _CHANGE)
    by_key = {one.score.key: formula_of(one.score) for one in answers.scores}
    yield ReportTable(
        "How scores are computed", ("score", "from"), tuple(by_key.items())
    )


def _row(one: ScoreAnswers) -> tuple[str, ...]:
    found, quality = _summary(one), _reliability(one)
    words = (str(one.page.when).replace("-", " "), one.feedback)
    shown = ", ".join(filter(None, words))
    return (
        one.score.key,
        shown,
        str(found["answered"]),
        number(found["mean"]),
        number(found["sd"]),
        number(found["median"]),
        "{:g} to {:g}".format(*one.limits),
        str(quality.n),
        number(quality.alpha),
        number(quality.omega),
    )


def _change_row(first: ScoreAnswers, last: ScoreAnswers) -> tuple[str, ...]:
    found = _change(first, last)
    columns = [one for one in WILCOXON.columns if one.key != "p_holm"]
    cells = (one.text(found[one.key]) if found else "-" for one in columns)
    return last.score.key, first.score.key, number(found.get("mean")), *cells


def _sources(answers: Answers) -> Iterator[str]:
    names = dict.fromkeys(one.page.scale for one in answers.scores if one.page.scale)
    for name in names:
        if name in scale_names():  # else a laboratory's own
            scale = read_scale(name)
            yield f"{scale.name}: {scale.source}."
