import os
import re
import shutil
import subprocess
import tomllib
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import pytest

from hapticplayer import doctor
from hapticplayer.linux import DEVICE_PRIORITY, FIFO_PRIORITY, GUARD_PRIORITY

ROOT = doctor.ROOT
LOCKS = ("requirements.lock", "requirements-dev.lock")
SCRIPTS = (
    *("run", "test", ".ci/run", "tools/lock.sh"),
    *("packaging/setup.sh", "packaging/wheels.sh", "packaging/release.sh"),
    *("packaging/deb/build.sh", "packaging/deb/try.sh", "packaging/offline/build.sh"),
)
# Written so that this line does not match itself.
MACHINE_PATH = re.compile(rb"/(wor[k]|roo[t]|tm[p]/[a-z]+|hom[e]/[a-z]+)/")


def _locked(name: str) -> dict[str, str]:
    """The pinned requirements of a lock, each with its hashes."""
    text = (ROOT / "packaging" / name).read_text(encoding="utf-8")
    entries = re.split(r"\n(?=\S)", text.strip().replace("\\\n", " "))
    return dict(entry.split(None, 1) for entry in entries)


@pytest.mark.parametrize("name", LOCKS)
def test_locks_pin_each_package_by_hash_and_hold_no_address(name) -> None:
    assert "://" not in (ROOT / "packaging" / name).read_text(encoding="utf-8")
    for pin, rest in _locked(name).items():
        assert re.fullmatch(r"[a-z0-9-]+==[\w.]+", pin)
        assert re.search(r"--hash=sha256:[0-9a-f]{64}", rest), pin


def test_the_development_lock_holds_the_runtime_lock() -> None:
    runtime, development = map(_locked, LOCKS)

    assert runtime.items() <= development.items()


@pytest.mark.parametrize(
    ("lock", "extra"), [(LOCKS[0], ["study"]), (LOCKS[1], ["dev", "vision", "study"])]
)
def test_locks_hold_what_the_project_asks_for(lock, extra) -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    wanted = [*project["build-system"]["requires"], *project["project"]["dependencies"]]
    for name in extra:
        wanted += project["project"]["optional-dependencies"][name]
    names = {re.split(r"[<>=;]", each)[0].lower() for each in wanted}

    assert names <= {pin.partition("==")[0] for pin in _locked(lock)}


def test_the_list_of_system_packages_is_well_formed() -> None:
    lines = doctor.APT_LIST.read_text(encoding="utf-8").splitlines()
    rows = [line.split(None, 4) for line in lines if line and line[0] != "#"]

    assert len({row[0] for row in rows}) == len(rows)
    for name, proof, group, need, _purpose in rows:
        assert re.fullmatch(r"[a-z0-9][a-z0-9.+-]+", name)
        assert proof.partition(":")[0] in doctor.PROOFS
        assert proof.partition(":")[2]
        assert group in (*doctor.RUN_GROUPS, doctor.CHECKS_GROUP, "benchmarks")
        assert need in ("required", "optional")


def _tracked_files() -> list[Path]:
    command = ["git", "-C", str(ROOT), "ls-files", "-z"]
    if shutil.which("git"):
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        if result.stdout:
            return [ROOT / name for name in result.stdout.split("\0") if name]
    return [
        path
        for top in ROOT.iterdir()
        if top.name not in (".git", ".venv", ".hypothesis")
        and not top.name.endswith("_cache")
        for path in (top.rglob("*") if top.is_dir() else [top])
        if "__pycache__" not in path.parts
    ]


def test_no_file_names_a_path_of_one_machine() -> None:
    found = []
    for path in _tracked_files():
        content = path.read_bytes() if path.is_file() else b""
        if b"\0" not in content[:8192] and MACHINE_PATH.search(content):
            found.append(str(path.relative_to(ROOT)))

    assert found == []


@pytest.mark.parametrize("script", SCRIPTS)
def test_scripts_are_executable_and_parse(script) -> None:
    assert os.access(ROOT / script, os.X_OK)
    subprocess.run(["bash", "-n", ROOT / script], check=True)


# Stands in for Python: tells what is missing, and makes an environment of itself.
FAKE_PYTHON = """#!/bin/bash
echo "python $*" >>"$FAKE/calls"
case "$*" in
  *--missing-apt\\ *) cat "$FAKE/missing-${*: -1}" ;;
  "-m venv "*)
    mkdir -p "$3/bin"
    cp "$0" "$3/bin/python3"
    echo "#!$3/bin/python3" >"$3/bin/pip" ;;
  *"--requirement "*) [ ! -e "$FAKE/offline" ] ;;
  *"--editable "*)
    program=$(dirname "$0")/hapticplayer
    printf '#!/bin/bash\\nprintf "<%%s>" "$PWD" "$@"\\nexit 7\\n' >"$program"
    chmod +x "$program" ;;
  *doctor.py*) echo "doctor: ${*: 3}"; exit 1 ;;
esac
"""
# Stands in for apt-get: installs what it is asked for, unless it may not.
FAKE_APT = """#!/bin/bash
echo "apt-get $*" >>"$FAKE/calls"
[ "${*: -1}" = update ] && exit 0
[ ! -e "$FAKE/refuse" ] || exit 100
[ ! -e "$FAKE/conflicts" ] || [[ "$*" != *"$(cat "$FAKE/conflicts")"* ]] || exit 100
case "$*" in *ffmpeg*) : >"$FAKE/missing-checks" ;;
  *) for need in required optional; do : >"$FAKE/missing-$need"; done ;;
esac
"""
FAKE_SUDO = """#!/bin/bash
while [[ $1 == -* ]]; do shift; done
exec "$@"
"""


@dataclass
class Machine:
    """A copy of the scripts, with stand-ins for what they call."""

    tree: Path
    fake: Path

    def start(self, script: str, *arguments: str) -> subprocess.CompletedProcess[str]:
        path = f"{self.fake / 'bin'}:/usr/bin:/bin"
        return subprocess.run(
            [self.tree / script, *arguments],
            env={"PATH": path, "FAKE": str(self.fake)},
            cwd=self.fake,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
        )

    def lacks(
        self, *, required: str = "", optional: str = "", checks: str = ""
    ) -> None:
        (self.fake / "missing-required").write_text(required)
        (self.fake / "missing-optional").write_text(optional)
        (self.fake / "missing-checks").write_text(checks)

    def calls(self, word: str) -> list[str]:
        calls = self.fake / "calls"
        lines = calls.read_text().splitlines() if calls.exists() else []
        return [line for line in lines if word in line]


@pytest.fixture
def machine(tmp_path) -> Machine:
    tree, fake = tmp_path / "a tree", tmp_path / "fake"
    shutil.copytree(ROOT / "packaging", tree / "packaging")
    for name in ("run", "test", "pyproject.toml"):
        shutil.copy(ROOT / name, tree)
    (fake / "bin").mkdir(parents=True)
    stand_ins = {"python3": FAKE_PYTHON, "apt-get": FAKE_APT, "sudo": FAKE_SUDO}
    for name, text in stand_ins.items():
        (fake / "bin" / name).write_text(text)
        (fake / "bin" / name).chmod(0o755)
    machine = Machine(tree, fake)
    machine.lacks()
    return machine


def test_run_passes_on_arguments_directory_and_exit_status(machine) -> None:
    result = machine.start("run", "play", "a b", "")

    assert result.returncode == 7
    assert result.stdout == f"<{machine.fake}><play><a b><>"


def test_the_second_start_sets_nothing_up(machine) -> None:
    machine.start("run")
    (machine.fake / "calls").unlink()

    result = machine.start("run")

    assert result.stderr == ""
    assert machine.calls("") == []


def test_a_complete_machine_leaves_apt_alone(machine) -> None:
    machine.start("run")

    assert machine.calls("apt-get") == []


def test_missing_system_packages_are_installed(machine) -> None:
    machine.lacks(required="libgl1 libegl1", optional="libportaudio2")

    assert machine.start("run").returncode == 7

    update, install = machine.calls("apt-get")
    assert update.endswith("update")
    assert install.endswith(
        "install --no-install-recommends --no-remove libgl1 libegl1 libportaudio2"
    )


def test_packages_for_tests_are_installed_for_them_alone(machine) -> None:
    machine.lacks(checks="ffmpeg umockdev")

    machine.start("run")
    assert machine.calls("apt-get") == []

    machine.lacks(optional="libportaudio2", checks="ffmpeg umockdev")
    machine.start("packaging/setup.sh", "dev")
    installs = machine.calls("--no-install-recommends")
    assert installs[0].endswith(" libportaudio2")  # what tests need holds nothing up
    assert installs[1].endswith(" ffmpeg umockdev")


def test_a_package_that_would_remove_others_is_left_out(machine) -> None:
    """On a desktop with PipeWire pulseaudio would; the others come all the same."""
    machine.lacks(checks="ffmpeg pulseaudio")
    (machine.fake / "conflicts").write_text("pulseaudio")

    machine.start("packaging/setup.sh", "dev")

    installs = machine.calls("--no-remove")
    assert [line.split("--no-remove ")[1] for line in installs] == [
        "ffmpeg pulseaudio",
        "ffmpeg",
        "pulseaudio",
    ]


def test_a_missing_package_for_tests_is_a_warning(machine) -> None:
    machine.lacks(checks="ffmpeg")
    (machine.fake / "refuse").touch()

    result = machine.start("packaging/setup.sh", "dev")

    assert result.returncode == 0
    assert f"{doctor.APT_INSTALL} ffmpeg\n" in result.stderr


def test_a_required_package_that_cannot_be_had_is_named(machine) -> None:
    machine.lacks(required="libgl1", optional="libportaudio2")
    (machine.fake / "refuse").touch()

    result = machine.start("run")

    assert result.returncode == 1
    assert result.stdout == ""
    assert f"{doctor.APT_INSTALL} libgl1 libportaudio2\n" in result.stderr
    assert not (machine.tree / ".venv").exists()


def test_an_optional_package_that_cannot_be_had_is_a_warning(machine) -> None:
    machine.lacks(optional="libportaudio2")
    (machine.fake / "refuse").touch()

    result = machine.start("run")

    assert result.returncode == 7
    assert "going on without" in result.stderr
    assert f"{doctor.APT_INSTALL} libportaudio2\n" in result.stderr


def test_the_doctor_runs_when_the_set_up_fails(machine) -> None:
    machine.lacks(required="libgl1")
    (machine.fake / "refuse").touch()

    result = machine.start("run", "doctor", "--json")

    assert result.stdout == "doctor: --json\n"
    assert result.returncode == 1


def test_packages_that_cannot_be_fetched_are_fetched_next_time(machine) -> None:
    (machine.fake / "offline").touch()

    result = machine.start("run")

    assert result.returncode == 1
    assert "is the package index of pip within reach?" in result.stderr

    (machine.fake / "offline").unlink()
    assert machine.start("run").returncode == 7


def test_an_environment_of_a_killed_set_up_is_made_again(machine) -> None:
    machine.start("run")
    (machine.tree / ".venv" / "unfinished").touch()
    (machine.tree / ".venv" / "stamp-run").unlink()
    (machine.tree / ".venv" / "rest").touch()

    assert machine.start("run").returncode == 7
    assert not (machine.tree / ".venv" / "rest").exists()


def test_a_tree_that_moved_gets_a_new_environment(machine) -> None:
    machine.start("run")
    machine.tree = machine.tree.rename(machine.tree.with_name("elsewhere"))

    assert machine.start("run").returncode == 7
    assert len(machine.calls("-m venv")) == 2


def test_a_changed_lock_updates_the_environment_in_place(machine) -> None:
    machine.start("run")
    with (machine.tree / "packaging" / "requirements.lock").open("a") as lock:
        lock.write("# changed\n")

    assert machine.start("run").returncode == 7
    assert len(machine.calls("-m venv")) == 1
    assert len(machine.calls("--requirement")) == 2


def test_the_set_up_for_tests_satisfies_the_program_too(machine) -> None:
    machine.start("packaging/setup.sh", "dev")
    (machine.fake / "calls").unlink()

    assert machine.start("run").returncode == 7
    assert machine.calls("") == []


def test_set_ups_at_the_same_time_wait_for_one_another(machine) -> None:
    with ThreadPoolExecutor(4) as pool:
        results = list(pool.map(lambda _: machine.start("run"), range(4)))

    assert [each.returncode for each in results] == [7] * 4
    assert len(machine.calls("-m venv")) == 1


def test_the_group_may_have_the_priority_of_the_guard() -> None:
    limits = (ROOT / "packaging/deb/limits.conf").read_text(encoding="utf-8")
    assert f"@hapticplayer - rtprio {GUARD_PRIORITY}\n" in limits
    assert max(GUARD_PRIORITY, FIFO_PRIORITY, DEVICE_PRIORITY) == GUARD_PRIORITY
