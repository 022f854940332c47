"""What frames tell of the camera's motion; the only place for OpenCV.

OpenCV comes with the optional extra `hapticplayer[vision]`.
"""

from hapticplayer.capture.vision.rotation import FrameRotation, rotation
from hapticplayer.capture.vision.watching import FeatureKind, is_available, why_broken

__all__ = ["FeatureKind", "FrameRotation", "is_available", "rotation", "why_broken"]
