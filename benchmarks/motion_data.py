"""The recordings of `motion.py` by family: each figure is the mean over one of them."""

from collections.abc import Iterable
from dataclasses import dataclass, field

from recordings import (
    DATA,
    HOLE,
    TruthRecording,
    load_comma,
    load_orientation,
    load_simulated,
)

from hapticplayer.model import Sampling
from hapticplayer.simulation.rides.motion_scenes import MOTION_SCENES

ORIENTATION, COMMA = DATA / "orientation", DATA / "capture" / "comma2k19"
OPTICAL = ("broad", "tumvi", "tyrex")
# a family of simulated rides and how the names of its scenes begin
_DRIVEN, _CARRIED = "sim-car", "sim-people"
_CAMERA, _BOARD = "camera", "paper-board"
FAMILIES = (*OPTICAL, "car", _DRIVEN, _CARRIED)
TITLES = {
    "broad": "hand-held (BROAD)",
    "tumvi": "camera rig (TUM-VI)",
    "tyrex": "phone on people (tyrex)",
    "car": "phone in a car (comma2k19)",
    _DRIVEN: "simulated car rides",
    _CARRIED: "simulated people, bikes",
}
NATIVE, AVERAGED = "native", "30 Hz"
QUICK_NAMES = (
    "broad_15_undisturbed_fast_translation_A",
    "tumvi_room4",
    "tyrex_Guillaume_Nexus5_NoDist_Swinging",
    "comma2k19",
)
QUICK_SCENES = ("car-brisk", "handheld-brisk")


@dataclass(frozen=True, slots=True, eq=False)
class Family:
    """Recordings of one kind at one rate.

    Attributes:
        name: one of FAMILIES.
        rate: NATIVE or AVERAGED.
        recordings: that figures are means over.
        apart: shown beside them, but in no mean.
    """

    name: str
    rate: str
    recordings: list[TruthRecording] = field(default_factory=list)
    apart: list[TruthRecording] = field(default_factory=list)

    @property
    def key(self) -> str:
        """Name and rate."""
        return f"{self.name} {self.rate}"

    @property
    def title(self) -> str:
        """For people."""
        return f"{TITLES[self.name]}, {self.rate}"

    @property
    def samples(self) -> int:
        """Samples of the recordings."""
        return sum(len(recording.imu) for recording in self.recordings)


def missing_data(wanted: Iterable[str]) -> list[str]:
    """Return the folders that are needed and not there."""
    folders = [ORIENTATION] if set(wanted) & set(OPTICAL) else []
    folders += [COMMA] if "car" in wanted else []
    return [str(folder) for folder in folders if not folder.is_dir()]


def load_families(
    wanted: Iterable[str], seeds: int, *, quick: bool = False
) -> list[Family]:
    """Return the wanted families, native ones first.

    Args:
        wanted: of FAMILIES.
        seeds: simulated rides of each scene.
        quick: only the recordings and scenes named above.
    """
    families: dict[tuple[str, str], Family] = {}
    for recording in _recordings(set(wanted), seeds, quick):
        averaged = recording.imu.sampling is Sampling.AVERAGED
        name = _family_of(recording)
        rate = AVERAGED if averaged else NATIVE
        family = families.setdefault((name, rate), Family(name, rate))
        held = family.apart if recording.name == HOLE else family.recordings
        held.append(recording)
    order = [(name, rate) for rate in (NATIVE, AVERAGED) for name in FAMILIES]
    return [families[key] for key in order if key in families]


def _family_of(recording: TruthRecording) -> str:
    if recording.family in FAMILIES:
        return recording.family
    return _simulated_family(recording.family)


def _recordings(wanted: set[str], seeds: int, quick: bool) -> list[TruthRecording]:
    found: list[TruthRecording] = []
    if wanted & set(OPTICAL):
        for averaged in (False, True):
            found += load_orientation(ORIENTATION, averaged)
    if "car" in wanted:
        found.append(load_comma(COMMA))
    found = [
        recording
        for recording in found
        if recording.family in wanted and not (quick and not _is_quick(recording))
    ]
    for scene in QUICK_SCENES if quick else MOTION_SCENES:
        if _simulated_family(scene) in wanted:
            found += [
                load_simulated(scene, seed, sensor=sensor)
                for sensor in ((_CAMERA,) if quick else (_CAMERA, _BOARD))
                for seed in range(1, (1 if quick else seeds) + 1)
            ]
    return found


def _simulated_family(scene: str) -> str:
    return _DRIVEN if scene.startswith("car") else _CARRIED


def simulated_rides(wanted: Iterable[str]) -> dict[str, list[tuple[str, str]]]:
    """Return scene and sensor of the simulated rides by the key of their family."""
    found: dict[str, list[tuple[str, str]]] = {}
    for sensor, rate in ((_CAMERA, NATIVE), (_BOARD, AVERAGED)):
        for scene in MOTION_SCENES:
            if (name := _simulated_family(scene)) in wanted:
                key = Family(name, rate).key
                found.setdefault(key, []).append((scene, sensor))
    return found


def one_ride_each(family: Family) -> list[TruthRecording]:
    """Return its recordings, of simulated rides the first of each scene."""
    if family.name in (*OPTICAL, "car"):
        return family.recordings
    first = {one.family: one for one in reversed(family.recordings)}
    return list(first.values())[::-1]


def _is_quick(recording: TruthRecording) -> bool:
    return recording.name in QUICK_NAMES
