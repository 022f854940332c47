"""Effects on a timeline: spans in which a motion or a force is changed.

    effects = EffectList((Effect("knock", 1.2, 1.5, parameters={"amplitude": 2.0}),))
    motion = applied_to_motion(motion, effects)      # p, frame A, m/s^2
    track = applied_to_force(track, effects)         # F, frame D, N, before the washout

`EFFECTS` holds the kinds: name, text, parameters with default, range and unit, and
whether control points (`Effect.curve`) may stand for one of them. Values are frozen and
checked when they are made (`UsageError` names the field); change them with
`dataclasses.replace` and `Effect.moved`. Nothing changes its argument; without an effect
that is switched on, a motion or a track is returned itself.

Source: Danieau et al. 2012, discussion: "artificial modulation of some parts of
interest to underline specific haptic events".
"""

from hapticplayer.rendering.effects.kinds import (
    EFFECTS,
    EffectKind,
    kind_of,
)
from hapticplayer.rendering.effects.values import (
    NO_EFFECTS,
    Effect,
    EffectList,
    Target,
    TimeMarker,
    applied_to_force,
    applied_to_motion,
    faded_share,
)

__all__ = [
    "EFFECTS",
    "NO_EFFECTS",
    "Effect",
    "EffectKind",
    "EffectList",
    "Target",
    "TimeMarker",
    "applied_to_force",
    "applied_to_motion",
    "faded_share",
    "kind_of",
]
