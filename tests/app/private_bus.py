"""A D-Bus of the test's own, with nobody on it."""

import itertools
import shutil
import subprocess

import pytest
from PySide6.QtDBus import QDBusConnection

_CONFIG = """<!DOCTYPE busconfig PUBLIC
 "-//freedesktop//DTD D-Bus Bus Configuration 1.0//EN"
 "http://www.freedesktop.org/standards/dbus/1.0/busconfig.dtd">
<busconfig><type>session</type><listen>unix:path={socket}</listen>
<policy context="default"><allow send_destination="*" eavesdrop="true"/>
<allow eavesdrop="true"/><allow own="*"/></policy>
</busconfig>
"""
_numbers = itertools.count()


@pytest.fixture
def address(bus_daemon):
    """The address of a bus that ends with the test."""
    return bus_daemon.stdout.readline().decode().strip()


@pytest.fixture
def bus_daemon(tmp_path):
    if shutil.which("dbus-daemon") is None:
        pytest.skip("dbus-daemon is not on this machine")
    config = tmp_path / "bus.conf"
    config.write_text(_CONFIG.format(socket=tmp_path / "bus.sock"))
    command = ["dbus-daemon", f"--config-file={config}", "--nofork", "--print-address"]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
    ) as daemon:
        yield daemon
        daemon.terminate()


@pytest.fixture
def bus(address, qapp):
    name = f"test-{next(_numbers)}"
    made = QDBusConnection.connectToBus(address, name)
    assert made.isConnected()
    yield made
    QDBusConnection.disconnectFromBus(name)
