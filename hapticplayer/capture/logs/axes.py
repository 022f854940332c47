"""From a log's axes to frame A (x right, y front, z up), and whether that can be.

At rest the specific force points up, so a log tells which of its axes was upright;
which one looked to the front only a person can know.
"""

import numpy as np

from hapticplayer.capture.logs.choices import LogChoices, question
from hapticplayer.capture.logs.raw import RawLog
from hapticplayer.errors import UsageError
from hapticplayer.model.arrays import Floats

_NAMES = "xyz"
_UPRIGHT = 0.7
"""Cosine of 45 degrees: farther from up is not how frame A is meant."""

_CONSTANT = 0.5
"""Below it gravity turned so much in the sensor that no axis was up."""


def axes_matrix(axes: str) -> Floats:
    """Return the rotation (3, 3) from stored axes to frame A.

    Args:
        axes: right, front and up in stored axes, such as "x,-z,y".

    Raises:
        UsageError: when they are no axes, or mirrored.
    """
    rows = []
    for part in axes.lower().replace(" ", "").split(","):
        name = part.lstrip("+-")
        if len(part) - len(name) > 1 or len(name) != 1 or name not in _NAMES:
            break
        row = np.zeros(3)
        row[_NAMES.index(name)] = -1.0 if part.startswith("-") else 1.0
        rows.append(row)
    matrix = np.array(rows)
    if matrix.shape != (3, 3) or abs(np.linalg.det(matrix)) != 1.0:
        raise UsageError(
            f"axes={axes} are not three axes; give right, front and up in the axes of "
            "the log, for example axes=x,-z,y"
        )
    if np.linalg.det(matrix) < 0.0:
        raise UsageError(
            f"axes={axes} mirror the log; turn one sign round, for right, front and up "
            "have to follow the right hand"
        )
    return matrix


def check_upright(
    force: Floats, raw: RawLog, choices: LogChoices, where: str
) -> tuple[str, ...]:
    """Hold a specific force in frame A against "up is up".

    Args:
        force: (N, 3) m/s2, finite.
        raw: the log; its axes were applied.
        choices: axes that a person chose are not asked about again.
        where: the file.

    Returns:
        Notes.

    Raises:
        UsageError: asking for the axes, when another one was up.
    """
    mean = force.mean(axis=0)
    typical = float(np.linalg.norm(force, axis=1).mean())
    length = float(np.linalg.norm(mean))
    if length < _CONSTANT * typical:
        return ("the sensor turned so much that gravity does not show its axes",)
    if mean[2] >= _UPRIGHT * length:
        return ()
    stored = axes_matrix(raw.axes).T @ mean
    up = int(np.argmax(np.abs(stored)))
    up_name = ("-" if stored[up] < 0.0 else "") + _NAMES[up]
    if choices.axes:
        return (f"gravity shows that {up_name} was up, not the axis that was chosen",)
    words = f" ({raw.axes_words})" if raw.axes_words else ""
    proposal = _proposal(up, stored[up] < 0.0, raw.back_axis)
    raise question(
        f"its axis {up_name} was up, so the sensor was not mounted with {raw.axes} to "
        f"the right, front and up{words}",
        (
            f"axes={proposal} or what else was right, front, up",
            "force-sign=- if its accelerometer shows -1 g upwards",
        ),
        where,
    )


def _proposal(up: int, is_down: bool, back_axis: str) -> str:
    """Return right, front, up with the axis that was up."""
    upward, front = np.zeros(3), np.zeros(3)
    upward[up] = -1.0 if is_down else 1.0
    back = _NAMES.find(back_axis) if back_axis else -1
    if back not in (-1, up):
        front[back] = -1.0
    else:
        front[1 if up == 2 else 2] = 1.0
    rows = (np.cross(front, upward), front, upward)
    return ",".join(_name(row) for row in rows)


def _name(row: Floats) -> str:
    at = int(np.argmax(np.abs(row)))
    return ("-" if row[at] < 0.0 else "") + _NAMES[at]
