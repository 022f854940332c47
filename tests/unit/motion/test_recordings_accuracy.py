"""What is asked of the default method on recordings whose vertical optics measured.

`benchmarks.motion accuracy` asks the same of all methods, and of cars.
"""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from numpy.typing import NDArray

from hapticplayer.model import STANDARD_GRAVITY_MPS2
from hapticplayer.motion import analyse, remove_gravity
from tools.optical import OPTICAL, OpticalRecording, offline_vqf_up

GRAVITY_MPS2 = 9.81  # of the error figures, as the field reports them
FAMILIES = [f"{name} {rate}" for rate in ("native", "30 Hz") for name in OPTICAL]

PUBLISHED_MPS2 = [
    *(0.059, 0.099, 0.304, 0.124, 0.198),
    *(0.210, 0.103, 0.315, 0.167, 0.200),
]
# What sigma covers at the least; one of the sticks at 30 Hz shows too little.
COVERED = {"repoimu_TStick 30 Hz": 0.88}


@dataclass(frozen=True)
class Score:
    """Of one recording: the error of gravity, and what the method says of it."""

    name: str
    error_mps2: NDArray[np.float64]
    sigma_mps2: NDArray[np.float64]
    leak_mps2: float | None
    reference_mps2: float

    @property
    def rms_mps2(self) -> float:
        return float(np.sqrt(np.mean(np.square(self.error_mps2))))


def error_mps2(one: OpticalRecording, up):
    """Return the gravity error of each sample that counts."""
    apart = np.linalg.norm(up - one.up, axis=1)
    return GRAVITY_MPS2 * apart[one.counted]


@pytest.fixture(scope="module")
def scores(optical):
    """Return the scores of a family; each is computed once."""
    held = {}

    def score(one: OpticalRecording) -> Score:
        done = analyse(one.log)
        reference = error_mps2(one, offline_vqf_up(one.log))
        return Score(
            one.name,
            error_mps2(one, done.track.gravity_mps2 / STANDARD_GRAVITY_MPS2),
            done.track.gravity_sigma_mps2[one.counted],
            done.summary["leak_at_rest_mps2"],
            float(np.sqrt(np.mean(np.square(reference)))),
        )

    def of(family: str) -> list[Score]:
        if family not in held:
            held[family] = [score(one) for one in optical(family)]
        return held[family]

    return of


@pytest.mark.parametrize(
    ("family", "published_mps2"),
    list(zip(FAMILIES, PUBLISHED_MPS2, strict=True)),
)
def test_offline_vqf_comes_out_as_others_measured_it(scores, family, published_mps2):
    """Or the truth, its shift or the scoring has changed, and no limit means much."""
    error = np.mean([one.reference_mps2 for one in scores(family)])
    assert error == pytest.approx(published_mps2, rel=0.02)


@pytest.mark.parametrize(
    ("family", "limit_mps2"), [("broad native", 0.073), ("broad 30 Hz", 0.097)]
)
def test_the_gravity_error_is_below_its_limit(scores, family, limit_mps2):
    assert np.mean([one.rms_mps2 for one in scores(family)]) <= limit_mps2


@pytest.mark.parametrize(
    ("family", "limit"),
    [
        ("tumvi native", 0.65),
        ("tumvi 30 Hz", 0.65),
        ("tyrex native", 0.45),
        ("tyrex 30 Hz", 0.5),
        ("repoimu_TStick native", 1.1),
        ("repoimu_Pendulum native", 1.1),
        ("repoimu_TStick 30 Hz", 1.2),
        ("repoimu_Pendulum 30 Hz", 1.1),
    ],
)
def test_the_gravity_error_is_so_much_below_offline_vqf(scores, family, limit):
    ours = np.mean([one.rms_mps2 for one in scores(family)])
    assert ours <= limit * np.mean([one.reference_mps2 for one in scores(family)])


@pytest.mark.parametrize("family", FAMILIES)
def test_the_error_is_finite_and_sigma_says_how_large_it_is(scores, family):
    error = np.concatenate([one.error_mps2 for one in scores(family)])
    sigma = np.concatenate([one.sigma_mps2 for one in scores(family)])
    assert np.isfinite(error).all()
    assert COVERED.get(family, 0.90) <= np.mean(error <= 2.0 * sigma) <= 0.99
    assert np.median(sigma) <= 1.5 * np.sqrt(np.mean(np.square(error)))


def test_sigma_holds_for_each_recording(scores):
    shares = {
        (family, one.name): np.mean(one.error_mps2 <= 2.0 * one.sigma_mps2)
        for family in FAMILIES
        for one in scores(family)
    }
    assert {name: share for name, share in shares.items() if share < 0.6} == {}


def test_hardly_any_gravity_is_left_at_rest(scores):
    found = [one for family in FAMILIES for one in scores(family)]
    leaks = {one.name: one.leak_mps2 for one in found if one.leak_mps2 is not None}
    assert len(leaks) >= 11  # the hand-held recordings begin and end on a table
    assert {name: leak for name, leak in leaks.items() if leak > 0.05} == {}


@pytest.mark.parametrize("scale", [0.95, 1.05])
@pytest.mark.parametrize("family", ["broad", "repoimu_TStick", "repoimu_Pendulum"])
def test_a_wrong_scale_of_the_force_does_little(scores, optical, family, scale):
    """On the sticks at most a third more; offline VQF, which levels fast, loses none."""
    found = []
    for one in optical(f"{family} native"):
        force = scale * one.log.specific_force_mps2
        track = remove_gravity(replace(one.log, specific_force_mps2=force))
        error = error_mps2(one, track.gravity_mps2 / STANDARD_GRAVITY_MPS2)
        found.append(np.sqrt(np.mean(np.square(error))))
    usual = np.mean([one.rms_mps2 for one in scores(f"{family} native")])
    assert np.mean(found) < 1.35 * usual


def test_hands_that_turn_fast_are_followed_at_15_hz(optical):
    """What a slow rate loses of the rotation must not pass for a velocity."""
    (fast,) = (one for one in optical("broad 30 Hz") if one.name.startswith("broad_07"))
    log, count = fast.log, len(fast.log) // 2 * 2

    def pairs(values):
        return 0.5 * (values[:count:2] + values[1:count:2])

    half = replace(
        log,
        time_s=pairs(log.time_s),
        specific_force_mps2=pairs(log.specific_force_mps2),
        angular_rate_radps=pairs(log.angular_rate_radps),
        magnetic_field_ut=None,
    )
    apart = remove_gravity(half).gravity_mps2 - GRAVITY_MPS2 * pairs(fast.up)
    assert np.sqrt(np.nanmean(np.square(apart).sum(axis=1))) < 0.4
