"""The 1 kHz process: it owns the device, and brings the hand to rest.

Run as `python -m hapticplayer.haptics` by `HapticsProcesses`. The force track is
known in advance, so the process gets the whole track and a clock; single forces
never cross the border. It imports the standard library, `model` and `devices` only:
its memory is locked, and numpy alone would be 65 MB of it.
"""
