"""Washout: the force nearest to a track under which the hands it is made for stay inside.

Over a piece of the track, three axes together,

    minimise 1/2 ||W (u - F)||^2 subject to
        min(0, F_i) - d <= u_i <= max(0, F_i) + d       no force where none is meant
        |u| <= force limit
        |(1 + a s) X_h(s) u| <= R for each design hand h
        X_h = 1 / (m s^2 + b s + k (1 - Y)),  Y = (1/t_y) / (s + 1/t_y + 1/t_r)

X_h is the way of grip and hand under a force, Y the rest point of a hand that gives way,
W the weight of an error by its frequency,

    |W(f)|^2 = (w^2 + (f/f_1)^2) / (1 + (f/f_1)^2) / (1 + (f/f_2)^4):

a constant error counts w, one of 0.5 to 10 Hz counts 1; above 15 Hz a grip does not move.

W and X_h do not change with time, so the alternating direction method of multipliers
(Boyd et al. 2011, section 3; over-relaxation 3.4.3; a varying penalty for u and another
for the excursions) solves for u with one division per frequency; its other steps clip and
shorten vectors, in single precision. The solution at 50 Hz gives a correction u - F that
is added to the track, which keeps its detail.
"""

import hashlib
import math
from collections import deque
from collections.abc import Iterator
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.errors import InputError
from hapticplayer.model import ForceTrack, Reconstruction
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import AT_LIMIT
from hapticplayer.model.mapping import DEFAULT_FORCE_LIMIT_N

Spectra = NDArray[np.complexfloating[Any, Any]]
Singles = NDArray[np.float32]

CORNERS_HZ = 0.5, 15.0
CONSTANT_WEIGHT = 0.3
"""Of the weight of an error. Nobody has measured the constant's for forces on a hand; 0.03
to 1 change an optimised washout little."""

SOLVE_HZ = 50.0
PIECE_S, BLEND_S = 30.0, 2.0
RUN_UP_S = 8.0
"""Of a piece before it counts: a hand that gives way remembers a force for 2.4 s."""

LOOK_AHEAD_S = 4.0
"""Of a piece after it has counted."""

MOST_ITERATIONS = 400
"""Of the solver, for each piece."""

_OVERLAP_S = RUN_UP_S + BLEND_S + LOOK_AHEAD_S
_PAD_S = 8.0  # zeros in which the slowest hand comes back
_TAPER_S = 1.0  # a piece begins and ends without a step that the track does not have
_OVERSAMPLING = 8  # before the low-pass that comes before 50 Hz
_RELAXATION, _FIRST_PENALTY, _PENALTY_STEP = 1.7, 2.0, 1.6
_CHECK_EVERY, _LEAST_ITERATIONS = 10, 40
_EXCESS_SHARE, _ERROR_STEP = 0.005, 0.0005
_KNOWN_VERSIONS = 4  # so that undo, and before and after, are quick


@dataclass(frozen=True, slots=True)
class DesignHand:
    """A hand on the grip, with what the hand feels of the device.

    Attributes:
        mass_kg: of hand and device, along x, y, z of frame D.
        damping_n_s_per_m: of both, likewise.
        stiffness_n_per_m: of the hand.
        yield_s, return_s: time constants of its rest point, see `devices.dynamics.Hand`.
    """

    mass_kg: tuple[float, float, float]
    damping_n_s_per_m: tuple[float, float, float]
    stiffness_n_per_m: float
    yield_s: float = math.inf
    return_s: float = 0.5

    def compliance_m_per_n(self, frequency_hz: Floats) -> NDArray[np.complex128]:
        """Return X_h, (3, M), at frequencies (M,)."""
        s = 2j * np.pi * frequency_hz
        gives_way = (1.0 / self.yield_s) / (
            s + 1.0 / self.yield_s + 1.0 / self.return_s
        )
        mass, damping = np.array([self.mass_kg, self.damping_n_s_per_m])[:, :, None]
        stiffness = self.stiffness_n_per_m * (1.0 - gives_way)
        return np.asarray(1.0 / (mass * s * s + damping * s + stiffness))


@dataclass(frozen=True, slots=True)
class Washout:
    """What a washout has to keep.

    Attributes:
        hands: for which the excursion is limited.
        reach_m: R, the limit.
        ahead_s: a, the prediction time of the device's spring and fade.
        false_force_n: d, allowed against the track's direction, per axis.
        constant_weight: w, of a constant error beside one of 0.5 to 10 Hz.
        force_limit_n: magnitude.
    """

    hands: tuple[DesignHand, ...]
    reach_m: float
    ahead_s: float = 0.010
    false_force_n: float = 0.15
    constant_weight: float = CONSTANT_WEIGHT
    force_limit_n: float = DEFAULT_FORCE_LIMIT_N

    def weight(self, frequency_hz: Floats) -> Floats:
        """Return |W|, (M,), at frequencies (M,)."""
        return weight(frequency_hz, self.constant_weight)

    def reaches(self, frequency_hz: Floats) -> NDArray[np.complex128]:
        """Return (1 + a s) X_h / R, (hands, 3, M), at frequencies (M,)."""
        ahead = 1.0 + 2j * np.pi * self.ahead_s * frequency_hz
        each = [hand.compliance_m_per_n(frequency_hz) for hand in self.hands]
        return np.asarray(np.stack(each) * ahead / self.reach_m)


class SolvedPieces:
    """The pieces of a track and of its last versions, under one washout.

    A piece that one of them has with the same force, bit for bit, is not solved again;
    what comes out is what `solve` returns.
    """

    def __init__(self, washout: Washout) -> None:
        self.washout = washout
        self._versions: deque[dict[bytes, Floats]] = deque(maxlen=_KNOWN_VERSIONS)

    def begin(self) -> None:
        """Begin another version; the oldest is forgotten."""
        self._versions.appendleft({})

    def solved(self, force_n: Floats) -> Floats:
        """Return u, (3, N) in N at 50 Hz, of a piece, see `solve`."""
        key = hashlib.blake2b(force_n.tobytes(), digest_size=16).digest()
        known = (one[key] for one in self._versions if key in one)
        found = next(known, None)
        if found is None:
            found = solve(force_n, self.washout)
        self._versions[0][key] = found
        return found


def washed_out(
    track: ForceTrack, washout: Washout, pieces: SolvedPieces | None = None
) -> ForceTrack:
    """Return a LINEAR track under which every design hand stays within the limit.

    Where the hands stay within it anyway, the force is the track's own, bit for bit.
    The provenance gains the parameters and the share of the time that was changed.

    Args:
        track: LINEAR, in frame D, N.
        washout: limits and hands.
        pieces: of the last versions of the track, under the same washout; the result
            is the same without them.
    """
    if track.reconstruction is not Reconstruction.LINEAR:
        raise InputError("a washout needs a track of straight lines, this one holds")
    if pieces is not None:
        pieces.begin()
    start_s = float(track.time_s[0])
    count = math.ceil((float(track.time_s[-1]) - start_s) * SOLVE_HZ) + 1
    correction = np.zeros((3, count), np.float32)
    for first, size in _pieces(count):
        piece = slice(first, first + size)
        force = _sampled(track, start_s, first, size)
        force *= _ramps(first, size, count, (0.0, 0.0), _TAPER_S)
        solved = pieces.solved(force) if pieces else solve(force, washout)
        blend = _ramps(first, size, count, (RUN_UP_S, LOOK_AHEAD_S), BLEND_S)
        correction[:, piece] += blend * (solved - force)
    changed = np.any(correction != 0.0, axis=0)
    made = {**_described(washout), "changed_share": float(np.mean(changed))}
    provenance = {**track.provenance, "washout": made}
    if not changed.any():
        return replace(track, provenance=provenance)
    time_s = _with_grid(track.time_s, start_s + np.arange(count) / SOLVE_HZ, changed)
    force_n = np.empty((len(time_s), 3), np.float32)
    rows_at_once = 1 << 16
    for begin in range(0, len(time_s), rows_at_once):
        rows = slice(begin, begin + rows_at_once)
        force_n[rows] = _corrected(track, correction, time_s[rows], washout)
    if provenance.get("saturated_share"):  # of what is left after it
        limit_n = AT_LIMIT * float(provenance["force_limit_n"])
        at_limit = np.linalg.norm(force_n, axis=1) >= limit_n
        provenance["saturated_share"] = float(np.mean(at_limit))
    return replace(track, time_s=time_s, force_n=force_n, provenance=provenance)


def solve(force_n: Floats, washout: Washout) -> Floats:
    """Return u, (3, N) in N at 50 Hz; `force_n` itself where nothing has to change.

    Before and after it there is no force.

    Args:
        force_n: F, (3, N) in N at 50 Hz.
        washout: limits and hands.
    """
    from scipy import fft  # playing does not need it

    count = force_n.shape[1]
    size = fft.next_fast_len(count + round(_PAD_S * SOLVE_HZ), real=True)
    frequency_hz = fft.rfftfreq(size, 1.0 / SOLVE_HZ)
    reaches = washout.reaches(frequency_hz)
    wanted = fft.rfft(force_n, size)

    def furthest(spectrum: Spectra) -> float:
        return float(_lengths(fft.irfft(reaches * spectrum, size)).max(initial=0.0))

    if furthest(wanted) <= 1.0:
        return force_n
    weight = np.square(washout.weight(frequency_hz))
    low, high = _box(force_n, size, washout.false_force_n)
    # rows: u itself, and the excursion of each hand
    ways = np.concatenate((np.ones_like(reaches[:1]), reaches)).astype(np.complex64)
    limits = np.array([washout.force_limit_n] + [1.0] * len(reaches), np.float32)
    least = _LeastSquares(ways, weight, wanted)
    copies = np.zeros((len(ways), 3, size), np.float32)
    duals = np.zeros_like(copies)
    scale, error = max(_energy(weight, wanted), 1e-12), math.inf
    for iteration in range(1, MOST_ITERATIONS + 1):
        own = fft.irfft(ways * least.spectrum(fft.rfft(copies - duals)), size)
        before = copies
        duals += _RELAXATION * own + (1.0 - _RELAXATION) * before
        copies = duals.copy()
        np.clip(copies[0], low, high, out=copies[0])
        copies *= _shares(copies, limits[:, None, None])
        duals -= copies
        if iteration % _CHECK_EVERY:
            continue
        result = fft.rfft(copies[0].astype(np.float64))
        last, error = error, math.sqrt(_energy(weight, result - wanted) / scale)
        is_done = furthest(result) - 1.0 < _EXCESS_SHARE
        is_done = is_done and abs(error - last) < _ERROR_STEP
        if is_done and iteration >= _LEAST_ITERATIONS:
            break
        if iteration <= MOST_ITERATIONS // 2:
            for rows in (slice(0, 1), slice(1, None)):
                residuals = own[rows] - copies[rows], copies[rows] - before[rows]
                size_n = max(_size(own[rows]), _size(copies[rows]))
                factor = _factor(*residuals, size_n, duals[rows])
                duals[rows] /= least.scale_penalty(rows, factor)
    return np.asarray(copies[0][:, :count], np.float64)


class _LeastSquares:
    """Finds the spectrum of u that is nearest to F and to the copies.

    Args:
        ways: (copies, 3, M) from u to what each copy limits.
        weight: |W|^2, (M,).
        wanted: spectrum of F, (3, M).
    """

    def __init__(self, ways: Spectra, weight: Floats, wanted: Spectra) -> None:
        self._back, self._gains = np.conj(ways), np.square(np.abs(ways))
        self._weight = weight.astype(np.float32)
        self._weighted = (weight * wanted).astype(np.complex64)
        self._penalties = np.full((len(ways), 1, 1), _FIRST_PENALTY, np.float32)
        self._prepare()

    def _prepare(self) -> None:
        self._pull = self._penalties * self._back
        self._divisor = self._weight + (self._penalties * self._gains).sum(axis=0)

    def spectrum(self, aims: Spectra) -> Spectra:
        """Return the spectrum (3, M) for those of the copies less duals."""
        pulled = (self._pull * aims).sum(axis=0)
        return np.asarray((self._weighted + pulled) / self._divisor)

    def scale_penalty(self, rows: slice, factor: float) -> np.float32:
        """Scale the penalty of some copies; return the factor as it is used."""
        used = np.float32(factor)
        self._penalties[rows] *= used
        self._prepare()
        return used


def _energy(weight: Floats, spectrum: NDArray[np.complex128]) -> float:
    return float((weight * np.square(np.abs(spectrum))).sum())


def _described(washout: Washout) -> dict[str, Any]:
    """Return the parameters as JSON holds them; a hand that never yields has None."""
    hands = [
        {
            **asdict(hand),
            "mass_kg": list(hand.mass_kg),
            "damping_n_s_per_m": list(hand.damping_n_s_per_m),
            "yield_s": hand.yield_s if math.isfinite(hand.yield_s) else None,
        }
        for hand in washout.hands
    ]
    return {**asdict(washout), "hands": hands, "solve_hz": SOLVE_HZ}


def _factor(primal: Singles, dual: Singles, size_n: float, duals: Singles) -> float:
    """The factor on the penalty that balances the residuals, each relative to its scale.

    Source: Stellato et al. 2020, "OSQP: an operator splitting solver", section 5.2. The
    penalty itself is in both parts of the second ratio.
    """
    first, second = _size(primal) * _size(duals), _size(dual) * size_n
    factor = math.sqrt(max(first, 1e-12) / max(second, 1e-12))
    return min(max(factor, 1.0 / _PENALTY_STEP), _PENALTY_STEP)


def _size(values: Singles) -> float:
    # a sum in numpy's own order; that of a norm depends on the number of threads
    return math.sqrt(float(np.square(values).sum()))


def _box(force_n: Floats, size: int, false_force_n: float) -> tuple[Floats, Floats]:
    """Return the bounds (3, size) of u; zero outside the piece."""
    low, high = np.zeros((2, 3, size))
    count = force_n.shape[1]
    low[:, :count] = np.minimum(0.0, force_n) - false_force_n
    high[:, :count] = np.maximum(0.0, force_n) + false_force_n
    return low, high


def _lengths(vectors: Floats) -> Floats:
    """Return the lengths (..., N) of vectors (..., 3, N)."""
    return np.asarray(np.sqrt(np.square(vectors).sum(axis=-2, keepdims=True)))


def _shares(vectors: Singles, limits: Singles) -> Singles:
    """Return how much of vectors (copies, 3, N) is within limits (copies, 1, 1)."""
    squares = np.square(vectors)
    lengths = np.sqrt(squares[:, 0] + squares[:, 1] + squares[:, 2])[:, None]
    return np.asarray(limits / np.maximum(lengths, limits))


def _shortened(vectors: Floats, limit: float) -> Floats:
    """Return vectors (..., 3, N) no longer than the limit."""
    return np.asarray(vectors * (limit / np.maximum(_lengths(vectors), limit)))


def _pieces(count: int) -> Iterator[tuple[int, int]]:
    """Yield first sample and size of overlapping pieces; the last takes a short rest."""
    size, step = round(PIECE_S * SOLVE_HZ), round((PIECE_S - _OVERLAP_S) * SOLVE_HZ)
    first = 0
    while first + size < count:
        yield first, size
        first += step
    yield first, count - first


def _ramps(
    first: int, size: int, count: int, margins_s: tuple[float, float], width_s: float
) -> Floats:
    """Return (size,) ramps up and down at those ends that are not the track's."""
    shares = np.ones(size)
    from_start_s = np.arange(size) / SOLVE_HZ
    to_end_s = (size - np.arange(size)) / SOLVE_HZ
    if first > 0:
        shares *= np.clip((from_start_s - margins_s[0]) / width_s, 0.0, 1.0)
    if first + size < count:
        shares *= np.clip((to_end_s - margins_s[1]) / width_s, 0.0, 1.0)
    return shares


def _sampled(track: ForceTrack, start_s: float, first: int, size: int) -> Floats:
    """Return the track (3, size) at 50 Hz, low-passed before."""
    from scipy import signal

    fine = np.arange(first * _OVERSAMPLING, (first + size) * _OVERSAMPLING)
    force = track.at(start_s + fine / (_OVERSAMPLING * SOLVE_HZ))
    return np.asarray(signal.resample_poly(force, 1, _OVERSAMPLING, axis=0).T)


def _with_grid(time_s: Floats, grid_s: Floats, changed: NDArray[np.bool_]) -> Floats:
    """Return the times with those of the grid that lie in steps longer than its own."""
    chosen = grid_s[changed & (grid_s > time_s[0]) & (grid_s < time_s[-1])]
    after = np.searchsorted(time_s, chosen)
    is_long = np.diff(time_s)[after - 1] > 1.001 / SOLVE_HZ
    return np.asarray(np.union1d(time_s, chosen[is_long]))


def _corrected(
    track: ForceTrack, correction: NDArray[np.float32], time_s: Floats, washout: Washout
) -> Floats:
    """Return the force (M, 3) with the correction between its samples."""
    places = (time_s - track.time_s[0]) * SOLVE_HZ
    grid = np.arange(correction.shape[1])
    more = np.stack([np.interp(places, grid, axis) for axis in correction], axis=1)
    rows = np.searchsorted(track.time_s, time_s)
    is_own = track.time_s[np.minimum(rows, len(track.time_s) - 1)] == time_s
    force = track.at(time_s)
    force[is_own] = track.force_n[rows[is_own]]  # the last entry too
    is_changed = np.any(more != 0.0, axis=1)
    total = _shortened((force + more).T, washout.force_limit_n).T
    return np.where(is_changed[:, None], total, force)


def weight(frequency_hz: Floats, constant_weight: float = CONSTANT_WEIGHT) -> Floats:
    """Return |W|, (M,), at frequencies (M,)."""
    low, high = (np.square(frequency_hz / corner) for corner in CORNERS_HZ)
    square = (constant_weight**2 + low) / (1.0 + low) / (1.0 + high * high)
    return np.asarray(np.sqrt(square))


def weighted(force_n: Floats, rate_hz: float) -> Floats:
    """Return W applied to forces (..., N) in N, as if they repeated without end."""
    from scipy import fft  # playing does not need it

    count = force_n.shape[-1]
    by_frequency = weight(fft.rfftfreq(count, 1.0 / rate_hz))
    return np.asarray(fft.irfft(by_frequency * fft.rfft(force_n), count))


def magnitude_rms_n(force_n: Floats) -> float:
    """Return the RMS of the magnitude of forces (3, N), N."""
    return float(np.sqrt(np.square(force_n).sum(axis=0).mean()))
