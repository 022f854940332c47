"""Front ends reach the engine through the player's values and commands alone."""

import ast
import dataclasses
from pathlib import Path

import pytest

from hapticplayer.clock import ManualClock
from hapticplayer.playback.player import Player

ROOT = Path(__file__).parents[3]
ROOMS = ("app", "hapticplayer/study", "hapticplayer/cli")


@pytest.fixture
def player():
    made = Player(ManualClock(), audio=None)
    yield made
    made.close()


def test_the_player_has_commands_and_no_public_parts(player):
    assert [name for name in vars(player) if not name.startswith("_")] == []
    public = {name for name in dir(player) if not name.startswith("_")}
    values = {name for name in public if not callable(getattr(player, name))}
    assert values == {
        "latch",
        "output_names",
        "are_outputs_free",
        "first_frame_s",
        "media_clock",
    }


def test_snapshots_are_frozen(player):
    for value in (player.snapshot(), player.measurements()):
        name = dataclasses.fields(value)[0].name
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(value, name, None)


def reaches_inside(node: ast.AST) -> bool:
    """Whether an expression takes a private member of something called player."""
    if not isinstance(node, ast.Attribute) or not node.attr.startswith("_"):
        return False
    owner = node.value
    name = getattr(owner, "attr", getattr(owner, "id", ""))
    return name in ("player", "_player")


@pytest.mark.parametrize("room", ROOMS)
def test_front_ends_do_not_reach_inside_the_player(room):
    found = [
        f"{path.relative_to(ROOT)}:{node.lineno}"
        for path in (ROOT / room).rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if reaches_inside(node)
    ]
    assert found == []
