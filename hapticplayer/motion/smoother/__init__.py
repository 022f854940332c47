"""The non-causal smoother: orientation from the whole recording.

Method and equations: docs/methods.md. Constants were chosen by the errors of
`python -m benchmarks.motion accuracy`; what half and twice of each does is measured by
`python -m benchmarks.motion sensitivity`, and said beside it where the mean error
changes by 1 % or more.
"""

from hapticplayer.motion.smoother.parameters import SmootherParameters
from hapticplayer.motion.smoother.recording import SmoothedRecording, smooth_recording
from hapticplayer.motion.smoother.samples import InertialSamples, window_mean

__all__ = [
    "InertialSamples",
    "SmoothedRecording",
    "SmootherParameters",
    "smooth_recording",
    "window_mean",
]
