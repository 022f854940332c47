"""Which Falcons are plugged in, asked for beside the window: the bus may take its time."""

from collections.abc import Callable

from PySide6.QtCore import QObject

from app.bridge.beside import Beside
from hapticplayer.devices.falcon.transport import list_falcons


class Plugged(Beside):
    """Finds the serial numbers, "" for those that may not be read.

    Args:
        look: returns them.
        parent: Qt's owner.
    """

    def __init__(
        self,
        look: Callable[[], list[str]] | None = None,
        parent: QObject | None = None,
    ) -> None:
        look = look or _serials
        super().__init__(lambda _progress: look(), parent)

    def falcons(self) -> list[tuple[str, str]]:
        """Return (the engine's name, the serial number) of each Falcon to choose.

        The only one, or none, is `falcon`; its number may be "".
        """
        numbers = sorted(filter(None, self.found))
        if len(numbers) > 1:
            return [(f"falcon:{number}", number) for number in numbers]
        return [("falcon", "".join(numbers))]


def _serials() -> list[str]:
    return [found.serial for found in list_falcons()]
