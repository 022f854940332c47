"""What an event of a recording is."""

from dataclasses import dataclass, replace

from hapticplayer.errors import Message
from hapticplayer.rendering.effects import Effect

LEAST_EFFECT_S = 0.001


@dataclass(frozen=True, slots=True)
class Event:
    """Something that happens in a recording.

    Attributes:
        kind: name of its detector.
        start_s, end_s: media time.
        confidence: 0 to 1; at least 0.5, as what is less is not offered.
        text: a sentence for people.
        effect: what may be made of it; nothing is applied by itself.
    """

    kind: str
    start_s: float
    end_s: float
    confidence: float
    text: Message
    effect: Effect

    def within(self, end_s: float) -> "Event":
        """It without what lies before 0 or after the end of a clip.

        The effect keeps a millisecond at least, also where it would begin after the end.
        """
        effect = self.effect
        first_s = min(effect.start_s, max(0.0, end_s - LEAST_EFFECT_S))
        last_s = min(max(effect.end_s, first_s + LEAST_EFFECT_S), end_s)
        most_s = 0.5 * (last_s - first_s)
        cut = replace(
            effect,
            start_s=first_s,
            end_s=last_s,
            fade_in_s=min(effect.fade_in_s, most_s),
            fade_out_s=min(effect.fade_out_s, most_s),
        )
        start_s, stop_s = max(self.start_s, 0.0), min(self.end_s, end_s)
        return replace(self, start_s=start_s, end_s=stop_s, effect=cut)
