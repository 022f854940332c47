"""A window whose editor changes the effects of a folder, and then waits to be killed."""

import sys
from pathlib import Path

from app.bridge.settings import Settings
from app.editor.page import EditorPage
from app.player.application import make_application
from app.player.video_surface import SurfaceSink, VideoSurface
from app.player.window import PlayerWindow
from hapticplayer.clock import SystemClock
from hapticplayer.playback.player import Player
from hapticplayer.rendering.effects import Effect


def edit(page: EditorPage) -> None:
    """Make a change, take it back, and make another one."""
    for end_s in (0.8, 1.5):
        pulse = Effect("pulse", 0.5, end_s, parameters={"amplitude": 2.0})
        page.editing.add(pulse, "Add")
        if end_s < 1.0:
            page.undo()
    sys.stdout.write("edited\n")
    sys.stdout.flush()


def main() -> None:
    application = make_application()
    clock, surface = SystemClock(), VideoSurface()
    player = Player(clock, SurfaceSink(surface), outputs=[], audio=None)
    window = PlayerWindow(player, surface, clock, Settings(None))
    window.show()
    window.dialogs.edit_effects(clock, Path(sys.argv[1]))
    page = window.findChild(EditorPage)
    page.ready.connect(lambda: edit(page))
    application.exec()


if __name__ == "__main__":
    main()
