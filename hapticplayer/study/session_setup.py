"""Loading the sequences of a study for a session."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hapticplayer import __version__
from hapticplayer.clock import Clock
from hapticplayer.devices.capabilities import FALCON
from hapticplayer.errors import InputError, Message, StudyError, UsageError, message_of
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.model import Feedback, ForceTrack
from hapticplayer.model.mapping import DEFAULT_FORCE_LIMIT_N
from hapticplayer.playback.conditions import Other, feedback_track
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import Source, open_source
from hapticplayer.playback.video_check import Verdict
from hapticplayer.rendering.demonstration import demonstration
from hapticplayer.storage import cache_root
from hapticplayer.study.definition import refuse
from hapticplayer.study.definition_reader import DEFINITION, to_be_worded
from hapticplayer.study.player_stage import PlayerStage
from hapticplayer.study.sequence_folders import (
    clip_checksums,
    refuse_estimates,
    sequence_folder,
)
from hapticplayer.study.session_folder import StoredSession
from hapticplayer.study.sites import check_package
from hapticplayer.study.study_folder import Study

if TYPE_CHECKING:
    from hapticplayer.capture.live.source import OpenedSource

NAME = "demonstration"
RATE_HZ, WIDTH, HEIGHT = 25, 640, 360
STRENGTHS = (0.5, 1.0)
"""As shares of the largest force: a session has less time than the page of a device."""
_GROUND, _DISC = np.array([20, 23, 27]), np.array([74, 168, 255])
_RADIUS_PX, _TRAVEL_PX, _GROWTH = 40.0, 110.0, 0.7


@dataclass(frozen=True, slots=True, eq=False)
class StudySources:
    """The sources of a study.

    Attributes:
        sources: of its sequences, by key.
        demonstration: of the device.
        clips: SHA-256 of each sequence's description.
    """

    sources: Mapping[str, Source]
    demonstration: Source
    clips: Mapping[str, str]


def load_study_sources(study: Study) -> StudySources:
    """Open the sequences of a study and make the tracks of their feedbacks."""
    check_package(study)
    clips = clip_checksums(study)
    path = str(study.folder / DEFINITION)
    refuse_estimates(study.definition, path, study.folder)
    for field in to_be_worded(study.definition):
        refuse(path, field, Message("is to be worded"), Message("enter the wording"))
    opened = {
        sequence.key: open_source(sequence_folder(study, sequence.key))
        for sequence in study.definition.sequences
    }
    for source in opened.values():
        _refuse_another_video(source)
    sources = {
        key: replace(source, tracks=_tracks(study, key, opened))
        for key, source in opened.items()
    }
    return StudySources(sources, demonstration_source(), clips)


def _refuse_another_video(source: Source) -> None:
    if source.check is not None and source.check.wait() is Verdict.ANOTHER:
        raise StudyError(
            "its clip has changed since it was imported (its checksum differs)",
            where=str(source.path),
            remedy="copy the sequence again or import it again",
        )


def _tracks(
    study: Study, key: str, opened: Mapping[str, Source]
) -> dict[str, ForceTrack]:
    """Return the tracks of a sequence by the names of the study's feedbacks."""
    made = {}
    for number, one in enumerate(study.definition.chosen_feedbacks):
        try:
            made[one.name] = feedback_track(
                *(opened[key], one.condition, one.parameters), others_of(opened, key)
            )
        except (InputError, UsageError) as problem:
            raise StudyError(
                "the sequence {key!r}: {reason}",
                where=f"{study.folder / DEFINITION}, feedbacks[{number}]",
                key=key,
                reason=message_of(problem),
            ) from problem
    _check_edited(study, key, made)
    return made


def others_of(opened: Mapping[str, Source], key: str) -> Other:
    """What returns the force of another sequence; the next if none is wanted."""

    def other(wanted: str) -> ForceTrack:
        keys = [*opened, *opened]
        after = keys[keys.index(key) + 1]
        found = after if wanted in ("", key) else wanted
        return opened[found].tracks[Feedback.REALISTIC]

    return other


def _check_edited(study: Study, key: str, made: Mapping[str, ForceTrack]) -> None:
    """Refuse to compare an edited force with itself."""
    chosen = study.definition.chosen_feedbacks
    edited = [one for one in chosen if one.condition == "edited"]
    for one in edited:
        for other in chosen:
            if other is not one and made[other.name] is made[one.name]:
                raise StudyError(
                    "in the sequence {key!r}, {one!r} and {other!r} are the same force",
                    where=str(study.folder / DEFINITION),
                    remedy='give "realistic" the parameter "effects": "off"',
                    key=key,
                    one=one.name,
                    other=other.name,
                )


def check_unchanged(session: StoredSession, study_sources: StudySources) -> None:
    """Refuse to resume a session with changed sequences."""
    for key, checksum in session.plan.clips.items():
        if study_sources.clips.get(key) != checksum:
            raise StudyError(
                "the sequence {key!r} has changed since this session began",
                where=session.code,
                remedy="restore the old sequence, or stop this session",
                key=key,
            )


def make_stage(
    study: Study,
    study_sources: StudySources,
    player: Player,
    clock: Clock,
    record: str,
    sensor: "OpenedSource | None" = None,
) -> PlayerStage:
    """A stage for a session, whose demonstration a sensor gives if there is one."""
    rules = (study.definition.limits, study.definition.checks)
    sources, demonstration = study_sources.sources, study_sources.demonstration
    parts = (player, sources, demonstration, rules, clock, record)
    if sensor is None:
        return PlayerStage(*parts)
    from hapticplayer.study.felt_demonstration import FeltStage

    return FeltStage(*parts, sensor=sensor)


def demonstration_source() -> Source:
    """The demonstration as a source; its clip is made on first use."""
    track, _steps = demonstration(FALCON, STRENGTHS)
    path = cache_root() / f"{NAME}-{__version__}.mp4"
    if not path.exists():
        write_clip(path, _frames(track), frame_rate_hz=RATE_HZ)
    return Source(NAME, path, probe(path), {NAME: track}, None, NAME)


def _frames(track: ForceTrack) -> Iterator[NDArray[np.uint8]]:
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH]
    times = np.arange(0.0, track.time_s[-1], 1.0 / RATE_HZ)
    for right, up, near in track.at(times) / DEFAULT_FORCE_LIMIT_N:
        centre_x = WIDTH / 2 + _TRAVEL_PX * right
        centre_y = HEIGHT / 2 - _TRAVEL_PX * up
        radius = _RADIUS_PX * (1.0 + _GROWTH * near)
        inside = np.clip(radius - np.hypot(x - centre_x, y - centre_y), 0.0, 1.0)
        frame = _GROUND + inside[..., None] * (_DISC - _GROUND)
        yield frame.astype(np.uint8)
