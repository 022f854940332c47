"""Events of a recording: found and offered, never applied.

Detectors are a registry; command line, editor and benchmark read it. Precision and recall
on simulated rides: `python -m benchmarks.haptics events`.
"""

from collections.abc import Callable, Collection
from dataclasses import dataclass

from hapticplayer.errors import InputError, Message, entry_named
from hapticplayer.model import ImuLog, MotionTrack
from hapticplayer.rendering.event import Event, EventInputs
from hapticplayer.rendering.flawed_spans import artefacts, saturation, stillness
from hapticplayer.rendering.low_sound import LowSound
from hapticplayer.rendering.manoeuvres import hard_braking, turns
from hapticplayer.rendering.shocks import impacts


@dataclass(frozen=True, slots=True)
class Detector:
    """Finds one kind of events.

    Attributes:
        name: of the kind.
        title: for people, a word.
        text: for people, what is found.
        find: returns the events in the order of time.
    """

    name: str
    title: Message
    text: Message
    find: Callable[[EventInputs], list[Event]]


DETECTORS: tuple[Detector, ...] = (
    Detector(
        "impact",
        Message("Impact"),
        Message("Shocks that stand out of what surrounds them"),
        impacts,
    ),
    Detector(
        "braking",
        Message("Braking"),
        Message("Speed is lost at 0.3 g or more"),
        hard_braking,
    ),
    Detector(
        "turn", Message("Turn"), Message("Bends with 0.15 g or more sideways"), turns
    ),
    Detector(
        "stillness",
        Message("Stillness"),
        Message("A second or more without motion"),
        stillness,
    ),
    Detector(
        "saturation",
        Message("Saturation"),
        Message("A sensor at the end of its range"),
        saturation,
    ),
    Detector(
        "artefact",
        Message("Artefact"),
        Message("Missing samples and isolated spikes"),
        artefacts,
    ),
)


def find_events(
    motion: MotionTrack,
    imu: ImuLog | None = None,
    sound: LowSound | None = None,
    *,
    kinds: Collection[str] | None = None,
) -> tuple[Event, ...]:
    """Return the events of a recording, by their start.

    Args:
        motion: in media time.
        imu: its log in media time; without one no saturation is found.
        sound: of the clip; confirms impacts.
        kinds: names of detectors; all if None.
    """
    known = {detector.name: detector for detector in DETECTORS}
    for kind in kinds or ():
        entry_named(known, kind, Message("kind of event"))
    if len(motion) < 2 or (imu is not None and len(imu) < 2):
        raise InputError("there is no motion to find events in")
    inputs = EventInputs(motion, imu, sound)
    found = [
        event
        for detector in DETECTORS
        if kinds is None or detector.name in kinds
        for event in detector.find(inputs)
    ]
    return tuple(sorted(found, key=lambda one: (one.start_s, one.end_s)))
