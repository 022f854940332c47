"""Edits are seen, felt and compared while the clip plays."""

import numpy as np
import pytest

from app.editor.comparison import Comparison
from app.editor.live_force import LiveForce
from hapticplayer.errors import InputError
from hapticplayer.rendering.effects import NO_EFFECTS, Effect, EffectList
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.editing import rendering_of
from hapticplayer.sequence.figures import ForceFigures
from hapticplayer.sequence.presets import render_preset

EFFECTS = EffectList((Effect("gain", 0.2, 0.6),))
PULSE = Effect("pulse", 0.5, 1.5, parameters={"amplitude": 2.0}, direction=(1, 0, 0))


def test_an_edit_is_rendered_as_it_will_be_saved(make_page, folder, wait_for):
    page = make_page(folder)
    stored = page.loaded.source.tracks["realistic"]
    assert page.playing.track is stored
    assert page.lanes.track is stored
    page.editing.add(PULSE, "Add")
    wait_for(lambda: page.playing.track is not stored)
    track = page.playing.track
    assert page.playing.session.player.snapshot().source.tracks["realistic"] is track
    sequence = open_sequence(folder)
    expected = render_preset(
        sequence.motion,
        sequence.mapping,
        name=str(track.provenance["preset"]),
        effects=page.document.effects,
    )
    assert np.array_equal(track.force_n, expected.force_n)
    assert np.array_equal(track.time_s, expected.time_s)
    page.change_bar.undo_button.click()
    wait_for(lambda: page.playing.track is stored)
    assert page.lanes.track is stored


def test_the_force_without_effects_lies_behind_it(make_page, folder, wait_for):
    page = make_page(folder)
    wait_for(lambda: page.lanes.before is not None)
    plain = rendering_of(open_sequence(page.folder)).track(NO_EFFECTS)
    assert np.array_equal(page.lanes.before.force_n, plain.force_n)
    page.editing.add(PULSE, "Add")
    wait_for(lambda: not page.live.is_busy)
    with_both = page.lanes.grab().toImage()
    page.play_bar.compare.click()
    assert page.lanes.grab().toImage() != with_both


def test_figures_of_both_are_predicted_once_edits_rest(make_page, folder, wait_for):
    page = make_page(folder)
    page.editing.add(PULSE, "Add")
    wait_for(lambda: page.comparison.after is not None)
    wait_for(lambda: page.comparison.after.rms_n > page.comparison.before.rms_n + 0.3)
    text = page.comparison.text()
    assert f"{page.comparison.before.rms_n:.2f} \u2192" in text
    assert f"\u2192 {page.comparison.after.peak_n:.2f} N" in text


def test_a_force_that_would_be_stopped_is_told_of(application, qtbot):
    line = Comparison()
    qtbot.addWidget(line)
    before = ForceFigures(1.0, 0.5, (0.5,), 0.0, {"relaxed": 0.4}, ())
    line.show_figures(before, before)
    assert "stopped" not in line.text()
    after = ForceFigures(4.5, 2.0, (2.0,), 0.1, {"relaxed": 1.0}, ("relaxed",))
    line.show_figures(before, after)
    assert "0.0 \u2192 10.0 %" in line.text()
    assert "the force would be stopped" in line.text()


def test_of_several_edits_the_last_is_rendered(application, folder, qtbot):
    live = LiveForce(rendering_of(open_sequence(folder)))
    made = []
    live.made.connect(lambda effects, _track: made.append(effects))
    lists = [EffectList((Effect("mute", 0.1 * k, 1.0),)) for k in range(8)]
    live.poll()
    for effects in lists:
        live.want(effects)
    while live.is_busy:
        live.poll()
        qtbot.wait(1)
    assert made == [NO_EFFECTS, lists[-1]]
    live.want(lists[-1])
    assert not live.is_busy
    live.close()


def test_a_track_that_cannot_be_rendered_is_reported(application, qtbot):
    class Broken:
        def track(self, _effects):
            raise InputError("the motion track is empty")

    live, said = LiveForce(Broken()), []
    live.failed.connect(said.append)
    while live.is_busy:
        live.poll()
        qtbot.wait(1)
    assert [str(one) for one in said] == ["the motion track is empty"]


def test_a_loop_follows_the_effect_and_goes_there(make_page, folder):
    page = make_page(folder)
    page.editing.add(PULSE, "Add")
    page.play_bar.loop.click()
    player = page.playing.session.player
    assert player.snapshot().loop_s == pytest.approx((0.2, 1.8))
    assert page.lanes.cursor_s == pytest.approx(0.2)
    page.panel.fields["end_s"].box.setValue(1.0)
    assert player.snapshot().loop_s == pytest.approx((0.2, 1.3))
    page.editing.select_all()  # from 0.2 to 1.0 s
    assert player.snapshot().loop_s == pytest.approx((0.0, 1.3))
    page.play_bar.loop.click()
    assert player.snapshot().loop_s is None


@pytest.mark.realtime
def test_a_slider_is_felt_while_the_clip_plays(make_page, folder, wait_for):
    page = make_page(folder, "simulated")
    player = page.playing.session.player
    wait_for(lambda: player.snapshot().leading.tick is not None)
    page.editing.add(PULSE, "Add")
    page.play_bar.loop.click()
    page.playing.toggle()

    def pushed() -> float:
        """Return the newest force to the right while the pulse plays, else 0.

        Less than planned: the hand gives way, and outward force is reduced.
        """
        tick = player.snapshot().leading.tick
        is_in_pulse = 0.7 < tick["media_s"] < 1.4
        return float(tick["force_n"][0]) if is_in_pulse else 0.0

    wait_for(lambda: pushed() > 1.0)
    begin_s = float(player.snapshot().leading.tick["monotonic_s"])
    page.panel.fields["amplitude"].slider.setValue(60)  # -2 N
    wait_for(lambda: pushed() < -1.0)
    ticks = player.ticks_since(begin_s)
    on_time = np.diff(ticks["monotonic_s"]) < 0.0015  # a late one makes up for more
    steps_n = np.abs(np.diff(ticks["force_n"], axis=0))[on_time]
    assert np.count_nonzero(on_time) > 100
    assert steps_n.max() <= 1.0 + 1e-6  # the slew of the contract
