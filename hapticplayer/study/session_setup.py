"""Loading the sequences of a study for a session."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from hapticplayer.clock import Clock
from hapticplayer.errors import InputError, StudyError, UsageError, message_of
from hapticplayer.model import Feedback, ForceTrack
from hapticplayer.playback.conditions import Other, feedback_track
from hapticplayer.playback.player import Player
from hapticplayer.playback.source import Source, open_source
from hapticplayer.playback.video_check import Verdict
from hapticplayer.study.definition_reader import DEFINITION
from hapticplayer.study.demonstration import demonstration_source
from hapticplayer.study.estimates import refuse_estimates
from hapticplayer.study.sequence_folders import clip_checksums, sequence_folder
from hapticplayer.study.session_folder import StoredSession
from hapticplayer.study.stage import PlayerStage
from hapticplayer.study.study_folder import Study


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
    clips = clip_checksums(study)
    refuse_estimates(study.definition, str(study.folder / DEFINITION), study.folder)
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
    study: Study, study_sources: StudySources, player: Player, clock: Clock, record: str
) -> PlayerStage:
    rules = (study.definition.limits, study.definition.checks)
    sources, demonstration = study_sources.sources, study_sources.demonstration
    return PlayerStage(player, sources, demonstration, rules, clock, record)
