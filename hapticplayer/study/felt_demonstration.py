"""The demonstration of the device by a sensor: what the experimenter moves is felt."""

from typing import Any

from hapticplayer.capture.live.source import OpenedSource
from hapticplayer.model import Mapping
from hapticplayer.playback.feel import Feel, FeelPhase
from hapticplayer.study.definition import Condition
from hapticplayer.study.player_stage import PlayerStage

FELT_S, MOST_S = 20.0, 60.0
"""The demonstration ends when so much was felt, or after so long at the latest."""


class FeltStage(PlayerStage):
    """Trials as ever, with a sensor in place of the usual demonstration.

    Args:
        stage: as of a stage.
        sensor: an open one; who opened it closes it.
    """

    def __init__(self, *stage: Any, sensor: OpenedSource) -> None:
        super().__init__(*stage)
        self._sensor, self._is_demonstration = sensor, False
        self._feel: Feel | None = None
        self._end_s = 0.0

    @property
    def said(self) -> str:
        """What the experimenter does next; "" while no sensor is felt."""
        return self._feel.snapshot().text if self._feel else ""

    def prepare(self, condition: Condition) -> None:
        self._is_demonstration = False
        super().prepare(condition)

    def prepare_demonstration(self) -> None:
        self._is_demonstration = True
        super().prepare_demonstration()

    def begin(self) -> None:
        if not self._is_demonstration:
            super().begin()
            return
        self._let_go()
        self._feel = Feel(self.player, self._sensor, Mapping(), self._clock)
        self._end_s = self._clock.now_s() + MOST_S
        self._feel.start()

    def is_over(self) -> bool:
        if self._feel is None:
            return super().is_over()
        is_lost = self._feel.snapshot().phase is FeelPhase.LOST
        is_felt = self._feel.summary()["felt_s"] >= FELT_S
        if not (is_lost or is_felt or self._clock.now_s() >= self._end_s):
            return False
        self._let_go()
        return True

    def halt(self) -> None:
        super().halt()
        self._let_go()

    def interrupt(self) -> None:
        super().interrupt()
        self._let_go()

    def _let_go(self) -> None:
        """Ramp the force of the sensor, if it is felt."""
        feel, self._feel = self._feel, None
        if feel is not None:
            feel.stop()
