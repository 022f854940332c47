"""Simulated clips with three pats, to measure synchronisation against a known truth.

Motion alone: damped taps of 18 to 60 Hz and 10 to 35 m/s2, walking with foot impacts,
taps later in the clip, a sensor like the ADXL345 (noise as measured at 200 Hz, steps
of 3.9 mg) at 200 Hz or averaged to 30 Hz, times in whole ms with jitter, stalls of the
memory card of 20 to 80 ms, a clock that is off by up to 100 ppm and 20 s. Sound at
16 kHz: thumps of 90 to 350 Hz, gusts of wind, speech, a soft limiter. A clip is easy
(still before and during the pats, the paper's protocol, signal to noise 15 to 35 dB) or
hard (the pats are given while walking in wind, 8 to 20 dB). Sizes are assumptions.
"""

from dataclasses import dataclass

import numpy as np
from scipy.signal import lfilter

from hapticplayer.model import STANDARD_GRAVITY_MPS2, ClockMap, ImuLog, Sampling
from hapticplayer.model.arrays import Floats

AUDIO_RATE_HZ = 16_000
SENSOR_RATE_HZ = 200

_NOISE_MPS2 = np.array([0.065, 0.062, 0.095])
_GYRO_NOISE_RADPS = 0.0009
_STEP_MPS2 = 0.0039 * STANDARD_GRAVITY_MPS2
_LIMIT_MPS2 = 16.0 * STANDARD_GRAVITY_MPS2
_BEYOND_S = 4.0  # the logger runs up to this much longer at either end


@dataclass(frozen=True, slots=True, eq=False)
class PatClip:
    """A log on its own clock, sound (n,), the true clock map, onsets of the pats."""

    imu: ImuLog
    audio: Floats
    audio_rate_hz: int
    clock_map: ClockMap
    pats_s: Floats
    duration_s: float


@dataclass(frozen=True, slots=True)
class _Tap:
    """What hits the camera: begins at `at_s`, felt and heard."""

    at_s: float
    felt_mps2: float
    heard: float
    felt_hz: float
    heard_hz: float
    felt_decay_s: float
    heard_decay_s: float
    direction: Floats


def simulate_pats(
    seed: int,
    *,
    hard: bool,
    rate_hz: int,
    duration_s: float = 60.0,
    at_both_ends: bool = False,
) -> PatClip:
    """Return a clip with three pats, after a few seconds (and before the end).

    `hard` ones are given while walking in wind; a log of 30 Hz holds averages.
    """
    rng = np.random.default_rng([seed, int(hard), round(duration_s)])
    clock = ClockMap(rng.uniform(-20.0, 20.0), 1.0 + rng.uniform(-1e-4, 1e-4))
    pats_s = _pat_times(rng, rng.uniform(2.0, 6.0))
    if at_both_ends:
        last_s = _pat_times(rng, 0.0)
        pats_s = np.append(pats_s, duration_s - rng.uniform(3.0, 6.0) + last_s)
    pats = _pats(rng, pats_s)
    still = [] if hard else _still_spans(rng, pats_s)
    others = _spurious_taps(rng, duration_s, pats_s, still)
    steps_s = _step_times(rng, duration_s, still)
    audio = _sound(rng, [*pats, *others], steps_s, duration_s, hard=hard)
    fine_s = np.arange(-_BEYOND_S, duration_s + _BEYOND_S, 1.0 / SENSOR_RATE_HZ)
    force = _specific_force(rng, fine_s, [*pats, *others], steps_s, still)
    imu = _log(rng, fine_s, force, clock, rate_hz)
    return PatClip(imu, audio, AUDIO_RATE_HZ, clock, pats_s, duration_s)


def _pat_times(rng: np.random.Generator, first_s: float) -> Floats:
    step_s = rng.uniform(0.3, 0.7)
    steps = step_s * (1.0 + rng.uniform(-0.12, 0.12, 2))
    return np.asarray(first_s + np.concatenate([[0.0], np.cumsum(steps)]))


def _pats(rng: np.random.Generator, pats_s: Floats) -> list[_Tap]:
    """The three pats of one place: alike in kind, unlike in strength."""
    felt_hz, heard_hz = rng.uniform(18.0, 60.0), rng.uniform(90.0, 350.0)
    felt_decay_s, heard_decay_s = rng.uniform(0.015, 0.06), rng.uniform(0.01, 0.035)
    direction = rng.standard_normal(3)
    return [
        _Tap(
            at_s=float(at_s),
            felt_mps2=rng.uniform(10.0, 35.0),
            heard=float(np.exp(0.45 * rng.standard_normal())),
            felt_hz=felt_hz * rng.uniform(0.9, 1.1),
            heard_hz=heard_hz * rng.uniform(0.9, 1.1),
            felt_decay_s=felt_decay_s,
            heard_decay_s=heard_decay_s,
            direction=_unit(direction + 0.3 * rng.standard_normal(3)),
        )
        for at_s in pats_s
    ]


def _spurious_taps(
    rng: np.random.Generator,
    duration_s: float,
    pats_s: Floats,
    still: list[tuple[float, float]],
) -> list[_Tap]:
    """Knocks later in the clip; some are felt or heard only."""
    count = rng.poisson(duration_s / 12.0)
    found = []
    for at_s in rng.uniform(0.0, duration_s, count):
        is_near = np.any(np.abs(at_s - pats_s) < 1.0)
        if is_near or any(begin <= at_s <= end for begin, end in still):
            continue
        kind = rng.uniform()
        found.append(
            _Tap(
                at_s=float(at_s),
                felt_mps2=0.0 if kind < 0.25 else rng.uniform(5.0, 40.0),
                heard=0.0 if kind > 0.75 else float(np.exp(0.7 * rng.normal())),
                felt_hz=rng.uniform(18.0, 60.0),
                heard_hz=rng.uniform(90.0, 350.0),
                felt_decay_s=rng.uniform(0.015, 0.06),
                heard_decay_s=rng.uniform(0.01, 0.035),
                direction=_unit(rng.standard_normal(3)),
            )
        )
    return found


def _still_spans(rng: np.random.Generator, pats_s: Floats) -> list[tuple[float, float]]:
    """Stillness from before each triple to a little after it."""
    spans: list[tuple[float, float]] = []
    for triple in pats_s.reshape(-1, 3):
        before_s = 30.0 if len(spans) == 0 else rng.uniform(1.5, 3.0)
        spans.append((triple[0] - before_s, triple[2] + rng.uniform(1.0, 5.0)))
    return spans


def _step_times(
    rng: np.random.Generator, duration_s: float, still: list[tuple[float, float]]
) -> Floats:
    cadence_hz = rng.uniform(1.6, 2.1)
    count = int((duration_s + 2 * _BEYOND_S) * cadence_hz * 1.1)
    steps = np.cumsum(rng.normal(1.0, 0.03, count) / cadence_hz) - _BEYOND_S
    kept = np.ones(count, dtype=bool)
    for begin_s, end_s in still:
        kept &= (steps < begin_s) | (steps > end_s)
    return np.asarray(steps[kept])


def _specific_force(
    rng: np.random.Generator,
    time_s: Floats,
    taps: list[_Tap],
    steps_s: Floats,
    still: list[tuple[float, float]],
) -> Floats:
    """Return what the sensor would measure without errors (N, 3)."""
    up = _unit(np.array([0.0, 0.0, 1.0]) + 0.3 * rng.standard_normal(3))
    moving = np.ones(len(time_s))
    for begin_s, end_s in still:
        moving[(time_s > begin_s) & (time_s < end_s)] = 0.0
    moving = np.convolve(moving, np.ones(100) / 100, "same")
    force = np.outer(np.full(len(time_s), STANDARD_GRAVITY_MPS2), up)
    sway = rng.uniform(1.0, 3.0) * _sway(rng, time_s, steps_s)
    force += (moving * sway)[:, None] * up
    shake = rng.standard_normal((len(time_s), 3))
    shake = lfilter([0.25], [1.0, -0.75], shake, axis=0)
    force += rng.uniform(0.1, 0.5) * moving[:, None] * shake
    impact_mps2 = rng.uniform(2.0, 9.0)
    for at_s in steps_s:
        size = impact_mps2 * np.exp(0.35 * rng.standard_normal())
        along = _unit(up + 0.3 * rng.standard_normal(3))
        _add_tap(force, time_s, at_s, size * along, (rng.uniform(15, 40), 0.02))
    for tap in taps:
        form = (tap.felt_hz, tap.felt_decay_s)
        _add_tap(force, time_s, tap.at_s, tap.felt_mps2 * tap.direction, form)
    return force


def _sway(rng: np.random.Generator, time_s: Floats, steps_s: Floats) -> Floats:
    """The body's up and down between the steps, with an overtone."""
    if len(steps_s) < 2:
        return np.zeros(len(time_s))
    phase = 2 * np.pi * np.interp(time_s, steps_s, np.arange(len(steps_s)))
    return np.asarray(np.sin(phase) + 0.4 * np.sin(2 * phase + rng.uniform(0, 6.28)))


def _add_tap(
    force: Floats,
    time_s: Floats,
    at_s: float,
    peak_mps2: Floats,
    form: tuple[float, float],
) -> None:
    """Add a damped sine, band-limited as the sensor does, to a few samples."""
    first, last = np.searchsorted(time_s, [at_s - 0.01, at_s + 0.3])
    hz, decay_s = form
    inner = (np.arange(-4, 4) + 0.5) / 8 / SENSOR_RATE_HZ  # mean over one sample
    since_s = (time_s[first:last, None] + inner) - at_s
    wave = np.exp(-np.maximum(since_s, 0.0) / decay_s) * np.sin(
        2 * np.pi * hz * since_s
    )
    wave = np.where(since_s > 0.0, wave, 0.0).mean(axis=1)
    force[first:last] += wave[:, None] * peak_mps2


def _log(
    rng: np.random.Generator,
    media_s: Floats,
    force: Floats,
    clock: ClockMap,
    rate_hz: int,
) -> ImuLog:
    """Return what the logger writes: averaged, stamped in ms, with stalls."""
    value = force + _NOISE_MPS2 * rng.standard_normal(force.shape)
    value = np.clip(
        _STEP_MPS2 * np.round(value / _STEP_MPS2), -_LIMIT_MPS2, _LIMIT_MPS2
    )
    begin_s = -rng.uniform(0.0, _BEYOND_S)
    end_s = media_s[-1] - rng.uniform(0.0, _BEYOND_S)
    kept = (media_s >= begin_s) & (media_s <= end_s)
    time_s, value = (media_s[kept] - clock.offset_s) / clock.rate, value[kept]
    sampling = Sampling.INSTANT
    if rate_hz < SENSOR_RATE_HZ:
        bins = np.floor((time_s - time_s[0]) * rate_hz).astype(int)
        first = np.flatnonzero(np.diff(bins, prepend=-1))
        count = np.diff(first, append=len(bins))[:, None]
        value = np.add.reduceat(value, first) / count
        time_s = np.add.reduceat(time_s, first) / count[:, 0]
        sampling = Sampling.AVERAGED
    stamped_s = np.round(time_s + rng.normal(0.0, 0.0007, len(time_s)), 3)
    lost = np.zeros(len(time_s), dtype=bool)
    for _ in range(rng.poisson((time_s[-1] - time_s[0]) / 15.0)):
        at_s = rng.uniform(time_s[0], time_s[-1])
        lost |= (time_s > at_s) & (time_s < at_s + rng.uniform(0.02, 0.08))
    ordered = np.concatenate([[True], np.diff(stamped_s) > 0])
    keep = ordered & ~lost
    return ImuLog(
        time_s=stamped_s[keep],
        specific_force_mps2=value[keep],
        angular_rate_radps=_GYRO_NOISE_RADPS * rng.standard_normal((keep.sum(), 3)),
        sampling=sampling,
        source="simulated pats",
    )


def _sound(
    rng: np.random.Generator,
    taps: list[_Tap],
    steps_s: Floats,
    duration_s: float,
    *,
    hard: bool,
) -> Floats:
    """Return the sound, limited softly, (n,) float32."""
    count = round(duration_s * AUDIO_RATE_HZ)
    snr_db = rng.uniform(8.0, 20.0) if hard else rng.uniform(15.0, 35.0)
    background = wind(rng, count) + rng.uniform(0.3, 1.2) * speech(rng, count)
    background /= np.sqrt(np.mean(background**2))
    signal = np.zeros(count)
    for tap in taps:
        form = (tap.heard_hz, tap.heard_decay_s)
        _add_thump(signal, tap.at_s, tap.heard, form)
    loudness = rng.uniform(0.0, 0.4)
    for at_s in steps_s:
        size = loudness * np.exp(0.5 * rng.standard_normal())
        _add_thump(signal, at_s, size, (rng.uniform(60, 200), 0.02))
    # a thump of strength 1 has its peak at about 0.8
    signal += 0.8 * 10.0 ** (-snr_db / 20.0) * background
    gain = rng.uniform(0.2, 1.2)
    return np.asarray(np.tanh(gain * signal), dtype=np.float32)


def _add_thump(
    signal: Floats, at_s: float, size: float, form: tuple[float, float]
) -> None:
    first = max(0, int(np.ceil(at_s * AUDIO_RATE_HZ)))
    part = signal[first : first + AUDIO_RATE_HZ // 5]
    since_s = (first + np.arange(len(part))) / AUDIO_RATE_HZ - at_s
    hz, decay_s = form
    part += size * np.exp(-since_s / decay_s) * np.sin(2 * np.pi * hz * since_s)


def wind(rng: np.random.Generator, count: int) -> Floats:
    """Return low noise that swells and ebbs, over a quieter hiss, at AUDIO_RATE_HZ."""
    rumble = lfilter([0.06], [1.0, -0.94], rng.standard_normal(count))
    hiss = 0.1 * rng.standard_normal(count)
    return np.asarray(rumble * _swell(rng, count, 6.0, 1.0) + hiss)


def speech(rng: np.random.Generator, count: int) -> Floats:
    """Return syllables, a buzz with a formant, in phrases, at AUDIO_RATE_HZ."""
    time_s = np.arange(count) / AUDIO_RATE_HZ
    pitch_hz = rng.uniform(100.0, 220.0) * _swell(rng, count, 2.0, 0.08)
    phase = 2 * np.pi * np.cumsum(pitch_hz) / AUDIO_RATE_HZ
    buzz = sum(np.sin(k * phase) / k for k in (1, 2, 3, 5, 8))
    syllables = np.maximum(0.0, np.sin(2 * np.pi * rng.uniform(3.0, 5.0) * time_s)) ** 2
    phrases = _swell(rng, count, 0.3, 1.0) > 1.0
    soft = lfilter([0.002], [1.0, -0.998], phrases.astype(float))
    return np.asarray(0.7 * buzz * syllables * soft)


def _swell(rng: np.random.Generator, count: int, rate_hz: float, size: float) -> Floats:
    """A slow random factor around 1, log-normal."""
    knots = rng.standard_normal(int(count / AUDIO_RATE_HZ * rate_hz) + 3)
    at = np.linspace(0.0, len(knots) - 1.0, count)
    return np.asarray(np.exp(size * np.interp(at, np.arange(len(knots)), knots)))


def _unit(vector: Floats) -> Floats:
    return np.asarray(vector / np.linalg.norm(vector))
