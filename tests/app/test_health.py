import dataclasses

import pytest

from app.bridge import languages
from app.player.health import Level, readings
from app.player.health_line import BETWEEN_PX, HealthLine
from hapticplayer.haptics.contract import Cause, Mode
from hapticplayer.haptics.processes import Health
from hapticplayer.model import LoopStats, SyncStats
from hapticplayer.playback.phases import Phase
from hapticplayer.playback.snapshot import Measurements, OutputSnapshot, Snapshot
from tests.needed_extras import needs

GOOD = Snapshot(
    phase=Phase.PLAYING,
    media_s=1.0,
    feedback="realistic",
    clock="audio",
    audio="default",
    frames_shown=300,
)
LEADING = OutputSnapshot(
    "simulated", Health.READY, scheduling="fifo", mode=Mode.FOLLOWING
)
MEASURED = Measurements(
    loop=LoopStats(10_000, 0, 20.0, 53.0, 200.0, 900.0),
    force_minus_video=SyncStats(100, -1.0, -0.25, 0.5),
    force_minus_audio=SyncStats(100, 0.0, 0.2, 0.4),
)


def with_changes(changes) -> tuple[Snapshot, Measurements]:
    names = {field.name for field in dataclasses.fields(Measurements)}
    measured = {name: changes.pop(name) for name in names & set(changes)}
    fields = {field.name for field in dataclasses.fields(OutputSnapshot)}
    leading = {name: changes.pop(name) for name in (fields & set(changes))}
    outputs = (dataclasses.replace(LEADING, **leading),)
    is_stopped = outputs[0].mode is Mode.TRIPPED
    return (
        dataclasses.replace(GOOD, outputs=outputs, is_stopped=is_stopped, **changes),
        dataclasses.replace(MEASURED, **measured),
    )


def shown(**changes) -> list[tuple[Level, str]]:
    return [tuple(reading) for reading in readings(*with_changes(changes))]


@pytest.fixture
def line(qtbot):
    made = HealthLine()
    qtbot.addWidget(made)
    made.show()
    qtbot.waitExposed(made)
    return made


def show(line, **changes):
    line.show_readings(*with_changes(changes))


def test_all_is_well():
    assert shown() == [
        (Level.GOOD, "Simulated, active"),
        (Level.GOOD, "FIFO"),
        (Level.GOOD, "yes, 53 \u00b5s, 0 missed"),
        (Level.GOOD, "\u22120.2, +0.5 ms"),
        (Level.GOOD, "+0.2, +0.4 ms"),
        (Level.GOOD, "300 shown, 0 dropped"),
        (Level.GOOD, "audio"),
    ]


@pytest.mark.parametrize(
    ("changes", "entry", "level", "words"),
    [
        ({"mode": Mode.TRIPPED, "cause": Cause.STOPPED}, 0, Level.BAD, "STOPPED"),
        (
            {"mode": Mode.TRIPPED, "cause": Cause.HEARTBEAT_LOST},
            0,
            Level.BAD,
            "window not responding",
        ),
        ({"health": Health.GONE}, 0, Level.BAD, "gone"),
        ({"health": Health.FAILED}, 0, Level.BAD, "failed"),
        (
            {"mode": Mode.IDLE, "cause": Cause.NOT_HOMED},
            0,
            Level.WATCH,
            "pull the grip out, then push it in",
        ),
        (
            {"name": "shaker", "mode": Mode.IDLE, "cause": Cause.NOT_HOMED},
            0,
            Level.WATCH,
            "starting",
        ),
        (
            {"mode": Mode.IDLE, "cause": Cause.HEARTBEAT_LATE},
            0,
            Level.WATCH,
            "at rest: window not responding",
        ),
        ({"mode": Mode.RAMPING, "cause": Cause.SEEK}, 0, Level.GOOD, "fading out"),
        ({"health": Health.STARTING}, 0, Level.WATCH, "starting"),
        ({"name": "none", "health": Health.NONE}, 0, Level.NEUTRAL, "none"),
        ({"scheduling": "normal"}, 1, Level.WATCH, "normal"),
        ({"scheduling": ""}, 1, Level.NEUTRAL, "\u2013"),
        ({"loop": LoopStats(10_000, 0, 20, 900, 2e3, 5e3)}, 2, Level.WATCH, "900"),
        ({"loop": LoopStats(10_000, 500, 20, 90, 2e3, 5e3)}, 2, Level.BAD, "500 miss"),
        ({"force_minus_video": None}, 3, Level.NEUTRAL, "\u2013"),
        ({"force_minus_video": SyncStats(9, -1, -0.04, 1)}, 3, Level.GOOD, "+0.0, +1"),
        ({"force_minus_video": SyncStats(9, 20, 25, 30)}, 3, Level.WATCH, "+25.0, +30"),
        ({"force_minus_video": SyncStats(9, 40, 51, 60)}, 3, Level.BAD, "late +51.0"),
        (
            {"force_minus_audio": SyncStats(9, -20, -16, 0)},
            4,
            Level.BAD,
            "early \u221216",
        ),
        ({"frames_dropped": 30}, 5, Level.BAD, "30 dropped"),
        ({"frames_damaged": 2}, 5, Level.WATCH, "2 damaged"),
        ({"clock": "monotonic", "audio": ""}, 6, Level.NEUTRAL, "monotonic"),
        ({"clock": "monotonic"}, 6, Level.WATCH, "no sound"),
        ({"clock": "monotonic"}, 4, Level.NEUTRAL, "\u2013"),
        ({"health": Health.GONE}, 2, Level.NEUTRAL, "\u2013"),
    ],
)
@needs("shakers")
def test_an_unhealthy_entry_says_why(changes, entry, level, words):
    found_level, text = shown(**changes)[entry]
    assert found_level is level
    assert words in text


def test_the_line_tells_the_judgement_in_words(line):
    show(line, scheduling="normal")
    assert line.entries[1].accessibleName() == "Scheduling: normal (watch)"
    assert line.entries[1].toolTip().startswith("Scheduling: normal (watch)")


def test_entries_keep_their_width_when_the_values_change(line):
    line.resize(1400, 44)
    show(line)
    before = [entry.geometry() for entry in line.entries]
    loop = LoopStats(10_000, 9999, 1e4, 1e6, 1e6, 1e6)
    show(line, loop=loop, frames_shown=10**9)
    line.layout().activate()
    assert [entry.geometry() for entry in line.entries] == before


@pytest.mark.parametrize("more_px", [12, 40, 600])
def test_a_long_entry_takes_its_room_from_short_ones(line, more_px):
    loop = LoopStats(10_000, 88, 1.0, 188.0, 1e3, 1e3)
    show(line, loop=loop, force_minus_audio=None)
    margins = line.layout().contentsMargins()
    needed_px = sum(entry.needed_px() for entry in line.entries)
    needed_px += (len(line.entries) - 1) * BETWEEN_PX
    line.resize(needed_px + margins.left() + margins.right() + more_px, 44)
    line.layout().activate()
    short = [e.text() for e in line.entries if e.width() < e.needed_px()]
    assert short == []


def test_why_the_force_has_stopped_is_not_cut_off(line):
    line.resize(1280, 44)
    show(line)
    stopped = {"mode": Mode.TRIPPED, "cause": Cause.MALFORMED}
    show(line, **stopped)
    line.layout().activate()
    assert "malformed replies" in line.entries[0].text()
    assert [e.text() for e in line.entries if e.width() < e.needed_px()] == []


@pytest.mark.parametrize("code", languages.NAMES)
def test_hundreds_of_missed_periods_are_not_shortened(application, qtbot, code):
    languages.install(application, code)
    try:
        line = HealthLine()
        qtbot.addWidget(line)
        line.resize(1280, 44)
        line.show()
        qtbot.waitExposed(line)
        loop = LoopStats(7476, 186, 9.0, 346.0, 6446.0, 34826.0)
        show(line, loop=loop)
        assert "186" in line.entries[2].text()
        assert [e.text() for e in line.entries if e.width() < e.needed_px()] == []
    finally:
        languages.install(application, languages.ENGLISH)


def test_new_values_are_not_drawn_in_the_old_room(qtbot):
    line = HealthLine()
    qtbot.addWidget(line)
    line.resize(936, 44)
    show(line, name="none", loop=None)
    line.show()
    qtbot.waitExposed(line)
    show(line, force_minus_audio=None)
    assert [e.text() for e in line.entries if e.width() < e.needed_px()] == []


def test_letters_are_smaller_where_what_is_said_needs_it(qtbot):
    line = HealthLine()
    qtbot.addWidget(line)
    line.show()
    qtbot.waitExposed(line)
    stopped = {"mode": Mode.TRIPPED, "cause": Cause.HEARTBEAT_LOST}
    line.resize(2000, 44)
    show(line, **stopped, frames_shown=12345)
    usual_px = [entry.needed_px() for entry in line.entries]
    margins = line.layout().contentsMargins()
    around_px = margins.left() + margins.right()
    around_px += (len(line.entries) - 1) * BETWEEN_PX
    line.resize(round(0.93 * sum(usual_px)) + around_px, 44)
    line.layout().activate()
    assert [e.text() for e in line.entries if e.width() < e.needed_px()] == []
    assert sum(entry.needed_px() for entry in line.entries) < sum(usual_px)
    line.resize(2000, 44)
    assert [entry.needed_px() for entry in line.entries] == usual_px


@pytest.mark.parametrize("code", languages.NAMES)
@pytest.mark.parametrize("width_px", [960, 780, 640])
def test_a_narrow_window_gets_two_rows(application, qtbot, code, width_px):
    """960 px is a screen of 1920 px at 200 %."""
    languages.install(application, code)
    try:
        line = HealthLine()
        qtbot.addWidget(line)
        line.resize(width_px, 44)
        line.show()
        qtbot.waitExposed(line)
        one_row_px = line.sizeHint().height()
        show(line, mode=Mode.IDLE, cause=Cause.NOT_HOMED)
        line.resize(width_px, line.sizeHint().height())
        show(line, mode=Mode.IDLE, cause=Cause.NOT_HOMED)
        assert [e.text() for e in line.entries if e.width() < e.needed_px()] == []
        assert all(line.rect().contains(e.geometry()) for e in line.entries)
        line.resize(2000, line.height())
        show(line, mode=Mode.IDLE, cause=Cause.NOT_HOMED)
        assert line.sizeHint().height() < 1.5 * one_row_px
    finally:
        languages.install(application, languages.ENGLISH)


def test_frames_dropped_long_ago_do_not_alarm(line):
    """A busy start is over; the figures stay, and what is dropped now is seen."""
    entry = line.entries[5]

    def said(frames_shown, frames_dropped, times=1):
        for _ in range(times):
            show(line, frames_shown=frames_shown, frames_dropped=frames_dropped)
        return entry.accessibleName()

    assert "(bad)" in said(100, 40)
    assert "(good)" in said(700, 40, times=25)
    assert "40 dropped" in entry.text()
    assert "(bad)" in said(710, 60)
    assert "(good)" in said(30, 0)  # another clip
