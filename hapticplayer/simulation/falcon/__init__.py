"""A Falcon that is only computed: its mechanism, a hand, and the socket to reach it.

`Simulation` is the physics in virtual time, `SimulatedFalcon` the device made of it
in the caller's process, `RemoteFalcon` the same device in a process of its own
(`python -m hapticplayer.simulation.falcon`).
"""
