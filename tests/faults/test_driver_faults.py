"""The safety contract with the Falcon's driver; faults happen on its USB."""

import pytest

from hapticplayer.haptics.contract import Cause
from tests.faults.driver_faults import Side, cases_of, check_force_is_gone_in_time
from tests.faults.falcon_rig import FalconGrip

# The answer comes with the chip's latency timer. No encoder says "not a number", and
# none leaps through the air to the edge; a place that is lost for good is a fault of
# the driver, earlier than 20 bad answers.
FALCON = Side(
    FalconGrip,
    phases=3,
    slack=3,
    cannot=("position-not-finite", "pushed-out"),
    also={"encoder-leaps": Cause.UNPLUGGED},
    deaf=("unplugged",),
)


@pytest.mark.parametrize(("name", "phase"), cases_of(FALCON))
def test_the_force_is_gone_in_the_stated_time_and_its_slack(name, phase):
    check_force_is_gone_in_time(FALCON, name, phase)
