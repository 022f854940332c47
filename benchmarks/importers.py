"""Every importer: a large clip, all mutations of every format, logs of ten hours.

    python benchmarks/importers.py [--only WORD] [--part clips|mutations|ten_hours]
                                   [--mutations N]

A generated 700 MB clip: the best of five readings (after one that loads the
libraries), and bytes that were read from it. 200 seeded mutations of each format: what became of
them, the longest time and the memory at the peak; anything but a recording that is
sound, a refusal or a question in one sentence ends the run. Ten hours at 100 Hz in
each format: time and memory, each in a process of its own. Also the same mutations
of a real camera's clip, if it is at hand. Writes benchmarks/results/importers.json
and importers.md; a run of a part replaces its rows there and keeps the others.
"""

import argparse
import json
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
from common import RESULTS, ROOT, save, table

sys.path.insert(0, str(ROOT))
from tests.faults.import_cases import MUTATIONS, judge, mutated, mutation
from tests.faults.import_formats import FORMATS, Written, gopro_payloads, own_csv, put
from tests.faults.import_signal import sample

DATA = ROOT.parent / "shared" / "data" / "capture" / "gopro"
KARMA = "GoPro, karma.mp4"
LONG_S = 36_000.0
CLIP_BYTES = 700_000_000
CLIP_LENGTHS_S = (112.0, 2580.0)
"""50 Mbit/s, what cameras write, and the 43 min of the reference's file."""

PARTS = ("clips", "mutations", "ten_hours")
_READINGS = 5
MAX_CLIP_S, MAX_CLIP_READ_MB = 0.2, 120.0
MAX_S, MAX_MB = 10.0, 1024.0


def main() -> int:
    """Run what was asked for; 1 when a bound is broken."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", default="", help="formats with this word")
    parser.add_argument("--mutations", type=int, default=MUTATIONS)
    parser.add_argument("--part", choices=PARTS, help="only this, kept with the rest")
    parser.add_argument("--child", nargs=2, metavar=("KIND", "KEY"))
    options = parser.parse_args()
    if options.child:
        print(json.dumps(_child(*options.child, options.mutations)))
        return 0
    parts = (options.part,) if options.part else PARTS
    keys = [key for key in (*FORMATS, KARMA) if options.only.lower() in key.lower()]
    found: dict[str, list[Any]] = {part: [] for part in PARTS}
    if "clips" in parts and not options.only:
        with tempfile.TemporaryDirectory(prefix="hp-importers-") as folder:
            found["clips"] = _clips(Path(folder))
    if "mutations" in parts:
        found["mutations"] = [
            _in_child("mutations", k, options.mutations) for k in keys
        ]
    if "ten_hours" in parts:
        found["ten_hours"] = [_in_child("long", k, 0) for k in keys if k in FORMATS]
    if options.mutations == MUTATIONS:
        _keep(found)
    else:
        print(_report(*found.values()))
    return int(_is_broken(*found.values()))


def _keep(found: dict[str, list[Any]]) -> None:
    """Put the new rows in the place of the old ones and write the report."""
    path = RESULTS / "importers.json"
    held = json.loads(path.read_text()) if path.exists() else {}
    merged = {}
    for part in PARTS:
        name = "length_s" if part == "clips" else "format"
        rows = {row[name]: row for row in (*held.get(part, ()), *found[part])}
        order = (
            list(rows)
            if part == "clips"
            else [k for k in (*FORMATS, KARMA) if k in rows]
        )
        merged[part] = [rows[key] for key in order]
    save("importers", merged)
    text = _report(*merged.values())
    print(text)
    (RESULTS / "importers.md").write_text(text + "\n")


def _is_broken(clips: list[Any], faults: list[Any], long: list[Any]) -> bool:
    slow = any(
        c["seconds"] > MAX_CLIP_S or c["read_mb"] > MAX_CLIP_READ_MB for c in clips
    )
    bad = any(
        row.get("cpu_s", row["longest_s"]) > MAX_S or row["peak_mb"] > MAX_MB
        for row in faults + long
    )
    return slow or bad


def _clips(folder: Path) -> list[dict[str, Any]]:
    found = []
    for length_s in CLIP_LENGTHS_S:
        path = folder / f"clip-{length_s:.0f}.mp4"
        _write_clip(path, length_s)
        found.append({"length_s": length_s, **_in_child("clip", str(path), 0)})
        path.unlink()
    return found


def _write_clip(path: Path, length_s: float) -> None:
    """Mux pictures that hold noise, and telemetry of a camera that moves.

    The stream of pictures is never decoded: its packets only take the room.
    """
    import av
    from av.packet import Packet

    from hapticplayer.media import TelemetryPacket, add_telemetry, write_clip

    small, mixed = path.with_suffix(".small.mp4"), path.with_suffix(".mixed.mp4")
    grey = [np.full((48, 64, 3), 9 * k, np.uint8) for k in range(2)]
    write_clip(small, grey, frame_rate_hz=30.0)
    payloads = gopro_payloads(sample(length_s, 200.0, apart=True))
    add_telemetry(small, mixed, [TelemetryPacket(t, 1.0, p) for t, p in payloads])
    count = round(30 * length_s)
    noise = np.random.default_rng(1).bytes(CLIP_BYTES // count)
    with av.open(str(mixed)) as source, av.open(str(path), "w") as target:
        video = target.add_stream_from_template(source.streams.video[0])
        data = target.add_stream_from_template(source.streams.data[0])
        data.metadata.update(source.streams.data[0].metadata)
        base = source.streams.video[0].time_base
        assert base is not None
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


def _in_child(kind: str, key: str, mutations: int) -> dict[str, Any]:
    command = [sys.executable, __file__, "--child", kind, key]
    command += ["--mutations", str(mutations)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{kind} of {key} broke:\n{done.stderr[-3000:]}")
    answer: dict[str, Any] = json.loads(done.stdout)
    print(f"{kind} {key}: {answer}", file=sys.stderr)
    return answer


def _child(kind: str, key: str, mutations: int) -> dict[str, Any]:
    if kind == "clip":
        return _read_clip(Path(key))
    with tempfile.TemporaryDirectory(prefix="hp-importers-") as folder:
        work = _long if kind == "long" else _mutations
        return {"format": key, **work(key, Path(folder), mutations)}


def _read_clip(path: Path) -> dict[str, Any]:
    from hapticplayer.capture import read_recording

    recording = read_recording(path)  # loads PyAV and scipy
    seconds, cpu, read = [], [], []
    for _ in range(_READINGS):
        before, begin, begin_cpu = (
            _bytes_read(),
            time.perf_counter(),
            time.process_time(),
        )
        recording = read_recording(path)
        seconds.append(time.perf_counter() - begin)
        cpu.append(time.process_time() - begin_cpu)
        read.append(_bytes_read() - before)
    return {
        "size_mb": path.stat().st_size / 1e6,
        "samples": len(recording.imu),
        "seconds": min(seconds),
        "cpu_s": min(cpu),
        "read_mb": max(read) / 1e6,
    }


def _bytes_read() -> int:
    """Return what this process has read through system calls, cached or not."""
    lines = Path("/proc/self/io").read_text().splitlines()
    return int(next(line for line in lines if line.startswith("rchar")).split()[1])


def _mutations(key: str, folder: Path, count: int) -> dict[str, Any]:
    outcomes: Counter[str] = Counter()
    longest_s = 0.0
    for number in range(count):
        path = folder / "one"
        one = FORMATS.get(key, Written(key, own_csv))
        file = _karma(number, path) if key == KARMA else mutation(key, number, path)
        begin = time.perf_counter()
        outcomes[judge(file, one).outcome] += 1
        longest_s = max(longest_s, time.perf_counter() - begin)
        shutil.rmtree(path)
    return {"outcomes": dict(outcomes), "longest_s": longest_s, "peak_mb": _peak_mb()}


def _karma(number: int, folder: Path) -> Path:
    """Damage a real clip: its telemetry's place at the end, or anywhere."""
    content = (DATA / "karma.mp4").read_bytes()
    return put(mutated({"karma.mp4": content}, np.random.default_rng(number)), folder)


def _long(key: str, folder: Path, _count: int) -> dict[str, Any]:
    one = FORMATS[key]
    # the files are written by another process, so that the peak is the reader's
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]);"
        "from pathlib import Path;"
        "from tests.faults.import_formats import FORMATS, put;"
        "from tests.faults.import_signal import sample;"
        "one = FORMATS[sys.argv[2]];"
        "print(put(one.write(sample(float(sys.argv[4]), 100.0, apart=one.apart)),"
        " Path(sys.argv[3])))"
    )
    command = [sys.executable, "-c", code, str(ROOT), key, str(folder), str(LONG_S)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    path = Path(done.stdout.strip())
    files = [path] if path.is_file() else [f for f in path.rglob("*") if f.is_file()]
    # and it is read by one that has loaded nothing else
    command = [sys.executable, "-c", _READER, str(path), *one.choices]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    answer: dict[str, Any] = json.loads(done.stdout)
    answer["size_mb"] = sum(file.stat().st_size for file in files) / 1e6
    return answer


_READER = """
import json, resource, sys, time
import numpy as np
from hapticplayer.capture import parse_choices, read_recording
begin, begin_cpu = time.perf_counter(), time.process_time()
imu = read_recording(sys.argv[1], parse_choices(sys.argv[2:])).imu
took, cpu = time.perf_counter() - begin, time.process_time() - begin_cpu
peak_mb = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
assert (np.diff(imu.time_s) > 0.0).all()
print(json.dumps(dict(samples=len(imu), longest_s=took, cpu_s=cpu, peak_mb=peak_mb)))
"""


def _peak_mb() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0


def _report(clips: list[Any], faults: list[Any], long: list[Any]) -> str:
    parts = []
    if clips:
        rows = [
            [
                f"{c['length_s']:.0f}",
                c["size_mb"],
                c["samples"],
                c["seconds"],
                c["cpu_s"],
                c["read_mb"],
            ]
            for c in clips
        ]
        parts += ["A clip of 700 MB, the best of five readings", ""]
        parts.append(
            table(["length s", "MB", "samples", "seconds", "CPU s", "MB read"], rows)
        )
    rows = [
        [r["format"], *(r["outcomes"].get(k, 0) for k in ("read", "refused", "asked")),
         r["longest_s"], r["peak_mb"]]
        for r in faults
    ]  # fmt: skip
    parts += ["", "Mutations of 8 s", ""]
    parts.append(
        table(["format", "read", "refused", "asked", "longest s", "peak MB"], rows)
    )
    if long:
        rows = [[r["format"], r["size_mb"], r["samples"], r["longest_s"], r["cpu_s"], r["peak_mb"]]
                for r in long]  # fmt: skip
        parts += ["", "Ten hours at 100 Hz", ""]
        parts.append(
            table(["format", "MB", "samples", "seconds", "CPU s", "peak MB"], rows)
        )
    return "```\n" + "\n".join(parts) + "\n```"


if __name__ == "__main__":
    sys.exit(main())
