"""The pages of this extra, see `tests.app.faces`."""

from app.extras.faults.panel import FaultPanel


def dialogs(window):
    return {"faults": lambda: FaultPanel(window.clock, window.session, window)}
