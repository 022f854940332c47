"""What holds for the whole study: title, languages, checks."""

from PySide6.QtWidgets import QCheckBox, QWidget

from app.bridge.languages import NAMES
from app.experimenter.study.document import StudyDocument
from app.experimenter.study.fields import Fields
from app.widgets import theme
from app.widgets.layout import STRETCH, paragraph, row_of
from hapticplayer.model.ranges import Range
from hapticplayer.study.creation import with_languages
from hapticplayer.study.definition import Checks, PlaybackLimits, TrialKind


class GeneralFields(Fields):
    """The first page of the editor."""

    def __init__(self, document: StudyDocument) -> None:
        super().__init__(document)
        self.languages: dict[str, QCheckBox] = {}

    def refresh(self) -> None:
        self.show_shape("general", self._fill)

    def _fill(self) -> None:
        self.line(self.tr("Title"), ("title",))
        self._language_row()
        self.check(
            self.tr("Hide the condition from the operator"), ("operator_is_blind",)
        )
        self.check(
            self.tr("Use the published wording of questions where there is one"),
            ("use_published",),
        )
        self.check(
            self.tr(
                "Stream markers and force to other programs on this computer (LSL)"
            ),
            ("lsl",),
        )
        self.check(self.tr("Record each session with LabRecorder"), ("lab_recorder",))
        self.listed(
            self.tr("LSL streams that each trial needs"),
            ("needed_streams",),
        )
        text = self.tr("Least time between two clips")
        self.decimal(text, ("gap_s",), Range(0.0, 3600.0, "s"))
        self._fill_checks()
        self._fill_limits()
        self.whole(paragraph(self.unchanged(), theme.DIM))

    def _fill_checks(self) -> None:
        self.heading(self.tr("Before a session"))
        self.check(
            self.tr("Require a real device before a session starts"),
            ("checks", "device"),
            usually=True,
        )
        self.check(
            self.tr("Ask the operator whether the sound is audible"),
            ("checks", "sound"),
            usually=True,
        )
        disk = self.number(
            self.tr("Free disk space"),
            ("checks", "disk_free_mb"),
            0,
            10**9,
            usually=Checks().disk_free_mb,
        )
        disk.setSuffix(" MB")
        self.ticks(
            self.tr("Scheduling of the haptic loop"),
            ("checks", "scheduling"),
            [
                (self.tr("real time (FIFO)"), "fifo"),
                (self.tr("short time slices"), "slice"),
                (self.tr("normal"), "normal"),
            ],
            usually=Checks().scheduling,
        )

    def _fill_limits(self) -> None:
        self.heading(self.tr("A trial is marked as invalid above"))
        for text, name, limits in (
            (self.tr("Dropped frames (share)"), "dropped_share", Range(0.0, 1.0)),
            (
                self.tr("Force to video or sound (median)"),
                "sync_ms",
                Range(0.0, 1e6, "ms"),
            ),
            (
                self.tr("Missed periods of the haptic loop (share)"),
                "missed_share",
                Range(0.0, 1.0),
            ),
            (self.tr("Audio dropouts"), "silence_s", Range(0.0, 1e6, "s")),
        ):
            usually = getattr(PlaybackLimits(), name)
            box = self.decimal(text, ("limits", name), limits, usually=usually)
            if limits.unit == "ms":
                box.setDecimals(1)
            box.setSingleStep(1.0 if limits.unit == "ms" else 0.01)

    def unchanged(self) -> str:
        """What the editor keeps as it is."""
        kinds = {
            TrialKind.RATING: self.tr("conditions are compared by answers"),
            TrialKind.YES_NO: self.tr("yes or no to each level of the force"),
            TrialKind.TWO_INTERVAL: self.tr("which of two clips (forced choice)"),
            TrialKind.MAGNITUDE: self.tr("a number for each level of the force"),
        }
        text = self.tr(
            "Kept as they are: the template ({template}), what the trials are for "
            "({trial}), and the identifier by which sessions belong to the study ({id})."
        )
        at = self.document.at
        trial = kinds.get(at(("trial",)), at(("trial",)))
        return text.format(template=at(("template",)), trial=trial, id=at(("id",)))

    def _language_row(self) -> None:
        self.languages = {}
        known = dict.fromkeys([*NAMES, *self.document.languages])
        for language in known:
            box = self.languages[language] = QCheckBox(NAMES.get(language, language))
            box.clicked.connect(lambda *_: self._choose_languages())
        row = QWidget()
        row_of(*self.languages.values(), STRETCH, spacing=16, of=row)
        self.row(self.tr("Languages"), row)
        first = next(iter(self.languages.values()))
        self.bind(("languages",), first, self._show_languages)

    def _show_languages(self) -> None:
        spoken = self.document.languages
        for language, box in self.languages.items():
            box.setChecked(language in spoken)
            box.setEnabled(spoken != [language])  # one has to stay

    def _choose_languages(self) -> None:
        chosen = [one for one, box in self.languages.items() if box.isChecked()]
        made = with_languages(self.document.value, chosen)
        self.document.change(made, self.tr("other languages"))
