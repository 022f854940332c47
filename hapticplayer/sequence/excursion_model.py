"""Many grips at once: hands of several kinds, at several moments of a track."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from hapticplayer.devices.dynamics import Hand, Mechanism
from hapticplayer.devices.falcon.geometry import FALCON_GEOMETRY
from hapticplayer.devices.falcon.kinematics import Kinematics
from hapticplayer.haptics.centring import Centring
from hapticplayer.haptics.contract import OUTWARD_N
from hapticplayer.haptics.limiter import Limits
from hapticplayer.model.arrays import Floats

RATE_HZ = 500.0
_STICK_MPS = 0.002  # below it dry friction falls with the speed
_SMALL_M = 1e-9


class Grip:
    """Point masses on springs and dampers; arrays are (3 axes, hands, lanes).

    Args:
        hands: one row each.
        limits: of the force, and of place and speed.
        centring: spring and look-ahead.
    """

    def __init__(
        self, hands: Sequence[Hand], limits: Limits, centring: Centring
    ) -> None:
        self._limits, self._centring = limits, centring
        mass, viscous, self._dry_n = _felt(Mechanism())
        self._step_per_kg = (1.0 / RATE_HZ) / np.stack(
            [mass + hand.mass_kg for hand in hands], axis=1
        )[:, :, None]
        self._viscous = np.stack(
            [viscous + hand.damping_n_s_per_m for hand in hands], axis=1
        )[:, :, None]
        self._stiffness = np.array([hand.stiffness_n_per_m for hand in hands])[:, None]
        self.rest(1)

    def rest(self, lanes: int) -> None:
        """Put all grips at rest in the middle."""
        shape = (3, len(self._stiffness), lanes)
        self._place_m, self._speed_mps = np.zeros(shape), np.zeros(shape)
        self.is_fast = self.is_outside = np.zeros(shape[1:], dtype=bool)

    def advance(self, planned_n: Floats) -> Floats:
        """Let one step pass and return the radii, share of the workspace.

        Args:
            planned_n: (3, lanes) of the track.
        """
        planned = planned_n[:, None, :]
        force = self._sent(planned)
        place, speed, step = self._place_m, self._speed_mps, self._step_per_kg
        drag = self._viscous + self._dry_n / np.maximum(np.abs(speed), _STICK_MPS)
        speed += step * (force - self._stiffness * place)
        speed /= 1.0 + step * drag
        place += speed / RATE_HZ
        radius_m = _size(place)
        self._judge(planned, radius_m)
        return np.asarray(radius_m / self._limits.workspace_m)

    def _sent(self, planned: Floats) -> Floats:
        """Return what `haptics.step` sends: faded, pulled inwards, capped."""
        limits, centring = self._limits, self._centring
        ahead = self._place_m + centring.ahead_s * self._speed_mps
        radius = np.maximum(_size(ahead), _SMALL_M)
        outward = np.maximum(0.0, (planned * ahead).sum(axis=0) / radius)
        begin_m = limits.fade_from * limits.workspace_m
        width_m = (limits.fade_to - limits.fade_from) * limits.workspace_m
        lost = outward * np.clip((radius - begin_m) / width_m, 0.0, 1.0)
        force = planned - ((lost + pull_n(radius, centring)) / radius) * ahead
        force *= np.minimum(1.0, limits.force_cap_n / np.maximum(_size(force), 1e-9))
        return np.asarray(force)

    def _judge(self, planned: Floats, radius_m: Floats) -> None:
        """Apply the two rules of the contract that a hand can break."""
        limits = self._limits
        self.is_fast = _size(self._speed_mps) > limits.speed_mps
        outside = radius_m > limits.outside * limits.workspace_m
        if outside.any():
            along = (planned * self._place_m).sum(axis=0)
            outside &= along > OUTWARD_N * radius_m
        self.is_outside = outside


def pull_n(radius_m: Floats, centring: Centring) -> Floats:
    """Return the size of `haptics.centring.centring_force` at radii."""
    width_m = centring.full_m - centring.from_m
    share = np.maximum(0.0, (radius_m - centring.from_m) / width_m)
    return np.asarray(
        centring.pull_n * np.where(share < 1.0, share * share, 2.0 * share - 1.0)
    )


def _felt(mechanism: Mechanism) -> tuple[Floats, Floats, NDArray[np.float64]]:
    """Return the grip's mass, friction and dry friction per axis in the middle."""
    centre = (0.0, 0.0, FALCON_GEOMETRY.centre_z_m)
    rows = np.linalg.inv(np.array(Kinematics().jacobian(centre)))  # dtheta/dp, 1/m
    square = np.square(rows).sum(axis=0)
    dry = mechanism.coulomb_nm * np.abs(rows).sum(axis=0)
    return (
        mechanism.joint_inertia_kg_m2 * square + mechanism.grip_mass_kg,
        mechanism.viscous_nm_s * square,
        dry[:, None, None],
    )


def _size(vectors: Floats) -> Floats:
    return np.asarray(np.sqrt(np.einsum("i...,i...->...", vectors, vectors)))
