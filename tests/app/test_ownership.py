"""What Qt's windows hold is freed by them alone, however the program ends.

Where Python believes that it owns a widget that is in a window, the widget is freed
twice when the interpreter ends: the program aborts, or not, as memory happens to lie.
"""

import os
import subprocess
import sys

import faces
from PySide6.QtCore import QObject
from shiboken6 import getAllValidWrappers, ownedByPython

EDITORS = """
import sys
from pathlib import Path

from app.experimenter.study.editor import StudyEditor
from app.player.application import make_application
from hapticplayer.study.creation import create_study

application = make_application()
study = create_study(Path(sys.argv[1]))
for _ in range(10):
    editor = StudyEditor(study.folder, Path.cwd)
    editor.show()
    application.processEvents()
    editor.close()
"""


def owned_twice() -> list[QObject]:
    """Return what has an owner in Qt, and Python for another.

    Nothing else may be asked before: `parent` and `findChildren` put it right.
    """
    ours = [w for w in getAllValidWrappers() if isinstance(w, QObject)]
    return [w for w in ours if ownedByPython(w) and w.parent() is not None]


def test_no_page_has_two_owners_for_anything(window, source, tmp_path):
    window.session.show_source(source)
    pages = faces.dialogs(window, tmp_path)
    before, found = owned_twice(), {}
    for name, make in pages.items():
        face = make()
        found[name] = [w for w in owned_twice() if w not in before]
        faces.close(face)
    assert {name: these for name, these in found.items() if these} == {}


def test_nobody_who_takes_part_meets_a_widget_with_two_owners(make_study, sit):
    before = owned_twice()
    session = sit(make_study())
    session.runner.consent(given=True)
    session.participant.refresh()
    assert [w for w in owned_twice() if w not in before] == []


def test_a_program_that_has_edited_studies_ends_well(tmp_path):
    command = [sys.executable, "-c", EDITORS, tmp_path / "study"]
    paths = os.pathsep.join(filter(None, sys.path))
    ended = subprocess.run(
        command,
        env=os.environ | {"PYTHONPATH": paths},
        capture_output=True,
        check=False,
        text=True,
    )
    assert "deleted directly" not in ended.stderr
    assert ended.returncode == 0, ended.stderr
