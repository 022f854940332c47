"""The folders of studies, as the commands of the analysis need them."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from hapticplayer.clock import SystemClock
from hapticplayer.simulation.participants import Rate, WriteSession
from hapticplayer.simulation.sessions import write_scripted_session
from hapticplayer.study.answers import Answers, Participant, collect_answers
from hapticplayer.study.creation import create_study
from hapticplayer.study.study_folder import open_study


class StudyFolders:
    """Reads studies, and adds simulated sessions to them."""

    def read(self, folder: Path) -> Answers:
        """Return all answers of a study."""
        return collect_answers(open_study(folder))

    def design(self, folder: Path) -> Answers:
        """Return a study's answers; a missing study is made, an empty folder is one."""
        if folder.is_dir() and not any(folder.iterdir()):
            folder.rmdir()
        study = open_study(folder) if folder.exists() else create_study(folder)
        return collect_answers(study)

    def writer(self, folder: Path, origin: Mapping[str, Any]) -> WriteSession:
        """Return what adds scripted sessions, marked by their origin."""
        study, clock = open_study(folder), SystemClock()

        def write(person: Participant, rate: Rate) -> str:
            sheet = {
                "age": person.age,
                "gender": person.gender,
                "handedness": person.handedness,
                "used_device_before": person.used_device_before,
            }
            return write_scripted_session(
                study,
                sheet,
                lambda condition: rate(condition.sequence, condition.feedback),
                clock,
                origin=origin,
            )

        return write
