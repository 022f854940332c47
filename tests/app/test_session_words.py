"""What the operator reads is in the operator's language, and made of words."""

import pytest

from app.bridge import languages
from app.experimenter.start_panel import reason_text
from hapticplayer.haptics.contract import Cause

REASONS = [
    "paused",
    "repeated",
    "skipped",
    "stopped",
    "operator",
    "escape",
    "space",
    "focus_lost",
    "window_closed",
    "clip_damaged",
    "frames_dropped",
    "no_sound",
    "sound_missing",
    "no_device",
    "device_lost",
    "output_fault:rig",
    "periods_missed",
    "no_ticks",
    "record_incomplete",
    "sync:video",
    "sync:sound",
    "fault:unplugged",
]


@pytest.mark.parametrize("language", list(languages.NAMES))
def test_every_reason_is_told_in_words(spoken, language):
    spoken(language)
    texts = [reason_text(reason) for reason in REASONS]
    assert not [text for text in texts if "_" in text or "sync:" in text]
    assert len(set(texts)) == len(REASONS)
    assert reason_text("new_reason") == "new_reason"


@pytest.mark.parametrize("language", list(languages.NAMES))
def test_every_fault_is_told_in_words(spoken, language):
    spoken(language)
    harmless = {Cause.NONE, Cause.PAUSED, Cause.SEEK, Cause.TRACK_ENDED, Cause.CLOSING}
    codes = [cause.name.lower() for cause in set(Cause) - harmless]
    texts = {code: reason_text(f"fault:{code}") for code in codes}
    assert [code for code, text in texts.items() if f"({code})" in text] == (
        ["stopped", "unplugged"] if language == "en" else []
    )
