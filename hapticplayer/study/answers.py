"""What participants answered, as values: all that an analysis needs to know."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Rating:
    """One factor of one condition, rated by one participant.

    Attributes:
        participant: code.
        sequence: key of the sequence in the definition.
        feedback: "realistic", "none", "random", or another of the definition's.
        factor: "realism", "sensory", "comfort", "satisfaction", or the definition's own.
        value: 1 to 5; None where it is missing.
        sound: whether the playback that was rated was without a fault.
    """

    participant: str
    sequence: str
    feedback: str
    factor: str
    value: int | None
    sound: bool


@dataclass(frozen=True, slots=True)
class Judgement:
    """Whether one participant felt a shifted or scaled force as consistent.

    Attributes:
        participant: code.
        sequence: key of the sequence.
        delay_s: by which the force came later than the picture, s.
        gain: of the force, 1 as recorded.
        consistent: the answer; None where it is missing.
        sound: whether the playback that was judged was without a fault.
    """

    participant: str
    sequence: str
    delay_s: float
    gain: float
    consistent: bool | None
    sound: bool


@dataclass(frozen=True, slots=True)
class OpenAnswer:
    """An answer in words; nobody has seen it yet who could tell if it names someone.

    Attributes:
        participant: code.
        question: key of the question in the definition.
        feedback: that the answer is about; empty where it is about all.
        text: as written.
        reviewed: whether a person has read it and let it pass for export.
    """

    participant: str
    question: str
    feedback: str
    text: str
    reviewed: bool


@dataclass(frozen=True, slots=True)
class Participant:
    """Who answered; None where it was not told.

    Attributes:
        code: made by the program.
        age: years.
        gender: the definition's word for it.
        handedness: the definition's word for it.
        used_device_before: whether the device was known.
        complete: whether the session came to its end.
    """

    code: str
    age: int | None
    gender: str | None
    handedness: str | None
    used_device_before: bool | None
    complete: bool = True


@dataclass(frozen=True, slots=True)
class Answers:
    """All answers of a study; names are keys in the order of the definition.

    Every participant who began a trial is in `participants`, and every planned
    condition of theirs in `ratings`: what is missing has the value None.

    Attributes:
        participants: in order of their sessions.
        ratings: by participant, then in order of the definition.
        sequences: keys.
        feedbacks: keys.
        factors: keys.
        open_answers: in words.
        judgements: of the second type of trial.
        remarks: what could not be read, or was left out, one sentence each.
    """

    participants: tuple[Participant, ...]
    ratings: tuple[Rating, ...]
    sequences: tuple[str, ...]
    feedbacks: tuple[str, ...]
    factors: tuple[str, ...]
    open_answers: tuple[OpenAnswer, ...] = ()
    judgements: tuple[Judgement, ...] = ()
    remarks: tuple[str, ...] = ()
