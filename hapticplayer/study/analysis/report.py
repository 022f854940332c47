"""The report of a study with either kind of trials, and its files."""

import csv
import io
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from hapticplayer import extension, storage
from hapticplayer.errors import Message, Progress, StudyError
from hapticplayer.study.analysis import contents, figures
from hapticplayer.study.analysis.analysis import (
    Analysis,
    AnalysisOptions,
    analyse,
    summary,
)
from hapticplayer.study.analysis.course_report import (
    course_figures,
    course_rows,
    course_summary,
)
from hapticplayer.study.analysis.describing import Summary
from hapticplayer.study.analysis.parts import Analyse, AnalysisKind, ReportParts
from hapticplayer.study.analysis.pdf import write_pdf
from hapticplayer.study.analysis.preregistered import with_registration
from hapticplayer.study.analysis.statistic import number, p_value, rounded
from hapticplayer.study.analysis.typesetting import page
from hapticplayer.study.answers import Answers, simulated_mark
from hapticplayer.study.data_table import guarded
from hapticplayer.study.definition import TrialKind

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def analyse_study(
    answers: Answers,
    options: AnalysisOptions | None = None,
    progress: Progress = lambda _fraction, _step: None,
) -> ReportParts:
    """Analyse ratings, or judgements by the extension that knows their kind."""
    options = options or AnalysisOptions()
    return with_registration(_analysed(answers, options, progress), options)


def _analysed(
    answers: Answers, options: AnalysisOptions, progress: Progress
) -> ReportParts:
    if answers.trial is TrialKind.RATING:
        return parts_of(analyse(answers, options, progress))
    kinds = {one.name: one for one in extension.rows("study_analyses", AnalysisKind)}
    if (kind := kinds.get(answers.trial)) is None:
        raise StudyError(
            "the analysis of {kind} trials is missing; install the extension that has "
            "it, or export the answers",
            kind=answers.trial.value,
        )
    return cast(Analyse, extension.load(kind.home))(answers, options, progress)


def parts_of(found: Analysis) -> ReportParts:
    mark = simulated_mark(found.answers.participants)
    is_empty = found.scores.is_empty
    over_time = course_summary(found.answers, found.first_order)
    has_courses = bool(found.answers.courses)
    return ReportParts(
        found.answers,
        mark,
        rounded({**summary(found), "over_time": over_time}),
        () if is_empty else tuple(_lines(found)),
        tuple(contents.contents(found)),
        lambda: {} if is_empty else figures.marked(_figures(found), mark),
        {
            "conditions.csv": _condition_rows(found),
            "tests.csv": _test_rows(found),
            "scores.csv": _score_rows(found),
            **({"courses.csv": course_rows(found.answers)} if has_courses else {}),
        },
        is_empty,
    )


def _figures(found: Analysis) -> dict[str, "Figure"]:
    return figures.figures(found) | course_figures(found.answers)


def _lines(found: Analysis) -> Iterator[str]:
    for name, one in found.measures.items():
        means = ", ".join(
            f"{key} {number(part.mean)} (SD {number(part.sd)})"
            for key, part in one.feedbacks.items()
        )
        test = found.found["friedman"][name]
        yield (
            f"{name:<12} {means}\n{'':13}Friedman chi2({test['df']}) "
            f"{number(test['chi2'])}, "
            f"p {p_value(test['p'])}, permutation {p_value(test['p_exact'])}, "
            f"Holm {p_value(test['p_holm'])}, W {number(test['kendall_w'], 3)}"
        )
        for pair, part in found.found["wilcoxon"][name].items():
            yield (
                f"{'':13}{pair}: Wilcoxon Holm {p_value(part['p_holm'])}, "
                f"r {number(part['rank_biserial'])}"
            )


def write_report(
    parts: ReportParts,
    target: Path,
    title: str,
    progress: Progress = lambda _fraction, _step: None,
) -> None:
    """Write the report into a new folder, atomically.

    `report.html`, `report.pdf`, `numbers.json`, the figures as SVG, PDF and PNG, and of
    ratings `conditions.csv` (means and spreads), `tests.csv` and `scores.csv` (each
    participant's), of judgements `levels.csv` and `curves.csv`.
    """
    title = title.encode(errors="replace").decode()  # of a folder, in whatever bytes
    with storage.folder_written_aside(target, storage.PRIVATE_FOLDER) as aside:
        for place, (name, figure) in enumerate(parts.draw().items()):
            progress(0.2 + 0.2 * place, Message("drawing {name}", name=name))
            for suffix in figures.FORMATS:
                content = figures.image(figure, suffix)
                (aside / f"{name}{suffix}").write_bytes(content)
        svgs, pngs = (
            {path.stem: path.read_bytes() for path in sorted(aside.glob(pattern))}
            for pattern in ("*.svg", "*.png")
        )
        progress(0.6, Message("writing {file}", file="report.html"))
        _write_text(aside / "report.html", page(title, parts.mark, parts.blocks, svgs))
        progress(0.7, Message("writing {file}", file="report.pdf"))
        write_pdf(aside / "report.pdf", title, parts.mark, parts.blocks, pngs)
        progress(0.9, Message("writing the numbers"))
        storage.write_json(aside / "numbers.json", parts.numbers)
        for name, rows in parts.tables.items():
            out = io.StringIO()
            cells = ([guarded(one) for one in rounded(row)] for row in rows)
            csv.writer(out, lineterminator="\n").writerows(cells)
            _write_text(aside / name, out.getvalue())
        for path in aside.iterdir():  # contains the answers of participants
            path.chmod(storage.PRIVATE_FILE)


def _write_text(path: Path, text: str) -> None:
    path.write_text(text, encoding="utf-8", errors="replace")


def _condition_rows(analysis: Analysis) -> Iterator[list[Any]]:
    yield ["measure", "sequence", "feedback", *Summary.__dataclass_fields__]
    for measure, one in analysis.measures.items():
        groups = [("all", one.feedbacks), *one.conditions.items(), *one.levels.items()]
        for sequence, part in groups:
            for feedback, described in part.items():
                yield [measure, sequence, feedback, *asdict(described).values()]


def _test_rows(analysis: Analysis) -> Iterator[list[Any]]:
    yield ["test", "measure", "of", "statistic", "value"]
    for test, statistic in analysis.statistics.items():
        for measure, found in analysis.found[test].items():
            for name, part in statistic.rows(found).items():
                for key, value in _flat(part):
                    yield [test, measure, name, key, value]


def _flat(part: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    for key, value in part.items():
        if isinstance(value, dict):
            yield from ((f"{key}.{name}", one) for name, one in value.items())
        elif isinstance(value, list):
            yield from ((f"{key}.{place}", one) for place, one in enumerate(value))
        else:
            yield key, value


def _score_rows(analysis: Analysis) -> Iterator[list[Any]]:
    yield ["participant", "measure", "feedback", "mean_over_sequences"]
    for measure, one in analysis.measures.items():
        sample = one.sample
        for code, row in zip(sample.participants, sample.values, strict=True):
            for feedback, value in zip(sample.feedbacks, row.tolist(), strict=True):
                yield [code, measure, feedback, value]
