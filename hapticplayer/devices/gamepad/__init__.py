"""Game pads with two motors: a felt trace of the force, without its direction.

`reports` has the bytes, `rumble` turns force into motors, `ports` is the only place
that knows hidapi, and `driver` makes a haptic device of them.
"""
