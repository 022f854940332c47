"""The phases of playing as one table: what each event does in each phase."""

import enum
from typing import NamedTuple


class Phase(enum.StrEnum):
    """What the player is doing."""

    EMPTY = "empty"
    PAUSED = "paused"
    BUFFERING = "buffering"
    STARTING = "starting"
    PLAYING = "playing"
    ENDED = "ended"


PLAYING_PHASES = (Phase.BUFFERING, Phase.STARTING, Phase.PLAYING)


class PhaseEvent(enum.Enum):
    """What a person asks for, or what happens to a clip."""

    OPEN = enum.auto()
    CLOSE = enum.auto()
    PLAY = enum.auto()
    PAUSE = enum.auto()
    SEEK = enum.auto()
    REFRESH = enum.auto()
    """The frame that is shown has to be decoded again."""
    BUFFERED = enum.auto()
    """Enough is decoded, and a sound output will lead the clock."""
    BUFFERED_SILENT = enum.auto()
    """Enough is decoded, and nothing will be heard."""
    HEARD = enum.auto()
    """The first sound has been heard; the clock runs with it."""
    UNHEARD = enum.auto()
    """The sound output has played nothing for too long."""
    OUTPUT_CHANGED = enum.auto()
    """The sound output was opened or lost: what was started is not heard."""
    END = enum.auto()


class Action(enum.Enum):
    """What the player does on the way to the next phase."""

    GO_TO = enum.auto()
    """Stand at the position that belongs to the event."""
    HOLD = enum.auto()
    """Stand where the clip is; sound that is under way is kept."""
    START_SOUND = enum.auto()
    START_CLOCK = enum.auto()
    FORGET = enum.auto()
    """Drop the clip."""


class Transition(NamedTuple):
    """Where an event leads."""

    phase: Phase
    actions: tuple[Action, ...] = ()


_CLOSED = Transition(Phase.EMPTY, (Action.FORGET,))
_HELD = Transition(Phase.PAUSED, (Action.HOLD,))
_BUFFER_THERE = Transition(Phase.BUFFERING, (Action.GO_TO,))
_PAUSE_THERE = Transition(Phase.PAUSED, (Action.GO_TO,))

TRANSITIONS: dict[Phase, dict[PhaseEvent, Transition]] = {
    Phase.EMPTY: {PhaseEvent.OPEN: _PAUSE_THERE},
    Phase.PAUSED: {
        PhaseEvent.CLOSE: _CLOSED,
        PhaseEvent.PLAY: Transition(Phase.BUFFERING),
        PhaseEvent.SEEK: _PAUSE_THERE,
        PhaseEvent.REFRESH: _PAUSE_THERE,
    },
    Phase.BUFFERING: {
        PhaseEvent.CLOSE: _CLOSED,
        PhaseEvent.PAUSE: _HELD,
        PhaseEvent.SEEK: _BUFFER_THERE,
        PhaseEvent.BUFFERED: Transition(Phase.STARTING, (Action.START_SOUND,)),
        PhaseEvent.BUFFERED_SILENT: Transition(Phase.PLAYING, (Action.START_CLOCK,)),
    },
    Phase.STARTING: {
        PhaseEvent.CLOSE: _CLOSED,
        PhaseEvent.PAUSE: _HELD,
        PhaseEvent.SEEK: _BUFFER_THERE,
        PhaseEvent.HEARD: Transition(Phase.PLAYING),
        PhaseEvent.UNHEARD: Transition(Phase.PLAYING, (Action.START_CLOCK,)),
        PhaseEvent.OUTPUT_CHANGED: Transition(Phase.BUFFERING),
    },
    Phase.PLAYING: {
        PhaseEvent.CLOSE: _CLOSED,
        PhaseEvent.PAUSE: _HELD,
        PhaseEvent.SEEK: _BUFFER_THERE,
        PhaseEvent.END: Transition(Phase.ENDED, (Action.HOLD,)),
    },
    Phase.ENDED: {
        PhaseEvent.CLOSE: _CLOSED,
        PhaseEvent.PLAY: _BUFFER_THERE,  # from the beginning
        PhaseEvent.SEEK: _PAUSE_THERE,
        PhaseEvent.REFRESH: Transition(Phase.ENDED, (Action.GO_TO,)),
    },
}
"""What is not listed is ignored: an event that comes too late, or twice."""


def transition(phase: Phase, event: PhaseEvent) -> Transition | None:
    """Return where an event leads, None where it is ignored."""
    return TRANSITIONS[phase].get(event)
