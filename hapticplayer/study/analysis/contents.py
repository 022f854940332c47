"""What the report says, in order, apart from how it is shown."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

from hapticplayer.study.analysis.analysis import Analysis, Choices, MeasureAnalysis
from hapticplayer.study.analysis.describing import Summary
from hapticplayer.study.analysis.scores import QOE
from hapticplayer.study.analysis.summary import missing, pair_name, provenance
from hapticplayer.study.analysis.words import ASSUMPTIONS, warnings_of


@dataclass(frozen=True, slots=True)
class Heading:
    """The title of a part."""

    text: str


@dataclass(frozen=True, slots=True)
class Words:
    """A paragraph, with a few words in bold before it."""

    text: str
    lead: str = ""


@dataclass(frozen=True, slots=True)
class Table:
    """Rows of texts under a head; the first column names them."""

    title: str
    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True, slots=True)
class Picture:
    """A figure by its name."""

    name: str
    caption: str


Block = Heading | Words | Table | Picture
Part = Callable[[MeasureAnalysis], Iterable[tuple[str, ...]]]


def contents(analysis: Analysis) -> Iterator[Block]:
    """Yield the parts of the report."""
    yield from _people(analysis)
    yield Heading("Where care is needed")
    warned = warnings_of(analysis)
    for text in warned or ["Nothing was found that speaks against the tests below."]:
        yield Words(text)
    yield Heading("Figures")
    yield Picture("qoe-by-sequence", "QoE by sequence and feedback")
    yield Picture("factors-by-feedback", "Factors by feedback, mean over the sequences")
    yield Heading("Means and spreads")
    yield from _described(analysis)
    yield Heading("Tests")
    yield from _tests(analysis)
    yield Heading("What the tests assume")
    for name, text in ASSUMPTIONS:
        yield Words(text, name)
    yield from made_with(analysis.choices)


def made_with(choices: Choices) -> Iterator[Block]:
    """Yield what is needed to make the report again."""
    yield Heading("How this was made")
    made = provenance(choices)
    versions = ", ".join(f"{k} {v}" for k, v in made["versions"].items())
    yield Words(
        f"{made['program']}; {versions}. Seed {made['seed']}, {made['resamples']} "
        "resamples, intervals of 95 %. The same answers, seed and versions give the "
        "same report to the bit."
    )


def number(value: float | None, digits: int = 2) -> str:
    """Return a number for people; a dash where there is none."""
    return "-" if value is None else f"{value:.{digits}f}"


def p_value(value: float | None) -> str:
    """Return a p value as it is printed."""
    if value is None:
        return "-"
    return "< .001" if value < 0.001 else f"{value:.3f}".lstrip("0")


def interval(value: tuple[float, float] | None) -> str:
    """Return an interval."""
    return "-" if value is None else f"[{value[0]:.2f}, {value[1]:.2f}]"


def _people(analysis: Analysis) -> Iterator[Block]:
    found, scores = missing(analysis), analysis.scores
    used = sum(scores.used_before.values())
    yield Heading("Participants and answers")
    yield Words(
        f"{found['participants']} participants, {used} of them had used the device "
        f"before; {len(scores.sequences)} sequences x {len(scores.feedbacks)} feedbacks "
        f"x {len(scores.factors)} factors. {found['answers_missing']} of "
        f"{found['answers_planned']} answers are missing "
        f"({found['of_these_not_sound']} because the playback was not sound); "
        f"{found['replaced_by_repetition']} were replaced by a repetition. QoE of a "
        "condition is the sum of its factors; the tests take the mean over the "
        "sequences for each participant and feedback."
    )


def _described(analysis: Analysis) -> Iterator[Block]:
    head = (
        "feedback",
        "n",
        "mean",
        "95 %",
        "SD",
        "median",
        "quartiles",
        "range",
        "W",
        "p",
    )
    for name, one in analysis.measures.items():
        rows = (
            (
                *_summary_row(k, s),
                number(one.shapiro[k].w, 3),
                p_value(one.shapiro[k].p),
            )
            for k, s in one.feedbacks.items()
        )
        yield Table(f"{_label(name)}; W and p of Shapiro-Wilk", head, tuple(rows))
    for name, one in analysis.measures.items():
        rows = (
            _summary_row(f"{sequence}, {feedback}", summary)
            for sequence, by_feedback in one.conditions.items()
            for feedback, summary in by_feedback.items()
        )
        title = f"{_label(name)} by condition, all answers"
        yield Table(title, ("condition", *head[1:8]), tuple(rows))


def _label(measure: str) -> str:
    return "QoE" if measure == QOE else measure


def _summary_row(name: str, one: Summary) -> tuple[str, ...]:
    def pair(low: float | None, high: float | None) -> tuple[float, float] | None:
        return None if low is None or high is None else (low, high)

    return (
        name,
        str(one.n),
        number(one.mean),
        interval(pair(one.mean_low, one.mean_high)),
        number(one.sd),
        number(one.median),
        interval(pair(one.q1, one.q3)),
        interval(pair(one.low, one.high)),
    )


def _tests(analysis: Analysis) -> Iterator[Block]:
    measures = analysis.measures.items()
    yield Table(
        "Friedman over the feedbacks; Holm over the measures (of the exact p)",
        (
            "measure",
            "n",
            "chi²",
            "df",
            "p",
            "Kendall's W",
            "exact p",
            "Holm",
            "F",
            "p of F",
        ),
        tuple(_friedman_row(name, one) for name, one in measures),
    )
    yield Table(
        "Pairs of feedbacks: Wilcoxon signed rank; Holm over the pairs of a measure",
        ("pair", "n", "zeros", "W+", "W-", "p", "Holm", "r", "95 %", "shift", "95 %"),
        tuple(_rows(measures, _wilcoxon_rows)),
    )
    yield Table(
        "Pairs of feedbacks: Nemenyi and Conover",
        ("pair", "Nemenyi q", "p", "Conover t", "p", "Holm"),
        tuple(_rows(measures, _posthoc_rows)),
    )
    yield Table(
        "Used the device before or not: Mann-Whitney; Holm over all of these tests",
        ("feedback", "before", "new", "U", "p", "Holm", "r", "95 %"),
        tuple(_rows(measures, _expertise_rows)),
    )
    yield Table(
        "Sequence x feedback: analysis of variance of aligned ranks",
        ("effect", "n", "F", "df", "p", "epsilon", "corrected p", "partial eta²"),
        tuple(_rows(measures, _structure_rows)),
    )


def _rows(
    measures: Iterable[tuple[str, MeasureAnalysis]], part: Part
) -> Iterator[tuple[str, ...]]:
    for name, one in measures:
        for first, *rest in part(one):
            yield (f"{_label(name)}: {first}", *rest)


def _friedman_row(name: str, one: MeasureAnalysis) -> tuple[str, ...]:
    test = one.friedman
    return (
        _label(name),
        str(test.n),
        number(test.chi2),
        str(test.df),
        p_value(test.p),
        number(test.kendall_w, 3),
        p_value(test.p_exact),
        p_value(test.p_holm),
        number(test.f),
        p_value(test.p_f),
    )


def _wilcoxon_rows(one: MeasureAnalysis) -> Iterator[tuple[str, ...]]:
    for pair in one.pairs:
        test = pair.wilcoxon
        yield (
            pair_name(pair),
            str(test.n),
            str(test.zeros),
            number(test.w_plus, 1),
            number(test.w_minus, 1),
            p_value(test.p),
            p_value(test.p_holm),
            number(test.rank_biserial),
            interval(test.rank_biserial_interval),
            number(test.shift),
            interval(test.shift_interval),
        )


def _posthoc_rows(one: MeasureAnalysis) -> Iterator[tuple[str, ...]]:
    for pair in one.pairs:
        yield (
            pair_name(pair),
            number(pair.nemenyi.q),
            p_value(pair.nemenyi.p),
            number(pair.conover.t),
            p_value(pair.conover.p),
            p_value(pair.conover.p_holm),
        )


def _expertise_rows(one: MeasureAnalysis) -> Iterator[tuple[str, ...]]:
    for feedback, test in one.mann_whitney.items():
        yield (
            feedback,
            str(test.n_before),
            str(test.n_new),
            number(test.u, 1),
            p_value(test.p),
            p_value(test.p_holm),
            number(test.rank_biserial),
            interval(test.rank_biserial_interval),
        )


def _structure_rows(one: MeasureAnalysis) -> Iterator[tuple[str, ...]]:
    if one.structure is None:
        return
    for name, effect in one.structure.effects.items():
        yield (
            name,
            str(len(one.structure.participants)),
            number(effect.f),
            f"{effect.df[0]:.0f}, {effect.df[1]:.0f}",
            p_value(effect.p),
            number(effect.epsilon),
            p_value(effect.p_corrected),
            number(effect.partial_eta_squared),
        )
