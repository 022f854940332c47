"""Logs of phones, loggers and inertial sensors, each with a layout of its own."""
