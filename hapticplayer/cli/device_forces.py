"""`device test`: a slow circle of force, through all that guards a hand."""

import argparse
import json
import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hapticplayer.cli.common import agreed, complain, interruptible, peak_text, say
from hapticplayer.clock import SystemClock
from hapticplayer.devices import find_device
from hapticplayer.errors import DeviceError, Message
from hapticplayer.extras.shakers.settings import ShakerSettings
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.rig.loop import REFUSED, SENT
from hapticplayer.model import ForceTrack
from hapticplayer.model.device import Signal
from hapticplayer.model.rig_track import RigTrack
from hapticplayer.playback.forces import ForcePlayer, moved_along
from hapticplayer.playback.latch import StopLatch
from hapticplayer.rendering import circle, rig_demonstration
from hapticplayer.rendering.demonstration import CIRCLE_N

POLL_S = 0.02
HOMING_S = 120.0
_WAIT_FOR_HOMING = "pull the grip out as far as it goes, then push it in until it locks"


def test_forces(options: argparse.Namespace) -> int:
    """Draw a circle and say how the device took it."""
    entry = find_device(options.device)
    if entry.capabilities.signal is Signal.MOTION:
        return _test_rig(options)
    chosen = entry.settings
    if isinstance(chosen, ShakerSettings):
        return _test_shaker(options, chosen)
    agreed(
        options,
        f"The device will draw a slow circle of {CIRCLE_N} N. Hold its grip loosely; "
        "any button on it, or Ctrl-C, stops. Ready?",
    )
    player, ticks = _played(options.device, circle())
    report = _report(options.device, ticks)
    say(json.dumps(report) if options.json else _text(report))
    if player.mode is Mode.TRIPPED:
        complain(f"stopped: {player.cause.name.lower().replace('_', ' ')}")
        return 1
    if player.problem:
        complain(player.problem)
        return 1
    return 0


def _test_rig(options: argparse.Namespace) -> int:
    """Move a rig gently along and about each axis, and say what was sent."""
    track, steps = rig_demonstration()
    agreed(
        options,
        f"The rig will move gently for {track.time_s[-1]:.0f} s: "
        f"{', '.join(step.axis for step in steps)}. Its seat must be free, its emergency "
        "stop at hand; Ctrl-C brings it to rest. Ready?",
    )
    player, ticks = _played(options.device, track)
    flags = ticks["buttons"]
    packets = int(np.count_nonzero(flags & SENT))
    is_heard = not np.any(flags & REFUSED)
    report = {"device": options.device, "packets": packets, "is_heard": is_heard}
    said = f"{packets} packets sent" + ", but nobody listens there" * (not is_heard)
    say(json.dumps(report) if options.json else said)
    if player.problem:
        complain(player.problem)
    return int(bool(player.problem))


def _test_shaker(options: argparse.Namespace, chosen: ShakerSettings) -> int:
    """Play each channel of a shaker in turn, gently."""
    track = circle()
    channels = ", ".join(map(str, chosen.channels))
    agreed(
        options,
        f"The shakers on channels {channels} of {chosen.address or 'default'} will swell and fade in "
        f"turn, {track.time_s[-1]:.0f} s each. Turn their amplifier low; Ctrl-C stops. "
        "Ready?",
    )
    played: list[dict[str, Any]] = []
    latch = StopLatch()
    problem: Message | str = ""
    for channel in chosen.channels:
        player, _ = _played(chosen.alone(channel), track, latch, has_grip=False)
        if player.problem:
            problem = player.problem
            break
        for level in player.loudest.described():
            played.append(level)
            if not options.json:
                say(f"channel {channel} played, {peak_text(level)}")
    if options.json:
        say(json.dumps({"device": options.device, "channels": played}))
    if problem:
        complain(problem)
    return int(bool(problem))


def _played(
    device: str,
    track: ForceTrack | RigTrack,
    latch: StopLatch | None = None,
    *,
    has_grip: bool = True,
) -> tuple[ForcePlayer, NDArray[Any]]:
    """Play a track to its end; return the player, closed, and its ticks."""
    clock = SystemClock()
    player = ForcePlayer(clock, device, track, latch)
    try:
        with interruptible():
            player.wait_ready()
            return player, np.concatenate(_ticks(player, clock, has_grip=has_grip))
    finally:
        player.close()


def _ticks(
    player: ForcePlayer, clock: SystemClock, *, has_grip: bool
) -> list[NDArray[Any]]:
    ticks = [player.poll()]
    limit_s, is_shown = clock.now_s() + HOMING_S, not has_grip
    while not player.is_over:
        ticks.append(player.poll())
        if player.cause is Cause.NOT_HOMED and not is_shown:
            is_shown = True
            sys.stderr.write(_WAIT_FOR_HOMING + "\n")
        if player.media_s == 0.0 and clock.now_s() > limit_s:
            raise DeviceError(
                f"the device was not homed in {HOMING_S:.0f} s; try again"
            )
        clock.sleep_until(clock.now_s() + POLL_S)
    return ticks


def _report(device: str, ticks: NDArray[Any]) -> dict[str, Any]:
    played = ticks[ticks["mode"] == Mode.FOLLOWING]
    report: dict[str, Any] = {"device": device, "ticks": len(ticks)}
    if not len(played):
        return report
    age_ms = 1e3 * np.percentile(played["reply_age_s"], (50, 99))
    late_us = 1e6 * np.percentile(played["lateness_s"], (50, 99))
    size_n = np.linalg.norm(played["force_n"], axis=1)
    travel_mm = 1e3 * np.ptp(played["position_m"], axis=0)
    return report | {
        "largest_force_n": round(float(size_n.max()), 3),
        "travel_mm": [round(float(way), 1) for way in travel_mm],
        "moved_along_the_force": round(moved_along(played), 3),
        "reply_age_ms": {"p50": round(age_ms[0], 3), "p99": round(age_ms[1], 3)},
        "lateness_us": {"p50": round(late_us[0], 1), "p99": round(late_us[1], 1)},
        "missed": int(played["missed"].sum()),
    }


def _text(report: dict[str, Any]) -> str:
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
