"""What a screen reader hears of each page, and the order in which Tab reads it."""

import faces
import hearing


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
        if order := hearing.wrong_order(face, faces.reached_by_tab(face)):
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
