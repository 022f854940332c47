"""A Falcon that is only computed: its mechanism, a hand, and the socket to reach it.

`Simulation` is the physics in virtual time, `RemoteFalcon` the device made of it in a
process of its own (`python -m hapticplayer.simulation.falcon`).
"""
