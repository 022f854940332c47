"""The page of preferences, and where commands stand in the menus."""

import pytest
from PySide6.QtCore import QPoint

from app.bridge.settings import library_folder
from app.experimenter.library_page import LibraryPage
from app.player import extras
from app.player.keys_dialog import KeysDialog
from app.player.preferences import PreferencesPage
from app.player.viewing import FRAMES


@pytest.fixture
def page(window):
    window.commands.preferences.trigger()
    return window.findChild(PreferencesPage)


def choose(combo, value):
    combo.setCurrentIndex(combo.findData(value))


def test_preferences_are_kept_when_they_are_accepted(page, window, settings, tmp_path):
    page.library.take(str(tmp_path / "rides"))
    page.frames.take(str(tmp_path / "frames"))
    page.resumes.setChecked(False)
    page.accept_button.click()
    assert library_folder(settings) == tmp_path / "rides"
    assert window.viewing.folder == tmp_path / "frames"
    assert settings.flag(extras.RESUMES, default=True) is False


def test_preferences_that_are_cancelled_are_not_kept(page, settings, tmp_path):
    before = library_folder(settings)
    page.library.take(str(tmp_path / "rides"))
    page.reject()
    assert library_folder(settings) == before
    assert settings.text(FRAMES) == ""


def test_only_another_theme_asks_for_another_window(page, window):
    asked = []
    window.themes.changed.connect(lambda: asked.append(True))
    page.accept()
    assert asked == []
    window.show_preferences()
    page = window.findChildren(PreferencesPage)[-1]
    choose(page.theme, "light")
    page.accept()
    assert asked == [True]
    window.settings.keep("look", "dark")


def test_pages_of_their_own_are_reached_from_there(page, window, wait_for):
    page.page_wanted.emit("shortcuts")
    wait_for(lambda: window.findChild(KeysDialog) is not None)
    window.findChild(KeysDialog).close()


def test_a_clip_begins_at_its_beginning_where_that_is_preferred(
    window, long_source, settings
):
    history = window.extras.history
    window.session.show_source(long_source)
    window.player.seek(60.0)
    history.note_position(window.player)
    for resumes, at_s in ((False, 0.0), (True, 60.0)):
        settings.keep(extras.RESUMES, resumes)
        window.session.show_source(long_source)
        window.session.chosen.emit(long_source)
        assert window.player.snapshot().media_s == pytest.approx(at_s, abs=0.2)
        window.player.seek(60.0)


def test_letters_of_a_menu_are_used_once(window):
    for name, menu in window.commands.menus.items():
        texts = [action.text().replace("&&", "") for action in menu.actions()]
        letters = [t[t.index("&") + 1].lower() for t in texts if "&" in t]
        assert len(set(letters)) == len(letters), (name, sorted(letters))


def test_devices_and_editing_have_menus_of_their_own(window):
    menus = window.commands.menus
    said = {
        name: {a.text().replace("&", "").rstrip("\u2026") for a in menu.actions()}
        for name, menu in menus.items()
    }
    assert {"Set up the device", "Outputs", "Stop the force"} <= said["device"]
    assert {"Edit effects", "Rendering", "Preferences"} <= said["edit"]
    assert {"Guide", "System check", "Report a problem"} <= said["help"]
    assert not said["device"] & (said["playback"] | said["view"]) - {""}


@pytest.fixture
def library(application, sequence, qtbot):
    made = LibraryPage(sequence.parent)
    made.show()
    yield made
    made.close_jobs()
    made.close()


def test_a_right_click_on_a_sequence_offers_what_its_buttons_do(library):
    item = library.list.currentItem()
    menu = library.open_menu(library.list.visualItemRect(item).center())
    said = [action.text().replace("&", "") for action in menu.actions()]
    assert said[:2] == ["Open", "Effects\u2026"]
    assert "Show in the file manager" in said
    opened = []
    library.open_wanted.connect(opened.append)
    menu.actions()[0].trigger()
    assert opened == [library.list.item(0).data(256).folder]


def test_a_right_click_beside_the_sequences_offers_nothing(library):
    assert library.open_menu(QPoint(5, library.list.viewport().height() - 2)) is None
