"""The mounting of a recorder on the actor: from the recorder's frame to frame A.

A camera that looks forward and is upright needs none. For any other a person gives its
right, front and up axes; the samples show which axis was up.
"""

import dataclasses
import itertools
from typing import NamedTuple

import numpy as np

from hapticplayer.errors import InputError, Message, UsageError
from hapticplayer.model import ImuLog, Mapping
from hapticplayer.model.arrays import Floats
from hapticplayer.model.limits import MIN_MEAN_SHARE, UPRIGHT

AS_RECORDED = "x,y,z"


class Mounting(NamedTuple):
    """A common mounting.

    Attributes:
        axes: right, front and up of the actor in the recorder's axes (x to its right,
            y where it looks, z to its top).
        text: for people.
    """

    axes: str
    text: Message


MOUNTINGS = {
    "forward": Mounting(AS_RECORDED, Message("Facing forward, upright")),
    "upside-down": Mounting("-x,y,-z", Message("Facing forward, upside down")),
    "backward": Mounting("-x,-y,z", Message("Facing backward, upright")),
    "to-the-right": Mounting("y,-x,z", Message("Facing right, upright")),
    "to-the-left": Mounting("-y,x,z", Message("Facing left, upright")),
    "left-side-up": Mounting("z,y,-x", Message("Facing forward, left side up")),
    "right-side-up": Mounting("-z,y,x", Message("Facing forward, right side up")),
    "to-the-sky": Mounting("x,-z,y", Message("Lying on its back, facing up")),
    "to-the-ground": Mounting("x,z,-y", Message("Facing down")),
}

BY_FRAMES = "auto"
"""In place of a mounting: the one that the frames of the clip tell."""

WRONG_SIGN = Message("accel-sign=- if its accelerometer reads -1 g upwards")

AXES = "xyz"
_ROUNDING = 2e-3  # of matrices that people type with three digits


def signed_axes(text: str) -> Floats | None:
    """Return the matrix of three axes with signs, mirrored perhaps; None for others."""
    rows = []
    for part in text.lower().replace(" ", "").split(","):
        name = part.lstrip("+-")
        if len(part) - len(name) > 1 or len(name) != 1 or name not in AXES:
            break
        row = np.zeros(3)
        row[AXES.index(name)] = -1.0 if part.startswith("-") else 1.0
        rows.append(row)
    matrix = np.array(rows)
    is_whole = matrix.shape == (3, 3) and abs(np.linalg.det(matrix)) == 1.0
    return matrix if is_whole else None


def axes_matrix(axes: str) -> Floats:
    """Return the rotation (3, 3) from stored axes to frame A.

    Args:
        axes: right, front and up in stored axes, such as "x,-z,y".

    Raises:
        UsageError: when they are not axes, or mirrored.
    """
    matrix = signed_axes(axes)
    if matrix is None:
        raise UsageError(
            "axes={axes} are not three axes; give right, front and up in the axes "
            "of the log, for example axes=x,-z,y",
            axes=axes,
        )
    if np.linalg.det(matrix) < 0.0:
        raise UsageError(
            "axes={axes} mirror the log; change one sign: right, front "
            "and up have to follow the right hand",
            axes=axes,
        )
    return matrix


def device_axes(text: str) -> Floats:
    """Return the rotation (3, 3) from frame A to a device.

    Args:
        text: the device's right, up and towards the user in frame A, such as "x,z,-y",
            or the nine numbers of a rotation, row by row, rounded by hand perhaps.
    """
    parts = text.split(",")
    if len(parts) != 9:
        return _device_permutation(text)
    refusal = UsageError(
        "{text!r} is not a rotation; give nine numbers, row by row, with rows of "
        "length 1 at right angles and determinant +1",
        text=text[:80],
    )
    try:
        rows = np.array([float(part) for part in parts]).reshape(3, 3)
        left, sizes, right = np.linalg.svd(rows)
        axes = Mapping(axes=left @ right).axes
    except (ValueError, InputError, np.linalg.LinAlgError):
        raise refusal from None
    if np.abs(sizes - 1.0).max() > _ROUNDING:
        raise refusal
    return axes


def _device_permutation(text: str) -> Floats:
    matrix = signed_axes(text)
    if matrix is None:
        raise UsageError(
            "{text!r} are not three axes; give the device's right, up and towards the "
            "user in the wearer's axes (x right, y front, z up), such as x,z,-y, or the "
            "nine numbers of a rotation, row by row",
            text=text[:80],
        )
    if np.linalg.det(matrix) < 0.0:
        raise UsageError(
            "the axes {text!r} mirror the motion; change one sign", text=text[:80]
        )
    return matrix


def axes_text(axes: Floats) -> str:
    """Return the text that `device_axes` reads as this rotation, to six digits."""
    is_signed = np.abs(np.abs(axes) - np.round(np.abs(axes))).max() < 1e-9
    if not is_signed:
        return ",".join(f"{value:.6g}" for value in axes.ravel().tolist())
    columns = np.abs(axes).argmax(axis=1)
    signs = axes[np.arange(3), columns]
    return ",".join(
        ("-" if sign < 0.0 else "") + AXES[column]
        for sign, column in zip(signs, columns, strict=True)
    )


def all_mountings() -> list[str]:
    """Return all 24, the common ones first."""
    signed = [sign + axis for axis in "xyz" for sign in ("", "-")]
    made = (",".join(three) for three in itertools.permutations(signed, 3))
    proper = [axes for axes in made if _is_proper(axes)]
    usual = [one.axes for one in MOUNTINGS.values()]
    return usual + [axes for axes in proper if axes not in usual]


def mounting_axes(text: str) -> str:
    """Return the axes of a mounting given by name or by axes."""
    usual = MOUNTINGS.get(text.strip().lower())
    axes = usual.axes if usual else text
    try:
        axes_matrix(axes)
    except UsageError:
        raise UsageError(
            "mounting {text!r} not found; choose one of {known}, or give right, front and "
            "up of the wearer in the recorder's axes (--mounting=-x,y,-z)",
            text=text,
            known=", ".join(MOUNTINGS),
        ) from None
    return axes


def is_fallen(imu: ImuLog) -> bool:
    """Whether gravity shows that the recorder was not upright."""
    up = mean_up(imu)
    return up is not None and up[2] < UPRIGHT


def ask_for_mounting(imu: ImuLog, where: str, *, is_sign_known: bool) -> None:
    """Ask for the mounting if gravity shows that the recorder was not upright.

    Args:
        imu: in the recorder's frame.
        where: the file.
        is_sign_known: of the accelerometer; with the other sign another side was up.
    """
    up = mean_up(imu)
    if up is None or up[2] >= UPRIGHT:
        return
    axes = proposed_mounting(up)
    name = next(name for name, one in MOUNTINGS.items() if one.axes == axes)
    sign = ""
    if not is_sign_known and is_down(up):
        sign = Message(", or {sign} (--read-as)", sign=WRONG_SIGN)
    raise UsageError(
        "{file}: {what}; choose the mounting {name} (--mounting {name}), or another of "
        "{known}, or auto for what the frames tell, or forward to keep its axes{sign}",
        file=where,
        what=fallen_text(up),
        sign=sign,
        name=name,
        known=", ".join(MOUNTINGS),
    )


def refuse_upside_down(imu: ImuLog, where: str, mounting: str) -> None:
    """Ask again where the actor would have been upside down all the time.

    Args:
        imu: in frame A, by the mounting or axes that were given.
        where: the file.
        mounting: that was given, "" for none; one that keeps the axes is believed.
    """
    up = mean_up(imu)
    if up is None or up[2] > -UPRIGHT or mounting == AS_RECORDED:
        return
    raise UsageError(
        "{file}: as its axes are given, the wearer was upside down: by gravity the other "
        "side is up; choose another mounting (--mounting), or {sign} (--read-as), or "
        "keep the axes of the log (--mounting forward)",
        file=where,
        sign=WRONG_SIGN,
    )


def is_down(up: tuple[float, float, float]) -> bool:
    """Whether the axis that was up points down, as with the other sign of gravity."""
    return min(up) < -max(up)


def fallen_text(up: tuple[float, float, float]) -> str:
    """Return in words that a recorder was not upright."""
    at = int(np.argmax(np.abs(up)))
    sign = "-" if up[at] < 0.0 else ""
    return Message(
        "gravity shows that {sign}{axis} of the recorder was up, not its z",
        sign=sign,
        axis="xyz"[at],
    )


def _is_proper(axes: str) -> bool:
    try:
        axes_matrix(axes)
    except UsageError:
        return False
    return True


def mounted(imu: ImuLog, axes: str) -> ImuLog:
    """Return a log in frame A.

    Args:
        imu: in the recorder's frame.
        axes: right, front and up of the actor in that frame; "" for as it is.
    """
    if not axes or axes == AS_RECORDED:
        return imu
    rotation_t = axes_matrix(axes).T
    field = imu.magnetic_field_ut
    return dataclasses.replace(
        imu,
        specific_force_mps2=imu.specific_force_mps2 @ rotation_t,
        angular_rate_radps=imu.angular_rate_radps @ rotation_t,
        magnetic_field_ut=None if field is None else field @ rotation_t,
    )


def mean_up(imu: ImuLog) -> tuple[float, float, float] | None:
    """Return the mean up direction (unit, recorder's frame); None if it rotated too much."""
    accel = imu.specific_force_mps2
    mean = np.asarray(accel.mean(axis=0), dtype=float)
    length = float(np.linalg.norm(mean))
    if length < MIN_MEAN_SHARE * float(np.linalg.norm(accel, axis=1).mean()):
        return None
    x, y, z = (mean / length).tolist()
    return x, y, z


def up_in_frame_a(up: tuple[float, float, float], axes: str) -> Floats:
    """Return the up direction after a mounting; (0, 0, 1) if it fits."""
    return np.asarray(axes_matrix(axes) @ np.array(up))


def gravity_agrees(up: tuple[float, float, float] | None, axes: str) -> bool:
    """Whether gravity, as far as it is known, shows no other side up."""
    return up is None or bool(up_in_frame_a(up, axes)[2] >= UPRIGHT)


def proposed_mounting(up: tuple[float, float, float] | None) -> str:
    """Return the axes of the common mounting with this up; the front is a guess."""
    if up is None:
        return AS_RECORDED
    usual = [one.axes for one in MOUNTINGS.values()]
    fits = {axes: float(up_in_frame_a(up, axes)[2]) for axes in usual}
    best = max(fits.values())
    return next(axes for axes, fit in fits.items() if fit > best - 1e-9)
