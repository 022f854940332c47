"""The feedback conditions of the study, one line each: realistic, none, random.

Source: Danieau et al. 2012: the random feedback is white noise low-passed at
0.5 Hz; here with the same RMS per axis as the realistic track it stands beside.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from hapticplayer.errors import Message
from hapticplayer.model import Feedback, ForceTrack, Reconstruction

CUTOFF_HZ = 0.5
BUTTERWORTH_ORDER = 4
WARM_UP_S = 10.0  # five periods of the cut-off: the filter has forgotten its start
RATE_HZ = 50.0  # a hundred times the cut-off: straight lines between are exact enough


def random_feedback(realistic: ForceTrack, seed: int) -> ForceTrack:
    """Return smooth random force of the same span and RMS per axis.

    Args:
        realistic: the track to stand in for.
        seed: of numpy's default generator (PCG64); stored in the provenance.

    Returns:
        LINEAR track at 50 Hz over the same time span.
    """
    from scipy import signal  # half a second that playing does not need

    start_s, end_s = float(realistic.time_s[0]), float(realistic.time_s[-1])
    count = max(2, int(np.ceil((end_s - start_s) * RATE_HZ)) + 1)
    warm_up = round(WARM_UP_S * RATE_HZ)
    rng = np.random.default_rng(seed)
    noise = rng.standard_normal((warm_up + count, 3))
    sos = signal.butter(BUTTERWORTH_ORDER, CUTOFF_HZ, fs=RATE_HZ, output="sos")
    smooth = signal.sosfilt(sos, noise, axis=0)[warm_up:]
    smooth *= realistic.rms_n() / np.sqrt(np.mean(np.square(smooth), axis=0))
    time_s = np.linspace(start_s, max(end_s, start_s + 1.0 / RATE_HZ), count)
    return ForceTrack(
        time_s=time_s,
        force_n=smooth.astype(np.float32),
        reconstruction=Reconstruction.LINEAR,
        provenance={
            "feedback": Feedback.RANDOM.value,
            "seed": seed,
            "cutoff_hz": CUTOFF_HZ,
            "butterworth_order": BUTTERWORTH_ORDER,
            "rms_n": [float(value) for value in realistic.rms_n()],
        },
    )


def no_feedback(realistic: ForceTrack) -> ForceTrack:
    """Return a track of the same span without force: one zero entry at each end."""
    start_s, end_s = realistic.time_s[0], realistic.time_s[-1]
    return ForceTrack(
        time_s=np.array([start_s, max(end_s, start_s + 1e-3)]),
        force_n=np.zeros((2, 3), dtype=np.float32),
        provenance={"feedback": Feedback.NONE.value},
    )


class FeedbackCondition(NamedTuple):
    """What the hand gets while the clip plays.

    Attributes:
        name: in files and on the command line.
        text: for people.
        make: returns the track for the realistic one and a seed.
        is_stored: whether a sequence keeps the track in a file of its own; else it is
            made when the sequence is opened.
    """

    name: str
    text: Message
    make: Callable[[ForceTrack, int], ForceTrack]
    is_stored: bool = True


FEEDBACKS: tuple[FeedbackCondition, ...] = (
    FeedbackCondition(
        Feedback.REALISTIC, Message("Realistic"), lambda realistic, _seed: realistic
    ),
    FeedbackCondition(
        Feedback.NONE,
        Message("None"),
        lambda realistic, _seed: no_feedback(realistic),
        is_stored=False,
    ),
    FeedbackCondition(Feedback.RANDOM, Message("Random"), random_feedback),
)
"""In the order in which people see them. A sequence may hold further tracks."""
