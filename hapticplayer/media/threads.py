"""How many threads decode a clip.

Frame threads share a picture between two cores' caches: one thread takes 12 % less CPU
(720p30 and 1080p60, H.264). So there are more only where one might not keep up.
"""

from av.container import InputContainer
from av.video.stream import VideoStream

# H.264 on one core of a 2 GHz server, fitted to 720p30 with 3.5 and 20 Mbit/s and
# 1080p60 with 9 Mbit/s, within 2 % of a core
_PERCENT_PER_MPIXEL_PER_S = 0.1
_PERCENT_PER_MBIT_PER_S = 1.0
_EASY_PERCENT = 30.0
"""A machine of a third of that speed still keeps up."""

_CODEC = "h264"


def choose_threads(container: InputContainer, stream: VideoStream) -> None:
    """Set up the decoder; call it before anything is decoded."""
    is_easy = 0.0 < _percent(container, stream) < _EASY_PERCENT
    stream.thread_type = "NONE" if is_easy else "AUTO"
    if is_easy:
        stream.codec_context.thread_count = 1


def _percent(container: InputContainer, stream: VideoStream) -> float:
    """Return what decoding takes of a core, in percent; 0 where that is unknown."""
    rate = stream.average_rate or stream.guessed_rate
    bit_rate = stream.bit_rate or container.bit_rate
    if stream.codec_context.name != _CODEC or not rate or not bit_rate:
        return 0.0
    mpixels_per_s = 1e-6 * stream.width * stream.height * float(rate)
    return (
        _PERCENT_PER_MPIXEL_PER_S * mpixels_per_s
        + _PERCENT_PER_MBIT_PER_S * 1e-6 * bit_rate
    )
