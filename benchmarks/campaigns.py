"""Long forms of fault tests: `pytest -m campaign`, and the figures that they record.

The cases and what must hold for each belong to the tests; here they run in full, and
what they record (`record_property("figures", json)`) becomes a table and a result.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from benchmarks.common import ROOT, Report, positive
from hapticplayer.facilities import FACILITIES
from hapticplayer.linux import SWITCH

TESTS = "tests/faults/test_campaigns.py"
WHOLE_PROGRAM = "tests/e2e"
QUICK_PROGRAM = [f"{WHOLE_PROGRAM}/test_headless.py"]


class Case(NamedTuple):
    """One test of a campaign: its parameters, figures, and how it failed, if so."""

    name: str
    figures: dict[str, Any]
    failure: str


def campaign(
    report: Report, test: str, *, share: float = 1.0, only: str = "", workers: int = 1
) -> list[Case]:
    """Run a campaign; return cases with figures. Failed ones are a missed target.

    Args:
        report: takes the target that no case fails.
        test: file and function, `tests/faults/test_x.py::test_y`.
        share: of the full number of mutations or cases.
        only: pattern of pytest's -k.
        workers: processes at once.
    """
    words = ["-m", "campaign", test]
    words += ["-k", only] if only else []
    words += ["-n", str(workers)] if workers > 1 else []
    cases = [_case(one) for one in tested(words, {"CAMPAIGN_SHARE": str(share)})]
    failed = [case for case in cases if case.failure]
    for case in failed:
        print(f"failed: {case.name}: {case.failure}")
    report.target(f"cases that fail, of {len(cases)}", len(failed), ("<=", 0))
    if not any(case.figures for case in cases):
        sys.exit("no case of the campaign has recorded anything")
    return [case for case in cases if case.figures]


def tested(words: list[str], added: dict[str, str]) -> list[ET.Element]:
    """What pytest writes of each test, with something added to its environment."""
    with tempfile.TemporaryDirectory(prefix="hp-campaign-") as folder:
        path = Path(folder) / "found.xml"
        command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"]
        command += ["-o", "junit_family=xunit1", f"--junitxml={path}"]
        command += ["-o", "faulthandler_timeout=0", *words]
        environment = {**os.environ, **added, "QT_QPA_PLATFORM": "offscreen"}
        done = subprocess.run(
            command, cwd=ROOT, env=environment, stdout=sys.stderr, check=False
        )
        if done.returncode not in (0, 1):
            sys.exit(f"pytest ended with {done.returncode}: {' '.join(command)}")
        return list(ET.parse(path).iter("testcase"))  # noqa: S314 - ours


def _failure(element: ET.Element) -> str:
    failures = [*element.iter("failure"), *element.iter("error")]
    return (failures[0].get("message") or "failed").splitlines()[0] if failures else ""


def _case(element: ET.Element) -> Case:
    name = element.get("name", "").partition("[")[2].removesuffix("]")
    properties = {p.get("name"): p.get("value", "") for p in element.iter("property")}
    return Case(name, json.loads(properties.get("figures", "{}")), _failure(element))


# --- haptics centring -------------------------------------------------------------


def centring_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--workers", type=int, default=2)


def centring(options: argparse.Namespace, report: Report) -> None:
    """Hands under strong, long forces: kept inside, stable, passive, and predicted.

    The real `step` with the physics of device and hand in virtual time; no clock, so the
    figures are the same on every machine. Rides and hostile tracks for every hand, delay
    and loss of packets; grips that are let go; free grips at the edge; the stability
    boundary beside b / (T/2 + delay) and the eigenvalues of the sampled loop; the
    prediction beside the full physics.
    """
    quick = "(inside and relaxed and 0.003-0.1) or (let_go and 3-0.001) or boundary"
    only = quick if options.quick else "hands"
    cases = campaign(report, TESTS, only=only, workers=options.workers)
    kept = [case.figures for case in cases if "reach" in case.figures]
    rows, grouped = [], {}
    for one in kept:
        grouped.setdefault((one["track"], one["hand"]), []).append(one)
    for (track, hand), each in grouped.items():
        row = [track, hand, len(each), max(one["reach"] for one in each)]
        row += [min(one["energy_mj"] for one in each)]
        rows.append([*row, max(one["speed_mps"] for one in each)])
    header = ["track", "hand", "runs", "reach/R", "energy mJ", "m/s"]
    report.table("Hands, worst over delays and lost packets", header, rows)
    report.figures["hands"] = {"columns": header, "rows": rows}
    _worst(report, cases, "mass_kg", "speed_mps", "fastest grip let go, m/s")
    _worst(report, cases, "swing_mm", "swing_mm", "swing of a free grip at rest, mm")
    off = [abs(o["predicted"] - o["reach"]) for o in kept if "predicted" in o]
    if off:
        report.figures["prediction off by, of the workspace"] = max(off)
    rows = [
        list(case.figures.values())[:5] for case in cases if "formula" in case.figures
    ]
    rows.sort()
    header = ["delay ms", "found", "b/(T/2+d)", "look-ahead", "eigenvalues"]
    report.table("Largest stable stiffness of a free grip, N/m", header, rows)
    report.figures["boundary"] = {"columns": header, "rows": rows}


def _worst(report: Report, cases: list[Case], has: str, key: str, text: str) -> None:
    found = [case.figures[key] for case in cases if has in case.figures]
    if found:
        print(f"{text}: {max(found):.3g}, of {len(found)}")
        report.figures[text] = max(found)


# --- motion stress ----------------------------------------------------------------


def stress_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--only", default="", help="cases with this word")


def stress(options: argparse.Namespace, report: Report) -> None:
    """Flawed recordings through repair and every method, beside the raw packages.

    The cases are those of `tests/faults/motion_cases.py`. Ours is `repair_samples` and
    `remove_gravity`; `raw VQF` and `raw offlineVQF` are the package with the arrays as they
    are, as its manual shows. A cell is the RMS inclination error in degrees from 10 s after
    the fault on, over samples marked valid, with the share that is not, or the error raised.
    """
    only = options.only or ("NaN" if options.quick else "")
    test = f"{TESTS}::test_flawed_motion"
    cases = campaign(report, test, only=only)
    methods = list(cases[0].figures["methods"])
    rows = [
        [case.name, case.figures["expected"]]
        + [_cell(case.figures["methods"][method]) for method in methods]
        for case in cases
    ]
    report.table("Flawed recordings", ["input", "expected", *methods], rows)
    report.figures["columns"] = ["input", "expected", *methods]
    report.figures["rows"] = rows


def _cell(answer: dict[str, Any]) -> str:
    if "error" in answer:
        return str(answer["error"])
    share = round(100.0 * (answer["invalid_share"] or 0.0))
    after = "-" if answer["after"] is None else f"{answer['after']:.2f}"
    return f"{after} ({share} %)" if share else after


# --- robustness media -------------------------------------------------------------

LEAST_MARKED = 0.95


def media_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--share", type=float, help="of all mutations (1.0)")
    parser.add_argument("--seed", type=int, default=0)


def media(options: argparse.Namespace, report: Report) -> None:
    """Damaged clips: no crash, no hang, bounded memory, and lost frames are marked.

    Seeded mutations of a clip (MP4 1000, MKV, WebM, MOV and AVI 200 each) are played from
    beginning to end, each in a process with limits. The rules that mark a clip as damaged
    were made with seed 0, so another seed judges them.
    """
    os.environ["CAMPAIGN_SEED"] = str(options.seed)
    share = options.share or (0.02 if options.quick else 1.0)
    test = f"{TESTS}::test_damaged_clips"
    cases = campaign(report, test, share=share)
    report.table(
        "Damaged clips",
        ["container", *cases[0].figures],
        [[case.name, *case.figures.values()] for case in cases],
    )
    lossy, marked = (sum(c.figures[k] for c in cases) for k in ("lossy", "marked"))
    if lossy:
        what = f"share marked of {lossy} clips that lost frames"
        report.target(what, marked / lossy, (">=", LEAST_MARKED))
    report.figures |= {"seed": options.seed, "share": share}
    report.figures["clips"] = {case.name: case.figures for case in cases}


# --- robustness importers ---------------------------------------------------------

CLIP_MB = 700.0
CLIP_LENGTHS_S = (112.0, 2580.0)
"""50 Mbit/s, what cameras write, and the 43 min of another program's test file."""
READINGS = 5
MAX_CLIP_S, MAX_CLIP_READ_MB = 0.2, 120.0
HOUR_ROWS, FORCE_ROWS = 3_600_000, 20_000_000
MAX_PROCESS_MB, MAX_PLAY_MB = 600.0, 400.0
_PEAKS = ("peak_mb", "cpu_s", "missed")


def importers_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--part", nargs="+", choices=PARTS, default=list(PARTS))
    parser.add_argument("--only", default="", help="formats with this word")


def importers(options: argparse.Namespace, report: Report) -> None:
    """Importers of motion logs: damaged logs, logs of ten hours, a camera clip of 700 MB.

    Each format is damaged 200 times (a real camera's clip as well, where it is at hand):
    it must be read, or refused or asked about in one sentence, within 10 s and 1 GB. Ten
    hours at 100 Hz in each format, read by a process of its own. The clip holds telemetry
    beside frames that are never decoded; the best of five readings after one that loads the
    libraries, and the bytes that were read from it. Commands on long files: peak memory
    of `process` with an hour at 1 kHz, and of `play --force` with 20 million rows.
    """
    for part in options.part:
        report.figures[part] = PARTS[part](options, report)


def damaged(options: argparse.Namespace, report: Report) -> dict[str, Any]:
    """Damage logs of 8 s."""
    test, share = f"{TESTS}::test_damaged_logs", 0.02 if options.quick else 1.0
    cases = campaign(report, test, share=share, only=options.only)
    keys = ("read", "refused", "asked", "longest_s", "peak_mb")
    rows = [[case.name, *(case.figures.get(k, 0) for k in keys)] for case in cases]
    report.table("Damaged logs", ["format", *keys], rows)
    return {case.name: case.figures for case in cases}


def ten_hours(options: argparse.Namespace, report: Report) -> dict[str, Any]:
    """Read long logs."""
    test, share = f"{TESTS}::test_logs_of_ten_hours", 0.01 if options.quick else 1.0
    cases = campaign(report, test, share=share, only=options.only)
    keys = ("mb", "samples", "s", "cpu_s", "peak_mb")
    rows = [[case.name, *(case.figures.get(k, "-") for k in keys)] for case in cases]
    report.table("Ten hours at 100 Hz", ["format", *keys], rows)
    return {case.name: case.figures for case in cases}


def clips(options: argparse.Namespace, report: Report) -> dict[str, Any]:
    """Read the telemetry of a large clip without its frames."""
    figures: dict[str, Any] = {}
    size_mb = 0.05 * CLIP_MB if options.quick else CLIP_MB
    for length_s in CLIP_LENGTHS_S[:1] if options.quick else CLIP_LENGTHS_S:
        with tempfile.TemporaryDirectory(prefix="hp-importers-") as folder:
            path = Path(folder) / "clip.mp4"
            _write_clip(path, length_s, size_mb)
            command = [sys.executable, "-c", _READER, str(path), str(READINGS)]
            done = subprocess.run(command, capture_output=True, text=True, check=True)
        found = figures[f"{length_s:.0f} s"] = json.loads(done.stdout)
        report.target(f"clip of {length_s:.0f} s: s", found["s"], ("<=", MAX_CLIP_S))
        what, limit = f"clip of {length_s:.0f} s: MB read", ("<=", MAX_CLIP_READ_MB)
        report.target(what, found["read_mb"], limit)
    rows = [[name, *found.values()] for name, found in figures.items()]
    report.table(
        f"Clip of {size_mb:.0f} MB",
        ["length", "samples", "s", "CPU s", "MB read"],
        rows,
    )
    return figures


def commands(options: argparse.Namespace, report: Report) -> dict[str, Any]:
    """Run commands on long files, and measure their peak memory."""
    from hapticplayer.media.encode import write_clip

    share = 0.01 if options.quick else 1.0
    figures: dict[str, Any] = {}
    with tempfile.TemporaryDirectory(prefix="hp-importers-") as name:
        folder = Path(name)
        log, force, clip = (folder / one for one in ("log.csv", "f.csv", "clip.mp4"))
        _write_log(log, round(share * HOUR_ROWS))
        _write_force(force, round(share * FORCE_ROWS))
        grey = [np.full((72, 128, 3), 4 * k, np.uint8) for k in range(60)]
        write_clip(clip, grey, frame_rate_hz=30.0)
        play = ["play", str(clip), "--force", str(force), "--headless", "--mute"]
        for what, words, most_mb in (
            ("process, 1 h at 1 kHz", ["process", str(log)], MAX_PROCESS_MB),
            ("play, 20 million rows", play, MAX_PLAY_MB),
        ):
            command = [sys.executable, "-c", _PEAK, *words, "--json"]
            done = subprocess.run(
                command, capture_output=True, text=True, check=True, cwd=ROOT
            )
            output, usage = done.stdout.splitlines()[-2:]
            printed, found = json.loads(output), json.loads(usage)
            report.target(f"{what}: peak MB", found["peak_mb"], ("<=", most_mb))
            if "missed" in printed:
                found["missed"] = printed["missed"]
            figures[what] = found
    rows = [[name, *(f.get(k, "-") for k in _PEAKS)] for name, f in figures.items()]
    report.table("Commands on long files", ["command", *_PEAKS], rows)
    return figures


_PEAK = """
import json, os, subprocess, sys  # a small process: its memory counts before the exec
process = subprocess.Popen([sys.executable, "-m", "app", *sys.argv[1:]])
_, status, usage = os.wait4(process.pid, 0)
print(json.dumps(dict(peak_mb=usage.ru_maxrss * 1.024e-3, cpu_s=usage.ru_utime)))
sys.exit(os.waitstatus_to_exitcode(status))
"""


def _write_log(path: Path, count: int) -> None:
    from hapticplayer.capture.si_csv import write_imu_csv
    from hapticplayer.model import ImuLog

    rng = np.random.default_rng(1)
    time_s = np.arange(count) / 1000.0
    accel = rng.normal((0.0, 0.0, 9.80665), 0.3, (count, 3))
    accel[:, 0] += 2.0 * np.sin(8.0 * time_s)
    rate = rng.normal(0.0, 0.05, (count, 3))
    write_imu_csv(path, ImuLog(time_s, accel, rate))


def _write_force(path: Path, count: int) -> None:
    with path.open("w", encoding="ascii") as file:
        file.write("time_s,fx_n,fy_n,fz_n\n")
        file.writelines(f"{k / 1e7:.7f},{k % 1000 / 1e3},0,0\n" for k in range(count))


PARTS: dict[str, Callable[[argparse.Namespace, Report], dict[str, Any]]] = {
    "clips": clips,
    "commands": commands,
    "damaged": damaged,
    "ten-hours": ten_hours,
}

_READER = """
import json, sys, time
from hapticplayer.capture import read_recording
def read_bytes():
    lines = open("/proc/self/io").read().splitlines()
    return int(next(line for line in lines if line.startswith("rchar")).split()[1])
read_recording(sys.argv[1])  # loads the libraries
wall, cpu, size = [], [], []
for _ in range(int(sys.argv[2])):
    marks = read_bytes(), time.perf_counter(), time.process_time()
    samples = len(read_recording(sys.argv[1]).imu)
    size.append((read_bytes() - marks[0]) / 1e6)
    wall.append(time.perf_counter() - marks[1])
    cpu.append(time.process_time() - marks[2])
print(json.dumps(dict(samples=samples, s=min(wall), cpu_s=min(cpu), read_mb=max(size))))
"""


def _write_clip(path: Path, length_s: float, size_mb: float) -> None:
    """Mux frames that hold noise, and telemetry of a camera that moves."""
    import av
    from av.packet import Packet

    from hapticplayer.media.encode import write_clip
    from hapticplayer.media.telemetry import TelemetryPacket, add_telemetry

    small, mixed = path.with_suffix(".small.mp4"), path.with_suffix(".mixed.mp4")
    grey = [np.full((48, 64, 3), 9 * k, np.uint8) for k in range(2)]
    write_clip(small, grey, frame_rate_hz=30.0)
    add_telemetry(
        small, mixed, [TelemetryPacket(t, 1.0, p) for t, p in _payloads(length_s)]
    )
    count = round(30 * length_s)
    noise = np.random.default_rng(1).bytes(int(1e6 * size_mb) // count)
    with av.open(str(mixed)) as source, av.open(str(path), "w") as target:
        video = target.add_stream_from_template(source.streams.video[0])
        data = target.add_stream_from_template(source.streams.data[0])
        data.metadata.update(source.streams.data[0].metadata)
        base = source.streams.video[0].time_base
        telemetry = iter([p for p in source.demux(source.streams.data[0]) if p.size])
        for number in range(count):
            packet = Packet(noise)
            packet.stream, packet.time_base = video, base
            packet.pts = packet.dts = round(number / 30.0 / base)
            packet.duration = round(1 / 30.0 / base)
            packet.is_keyframe = number % 30 == 0
            target.mux(packet)
            if number % 30 == 0 and (one := next(telemetry, None)) is not None:
                one.stream = data
                target.mux(one)
    small.unlink()
    mixed.unlink()


def _payloads(length_s: float) -> Any:
    """The packets of a camera at 200 Hz, second by second."""
    from hapticplayer.extras.rides.gpmf_writer import write_payloads
    from hapticplayer.extras.rides.motion_scenes import simulate_motion

    ride = simulate_motion("handheld-brisk", 1, duration_s=length_s)
    return write_payloads(ride.imu)


# --- distribution damage ----------------------------------------------------------


def force_damage_options(_parser: argparse.ArgumentParser) -> None:
    """Add no options."""


def force_damage(options: argparse.Namespace, report: Report) -> None:
    """Files of force that are damaged: read, or refused in a sentence.

    Each format is damaged 2000 times; each must be done within 5 s and 512 MB.
    """
    share = 0.02 if options.quick else 1.0
    cases = campaign(report, f"{TESTS}::test_damaged_force", share=share)
    keys = ("read", "refused", "longest_s", "peak_mb")
    rows = [[case.name, *(case.figures.get(k, 0) for k in keys)] for case in cases]
    report.table("Damaged files of force", ["format", *keys], rows)
    report.figures |= {case.name: case.figures for case in cases}


# --- robustness without -----------------------------------------------------------


def without_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--only", nargs="+", choices=[*FACILITIES], help="(each)")
    parser.add_argument("--tests", nargs="+", help=f"({WHOLE_PROGRAM})")
    parser.add_argument("--workers", type=positive, default=1)


def without(options: argparse.Namespace, report: Report) -> None:
    """End-to-end tests without each thing that only Linux gives.

    `hapticplayer/facilities.py` has the rows; each is taken away alone from all processes
    of a test. The quick form takes all of them away at once, from a run without a window.
    """
    at_once = [",".join(FACILITIES)] if options.quick else list(FACILITIES)
    tests = options.tests or (QUICK_PROGRAM if options.quick else [WHOLE_PROGRAM])
    rows = []
    for names in options.only or at_once:
        words = [*tests, "-n", str(options.workers), "--dist", "worksteal"]
        cases = tested(words, {SWITCH: names})
        failed = {one.get("name", ""): _failure(one) for one in cases if _failure(one)}
        for name, text in failed.items():
            print(f"without {names}: {name}: {text}")
        skipped = sum(one.find("skipped") is not None for one in cases)
        rows.append([names, len(cases) - len(failed) - skipped, skipped, len(failed)])
        report.target(f"without {names}: tests that fail", len(failed), ("<=", 0))
    header = ["without", "passed", "skipped", "failed"]
    report.table("End-to-end tests", header, rows, "without")
