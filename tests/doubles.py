"""Devices in the test's own process, thread and time."""

from hapticplayer.devices.capabilities import SIMULATED
from hapticplayer.devices.dynamics import RELAXED, Hand, Mechanism
from hapticplayer.devices.falcon.protocol import MotorCommand, Reply, Words
from hapticplayer.devices.paced import Port
from hapticplayer.errors import DeviceError
from hapticplayer.model.device import DeviceReading, Vector
from hapticplayer.simulation.falcon.packets import Control, ScriptedEvent
from hapticplayer.simulation.falcon.parameters import Electronics
from hapticplayer.simulation.falcon.plant import ZERO
from hapticplayer.simulation.falcon.simulation import Simulation


class SimulatedFalcon:
    """A `HapticDevice` that answers at once, and whose faults are methods.

    `simulation` holds the truth behind the readings; None is a free grip.
    """

    name = "simulated"
    capabilities = SIMULATED

    def __init__(
        self,
        hand: Hand | None = RELAXED,
        *,
        mechanism: Mechanism | None = None,
        electronics: Electronics | None = None,
    ) -> None:
        self.simulation = Simulation(hand, mechanism=mechanism, electronics=electronics)
        self._last: DeviceReading | None = None
        self._is_plugged = True
        self._stall_s = 0.0
        self._deaf_until_s = 0.0
        self._corrupt = 0
        self._malformed = 0

    def open(self) -> None:
        """Raises DeviceError when it was unplugged."""
        self._check_plug()

    def exchange(self, force_n: Vector, now_s: float) -> DeviceReading:
        """Advance to `now_s` under the force so far, then take the new one.

        Raises:
            DeviceError: when it was unplugged.
        """
        self._check_plug()
        self.simulation.advance(now_s)
        if self._last is None:
            self._last = DeviceReading(ZERO, 0, is_homed=False, replied_s=now_s)
        if self._stall_s > 0.0:
            self._deaf_until_s, self._stall_s = now_s + self._stall_s, 0.0
        if now_s < self._deaf_until_s:
            return self._last
        self.simulation.command(force_n, now_s)
        if self._corrupt > 0:
            self._corrupt -= 1
            self._malformed += 1
            self._last = self._last._replace(malformed=self._malformed)
        else:
            self._malformed = 0
            self._last = self.simulation.reading(now_s)
        return self._last

    def close(self) -> None:
        """Nothing to let go of."""

    def let_go(self) -> None:
        """Take the hand away."""
        self.simulation.let_go()

    def grasp(self, hand: Hand | None = None) -> None:
        """Put a hand on the grip, by default the one from before."""
        self.simulation.grasp(hand)

    def press(self, buttons: int) -> None:
        """Press the buttons of this bit mask, and release the others."""
        self.simulation.act(Control(ScriptedEvent.BUTTONS, buttons))

    def unplug(self) -> None:
        """From now on every exchange raises DeviceError."""
        self._is_plugged = False

    def stall(self, duration_s: float) -> None:
        """Neither listen nor answer for so long, from the next exchange on."""
        self._stall_s = duration_s

    def corrupt(self, count: int) -> None:
        """Falsify the next answers; the commands arrive."""
        self._corrupt = count

    def lose_homing(self) -> None:
        """Say from now on that the position is invalid."""
        self.simulation.is_homed = False

    def _check_plug(self) -> None:
        if not self._is_plugged:
            raise DeviceError(
                "the simulated Falcon was unplugged; choose the device again"
            )


class BenchMechanics:
    """Encoders that stand where a test has put them; commands are written down."""

    def __init__(self, counts: Words = (-300, -300, -300), homed: int = 7) -> None:
        self.counts, self.buttons, self.homed = counts, 0, homed
        self.commands: list[tuple[float, Words]] = []

    def command(self, command: MotorCommand, at_s: float) -> None:
        """Write the words down."""
        self.commands.append((at_s, command.words))

    def reply(self, at_s: float) -> Reply:
        """Return what the test wants."""
        return Reply(self.counts, self.buttons, self.homed)


class DirectWriter:
    """Writes to a paced device in the caller's thread, which may have to wait."""

    is_waiting, taken = False, 0

    def __init__(self, port: Port) -> None:
        self._port = port

    def post(self, command: bytes) -> None:
        """Send a command."""
        self._port.write(command)

    def stop(self) -> None:
        """There is nothing to poll."""
