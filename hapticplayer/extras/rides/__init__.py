"""Rides whose true motion is known: trajectories, and the sensors that record them."""
