"""Pages of the menus File, Playback and Help, and of preferences."""

from app.player.guide import GuideWindow
from app.player.help_pages import CheckPage, ReportPage
from app.player.playlist_page import PlaylistPage
from app.player.preferences import PreferencesPage
from app.player.share_page import SharePage

LONG = "a clip whose name goes on and on " * 4


def dialogs(window, folder):
    """Return what makes each of them."""
    source = window.player.snapshot().source
    here = str(folder)

    def playlist(paths):
        page = PlaylistPage(window.playlist, here, window)
        window.playlist.set_paths(paths)
        return page

    def checked(page):
        page.checks.job.join()  # it ends by itself: no thread is left behind
        return page

    return {
        "playlist-empty": lambda: playlist([]),
        "playlist": lambda: playlist([source.path, folder / f"{LONG}.mp4"]),
        "preferences": lambda: PreferencesPage(
            window.settings, window.controls, window.viewing, window
        ),
        "share": lambda: SharePage(source.path, here, source.title, window),
        "guide": lambda: GuideWindow(window),
        "system-check": lambda: checked(CheckPage(window)),
        "report": lambda: checked(
            ReportPage(lambda checks: {"a.txt": checks}, here, window)
        ),
    }
