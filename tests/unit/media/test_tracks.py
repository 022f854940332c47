"""Audio tracks and subtitles, against what ffmpeg has written."""

import subprocess

import numpy as np
import pytest

from hapticplayer.errors import Cancelled, MediaError, no_progress
from hapticplayer.media.audio import AudioDecoder
from hapticplayer.media.tracks import (
    LONGEST_CAPTION,
    ClipTracks,
    OfferedTrack,
    read_subtitles,
    tracks_of,
)

SRT = """1
00:00:00,500 --> 00:00:02,000
Hello <i>rider</i>

2
00:00:02,500 --> 00:00:04,000
Second line
of two

3
00:00:04,200 --> 00:00:04,500
{long}
"""
TONES_HZ = (440, 880)


@pytest.fixture(scope="module", params=["mkv", "mp4"])
def clip(tmp_path_factory, request):
    """5 s with two tones and three captions, the video a little late."""
    folder = tmp_path_factory.mktemp("tracks")
    (folder / "a.srt").write_text(SRT.format(long="x" * 900))
    path = folder / f"clip.{request.param}"
    tones = [("-f", "lavfi", "-i", f"sine={hz}:d=5") for hz in TONES_HZ]
    subprocess.run(
        [
            *("ffmpeg", "-v", "error", "-f", "lavfi", "-i", "color=s=64x36:r=25:d=5"),
            *(word for tone in tones for word in tone),
            *("-i", folder / "a.srt", "-map", "0", "-map", "1", "-map", "2"),
            *("-map", "3", "-c:v", "libx264", "-c:a", "aac", "-bf", "0"),
            *("-c:s", "srt" if request.param == "mkv" else "mov_text"),
            *("-metadata:s:a:1", "language=deu", "-metadata:s:a:1", "title=Kommentar"),
            *("-metadata:s:s:0", "language=eng", path),
        ],
        check=True,
    )
    return path


def test_tracks_have_language_and_title(clip):
    found = tracks_of(clip)
    assert found.sound == (OfferedTrack(0, "", ""), OfferedTrack(1, "deu", "Kommentar"))
    assert found.subtitles == (OfferedTrack(0, "eng", ""),)


def test_captions_have_their_times_and_no_styles(clip):
    found = read_subtitles(clip, 0, progress=no_progress)
    texts = ["Hello rider", "Second line\nof two", LONGEST_CAPTION * "x"]
    assert [one.text for one in found] == texts
    times = [(one.start_s, one.end_s) for one in found]
    wanted = [(0.5, 2.0), (2.5, 4.0), (4.2, 4.5)]
    np.testing.assert_allclose(times, wanted, atol=0.06)  # of the video's first frame


@pytest.mark.parametrize("track", [0, 1])
def test_the_track_that_is_chosen_is_decoded(clip, track):
    with AudioDecoder(clip, channels=1, track=track) as decoder:
        decoder.seek(2.0)
        block = decoder.next_block()
        while len(block.samples) < 512:
            block = decoder.next_block()
    spectrum = np.abs(np.fft.rfft(block.samples[:, 0] * np.hanning(len(block.samples))))
    loudest_hz = np.argmax(spectrum) * decoder.rate_hz / len(block.samples)
    assert loudest_hz == pytest.approx(TONES_HZ[track], abs=60.0)


def test_tracks_that_are_not_there_are_refused(clip):
    with pytest.raises(MediaError, match="has no such subtitles"):
        read_subtitles(clip, 1, progress=no_progress)
    with pytest.raises(MediaError, match="holds no sound"):
        AudioDecoder(clip, track=2)


def test_reading_subtitles_stops_when_asked(clip):
    def stop(_fraction, _step):
        raise Cancelled

    with pytest.raises(Cancelled):
        read_subtitles(clip, 0, progress=stop)


def test_a_clip_without_tracks_offers_none(tmp_path):
    path = tmp_path / "mute.mp4"
    source = ("-f", "lavfi", "-i", "color=s=64x36:d=1")
    subprocess.run(["ffmpeg", "-v", "error", *source, path], check=True)
    assert tracks_of(path) == ClipTracks()
