"""The paper's processing between capture and rendering, and repair of samples.

Source: Danieau et al. 2012, "A Framework for Enhancing Video Viewing Experience with
Haptic Effects of Motion", section 3.2.2. Each module states its frequency response and
what it does to time stamps. The order that loses least: spikes, clipping, averaging,
gravity removal, low-pass.
"""

from hapticplayer.motion.conditioning.averaging import average
from hapticplayer.motion.conditioning.clipping import repair_clipping
from hapticplayer.motion.conditioning.filtering import lowpass_motion
from hapticplayer.motion.conditioning.spikes import remove_spikes

__all__ = ["average", "lowpass_motion", "remove_spikes", "repair_clipping"]
