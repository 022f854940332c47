"""Files are written whole or not at all, and two programs take turns."""

import fcntl
import os
import signal
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import pytest

from hapticplayer import storage
from hapticplayer.clock import ManualClock
from hapticplayer.errors import InputError

WRITER = """
import os, signal, sys
from pathlib import Path
from hapticplayer import storage
step, path = sys.argv[1], Path(sys.argv[2])
def killed(*_arguments):
    os.kill(os.getpid(), signal.SIGKILL)
if step == "content":
    with storage.file_replaced(path) as part:
        part.write_bytes(b"ne")
        killed()
setattr(storage.os, "fsync", killed) if step == "fsync" else None
Path.replace = killed if step == "rename" else Path.replace
storage.replace_file(path, b"new")
"""


@pytest.mark.parametrize("step", ["content", "fsync", "rename"])
def test_a_writer_killed_at_any_step_leaves_the_old_file(tmp_path, step):
    path = tmp_path / "kept.json"
    path.write_bytes(b"old")
    done = subprocess.run([sys.executable, "-c", WRITER, step, path], check=False)
    assert done.returncode == -signal.SIGKILL
    assert path.read_bytes() == b"old"
    storage.replace_file(path, b"newest")
    assert [one.name for one in tmp_path.iterdir()] == ["kept.json"]
    assert path.read_bytes() == b"newest"


def test_private_files_are_private_whatever_the_umask(tmp_path):
    before = os.umask(0)
    try:
        storage.write_private(tmp_path / "new", b"1")
        storage.replace_file(tmp_path / "again", b"1", storage.PRIVATE_FILE)
    finally:
        os.umask(before)
    modes = [path.stat().st_mode & 0o777 for path in tmp_path.iterdir()]
    assert modes == [0o600, 0o600]


@pytest.mark.parametrize("place", ["relative/folder", ""])
def test_a_folder_that_is_not_absolute_is_ignored(monkeypatch, tmp_path, place):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("XDG_CONFIG_HOME", place)
    assert storage.config_home() == tmp_path / ".config" / "hapticplayer"


def test_a_user_without_a_cache_folder_gets_a_temporary_one(monkeypatch, tmp_path):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    assert storage.cache_root().is_dir()


def test_a_folder_that_another_program_changes_is_waited_for(tmp_path):
    other = os.open(tmp_path, os.O_RDONLY)
    fcntl.flock(other, fcntl.LOCK_EX)
    clock = ManualClock()
    with (
        pytest.raises(InputError, match="is being changed by another program; wait"),
        storage.locked(tmp_path, clock),
    ):
        pass
    assert clock.now_s() - 1000.0 >= 5.0
    os.close(other)
    with storage.locked(tmp_path, ManualClock()):
        pass


def test_a_program_that_goes_on_writing_is_waited_for(tmp_path):
    other = os.open(tmp_path, os.O_RDONLY)
    fcntl.flock(other, fcntl.LOCK_EX)

    class Busy(ManualClock):
        """While time passes, the other program writes, and ends after a minute."""

        def sleep_until(self, deadline_s: float) -> None:
            super().sleep_until(deadline_s)
            os.utime(tmp_path, ns=(0, int(1e9 * self.now_s())))
            if self.now_s() > 1060.0:
                fcntl.flock(other, fcntl.LOCK_UN)

    clock = Busy()
    with storage.locked(tmp_path, clock):
        assert clock.now_s() > 1060.0
    os.close(other)


def test_a_thread_may_lock_a_folder_again_but_no_other_may(tmp_path):
    refused = []

    def other() -> None:
        try:
            with storage.locked(tmp_path, ManualClock()):
                pass
        except InputError as problem:
            refused.append(problem)

    with storage.locked(tmp_path), storage.locked(tmp_path):
        thread = threading.Thread(target=other)
        thread.start()
        thread.join()
    assert len(refused) == 1
    other()
    assert len(refused) == 1


def test_names_that_cannot_be_are_refused_with_what_can(tmp_path):
    (tmp_path / "loop").symlink_to("loop")
    (tmp_path / "file").write_text("x")
    for place, remedy in (
        ("x" * 256, "choose a shorter name"),
        ("loop/x", "a part of this path is a file or a dead link"),
        ("file/x", "a part of this path is a file"),
    ):
        with pytest.raises(storage.StorageError, match=remedy):
            storage.replace_file(tmp_path / place, b"")


def test_folders_written_at_once_take_none_from_each_other(tmp_path):
    def write(number):
        with storage.folder_written_aside(tmp_path / f"{number}") as aside:
            (aside / "file").write_text(f"{number}", encoding="utf-8")

    with ThreadPoolExecutor(8) as pool:
        list(pool.map(write, range(150)))
    found = {int(one.parent.name): one.read_text() for one in tmp_path.glob("*/file")}
    assert found == {number: f"{number}" for number in range(150)}
