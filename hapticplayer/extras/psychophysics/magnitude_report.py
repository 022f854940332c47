"""The analysis of magnitude estimation as JSON, report and tables."""

from collections.abc import Iterator
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import numpy as np

from hapticplayer.errors import Progress, counted
from hapticplayer.extras.psychophysics.framing import (
    Findings,
    contents,
    few_people,
    summary,
)
from hapticplayer.extras.psychophysics.magnitudes import (
    ALL,
    MagnitudeAnalysis,
    analyse_magnitudes,
)
from hapticplayer.study.analysis.analysis import AnalysisOptions
from hapticplayer.study.analysis.blocks import (
    Heading,
    ReportBlock,
    ReportFigure,
    ReportTable,
)
from hapticplayer.study.analysis.figures import marked, new_panel
from hapticplayer.study.analysis.methods import computed_with, invalid_text
from hapticplayer.study.analysis.parts import ReportParts
from hapticplayer.study.analysis.references import EFRON_1993, STEVENS_1957
from hapticplayer.study.analysis.statistic import (
    interval,
    number,
    plain,
    rounded,
)
from hapticplayer.study.answers import Answers, simulated_mark

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_FIGURE = "magnitudes"
_ASSUMPTIONS = (
    (
        "Numbers are proportional to what is felt, whatever scale a participant uses: "
        "they are divided by the participant's geometric mean, so that only their ratios "
        "count."
    ),
    (
        "The exponent assumes a power law: a straight line of the logarithms. It says "
        "nothing where the means by level bend."
    ),
)


def analysed(
    answers: Answers, options: AnalysisOptions | None, _progress: Progress
) -> ReportParts:
    found = analyse_magnitudes(answers, options)
    mark = simulated_mark(answers.participants)
    findings = _findings(found)
    numbers = {**_summary(found), **summary(answers, found.options, findings)}
    return ReportParts(
        answers,
        mark,
        rounded(numbers),
        tuple(_lines(found)),
        tuple(contents(answers, found.options, findings)),
        lambda: marked({_FIGURE: _figure(found)}, mark),
        {"levels.csv": _level_rows(found), "exponents.csv": _exponent_rows(found)},
    )


def _lines(found: MagnitudeAnalysis) -> Iterator[str]:
    for name, one in found.exponents.items():
        count = len(one.by_person)
        yield (
            f"{name}: exponent {number(one.mean)}, 95 % CI {interval(one.interval)}, "
            f"{counted(count, 'participant')}"
        )


def _summary(found: MagnitudeAnalysis) -> dict[str, Any]:
    return {
        "magnitudes": {
            name: [
                {"delay_s": delay_s, "gain": gain, "mean": mean, "answers": count}
                for (delay_s, gain), (mean, count) in levels.items()
            ]
            for name, levels in found.means.items()
        },
        "exponents": {k: plain(asdict(one)) for k, one in found.exponents.items()},
        "missing": {
            "participants": len(found.answers.participants),
            "answers_missing": found.missing,
            "not_positive": found.not_positive,
        },
    }


def _findings(found: MagnitudeAnalysis) -> Findings:
    count = len(found.answers.participants)
    warned = list(few_people(found.answers))
    if found.not_positive:
        warned.append(
            f"{found.not_positive} answers are zero or below; they have no logarithm and "
            "are left out."
        )
    if not found.exponents:
        warned.append("There are not two gains at one delay, hence no exponent.")
    return Findings(
        f"{counted(count, 'participant')}; {found.missing} answers are missing.",
        warned,
        (_methods(found),),
        tuple(_results(found)),
        _ASSUMPTIONS,
        (EFRON_1993, STEVENS_1957),
    )


def _methods(found: MagnitudeAnalysis) -> str:
    return (
        "Participants gave numbers in proportion to what they felt (magnitude "
        f"estimation; Stevens, 1957). {invalid_text(found.options)} Numbers were "
        "analysed by their logarithms after division by each participant's "
        "geometric mean. The exponent of the power law is the slope of log number "
        "against log gain, by least squares for each participant; the interval of "
        "its mean (95 %) is a percentile bootstrap over participants (Efron and "
        f"Tibshirani, 1993). {computed_with(found.options)}"
    )


def _results(found: MagnitudeAnalysis) -> Iterator[ReportBlock]:
    yield Heading("Magnitudes")
    caption = "Geometric means by level, all sequences."
    shown = ", ".join(
        f"{gain:g}: {number(mean)}"
        for (_, gain), (mean, _n) in found.means[ALL].items()
    )
    yield ReportFigure(_FIGURE, caption, f"Geometric means by gain. {shown}.")
    rows = tuple(
        (name, str(len(one.by_person)), number(one.mean), interval(one.interval))
        for name, one in found.exponents.items()
    )
    head = ("sequence", "participants", "exponent", "95 % CI")
    yield ReportTable("Exponents", head, rows)
    for name, levels in found.means.items():
        cells = tuple(
            (number(delay_s, 3), number(gain), number(mean), str(count))
            for (delay_s, gain), (mean, count) in levels.items()
        )
        head = ("delay, s", "gain", "geometric mean", "answers")
        yield ReportTable(f"Geometric means, {name}", head, cells)


def _figure(found: MagnitudeAnalysis) -> "Figure":
    with new_panel("geometric mean") as (figure, panel):
        levels = found.means[ALL]
        gains = [gain for _, gain in levels]
        panel.plot(gains, [mean for mean, _ in levels.values()], "o", color="#222222")
        if (one := found.exponents.get(ALL)) is not None:
            middle = np.mean([np.log(gain) for gain in gains if gain > 0.0])
            height = np.mean([np.log(mean) for mean, _ in levels.values()])
            at = np.geomspace(min(g for g in gains if g > 0.0), max(gains), 101)
            line = np.exp(height + one.mean * (np.log(at) - middle))
            panel.plot(at, line, color="#0072b2", lw=2.0)
        panel.set_xlabel("gain of the force")
    return figure


def _level_rows(found: MagnitudeAnalysis) -> list[list[Any]]:
    head: list[Any] = ["sequence", "delay_s", "gain", "geometric_mean", "answers"]
    rows = [
        [name, *level, *mean]
        for name, levels in found.means.items()
        for level, mean in levels.items()
    ]
    return [head, *rows]


def _exponent_rows(found: MagnitudeAnalysis) -> list[list[Any]]:
    head: list[Any] = ["sequence", "participant", "exponent"]
    rows = [
        [name, code, value]
        for name, one in found.exponents.items()
        for code, value in one.by_person.items()
    ]
    return [head, *rows]
