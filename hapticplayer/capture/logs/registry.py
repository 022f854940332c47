"""All formats of logs, and which of them a source is."""

from hapticplayer.capture.logs import (
    gcsv,
    generic_csv,
    nanoseconds,
    opencamera,
    phyphox,
    razor_lines,
    razor_m0,
    sensor_logger,
    ultimate_imu,
)
from hapticplayer.capture.logs.assemble import LogReading, assemble
from hapticplayer.capture.logs.choices import LogChoices, question
from hapticplayer.capture.logs.raw import Confidence, Format
from hapticplayer.capture.logs.source import Source
from hapticplayer.errors import UsageError

FORMATS: tuple[Format, ...] = (
    sensor_logger.FORMAT,
    phyphox.FORMAT,
    gcsv.FORMAT,
    nanoseconds.EUROC,
    nanoseconds.MARS,
    razor_lines.FORMAT,
    ultimate_imu.FORMAT,
    razor_m0.FORMAT,
    opencamera.FORMAT,
    generic_csv.FORMAT,
)


def find_format(source: Source, choices: LogChoices) -> Format | None:
    """Return the format of a source, or None when it is none of these.

    Raises:
        UsageError: when several fit equally well, or one was chosen that is not known.
    """
    if choices.format:
        return _chosen(choices.format, source)
    if choices.columns:
        return generic_csv.FORMAT
    found = [(one.recognises(source), one) for one in FORMATS]
    best = max(confidence for confidence, _ in found)
    if best is Confidence.NO:
        return None
    fitting = [one for confidence, one in found if confidence is best]
    if len(fitting) > 1 and generic_csv.FORMAT in fitting:
        # its columns have to be told; the other knows them, and checks them
        fitting.remove(generic_csv.FORMAT)
    if len(fitting) > 1:
        raise question(
            f"could be {' or '.join(one.name for one in fitting)}",
            tuple(f"format={one.key}" for one in fitting),
            str(source.path),
        )
    return fitting[0]


def read_log(source: Source, form: Format, choices: LogChoices) -> LogReading:
    """Return the log in SI and frame A.

    Raises:
        InputError: when it cannot be used.
        UsageError: when a decision is needed; says how to give it.
    """
    return assemble(form.read(source, choices), choices, str(source.path))


def _chosen(key: str, source: Source) -> Format:
    for one in FORMATS:
        if key == one.key or key.startswith(f"{one.key}-"):
            if one.recognises(source) is Confidence.NO:
                raise UsageError(f"{source.path}: is no log of {one.name}")
            return one
    raise UsageError(
        f"there is no format {key!r}; choose one of {', '.join(f.key for f in FORMATS)}"
    )
