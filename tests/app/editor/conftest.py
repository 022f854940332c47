"""A sequence with the effects of a module, and the editor over it."""

import shutil

import numpy as np
import pytest
from faces import make_player

from app.editor.page import EditorPage
from app.editor.playing import PlayerSetup
from hapticplayer.clock import SystemClock
from hapticplayer.sequence.editing import set_effects


@pytest.fixture(scope="module")
def edited(request, sequence, tmp_path_factory):
    """The sequence with the module's `EFFECTS`."""
    target = tmp_path_factory.mktemp("edited") / "ride"
    shutil.copytree(sequence, target)
    set_effects(target, request.module.EFFECTS)
    return target


@pytest.fixture
def folder(edited, tmp_path):
    """A copy of it for one test."""
    return shutil.copytree(edited, tmp_path / "edited")


@pytest.fixture
def make_page(application, qtbot, settings, wait_for):
    made = []

    def make(folder, device="none", player=make_player):
        page = EditorPage(folder, PlayerSetup(SystemClock(), device, settings, player))
        clean = page.document.stack.setClean
        qtbot.addWidget(page, before_close_func=lambda _: clean())  # else it asks
        made.append(page)
        page.show()
        wait_for(lambda: page.loaded is not None or bool(page.messages.text()))
        wait_for(lambda: page.live is None or not page.live.is_busy)
        return page

    yield make
    for page in made:
        page.reject()


@pytest.fixture
def felt(make_page, folder, wait_for):
    """The editor and its player, whose force is felt."""
    page = make_page(folder, "simulated")
    player = page.playing.session.player
    wait_for(lambda: player.snapshot().leading.tick is not None)
    page.playing.toggle()

    def is_felt():
        force_n = player.ticks_since(-np.inf)["force_n"]
        return bool((np.linalg.norm(force_n, axis=1) > 0.5).any())

    wait_for(is_felt)
    return page, player
