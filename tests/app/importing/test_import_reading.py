"""The form that says how a log is read, and the mapper of its columns."""

import numpy as np
import pytest

from app.experimenter.import_columns import in_words, words_of
from app.experimenter.import_reading import ReadingPage
from app.experimenter.import_wizard import MOUNTING, REPORT, SYNC
from hapticplayer.capture.choices import KEYS, LogChoices, parse_choices
from hapticplayer.capture.log_tables import keep_answers, kept_answers
from tests.e2e.command import hapticplayer
from tests.needed_extras import needs

pytestmark = needs("loggers")

SEVEN = "time,ax,ay,az,gx,gy,gz"
G, DPS, RADPS = "g", "deg/s", "rad/s"
TEXTS, SPELLINGS = "text-columns", "number-spellings"
COUNTS = {"time-unit": "us", "rate-unit": DPS, "accel-unit": "0.00478840332"}
GRAMS = {"time-unit": "s", "accel-unit": G, "rate-unit": RADPS}
LOGS = {
    "blackbox_decode": (
        [f"{TEXTS}/blackbox_decode.csv"],
        {"columns": "-,time,gx,gy,gz,ax,ay,az,-,-,-", **COUNTS},
    ),
    "blackbox_explorer": (
        [f"{TEXTS}/blackbox_explorer.csv"],
        {"columns": "-,time,gx,gy,gz,ax,ay,az", **COUNTS},
    ),
    "gopro": (
        [f"{TEXTS}/gopro_ACCL.csv", f"{TEXTS}/gopro_GYRO.csv"],
        {
            "columns": "time,-,az,ax,ay,-/time,-,gz,gx,gy,-",
            "time-unit": "ms",
            "accel-unit": "m/s2",
            "rate-unit": RADPS,
        },
    ),
    "metawear": (
        [f"{TEXTS}/metawear_acc.csv", f"{TEXTS}/metawear_gyro.csv"],
        {
            "columns": "-,-,time,ax,ay,az/-,-,time,gx,gy,gz",
            "time-unit": "s",
            "accel-unit": G,
            "rate-unit": DPS,
        },
    ),
    "sensorlog": (
        [f"{TEXTS}/sensorlog_ios.csv"],
        {"columns": "-,time,ax,ay,az,gx,gy,gz,-", **GRAMS, "accel-sign": "-"},
    ),
    "witmotion": (
        [f"{TEXTS}/witmotion.txt"],
        {"columns": "time,-,ax,ay,az,gx,gy,gz", "accel-unit": G, "rate-unit": DPS},
    ),
    "blanks": ([f"{SPELLINGS}/blanks.txt"], {"columns": SEVEN, **GRAMS}),
    "clock": (
        [f"{SPELLINGS}/clock_time.csv"],
        {"columns": SEVEN, "accel-unit": G, "rate-unit": RADPS},
    ),
    "not_available": (
        [f"{SPELLINGS}/not_available.csv"],
        {"columns": SEVEN, **GRAMS, "sampling": "averaged"},
    ),
    "phone": (["si-csv-answers/phone.csv"], {"axes": "y,-x,z"}),
    "micros_wrap": (["gcsv-header/micros_wrap.gcsv"], {"sampling": "averaged"}),
    "mobius_temp": (["gcsv-header/mobius_temp.gcsv"], {"rate-delay": "0.02"}),
    "excel": (["gcsv-header/saved_by_excel.gcsv"], {"accel-sign": "+"}),
    "thumb_rx": (["gcsv-header/thumb_rx.gcsv"], {"rate-axes": "x,y,z"}),
}

WHOLE = ("gopro", "phone", "not_available", "mobius_temp")
"""Whose sequences are compared; of the others, what the form says."""


@pytest.fixture
def form(application, qtbot, wait_for):
    """Open the form of a log, and wait until it has looked at it."""
    pages = []

    def opened(paths, answers=()):
        page = ReadingPage(paths, dict(answers))
        pages.append(page)
        qtbot.addWidget(page)
        page.show()
        settle(page, wait_for)
        return page

    yield opened
    for page in pages:
        page.close_jobs()


def settle(page, wait_for):
    wait_for(lambda: not page.is_unsettled)


def fill(page, answers):
    """Answer as a person does: by the entries of the lists."""
    for key, value in answers.items():
        if key == "columns":
            for names, part in zip(page.columns.names, value.split("/"), strict=True):
                for combo, name in zip(names, part.split(","), strict=True):
                    combo.setCurrentIndex(combo.findData(name))
        else:
            page.fields[key].put(value)


def test_every_answer_of_the_engine_has_a_field(form, wizard, case):
    page = form(case("si-csv-answers/phone.csv"))
    assert {*page.fields, "format"} == set(KEYS)
    assert wizard.files.format.accessibleName()
    for key, field in page.fields.items():
        assert field.accessibleName() or key == "columns"
    said = {
        "time-unit": "ms",
        "accel-unit": "9.9",
        "rate-unit": "1.1",
        "field-unit": "mT",
        "axes": "y,-x,z",
        "accel-sign": "-",
        "accel-axes": "y,-x,z",
        "rate-axes": "-y,x,z",
        "rate-delay": "0.3",
        "swapped": "accel,rate",
        "rate-hz": "140",
        "sampling": "averaged",
        "stuck": "no-force",
    }
    assert {*said, "columns", "format"} == set(KEYS)
    fill(page, said)
    assert page.answers() == said
    assert parse_choices([f"{k}={v}" for k, v in page.answers().items()]).given() == {
        key: said[key] for key in KEYS if key in said
    }


@pytest.fixture
def read_in_form(wizard, clip, case, wait_for):
    """Answer the form of a log of LOGS in the wizard; return the log's files."""

    def taken(name):
        names, answers = LOGS[name]
        paths = [case(one) for one in names]
        wizard.take([clip, *paths])
        wait_for(lambda: not wizard.jobs.is_busy)
        page = wizard.findChild(ReadingPage)
        # only columns are asked about
        assert (page is not None) == ("columns" in answers)
        page = page or wizard.files.open_form({})
        fill(page, answers)
        settle(page, wait_for)
        assert page.take.isEnabled(), page.check.text()
        page.take.click()
        wait_for(lambda: not wizard.jobs.is_busy)
        wait_for(wizard.next.isEnabled)
        return paths

    return taken


@pytest.mark.parametrize("name", [name for name in LOGS if name not in WHOLE])
def test_the_form_says_what_the_command_line_says(wizard, read_in_form, name):
    read_in_form(name)
    words = [f"{key}={value}" for key, value in LOGS[name][1].items()]
    assert wizard.files.choices() == parse_choices(words)


@pytest.mark.parametrize("name", WHOLE)
def test_the_form_makes_the_sequence_of_the_command_line(
    wizard, read_in_form, clip, wait_for, tmp_path, name
):
    paths, answers = read_in_form(name), LOGS[name][1]
    wizard.next.click()
    assert wizard.stack.currentIndex() == SYNC
    offset_s = 1.0 - wizard.preview.begin_s
    wizard.sync.offset.setValue(offset_s)
    wizard.sync.looked.setChecked(True)
    wizard.next.click()
    assert wizard.stack.currentIndex() == MOUNTING
    wizard.next.click()
    wait_for(lambda: wizard.stack.currentIndex() == REPORT)
    target = tmp_path / "by-command"
    logs = [word for path in paths for word in ("--imu", path)]
    words = [w for k, v in answers.items() for w in ("--read-as", f"{k}={v}")]
    said = hapticplayer(
        *("import", clip, *logs, *words, "--sync", "offset"),
        *("--offset", f"{wizard.sync.offset.value()!r}", "-o", target),
    )
    assert said.returncode == 0, said.stderr
    for file in ("imu", "motion", "force_realistic"):
        with (
            np.load(wizard.made / f"{file}.npz") as made,
            np.load(target / f"{file}.npz") as wanted,
        ):
            assert made.files == wanted.files
            for array in made.files:
                np.testing.assert_array_equal(made[array], wanted[array])


def test_an_unknown_table_is_checked_while_it_is_answered(form, case, wait_for):
    page = form(case(f"{TEXTS}/witmotion.txt"))
    assert page.columns.value() == LOGS["witmotion"][1]["columns"]  # by its header
    assert not page.columns.names[0][1].isEnabled()  # a column of text
    assert not page.fields["time-unit"].isEnabled()  # clock times
    assert not page.fields["rate-hz"].isEnabled()
    assert "Choose: Accelerometer unit, Gyroscope unit" in page.check.accessibleName()
    assert not page.take.isEnabled()
    fill(page, {"accel-unit": "m/s2", "rate-unit": DPS})
    settle(page, wait_for)
    assert "would fit another unit" in page.check.accessibleName()
    proposed = page.proposals()
    assert "Accelerometer unit: g" in [one.text() for one in proposed]
    next(one for one in proposed if one.text() == "Accelerometer unit: g").click()
    settle(page, wait_for)
    said = page.check.accessibleName()
    assert "At rest 9.80 m/s\u00b2; gravity is 9.81" in said
    assert "agrees with turning gravity" in said
    assert page.take.isEnabled()


@pytest.mark.parametrize(("columns", "offered"), [(7, 1), (8, 0)])
def test_an_example_is_offered_where_it_fits(form, tmp_path, columns, offered):
    log = tmp_path / "log.csv"
    rows = [[f"{at}.5"] * columns for at in range(50)]
    header = [f"col{at}" for at in range(columns)]
    log.write_text("\n".join(",".join(row) for row in [header, *rows]))
    page = form(log)
    assert "; ".join(header) in page.check.accessibleName()
    assert len(page.proposals()) == offered


def test_a_unit_can_be_chosen_typed_or_left(form, case):
    page = form(case(f"{TEXTS}/witmotion.txt"))
    unit = page.fields["time-unit"]
    assert (unit.currentText(), unit.value()) == ("", "")
    field = unit.lineEdit()
    assert field.placeholderText() == "choose or type"
    wanted_px = field.fontMetrics().horizontalAdvance(field.placeholderText())
    assert field.width() >= wanted_px + 2 * 4  # the margins of a field
    unit.setCurrentIndex(unit.findText("\u00b5s"))
    assert unit.value() == "us"
    unit.setEditText("us")
    assert unit.value() == "us"
    unit.put("us")
    assert unit.currentText() == "\u00b5s"
    unit.put("")
    assert (unit.currentText(), unit.value()) == ("", "")


def test_a_gyroscope_in_wrong_axes_is_seen_at_once(form, case, wait_for):
    columns = "time,-,ax,ay,az,gy,gx,gz"
    answers = {**LOGS["witmotion"][1], "columns": columns}
    page = form(case(f"{TEXTS}/witmotion.txt"), answers)
    assert "does not match that of gravity" in page.check.accessibleName()
    keep = "Gyroscope x, y, z: x, y, z"
    next(one for one in page.proposals() if one.text() == keep).click()
    settle(page, wait_for)
    assert "does not agree with turning gravity" in page.check.accessibleName()


def test_a_column_takes_its_name_from_the_one_that_had_it(form, case):
    page = form(case(f"{TEXTS}/gopro_ACCL.csv"), {"columns": "time,-,az,ax,ay,-"})
    ((first, *_, last),) = page.columns.names
    last.setCurrentIndex(last.findData("time"))
    assert first.currentText() == "ignore"
    assert page.columns.value() == "-,-,az,ax,ay,time"


def test_a_log_without_times_asks_for_its_rate(form, case):
    answers = LOGS["blanks"][1]
    page = form(case(f"{SPELLINGS}/blanks.txt"), answers)
    page.columns.names[0][0].setCurrentIndex(0)
    assert not page.fields["time-unit"].isEnabled()
    page.fields["rate-hz"].setText("50,0")
    assert page.answers()["rate-hz"] == "50.0"
    assert "time-unit" not in page.answers()


def test_kept_answers_are_offered_for_the_next_log(form, case, tmp_path, wait_for):
    names, answers = LOGS["sensorlog"]
    page = form(case(names[0]), answers)
    page.name.setText("SensorLog, belt")
    page.take.click()
    assert kept_answers()["SensorLog, belt"].answers == answers
    other = tmp_path / "next.csv"
    other.write_bytes(case(names[0]).read_bytes())
    page = form(other)
    assert page.kept.currentText() == "SensorLog, belt"
    assert page.answers() == answers
    assert page.take.isEnabled()
    page = form(case(f"{TEXTS}/witmotion.txt"))  # another header
    assert page.kept.value() == ""
    page.kept.put("SensorLog, belt")  # chosen all the same
    assert page.name.text() == "SensorLog, belt"
    said = hapticplayer("process", other, "--read-as", "template=SensorLog, belt")
    assert said.returncode == 0, said.stderr


def test_damaged_kept_answers_are_told_and_change_nothing(form, case, tmp_path):
    keep_answers("x", (), {"accel-sign": "-"})
    (tmp_path / "config" / "hapticplayer" / "loggers.json").write_text("{")
    page = form(case("si-csv-answers/phone.csv"))
    assert "loggers.json" in page.problem.text()
    page.name.setText("y")
    page.take.click()
    assert page.isVisible()
    assert "loggers.json" in page.problem.text()


def test_means_over_a_window_can_be_said_of_any_log(wizard, clip, case, wait_for):
    wizard.take([clip, case("si-csv-answers/phone.csv")])
    wait_for(wizard.next.isEnabled)
    assert wizard.files.how.isVisible()
    wizard.files.how.click()
    page = wizard.findChild(ReadingPage)
    page.fields["sampling"].put("averaged")
    settle(page, wait_for)
    page.take.click()
    wait_for(lambda: not wizard.jobs.is_busy and wizard.next.isEnabled())
    assert wizard.files.choices() == LogChoices(sampling="averaged")
    assert "sampling=averaged" in wizard.files.notes.text()


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        ("axes=x,-z,y, or the axes that were up", {"axes": "x,-z,y"}),
        ("axes=RIGHT,FRONT,UP, such as axes=x,-z,y", {"axes": "x,-z,y"}),
        ("time-unit=s|ms and accel-unit=g|mg", {}),
        ("record it again", {}),
        ("sampling=other", {}),
    ],
)
def test_proposals_are_taken_apart_as_far_as_they_are_answers(answer, words):
    assert words_of(answer) == words


@pytest.mark.parametrize(
    ("answer", "shown"),
    [
        (
            "accel-sign=- if its sign is wrong",
            "Accelerometer reads: \u22121 g upwards \u2013 if its sign is wrong",
        ),
        ("time-unit=ms", "Time unit: ms"),
        (
            "axes=x,-z,y, or others",
            "The wearer\u2019s axes in the log: right x, front -z, up y, or others",
        ),
        ("format=gcsv", "Format: Gyroflow gcsv"),
        (
            "rate-delay=0.25 to take it back",
            "Gyroscope late by, s: 0.25 \u2013 to take it back",
        ),
        ("record it again", "record it again"),
    ],
)
def test_people_read_a_proposal_in_the_words_of_its_field(application, answer, shown):
    assert in_words(answer) == shown
