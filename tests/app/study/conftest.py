"""The editor of a study, as an experimenter opens it."""

import pytest

from app.experimenter.study.editor import StudyEditor


@pytest.fixture
def library(tmp_path):
    """Holds no ride; a module may have one that does."""
    return tmp_path


@pytest.fixture
def edit(application, qtbot, library):
    """Open the editor of a study."""
    made = []

    def open_editor(folder) -> StudyEditor:
        editor = StudyEditor(folder, lambda: library)
        qtbot.addWidget(editor)
        editor.show()
        made.append(editor)
        return editor

    yield open_editor
    for editor in made:
        editor.close_jobs()
