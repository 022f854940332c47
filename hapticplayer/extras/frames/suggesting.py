"""What a sequence is made of whose motion was estimated from the picture."""

from pathlib import Path

from hapticplayer.capture import read_recording
from hapticplayer.capture.recording import refuse_gravity_free
from hapticplayer.capture.source import LogPath
from hapticplayer.errors import InputError, Message, Progress, UsageError, joined
from hapticplayer.media.clip_info import ClipInfo
from hapticplayer.model import ClockMap, Mapping
from hapticplayer.sequence.writing import ESTIMATE, Content

SOURCE = Message("estimated from the picture")
WHAT_IT_IS = Message(
    "the motion was estimated from the picture, nothing measured it: its strength is a "
    "guess, and studies refuse it unless they name the feedback 'estimated'"
)


def suggested(
    clip: ClipInfo,
    log: LogPath | None,
    gain: float,
    mapping: Mapping,
    progress: Progress,
) -> Content:
    """Return the motion that the frames of a clip suggest.

    Args:
        clip: the video.
        log: must be None, see Raises.
        gain: factor on the estimate, set by hand.
        mapping: must not have a lever arm, see Raises.
        progress: called while the frames are followed; raises Cancelled to stop.
    """
    if log is not None or _is_recorded(clip.path):
        raise UsageError(
            "the motion of {name} was recorded, which is better than an estimate from the "
            "picture; import it without an estimate",
            name=clip.path.name,
        )
    if mapping.moves_point:
        raise UsageError("a lever arm needs the angular rate of the recording")
    from hapticplayer.extras.frames import estimate

    found = estimate.suggest_motion(clip.path, gain=gain, progress=progress)
    if not found.motion.acceleration_mps2.any():
        raise InputError(
            "no motion can be estimated from its picture ({why})",
            where=clip.path.name,
            why=joined(Message("; "), found.notes),
        )
    sway, bounce = (float(value) for value in found.trust.mean(axis=0))
    provenance = {
        "motion_source": str(SOURCE),
        "camera": "",
        "conditioning": [],
        ESTIMATE: {
            "gain": gain,
            "height_m": estimate.HEIGHT_M,
            "below_hz": estimate.TOP_HZ,
            "sway_trust": sway,
            "bounce_trust": bounce,
        },
    }
    arrays = {
        "time_s": found.motion.time_s,
        "sigma_mps2": found.sigma_mps2,
        "trust": found.trust,
    }
    notes = (WHAT_IT_IS, *found.notes)
    return Content(
        found.motion, ClockMap(), None, notes, provenance, {ESTIMATE: arrays}
    )


def _is_recorded(video: Path) -> bool:
    """Whether a clip holds a recording that can be imported."""
    try:
        refuse_gravity_free(read_recording(video))
    except InputError:
        return False
    except UsageError:  # readable, once a decision is made
        return True
    return True
