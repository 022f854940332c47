"""The feedback conditions of the study, one entry each.

Source: Danieau et al. 2012 for realistic, none and random: white noise low-passed at
0.5 Hz; here with the same RMS per axis as the realistic track it stands beside.
"""

import numpy as np

from hapticplayer.errors import Message
from hapticplayer.model import Feedback, ForceTrack, PresetName, Reconstruction, ranges
from hapticplayer.rendering.condition import (
    ChosenFeedback,
    ConditionInputs,
    FeedbackCondition,
    Parameter,
    ParameterKind,
    pairs_of,
)
from hapticplayer.rendering.derived import inverted, shifted_and_scaled, shuffled

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


_PRESET = Parameter(
    "preset",
    Message("Preset"),
    ParameterKind.WORD,
    "",
    choices=tuple(PresetName),
)
_DELAY = Parameter(
    "delay_s",
    Message("Delay"),
    ParameterKind.NUMBER,
    0.3,
    ranges.FORCE_DELAY_S,
)
_GAIN = Parameter("gain", Message("Gain"), ParameterKind.NUMBER, 0.5, ranges.FORCE_GAIN)
_OF = Parameter("of", Message("Other sequence"), ParameterKind.CLIP, "")
_TRACK = Parameter("track", Message("Track"), ParameterKind.TRACK, "")
_EFFECTS = Parameter(
    "effects", Message("Effects"), ParameterKind.WORD, "", choices=("off",)
)


def _realistic(of: ConditionInputs, preset: str, effects: str) -> ForceTrack:
    is_other = preset or effects
    return of.rendered(preset, not effects) if is_other else of.realistic


def _shuffled(inputs: ConditionInputs, of: str) -> ForceTrack:
    return shuffled(inputs.realistic, inputs.other(of))


FEEDBACKS: tuple[FeedbackCondition, ...] = (
    FeedbackCondition(
        Feedback.REALISTIC,
        Message("Realistic"),
        _realistic,
        Message("the force of the recorded motion"),
        (_PRESET, _EFFECTS),
        simulated_as=Feedback.REALISTIC,
    ),
    FeedbackCondition(
        Feedback.ESTIMATED,
        Message("Estimated"),
        lambda of: of.realistic,
        Message("the force of a motion that was estimated from the picture"),
        simulated_as=Feedback.REALISTIC,
    ),
    FeedbackCondition(
        Feedback.NONE,
        Message("None"),
        lambda of: no_feedback(of.realistic),
        Message("no force"),
        is_stored=False,
        simulated_as=Feedback.NONE,
    ),
    FeedbackCondition(
        Feedback.RANDOM,
        Message("Random"),
        lambda of: random_feedback(of.realistic, of.seed),
        Message("smooth noise below 0.5 Hz, with the RMS of the realistic force"),
    ),
    FeedbackCondition(
        "shuffled",
        Message("Shuffled"),
        _shuffled,
        Message("the realistic force of another clip, with the RMS of this one"),
        (_OF,),
        is_stored=False,
        is_derived=True,
    ),
    FeedbackCondition(
        "delayed",
        Message("Delayed"),
        lambda of, delay_s: shifted_and_scaled(of.realistic, delay_s, 1.0),
        Message("the realistic force, later than the picture"),
        (_DELAY,),
        is_stored=False,
        is_derived=True,
    ),
    FeedbackCondition(
        "inverted",
        Message("Inverted"),
        lambda of: inverted(of.realistic),
        Message("the realistic force in the opposite direction"),
        is_stored=False,
        is_derived=True,
    ),
    FeedbackCondition(
        "scaled",
        Message("Scaled"),
        lambda of, gain: shifted_and_scaled(of.realistic, 0.0, gain),
        Message("the realistic force, stronger or weaker"),
        (_GAIN,),
        is_stored=False,
        is_derived=True,
        simulated_as=Feedback.REALISTIC,
    ),
    FeedbackCondition(
        "edited",
        Message("Edited"),
        lambda of, track: of.stored(track) if track else of.edited(),
        Message("the realistic force with the effects of the sequence on it"),
        (_TRACK,),
        is_stored=False,
        is_derived=True,
        simulated_as=Feedback.REALISTIC,
    ),
)
"""In the order in which people see them. A sequence may hold further tracks."""


def condition_named(name: str) -> FeedbackCondition | None:
    """Return the condition of a name; None for a further track of a sequence."""
    return next((one for one in FEEDBACKS if one.name == name), None)


def chosen_feedback(text: str) -> ChosenFeedback:
    """The choice in a text such as `delayed:delay_s=0.3`."""
    name, mark, rest = text.partition(":")
    condition = condition_named(name)
    if condition is None or not mark:
        return ChosenFeedback(text, {})
    given = {one: condition.parameter(one).read(value) for one, value in pairs_of(rest)}
    return ChosenFeedback(name, given)
