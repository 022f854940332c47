"""The events of a sequence, from its motion, its log and the sound of its clip."""

from collections.abc import Collection
from pathlib import Path

from hapticplayer.capture.sync.synchronize import read_sound
from hapticplayer.rendering.event import Event
from hapticplayer.rendering.events import find_events
from hapticplayer.rendering.low_sound import LowSound, low_sound
from hapticplayer.sequence import store


def events_of(
    folder: str | Path,
    *,
    kinds: Collection[str] | None = None,
    with_sound: bool = True,
) -> tuple[Event, ...]:
    """Return the events of a sequence that lie in its clip, by their start.

    Args:
        folder: of the sequence.
        kinds: names of `rendering.events.DETECTORS`; all if None.
        with_sound: whether the sound confirms impacts, if the clip has any.
    """
    sequence = store.open_sequence(folder)
    sound = sound_of(sequence) if with_sound else None
    has_log = store.IMU in sequence.description.files
    imu = store.recorded_log(sequence) if has_log else None
    events = find_events(store.motion_of(sequence), imu, sound, kinds=kinds)
    end_s = sequence.duration_s
    return tuple(
        event.within(end_s)
        for event in events
        if event.end_s > 0.0 and event.start_s < end_s
    )


def sound_of(sequence: store.Sequence) -> LowSound | None:
    """Return the low part of a sequence's sound; None without sound."""
    if not sequence.description.clip.has_audio:
        return None
    sound = read_sound(sequence.clip)
    return low_sound(sound.samples, sound.rate_hz)
