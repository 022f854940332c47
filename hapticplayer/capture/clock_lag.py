"""How far a camera's motion lags its frames, and how that is known."""

from dataclasses import dataclass
from typing import Any

from hapticplayer.errors import Message

CORI, FRAMES, TAPS, NOTHING = "cori", "frames", "pats", ""
"""What measures a lag."""

UNSTAMPED_SIGMA_S = 0.02
"""Of cameras without timestamps: 10 to 30 ms."""


@dataclass(frozen=True, slots=True)
class ClockLag:
    """The lag of a camera's motion against its frames.

    Attributes:
        measured_by: `CORI`, `FRAMES`, `TAPS`, or `NOTHING`.
        lag_s: log time less media time of the same moment; 0 if not measured.
        sigma_s: SD of its error.
        why: it could not be measured.
        is_of_machine: one machine stamped both, a recorder here.
    """

    measured_by: str
    lag_s: float
    sigma_s: float
    why: Message | str = ""
    is_of_machine: bool = False

    @property
    def is_measured(self) -> bool:
        """Whether the clock map takes it into account."""
        return self.measured_by != NOTHING

    @property
    def text(self) -> Message:
        """Return the sentence for people."""
        if self.is_of_machine:
            return self._text_of_machine
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

    @property
    def _text_of_machine(self) -> Message:
        if self.is_measured:
            return Message(
                "The recorder's clock was {lag_ms:+.1f} ms (± {sigma_ms:.1f} ms) off, "
                "measured from the {witness}; this is corrected.",
                lag_ms=1e3 * self.lag_s,
                sigma_ms=1e3 * self.sigma_s,
                witness=Message("taps")
                if self.measured_by == TAPS
                else Message("rotation in the frames"),
            )
        text = Message(
            "Camera and IMU have the recorder's clock, known to about {sigma_ms:.0f} ms",
            sigma_ms=1e3 * self.sigma_s,
        )
        if not self.why:
            return Message("{text}.", text=text)
        return Message(
            "{text}; taps and frames could not correct it: {why}.",
            text=text,
            why=self.why,
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


def stamped_here(residual_s: float, why: Message | str = "") -> ClockLag:
    """Return the lag of what a recorder here has stamped, not measured."""
    return ClockLag(NOTHING, 0.0, residual_s, why, is_of_machine=True)
