"""The Falcon as a haptic device: from power-up to forces, and safely back to zero."""

import atexit
import enum
from collections.abc import Callable
from dataclasses import dataclass

from hapticplayer.clock import Clock, SystemClock
from hapticplayer.devices.capabilities import FALCON
from hapticplayer.devices.descriptor_passing import hand_over
from hapticplayer.devices.falcon import usbfs
from hapticplayer.devices.falcon.firmware import (
    RETRY_LIMITS,
    FirmwareImage,
    Progress,
    RetryLimits,
    find_image,
    open_running,
)
from hapticplayer.devices.falcon.ftdi import Ftdi
from hapticplayer.devices.falcon.kinematics import (
    Counts,
    Kinematics,
    OutOfReachError,
    Pose,
    motor_words,
)
from hapticplayer.devices.falcon.link import WRITE_S, Link, ThreadedLink
from hapticplayer.devices.falcon.protocol import Lights, Reply, encode_command
from hapticplayer.devices.falcon.transport import OpenTransport, Transport, open_falcon
from hapticplayer.devices.options import DeviceOptions
from hapticplayer.errors import DeviceError, Message
from hapticplayer.model.device import DeviceReading, Vector

MOST_COUNTS_PER_MS = 200
"""A joint at 127 rad/s, the grip at 9 m/s: no hand does that, a glitch does."""
LEAPS_TO_FAULT = 5


class Tracker:
    """Where the grip is, as far as the replies can be trusted.

    Attributes:
        pose: of the last trusted reply of homed encoders; None before.
        is_homed: whether the last reply's encoders were all homed.
        replied_s: time of the last trusted reply; 0 before.
        buttons: of that reply.
        rejected: replies in a row, up to now, that were not trusted.
    """

    def __init__(self, kinematics: Kinematics) -> None:
        self._kinematics = kinematics
        self._counts: Counts | None = None
        self._last_s = 0.0
        self.pose: Pose | None = None
        self.is_homed = False
        self.replied_s = 0.0
        self.buttons = 0
        self.rejected = 0

    @property
    def has_lost_its_place(self) -> bool:
        """Whether the encoders went on from elsewhere: it was no glitch."""
        return self.rejected >= LEAPS_TO_FAULT

    def take(self, reply: Reply, at_s: float) -> None:
        """Use a reply that has not been used before."""
        gap_s, self._last_s = at_s - self._last_s, at_s
        self.is_homed = reply.is_homed
        if not reply.is_homed:  # the counts mean nothing, and will jump to their zero
            self._counts, self.pose = None, None
        elif self._leaps(reply.counts, gap_s) or not self._moved_to(reply.counts):
            self.rejected += 1
            return
        self.rejected = 0
        self.replied_s, self.buttons = at_s, reply.buttons

    def _leaps(self, counts: Counts, gap_s: float) -> bool:
        if self._counts is None:
            return False
        most = MOST_COUNTS_PER_MS * max(1.0, gap_s / _PERIOD_S)
        pairs = zip(counts, self._counts, strict=True)
        return any(abs(now - before) > most for now, before in pairs)

    def _moved_to(self, counts: Counts) -> bool:
        if counts == self._counts:
            return True
        near_m = self.pose.position_m if self.pose is not None else None
        try:
            self.pose = self._kinematics.pose(self._kinematics.angles(counts), near_m)
        except OutOfReachError:
            return False
        self._counts = counts
        return True


STALE_S = 0.05
"""Without a reply for so long, the position is too old to compute torques from."""
ZEROS_AT_THE_END = 5
_PERIOD_S = 0.001
_ZERO: Vector = (0.0, 0.0, 0.0)
_REST_FRAME = encode_command((0, 0, 0))
_RED_FRAME = encode_command((0, 0, 0), Lights.RED | Lights.HOMING)
_PLACE_LOST = Message(
    "the Falcon's position has jumped and stayed away; home it again, "
    "then choose the device again"
)
_NOT_FINITE = Message(
    "a force that is not a number was commanded, a defect of this program; "
    "please report it, and choose the device again"
)


class DriverState(enum.Enum):
    """How far a Falcon has come; forces only in READY."""

    DISCONNECTED = "not connected"
    UNLOADED = "without firmware"
    LOADED = "firmware runs"
    HOMING = "pull the grip out as far as it goes, then push it in until it locks"
    READY = "ready"
    FAULT = "stopped by a fault"


@dataclass(frozen=True, slots=True)
class Options:
    """What owners may have to choose, because no source settles it.

    Attributes:
        event_character: let the chip answer at once after a frame's last byte, not
            when its latency timer is over. From the chip's data sheet; no known
            driver does it.
        homing_bit_stays: keep asking for homing when it is done. libnifalcon says
            so; traces of the vendor's driver show it clear.
        retry: limits of the firmware's loader.
    """

    event_character: bool = False
    homing_bit_stays: bool = True
    retry: RetryLimits = RETRY_LIMITS


DEFAULTS = Options()


@dataclass
class _Session:
    """What lasts from `open` to `close`."""

    ftdi: Ftdi
    tracker: Tracker
    link: Link | None = None
    reply: Reply | None = None
    malformed: int = 0
    fault: str = ""


class FalconDriver:
    """A `HapticDevice`: `exchange` posts frame k and takes the reply to k - 1.

    Positions and forces are in frame D, positions from the workspace's centre. `image`
    returns the firmware, when it has to be loaded; by default the transport is that of
    the only Falcon plugged in.
    """

    name = "falcon"
    capabilities = FALCON

    def __init__(
        self,
        open_transport: OpenTransport = open_falcon,
        *,
        clock: Clock | None = None,
        image: Callable[[], FirmwareImage] = find_image,
        make_link: Callable[[Ftdi, Clock], Link] = ThreadedLink,
        options: Options = DEFAULTS,
    ) -> None:
        self._open_transport = open_transport
        self._clock = clock or SystemClock()
        self._image = image
        self._kinematics = Kinematics()
        self._make_link = make_link
        self._options = options
        self._session: _Session | None = None
        self._state = DriverState.DISCONNECTED
        homing = int(Lights.HOMING) if options.homing_bit_stays else 0
        # plain numbers: operations on flags take as long as encoding the frame
        self._force_lights = int(Lights.BLUE) | homing
        self._ready_frame = encode_command((0, 0, 0), int(Lights.GREEN) | homing)

    @property
    def state(self) -> DriverState:
        """How far the device has come."""
        return self._state

    @property
    def reply(self) -> Reply | None:
        """The newest reply as it came, for guidance during homing."""
        return self._session.reply if self._session is not None else None

    def open(self, progress: Progress | None = None) -> None:
        """Connect, load the firmware if needed; raises DeviceError with what to do."""
        self.close()
        self._state = DriverState.UNLOADED
        try:
            ftdi = open_running(
                self._open_transport,
                self._image,
                self._clock,
                self._options.retry,
                progress,
            )
            self._session = _Session(ftdi, Tracker(self._kinematics))
            ftdi.set_event_character(b">" if self._options.event_character else b"")
        except BaseException:
            self.close()
            raise
        self._state = DriverState.LOADED
        atexit.register(self.close)

    def exchange(self, force_n: Vector, now_s: float) -> DeviceReading:
        """Command a force and return the newest answer; never waits for one.

        The force is zero on the wire unless the device is homed and answers. Before
        the first answer the reading is the centre, not homed, as old as the first
        exchange.

        Raises:
            DeviceError: when the device is not open or gone, or a fault has stopped
                it; then it is sent zero.
        """
        session = self._session
        if session is None:
            raise DeviceError("the Falcon is not open; choose the device again")
        link = session.link
        if link is None:  # not earlier, so that it runs with the loop's scheduling
            link = session.link = self._make_link(session.ftdi, self._clock)
            session.tracker.replied_s = now_s
        try:
            self._listen(session, link)
            link.post(self._frame(session, force_n, now_s))
        except DeviceError:
            self._state = DriverState.DISCONNECTED
            raise
        if session.fault:
            self._state = DriverState.FAULT
            raise DeviceError(session.fault)
        return self._reading(session)

    def close(self) -> None:
        """Leave zero frames behind and let go of the device; may be called again."""
        atexit.unregister(self.close)
        session, self._session = self._session, None
        self._state = DriverState.DISCONNECTED
        if session is None:
            return
        if session.link is not None:
            session.link.stop()
        try:
            self._leave_zeros(session.ftdi)
        except DeviceError:
            return  # it is gone, and its force with it
        finally:
            session.ftdi.close()

    def _leave_zeros(self, ftdi: Ftdi) -> None:
        for _ in range(ZEROS_AT_THE_END):
            ftdi.write(_REST_FRAME, WRITE_S)
            self._clock.sleep_until(self._clock.now_s() + _PERIOD_S)
        ftdi.set_event_character(b"")

    def _listen(self, session: _Session, link: Link) -> None:
        reply, at_s, session.malformed = link.newest()
        if reply is None or reply is session.reply:
            return
        session.reply = reply
        tracker = session.tracker
        tracker.take(reply, at_s)
        if tracker.has_lost_its_place:
            session.fault = _PLACE_LOST
        self._state = DriverState.READY if tracker.is_homed else DriverState.HOMING

    def _frame(self, session: _Session, force_n: Vector, now_s: float) -> bytes:
        pose = session.tracker.pose
        if pose is None or session.fault or self._state is not DriverState.READY:
            return _RED_FRAME
        if force_n == _ZERO or now_s - session.tracker.replied_s > STALE_S:
            return self._ready_frame
        try:
            i, j, k = motor_words(pose.jacobian, force_n)
        except ValueError:
            session.fault = _NOT_FINITE
            return _RED_FRAME
        return encode_command((round(i), round(j), round(k)), self._force_lights)

    def _reading(self, session: _Session) -> DeviceReading:
        tracker, position_m = session.tracker, _ZERO
        if tracker.pose is not None:
            x, y, z = tracker.pose.position_m
            position_m = (x, y, z - self._kinematics.geometry.centre_z_m)
        return DeviceReading(
            position_m,
            tracker.buttons,
            tracker.is_homed,
            tracker.replied_s,
            session.malformed + tracker.rejected,
        )


def opening(line: int, serial: str = "") -> OpenTransport:
    """The opener of the Falcon that is plugged in, for a guard as well.

    `line` is the descriptor along which the guard is handed the open USB file, -1 where
    there is none; it stays the caller's.
    """

    def open_and_share() -> Transport:
        transport = open_falcon(serial)
        file = usbfs.open_descriptor(transport.bus, transport.address)
        if file is not None and line >= 0:
            hand_over(line, file)
        return transport

    return open_and_share


def make(line: int, options: DeviceOptions) -> FalconDriver:
    """The driver of the Falcon that is plugged in; see `opening`."""
    return FalconDriver(opening(line, options.address))
