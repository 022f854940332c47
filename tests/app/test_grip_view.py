"""The grip in space: what is shown, how it is painted, and when."""

import math
from dataclasses import replace

import hearing
import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, QSizeF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel

from app.player.display import grip_of
from app.plots import grip_painter
from app.plots.grip_moving import CENTRING, colours
from app.plots.grip_painter import GripPainter, excursion_text, force_text, headline
from app.plots.grip_scene import (
    Activity,
    Camera,
    Grip,
    Projection,
    trail_of,
)
from app.plots.grip_view import GripView
from app.plots.panel import PlotPanel
from app.widgets import theme
from hapticplayer.devices import DEVICES
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.processes import Health
from hapticplayer.haptics.shared import TICK
from hapticplayer.model.device import DeviceCapabilities
from hapticplayer.playback.meters import TickHistory
from hapticplayer.playback.snapshot import OutputSnapshot, Snapshot

RADIUS_M, SIDE_PX = 0.040, 320.0
FRONT = Camera(0.0, 0.0)
ACTIVE = Grip(
    "Simulated grip", "Force is active", Activity.ACTIVE, position_m=(0.01, 0.005, 0.0)
)


def projection(camera: Camera = FRONT, **more) -> Projection:
    return Projection(camera, RADIUS_M, SIDE_PX, more.get("height_px", SIDE_PX))


def ticks(count: int, **fields) -> np.ndarray:
    made = np.zeros(count, TICK)
    made["monotonic_s"] = 100.0 + 0.001 * np.arange(count)
    made["mode"] = Mode.FOLLOWING
    for name, value in fields.items():
        made[name] = value
    return made


def test_the_trail_is_the_last_half_second_every_20_ms():
    made = ticks(2000)
    made["position_m"][:, 0] = 1e-5 * np.arange(2000)  # 10 mm each second
    trail = np.array(trail_of(made))
    assert 25 <= len(trail) <= 27
    assert trail[0, 0] == pytest.approx(0.015, abs=1e-4)
    assert np.allclose(np.diff(trail[1:, 0]), 0.0002, atol=6e-5)


def test_a_grip_at_rest_leaves_no_trail():
    assert trail_of(ticks(2000, position_m=(0.01, 0.0, 0.0))) == ()
    assert trail_of(ticks(0)) == ()


# --- from ticks to a grip -----------------------------------------------------


def grip(
    records=None, feedback="realistic", device="simulated", health=Health.READY
) -> Grip:
    history, last = TickHistory(), {}
    if records is not None:
        history.add(records, 0)
        tick = history.latest()
        last = {"tick": tick, "mode": Mode(tick["mode"]), "cause": Cause(tick["cause"])}
    now = Snapshot(feedback=feedback, outputs=(OutputSnapshot(device, health, **last),))
    return grip_of(now, history.since)


def test_a_tick_becomes_what_is_shown():
    last = {
        "position_m": (0.012, -0.004, 0.003),
        "force_n": (1.0, 2.0, 2.0),
        "planned_n": (1.5, 2.0, 2.0),
        "centring_n": (-0.5, 0.0, 0.0),
    }
    made = grip(ticks(50, **last))
    for name, value in last.items():
        assert getattr(made, name) == pytest.approx(value, abs=1e-6), name
    assert made.activity is Activity.ACTIVE
    assert made.radius_m == RADIUS_M
    assert force_text(made) == "3.0 N"
    assert excursion_text(made) == "13 mm of 40"


@pytest.mark.parametrize(
    ("state", "activity"),
    [
        ((Mode.IDLE, Cause.PAUSED, "realistic"), Activity.OFF),
        ((Mode.FOLLOWING, Cause.NONE, "none"), Activity.OFF),
        ((Mode.ENTERING, Cause.NONE, "realistic"), Activity.CHANGING),
        ((Mode.RAMPING, Cause.SEEK, "realistic"), Activity.CHANGING),
        ((Mode.TRIPPED, Cause.STOPPED, "none"), Activity.STOPPED),
    ],
)
def test_every_mode_has_its_words_and_its_colour(state, activity):
    mode, cause, feedback = state
    made = grip(ticks(50, mode=mode, cause=cause), feedback)
    assert made.activity is activity
    wanted = {
        Activity.OFF: "off",
        Activity.CHANGING: "fading",
        Activity.STOPPED: "STOP",
    }
    assert wanted[activity] in made.state


@pytest.mark.parametrize(
    ("made", "said"),
    [
        (grip(device="none", health=Health.NONE), "No device"),
        (grip(health=Health.STARTING), "Starting"),
        (grip(ticks(9), health=Health.FAILED), "failed"),
        (grip(ticks(9), health=Health.GONE), "ended"),
        (grip(ticks(9, position_m=math.nan)), "unknown"),
    ],
)
def test_without_a_position_it_says_why_and_shows_no_grip(made, said):
    assert made.position_m is None
    assert said in made.state


def test_only_a_simulated_grip_is_called_simulated(monkeypatch):
    assert grip(ticks(9)).title == "Simulated grip"
    large = DeviceCapabilities(3, 20.0, 8.0, 0.080, 1000.0, 0.001)
    entry = replace(DEVICES["simulated"], name="other", capabilities=large)
    monkeypatch.setitem(DEVICES, "other", entry)
    made = grip(ticks(9), device="other")
    assert made.title == "Grip"
    assert (made.radius_m, made.full_force_n) == (0.080, 8.0)


# --- painting -----------------------------------------------------------------


def painted(grip: Grip, camera: Camera = FRONT, ratio: float = 1.0) -> np.ndarray:
    """Return (height, width, 3) of the picture of a grip."""
    side = round(SIDE_PX * ratio)
    image = QImage(side, side, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    painter = QPainter(image)
    GripPainter().paint(painter, QSizeF(SIDE_PX, SIDE_PX), camera, grip)
    painter.end()
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(side, -1, 4)
    return rows[:, :side, 2::-1].astype(int)


def count_of(picture: np.ndarray, name: str, within: int = 12) -> int:
    """Count the pixels that have nearly this colour."""
    wanted = QColor(name).getRgb()[:3]
    return int(np.all(np.abs(picture - wanted) <= within, axis=2).sum())


def middle_of(picture: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Return x and y of the middle of what differs."""
    rows, columns = np.nonzero(np.any(picture != other, axis=2))
    return np.array([columns.mean(), rows.mean()])


@pytest.fixture(autouse=True)
def _fonts(application):
    """Words need the application."""


@pytest.mark.parametrize(
    ("force_n", "across", "down"),
    [((3, 0, 0), 1, 0), ((-3, 0, 0), -1, 0), ((0, 3, 0), 0, -1), ((0, -3, 0), 0, 1)],
)
def test_the_arrow_is_painted_to_the_side_it_pushes(force_n, across, down):
    grip = replace(ACTIVE, position_m=(0.0, 0.0, 0.0))
    with_arrow = painted(replace(grip, force_n=force_n))
    side = middle_of(with_arrow, painted(grip)) - projection().middle_px
    assert side @ (across, down) > 15.0
    assert abs(side @ (down, across)) < 5.0


@pytest.mark.parametrize("force_n", [(0, 0, 3.0), (0, 0, -3.0)])
def test_an_arrow_along_the_line_of_sight_has_its_figure(force_n):
    grip = replace(ACTIVE, position_m=(0.0, 0.0, 0.0))
    with_arrow = painted(replace(grip, force_n=force_n))
    assert np.any(with_arrow != painted(grip), axis=2).sum() > 100


def test_the_arrow_has_the_colour_of_the_state():
    pushed = replace(ACTIVE, force_n=(3.0, 2.0, 0.0))
    active = painted(pushed)
    fading = painted(replace(pushed, activity=Activity.CHANGING))
    assert count_of(active, theme.GOOD) > 40
    assert count_of(active, theme.WARN) == 0
    assert count_of(fading, theme.WARN) > 40
    assert count_of(fading, theme.GOOD) == 0


def test_a_stopped_grip_is_red_and_shows_what_is_only_planned():
    stopped = replace(ACTIVE, activity=Activity.STOPPED)
    picture = painted(stopped)
    assert count_of(picture, theme.BAD, 40) > 60
    assert count_of(painted(ACTIVE), theme.BAD, 40) == 0
    planned = painted(replace(stopped, planned_n=(-3.0, 0.0, 0.0)))
    assert middle_of(planned, picture)[0] < projection().px(ACTIVE.position_m)[0]


def test_centring_has_a_colour_and_shows_only_when_active():
    assert count_of(painted(ACTIVE), CENTRING) == 0
    assert count_of(painted(replace(ACTIVE, centring_n=(-2.0, 0, 0))), CENTRING) > 40


@pytest.mark.parametrize(
    ("out_m", "colour"), [(0.030, None), (0.034, theme.WARN), (0.038, theme.BAD)]
)
def test_the_edge_is_marked_when_the_grip_comes_near(out_m, colour):
    grip = replace(ACTIVE, position_m=(out_m, 0.0, 0.0))
    text, picture = excursion_text(grip), painted(grip)
    view = projection()
    x_px, y_px = view.middle_px
    # in the zone, on the far side from the grip
    sample = picture[round(y_px) + 9, round(x_px - 0.95 * view.sphere_px)]
    plain = painted(ACTIVE)[round(y_px) + 9, round(x_px - 0.95 * view.sphere_px)]
    if colour is None:
        assert np.array_equal(sample, plain)
        assert text[0].isdigit()
    else:
        assert sample[0] - plain[0] > 20  # both warnings are red rather than blue
        assert not text[0].isdigit()  # and a sign for those who do not see that


def test_a_nearer_grip_is_painted_larger():
    row = round(projection().middle_px[1])
    elsewhere = painted(replace(ACTIVE, position_m=(-0.036, 0, 0)))[row, 120:200]

    def width_px(z_m: float) -> float:
        strip = painted(replace(ACTIVE, position_m=(0, 0, z_m)))[row, 120:200]
        return np.ptp(np.nonzero(np.any(strip != elsewhere, axis=1))[0])

    wanted = (5 * RADIUS_M + 0.03) / (5 * RADIUS_M - 0.03)
    assert width_px(0.03) / width_px(-0.03) == pytest.approx(wanted, rel=0.08)


def test_a_trail_is_painted_and_fades():
    trail = tuple((0.001 * k - 0.03, 0.0, 0.02) for k in range(26))
    picture = painted(replace(ACTIVE, position_m=(0.02, 0.02, 0), trail_m=trail))
    bare = painted(replace(ACTIVE, position_m=(0.02, 0.02, 0)))
    change = np.abs(picture - bare).sum(axis=(0, 2))
    ends = [round(projection().px(trail[k])[0]) for k in (2, 22)]
    old, new = (change[x - 4 : x + 4].sum() for x in ends)
    assert new > 3 * max(old, 1)


def test_twice_the_resolution_shows_the_same_but_sharper():
    small, large = painted(ACTIVE), painted(ACTIVE, ratio=2.0)
    halved = large.reshape(320, 2, 320, 2, 3).mean(axis=(1, 3))
    assert large.shape == (640, 640, 3)
    assert np.abs(halved - small).mean() < 2.0


def luminance(name: str) -> float:
    """Return the relative luminance of WCAG 2."""
    shares = np.array(QColor(name).getRgbF()[:3])
    linear = np.where(
        shares <= 0.04045, shares / 12.92, ((shares + 0.055) / 1.055) ** 2.4
    )
    return float(linear @ (0.2126, 0.7152, 0.0722))


@pytest.mark.parametrize("name", [*colours().values(), CENTRING, theme.TEXT])
def test_every_colour_of_arrows_and_words_stands_out(name):
    contrast = (luminance(name) + 0.05) / (luminance(theme.PANEL) + 0.05)
    assert contrast > 4.5


def test_axis_labels_keep_off_the_rim_where_there_is_room(monkeypatch):
    written = []
    monkeypatch.setattr(
        QPainter, "drawText", lambda _p, box, _flags, text: written.append((text, box))
    )
    view = projection(Camera(), height_px=180.0)
    image = QImage(round(SIDE_PX), 180, QImage.Format.Format_RGB32)
    with QPainter(image) as painter:
        grip_painter.paint_axes(painter, view)
    boxes = dict(written)
    assert set(boxes) == {"right", "up", "towards you"}
    for text in ("right", "towards you"):
        middle_left = (boxes[text].left(), boxes[text].center().y())
        assert math.dist(middle_left, view.middle_px) > view.sphere_px + 2.0
        assert boxes[text].right() <= SIDE_PX


# --- the widget ---------------------------------------------------------------


class CountingView(GripView):
    """Counts how often it is painted."""

    def __init__(self) -> None:
        super().__init__()
        self.paintings = 0

    def paintEvent(self, event) -> None:
        self.paintings += 1
        super().paintEvent(event)


@pytest.fixture
def view(application, qtbot) -> CountingView:
    made = CountingView()
    qtbot.addWidget(made)
    made.resize(320, 320)
    made.show()
    qtbot.waitExposed(made)
    QTest.qWait(1)
    made.paintings = 0
    return made


def settle(view: GripView) -> None:
    """Let what is to be painted be painted."""
    QTest.qWait(1)


def test_an_unchanged_grip_is_not_painted_again(view):
    view.show_grip(ACTIVE)
    settle(view)
    assert view.paintings == 1
    view.show_grip(replace(ACTIVE))
    settle(view)
    assert view.paintings == 1


def test_ticks_of_a_grip_at_rest_make_equal_values():
    trembling = ticks(600, position_m=(0.01, 0, 0), force_n=(1.0, 0, 0))
    trembling["position_m"] += 1e-6 * np.sin(np.arange(600.0))[:, None]
    assert grip(trembling[:400]) == grip(trembling)


def test_a_hidden_view_is_not_painted(view):
    view.hide()
    view.show_grip(ACTIVE)
    view.look(Camera(1.0, 0.5))
    settle(view)
    assert view.paintings == 0


def test_a_drag_goes_round_and_a_double_click_comes_back(view):
    middle = QPoint(160, 160)
    QTest.mousePress(view, Qt.MouseButton.LeftButton, pos=middle)
    QTest.mouseMove(view, middle + QPoint(40, 20))
    QTest.mouseRelease(view, Qt.MouseButton.LeftButton, pos=middle + QPoint(40, 20))
    turned = view.camera
    assert turned.yaw_rad < Camera().yaw_rad  # the scene follows the pointer
    assert turned.pitch_rad > Camera().pitch_rad
    QTest.mouseMove(view, middle)
    assert view.camera == turned
    QTest.mouseDClick(view, Qt.MouseButton.LeftButton, pos=middle)
    assert view.camera == Camera()


@pytest.mark.parametrize(("notch", "is_nearer"), [(120, True), (-120, False)])
def test_the_wheel_comes_nearer_and_goes_away(view, notch, is_nearer):
    event = QWheelEvent(
        QPointF(160, 160),
        view.mapToGlobal(QPointF(160, 160)),
        QPoint(),
        QPoint(0, notch),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    view.wheelEvent(event)
    assert (view.camera.zoom > 1.0) is is_nearer
    assert event.isAccepted()


def test_the_keys_turn_zoom_and_come_back(view):
    for key in (Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Plus):
        QTest.keyClick(view, key)
    start = Camera()
    assert view.camera.yaw_rad > start.yaw_rad
    assert view.camera.pitch_rad > start.pitch_rad
    assert view.camera.zoom > start.zoom
    QTest.keyClick(view, Qt.Key.Key_0)
    assert view.camera == start


def test_a_screen_reader_hears_the_state_and_the_figures(view):
    view.show_grip(replace(ACTIVE, force_n=(2.0, 0, 0)))
    assert view.accessibleName() == "Simulated grip"
    for said in ("Force is active", "2.0 N", "11 mm of 40", "arrow keys"):
        assert said in hearing.description(view)
    view.show_grip(Grip("Grip", "No device"))
    assert view.accessibleName() == "Grip"
    assert hearing.description(view).startswith("No device")


def test_a_long_state_is_wrapped_and_shown_whole(qtbot):
    panel = PlotPanel()
    qtbot.addWidget(panel)
    panel.resize(900, 300)
    panel.show()
    qtbot.waitExposed(panel)
    long = "Ein Zustand mit einer sehr langen Übersetzung & <Zeichen> " * 3
    panel.show_grip(replace(ACTIVE, state=long))
    settle(panel.grip)
    title = headline(panel.grip.grip)
    (label,) = (one for one in panel.findChildren(QLabel) if one.text() == title)
    assert "&lt;Zeichen&gt;" in headline(panel.grip.grip)
    assert label.height() >= label.heightForWidth(label.width())
    assert panel.width() == 900


# --- in the window ------------------------------------------------------------


def test_the_window_shows_it_beside_the_plots_until_hidden(window, wait_for):
    window.plots.prepare()
    view = window.plots.panel.grip
    wait_for(lambda: view.grip.state.startswith("No device: choose"))
    assert view.isVisible()
    window.commands.grip.trigger()
    assert not view.isVisible()
    window.commands.plots.trigger()
    assert not window.commands.grip.isEnabled()
    window.commands.plots.trigger()
    assert not view.isVisible()
    window.commands.grip.trigger()
    assert view.isVisible()


def test_the_arrow_keys_turn_it_only_while_it_has_the_keyboard(playing):
    playing.plots.prepare()
    view, window = playing.plots.panel.grip, playing.windowHandle()
    playing.player.pause()
    view.setFocus(Qt.FocusReason.TabFocusReason)
    media_s, camera = playing.player.snapshot().media_s, view.camera
    QTest.keyClick(window, Qt.Key.Key_Right)
    assert view.camera != camera
    assert playing.player.snapshot().media_s == media_s
    camera = view.camera
    playing.stage.setFocus()
    QTest.keyClick(window, Qt.Key.Key_Right)
    assert view.camera == camera
    assert playing.player.snapshot().media_s > media_s
