"""Force in files of other programs, each beside its right value.

The files are made here as those programs write them; the right value follows from what
was written, or is a refusal that names the cause and a remedy.
"""

import json
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.robustness.as_typed import CASES, Found, Ran, Row, hapticplayer, says

_EDGE_N = 1.6
"""Of a funscript at 100: 40 N/m over 40 mm."""

_WITHIN_N = 0.03
_LINE = [{"at": 0, "pos": 100}, {"at": 1000, "pos": 100}]
_SEM = (
    '<SEM xmlns="urn:mpeg:mpeg-v:2010:01-SEDL-NS" '
    'xmlns:sev="urn:mpeg:mpeg-v:2010:01-SEV-NS" '
    'xmlns:si="urn:mpeg:mpeg21:2003:01-DIA-XSI-NS" '
    'xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" si:timeScale="1000">{}</SEM>'
)
_PUSH = (
    '<Effect xsi:type="sev:ActiveKinestheticType" {} duration="500">'
    '<sev:ActiveKinesthetic fy="2"/></Effect>'
)


def rows() -> list[Row]:
    """All rows."""
    return [*_cases(), *_sounds(), *_scripts(), *_effects(), *_tables()]


# --- the cases -----------------------------------------------------------------------


def _cases() -> list[Row]:
    folder = CASES / "funscript-axes"
    found = [
        Row("funscript-axes", path.name, "0 N where it says off, or refused",
            lambda into, path=path: _off(into, path))
        for path in sorted(folder.glob("clip.*.funscript"))
    ]  # fmt: skip
    negative = folder / "negative_at.funscript"
    begins = Row("funscript-axes", negative.name, "0.69 N at 0 ms",
        lambda into: _felt(into, negative, {0.0: 0.69}))  # fmt: skip
    return [*found, begins]


def _off(into: Path, path: Path) -> Found:
    ran, table = _converted(into, path)
    if table is None:
        return says(ran, "strength|axis|vib|suck|valve|lube")
    largest_n = float(np.abs(table[table[:, 0] < 0.9, 1:]).max())
    return Found(f"{largest_n:.2f} N while off", largest_n == 0.0)


def _converted(into: Path, path: Path, *options: object) -> tuple[Ran, Any]:
    target = into / "force.csv"
    target.unlink(missing_ok=True)
    ran = hapticplayer("convert", path, target, *options)
    if ran.status:
        return ran, None
    return ran, np.loadtxt(target, delimiter=",", skiprows=1, ndmin=2)


def _felt(
    into: Path, path: Path, right_n: dict[float, float], *options: object
) -> Found:
    """Whether the force has its size at some times, s, and what its file left unread."""
    ran, table = _converted(into, path, *options)
    if table is None:
        return Found(ran.short, is_right=False)
    places = np.searchsorted(table[:, 0], [*right_n], side="right") - 1
    sizes = np.linalg.norm(table[places, 1:], axis=1) * (places >= 0)
    shown = ", ".join(f"{size:.2f}" for size in sizes)
    is_right = np.allclose(sizes, [*right_n.values()], atol=_WITHIN_N)
    return Found(f"{shown} N", bool(is_right))


def _row(
    what: str,
    name: str,
    content: str | bytes,
    right_n: dict[float, float],
    *options: object,
) -> Row:
    """A file, and its force at some times."""

    def run(into: Path) -> Found:
        return _felt(into, _written(into, name, content), right_n, *options)

    right = ", ".join(f"{size:.2f} N at {at_s:g} s" for at_s, size in right_n.items())
    return Row("published formats", what, right, run)


def _refused(what: str, name: str, content: str | bytes, *words: str) -> Row:
    """A file that is refused, or of which a part is listed as not read."""

    def run(into: Path) -> Found:
        path = _written(into, name, content)
        return says(hapticplayer("import-force", "--check", path), *words)

    return Row("published formats", what, f"says: {', '.join(words)}", run)


def _written(into: Path, name: str, content: str | bytes) -> Path:
    folder = into / "made"
    folder.mkdir(exist_ok=True)
    path = folder / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


# --- sounds --------------------------------------------------------------------------


def _wav(
    samples: np.ndarray, code: int = 1, order: str = "<", before: bytes = b""
) -> bytes:
    """A WAV file of samples (n, channels) at 1 kHz."""
    width, channels = samples.dtype.itemsize, samples.shape[1]
    data = samples.astype(samples.dtype.newbyteorder(order)).tobytes()
    block = width * channels
    form = struct.pack(
        f"{order}HHIIHH", code, channels, 1000, 1000 * block, block, 8 * width
    )

    def chunk(name: bytes, content: bytes) -> bytes:
        return name + struct.pack(f"{order}I", len(content)) + content

    body = b"WAVE" + chunk(b"fmt ", form) + before + chunk(b"data", data)
    return (b"RIFX" if order == ">" else b"RIFF") + chunk(b"", body)


def _sounds() -> list[Row]:
    levels = np.repeat([[0.25, 0.0, 0.0]], 1000, axis=0)
    whole = (levels * 32768).astype("i2")
    right_n = {0.1: 0.25, 0.9: 0.25}
    nine = np.zeros((1000, 9), "i2")
    nine[:, 4], nine[:, 8] = 8192, 4096
    odd = b"LIST" + struct.pack("<I", 13) + b"INFOISFT\1\0\0\0a"
    half = levels.astype("f2")
    open_end = _wav(whole)
    place = open_end.index(b"data") + 4
    open_end = open_end[:place] + bytes(4) + open_end[place + 4 :]
    return [
        _row("RIFX of 16 bits", "a.wav", _wav(whole, order=">"), right_n),
        _row("RIFX of floats", "a.wav", _wav(levels.astype("f4"), 3, ">"), right_n),
        _row("WAV of floats of 16 bits", "a.wav", _wav(half, 3), right_n),
        _row("WAV of 9 channels", "a.wav", _wav(nine), {0.5: 0.375}),
        _row("chunk without its pad byte", "a.wav", _wav(whole, before=odd), right_n),
        _row("WAV from a pipe, length 0", "a.wav", open_end, right_n),
        _refused("WAV of A-law", "a.wav", _wav(np.zeros((9, 1), "u1"), 6), "ffmpeg -i"),
    ]


# --- scripts -------------------------------------------------------------------------


def _scripts() -> list[Row]:
    nulls = {"axes": None, "channels": None, "metadata": None, "range": None}
    odd = {"Actions": [{"At": "0", "Pos": "100"}, {"at": 1000.0, "pos": 1e2}]}
    seconds = {"actions": [{"at": 0.3 * k, "pos": k % 2 * 100} for k in range(9)]}
    levels = [(0, 0), (500, 0), (500, 100), (1000, 100)]
    vibration = {"actions": [{"at": at, "pos": level} for at, level in levels]}
    right_n = {0.1: _EDGE_N, 0.9: _EDGE_N}

    def row(what: str, name: str, script: Any, right_n: dict[float, float]) -> Row:
        return _row(what, f"{name}.funscript", json.dumps(script), right_n)

    def refused(what: str, name: str, script: Any, *words: str) -> Row:
        return _refused(what, f"{name}.funscript", json.dumps(script), *words)

    return [
        row("funscript with nulls", "a", {"actions": _LINE, **nulls}, right_n),
        row("funscript in capitals and quotes", "a", odd, right_n),
        row("strengths of .vib", "b.vib", vibration, {0.3: 0.0, 0.505: 1.0, 0.9: 0.0}),
        refused("actions that are null", "c", {"actions": None}, "actions are null"),
        refused("times in seconds", "c", seconds, "seconds", "by 1000"),
        refused("strengths of .suck", "d.suck", vibration, "strengths", "rename it"),
    ]


# --- effects -------------------------------------------------------------------------


def _effects() -> list[Row]:
    both = _PUSH.format('si:pts="0"') + _PUSH.format('si:pts="1000"')
    group = f'<GroupOfEffects id="g">{both}</GroupOfEffects>'
    declared = f"<Declarations>{group}</Declarations>"
    played = f'{declared}<ReferenceEffect uri="#g" si:pts="5000"/>'
    at_five = {0.2: 0.0, 5.2: 2.0, 5.8: 0.0, 6.2: 2.0, 6.8: 0.0}
    early = f'<GroupOfEffects si:pts="5000">{both}</GroupOfEffects>'
    delta = _PUSH.format('si:pts="0"') + _PUSH.format('si:ptsDelta="3000"')

    def other(name: str) -> str:
        frame = {"amplitude_modulation": 0.5}
        frames = [{"relative_position": at_ms, **frame} for at_ms in (0, 1000)]
        band = {"band_type": "Curve", "curve_type": "Linear"}
        band |= {"effects": [{"effect_type": "Basis", "keyframes": frames}]}
        one = {"perception_modality": name, "channels": [{"bands": [band]}]}
        return json.dumps({"perceptions": [one]})

    return [
        _row("declared group of MPEG-V", "a.sem", _SEM.format(played), at_five),
        _row("group whose effects have pts 0", "a.sem", _SEM.format(early), at_five),
        _refused("ptsDelta of MPEG-V", "a.sem", _SEM.format(delta), "another time"),
        _refused("hjif Other", "a.hjif", other("Other"), "--other-is vibration"),
        _row("hjif Other, as force", "a.hjif", other("Other"), {0.5: 0.5},
             "--other-is", "force"),
        Row("published formats", "export of hjif", "no date", _dates),
    ]  # fmt: skip


def _dates(into: Path) -> Found:
    """Whether a file tells when it was made."""
    source, target = _written(into, "a.csv", _TABLE), into / "made" / "out.hjif"
    target.unlink(missing_ok=True)
    ran = hapticplayer("convert", source, target)
    if ran.status:
        return Found(ran.short, is_right=False)
    date = json.loads(target.read_text(encoding="utf-8"))["date"]
    return Found(f"date {date!r}", is_right=date == "")


# --- tables --------------------------------------------------------------------------

_TABLE = "time_s,fx_n,fy_n,fz_n\n0,0,1.5,0\n1,0,0,0\n"


def _tables() -> list[Row]:
    excel = "sep=;\r\n" + _TABLE.replace(",", ";").replace("1.5", "1,5")
    made: tuple[tuple[str, Callable[[str], str]], ...] = (
        ("capitals", lambda text: text.replace("time", "Time").replace("f", "F")),
        ("comments before the header", lambda text: f"# by me\n\n{text}"),
        ("blanks between columns", lambda text: text.replace(",", "  ")),
        ("bars between columns", lambda text: text.replace(",", "|")),
    )
    spelt = [
        _row(f"CSV with {what}", "a.csv", how(_TABLE), {0.5: 1.5})
        for what, how in made
    ]  # fmt: skip
    utf16 = _TABLE.encode("utf-16")
    return [
        *spelt,
        _row("CSV of Excel with sep=;", "a.csv", excel, {0.5: 1.5}),
        _refused("CSV in UTF-16", "a.csv", utf16, "utf-16", "utf-8"),
    ]
