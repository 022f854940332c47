"""The Haply Inverse3, and one that is simulated."""

from hapticplayer.devices import DeviceEntry
from hapticplayer.errors import Message
from hapticplayer.model.device import DeviceCapabilities

_HERE = "hapticplayer.extras.inverse3"
INVERSE3 = DeviceCapabilities(
    axes=3,
    peak_force_n=9.0,  # not known; about 10 N by hearsay
    continuous_force_n=3.0,  # not known; assumed, a third of the peak
    workspace_radius_m=0.10,  # the sphere of the vendor's demonstration
    rate_hz=1000.0,
    latency_s=0.002,
)


def devices() -> tuple[DeviceEntry, ...]:
    """See `hapticplayer.extension`."""
    return (
        DeviceEntry(
            "inverse3",
            Message("Inverse3"),
            "Haply Inverse3 through the Inverse Service of this machine",
            INVERSE3,
            f"{_HERE}.driver:make",
            f"{_HERE}.driver:silence",
            options=f"{_HERE}.driver:inverse3_options",
            guide=f"{_HERE}.guide:INVERSE3",
        ),
        DeviceEntry(
            "inverse3-simulated",
            Message("Inverse3 on a simulated service"),
            "the Inverse3's own driver on a simulated service, for developers",
            INVERSE3,
            f"{_HERE}.simulated.driver:make",
            "hapticplayer.simulation.falcon.remote:silence",
            server=f"{_HERE}.simulated",
            is_for_developers=True,
        ),
    )
