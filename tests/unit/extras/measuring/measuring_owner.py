"""An owner's measurement on a simulated Falcon, to be killed: `RECORD_DESCRIPTOR`."""

import sys

from hapticplayer.clock import SystemClock
from hapticplayer.devices.falcon.link import ThreadedLink
from hapticplayer.devices.falcon.reach import reach_of
from hapticplayer.errors import HapticPlayerError
from hapticplayer.extras.measuring import measuring
from hapticplayer.extras.measuring.guarded_clock import GuardedClock

DEVICE = "falcon-simulated"


def say(what: object) -> None:
    """Tell the test."""
    sys.stdout.write(f"{what}\n")
    sys.stdout.flush()


def main() -> int:
    """Measure until somebody ends it."""
    record = int(sys.argv[1])
    options = ["--running", "--hand", "firm", "--record", str(record)]
    watch = GuardedClock(SystemClock(), DEVICE, options, [record])
    say(watch.guard_pid)
    # not with the clock that beats: a thread of the link would beat for a dead loop
    reach = reach_of(DEVICE, watch.handle())
    driver = reach.driver(SystemClock(), make_link=ThreadedLink)
    driver.open()
    try:
        with watch.force():
            measuring.force_after_silence(driver, watch)
    except HapticPlayerError as problem:
        say(problem)
        return 1
    finally:
        driver.close()
        watch.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
