"""Haply Inverse3 through the vendor's service on this machine.

`protocol` has its messages, `driver` makes a haptic device of them. Nothing here was
tried on a real device; what that leaves open is in docs/safety.md.
"""
