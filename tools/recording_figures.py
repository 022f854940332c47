"""Draws the pictures of docs/recording.md, from simulated recordings.

python -m tools.recording_figures
"""

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

from app.experimenter.import_mounting import seen
from hapticplayer.capture import synchronize
from hapticplayer.capture.mounting import axes_matrix
from hapticplayer.capture.sync.result import ClipSound
from hapticplayer.cli.plots import draw_sync
from hapticplayer.model.arrays import Floats
from tests.material.sync_clips import simulate_pats

DOCS = Path(__file__).parents[1] / "docs"
PICTURES = {
    "recording-good.png": (False, 200, 100_003, "still, 200 Hz: the pats stand out"),
    "recording-30hz.png": (False, 30, 100_003, "the same pats, averaged to 30 Hz"),
    "recording-hard.png": (True, 30, 100_009, "pats while walking in wind, 30 Hz"),
}

AXES_FIGURE = "recording-axes.svg"
COLOURS = ("#a86800", "#0072b2", "#006b4e")
PANEL_PX, HIGH_PX, SCALE_PX = 190, 190, 58.0


class Fixed(NamedTuple):
    """A recorder as it needs no mounting; its half sides are right, front and up."""

    title: str
    halves: tuple[float, float, float]
    axes: str
    text: str


FIXED = (
    Fixed("Camera", (0.3, 0.3, 0.3), "x,y,z", "lens to the front"),
    Fixed("Phone", (0.32, 0.62, 0.05), "x,y,z", "screen up, top edge in front"),
    Fixed("WT901, Ultimate IMU", (0.4, 0.4, 0.06), "x,y,z", "as printed on the board"),
    Fixed("Razor", (0.3, 0.45, 0.06), "y,x,-z", "x in front, chips up"),
)

_FAR_FIRST = ((2, -1.0), (1, 1.0), (0, 1.0), (0, -1.0), (1, -1.0), (2, 1.0))


def main() -> int:
    """Draw all of them in place of the old ones."""
    (DOCS / AXES_FIGURE).write_text(axes_figure())
    for name, (hard, rate_hz, seed, title) in PICTURES.items():
        clip = simulate_pats(seed, hard=hard, rate_hz=rate_hz)
        found = synchronize(clip.imu, clip.audio, clip.audio_rate_hz)
        confidence = f"confidence {found.clock_map.confidence:.2f}"
        path = DOCS / name
        path.unlink(missing_ok=True)
        sound = ClipSound(clip.audio, clip.audio_rate_hz)
        draw_sync(path, sound, clip.imu, found, f"{title}; {confidence}")
        print(path.name, confidence)
    return 0


def axes_figure() -> str:
    """Recorders beside each other, seen from behind the wearer's left, as SVG."""
    wide_px = PANEL_PX * len(FIXED)
    panels = [line for at, one in enumerate(FIXED) for line in _panel(one, at)]
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide_px} {HIGH_PX}" '
        f'width="{wide_px}" height="{HIGH_PX}" font-family="sans-serif" '
        'font-size="13" text-anchor="middle">'
    )
    ground = f'<rect width="{wide_px}" height="{HIGH_PX}" fill="#ffffff"/>'
    return "\n".join((head, ground, *panels, "</svg>", ""))


def _panel(one: Fixed, number: int) -> Iterator[str]:
    centre = PANEL_PX * (number + 0.5)

    def place_of(place: Floats) -> tuple[float, float]:
        x, y, _ = SCALE_PX * seen(place)
        return centre + x, 0.62 * HIGH_PX - y

    def at(place: Floats) -> str:
        return "{:.1f},{:.1f}".format(*place_of(place))

    halves = np.array(one.halves)
    for axis, sign in _FAR_FIRST:
        corners = " ".join(at(halves * corner) for corner in _side(axis, sign))
        yield (
            f'<polygon points="{corners}" fill="#e4e7eb" fill-opacity="0.85" '
            'stroke="#4b5560" stroke-linejoin="round"/>'
        )
    for name, way, colour in zip("xyz", axes_matrix(one.axes).T, COLOURS, strict=True):
        line = f"M{at(0.0 * way)}L{at(1.05 * way)}"
        yield f'<path d="{line}" stroke="{colour}" stroke-width="2.6"/>'
        x, y = place_of(1.05 * way)
        yield f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{colour}"/>'
        x, y = place_of(1.25 * way)
        yield f'<text x="{x:.1f}" y="{y + 5:.1f}" fill="{colour}">{name}</text>'
    for text, y, weight in ((one.title, 17, "bold"), (one.text, 34, "normal")):
        yield (
            f'<text x="{centre:.1f}" y="{y}" fill="#16191d" '
            f'font-weight="{weight}">{text}</text>'
        )


def _side(axis: int, sign: float) -> list[Floats]:
    """Corners of a side of the unit cube, one after the other."""
    corners = []
    for a, b in ((-1, -1), (-1, 1), (1, 1), (1, -1)):
        corner = np.insert(np.array([a, b], float), axis, sign)
        corners.append(corner)
    return corners


if __name__ == "__main__":
    sys.exit(main())
