"""OpenCV that is installed, but cannot be loaded."""

import sys

import pytest

from hapticplayer.capture.frames import FeatureKind
from hapticplayer.capture.sync.result import COARSE_NOTE
from hapticplayer.errors import InputError
from hapticplayer.extras.frames import watching
from hapticplayer.extras.frames.rotation import rotation
from hapticplayer.extras.frames.watching import is_available
from hapticplayer.sequence.synchronizing import coarse_notes


@pytest.fixture
def broken(tmp_path, monkeypatch):
    package = tmp_path / "cv2"
    package.mkdir()
    (package / "__init__.py").write_text("raise ImportError('libGL.so.1: not found')")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "cv2", raising=False)
    watching.why_broken.cache_clear()
    yield
    watching.why_broken.cache_clear()


def test_frames_are_followed_by_the_vectors_of_the_codec(broken, tiny_clip):
    assert not is_available()
    assert rotation(tiny_clip.path).kind == FeatureKind.VECTORS


def test_the_reason_is_given(broken, tiny_clip):
    with pytest.raises(InputError, match=r"cannot be loaded \(libGL"):
        next(watching.watched(tiny_clip.path))
    assert coarse_notes()[0] == COARSE_NOTE
    assert "libGL.so.1: not found" in coarse_notes()[1]
