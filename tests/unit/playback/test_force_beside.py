"""Files of force that are opened as such: the video of their name plays with them."""

import pytest

from hapticplayer.errors import InputError
from hapticplayer.playback.source import FROM_FILE, open_source
from hapticplayer.sequence.force_formats import read_force
from hapticplayer.sequence.force_import import export_force
from hapticplayer.sequence.pack import pack


@pytest.fixture
def ride(sequence_folder, tmp_path):
    """A plain video and its force beside it."""
    pack(sequence_folder, tmp_path / "ride.mp4")
    return tmp_path / "ride.mp4"


def test_a_side_car_opens_the_video_beside_it(ride):
    opened = open_source(ride.with_name("ride.haptics.mkv"))
    assert opened.path == ride
    assert opened.feedback == "realistic"


def test_a_force_file_plays_with_the_video_of_its_name(ride, sequence_folder):
    force = ride.with_suffix(".hjif")
    export_force(sequence_folder, None, force, "hjif")
    ride.with_name("another.mp4").write_bytes(ride.read_bytes())

    opened = open_source(force)

    assert (opened.path, opened.feedback) == (ride, FROM_FILE)
    read = read_force(force).track.force_n
    assert opened.tracks[FROM_FILE].force_n.tolist() == read.tolist()


@pytest.mark.parametrize("name", ["alone.haptics.mkv", "alone.hjif"])
def test_force_without_its_video_says_what_to_do(tmp_path, name):
    (tmp_path / name).touch()
    with pytest.raises(InputError, match="no video of its name lies beside it; put"):
        open_source(tmp_path / name)
