"""The guides name menus, buttons, commands and pictures that there are."""

import json
import re
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from PySide6.QtWidgets import QMenu

from hapticplayer.study.creation import create_study
from tests.needed_extras import needs

ROOT = Path(__file__).resolve().parents[2]
GUIDES = {path.name: path for path in [ROOT / "README.md", *ROOT.glob("docs/*.md")]}
WITH_WORDS = ("participant", "play", "import", "force", "effects", "developer")
NAMED = re.compile(r"(?<![*\w])\*([^*\n]+(?:\n[^*\n]+)?)\*(?!\*)")
MENUS = ("File", "Playback", "View", "Help", "Study")
LARGEST_BYTES = 300_000


def plain(text: str) -> str:
    return text.replace("&", "").rstrip("\u2026.").strip()


def named_in(guide: Path) -> list[str]:
    text = re.sub(r"```.*?```", "", guide.read_text(encoding="utf-8"), flags=re.DOTALL)
    return [" ".join(found.split()) for found in NAMED.findall(text)]


@pytest.fixture(scope="module")
def words(tmp_path_factory) -> set[str]:
    """Every text of the window, and every word of a study's pages."""
    tree = ET.parse(ROOT / "resources" / "i18n" / "de.ts")
    texts = {plain(m.findtext("source")) for m in tree.iter("message")}
    study = create_study(tmp_path_factory.mktemp("studies") / "study")
    pages = json.loads(study.content)["words"].values()
    return texts | {plain(word["en"]) for word in pages}


@pytest.mark.parametrize("name", WITH_WORDS)
def test_words_in_italics_in_a_guide_are_in_the_program(words, name):
    guide = GUIDES[f"{name}.md"]
    named = [part for text in named_in(guide) for part in text.split(" > ")]
    assert named
    assert [text for text in named if plain(text) not in words] == []


@needs("faults")
def test_every_menu_path_of_the_guides_exists(window):
    paths = {
        tuple(text.split(" > "))
        for guide in GUIDES.values()
        for text in named_in(guide)
        if text.split(" > ")[0] in MENUS and " > " in text
    }
    assert len(paths) >= 5
    assert [path for path in sorted(paths) if not _exists(window, path)] == []


def _exists(window, path: tuple[str, ...]) -> bool:
    actions = window.menuBar().actions()
    for name in path:
        action = next((a for a in actions if plain(a.text()) == plain(name)), None)
        if action is None:
            return False
        menu = action.menu()
        if isinstance(menu, QMenu):
            menu.aboutToShow.emit()
            actions = menu.actions()
    return True


@pytest.mark.parametrize("name", list(GUIDES))
def test_links_and_pictures_are_there_and_pictures_are_small(name):
    guide = GUIDES[name]
    text = guide.read_text(encoding="utf-8")
    links = [link.split("#")[0] for link in re.findall(r"\]\(([^)]+)\)", text)]
    near = [guide.parent / link for link in links if link and "://" not in link]
    assert [path for path in near if not path.exists()] == []
    pictures = [path for path in near if path.suffix == ".png"]
    assert [p for p in pictures if p.stat().st_size > LARGEST_BYTES] == []
