"""Reads one member of a source as a table and cuts it into streams."""

from collections.abc import Sequence
from dataclasses import dataclass

from hapticplayer.capture.logs.numbers import Numbers, Shape, read_numbers
from hapticplayer.capture.logs.raw import Stream
from hapticplayer.capture.logs.source import Source
from hapticplayer.model.arrays import Floats

NANO = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Sensor:
    """A member that holds one sensor.

    Attributes:
        stream: with times in seconds since `origin_ns`.
        origin_ns: of the recorder's clock; 0 where times are not in nanoseconds.
        notes: on damaged lines.
    """

    stream: Stream
    origin_ns: int
    notes: tuple[str, ...]

    def since(self, origin_ns: int) -> Stream:
        """Return the stream with times since another origin."""
        shift_s = (self.origin_ns - origin_ns) * NANO
        return Stream(self.stream.time_s + shift_s, self.stream.values)


def read_table(source: Source, name: str, shape: Shape) -> Numbers:
    """Return the rows of a member."""
    with source.opened(name) as stream:
        return read_numbers(stream, shape, source.where(name))


def read_sensor(source: Source, name: str, shape: Shape) -> Sensor:
    """Return a member with a time in ns and three axes.

    Args:
        source: of the recording.
        name: of the member.
        shape: whose columns are time, x, y, z.
    """
    numbers = read_table(source, name, shape)
    values = numbers.values
    stream = Stream(values[:, 0] * NANO, values[:, 1:4].copy())
    notes = tuple(f"{name}: {note}" for note in numbers.notes)
    return Sensor(stream, numbers.origin, notes)


def split(
    values: Floats, time_s: Floats, starts: Sequence[int | None]
) -> list[Stream | None]:
    """Return streams of one table, which share their times.

    Args:
        values: (rows, columns).
        time_s: (rows,).
        starts: the column of each sensor's x, or None.
    """
    return [
        None if start is None else Stream(time_s, values[:, start : start + 3])
        for start in starts
    ]


def first_numbers(source: Source, name: str, separator: str = ",") -> list[list[float]]:
    """Return the rows of numbers at the beginning of a member; [] where none are.

    Empty cells are NaN. The last line of the beginning is left out, for it may be cut.
    """
    lines = source.head(name).replace("\r", "\n").split("\n")
    rows = []
    for line in [line for line in lines[:-1] if line.strip()][:60]:
        try:
            cells = [cell.strip() for cell in line.split(separator)]
            rows.append([float(cell or "nan") for cell in cells])
        except ValueError:
            return []
    return rows
