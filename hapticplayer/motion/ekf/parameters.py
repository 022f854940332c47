"""Parameters of the quaternion Kalman filter, each with unit, default and source.

The noises of the 2006 paper could not be found in any public text. "Chosen on
recordings" means: the one set that served hand-held sensors, a camera rig and phones
together best against optical truth. The gains of the filter depend only on the
ratios of its noises; their common scale was then chosen so that the standard
deviation of the inclination is as large as the errors seen.
"""

import math
from dataclasses import dataclass, fields

from hapticplayer.errors import UsageError
from hapticplayer.model import STANDARD_GRAVITY_MPS2


@dataclass(frozen=True, slots=True)
class EkfParameters:
    """Parameters of the filter of Sabatini 2006.

    The paper's noises are standard deviations per sample. They are spectral
    densities here (sigma = density / sqrt(interval)), so that one set serves every
    sampling rate. "Michel" is the benchmark of filters on smartphones by Michel et
    al. (PerCom 2017) with its variants of this filter.

    Attributes:
        gravity_mps2: m/s^2. Standard gravity (3rd CGPM, 1901).
        gyro_noise_radps_rthz: rad/s/sqrt(Hz), the paper's Sigma_g; it stands for
            errors of scale too, far above a sensor's noise (6e-5 in a Nexus 5,
            Michel). Chosen on recordings.
        accelerometer_noise_mps2_rthz: m/s^2/sqrt(Hz), the paper's Sigma_a; it stands
            for the motion that passes the gate. Chosen on recordings.
        magnetometer_noise_ut_rthz: uT/sqrt(Hz), the paper's Sigma_m. Chosen on
            recordings.
        accelerometer_gate_mps2: m/s^2; the specific force is used while its norm is
            within this of g. Chosen on recordings (Michel: 0.5). Wider would be
            more accurate there and no gate the most, but no longer this filter.
        accelerometer_gate_window_s: s; not only the sample but also the mean
            deviation over this much of the past has to pass; 0 for the sample
            alone. Chosen on recordings (Michel: 0.1).
        magnetometer_gate_ut: uT; the field is used while its norm is within this of
            the earth's (Michel).
        dip_gate_rad: rad; and its dip within this of the earth's (Michel: 10 deg).
        accelerometer_bias_sigma_mps2: m/s^2; standard deviation of the bias, a
            first-order Gauss-Markov process. Chosen on recordings.
        accelerometer_bias_time_s: s; its correlation time. Chosen by this project,
            as is the next but one; the recordings hardly tell.
        magnetometer_bias_sigma_ut: uT; as for the accelerometer. Chosen on
            recordings.
        magnetometer_bias_time_s: s.
        start_inclination_sigma_rad: rad; error of the vertical at the start, from
            one specific force. Chosen by this project, as is all that follows.
        start_heading_sigma_rad: rad; error of the first heading, from one field.
        still_window_s: s; shortest still span that gives a gyro bias.
        still_search_s: s; the span has to begin within this from the start.
        still_longest_s: s; nothing later than the sum of the two is looked at.
        still_accel_sigma_mps2: m/s^2; deviation of the specific force in it.
        still_rate_sigma_radps: rad/s; deviation of the angular rate in it.
        max_gyro_bias_radps: rad/s; a larger mean rate is taken for a rotation.
        field_magnitude_ut: uT; norm of the earth's field; None takes the median of
            the recording.
        field_dip_rad: rad; its angle below the horizon; None takes the median of the
            angles to the specific forces that pass the gate.

    Raises:
        UsageError: for a number that is not positive and finite where it has to be,
            or a dip beyond the vertical.
    """

    gravity_mps2: float = STANDARD_GRAVITY_MPS2
    gyro_noise_radps_rthz: float = 4e-3
    accelerometer_noise_mps2_rthz: float = 0.6
    magnetometer_noise_ut_rthz: float = 3.0
    accelerometer_gate_mps2: float = 2.0
    accelerometer_gate_window_s: float = 0.4
    magnetometer_gate_ut: float = 15.0
    dip_gate_rad: float = math.radians(10.0)
    accelerometer_bias_sigma_mps2: float = 0.06
    accelerometer_bias_time_s: float = 300.0
    magnetometer_bias_sigma_ut: float = 2.0
    magnetometer_bias_time_s: float = 300.0
    start_inclination_sigma_rad: float = 0.2
    start_heading_sigma_rad: float = 0.2
    still_window_s: float = 1.0
    still_search_s: float = 10.0
    still_longest_s: float = 60.0
    still_accel_sigma_mps2: float = 0.25
    still_rate_sigma_radps: float = 0.02
    max_gyro_bias_radps: float = 0.2
    field_magnitude_ut: float | None = None
    field_dip_rad: float | None = None

    def __post_init__(self) -> None:
        may_be_zero = ("accelerometer_gate_window_s", "still_search_s")
        for name in (f.name for f in fields(self)):
            value = getattr(self, name)
            if value is None or name == "field_dip_rad":
                continue
            # a variance of zero would make the covariance singular
            if (
                not math.isfinite(value)
                or value < 0.0
                or not (value or name in may_be_zero)
            ):
                raise UsageError(
                    "{name} must be positive and finite, got {value}",
                    name=name,
                    value=value,
                )
        if (
            self.field_dip_rad is not None
            and not abs(self.field_dip_rad) <= math.pi / 2
        ):
            raise UsageError(
                "field_dip_rad must lie within a right angle, got {field_dip_rad}",
                field_dip_rad=self.field_dip_rad,
            )
