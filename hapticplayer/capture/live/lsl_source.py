"""A stream of the lab streaming layer (LSL) as a live source.

liblsl brings its stamps to this machine's clock, which is CLOCK_MONOTONIC. Labels and
units are not standardised: those that are clear are used, others are asked.
"""

import importlib
from typing import Any

import numpy as np

from hapticplayer.capture.choices import ACCEL_UNITS, RATE_UNITS, factor
from hapticplayer.capture.live.source import (
    LiveSource,
    Samples,
    SourceLost,
    SourceOptions,
)
from hapticplayer.capture.live.source_answers import Declaration, ask_for_missing
from hapticplayer.capture.log_tables import SENSORS
from hapticplayer.clock import Clock
from hapticplayer.errors import HapticPlayerError, InputError, Message

_RESOLVE_S, _MOST_SAMPLES, _SAME_CLOCK_S = 3.0, 4096, 10.0
_UNITS = {
    "m/s^2": "m/s2", "m/s²": "m/s2", "meters/second^2": "m/s2", "dps": "deg/s",
    "°/s": "deg/s", "degrees/second": "deg/s", "radians/second": "rad/s",
}  # fmt: skip
_MARKS = {"accel": ("acc",), "rate": ("gyr", "angularvelocity", "rotationrate")}
Channels = list[dict[str, str]]
"""Label, type and unit of each channel."""


def channel_columns(channels: Channels, columns: str = "") -> dict[str, list[int]]:
    """The channels of each sensor, x, y, z: as named in `columns=`, or by their labels."""
    names = columns.split(",")
    found = {}
    for sensor, axes in SENSORS.items():
        if set(axes) <= set(names):
            found[sensor] = [names.index(axis) for axis in axes]
        elif not columns:
            marked = [
                number
                for number, one in enumerate(channels)
                if any(mark in _words(one) for mark in _MARKS.get(sensor, ()))
            ]
            if len(marked) == 3:
                found[sensor] = marked
    return found


def _words(channel: dict[str, str]) -> str:
    return f"{channel['label']} {channel['type']}".lower().replace(" ", "")


def channel_unit(channels: Channels, numbers: list[int]) -> str:
    """The unit of some channels, "" if they do not say it clearly."""
    units = {channels[number]["unit"].strip() for number in numbers}
    unit = units.pop() if len(units) == 1 else ""
    unit = _UNITS.get(unit, unit)
    return unit if unit in ACCEL_UNITS or unit in RATE_UNITS else ""


class LslSource:
    """Samples of an inlet.

    Args:
        inlet: of pylsl.
        columns: channels of each sensor.
        to_si: factors of acceleration and rate.
        clock: of this machine.
        where: for people.
    """

    def __init__(
        self,
        inlet: Any,
        columns: dict[str, list[int]],
        to_si: tuple[float, float],
        clock: Clock,
        where: str,
    ) -> None:
        self._inlet, self._columns, self._to_si = inlet, columns, to_si
        self._clock, self._where = clock, where

    def read(self, timeout_s: float) -> Samples:
        try:
            rows, stamps = self._inlet.pull_chunk(max(0.0, timeout_s), _MOST_SAMPLES)
        except RuntimeError as problem:
            raise SourceLost(
                "the stream has ended",
                where=self._where,
                remedy="start its program, and open it again",
            ) from problem
        if not stamps:
            return Samples.of(())
        table, stamp_s = np.array(rows, dtype=np.float64), np.array(stamps)
        accel = table[:, self._columns["accel"]] * self._to_si[0]
        rate = np.full_like(accel, np.nan)
        if "rate" in self._columns:
            rate = table[:, self._columns["rate"]] * self._to_si[1]
        now_s = self._clock.now_s()
        is_ours = np.abs(stamp_s - now_s) < _SAME_CLOCK_S
        arrival_s = np.where(is_ours, np.minimum(stamp_s, now_s), now_s)
        return Samples(arrival_s, stamp_s, accel, rate)

    def close(self) -> None:
        self._inlet.close_stream()


def open_lsl(options: SourceOptions, clock: Clock) -> LiveSource:
    """See `LslSource`; the place is the name of a stream, or its type."""
    name, where = options.place("NAME"), f"{options.source}:{options.text}"
    options.fields({})
    library = _library(where)
    found = library.resolve_byprop("name", name, timeout=_RESOLVE_S)
    found = found or library.resolve_byprop("type", name, timeout=0.5)
    if not found:
        raise InputError(
            "there is no such stream",
            where=where,
            remedy="start the program that sends it, in the same network",
        )
    flags = library.proc_clocksync | library.proc_monotonize
    inlet = library.StreamInlet(found[0], max_buflen=60, processing_flags=flags)
    try:
        channels = _channels(inlet.info(timeout=_RESOLVE_S))
        columns, to_si = _understood(channels, options, where)
        inlet.open_stream(timeout=_RESOLVE_S)
    except RuntimeError as problem:
        inlet.close_stream()
        raise InputError(
            "the stream does not answer ({reason})",
            where=where,
            remedy="look at the network and its firewall",
            reason=problem,
        ) from problem
    except HapticPlayerError:
        inlet.close_stream()
        raise
    return LslSource(inlet, columns, to_si, clock, where)


def _library(where: str) -> Any:
    try:
        return importlib.import_module("pylsl")
    except (ImportError, RuntimeError) as problem:
        raise InputError(
            "LSL streams need pylsl 1.18 or newer with its library",
            where=where,
            remedy="install hapticplayer[lsl], or choose another source",
        ) from problem


def _channels(info: Any) -> Channels:
    if info.channel_format() == 3:  # of texts
        return []
    channel = info.desc().child("channels").child("channel")
    found: Channels = []
    for _ in range(min(info.channel_count(), _MOST_SAMPLES)):
        keys = ("label", "type", "unit")
        found.append({key: channel.child_value(key) for key in keys})
        channel = channel.next_sibling("channel")
    return found


def _understood(
    channels: Channels, options: SourceOptions, where: str
) -> tuple[dict[str, list[int]], tuple[float, float]]:
    """The channels of each sensor, and factors of what a person has not answered."""
    choices = options.choices
    columns = channel_columns(channels, choices.take("columns"))
    largest = max((max(one) for one in columns.values()), default=0)
    if "accel" not in columns or largest >= len(channels):
        labels = ", ".join(one["label"] or "?" for one in channels)[:200]
        raise InputError(
            "its {count} channels ({labels}) do not say which are the accelerometer's",
            where=where,
            remedy="name them in their order (--read-as columns=ax,ay,az,gx,gy,gz; - for "
            "others)",
            count=len(channels),
            labels=labels or Message("without labels"),
        )
    unit = {
        key: channel_unit(channels, columns.get(key, [])) for key in ("accel", "rate")
    }
    rate_unit = unit["rate"] if "rate" in columns else "rad/s"
    ask_for_missing(
        Declaration(accel_unit=unit["accel"], rate_unit=rate_unit), choices, where
    )
    return columns, (
        1.0 if choices.accel_unit else factor(unit["accel"], ACCEL_UNITS, "accel-unit"),
        1.0 if choices.rate_unit else factor(rate_unit, RATE_UNITS, "rate-unit"),
    )
