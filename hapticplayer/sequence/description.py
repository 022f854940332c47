"""The structure of `sequence.json`."""

import dataclasses
from typing import Annotated, Any

from msgspec import Meta, Struct

from hapticplayer import __version__
from hapticplayer.clock import utc_now_iso
from hapticplayer.errors import Message, SequenceError
from hapticplayer.model import ClockMap
from hapticplayer.model.limits import MAX_FORCE_N
from hapticplayer.model.mapping import AxisGains
from hapticplayer.model.ranges import MEDIA_TIME_S
from hapticplayer.structures import check_schema, convert

SCHEMA, VERSION = "hapticplayer.sequence", 1
IMPORT_AGAIN = Message("import it again")
_OTHER = (
    Message("is not the description of a sequence"),
    Message("give the folder of a sequence"),
)

_Count = Annotated[int, Meta(ge=0)]
_Amount = Annotated[float, Meta(ge=0.0, le=1e9)]
_Force = Annotated[float, Meta(le=MAX_FORCE_N)]
_Reach = Annotated[float, Meta(ge=-1e3, le=1e3)]
_Time = Annotated[float, Meta(ge=MEDIA_TIME_S.least, le=MEDIA_TIME_S.largest)]


class FileEntry(Struct, frozen=True):
    """A file of the sequence."""

    size_bytes: _Count
    sha256: str


class ClipEntry(Struct, frozen=True):
    """The video."""

    file: str
    duration_s: _Time
    width: _Count = 0
    height: _Count = 0
    frame_rate_hz: _Amount = 0.0
    has_audio: bool = False


class MappingEntry(Struct, frozen=True):
    """From acceleration to force."""

    axes: list[list[float]]
    gain_n_per_mps2: float | AxisGains
    force_limit_n: _Force
    soft_knee_n: _Force | None
    lever_arm_m: tuple[_Reach, _Reach, _Reach]


class HandEntry(Struct, frozen=True):
    """How far a hand of one kind would move.

    Attributes:
        reach: the furthest, as a share of the workspace.
        reach_at_s: when that is.
        far_share: of the time, beyond `ExcursionEntry.far`.
        trip: what would trip, "runaway" or "outside", or None.
        trip_at_s: when that is.
    """

    reach: _Amount
    reach_at_s: _Time = 0.0
    far_share: _Amount = 0.0
    trip: str | None = None
    trip_at_s: _Time | None = None


class ExcursionEntry(Struct, frozen=True):
    """What a track is predicted to do to three hands and to the motors.

    Attributes:
        hands: by kind of hand.
        far: share of the workspace from which outward force is reduced.
        rms_10s_n: highest force over the motors' time constant.
        thermal_share: of it, of the continuous force.
    """

    hands: dict[str, HandEntry]
    far: _Amount
    rms_10s_n: _Amount
    thermal_share: _Amount


class TrackEntry(Struct, frozen=True, omit_defaults=True):
    """A force track; one that is made when the sequence is opened has no file."""

    file: str | None = None
    peak_n: _Amount | None = None
    rms_n: tuple[_Amount, ...] | None = None
    saturated_share: _Amount | None = None
    excursion: ExcursionEntry | None = None
    provenance: dict[str, Any] = {}

    def __post_init__(self) -> None:
        """Refuse what the random track cannot be made of again."""
        seed = self.provenance.get("seed", 0)
        if isinstance(seed, bool) or not isinstance(seed, int) or seed < 0:
            raise ValueError("'seed' must be a whole number from 0 on")


class Description(Struct, frozen=True, omit_defaults=True):
    """The object in the file."""

    title: str
    clip: ClipEntry
    mapping: MappingEntry
    feedbacks: dict[str, TrackEntry]
    files: dict[str, FileEntry]
    clock_map: ClockMap | None = None
    effects: str | None = None
    provenance: dict[str, Any] = {}


def checked_description(content: dict[str, Any], where: str) -> Description:
    check_schema(content, (SCHEMA, VERSION), where, _OTHER, SequenceError)
    return convert(content, Description, where, SequenceError, IMPORT_AGAIN)


def written(description: Description) -> dict[str, Any]:
    """A description as JSON keeps it."""
    return {"schema": SCHEMA, "version": VERSION, **unstructured(description)}


def unstructured(value: Any) -> Any:
    """A structure as dicts, without optional entries that it lacks."""
    if isinstance(value, Struct):
        is_short = type(value).__struct_config__.omit_defaults
        entries = ((name, getattr(value, name)) for name in value.__struct_fields__)
        return {k: unstructured(v) for k, v in entries if not (is_short and v is None)}
    if isinstance(value, ClockMap):
        return dataclasses.asdict(value)
    if isinstance(value, dict):
        return {name: unstructured(one) for name, one in value.items()}
    return value


def describe_rendering(*, fits_gain: bool) -> dict[str, Any]:
    """Return when and by what force tracks were rendered, for the provenance."""
    return {
        "program": f"hapticplayer {__version__}",
        "created_utc": utc_now_iso(),
        "gain_from": "fit" if fits_gain else "given",
    }
