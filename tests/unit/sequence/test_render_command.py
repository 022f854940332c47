"""The command `render`, and the same options at `import`."""

import json

import numpy as np
import pytest

from hapticplayer import cli, rendering
from hapticplayer.capture.recording import Recording
from hapticplayer.cli.importing import chosen_import
from hapticplayer.model import ClockMap, ImuLog, Mapping
from hapticplayer.sequence import open_sequence, store, verify_sequence
from hapticplayer.sequence.build import Choices, write_sequence
from hapticplayer.sequence.comparison import previewed_rendering
from hapticplayer.sequence.editing import set_mapping
from hapticplayer.sequence.excursion import predict
from hapticplayer.sequence.library import read_entry
from hapticplayer.sequence.store import read_recorded

ROTATION = "0.866,-0.5,0,0.5,0.866,0,0,0,1"


@pytest.fixture
def ride(swing):
    log, _ = swing
    return Recording(log, ClockMap(offset_s=-3.0), "test camera", (), {})


@pytest.fixture
def folder(tmp_path, tiny_clip, ride):
    choices = Choices(title="Ride", seed=5)
    return write_sequence(tiny_clip, ride, tmp_path / "ride", choices=choices)


def contents(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_a_copy_has_the_mapping_and_the_source_stays(folder, tmp_path, capsys):
    before, target = contents(folder), tmp_path / "other"
    words = ["--gain", "0.1,0.2,0.3", f"--axes={ROTATION}", "--soft-knee"]
    words += ["--lever-arm", "handlebar", "--json", "-o", str(target)]
    assert cli.main(["render", str(folder), *words]) == 0
    assert contents(folder) == before
    verify_sequence(target)
    old, new = open_sequence(folder), open_sequence(target)
    mapping = new.mapping
    assert mapping.gain_n_per_mps2 == (0.1, 0.2, 0.3)
    assert mapping.soft_knee_n == 2.0
    assert mapping.lever_arm_m == (0.0, 0.45, -0.25)
    # three digits were typed; the nearest rotation is stored
    first = np.array([0.866, -0.5, 0.0])
    np.testing.assert_allclose(
        mapping.axes[0], first / np.linalg.norm(first), atol=1e-12
    )
    printed = json.loads(capsys.readouterr().out)
    assert (
        printed["mapping"]
        == json.loads((target / "sequence.json").read_text())["mapping"]
    )
    imu, _ = read_recorded(folder)
    imu = ImuLog(imu.time_s - 3.0, imu.specific_force_mps2, imu.angular_rate_radps)
    expected = rendering.render_force(old.motion, mapping, imu)
    realistic, random = new.tracks["realistic"], new.tracks["random"]
    assert np.array_equal(realistic.force_n, expected.force_n)
    assert random.provenance["seed"] == 5
    np.testing.assert_allclose(random.rms_n(), realistic.rms_n(), rtol=1e-4)
    made_of = new.description.provenance
    assert made_of["rendering"]["gain_from"] == "given"
    assert realistic.provenance["gain_n_per_mps2"] == [0.1, 0.2, 0.3]
    entry = read_entry(target)
    assert not entry.problem
    assert entry.gain_n_per_mps2 is None


def test_options_that_are_not_given_stay_as_they_were(folder, capsys):
    before = open_sequence(folder)
    for words in (
        ["--gain", "0.2", "--soft-knee", "--lever-arm", "0,0,1", "--axes=y,z,x"],
        ["--no-soft-knee"],
        ["--gain", "0.4", "--lever-arm", "0,0,0", "--axes", "x,z,-y"],
    ):
        assert cli.main(["render", str(folder), "--in-place", *words]) == 0
        verify_sequence(folder)
    assert "gain 0.2 N per m/s^2, lever arm 0, 0, 1 m" in capsys.readouterr().out
    after = open_sequence(folder)
    for name, track in before.tracks.items():
        assert np.array_equal(after.tracks[name].force_n, track.force_n)
    assert after.description.mapping == before.description.mapping


def test_fit_is_offered_by_value_and_recorded(folder, tmp_path, capsys):
    p = open_sequence(folder).motion
    expected = rendering.fit_gain(p, Mapping(), 2.0)
    assert cli.main(["render", str(folder), "--gain", "0.3", "--in-place"]) == 0
    out = capsys.readouterr().out
    assert f"--gain fit: {expected:.4g}" in out
    target = tmp_path / "fit"
    assert cli.main(["render", str(folder), "--gain", "fit", "-o", str(target)]) == 0
    assert f"gain {expected:.4g} N per m/s^2 (fit)" in capsys.readouterr().out
    fitted = open_sequence(target)
    assert fitted.mapping.gain_n_per_mps2 == pytest.approx(expected)
    assert fitted.description.provenance["rendering"]["gain_from"] == "fit"


def test_a_new_sequence_is_balanced_unless_asked(tmp_path, tiny_clip, ride):
    presets = {}
    for name, choices in {"new": Choices(), "old": Choices(preset="faithful")}.items():
        made = write_sequence(tiny_clip, ride, tmp_path / name, choices=choices)
        presets[name] = open_sequence(made).tracks["realistic"].provenance["preset"]
    assert presets == {"new": "balanced", "old": "faithful"}
    words = ["import", "v.mp4", "-o", "x", "--preset", "equal"]
    options = cli.build_parser("import").parse_args(words)
    assert chosen_import(options).preset == "equal"


def test_an_import_takes_the_same_mapping(folder, ride, tiny_clip, tmp_path):
    choices = Choices(
        mapping=Mapping(lever_arm_m=(0.0, 0.0, 1.0)), fits_gain=True, seed=5
    )
    made = open_sequence(
        write_sequence(tiny_clip, ride, tmp_path / "made", choices=choices)
    )
    words = ["--gain", "fit", "--lever-arm", "0,0,1", "--in-place"]
    assert cli.main(["render", str(folder), *words]) == 0
    again = open_sequence(folder)
    assert again.mapping.gain_n_per_mps2 == made.mapping.gain_n_per_mps2
    for name, track in made.tracks.items():
        assert np.array_equal(again.tracks[name].force_n, track.force_n)


def test_a_preset_is_rendered_kept_and_taken_back(folder, tmp_path, capsys):
    before = open_sequence(folder).tracks["realistic"]
    target = tmp_path / "equal"
    words = ["--preset", "equal", "--gain", "1.6", "-o", str(target)]
    assert cli.main(["render", str(folder), *words]) == 0
    assert "preset equal" in capsys.readouterr().out
    verify_sequence(target)
    equal = open_sequence(target).tracks["realistic"]
    made = equal.provenance["washout"]
    assert (equal.provenance["preset"], made["reach_m"]) == ("equal", 0.022)
    assert [hand["yield_s"] for hand in made["hands"]] == [0.3, None]
    assert made["changed_share"] > 0.0
    reach = predict(equal, 2.0).hands["relaxed"].reach
    assert reach * 0.04 <= 0.022
    found = previewed_rendering(target, Mapping(gain_n_per_mps2=1.6))
    assert found.figures.reaches["relaxed"] == pytest.approx(reach)
    set_mapping(target, Mapping(gain_n_per_mps2=1.5))
    assert open_sequence(target).tracks["realistic"].provenance["preset"] == "equal"
    words = ["--preset", "faithful", "--gain", "0.4", "--in-place"]
    assert cli.main(["render", str(target), *words]) == 0
    faithful = open_sequence(target).tracks["realistic"]
    assert np.array_equal(faithful.force_n, before.force_n)


@pytest.mark.parametrize(
    ("words", "status", "said"),
    [
        (["--gain", "0,1,1"], 2, "--gain must be between 0.0001 and 100 N per m/s^2"),
        (["--gain", "1,1"], 2, "takes three numbers"),
        (["--gain", "best"], 2, "must be between"),
        (["--axes", "x,z,y"], 2, "mirror"),
        (["--axes", "x,z"], 2, "not three axes"),
        (["--axes", "1,1,0,0,1,0,0,0,1"], 2, "not a rotation"),
        (["--axes", "1,0,0,0,nan,0,0,0,1"], 2, "not a rotation"),
        (["--axes", "1,0,0,0,1,0,0,0,-1"], 2, "not a rotation"),
        (["--lever-arm", "0,0,11"], 2, "--lever-arm must be between -10 and 10 m"),
        (["--lever-arm", "knee"], 2, "takes three numbers"),
        (["--preset", "paper"], 2, "faithful"),
        ([], 1, "exists"),
    ],
)
def test_an_impossible_rendering_is_refused(folder, capsys, words, status, said):
    before = contents(folder)
    assert cli.main(["render", str(folder), *words, "-o", str(folder)]) == status
    assert said in capsys.readouterr().err
    assert contents(folder) == before


@pytest.mark.parametrize("name", ["clock_map", "provenance"])
@pytest.mark.parametrize("value", [None, "text", {"offset_s": "text"}])
def test_a_damaged_description_never_crashes(folder, capsys, name, value):
    path = folder / "sequence.json"
    content = json.loads(path.read_text())
    content[name] = value
    path.write_text(json.dumps(content))
    words = ["render", str(folder), "--in-place", "--lever-arm", "seat"]
    assert cli.main(words) == 1
    assert "import it again" in capsys.readouterr().err


def test_a_damaged_file_is_not_copied(folder, tmp_path, capsys):
    clip = open_sequence(folder).clip
    content = bytearray(clip.read_bytes())
    content[-1] ^= 1
    clip.write_bytes(content)
    target = tmp_path / "copy"
    assert cli.main(["render", str(folder), "-o", str(target)]) == 1
    assert "checksum differs" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["ride"]


def test_the_options_of_an_import_reach_its_choices():
    words = [
        "import",
        "ride.mp4",
        "-o",
        "ride",
        "--gain",
        "fit",
        "--axes=-x,y,-z",
        "--soft-knee",
    ]
    options = cli.build_parser("import").parse_args([*words, "--lever-arm=-1,0,2"])
    choices = chosen_import(options)
    assert choices.fits_gain
    assert choices.mapping.axes.tolist() == [[-1, 0, 0], [0, 1, 0], [0, 0, -1]]
    assert choices.mapping.soft_knee_n == 2.0
    assert choices.mapping.lever_arm_m == (-1.0, 0.0, 2.0)
    plain = chosen_import(cli.build_parser("import").parse_args(words[:4]))
    assert store.describe_mapping(plain.mapping) == store.describe_mapping(Mapping())
    assert not plain.fits_gain


@pytest.mark.parametrize("claimed_s", [0.5, 60.0])
def test_a_duration_that_a_description_claims_is_not_believed(
    folder, tmp_path, claimed_s
):
    right, wrong = tmp_path / "right", tmp_path / "wrong"
    assert cli.main(["render", str(folder), "--gain", "fit", "-o", str(right)]) == 0
    path = folder / "sequence.json"
    described = json.loads(path.read_text())
    true_s = described["clip"]["duration_s"]
    described["clip"]["duration_s"] = claimed_s
    path.write_text(json.dumps(described))
    assert open_sequence(folder).duration_s == pytest.approx(true_s, abs=1e-3)
    assert cli.main(["render", str(folder), "--gain", "fit", "-o", str(wrong)]) == 0
    made = [open_sequence(one).rendered for one in (right, wrong)]
    np.testing.assert_array_equal(made[0].time_s, made[1].time_s)
    np.testing.assert_allclose(made[0].force_n, made[1].force_n, atol=1e-6)
