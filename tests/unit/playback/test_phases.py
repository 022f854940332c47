"""Every cell of the phase table: where each event leads, and what is done on the way."""

import pytest

from hapticplayer.playback.phases import Action, Event, Phase, transition

GO_TO, HOLD, FORGET = (Action.GO_TO,), (Action.HOLD,), (Action.FORGET,)
SOUND, CLOCK = (Action.START_SOUND,), (Action.START_CLOCK,)

# one row for each event: the next phase from each phase by its first letters, in the
# order of `Phase` (empty, paused, buffering, starting, playing, ended); "-" is ignored
PHASES = {phase.value[:2]: phase for phase in Phase}
ROWS = {
    Event.OPEN: ("pa - - - - -", [GO_TO]),
    Event.CLOSE: ("- em em em em em", [FORGET] * 5),
    Event.PLAY: ("- bu - - - bu", [(), GO_TO]),
    Event.PAUSE: ("- - pa pa pa -", [HOLD] * 3),
    Event.SEEK: ("- pa bu bu bu pa", [GO_TO] * 5),
    Event.REFRESH: ("- pa - - - en", [GO_TO] * 2),
    Event.BUFFERED: ("- - st - - -", [SOUND]),
    Event.BUFFERED_SILENT: ("- - pl - - -", [CLOCK]),
    Event.HEARD: ("- - - pl - -", [()]),
    Event.UNHEARD: ("- - - pl - -", [CLOCK]),
    Event.OUTPUT_CHANGED: ("- - - bu - -", [()]),
    Event.END: ("- - - - en -", [HOLD]),
}


@pytest.mark.parametrize("event", list(Event))
def test_each_event_leads_where_the_table_says(event):
    cells, actions = ROWS[event]
    left = iter(actions)
    for phase, cell in zip(Phase, cells.split(), strict=True):
        found = transition(phase, event)
        if cell == "-":
            assert found is None, phase
        else:
            assert found == (PHASES[cell], next(left)), phase
    assert next(left, None) is None
