"""Recordings of any length: blocks with a calibration each, blended where they meet."""

import itertools
import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.model.calibration import SensorCalibration, vector
from hapticplayer.motion.smoother.block import Calibration, Smoothed, smooth
from hapticplayer.motion.smoother.parameters import (
    OTHER_SENSOR_SIGMAS,
    SmootherParameters,
)
from hapticplayer.motion.smoother.samples import InertialSamples, with_dropouts_filled
from hapticplayer.motion.smoother.stationary import StillBins
from hapticplayer.motion.stillness import StillSpans, mean_rate, nearest_still_bias

# A block has so many samples at least, however long they take.
MIN_BLOCK_SAMPLES = 50
# Neighbouring blocks are blended over this share of their margins.
BLENDED_MARGIN_SHARE = 0.25
# A wrong length of the force at rest may be a bias across the vertical, of this share.
# With 2 a scale error of 5 % passed for a bias (4 to 8 m/s^2 left on one pendulum in
# place of 0.14); with 0 a bias of 0.3 m/s^2 leaves a twentieth more.
SIDEWAYS_BIAS_FACTOR = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class SmoothedRecording:
    """The result for a whole recording.

    Attributes:
        quaternion_wxyz: (n, 4) sensor to earth at each sample.
        vertical: (n, 3) up in the sensor frame; for averaged samples its mean over
            their time.
        sigma_rad: (n,) standard deviation of the tilt, both axes together.
        at_rest: (n,) still samples that are not accelerated in the solution.
        blocks: what was found in each.
        overruled: in how many of them the calibration that was given was not used.
    """

    quaternion_wxyz: Floats
    vertical: Floats
    sigma_rad: Floats
    at_rest: NDArray[np.bool_]
    blocks: tuple[Calibration, ...]
    overruled: int = 0

    @property
    def time_constant_s(self) -> tuple[float, float]:
        """Shortest and longest of the levelling."""
        constants_s = np.concatenate([block.time_constant_s for block in self.blocks])
        return float(constants_s.min()), float(constants_s.max())

    def calibration(self, gain: float) -> SensorCalibration:
        """The sensor's calibration: the mean of the blocks by variance.

        Args:
            gain: of the accelerometer, which its specific force was multiplied with.
        """
        gyro, gyro_sigma = self._together("gyro_bias_radps", "gyro_bias_sigma_radps")
        accel, accel_sigma = self._together(
            "accelerometer_bias_mps2", "accelerometer_bias_sigma_mps2"
        )
        scale, scale_sigma = self._together(
            "accelerometer_scale", "accelerometer_scale_sigma"
        )
        return SensorCalibration(
            gyro_bias_radps=vector(gyro),
            gyro_bias_sigma_radps=vector(gyro_sigma),
            accelerometer_bias_mps2=vector(accel),
            accelerometer_bias_sigma_mps2=vector(accel_sigma),
            accelerometer_scale=float(scale) / gain,
            accelerometer_scale_sigma=float(scale_sigma) / gain,
        )

    def _together(self, name: str, sigma_name: str) -> tuple[Floats, Floats]:
        """Return mean and sigma; blocks that disagree widen it."""
        values = np.array([getattr(block, name) for block in self.blocks])
        sigma = np.array([getattr(block, sigma_name) for block in self.blocks])
        weight = sigma**-2.0
        weight /= weight.sum(axis=0)
        mean = (weight * values).sum(axis=0)
        variance = (weight * (sigma**2 + (values - mean) ** 2)).sum(axis=0)
        return mean, np.sqrt(variance)

    def mean(self, name: str) -> Floats:
        return np.asarray(
            np.mean([getattr(block, name) for block in self.blocks], axis=0)
        )


def smooth_recording(
    samples: InertialSamples,
    still: StillSpans,
    p: SmootherParameters,
    *,
    with_sigma: bool = True,
) -> SmoothedRecording:
    """Return the orientation of at least two samples.

    Args:
        samples: of the recording; dropped ones are put back for the computation.
        still: where it is still.
        p: settings.
        with_sigma: whether the uncertainty is wanted; it is 0 otherwise.
    """
    if p.calibration is not None and _is_refuted(p.calibration, still, p):
        unknown = replace(p, calibration=None)
        done = smooth_recording(samples, still, unknown, with_sigma=with_sigma)
        return replace(done, overruled=len(done.blocks))
    if samples.gain != 1.0:
        upright_mps2 = STANDARD_GRAVITY_MPS2 * abs(samples.gain - 1.0)
        sigma_mps2 = math.hypot(
            p.accel_bias_sigma_mps2, SIDEWAYS_BIAS_FACTOR * upright_mps2
        )
        p = replace(p, accel_bias_sigma_mps2=sigma_mps2)
        if p.calibration is not None:
            scale = samples.gain * p.calibration.accelerometer_scale
            p = replace(
                p, calibration=replace(p.calibration, accelerometer_scale=scale)
            )
    edges = still.per_bin * np.arange(len(still.bins) + 1)
    filled, places = with_dropouts_filled(samples)
    if places is None:
        return _in_blocks(samples, still, edges, p, with_sigma=with_sigma)
    # what was put in belongs to the sample after it
    edges = np.append(0, places + 1)[edges]
    whole = _in_blocks(filled, still, edges, p, with_sigma=with_sigma)
    return SmoothedRecording(
        whole.quaternion_wxyz[places],
        whole.vertical[places],
        whole.sigma_rad[places],
        whole.at_rest[places],
        whole.blocks,
        whole.overruled,
    )


def _is_refuted(
    known: SensorCalibration, still: StillSpans, p: SmootherParameters
) -> bool:
    """Whether a corrected accelerometer would not read 1 g at rest."""
    at_rest = still.force_mps2[:, still.bins]
    if not at_rest.size:
        return False
    bias, scale = np.array(known.accelerometer_bias_mps2), known.accelerometer_scale
    corrected = (at_rest - bias[:, None]) / scale
    norm = float(np.median(np.sqrt(np.square(corrected).sum(axis=0))))
    sigma_mps2 = math.hypot(
        *known.accelerometer_bias_sigma_mps2,
        STANDARD_GRAVITY_MPS2
        * min(known.accelerometer_scale_sigma, p.accel_scale_sigma),
    )
    return abs(norm - STANDARD_GRAVITY_MPS2) > OTHER_SENSOR_SIGMAS * sigma_mps2


def _in_blocks(
    samples: InertialSamples,
    still: StillSpans,
    edges: NDArray[np.intp],
    p: SmootherParameters,
    *,
    with_sigma: bool,
) -> SmoothedRecording:
    count, blocks = len(samples), _blocks(samples.step_s, p)
    overruled = 0

    def smoothed(reach: slice) -> Smoothed:
        nonlocal overruled
        bins = _still_bins(still, edges, reach)
        if bins is None and len(blocks) > 1 and still.bins.any():
            bins = _still_elsewhere(still, edges, reach, samples.step_s)
        part = samples.cut(reach)
        done = smooth(part, bins, p, with_sigma=with_sigma)
        if p.contradicts(done.calibration.gyro_bias_radps):
            overruled += 1
            unknown = replace(p, calibration=None)
            done = smooth(part, bins, unknown, with_sigma=with_sigma)
        return done

    if len(blocks) == 1:
        one = smoothed(slice(0, count))
        return SmoothedRecording(
            one.quaternion_wxyz,
            one.vertical,
            one.sigma_rad,
            one.at_rest,
            (one.calibration,),
            overruled,
        )
    q, vertical, sigma_rad = np.empty((count, 4)), np.empty((count, 3)), np.empty(count)
    at_rest = np.empty(count, np.bool_)
    written, found = 0, []
    for core, reach in blocks:
        block = smoothed(reach)
        _blend(block, core.start, reach, (q, vertical, sigma_rad[:, None]), written)
        at_rest[core.start : reach.stop] = block.at_rest[core.start - reach.start :]
        found.append(block.calibration)
        written = reach.stop
    return SmoothedRecording(q, vertical, sigma_rad, at_rest, tuple(found), overruled)


def _still_bins(
    still: StillSpans, edges: NDArray[np.intp], part: slice
) -> StillBins | None:
    """Return the still bins (between edges) among some samples; None without any."""
    first = int(np.searchsorted(edges, part.start))
    last = int(np.searchsorted(edges, part.stop, side="right")) - 1
    chosen = still.bins[first:last]
    if not chosen.any():
        return None
    everywhere = np.zeros(len(still.bins), np.bool_)
    everywhere[first:last] = chosen
    mean, sigma = mean_rate(still, everywhere)
    inside = edges[first : last + 1] - part.start
    count = np.concatenate([[0.0], np.cumsum(chosen * np.diff(inside))])
    return StillBins(inside.astype(np.float64), count, mean, sigma)


def _still_elsewhere(
    still: StillSpans, edges: NDArray[np.intp], reach: slice, step_s: Floats
) -> StillBins | None:
    """The gyro's mean in the nearest still span outside of a block.

    Args:
        still: of the recording.
        edges: its edges, in samples.
        reach: of the block.
        step_s: (n,) of the samples.
    """
    end_s = np.append(0.0, np.cumsum(step_s))
    start_s, stop_s = end_s[[reach.start, reach.stop]].tolist()
    found = nearest_still_bias(still, end_s[edges], start_s, stop_s)
    if found is None:
        return None
    ends = np.array([0.0, reach.stop - reach.start])
    return StillBins(ends, np.zeros(2), *found)


def _blocks(step_s: Floats, p: SmootherParameters) -> list[tuple[slice, slice]]:
    """Return (what a block is for, what it is computed from) in samples."""
    count = len(step_s)
    whole = [(slice(0, count), slice(0, count))]
    end_s = np.cumsum(step_s)
    number = min(round(float(end_s[-1]) / p.block_s), count // MIN_BLOCK_SAMPLES)
    if number <= 1:
        return whole
    borders_s = np.linspace(0.0, float(end_s[-1]), number + 1)

    def at(time_s: float) -> int:
        return int(np.searchsorted(end_s, time_s))

    blocks = []
    for first_s, last_s in itertools.pairwise(borders_s.tolist()):
        core = slice(at(first_s), at(last_s))
        blocks.append((core, slice(at(first_s - p.margin_s), at(last_s + p.margin_s))))
    if min(core.stop - core.start for core, _ in blocks) < 2:
        return whole
    last_core, last_reach = blocks[-1]
    blocks[-1] = slice(last_core.start, count), slice(last_reach.start, count)
    return blocks


def _blend(
    block: Smoothed, border: int, reach: slice, whole: tuple[Floats, ...], written: int
) -> None:
    """Write a block's rows; turn its heading and blend it into the one before.

    Args:
        block: what is to be written.
        border: first sample that the block is for.
        reach: samples that it was computed from; what is written beyond those it is
            for is there for the next block to blend with.
        whole: quaternion (N, 4), vertical (N, 3) and sigma (N, 1).
        written: how far the block before has written.
    """
    q, half, start = block.quaternion_wxyz, 0, border
    if border > 0:
        half = int(BLENDED_MARGIN_SHARE * min(border - reach.start, written - border))
        start = border - half
        q = _with_heading(q, whole[0][border], border - reach.start)
    mixed = slice(start, start + 2 * half)
    weight = np.linspace(0.0, 1.0, 2 * half)[:, None]
    for part, new in zip(
        whole, (q, block.vertical, block.sigma_rad[:, None]), strict=True
    ):
        old = part[mixed].copy()
        part[start : reach.stop] = new[start - reach.start :]
        if new is q:
            cosine = np.sum(old * part[mixed], axis=1)
            old[cosine < 0.0] *= -1.0
        part[mixed] = weight * part[mixed] + (1.0 - weight) * old
    whole[0][mixed] = quat.normalized(whole[0][mixed])


def _with_heading(block: Floats, before: Floats, at: int) -> Floats:
    """Return quaternions turned about the vertical to the heading before, at a sample."""
    between = quat.multiply(before, quat.conjugate(block[at]))
    turn = np.array([between[0], 0.0, 0.0, between[3]])
    norm = float(np.linalg.norm(turn))
    if norm < 1e-9:  # half a turn about a horizontal axis has no heading
        return block
    return quat.multiply(turn / norm, block)
