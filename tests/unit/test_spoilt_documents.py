"""Spoilt documents are refused in one sentence that names the file, by every reader."""

import copy
import itertools
import json
import random
import zlib

import pytest

from hapticplayer.capture.choices import LogChoices, read_template, write_template
from hapticplayer.capture.log_tables import KEPT, keep_answers, kept_answers
from hapticplayer.errors import InputError
from hapticplayer.media.matroska import read_attachments
from hapticplayer.media.remux import write_attachments
from hapticplayer.model.calibration import SensorCalibration
from hapticplayer.playback.latency import latencies_in, read_settings
from hapticplayer.playback.replay import read_force_log
from hapticplayer.rendering.effects import NO_EFFECTS, Effect, EffectList, TimeMarker
from hapticplayer.sequence import effects_file, open_sequence, store
from hapticplayer.sequence.calibration import (
    StoredCalibration,
    read_calibration,
    write_calibration,
)
from hapticplayer.sequence.editing import set_effects
from hapticplayer.sequence.figures import sequence_figures
from hapticplayer.sequence.library import read_entry
from hapticplayer.sequence.pack import pack
from hapticplayer.sequence.packed import MANIFEST, read_packed
from hapticplayer.sequence.synchronizing import stored_skews
from hapticplayer.simulation.sessions import write_scripted_session
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.journal import decode, encode
from hapticplayer.study.orders import ORDERS
from hapticplayer.study.plan import parse_plan_file
from hapticplayer.study.reviewing import read_reviewed
from hapticplayer.study.study_folder import open_study

DEEP, LARGE = "<deep>", "<large>"
WRONG = [None, True, "text", [], {}, [1, 2, 3], -1, 1.5, 10**400, DEEP, LARGE]
WRONG += [float("nan"), float("inf"), "half \ud800"]
MOST = 400
"""Of one document; which ones is drawn with a fixed seed."""


def places(value, path=()):
    """Yield the path of each entry of a document."""
    if path:
        yield path
    entries = {}.items()
    if isinstance(value, dict):
        entries = value.items()
    elif isinstance(value, list):
        entries = enumerate(value)
    for name, one in entries:
        yield from places(one, (*path, name))


def spoilt(document):
    """Yield texts of a document in which one entry is wrong, or is not there."""
    chosen = [(p, w) for p in places(document) for w in [*WRONG, "<gone>"]]
    random.Random(46).shuffle(chosen)
    for path, wrong in chosen[:MOST]:
        made = copy.deepcopy(document)
        at = made
        for name in path[:-1]:
            at = at[name]
        if wrong == "<gone>":
            del at[path[-1]]
        else:
            at[path[-1]] = wrong
        yield (path, wrong), as_text(made)
    for wrong in WRONG:
        yield ((), wrong), as_text(wrong)
    yield ((), "half"), json.dumps(document).encode()[: len(str(document)) // 2]
    yield ((), "no text"), b"\xff\xfe\x00"


def as_text(made):
    text = json.dumps(made).replace(f'"{DEEP}"', "[" * 100_000 + "]" * 100_000)
    return text.replace(f'"{LARGE}"', "1e999").encode()


def check(path, document, read, error=InputError):
    """Read each spoilt document: it is taken as another valid one, or refused."""
    refused = 0
    for what, text in spoilt(document):
        path.write_bytes(text)
        if said := refusal(read, what, error):
            refused += 1
            assert path.name in said or path.parent.name in said, what
            assert "\n" not in said, what
            assert len(said) < 1000, what
    assert refused


def refusal(read, what, error=InputError):
    """What a reader says to a spoilt document; "" if it takes it."""
    try:
        read()
    except error as problem:
        return str(problem)
    except Exception as problem:
        raise AssertionError(f"{what}: {problem!r}") from problem
    return ""


def use(folder):
    """Do with a sequence what the program does with one."""
    sequence = open_sequence(folder)
    store.effects_of(sequence)
    store.recorded_log(sequence)
    sequence_figures(sequence)
    read_entry(folder)


def test_a_spoilt_description_of_a_sequence_is_refused(sequence_folder):
    path = sequence_folder / "sequence.json"
    check(path, json.loads(path.read_text()), lambda: use(sequence_folder))


def test_a_spoilt_manifest_of_a_packed_video_is_refused(sequence_folder, tmp_path):
    """The checksum of the manifest is nobody's: another one can be attached."""
    target = tmp_path / "ride.mkv"
    pack(sequence_folder, target)
    attached = read_attachments(target, MANIFEST)
    at = next(k for k, one in enumerate(attached) if one.name == MANIFEST)
    made = tmp_path / "made.haptics.mkv"
    (tmp_path / "made.mp4").write_bytes((sequence_folder / "clip.mp4").read_bytes())
    refused = 0
    for what, text in itertools.islice(spoilt(json.loads(attached[at].content)), 150):
        attached[at] = attached[at]._replace(content=text)
        made.unlink(missing_ok=True)
        write_attachments(made, attached)
        if said := refusal(lambda: read_packed(tmp_path / "made.mp4"), what):
            refused += 1
            assert "made.haptics.mkv" in said, what
            assert "\n" not in said, what
            assert len(said) < 1000, what
    assert refused


def test_a_sequence_of_a_spoilt_description_is_left_as_it_was(sequence_folder):
    path = sequence_folder / "sequence.json"
    document = json.loads(path.read_text())
    document["feedbacks"]["random"]["provenance"]["seed"] = [3]
    path.write_text(json.dumps(document))
    files = sorted(one.name for one in sequence_folder.iterdir())
    with pytest.raises(InputError, match=r"sequence\.json, feedbacks\.random: .*seed"):
        set_effects(sequence_folder, NO_EFFECTS)
    assert sorted(one.name for one in sequence_folder.iterdir()) == files
    assert json.loads(path.read_text()) == document


def test_a_spoilt_list_of_effects_is_refused(tmp_path):
    curve = ((0.0, 1.0), (1.0, 0.5))
    knock = Effect("knock", 1.0, 2.0, parameters={"amplitude": 2.0})
    document = effects_file.written(
        EffectList(
            (knock, Effect("gain", 2.0, 4.0, curve=curve)), (TimeMarker(1.0, "a"),)
        )
    )
    path = tmp_path / "effects.json"
    check(
        path, json.loads(json.dumps(document)), lambda: effects_file.read_effects(path)
    )


def test_a_spoilt_calibration_is_refused(tmp_path):
    path = tmp_path / "imu.json"
    write_calibration(path, StoredCalibration(SensorCalibration(), "a", "b", "c"))
    check(path, json.loads(path.read_text()), lambda: read_calibration(path))


def test_a_spoilt_template_of_a_log_is_refused(tmp_path):
    path = tmp_path / "log.json"
    write_template(path, LogChoices(axes="x,y,z"))
    check(path, json.loads(path.read_text()), lambda: read_template(path))


def test_spoilt_skews_of_cameras_are_refused(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    path = tmp_path / "hapticplayer" / "cameras.json"
    path.parent.mkdir()
    check(path, {"sound_late_s": {"one": 0.01, "two": 0.02}}, stored_skews)


def test_spoilt_answers_that_were_kept_are_refused(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    keep_answers("logger", (("t", "ax"),), {"accel-unit": "g"})
    path = tmp_path / "hapticplayer" / KEPT
    check(path, json.loads(path.read_text()), kept_answers)


def test_spoilt_settings_are_left_out(tmp_path):
    path = tmp_path / "settings.json"
    document = {"latencies_ms": {"sound": {"a": 1.0}}, "version": 1}
    for _, text in spoilt(document):
        path.write_bytes(text)
        table = read_settings(path).get("latencies_ms")
        latencies_in(table if isinstance(table, dict) else {})


def test_a_spoilt_definition_of_a_study_is_refused(tmp_path):
    study = create_study(tmp_path / "study")
    path = study.folder / "study.json"
    check(path, json.loads(path.read_text()), lambda: open_study(study.folder))


@pytest.fixture
def session(tmp_path, manual_clock):
    """A study with a simulated session, and its code."""
    study = create_study(tmp_path / "study")
    code = write_scripted_session(
        study,
        {"age": 30},
        lambda _condition: {"realism": 3},
        manual_clock,
        origin={"scripted": True},
    )
    return study, study.session_folder(code)


def test_a_spoilt_plan_of_a_session_is_refused(session):
    _, folder = session
    path = folder / "session.json"
    check(
        path,
        json.loads(path.read_text()),
        lambda: parse_plan_file(path.read_bytes(), str(path)),
    )


def test_a_spoilt_list_of_reviewed_texts_approves_nothing(session):
    _, folder = session
    for _, text in spoilt({"passed": ["a" * 64]}):
        (folder / "reviewed.json").write_bytes(text)
        assert read_reviewed(folder) <= {"a" * 64}


CELLS = [
    "",
    " ",
    "text",
    "-1",
    "1.5",
    "1e999",
    "nan",
    "9" * 400,
    "=1",
    '"',
    "\0",
    "a,b",
]


def test_a_spoilt_list_of_orders_is_refused(tmp_path):
    study = create_study(tmp_path / "study")
    content = json.loads(study.content)
    content["order"]["method"] = "list"
    study = change_definition(study, content)
    path = study.folder / ORDERS
    names = ("order", "position", "sequence", "feedback", "delay_s", "gain", "repeat")
    rows = [
        ["a", str(place), one.sequence, one.feedback, "0", "1.0", "1"]
        for place, one in enumerate(study.definition.conditions)
    ]
    refused = 0
    for row, column, cell in itertools.product((0, 1, 12), range(len(names)), CELLS):
        table = [list(names), *(list(one) for one in rows)]
        table[row][column] = cell
        path.write_text("\n".join(map(",".join, table)))
        said = refusal(study.listed_orders, (row, column, cell))
        refused += bool(said)
        assert not said or ORDERS in said
        assert "\n" not in said
        assert not said or said in study.order_notices()
        if not said:  # another name of the order, or what is so where nothing is given
            (order,) = study.listed_orders()
            assert set(order) == set(study.definition.conditions)
    assert refused > 200
    for text in (b"", b"\xff\xfe", b'order,position,sequence,feedback\n"a', b"a\n" * 9):
        path.write_bytes(text)
        said = refusal(study.listed_orders, text)
        assert ORDERS in said or not text.strip(), text


def test_records_of_a_spoilt_journal_are_left_out_and_kept(session):
    study, folder = session
    path = folder / "answers.jsonl"
    intact = decode(path.read_bytes()).intact
    head = path.read_bytes().split(b"\n")[0] + b"\n"
    for number, record in enumerate(intact):
        chosen = dict(record.content)
        for _, text in list(spoilt(chosen))[:60]:
            body = b'{"record":%d,"v":1,"utc":"x","mono_s":1,"kind":"%s","more":%s' % (
                number + 1,
                record.kind.encode(),
                text,
            )
            path.write_bytes(head + signed(body) + signed_content(record, text))
            before = path.read_bytes()
            assert len(read_answers(study.folder).participants) <= 1
            assert path.read_bytes() == before


def signed(body):
    return body + b',"crc":"%08x"}\n' % zlib.crc32(body)


def signed_content(record, text):
    """A record whose own members are spoilt, but whose checksum is right."""
    try:
        content = json.loads(text)
        return encode(99, "x", 1.0, record.kind, content)
    except (ValueError, TypeError, AttributeError, RecursionError):
        return b""


def test_a_long_line_of_a_journal_takes_linear_time():
    line = b'{"record":' * 100_000 + b',"crc":"00000000"}' * 40_000 + b"\n"
    record = encode(1, "x", 1.0, "begin", {"step": "a"})
    found = decode(line + record)
    assert [one.kind for one in found.intact] == ["begin"]
    assert len(found.damaged) == 1


def test_a_spoilt_playback_log_is_refused(tmp_path):
    path = tmp_path / "play.log"
    header = {"kind": "header", "program": "hapticplayer"}
    force = {"kind": "force", "media_s": 1.0, "force_n": [1, 2, 3]}
    path.write_text(f"{json.dumps(header)}\n{json.dumps(force)}\n")
    for what, text in spoilt(force):
        path.write_bytes(json.dumps(header).encode() + b"\n" + text)
        said = refusal(lambda: read_force_log(path), what)
        assert not said or "play.log" in said, what
