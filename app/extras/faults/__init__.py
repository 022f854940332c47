"""The panel that injects faults."""
