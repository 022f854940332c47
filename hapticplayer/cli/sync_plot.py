"""Draws sound and acceleration on one time line, with the pats that join them."""

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from hapticplayer.capture.sync.result import Synchronisation
from hapticplayer.capture.sync.synchronize import Sound
from hapticplayer.cli.plots import DPI, envelope
from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_SOUND, _MOTION, _PAT = "#0f766e", "#1d4ed8", "#d97706"
_AROUND_S = 1.5


def draw_sync(
    path: Path, sound: Sound, imu: ImuLog, found: Synchronisation, title: str = ""
) -> None:
    """Draw the whole recording, and the pats themselves in a closer view.

    The same input gives the same file.

    Args:
        path: of the new file; its ending (.png or .svg) is the format.
        sound: of the clip.
        imu: its log.
        found: how the log lies to the clip.
        title: for people; empty for what was found.
    """
    import matplotlib as mpl
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    clock = found.clock_map
    heard_s = np.arange(len(sound.samples)) / sound.rate_hz - found.sound_late_s
    felt_s = clock.rate * imu.time_s + clock.offset_s
    samples = sound.samples.astype(float)
    size = np.linalg.norm(imu.specific_force_mps2, axis=1)
    with mpl.rc_context({"svg.hashsalt": "hapticplayer", "svg.fonttype": "none"}):
        figure = Figure(figsize=(9.0, 4.6), layout="constrained")
        FigureCanvasAgg(figure)
        panels = figure.subplots(2, 2, sharex="col", width_ratios=(2, 1))
        for column, (begin_s, end_s) in enumerate(_spans(found, heard_s)):
            _draw(panels[0, column], heard_s, samples, _SOUND, (begin_s, end_s))
            _draw(panels[1, column], felt_s, size, _MOTION, (begin_s, end_s))
            for panel in panels[:, column]:
                _mark(panel, found)
            panels[1, column].set_xlim(begin_s, end_s)
            panels[1, column].set_xlabel("media time, s")
        panels[0, 0].set_ylabel("sound")
        panels[1, 0].set_ylabel("specific force, m/s²")
        default = f"offset {clock.offset_s:.3f} s, confidence {clock.confidence:.2f}"
        panels[0, 0].set_title(title or default, loc="left", parse_math=False)
        panels[0, 1].set_title("the pats", loc="left")
        is_svg = path.suffix.lower() == ".svg"
        metadata = {"Date": None} if is_svg else {"Software": None}
        figure.savefig(path, dpi=DPI, metadata=metadata)


def _spans(found: Synchronisation, heard_s: Floats) -> list[tuple[float, float]]:
    """Return the whole clip, and what lies around the first three pats."""
    end_s = float(heard_s[-1]) if len(heard_s) else 1.0
    pats_s = [pat.heard_s for pat in found.pats[:3]] or [0.0]
    return [(0.0, end_s), (pats_s[0] - _AROUND_S / 2, pats_s[-1] + _AROUND_S / 2)]


def _draw(
    panel: "Axes",
    time_s: Floats,
    values: Floats,
    colour: str,
    span_s: tuple[float, float],
) -> None:
    first, last = np.searchsorted(time_s, span_s)
    x, y = envelope(time_s[first:last], values[first:last])
    panel.plot(x, y, color=colour, linewidth=0.7)
    panel.grid(visible=True, color="#e5e7eb", linewidth=0.6)


def _mark(panel: "Axes", found: Synchronisation) -> None:
    for pat in found.pats:
        at_s = pat.heard_s - found.sound_late_s
        panel.axvline(at_s, color=_PAT, linewidth=1.0, alpha=0.8)
