"""The command `effects`, and `render --effects`."""

import json
import subprocess
import sys

import numpy as np
import pytest

from hapticplayer import cli
from hapticplayer.capture.recording import Recording
from hapticplayer.errors import InputError, SequenceError
from hapticplayer.model import ClockMap
from hapticplayer.rendering.effects import Effect, EffectList, TimeMarker
from hapticplayer.sequence import effects_file, open_sequence, store, verify_sequence
from hapticplayer.sequence.build import Choices, write_sequence
from hapticplayer.sequence.editing import set_effects
from hapticplayer.sequence.pack import pack
from hapticplayer.sequence.packed import read_packed


@pytest.fixture
def folder(tmp_path, tiny_clip, swing):
    ride = Recording(swing[0], ClockMap(offset_s=-3.0), "test camera", (), {})
    return write_sequence(tiny_clip, ride, tmp_path / "ride", choices=Choices(seed=5))


def do(folder, *words):
    return cli.main(["effects", str(folder), *words])


MUTE = ("add", "mute", "--start", "0.2", "--end", "0.6")


def realistic(folder):
    return open_sequence(folder).tracks["realistic"]


def test_an_effect_changes_its_span_and_off_is_as_before(folder):
    before, motion = realistic(folder), (folder / "motion.npz").read_bytes()
    assert do(folder, *MUTE) == 0
    verify_sequence(folder)
    made = realistic(folder)
    assert not made.at(np.linspace(0.21, 0.59, 50)).any()
    assert before.at(np.linspace(0.21, 0.59, 50)).any()
    assert made.provenance["effects"] == [
        {"kind": "mute", "start_s": 0.2, "end_s": 0.6, "target": "force"}
    ]
    assert do(folder, "disable", "1") == 0
    np.testing.assert_array_equal(realistic(folder).time_s, before.time_s)
    np.testing.assert_array_equal(realistic(folder).force_n, before.force_n)
    assert realistic(folder).provenance == before.provenance
    assert (folder / "motion.npz").read_bytes() == motion


def test_a_list_is_changed_and_printed(folder, capsys):
    words = ("--param", "amplitude=2.5", "--direction", "1,0,0", "--fade-out", "0.1")
    assert do(folder, "add", "knock", "--start", "0.1", "--end", "0.4", *words) == 0
    assert do(folder, *MUTE) == 0
    assert do(folder, "move", "1", "--by", "0.5") == 0
    assert do(folder, "remove", "2") == 0
    capsys.readouterr()
    assert cli.main(["effects", str(folder), "--json", "list"]) == 0
    (only,) = json.loads(capsys.readouterr().out)["effects"]
    assert only["kind"] == "knock"
    assert only["start_s"] == pytest.approx(0.6)
    assert only["parameters"] == {"amplitude": 2.5}
    verify_sequence(folder)
    assert len(list(folder.glob("effects*.json"))) == 1


def test_a_forbidden_change_of_effects_changes_nothing(folder, capsys):
    before = (folder / "sequence.json").read_bytes()
    assert do(folder, "remove", "1") == 2
    assert "there is no effect 1" in capsys.readouterr().err
    assert do(folder, *MUTE, "--param", "size=3") == 2
    twice = ("--param", "amplitude=1", "--param", "amplitude=2")
    assert do(folder, "add", "pulse", *MUTE[2:], *twice) == 2
    assert "once" in (said := capsys.readouterr().err)
    assert "mute has no such parameter" in said
    assert (folder / "sequence.json").read_bytes() == before


@pytest.mark.parametrize("span", [("5000", "5001"), ("0.5", "5000"), ("-1", "0.5")])
def test_an_effect_beyond_the_clip_is_refused(folder, capsys, span):
    before = (folder / "sequence.json").read_bytes()
    words = ("add", "mute", f"--start={span[0]}", f"--end={span[1]}")
    assert do(folder, *words) == 2
    said = capsys.readouterr().err
    assert "is not within the clip" in said or "start" in said
    assert (folder / "sequence.json").read_bytes() == before
    assert do(folder, *MUTE) == 0
    assert do(folder, "move", "1", "--by", "5000") == 2
    assert "is not within the clip" in capsys.readouterr().err


def test_a_list_of_a_longer_clip_is_refused(folder, tmp_path, capsys):
    late = EffectList((Effect("mute", 5000.0, 5001.0),))
    (tmp_path / "late.json").write_text(json.dumps(effects_file.written(late)))
    target = tmp_path / "other"
    words = ["render", str(folder), "-o", str(target)]
    assert cli.main([*words, "--effects", str(tmp_path / "late.json")]) == 2
    assert "effect 1 (mute, from 5000 to 5001 s) is beyond" in capsys.readouterr().err
    assert not target.exists()


def test_render_takes_a_list_from_a_file(folder, tmp_path, capsys):
    assert do(folder, *MUTE) == 0
    listed, target = folder / "effects.json", tmp_path / "other"
    content = json.loads(listed.read_text())
    content["effects"][0]["end_s"] = 0.3
    mine = tmp_path / "mine.json"
    mine.write_text(json.dumps(content))
    words = ["render", str(folder), "-o", str(target), "--effects", str(mine)]
    assert cli.main(words) == 0
    (effect,) = store.effects_of(open_sequence(target)).effects
    assert effect.end_s == 0.3
    content["effects"][0]["end_s"] = "late"
    mine.write_text(json.dumps(content))
    words[3] = str(tmp_path / "third")
    assert cli.main(words) == 1
    assert "effects[0].end_s: must be a number" in capsys.readouterr().err


def test_a_list_that_was_changed_by_hand_is_noticed(folder):
    assert do(folder, *MUTE) == 0
    listed = folder / "effects.json"
    listed.write_text(listed.read_text().replace("0.6", "0.7"))
    with pytest.raises(SequenceError, match="has changed since it was written"):
        store.effects_of(open_sequence(folder))


def test_a_list_travels_with_its_video(folder, tmp_path):
    assert do(folder, *MUTE) == 0
    pack(folder, tmp_path / "ride.mkv")
    packed = read_packed(tmp_path / "ride.mkv")
    assert packed.small["effects.json"] == (folder / "effects.json").read_bytes()


def test_four_programs_that_add_at_once_leave_four_effects(folder):
    call = "import sys; from hapticplayer import cli; sys.exit(cli.main(sys.argv[1:]))"
    command = [sys.executable, "-c", call, "effects", folder, *MUTE[:2]]
    waiting = [[*command, "--start", f"0.{start}", "--end", "0.9"] for start in "1234"]
    while waiting:
        adding = [
            (words, subprocess.Popen(words, stderr=subprocess.PIPE, text=True))
            for words in waiting
        ]
        said = [(words, one.communicate()[1], one.returncode) for words, one in adding]
        waiting = [words for words, _text, status in said if status]
        # a slow machine lets a wait for the lock run out; the last one always gets it
        assert all("is being changed" in text for _w, text, status in said if status)
        assert len(waiting) < len(said)
    verify_sequence(folder)
    found = store.effects_of(open_sequence(folder)).effects
    assert sorted(one.start_s for one in found) == [0.1, 0.2, 0.3, 0.4]


def test_markers_stay_while_effects_are_changed(folder, capsys):
    marked = EffectList((Effect("gain", 0.1, 0.4),), (TimeMarker(0.25, "The gate"),))
    set_effects(folder, marked)
    for words in (MUTE, ("disable", "1"), ("remove", "2"), ("list",)):
        assert do(folder, *words) == 0
    assert store.effects_of(open_sequence(folder)).markers == marked.markers
    assert "at 0.25 s: The gate" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ({"time_s": -1.0, "name": "a"}, r"markers\[0\]: time_s"),
        ({"time_s": 1.0, "name": ""}, r"markers\[0\]: name"),
        ({"time_s": 1.0, "name": "a\nb"}, r"markers\[0\]: name"),
        ({"time_s": 1.0, "name": "a", "x": 1}, "x"),
        ({"time_s": 1.0}, "name"),
    ],
)
def test_markers_that_are_not_allowed_are_refused(tmp_path, entry, message):
    path = tmp_path / "effects.json"
    content = {**effects_file.written(EffectList()), "markers": [entry]}
    path.write_text(json.dumps(content))
    with pytest.raises(InputError, match=message):
        effects_file.read_effects(path)
    path.write_text(
        json.dumps({**content, "markers": [{"time_s": 1.0, "name": "a"}] * 501})
    )
    with pytest.raises(InputError, match="at most 500 markers"):
        effects_file.read_effects(path)
