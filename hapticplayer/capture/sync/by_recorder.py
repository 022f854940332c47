"""The clock of a recorder here, corrected by taps or frames."""

import dataclasses

from hapticplayer.capture.recording import OtherPlace
from hapticplayer.capture.sync.methods import sync_method
from hapticplayer.capture.sync.result import Synchronisation, SyncInput
from hapticplayer.capture.sync.synchronize import (
    CONTRADICTED,
    MOST_SIGMAS,
    NO_PATS,
    by_pats,
    tried,
)
from hapticplayer.errors import InputError, Message, joined
from hapticplayer.model import ClockMap

_NEAR_S = 0.15  # of a recorder's clock: a camera's exposure and a link's least delay


def corrected(inputs: SyncInput) -> Synchronisation:
    """A recorder's clock, whose constant taps correct, else the frames.

    Taps are looked for near it only; it decides between places that frames fit alike.
    Frames that are sure of another place contradict it.
    """
    own, lag = inputs.own, inputs.lag
    assert own is not None
    assert lag is not None
    reach_s = _NEAR_S + MOST_SIGMAS * lag.sigma_s
    inputs = inputs._replace(near_s=reach_s)
    found, unheard = tried(by_pats, inputs)
    unseen: InputError | None = None
    if (found is None or not found.is_confident) and inputs.look is not None:
        found, unseen = tried(sync_method("frames").function(), inputs)
    if found is None or not found.is_confident:
        reasons: list[str] = [one.what for one in (unheard, unseen) if one is not None]
        reasons += [found.frames.doubt] if found and found.frames else []
        why = joined("; ", reasons or [NO_PATS])
        lag = dataclasses.replace(lag, why=why)
        return Synchronisation(own, "embedded", offset_sigma_s=lag.sigma_s, lag=lag)
    middle_s = float(inputs.imu.time_s[len(inputs.imu) // 2])
    off_s = own.offset_at(middle_s) - found.clock_map.offset_at(middle_s)
    if abs(off_s) > reach_s:
        return _contradicting(own, found, off_s)
    sigma_s = max(found.offset_sigma_s, 0.0005)
    lag = dataclasses.replace(
        lag, measured_by=found.method, lag_s=off_s, sigma_s=sigma_s
    )
    clock = dataclasses.replace(found.clock_map, confidence=own.confidence)
    return dataclasses.replace(found, clock_map=clock, method="embedded", lag=lag)


def _contradicting(
    own: ClockMap, found: Synchronisation, off_s: float
) -> Synchronisation:
    """A recorder's clock and frames that are sure of another place: a person decides."""
    return Synchronisation(
        dataclasses.replace(own, confidence=CONTRADICTED),
        "embedded",
        second=found,
        contradiction=Message(
            "the frames place the motion {off_s:+.2f} s from where the recorder's clock "
            "does",
            off_s=-off_s,
        ),
        others=(
            OtherPlace(Message("by the recorder's clock"), own.offset_s),
            OtherPlace(Message("by the frames"), found.clock_map.offset_s),
        ),
    )
