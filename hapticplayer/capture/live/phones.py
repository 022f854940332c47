"""Phones in the network: phyphox is asked, SensorServer is listened to, Sensor Logger posts.

Sources: phyphox-android cb5f8d8 (RemoteServer.java), umer0586/SensorServer f68c375,
tszheichoi/awesome-sensor-logger b10f5c5.
"""

import contextlib
import http.client
import json
import math
import queue
import threading
from collections.abc import Iterable, Iterator
from typing import Annotated, Any
from urllib.parse import quote, urlsplit

from msgspec import Meta, Struct

from hapticplayer.capture.live.push_server import (
    ALL_ADDRESSES,
    LOOPBACK,
    MAX_BODY_BYTES,
    PushServer,
)
from hapticplayer.capture.live.sensor_join import ACCEL, GRAVITY, RATE, SensorJoin
from hapticplayer.capture.live.source import (
    LiveSource,
    Samples,
    SourceLost,
    SourceOptions,
)
from hapticplayer.clock import Clock
from hapticplayer.devices.options import PORT, host_and_port
from hapticplayer.devices.websocket import Connection
from hapticplayer.errors import DeviceError, HapticPlayerError, InputError, Message
from hapticplayer.model.ranges import finite_number
from hapticplayer.structures import decode

NANO = 1e-9
Event = tuple[str, float, tuple[float, ...]]
"""Sensor, stamp in s, values."""

_Nanoseconds = Annotated[int, Meta(ge=-(1 << 62), le=1 << 62)]
_POLL_S, _POLL_TIMEOUT_S = 0.05, 1.0
_AGAIN_S, _CLOSING_S = 1.0, 2.0
GRAVITY_S = 2.0
"""Within which Sensor Logger has sent each of its sensors."""
_MOST_BYTES, _MOST_WAITING = 8 << 20, 1000
_UPDATE = Message("update the app, or choose another source")


class Queued:
    """What threads hand over, for the one who reads.

    Args:
        clock: of the arrivals.
        join: of the sensors.
        where: for people.
    """

    def __init__(self, clock: Clock, join: SensorJoin, where: str) -> None:
        self._clock, self.join, self.where = clock, join, where
        self._waiting: queue.Queue[tuple[float, list[Event]]] = queue.Queue(
            _MOST_WAITING
        )
        self._problem: HapticPlayerError | None = None

    def put(self, events: Iterable[Event], arrival_s: float) -> None:
        """Hand over what has arrived; what nobody reads for long is dropped."""
        self._hand((arrival_s, list(events)))

    def fail(self, problem: HapticPlayerError) -> None:
        """End it with an error, once all has been read."""
        self._problem = problem
        self._hand((self._clock.now_s(), []))

    def _hand(self, read: tuple[float, list[Event]]) -> None:
        with contextlib.suppress(queue.Full):  # nobody reads: waiting would end nothing
            self._waiting.put_nowait(read)

    def read(self, timeout_s: float) -> Samples:
        with contextlib.suppress(queue.Empty):
            arrival_s, events = self._waiting.get(timeout=max(0.0, timeout_s))
            while True:
                for sensor, stamp_s, values in events:
                    self.join.add(sensor, stamp_s, values, arrival_s)
                arrival_s, events = self._waiting.get_nowait()
        samples = self.join.take()
        if self._problem is not None and not len(samples.stamp_s):
            raise self._problem
        return samples


# --- phyphox -----------------------------------------------------------------------


class _PhyphoxInput(Struct):
    source: str
    outputs: list[dict[str, str]]


class _PhyphoxConfig(Struct):
    inputs: list[_PhyphoxInput]


class _PhyphoxBuffer(Struct):
    buffer: list[float | None]


class _PhyphoxAnswer(Struct):
    buffer: dict[str, _PhyphoxBuffer]


PHYPHOX_SENSORS = {"accelerometer": ACCEL, "gyroscope": RATE}
Buffers = dict[str, tuple[str, str, str, str]]
"""Names of the buffers with time, x, y and z of each sensor."""


def phyphox_buffers(content: bytes, where: str) -> Buffers:
    """The buffers that an experiment fills; raises InputError without both sensors."""
    found: Buffers = {}
    for one in decode(content, _PhyphoxConfig, where, SourceLost, _UPDATE).inputs:
        named = {key: name for part in one.outputs for key, name in part.items()}
        sensor = PHYPHOX_SENSORS.get(one.source, "")
        if sensor and {"t", "x", "y", "z"} <= named.keys():
            found[sensor] = (named["t"], named["x"], named["y"], named["z"])
    if set(found) != {ACCEL, RATE}:
        raise InputError(
            "its experiment does not record accelerometer and gyroscope together",
            where=where,
            remedy="make one in phyphox: +, Add simple experiment, Accelerometer and "
            "Gyroscope, sensor rate 0 (fastest), then Allow remote access",
        )
    return found


def phyphox_query(buffers: Buffers, after_s: dict[str, float]) -> str:
    """The request for what is newer than the last of each sensor.

    Without a last one only for that: the whole of an hour would be too large.
    """
    parts: list[str] = []
    for sensor, names in buffers.items():
        if sensor not in after_s:
            parts += map(quote, names)
            continue
        since, (time, *axes) = f"{after_s[sensor]:.9g}", names
        parts.append(f"{quote(time)}={since}")
        parts += [f"{quote(axis)}={quote(f'{since}|{time}')}" for axis in axes]
    return f"/get?{'&'.join(parts)}"


def phyphox_events(content: bytes, buffers: Buffers, where: str) -> Iterator[Event]:
    """The samples in an answer."""
    held = decode(content, _PhyphoxAnswer, where, SourceLost, _UPDATE, _MOST_BYTES)
    for sensor, names in buffers.items():
        columns = [held.buffer[name].buffer for name in names if name in held.buffer]
        if len(columns) == len(names):
            for row in zip(*columns, strict=False):
                stamp_s, *values = (float("nan") if one is None else one for one in row)
                yield sensor, stamp_s, tuple(values)


class PhyphoxSource:
    """Asks the app for what is new, twenty times a second."""

    how = Message("The measurement in phyphox is started from here.")

    def __init__(self, host: str, port: int, clock: Clock, where: str) -> None:
        self._clock, self._where = clock, where
        self._client = http.client.HTTPConnection(host, port, timeout=_POLL_TIMEOUT_S)
        try:
            self._buffers = phyphox_buffers(self._get("/config"), where)
            self._get("/control?cmd=start")
        except (OSError, http.client.HTTPException) as problem:
            raise InputError(
                "does not answer ({reason})",
                where=where,
                remedy="open an experiment in phyphox, and Allow remote access in its menu",
                reason=problem,
            ) from problem
        self._queued = Queued(clock, SensorJoin(), where)
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._poll, daemon=True)
        self._thread.start()
        self.read = self._queued.read

    def _get(self, path: str) -> bytes:
        try:
            self._client.request("GET", path)
            answer = self._client.getresponse()
            content = answer.read(_MOST_BYTES + 1)
        except BaseException:
            self._client.close()
            raise
        if answer.status != http.client.OK:
            self._client.close()
            raise http.client.HTTPException(f"{answer.status} {answer.reason}")
        return content

    def _poll(self) -> None:
        """Ask until it is closed; a phone that sleeps is asked again and again."""
        after_s: dict[str, float] = {}
        try:
            while not self._stop.wait(_POLL_S):
                is_first = not after_s
                try:
                    content = self._get(phyphox_query(self._buffers, after_s))
                except (OSError, http.client.HTTPException):
                    continue
                now_s = self._clock.now_s()
                events = list(phyphox_events(content, self._buffers, self._where))
                # the last ones, not the largest: a new measurement begins at 0
                after_s |= {
                    sensor: stamp_s
                    for sensor, stamp_s, _ in events
                    if math.isfinite(stamp_s)
                }
                if not is_first:  # which holds what was measured before
                    self._queued.put(events, now_s)
        except HapticPlayerError as problem:
            self._queued.fail(problem)

    def close(self) -> None:
        self._stop.set()
        self._thread.join(_CLOSING_S)  # one who answers byte by byte is not waited for
        self._client.close()


def open_phyphox(options: SourceOptions, clock: Clock) -> LiveSource:
    """See `PhyphoxSource`."""
    host, port = _host_and_port(options, 8080)
    return PhyphoxSource(host, port, clock, f"{options.source}:{options.text}")


def _host_and_port(options: SourceOptions, usual: int) -> tuple[str, int]:
    """Of a URL, or of HOST or HOST:PORT."""
    place = options.place(f"192.168.1.20:{usual}")
    options.fields({})
    try:
        parts = urlsplit(place if "//" in place else f"//{place}")
        host, port = parts.hostname, parts.port or usual
    except ValueError:
        host, port = None, usual
    if not host:
        raise InputError(
            "is not an address",
            where=place,
            remedy="give the one that the app shows, such as 192.168.1.20:8080",
        )
    return host, port


# --- SensorServer ------------------------------------------------------------------


class _ServerMessage(Struct):
    type: str
    timestamp: _Nanoseconds
    values: list[float]


SENSOR_SERVER_SENSORS = {
    "android.sensor.accelerometer": ACCEL,
    "android.sensor.gyroscope": RATE,
}


def sensor_server_event(content: bytes, where: str) -> Event | None:
    """The sample in a message; None of another sensor."""
    held = decode(content, _ServerMessage, where, SourceLost, _UPDATE, 4096)
    sensor = SENSOR_SERVER_SENSORS.get(held.type)
    if sensor is None or len(held.values) < 3:
        return None
    return sensor, held.timestamp * NANO, tuple(held.values[:3])


class SensorServerSource:
    """Listens to the app's WebSocket; where it is closed, it is opened again."""

    def __init__(self, host: str, port: int, clock: Clock, where: str) -> None:
        self._clock, self._where, self._join = clock, where, SensorJoin()
        kinds = quote(json.dumps(list(SENSOR_SERVER_SENSORS)))
        self._url = f"ws://{host}:{port}/sensors/connect?types={kinds}"
        self._again_s = 0.0
        try:
            self._connection: Connection | None = self._opened()
        except DeviceError as problem:
            raise InputError("{reason}", where=where, reason=problem) from problem

    def _opened(self) -> Connection:
        return Connection(self._url, "SensorServer")

    def read(self, timeout_s: float) -> Samples:
        try:
            self._listen(max(0.0, timeout_s))
        except DeviceError:
            self.close()
            self._again_s = self._clock.now_s() + _AGAIN_S
        return self._join.take()

    def _listen(self, timeout_s: float) -> None:
        if self._connection is None:
            self._clock.sleep_until(min(self._clock.now_s() + timeout_s, self._again_s))
            if self._clock.now_s() < self._again_s:
                return
            self._connection = self._opened()
        for number in range(_MOST_WAITING):  # who sends without end is not heard so
            text = self._connection.receive(0.0 if number else timeout_s)
            if not text:
                return
            arrival_s = self._clock.now_s()
            content = text.encode() if isinstance(text, str) else text
            event = sensor_server_event(content, self._where)
            if event is not None:
                self._join.add(*event, arrival_s)

    def close(self) -> None:
        if self._connection is not None:
            self._connection.close()
        self._connection = None


def open_sensor_server(options: SourceOptions, clock: Clock) -> LiveSource:
    """See `SensorServerSource`."""
    host, port = _host_and_port(options, 8080)
    return SensorServerSource(host, port, clock, f"{options.source}:{options.text}")


# --- Sensor Logger -----------------------------------------------------------------


class _LoggerEntry(Struct):
    name: str
    time: _Nanoseconds
    values: Any = None


class _LoggerMessage(Struct):
    payload: list[_LoggerEntry]


_TOTAL = "totalacceleration"
_LOGGER_SENSORS = {"accelerometer": ACCEL, "gravity": GRAVITY, "gyroscope": RATE}


class SensorLoggerReader:
    """The samples in what Sensor Logger posts.

    Android may send acceleration with gravity; else both come, and are added.
    """

    def __init__(self, where: str) -> None:
        self._where, self.has_total = where, False
        self._seen: set[str] = set()
        self._origin_ns: int | None = None

    def events(self, content: bytes) -> Iterator[Event]:
        held = decode(
            content, _LoggerMessage, self._where, InputError, _UPDATE, MAX_BODY_BYTES
        )
        names = {entry.name.lower() for entry in held.payload}
        self._seen |= names
        self.has_total = self.has_total or _TOTAL in names
        for entry in held.payload:
            name, values = entry.name.lower(), entry.values
            sensor = ACCEL if name == _TOTAL else _LOGGER_SENSORS.get(name)
            if sensor is None or (
                sensor != RATE and self.has_total != (name == _TOTAL)
            ):
                continue
            if self._origin_ns is None:
                self._origin_ns = entry.time
            axes = values if isinstance(values, dict) else {}
            read = [finite_number(axes.get(axis)) for axis in "xyz"]
            found = tuple(one for one in read if one is not None)
            if len(found) == 3:
                yield sensor, (entry.time - self._origin_ns) * NANO, found

    @property
    def lacks_gravity(self) -> bool:
        """Whether acceleration came, but never gravity."""
        return "accelerometer" in self._seen and not {"gravity", _TOTAL} & self._seen


class SensorLoggerSource:
    """Waits for what the app posts to a server that runs meanwhile."""

    def __init__(self, address: str, port: int, clock: Clock, where: str) -> None:
        self._clock, self._where, self._began_s = clock, where, math.inf
        self._reader = SensorLoggerReader(where)
        self._queued = Queued(clock, SensorJoin(with_gravity=True), where)
        self._server = PushServer(self._take, address, port)
        self.how = Message(
            "In Sensor Logger: Settings, Data Streaming, HTTP Push, Push URL {url}; then "
            "record Accelerometer, Gravity and Gyroscope.",
            url=self._server.url,
        )
        self.read = self._queued.read

    def _take(self, content: bytes) -> None:
        arrival_s = self._clock.now_s()
        events = list(
            self._reader.events(content)
        )  # what is no message ends its request
        if self._reader.has_total:
            self._queued.join.without_gravity()
        self._queued.put(events, arrival_s)
        self._began_s = min(self._began_s, arrival_s)
        if self._reader.lacks_gravity and arrival_s - self._began_s > GRAVITY_S:
            self._queued.fail(
                SourceLost(
                    "sends acceleration from which gravity was removed",
                    where=self._where,
                    remedy="choose Gravity beside Accelerometer in Sensor Logger",
                )
            )

    def close(self) -> None:
        self._server.close()


def open_sensor_logger(options: SourceOptions, clock: Clock) -> LiveSource:
    """See `SensorLoggerSource`; beyond this machine only if a person allows it."""
    place = options.place("8000")
    options.fields({})
    if place == LOOPBACK:
        host, port = place, 0  # any that is free
    elif ":" in place:
        host, port = host_and_port(place)
    else:
        host, port = ALL_ADDRESSES, int(PORT.parse("port", place))
    if host != LOOPBACK:
        options.allow(
            Message(
                "whoever is in the network and knows the URL can send to port {port} of "
                "this machine while it records.",
                port=port,
            )
        )
    where = f"{options.source}:{options.text}"
    return SensorLoggerSource(host, port, clock, where)
