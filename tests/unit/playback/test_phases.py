"""Every cell of the phase table: where each event leads, and what is done on the way."""

import pytest

from hapticplayer.playback.phases import Action, Phase, PhaseEvent, transition

GO_TO, HOLD, FORGET = (Action.GO_TO,), (Action.HOLD,), (Action.FORGET,)
SOUND, CLOCK = (Action.START_SOUND,), (Action.START_CLOCK,)

# one row for each event: the next phase from each phase by its first letters, in the
# order of `Phase` (empty, paused, buffering, starting, playing, ended); "-" is ignored
PHASES = {phase.value[:2]: phase for phase in Phase}
ROWS = {
    PhaseEvent.OPEN: ("pa - - - - -", [GO_TO]),
    PhaseEvent.CLOSE: ("- em em em em em", [FORGET] * 5),
    PhaseEvent.PLAY: ("- bu - - - bu", [(), GO_TO]),
    PhaseEvent.PAUSE: ("- - pa pa pa -", [HOLD] * 3),
    PhaseEvent.SEEK: ("- pa bu bu bu pa", [GO_TO] * 5),
    PhaseEvent.REFRESH: ("- pa - - - en", [GO_TO] * 2),
    PhaseEvent.BUFFERED: ("- - st - - -", [SOUND]),
    PhaseEvent.BUFFERED_SILENT: ("- - pl - - -", [CLOCK]),
    PhaseEvent.HEARD: ("- - - pl - -", [()]),
    PhaseEvent.UNHEARD: ("- - - pl - -", [CLOCK]),
    PhaseEvent.OUTPUT_CHANGED: ("- - - bu - -", [()]),
    PhaseEvent.END: ("- - - - en -", [HOLD]),
}


@pytest.mark.parametrize("event", list(PhaseEvent))
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
