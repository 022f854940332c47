"""The driver as a haptic device on a simulated Falcon, in virtual time."""

import math

import pytest

from hapticplayer.devices.capabilities import FALCON
from hapticplayer.devices.dynamics import Mechanism
from hapticplayer.devices.falcon import kinematics, matrix3
from hapticplayer.devices.falcon.driver import (
    STALE_S,
    ZEROS_AT_THE_END,
    DriverState,
    FalconDriver,
)
from hapticplayer.devices.falcon.link import DirectLink
from hapticplayer.devices.falcon.protocol import Lights
from hapticplayer.errors import DeviceError
from hapticplayer.extras.faults.usb.board import Stage
from hapticplayer.extras.faults.usb.mechanics import SimulatedMechanics
from hapticplayer.simulation.falcon.simulation import Simulation

ZERO = (0.0, 0.0, 0.0)
PUSH = (1.0, 2.0, -3.0)


class Session:
    """A driver that is exchanged with every millisecond."""

    def __init__(self, bench, **options):
        self.bench, self.device = bench, bench.driver(**options)
        self.device.open()

    def tick(self, force_n=ZERO, count=1):
        clock = self.bench.clock
        for _ in range(count):
            reading = self.device.exchange(force_n, clock.now_s())
            clock.advance(0.001)
        return reading

    def move_to(self, counts):
        """Turn the encoders as fast as is still believed, then wait for the answer."""
        mechanics = self.bench.mechanics
        while mechanics.counts != tuple(counts):
            mechanics.counts = tuple(
                now + max(-150, min(150, goal - now))
                for now, goal in zip(mechanics.counts, counts, strict=True)
            )
            self.tick()
        return self.tick(count=4)

    @property
    def words(self):
        return self.bench.mechanics.commands[-1][1]


@pytest.fixture
def session(running):
    session = Session(running)
    yield session
    session.device.close()


def test_a_falcon_goes_from_unplugged_to_ready_and_back(bench):
    device = bench.driver()
    assert device.state is DriverState.DISCONNECTED
    device.open()
    assert device.state is DriverState.LOADED
    assert bench.board.stage is Stage.RUNNING
    bench.mechanics.homed = 3
    reading = [device.exchange(ZERO, bench.clock.now_s()) for _ in range(4)][-1]
    assert device.state is DriverState.HOMING
    assert (reading.is_homed, reading.position_m) == (False, ZERO)
    assert device.reply.homed == 3
    bench.mechanics.homed = 7
    reading = [device.exchange(ZERO, bench.clock.now_s()) for _ in range(4)][-1]
    assert device.state is DriverState.READY
    assert reading.is_homed
    device.close()
    assert device.state is DriverState.DISCONNECTED
    assert not bench.port.is_claimed
    device.open()  # the firmware is still there
    assert bench.chip.requests.count((9, 16, 0)) == 1
    device.close()


def test_positions_match_the_reference_rows_from_the_centre(session, golden):
    for row in golden["kinematics"]:
        x, y, z = session.move_to(row["counts"]).position_m
        assert (x, y, z + 0.120) == pytest.approx(row["p"], abs=1e-9)


def test_words_are_those_of_the_reference_rows(session, golden):
    for row in golden["kinematics"]:
        session.move_to(row["counts"])
        session.tick(PUSH)
        assert session.words == tuple(round(word) for word in row["dac"])


def test_buttons_are_read(session):
    session.bench.mechanics.buttons = 5
    assert session.tick(count=4).buttons == 5


def test_the_reply_to_one_frame_comes_with_the_next(session):
    session.tick(count=3)
    began_s = session.bench.clock.now_s()
    reading = session.tick()
    assert 0.0 <= began_s - reading.replied_s <= 0.003


@pytest.mark.parametrize("homed", range(7))
def test_no_force_before_all_three_encoders_are_homed(running, homed):
    running.mechanics.homed = homed
    session = Session(running)
    session.tick(PUSH, count=20)
    assert {words for _, words in running.mechanics.commands} == {(0, 0, 0)}
    session.device.close()


def test_lost_homing_takes_the_force_away_at_the_next_answer(session):
    session.tick(PUSH, count=5)
    assert session.words != (0, 0, 0)
    session.bench.mechanics.homed = 0
    reading = session.tick(PUSH, count=4)
    assert (session.words, reading.is_homed) == ((0, 0, 0), False)
    assert reading.position_m == ZERO
    assert session.device.state is DriverState.HOMING
    session.bench.mechanics.homed = 7
    session.bench.mechanics.counts = (900, -900, 100)  # a new zero
    session.tick(PUSH, count=4)
    assert session.device.state is DriverState.READY
    assert session.words != (0, 0, 0)


def frames_of(bench, monkeypatch):
    """Return a list that all frames from now on are added to."""
    frames, write = [], bench.chip.write

    def written(data, timeout_s):
        frames.append(bytes(data))
        return write(data, timeout_s)

    monkeypatch.setattr(bench.chip, "write", written)
    return frames


def test_lights_tell_people_the_state(running, monkeypatch):
    frames = frames_of(running, monkeypatch)
    running.mechanics.homed = 0
    session = Session(running)
    session.tick(count=4)
    assert frames[-1][13] - 0x41 == Lights.RED | Lights.HOMING
    running.mechanics.homed = 7
    session.tick(count=4)
    assert frames[-1][13] - 0x41 == Lights.GREEN | Lights.HOMING
    session.tick(PUSH)
    assert frames[-1][13] - 0x41 == Lights.BLUE | Lights.HOMING
    session.device.close()
    assert frames[-ZEROS_AT_THE_END:] == [b"<AAAAAAAAAAAAAA>"] * ZEROS_AT_THE_END


def test_the_homing_bit_can_be_cleared_as_the_vendor_does(running, monkeypatch):
    frames = frames_of(running, monkeypatch)
    session = Session(running, homing_bit_stays=False)
    session.tick(PUSH, count=4)
    assert frames[-1][13] - 0x41 == Lights.BLUE
    session.tick(ZERO)
    assert frames[-1][13] - 0x41 == Lights.GREEN
    running.mechanics.homed = 0
    session.tick(PUSH, count=4)
    assert frames[-1][13] - 0x41 == Lights.RED | Lights.HOMING
    session.device.close()


@pytest.mark.parametrize("is_on", [True, False])
def test_the_event_character_is_for_those_who_want_it(running, is_on):
    session = Session(running, event_character=is_on)
    assert ((6, 0x013E, 0) in running.chip.requests) == is_on
    session.device.close()
    assert running.chip.requests[-1] == (6, 0, 0)


def test_closing_leaves_zero_on_the_motors_also_under_force(session):
    session.tick(PUSH, count=5)
    assert session.words != (0, 0, 0)
    session.device.close()
    last = session.bench.mechanics.commands[-ZEROS_AT_THE_END:]
    assert [words for _, words in last] == [(0, 0, 0)] * ZEROS_AT_THE_END
    session.device.close()
    with pytest.raises(DeviceError, match="not open"):
        session.tick()


def test_the_end_of_the_program_closes_it(running, monkeypatch):
    registered = []
    monkeypatch.setattr("atexit.register", registered.append)
    session = Session(running)
    session.tick(PUSH, count=5)
    assert session.words != (0, 0, 0)
    (at_exit,) = registered
    at_exit()
    assert session.words == (0, 0, 0)


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_a_force_that_is_no_number_is_a_fault_and_zero(session, bad):
    session.tick(PUSH, count=5)
    with pytest.raises(DeviceError, match="not a number"):
        session.tick((0.0, bad, 0.0))
    assert session.words == (0, 0, 0)
    assert session.device.state is DriverState.FAULT
    with pytest.raises(DeviceError, match="not a number"):
        session.tick(PUSH)
    assert session.words == (0, 0, 0)
    session.device.close()
    session.device.open()
    session.tick(PUSH, count=5)
    assert session.words != (0, 0, 0)


def test_a_force_beyond_the_motors_keeps_its_direction(session):
    session.tick((60.0, 0.0, 0.0), count=5)
    assert max(map(abs, session.words)) == 4096
    jacobian = kinematics.pose(kinematics.angles((-300, -300, -300))).jacobian
    exact = kinematics.motor_words(jacobian, (60.0, 0.0, 0.0))
    assert session.words == tuple(round(word) for word in exact)


@pytest.mark.parametrize("force_n", [(12.0, 0.0, 0.0), (0.0, -3.0, 4.0)])
def test_the_packet_on_the_wire_gives_the_force_back(session, force_n):
    """Decoded here by hand: little endian nibbles, J^-T of the reference home."""
    session.move_to((0, 0, 0))
    session.tick(force_n)
    home = (
        (0.019304327883272625, -0.06507532861507441, 0.045771000731801785),
        (-0.06399715808710088, 0.015280540693652074, 0.04871661739344882),
        (0.02493839593345051, 0.024938395933450517, 0.02493839593345051),
    )
    expected = [
        -10_000.0 * sum(home[i][j] * force_n[i] for i in range(3)) for j in range(3)
    ]
    shrink = min(1.0, 4096 / max(map(abs, expected)))
    assert session.words == pytest.approx([shrink * w for w in expected], abs=0.5001)


def test_silence_is_no_error_but_the_answer_grows_old(session):
    before = session.tick(PUSH, count=5)
    session.bench.faults.silent = 1000
    after = session.tick(PUSH, count=40)
    assert after.position_m == before.position_m
    assert session.bench.clock.now_s() - after.replied_s > 0.035
    assert session.words != (0, 0, 0)  # the loop ramps; a jump to zero is not ours
    session.tick(PUSH, count=int(STALE_S * 1000))
    assert session.words == (0, 0, 0)
    session.bench.faults.silent = 0
    session.tick(PUSH, count=4)
    assert session.words != (0, 0, 0)


def test_falsified_answers_are_counted_and_change_nothing(session):
    session.tick(PUSH, count=5)
    session.bench.mechanics.counts = (-310, -300, -300)
    session.bench.faults.corrupt = 6
    readings = [session.tick(PUSH) for _ in range(12)]
    counts = [r.malformed for r in readings]
    worst = counts.index(6)
    assert counts[:worst] == sorted(counts[:worst])
    assert set(counts[worst:]) == {6, 0}
    assert len({r.position_m for r in readings[: worst + 1]}) == 1
    assert readings[-1].position_m != readings[0].position_m


def test_noise_before_a_reply_does_not_cost_the_reply(session):
    session.tick(count=4)
    session.bench.faults.noise = b"\x00\xff<AA"
    session.bench.mechanics.counts = (-290, -300, -300)
    reading = session.tick(count=4)
    assert reading.malformed == 0
    assert reading.position_m[0] != 0.0


@pytest.mark.parametrize("most_payload", [1, 5, 15])
def test_short_packets_are_put_together(running, most_payload):
    running.chip.most_payload = most_payload
    session = Session(running)
    reading = session.tick(PUSH, count=20)
    assert (reading.is_homed, reading.malformed) == (True, 0)
    session.device.close()


def test_a_glitch_of_an_encoder_is_dropped(session):
    good = session.tick(PUSH, count=5)
    session.bench.mechanics.counts = (-300, 700, -300)
    glitch = session.tick(PUSH, count=3)
    assert glitch.position_m == good.position_m
    assert glitch.malformed > 0
    session.bench.mechanics.counts = (-300, -300, -300)
    after = session.tick(PUSH, count=3)
    assert (after.position_m, after.malformed) == (good.position_m, 0)


def test_an_encoder_that_stays_away_is_a_fault_and_zero(session):
    session.tick(PUSH, count=5)
    session.bench.mechanics.counts = (-300, 700, -300)
    with pytest.raises(DeviceError, match="home it again"):
        session.tick(PUSH, count=20)
    assert session.words == (0, 0, 0)
    assert session.device.state is DriverState.FAULT


def test_a_quick_hand_is_no_glitch(session):
    """2 m/s, twice the speed at which the loop trips."""
    session.tick(count=4)
    counts = -300
    for _ in range(20):
        counts += 44
        session.bench.mechanics.counts = (counts, counts, counts)
        reading = session.tick()
        assert reading.malformed == 0
    assert reading.position_m[2] > 0.02


def test_unplugging_is_an_error_and_closing_then_is_none(session):
    session.tick(PUSH, count=5)
    session.bench.chip.unplug()
    with pytest.raises(DeviceError, match="unplugged"):
        session.tick(PUSH)
    assert session.device.state is DriverState.DISCONNECTED
    session.device.close()


def test_a_failed_opening_leaves_nothing_open(bench):
    bench.faults.hello = b""
    device = bench.driver()
    with pytest.raises(DeviceError):
        device.open()
    assert device.state is DriverState.DISCONNECTED
    assert not bench.port.is_claimed
    with pytest.raises(DeviceError, match="not open"):
        device.exchange(ZERO, 0.0)


def test_capabilities_are_what_the_motors_can_do_everywhere(rng):
    """The continuous force is possible in every direction of the workspace."""
    for _ in range(300):
        place = rng.normal(size=3)
        place *= FALCON.workspace_radius_m * rng.uniform() / math.hypot(*place)
        jacobian = kinematics.jacobian((place[0], place[1], place[2] + 0.12))
        force = rng.normal(size=3)
        force *= FALCON.continuous_force_n / math.hypot(*force)
        torques = matrix3.transposed_times(jacobian, tuple(force))
        assert max(map(abs, torques)) * 10_000 <= 4096


def test_a_force_moves_a_simulated_hand_its_way(running):
    """Driver, pyusb, chip, board, physics, and back: the hand yields by F / k."""
    simulation = Simulation(mechanism=Mechanism(coulomb_nm=0.0))
    running.board.mechanics = SimulatedMechanics(simulation)
    device = FalconDriver(
        running.open,
        clock=running.clock,
        image=lambda: running.image,
        make_link=DirectLink,
    )
    device.open()
    for _ in range(1500):
        reading = device.exchange((2.0, -1.0, 1.5), running.clock.now_s())
        running.clock.advance(0.0005)
    assert simulation.applied_n == pytest.approx((2.0, -1.0, 1.5), abs=0.01)
    expected = (2.0 / 150.0, -1.0 / 150.0, 1.5 / 150.0)
    assert reading.position_m == pytest.approx(expected, abs=2e-4)
    assert reading.position_m == pytest.approx(simulation.position_m, abs=1e-4)
    device.close()
    assert simulation.commanded_n == ZERO
