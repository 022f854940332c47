"""What other programs on the machine are reported while somebody takes part."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from sitting import KEYS, Person

from hapticplayer.errors import StudyError
from hapticplayer.extras.research.lsl import FORCE, MARKERS, LslStreams
from hapticplayer.study.pages import PageKind
from hapticplayer.study.ticks import tick_chunks, tick_files

WAIT_S, NOW_S = 20.0, 0.5  # what has been sent may still be on its way
ANSWERS = (3, 2, 5, 1)


@pytest.fixture
def streams():
    try:
        made = LslStreams()
    except StudyError as problem:
        pytest.skip(str(problem))
    yield made
    made.close()


@pytest.fixture
def inlets(streams):
    import pylsl

    made = {}
    for name in (MARKERS, FORCE):
        found = pylsl.resolve_byprop("name", name, timeout=WAIT_S)
        if not found:
            pytest.skip("streams cannot be found on this machine's loopback")
        made[name] = pylsl.StreamInlet(found[0])
        made[name].open_stream(WAIT_S)
    yield made
    for inlet in made.values():
        inlet.close_stream()


def pulled(inlet):
    samples, times_s = [], []
    while True:
        sample, at_s = inlet.pull_sample(NOW_S if samples else WAIT_S)
        if sample is None:
            return samples, times_s
        samples.append(sample)
        times_s.append(at_s)


def test_a_trial_is_streamed_without_answers_and_codes(
    streams, inlets, make_study, sit, wait_for
):
    session = sit(make_study(), outputs=["simulated"], observer=streams)
    person = Person(session, wait_for)
    person.to_trials()
    person.trial(ANSWERS)
    person.wait_page(PageKind.READY, "trial-02")
    session.control.note.setText("Anna coughed")
    session.control.note.returnPressed.emit()
    person.key(Qt.Key.Key_Escape)
    code = session.runner.plan.code
    condition = session.runner.plan.order[0].key
    stored = session.study.session(code)
    session.close()
    texts, marked_s = pulled(inlets[MARKERS])
    reported = [text for (text,) in texts]
    assert [t for t in reported if t.startswith("trial-01")] == [
        "trial-01 page",
        f"trial-01 begin {condition}",
        f"trial-01 first frame {condition}",
        f"trial-01 end {condition}",
        "trial-01 questions",
    ]
    everything = " ".join(reported) + "".join(
        i.info().as_xml() for i in inlets.values()
    )
    for secret in (code, "Anna", "answers", "female", str(list(ANSWERS))):
        assert secret not in everything.replace(FORCE, ""), secret
    assert any(key in everything for key in KEYS)
    begin_s, end_s = (
        marked_s[reported.index(text)]
        for text in reported
        if " begin " in text or text.startswith("trial-01 end")
    )
    trial = next(r for r in stored.records.intact if r.kind == "trial").content
    assert begin_s == pytest.approx(trial["playback"]["begun_mono_s"], abs=0.05)
    assert end_s == pytest.approx(trial["playback"]["ended_mono_s"], abs=0.05)
    check_forces(inlets[FORCE], stored, begin_s, end_s)


def check_forces(inlet, stored, begin_s, end_s):
    """Every force of the trial is there once, at the time that the record has."""
    samples, times_s = pulled(inlet)
    (file,) = tick_files(stored)
    ticks = np.concatenate(list(tick_chunks(file, [])))
    ticks = ticks[(ticks["monotonic_s"] >= begin_s) & (ticks["monotonic_s"] <= end_s)]
    sent = dict(zip(times_s, samples, strict=True))
    assert len(sent) == len(times_s)
    assert len(ticks) > 100
    for tick in ticks:
        assert sent[tick["monotonic_s"]] == list(tick["force_n"])
