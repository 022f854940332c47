"""What a screen reader hears of each page, and the order in which Tab reads it."""

import importlib
import pkgutil

import face_checks
import faces
import hearing
from PySide6.QtWidgets import QDialog

import app
from app.widgets.job_dialog import JobDialog


def test_each_control_has_a_name_of_its_own_in_reading_order(
    dressed, make_window, source, tmp_path, qtbot
):
    dressed(language="en")
    window = make_window()
    window.session.show_source(source)
    wrong = {}

    def look(name, face):
        face.activateWindow()
        qtbot.waitUntil(face.isActiveWindow)
        found = list(hearing.wrong_names(face))
        if order := hearing.wrong_order(face, face_checks.reached_by_tab(face)):
            found.append(f"order: {order}")
        if found:
            wrong[name] = found

    look("window", window)
    for name, make in faces.dialogs(window, tmp_path).items():
        face = make()
        face.show()
        qtbot.waitExposed(face)
        look(name, face)
        faces.close(face)
    assert wrong == {}


def pages(base: type) -> set[type]:
    """All kinds of a page that the window has."""
    found = {one for one in base.__subclasses__() if one.__module__.startswith("app.")}
    return found | {one for each in found for one in pages(each)}


def test_the_pages_that_are_looked_at_are_all_of_the_window(
    dressed, make_window, source, tmp_path
):
    dressed(language="en")
    for module in pkgutil.walk_packages(app.__path__, "app."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)
    window, seen = make_window(), set()
    window.session.show_source(source)
    for make in faces.dialogs(window, tmp_path).values():
        face = make()
        seen.add(type(face))
        faces.close(face)
    assert pages(QDialog) - {JobDialog} <= seen
