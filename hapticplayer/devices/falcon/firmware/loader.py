"""Starting the Falcon's processor: hello, autobaud, upload, and trying again.

The order of steps is that of libnifalcon's FalconCommLibUSB and FalconFirmware. Its
users report that the first upload often fails and that the next one, after closing
and opening the device, works; so that is done here without a word.
"""

from collections.abc import Callable
from dataclasses import dataclass

from hapticplayer.clock import Clock
from hapticplayer.devices.falcon.firmware.image import FirmwareImage
from hapticplayer.devices.falcon.ftdi import (
    HELLO_BAUD,
    LOADER_BAUD,
    PAYLOAD_BYTES,
    RUN_BAUD,
    Ftdi,
)
from hapticplayer.devices.falcon.protocol import ReplyParser, encode_command
from hapticplayer.devices.falcon.transport import OpenTransport
from hapticplayer.errors import Cancelled, DeviceError, Message

HELLO = b"\x0aC\x0d"
HELLO_ANSWER = b"\x0aD,\x0d"
"""Some devices send a zero byte first, the trace of a glitch on the line."""
AUTOBAUD = b"A"
ZERO_FRAME = encode_command((0, 0, 0))

Progress = Callable[[float], None]
"""Called with the part of the image that is loaded, 0 to 1; may raise Cancelled."""


@dataclass(frozen=True, slots=True)
class RetryLimits:
    """How often and how long to try."""

    attempts: int = 10  # uploads, each on a newly opened device
    hellos: int = 20  # calls to the boot processor in each
    # for one answer; 7 bytes at 9600 baud take 7.3 ms, the chip's latency another 16
    hello_s: float = 0.05
    # for the line CTS after the hello. An unmerged change to libnifalcon says that the
    # loader then is ready; it is not certain, so that afterwards the upload begins all
    # the same
    clear_to_send_s: float = 0.1
    echo_s: float = 0.5  # without a byte of echo
    probes: int = 10  # zero frames to see whether the firmware runs
    probe_s: float = 0.01  # for an answer to one of them
    rest_s: float = 0.2  # between closing and opening


RETRY_LIMITS = RetryLimits()


class UploadError(DeviceError):
    """One attempt to load the firmware has failed; the next one may not."""


def open_running(
    open_transport: OpenTransport,
    find_image: Callable[[], FirmwareImage],
    clock: Clock,
    retry: RetryLimits = RETRY_LIMITS,
    progress: Progress | None = None,
) -> Ftdi:
    """Return an open Falcon whose firmware runs, loading it where necessary.

    `find_image` is called only when it is needed, `progress` with the share of the
    upload.
    """
    ftdi = Ftdi(open_transport())
    try:
        if is_running(ftdi, clock, retry):
            return ftdi
        image = find_image()
    except DeviceError:
        ftdi.close()
        raise
    problem: DeviceError | None = None
    for attempt in range(retry.attempts):
        try:
            if attempt:
                ftdi = Ftdi(open_transport())
            upload(ftdi, image, clock, retry, progress)
        except DeviceError as failure:
            ftdi.close()
            problem = failure
            clock.sleep_until(clock.now_s() + retry.rest_s)
        except Cancelled:
            ftdi.close()
            raise
        else:
            return ftdi
    raise DeviceError(
        "the Falcon did not start in {attempts} attempts (the last: "
        "{reason}); unplug its power and USB, plug both in, if you can "
        "without a hub, and try again",
        attempts=retry.attempts,
        reason=problem,
    ) from problem


def is_running(ftdi: Ftdi, clock: Clock, retry: RetryLimits = RETRY_LIMITS) -> bool:
    """Whether the firmware answers; the frames that ask are without force."""
    ftdi.set_latency(1)
    ftdi.set_baud(RUN_BAUD)
    ftdi.set_format()
    ftdi.purge()
    parser = ReplyParser()
    for _ in range(retry.probes):
        ftdi.write(ZERO_FRAME, retry.probe_s)
        deadline_s = clock.now_s() + retry.probe_s
        while (left_s := deadline_s - clock.now_s()) > 0.0:
            if parser.feed(ftdi.read(left_s)):
                return True
    return False


def upload(
    ftdi: Ftdi,
    image: FirmwareImage,
    clock: Clock,
    retry: RetryLimits = RETRY_LIMITS,
    progress: Progress | None = None,
) -> None:
    """Load the firmware into a Falcon that has none, once.

    Raises:
        UploadError: when the device answers otherwise than it should.
        DeviceError: when it is gone.
    """
    progress = progress or _nobody_looks
    _say_hello(ftdi, clock, retry, progress)
    _find_the_rate(ftdi, clock, retry)
    data = image.data
    for start in range(0, len(data), PAYLOAD_BYTES):
        block = data[start : start + PAYLOAD_BYTES]
        _send_with_echo(
            ftdi, block, clock, retry.echo_s, Message("byte {number}", number=start)
        )
        progress((start + len(block)) / len(data))
    if not is_running(ftdi, clock, retry):
        raise UploadError("the firmware was loaded and does not answer")


def _nobody_looks(_part: float) -> None:
    """Show nothing."""


def _say_hello(
    ftdi: Ftdi, clock: Clock, retry: RetryLimits, progress: Progress
) -> None:
    """Reset the processors by the line DTR and wait for the one that boots."""
    ftdi.set_event_character(b"")
    ftdi.purge()
    ftdi.set_latency(16)  # with 1 ms "checks tend to fail", says libnifalcon
    ftdi.set_baud(HELLO_BAUD)
    ftdi.set_format()
    ftdi.set_rts(is_high=False)
    ftdi.set_dtr(is_high=False)
    ftdi.set_dtr(is_high=True)
    heard = b""
    for _ in range(retry.hellos):
        progress(0.0)  # here, too, a person may have had enough
        ftdi.write(HELLO, retry.hello_s)
        deadline_s = clock.now_s() + retry.hello_s
        while (left_s := deadline_s - clock.now_s()) > 0.0:
            heard = heard[-PAYLOAD_BYTES:] + ftdi.read(left_s)
            if HELLO_ANSWER in heard:
                return
    raise UploadError("its boot processor does not answer")


def _find_the_rate(ftdi: Ftdi, clock: Clock, retry: RetryLimits) -> None:
    """Change to the loader's rate, which the loader takes from one letter."""
    ftdi.set_dtr(is_high=False)
    ftdi.set_baud(LOADER_BAUD)
    deadline_s = clock.now_s() + retry.clear_to_send_s
    late = b""
    while (left_s := deadline_s - clock.now_s()) > 0.0:
        late = ftdi.read(left_s)
        if ftdi.is_clear_to_send and not late:
            break
    _send_with_echo(ftdi, AUTOBAUD, clock, retry.echo_s, Message("the letter A"))


def _send_with_echo(
    ftdi: Ftdi, data: bytes, clock: Clock, echo_s: float, where: str
) -> None:
    """Send bytes and see all of them come back; raises UploadError when they do not."""
    if ftdi.write(data, echo_s) != len(data):
        raise UploadError("it did not accept all of the data at {place}", place=where)
    echo = b""
    deadline_s = clock.now_s() + echo_s
    while len(echo) < len(data):
        left_s = deadline_s - clock.now_s()
        if left_s <= 0.0:
            raise UploadError(
                "its echo at {place} ended after {count} of {expected} bytes",
                place=where,
                count=len(echo),
                expected=len(data),
            )
        heard = ftdi.read(left_s)
        if heard:
            echo += heard
            deadline_s = clock.now_s() + echo_s
    if echo != data:
        raise UploadError("its echo at {place} was wrong", place=where)
