"""The pages of this extra, see `tests.app.faces`."""

from app.extras.rigs.panel import RigPanel


def dialogs(window):
    return {"rig": lambda: RigPanel(window.clock, window, (0,))}
