"""The page that sets a shaker up, see `tests.app.faces`."""

from app.player.choices import PluggedFalcons
from app.player.setup_page import SetupPage

CARD = "shaker:a card with a name that goes on and on,channels=1+2+3+4"


def dialogs(window):
    plugged = PluggedFalcons(list, window)
    return {
        "set-up-shaker": lambda: SetupPage(
            window.clock, CARD, plugged, window.settings, window
        )
    }
