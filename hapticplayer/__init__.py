"""hapticplayer: play a video and feel the motion of whoever recorded it.

The engine: no Qt, importable without a display.
"""

__version__ = "0.2.0"
