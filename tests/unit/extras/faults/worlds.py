"""The Falcon's driver on a simulated USB, as a process."""

from tests.unit.devices.conformance.world import Process

WORLDS = {"falcon-simulated": lambda: Process("falcon-simulated", "--running")}
