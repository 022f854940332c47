"""Skips tests whose material belongs to an extra that has been deleted."""

import re
import sys
from importlib.abc import MetaPathFinder
from pathlib import Path

import pytest

TESTS = Path(__file__).parent
OF_AN_EXTRA = re.compile(r"(?:hapticplayer|app|tests\.unit|tests\.app)\.extras\.(\w+)")


def needs(*names: str) -> pytest.MarkDecorator:
    """A mark for what names formats, devices or commands of extras."""
    extras = Path(__file__).parents[1] / "hapticplayer" / "extras"
    absent = [name for name in names if not (extras / name).is_dir()]
    return pytest.mark.skipif(
        bool(absent), reason=f"needs the extra {', '.join(absent)}"
    )


class NeededExtras(MetaPathFinder):
    """Asked last, when nobody has found a module; errors of the core stay errors."""

    def find_spec(self, name, path=None, target=None):
        needed = OF_AN_EXTRA.fullmatch(name)
        if needed and _importer().is_relative_to(TESTS):
            pytest.skip(f"needs the extra {needed[1]}", allow_module_level=True)


def _importer() -> Path:
    """The file with the import statement."""
    frame = sys._getframe(2)
    while frame and "importlib" in frame.f_code.co_filename:
        frame = frame.f_back
    return Path(frame.f_code.co_filename if frame else "")


def install() -> None:
    sys.meta_path.append(NeededExtras())
