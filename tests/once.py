"""What is made once for all processes of a run of the tests, and only read after that."""

import fcntl
import os


def made_once(tmp_path_factory, name, make):
    """Return the file or folder `name`, which `make` writes to the path that it gets."""
    root = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        root = root.parent
    folder = root / "once" / name
    folder.parent.mkdir(exist_ok=True)
    with folder.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (folder / "made").exists():
            folder.mkdir(exist_ok=True)
            make(folder / name)
            (folder / "made").touch()
    return folder / name
