"""Simulated rides, devices, faults and participants: rides, devices, faults and participants.

The rooms below import nothing from here; they load it by name when a person chooses it.
"""
