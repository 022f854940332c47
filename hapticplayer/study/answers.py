"""What the participants of a study have answered, apart from how it is stored."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Rating:
    """One factor of one condition, rated by one participant.

    Attributes:
        participant: the code.
        sequence: the name of the sequence.
        feedback: "realistic", "none", "random" or the definition's own.
        factor: "realism", "sensory", "comfort", "satisfaction" or the definition's own.
        value: 1 to 5; None where the answer is missing.
        sound: the playback of the trial was sound.
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
class Participant:
    """Who answered, by code; None where it was not said."""

    code: str
    age: int | None
    gender: str | None
    handedness: str | None
    used_device_before: bool | None
    complete: bool = True


@dataclass(frozen=True, slots=True)
class Answers:
    """All ratings of a study, and the design they belong to."""

    participants: tuple[Participant, ...]
    ratings: tuple[Rating, ...]
    sequences: tuple[str, ...]
    feedbacks: tuple[str, ...]
    factors: tuple[str, ...]
    judgements: tuple[Judgement, ...] = ()
    remarks: tuple[str, ...] = ()
