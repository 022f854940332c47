"""Reads what a program shows to screen readers; run by the system's Python.

Prints a JSON list of {"role", "name", "label", "description"} of all that is shown now.
"""

import json
import sys

from gi.repository import Gio, GLib

ACCESSIBLE, PROPERTIES = "org.a11y.atspi.Accessible", "org.freedesktop.DBus.Properties"
ROOT = ("org.a11y.atspi.Registry", "/org/a11y/atspi/accessible/root")
SHOWING, LABELLED_BY = 25, 2  # a state, and a relation, of AT-SPI


def ask(bus, place, interface, method, arguments=None):
    """Call a method of an object and return its first value."""
    name, path = place
    what = (name, path, interface, method, arguments, None)
    return bus.call_sync(*what, Gio.DBusCallFlags.NONE, -1, None).unpack()[0]


def text(bus, place, name):
    wanted = GLib.Variant("(ss)", (ACCESSIBLE, name))
    return ask(bus, place, PROPERTIES, "Get", wanted)


def read(bus, place):
    """Yield each object that is shown below a place."""
    for child in ask(bus, place, ACCESSIBLE, "GetChildren"):
        states, _ = ask(bus, child, ACCESSIBLE, "GetState")
        if not states >> SHOWING & 1:
            continue
        relations = ask(bus, child, ACCESSIBLE, "GetRelationSet")
        labels = [
            one for kind, all_ in relations if kind == LABELLED_BY for one in all_
        ]
        yield {
            "role": ask(bus, child, ACCESSIBLE, "GetRoleName"),
            "name": text(bus, child, "Name"),
            "label": " ".join(text(bus, label, "Name") for label in labels),
            "description": text(bus, child, "Description"),
        }
        yield from read(bus, child)


def accessibility_bus():
    session = Gio.bus_get_sync(Gio.BusType.SESSION)
    place = ("org.a11y.Bus", "/org/a11y/bus")
    address = ask(session, place, "org.a11y.Bus", "GetAddress")
    flags = Gio.DBusConnectionFlags
    flags = flags.AUTHENTICATION_CLIENT | flags.MESSAGE_BUS_CONNECTION
    return Gio.DBusConnection.new_for_address_sync(address, flags, None, None)


json.dump(list(read(accessibility_bus(), ROOT)), sys.stdout)
