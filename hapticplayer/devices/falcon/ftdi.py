"""The FT232R between USB and the Falcon's processors: line settings and packets.

Request numbers: Linux, drivers/usb/serial/ftdi_sio.h. When the chip answers: FTDI's
application note AN232B-04 (62 bytes are waiting, a modem line or the event character
changed, or the latency timer is over; then also without data).
"""

from typing import NamedTuple

from hapticplayer.devices.falcon.transport import PACKET_BYTES, Transport

STATUS_BYTES = 2
PAYLOAD_BYTES = PACKET_BYTES - STATUS_BYTES

RESET, MODEM, FLOW, BAUD, DATA, EVENT, LATENCY = 0, 1, 2, 3, 4, 6, 9
RESET_ALL, PURGE_ONE, PURGE_TWO = 0, 1, 2
EIGHT_BITS_NO_PARITY = 0x0008
NO_FLOW_CONTROL = 0
CTS = 0x10
"""Clear to send, in the first status byte."""

_CLOCK_HZ = 3_000_000
_EIGHTHS = (0, 4, 2, 1, 3, 5, 6, 7)  # by the three bits of the fraction's code
_EVENT_IS_ON = 0x100


class Divisor(NamedTuple):
    """Encode a baud rate for the chip: wValue and wIndex of the request."""

    request_value: int
    request_index: int

    @property
    def baud(self) -> float:
        """The rate that results."""
        whole, code = (
            self.request_value & 0x3FFF,
            self.request_value >> 14 | (self.request_index & 1) << 2,
        )
        if whole <= 1 and code == 0:
            return _CLOCK_HZ / (1.0, 1.5)[whole]  # 0 and 1 are special
        return _CLOCK_HZ / (whole + _EIGHTHS[code] / 8.0)


HELLO_BAUD = Divisor(0x4138, 0)
"""9600."""
LOADER_BAUD = Divisor(0x0015, 0)
"""142857, called 140000 by the vendor; the boot loader adapts to it."""
RUN_BAUD = Divisor(0x0002, 0)
"""1.5 million, called 1456312 by the vendor."""


def strip_status(data: bytes) -> bytes:
    """Return the payload: every packet of 64 bytes begins with two status bytes."""
    if len(data) <= PACKET_BYTES:
        return data[STATUS_BYTES:]
    return b"".join(
        data[start + STATUS_BYTES : start + PACKET_BYTES]
        for start in range(0, len(data), PACKET_BYTES)
    )


class Ftdi:
    """The chip's settings, and its line as a stream of bytes.

    Methods raise DeviceError when the transport does. One thread may read while
    another one writes.
    """

    def __init__(self, transport: Transport) -> None:
        self._transport = transport
        self._modem_status = 0

    @property
    def is_clear_to_send(self) -> bool:
        """State of the line CTS in the newest packet."""
        return bool(self._modem_status & CTS)

    def purge(self) -> None:
        """Forget what the chip has not yet passed on, in both directions."""
        self._transport.control(RESET, PURGE_ONE)
        self._transport.control(RESET, PURGE_TWO)

    def set_baud(self, divisor: Divisor) -> None:
        """Set the rate of the line."""
        self._transport.control(BAUD, *divisor)

    def set_format(self) -> None:
        """Set 8 bits, no parity, one stop bit, no flow control."""
        self._transport.control(DATA, EIGHT_BITS_NO_PARITY)
        self._transport.control(FLOW, NO_FLOW_CONTROL)

    def set_dtr(self, *, is_high: bool) -> None:
        self._transport.control(MODEM, 0x0101 if is_high else 0x0100)

    def set_rts(self, *, is_high: bool) -> None:
        self._transport.control(MODEM, 0x0202 if is_high else 0x0200)

    def set_latency(self, milliseconds: int) -> None:
        """Set how long the chip waits for more before it answers, 1 to 255 ms."""
        self._transport.control(LATENCY, milliseconds)

    def set_event_character(self, character: bytes) -> None:
        """Let the chip answer at once after this character; b"" for never."""
        self._transport.control(EVENT, _EVENT_IS_ON | character[0] if character else 0)

    def write(self, data: bytes, timeout_s: float) -> int:
        """Send bytes; return how many were taken before the time was over."""
        return self._transport.write(data, timeout_s)

    def read(self, timeout_s: float) -> bytes:
        """Return the payload of the next packet; b"" is normal."""
        data = self._transport.read(timeout_s)
        if data:
            self._modem_status = data[0]
        return strip_status(data)

    def close(self) -> None:
        """Let go of the device."""
        self._transport.close()
