"""From the raw arrays of a flawed recording to an honest ImuLog."""

from hapticplayer.motion.repair.samples import Repaired, repair_samples

__all__ = ["Repaired", "repair_samples"]
