"""A sequence opens as written, and damage is named."""

import dataclasses
import json
import zipfile

import numpy as np
import pytest

from hapticplayer import motion, rendering, storage
from hapticplayer.errors import SequenceError
from hapticplayer.model import Sampling
from hapticplayer.motion.conditioning import average
from hapticplayer.sequence import arrays, editing, open_sequence, verify_sequence
from hapticplayer.sequence.arrays import read_arrays
from hapticplayer.sequence.build import write_sequence
from hapticplayer.sequence.store import read_recorded


def edit(folder, change):
    path = folder / "sequence.json"
    content = json.loads(path.read_text())
    change(content)
    path.write_text(json.dumps(content))


def test_a_written_sequence_comes_back(sequence_folder, recording):
    sequence = open_sequence(sequence_folder)
    track = motion.remove_gravity(recording.imu)
    assert sequence.title == "Ride"
    assert np.array_equal(sequence.motion.acceleration_mps2, track.acceleration_mps2)
    assert np.allclose(sequence.motion.time_s, recording.imu.time_s + 0.5)
    expected = rendering.render_force(sequence.motion)
    realistic = sequence.tracks["realistic"]
    assert np.array_equal(realistic.force_n, expected.force_n)
    assert list(sequence.tracks) == ["realistic", "none", "random"]
    assert not sequence.tracks["none"].force_n.any()
    assert np.allclose(sequence.tracks["random"].rms_n(), realistic.rms_n(), rtol=1e-4)
    assert sequence.mapping.gain_n_per_mps2 == 0.4
    verify_sequence(sequence_folder)


def test_its_provenance_documents_the_import(sequence_folder):
    made_of = open_sequence(sequence_folder).description.provenance
    assert made_of["gravity_removal"] == motion.DEFAULT_METHOD
    assert made_of["accelerometer_gain"] == pytest.approx(1 / 1.03, abs=1e-3)
    assert "still spans" in made_of["accelerometer_gain_from"]
    summary = made_of["motion_summary"]
    assert summary["accelerometer_gain"] == made_of["accelerometer_gain"]
    assert summary["leak_at_rest_mps2"] < 0.05
    assert made_of["processing"]["time_constant_s"] is None
    assert made_of["conditioning"] == []
    assert made_of["camera"] == "test camera"
    assert made_of["notes"] == ["a note"]


def test_the_same_seed_gives_the_same_random_track(tmp_path, tiny_clip, recording):
    from hapticplayer.sequence.build import Choices, write_sequence

    one, two = (
        open_sequence(
            write_sequence(tiny_clip, recording, tmp_path / n, choices=Choices(seed=9))
        )
        for n in "ab"
    )
    assert np.array_equal(one.tracks["random"].force_n, two.tracks["random"].force_n)


def test_the_recorded_samples_come_back_with_what_was_missing(
    tmp_path, tiny_clip, recording
):
    valid = np.ones(len(recording.imu), dtype=bool)
    valid[700:730] = False
    field = np.tile([20.0, 0.0, -40.0], (len(valid), 1))
    log = dataclasses.replace(recording.imu, valid=valid, magnetic_field_ut=field)
    log = dataclasses.replace(log, sampling=Sampling.AVERAGED)
    flawed = dataclasses.replace(recording, imu=log)
    folder = write_sequence(tiny_clip, flawed, tmp_path / "flawed")
    again, made_of = read_recorded(folder)
    for name in (
        "time_s",
        "specific_force_mps2",
        "angular_rate_radps",
        "magnetic_field_ut",
        "valid",
    ):
        assert np.array_equal(getattr(again, name), getattr(log, name)), name
    assert again.sampling is Sampling.AVERAGED
    assert made_of["camera"] == "test camera"
    assert not open_sequence(folder).motion.valid[700:730].any()
    assert "1.5 % of the motion is not valid" in " ".join(made_of["notes"])


def test_a_log_that_lacks_nothing_comes_back_without_marks(sequence_folder):
    imu, _ = read_recorded(sequence_folder)
    assert imu.valid is None
    assert imu.magnetic_field_ut is None


@pytest.fixture
def averaged_folder(tmp_path, tiny_clip, recording):
    log = average(recording.imu, 30.0)
    averaged = dataclasses.replace(recording, imu=log)
    return write_sequence(tiny_clip, averaged, tmp_path / "averaged")


def with_sampling(folder, sampling):
    """Write the motion again with another kind of samples."""
    path = folder / "motion.npz"
    with np.load(path) as arrays:
        kept = {name: arrays[name] for name in arrays.files if name != "sampling"}
    np.savez(path, **kept, sampling=sampling)
    entry = {"sha256": storage.sha256_of(path), "size_bytes": path.stat().st_size}
    edit(folder, lambda content: content["files"].update({"motion.npz": entry}))


def test_averaged_motion_keeps_its_kind_and_its_dense_track(averaged_folder):
    sequence = open_sequence(averaged_folder)
    assert sequence.motion.sampling is Sampling.AVERAGED
    stored = sequence.tracks["realistic"]
    assert stored.provenance["reconstruction"] == "integral-spline"
    assert len(stored.time_s) == 4 * (len(sequence.motion) - 1) + 1
    editing.set_mapping(averaged_folder, sequence.mapping)
    again = open_sequence(averaged_folder).tracks["realistic"]
    assert np.array_equal(again.force_n, stored.force_n)


def test_an_unknown_kind_of_samples_is_refused(averaged_folder):
    with_sampling(averaged_folder, "every other")
    with pytest.raises(SequenceError, match="every other"):
        open_sequence(averaged_folder)


@pytest.mark.parametrize("damage", ["flip", "remove"])
def test_damaged_samples_are_refused(sequence_folder, damage):
    path = sequence_folder / "imu.npz"
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 1
    path.unlink()
    if damage == "flip":
        path.write_bytes(content)
    with pytest.raises(SequenceError, match=r"imu.npz"):
        read_recorded(sequence_folder)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda c: c.update(schema="else"), "is not the description of a sequence"),
        (lambda c: c.update(version=99), "version 99"),
        (lambda c: c.pop("clip"), "missing entry 'clip'"),
        (lambda c: c.pop("title"), "missing entry 'title'"),
        (lambda c: c.update(feedbacks=[]), "feedbacks: must be an object"),
        (lambda c: c["clip"].update(file="../ride.mp4"), "not a plain file name"),
        (lambda c: c["clip"].update(file="/etc/passwd"), "not a plain file name"),
        (lambda c: c["clip"].update(file=7), "clip.file: must be a text"),
        (lambda c: c["feedbacks"]["random"].update(file=".."), "not a plain file name"),
        (lambda c: c["mapping"].update(gain_n_per_mps2=-1.0), "positive"),
        (lambda c: c["files"]["clip.mp4"].update(size_bytes=1), "instead of 1"),
    ],
)
def test_a_wrong_description_is_refused(sequence_folder, change, message):
    edit(sequence_folder, change)
    with pytest.raises(SequenceError, match=message):
        open_sequence(sequence_folder)


@pytest.mark.parametrize(
    "text", ["", "{", "[]", "7", '{"a": NaN}', '{"a": 1e999}', "[" * 100_000, "\xff"]
)
def test_a_description_that_is_no_json_is_refused(sequence_folder, text):
    (sequence_folder / "sequence.json").write_text(text, encoding="latin-1")
    with pytest.raises(SequenceError):
        open_sequence(sequence_folder)


@pytest.mark.parametrize("at", ["{", '"clip": {'])
def test_an_entry_that_is_there_twice_is_refused(sequence_folder, at):
    path = sequence_folder / "sequence.json"
    name = "title" if at == "{" else "file"
    text = path.read_text().replace(at, f'{at}"{name}": "other",', 1)
    path.write_text(text)
    assert json.loads(text)  # which keeps the last and says nothing
    with pytest.raises(SequenceError, match=f"duplicate entry '{name}'"):
        open_sequence(sequence_folder)


@pytest.mark.parametrize("name", ["motion.npz", "force_realistic.npz", "clip.mp4"])
def test_a_missing_file_is_named(sequence_folder, name):
    (sequence_folder / name).unlink()
    with pytest.raises(SequenceError, match=name):
        open_sequence(sequence_folder)


def test_every_flipped_byte_of_the_small_files_is_noticed(sequence_folder, rng):
    for name in ("motion.npz", "force_realistic.npz", "force_random.npz"):
        path = sequence_folder / name
        whole = path.read_bytes()
        for _ in range(10):
            damaged = bytearray(whole)
            damaged[int(rng.integers(len(whole)))] ^= 1 << int(rng.integers(8))
            path.write_bytes(damaged)
            with pytest.raises(SequenceError, match=r"changed|damaged"):
                open_sequence(sequence_folder)
        path.write_bytes(whole)
    open_sequence(sequence_folder)


def test_verifying_reads_the_clip_too(sequence_folder):
    clip = sequence_folder / "clip.mp4"
    content = bytearray(clip.read_bytes())
    content[-1] ^= 1
    clip.write_bytes(content)
    open_sequence(sequence_folder)
    with pytest.raises(SequenceError, match="changed"):
        verify_sequence(sequence_folder)


def test_pickled_objects_are_never_loaded(tmp_path):
    path = tmp_path / "bad.npz"
    np.savez(path, evil=np.array([{"a": 1}], dtype=object))
    with pytest.raises(SequenceError, match="damaged"):
        read_arrays(path)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("kind", [complex, "U8", "S8", "M8[s]", "m8[s]", "f4,f4"])
@pytest.mark.parametrize("field", ["time_s", "force_n"])
def test_force_that_is_not_of_real_numbers_is_refused(sequence_folder, kind, field):
    change_array(
        sequence_folder, "force_realistic", field, lambda a: np.zeros(a.shape, kind)
    )
    with pytest.raises(SequenceError, match=f"{field} must hold real numbers"):
        open_sequence(sequence_folder)


def change_array(folder, name, field, change):
    """Change an array of a file, so that its checksum is right."""
    path = folder / f"{name}.npz"
    with np.load(path) as held:
        made = {name: held[name] for name in held.files}
    made[field] = change(made[field])
    np.savez(path, **made)
    entry = {"sha256": storage.sha256_of(path), "size_bytes": path.stat().st_size}
    edit(folder, lambda content: content["files"].update({path.name: entry}))


@pytest.mark.parametrize(
    ("entry", "change"),
    [
        ("clock_map", {"offset_s": 1e300}),
        ("clock_map", {"rate": 1e300}),
        ("mapping", {"gain_n_per_mps2": [1e300] * 3}),
        ("mapping", {"force_limit_n": 1e30}),
        ("mapping", {"lever_arm_m": [1e300, 0.0, 0.0]}),
    ],
)
def test_described_numbers_beyond_reason_are_refused(sequence_folder, entry, change):
    edit(sequence_folder, lambda content: content[entry].update(change))
    with pytest.raises(SequenceError, match=r"must be at most|not a valid clock map"):
        open_sequence(sequence_folder)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(
    ("name", "field", "value", "said"),
    [
        ("force_realistic", "force_n", 1e38, "beyond any device"),
        ("force_realistic", "time_s", 1e300, "beyond any clip"),
        ("motion", "time_s", 1e300, "beyond any clip"),
        ("motion", "acceleration_mps2", 1e300, "beyond what sensors measure"),
    ],
)
def test_stored_numbers_beyond_reason_are_refused(
    sequence_folder, name, field, value, said
):
    def ending(array):
        array[-1] = value
        return array

    change_array(sequence_folder, name, field, ending)
    with pytest.raises(SequenceError, match=said):
        open_sequence(sequence_folder)


def test_an_archive_that_would_explode_is_not_unpacked(tmp_path, monkeypatch):
    monkeypatch.setattr(arrays, "MAX_ARRAYS_BYTES", 1 << 20)
    path = tmp_path / "bomb.npz"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("x.npy", bytes(2 << 20))
    with pytest.raises(SequenceError, match="too large"):
        read_arrays(path)
