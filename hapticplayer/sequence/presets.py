"""Presets of the rendering: how a motion becomes the realistic force track.

A preset may wash out the force so that the hands it is made for stay within a part of
the workspace. Measured figures: `python -m benchmarks.haptics washout`.
"""

from dataclasses import dataclass, replace

from hapticplayer import rendering
from hapticplayer.devices.dynamics import RELAXED, Hand, Mechanism
from hapticplayer.errors import Message, UsageError
from hapticplayer.model import ForceTrack, ImuLog, Mapping, MotionTrack, PresetName
from hapticplayer.rendering.effects import (
    NO_EFFECTS,
    EffectList,
    applied_to_force,
    applied_to_motion,
    described_effect,
)
from hapticplayer.rendering.washout import DesignHand, Washout, washed_out
from hapticplayer.sequence.excursion import felt

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

    Raises:
        InputError: as `render_force`.
        UsageError: for an unknown preset.
    """
    preset = next((one for one in PRESETS if one.name == name), None)
    if preset is None:
        raise UsageError(
            "{name!r} is not a preset; choose one of {names}",
            name=name,
            names=", ".join(one.name for one in PRESETS),
        )
    mapping = mapping or Mapping()
    motion = applied_to_motion(motion, effects)
    track = rendering.render_force(motion, mapping, imu)
    track = applied_to_force(track, effects, mapping.force_limit_n)
    if not effects.is_idle:
        made_of = [described_effect(one) for one in effects.effects if one.enabled]
        track = replace(track, provenance={**track.provenance, "effects": made_of})
    if preset.hands:
        track = washed_out(track, washout_of(preset, mapping.force_limit_n))
    return replace(track, provenance={**track.provenance, "preset": preset.name})


def preset_of(track: ForceTrack) -> str:
    """Return the name of the preset of a track; earlier versions had one."""
    return str(track.provenance.get("preset", PresetName.FAITHFUL))


def washout_of(preset: Preset, force_limit_n: float) -> Washout:
    """Return the washout of a preset for a Falcon."""
    mass, viscous, _dry_n = felt(Mechanism())
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
