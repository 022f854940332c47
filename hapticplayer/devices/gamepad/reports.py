"""Input and output reports of DualSense and DualShock 4 over USB.

Layouts: Linux, drivers/hid/hid-playstation.c (structs dualsense_output_report_common,
dualshock4_output_report_common, and the input reports of both). Only motors are set;
lights and triggers stay as they are.
"""

from dataclasses import dataclass

from hapticplayer.devices.gamepad.rumble import Rumble
from hapticplayer.model.device import Vector

VENDOR_ID = 0x054C
INPUT_ID = 0x01
_NEUTRAL = 8  # of the direction pad


@dataclass(frozen=True, slots=True)
class Layout:
    """Where things are in the reports of one kind of pad.

    Attributes:
        title: for people.
        product_ids: of USB.
        head: first bytes of an output report: its id, and flags (compatible vibration
            and haptics select, or motors).
        size: of an output report, bytes.
        weak_at, strong_at: the two motors, 0 to 255 each.
        buttons_at: first of three bytes in an input report.
    """

    title: str
    product_ids: tuple[int, ...]
    head: bytes
    size: int
    weak_at: int
    strong_at: int
    buttons_at: int


DUALSENSE = Layout(
    "DualSense",
    (0x0CE6, 0x0DF2),
    b"\x02\x03",
    48,
    weak_at=3,
    strong_at=4,
    buttons_at=8,
)
DUALSHOCK4 = Layout(
    "DualShock 4",
    (0x05C4, 0x09CC),
    b"\x05\x01",
    32,
    weak_at=4,
    strong_at=5,
    buttons_at=5,
)
LAYOUTS = (DUALSENSE, DUALSHOCK4)


def layout_of(product_id: int) -> Layout | None:
    """Return the layout of a pad, None for other devices."""
    for layout in LAYOUTS:
        if product_id in layout.product_ids:
            return layout
    return None


def motors_report(layout: Layout, strong: int, weak: int) -> bytes:
    """Return the report that sets both motors, 0 to 255; else it raises ValueError."""
    report = bytearray(layout.size)
    report[: len(layout.head)] = layout.head
    report[layout.weak_at], report[layout.strong_at] = weak, strong
    return bytes(report)


def audio_report() -> bytes:
    """Return the report that leaves a DualSense's voice coils to its sound channels.

    Both flags of vibration are clear: it and sound exclude each other.
    """
    return b"\x02" + bytes(DUALSENSE.size - 1)


def buttons_of(layout: Layout, report: bytes) -> int | None:
    """Return the pressed buttons as a mask of 16 bits; None for other reports.

    Bits: the four on the right, then shoulders, triggers, menu buttons and sticks,
    then up to three more, and last any direction of the direction pad.
    """
    at = layout.buttons_at
    if len(report) < at + 3 or report[0] != INPUT_ID:
        return None
    first, second, third = report[at : at + 3]
    third &= 0x07 if layout is DUALSENSE else 0x03  # a counter is above them
    is_directed = (first & 0x0F) < _NEUTRAL
    return first >> 4 | second << 4 | third << 12 | is_directed << 15


class PadRumble:
    """Rumble in the reports of one kind of pad (`paced.Translator`)."""

    def __init__(self, layout: Layout) -> None:
        self._layout, self._rumble = layout, Rumble()
        self.off = motors_report(layout, 0, 0)

    def command(self, force_n: Vector, now_s: float) -> bytes:
        """Return the report that shakes with a force."""
        return motors_report(self._layout, *self._rumble.levels(force_n, now_s))

    def buttons(self, report: bytes) -> int | None:
        """Return what is pressed, None for other reports."""
        return buttons_of(self._layout, report)
