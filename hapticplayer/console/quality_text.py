"""The quality report and the table of the methods as plain text."""

import math
from typing import Any

_COLUMNS = (
    ("RMS of p", "rms_mps2", 3),
    ("at rest", "leak_at_rest_mps2", 3),
    ("to default", "difference_mps2", 3),
    ("sigma", "gravity_sigma_mps2", 3),
    ("us/sample", "us_per_sample", 2),
)


def quality_text(report: dict[str, Any]) -> str:
    """Return a quality report (`sequence.quality.describe_quality`) as lines."""
    read, found = report["recording"], report["gravity_removal"]
    lines = [
        f"{read['source']} - {read['camera']}",
        _line("recording", _recording_text(read)),
        *(_line("as read", note) for note in read["notes"]),
        *(_line("conditioned", step) for step in report["conditioning"]),
        _line("method", _method_text(found)),
        *(_line(name, text) for name, text in _bias_texts(found)),
        _line(
            "gain",
            f"{found['accelerometer_gain']:.4f} ({found['accelerometer_gain_from']})",
        ),
        _line("at rest", _leak_text(found)),
        _line(
            "samples",
            f"{_percent(found['saturated_share'])} at the sensor's limit, "
            f"{_percent(found['invalid_share'])} not valid",
        ),
        _line("uncertainty", _sigma_text(found)),
        _line("motion", _motion_text(report["motion"])),
        *(_line(*entry) for entry in _excursion_texts(report.get("excursion"))),
    ]
    return "\n".join(lines + [f"note: {note}" for note in report.get("notes", ())])


def comparison_text(rows: list[dict[str, Any]], chosen: str) -> str:
    """Return the methods side by side; the chosen one has a star."""
    head = f"{'m/s^2':<14}" + "".join(f"{name:>12}" for name, _, _ in _COLUMNS)
    lines = [head]
    for row in rows:
        name = row["method"] + (" *" if row["method"] == chosen else "")
        cells = (_number(row[key], digits) for _, key, digits in _COLUMNS)
        lines.append(f"{name:<14}" + "".join(f"{cell:>12}" for cell in cells))
    return "\n".join(lines)


def _line(name: str, text: str) -> str:
    return f"  {name:<13}{text}"


def _recording_text(read: dict[str, Any]) -> str:
    text = (
        f"{read['samples']} samples in {read['duration_s']:.2f} s "
        f"at {read['rate_hz']:.2f} Hz, "
    )
    if not read["gaps"]:
        return text + "no gaps"
    count = "one gap" if read["gaps"] == 1 else f"{read['gaps']} gaps"
    return text + f"{count}, the longest of {read['longest_gap_s']:.2f} s"


def _method_text(found: dict[str, Any]) -> str:
    constants_s = found.get("time_constant_s")
    if not constants_s:
        return str(found["method"])
    shortest_s, longest_s = constants_s
    span = f"{shortest_s:.1f} s"
    if longest_s - shortest_s >= 0.05:
        span = f"{shortest_s:.1f} to {longest_s:.1f} s"
    return f"{found['method']}, time constant {span} ({found['time_constant_from']})"


def _bias_texts(found: dict[str, Any]) -> list[tuple[str, str]]:
    texts = []
    if gyro := found.get("gyro_bias_radps"):
        degrees = ", ".join(f"{math.degrees(value):+.3f}" for value in gyro)
        source = found.get("gyro_bias_from")
        texts.append(
            ("gyro bias", f"{degrees} deg/s" + (f" ({source})" * bool(source)))
        )
    if force := found.get("accelerometer_bias_mps2"):
        numbers = ", ".join(f"{value:+.3f}" for value in force)
        texts.append(("acc. bias", f"{numbers} m/s^2"))
    return texts


def _leak_text(found: dict[str, Any]) -> str:
    leak_mps2 = found["leak_at_rest_mps2"]
    if leak_mps2 is None:
        return "no still span to tell how much gravity is left"
    return f"{leak_mps2:.3f} m/s^2 of gravity left, over {found['still_s']:.1f} s"


def _sigma_text(found: dict[str, Any]) -> str:
    sigma_mps2 = found["gravity_sigma_mps2"]
    if sigma_mps2 is None:
        return "not known to this method"
    return f"{sigma_mps2:.3f} m/s^2 (median sigma of the removed gravity)"


def _motion_text(motion: dict[str, Any]) -> str:
    if motion["rms_mps2"] is None:
        return "no valid sample"
    return (
        f"RMS {motion['rms_mps2']:.3f} m/s^2, peak {motion['peak_mps2']:.2f} m/s^2 "
        f"at {motion['peak_at_s']:.2f} s"
    )


def _excursion_texts(found: dict[str, Any] | None) -> list[tuple[str, str]]:
    """Return how far hands would go; reports of older versions do not say."""
    if found is None:
        return []
    hands = found["hands"]
    reached = ", ".join(
        f"{name} {100.0 * one['reach']:.0f} %" for name, one in hands.items()
    )
    far = f"{_percent(hands['relaxed']['far_share'])} of the time beyond"
    heat = f"{_percent(found['thermal_share'])} of the continuous force"
    return [
        ("excursion", f"{reached} of the workspace (at the default gain)"),
        ("relaxed hand", f"{far} {100.0 * found['far']:.0f} %"),
        *(("trip", _trip_text(*entry)) for entry in hands.items() if entry[1]["trip"]),
        ("motors", f"{found['rms_10s_n']:.2f} N over 10 s at most, {heat}"),
    ]


def _trip_text(name: str, one: dict[str, Any]) -> str:
    return f"{name} hand: {one['trip']} at {one['trip_at_s']:.1f} s stops the force"


def _number(value: float | None, digits: int) -> str:
    return "-" if value is None else f"{value:.{digits}f}"


def _percent(share: float) -> str:
    return f"{100.0 * share:.3g} %"
