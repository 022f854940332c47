"""A trial answered by fingers alone."""

from PySide6.QtCore import QPoint
from PySide6.QtTest import QTest
from sitting import Person

from hapticplayer.study.answers import read_answers
from hapticplayer.study.pages import PageKind


def test_by_touch_alone(make_study, sit, wait_for, qapp):
    session = sit(make_study())
    person, window = Person(session, wait_for), session.participant
    device = QTest.createTouchDevice()

    def tap(widget):
        wait_for(lambda: not window.guard.isActive())
        window.content.ensureWidgetVisible(widget)
        middle = QPoint(widget.width() // 2, widget.height() // 2)
        handle, at = window.windowHandle(), widget.mapTo(window, middle)
        QTest.touchEvent(handle, device).press(0, at, handle).commit()
        QTest.touchEvent(handle, device).release(0, at, handle).commit()

    tap(person.page.buttons["agree"])
    person.wait_page(PageKind.QUESTIONS, "sheet")
    person.answer_sheet()
    person.wait_page(PageKind.DEMONSTRATION)
    tap(person.page.buttons["next"])
    person.wait_page(PageKind.READY)
    tap(person.page.buttons["start"])
    person.wait_page(PageKind.PLAYING)
    session.player.set_end(0.2)
    person.wait_page(PageKind.QUESTIONS)
    for row, answer in zip(person.page.rows, (1, 2, 4, 5), strict=True):
        tap(row.group.button(answer - 1))
        assert row.value() == answer
    tap(person.page.next)
    person.wait_page(PageKind.READY, "trial-02")
    ratings = read_answers(session.study.folder).ratings
    assert [r.value for r in ratings if r.value is not None] == [1, 2, 4, 5]
