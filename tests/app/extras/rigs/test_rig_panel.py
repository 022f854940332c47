"""The simulated rig in the window: it follows packets, and tells what is out of reach."""

import socket

import pytest

from app.extras.rigs.panel import RigPanel
from app.plots.rig_platform import PlatformPose
from hapticplayer.clock import SystemClock
from hapticplayer.extras.rigs.packets import outsim
from hapticplayer.extras.rigs.settings import RigSettings
from hapticplayer.model.rig import RigMotion


@pytest.fixture
def panel(qtbot):
    made = RigPanel(SystemClock(), None, (0,))
    qtbot.addWidget(made)
    yield made
    made.done(0)


def send(panel, **values):
    (port,) = panel.receiver.rigs
    motion = RigMotion(*[0.0] * len(RigMotion._fields))._replace(**values)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as end:
        end.sendto(outsim(motion, 1.0, RigSettings()), ("127.0.0.1", port))


def test_a_packet_moves_the_platform(panel, wait_for):
    assert panel.state.text() == "No data received yet"
    send(panel, pitch_rad=0.1)
    wait_for(lambda: panel.view.pose.pitch_rad == pytest.approx(0.1))
    assert not panel.view.is_clamped
    assert panel.state.text() == "outsim: followed"


def test_the_rig_is_added_to_what_plays(window):
    window.commands.rig.trigger()
    panel = window.findChild(RigPanel)
    for _ in range(2):
        panel.play.click()
        assert window.player.output_names.count("rig:outsim") == 1
    panel.done(0)


def test_a_pose_out_of_reach_is_held_back_and_reported(panel, wait_for):
    send(panel, up_mps2=30.0)
    wait_for(lambda: panel.view.is_clamped)
    assert 0.05 < panel.view.pose.up_m < 0.3
    assert "out of reach" in panel.state.text()


def test_a_port_that_is_taken_is_told(panel, qtbot):
    other = RigPanel(SystemClock(), None, tuple(panel.receiver.rigs))
    qtbot.addWidget(other)
    assert other.state.text() == "Not listening"
    assert "cannot be opened" in other.hint.text()
    assert other.view.pose == PlatformPose()
    other.done(0)
