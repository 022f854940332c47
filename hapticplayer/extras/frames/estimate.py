"""Suggests motion for a video without a sensor: estimated sway and bounce.

Sway is what a turn presses to the side: speed over the ground times rotation about the
vertical. Bounce is how the camera goes up and down at each step. Both are in heights of the
camera above the ground, which no picture shows: one gain is set by hand. Neither is a
measurement. `benchmarks.motion suggested` says where they are right and where not.
"""

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy import ndimage, signal

from hapticplayer.errors import InputError, Message, Progress
from hapticplayer.extras.frames.ground import Ground, GroundMotion
from hapticplayer.extras.frames.watching import watched
from hapticplayer.media.clip_info import probe
from hapticplayer.model import STANDARD_GRAVITY_MPS2, MotionTrack
from hapticplayer.model.arrays import Floats

RATE_HZ = 100.0
"""Of the result; straight lines between are exact enough below `TOP_HZ`."""

TOP_HZ = 5.0
"""Nothing is estimated from here on: frames do not show it."""

HEIGHT_M = 1.5
"""Of the camera above the ground, assumed; another one is a factor, see the gain."""

SWAY_HZ, BOUNCE_HZ = 0.5, (0.5, 4.0)
"""Pass bands: where simulated rides and walks agree with the truth."""

LEAST_FRAME_RATE_HZ, LEAST_S = 12.0, 3.0

_STOP_DB, _ORDER = 40.0, 8
_MEMORY_S = 1.0  # over which trust changes
_FADE_S = 0.25  # around what is not seen
_TURN_SIGMA = (0.02, 0.15)  # rad/s, and share of the quick yaw, such as of steps
_SPEED_SIGMA = 0.3  # share of the sway
_LEAST_SIGMA_MPS2 = 0.05  # less is not noticed: 0.02 N at the default gain
_SHARES = (0.3, 0.8)  # of sway in sway and error: from no trust to full trust
_HALVES = (0.8, 0.95)  # correlation of the halves: from no trust to full trust
_WILD_MPS2 = (6.0, 9.0)  # RMS of a bounce that no gait has: full trust to none
_BOUNCE_SIGMA = (2.0, 0.45)  # of the halves' difference, and share of the bounce
_LITTLE = 0.05  # mean trust below which a part is left out, and that is said
_STILL_HEIGHTS_PER_S, _STILL_RADPS = 0.05, 0.02


@dataclass(frozen=True, slots=True, eq=False)
class Suggestion:
    """Motion that a picture suggests, N samples; not measured.

    Attributes:
        motion: in media time; frame A of a level camera, x sway and z bounce, y zero.
        sigma_mps2: (N, 2) of sway and bounce, for a gain that fits the clip.
        trust: (N, 2) share of each that was kept: 0 where it cannot be trusted.
        notes: what was left out, and why.
    """

    motion: MotionTrack
    sigma_mps2: Floats
    trust: Floats
    notes: tuple[str, ...]


def suggest_motion(
    clip: str | os.PathLike[str],
    *,
    gain: float = 1.0,
    progress: Progress = lambda _share, _step: None,
) -> Suggestion:
    """Estimate sway and bounce from the frames of a clip.

    Args:
        clip: the video.
        gain: factor on both, set by hand.
        progress: called with the share done and a step; raises Cancelled to stop.
    """
    duration_s = probe(clip).duration_s
    steps: list[GroundMotion] = []
    ground: Ground | None = None
    for view, seen in watched(clip, progress=progress):
        ground = ground or Ground(view)
        steps.append(ground.step(seen))
    if ground is None or duration_s < LEAST_S:
        raise InputError(
            "the clip is too short to suggest motion; it needs {least_s:g} s",
            where=str(clip),
            least_s=LEAST_S,
        )
    return suggestion(steps, ground.speeds(), duration_s, gain)


def suggestion(
    steps: Sequence[GroundMotion],
    speeds: tuple[Floats, Floats],
    duration_s: float,
    gain: float = 1.0,
) -> Suggestion:
    """The motion that frames suggest by the ground between them.

    Args:
        steps: of each pair of frames, one or more.
        speeds: times and speeds over the ground, heights per second.
        duration_s: of the clip.
        gain: factor on sway and bounce.
    """
    watched_ = _Watched.of(steps, speeds, duration_s)
    sway, sway_sigma, sway_trust = _sway(watched_)
    bounce, bounce_sigma, bounce_trust = _bounce(watched_)
    trust = np.stack([sway_trust, bounce_trust], axis=1)
    trust *= watched_.is_known
    notes, is_left_out = _notes(watched_, trust)
    trust[:, is_left_out] = 0.0
    parts = np.stack([sway, bounce], axis=1) * trust
    acceleration = np.zeros((len(trust), 3))
    acceleration[:, [0, 2]] = gain * _below_top(parts)
    sigma = gain * np.stack([sway_sigma, bounce_sigma], axis=1)
    return Suggestion(_track(watched_.time_s, acceleration), sigma, trust, notes)


def _track(time_s: Floats, acceleration: Floats) -> MotionTrack:
    level = np.zeros((len(time_s), 4))
    level[:, 0] = 1.0
    gravity = np.zeros((len(time_s), 3))
    gravity[:, 2] = STANDARD_GRAVITY_MPS2
    valid = np.ones(len(time_s), np.bool_)
    return MotionTrack(
        time_s, acceleration, gravity, 1.0, level, None, valid, is_estimated=True
    )


class _Watched(NamedTuple):
    """Steps at `RATE_HZ` over the clip (N)."""

    time_s: Floats
    speed: Floats  # heights per second
    turn_radps: Floats
    sinking: Floats  # (N, 3) heights per second: all points, either half
    is_known: Floats  # (N, 2) turn and sinking, 0 to 1, with fades

    @classmethod
    def of(
        cls,
        steps: Sequence[GroundMotion],
        speeds: tuple[Floats, Floats],
        duration_s: float,
    ) -> "_Watched":
        begin_s, end_s = np.array([(step.begin_s, step.end_s) for step in steps]).T
        lasts_s = np.maximum(end_s - begin_s, 1e-3)
        if 1.0 / np.median(lasts_s) < LEAST_FRAME_RATE_HZ:
            raise InputError(
                "the clip has {rate_hz:.0f} frames per second, too few to suggest "
                "motion; it needs {least_hz:.0f}",
                rate_hz=1.0 / float(np.median(lasts_s)),
                least_hz=LEAST_FRAME_RATE_HZ,
            )
        time_s = np.arange(0.0, duration_s, 1.0 / RATE_HZ)
        rates = np.array([(step.turned_rad, *step.sunk) for step in steps])
        rates = ndimage.median_filter(rates / lasts_s[:, None], (3, 1), mode="nearest")
        known = np.array([(step.is_turn_known, step.is_sunk_known) for step in steps])
        middle_s = 0.5 * (begin_s + end_s)
        on = [
            _interpolated(time_s, middle_s[is_known], column[is_known])
            for column, is_known in zip(rates.T, known[:, [0, 1, 1, 1]].T, strict=True)
        ]
        is_known = [
            _faded(np.interp(time_s, middle_s, column) > 0.5) for column in known.T
        ]
        return cls(
            time_s,
            np.interp(time_s, *speeds),
            on[0],
            np.stack(on[1:], axis=1),
            np.stack(is_known, axis=1),
        )


def _interpolated(time_s: Floats, known_s: Floats, values: Floats) -> Floats:
    return np.interp(time_s, known_s, values) if len(known_s) else np.zeros(len(time_s))


def _sway(watched_: _Watched) -> tuple[Floats, Floats, Floats]:
    """Return sway, its sigma and its trust (N,)."""
    metres_per_s = HEIGHT_M * watched_.speed
    slow = signal.butter(4, SWAY_HZ, fs=RATE_HZ, output="sos")
    sway = -metres_per_s * _filtered(slow, watched_.turn_radps)
    band = signal.butter(2, (0.5, 3.0), "band", fs=RATE_HZ, output="sos")
    quick = np.sqrt(_mean(_filtered(band, watched_.turn_radps) ** 2))
    floor, of_quick = _TURN_SIGMA
    of_turn = np.hypot(metres_per_s * (floor + of_quick * quick), _LEAST_SIGMA_MPS2)
    square = _mean(sway**2)
    sigma = np.hypot(of_turn, _SPEED_SIGMA * np.sqrt(square))
    share = square / (square + of_turn**2)
    return sway, sigma, _between(share, _SHARES)


def _bounce(watched_: _Watched) -> tuple[Floats, Floats, Floats]:
    """Return bounce, its sigma and its trust (N,)."""
    band = signal.butter(2, BOUNCE_HZ, "band", fs=RATE_HZ, output="sos")
    rising = -HEIGHT_M * np.gradient(watched_.sinking, 1.0 / RATE_HZ, axis=0)
    bounce, one, other = _filtered(band, rising).T
    common, apart = _mean(one * other), _mean((one - other) ** 2 / 4.0)
    alike = common / (np.abs(common) + 2.0 * apart + 1e-12)
    of_noise, of_bounce = _BOUNCE_SIGMA
    size = np.sqrt(_mean(bounce**2))
    of_halves = np.hypot(of_noise * np.sqrt(apart), _LEAST_SIGMA_MPS2)
    sigma = np.hypot(of_halves, of_bounce * size)
    trust = _between(alike, _HALVES) * (1.0 - _between(size, _WILD_MPS2))
    return bounce, sigma, trust


def _between(values: Floats, bounds: tuple[float, float]) -> Floats:
    """Return 0 up to the first bound, 1 from the second on."""
    none, full = bounds
    return np.asarray(np.clip((values - none) / (full - none), 0.0, 1.0))


def _notes(watched_: _Watched, trust: Floats) -> tuple[tuple[str, ...], list[int]]:
    """The notices, and the parts (0 sway, 1 bounce) that are left out."""
    notes: list[str] = []
    unseen_s = float((watched_.is_known[:, 0] < 0.5).sum()) / RATE_HZ
    if unseen_s >= 1.0:
        notes.append(
            Message(
                "{unseen_s:.0f} s without estimate: cuts, dark, blurred or empty frames",
                unseen_s=unseen_s,
            )
        )
    if (
        float(watched_.speed.max()) < _STILL_HEIGHTS_PER_S
        and float(np.abs(watched_.turn_radps).max()) < _STILL_RADPS
    ):
        return (
            *notes,
            Message("the camera does not move: there is nothing to estimate"),
        ), [0, 1]
    left_out = [part for part in (0, 1) if trust[:, part].mean() < _LITTLE]
    if 0 in left_out:
        notes.append(Message("no estimated sway: no turns beyond what may be an error"))
    if 1 in left_out:
        notes.append(
            Message(
                "no estimated bounce: two halves of the points do not agree on it, or it "
                "is wilder than any gait"
            )
        )
    return tuple(notes), left_out


def _below_top(values: Floats) -> Floats:
    stop = signal.cheby2(_ORDER, _STOP_DB, TOP_HZ, fs=RATE_HZ, output="sos")
    return _filtered(stop, values)


def _filtered(sos: Floats, values: Floats) -> Floats:
    """Return values (N, ...) filtered without phase."""
    return np.asarray(signal.sosfiltfilt(sos, values, axis=0))


def _mean(values: Floats) -> Floats:
    sigma = _MEMORY_S * RATE_HZ
    return np.asarray(ndimage.gaussian_filter1d(values, sigma, mode="nearest"))


def _faded(is_seen: Floats) -> Floats:
    """Return 1 where something is seen, and smooth ways to 0."""
    half = round(_FADE_S * RATE_HZ)
    kept = ndimage.minimum_filter1d(is_seen.astype(float), 4 * half + 1, mode="nearest")
    window = np.hanning(2 * half + 3)
    return np.asarray(ndimage.convolve1d(kept, window / window.sum(), mode="nearest"))
