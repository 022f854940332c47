"""What a journal asks of a report, in the parts that HTML and PDF are made from."""

import re
import zlib
from dataclasses import replace

import numpy as np
import pytest

from hapticplayer.clock import SystemClock
from hapticplayer.devices import find_device
from hapticplayer.simulation.participants import simulated_answers
from hapticplayer.simulation.sessions import write_answers
from hapticplayer.study.analysis import AnalysisOptions, Resampling, analyse
from hapticplayer.study.analysis.analysis import statistics_of
from hapticplayer.study.analysis.blocks import (
    Paragraph,
    ReportFigure,
    ReportTable,
    numbered,
)
from hapticplayer.study.analysis.conduct_report import (
    identity,
    order_balance,
    playback,
)
from hapticplayer.study.analysis.pdf import write_pdf
from hapticplayer.study.analysis.report import parts_of, write_report
from hapticplayer.study.analysis.statistic import interval, number
from hapticplayer.study.answers import Participant, collect_answers
from hapticplayer.study.conduct import AnsweredPlayback, Conduct
from hapticplayer.study.creation import create_study


def parts(answers):
    resampling = Resampling(seed=7, count=99)
    return parts_of(analyse(answers, AnalysisOptions(resampling=resampling)))


def table(blocks, title) -> ReportTable:
    (found,) = (
        one
        for one in blocks
        if isinstance(one, ReportTable) and f". {title}" in one.title
    )
    return found


def text_of(blocks) -> str:
    return "\n".join(one.text for one in blocks if isinstance(one, Paragraph))


SECOND = {"rig:outsim": "nobody listens at 127.0.0.1:4123: start the rig's software"}


@pytest.fixture(scope="module")
def answers(make_answers):
    made = make_answers(5, 8, sequences=2)
    people = (
        Participant("A", 20, "female", "left", True, simulated=True),
        Participant("B", 30, "male", "right", False),
        Participant("C", None, None, "right", None),
    )
    people += tuple(replace(one, age=40) for one in made.participants[3:])
    names = dict(zip(["P00", "P01", "P02"], "ABC", strict=True))
    ratings = tuple(
        replace(one, participant=names.get(one.participant, one.participant))
        for one in made.ratings
    )
    figures = {
        "frames_shown": 90,
        "frames_dropped": 10,
        "silence_s": 0.25,
        "missed": 3,
        "ticks": 1000,
        "force_minus_video_ms": {"count": 9, "p05": -1.0, "p50": 2.0, "p95": 6.5},
    }
    later = {"count": 9, "p05": 1.0, "p50": 4.0, "p95": 8.0}
    conduct = Conduct(
        "Rides",
        "abc123",
        ("2026-01-02", "2026-02-03"),
        ("hapticplayer 0.0.9",),
        8,
        7,
        "williams",
        (1, 2),
        (0, 3),
        (
            AnsweredPlayback("none", 1, True, 10.0, figures),
            AnsweredPlayback(
                "none",
                2,
                False,
                14.0,
                {**figures, "force_minus_video_ms": later, "output_faults": SECOND},
                reasons=("output_fault", "fault:reply_lost"),
            ),
            AnsweredPlayback("random", 1, True, 30.0),
        ),
    )
    return replace(made, participants=people, ratings=ratings, conduct=conduct)


@pytest.fixture(scope="module")
def made(answers):
    return parts(answers)


def test_the_report_says_which_study_when_and_with_what(made):
    first = made.blocks[0].text
    for said in ("abc123", "2026-01-02 to 2026-02-03", "0.0.9", "Partly simulated"):
        assert said in first


def test_the_report_names_the_devices_of_its_sessions(answers):
    used = [["simulated"], ["falcon", "simulated"], "odd", ["gone:7"], None]
    trials = tuple(
        AnsweredPlayback("none", 1, True, 1.0, {"outputs": one}) for one in used
    )
    conduct = replace(answers.conduct, playbacks=trials)
    (first,) = identity(replace(answers, conduct=conduct))
    labels = [find_device(one).label for one in ("simulated", "falcon")]
    said = f"Devices: {labels[0]} (simulated), {labels[1]} (falcon) and gone:7."
    assert said in first.text


def test_one_answer_alone_makes_no_tables_of_dashes(answers):
    first = answers.ratings[0]
    ratings = [replace(one, is_valid=one is first) for one in answers.ratings]
    found = parts(replace(answers, ratings=tuple(ratings)))
    tables = [one for one in found.blocks if isinstance(one, ReportTable)]
    means = [one.title for one in tables if one.head[1:3] == ("n", "mean")]
    assert [one.partition(". ")[2] for one in means] == [
        f"{first.factor} by condition, all answers"
    ]
    warned = "\n".join(found.numbers["warnings"])
    assert "cannot be compared: there are none of one group" in warned
    assert "0 participants:" not in warned


def test_a_report_without_a_valid_answer_says_so_first(answers, tmp_path):
    ratings = tuple(replace(one, is_valid=False) for one in answers.ratings)
    found = parts(replace(answers, ratings=ratings))
    count = len(ratings)
    assert found.is_empty
    assert found.blocks[0].text.startswith(
        f"No valid answer yet: {count} of {count} answers are missing, {count} of them"
    )
    assert found.draw() == {}
    assert found.lines == ()
    assert found.numbers["warnings"] == [found.blocks[0].text]
    titles = [one.title for one in found.blocks if isinstance(one, ReportTable)]
    assert not any("Means" in one or "test" in one for one in titles)
    write_report(found, tmp_path / "report", "Rides")
    assert (tmp_path / "report" / "report.pdf").exists()


def test_the_report_describes_the_participants(made):
    rows = dict(table(made.blocks, "Participants of").rows)
    # 20, 30 and five of 40: mean 250 / 7, one of eight unknown
    assert rows["age, years"] == "mean 35.71, SD 7.87, range 20 to 40, 1 unknown"
    assert rows["handedness"] == "7 right, 1 left"
    assert rows["completed sessions"] == "7 of 8"
    assert rows["gender"].startswith("6 unknown")
    assert "had used such a device before" in rows["experience"]


def test_the_report_says_how_balanced_orders_were(made):
    text = text_of(made.blocks)
    assert "Williams" in text
    assert "1 to 2 times at each position" in text
    assert "0 to 3 times directly after" in text


@pytest.mark.parametrize(
    ("position", "words"), [((1, 1), "played once"), ((3, 3), "played 3 times")]
)
def test_counts_that_are_alike_are_told_once(answers, position, words):
    conduct = replace(answers.conduct, at_position=position, followed=(0, 0))
    text = text_of(list(order_balance(replace(answers, conduct=conduct))))
    assert f"{words} at each position, and never directly after" in text


def test_the_report_has_times_and_quality_of_playback(made):
    times = {row[0]: row[1:] for row in table(made.blocks, "Time from").rows}
    assert times["none"] == ("2", "12.0", "[11.0, 13.0]", "[10.0, 14.0]")
    assert times["realistic"] == ("0", "-", "-", "-")
    quality = {row[0]: row[1:] for row in table(made.blocks, "Quality").rows}
    expected = ("2", "1", "1", "20 of 200", "0.50", "6 of 2000", "3.0 [-1.0, 8.0]", "-")
    assert quality["none"] == expected
    assert quality["random"][:4] == ("1", "0", "0", "-")


def test_the_report_names_reasons_and_faulty_outputs(made):
    reasons = table(made.blocks, "Reasons why a playback").rows
    assert reasons == (("output fault", "1"), ("fault: reply_lost", "1"))
    faults = table(made.blocks, "What kept outputs").rows
    assert faults == (("rig:outsim", SECOND["rig:outsim"], "1"),)


@pytest.mark.parametrize("odd", [None, [1], "x", {"rig": 7}])
def test_damaged_faults_of_outputs_are_no_traceback(answers, odd):
    trial = AnsweredPlayback("none", 1, False, 1.0, {"output_faults": odd})
    conduct = replace(answers.conduct, playbacks=(trial,))
    blocks = list(playback(replace(answers, conduct=conduct), ["none"]))
    assert any(isinstance(one, ReportTable) for one in blocks)


def test_damaged_figures_of_a_playback_are_left_out(answers):
    odd = {"frames_shown": "many", "ticks": None, "missed": [1], "silence_s": 0.5}
    odd["force_minus_video_ms"] = {"p50": 3.0}
    trial = AnsweredPlayback("none", 1, True, "soon", odd)
    conduct = replace(answers.conduct, playbacks=(trial,))
    blocks = playback(replace(answers, conduct=conduct), ["none"])
    found = next(one for one in blocks if isinstance(one, ReportTable))
    assert found.rows[0] == ("none", "1", "0", "0", "-", "0.50", "-", "-", "-")


def test_a_playback_without_figures_has_no_columns_of_them(answers):
    trial = AnsweredPlayback("none", 1, True, 2.0)
    conduct = replace(answers.conduct, playbacks=(trial,))
    blocks = list(playback(replace(answers, conduct=conduct), ["none"]))
    quality = next(one for one in blocks if "Quality" in getattr(one, "title", ""))
    assert quality.head == ("feedback", "trials", "repeated", "not valid")
    assert quality.rows[0] == ("none", "1", "0", "0")


def test_tables_without_rows_are_left_out():
    empty = ReportTable("Nothing", ("of",), ())
    (shown,) = numbered([empty, replace(empty, title="More", rows=(("a",),))])
    assert shown.title == "Table 1. More"


@pytest.mark.parametrize(
    ("value", "text"), [(-0.001, "0.00"), (-0.006, "-0.01"), (2.0, "2.00")]
)
def test_a_zero_has_no_sign(value, text):
    assert number(value) == text
    assert interval((value, 1.0)) == f"[{text}, 1.00]"


def test_tables_and_figures_are_numbered(made):
    for kind, label in ((ReportTable, "Table"), (ReportFigure, "Figure")):
        found = [one for one in made.blocks if isinstance(one, kind)]
        captions = [getattr(one, "title", "") or one.caption for one in found]
        for place, caption in enumerate(captions, 1):
            assert caption.startswith(f"{label} {place}. ")
        assert captions


def test_each_f_t_and_chi_square_has_its_degrees_of_freedom(made):
    tables = [one for one in made.blocks if isinstance(one, ReportTable)]
    seen = [name for one in tables for name in one.head if name in ("F", "t", "chi²")]
    assert sorted(seen) == ["F", "F", "chi²", "chi²", "chi²", "t", "t", "t"]
    assert all("df" in one.head for one in tables if "t" in one.head)
    friedman = table(made.blocks, "Friedman")
    row = dict(zip(friedman.head, friedman.rows[0], strict=True))
    assert row["df"] == "2"
    assert row["df of F"] == "1.75, 12.25"  # k - 1 - 2/n and (n - 1) times that
    conover = table(made.blocks, "Pairs of feedbacks: Conover")
    assert dict(zip(conover.head, conover.rows[0], strict=True))["df"] == "14"
    assert "df" in table(made.blocks, "Sequence x feedback").head


def test_corrections_name_their_family_and_its_size(made):
    assert "5 tests of all measures" in table(made.blocks, "Friedman").note
    assert (
        "3 tests of each measure"
        in table(made.blocks, "Pairs of feedbacks: Wilcoxon").note
    )
    assert "15 tests of all measures" in table(made.blocks, "Participants who").note
    assert "Greenhouse" in table(made.blocks, "Sequence x feedback").note


def test_each_test_is_described_with_references_that_are_listed(made):
    text = text_of(made.blocks)
    listed = {one.text for one in made.blocks if isinstance(one, Paragraph)}
    for name, statistic in statistics_of(has_factors=False).items():
        described = statistic.methods(made.numbers[statistic.key or name])
        assert described in text
        cited = [one for one in statistic.references if one.split()[0] in described]
        assert bool(cited) is bool(described)
        for work in statistic.references:
            assert (work in listed) == (not work.startswith("Phipson"))
            year = re.search(r"\((\d{4})\)", work)[1]
            assert year in described or work not in cited
    assert "Holm S. (1979)" in text


def test_methods_say_what_was_decided(made, make_answers):
    text = text_of(made.blocks)
    assert "it doubles the smaller tail" in text
    assert "pairs without a difference were dropped" in text
    assert "permutation p was exact" in text
    assert "Monte Carlo" not in text
    for program in ("hapticplayer", "python", "numpy", "scipy"):
        assert re.search(rf"computed with .*{program} \d", text)
    large = text_of(parts(make_answers(5, 210, sequences=1)).blocks)
    assert "Phipson B., Smyth G. K. (2010)" in large
    assert "by Monte Carlo (99 random orders" in large
    assert "normal approximation for more than 100 participants" in large
    assert "doubles the smaller tail" not in large


def test_a_test_that_was_not_computed_is_not_described(make_answers):
    blocks = parts(make_answers(5, 1, sequences=2)).blocks
    text = text_of(blocks)
    assert "were compared by" not in text
    assert "Wilcoxon F. (1945)" not in text
    assert "0 tests" not in text + " ".join(getattr(one, "note", "") for one in blocks)
    assert all(one.rows for one in blocks if isinstance(one, ReportTable))


def test_figures_are_described_in_words(made, answers):
    figure = next(one for one in made.blocks if isinstance(one, ReportFigure))
    mean = np.mean(
        [
            sum(one.value for one in answers.ratings if one.participant == person.code
                and one.sequence == "clip-1" and one.feedback == "random")
            for person in answers.participants
        ]
    )  # fmt: skip
    part = figure.text.partition("clip-1")[2].partition(";")[0]
    assert f"random {mean:.2f} (SD" in part


def test_pages_and_figures_say_that_data_are_simulated(tmp_path):
    study = create_study(tmp_path / "study")
    origin = {"simulated": True}
    write_answers(study, simulated_answers(6, seed=1), SystemClock(), origin=origin)
    answers = collect_answers(study)
    target = tmp_path / "report"
    options = AnalysisOptions(resampling=Resampling(count=99))
    write_report(parts_of(analyse(answers, options)), target, "Rides")
    assert (
        '<div class="mark">simulated data</div>' in (target / "report.html").read_text()
    )
    for figure in target.glob("*.svg"):
        assert ">simulated data<" in figure.read_text()
    streams = pages_of((target / "report.pdf").read_bytes())
    assert len(streams) > 3
    assert all(b"0.6392 0.1255 0.1255 rg" in one for one in streams)


def test_a_header_is_repeated_on_each_page_of_its_table(tmp_path):
    rows = tuple((str(number), "5") for number in range(200))
    path = tmp_path / "table.pdf"
    write_pdf(path, "Rides", "", [ReportTable("Numbers", ("number", "n"), rows)], {})
    pages = pages_of(path.read_bytes())
    assert len(pages) > 2
    assert all(len(set(re.findall(rb"/F\d+ [0-9.]+ Tf", one))) > 1 for one in pages)


def test_real_data_have_no_mark(make_answers):
    assert parts(make_answers(5, 4, sequences=1)).mark == ""


def pages_of(pdf: bytes) -> list[bytes]:
    """Return the drawing commands of each page."""
    found = []
    for packed in re.findall(rb"stream\r?\n(.*?)\r?\nendstream", pdf, re.DOTALL):
        try:
            content = zlib.decompress(packed)
        except zlib.error:
            continue
        if b" Tf" in content and b"BT" in content:
            found.append(content)
    return found
