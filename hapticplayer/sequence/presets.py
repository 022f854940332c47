"""Presets of the rendering: how a motion becomes the realistic force track.

A preset may wash out the force so that the hands it is made for stay within a part of
the workspace. Measured figures: `python -m benchmarks.haptics washout`.
"""

from dataclasses import dataclass, replace

from hapticplayer import rendering
from hapticplayer.devices.dynamics import RELAXED, Hand, Mechanism
from hapticplayer.errors import Message, entry_named
from hapticplayer.model import ForceTrack, ImuLog, Mapping, MotionTrack, PresetName
from hapticplayer.rendering.effects import (
    NO_EFFECTS,
    Effect,
    EffectList,
    Target,
    applied_to_force,
    applied_to_motion,
)
from hapticplayer.rendering.washout import (
    DesignHand,
    SolvedPieces,
    Washout,
    washed_out,
)
from hapticplayer.sequence.effects_file import described_effect
from hapticplayer.sequence.excursion import mechanism_at_grip

YIELDING = replace(RELAXED, yield_s=0.3, return_s=2.0)
"""Relaxed, and gives way to a steady force within a second."""


@dataclass(frozen=True, slots=True)
class Preset:
    """One way to render.

    Attributes:
        name: on the command line and in the provenance.
        text: for people, in a sentence.
        hands: that stay within `reach_m`; none for the direct rendering.
        reach_m: 10 ms ahead, without the device's spring.
    """

    name: str
    text: Message
    hands: tuple[Hand, ...] = ()
    reach_m: float = 0.0


PRESETS: tuple[Preset, ...] = (
    Preset(
        PresetName.FAITHFUL,
        Message("Force in proportion to the motion, as in the paper."),
    ),
    Preset(
        PresetName.BALANCED,
        Message(
            "Changes only what would push a relaxed hand further than 26 mm from the "
            "centre."
        ),
        (RELAXED,),
        0.026,
    ),
    Preset(
        PresetName.EQUAL,
        Message(
            "For studies: every participant gets nearly the same force, but long "
            "pushes are much weaker."
        ),
        (YIELDING, RELAXED),
        0.022,
    ),
)

DEFAULT_PRESET = PresetName.BALANCED
"""Of new sequences."""


def render_preset(
    motion: MotionTrack,
    mapping: Mapping | None = None,
    imu: ImuLog | None = None,
    *,
    name: str,
    effects: EffectList = NO_EFFECTS,
) -> ForceTrack:
    """Return the force track of a motion under a preset, see `render_force`.

    Effects come before the washout; without one that is switched on nothing changes.
    """
    return Rendering(motion, mapping, imu, name=name).track(effects)


class Rendering:
    """Renders a motion again and again while the effects on it are edited.

    Only what an edit changes is computed again, and each track is the one that
    `render_preset` returns, bit for bit. One thread at a time may use it.

    Args:
        motion: gravity-free acceleration, in media time.
        mapping: axes, gain and limit; the default mapping if None.
        imu: in media time; a lever arm needs its angular rate.
        name: of the preset.

    Raises:
        UsageError: for an unknown preset.
    """

    def __init__(
        self,
        motion: MotionTrack,
        mapping: Mapping | None = None,
        imu: ImuLog | None = None,
        *,
        name: str,
    ) -> None:
        self.preset = preset_named(name)
        self._motion, self._mapping, self._imu = motion, mapping or Mapping(), imu
        self._direct: tuple[tuple[Effect, ...], ForceTrack] | None = None
        self._pieces: SolvedPieces | None = None
        if self.preset.hands:
            washout = washout_of(self.preset, self._mapping.force_limit_n)
            self._pieces = SolvedPieces(washout)

    def track(self, effects: EffectList = NO_EFFECTS) -> ForceTrack:
        track = self._rendered(effects)
        track = applied_to_force(track, effects, self._mapping.force_limit_n)
        if not effects.is_idle:
            made_of = [described_effect(one) for one in effects.effects if one.enabled]
            track = replace(track, provenance={**track.provenance, "effects": made_of})
        if self._pieces is not None:
            track = washed_out(track, self._pieces.washout, self._pieces)
        provenance = {**track.provenance, "preset": self.preset.name}
        return replace(track, provenance=provenance)

    def _rendered(self, effects: EffectList) -> ForceTrack:
        """Return the track before effects on the force; the last one where it is that."""
        chosen = effects.chosen(Target.MOTION)
        if self._direct is None or self._direct[0] != chosen:
            motion = applied_to_motion(self._motion, effects)
            track = rendering.render_force(motion, self._mapping, self._imu)
            self._direct = chosen, track
        return self._direct[1]


def preset_named(name: str) -> Preset:
    return entry_named({one.name: one for one in PRESETS}, name, Message("preset"))


def preset_of(track: ForceTrack) -> str:
    return str(track.provenance.get("preset", DEFAULT_PRESET))


def washout_of(preset: Preset, force_limit_n: float) -> Washout:
    mass, viscous, _dry_n = mechanism_at_grip(Mechanism())
    hands = []
    for hand in preset.hands:
        x_kg, y_kg, z_kg = (mass + hand.mass_kg).tolist()
        x_b, y_b, z_b = (viscous + hand.damping_n_s_per_m).tolist()
        hands.append(
            DesignHand(
                (x_kg, y_kg, z_kg),
                (x_b, y_b, z_b),
                hand.stiffness_n_per_m,
                hand.yield_s,
                hand.return_s,
            )
        )
    return Washout(tuple(hands), preset.reach_m, force_limit_n=force_limit_n)
