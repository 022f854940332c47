"""The command line asks with exit status 2, and takes the answer."""

import pytest

from hapticplayer.cli import main
from tests.faults.import_formats import GENERIC, generic, phyphox_linear, put
from tests.faults.import_signal import sample


@pytest.fixture
def table(tmp_path):
    return put(generic(sample()), tmp_path / "in")


def test_a_doubtful_log_ends_with_status_2_and_a_question(table, capsys):
    assert main(["process", str(table)]) == 2
    said = capsys.readouterr().err.strip().splitlines()[-1]  # above: the progress
    assert said.startswith("hapticplayer: ")
    assert "--read-as columns=" in said


def test_the_answer_is_taken_kept_and_used_again(table, tmp_path, capsys):
    template = tmp_path / "mine.json"
    answers = [word for answer in GENERIC for word in ("--read-as", answer)]
    first = ["process", str(table), *answers, "--save-template", str(template)]
    assert main([*first, "--method", "lowpass"]) == 0
    assert "read as CSV with chosen columns" in capsys.readouterr().out
    again = ["process", str(table), "--read-as", f"template={template}"]
    assert main([*again, "--method", "lowpass"]) == 0


def test_answers_may_follow_one_another(table, capsys):
    words = ["--method", "lowpass", "--read-as", *GENERIC]
    assert main(["process", *words, str(table)]) == 0
    assert main(["process", str(table), *words, "--json"]) == 0
    assert main(["process", *words, "answer=unknown", str(table)]) == 2


def test_answers_that_read_nothing_are_not_kept(table, tmp_path, capsys):
    template = tmp_path / "mine.json"
    wrong = ["--read-as", GENERIC[0], "--save-template", str(template)]
    assert main(["process", str(table), *wrong]) == 2
    assert not template.exists()


def test_motion_without_gravity_is_not_processed_a_second_time(tmp_path, capsys):
    path = put(phyphox_linear(sample()), tmp_path / "in")
    assert main(["process", str(path)]) == 1
    assert "recorder has removed gravity" in capsys.readouterr().err


def test_a_folder_of_a_phone_is_processed(tmp_path, capsys):
    from tests.faults.import_formats import sensor_logger_android

    folder = put(sensor_logger_android(sample(apart=True)), tmp_path / "in")
    assert main(["process", str(folder), "--method", "lowpass"]) == 0
    assert "Sensor Logger (Android)" in capsys.readouterr().out
