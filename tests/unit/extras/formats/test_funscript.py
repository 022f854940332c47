"""Funscript: positions of a hand, axes, and what others write."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest

from hapticplayer.errors import InputError
from hapticplayer.model import ForceTrack, Reconstruction
from hapticplayer.sequence.excursion import predict, travel_m
from hapticplayer.sequence.force_files import WriteChoices
from hapticplayer.sequence.force_formats import (
    export_track,
    force_formats,
    loss_line,
    read_force,
)
from tests.unit.extras.formats.conftest import RAMP, at


def positions(actions, time_s):
    rows = [(one["at"] / 1000.0, one["pos"]) for one in actions]
    return np.interp(time_s, *zip(*rows, strict=True))


@pytest.mark.parametrize("version", ["1.0", "1.1", "2.0"])
def test_a_funscript_holds_the_excursion_of_a_hand(written, version):
    push = ForceTrack([0.0, 2.0], [[0, 2, -2], [0, 0, 0]], Reconstruction.HOLD)
    path = written("funscript", push, duration_s=3.0, funscript_version=version)
    content = json.loads(path.read_text())
    time_s, place_m = travel_m(push, 3.0)
    up = positions(content["actions"], time_s)
    assert up.max() > 54.0  # pushed up
    np.testing.assert_allclose(up, 50 + 50 * place_m[:, 1] / 0.04, atol=1.0)
    if version == "2.0":
        surge = content["channels"]["surge"]["actions"]
        assert max(one["pos"] for one in surge) > 54  # forward is away from the user
    assert ("axes" in content) == (version == "1.1")


def test_a_script_of_version_1_0_is_a_file_for_each_axis(tmp_path):
    push = ForceTrack([0.0, 2.0], [[-1, 2, -2], [0, 0, 0]], Reconstruction.HOLD)
    form, path = force_formats()["funscript"], tmp_path / "ride.funscript"
    choices = WriteChoices(duration_s=3.0, funscript_version="1.0")
    report = export_track(push, path, form, choices)
    names = ["ride.funscript", "ride.surge.funscript", "ride.sway.funscript"]
    assert sorted(one.name for one in tmp_path.iterdir()) == sorted(names)
    assert report["beside"] == names[1:]
    assert report["bytes"] == sum(one.stat().st_size for one in tmp_path.iterdir())
    assert "the other axes are in ride.surge.funscript" in str(loss_line(report))
    time_s, place_m = travel_m(push, 3.0)
    for name, column, sign in zip(names, (1, 2, 0), (1, -1, -1), strict=True):
        content = json.loads((tmp_path / name).read_text())
        assert content.keys() == {"version", "metadata", "actions"}
        exact = 50 + 50 * sign * place_m[:, column] / 0.04
        there = positions(content["actions"], time_s)
        assert there.max() > 51.0
        np.testing.assert_allclose(there, exact, atol=1.0)
    with pytest.raises(InputError, match="exists"):
        export_track(push, path, form, choices)
    export_track(push, path, form, replace(choices, overwrite=True))


def test_a_version_1_0_is_read_like_a_version_1_1(written, tmp_path):
    push = ForceTrack([0.0, 2.0], [[-1, 2, -2], [0, 0, 0]], Reconstruction.HOLD)
    one = read_force(written("funscript", push, duration_s=3.0))
    path, form = tmp_path / "ride.funscript", force_formats()["funscript"]
    export_track(push, path, form, WriteChoices(3.0, funscript_version="1.0"))
    three = read_force(path)
    np.testing.assert_array_equal(three.track.force_n, one.track.force_n)
    assert "ride.surge.funscript beside it was read" in str(three.assumed[1])
    (tmp_path / "ride.sway.funscript").unlink()
    two = read_force(path).track
    assert not two.force_n[:, 0].any()
    assert two.force_n[:, 2].any()


def test_one_of_the_files_that_is_in_the_way_is_kept(tmp_path):
    (tmp_path / "ride.sway.funscript").write_text("dear")
    choices = WriteChoices(funscript_version="1.0", overwrite=True)
    form = force_formats()["funscript"]
    with pytest.raises(InputError, match="sway"):
        export_track(RAMP, tmp_path / "ride.funscript", form, choices)
    assert [one.name for one in tmp_path.iterdir()] == ["ride.sway.funscript"]


def test_the_excursion_is_the_one_that_is_predicted():
    push = ForceTrack([0.2, 1.7], [[0, 3, 0], [0, 0, 0]], Reconstruction.HOLD)
    _, place_m = travel_m(push, 3.0)
    reach = predict(push, 3.0).hands["normal"].reach
    assert np.linalg.norm(place_m, axis=1).max() / 0.04 == pytest.approx(
        reach, rel=0.02
    )


def test_a_funscript_has_few_positions_and_all_axes_are_near(written, rng):
    force_n = np.cumsum(rng.normal(0.0, 0.3, (2000, 3)), axis=0)
    track = ForceTrack(np.arange(2000) / 20.0, 2.0 * np.sin(force_n))
    content = json.loads(written("funscript", track).read_text())
    time_s, place_m = travel_m(track, float(track.time_s[-1]))
    axes = [content, *content["axes"]]
    for one, column, sign in zip(axes, (1, 2, 0), (1, -1, -1), strict=True):
        exact = 50 + 50 * sign * place_m[:, column] / 0.04
        there = positions(one["actions"], time_s)
        np.testing.assert_allclose(there, exact, atol=1.0)
        assert len(one["actions"]) < len(time_s) / 2


def test_a_funscript_of_too_many_positions_is_refused(written, monkeypatch):
    monkeypatch.setattr("hapticplayer.extras.formats.funscript.MAX_ACTIONS", 5)
    with pytest.raises(InputError, match="positions"):
        written("funscript")


def test_a_funscript_is_a_spring_set_point_on_three_axes(read):
    content = {
        "version": "1.1",
        "actions": [{"at": 0, "pos": 50}, {"at": 1000, "pos": 100}],
        "axes": [
            {"id": "L1", "actions": [{"at": 0, "pos": 100}, {"at": 1000, "pos": 100}]},
            {"id": "R0", "actions": [{"at": 0, "pos": 0}]},
        ],
    }
    found = read(json.dumps(content), ".funscript", stiffness_n_per_m=50.0)
    # 50 N/m over 40 mm is 2 N
    np.testing.assert_allclose(at(found.track, 0.5)[0], [0, 1, -2], atol=1e-6)
    notes = [str(note) for note in found.notes]
    assert "set-point" in notes[0]
    assert notes[1] == "not read: R0 (1)"


LINE = [{"at": 0, "pos": 0}, {"at": 1000, "pos": 100}]
EDGE_N = 40.0 * 0.04
"""Of the usual spring at the edge of the workspace."""


def test_a_position_before_the_clip_is_on_the_line_to_the_next(read):
    actions = [
        {"at": -1000, "pos": 0},
        {"at": 400, "pos": 100},
        {"at": 900, "pos": 100},
    ]
    found = read(json.dumps({"actions": actions}), ".funscript")
    force_n = at(found.track, 0.0, 0.4, 0.8)[:, 1]
    first_n = EDGE_N * (100.0 / 1.4 - 50.0) / 50.0  # 71.4 at 0 ms
    np.testing.assert_allclose(force_n, [first_n, EDGE_N, EDGE_N], atol=1e-5)
    assert [str(note) for note in found.unread] == ["what lies before 0 s was left out"]


def test_the_positions_of_the_case_begin_on_the_line(scripts):
    found = read_force(scripts / "negative_at.funscript").track
    assert at(found, 0.0)[0, 1] == pytest.approx(0.69, abs=0.005)


@pytest.mark.parametrize("part", ["suck", "valve", "lube", "Pump", "roll", "twist"])
def test_a_script_of_another_axis_is_refused_with_what_to_do(read, tmp_path, part):
    with pytest.raises(
        InputError, match=rf"{part.lower()}\), which are not"
    ) as refused:
        read(json.dumps({"actions": LINE}), f".{part}.funscript")
    (name,) = re.findall(r"rename it to '(.*)' to feel", str(refused.value))
    (tmp_path / f"other.{part}.funscript").rename(tmp_path / name)
    assert np.abs(read_force(tmp_path / name).track.force_n).max() > 0.9


@pytest.mark.parametrize("part", ["suck", "valve", "lube"])
def test_the_strengths_of_the_case_are_not_positions(scripts, part):
    with pytest.raises(InputError, match="strengths"):
        read_force(scripts / f"clip.{part}.funscript")


@pytest.mark.parametrize("part", ["vib", "V0", "vibrate"])
def test_a_script_of_vibration_is_felt_as_strong_as_it_says(read, part):
    places = [(1000, 0), (2000, 100), (3000, 100), (3000, 0), (4000, 0)]
    actions = [{"at": at_ms, "pos": place} for at_ms, place in places]
    script = json.dumps({"actions": actions})
    along = {"full_scale_n": 2.0, "direction": (1.0, 0.0, 0.0)}
    found = read(script, f".{part}.funscript", **along)
    force_n = at(found.track, *np.arange(0.0, 4.0, 0.001))
    assert not force_n[:, 1:].any()
    sizes = np.abs(force_n[:, 0]).reshape(-1, 20).max(axis=1)  # of each period
    assert sizes[:50] == pytest.approx(0.0)  # off until its first action
    assert sizes[74] == pytest.approx(1.0, abs=0.05)
    assert sizes[100:150] == pytest.approx(2.0, abs=0.01)
    assert sizes[151:] == pytest.approx(0.0)
    crossings = np.sum(np.diff(np.sign(force_n[2000:3000, 0])) > 1.0)
    assert crossings == pytest.approx(50, abs=2)
    assert "strength 100 was taken as 2 N" in str(found.assumed[0])


def test_a_vibration_that_begins_before_the_clip_is_cut(read):
    actions = [{"at": -1000, "pos": 100}, {"at": 1000, "pos": 100}]
    found = read(json.dumps({"actions": actions}), ".vib.funscript")
    assert np.abs(found.track.force_n).max() == pytest.approx(1.0, abs=0.01)
    assert [str(note) for note in found.unread] == ["what lies before 0 s was left out"]


def test_a_vibration_of_many_hours_is_refused(read):
    actions = [{"at": 0, "pos": 0}, {"at": 9_000_000, "pos": 100}]
    with pytest.raises(InputError, match=r"more than 3000 s.*cut it"):
        read(json.dumps({"actions": actions}), ".vib.funscript")


def test_a_vibration_without_actions_is_refused(read):
    with pytest.raises(InputError, match="holds no positions"):
        read("{}", ".vib.funscript")


@pytest.mark.parametrize("name", ["roll", "pump", "left", "my.ride", "ride.v2"])
def test_a_script_with_such_a_name_alone_is_up(tmp_path, name):
    path = tmp_path / f"{name}.funscript"
    path.write_text(json.dumps({"actions": LINE}))
    assert at(read_force(path).track, 0.999)[0, 1] == pytest.approx(EDGE_N, abs=0.01)


def test_axes_beside_a_script_are_read_or_said(read, tmp_path):
    text = json.dumps({"actions": [{"at": 0, "pos": 50}, {"at": 1000, "pos": 100}]})
    for name in ("other.Surge", "other.twist", "other.vib", "another.sway"):
        (tmp_path / f"{name}.funscript").write_text(text)
    found = read(text, ".funscript")
    assert at(found.track, 0.5)[0] == pytest.approx([0, 0.8, -0.8])
    notes = " ".join(map(str, found.notes))
    assert "other.Surge.funscript beside it was read" in notes
    assert "not read: other.twist.funscript" in notes
    assert "not read: other.vib.funscript" in notes
    assert "another" not in notes


def test_a_script_in_utf_16_is_named(read):
    with pytest.raises(InputError, match="UTF-16; save it as text in UTF-8"):
        read(json.dumps({"actions": []}).encode("utf-16"), ".funscript")


@pytest.mark.parametrize(
    ("content", "suffix"),
    [
        ('{"actions": [{"at": 0, "pos": 50}, {"at": 1000, "pos": 50}]}', ".funscript"),
        ("time_s,fx_n,fy_n,fz_n\n0,0,0,0\n1,0,0,0\n", ".csv"),
    ],
)
def test_a_file_without_any_force_is_said(read, content, suffix):
    assert "0 N from beginning to end" in " ".join(
        map(str, read(content, suffix).notes)
    )


@pytest.mark.parametrize(
    "more", [{"axes": [{"id": "L0"}]}, {"channels": {"stroke": {}}}]
)
def test_an_axis_that_is_there_twice_is_said(read, more):
    (held,) = more.values()
    other = held[0] if isinstance(held, list) else held["stroke"]
    other["actions"] = [{"at": 0, "pos": 50}, {"at": 1000, "pos": 50}]
    found = read(json.dumps({"actions": LINE, **more}), ".funscript")
    assert at(found.track, 0.999)[0, 1] == pytest.approx(EDGE_N, abs=0.01)
    assert [str(note) for note in found.unread] == [
        "L0 appears twice; the first was read"
    ]


@pytest.mark.parametrize("name", ["L1", "l1", "surge", "Forward"])
def test_an_axis_may_be_named_in_words(read, name):
    script = json.dumps({"axes": [{"id": name, "actions": LINE}]})
    assert at(read(script, ".funscript").track, 0.999)[0, 2] < -1.5


def test_two_positions_at_one_time_are_a_step(read):
    places = [(0, 100), (500, 100), (500, 25), (1000, 25)]
    actions = [{"at": at_ms, "pos": place} for at_ms, place in places]
    found = read(json.dumps({"actions": actions}), ".funscript").track
    force_n = at(found, 0.499, 0.501, 0.9)[:, 1]
    np.testing.assert_allclose(force_n, [EDGE_N, -EDGE_N / 2, -EDGE_N / 2], atol=1e-4)


def test_positions_beyond_the_way_are_limited_and_counted(read):
    actions = [{"at": 0, "pos": -5}, {"at": 500, "pos": 50}, {"at": 1000, "pos": 999}]
    found = read(json.dumps({"actions": actions}), ".funscript")
    assert at(found.track, 0.0)[0, 1] == pytest.approx(-EDGE_N)
    assert str(found.assumed[-1]) == "2 positions of L0 beyond 0 to 100 were limited"


@pytest.mark.parametrize("positions", [(0, 0.5, 1), (0, 1, 0), (0.2, 0.4, 0.6)])
def test_positions_from_0_to_1_are_refused_with_the_factor(read, positions):
    actions = [{"at": 500 * k, "pos": pos} for k, pos in enumerate(positions)]
    with pytest.raises(InputError, match=r"from 0 to 1.*multiply its positions by 100"):
        read(json.dumps({"actions": actions}), ".funscript")


def test_an_axis_that_is_there_twice_and_alike_is_one(read):
    content = {"actions": LINE, "axes": [{"id": "L0", "actions": LINE}]}
    assert read(json.dumps(content), ".funscript").unread == ()


@pytest.mark.parametrize(("given", "is_unread"), [(50, True), (90, False), (120, True)])
def test_a_range_that_is_not_applied_is_said(read, given, is_unread):
    found = read(json.dumps({"range": given, "actions": LINE}), ".funscript")
    said = found.unread if is_unread else found.assumed
    assert f"range of {given} % was not applied" in str(said[-1])
    whole = read(json.dumps({"range": 100, "actions": LINE}), ".funscript")
    assert len(whole.notes) == 1


NULLS = {"axes": None, "channels": None, "metadata": None, "range": None, "id": None}


@pytest.mark.parametrize(
    "more",
    [
        NULLS,
        {"inverted": None, "version": None, "axes": [None]},
        {"axes": [{"id": "L1", "actions": []}, {"id": "L2", "inverted": None}]},
        {"channels": {"surge": None}},
        {"is_null": True, "others": 3},
    ],
)
def test_null_in_a_script_is_as_if_it_were_absent(read, more):
    plain = read(json.dumps({"actions": LINE}), ".funscript")
    found = read(json.dumps({"actions": LINE, **more}), ".funscript")
    np.testing.assert_array_equal(found.track.force_n, plain.track.force_n)
    assert found.notes == plain.notes


@pytest.mark.parametrize("name", ["rawactions", "vibration"])
@pytest.mark.parametrize("wrap", [lambda held: held, lambda held: {"actions": held}])
def test_actions_under_another_name_are_listed(read, name, wrap):
    more = {
        name: wrap(LINE),
        "metadata": {"chapters": []},
        "tags": ["a"],
        "bookmarks": [],
    }
    found = read(json.dumps({"actions": LINE, **more}), ".funscript")
    assert [str(note) for note in found.unread] == [f"not read: {name} (1)"]


def test_actions_that_are_null_are_named(read):
    script = {"actions": None, "axes": [{"id": "L1", "actions": LINE}]}
    found = read(json.dumps(script), ".funscript")
    assert at(found.track, 0.999)[0, 2] == pytest.approx(-EDGE_N, abs=0.01)
    assert [str(note) for note in found.unread] == ["L0: its actions are null"]


@pytest.mark.parametrize(
    "script",
    [
        {"Actions": [{"At": 0, "Pos": 0}, {"At": 1000, "Pos": 100}]},
        {"ACTIONS": [{"at": "0", "pos": "0"}, {"at": "1e3", "pos": "100.0"}]},
        {"actions": [{"at": 0.0, "pos": 0.0}, {"at": 1000.0, "pos": 100.0}]},
        {"actions": [{"at": 0, "pos": "0"}, {" at": 1000, "POS": 100, "x": 1}]},
        {"Inverted": "false", "Range": "100", "actions": LINE},
        {"actions": LINE[::-1], "inverted": 0},
        {"inverted": "True", "actions": [{"at": 0, "pos": 100}, {"at": 1e3, "pos": 0}]},
    ],
)
def test_spellings_of_other_programs_are_read(read, script):
    plain = read(json.dumps({"actions": LINE}), ".funscript")
    found = read(json.dumps(script), ".funscript")
    np.testing.assert_array_equal(found.track.force_n, plain.track.force_n)
    assert found.notes == plain.notes


def test_times_in_seconds_are_refused_with_the_factor(read):
    def script(scale):
        rows = [{"at": 0.4 * k * scale, "pos": k % 2 * 100} for k in range(9)]
        return json.dumps({"actions": rows})

    with pytest.raises(
        InputError, match=r"look like seconds.*multiply its times by 1000"
    ):
        read(script(1.0), ".funscript")
    assert read(script(1000.0), ".funscript").track.end_s == pytest.approx(3.2)


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (
            '{"actions": [{"at": "0:01", "pos": 1}]}',
            r"\[0\].at: must be a number.*correct",
        ),
        (
            '{"actions": [{"at": 0, "pos": "5,5"}]}',
            r"actions\[0\].pos: must be a number",
        ),
        ('{"actions": [{"at": 0}]}', "missing entry 'pos'"),
        ('{"actions": [{"at": 0, "pos": null}]}', "pos: must be a number"),
        ('{"actions": [{"at": 1e12, "pos": 1}]}', "at: must be at most"),
        ('{"actions": {"at": 0, "pos": 1}}', "actions: must be a list"),
        ('{"actions": [[0, 1]]}', r"actions\[0\]: must be an object"),
        ('{"inverted": "yes", "actions": []}', "inverted: must be true or false"),
        ('{"channels": {"surge": 3}}', "channels.surge: must be an object"),
        ('{"actions": [{"at": -9, "pos": 1}]}', "ends before 0 s"),
        ('{"actions": []}', "holds no positions"),
        ('{"actions": null}', r"no positions.*L0: its actions are null"),
        ('{"channels": {"roll": {"actions": []}}}', r"no positions.*not read: roll"),
        ("[]", "must be an object"),
    ],
)
def test_a_damaged_script_is_refused_by_its_place(read, content, says):
    with pytest.raises(InputError, match=says):
        read(content, ".funscript")
