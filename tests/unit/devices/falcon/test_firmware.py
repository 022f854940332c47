"""The image's structure, where it is kept, and its upload with everything that fails."""

import hashlib
import struct
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hapticplayer.devices.falcon import firmware
from hapticplayer.devices.falcon.firmware import (
    MemoryBlock,
    build_image,
    loader,
    parse_image,
)
from hapticplayer.devices.falcon.firmware import image as image_module
from hapticplayer.errors import Cancelled, DeviceError, UsageError

QUICK = replace(firmware.RETRY_LIMITS, attempts=3)


def test_an_image_is_read_as_the_boot_rom_reads_it():
    """Written out by hand after the manual: low byte first, high word first."""
    data = struct.pack(
        "<H16x2H" "3H2H" "3H1H" "H",
        0x08AA, 0x003F, 0x8002,
        2, 0x003F, 0x8002, 0x1111, 0x2222,
        1, 0x0000, 0x93A2, 0x3333,
        0,
    )  # fmt: skip
    image = parse_image(data)
    assert image.entry == 0x3F8002
    assert image.blocks == (
        MemoryBlock(0x3F8002, (0x1111, 0x2222)),
        MemoryBlock(0x93A2, (0x3333,)),
    )
    assert image.sha256 == hashlib.sha256(data).hexdigest()
    assert image.known_name == ""
    assert build_image(image.entry, image.blocks) == data


def test_four_images_are_known():
    names = set(firmware.KNOWN_IMAGES.values())
    assert names == {
        "nvent_firmware.bin", "novint_T0.bin", "novint_T2.bin", "test_firmware.bin"
    }  # fmt: skip
    assert all(len(bytes.fromhex(digest)) == 32 for digest in firmware.KNOWN_IMAGES)


def test_every_broken_image_is_refused(image):
    data = image.data
    for length in range(len(data)):
        with pytest.raises(DeviceError, match="not valid firmware"):
            parse_image(data[:length])
    for broken, why in (
        (data + b"\x00\x00", "2 bytes follow its end"),
        (b"\xab" + data[1:], "key 08AA"),
        (build_image(0x3F8002, ()), "nothing in it"),
        (build_image(0x100, image.blocks), "entry point 000100"),
        (build_image(0x3FFFFF, (MemoryBlock(0x3FFFFF, (1, 2)),)), "fits nowhere"),
        (build_image(0, (MemoryBlock(0, (1,) * 30_000),)), "fits nowhere"),
        (b"\x00" * (2 << 20), "too many"),
    ):
        with pytest.raises(DeviceError, match=why):
            parse_image(broken)


@given(st.binary(max_size=300))
def test_random_files_are_refused_and_never_crash(data):
    with pytest.raises(DeviceError, match="not valid firmware"):
        parse_image(struct.pack("<H", 0x08AA) + data)


@pytest.fixture
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    monkeypatch.delenv(firmware.OVERRIDE, raising=False)
    return tmp_path


@pytest.fixture
def file(home, image):
    path = home / "image.bin"
    path.write_bytes(image.data)
    return path


def test_without_a_firmware_the_user_is_told_where_to_get_it(home):
    with pytest.raises(DeviceError, match="upload-firmware FILE"):
        firmware.find_image()


def test_a_known_image_is_kept_in_the_users_folder(home, file, image, monkeypatch):
    monkeypatch.setitem(image_module.KNOWN_IMAGES, image.sha256, "ours.bin")
    assert firmware.install_image(file).known_name == "ours.bin"
    kept = home / "data" / "hapticplayer" / "falcon-firmware.bin"
    assert firmware.kept_path() == kept
    assert kept.read_bytes() == image.data
    assert list(kept.parent.iterdir()) == [kept]
    assert firmware.find_image() == image


def test_an_unknown_image_needs_a_decision(file, image):
    with pytest.raises(UsageError, match=image.sha256[:16]):
        firmware.install_image(file)
    assert not firmware.kept_path().exists()
    firmware.install_image(file, accept_unknown=True)
    assert firmware.find_image() == image


def test_a_wrong_file_never_replaces_a_kept_one(file, image):
    firmware.install_image(file, accept_unknown=True)
    file.write_bytes(b"%PDF-1.4 something else")
    with pytest.raises(DeviceError, match=r"image\.bin: not valid firmware"):
        firmware.install_image(file, accept_unknown=True)
    with pytest.raises(DeviceError, match="no such file"):
        firmware.install_image(file.with_name("missing.bin"))
    assert firmware.find_image() == image


def test_the_environment_overrides_where_it_is_kept(home, file, monkeypatch, image):
    monkeypatch.setenv(firmware.OVERRIDE, str(file))
    assert firmware.kept_path() == file
    assert firmware.find_image() == image
    monkeypatch.setenv(firmware.OVERRIDE, str(file / "below-a-file"))
    file_again = home / "again.bin"
    file_again.write_bytes(image.data)
    with pytest.raises(DeviceError, match=firmware.OVERRIDE):
        firmware.install_image(file_again, accept_unknown=True)


def test_a_copy_that_fails_leaves_nothing_behind(file):
    kept = firmware.kept_path()
    kept.mkdir(parents=True)
    with pytest.raises(DeviceError, match="cannot be written"):
        firmware.install_image(file, accept_unknown=True)
    assert list(kept.parent.iterdir()) == [kept]


def test_a_relative_data_folder_is_ignored(home, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", "here")
    monkeypatch.setenv("HOME", str(home))
    expected = home / ".local" / "share" / "hapticplayer" / "falcon-firmware.bin"
    assert firmware.kept_path() == expected


def test_the_licence_note_says_whose_it_is():
    for word in ("Novint", "noncommercial", "not part of this", "LICENSE_NOVINT.txt"):
        assert word in firmware.LICENCE_NOTE


def start(bench, retry=QUICK, progress=None):
    return firmware.open_running(
        bench.open, lambda: bench.image, bench.clock, retry, progress
    )


def test_an_upload_starts_the_firmware(bench, image):
    from hapticplayer.extras.faults.usb.board import Stage

    seen = []
    began_s = bench.clock.now_s()
    ftdi = start(bench, progress=seen.append)
    assert bench.board.stage is Stage.RUNNING
    assert bench.board.image == image.data
    assert bench.openings == 1
    assert seen == sorted(seen)
    assert seen[-1] == 1.0
    # a line of 142857 baud, each byte there and back, 16 ms latency at each block
    assert bench.clock.now_s() - began_s < 1.0
    ftdi.close()


def test_the_requests_come_in_the_order_of_the_reference(bench):
    start(bench).close()
    boot = [
        (6, 0, 0), (0, 1, 0), (0, 2, 0), (9, 16, 0), (3, 0x4138, 0), (4, 8, 0), (2, 0, 0),
        (1, 0x200, 0), (1, 0x100, 0), (1, 0x101, 0),
        (1, 0x100, 0), (3, 0x15, 0),
        (9, 1, 0), (3, 2, 0),
    ]  # fmt: skip
    requests = bench.chip.requests
    first = requests.index((9, 16, 0)) - 3
    assert requests[first : first + len(boot)] == boot


def test_a_firmware_that_runs_is_not_loaded_again(running):
    def never():
        raise AssertionError("the image was asked for")

    ftdi = firmware.open_running(running.open, never, running.clock)
    assert running.chip.requests.count((9, 16, 0)) == 0
    assert {words for _, words in running.mechanics.commands} == {(0, 0, 0)}
    ftdi.close()


def test_a_missing_image_is_said_at_once_and_the_device_let_go(bench):
    def missing():
        raise DeviceError("the Falcon's firmware is missing")

    with pytest.raises(DeviceError, match="missing"):
        firmware.open_running(bench.open, missing, bench.clock)
    assert bench.openings == 1
    assert not bench.port.is_claimed


@pytest.mark.parametrize("hello", [b"\x0aD,\x0d", b"\x00\x0aD,\x0d"])
@pytest.mark.parametrize("most_payload", [62, 3, 2, 1])
def test_both_hellos_are_understood_however_they_are_split(bench, hello, most_payload):
    bench.faults.hello = hello
    bench.chip.most_payload = most_payload
    start(bench).close()
    assert bench.openings == 1


@pytest.mark.parametrize("after_s", [0.0, 0.005, 0.06, None])
def test_a_loader_that_raises_cts_late_or_never_is_served(bench, after_s):
    bench.faults.clear_to_send_s = after_s
    start(bench).close()
    assert bench.openings == 1


def test_old_bytes_do_not_disturb_the_hello(bench):
    from hapticplayer.extras.faults.usb.board import Stage

    ftdi = bench.ftdi()
    bench.chip.send_back(b"<AAAAAAAAAAAAAA>" * 3, bench.clock.now_s())
    firmware.upload(ftdi, bench.image, bench.clock)
    assert bench.board.stage is Stage.RUNNING
    ftdi.close()


@pytest.mark.parametrize("place", [-1, 0, 61, 62, 500])
def test_a_wrong_echo_is_seen_and_the_next_attempt_succeeds(bench, place):
    from hapticplayer.extras.faults.usb.board import Stage

    bench.faults.wrong_echo_at = place
    with pytest.raises(firmware.UploadError, match=r"wrong|does not answer"):
        firmware.upload(bench.ftdi(), bench.image, bench.clock)
    bench.port.is_claimed = False
    bench.board.stage = Stage.DARK
    bench.faults.wrong_echo_at = place
    start(bench).close()
    assert bench.openings == 3
    assert bench.board.stage is Stage.RUNNING


@pytest.mark.parametrize("place", [-1, 0, 30, 62, 700])
def test_an_echo_that_ends_is_seen_and_the_next_attempt_succeeds(bench, place):
    bench.faults.echo_ends_at = place
    start(bench).close()
    assert bench.openings == 2


def test_no_hello_gives_up_with_what_to_do(bench):
    bench.faults.hello = b""
    with pytest.raises(DeviceError, match=r"in 3 attempts .*boot processor.*unplug"):
        start(bench)
    assert bench.openings == 3
    assert not bench.port.is_claimed


def test_an_image_that_does_not_run_is_said(bench):
    bench.board.accepts_any = False
    with pytest.raises(DeviceError, match="was loaded and does not answer"):
        start(bench)


@pytest.mark.parametrize("after_s", [0.0, 0.05, 0.1, 0.15, 0.2])
def test_unplugging_at_any_moment_of_an_upload_is_said(bench, after_s):
    from hapticplayer.extras.faults.usb.board import Stage

    class Impatient(type(bench.clock)):
        def sleep_until(self, deadline_s):
            super().sleep_until(deadline_s)
            if self.now_s() > 1000.0 + after_s:
                bench.chip.unplug()

    bench.clock.__class__ = Impatient
    with pytest.raises(DeviceError, match="plugged"):
        start(bench)
    assert bench.board.stage is not Stage.RUNNING


def test_replugging_during_the_attempts_goes_on_with_the_new_one(bench):
    bench.faults.echo_ends_at = 100
    opened = bench.open

    def open_again():
        if bench.openings == 1:
            bench.openings += 1
            raise DeviceError("no Falcon is plugged in")
        return opened()

    ftdi = firmware.open_running(open_again, lambda: bench.image, bench.clock)
    assert bench.openings == 3
    ftdi.close()


def test_an_upload_can_be_cancelled(bench):
    def stop(_part):
        raise Cancelled

    with pytest.raises(Cancelled):
        start(bench, progress=stop)
    assert not bench.port.is_claimed


def test_a_stalled_device_takes_no_block_and_is_tried_again(bench):
    state = {"left": 1}

    def stall(part):
        if part > 0.5 and state["left"]:
            state["left"] -= 1
            bench.chip.stalled_until_s = bench.clock.now_s() + 1.0

    start(bench, progress=stall).close()
    assert bench.openings == 2


def test_the_probe_hears_an_answer_that_is_split_and_late(running):
    running.chip.most_payload = 5
    running.faults.silent = 3
    ftdi = running.ftdi()
    assert loader.is_running(ftdi, running.clock)
    ftdi.close()
