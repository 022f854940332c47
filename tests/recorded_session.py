"""A session with a record of the device whose figures have closed forms."""

from pathlib import Path

import numpy as np

from hapticplayer.haptics.contract import Mode
from hapticplayer.haptics.records import RecordWriter
from hapticplayer.haptics.shared import TICK
from hapticplayer.study.journal import Journal
from hapticplayer.study.plan import describe
from hapticplayer.study.session_folder import ANSWERS
from hapticplayer.study.study_folder import begin_session, open_study

SECONDS = 20.0
T = 1e-3 * np.arange(1, round(SECONDS * 1e3) + 1)
Y = np.array([0.0, 1.0, 0.0])
RATINGS = {"realism": 3, "sensory": 2, "comfort": 5, "satisfaction": 1}
RECORD = "ticks-01.hprec"


def sine(amplitude_n, frequency_hz, delay_s=0.0):
    return amplitude_n * np.sin(2.0 * np.pi * frequency_hz * (T - delay_s))


def ticks(planned, sent, mode=Mode.FOLLOWING, begin_s=100.0):
    """Return ticks at 1 kHz of forces along y, the grip 20 mm away once."""
    made = np.zeros(len(T), TICK)
    made["monotonic_s"], made["media_s"] = begin_s + T, T
    made["planned_n"], made["force_n"] = np.outer(planned, Y), np.outer(sent, Y)
    made["mode"] = mode
    made["position_m"][100] = [0.012, 0.0, 0.016]
    return made


def recorded_session(study, clock):
    """Answer three trials: as planned, at half strength, without a record."""
    made = begin_session(study, "en", {}, clock)
    runs = [
        ticks(sine(2.0, 1.0), share * sine(2.0, 1.0), begin_s=begin_s)
        for share, begin_s in ((1.0, 100.0), (0.5, 130.0))
    ]
    write_record(made.folder / RECORD, np.concatenate(runs))
    journal = Journal(made.folder / ANSWERS, clock)
    journal.append("begin")
    for number, begun_s in enumerate((99.5, 129.5, None), 1):
        named = {
            "step": f"trial-{number:02d}",
            "attempt": 1,
            "condition": describe(made.plan.order[number - 1]),
        }
        played = {} if begun_s is None else playback(begun_s)
        journal.append("trial", **named, is_valid=True, reasons=[], playback=played)
        journal.append("answers", **named, page="rating", values=RATINGS)
    journal.close()
    return open_study(study.folder).session(made.code)


def playback(begun_s):
    return {
        "begun_mono_s": begun_s,
        "ended_mono_s": begun_s + 21.5,
        "duration_s": SECONDS,
        "device": "simulated",
        "record": RECORD,
    }


def write_record(path: Path, made):
    with path.open("wb") as out:
        writer = RecordWriter(out.fileno())
        writer.begin({"device": "simulated"})
        for first in range(0, len(made), 1500):
            writer.append(first, 0, made[first : first + 1500])
        writer.append(len(made), 0, made[:0])
