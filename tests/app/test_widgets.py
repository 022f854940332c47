import pytest
from PySide6.QtCore import QPoint, Qt

from app.bridge.jobs import JobState
from app.widgets import theme
from app.widgets.buttons import text_button
from app.widgets.layout import ElidedLabel
from app.widgets.messages import JobBar, MessageBar
from app.widgets.seek_slider import SeekSlider
from app.widgets.texts import position_text, time_text
from app.widgets.theme import FOLDER, icon


@pytest.fixture
def slider(qtbot) -> SeekSlider:
    made = SeekSlider()
    qtbot.addWidget(made)
    made.resize(400, 26)
    made.set_duration(60.0)
    made.show()
    qtbot.waitExposed(made)
    return made


def test_a_drag_scrubs_and_the_clip_does_not_pull_at_the_handle(slider, qtbot):
    sought = []
    slider.sought.connect(sought.append)
    qtbot.mousePress(slider, Qt.MouseButton.LeftButton, pos=QPoint(100, 13))
    qtbot.mouseMove(slider, QPoint(200, 13))
    slider.follow(1.0)
    assert slider.value() == pytest.approx(30_000, abs=200)
    qtbot.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=QPoint(200, 13))
    assert sought[-1] == pytest.approx(30.0, abs=0.2)
    slider.follow(1.0)
    assert slider.value() == 1000


def test_following_the_clip_seeks_nothing(slider, qtbot):
    with qtbot.assertNotEmitted(slider.sought):
        slider.follow(20.0)


def test_the_keys_step(slider, qtbot):
    slider.follow(20.0)
    with qtbot.waitSignal(slider.sought) as signal:
        qtbot.keyClick(slider, Qt.Key.Key_PageUp)
    assert signal.args == [30.0]


def test_a_reader_hears_the_position_and_not_every_second(slider, qtbot):
    slider.clearFocus()
    slider.follow(12.3)
    assert slider.accessibleDescription() == "00:12.3 / 01:00.0"
    slider.setFocus()
    slider.follow(20.0)
    assert slider.accessibleDescription() == "00:12.3 / 01:00.0"
    qtbot.keyClick(slider, Qt.Key.Key_PageUp)
    assert slider.accessibleDescription() == "00:30.0 / 01:00.0"


def test_a_slider_without_a_clip_does_nothing(slider, qtbot):
    slider.set_duration(0.0)
    with qtbot.assertNotEmitted(slider.sought):
        qtbot.mouseClick(slider, Qt.MouseButton.LeftButton, pos=QPoint(200, 13))


@pytest.mark.parametrize(
    ("media_s", "text"),
    [(0.0, "00:00.0"), (9.99, "00:09.9"), (65.35, "01:05.3"), (3599.95, "59:59.9")],
)
def test_times_are_rounded_down(media_s, text):
    assert time_text(media_s) == text


def test_a_long_clip_has_hours_on_both_sides():
    assert position_text(65.0, 7325.0) == "0:01:05.0 / 2:02:05.0"


def test_a_position_is_never_beyond_the_end():
    assert position_text(12.5, 12.0) == "00:12.0 / 00:12.0"


def test_a_long_label_asks_for_no_room(qtbot):
    label = ElidedLabel("x" * 500)
    qtbot.addWidget(label)
    assert label.minimumSizeHint().width() == 0
    assert label.sizeHint().width() > 1000


def test_a_message_breaks_a_long_path_into_lines(qtbot):
    bar = MessageBar()
    qtbot.addWidget(bar)
    text = "/a/very/long/path" * 30 + ": is broken"
    bar.show_text(text)
    assert bar.text() == text
    assert bar.minimumSizeHint().width() < 400
    bar.close_button.click()
    assert bar.text() == ""


def test_a_job_that_is_done_at_once_shows_no_bar(qtbot):
    bar = JobBar()
    qtbot.addWidget(bar)
    bar.show_state(JobState("Opening", 0.0, ""), 10.0)
    assert bar.isHidden()
    bar.show_state(None, 10.1)
    assert bar.isHidden()


def test_a_long_job_shows_its_step_and_can_be_cancelled(qtbot):
    bar = JobBar()
    qtbot.addWidget(bar)
    bar.show_state(JobState("Import", 0.0, ""), 10.0)
    bar.show_state(JobState("Import", 0.5, "copying the clip"), 11.0)
    assert not bar.isHidden()
    assert bar.text_label.text() == "Import: copying the clip"
    with qtbot.waitSignal(bar.cancelled):
        bar.cancel_button.click()
    assert not bar.cancel_button.isEnabled()
    bar.show_state(None, 12.0)
    assert bar.isHidden()
    assert bar.cancel_button.isEnabled()


def test_a_long_job_moves_nothing(window, wait_for):
    before, bar, is_enough = window.stage.geometry(), window.job_bar, []

    def work(progress):
        while not is_enough:
            progress(0.5, "copying the clip")

    window.session.jobs.run("Import", work, lambda _: None)
    wait_for(bar.isVisible)
    assert window.stage.geometry() == before
    assert window.stage.rect().contains(bar.geometry())
    window.resize(window.width() + 40, window.height())
    wait_for(lambda: bar.width() == window.stage.width() > before.width())
    is_enough.append(True)
    wait_for(bar.isHidden)


def test_long_work_says_how_long_it_still_takes(application, qtbot):
    bar = JobBar()
    qtbot.addWidget(bar)
    bar.show_state(JobState("Import", 0.0, ""), 100.0)
    for fraction, now_s, rest in (
        (0.5, 102.0, ""),  # too early to tell
        (0.02, 104.0, ""),
        (0.25, 110.0, "about 30 s left"),  # three times 10 s
        (0.7, 128.0, "about 15 s left"),  # 12 s
        (0.999, 130.0, "about 5 s left"),
        (0.1, 160.0, "about 9 min left"),  # nine times 60 s
    ):
        bar.show_state(JobState("Import", fraction, ""), now_s)
        assert bar.text_label.text() == " \u2013 ".join(filter(None, ("Import", rest)))
    bar.show_state(None, 161.0)
    bar.show_state(JobState("Import", 0.5, ""), 162.0)
    assert bar.text_label.text() == "Import"  # other work


def test_enter_presses_a_focused_button(qtbot):
    button = text_button("Go", "")
    qtbot.addWidget(button)
    button.show()
    with qtbot.waitSignal(button.clicked):
        qtbot.keyClick(button, Qt.Key.Key_Return)


@pytest.mark.parametrize("name", sorted(path.stem for path in FOLDER.glob("*.svg")))
def test_every_drawing_loads(qapp, name):
    assert not icon(name).pixmap(24, 24).toImage().isNull()
    assert icon(name).pixmap(24, 24).toImage().pixelColor(12, 12).isValid()


def luminance(colour: str) -> float:
    parts = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    linear = [
        p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts
    ]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


_PAIRS = (
    ("TEXT", "RAISED", 4.5),
    ("TEXT", "BACKGROUND", 4.5),
    ("TEXT", "ALARM", 4.5),
    ("DIM", "PANEL", 4.5),
    ("GOOD", "PANEL", 4.5),
    ("WARN", "PANEL", 4.5),
    ("BAD", "PANEL", 4.5),
    ("PRIMARY_TEXT", "PRIMARY", 4.5),
    ("FOCUS", "PANEL", 3.0),
)


@pytest.mark.parametrize(
    ("text", "ground", "least"),
    [
        *(
            (look[text], look[ground], least)
            for look in theme.THEMES.values()
            for text, ground, least in _PAIRS
        ),
        *(
            (colour, theme.THEMES[look]["PANEL"], 3.0)
            for look, colours in theme.AXES.items()
            for colour in colours
        ),
        ("#ffffff", theme.STOP, 4.5),
        ("#ffffff", "#8a5a00", 4.5),
    ],
)
def test_contrast_is_enough_to_read(text, ground, least):
    # WCAG 2.2, success criteria 1.4.3 (text) and 1.4.11 (lines and focus)
    light, dark = sorted((luminance(text), luminance(ground)), reverse=True)
    assert (light + 0.05) / (dark + 0.05) >= least
