"""The paper's processing between capture and rendering, and effects on the motion.

Source: Danieau et al. 2012, "A Framework for Enhancing Video Viewing Experience with
Haptic Effects of Motion", section 3.2.2. Each module states its frequency response and
what it does to time stamps. The order that loses least: spikes, clipping, averaging or
decimation, gravity removal, low-pass, modulation.
"""

from hapticplayer.motion.conditioning.averaging import (
    average,
    average_motion,
    average_response,
)
from hapticplayer.motion.conditioning.clipping import (
    Clipping,
    ClippingLimits,
    ClippingReport,
    reconstruct,
    repair_clipping,
)
from hapticplayer.motion.conditioning.decimation import (
    decimate,
    decimate_even,
    decimate_motion,
    decimation_response,
)
from hapticplayer.motion.conditioning.filtering import (
    lowpass,
    lowpass_motion,
    lowpass_response,
)
from hapticplayer.motion.conditioning.modulation import GainSpan, gain_at, modulate
from hapticplayer.motion.conditioning.rails import find_rails
from hapticplayer.motion.conditioning.spike_search import (
    SpikeLimits,
    find_spikes,
    replace_samples,
)
from hapticplayer.motion.conditioning.spikes import SpikeReport, remove_spikes

__all__ = [
    "Clipping",
    "ClippingLimits",
    "ClippingReport",
    "GainSpan",
    "SpikeLimits",
    "SpikeReport",
    "average",
    "average_motion",
    "average_response",
    "decimate",
    "decimate_even",
    "decimate_motion",
    "decimation_response",
    "find_rails",
    "find_spikes",
    "gain_at",
    "lowpass",
    "lowpass_motion",
    "lowpass_response",
    "modulate",
    "reconstruct",
    "remove_spikes",
    "repair_clipping",
    "replace_samples",
]
