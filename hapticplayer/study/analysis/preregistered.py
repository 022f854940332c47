"""The plan of a study as a document, and in the report what came of it."""

import hashlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from hapticplayer.study.analysis.analysis import AnalysisOptions, statistics_of
from hapticplayer.study.analysis.blocks import (
    Heading,
    Paragraph,
    ReportBlock,
    ReportTable,
    numbered,
)
from hapticplayer.study.analysis.conduct_report import ORDERS
from hapticplayer.study.analysis.parts import ReportParts
from hapticplayer.study.analysis.scores import MissingPolicy
from hapticplayer.study.analysis.statistic import ALPHA, listed, number, p_value
from hapticplayer.study.answers import Answers
from hapticplayer.study.definition import QOE, Definition
from hapticplayer.study.preregistration import (
    Deviation,
    ExpectedOrder,
    PlannedAnalysis,
    PlannedPower,
    Preregistration,
    hypothesis_of,
)
from hapticplayer.study.questions import range_of
from hapticplayer.study.scoring import formula_of

_MISSING = {
    MissingPolicy.PAIRED: "Where an answer is missing, its sequence is left out for all "
    "feedbacks of this participant.",
    MissingPolicy.COMPLETE: "Participants with a missing answer are left out of the tests "
    "over sequences.",
}


def analysis_digest() -> str:
    """SHA-256 of the program's analysis: its source files by name."""
    digest = hashlib.sha256()
    for path in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(f"{path.name}\n".encode() + path.read_bytes())
    return digest.hexdigest()


def planned_analysis(options: AnalysisOptions, *, has_factors: bool) -> PlannedAnalysis:
    made, planned = options.provenance(), statistics_of(has_factors=has_factors)
    return PlannedAnalysis(
        missing_answers=options.missing.value,
        include_invalid=options.include_invalid,
        seed=options.resampling.seed,
        resamples=options.resampling.count,
        statistics=tuple(one.title for one in planned.values()),
        sha256=analysis_digest(),
        versions={"program": made["program"], **made["versions"]},
    )


def deviations(answers: Answers, options: AnalysisOptions) -> tuple[Deviation, ...]:
    """What was done otherwise than planned; nothing where there was no plan."""
    if answers.registered is None:
        return ()
    plan, has_factors = answers.registered.plan, bool(answers.sequence_factors)
    made = planned_analysis(options, has_factors=has_factors)
    return (
        *_of_participants(plan, answers),
        *answers.registered.deviations,
        *_of_analysis(plan.analysis, made),
    )


def _of_participants(plan: Preregistration, answers: Answers) -> Iterator[Deviation]:
    complete = sum(one.complete for one in answers.participants)
    if complete != plan.participants:
        text = f"{plan.participants} were planned, {complete} completed a session"
        yield Deviation("participants", text)


def _of_analysis(plan: PlannedAnalysis, made: PlannedAnalysis) -> Iterator[Deviation]:
    options = {
        "missing_answers": "treatment of missing answers",
        "include_invalid": "inclusion of trials whose playback was not valid",
        "seed": "seed",
        "resamples": "number of resamples",
    }
    for name, text in options.items():
        was, now = getattr(plan, name), getattr(made, name)
        if was != now:
            yield Deviation("analysis", f"{text}: {was} was planned, it is {now}")
    if plan.sha256 != made.sha256:
        text = (
            f"its source has SHA-256 {made.sha256[:16]}..., not {plan.sha256[:16]}..."
        )
        yield Deviation("analysis", f"the program's analysis has changed: {text}")
    for name in dict.fromkeys((*plan.versions, *made.versions)):
        was, now = (one.versions.get(name, "nothing") for one in (plan, made))
        if was != now:
            yield Deviation("analysis", f"{name}: {was} was planned, it is {now}")


def with_registration(parts: ReportParts, options: AnalysisOptions) -> ReportParts:
    """The report with its plan, what came of the hypotheses, and each deviation."""
    registered = parts.answers.registered
    if registered is None:
        return parts
    plan, found = registered.plan, deviations(parts.answers, options)
    results = [_result(text, parts.numbers) for text in plan.hypotheses]
    numbers = {
        "sha256": plan.sha256,
        "written_utc": plan.written_utc,
        "participants": plan.participants,
        "hypotheses": [
            {"text": text, "result": result}
            for text, result in zip(plan.hypotheses, results, strict=True)
        ],
        "deviations": [one._asdict() for one in found],
    }
    place = next(i for i, one in enumerate(parts.blocks) if isinstance(one, Heading))
    section = _section(plan, results, found)
    return replace(
        parts,
        numbers={**parts.numbers, "preregistration": numbers},
        lines=(*parts.lines, *(f"deviation: {a}: {text}" for a, text in found)),
        blocks=(*parts.blocks[:place], *section, *parts.blocks[place:]),
    )


def _section(
    plan: Preregistration, results: list[str], found: tuple[Deviation, ...]
) -> Iterator[ReportBlock]:
    yield Heading("Preregistration")
    yield Paragraph(
        f"The plan was written on {_day(plan)} with {plan.program}, "
        f"{_before(plan)}; its SHA-256 is {plan.sha256}."
    )
    for text, result in zip(plan.hypotheses, results, strict=True):
        yield Paragraph(f"Hypothesis: {text}. {result}")
    compared = (
        "participants, definition, sessions, clips, orders, exclusions and analysis"
    )
    if not found:
        yield Paragraph(f"No deviation from the plan was found ({compared} compared).")
    for about, text in found:
        yield Paragraph(f"Deviation ({about}): {text}.")


def _result(text: str, numbers: Mapping[str, Any]) -> str:
    """What the signed-rank test says of a hypothesis."""
    claim = hypothesis_of(text)
    if claim is None or not numbers.get("wilcoxon", {}).get(claim.measure):
        return "It is not tested by the program."
    tested, more = _compared(claim, numbers)
    if tested is None or tested["p_holm"] is None:
        return "It could not be tested."
    is_clear = tested["p_holm"] <= ALPHA
    word = "supported" if more > 0.0 else "contradicted"
    return (
        f"It was {word if is_clear else 'not supported'}: mean of {claim.higher} less "
        f"{claim.lower} {number(more)}, Wilcoxon's signed-rank test, p (Holm) "
        f"{p_value(tested['p_holm'])}."
    )


def _compared(
    claim: ExpectedOrder, numbers: Mapping[str, Any]
) -> tuple[Mapping[str, Any] | None, float]:
    """The test of a claim, and by how much the mean is larger where it is expected."""
    levels = numbers.get("levels", {}).get(claim.measure, {})
    pair = claim.higher, claim.lower
    if claim.higher not in levels:
        of = (
            numbers["qoe"]
            if claim.measure == QOE
            else numbers["factors"][claim.measure]
        )
        tests = numbers["wilcoxon"][claim.measure]
        return _test_in(tests, pair), of[claim.higher]["mean"] - of[claim.lower]["mean"]
    tests = numbers["factor_pairs"][claim.measure] or {}
    means = [
        {name: one["mean"] for name, one in levels[level].items()} for level in pair
    ]
    if any(one is None for each in means for one in each.values()):
        return None, 0.0
    if claim.difference is None:
        first, second = (sum(each.values()) / len(each) for each in means)
        return _test_in(tests, pair), first - second
    more, less = claim.difference
    first, second = (each[more] - each[less] for each in means)
    names = (f"{less}-{more}, ", f"{more}-{less}, ")
    found = (_test_in(tests, pair, name) for name in names)
    return next((one for one in found if one), None), first - second


def _test_in(
    tests: Mapping[str, Any], pair: tuple[str, str], before: str = ""
) -> Mapping[str, Any] | None:
    """The result for a pair, in whichever order it was compared."""
    first, second = pair
    names = f"{before}{first}-{second}", f"{before}{second}-{first}"
    return next((tests[name] for name in names if name in tests), None)


def _day(plan: Preregistration) -> str:
    return f"{plan.written_utc[:10]} at {plan.written_utc[11:16]} UTC"


def _before(plan: Preregistration) -> str:
    if not plan.sessions_before:
        return "before the first session"
    return f"after {plan.sessions_before} sessions"


def plan_document(
    plan: Preregistration, definition: Definition
) -> Iterator[ReportBlock]:
    """The plan for people and registries."""
    yield from numbered(_document(plan, definition))


def _document(plan: Preregistration, definition: Definition) -> Iterator[ReportBlock]:
    yield Paragraph(
        f"Preregistration of the study {plan.study}, written on {_day(plan)} with "
        f"{plan.program}, {_before(plan)}. SHA-256 of its content: {plan.sha256}."
    )
    yield Heading("Hypotheses")
    if not plan.hypotheses:
        yield Paragraph("No hypothesis: the study is exploratory.")
    for place, text in enumerate(plan.hypotheses, 1):
        yield Paragraph(f"H{place}: {text}.{_test_of(text)}")
    yield from _design(definition)
    yield from _participants(plan)
    yield Heading("Exclusion")
    yield Paragraph(_exclusion(plan, definition))
    yield from _analysis(plan)


def _test_of(text: str) -> str:
    is_tested = hypothesis_of(text) is not None
    return " Tested by Wilcoxon's signed-rank test (Holm)." if is_tested else ""


def _design(definition: Definition) -> Iterator[ReportBlock]:
    yield Heading("Design")
    sequences = [one.key for one in definition.sequences]
    kind = definition.trial.value.replace("-", " ")
    yield Paragraph(
        f"Within participants, {len(definition.conditions)} trials ({kind}): sequences "
        f"{listed(sequences)}, each with the feedbacks {listed(definition.feedback_keys)}. "
        "Participants are never told the condition; the operator "
        f"{'is not told it either' if definition.operator_is_blind else 'sees it'}."
    )
    if factors := definition.sequence_factors:
        levels = zip(*factors.values(), strict=True)
        of = tuple((key, *row) for key, row in zip(sequences, levels, strict=True))
        yield ReportTable("Factors of the sequences", ("sequence", *factors), of)
    feedbacks = tuple((one.name, one.text) for one in definition.chosen_feedbacks)
    yield ReportTable("Feedbacks", ("feedback", "force"), feedbacks)
    rows = tuple(_questions(definition))
    head = ("question", "shown", "kind", "range", "wording")
    yield ReportTable("Questions", head, rows)
    live = tuple(_live(definition))
    if live:
        heads = ("rating", "by", "range", "stops the clip at", "wording")
        yield ReportTable("Ratings while the clips play", heads, live)
    if definition.gap_s:
        yield Paragraph(f"At least {definition.gap_s:g} s lie between two clips.")
    scores = tuple(
        (score.key, score.text, formula_of(score))
        for page in definition.pages
        for score in page.scores
    )
    if scores:
        yield ReportTable("Scores", ("score", "what", "from"), scores)
    method = ORDERS.get(definition.order.method.value, definition.order.method.value)
    apart = ", no sequence twice in a row"
    yield Paragraph(
        f"Orders are {method} (seed {definition.order.seed}"
        f"{apart if definition.order.no_sequence_twice_in_a_row else ''})."
    )


def _questions(definition: Definition) -> Iterator[tuple[str, ...]]:
    language = definition.languages[0]
    for page in definition.pages:
        for asked in page.questions:
            limits = range_of(asked)
            yield (
                asked.key,
                str(page.when).replace("-", " "),
                asked.kind.value,
                f"{limits[0]} to {limits[1]}" if limits else "-",
                definition.wording(asked, language),
            )


def _live(definition: Definition) -> Iterator[tuple[str, ...]]:
    for one in definition.while_watching:
        every = f", each {one.every_s:g} s" if one.every_s else ""
        yield (
            one.key,
            f"{one.kind.value.replace('-', ' ')}{every}",
            "-" if one.least is None else f"{one.least} to {one.most}",
            "-" if one.stop_at is None else str(one.stop_at),
            one.text[definition.languages[0]],
        )


def _participants(plan: Preregistration) -> Iterator[ReportBlock]:
    yield Heading("Participants and stop rule")
    yield Paragraph(f"Planned number of participants: {plan.participants}.")
    yield Paragraph(plan.stop_rule)
    if plan.power is None:
        yield Paragraph(f"No power is stated: {plan.without_power}")
        return
    power = plan.power
    rows = tuple((name, number(share)) for name, share in power.of.items())
    yield ReportTable(
        f"Power of {plan.participants} participants",
        ("test", "power"),
        rows,
        f"{power.measure}, {power.population}, alpha {power.alpha:g}, "
        f"{power.studies} simulated studies. {power.tests}.",
    )


def _exclusion(plan: Preregistration, definition: Definition) -> str:
    limits = definition.limits
    options = plan.analysis
    kept = "are kept" if options.include_invalid else "count as missing"
    rules = " ".join(f"{rule.rstrip('.')}." for rule in plan.exclusions)
    return (
        "The playback of a trial is not valid if the safety contract stopped the force, if "
        f"more than {100.0 * limits.dropped_share:g} % of the frames were dropped, more than "
        f"{limits.silence_s:g} s of sound or {100.0 * limits.missed_share:g} % of the periods "
        f"of the haptic loop were missing, or force and video or sound were more than "
        f"{limits.sync_ms:g} ms apart. Answers to such trials {kept}. "
        f"{_MISSING[MissingPolicy(options.missing_answers)]} {rules}"
    ).rstrip()


def _analysis(plan: Preregistration) -> Iterator[ReportBlock]:
    planned = plan.analysis
    yield Heading("Analysis")
    yield Paragraph(
        f"The analysis of {plan.program}, {planned.resamples} resamples from the seed "
        f"{planned.seed}, significance level {ALPHA:g}, p corrected by Holm's method: "
        f"{'; '.join(planned.statistics)}."
    )
    versions = ", ".join(f"{name} {one}" for name, one in planned.versions.items())
    yield Paragraph(
        f"SHA-256 of the analysis: {planned.sha256}; versions: {versions}. The report "
        "states each deviation from this plan."
    )


def planned_power(
    population: str, measure: str, summaries: Sequence[Mapping[str, Any]], size: int
) -> PlannedPower:
    """The power of a number of participants, from each `power_summary`."""
    summary = summaries[0]
    of = {
        name: row[one["participants"].index(size)]
        for one in summaries
        for name, row in one["curves"].items()
    }
    return PlannedPower(
        population=population,
        measure=measure,
        alpha=summary["alpha"],
        studies=summary["studies"],
        tests="; ".join(str(one["tests"]) for one in summaries),
        of=of,
    )
