"""What a game pad can do; here, so that choosing a device loads no driver."""

from hapticplayer.devices.gamepad.rumble import FULL_N
from hapticplayer.model.device import DeviceCapabilities

CAPABILITIES = DeviceCapabilities(
    axes=0,
    peak_force_n=FULL_N,  # nominal: full vibration
    continuous_force_n=FULL_N,
    workspace_radius_m=0.04,  # nominal: it stays in the middle
    rate_hz=100.0,
    latency_s=0.010,
)
