"""Which clips and logs belong together, and what is a log at all."""

import shutil

import pytest

from hapticplayer.capture.choices import LogChoices
from hapticplayer.capture.log_tables import header_of, keep_answers
from hapticplayer.errors import InputError, TelemetryError, UsageError
from hapticplayer.sequence import open_sequence
from hapticplayer.sequence.import_batch import (
    BroughtIn,
    Item,
    bring_in,
    is_log,
    items_of,
    needs_an_answer,
)
from hapticplayer.sequence.import_preview import tables_of
from tests.needed_extras import needs


@pytest.fixture
def put(tmp_path):
    def write(*names):
        for name in names:
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("x")
        return [tmp_path / name for name in names]

    return write


def test_one_clip_gets_all_logs_that_were_chosen_with_it(put):
    clip, *logs = put("a.mp4", "acc.csv", "gyr.csv")
    assert items_of([logs[0], clip, logs[1]]) == [Item(clip, tuple(logs))]


def test_each_of_several_clips_gets_the_log_of_its_name(put):
    a, b, log, other = put("a.mp4", "b.MOV", "b.csv", "c.csv")
    assert items_of([a, log, b, other]) == [
        Item(a),
        Item(b, (log,)),
        Item(None, (other,)),
    ]


def test_a_folder_gives_its_clips_and_not_those_of_sequences(put, tmp_path):
    put("in/.hidden/x.mp4", "in/made/sequence.json", "in/made/clip.mp4", "in/read.me")
    put("in/a.haptics.mkv", "in/far/far/far/z.mp4")
    a, b, log = put("in/a.mp4", "in/deep/b.mp4", "in/deep/b.txt")
    assert items_of([tmp_path / "in"]) == [Item(a), Item(b, (log,))]


def test_the_only_log_beside_the_only_clip_belongs_to_it(put, tmp_path):
    clip, log = put("ride/clip.mp4", "ride/imu.csv")
    assert items_of([tmp_path / "ride"]) == [Item(clip, (log,))]
    put("ride/other.csv")  # now nobody knows
    assert items_of([tmp_path / "ride"]) == [Item(clip)]


def test_a_folder_without_clips_is_a_log(put, tmp_path):
    put("log/Accelerometer.csv")
    assert items_of([tmp_path / "log"]) == [Item(None, (tmp_path / "log",))]
    assert items_of([]) == []


def test_logs_are_told_from_other_files(tmp_path, case):
    assert is_log(case("si-csv-answers/phone.csv"))
    (tmp_path / "notes.txt").write_text("hello\n")
    assert not is_log(tmp_path / "notes.txt")
    assert not is_log(tmp_path / "missing.csv")


def test_a_log_alone_asks_for_its_clip(tmp_path):
    with pytest.raises(
        UsageError, match=r"a\.csv is a motion log; choose the video"
    ) as e:
        bring_in(Item(None, (tmp_path / "a.csv",)), tmp_path)
    assert needs_an_answer(e.value)


def test_a_plain_clip_waits_for_an_answer(tiny_clip, tmp_path):
    with pytest.raises(TelemetryError) as error:
        bring_in(Item(tiny_clip.path), tmp_path / "library")
    assert needs_an_answer(error.value)
    assert not (tmp_path / "library").exists()


@needs("loggers")
def test_kept_answers_read_the_logs_of_a_queue(tiny_clip, case, tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    clip = tmp_path / "clip.mp4"
    shutil.copy(tiny_clip.path, clip)
    log = case("text-columns/witmotion.txt")
    item, library = Item(clip, (log,)), tmp_path / "library"
    with pytest.raises(UsageError, match="without a description"):
        bring_in(item, library)
    answers = {
        "columns": "time,-,ax,ay,az,gx,gy,gz",
        "accel-unit": "g",
        "rate-unit": "deg/s",
    }
    keep_answers("wit", header_of(tables_of(log, LogChoices())), answers)
    with pytest.raises(InputError, match="holds no sound") as error:
        bring_in(item, library)  # it is read now, but not synchronised
    assert needs_an_answer(error.value)


def test_a_clip_that_is_there_is_tested_and_not_made_again(shared_data, tmp_path):
    clip = tmp_path / "karma.mp4"
    shutil.copy(shared_data / "capture" / "gopro" / "karma.mp4", clip)
    made = bring_in(Item(clip), tmp_path / "library")
    assert made.is_new
    assert open_sequence(made.folder).title == "karma"
    assert bring_in(Item(clip), tmp_path / "library") == BroughtIn(made.folder, False)
