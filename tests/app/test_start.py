"""What the window does not load before it is wanted."""

import subprocess
import sys

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
    heavy = {"matplotlib", "pandas", "pyqtgraph", "scipy"}  # later than the first frame
    modules = loaded("import app.player.application", "app", "hapticplayer", *heavy)
    unwanted = {
        *dialogs.LATER,
        "hapticplayer.sequence.build",
        "hapticplayer.capture.gopro",
        "hapticplayer.study",
        "hapticplayer.devices.falcon.driver",
        "hapticplayer.devices.paced",
        "hapticplayer.simulation",
        *heavy,
    }
    assert {"app.player.session", "app.player.window"} <= modules
    assert not unwanted & modules


def test_dialogs_load_what_they_need_and_no_simulation() -> None:
    code = "from app.player import dialogs; dialogs.load()"
    modules = loaded(code, "app", "hapticplayer")
    assert set(dialogs.LATER) <= modules
    assert "hapticplayer.simulation" not in modules
