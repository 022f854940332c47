"""What each device can do; apart, so that choosing a device loads no driver."""

from dataclasses import replace

from hapticplayer.model.device import DeviceCapabilities

FULL_N = 4.5
"""Force at which what has no newtons does all it can."""

VIBRATION = DeviceCapabilities(
    axes=0,
    peak_force_n=FULL_N,  # nominal: full vibration
    continuous_force_n=FULL_N,
    workspace_radius_m=0.04,  # nominal: it stays in the middle
    rate_hz=100.0,
    latency_s=0.015,
    has_newtons=False,
)
"""Of what vibrates, each with another pace and latency."""

FALCON = DeviceCapabilities(
    axes=3,
    peak_force_n=9.0,  # press: "over 2 lb"; in every direction 4.9
    continuous_force_n=3.0,  # not known; assumed, a third of the peak
    workspace_radius_m=0.04,  # CHAI3D
    rate_hz=1000.0,
    latency_s=0.001,
)

SIMULATED = replace(FALCON, latency_s=0.0)  # it acts at once
