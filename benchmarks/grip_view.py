"""Time to paint the grip in space, 320 x 320, on the processor alone.

    python benchmarks/grip_view.py [--times 500]

With everything that can be shown: trail, three arrows, the marked edge. "step" is what
each new position costs, "turn" what a drag costs, which paints the scene anew.
"""

import argparse
import math
import os
import time
from collections.abc import Callable
from dataclasses import replace

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import numpy as np
from common import save, table
from PySide6.QtCore import QSizeF
from PySide6.QtGui import QImage, QPainter

from app.player.application import make_application
from app.plots.grip_camera import Camera
from app.plots.grip_painter import GripPainter
from app.plots.grip_scene import Activity, Grip

SIDE_PX = 320
TRAIL_M = tuple(
    (0.03 * math.sin(k / 6), 0.02 * math.cos(k / 5), 0.01 * math.sin(k / 9))
    for k in range(26)
)
GRIP = Grip(
    "Simulated grip",
    "Force is active",
    Activity.ACTIVE,
    (0.030, 0.015, 0.010),
    (2.0, 1.0, 1.0),
    (2.5, 1.0, 1.0),
    (-0.8, -0.4, -0.2),
    TRAIL_M,
)


def measure(times: int, ratio: float, camera_of: Callable[[int], Camera]) -> np.ndarray:
    """Return how long each of some paintings took, ms."""
    side = round(SIDE_PX * ratio)
    image = QImage(side, side, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    scene, took_ms = GripPainter(), []
    for number in range(times + 20):
        grip = replace(GRIP, position_m=(0.030, 0.015, 0.0001 * (number % 90)))
        start_s = time.perf_counter()
        painter = QPainter(image)
        scene.paint(painter, QSizeF(SIDE_PX, SIDE_PX), camera_of(number), grip)
        painter.end()
        took_ms.append(1e3 * (time.perf_counter() - start_s))
    return np.array(took_ms[20:])


def main() -> None:
    """Measure, print and keep."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--times", type=int, default=500)
    times = parser.parse_args().times
    application = make_application()
    kinds: dict[str, Callable[[int], Camera]] = {
        "step": lambda _number: Camera(),
        "turn": lambda number: Camera(0.01 * number),
    }
    rows, results = [], {}
    for ratio in (1.0, 2.0):
        for kind, camera_of in kinds.items():
            p50, p95 = np.percentile(measure(times, ratio, camera_of), [50, 95])
            rows.append([kind, f"{ratio:g}", f"{p50:.2f}", f"{p95:.2f}"])
            results[f"{kind}_x{ratio:g}"] = {"p50_ms": p50, "p95_ms": p95}
    print(table(["painting", "scale", "p50, ms", "p95, ms"], rows))
    save("grip_view", results)
    application.quit()


if __name__ == "__main__":
    main()
