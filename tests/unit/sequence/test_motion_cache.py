"""Known results come back bit for bit; whatever else happens, they are computed."""

import dataclasses
import os
import stat

import numpy as np
import pytest

from hapticplayer import motion
from hapticplayer.model import Sampling
from hapticplayer.motion import EkfParameters, SmootherParameters
from hapticplayer.sequence import files, motion_cache
from hapticplayer.sequence.motion_cache import MotionCache, plain, user_cache
from hapticplayer.sequence.processing import Processing, process_motion


@pytest.fixture
def cache(tmp_path):
    return MotionCache(tmp_path / "cache")


@pytest.fixture
def computed(monkeypatch):
    """What was really computed: a list of methods."""
    done, analyse = [], motion.analyse

    def counted(imu, method, **options):
        done.append(method)
        return analyse(imu, method, **options)

    monkeypatch.setattr(motion, "analyse", counted)
    return done


def entries(cache):
    return sorted(cache._folder.glob("*"))


def assert_identical(one, other):
    for field in dataclasses.fields(one):
        here, there = getattr(one, field.name), getattr(other, field.name)
        if isinstance(here, np.ndarray):
            assert here.dtype == there.dtype
            assert here.tobytes() == there.tobytes(), field.name
        else:
            assert here == there, field.name


@pytest.mark.parametrize("method", sorted(motion.METHODS))
def test_a_hit_is_bit_identical(cache, computed, swing, method):
    imu, _ = swing
    first = process_motion(imu, Processing(method), cache)
    again = process_motion(imu, Processing(method), cache)
    assert computed == [method]
    assert (first.is_cached, again.is_cached) == (False, True)
    assert_identical(first.track, again.track)
    assert first.summary == again.summary


def flipped(values):
    changed = np.array(values)
    flat = changed.reshape(-1)
    flat[flat.size // 2] = np.nextafter(flat[flat.size // 2], np.inf)
    return changed


@pytest.mark.parametrize(
    "change",
    [
        lambda imu: {"specific_force_mps2": flipped(imu.specific_force_mps2)},
        lambda imu: {"angular_rate_radps": flipped(imu.angular_rate_radps)},
        lambda imu: {"time_s": flipped(imu.time_s)},
        lambda imu: {"magnetic_field_ut": np.ones((len(imu), 3))},
        lambda imu: {"valid": np.ones(len(imu), dtype=bool)},
        lambda _imu: {"sampling": Sampling.AVERAGED},
    ],
)
def test_one_changed_bit_is_another_result(cache, swing, change):
    imu, _ = swing
    changed = dataclasses.replace(imu, **change(imu))
    assert cache.key(imu, "smoother") != cache.key(changed, "smoother")


def test_the_name_of_the_file_does_not_matter(cache, swing):
    imu, _ = swing
    renamed = dataclasses.replace(imu, source="elsewhere")
    assert cache.key(imu, "smoother") == cache.key(renamed, "smoother")


def test_other_parameters_are_another_result(cache, computed, swing):
    imu, _ = swing
    for time_constant_s in (None, 10.0, 10.0, 20.0):
        process_motion(imu, Processing(time_constant_s=time_constant_s), cache)
    assert len(computed) == 3
    keys = {
        cache.key(imu, method, parameters)
        for method in ("smoother", "ekf")
        for parameters in (None, SmootherParameters(), EkfParameters())
    }
    assert len(keys) == 6


def test_another_program_is_another_result(cache, monkeypatch, swing):
    imu, _ = swing
    before = cache.key(imu, "smoother")
    monkeypatch.setattr(motion_cache, "_program", lambda: "another")
    assert cache.key(imu, "smoother") != before


def test_every_damaged_entry_is_computed_anew_and_replaced(
    cache, computed, still_log, rng
):
    first = process_motion(still_log, Processing("lowpass"), cache)
    (path,) = entries(cache)
    whole = path.read_bytes()
    ends = [0, 1, len(whole) // 2, len(whole) - 1]
    damaged = [whole[:end] for end in ends] + [b"x" * 1000, whole + b"x"]
    # the ends of a zip archive say where everything is, so flip mostly there
    places = [*rng.integers(len(whole), size=30), *range(80), *range(-800, 0, 7)]
    for place in places:
        content = bytearray(whole)
        content[place] ^= 1 << int(rng.integers(8))
        damaged.append(bytes(content))
    for content in damaged:
        path.write_bytes(content)
        again = process_motion(still_log, Processing("lowpass"), cache)
        assert_identical(first.track, again.track)
        assert first.summary == again.summary
    path.write_bytes(b"x")
    process_motion(still_log, Processing("lowpass"), cache)
    assert path.stat().st_size == len(whole)  # replaced by a good one


def test_an_entry_of_another_name_is_not_believed(cache, still_log):
    process_motion(still_log, Processing("lowpass"), cache)
    (path,) = entries(cache)
    key = cache.key(still_log, "smoother")
    path.rename(path.with_name(f"{key}.npz"))
    assert cache.load(key, still_log) is None


@pytest.mark.parametrize("kind", ["a file", "no folder", "read-only"])
def test_a_cache_that_cannot_be_written_only_costs_time(
    tmp_path, computed, still_log, kind
):
    folder = tmp_path / "cache"
    if kind == "a file":
        folder.write_text("mine")
    elif kind == "no folder":
        folder = tmp_path / "dead"
        folder.symlink_to(tmp_path / "nowhere" / "deep" / "er")
    else:
        folder.mkdir()
        folder.chmod(stat.S_IRUSR | stat.S_IXUSR)
    cache = MotionCache(folder)
    for _ in range(2):
        done = process_motion(still_log, Processing("lowpass"), cache)
        assert len(done.track) == len(still_log)
    is_root = os.geteuid() == 0  # who may write everywhere
    assert len(computed) == (1 if kind == "read-only" and is_root else 2)
    if kind == "a file":
        assert folder.read_text() == "mine"


@pytest.mark.parametrize("error", [OSError(28, "full"), KeyboardInterrupt()])
def test_what_goes_wrong_while_writing_leaves_no_part(
    cache, monkeypatch, still_log, error
):
    def fail(writer, **_arrays):
        writer.write(b"half")
        raise error

    done = motion.analyse(still_log)
    key = cache.key(still_log, "smoother")
    monkeypatch.setattr(motion_cache.np, "savez", fail)
    if isinstance(error, OSError):
        assert not cache.store(key, done.track, plain(done.summary))
    else:
        with pytest.raises(KeyboardInterrupt):
            cache.store(key, done.track, plain(done.summary))
    assert entries(cache) == []


def test_the_oldest_go_when_there_is_no_room(tmp_path, still_log):
    trial = MotionCache(tmp_path / "trial")
    process_motion(still_log, Processing("lowpass"), trial)
    limit_bytes = int(3.5 * entries(trial)[0].stat().st_size)
    cache = MotionCache(tmp_path / "cache", limit_bytes)
    logs = [
        dataclasses.replace(still_log, time_s=still_log.time_s + shift)
        for shift in range(5)
    ]
    keys = [cache.key(log, "lowpass") for log in logs]
    for number, log in enumerate(logs[:3]):
        process_motion(log, Processing("lowpass"), cache)
        os.utime(cache._path(keys[number]), (number, number))
    assert cache.load(keys[0], logs[0]) is not None  # used: no longer the oldest
    for number in (3, 4):
        process_motion(logs[number], Processing("lowpass"), cache)
    total_bytes = sum(path.stat().st_size for path in entries(cache))
    assert total_bytes <= limit_bytes
    kept = [cache.load(keys[k], logs[k]) is not None for k in range(5)]
    assert kept == [True, False, False, True, True]


def test_a_result_beyond_the_limit_is_not_kept(tmp_path, still_log):
    cache = MotionCache(tmp_path / "cache", limit_bytes=10_000)
    process_motion(still_log, Processing("lowpass"), cache)
    assert not (tmp_path / "cache").exists()


def test_parts_of_processes_that_died_are_removed(cache, still_log):
    process_motion(still_log, Processing("lowpass"), cache)
    for name, age_s in (("old.part", 2 * 3600), ("new.part", 60)):
        part = cache._folder / name
        part.write_bytes(b"half")
        now_s = entries(cache)[0].stat().st_mtime
        os.utime(part, (now_s - age_s, now_s - age_s))
    process_motion(still_log, Processing("smoother"), cache)
    assert [path.name for path in entries(cache) if path.suffix == ".part"] == [
        "new.part"
    ]


def test_the_users_cache_can_be_moved_and_switched_off(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.delenv(motion_cache.SWITCH)
    cache = user_cache()
    assert cache is not None
    assert cache._folder == tmp_path / "hapticplayer" / "motion"
    assert user_cache(wanted=False) is None
    monkeypatch.setenv(motion_cache.SWITCH, "OFF")
    assert user_cache() is None


def test_nothing_is_unpickled(cache, still_log):
    key = cache.key(still_log, "lowpass")
    cache._folder.mkdir()
    evil = np.array([{"a": 1}], dtype=object)
    np.savez(cache._path(key), key=key, summary=evil)
    assert cache.load(key, still_log) is None


def test_a_summary_holds_plain_finite_values_only():
    found = plain(
        {
            "a": np.float64(2.5),
            "b": (1, np.int64(2)),
            "c": float("nan"),
            "d": np.array([1.0, np.inf]),
            "e": {"f": np.bool_(True)},
            "g": None,
        }
    )
    assert found == {
        "a": 2.5,
        "b": [1, 2],
        "c": None,
        "d": [1.0, None],
        "e": {"f": True},
        "g": None,
    }
    assert type(found["a"]) is float


def test_damage_in_any_archive_is_one_kind_of_error(tmp_path):
    """A flag that says "encrypted" makes zipfile raise a RuntimeError."""
    path = tmp_path / "a.npz"
    files.write_arrays(path, a=np.arange(4.0))
    content = bytearray(path.read_bytes())
    central = content.rindex(b"PK\x01\x02")
    content[central + 8] |= 1
    path.write_bytes(content)
    with pytest.raises(motion_cache.InputError, match="damaged"):
        files.read_arrays(path)
