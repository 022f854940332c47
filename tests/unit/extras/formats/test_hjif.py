"""hjif: what other software gets, and what is understood of its files."""

import json
import re

import numpy as np
import pytest

from hapticplayer import cli
from hapticplayer.errors import InputError
from hapticplayer.extras.formats import hjif, hjif_read
from hapticplayer.extras.formats.hjif_wavelet import block_height
from hapticplayer.model import ForceTrack
from hapticplayer.sequence.force_files import ReadChoices, WriteChoices

CHANNEL = {"id": 0, "description": "", "gain": 1.0, "mixing_coefficient": 1.0}
CHANNEL |= {"body_part_mask": 0}


def band(kind="Curve", effects=(), **more):
    one = {"band_type": kind, "lower_frequency_limit": 0}
    return {**one, "upper_frequency_limit": 300, "effects": list(effects), **more}


def effect(*frames, position=0, **more):
    names = ("relative_position", "amplitude_modulation", "frequency_modulation")
    keys = [
        {n: v for n, v in zip(names, f, strict=False) if v is not None} for f in frames
    ]
    return {"effect_type": "Basis", "position": position, "keyframes": keys, **more}


def content(*bands, modality="Force", library=(), device=True, timescale=1000, **more):
    devices = [{"id": 0, "name": "arm", "maximum_amplitude": 4.0}] if device else []
    perception = {"id": 0, "avatar_id": 0, "description": ""}
    perception |= {"perception_modality": modality, "reference_devices": devices}
    perception |= {"effect_library": list(library)}
    perception |= {"channels": [{**CHANNEL, **more, "bands": list(bands)}]}
    root = {"version": "2023", "profile": "Main", "level": 1, "date": "2026-11-25"}
    root |= {"description": "", "timescale": timescale, "avatars": [], "syncs": []}
    return {**root, "perceptions": [perception]}


@pytest.fixture
def read(tmp_path):
    def reader(made, choices=None):
        path = tmp_path / "other.hjif"
        path.write_text(json.dumps(made))
        return hjif_read.read(path, choices or ReadChoices())

    return reader


def at(track, *ms):
    return track.at(np.array(ms) / 1000.0)


STREAM = "x+2AI3Pgv1bYf71JUH4cDK6JQABdbpC/4Bz6gmgylI8qWfeuiABb2CX+to51Paicrk9VecfkTK1gJguez/gw"
THIRD = (
    "L+4AMAYyXRO68wq1TeWW6PLyAAut5ujl/vhvWKCfYdZvjTK3e7AAFH2RryIOQ7SGD/5E5TIj6Xil5AAD"
    "k/9YsAAAEaw"
)
UP = {"direction": {"X": 0, "Y": 127, "Z": 0}}


def test_a_curve_is_in_newtons_of_the_reference_device(read):
    found = read(
        content(band(effects=[effect((0, 0.0), (100, 0.5), (200, 0.5))]), **UP)
    )
    assert found.notes == ()
    values = at(found.track, 0, 50, 100, 150, 200, 250)
    np.testing.assert_allclose(values[:, 1], [0, 1, 2, 2, 2, 0], atol=1e-5)
    assert not values[:, [0, 2]].any()


def test_the_gain_scales_and_the_direction_turns(read):
    way = {"X": 90, "Y": 0, "Z": -90}
    found = read(
        content(band(effects=[effect((0, 1.0), (9, 1.0))]), gain=0.5, direction=way)
    )
    side = 2.0 / np.sqrt(2.0)
    np.testing.assert_allclose(at(found.track, 5)[0], [side, 0, -side], atol=1e-5)


def test_an_effect_ends_where_the_next_begins(read):
    two = [effect((0, 1.0), (100, 1.0)), effect((0, -0.5), (20, -0.5), position=50)]
    found = read(content(band(effects=two), **UP))
    values = at(found.track, 49, 50, 60, 80)[:, 1]
    np.testing.assert_allclose(values, [4, -2, -2, 0], atol=1e-5)


def test_a_cubic_curve_is_level_at_its_keyframes(read):
    found = read(
        content(band(effects=[effect((0, 0.0), (100, 1.0))], curve_type="Cubic"), **UP)
    )
    values = at(found.track, 25, 50, 75)[:, 1]
    np.testing.assert_allclose(values, [0.625, 2.0, 3.375], atol=1e-5)


def test_a_reference_effect_is_taken_from_the_library(read):
    library = [{**effect((0, 0.25), (40, 0.25)), "id": 7}]
    use = {"effect_type": "Reference", "id": 7, "position": 1000}
    found = read(content(band(effects=[use]), library=library, **UP))
    np.testing.assert_allclose(at(found.track, 990, 1010)[:, 1], [0, 1], atol=1e-5)


def test_a_transient_is_two_periods_in_22_ms(read):
    found = read(content(band("Transient", [effect((0, 0.5), position=100)]), **UP))
    values = at(found.track, 99, 103, 111, 114, 123)[:, 1]
    expected = 2.0 * np.sin(4.0 * np.pi * np.array([0, 3, 11, 14, 22]) / 22.0)
    np.testing.assert_allclose(values, expected, atol=1e-4)


def test_a_vectorial_wave_has_its_frequency_and_amplitude(read):
    wave = effect((0, 0.5, 50), (1000, 0.5, 50))
    found = read(content(band("VectorialWave", [wave]), **UP))
    ms = np.arange(0, 1000)
    expected = 2.0 * np.sin(2.0 * np.pi * 50.0 * ms / 1000.0)
    np.testing.assert_allclose(at(found.track, *ms)[:, 1], expected, atol=1e-4)


def test_a_chirp_runs_through_its_frequencies(read):
    wave = effect((0, 1.0, 10), (2000, 1.0, 30))
    found = read(content(band("VectorialWave", [wave]), **UP))
    values = at(found.track, *range(2000))[:, 1]
    rises = np.flatnonzero((values[:-1] < 0) & (values[1:] >= 0))
    assert len(rises) == 39  # 40 periods: the mean of 10 and 30 Hz for 2 s
    assert rises[1] - rises[0] > 2 * (rises[-1] - rises[-2])


def test_vibration_takes_full_scale_and_direction_from_the_user(read):
    choices = ReadChoices(full_scale_n=2.0, direction=(0.0, 0.0, 1.0))
    made = content(band(effects=[effect((0, 1.0), (9, 1.0))]), modality="Vibrotactile")
    found = read(made, choices)
    np.testing.assert_allclose(at(found.track, 5)[0], [0, 0, 2], atol=1e-5)
    assert len(found.notes) == 2


def test_a_wavelet_block_is_an_envelope(read):
    # written by the reference encoder for a sine of 200 Hz and amplitude 0.5
    block = {"effect_type": "Basis", "position": 0, "wavelet_stream": STREAM}
    wavelet = band("WaveletWave", [block], block_length=128)
    wavelet["upper_frequency_limit"] = 8000
    found = read(content(wavelet, **UP))
    force_n = found.track.force_n[:, 1]
    assert np.abs(force_n).max() == pytest.approx(0.5 * 4.0, rel=0.1)
    assert any("envelope" in note for note in found.assumed)
    (note,) = found.unread
    assert str(note) == "not read: course of wavelets within their blocks (1)"


def test_a_curve_of_an_unknown_type_is_the_cubic(read):
    frames = effect((0, 0.0), (100, 1.0), (200, 0.0))
    wanted = read(content(band(effects=[frames], curve_type="Cubic"), **UP))
    for more in ({"curve_type": "Unknown"}, {"curve_type": ""}, {}):
        found = read(content(band(effects=[frames], **more), **UP))
        assert found.notes == ()
        np.testing.assert_array_equal(found.track.force_n, wanted.track.force_n)


@pytest.mark.parametrize("kind", ["Bezier", "Spline"])
def test_a_curve_that_becomes_lines_is_named(read, kind):
    lines = effect((0, 0.0), (100, 1.0))
    found = read(content(band(effects=[lines], curve_type=kind), **UP))
    assert found.track.at(np.array([0.025]))[0, 1] == pytest.approx(1.0, abs=1e-5)
    assert f"{kind}" in str(found.assumed[0])


def test_a_base_signal_of_no_name_is_said(read):
    wave = effect((0, 1.0, 9), (99, 1.0, 9), base_signal="Wobble")
    found = read(content(band("VectorialWave", [wave]), **UP))
    assert "'Wobble' was read as a sine" in str(found.assumed[0])


@pytest.mark.parametrize("kind", ["Linear", "Cubic", "Akima"])
def test_two_keyframes_at_one_time_are_a_step(read, kind):
    keys = effect((0, 1.0), (500, 1.0), (500, 0.25), (1000, 0.25))
    found = read(content(band(effects=[keys], curve_type=kind), **UP))
    values = at(found.track, 1, 499, 501, 750, 999)[:, 1]
    np.testing.assert_allclose(values, [4, 4, 1, 1, 1], atol=1e-4)


def test_of_many_keyframes_at_one_time_the_ends_count(read):
    keys = effect((0, 0.5), (9, 0.5), (9, 1.0), (9, -1.0), (9, 0.0), (20, 0.0))
    found = read(content(band(effects=[keys], curve_type="Linear"), **UP))
    values = at(found.track, 5, 8, 10, 15)[:, 1]
    np.testing.assert_allclose(values, [2, 2, 0, 0], atol=1e-4)
    assert np.abs(found.track.force_n).max() <= 2.0


def test_a_keyframe_without_a_position_is_listed(read):
    keys = effect((0, 1.0), (None, 0.0), (20, 1.0))
    found = read(content(band(effects=[keys]), **UP))
    assert at(found.track, 0, 10)[:, 1] == pytest.approx([4.0, 4.0])
    assert str(found.unread[0]) == "not read: keyframe without a position (1)"


@pytest.mark.parametrize("kind", ["Curve", "Transient"])
def test_a_keyframe_without_an_amplitude_is_listed(read, kind):
    made = effect((0, 1.0), (100, None), (200, 1.0))
    (note,) = read(content(band(kind, [made]), **UP)).unread
    assert str(note) == "not read: keyframe without an amplitude (1)"


def test_channels_for_parts_of_the_body_are_said_to_be_one(read):
    made = content(band(effects=[effect((0, 0.25), (9, 0.25))]), **UP)
    (channel,) = made["perceptions"][0]["channels"]
    made["perceptions"][0]["channels"].append({**channel, "body_part_mask": 64})
    found = read(made)
    assert at(found.track, 5)[0, 1] == pytest.approx(2.0)
    assert "2 parts of the body act on one hand" in str(found.assumed[-1])


def test_an_effect_that_begins_before_the_clip_is_cut(read):
    line = effect((0, 0.0), (400, 1.0), position=-100)
    found = read(content(band(effects=[line], curve_type="Linear"), **UP))
    values = at(found.track, 0, 100, 200, 299)[:, 1]
    np.testing.assert_allclose(values, [1, 2, 3, 3.99], atol=1e-4)
    assert "before 0 s" in str(found.unread[0])


def test_an_effect_that_begins_at_zero_is_whole(read):
    found = read(content(band(effects=[effect((0, 1.0), (9, 1.0))]), **UP))
    assert found.unread == ()
    assert at(found.track, 0)[0, 1] == pytest.approx(4.0)


def test_a_file_that_ends_before_the_clip_is_refused(read):
    early = effect((0, 1.0), (9, 1.0), position=-500)
    with pytest.raises(InputError, match="ends before 0 s"):
        read(content(band(effects=[early]), **UP))


def test_a_keyframe_before_the_clip_is_cut_there(read):
    line = effect((-100, 0.5), (1000, 1.0))
    found = read(content(band(effects=[line], curve_type="Linear")))
    assert at(found.track, 0)[0, 1] == pytest.approx(4.0 * (0.5 + 0.5 / 11.0), abs=1e-5)


@pytest.mark.parametrize(
    ("made", "said"),
    [
        ({"mixing_coefficient": 0.5}, r"not read: mixing_coefficient \(1\)"),
        ({"gain": 1.0, "height": 2.0}, "amplitudes beyond 1 were limited"),
        ({"devices": 2}, "of 2 reference devices the first was taken"),
    ],
)
def test_an_entry_that_changes_the_force_is_said(read, made, said):
    made = dict(made)
    height, devices = made.pop("height", 1.0), made.pop("devices", 1)
    one = content(band(effects=[effect((0, 0.0), (1000, height))]), **made)
    one["perceptions"][0]["reference_devices"] *= devices
    for number, device in enumerate(one["perceptions"][0]["reference_devices"]):
        one["perceptions"][0]["reference_devices"][number] = {**device, "id": number}
    assert re.search(said, " ".join(map(str, read(one).notes)))


def test_a_direction_of_no_length_is_the_chosen_one(read):
    made = content(
        band(effects=[effect((0, 1.0), (9, 1.0))]), direction={"X": 0, "Y": 0, "Z": 0}
    )
    found = read(made, ReadChoices(direction=(0.0, 0.0, 1.0)))
    np.testing.assert_allclose(at(found.track, 5)[0], [0, 0, 4], atol=1e-5)
    assert "length 0" in str(found.assumed[0])


def test_a_device_that_is_not_there_is_said(read):
    made = content(band(effects=[effect((0, 1.0), (9, 1.0))]), **UP)
    made["perceptions"][0]["channels"][0]["reference_device_id"] = 7
    assert "reference device 7 is not" in str(read(made).assumed[0])


OTHER = content(band(effects=[effect((0, 1.0), (9, 1.0))]), modality="Other")


@pytest.mark.parametrize(("meant", "largest_n"), [("force", 4.0), ("vibration", 1.0)])
def test_other_is_what_the_user_says(read, meant, largest_n):
    found = read(OTHER, ReadChoices(other_is=meant))
    np.testing.assert_allclose(at(found.track, 5)[0], [0, largest_n, 0], atol=1e-5)
    assert "Other was taken as" in str(found.assumed[0])


def test_other_is_refused_with_the_option_that_reads_it(tmp_path, capsys):
    path = tmp_path / "coded.hjif"
    path.write_text(json.dumps(OTHER))
    assert cli.main(["convert", str(path), str(tmp_path / "a.csv")]) == 1
    said = capsys.readouterr().err
    words = re.search(r"(--other-is force), (--other-is vibration)", said)
    for number, option in enumerate(words.groups()):
        target = str(tmp_path / f"{number}.csv")
        assert cli.main(["convert", str(path), target, *option.split()]) == 0


@pytest.mark.parametrize("length", range(30))
def test_a_block_of_any_length_is_read(read, length):
    block = {"effect_type": "Basis", "position": 0, "wavelet_stream": STREAM[:length]}
    wavelet = band("WaveletWave", [block], block_length=128)
    assert read(content(wavelet, **UP)).track.end_s == pytest.approx(0.128, abs=1e-5)


def test_a_block_with_other_characters_is_refused(read):
    block = {"effect_type": "Basis", "position": 0, "wavelet_stream": "x+2?I3Pg"}
    with pytest.raises(InputError, match=r"channels\[0\]: the wavelet .* not base64"):
        read(content(band("WaveletWave", [block], block_length=128), **UP))


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('"gain": 1.0', '"gain": "1,5"', r"channels\[0\].gain: must be a number"),
        ('"gain": 1.0', '"gain": [1]', "gain: must be a number"),
        ('"gain": 1.0', '"gain": 1' + 400 * "0", "valid JSON|out of range"),
        ('"gain": 1.0', '"gain": Infinity', "not valid JSON"),
        ('"gain": 1.0', '"gain": 1e400', "not valid JSON"),
        ('"gain": 1.0', '"gain": true', "gain: must be a number"),
        ('"timescale": 1000', '"timescale": 0', "timescale: must be at least 1"),
        ('"position": 0', '"position": 1e13', "position: must be at most"),
        ('"channels": [', '"channels": [3, ', r"channels\[0\]: must be an object"),
    ],
)
def test_a_wrong_entry_is_named(tmp_path, old, new, says):
    path = tmp_path / "wrong.hjif"
    text = json.dumps(content(band(effects=[effect((0, 1.0), (9, 1.0))]), **UP))
    assert old in text
    path.write_text(text.replace(old, new, 1))
    with pytest.raises(InputError, match=says):
        hjif_read.read(path, ReadChoices())


@pytest.mark.parametrize(("stream", "height"), [(STREAM, 2.625), (THIRD, 2.5)])
def test_the_height_of_a_block_is_that_of_the_reference(stream, height):
    assert block_height(stream) == height  # printed by the reference decoder


def test_null_and_numbers_in_quotes_are_read(read):
    made = content(band(effects=[effect((0, 1.0), (100, 1.0))]), **UP)
    plain = read(made)
    perception = made["perceptions"][0]
    perception |= {"effect_library": None, "perception_unit_exponent": None}
    perception["channels"][0] |= {"gain": None, "body_part_mask": "0"}
    perception["channels"][0]["bands"][0]["effects"][0] |= {"phase": None}
    made |= {"timescale": "1000"}
    found = read(made)
    np.testing.assert_array_equal(found.track.force_n, plain.track.force_n)
    assert found.notes == plain.notes


def test_unknown_parts_of_a_file_are_listed(read):
    made = content(band(effects=[effect((0, 1.0), (9, 1.0))]), **UP)
    made["perceptions"].append(
        {**made["perceptions"][0], "perception_modality": "Wind"}
    )
    made["perceptions"][0]["channels"][0]["bands"][0]["effects"].append(
        {"effect_type": "Composite", "position": 5}
    )
    notes = [str(note) for note in read(made).notes]
    assert notes == [
        "not read: effect Composite (1)",
        "not read: perception Wind (1)",
    ]


def test_a_file_with_nothing_to_feel_is_refused(read):
    with pytest.raises(InputError, match="perception Temperature"):
        read(content(band(), modality="Temperature"))


def test_a_written_file_has_what_the_reference_loader_needs(tmp_path, rng):
    path = tmp_path / "own.hjif"
    track = ForceTrack(np.arange(200) / 50.0, rng.normal(0, 1, (200, 3)))
    with path.open("xb") as out:
        hjif.write(track, out, WriteChoices())
    made = json.loads(path.read_text())
    (perception,) = made["perceptions"]
    channel = perception["channels"][0]
    assert made.keys() >= {"version", "profile", "level", "date", "timescale", "syncs"}
    assert perception.keys() >= {"id", "avatar_id", "perception_modality"}
    assert channel.keys() >= {"gain", "mixing_coefficient", "body_part_mask", "bands"}
    assert type(channel["bands"][0]["upper_frequency_limit"]) is int
    assert hjif.is_ours(path.read_bytes()[:400])


def test_an_entry_that_is_not_read_is_listed(read):
    lines = effect((0, 1.0), (9, 1.0), semantic="rain")
    lines["keyframes"][0]["ease"] = "in"
    made = content(band(effects=[lines], window=3, **LINEAR), vertices=[], **UP)
    made["syncs"] = [{"timestamp": 500}]
    (perception,) = made["perceptions"]
    perception["unit_exponent"] = -6
    perception["reference_devices"][0] |= {"weight": 3.0, "impedance": 2}
    names = sorted(str(note) for note in read(made).unread)
    wanted = [f"not read: {n} (1)" for n in ("ease", "syncs", "unit_exponent")]
    assert names == [*wanted, "not read: window (1)"]


LINEAR = {"curve_type": "Linear"}


@pytest.mark.parametrize("more", [{}, {"keyframes": None}, {"keyframes": []}])
def test_an_effect_without_keyframes_is_listed(read, more):
    empty = {"effect_type": "Basis", "position": 50, **more}
    found = read(content(band(effects=[effect((0, 1.0), (9, 1.0)), empty]), **UP))
    assert [str(note) for note in found.unread] == [
        "not read: effect without keyframes (1)"
    ]
