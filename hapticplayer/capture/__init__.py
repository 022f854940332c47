"""Recordings in: camera telemetry, motion logs, and the recording simulator.

Times are media time (0 is the first picture) where the clocks are one; frame A is
x right, y front, z up. Each module is loaded when its first name is used.
"""

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hapticplayer.capture.csv_log import (
        read_force_csv,
        read_imu_csv,
        write_imu_csv,
    )
    from hapticplayer.capture.gopro import GoProTelemetry, read_gopro, read_raw_gopro
    from hapticplayer.capture.logs import (
        LogChoices,
        LogQuestion,
        parse_choices,
        write_template,
    )
    from hapticplayer.capture.motion_scenes import (
        MOTION_SCENES,
        SimulatedMotion,
        simulate_motion,
    )
    from hapticplayer.capture.recording import Recording, read_recording
    from hapticplayer.capture.rides import RIDES, SCENES
    from hapticplayer.capture.sensor_model import SENSORS, SensorErrors, SensorModel
    from hapticplayer.capture.simulator import (
        SimulatedRecording,
        simulate,
        write_gopro_clip,
        write_simulated_clip,
    )
    from hapticplayer.capture.sync import Synchronisation, read_sound, synchronize

_HOMES = {
    "MOTION_SCENES": "motion_scenes",
    "RIDES": "rides",
    "SCENES": "rides",
    "SENSORS": "sensor_model",
    "GoProTelemetry": "gopro",
    "LogChoices": "logs",
    "LogQuestion": "logs",
    "Recording": "recording",
    "SensorErrors": "sensor_model",
    "SensorModel": "sensor_model",
    "SimulatedMotion": "motion_scenes",
    "SimulatedRecording": "simulator",
    "Synchronisation": "sync",
    "parse_choices": "logs",
    "read_force_csv": "csv_log",
    "read_gopro": "gopro",
    "read_imu_csv": "csv_log",
    "read_raw_gopro": "gopro",
    "read_recording": "recording",
    "read_sound": "sync",
    "simulate": "simulator",
    "simulate_motion": "motion_scenes",
    "synchronize": "sync",
    "write_gopro_clip": "simulator",
    "write_imu_csv": "csv_log",
    "write_simulated_clip": "simulator",
    "write_template": "logs",
}

__all__ = [
    "MOTION_SCENES",
    "RIDES",
    "SCENES",
    "SENSORS",
    "GoProTelemetry",
    "LogChoices",
    "LogQuestion",
    "Recording",
    "SensorErrors",
    "SensorModel",
    "SimulatedMotion",
    "SimulatedRecording",
    "Synchronisation",
    "parse_choices",
    "read_force_csv",
    "read_gopro",
    "read_imu_csv",
    "read_raw_gopro",
    "read_recording",
    "read_sound",
    "simulate",
    "simulate_motion",
    "synchronize",
    "write_gopro_clip",
    "write_imu_csv",
    "write_simulated_clip",
    "write_template",
]


def __getattr__(name: str) -> object:
    """Load the module of a public name at its first use."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module = importlib.import_module(f"{__name__}.{_HOMES[name]}")
    globals()[name] = getattr(module, name)
    return globals()[name]
