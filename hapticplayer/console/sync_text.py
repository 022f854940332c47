"""A synchronisation in words."""

from collections.abc import Mapping
from typing import Any


def sync_text(found: Mapping[str, Any]) -> str:
    """Return the sentences on what `Synchronisation.described` holds."""
    first = (
        f"offset {found['offset_s']:.3f} s by {found['method']}, "
        f"confidence {found['confidence']:.2f}, "
        f"residual {1e3 * found['residual_s']:.1f} ms"
    )
    if found["drift_is_fitted"]:
        first += f", drift {found['drift_ppm']:+.1f} ppm"
    if found["sound_late_s"]:
        skew_ms = 1e3 * found["sound_late_s"]
        first += f", {skew_ms:.0f} ms of the camera's skew taken off"
    lines = [first]
    for number, pat in enumerate(found["pats"], start=1):
        lines.append(
            f"  pat {number}: heard at {pat['heard_s']:.3f} s, felt at "
            f"{pat['felt_s']:.3f} s of the log; events so strong are "
            f"{_rarity(pat['heard_rarity_hz'])} in the sound, "
            f"{_rarity(pat['felt_rarity_hz'])} in the log"
        )
    return "\n".join(lines)


def check_text(name: str, found: Mapping[str, Any]) -> str:
    """Return the sentence on what `StreamCheck.described` holds."""
    times = ", ".join(f"{at:.2f}" for at in found["pats_s"])
    if not found["pats_s"]:
        return f"{name}: no three knocks in a rhythm"
    verdict = "stand out" if found["is_usable"] else "do not stand out"
    return (
        f"{name}: three knocks at {times} s {verdict} "
        f"(the weakest is {_rarity(found['rarity_hz'])})"
    )


def _rarity(rarity_hz: float) -> str:
    if rarity_hz < 1 / 60:
        return "less than one a minute"
    return f"{60 * rarity_hz:.0f} a minute"
