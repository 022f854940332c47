"""A picture of every page in every language, theme and scale, without a screen.

    python -m tools.screenshots -o FOLDER [--languages en de] [--themes dark light]
        [--scales 1 2 3] [--screen 1280 720] [--only player study] [--sheets]
        [--docs docs]

Pages are shown as a person meets them: empty, at work, doubtful, wrong, and with names
and questions that are too long. The screen has 1920 x 1080 pixels at 100 and at 200 %,
3840 x 2160 at 300 %, unless `--screen` says another size. `--sheets` puts the pictures of a group on contact sheets,
`--docs` writes those that the documentation shows.
"""

import argparse
import gc
import itertools
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

SCREENS = {1.0: (1920, 1080), 2.0: (1920, 1080), 3.0: (3840, 2160)}
LARGEST = (3840, 2160)  # for other scales
LANGUAGES, THEMES = ("en", "fr", "de"), ("dark", "light", "contrast")
GROUPS = ("player", "device", "library", "editor", "study", "kinds")
DOCS = {
    "player-playing": "screenshot.png",
    "import-sync-sure": "import.png",
    "library-4": "library.png",
    "editor-working": "editor.png",
    "rendering-equal": "rendering.png",
    "operator-playing": "operator.png",
    "study-trial-03-questions": "questions.png",
    "faults-shown": "faults.png",
}
IN_DOCS, DOCS_PX, DOCS_COLOURS = "en-light-100", 960, 255
SHEET_PX, WIDEST_PX, HIGHEST_PX = 1560, 776, 740  # of contact sheets
TEXT_PX, GAP_PX, LEAST_PX = 20, 6, 160


def main() -> int:
    """Make the pictures that are asked for, and print their names."""
    options = _options()
    options.output.mkdir(parents=True, exist_ok=True)
    parts = list(itertools.product(options.scales, options.only))
    if len(parts) > 1:
        # Qt takes the scale when it begins, and all windows of a group end with it
        return max(abs(_in_process(options, *part)) for part in parts)
    with tempfile.TemporaryDirectory() as folder:
        _make(options, Path(folder))
    return 0


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.add_argument("--languages", nargs="+", choices=LANGUAGES, default=LANGUAGES)
    parser.add_argument("--themes", nargs="+", choices=THEMES, default=THEMES)
    parser.add_argument("--scales", nargs="+", type=float, default=list(SCREENS))
    parser.add_argument("--screen", nargs=2, type=int, metavar=("WIDTH", "HEIGHT"))
    parser.add_argument("--only", nargs="+", choices=GROUPS, default=GROUPS)
    parser.add_argument("--sheets", action="store_true", help="also put on sheets")
    parser.add_argument("--docs", type=Path, help="folder for the few in the docs")
    return parser.parse_args()


def _in_process(options: argparse.Namespace, scale: float, group: str) -> int:
    command = [sys.executable, "-m", "tools.screenshots", "-o", options.output]
    for name in ("languages", "themes"):
        command += [f"--{name}", *getattr(options, name)]
    command += ["--only", group, "--scales", str(scale)]
    command += ["--screen", *map(str, options.screen)] if options.screen else []
    command += [*(["--sheets"] if options.sheets else [])]
    command += ["--docs", options.docs] if options.docs else []
    return subprocess.run(command, check=False).returncode


def _make(options: argparse.Namespace, folder: Path) -> None:
    scale = options.scales[0]
    _use_screen(folder, scale, options.screen or SCREENS.get(scale, LARGEST))
    # only now: these begin Qt's platform
    from app.bridge.collector import Collector
    from app.bridge.settings import LANGUAGE, THEME, Settings
    from app.player.application import make_application
    from app.player.remake import apply_appearance
    from hapticplayer.playback.source import open_source
    from tools.pages import device, editor, kinds, library, player, study
    from tools.pages.material import make_material
    from tools.pages.stage import Stage

    makers = {
        "player": player.pictures,
        "device": device.pictures,
        "library": library.pictures,
        "editor": editor.pictures,
        "study": study.pictures,
        "kinds": kinds.pictures,
    }
    application = make_application()
    collector = Collector()  # else windows that are gone are freed in any thread
    collector.begin()
    (folder / "material").mkdir()
    material = make_material(folder / "material")
    source = open_source(material.demo)
    for language in options.languages:
        for theme in options.themes:
            settings = Settings(None)
            settings.keep(LANGUAGE, language)
            settings.keep(THEME, theme)
            apply_appearance(application, settings)
            room = folder / f"{language}-{theme}"
            room.mkdir()
            stage = Stage(application, settings, source, material, room, language)
            for group in options.only:
                made = []
                for name, picture in makers[group](stage):
                    at = f"{name}-{language}-{theme}-{100 * scale:.0f}.png"
                    made.append(options.output / at)
                    picture.save(str(made[-1]))
                    print(made[-1], flush=True)
                    if options.docs and name in DOCS and IN_DOCS in at:
                        _put_into_docs(made[-1], options.docs / DOCS[name])
                if options.sheets:
                    end = f"{language}-{theme}-{100 * scale:.0f}"
                    _put_on_sheets(made, options.output / "sheets", f"{group}-{end}")
    gc.collect()
    collector.end()


def _use_screen(folder: Path, scale: float, size: tuple[int, int]) -> None:
    """Begin Qt on a screen of its own, with nothing of the user's."""
    width, height = size
    screen = {"name": "HDMI-1", "x": 0, "y": 0, "width": width, "height": height}
    screen |= {"logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1}
    config = folder / "screens.json"
    config.write_text(json.dumps({"screens": [screen]}))
    os.environ["QT_QPA_PLATFORM"] = f"offscreen:configfile={config}"
    os.environ["QT_SCALE_FACTOR"] = str(scale)
    os.environ["XDG_CONFIG_HOME"] = str(folder / "config")


def _put_into_docs(path: Path, target: Path) -> None:
    """Make a picture small: no wider than a page, few colours."""
    from PIL import Image

    with Image.open(path) as image:
        small = image.convert("RGB")
    small.thumbnail((DOCS_PX, DOCS_PX), Image.Resampling.LANCZOS)
    faithful = Image.Quantize.FASTOCTREE  # the others turn yellow into grey
    small.quantize(DOCS_COLOURS, faithful).save(target, optimize=True)


def _put_on_sheets(paths: list[Path], folder: Path, name: str) -> None:
    """Put pictures side by side, each with its name, as large as can be read."""
    from PySide6.QtCore import Qt
    from PySide6.QtGui import QImage, QPainter

    folder.mkdir(exist_ok=True)
    sheets: list[QImage] = []
    x = y = row_px = SHEET_PX
    for path in paths:
        image = QImage(str(path))
        image.setDevicePixelRatio(1.0)
        if image.width() > WIDEST_PX or image.height() > HIGHEST_PX:
            image = image.scaled(
                WIDEST_PX,
                HIGHEST_PX,
                Qt.AspectRatioMode.KeepAspectRatio,
                Qt.TransformationMode.SmoothTransformation,
            )
        if x + image.width() > SHEET_PX:
            x, y, row_px = 0, y + row_px, 0
        if y + TEXT_PX + image.height() > SHEET_PX:
            y = 0
            sheets.append(QImage(SHEET_PX, SHEET_PX, QImage.Format.Format_RGB32))
            sheets[-1].fill(0xFF808080)
        with QPainter(sheets[-1]) as painter:
            painter.drawText(x, y + TEXT_PX - GAP_PX, path.stem)
            painter.drawImage(x, y + TEXT_PX, image)
        x += max(image.width(), LEAST_PX) + GAP_PX
        row_px = max(row_px, image.height() + TEXT_PX + GAP_PX)
    for number, sheet in enumerate(sheets, 1):
        sheet.save(str(folder / f"{name}-{number}.png"))


if __name__ == "__main__":
    sys.exit(main())
