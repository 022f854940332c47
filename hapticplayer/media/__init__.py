"""Everything that PyAV does: open, probe, decode, take telemetry, encode.

Media time 0 is where the first frame is shown; all times of this room count from there,
in seconds. `files`, `limits` and `memory` do not load PyAV.
"""
