"""Injected faults, and a Falcon on a simulated USB chip; for developers."""
