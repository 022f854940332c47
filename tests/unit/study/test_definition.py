"""`study.json`: what is right is read, what is wrong is named by its place."""

import json

import pytest

from hapticplayer.errors import InputError, StudyError, UsageError
from hapticplayer.study.creation import change_definition, create_study, template_names
from hapticplayer.study.definition import QuestionKind
from hapticplayer.study.definition_reader import parse_definition
from hapticplayer.study.study_folder import open_study


def parse(content):
    return parse_definition(json.dumps(content).encode(), "study.json")


def test_the_built_in_study_is_the_protocol_of_the_paper(template):
    study = parse(template)
    assert len(study.conditions) == 12
    assert [s.key for s in study.sequences] == [
        "bike",
        "horse",
        "car-turning",
        "car-braking",
    ]
    faithful, *others = study.feedbacks
    assert (faithful.name, faithful.condition) == ("realistic", "realistic")
    assert others == ["none", "random"]
    assert template["feedbacks"][0]["parameters"] == {"preset": "faithful"}
    assert [q.key for q in study.pages[1].questions] == [
        "realism",
        "sensory",
        "comfort",
        "satisfaction",
    ]
    assert all(q.kind is QuestionKind.SCALE for q in study.pages[1].questions)
    assert [q.key for q in study.pages[0].questions] == [
        "age",
        "gender",
        "handedness",
        "used_device_before",
    ]
    assert [q.key for q in study.pages[2].questions if q.for_each_feedback] == ["label"]


def test_feedbacks_may_have_parameters_and_names_of_their_own(template):
    late = {"key": "late", "condition": "delayed", "parameters": {"delay_s": 1}}
    template["feedbacks"] = ["none", late, {"condition": "shuffled"}, "own-track"]
    study = parse(template)
    assert study.feedback_keys == ("none", "late", "shuffled", "own-track")
    assert len(study.conditions) == 16
    assert study.conditions[1].key == "bike/late"
    assert study.chosen_feedbacks[1].parameters == {"delay_s": 1.0}
    assert "(delay_s 1)" in study.chosen_feedbacks[1].text


def test_shuffling_needs_a_second_sequence(template):
    template.update(feedbacks=["none", "shuffled"], sequences=template["sequences"][:1])
    with pytest.raises(StudyError, match=r"feedbacks\[1\]: needs a second sequence"):
        parse(template)


@pytest.mark.parametrize("name", template_names())
def test_every_template_is_whole_in_every_language(tmp_path, name):
    study = create_study(tmp_path / name, name).definition
    assert study.languages == ("en", "fr", "de")
    texts = [
        getattr(part, name)
        for part in (study.texts,)
        for name in part.__struct_fields__
    ]
    pages = [page for page in study.pages if not page.scale]  # test_scales has those
    texts += [page.text for page in pages if page.text]
    asked = [question for page in pages for question in page.questions]
    texts += [q.text for q in asked] + [la.text for q in asked for la in q.labels]
    rated = study.while_watching
    texts += [one.text for one in rated] + [one.rest for one in rated if one.rest]
    assert all(len({text[key] for key in study.languages}) == 3 for text in texts)


def test_the_second_kind_of_trial_shifts_the_force(tmp_path):
    study = create_study(tmp_path / "s", "consistency").definition
    assert len(study.conditions) == 4 * 8
    assert {c.delay_s for c in study.conditions} >= {-0.4, 0.0, 0.8}
    assert len({c.key for c in study.conditions}) == len(study.conditions)


def test_the_published_wording_is_shown_only_on_demand(template):
    template["pages"][1]["questions"][0]["published"] = {"en": "As printed"}
    own = parse(template)
    assert own.wording(own.pages[1].questions[0], "en") != "As printed"
    printed = parse({**template, "use_published": True})
    assert printed.wording(printed.pages[1].questions[0], "en") == "As printed"
    assert (
        printed.wording(printed.pages[1].questions[0], "fr")
        == printed.pages[1].questions[0].text["fr"]
    )


def chosen(condition, **more):
    """Return a change that adds a feedback with parameters."""
    return lambda d: d["feedbacks"].append({"condition": condition, **more})


def first(content, page):
    """The first question of a page."""
    return content["pages"][page]["questions"][0]


LABELS = [{"at": 20, "text": {"en": "a", "fr": "b", "de": "c"}}]
SPOILT = [
    (lambda d: d.update(version=2), "version 2"),
    (lambda d: d.pop("title"), "'title'"),
    (lambda d: d.update(colour="red"), "'colour'"),
    (lambda d: d["sequences"][1].update(key="bike"), "duplicate key 'bike'"),
    (lambda d: d["sequences"][2].update(key="../etc"), "sequences[2].key"),
    (lambda d: d["sequences"][2].update(key="bike2\n"), "sequences[2].key"),
    (lambda d: d["sequences"][2].update(key="-1"), "sequences[2].key"),
    (
        lambda d: d["pages"][1]["questions"][3]["text"].pop("de"),
        "pages[1].questions[3].text",
    ),
    (
        lambda d: d["pages"][1]["questions"][0].update(kind="text"),
        "pages[1].questions[0].least: is not used in text questions",
    ),
    (lambda d: d["order"].update(seed=1.5), "order.seed"),
    (lambda d: d["order"].update(seed=True), "order.seed"),
    (lambda d: d["order"].update(method="dice"), "williams"),
    (lambda d: d["limits"].update(sync_ms=-1), "limits.sync_ms"),
    (lambda d: d["limits"].update(silence_s=10**400), "limits.silence_s"),
    (lambda d: d.update(feedbacks=[]), "feedbacks"),
    (chosen("delayed", parameters={"delay_s": 9}), "feedbacks[3].parameters.delay_s"),
    (chosen("delayed", parameters={"delay_s": "1"}), "must be a number"),
    (chosen("delayed", parameters={"late": 1}), "feedbacks[3].parameters: unknown"),
    (chosen("shuffled", parameters={"of": "boat"}), "feedbacks[3].parameters.of"),
    (
        chosen("realistic", key="r2", parameters={"preset": "x"}),
        "one of faithful, balanced",
    ),
    (chosen("mine", parameters={"a": 1}), "feedbacks[3].condition: 'mine' has no"),
    (chosen("delayed", key="A B"), "feedbacks[3].key: is not a valid key"),
    (chosen("delayed", key="-a"), "feedbacks[3].key: is not a valid key"),
    (chosen("delayed", key="a\n"), "feedbacks[3].key: is not a valid key"),
    (chosen("none"), "duplicate key 'none'"),
    (lambda d: d["feedbacks"].append(7), "feedbacks[3]: must be a text / an object"),
    (lambda d: d["feedbacks"].append({}), "feedbacks[3]: missing entry 'condition'"),
    (chosen("delayed", key="edited"), "feedbacks[3].key: 'edited' is the name of"),
    (lambda d: d.update(pages=[]), "pages: must have at least 1 entries"),
    (lambda d: d["pages"].pop(1), "pages: has no question after a clip"),
    (lambda d: d["pages"][1].update(questions=[]), "pages[1].questions: must have"),
    (lambda d: d["pages"][1].update(key="sheet"), "pages[1].key: duplicate key"),
    (lambda d: d["pages"][1].update(key="trial-1"), "pages[1].key: 'trial-1' is the"),
    (
        lambda d: d["pages"][1].update(when="later"),
        "one of before, before-clip, after-clip, after",
    ),
    (lambda d: d["pages"][1].update(replays=True), "pages[1].replays: is only used"),
    (lambda d: d["pages"][1].update(text={"en": "x"}), "pages[1].text"),
    (lambda d: first(d, 1).update(key="age"), "pages[1].questions[0].key: duplicate"),
    (lambda d: first(d, 1).update(key="qoe"), "'qoe' is the name of the sum"),
    (lambda d: first(d, 1).update(kind="likert"), "one of scale, visual, number"),
    (lambda d: first(d, 1).update(help={"en": "x"}), "pages[1].questions[0].help"),
    (lambda d: first(d, 1).update(most=30), "questions[0].most: must have 2 to 21"),
    (lambda d: first(d, 1).update(least=5), "questions[0].most: must have 2 to 21"),
    (lambda d: first(d, 1).update(least=6), "questions[0].most: must be at least 6"),
    (lambda d: first(d, 1).update(most=4), "labels[1].at: must be between 1 and 4"),
    (lambda d: first(d, 1)["labels"][1].update(at=1), "labels[1].at: the point 1 has"),
    (lambda d: first(d, 1)["labels"][1].pop("text"), "labels[1]: missing entry 'text'"),
    (lambda d: first(d, 1).update(kind="visual"), "least: is not used in visual"),
    (lambda d: first(d, 0).update(in_qoe=True), "in_qoe: is not used in number"),
    (lambda d: first(d, 0).update(labels=LABELS), "labels: is not used in number"),
    (lambda d: first(d, 0).update(least=1.5), "questions[0].least: must be a whole"),
    (lambda d: first(d, 0).pop("most"), "questions[0].most: missing entry 'most'"),
    (lambda d: first(d, 2).update(most=0), "questions[0].most: must be between 1 and"),
    (lambda d: d.update(repeats=2), "repeats: is not used in rating trials"),
    (lambda d: d.update(levels=[{}]), "levels: is not used in rating trials"),
    (
        lambda d: d["pages"][0]["questions"][3].update(least=1),
        "pages[0].questions[3].least: is not used",
    ),
    (
        lambda d: d["pages"][2]["questions"][0].update(least=5),
        "pages[2].questions[0].least: is not used",
    ),
    (
        lambda d: d["pages"][1]["questions"][1].update(for_each_feedback=True),
        "for_each_feedback",
    ),
    (
        lambda d: d["pages"][0]["questions"][1].update(for_each_feedback=True),
        "for_each_feedback",
    ),
    (lambda d: d.update(use_published=True), "use_published: no question has"),
    (lambda d: d["texts"].update(consent="yes"), "texts.consent"),
    (lambda d: d["pages"][0]["questions"][0].pop("least"), "'least'"),
    (
        lambda d: d["pages"][0]["questions"][1].update(choices=[]),
        "questions[1].choices: must have at least 2",
    ),
    (
        lambda d: d["texts"]["consent"].update(fr=3),
        "texts.consent.fr: must be a text",
    ),
    (lambda d: d["texts"]["consent"].update(fr=" "), "consent.fr: is empty"),
    (lambda d: d["checks"].update(scheduling=["fast"]), "one of fifo, normal, slice"),
    (
        lambda d: d["order"].update(method="williams", no_sequence_twice_in_a_row=True),
        "Williams",
    ),
]


@pytest.mark.parametrize(("spoil", "place"), SPOILT)
def test_a_wrong_field_of_a_study_is_named(template, spoil, place):
    spoil(template)
    with pytest.raises(StudyError) as refusal:
        parse(template)
    assert place in str(refusal.value)
    assert "study.json" in str(refusal.value)


def test_more_conditions_than_could_be_listed_are_refused(template):
    title = template["sequences"][0]["title"]
    for name, rest in (("sequences", {"title": title, "folder": ""}), ("feedbacks", {"condition": "delayed"})):  # fmt: skip
        template[name] = [{"key": f"k{number}", **rest} for number in range(2000)]
    template |= {"trial": "yes-no", "levels": [{"gain": 1.0}] * 2000, "repeats": 100}
    with pytest.raises(StudyError, match="must have 2 to 400 conditions, has 8000000"):
        parse(template)


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"pages": 1}, "pages: has no yes-or-no question after a clip"),
        ({"levels": [{"gain": 1.0}, {"gain": 1.0}]}, "levels: holds a level twice"),
    ],
)
def test_entries_that_consistency_trials_ignore_are_named(
    tmp_path, template, change, place
):
    made = create_study(tmp_path / "s", "consistency")
    given = {**change, "pages": template["pages"]} if "pages" in change else change
    with pytest.raises(StudyError, match=place):
        parse({**json.loads(made.content), **given})


@pytest.mark.parametrize(
    "content", [b"", b"[]", b"{", b"\xff\xfe", b'{"a":1,"a":2}', b"[" * 100_000, b"NaN"]
)
def test_a_file_that_is_not_a_study_is_refused(content):
    with pytest.raises(StudyError):
        parse_definition(content, "study.json")


def test_a_study_is_never_overwritten(tmp_path):
    create_study(tmp_path / "s")
    before = (tmp_path / "s" / "study.json").read_bytes()
    with pytest.raises(InputError, match="already exists"):
        create_study(tmp_path / "s")
    assert (tmp_path / "s" / "study.json").read_bytes() == before


def test_unknown_templates_and_sequences_are_wrong_usage(tmp_path):
    with pytest.raises(UsageError, match="qoe2012"):
        create_study(tmp_path / "s", "nothing")
    with pytest.raises(UsageError, match="bike"):
        create_study(tmp_path / "s", folders={"boat": tmp_path})
    assert not (tmp_path / "s").exists()


def test_a_definition_that_another_program_changed_is_kept(tmp_path):
    ours = create_study(tmp_path / "s")
    theirs = json.loads(ours.content)
    theirs["title"] = "theirs"
    change_definition(ours, theirs)
    with pytest.raises(StudyError, match="changed by another program meanwhile"):
        change_definition(ours, json.loads(ours.content))
    assert open_study(tmp_path / "s").definition.title == "theirs"
