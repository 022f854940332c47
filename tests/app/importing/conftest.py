"""A simulated ride, and the wizard that imports it."""

import functools
import threading

import numpy as np
import pytest
from scipy.signal import resample_poly

from app.experimenter import import_wizard
from app.experimenter.import_wizard import ImportWizard
from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.media.encode import write_clip
from hapticplayer.media.telemetry import TelemetryPacket, add_telemetry
from hapticplayer.model import ImuLog
from hapticplayer.sequence import import_preview
from hapticplayer.sequence.import_preview import preview_import

SECONDS = 20


@pytest.fixture(scope="session")
def ride(tmp_path_factory):
    """A clip with pats, its log, a stranger's log, a GoPro's file, and the truth."""
    from hapticplayer.extras.rides.gpmf_writer import write_payloads
    from tests.material.sync_clips import simulate_pats

    folder = tmp_path_factory.mktemp("pats")
    made = simulate_pats(41_001, hard=False, rate_hz=200, duration_s=SECONDS)
    other = simulate_pats(41_002, hard=False, rate_hz=200, duration_s=SECONDS)
    grey = (np.full((36, 64, 3), k % 250, np.uint8) for k in range(30 * SECONDS))
    sound = resample_poly(made.audio, 3, 1).astype(np.float32)[:, None]
    write_clip(folder / "ride.mp4", grey, frame_rate_hz=30, audio=sound)
    write_imu_csv(folder / "log.csv", made.imu)
    write_imu_csv(folder / "other.csv", other.imu)
    media_s = made.clock_map.rate * made.imu.time_s + made.clock_map.offset_s
    inside = (media_s >= 0.0) & (media_s < SECONDS)
    own = ImuLog(
        media_s[inside] - media_s[inside][0],
        made.imu.specific_force_mps2[inside],
        made.imu.angular_rate_radps[inside],
    )
    packets = [TelemetryPacket(t, 1.0, p) for t, p in write_payloads(own)]
    add_telemetry(folder / "ride.mp4", folder / "gopro.mp4", packets)
    return folder, made


@pytest.fixture(scope="session")
def reading_once():
    """Return `preview_import` with a memory: most tests begin with the same files."""
    known = {}

    @functools.wraps(preview_import)
    def read(*arguments, progress):
        if (key := repr(arguments)) not in known:
            known[key] = preview_import(*arguments, progress=progress)
        return known[key]

    return read


@pytest.fixture
def wizard(application, qtbot, tmp_path, monkeypatch, reading_once):
    for module in (import_preview, import_wizard):  # for a process, it is found by name
        monkeypatch.setattr(module, "preview_import", reading_once)
    made = ImportWizard(str(tmp_path), tmp_path / "library")
    qtbot.addWidget(made)
    made.show()
    before = set(threading.enumerate())
    yield made
    made.close_jobs()
    assert not [t for t in threading.enumerate() if t not in before and t.is_alive()]


def true_offset_s(made) -> float:
    log_s = (made.pats_s[1] - made.clock_map.offset_s) / made.clock_map.rate
    return float(made.pats_s[1] - log_s)
