"""The non-causal smoother: orientation from the whole recording."""

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
