"""How far a camera's motion lags its frames, and how that is known."""

from dataclasses import dataclass
from typing import Any

from hapticplayer.errors import Message

CORI, FRAMES, NOTHING = "cori", "frames", ""
"""What measures a lag."""

UNSTAMPED_SIGMA_S = 0.02
"""Of cameras without timestamps: 10 to 30 ms."""


@dataclass(frozen=True, slots=True)
class ClockLag:
    """The lag of a camera's motion against its frames.

    Attributes:
        measured_by: `CORI`, `FRAMES`, or `NOTHING`.
        lag_s: log time less media time of the same moment; 0 if not measured.
        sigma_s: SD of its error.
        why: it could not be measured.
    """

    measured_by: str
    lag_s: float
    sigma_s: float
    why: Message | str = ""

    @property
    def is_measured(self) -> bool:
        """Whether the clock map takes it into account."""
        return self.measured_by != NOTHING

    @property
    def text(self) -> Message:
        """Return the sentence for people."""
        if self.measured_by == CORI:
            return Message(
                "The motion's timestamps are {lag_ms:+.1f} ms (± {sigma_ms:.2f} ms) off "
                "the frames, measured from the camera's own orientation at each frame "
                "(CORI); this is corrected.",
                lag_ms=1e3 * self.lag_s,
                sigma_ms=1e3 * self.sigma_s,
            )
        if self.measured_by == FRAMES:
            return Message(
                "This camera does not timestamp its samples: they are {lag_ms:+.1f} ms "
                "(± {sigma_ms:.1f} ms) off the frames, measured from the rotation in the "
                "frames; this is corrected.",
                lag_ms=1e3 * self.lag_s,
                sigma_ms=1e3 * self.sigma_s,
            )
        if self.why:
            return Message(
                "This camera does not timestamp its samples: they may be 10 to 30 ms "
                "off, and the frames could not tell by how much: {why}.",
                why=self.why,
            )
        return Message(
            "This camera does not timestamp its samples: they may be 10 to 30 ms off."
        )

    def described(self) -> dict[str, Any]:
        """Return it as plain values."""
        return {
            "measured_by": self.measured_by or None,
            "lag_s": round(self.lag_s, 6),
            "sigma_s": round(self.sigma_s, 6),
            "text": str(self.text),
        }


def unstamped(why: Message | str = "") -> ClockLag:
    """Return the lag of a camera without timestamps, not measured."""
    return ClockLag(NOTHING, 0.0, UNSTAMPED_SIGMA_S, why)
