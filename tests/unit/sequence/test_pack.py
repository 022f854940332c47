"""A sequence in one file, or beside an MP4, comes back as it was."""

import hashlib
import io
import json
import shutil
import subprocess

import numpy as np
import pytest
from msgspec import structs

from hapticplayer import cli
from hapticplayer.errors import Cancelled, HapticPlayerError, InputError, UsageError
from hapticplayer.media.clip_info import probe
from hapticplayer.media.matroska import Attachment, read_attachments
from hapticplayer.media.remux import MATROSKA, Additions, remux, video_payload
from hapticplayer.model import ForceTrack, Mapping
from hapticplayer.sequence import editing, open_sequence, verify_sequence
from hapticplayer.sequence.contents import contents, contents_of
from hapticplayer.sequence.force_import import export_force
from hapticplayer.sequence.library import read_entry
from hapticplayer.sequence.pack import pack
from hapticplayer.sequence.packed import MANIFEST, read_packed
from hapticplayer.sequence.store import read_recorded, recorded_log
from hapticplayer.sequence.unpack import unpack

FORCES = ("force_realistic.npz", "force_random.npz")


@pytest.fixture(scope="module", autouse=True)
def _own_cache(tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        yield


@pytest.fixture(params=["ride.mkv", "ride.mp4"])
def packed_file(request, sequence_folder, tmp_path):
    target = tmp_path / request.param
    pack(sequence_folder, target, with_motion=True, with_places=True)
    return target


def test_force_and_motion_are_read_without_unpacking(packed_file, sequence_folder):
    whole, packed = open_sequence(sequence_folder), read_packed(packed_file)
    for clip in (whole.clip, packed_file):
        assert packed.payload.difference(video_payload(clip)) is None
    assert packed.sequence.title == "Ride"
    assert list(packed.sequence.tracks) == ["realistic", "none", "random"]
    for name, track in whole.tracks.items():
        again = packed.sequence.tracks[name]
        assert np.array_equal(again.force_n, track.force_n)
        assert np.array_equal(again.time_s, track.time_s)
        assert again.provenance == track.provenance
    motion = packed.sequence.motion.acceleration_mps2
    assert np.array_equal(motion, whole.motion.acceleration_mps2)


def test_the_folder_comes_back_bit_for_bit(packed_file, sequence_folder, tmp_path):
    unpack(packed_file, tmp_path / "again")
    verify_sequence(tmp_path / "again")
    for name in (*FORCES, "motion.npz", "imu.npz"):
        before = (sequence_folder / name).read_bytes()
        assert (tmp_path / "again" / name).read_bytes() == before
    again = open_sequence(tmp_path / "again")
    assert video_payload(again.clip).difference(video_payload(packed_file)) is None
    before = open_sequence(sequence_folder).description
    kept = structs.replace(again.description, clip=before.clip, files=before.files)
    assert kept == before


def test_motion_is_shared_only_when_asked_for(sequence_folder, tmp_path):
    pack(sequence_folder, tmp_path / "ride.mkv")
    packed = read_packed(tmp_path / "ride.mkv")
    assert packed.sequence.motion is None
    assert set(packed.attached) == {MANIFEST, "sequence.json", *FORCES}
    unpack(tmp_path / "ride.mkv", tmp_path / "again")
    verify_sequence(tmp_path / "again")
    with pytest.raises(HapticPlayerError, match="shared without its motion"):
        editing.set_mapping(tmp_path / "again", Mapping())


def test_the_mp4_names_its_side_car_and_plays_alone(sequence_folder, tmp_path):
    pack(sequence_folder, tmp_path / "ride.mp4")
    assert probe(tmp_path / "ride.mp4").names_force
    assert read_packed(tmp_path / "ride.mp4").carrier == tmp_path / "ride.haptics.mkv"
    with pytest.raises(InputError, match="holds the force of a video, not the video"):
        read_packed(tmp_path / "ride.haptics.mkv")
    (tmp_path / "ride.haptics.mkv").unlink()
    assert read_packed(tmp_path / "ride.mp4") is None


def test_an_added_track_is_listed_by_its_name(sequence_folder):
    track = ForceTrack([0.0, 0.5], np.ones((2, 3)))
    editing.add_track(sequence_folder, "bump", lambda _duration_s: track)
    texts = [str(part.text) for part in contents(sequence_folder).attached]
    assert "force of the feedback bump, lossless" in texts
    assert len(set(texts)) == len(texts)  # each part says what it is


def test_the_listing_says_what_is_written(sequence_folder, tmp_path):
    note = Attachment("realistic.hjif", "haptics/hjif", b"{}")
    before = contents(sequence_folder, with_motion=True, extras=[note])
    assert not list(tmp_path.glob("*.mkv"))
    target = tmp_path / "ride.mkv"
    pack(sequence_folder, target, with_motion=True, extras=[note])
    after = contents_of(read_packed(target))
    assert {*after.attached} - {*before.attached} == {after.attached[0]}
    assert after.attached[0].name == MANIFEST
    assert before.attached[-1] == (*note[:1], "force for other programs", note[1], 2)
    assert before.size_bytes == pytest.approx(target.stat().st_size, rel=0.05)


def test_another_video_is_refused_unless_it_is_accepted(sequence_folder, tmp_path):
    target, other = tmp_path / "ride.mkv", tmp_path / "other.mkv"
    pack(sequence_folder, target)
    attached = tuple(read_attachments(target, MANIFEST))
    remux(changed_clip(sequence_folder, tmp_path), other, MATROSKA, Additions(attached))
    with pytest.raises(InputError, match="not the one that the force was made for"):
        unpack(other, tmp_path / "again")
    assert not (tmp_path / "again").exists()
    unpack(other, tmp_path / "again", accepts_changed=True)
    verify_sequence(tmp_path / "again")


def changed_clip(sequence_folder, tmp_path):
    content = bytearray((sequence_folder / "clip.mp4").read_bytes())
    content[content.index(b"mdat") + 900] ^= 1
    (tmp_path / "changed.mp4").write_bytes(content)
    return tmp_path / "changed.mp4"


def test_a_clip_that_has_changed_is_not_shared(sequence_folder, tmp_path):
    shutil.copy(changed_clip(sequence_folder, tmp_path), sequence_folder / "clip.mp4")
    with pytest.raises(InputError, match=r"clip.mp4.*has changed"):
        pack(sequence_folder, tmp_path / "ride.mkv")
    assert not list(tmp_path.glob("*.mkv"))


@pytest.mark.parametrize("name", ["ride.mkv", "ride.mp4"])
def test_a_cancelled_pack_leaves_no_file(sequence_folder, tmp_path, name):
    def stop(fraction, _step):
        if fraction > 0.8:
            raise Cancelled

    before = set(tmp_path.iterdir())
    with pytest.raises(Cancelled):
        pack(sequence_folder, tmp_path / name, progress=stop)
    assert set(tmp_path.iterdir()) == before


@pytest.mark.parametrize("name", ["ride", "ride.avi", "ride.haptics.mkv"])
def test_other_endings_are_refused(sequence_folder, tmp_path, name):
    with pytest.raises(UsageError, match=r"must end with .mkv .* or .mp4"):
        pack(sequence_folder, tmp_path / name)


# --- what others may have put in ---------------------------------------------------


def with_attached(carrier, attached, tmp_path):
    target = tmp_path / "made.mkv"
    remux(carrier, target, MATROSKA, Additions(tuple(attached)))
    return target


def edited(one, change):
    content = json.loads(one.content)
    change(content)
    return one._replace(content=json.dumps(content).encode())


def signed(attached):
    """Return the files with a manifest that agrees with them, as anybody can write."""
    named = {one.name: one for one in attached}
    manifest = json.loads(named[MANIFEST].content)
    for name, entry in manifest["files"].items():
        entry["size_bytes"] = len(named[name].content)
        entry["sha256"] = hashlib.sha256(named[name].content).hexdigest()
    named[MANIFEST] = named[MANIFEST]._replace(content=json.dumps(manifest).encode())
    return list(named.values())


@pytest.mark.parametrize(
    ("name", "change", "says"),
    [
        (MANIFEST, lambda c: c.update(version=9), "has version 9"),
        (MANIFEST, lambda c: c.update(schema="x\x1b[2J"), "is not a manifest"),
        (MANIFEST, lambda c: c.pop("video"), "missing entry 'video'"),
        (MANIFEST, lambda c: c.update(files=3), "files: must be an object"),
        (
            MANIFEST,
            lambda c: c["video"].update(packets="many"),
            "video.packets: must be a",
        ),
        (MANIFEST, lambda c: c["files"].pop("sequence.json"), "is missing"),
        ("sequence.json", lambda c: c.update(title="other"), "has changed"),
    ],
)
def test_a_wrong_manifest_is_refused(sequence_folder, tmp_path, name, change, says):
    pack(sequence_folder, tmp_path / "ride.mkv")
    attached = read_attachments(tmp_path / "ride.mkv", MANIFEST)
    made = [edited(a, change) if a.name == name else a for a in attached]
    with pytest.raises(InputError, match=says):
        read_packed(with_attached(sequence_folder / "clip.mp4", made, tmp_path))


def outside(content):
    content["files"]["../../evil.txt"] = content["files"]["force_random.npz"]


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (outside, "not a plain file name"),
        (lambda c: c.update(files=[]), "files: must be an object"),
        (lambda c: c["clip"].update(duration_s="long"), "clip.duration_s: must be"),
        (lambda c: c["feedbacks"]["random"].update(file="imu.npz"), "is missing"),
    ],
)
def test_a_wrong_description_is_refused(sequence_folder, tmp_path, change, says):
    pack(sequence_folder, tmp_path / "ride.mkv")
    made = [
        edited(a, change) if a.name == "sequence.json" else a
        for a in read_attachments(tmp_path / "ride.mkv", MANIFEST)
    ]
    evil = made[-1]._replace(name="../../evil.txt")
    made = signed([*made, evil])
    target = with_attached(sequence_folder / "clip.mp4", made, tmp_path)
    with pytest.raises(InputError, match=says):
        unpack(target, tmp_path / "again")
    assert not (tmp_path / "again").exists()
    assert not (tmp_path.parent / "evil.txt").exists()


def test_pickled_forces_are_never_loaded(sequence_folder, tmp_path):
    pack(sequence_folder, tmp_path / "ride.mkv")
    bad = io.BytesIO()
    np.savez(bad, time_s=np.array([{"a": 1}], dtype=object))
    attached = read_attachments(tmp_path / "ride.mkv", MANIFEST)
    made = [
        a._replace(content=bad.getvalue()) if a.name == FORCES[0] else a
        for a in attached
    ]
    description = next(a for a in made if a.name == "sequence.json")

    def agree(content):
        content["files"][FORCES[0]] = {
            "sha256": hashlib.sha256(bad.getvalue()).hexdigest(),
            "size_bytes": len(bad.getvalue()),
        }

    made[made.index(description)] = edited(description, agree)
    target = with_attached(sequence_folder / "clip.mp4", signed(made), tmp_path)
    with pytest.raises(InputError, match="damaged"):
        read_packed(target)


def test_arrays_that_are_too_large_together_are_refused(
    sequence_folder, tmp_path, monkeypatch
):
    pack(sequence_folder, tmp_path / "ride.mkv")
    tracks = read_packed(tmp_path / "ride.mkv").sequence.tracks
    kept = [tracks[name] for name in ("realistic", "random")]
    both = sum(one.time_s.nbytes + one.force_n.nbytes for one in kept)
    monkeypatch.setattr("hapticplayer.sequence.packed.MAX_ATTACHED_BYTES", both - 1000)
    with pytest.raises(InputError, match=r"force_\w+\.npz: is too large"):
        read_packed(tmp_path / "ride.mkv")


def test_names_dates_and_numbers_stay_here_unless_asked_for(
    sequence_folder, tmp_path, capsys
):
    path = sequence_folder / "sequence.json"
    made = json.loads(path.read_text())
    told = {"video": "Anna Elm Street.mp4", "motion_source": "Elm Street 5"}
    made["provenance"] |= {**told, "note": "Anna Elm Street.mp4, line 3"}
    made["provenance"] |= {"created_utc": "2026-05-01T10", "camera_serial": 83441}
    made["provenance"] |= {"text": "Elm Street 5/accel.csv {Elm}", "word": "Elm"}
    made["feedbacks"]["Anna"] = {**made["feedbacks"]["random"]}
    made["feedbacks"]["Anna"]["provenance"] = {"source": "Anna.csv"}
    path.write_text(json.dumps({**made, "title": "Anna Elm Street"}))
    secret = (b"Anna", b"2026-05-01", b"83441", b"Elm Street")
    words = ["pack", str(sequence_folder), "--with-motion"]
    assert cli.main([*words, "-o", str(tmp_path / "a.mkv"), "--dry-run"]) == 0
    said = capsys.readouterr().out
    assert "left out, see --with-places: name of a file Anna Elm Street.mp4" in said
    assert all(word.decode() in said for word in secret)
    for name in ("a.mkv", "a.mp4"):
        assert cli.main([*words, "-o", str(tmp_path / name)]) == 0
        for one in tmp_path.glob("a.*"):
            assert not [word for word in secret if word in one.read_bytes()]
    unpack(tmp_path / "a.mkv", tmp_path / "again")
    verify_sequence(tmp_path / "again")
    again = open_sequence(tmp_path / "again")
    assert "imported 1" in again.tracks
    assert again.description.provenance["text"] == "file/accel.csv {Elm}"
    assert again.description.provenance["word"] == "Elm"
    assert not read_entry(tmp_path / "again").problem
    read_recorded(tmp_path / "again")
    assert cli.main([*words, "-o", str(tmp_path / "b.mkv"), "--with-places"]) == 0
    assert "included: date 2026-05-01T10" in capsys.readouterr().out
    content = (tmp_path / "b.mkv").read_bytes()
    assert all(word in content for word in secret)


def test_a_clock_that_shows_the_date_stays_here(sequence_folder, tmp_path, capsys):
    path, log = sequence_folder / "sequence.json", sequence_folder / "imu.npz"
    before = recorded_log(open_sequence(sequence_folder))
    made, arrays = json.loads(path.read_text()), dict(np.load(log))
    np.savez(log, **{**arrays, "time_s": arrays["time_s"] + 1.7e9})
    made["clock_map"]["offset_s"] -= 1.7e9 * made["clock_map"]["rate"]
    made["files"]["imu.npz"] = {
        "size_bytes": log.stat().st_size,
        "sha256": hashlib.sha256(log.read_bytes()).hexdigest(),
    }
    path.write_text(json.dumps(made))
    words = ["pack", str(sequence_folder), "--with-motion", "-o"]
    assert cli.main([*words, str(tmp_path / "a.mkv")]) == 0
    assert "left out, see --with-places: date 2023-11-14T22:13" in (
        capsys.readouterr().out
    )
    unpack(tmp_path / "a.mkv", tmp_path / "again")
    again = open_sequence(tmp_path / "again")
    assert abs(again.description.clock_map.offset_s) < 1.0
    after = recorded_log(again)
    np.testing.assert_allclose(after.time_s, before.time_s, atol=1e-6)


def test_two_attachments_of_one_name_are_refused(sequence_folder, tmp_path):
    pack(sequence_folder, tmp_path / "ride.mkv")
    attached = read_attachments(tmp_path / "ride.mkv", MANIFEST)
    twice = with_attached(
        sequence_folder / "clip.mp4", [*attached, attached[-1]], tmp_path
    )
    with pytest.raises(InputError, match="two attachments of one name"):
        read_packed(twice)


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("clip.mkv", "named like another part"),
        ("CLIP.MKV", "named like another part"),
        ("Sequence.JSON", "named like another part"),
        ("hapticplayer.json", "two attachments of one name|like another part"),
        ("FORCE_random.npz", "named like another part"),
        ("a\0b", "not a plain file name"),
        ("a" * 300, "not a plain file name"),
        ("..", "not a plain file name"),
        ("a.desktop", "a file that no sequence has"),
        ("\u202egpj.exe", "a file that no sequence has"),
    ],
)
def test_a_file_in_place_of_another_part_is_refused(
    sequence_folder, tmp_path, name, says
):
    pack(sequence_folder, tmp_path / "ride.mkv")
    made = read_attachments(tmp_path / "ride.mkv", MANIFEST)
    evil = made[-1]._replace(name=name)
    entry = {
        "size_bytes": len(evil.content),
        "sha256": hashlib.sha256(evil.content).hexdigest(),
    }
    made = [
        edited(a, lambda c: c["files"].update({name: entry}))
        if a.name == "sequence.json"
        else a
        for a in made
    ]
    made = [*signed(made), *([evil] if "\0" not in name else [])]
    target = with_attached(sequence_folder / "clip.mp4", made, tmp_path)
    with pytest.raises(InputError, match=says):
        unpack(target, tmp_path / "again")
    assert not (tmp_path / "again").exists()


def test_a_name_with_a_zero_is_listed_and_refused(sequence_folder, tmp_path, capsys):
    """FFmpeg cannot write such a name, but any other program can."""
    target = tmp_path / "ride.mkv"
    note = Attachment("note.bin", "a/b", b"x")
    pack(sequence_folder, target, extras=[note])
    content = target.read_bytes()
    target.write_bytes(content.replace(b"\x88note.bin", b"\x88no\0e.bin"))
    assert cli.main(["unpack", str(target), "--dry-run"]) == 1
    assert "note.bin: is missing" in capsys.readouterr().err
    pack(sequence_folder, tmp_path / "whole.mkv")
    made = [*read_attachments(tmp_path / "whole.mkv", MANIFEST), note]
    target = with_attached(sequence_folder / "clip.mp4", made, tmp_path)
    content = target.read_bytes()
    target.write_bytes(content.replace(b"note.bin", b"no\0e\x1bbin"))
    assert cli.main(["unpack", str(target), "--dry-run"]) == 0
    assert "no?e?bin" in capsys.readouterr().out


@pytest.mark.parametrize("name", ["force_realistic.npz", "note.bin"])
def test_the_manifest_is_compared_with_each_file(sequence_folder, tmp_path, name):
    pack(
        sequence_folder,
        tmp_path / "ride.mkv",
        extras=[Attachment("note.bin", "a/b", b"x")],
    )
    for change in (
        lambda c: c["files"][name].update(sha256="0" * 64),
        lambda c: c["files"][name].update(size_bytes=7),
    ):
        made = [
            edited(a, change) if a.name == MANIFEST else a
            for a in read_attachments(tmp_path / "ride.mkv", MANIFEST)
        ]
        target = with_attached(sequence_folder / "clip.mp4", made, tmp_path)
        with pytest.raises(InputError, match=f"{name}: has changed"):
            read_packed(target)
        target.unlink()


def test_a_wrong_duration_is_not_passed_on(sequence_folder, tmp_path):
    pack(sequence_folder, tmp_path / "ride.mkv")
    made = [
        edited(a, lambda c: c["clip"].update(duration_s=0.25))
        if a.name == "sequence.json"
        else a
        for a in read_attachments(tmp_path / "ride.mkv", MANIFEST)
    ]
    target = with_attached(sequence_folder / "clip.mp4", signed(made), tmp_path)
    duration_s = probe(target).duration_s
    cost = export_force(target, None, tmp_path / "ride.csv", "csv")
    assert cost["duration_s"] == pytest.approx(duration_s, abs=0.05)
    unpack(target, tmp_path / "again")
    assert open_sequence(tmp_path / "again").duration_s == duration_s


@pytest.mark.parametrize("title", ["ride \udce9\udcff", "\ud800 half", "a\0b"])
def test_a_title_that_is_not_text_is_packed(sequence_folder, tmp_path, title):
    path = sequence_folder / "sequence.json"
    path.write_text(json.dumps({**json.loads(path.read_text()), "title": title}))
    pack(sequence_folder, tmp_path / "ride.mkv")
    packed = read_packed(tmp_path / "ride.mkv")
    assert packed.sequence.title == title.replace("\0", "?")
    unpack(tmp_path / "ride.mkv", tmp_path / "again")
    assert open_sequence(tmp_path / "again").title == packed.sequence.title


def test_damage_anywhere_gives_a_sequence_or_a_sentence(sequence_folder, tmp_path, rng):
    """What is opened in spite of it holds the force as it was written."""
    target = tmp_path / "ride.mkv"
    pack(sequence_folder, target)
    whole = target.read_bytes()
    force = open_sequence(sequence_folder).tracks["realistic"].force_n
    outcomes = set()
    for _ in range(150):
        damaged = bytearray(whole)
        for _ in range(int(rng.integers(1, 3))):
            damaged[int(rng.integers(len(whole)))] ^= 1 << int(rng.integers(8))
        target.write_bytes(damaged)
        try:
            packed = read_packed(target)
        except InputError:
            outcomes.add("refused")
            continue
        outcomes.add("none" if packed is None else "read")
        if packed is not None:
            kept = packed.sequence.tracks["realistic"].force_n
            assert np.array_equal(kept, force)
    assert {"refused", "read"} <= outcomes


# --- other programs -----------------------------------------------------------------


@pytest.mark.parametrize(
    "words", [["mkvmerge", "-J"], ["mediainfo"], ["ffprobe", "-show_streams"]]
)
@pytest.mark.parametrize("name", ["ride.mkv", "ride.haptics.mkv"])
def test_other_programs_name_what_is_attached(sequence_folder, tmp_path, words, name):
    if shutil.which(words[0]) is None:
        pytest.skip(f"needs {words[0]}")
    if words[0] == "ffprobe" and name != "ride.mkv":
        pytest.skip("FFmpeg refuses a file without streams")
    pack(sequence_folder, tmp_path / name.replace(".haptics.mkv", ".mp4"))
    done = subprocess.run(
        [*words, str(tmp_path / name)], capture_output=True, text=True, check=True
    )
    for one in (MANIFEST, "sequence.json", *FORCES):
        assert one in done.stdout
    if words[0] == "mkvmerge":
        found = json.loads(done.stdout)
        assert found["errors"] + found["warnings"] == []


# --- the commands -------------------------------------------------------------------


def test_the_commands_report_what_they_do(sequence_folder, tmp_path, capsys):
    target, again = str(tmp_path / "ride.mkv"), str(tmp_path / "again")
    words = ["pack", str(sequence_folder), "-o", target]
    assert cli.main([*words, "--dry-run", "--json"]) == 0
    planned = json.loads(capsys.readouterr().out)
    assert not (tmp_path / "ride.mkv").exists()
    assert cli.main([*words, "--json"]) == 0
    done = json.loads(capsys.readouterr().out)
    assert done["attached"] == planned["attached"]
    assert done["written_bytes"] == (tmp_path / "ride.mkv").stat().st_size
    assert done["video"]["sha256"] == video_payload(target).sha256
    assert cli.main(words) == 1
    assert "already exists" in capsys.readouterr().err
    assert cli.main([*words, "--overwrite"]) == 0
    capsys.readouterr()
    assert cli.main(["unpack", target, "--dry-run", "--json"]) == 0
    held = json.loads(capsys.readouterr().out)
    assert held["feedbacks"] == ["realistic", "none", "random"]
    assert cli.main(["unpack", target, "-o", again]) == 0
    assert "force of the feedback realistic, lossless" in capsys.readouterr().out
    verify_sequence(again)
    assert cli.main(["unpack", target]) == 2


def test_a_video_of_another_program_is_not_overwritten(
    sequence_folder, tmp_path, capsys
):
    target = tmp_path / "film.mkv"
    remux(sequence_folder / "clip.mp4", target, MATROSKA)
    words = ["pack", str(sequence_folder), "-o", str(target), "--overwrite"]
    assert cli.main(words) == 1
    assert "not such a file" in capsys.readouterr().err
