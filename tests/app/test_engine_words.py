"""What the engine says is shown in the language of the window."""

import ast
import importlib.util
import json
import re
import shutil
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtGui import QGuiApplication

from app.bridge import engine_words, languages
from app.bridge.engine_words import LONGEST, MOST_PARTS, Search, told, translated
from app.experimenter.import_wizard import ImportWizard
from app.player.remake import dress
from hapticplayer import errors
from hapticplayer.capture.choices import LogQuestion
from hapticplayer.errors import DeviceError, InputError

ROOT = Path(__file__).resolve().parents[2]
FOREIGN = [code for code in languages.NAMES if code != languages.ENGLISH]
PLACE = re.compile(r"\{(\d+)\}")
CHECKED = (  # whose errors reach the window: a new folder of the engine belongs here
    "capture",
    "devices",
    "haptics",
    "media",
    "model",
    "motion/gravity.py",
    "motion/repair",
    "playback",
    "rendering",
    "sequence",
    "study",
)


@pytest.fixture(scope="module")
def script():
    """Return the program that collects the sentences."""
    path = ROOT / "packaging" / "engine_sentences.py"
    spec = importlib.util.spec_from_file_location("engine_sentences", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def spoken(application):
    yield lambda code: languages.install(application, code)
    languages.install(application, languages.ENGLISH)


@pytest.fixture
def german(make_window, settings, application):
    """A window that speaks German."""
    settings.keep("language", "de")
    dress(application, settings)
    yield make_window()
    settings.keep("language", languages.ENGLISH)
    dress(application, settings)


# --- every sentence is there ---------------------------------------------------


def named(function: ast.expr) -> str:
    if isinstance(function, ast.Name):
        return function.id
    return function.attr if isinstance(function, ast.Attribute) else ""


def filled(node: ast.expr) -> Iterator[tuple[str, list[str]]]:
    """Yield the sentences of an argument, with numbers for values, and the numbers."""
    if isinstance(node, ast.IfExp):
        yield from filled(node.body)
        yield from filled(node.orelse)
    elif isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value, []
    elif isinstance(node, ast.JoinedStr):
        text, values = "", []
        for part in node.values:
            if isinstance(part, ast.FormattedValue):
                values.append(f"{70 + len(values)}.5")
                text += values[-1]
            else:
                text += part.value
        yield text, values


def is_of_ours(name: str) -> bool:
    """Whether a class is an error that a person may get to read."""
    kind = getattr(errors, name, None)
    is_error = isinstance(kind, type) and issubclass(kind, errors.HapticPlayerError)
    return is_error or (name.startswith("Falcon") and name.endswith("Error"))


def raised(silent: tuple[str, ...]) -> Iterator[tuple[str, str, list[str]]]:
    """Yield file and line, a sentence and its values, of each error with a text."""
    for path in sorted((ROOT / "hapticplayer").rglob("*.py")):
        place = path.relative_to(ROOT / "hapticplayer").as_posix()
        if not place.startswith(CHECKED) or place.startswith(silent):
            continue
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not (isinstance(node, ast.Call) and is_of_ours(named(node.func))):
                continue
            said = [k.value for k in node.keywords if k.arg == "remedy"]
            for argument in (*node.args[:1], *said):
                for text, values in filled(argument):
                    if re.search(r"[a-z]{2,} ", text):
                        yield f"{place}:{node.lineno}", text, values


@pytest.mark.parametrize("code", FOREIGN)
def test_every_error_is_shown_in_the_language_of_the_window(spoken, script, code):
    sites = list(raised(script.SILENT))
    assert len(sites) > 300
    spoken(code)
    left = []
    for place, text, values in sites:
        said = translated(text)
        if said == text or any(value not in said for value in values):
            left.append(f"{place}: {text} -> {said}")
    assert left == []


def test_the_list_of_sentences_is_that_of_the_source(script):
    listed = json.loads(engine_words.FILE.read_text(encoding="utf-8"))
    new = sorted(set(script.sentences()) ^ set(listed))
    assert new == [], "run packaging/translate.sh and translate what is new"


@pytest.mark.parametrize("code", FOREIGN)
def test_the_translation_is_whole_and_holds_the_same_values(code):
    tree = ET.parse(languages.FOLDER / f"{code}.ts")
    contexts = {c.findtext("name"): c for c in tree.iter("context")}
    pairs = {
        one.findtext("source"): one.find("translation")
        for one in contexts[engine_words.CONTEXT].iter("message")
    }
    listed = json.loads(engine_words.FILE.read_text(encoding="utf-8"))
    assert set(pairs) == set(listed)
    for text, said in pairs.items():
        assert said.text, text
        assert said.get("type") is None, text
        assert sorted(PLACE.findall(said.text)) == sorted(PLACE.findall(text)), text


def test_french_signs_stay_with_their_word():
    tree = ET.parse(languages.FOLDER / "fr.ts")
    texts = [one.text or "" for one in tree.iter("translation")]
    assert [text for text in texts if re.search(r" [;:!?\u00bb]|\u00ab ", text)] == []


@pytest.mark.parametrize("code", FOREIGN)
def test_every_template_is_known_again_with_its_values(spoken, code):
    spoken(code)
    left = []
    for text in json.loads(engine_words.FILE.read_text(encoding="utf-8")):
        if text in (*engine_words._LINKS, *engine_words._NOT_LOOKED_FOR):
            continue
        numbers = sorted(set(PLACE.findall(text)))
        values = {number: f"{80 + int(number)}.5" for number in numbers}
        fill = lambda template: PLACE.sub(lambda m: values[m[1]], template)  # noqa: E731, B023
        expected = fill(engine_words._say(text))
        if (said := Search().found(fill(text)).text) != expected:
            left.append(f"{text}: {said}")
    assert left == []


# --- how a sentence is read ----------------------------------------------------


def test_a_sentence_is_told_part_by_part_and_names_of_files_stay(spoken):
    spoken("de")
    problem = InputError(
        "'x' is not a finite number",
        where="/films/you and me: or not/log.csv, line 3, column ax",
        remedy="remove the line or correct the number",
    )
    expected = (
        "/films/you and me: or not/log.csv, Zeile 3, Spalte ax: 'x' ist nicht wie "
        "verlangt: endliche Zahl; entfernen Sie die Zeile, oder berichtigen Sie die Zahl"
    )
    assert told(problem) == expected
    spoken("fr")
    assert told(
        InputError("is missing", where="a or b.csv", remedy="copy it again")
    ) == ("a or b.csv\u00a0: manque\u00a0; copiez-le encore une fois")


@pytest.mark.parametrize(
    ("sentence", "german"),
    [
        (
            "/x/y z.mp4: cannot be read (No such file or directory); import it again",
            (
                "/x/y z.mp4: kann nicht gelesen werden (Datei oder Ordner gibt es nicht); "
                "importieren Sie es noch einmal"
            ),
        ),
        (
            (
                "the Falcon did not start in 3 attempts (the last: its echo at byte 5 was "
                "wrong); unplug its power and USB, plug both in, if you can without a hub, "
                "and try again"
            ),
            (
                "der Falcon ist in 3 Versuchen nicht gestartet (zuletzt: das Echo bei Byte "
                "5 war falsch); ziehen Sie Netzteil und USB ab, stecken Sie beide wieder "
                "an, m\u00f6glichst ohne Hub, und versuchen Sie es noch einmal"
            ),
        ),
        (
            (
                "read as Razor, raw output: specific force in counts of 0.0383, y,x,-z (the "
                "chip's axes) are right, front, up, 9.80 m/s2 at rest"
            ),
            (
                "gelesen als Razor, Rohausgabe: spezifische Kraft in Z\u00e4hlwerten von "
                "0.0383, y,x,-z (Achsen des Chips) sind rechts, vorn, oben, 9.80 m/s2 in "
                "Ruhe"
            ),
        ),
        (
            "3 of 90 rows repeat the one before and were left out (first in line 7)",
            (
                "3 von 90 Zeilen wiederholen die vorige und wurden weggelassen (zuerst in "
                "Zeile 7)"
            ),
        ),
        (
            "could be Razor, raw output or MARS logger",
            "k\u00f6nnte Razor, Rohausgabe oder MARS logger sein",
        ),
        (
            "this track would move a relaxed hand so that the force stops (speed) at 3.2 s",
            (
                "diese Spur w\u00fcrde eine lockere Hand so bewegen, dass die Kraft "
                "abschaltet (speed), bei 3.2 s"
            ),
        ),
    ],
)
def test_values_that_are_the_engines_own_words_are_said_too(spoken, sentence, german):
    spoken("de")
    assert translated(sentence) == german


@pytest.mark.parametrize(
    "sentence",
    [
        "",
        ": ; ,",
        "nobody knows this: not even here; and not there",
        "Die Kraft ist gestoppt: schon gesagt",
        "is really strange",
        "a {0} with {1} braces",
        "you and me or them",
    ],
)
def test_what_is_not_known_stays_as_it_is(spoken, sentence):
    for code in FOREIGN:
        spoken(code)
        assert translated(sentence) == sentence


def test_english_stays_english(spoken):
    spoken("en")
    problem = InputError("is missing", where="a", remedy="copy it again")
    assert told(problem) == str(problem) == "a: is missing; copy it again"


@pytest.mark.parametrize("code", FOREIGN)
def test_braces_of_somebody_else_do_no_harm(spoken, code):
    spoken(code)
    said = translated("/x: has the unknown entry '{0} {7} {{'; correct it")
    assert "'{0} {7} {{'" in said
    assert "unknown" not in said


@pytest.mark.parametrize(
    "hostile",
    [
        "is damaged (: ; , " * 300,
        "{0}: {1}; " * 500,
        "a of b rows c of " * 300,
        "x" * LONGEST,
        "is " * (LONGEST // 3),
    ],
)
def test_a_hostile_sentence_takes_few_looks(spoken, hostile):
    spoken("fr")
    search = Search()
    search.found(hostile[:LONGEST])
    assert search.parts <= MOST_PARTS


def test_a_sentence_of_a_megabyte_is_shown_as_it_is(spoken, monkeypatch):
    spoken("fr")
    monkeypatch.setattr(engine_words, "_kept", None)  # nothing is looked for
    text = "is damaged (" * 90_000
    assert translated(text) == text
    assert told(DeviceError(text)) == text


# --- in the window -------------------------------------------------------------


def test_a_missing_file_is_shown_in_german_and_copied_in_both(
    german, wait_for, tmp_path
):
    path = tmp_path / "missing.mp4"
    german.session.open_path(path)
    wait_for(lambda: "missing.mp4" in german.messages.text())
    said = german.messages.text()
    assert (
        said == f"{path}: diese Datei gibt es nicht; pr\u00fcfen Sie Namen und Ordner"
    )
    german.messages.copy.click()
    lines = QGuiApplication.clipboard().text().splitlines()
    english = f"{path}: there is no such file; check the name and the folder"
    assert lines == [said, english]


def test_a_damaged_sequence_is_told_in_german(german, sequence, wait_for, tmp_path):
    broken = tmp_path / "broken"
    shutil.copytree(sequence, broken)
    (broken / "sequence.json").write_text("[]")
    german.session.open_path(broken)
    wait_for(german.messages.isVisible)
    assert german.messages.text() == f"{broken / 'sequence.json'}: ist kein JSON-Objekt"


def test_a_log_that_cannot_be_read_is_told_in_german(
    german, clip, wait_for, qtbot, tmp_path
):
    log = tmp_path / "log.csv"
    rows = "".join(f"{k / 100},0,0,9.8,0,0,zero\n" for k in range(300))
    log.write_text("time_s,ax,ay,az,gx,gy,gz\n" + rows)
    wizard = ImportWizard("", tmp_path, german)
    qtbot.addWidget(wizard)
    wizard.take([clip, log])
    wait_for(lambda: bool(wizard.files.problem.text()))
    said = wizard.files.problem.text()
    wizard.close_jobs()
    assert said == (
        f"{log}, Zeile 2, Spalte gz: 'zero' ist keine Zahl; entfernen Sie die Zeile, "
        "oder berichtigen Sie die Zahl"
    )


def test_a_question_about_a_log_is_asked_in_german(german, qtbot, tmp_path):
    wizard = ImportWizard("", tmp_path, german)
    qtbot.addWidget(wizard)
    question = LogQuestion(
        "its units are not known", ("force-unit=g to take it as it is",), "/x/log.csv"
    )
    wizard.files.show_problem(question)
    asked = wizard.files.question
    assert asked.text.text() == "log.csv: die Einheiten sind nicht bekannt"
    (answer,) = asked.answers.buttons()
    assert answer.text() == "force-unit=g um es so zu nehmen, wie es ist"
    answer.click()
    assert asked.other.text() == "force-unit=g"
    wizard.close_jobs()


def test_a_device_that_is_not_there_is_told_in_german(german, wait_for):
    german.session.choose_device("falcon:NONE")
    wait_for(german.messages.isVisible)
    said = german.messages.text()
    assert re.match(
        r"kein Falcon |libusb fehlt; |der Falcon |Sie d\u00fcrfen ", said
    ), said
