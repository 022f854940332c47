"""The plan of a study that is written before its data, and what was done otherwise."""

import json
import re
from collections.abc import Callable, Iterator, Sequence
from typing import Annotated, Any, Literal, NamedTuple

import msgspec
from msgspec import Meta

from hapticplayer import __version__, storage
from hapticplayer.clock import utc_now_iso
from hapticplayer.errors import StudyError, UsageError, counted
from hapticplayer.structures import convert, read_json
from hapticplayer.study.definition import (
    Definition,
    JsonObject,
    Key,
    Line,
    OrderMethod,
    read_file,
)
from hapticplayer.study.orders import ORDERS, random_order, rows_of
from hapticplayer.study.sequence_folders import clip_checksums
from hapticplayer.study.session_folder import SessionState, StoredSession, sha256
from hapticplayer.study.study_folder import Study

PLAN_FILE = "preregistration.json"
_TESTABLE = re.compile(r"(\S+): (?:(\S+) less (\S+): )?(\S+) ([<>]) (\S+)")
_MOST_SHOWN, _MOST_TEXT = 20, 60


class PlannedPower(JsonObject, frozen=True, kw_only=True):
    """The power of the planned number of participants, by test.

    Attributes:
        population: whom the simulated studies asked.
        measure: that was simulated.
        alpha: significance level.
        studies: that were simulated.
        tests: in words.
        of: share of studies in which each test was significant.
    """

    population: str
    measure: str
    alpha: float
    studies: int
    tests: str
    of: dict[str, float]


class PlannedAnalysis(JsonObject, frozen=True, kw_only=True):
    """Options and identity of the analysis.

    Attributes:
        missing_answers, include_invalid, seed, resamples: options.
        statistics: titles.
        sha256: of the program's analysis.
        versions: of the program and its libraries.
    """

    missing_answers: str
    include_invalid: bool
    seed: int
    resamples: int
    statistics: tuple[str, ...]
    sha256: str
    versions: dict[str, str]


class Preregistration(JsonObject, frozen=True, kw_only=True):
    """The plan.

    Attributes:
        study: id.
        written_utc: ISO 8601.
        program: that wrote it.
        design: the definition, without the folders of its sequences.
        clips: SHA-256 of each sequence's description, where it was known.
        orders_sha256: of `orders.csv`; empty for other methods.
        hypotheses: in words, or as "measure: feedback > feedback".
        participants: planned number.
        power: of that number; None where `without_power` says why.
        stop_rule: when data collection ends.
        exclusions: rules beside those of the program.
        analysis: of the data.
        sessions_before: participants who had taken part already.
        sha256: of all this.
    """

    schema: Literal["hapticplayer.preregistration"] = "hapticplayer.preregistration"
    version: Literal[1] = 1
    study: Key
    written_utc: str
    program: str
    design: dict[str, Any]
    clips: dict[str, str]
    orders_sha256: str
    hypotheses: tuple[Line, ...]
    participants: Annotated[int, Meta(ge=1, le=10**6)]
    power: PlannedPower | None
    without_power: str
    stop_rule: Line
    exclusions: tuple[Line, ...]
    analysis: PlannedAnalysis
    sessions_before: int
    sha256: str = ""

    @property
    def digest(self) -> str:
        content = msgspec.to_builtins(msgspec.structs.replace(self, sha256=""))
        return sha256(json.dumps(content, sort_keys=True).encode())

    def signed(self) -> "Preregistration":
        return msgspec.structs.replace(self, sha256=self.digest)


class Deviation(NamedTuple):
    """What was done otherwise than planned."""

    about: str
    text: str


class Registered(NamedTuple):
    """A plan, and how sessions and definition differ from it."""

    plan: Preregistration
    deviations: tuple[Deviation, ...]


class ExpectedOrder(NamedTuple):
    """A hypothesis that can be tested: one feedback or level has higher values than another.

    `difference` is of two feedbacks, first less second, that is higher at one level.
    """

    measure: str
    higher: str
    lower: str
    difference: tuple[str, str] | None = None


def hypothesis_of(text: str) -> ExpectedOrder | None:
    """What a text such as "qoe: realistic > none" claims; None for other words.

    With factors of the sequences also "qoe: first > third", and "qoe: realistic less none:
    first > third".
    """
    found = _TESTABLE.fullmatch(text.strip())
    if found is None:
        return None
    measure, more, less, first, sign, second = found.groups()
    pair = (first, second) if sign == ">" else (second, first)
    return ExpectedOrder(measure, *pair, (more, less) if more else None)


def check_hypotheses(
    texts: Sequence[str], measures: Sequence[str], definition: Definition
) -> None:
    """Refuse those that name a measure, feedback or level that the study does not have."""
    feedbacks = definition.feedback_keys
    for text in texts:
        if (claim := hypothesis_of(text)) is None:
            continue
        factors = [
            tuple(dict.fromkeys(o)) for o in definition.sequence_factors.values()
        ]
        of_higher = [each for each in factors if claim.higher in each]
        if claim.difference is not None:
            of_higher = of_higher or [tuple(one for each in factors for one in each)]
        compared = of_higher[0] if of_higher else feedbacks
        for name, known in (
            (claim.measure, measures),
            *((one, feedbacks) for one in claim.difference or ()),
            (claim.higher, compared),
            (claim.lower, compared),
        ):
            if name not in known:
                raise UsageError(
                    "hypothesis {text!r}: there is no {name!r}; choose one of {known}",
                    text=text,
                    name=name,
                    known=", ".join(known),
                )


class Intentions(NamedTuple):
    """What only people know of a plan; `power` is why there is none where it is a text."""

    hypotheses: Sequence[str]
    participants: int
    power: PlannedPower | str
    stop_rule: str
    exclusions: Sequence[str]


def write_plan(
    study: Study, intended: Intentions, analysis: PlannedAnalysis
) -> Preregistration:
    """Write the plan into the study's folder, once."""
    path = study.folder / PLAN_FILE
    storage.refuse_existing(path)
    power = intended.power
    has_clips = all(one.folder for one in study.definition.sequences)
    plan = Preregistration(
        study=study.definition.id,
        written_utc=utc_now_iso("seconds"),
        program=f"hapticplayer {__version__}",
        design=design_of(study.definition),
        clips=clip_checksums(study) if has_clips else {},
        orders_sha256=_orders_digest(study),
        hypotheses=tuple(intended.hypotheses),
        participants=intended.participants,
        power=None if isinstance(power, str) else power,
        without_power=power if isinstance(power, str) else "",
        stop_rule=intended.stop_rule,
        exclusions=tuple(intended.exclusions),
        analysis=analysis,
        sessions_before=len(study.codes()),
    )
    # what could not be read again is not written
    described = json.loads(storage.json_text(msgspec.to_builtins(plan), "replace"))
    plan = convert(described, Preregistration, str(path), StudyError).signed()
    storage.write_private(path, storage.json_text(msgspec.to_builtins(plan)))
    return plan


def read_registered(
    study: Study, sessions: Sequence[StoredSession]
) -> Registered | None:
    """The plan in the study's folder with the deviations of its sessions.

    Raises:
        StudyError: when it is damaged or of another study.
    """
    path = study.folder / PLAN_FILE
    if not path.exists():
        return None
    plan = read_json(path, Preregistration, StudyError)
    if plan.study != study.definition.id:
        raise StudyError(
            "is the plan of the study {found}, not {expected}",
            where=str(path),
            remedy="move it to its own study",
            found=plan.study,
            expected=study.definition.id,
        )
    return Registered(plan, tuple(_deviations(plan, study, sessions)))


def design_of(definition: Definition) -> dict[str, Any]:
    """What of a definition is the design: all but where its sequences lie."""
    design: dict[str, Any] = json.loads(msgspec.json.encode(definition))
    for sequence in design["sequences"]:
        del sequence["folder"]
    return design


def _orders_digest(study: Study) -> str:
    is_listed = study.definition.order.method is OrderMethod.LIST
    return sha256(read_file(study.folder / ORDERS)) if is_listed else ""


def _deviations(
    plan: Preregistration, study: Study, sessions: Sequence[StoredSession]
) -> Iterator[Deviation]:
    if plan.sha256 != plan.digest:
        yield Deviation("plan", f"{PLAN_FILE} was altered after it was written")
    for text in _shown(differences(plan.design, design_of(study.definition))):
        yield Deviation("definition", text)
    checks: tuple[tuple[str, str, Callable[[StoredSession], bool]], ...] = (
        (
            "sessions",
            "began before the plan was written",
            lambda one: one.plan.created_utc[:19] < plan.written_utc[:19],
        ),
        (
            "definition",
            "followed another definition",
            lambda one: design_of(one.definition) != plan.design,
        ),
        (
            "clips",
            "played other clips",
            lambda one: any(
                one.plan.clips.get(key, known) != known
                for key, known in plan.clips.items()
            ),
        ),
        ("orders", "had an order that the plan does not make", _has_other_order(study)),
    )
    for about, text, is_other in checks:
        if count := sum(map(is_other, sessions)):
            yield Deviation(about, f"{_of(count, sessions)} {text}")
    if plan.orders_sha256 != _orders_digest(study):
        yield Deviation("orders", f"{ORDERS} has changed")
    for text in _exclusions(plan, study, sessions):
        yield Deviation("exclusions", text)


def _of(count: int, sessions: Sequence[StoredSession]) -> str:
    return f"{count} of {len(sessions)} sessions"


def _has_other_order(study: Study) -> Callable[[StoredSession], bool]:
    definition, method = study.definition, study.definition.order.method
    if method is OrderMethod.RANDOM:
        return lambda one: one.plan.order != random_order(definition, one.code)
    is_listed = method is OrderMethod.LIST
    known = set(study.listed_orders() if is_listed else rows_of(definition))
    return lambda one: one.plan.order not in known


def _exclusions(
    plan: Preregistration, study: Study, sessions: Sequence[StoredSession]
) -> Iterator[str]:
    """What is missing in the data for reasons that the plan does not name."""
    foreseen = {text.casefold() for text in plan.exclusions}
    for session in sessions:
        for record in session.records.intact:
            reason = str(record.content.get("reason") or "no reason given")
            if reason.casefold() in foreseen:
                continue
            if record.kind == "end" and session.state is SessionState.STOPPED:
                yield f"session {session.code} was ended early: {reason}"
            elif record.kind == "skip":
                step = record.content.get("step")
                yield f"{step} of session {session.code} was skipped: {reason}"
        if session.state is SessionState.UNFINISHED:
            yield f"session {session.code} was not completed"
    if deleted := study.deleted_count():
        yield f"{counted(deleted, 'participant')} deleted"


def differences(planned: Any, found: Any, at: str = "") -> Iterator[str]:
    """Yield each place at which JSON differs, with both values."""
    if isinstance(planned, dict) and isinstance(found, dict):
        for key in dict.fromkeys((*planned, *found)):
            place = f"{at}.{key}" if at else str(key)
            yield from differences(planned.get(key), found.get(key), place)
    elif isinstance(planned, list) and isinstance(found, list):
        if len(planned) != len(found):
            yield f"{at}: {len(planned)} entries were planned, there are {len(found)}"
        for number, (one, other) in enumerate(zip(planned, found, strict=False)):
            yield from differences(one, other, f"{at}[{number}]")
    elif planned != found:
        yield f"{at}: {_brief(planned)} was planned, it is {_brief(found)}"


def _brief(value: Any) -> str:
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= _MOST_TEXT else f"{text[: _MOST_TEXT - 3]}..."


def _shown(texts: Iterator[str]) -> Iterator[str]:
    found = list(texts)
    yield from found[:_MOST_SHOWN]
    if len(found) > _MOST_SHOWN:
        yield f"and {len(found) - _MOST_SHOWN} more differences"
