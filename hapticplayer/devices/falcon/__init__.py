"""The Novint Falcon over USB, from the wire up.

`transport` moves bytes, `ftdi` is the serial chip, `firmware` starts the processor
behind it, `protocol` has the frames, `kinematics` the legs, and `driver` makes a
haptic device of all of them.
"""
