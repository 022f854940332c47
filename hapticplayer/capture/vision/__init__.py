"""What frames tell of the camera's rotation; the only place for OpenCV.

OpenCV comes with the optional extra `hapticplayer[vision]`.
"""

from hapticplayer.capture.vision.rotation import FrameRotation, is_available, rotation

__all__ = ["FrameRotation", "is_available", "rotation"]
