"""Force feedback of Linux: wheels and joysticks with one axis, game pads that rumble.

`effects` has the kernel's bytes, `options` what is chosen with the device, `ports` is the
only place that knows /dev/input, and `driver` makes haptic devices of them.
"""
