"""Shakers and voice coils on a sound card: force as sound in the band that they have.

`settings` has what a person chooses, `signal` turns force into samples, and `driver`
plays them at stated times; it is the only place here that knows sounddevice.
"""
