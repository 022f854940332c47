"""What is left out on the way to a picture changes nothing that is shown."""

from fractions import Fraction
from hashlib import sha256
from pathlib import Path

import av
import numpy as np
import pytest
from av.video.frame import VideoFrame
from av.video.stream import VideoStream

from hapticplayer.media import video
from hapticplayer.media.packets import Lookahead
from hapticplayer.media.video import VideoDecoder, choose_threads

COUNT, RATE_HZ = 100, 25
KINDS = {
    "b-pyramid": {"bf": "3", "x264-params": "b-pyramid=normal:ref=4:keyint=40"},
    "open groups": {"bf": "3", "x264-params": "open-gop=1:keyint=25:scenecut=0"},
    "strict pyramid, 16 references": {
        "bf": "7",
        "x264-params": "b-pyramid=strict:ref=16:keyint=60:b-adapt=2:direct=temporal",
    },
    "no b frames": {"bf": "0", "x264-params": "keyint=50"},
    "interlaced": {"bf": "2", "x264-params": "tff=1:keyint=40"},
    "periodic refresh": {"bf": "0", "x264-params": "intra-refresh=1:keyint=30"},
}


def write_moving(
    path: Path, options: dict[str, str], pts: list[int], codec: str = "libx264"
) -> Path:
    """Write a clip whose pictures are made from each other."""
    rng = np.random.default_rng(5)
    field = np.kron(rng.integers(0, 256, (23, 40)), np.ones((8, 8))).astype(np.uint8)
    with av.open(str(path), "w") as container:
        stream = container.add_stream(codec, rate=RATE_HZ, options=options)
        stream.width, stream.height = 160, 96
        stream.pix_fmt = "yuv420p"
        for number, time in enumerate(pts):
            moved = np.roll(field, (number, 2 * number), (0, 1))[:96, :160]
            moved = np.ascontiguousarray(moved) // 2 + rng.integers(0, 24, (96, 160))
            gray = VideoFrame.from_ndarray(moved.astype(np.uint8), format="gray")
            frame = gray.reformat(format="yuv420p")
            frame.pts, frame.time_base = time, Fraction(1, RATE_HZ)
            container.mux(stream.encode(frame))
        container.mux(stream.encode())
    return path


def digest(frame: VideoFrame) -> str:
    return sha256(frame.to_ndarray().tobytes()).hexdigest()


def straight(path: Path) -> dict[int, str]:
    """Decode from the beginning with PyAV alone; digest of each picture by its time."""
    with av.open(str(path)) as container:
        return {
            f.pts: digest(f) for f in container.decode(video=0) if f.pts is not None
        }


@pytest.mark.parametrize(
    ("suffix", "threads"), [("mp4", "NONE"), ("mkv", "NONE"), ("mp4", "FRAME")]
)
@pytest.mark.parametrize("kind", [*KINDS])
def test_picture_after_a_seek_is_the_same_to_the_bit(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    kind: str,
    suffix: str,
    threads: str,
) -> None:
    def choose(_container: object, stream: VideoStream) -> None:
        stream.thread_type = threads
        stream.codec_context.thread_count = 3 if threads == "FRAME" else 1

    monkeypatch.setattr(video, "choose_threads", choose)
    path = tmp_path / f"clip.{suffix}"
    write_moving(path, KINDS[kind], list(range(COUNT)))
    whole = straight(path)
    assert len(whole) == COUNT
    times = sorted(whole)
    with VideoDecoder(path) as decoder:
        first = decoder.next_frame()
        assert first is not None
        assert first.native.time_base is not None
        base_s = float(first.native.time_base)
        for number in np.random.default_rng(2).permutation(COUNT)[:15].tolist():
            decoder.seek(
                (times[number] - times[0] + 0.4 * (times[1] - times[0])) * base_s
            )
            for wanted in times[number : number + 4]:
                frame = decoder.next_frame()
                assert frame is not None
                assert frame.native.pts == wanted
                assert digest(frame.native) == whole[wanted]
        assert decoder.damaged == 0


@pytest.mark.parametrize("suffix", ["mp4", "mkv"])
def test_half_of_a_group_with_b_frames_is_not_decoded(
    tmp_path: Path, suffix: str
) -> None:
    """Matroska stores no decoding times: FFmpeg knows them from the third packet on."""
    path = write_moving(
        tmp_path / f"clip.{suffix}",
        {"bf": "3", "x264-params": "keyint=100:scenecut=0:b-adapt=0:b-pyramid=none"},
        list(range(COUNT)),
    )
    with VideoDecoder(path) as decoder:
        came = []
        decoder._land(3.9, 3.9)
        while (frame := decoder.next_frame()) is not None:
            came.append(frame.pts_s)
    # I and P every fourth picture, from the key frame to the last before 3.9 s
    assert len(came) <= 2 + 97 // 4 + 2


def test_uneven_times_and_ends_are_reached(tmp_path: Path) -> None:
    pts = [0, 1, 2, 30, 31, 60, 61, 62, 63, 95]
    path = write_moving(tmp_path / "clip.mp4", KINDS["b-pyramid"], pts)
    whole = straight(path)
    with VideoDecoder(path) as decoder:
        for at, number in [
            (0, 0),
            (29, 2),
            (30, 3),
            (59, 4),
            (94, 8),
            (95, 9),
            (999, 9),
        ]:
            decoder.seek((at + 0.1) / RATE_HZ)
            frame = decoder.next_frame()
            assert frame is not None
            assert frame.pts_s == pytest.approx(pts[number] / RATE_HZ, abs=1e-3)
            assert digest(frame.native) == whole[sorted(whole)[number]]


class Packet:
    """As much of a packet as is looked at."""

    is_discard = False

    def __init__(self, pts: int | None, dts: int | None, size: int = 10) -> None:
        self.pts, self.dts, self.size = pts, dts, size


@pytest.mark.parametrize(
    "times",
    [
        [(0, 0), (None, 1), (2, 2), (9, 9)],
        [(0, 0), (1, None), (2, 2), (9, 9)],
        [(0, 0), (1, 3), (2, 4), (9, 9)],
        [(0, 0), (5, 1), (2, 1), (9, 9)],
    ],
)
def test_times_that_allow_no_conclusion_leave_nothing_out(
    times: list[tuple[int | None, int | None]],
) -> None:
    approach = Lookahead(is_marked=True)
    approach.read(iter([Packet(*time) for time in times]), 5)  # type: ignore[arg-type]
    assert approach.wanted is None
    assert not any(approach.is_skipped(pts) for pts in range(10))
    assert approach.pop() is not None


def test_the_two_newest_pictures_before_a_position_are_decoded() -> None:
    packets = [Packet(0, -2), Packet(40, -1), Packet(20, 0), Packet(10, 10)]
    packets += [Packet(30, 20), Packet(80, 40), Packet(60, 50)]
    approach = Lookahead(is_marked=True)
    approach.read(iter(packets), 35)  # type: ignore[arg-type]
    assert approach.wanted == 30
    assert [p for p in (0, 10, 20, 30, 40) if approach.is_skipped(p)] == [0, 10]
    unmarked = Lookahead(is_marked=False)
    unmarked.read(iter(packets), 35)  # type: ignore[arg-type]
    assert unmarked.wanted == 30
    assert not unmarked.is_skipped(0)


@pytest.mark.parametrize(
    ("codec", "bit_rate", "threads"),
    [("h264", 3_500_000, 1), ("h264", 60_000_000, 0), ("h264", 0, 0), ("hevc", 9, 0)],
)
def test_easy_clips_are_decoded_by_one_thread(
    codec: str, bit_rate: int, threads: int
) -> None:
    class Context:
        name = codec
        thread_count = 0

    class Stream:
        average_rate = guessed_rate = 30
        width, height = 1280, 720
        thread_type = ""
        codec_context = Context()

    stream, container = Stream(), Stream()
    stream.bit_rate = container.bit_rate = bit_rate  # type: ignore[attr-defined]
    choose_threads(container, stream)  # type: ignore[arg-type]
    assert stream.codec_context.thread_count == threads
    assert stream.thread_type == ("NONE" if threads else "AUTO")
