"""What faults and rules are called on the developer's panel."""

from PySide6.QtCore import QCoreApplication

from hapticplayer.haptics.contract import RULES, Cause, Reaction
from hapticplayer.simulation.faults import RULES_OF, Fault

translate = QCoreApplication.translate

HANGS: dict[str, tuple[float, Cause]] = {
    "hang-short": (0.4, Cause.HEARTBEAT_LATE),
    "hang-long": (1.3, Cause.HEARTBEAT_LOST),
}
"""Faults of the window itself: how long it hangs, and the rule that answers."""

_REACTIONS = {rule.cause: rule.reaction for rule in RULES}


def fault_text(name: str) -> str:
    """Return what happens."""
    return {
        Fault.UNPLUG.value: translate("FaultTexts", "Unplug it"),
        Fault.SHORT_STALL.value: translate("FaultTexts", "Stall, 60 ms"),
        Fault.LONG_STALL.value: translate("FaultTexts", "Stall, 300 ms"),
        Fault.NONSENSE.value: translate("FaultTexts", "Nonsense answers"),
        Fault.LOST_HOMING.value: translate("FaultTexts", "Lose the homing"),
        Fault.LET_GO.value: translate("FaultTexts", "Let go of the grip"),
        Fault.BUTTON.value: translate("FaultTexts", "Press a grip button"),
        Fault.POSITION_NAN.value: translate("FaultTexts", "Position is NaN"),
        Fault.FORCE_NAN.value: translate("FaultTexts", "Force is NaN"),
        Fault.LOOP_LATE.value: translate("FaultTexts", "Loop late, 35 ms"),
        Fault.LOOP_LOST.value: translate("FaultTexts", "Loop still, 80 ms"),
        Fault.STALE_COMMAND.value: translate("FaultTexts", "Command 25 ms old"),
        "hang-short": translate("FaultTexts", "Window hangs, 0.4 s"),
        "hang-long": translate("FaultTexts", "Window hangs, 1.3 s"),
    }[name]


def names() -> list[str]:
    """Return all faults in the order of the panel."""
    return [fault.value for fault in Fault] + list(HANGS)


def rule_text(cause: Cause) -> str:
    """Return a rule as the contract's table has it: its name and its reaction."""
    reaction = _REACTIONS.get(cause)
    return (
        f"{cause.name} ({reaction.name})"
        if isinstance(reaction, Reaction)
        else "\u2013"
    )


def expected(name: str) -> str:
    """Return the rules that may answer."""
    causes = (HANGS[name][1],) if name in HANGS else RULES_OF[Fault(name)]
    return ", ".join(rule_text(cause) for cause in causes)
