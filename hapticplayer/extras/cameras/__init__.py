"""Telemetry of cameras beyond GoPro."""
