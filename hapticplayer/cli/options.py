"""The options of each command; needs nothing but the standard library."""

import argparse
from typing import Any

from hapticplayer.cli import commands as run
from hapticplayer.cli import device

DEVICE_NAMES = ("simulated", "falcon", "falcon-simulated", "gamepad", "none")
CLIP_SCENARIOS = ("demo",)
RIDE_SCENARIOS = (
    "bike",
    "horse",
    "car-turning",
    "car-braking",
    "still",
    "free-fall",
    "stairs",
)
MOTION_SCENARIOS = (
    "car-calm",
    "car-brisk",
    "car-hard",
    "car-roundabouts",
    "car-motorway",
    "car-stop-and-go",
    "car-on-ramp",
    "car-hills",
    "walk",
    "run",
    "handheld-quiet",
    "handheld-brisk",
    "bicycle",
    "mountain-bike",
)
MOUNTING_NAMES = (
    "forward",
    "upside-down",
    "backward",
    "to-the-right",
    "to-the-left",
    "left-side-up",
    "right-side-up",
    "to-the-sky",
    "to-the-ground",
)
SYNC_METHODS = ("pats", "variance", "embedded", "offset")
METHOD_NAMES = ("smoother", "ekf", "vqf", "offline-vqf", "lowpass")

PLAY_DEFAULTS: dict[str, Any] = {
    "source": None,
    "feedback": None,
    "force": None,
    "device": "simulated",
    "headless": False,
    "mute": False,
    "fullscreen": False,
    "plots": True,
    "close_at_end": False,
    "speed": 1.0,
    "start": 0.0,
    "duration": None,
    "log": None,
    "record": None,
    "scheduling": None,
    "json": False,
}


def add_play(commands: Any) -> None:
    """Add the command `play`."""
    play = commands.add_parser(
        "play", help="play a sequence, or any video with any force track"
    )
    play.set_defaults(run=run.play)
    play.add_argument(
        "source", metavar="SEQUENCE_OR_VIDEO", help="folder of a sequence, or a video"
    )
    play.add_argument(
        "--feedback",
        metavar="F",
        help="realistic, none, random or another of its tracks",
    )
    play.add_argument(
        "--force",
        metavar="FILE.csv",
        help="force track: rows of time_s,fx_n,fy_n,fz_n, held between rows",
    )
    add_device_name(play)
    play.add_argument("--headless", action="store_true", help="without a window")
    play.add_argument(
        "--mute",
        action="store_true",
        help="silent; without a window no sound is decoded",
    )
    play.add_argument("--fullscreen", action="store_true")
    play.add_argument(
        "--no-plots", dest="plots", action="store_false", help="hide the live plots"
    )
    play.add_argument(
        "--close-at-end", action="store_true", help="close the window after the clip"
    )
    play.add_argument(
        "--start", type=_seconds, default=0.0, metavar="S", help="media time, s"
    )
    play.add_argument(
        "--duration", type=_seconds, metavar="S", help="stop after S seconds"
    )
    play.add_argument(
        "--speed", type=float, default=1.0, metavar="X", help="0.5 to 4 (default: 1)"
    )
    play.add_argument("--log", metavar="FILE", help="write what happened as JSON lines")
    play.add_argument(
        "--record",
        metavar="FILE",
        help="record every tick of the haptic loop; see `export`",
    )
    play.add_argument(
        "--scheduling",
        choices=("fifo", "slice", "normal"),
        help="at most this class for the haptic loop; for measurements "
        "(default: the best there is)",
    )
    play.add_argument("--json", action="store_true", help="print the summary as JSON")


def add_device_name(
    command: argparse.ArgumentParser, default: str = "simulated"
) -> None:
    """Add the option that names a haptic device."""
    command.add_argument(
        "--device",
        type=_device_name,
        default=default,
        metavar="NAME[:SERIAL]",
        help=f"{', '.join(DEVICE_NAMES)}; of several Falcons one by its number "
        f"(default: {default})",
    )


def add_import(commands: Any) -> None:
    """Add the command `import`."""
    command = commands.add_parser(
        "import", help="make a sequence of a video and its motion"
    )
    command.set_defaults(run=run.import_)
    command.add_argument(
        "videos",
        metavar="VIDEO",
        nargs="+",
        help="with several, each becomes a folder in DIR, with the log that lies beside "
        "it under its name (ride.mp4, ride.csv), and a summary is printed",
    )
    command.add_argument(
        "--imu",
        metavar="LOG",
        help="motion in a file of its own: the log of a logger or a phone (a folder or "
        "zip where it writes several files), or CSV with the columns "
        "time_s,ax,ay,az,gx,gy,gz[,mx,my,mz] in SI, x right, y front, z up",
    )
    _add_reading(command)
    _add_mounting(command)
    _add_sync(command, "--sync")
    command.add_argument("-o", "--output", required=True, metavar="DIR")
    command.add_argument("--title", help="default: the name of the video")
    command.add_argument(
        "--gain", type=_number, metavar="N", help="newtons per m/s^2 (default 0.4)"
    )
    command.add_argument(
        "--seed", type=int, help="of the random feedback (default: from the clip)"
    )
    _add_processing(command)
    command.add_argument("--json", action="store_true", help="print a report as JSON")


def add_sync(commands: Any) -> None:
    """Add the command `sync`."""
    command = commands.add_parser(
        "sync", help="say how the clock of a motion log lies to a clip"
    )
    command.set_defaults(run=run.sync)
    command.add_argument(
        "clip", metavar="CLIP", help="a video; with --check also a log"
    )
    command.add_argument(
        "--imu", metavar="LOG", help="as for `import` (default: the clip's own motion)"
    )
    _add_reading(command)
    _add_sync(command, "--method")
    command.add_argument(
        "--check",
        action="store_true",
        help="say whether the pats of a recording can be used, right after making it",
    )
    command.add_argument(
        "--plot",
        metavar="FILE",
        help="draw sound and acceleration on one time line (.png or .svg)",
    )
    command.add_argument(
        "--store-skew",
        action="store_true",
        help="keep --skew for all clips of --camera",
    )
    command.add_argument("--json", action="store_true", help="print the report as JSON")


def _add_sync(command: argparse.ArgumentParser, method: str) -> None:
    group = command.add_argument_group("synchronisation")
    group.add_argument(
        method,
        dest="sync_method",
        choices=SYNC_METHODS,
        help="default: the offset if given, the recording's own clock if it is the "
        "clip's, else three pats on the camera, heard and felt",
    )
    group.add_argument(
        "--offset",
        type=_number,
        metavar="S",
        help="media time at which the log's clock reads zero",
    )
    group.add_argument(
        "--camera",
        metavar="NAME",
        help="take off the skew that is stored for it (default: "
        "the camera that the clip names)",
    )
    group.add_argument(
        "--skew",
        type=_number,
        metavar="S",
        help="how much later than its picture the camera's sound comes",
    )


def add_process(commands: Any) -> None:
    """Add the command `process`."""
    command = commands.add_parser(
        "process", help="say how good a recording's motion is; compare the methods"
    )
    command.set_defaults(run=run.process)
    command.add_argument(
        "recording",
        metavar="RECORDING",
        help="a camera's video, a log as for `import --imu`, or a sequence's folder",
    )
    _add_reading(command)
    _add_mounting(command)
    command.add_argument(
        "--compare",
        action="store_true",
        help="run all methods and print them side by side",
    )
    command.add_argument(
        "--plot",
        metavar="FILE",
        help="draw raw, gravity and motion over time (.png or .svg)",
    )
    _add_processing(command)
    command.add_argument("--json", action="store_true", help="print the report as JSON")


def _add_reading(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--read-as",
        action="append",
        default=[],
        metavar="KEY=VALUE",
        help="decide what a log does not say, such as axes=x,-z,y or force-unit=g or "
        "template=FILE; the question names the key",
    )
    command.add_argument(
        "--save-template",
        metavar="FILE",
        help="keep these decisions for other logs of the same logger",
    )


def _add_mounting(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--mounting",
        metavar="HOW",
        help="how the camera or logger sat on the actor, who looks to the front: "
        f"{', '.join(MOUNTING_NAMES)}, or right, front and up of the actor in the "
        "recorder's axes, such as --mounting=-x,y,-z (default: forward, and gravity has "
        "to agree)",
    )


def _add_processing(command: argparse.ArgumentParser) -> None:
    group = command.add_argument_group("motion")
    group.add_argument(
        "--method",
        choices=METHOD_NAMES,
        help=f"of gravity removal (default {METHOD_NAMES[0]})",
    )
    group.add_argument(
        "--time-constant",
        type=_positive,
        metavar="S",
        help="of the smoother: accelerations that last much longer count as gravity "
        "(default: from how fast the recording moves)",
    )
    group.add_argument(
        "--remove-spikes", action="store_true", help="replace isolated spikes"
    )
    group.add_argument(
        "--repair-clipping",
        action="store_true",
        help="reconstruct short peaks beyond the sensor's range",
    )
    group.add_argument(
        "--average", type=_positive, metavar="HZ", help="average the samples first"
    )
    group.add_argument(
        "--lowpass",
        type=_positive,
        metavar="HZ",
        help="low-pass the motion, zero phase",
    )
    group.add_argument(
        "--no-cache",
        action="store_true",
        help="without effect: results are no longer cached (kept for scripts)",
    )


def add_simulate(commands: Any) -> None:
    """Add the command `simulate`."""
    command = commands.add_parser(
        "simulate", help="make a simulated ride with known truth"
    )
    command.set_defaults(run=run.simulate)
    command.add_argument(
        "scenario",
        metavar="SCENARIO",
        help=f"a recording (clip.mp4, imu.csv, truth.npz): {', '.join(RIDE_SCENARIOS)}; "
        f"a sequence: {', '.join(CLIP_SCENARIOS)}; motion only (imu.csv and truth.npz): "
        f"{', '.join(MOTION_SCENARIOS)}",
    )
    command.add_argument("-o", "--output", required=True, metavar="DIR")
    command.add_argument(
        "--gopro",
        action="store_true",
        help="of a recording, also gopro.mp4: the clip with a telemetry track",
    )
    command.add_argument("--seed", type=int, help="of the ride and the sensor noise")


def add_export(commands: Any) -> None:
    """Add the command `export`."""
    command = commands.add_parser(
        "export", help="convert a record that `play --record` has written"
    )
    command.set_defaults(run=run.export)
    command.add_argument("record", metavar="RECORD")
    command.add_argument("-o", "--output", required=True, metavar="FILE")
    command.add_argument(
        "--format",
        default="csv",
        metavar="FORMAT",
        help="csv: a line per tick with the units in the names (default)",
    )
    command.add_argument("--json", action="store_true", help="print a report as JSON")


def add_device(commands: Any) -> None:
    """Add the command `device`."""
    device.add_device(commands, add_device_name)


def add_doctor(commands: Any) -> None:
    """Add the command `doctor`."""
    command = commands.add_parser("doctor", help="what is missing, by package name")
    command.add_argument("--json", action="store_true")
    command.set_defaults(run=run.doctor)


def _device_name(text: str) -> str:
    if text.partition(":")[0] not in DEVICE_NAMES:
        raise argparse.ArgumentTypeError(
            f"{text!r} is none of {', '.join(DEVICE_NAMES)}"
        )
    return text


def _number(text: str) -> float:
    value = float(text)
    if value != value or value in (float("inf"), float("-inf")):
        raise argparse.ArgumentTypeError(f"{text!r} is not a finite number")
    return value


def _positive(text: str) -> float:
    value = _number(text)
    if value <= 0.0:
        raise argparse.ArgumentTypeError(f"{text!r} is not above zero")
    return value


def _seconds(text: str) -> float:
    value = _number(text)
    if value < 0.0:
        raise argparse.ArgumentTypeError(f"{text!r} is negative")
    return value
