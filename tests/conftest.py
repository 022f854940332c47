"""Fixtures that all tests share: seeded data with closed-form truth, real files."""

import gc
import os
import resource
import signal
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, settings

from hapticplayer.capture.recording import Recording
from hapticplayer.clock import ManualClock
from hapticplayer.haptics.messages import signal_alarm
from hapticplayer.media.clip_info import probe
from hapticplayer.media.encode import write_clip
from hapticplayer.model import STANDARD_GRAVITY_MPS2, ClockMap, ImuLog
from hapticplayer.model import quaternions as quat
from hapticplayer.playback.player import ClipPlayback, Player
from hapticplayer.sequence.build import Choices, write_sequence
from tests import needed_extras
from tests.realtime import RealTime

needed_extras.install()
pytest_plugins = ("pytester",)

TWO_SCREENS = Path(__file__).parent / "data" / "two_screens.json"
os.environ["QT_QPA_PLATFORM"] = os.environ.get(
    "HAPTICPLAYER_TEST_PLATFORM", f"offscreen:configfile={TWO_SCREENS}"
)
# a run in the background ignores signals, and so would every program that a test starts
signal.signal(signal.SIGINT, signal.default_int_handler)
for _number in (signal.SIGQUIT, signal.SIGHUP):
    signal.signal(_number, signal.SIG_DFL)

# how long an example takes is the machine's affair
settings.register_profile(
    "suite", deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("suite")

SHARED_DATA = Path(__file__).resolve().parents[2] / "shared" / "data"


def pytest_configure(config) -> None:
    config.pluginmanager.register(RealTime())


@pytest.hookimpl(wrapper=True)
def pytest_collection(session):
    """Let no collection of garbage walk through all tests and modules again."""
    gc.disable()
    found = yield
    gc.collect()
    gc.freeze()
    gc.enable()
    return found


def pytest_terminal_summary(terminalreporter) -> None:
    """Append what was skipped, and why, to what ./test shows at its end."""
    if "SKIPPED_LOG" in os.environ:
        reports = terminalreporter.stats.get("skipped", ())
        reasons = Counter(report.longrepr[2] for report in reports)
        with Path(os.environ["SKIPPED_LOG"]).open("a", encoding="utf-8") as log:
            log.writelines(
                f"   {count} x {reason.removeprefix('Skipped: ')}\n"
                for reason, count in reasons.items()
            )


def pytest_unconfigure() -> None:
    """Close the sockets of the alarm, which a program keeps until it ends."""
    if signal_alarm.cache_info().currsize:
        alarm = signal_alarm()
        alarm.write_end.close()
        alarm.read_end.close()


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """The folder of real recordings, beside the repository."""
    if not SHARED_DATA.is_dir():
        pytest.skip("the real recordings (../shared/data) are not on this machine")
    return SHARED_DATA


@pytest.fixture(scope="session")
def case(shared_data: Path) -> Callable[[str], Path]:
    """A small file whose right value is known, by its folder and name."""

    def path_of(name: str) -> Path:
        path = shared_data / "cases" / name
        if not path.exists():
            pytest.skip(f"needs ../shared/data/cases/{name}")
        return path

    return path_of


def clip_of(player: Player) -> ClipPlayback:
    """Return what a player keeps to itself: the one place that looks inside."""
    return player._clip


@pytest.fixture
def fill_disk() -> Iterator[Callable[[], None]]:
    """Return what lets no file grow beyond 512 bytes any more."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    yield lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (512, before[1]))
    resource.setrlimit(resource.RLIMIT_FSIZE, before)


@pytest.fixture
def manual_clock() -> ManualClock:
    return ManualClock()


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(20120613)


@pytest.fixture
def still_log(rng) -> ImuLog:
    """Ten seconds at rest, tilted, with a gain error of 3 % and white noise."""
    count = 2000
    up = np.array([0.2, -0.3, 0.9])
    up /= np.linalg.norm(up)
    force = 1.03 * STANDARD_GRAVITY_MPS2 * up + 0.02 * rng.standard_normal((count, 3))
    return ImuLog(
        time_s=np.arange(count) / 200.0,
        specific_force_mps2=force,
        angular_rate_radps=0.001 * rng.standard_normal((count, 3)),
        source="still",
    )


@pytest.fixture
def swing() -> tuple[ImuLog, np.ndarray]:
    """A swinging, shaken sensor with exact truth: (log, gravity-free acceleration).

    Orientation: roll 0.5 sin(1.3 t) about x, then yaw 0.7 t about z. Acceleration in
    the earth frame: zero-mean sines, so that no velocity builds up.
    """
    t = np.arange(0, 40, 1 / 200)
    roll, yaw = 0.5 * np.sin(1.3 * t), 0.7 * t
    q = quat.multiply(
        quat.from_rotation_vector(np.outer(yaw, [0, 0, 1.0])),
        quat.from_rotation_vector(np.outer(roll, [1.0, 0, 0])),
    )
    roll_rate = 0.65 * np.cos(1.3 * t)
    rate = np.stack([roll_rate, 0.7 * np.sin(roll), 0.7 * np.cos(roll)], axis=1)
    earth = np.stack(
        [1.5 * np.sin(5 * t), 2.0 * np.cos(7 * t), 1.0 * np.sin(11 * t)], axis=1
    )
    to_sensor = quat.conjugate(q)
    acceleration = quat.rotate(to_sensor, earth)
    gravity = quat.rotate(to_sensor, np.array([0, 0, STANDARD_GRAVITY_MPS2]))
    return ImuLog(t, acceleration + gravity, rate, source="swing"), acceleration


@pytest.fixture(scope="session")
def tiny_clip(tmp_path_factory):
    path = tmp_path_factory.mktemp("clip") / "ride.mp4"
    grey = (np.full((36, 64, 3), 40 + 2 * k, dtype=np.uint8) for k in range(60))
    write_clip(path, grey, frame_rate_hz=30)
    return probe(path)


@pytest.fixture
def recording(still_log):
    return Recording(still_log, ClockMap(offset_s=0.5), "test camera", ("a note",), {})


@pytest.fixture
def sequence_folder(tmp_path, tiny_clip, recording):
    return write_sequence(
        tiny_clip, recording, tmp_path / "ride", choices=Choices(title="Ride", seed=5)
    )
