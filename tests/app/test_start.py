"""What the window does not load before it is wanted."""

import os
import subprocess
import sys

import pytest

from app import __main__ as program
from app.player import dialogs

LOADED = """
import sys
{code}
print(" ".join(name for name in sys.modules if name.startswith({prefixes!r})))
"""


def loaded(code: str, *prefixes: str) -> set[str]:
    """Return which modules some code loads in a fresh interpreter."""
    script = LOADED.format(code=code, prefixes=prefixes)
    found = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, check=True, text=True
    )
    return set(found.stdout.split())


def test_playing_loads_no_dialog_no_pipeline_and_no_driver() -> None:
    modules = loaded("import app.player.application", "app", "hapticplayer", "scipy")
    unwanted = {
        *dialogs._LATER,
        "hapticplayer.sequence.build",
        "hapticplayer.capture.formats",
        "hapticplayer.study",
        "hapticplayer.devices.falcon.driver",
        "hapticplayer.devices.gamepad.driver",
        "scipy",
    }
    assert "app.player.window" in modules
    assert not unwanted & modules


def test_what_is_loaded_later_is_there() -> None:
    dialogs._load()
    assert set(dialogs._LATER) <= set(sys.modules)


@pytest.mark.parametrize("chosen", [None, "3"])
def test_the_environment_of_other_programs_is_left_as_it_was(
    monkeypatch: pytest.MonkeyPatch, chosen: str | None
) -> None:
    name = "OPENBLAS_NUM_THREADS"
    monkeypatch.delenv(name, raising=False)
    if chosen is not None:
        monkeypatch.setenv(name, chosen)
    with program._quick_imports():
        assert os.environ[name] == (chosen or "1")
    assert os.environ.get(name) == chosen


READ = """
import builtins, inspect, sys
{before}
plain = builtins.__import__
import PySide6.QtCore
hook, looked, of = builtins.__import__, [], inspect.getsource
inspect.getsource = lambda module: looked.append(module.__name__) or of(module)
{code}
assert builtins.__import__ is hook, "others may use its features"
assert "app.player.window" in sys.modules
print(sum(name.startswith("app.") for name in looked))
"""
IMPORTS = "import app.player.application"


@pytest.mark.parametrize(
    ("code", "is_any"),
    [(IMPORTS, True), (f"with program._imports_by(plain):\n    {IMPORTS}", False)],
    ids=["by Qt's hook", "as the program does"],
)
def test_nobody_reads_the_source_of_what_is_loaded(code: str, is_any: bool) -> None:
    before = "from app import __main__ as program"
    script = READ.format(before=before, code=code)
    found = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, check=True, text=True
    )
    assert (int(found.stdout) > 0) is is_any
