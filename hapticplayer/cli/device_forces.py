"""`device test`: the gentle test of any device, through all that guards a hand."""

import argparse
import json
import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.cli.common import agreed, complain, interruptible, peak_text, say
from hapticplayer.clock import SystemClock
from hapticplayer.devices import find_device
from hapticplayer.devices.guides import guide_of, hold_text
from hapticplayer.haptics.block import REFUSED, SENT
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.playback.device_test import DevicePart, DeviceTest, parts_of
from hapticplayer.playback.forces import moved_along

POLL_S = 0.02
HOMING_S = 120.0
_WAIT_FOR_HOMING = "pull the grip out as far as it goes, then push it in until it locks"


def test_forces(options: argparse.Namespace) -> int:
    """Test a device and say how it took it."""
    entry, parts = find_device(options.device), parts_of(options.device)
    hold = hold_text(guide_of(entry), entry.capabilities)
    agreed(
        options,
        f"The device will move or vibrate gently for {sum(p.end_s for p in parts):.0f} s"
        f"{_what(parts)}. {hold} Ctrl-C or a button on it stops. Ready?",
    )
    test, ticks = _tested(options.device)
    report = {"device": entry.name, "ticks": len(ticks)}
    report |= _packets(ticks) if entry.takes_motion else _forces(ticks)
    if test.loudest:
        report["channels"] = test.loudest
    say(json.dumps(report) if options.json else _text(report))
    if test.problem:
        complain(test.problem)
    elif test.mode is Mode.TRIPPED:
        complain(f"stopped: {test.cause.name.lower().replace('_', ' ')}")
    return int(bool(test.problem) or test.mode is Mode.TRIPPED)


def _what(parts: tuple[DevicePart, ...]) -> str:
    labels = ", ".join(part.label for part in parts if part.label)
    if labels:
        return f", channel by channel: {labels}"
    sizes = (getattr(step, "strength_n", 0.0) for step in parts[0].steps)
    largest_n = max(sizes, default=0.0)
    return f" with up to {largest_n:.1f} N" if largest_n else ""


def _tested(device: str) -> tuple[DeviceTest, NDArray[Any]]:
    """A test that is over, and its ticks."""
    clock, is_told = SystemClock(), False
    test = DeviceTest(clock, device, homing_s=HOMING_S)
    ticks = []
    try:
        with interruptible():
            while not test.is_over:
                ticks.append(test.poll())
                if test.cause is Cause.NOT_HOMED and len(ticks) > 1 and not is_told:
                    is_told = True
                    sys.stderr.write(_WAIT_FOR_HOMING + "\n")
                clock.sleep_until(clock.now_s() + POLL_S)
    finally:
        test.stop()
        test.wait()
    return test, np.concatenate(ticks)


def _packets(ticks: NDArray[Any]) -> dict[str, Any]:
    flags = ticks["buttons"]
    return {
        "packets": int(np.count_nonzero(flags & SENT)),
        "is_heard": not np.any(flags & REFUSED),
    }


def _forces(ticks: NDArray[Any]) -> dict[str, Any]:
    played = ticks[ticks["mode"] == Mode.FOLLOWING]
    if not len(played):
        return {}
    age_ms = 1e3 * np.percentile(played["reply_age_s"], (50, 99))
    late_us = 1e6 * np.percentile(played["lateness_s"], (50, 99))
    size_n = np.linalg.norm(played["force_n"], axis=1)
    travel_mm = 1e3 * np.ptp(played["position_m"], axis=0)
    return {
        "largest_force_n": round(float(size_n.max()), 3),
        "travel_mm": [round(float(way), 1) for way in travel_mm],
        "moved_along_the_force": round(moved_along(played), 3),
        "reply_age_ms": {"p50": round(age_ms[0], 3), "p99": round(age_ms[1], 3)},
        "lateness_us": {"p50": round(late_us[0], 1), "p99": round(late_us[1], 1)},
        "missed": int(played["missed"].sum()),
    }


def _text(report: dict[str, Any]) -> str:
    if "packets" in report:
        return f"{report['packets']} packets sent" + (
            ", but nobody listens there" * (not report["is_heard"])
        )
    if "channels" in report:
        return "\n".join(
            f"channel {one['channel']} played, {peak_text(one)}"
            for one in report["channels"]
        )
    if "travel_mm" not in report:
        return "No force was made."
    x, y, z = report["travel_mm"]
    age, late = report["reply_age_ms"], report["lateness_us"]
    return (
        f"force      up to {report['largest_force_n']} N\n"
        f"way        {x} x {y} x {z} mm; along the force "
        f"{report['moved_along_the_force']:+.2f} (1 is exactly)\n"
        f"answers    p50 {age['p50']} ms, p99 {age['p99']} ms old\n"
        f"loop       late by p50 {late['p50']} us, p99 {late['p99']} us; "
        f"{report['missed']} missed"
    )
