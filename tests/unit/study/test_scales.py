"""Scales: their files, scores by the published keys, and where the scores go."""

import csv
import json
import re

import numpy as np
import pytest

from hapticplayer import cli
from hapticplayer.errors import StudyError
from hapticplayer.study.analysis.reliability import reliability
from hapticplayer.study.analysis.report import analyse_study
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import (
    add_scale,
    create_study,
    definition_text,
)
from hapticplayer.study.definition import When
from hapticplayer.study.definition_reader import parse_definition, to_be_worded
from hapticplayer.study.scales import (
    SCALES,
    TEMPLATES,
    page_of_scale,
    read_scale,
    scale_names,
)
from hapticplayer.study.scoring import PageScores

LAB_BRINGS_WORDING = {"hxi", "ipq"}


def asked(study, name, when=When.BEFORE, key="s"):
    """The page of a scale in a study."""
    return add_scale(study, name, key, when).definition.pages[-1]


def scored(page, numbers):
    """The scores of answers in the order of the items, without the page's key."""
    scores = PageScores(page)
    values = {q.key: n for q, n in zip(page.questions, numbers, strict=True)}
    found = scores.numbers(values)
    return {key.removeprefix(f"{page.key}_"): found[key] for key in scores.scores}


# --- a second scorer, from the publications: items by their number on the sheet -----

SSQ_SHEETS = {  # Kennedy et al. (1993), table 5: the items with a 1 in each column
    "n": ((1, 6, 7, 8, 9, 15, 16), 9.54),
    "o": ((1, 2, 3, 4, 5, 9, 11), 7.58),
    "d": ((5, 8, 10, 11, 12, 13, 14), 13.92),
}


def by_ssq(sheet):
    raw = {
        name: sum(sheet[i - 1] for i in items)
        for name, (items, _) in SSQ_SHEETS.items()
    }
    found = {name: raw[name] * factor for name, (_, factor) in SSQ_SHEETS.items()}
    return {**found, "total": 3.74 * sum(raw.values())}


def by_sus(sheet):
    odd = sum(x - 1 for x in sheet[::2])
    return {"sus": 2.5 * (odd + sum(5 - x for x in sheet[1::2]))}


def by_ueq_s(sheet):
    found = {"pragmatic": sheet[:4], "hedonic": sheet[4:], "overall": sheet}
    return {name: sum(part) / len(part) for name, part in found.items()}


def by_ipq(sheet):
    s = [6 - x if number in (3, 9, 11) else x for number, x in enumerate(sheet, 1)]
    parts = {"presence": s[:1], "spatial": s[1:6], "involvement": s[6:10]}
    parts["realism"] = s[10:]
    return {name: sum(part) / len(part) for name, part in parts.items()}


def by_hxi(sheet):
    names = ("autotelics", "involvement", "realism", "discord", "harmony")
    found = {n: sum(sheet[4 * i : 4 * i + 4]) / 4 for i, n in enumerate(names)}
    turned = {**found, "discord": 8 - found["discord"]}
    return {**found, "total": sum(turned.values())}


def by_rtlx(sheet):
    return {"rtlx": sum(sheet) / 6}


def by_qoe(sheet):
    return {"sum": sum(sheet)}


SCORERS = {
    "ssq": (by_ssq, 0, 3),
    "sus": (by_sus, 1, 5),
    "ueq-s": (by_ueq_s, -3, 3),
    "ipq": (by_ipq, 0, 6),
    "hxi": (by_hxi, 1, 7),
    "rtlx": (by_rtlx, 0, 100),
    "qoe2012": (by_qoe, 1, 5),
}


@pytest.mark.parametrize("name", SCORERS)
def test_scores_are_those_of_a_second_scorer(study, name):
    page, rng = asked(study, name), np.random.default_rng(5)
    scorer, least, most = SCORERS[name]
    for _ in range(200):
        sheet = rng.integers(least, most + 1, len(page.questions)).tolist()
        assert scored(page, sheet) == pytest.approx(scorer(sheet), abs=1e-9)


# worked by hand from the published keys; the greatest scores are those of the papers
WORKED = [
    ("ssq", [3] * 16, {"n": 200.34, "o": 159.18, "d": 292.32, "total": 235.62}),
    # discomfort 1, nausea 2, vertigo 3: N (1 + 2) x 9.54, O 1 x 7.58, D (2 + 3) x 13.92
    (
        "ssq",
        [1, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 3, 0, 0],
        {"n": 28.62, "o": 7.58, "d": 69.6, "total": 33.66},
    ),
    ("sus", [5, 1] * 5, {"sus": 100.0}),
    ("sus", [3] * 10, {"sus": 50.0}),
    # 3 + 3 + 4 + 4 + 2 of the odd, 3 + 4 + 3 + 2 + 4 of the even ones: 32 x 2.5
    ("sus", [4, 2, 4, 1, 5, 2, 5, 3, 3, 1], {"sus": 80.0}),
    ("rtlx", [50, 10, 30, 20, 60, 5], {"rtlx": 175 / 6}),
]


@pytest.mark.parametrize(("name", "sheet", "expected"), WORKED)
def test_scores_are_those_worked_by_hand(study, name, sheet, expected):
    assert scored(asked(study, name), sheet) == pytest.approx(expected, abs=1e-9)


def test_means_of_travel_sickness_leave_out_what_was_not_used(study):
    """Golding 2006: sum x 9 / (9 - types not used), and the percentile's polynomial."""
    page = asked(study, "mssq-short")
    child = ["3", "1", "na", "na", "2", "0", "0", "1", "2"]  # 9 of 7 types: 11.571
    adult = ["1", "0", "0", "0", "1", "na", "na", "na", "1"]  # 3 of 6 types: 4.5
    found = scored(page, child + adult)
    raw = 9 * 9 / 7 + 3 * 9 / 6
    expected = 5.1160923 * raw - 0.055169904 * raw**2
    expected += -0.00067784495 * raw**3 + 1.0714752e-5 * raw**4
    assert found["child"] == pytest.approx(9 * 9 / 7, abs=1e-9)
    assert found["adult"] == pytest.approx(4.5)
    assert found["raw"] == pytest.approx(raw, abs=1e-9)
    assert found["percentile"] == pytest.approx(expected, abs=1e-6)
    never = scored(page, ["na"] * 9 + adult)
    assert (never["child"], never["raw"], never["adult"]) == (None, None, 4.5)


def test_a_score_is_missing_where_an_item_is(study):
    page = asked(study, "ssq")
    found = scored(page, [None, *[1] * 15])
    assert found == {"n": None, "o": None, "d": pytest.approx(97.44), "total": None}


# --- files ----------------------------------------------------------------------------


@pytest.mark.parametrize("name", scale_names())
def test_each_scale_makes_a_study_in_three_languages(study, name):
    content = json.loads(study.content)
    page = page_of_scale(name, "s", When.AFTER_CLIP, content["languages"])
    made = parse_definition(
        definition_text({**content, "pages": [*content["pages"], page]}), name
    )
    open_texts = list(to_be_worded(made))
    scale = read_scale(name)
    lacking = {field.rpartition(".")[2] for field in open_texts}
    assert lacking == {"en", "fr", "de"} - scale.wordings.keys()
    assert (not scale.wordings) == (name in LAB_BRINGS_WORDING)
    assert scale.source
    assert scale.licence


def test_all_scales_are_listed(capsys):
    assert cli.main(["study", "scales"]) == 0
    told = capsys.readouterr().out
    assert all(name in told for name in scale_names())
    assert cli.main(["study", "scales", "ssq", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["items"] == 16
    assert "13.92" in told["scores"]["d"]
    assert "Kennedy" in told["source"]


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"of": ["s_fms"]}, "scores[0].of"),
        ({"of": ["nobody"]}, "scores[0].of"),
        ({"reversed": ["s_1"], "of": ["s_2"]}, "scores[0].reversed"),
        ({"least_answered": 2}, "scores[0].least_answered"),
        ({"key": "realism"}, "scores[0].key"),
        ({"key": "qoe"}, "scores[0].key"),
    ],
)
def test_a_score_that_cannot_be_computed_is_refused(study, change, field):
    content = json.loads(add_scale(study, "sus", "s", When.AFTER).content)
    content["pages"][-1]["scores"][0] |= change
    with pytest.raises(StudyError) as refused:
        parse_definition(definition_text(content), "study.json")
    assert refused.value.where == f"study.json, pages[3].{field}"


# --- a study with scales -----------------------------------------------------------------


def table(path):
    return list(csv.DictReader(path.read_text().splitlines()))


@pytest.fixture(scope="module")
def answered(tmp_path_factory):
    """A study with scales before, after and between, and simulated participants."""
    folder = tmp_path_factory.mktemp("scales") / "study"
    study = create_study(folder, languages=["en"])
    for name, key, when in (
        ("mssq-short", "mssq", When.BEFORE),
        ("ssq", "pre", When.BEFORE),
        ("fms", "base", When.BEFORE_CLIP),
        ("ueq-s", "ueq", When.AFTER_CLIP),
        ("misc", "now", When.AFTER_CLIP),
        ("ssq", "post", When.AFTER),
    ):
        study = add_scale(study, name, key, when)
    assert cli.main(["study", "simulate", str(folder), "--participants=6"]) == 0
    return study


def test_scores_are_columns_with_their_meaning(answered, tmp_path):
    out = tmp_path / "out"
    assert cli.main(["study", "export", str(answered.folder), "-o", str(out)]) == 0
    people, trials = table(out / "participants.csv"), table(out / "trials.csv")
    pages = {page.key: page for page in answered.definition.pages}
    for row in people:
        sheet = [int(row[q.key]) for q in pages["pre"].questions]
        assert float(row["pre_total"]) == pytest.approx(
            by_ssq(sheet)["total"], abs=1e-6
        )
        assert "post_total" in row
        assert row["mssq_raw"] or "na" in row.values()
    for row in trials:
        sheet = [int(row[q.key]) for q in pages["ueq"].questions]
        assert float(row["ueq_hedonic"]) == pytest.approx(by_ueq_s(sheet)["hedonic"])
        assert row["now_misc"] in map(str, range(11))
        assert row["base_fms"] in map(str, range(21))
    meant = {one["column"]: one for one in table(out / "data_dictionary.csv")}
    assert "9.54 x; x: sum of pre_discomfort" in meant["pre_n"]["meaning"]
    assert meant["pre_n"]["unit_or_levels"] == "from 0 to 200.34"


def test_scores_are_described_in_bids(answered, tmp_path):
    out = tmp_path / "out"
    words = ["study", "export", str(answered.folder), "-o", str(out), "--format=bids"]
    assert cli.main(words) == 0
    trials = json.loads((out / "task-qoe_beh.json").read_text())
    assert "mean of ueq_supportive" in trials["ueq_pragmatic"]["Description"]
    people = json.loads((out / "participants.json").read_text())
    assert "from 0 to 235.62" in people["post_total"]["Description"]
    beh = next(out.rglob("*_beh.tsv")).read_text().splitlines()
    assert {"ueq_pragmatic", "ueq_hedonic"} <= set(beh[0].split("\t"))


def test_feedbacks_are_compared_by_scores_not_by_their_items(answered):
    found = read_answers(answered.folder)
    scores = ("ueq_pragmatic", "ueq_hedonic", "ueq_overall")
    qoe = ("realism", "sensory", "comfort", "satisfaction")
    assert found.factors == (*qoe, *scores, "now_misc")
    assert found.ranges["ueq_overall"] == (-3.0, 3.0)
    assert found.ranges["now_misc"] == (0, 10)
    assert found.qoe == qoe


def test_the_report_has_scores_reliability_and_change(answered):
    report = analyse_study(read_answers(answered.folder))
    scales = report.numbers["scales"]
    people = [dict(p.values) for p in read_answers(answered.folder).participants]
    pages = {page.key: page for page in answered.definition.pages}
    pre = [by_ssq([p[q.key] for q in pages["pre"].questions])["total"] for p in people]
    assert scales["pre_total"]["mean"] == pytest.approx(np.mean(pre), abs=1e-6)
    assert scales["pre_total"]["items"] == 16
    assert scales["post_total"]["change_from"] == "pre_total"
    assert scales["post_total"]["change"]["n"] == 6
    assert set(scales["ueq_hedonic"]["feedbacks"]) == {"realistic", "none", "random"}
    counted = report.numbers["questions"]["base_fms"]["feedbacks"]
    assert {one["n"] for one in counted.values()} == {6 * 4}
    texts = "\n".join(map(repr, report.blocks))
    assert "Kennedy R. S." in texts
    assert "Change from before to after" in texts


# --- reliability ---------------------------------------------------------------------------


def sample_with(covariance, count=40):
    """Answers whose covariances are exactly these."""
    rng = np.random.default_rng(1)
    drawn = rng.normal(size=(count, len(covariance)))
    drawn -= drawn.mean(axis=0)
    white = drawn @ np.linalg.inv(np.linalg.cholesky(np.cov(drawn, rowvar=False))).T
    return white @ np.linalg.cholesky(covariance).T


def test_alpha_is_that_worked_by_hand():
    # variances 2.5, 2.5, 4.3; of the sum 22.5: 3/2 (1 - 9.3 / 22.5)
    answers = np.array([[1, 2, 1], [2, 1, 2], [3, 3, 4], [4, 5, 3], [5, 4, 6]], float)
    found = reliability(answers)
    total = answers.sum(axis=1).var(ddof=1)
    expected = 1.5 * (1.0 - answers.var(axis=0, ddof=1).sum() / total)
    assert (found.n, found.items) == (5, 3)
    assert found.alpha == pytest.approx(expected)


@pytest.mark.parametrize(
    ("loadings", "own"),
    [((0.9, 0.7, 0.5, 0.3), (0.3, 0.6, 0.9, 1.2)), ((2.0, 1.0, 0.5), (1.0, 3.0, 0.2))],
)
def test_omega_recovers_one_factor(loadings, own):
    covariance = np.outer(loadings, loadings) + np.diag(own)
    found = reliability(sample_with(covariance))
    common = sum(loadings) ** 2
    assert found.omega == pytest.approx(common / (common + sum(own)), abs=1e-6)
    assert found.alpha < found.omega


def test_omega_is_alpha_where_items_are_equal():
    covariance = np.full((5, 5), 0.4) + 0.6 * np.eye(5)
    found = reliability(sample_with(covariance))
    assert found.omega == pytest.approx(found.alpha, abs=1e-6)
    assert found.alpha == pytest.approx(5 * 0.4 / (1 + 4 * 0.4))


def test_reliability_is_open_where_it_is_not_defined():
    alike = np.array([[1.0, 2.0], [1.0, 3.0], [1.0, 4.0]])
    assert reliability(alike).alpha is None
    assert reliability(alike[:1]).omega is None
    two = reliability(np.array([[1.0, 2.0], [2.0, 4.0], [3.0, 5.0]]))
    assert two.alpha is not None
    assert two.omega is None


def french(part):
    """Yield the French texts of a file."""
    if isinstance(part, dict):
        for name, one in part.items():
            yield from [one] if name == "fr" else french(one)
    elif isinstance(part, list):
        for one in part:
            yield from french(one)


def test_french_texts_have_french_spaces_and_apostrophes():
    texts = [
        text
        for folder in (SCALES, TEMPLATES)
        for path in folder.glob("*.json")
        for text in french(json.loads(path.read_text(encoding="utf-8")))
    ]
    assert len(texts) > 150
    assert [text for text in texts if re.search("[^\u00a0][:;?!]|'", text)] == []
