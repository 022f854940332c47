"""A pad on USB that keeps what was sent; below hidapi's two functions."""

from hapticplayer.devices.gamepad.reports import DUALSENSE, INPUT_ID, PadRumble
from hapticplayer.errors import DeviceError


class FakePad:
    """Answers each look with one input report, as long as it is plugged in."""

    is_quiet = False

    def __init__(self, layout=DUALSENSE):
        self.layout = layout
        self.translator = PadRumble(layout)
        self.written = []
        self.is_plugged, self.answers, self.is_open = True, True, True
        self.buttons = b"\x08\x00\x00"
        self.garbage = 0
        self._is_due = True

    def write(self, report):
        self._check()
        self.written.append(bytes(report))

    def read(self):
        self._check()
        self._is_due = not self._is_due  # one report, then nothing
        if self._is_due or not self.answers:
            return b""
        if self.garbage:
            self.garbage -= 1
            return b"\x31" + bytes(77)
        report = bytearray(64)
        report[0] = INPUT_ID
        at = self.layout.buttons_at
        report[at : at + 3] = self.buttons
        return bytes(report)

    def close(self):
        self.is_open = False

    @property
    def motors(self):
        """(large, small) as last sent."""
        if not self.written:
            return (0, 0)
        last = self.written[-1]
        return last[self.layout.strong_at], last[self.layout.weak_at]

    def _check(self):
        if not self.is_plugged:
            raise DeviceError("the pad was unplugged; plug it in and choose it again")
