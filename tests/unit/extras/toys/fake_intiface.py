"""A Buttplug server of version 4 or 3 with one toy of two motors.

As docs.buttplug.io: it answers each message by its Id, stops the toy when its client is
gone, and, where it wants pings, when one is late.
"""

import contextlib
import json
import socket
import threading

from websockets.exceptions import ConnectionClosed
from websockets.sync.server import serve

from hapticplayer.clock import SystemClock

NEW_TOY = {
    "DeviceName": "Toy",
    "DeviceIndex": 3,
    "DeviceMessageTimingGap": 0,
    "DeviceFeatures": {
        "0": {"FeatureIndex": 0, "Output": {"Vibrate": {"Value": [0, 20]}}},
        "1": {"FeatureIndex": 1, "Output": {"Rotate": {"Value": [0, 20]}}},
        "2": {"FeatureIndex": 2, "Output": {"Vibrate": {"Value": [0, 100]}}},
    },
}
OLD_TOY = {
    "DeviceName": "Toy",
    "DeviceIndex": 3,
    "DeviceMessages": {
        "StopDeviceCmd": {},
        "ScalarCmd": [
            {"StepCount": 20, "FeatureDescriptor": "", "ActuatorType": "Vibrate"},
            {"StepCount": 20, "FeatureDescriptor": "", "ActuatorType": "Rotate"},
            {"StepCount": 100, "FeatureDescriptor": "", "ActuatorType": "Vibrate"},
        ],
    },
}


class FakeIntiface:
    def __init__(self, version=4, max_ping_ms=0, toys=1, gap_ms=0, info=None):
        self.gap_ms, self.info = gap_ms, info or {}
        self.errors = 0
        self.more = {}  # devices beside the toy, by their key
        self.unanswered = ()  # names of messages
        self.late_s = {}  # by the name of the message, how late it is answered
        self.refuses = {}  # by the name of the message, code and text of the error
        self.hangs_up = self.falls_silent = False  # with the first command
        self.version, self.max_ping_ms, self.toys = version, max_ping_ms, toys
        self.strength, self.heard, self.arrived_s = {}, [], []
        self.answers, self.nonsense, self.pings = True, False, 0
        self.connections, self._clock = [], SystemClock()
        self._server = serve(self._talk, "127.0.0.1", 0, ping_interval=None)
        self.where = f"127.0.0.1:{self._server.socket.getsockname()[1]}"
        self._thread = threading.Thread(target=self._server.serve_forever, daemon=True)
        self._thread.start()

    def close(self):
        self.hang_up()
        self._server.shutdown()
        self._thread.join(10)

    def hang_up(self):
        for connection in self.connections:
            with contextlib.suppress(OSError):  # a closed one wakes nobody who reads it
                connection.socket.shutdown(socket.SHUT_RDWR)

    def babble(self, count):
        self.send("}{", count)

    def say(self, messages, count):
        self.send(json.dumps(messages), count)

    def send(self, text, count):
        for connection in self.connections:
            for _ in range(count):
                connection.send(text)

    def leave(self):
        """The toy is switched off: the server says so, and refuses its commands."""
        self.toys = 0
        number = {"Id": 0, "DeviceIndex": 3}
        removed, listed = {"DeviceRemoved": number}, {"Id": 0, "Devices": {}}
        for connection in self.connections:
            said = removed if self.version == 3 else {"DeviceList": listed}
            with contextlib.suppress(ConnectionClosed):  # that of a first greeting
                connection.send(json.dumps([said]))

    def _talk(self, connection):
        self.connections.append(connection)
        limit_s = self.max_ping_ms / 1000.0 or None
        pinged_s = self._clock.now_s()
        try:
            while True:
                left_s = limit_s and limit_s - (self._clock.now_s() - pinged_s)
                for message in json.loads(connection.recv(left_s)):
                    ((name, content),) = message.items()
                    if name == "Ping":
                        pinged_s = self._clock.now_s()
                    is_command = name in ("OutputCmd", "ScalarCmd")
                    if is_command and self.hangs_up:
                        self.hang_up()
                    self.answers &= not (is_command and self.falls_silent)
                    if self.answers:
                        answer = self._answer(name, content)
                        self._wait(self.late_s.get(name, 0.0))
                        if name not in self.unanswered:
                            connection.send(json.dumps([answer]))
        except (ConnectionClosed, OSError, TimeoutError):
            self.strength.clear()  # the client is gone, or silent
            with contextlib.suppress(OSError):
                connection.close()

    def _wait(self, late_s):
        if late_s:
            self._clock.sleep_until(self._clock.now_s() + late_s)

    def _answer(self, name, content):
        self.heard.append((name, content))
        self.arrived_s.append(self._clock.now_s())
        number = content["Id"]
        if name == "RequestServerInfo":
            return self._greeting(content, number)
        if name == "RequestDeviceList":
            return {"DeviceList": {"Id": number, "Devices": self._devices()}}
        if name in self.refuses:
            code, text = self.refuses[name]
            return {"Error": {"Id": number, "ErrorMessage": text, "ErrorCode": code}}
        if self.errors and name in ("OutputCmd", "ScalarCmd"):
            self.errors -= 1
            text = "Device 3 not available"
            return {"Error": {"Id": number, "ErrorMessage": text, "ErrorCode": 4}}
        if name == "OutputCmd":
            ((kind, value),) = content["Command"].items()
            feature = NEW_TOY["DeviceFeatures"][str(content["FeatureIndex"])]
            low, high = feature["Output"][kind]["Value"]
            assert low <= value["Value"] <= high
            self.strength[content["FeatureIndex"]] = value["Value"] / high
        elif name == "ScalarCmd":
            for scalar in content["Scalars"]:
                assert 0.0 <= scalar["Scalar"] <= 1.0
                self.strength[scalar["Index"]] = scalar["Scalar"]
        elif name in ("StopCmd", "StopAllDevices"):
            self.strength.clear()
        elif name == "Ping":
            self.pings += 1
        else:
            return {"Error": {"Id": number, "ErrorMessage": name, "ErrorCode": 3}}
        return {"Ok": {"Id": number}}

    def _greeting(self, content, number):
        value = {"Id": number, "ServerName": "fake", "MaxPingTime": self.max_ping_ms}
        value |= self.info
        if self.version == 3:
            if "MessageVersion" not in content:
                text = "missing field `MessageVersion`"
                return {"Error": {"Id": 0, "ErrorMessage": text, "ErrorCode": 3}}
            return {"ServerInfo": {"MessageVersion": 3, **value}}
        versions = {"ProtocolVersionMajor": 4, "ProtocolVersionMinor": 0}
        return {"ServerInfo": {**versions, **value}}

    def _devices(self):
        if self.version == 3:
            return [*self.more.values(), *[OLD_TOY | self._gap()][: self.toys]]
        return self.more | dict([("3", NEW_TOY | self._gap())][: self.toys])

    def _gap(self):
        return {"DeviceMessageTimingGap": self.gap_ms}
