"""Import, process, sync and the wizard ask the same about axes and units."""

import dataclasses

import numpy as np
import pytest

from hapticplayer.capture import read_recording
from hapticplayer.capture.choices import LogQuestion, parse_choices
from hapticplayer.capture.si_csv import write_imu_csv
from hapticplayer.cli import main
from hapticplayer.motion.repair import rotation
from hapticplayer.sequence import import_preview
from tests.faults.import_formats import FORMATS, put
from tests.unit.capture.test_agreement import tumbling


@pytest.fixture
def mirrored(tmp_path, swing):
    """A log whose gyroscope is reversed."""
    log = swing[0]
    wrong = dataclasses.replace(log, angular_rate_radps=-log.angular_rate_radps)
    write_imu_csv(tmp_path / "log.csv", wrong)
    return tmp_path / "log.csv"


COMMANDS = {
    "import": ("import", "{clip}", "--imu", "{log}", "-o", "{made}", "--offset", "0"),
    "process": ("process", "{log}"),
    "sync": ("sync", "{clip}", "--imu", "{log}"),
}


@pytest.mark.parametrize("name", [*COMMANDS, "wizard"])
def test_a_reversed_gyroscope_is_asked_about(
    name, tiny_clip, mirrored, tmp_path, capsys, monkeypatch
):
    places = {"clip": tiny_clip.path, "log": mirrored, "made": tmp_path / "ride"}
    asked = []
    rule = rotation.doubt_about
    monkeypatch.setattr(
        rotation, "doubt_about", lambda imu: asked.append(imu) or rule(imu)
    )
    if name == "wizard":
        with pytest.raises(LogQuestion) as question:
            import_preview.preview_import(tiny_clip.path, mirrored, method="offset")
        said = str(question.value)
    else:
        assert main([word.format(**places) for word in COMMANDS[name]]) == 2
        said = capsys.readouterr().err
    assert asked
    assert "does not match that of gravity" in said
    assert "--read-as rate-axes=-x,-y,-z if the gyroscope is mirrored" in said
    assert "rate-axes=-x,y,z if both sensors are mirrored" in said


def test_a_log_of_another_hand_is_mended_by_a_named_answer(tmp_path):
    """One axis of both sensors is mirrored: which one, only a person can tell."""
    mirror = np.diag([1.0, -1.0, 1.0])
    made = tumbling()
    wrong = dataclasses.replace(
        made, force=made.force @ mirror, rate=made.rate @ mirror
    )
    path = put(FORMATS["own CSV"].write(wrong), tmp_path / "log")
    with pytest.raises(LogQuestion) as asked:
        read_recording(path)
    words = "accel-axes=x,-y,z rate-axes=x,-y,z"
    assert any(words in str(answer) for answer in asked.value.answers)
    mended = read_recording(path, parse_choices(words.split())).imu
    right = read_recording(put(FORMATS["own CSV"].write(made), tmp_path / "right")).imu
    np.testing.assert_allclose(
        mended.angular_rate_radps, right.angular_rate_radps, atol=1e-6
    )
