"""Simulated ratings while clips play: what is made of them is what was simulated."""

import json

import numpy as np
import pytest

from hapticplayer import cli
from hapticplayer.simulation.ratings import LAG_S, LATERAL, Raters
from hapticplayer.study.analysis.describing import Resampling
from hapticplayer.study.analysis.first_order import first_order_models
from hapticplayer.study.answers import read_answers
from hapticplayer.study.creation import change_definition, create_study
from hapticplayer.study.definition import Condition
from hapticplayer.study.drafts import USUAL_CLIP_S
from hapticplayer.study.live_ratings import rating_file, read_ratings
from hapticplayer.study.study_folder import open_study
from hapticplayer.study.watched import COURSE_HZ, Course


def simulated(folder, people):
    command = ["study", "simulate", str(folder), "--participants", str(people)]
    assert cli.main([*command, "--seed", "2", "--json"]) == 0
    return open_study(folder)


def motion_n(time_s):
    """Forces of curves and brakes, which come and go within seconds."""
    periods_s = np.array([[7.0, 17.0, 5.0], [11.0, 29.0, 13.0]])
    turns = 2.0 * np.pi * time_s[:, None, None] / periods_s
    return 2.0 * np.sin(turns).sum(axis=1)


def test_the_model_finds_what_simulated_sliders_follow(tmp_path):
    study = create_study(tmp_path / "study", "incongruence")
    like = dict.fromkeys(study.definition.feedback_keys, "random")
    raters = Raters(study, like, np.random.default_rng(1), [])
    ways = {"late": 0.5, "half": 0.5, "none": 0.0}
    raters.forces = {
        ("bike", name): (lambda t, part=part: part * motion_n(t), motion_n)
        for name, part in ways.items()
    }
    people = [raters.person(100.0) for _ in range(8)]
    time_s = np.arange(0.0, USUAL_CLIP_S, 1.0 / COURSE_HZ)
    rating, courses = study.definition.while_watching[0], []
    for number, (name, part) in enumerate(ways.items(), 1):
        condition, values = Condition("bike", name), []
        for one, person in enumerate(people):
            folder = tmp_path / str(one)
            folder.mkdir(exist_ok=True)
            assert person.watch(folder, number, condition) == ()
            path = rating_file(folder, number, 1, "mismatch")
            _, media_s, value = np.loadtxt(path, delimiter=",", skiprows=1).T
            values.append(np.interp(time_s, media_s, value))
        felt_n = part * motion_n(time_s)
        of = rating, condition, time_s, np.array(values), felt_n
        courses.append(Course(*of, motion_n(time_s) - felt_n))
    found = first_order_models(courses, Resampling())["mismatch"]
    assert found["lag_s"] == pytest.approx(LAG_S, rel=0.2)
    assert found["lateral"] == pytest.approx(LATERAL, abs=0.1)
    assert found["explained"] > 0.8


def test_who_feels_sick_ends_the_clip_and_keys_are_held(tmp_path):
    made = create_study(tmp_path / "study", "sickness")
    content = json.loads(made.content)
    content["sequences"] = content["sequences"][:2]
    fms, _ = content["while_watching"]
    fms.update(every_s=10, stop_at=1)
    study = simulated(change_definition(made, content).folder, 12)
    answers = read_answers(study.folder)
    held = {
        feedback: np.mean(
            [
                one.value
                for one in answers.ratings
                if (one.factor, one.feedback) == ("moving.held_s", feedback)
            ]
        )
        for feedback in answers.feedbacks
    }
    assert held["none"] < held["realistic"]
    stopped = [one for one in answers.conduct.playbacks if one.reasons]
    assert 0 < len(stopped) < len(answers.conduct.playbacks)
    assert {one.reasons for one in stopped} == {("limit:fms",)}
    last = [
        track
        for code in study.codes()
        for track in read_ratings(study.session(code), [])
        if track.rating.key == "fms" and np.nanmax(track.value) >= 1.0
    ]
    assert len(last) == len(stopped)
    assert all(np.sum(track.value >= 1.0) == 1 for track in last)
