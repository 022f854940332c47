"""What the Falcon can do; here, so that choosing a device loads no driver."""

from hapticplayer.model.device import DeviceCapabilities

CAPABILITIES = DeviceCapabilities(
    axes=3,
    peak_force_n=9.0,  # press: "over 2 lb"; in every direction 4.9
    continuous_force_n=3.0,  # not known; assumed, a third of the peak
    workspace_radius_m=0.04,  # CHAI3D
    rate_hz=1000.0,
    latency_s=0.001,
)
