"""HOST:PORT as people write it."""

from hapticplayer.errors import DeviceError
from hapticplayer.model.ranges import Range

PORT = Range(1, 65535, is_whole=True)


def host_and_port(text: str) -> tuple[str, int]:
    """Return both parts of HOST:PORT or [HOST]:PORT; raises DeviceError."""
    host, colon, port = text.rpartition(":")
    host = host.removeprefix("[").removesuffix("]")
    if not (colon and host):
        raise DeviceError("{text!r} is not HOST:PORT", text=text)
    return host, int(PORT.parse("port", port))
