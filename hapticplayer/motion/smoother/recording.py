"""Recordings of any length: blocks with a calibration each, blended where they meet."""

import itertools
import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.model import quaternions as quat
from hapticplayer.model.arrays import Floats
from hapticplayer.motion.smoother.block import Calibration, Smoothed, smooth
from hapticplayer.motion.smoother.parameters import SmootherParameters
from hapticplayer.motion.smoother.rest import Rest
from hapticplayer.motion.smoother.strapdown import Samples
from hapticplayer.motion.stillness import StillSpans

Flags = NDArray[np.bool_]

# Fewer samples are no block of their own, however long they take.
_FEWEST = 50
# Neighbouring blocks are blended over this share of their margins.
_BLEND = 0.25
# An accelerometer that is off by so much along the vertical at rest may be off by
# twice that sideways.
_SIDEWAYS = 2.0


@dataclass(frozen=True, slots=True, eq=False)
class SmoothedRecording:
    """The result for a whole recording.

    Attributes:
        quaternion_wxyz: (n, 4) sensor to earth at each sample.
        vertical: (n, 3) up in the sensor frame; for averaged samples its mean over
            their time.
        sigma_rad: (n,) standard deviation of the tilt, both axes together.
        at_rest: (n,) still samples that were found to be so.
        blocks: what was found in each.
    """

    quaternion_wxyz: Floats
    vertical: Floats
    sigma_rad: Floats
    at_rest: NDArray[np.bool_]
    blocks: tuple[Calibration, ...]

    @property
    def time_constant_s(self) -> tuple[float, float]:
        """Shortest and longest of the levelling."""
        constants_s = [block.time_constant_s for block in self.blocks]
        return (
            min(float(part.min()) for part in constants_s),
            max(float(part.max()) for part in constants_s),
        )

    def mean(self, name: str) -> Floats:
        """Return a calibration by its name, the mean over the blocks."""
        found = [getattr(block, name) for block in self.blocks]
        return np.asarray(found[0] if len(found) == 1 else np.mean(found, axis=0))


def smooth_recording(
    samples: Samples,
    still: StillSpans,
    p: SmootherParameters,
    places: NDArray[np.intp] | None = None,
    *,
    with_sigma: bool = True,
) -> SmoothedRecording:
    """Return the orientation of at least two samples.

    Args:
        samples: of the recording.
        still: where it stands still, counted in `places`.
        p: settings.
        places: those samples that are asked for; None for all.
        with_sigma: whether the uncertainty is wanted; it is 0 otherwise.
    """
    if samples.gain != 1.0:
        upright_mps2 = STANDARD_GRAVITY_MPS2 * abs(samples.gain - 1.0)
        bias_mps2 = math.hypot(p.accelerometer_bias_mps2, _SIDEWAYS * upright_mps2)
        p = replace(p, accelerometer_bias_mps2=bias_mps2)
    spans = _edges(still)
    if places is None:
        return _whole(samples, spans, p, with_sigma=with_sigma)
    moved = _moved(spans, places)
    return _picked(_whole(samples, moved, p, with_sigma=with_sigma), places)


def _whole(
    samples: Samples, still: "_Still | None", p: SmootherParameters, *, with_sigma: bool
) -> SmoothedRecording:
    count = len(samples)
    blocks = _blocks(samples.step_s, p)
    if len(blocks) == 1:
        rest = _rest(still, slice(0, count))
        return _alone(smooth(samples, rest, p, with_sigma=with_sigma))
    whole = (
        np.empty((count, 4)),
        np.empty((count, 3)),
        np.empty(count),
        np.empty(count, np.bool_),
    )
    found: list[Calibration] = []
    written = 0
    for core, reach in blocks:
        part, rest = samples.cut(reach.start, reach.stop), _rest(still, reach)
        block = smooth(part, rest, p, with_sigma=with_sigma)
        found.append(block.calibration)
        _put(block, core.start, reach, whole, written)
        written = reach.stop
    return SmoothedRecording(*whole, tuple(found))


@dataclass(frozen=True, slots=True, eq=False)
class _Still:
    """Still spans by their edges in samples: (B + 1,) edges of B bins."""

    edges: NDArray[np.intp]
    spans: StillSpans


def _edges(still: StillSpans) -> _Still | None:
    """Return the still spans by their edges; None where there are none."""
    if not still.bins.any():
        return None
    return _Still(still.per_bin * np.arange(len(still.bins) + 1), still)


def _moved(still: _Still | None, places: NDArray[np.intp]) -> _Still | None:
    """Return the still spans where other samples were put between."""
    if still is None:
        return None
    first = np.append(0, places[:-1] + 1)  # what was put in belongs to the one after
    ends = np.append(first, places[-1] + 1)
    return _Still(ends[still.edges], still.spans)


def _picked(whole: SmoothedRecording, places: NDArray[np.intp]) -> SmoothedRecording:
    return replace(
        whole,
        quaternion_wxyz=whole.quaternion_wxyz[places],
        vertical=whole.vertical[places],
        sigma_rad=whole.sigma_rad[places],
        at_rest=whole.at_rest[places],
    )


def _rest(still: _Still | None, part: slice) -> Rest | None:
    """Return what is known of the still spans among some samples."""
    if still is None:
        return None
    spans = still.spans
    first = int(np.searchsorted(still.edges, part.start))
    last = int(np.searchsorted(still.edges, part.stop, side="right")) - 1
    chosen = spans.bins[first:last]
    if not chosen.any():
        return None
    rate = spans.rate_radps[:, first:last][:, chosen]
    mean = rate.mean(axis=1)
    scatter = math.sqrt(float(np.square(rate - mean[:, None]).mean()))
    # a sensor that is held does not turn the same way for longer than a second
    sigma = scatter / math.sqrt(len(rate.T) * spans.bin_s)
    edges = still.edges[first : last + 1] - part.start
    count = np.concatenate([[0.0], np.cumsum(chosen * np.diff(edges))])
    return Rest(edges.astype(np.float64), count, mean, sigma)


def _alone(block: Smoothed) -> SmoothedRecording:
    return SmoothedRecording(
        block.quaternion_wxyz,
        block.vertical,
        block.sigma_rad,
        block.at_rest,
        (block.calibration,),
    )


def _blocks(step_s: Floats, p: SmootherParameters) -> list[tuple[slice, slice]]:
    """Return (what a block is for, what it looks at) in samples."""
    count = len(step_s)
    number = round(float(step_s.sum()) / p.block_s)
    number = max(1, min(number, count // _FEWEST))
    if number == 1:
        return [(slice(0, count), slice(0, count))]
    end_s = np.cumsum(step_s)
    borders_s = np.linspace(0.0, float(end_s[-1]), number + 1)

    def at(time_s: float) -> int:
        return int(np.searchsorted(end_s, time_s))

    blocks = []
    for first_s, last_s in itertools.pairwise(borders_s.tolist()):
        core = slice(at(first_s), at(last_s))
        blocks.append((core, slice(at(first_s - p.margin_s), at(last_s + p.margin_s))))
    if min(core.stop - core.start for core, _ in blocks) < 2:
        return [(slice(0, count), slice(0, count))]
    last_core, last_reach = blocks[-1]
    blocks[-1] = slice(last_core.start, count), slice(last_reach.start, count)
    return blocks


def _put(
    block: Smoothed,
    border: int,
    reach: slice,
    whole: tuple[Floats, Floats, Floats, Flags],
    written: int,
) -> None:
    """Write a block's part; turn its heading and blend it into the one before.

    Args:
        block: what is to be written.
        border: first sample that the block is for.
        reach: samples that it looked at; what is written beyond those it is for is
            there for the next block to blend with.
        whole: where it is written.
        written: how far the block before has written.
    """
    *tables, at_rest = whole
    parts = [block.quaternion_wxyz, block.vertical, block.sigma_rad[:, None]]
    half, start = 0, border
    if border > 0:
        half = int(_BLEND * min(border - reach.start, written - border))
        start = border - half
        parts[0] = _turned(parts[0], whole[0][border], border - reach.start)
    weight = np.linspace(0.0, 1.0, 2 * half)[:, None]
    for target, part in zip(tables, parts, strict=True):
        table = target.reshape(len(target), -1)  # a view
        new = part[start - reach.start :]
        old = table[start : start + 2 * half].copy()
        table[start : reach.stop] = new
        table[start : start + 2 * half] *= weight
        table[start : start + 2 * half] += (1.0 - weight) * _same_side(old, new)
    at_rest[start : reach.stop] = block.at_rest[start - reach.start :]
    mixed = whole[0][start : start + 2 * half]
    mixed /= np.linalg.norm(mixed, axis=1, keepdims=True)


def _same_side(old: Floats, new: Floats) -> Floats:
    """Return quaternions with the sign of others; leave other tables alone."""
    if old.shape[1] != 4:
        return old
    cosine = np.sum(old * new[: len(old)], axis=1, keepdims=True)
    return np.where(cosine < 0.0, -old, old)


def _turned(block: Floats, before: Floats, at: int) -> Floats:
    """Return the block turned about the vertical to the heading before, at a sample."""
    between = quat.multiply(before, quat.conjugate(block[at]))
    turn = np.array([between[0], 0.0, 0.0, between[3]])
    norm = float(np.linalg.norm(turn))
    if norm < 1e-9:  # half a turn about a horizontal axis has no heading
        return block
    return quat.multiply(turn / norm, block)
