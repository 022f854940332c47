"""Phones are test clients and servers here, with texts as their apps' documents have them."""

import http.client
import json
import threading
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from urllib.parse import parse_qs, urlsplit

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from websockets.sync.server import serve

from hapticplayer.capture.choices import LogChoices, LogQuestion
from hapticplayer.capture.live import lsl_source, phones
from hapticplayer.capture.live.push_server import MAX_BODY_BYTES
from hapticplayer.capture.live.sensor_join import ACCEL, RATE, SensorJoin
from hapticplayer.capture.live.source import (
    ClockRestarted,
    SourceLost,
    open_source,
)
from hapticplayer.clock import SystemClock
from hapticplayer.errors import InputError, UsageError

CONFIG = json.dumps({
    "crc32": "00000000", "title": "Ride", "buffers": [{"name": "accX", "size": 0}],
    "inputs": [
        {"source": "accelerometer", "outputs": [{"x": "accX"}, {"y": "accY"}, {"z": "accZ"}, {"t": "acc_time"}]},
        {"source": "gyroscope", "outputs": [{"x": "gyrX"}, {"y": "gyrY"}, {"z": "gyrZ"}, {"t": "gyr_time"}]},
        {"source": "light", "outputs": [{"out": "lux"}]},
    ],
}).encode()  # fmt: skip
ACC_BUFFERS = {
    "acc_time": [0.01, 0.02], "accX": [0.1, 0.2], "accY": [0.0, None], "accZ": [9.8, 9.7],
}  # fmt: skip
GYR_BUFFERS = {"gyr_time": [0.0, 0.02], "gyrX": [1, 3], "gyrY": [0, 0], "gyrZ": [0, 0]}
ANSWER = json.dumps({
    "buffer": {
        name: {"size": 0, "updateMode": "partial", "buffer": values}
        for name, values in {**ACC_BUFFERS, **GYR_BUFFERS}.items()
    },
    "status": {"session": "abc", "measuring": True, "timedRun": False, "countDown": 0},
}).encode()  # fmt: skip
SERVER_MESSAGE = (
    b'{"type":"android.sensor.gyroscope","accuracy":3,"timestamp":3925657519043709,'
    b'"values":[0.31892395,-0.97802734,10.049896]}'
)


def logger_message(*entries, number=1):
    payload = [
        {"name": name, "time": ns, "values": dict(zip("xyz", xyz, strict=True))}
        for name, ns, xyz in entries
    ]
    message = {"messageId": number, "sessionId": "s", "deviceId": "d"}
    return json.dumps({**message, "payload": payload}).encode()


T0 = 1_700_000_000_000_000_000
IOS = logger_message(
    ("accelerometer", T0, (0.0, 0.0, 0.5)),
    ("gravity", T0, (0.0, 0.0, -9.8)),
    ("gyroscope", T0, (0.1, 0.2, 0.3)),
    ("barometer", T0, (1.0, 1.0, 1.0)),
)


def test_the_buffers_of_an_experiment_are_asked_for_what_is_new():
    buffers = phones.phyphox_buffers(CONFIG, "x")
    assert buffers[RATE] == ("gyr_time", "gyrX", "gyrY", "gyrZ")
    assert phones.phyphox_query(buffers, {ACCEL: 12.345678}) == (
        "/get?acc_time=12.345678&accX=12.345678%7Cacc_time&accY=12.345678%7Cacc_time"
        "&accZ=12.345678%7Cacc_time&gyr_time&gyrX&gyrY&gyrZ"
    )
    events = list(phones.phyphox_events(ANSWER, buffers, "x"))
    assert events[0] == (ACCEL, 0.01, (0.1, 0.0, 9.8))
    assert events[3] == (RATE, 0.02, (3, 0, 0))


def test_an_experiment_without_gyroscope_is_refused():
    content = CONFIG.replace(b"gyroscope", b"pressure")
    with pytest.raises(InputError, match="together; make one in phyphox"):
        phones.phyphox_buffers(content, "x")


def test_a_message_of_sensor_server_is_in_seconds_since_boot():
    sensor, stamp_s, values = phones.sensor_server_event(SERVER_MESSAGE, "x")
    assert (sensor, values) == (RATE, (0.31892395, -0.97802734, 10.049896))
    assert stamp_s == pytest.approx(3925657.519043709)


def test_sensor_logger_adds_gravity_where_it_comes_by_itself():
    reader, join = phones.SensorLoggerReader("x"), SensorJoin(with_gravity=True)
    for event in reader.events(IOS):
        join.add(*event, 5.0)
    samples = join.take()
    assert samples.accel_mps2.tolist() == [[0.0, 0.0, pytest.approx(-9.3)]]
    assert samples.rate_radps.tolist() == [[0.1, 0.2, 0.3]]
    assert samples.stamp_s.tolist() == [0.0]


def test_sensor_logger_takes_total_acceleration_alone():
    content = logger_message(
        ("totalacceleration", T0, (0, 0, 9.8)), ("accelerometer", T0, (0, 0, 0))
    )
    reader = phones.SensorLoggerReader("x")
    assert [one[2] for one in reader.events(content)] == [(0.0, 0.0, 9.8)]
    assert reader.has_total


def test_sensors_are_joined_by_their_times():
    join = SensorJoin()
    for k in (2, 0, 1, 3):  # out of order
        join.add(ACCEL, 0.01 * k, (k, 0, 9.8), 7.0 + k)
    assert not len(join.take().stamp_s)
    for stamp_s, rate in ((0.0, 0.0), (0.015, 1.5), (0.025, 2.5)):
        join.add(RATE, stamp_s, (rate, 0, 0), 8.0)
    samples = join.take()
    assert samples.stamp_s.tolist() == [0.0, 0.01, 0.02]
    assert samples.rate_radps[:, 0] == pytest.approx([0.0, 1.0, 2.0])
    assert samples.arrival_s.tolist() == [7.0, 8.0, 9.0]
    join.add(ACCEL, 1.0, (0, 0, 9.8), 20.0)  # the gyroscope has stopped
    assert np.isnan(join.take().rate_radps).all()


def test_a_rate_of_a_far_time_hides_none_of_the_others():
    join = SensorJoin()
    for k in range(30):
        join.add(RATE, 0.02 * k, (k, 0, 0), 0.02 * k)
        join.add(ACCEL, 0.02 * k - 0.01, (0, 0, 9.8), 0.02 * k)
        join.add(RATE, 1e9, (0, 0, 0), 0.02 * k) if k == 9 else None
        join.add(ACCEL, 0.02 * k + 0.005, (0, 0, 9.8), 0.02 * k)
        rate = join.take().rate_radps
    assert rate[-1, 0] == pytest.approx(28.5)


@pytest.mark.parametrize("far_s", [1e9, -1e9])
def test_an_acceleration_of_a_far_time_costs_few_samples(far_s):
    join, rates = SensorJoin(), []
    for k in range(60):
        join.add(ACCEL, far_s, (0, 0, 9.8), 0.02 * k) if k == 20 else None
        join.add(ACCEL, 0.02 * k, (0, 0, 9.8), 0.02 * k)
        rates.append(join.take().rate_radps)  # the gyroscope is later
        join.add(RATE, 0.02 * k, (k, 0, 0), 0.02 * k)
    known = np.concatenate(rates)[:, 0]
    assert np.isfinite(known).sum() > 40
    assert known[-1] == pytest.approx(58.0)


def test_a_problem_is_told_after_the_samples_before_it():
    queued = phones.Queued(SystemClock(), SensorJoin(), "x")
    events = [(sensor, 1.0, (0.0, 0.0, 9.8)) for sensor in (RATE, ACCEL)]
    queued.put(events, 1.0)
    queued.fail(SourceLost("has ended", where="x"))
    assert len(queued.read(0.0).stamp_s) == 1
    with pytest.raises(SourceLost, match="has ended"):
        queued.read(0.0)


TEXTS = (CONFIG, ANSWER, SERVER_MESSAGE, IOS)


@settings(max_examples=200, deadline=None)
@given(
    text=st.sampled_from(TEXTS),
    cut=st.integers(0, 400),
    put=st.one_of(
        st.binary(max_size=12),
        st.sampled_from(
            [b"1" * 400, b"1e999", b"null", b"[[[[", b'{"x":', b"-9e99", b'"']
        ),
    ),
)
def test_no_text_of_a_phone_brings_another_error(text, cut, put):
    content = text[:cut] + put + text[cut + len(put) :]
    join = SensorJoin(with_gravity=True)
    for read in (
        lambda: phones.phyphox_buffers(content, "x"),
        lambda: list(phones.phyphox_events(content, {ACCEL: tuple(ACC_BUFFERS)}, "x")),
        lambda: list(phones.SensorLoggerReader("x").events(content)),
        lambda: [e for e in [phones.sensor_server_event(content, "x")] if e],
    ):
        try:
            found = read()
        except InputError:
            continue
        for event in found if isinstance(found, list) else ():
            join.add(*event, 1.0)
    join.take()


@pytest.fixture(autouse=True)
def _own_settings(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))


def read_until(source, count):
    """Samples of several reads; what comes over a network comes in parts."""
    rows = [np.zeros((0, 8))]
    until_s = SystemClock.now_s() + 10.0
    while sum(map(len, rows)) < count and SystemClock.now_s() < until_s:
        one = source.read(0.2)
        parts = (
            one.arrival_s[:, None],
            one.stamp_s[:, None],
            one.accel_mps2,
            one.rate_radps,
        )
        rows.append(np.concatenate(parts, axis=1))
    return np.concatenate(rows)


@contextmanager
def phone(answers):
    """A server with an answer for each path."""

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self):
            asked.append(self.path)
            content = answers.get(urlsplit(self.path).path)
            self.send_response(404 if content is None else 200)
            self.send_header("Content-Length", str(len(content or b"")))
            self.end_headers()
            self.wfile.write(content or b"")

        def log_message(self, *_args):
            """Say nothing."""

    asked = []
    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, args=(0.05,))
    thread.start()
    try:
        yield server.server_address[1], asked
    finally:
        server.shutdown()
        thread.join()
        server.server_close()


@pytest.mark.realtime
def test_phyphox_is_started_and_asked_for_what_is_new():
    answers = {"/config": CONFIG, "/control": b'{"result":true}', "/get": ANSWER}
    clock = SystemClock()
    with phone(answers) as (port, asked):
        source = open_source(f"phyphox:http://127.0.0.1:{port}", clock)
        while len(asked) < 4:  # what was measured before is left out
            source.read(0.05)
        answers["/get"] = answered_at(1.0)
        rows = read_until(source, 1)
        assert rows[0, 1:] == pytest.approx([1.01, 0.1, 0.0, 9.8, 2.0, 0.0, 0.0])
        assert abs(rows[0, 0] - clock.now_s()) < 5.0
        assert asked[1] == "/control?cmd=start"
        assert urlsplit(asked[2]).query.startswith("acc_time&accX")
        assert parse_qs(urlsplit(asked[3]).query)["acc_time"] == ["0.02"]
    assert not len(source.read(0.1).stamp_s)  # it sleeps, and is asked again
    source.close()


def answered_at(begin_s):
    return ANSWER.replace(
        b"[0.01, 0.02]", f"[{begin_s + 0.01}, {begin_s + 0.02}]".encode()
    ).replace(b"[0.0, 0.02]", f"[{begin_s}, {begin_s + 0.02}]".encode())


@pytest.mark.realtime
def test_a_measurement_that_began_anew_is_told_and_asked_for():
    answers = {"/config": CONFIG, "/control": b"{}", "/get": answered_at(99.0)}
    with phone(answers) as (port, asked):
        source = open_source(f"phyphox:127.0.0.1:{port}", SystemClock())
        while len(asked) < 4:
            source.read(0.05)
        answers["/get"] = answered_at(100.0)
        assert read_until(source, 1)[0, 1] == pytest.approx(100.01)
        answers["/get"] = answered_at(0.0)
        with pytest.raises(ClockRestarted, match="restarted"):
            read_until(source, 1)
        source.forget_clock()
        answers["/get"] = answered_at(1.0)
        assert read_until(source, 1)[0, 1] == pytest.approx(1.01)
        assert "acc_time=0.02" in "".join(asked)
    source.close()


@pytest.mark.realtime
def test_an_answer_that_is_none_of_phyphox_ends_it():
    answers = {"/config": CONFIG, "/control": b"{}", "/get": b'{"buffer": 3}'}
    with phone(answers) as (port, _):
        source = open_source(f"phyphox:127.0.0.1:{port}", SystemClock())
        with pytest.raises(SourceLost, match="update the app"):
            read_until(source, 1)
        source.close()


def test_a_phone_that_is_not_there_is_told():
    with phone({}) as (port, _):
        pass
    with pytest.raises(InputError, match=r"does not answer .*Allow remote access"):
        open_source(f"phyphox:127.0.0.1:{port}", SystemClock())


@pytest.mark.realtime
def test_sensor_server_is_listened_to_and_opened_again():
    def talk(connection):
        paths.append(connection.request.path)
        at_ns = len(paths) * 10**9
        for k, kind in enumerate(("gyroscope", "accelerometer", "gyroscope")):
            message = {"type": f"android.sensor.{kind}", "accuracy": 3, "timestamp": at_ns + k * 10**6, "values": [k, 0, 9.8]}  # fmt: skip
            connection.send(json.dumps(message))

    paths = []
    with serve(talk, "127.0.0.1", 0) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        port = server.socket.getsockname()[1]
        source = open_source(f"sensor-server:127.0.0.1:{port}", SystemClock())
        rows = read_until(source, 2)  # the second one of another connection
        assert rows[:, 1] == pytest.approx([1.001, 2.001])
        assert rows[0, 2:] == pytest.approx([1, 0, 9.8, 1, 0, 9.8])
        source.close()
        server.shutdown()
        thread.join()
    assert parse_qs(urlsplit(paths[0]).query)["types"] == [
        '["android.sensor.accelerometer", "android.sensor.gyroscope"]'
    ]


def post(url, body, method="POST", **headers):
    parts = urlsplit(url)
    client = http.client.HTTPConnection(parts.hostname, parts.port, timeout=5)
    client.request(method, parts.path, body, headers)
    status = client.getresponse().status
    client.close()
    return status


def test_the_network_is_listened_to_only_when_that_is_allowed():
    with pytest.raises(LogQuestion, match=r"accel-sign=\+ if it reads"):
        open_source("sensor-logger:0", SystemClock())
    with pytest.raises(UsageError, match=r"whoever is in the network .*allow=yes"):
        open_source("sensor-logger:8000", SystemClock(), LogChoices(accel_sign="+"))


@pytest.fixture
def logger():
    source = open_source(
        "sensor-logger:127.0.0.1", SystemClock(), LogChoices(accel_sign="-")
    )
    yield source
    source.close()


def test_sensor_logger_posts_to_a_path_that_nobody_guesses(logger):
    url = logger.how.values["url"]
    assert len(urlsplit(url).path) > 20
    assert post(url, IOS) == 200
    rows = read_until(logger, 1)
    assert rows[0, 1:] == pytest.approx([0.0, 0.0, 0.0, 9.3, 0.1, 0.2, 0.3])


def test_sensor_logger_without_gravity_names_what_to_choose(logger, monkeypatch):
    monkeypatch.setattr(phones, "GRAVITY_S", 0.0)
    alone = logger_message(("accelerometer", T0, (0, 0, 0.1)))
    url = logger.how.values["url"]
    post(url, alone)
    assert post(url, alone) == 200
    with pytest.raises(SourceLost, match="choose Gravity beside Accelerometer"):
        read_until(logger, 1)


@pytest.mark.parametrize(
    ("status", "change"),
    [
        (403, {"path": "/guess"}),
        (413, {"headers": {"Content-Length": str(MAX_BODY_BYTES + 1)}}),
        (400, {"body": b"no message"}),
        (501, {"method": "GET"}),
        (411, {"headers": {"Content-Length": "-5"}}),
    ],
)
def test_other_requests_are_refused_and_read_nothing(logger, status, change):
    url = logger.how.values["url"]
    url = url.rpartition("/")[0] + change.get("path", urlsplit(url).path)
    body, method = change.get("body", IOS), change.get("method", "POST")
    assert post(url, body, method, **change.get("headers", {})) == status
    assert not len(logger.read(0.0).stamp_s)


def channels(*rows):
    return [dict(zip(("label", "type", "unit"), row, strict=True)) for row in rows]


ACC = [(f"Acc{axis}", "IMU", "m/s^2") for axis in "XYZ"]
GYR = [(f"Gyro{axis}", "IMU", "deg/s") for axis in "XYZ"]


def test_channels_of_a_stream_are_those_whose_labels_say_so():
    held = channels(("counter", "", ""), *ACC, *GYR)
    assert lsl_source.channel_columns(held) == {"accel": [1, 2, 3], "rate": [4, 5, 6]}
    assert lsl_source.channel_columns(held, "-,-,-,-,ax,ay,az") == {"accel": [4, 5, 6]}
    assert lsl_source.channel_unit(held, [1, 2, 3]) == "m/s2"
    assert lsl_source.channel_unit(held, [0, 1, 2]) == ""


@pytest.mark.realtime
def test_a_stream_of_lsl_has_the_clock_of_this_machine():
    pylsl = pytest.importorskip("pylsl")
    info = pylsl.StreamInfo("hp-test-imu", "IMU", 6, 100.0, pylsl.cf_float32, "hp-test")
    described = info.desc().append_child("channels")
    for label, kind, unit in ACC + GYR:
        one = described.append_child("channel")
        for key, value in (("label", label), ("type", kind), ("unit", unit)):
            one.append_child_value(key, value)
    outlet = pylsl.StreamOutlet(info)
    clock = SystemClock()
    source = open_source("lsl:hp-test-imu", clock)
    outlet.wait_for_consumers(5.0)
    sent_s = clock.now_s()
    for k in range(20):
        outlet.push_sample([0.0, 0.0, 9.8, 180.0, 0.0, 0.0], sent_s + 0.001 * k)
    rows = read_until(source, 1)
    assert rows[0, 2:] == pytest.approx([0, 0, 9.8, np.pi, 0, 0], abs=1e-5)
    assert abs(rows[0, 1] - sent_s) < 0.1
    source.close()
    del outlet
