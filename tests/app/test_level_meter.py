"""The level meter of a sound card's channels, in the list of devices and in the line."""

import face_checks
import pytest
from PySide6.QtGui import QColor, QPixmap

from app.player.outputs_page import OutputsPage
from app.widgets import theme
from app.widgets.level_meter import LEAST_DB, LevelMeter, levels_text
from hapticplayer.haptics.processes import Health
from hapticplayer.model.device import ChannelLevel
from tests.needed_extras import needs

LEVELS = (ChannelLevel(3, 10 ** (-12 / 20), False), ChannelLevel(4, 0.95, True))


def painted(widget):
    pixmap = QPixmap(widget.size())
    widget.render(pixmap)
    return pixmap.toImage()


def test_a_bar_shows_decibels_and_its_mark_the_limiter(application):
    meter = LevelMeter("Shaker")
    meter.show_levels(LEVELS)
    meter.resize(meter.sizeHint())
    image, middle = painted(meter), meter.height() // 2
    row = [image.pixelColor(x, middle) for x in range(image.width())]
    half = len(row) // 2
    green, red = QColor(theme.GOOD), QColor(theme.BAD)
    lengths = [part.count(green) for part in (row[:half], row[half:])]
    full = lengths[1] / (1.0 + LEVELS[1].peak_db / -LEAST_DB)
    assert lengths[0] / full == pytest.approx(1.0 - 12.0 / 48.0, abs=0.03)
    assert [part.count(red) > 3 for part in (row[:half], row[half:])] == [False, True]


def test_its_words_change_only_with_what_is_heard(application):
    meter = LevelMeter("Shaker")
    meter.show_levels(LEVELS)
    said = "Shaker: channel 3 \u221212 dB, channel 4 0 dB, limited"
    assert meter.accessibleName() == said
    meter.show_levels((LEVELS[0]._replace(peak=0.24), LEVELS[1]))
    assert meter.accessibleName() == said
    meter.show_levels((ChannelLevel(3, 0.0, False),))
    assert meter.accessibleName() == "Shaker: channel 3 silent"
    assert levels_text(LEVELS[:1]) == "channel 3 \u221212 dB"


@needs("rigs")
def test_an_output_with_channels_has_a_meter(make_window, wait_for, qtbot):
    """From the block that the loop writes to the bars."""
    window = make_window()
    window.commands.outputs.trigger()
    page = window.findChild(OutputsPage)
    window.player.set_outputs(["simulated", "rig:outsim"])

    def states():
        return {one.name: one for one in window.player.snapshot().outputs}

    wait_for(lambda: states()["simulated"].health is Health.READY)
    assert not page.rows["simulated"].meter.isVisible()
    block = window.player._outputs["simulated"].processes.block
    block.write_levels(LEVELS)
    page.look()
    qtbot.wait(20)
    meter = page.rows["simulated"].meter
    assert meter.isVisible()
    assert meter.accessibleName().startswith("Simulated: channel 3 \u221212 dB")
    assert not page.rows["rig:outsim"].meter.isVisible()
    assert list(face_checks.cut_off(page)) == []
    block.write_levels(())
    page.look()
    assert not meter.isVisible()


def test_the_health_line_shows_channels_of_the_main_device(make_window, wait_for):
    window = make_window("simulated")
    wait_for(lambda: window.player.snapshot().leading.health is Health.READY)
    entry = window.health.entries[0]
    plain_px = entry.needed_px()
    window.player._outputs.leading.processes.block.write_levels(LEVELS)
    wait_for(lambda: entry.meter.levels != ())
    assert entry.meter.isVisible()
    assert entry.needed_px() > plain_px
    assert entry.width() >= entry.needed_px()
