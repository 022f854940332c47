"""Figures of recordings: motion and gravity; sound and acceleration with the pats."""

import warnings
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hapticplayer.capture.sync.result import ClipSound, Synchronisation
from hapticplayer.model import ImuLog
from hapticplayer.model.arrays import Floats
from hapticplayer.sequence.processing import Processed

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SIZE_IN = (11.0, 7.5)
DPI = 120
BINS = 2000
"""Longer recordings are drawn as the smallest and largest value of so many parts."""

_MEASURED, _GRAVITY, _MOTION, _INVALID = "#9aa5b1", "#d97706", "#1d4ed8", "#dc2626"
_PROGRAM = "hapticplayer"
_AXES = ("x (right)", "y (front)", "z (up)")


def draw_motion(path: Path, processed: Processed, title: str) -> None:
    """Draw measured specific force, gravity with its sigma, and p[k] over time.

    One panel for each axis of frame A; spans that are not valid are shaded. The same
    input gives the same file.

    Args:
        path: of the new file; its ending (.png or .svg) is the format.
        processed: a recording without gravity.
        title: of the figure.
    """
    import matplotlib as mpl
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    # ids and the date of an SVG would make every file another
    with (
        mpl.rc_context({"svg.hashsalt": "hapticplayer", "svg.fonttype": "none"}),
        warnings.catch_warnings(),
    ):
        warnings.filterwarnings("ignore", "Glyph .* missing", UserWarning)
        figure = Figure(figsize=SIZE_IN, layout="constrained")
        FigureCanvasAgg(figure)
        panels = figure.subplots(3, 1, sharex=True)
        for axis, panel in enumerate(panels):
            _draw_axis(panel, processed, axis)
        _label(figure, panels, processed, title)
        _save(figure, path)


def _save(figure: "Figure", path: Path) -> None:
    is_svg = path.suffix.lower() == ".svg"
    mark = {"Date": None, "Creator": _PROGRAM} if is_svg else {"Software": _PROGRAM}
    figure.savefig(path, dpi=DPI, metadata=mark)


def is_plot(head: bytes) -> bool:
    """Whether a file begins as a figure that was drawn here."""
    marks = (f"tEXtSoftware\0{_PROGRAM}", f"<dc:title>{_PROGRAM}</dc:title>")
    return any(mark.encode() in head for mark in marks)


def _draw_axis(panel: "Axes", processed: Processed, axis: int) -> None:
    track, time_s = processed.track, processed.track.time_s
    measured = processed.imu.specific_force_mps2[:, axis]
    gravity = track.gravity_mps2[:, axis]
    _draw_line(panel, time_s, measured, _MEASURED, "measured specific force")
    _draw_line(panel, time_s, track.acceleration_mps2[:, axis], _MOTION, "motion p")
    if track.gravity_sigma_mps2 is not None:
        part = _bin_starts(len(time_s))
        sigma = np.maximum.reduceat(track.gravity_sigma_mps2, part)
        panel.fill_between(
            time_s[part],
            gravity[part] - sigma,
            gravity[part] + sigma,
            color=_GRAVITY,
            alpha=0.3,
            linewidth=0.0,
            label="gravity ± sigma",
        )
    _draw_line(panel, time_s, gravity, _GRAVITY, "gravity")
    for number, (start_s, end_s) in enumerate(invalid_spans(time_s, track.valid)):
        label = "not valid" if not number else None
        panel.axvspan(
            start_s, end_s, color=_INVALID, alpha=0.15, linewidth=0.0, label=label
        )
    panel.set_ylabel(f"{_AXES[axis]}, m/s²")
    panel.grid(visible=True, color="#e5e7eb", linewidth=0.6)
    panel.margins(x=0.0)


def _label(
    figure: "Figure", panels: NDArray[np.object_], processed: Processed, title: str
) -> None:
    method = processed.summary["method"]
    # a file may have any name: no formulas, no halves of characters
    title = title.encode(errors="replace").decode()
    panels[0].set_title(
        f"{title}: gravity removed by {method}", loc="left", parse_math=False
    )
    panels[-1].set_xlabel("time of the recording, s")
    named = {}
    for panel in panels:
        named.update(dict(zip(*panel.get_legend_handles_labels()[::-1], strict=True)))
    figure.legend(
        named.values(),
        named.keys(),
        loc="outside lower center",
        ncols=len(named),
        frameon=False,
    )


def _draw_line(
    panel: "Axes", time_s: Floats, values: Floats, colour: str, label: str
) -> None:
    time_s, values = envelope(time_s, values)
    panel.plot(time_s, values, color=colour, linewidth=0.9, label=label)


def envelope(time_s: Floats, values: Floats) -> tuple[Floats, Floats]:
    """Return a curve of few points (M,) that looks like the full one.

    Each bin contributes its smallest and its largest value at its start, so that no
    peak is lost.
    """
    if len(time_s) <= 2 * BINS:
        return time_s, values
    part = _bin_starts(len(time_s))
    low, high = np.minimum.reduceat(values, part), np.maximum.reduceat(values, part)
    return np.repeat(time_s[part], 2), np.stack([low, high], axis=1).ravel()


def _bin_starts(count: int) -> NDArray[np.intp]:
    """Return the starts of up to BINS bins; all samples of a short recording."""
    if count <= 2 * BINS:
        return np.arange(count)
    return np.linspace(0, count, BINS, endpoint=False).astype(np.intp)


def invalid_spans(
    time_s: Floats, valid: NDArray[np.bool_]
) -> list[tuple[float, float]]:
    """Return start and end of the spans that are not valid, s; neighbours are joined.

    On a long recording, spans too close to be distinguished are joined.
    """
    edges = np.flatnonzero(np.diff(~valid, prepend=False, append=False))
    if not len(edges):
        return []
    before = time_s[np.maximum(edges[::2] - 1, 0)]
    after = time_s[np.minimum(edges[1::2], len(time_s) - 1)]
    apart_s = (time_s[-1] - time_s[0]) / BINS
    joins = np.flatnonzero(before[1:] - after[:-1] > apart_s)
    begins = before[np.concatenate([[0], joins + 1])]
    ends = after[np.concatenate([joins, [len(after) - 1]])]
    return list(zip(begins.tolist(), ends.tolist(), strict=True))


_SOUND, _PAT = "#0f766e", "#d97706"
_AROUND_S = 1.5


def draw_sync(
    path: Path, sound: ClipSound, imu: ImuLog, found: Synchronisation, title: str = ""
) -> None:
    """Draw the whole recording, and the pats themselves in a closer view.

    The same input gives the same file.

    Args:
        path: of the new file; its ending (.png or .svg) is the format.
        sound: of the clip.
        imu: its log.
        found: the synchronisation of the log with the clip.
        title: of the figure; empty for offset and confidence.
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
        for column, (start_s, end_s) in enumerate(_spans(found, heard_s)):
            _draw(panels[0, column], heard_s, samples, _SOUND, (start_s, end_s))
            _draw(panels[1, column], felt_s, size, _MOTION, (start_s, end_s))
            for panel in panels[:, column]:
                _mark(panel, found)
            panels[1, column].set_xlim(start_s, end_s)
            panels[1, column].set_xlabel("media time, s")
        panels[0, 0].set_ylabel("sound")
        panels[1, 0].set_ylabel("specific force, m/s²")
        default = f"offset {found.offset_s:.3f} s, confidence {clock.confidence:.2f}"
        panels[0, 0].set_title(title or default, loc="left", parse_math=False)
        panels[0, 1].set_title("the taps", loc="left")
        _save(figure, path)


def _spans(found: Synchronisation, heard_s: Floats) -> list[tuple[float, float]]:
    """Return the span of the whole clip, and that around the first three pats."""
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
