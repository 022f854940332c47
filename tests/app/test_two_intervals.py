"""A participant compares two plays of a clip, with the windows that people see."""

from PySide6.QtCore import Qt
from sitting import Person

from hapticplayer.study.pages import PageKind

WHICH = {
    "key": "which",
    "kind": "choice",
    "text": dict.fromkeys(("en", "fr", "de"), "Which?"),
    "choices": [
        {"key": key, "text": dict.fromkeys(("en", "fr", "de"), key)}
        for key in ("first", "second")
    ],
}


def test_a_participant_compares_two_plays_of_a_clip(make_study, sit, wait_for):
    pages = [{"key": "compared", "when": "after-clip", "questions": [WHICH]}]
    study = make_study(
        trial="two-interval",
        standard={"feedback": "realistic"},
        feedbacks=["realistic", "none"],
        pages=pages,
    )
    session = sit(study)
    person = Person(session, wait_for)
    person.page.buttons["agree"].setFocus()
    person.key(Qt.Key.Key_Space)
    person.wait_page(PageKind.DEMONSTRATION)
    person.page.buttons["next"].setFocus()
    person.key(Qt.Key.Key_Enter)
    person.wait_page(PageKind.READY, "trial-01")
    person.key(Qt.Key.Key_Enter)
    for text in ("Clip 1", "Clip 2"):
        person.wait_page(PageKind.INTERVAL, "trial-01")
        assert session.runner.page.text == text
        person.wait_page(PageKind.PLAYING, "trial-01")
    person.wait_page(PageKind.QUESTIONS, "trial-01")
    person.key(Qt.Key.Key_2)
    person.key(Qt.Key.Key_Enter)
    person.wait_page(PageKind.READY, "trial-02")
    records = session.study.session(session.runner.plan.code).records.intact
    (trial,) = [one.content for one in records if one.kind == "trial"]
    assert {one["feedback"] for one in trial["presented"]} == {"realistic", "none"}
    (answers,) = [one.content for one in records if one.kind == "answers"]
    assert answers["values"] == {"which": "second"}
