"""The quality report of a sequence: each figure with its mark and what to do."""

from collections.abc import Sequence
from html import escape

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QTextOption
from PySide6.QtWidgets import QTextBrowser

from app.bridge.languages import translated
from app.widgets import theme
from app.widgets.texts import local
from hapticplayer.capture.sync.methods import title_of
from hapticplayer.sequence.report import Finding, Mark, needs_recording, worst

translate = QCoreApplication.translate
_SIGNS = {Mark.GOOD: "\u25cf", Mark.DOUBTFUL: "\u25b2", Mark.BAD: "\u25a0"}


class QualityView(QTextBrowser):
    """Shows findings, the verdict first, then the notes of the import."""

    def __init__(self) -> None:
        super().__init__()
        self.setOpenLinks(False)
        self.setWordWrapMode(QTextOption.WrapMode.WordWrap)  # never within a word
        self.setAccessibleName(self.tr("Quality report"))
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)

    def show_findings(
        self, findings: Sequence[Finding], notes: Sequence[str] = ()
    ) -> None:
        """Show a report."""
        whole = worst(list(findings))
        head = f"<h3>{_sign(whole)} {escape(verdict(list(findings)))}</h3>"
        rows = "".join(_row(one) for one in findings)
        said = "".join(f"<li>{escape(translated(note))}</li>" for note in notes)
        more = ""
        if said:
            title = escape(self.tr("Notes"))
            more = (
                "<p style='font-size:4pt; margin:0'>&nbsp;</p>"
                f"<p style='color:{theme.DIM}; margin:0'>{title}</p>"
                f"<ul style='margin-top:0'>{said}</ul>"
            )
        self.setHtml(
            f"{head}<table cellspacing='0' cellpadding='4'>{rows}</table>{more}"
        )

    def show_problem(self, text: str) -> None:
        """Show why there is no report: the sequence cannot be read."""
        title = escape(self.tr("This sequence cannot be played"))
        self.setHtml(
            f"<h3>{_sign(Mark.BAD)} {title}</h3><p>{escape(translated(text))}</p>"
        )


def verdict(findings: list[Finding]) -> str:
    """The overall quality."""
    mark = worst(findings)
    if mark is Mark.BAD and not needs_recording(findings):
        return translate("Quality", "Bad: change the rendering")
    return {
        Mark.GOOD: translate("Quality", "Good: ready for use"),
        Mark.DOUBTFUL: translate("Quality", "Doubtful: check the marked items"),
        Mark.BAD: translate("Quality", "Bad: record or import it again"),
    }[mark]


def mark_name(mark: Mark) -> str:
    """Return a mark in a word."""
    return {
        Mark.GOOD: translate("Quality", "good"),
        Mark.DOUBTFUL: translate("Quality", "doubtful"),
        Mark.BAD: translate("Quality", "bad"),
    }[mark]


def colour_of(mark: Mark) -> str:
    return {Mark.GOOD: theme.GOOD, Mark.DOUBTFUL: theme.WARN, Mark.BAD: theme.BAD}[mark]


def _sign(mark: Mark) -> str:
    return f"<span style='color:{colour_of(mark)}'>{_SIGNS[mark]}</span>"


def _row(one: Finding) -> str:
    advice = "" if one.mark is Mark.GOOD else _advice(one)
    value = escape(local(value_of(one)))
    if advice:  # under the figure: a column of its own is too much in a narrow window
        value += f"<br><span style='color:{theme.DIM}'>{escape(advice)}</span>"
    cells = (
        f"{_sign(one.mark)} {escape(mark_name(one.mark))}",
        f"<b>{escape(name_of(one))}</b>",
        value,
    )
    return "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>"


def name_of(one: Finding) -> str:
    """The subject of a finding."""
    names = {
        "estimate": translate("Quality", "Motion"),
        "sync": translate("Quality", "Synchronisation"),
        "drift": translate("Quality", "Clock drift"),
        "rate": translate("Quality", "Sampling"),
        "leak": translate("Quality", "Residual gravity at rest"),
        "sensor": translate("Quality", "Sensor saturation"),
        "gaps": translate("Quality", "Gaps"),
        "cover": translate("Quality", "Clip without motion data"),
        "force": translate("Quality", "Force saturation"),
        "workspace": translate("Quality", "Workspace used"),
        "heat": translate("Quality", "Motor heating"),
    }
    return names.get(one.name, one.name)


def value_of(one: Finding) -> str:
    """Return the figure with its unit, and what belongs to it."""
    if one.value is None:
        return translate("Quality", "not measured")
    value, more = one.value, one.more
    percent = f"{100.0 * value:.3g}\u00a0%"
    if one.name == "sync":
        text = translate("Quality", "residual {ms} ms, confidence {confidence} ({how})")
        if more.get("is_confirmed"):  # a figure of the doubt that was resolved
            text = translate(
                "Quality", "residual {ms} ms, confirmed by a person ({how})"
            )
        return text.format(
            ms=f"{1e3 * value:.1f}",
            confidence=f"{more['confidence']:.2f}",
            how=translated(title_of(str(more["method"]))),
        ).removesuffix(" ()")  # a simulated camera has nothing to find
    if one.name == "estimate":
        text = translate(
            "Quality",
            "estimated from the picture, nothing measured it: sway in {sway}, bounce in "
            "{bounce} of the clip; gain {gain}",
        )
        return text.format(
            sway=_percent(more.get("sway")),
            bounce=_percent(more.get("bounce")),
            gain=f"{value:g}",
        )
    if one.name == "gaps" and more.get("gaps"):
        text = translate("Quality", "{share} of the motion; {count}, the longest {s} s")
        longest = f"{more.get('longest_gap_s') or 0.0:.2f}"
        return text.format(share=percent, count=int(more["gaps"]), s=longest)
    if one.name == "force":
        text = translate("Quality", "{share} of the time; the peak is {n} N")
        return text.format(share=percent, n=f"{more.get('peak_n') or 0.0:.2f}")
    units = {
        "drift": f"{value:+.1f} ppm",
        "rate": f"{value:.1f} Hz",
        "leak": f"{value:.3f} m/s\u00b2",
        "workspace": ", ".join(
            f"{_hand(name)} {100.0 * reach:.0f}\u00a0%"
            for name, reach in more.get("reaches", {}).items()
        ),
    }
    return units.get(one.name, percent)


def _hand(name: str) -> str:
    return {
        "relaxed": translate("Quality", "relaxed hand"),
        "normal": translate("Quality", "normal hand"),
        "firm": translate("Quality", "firm hand"),
    }.get(name, name)


def _percent(share: float | None) -> str:
    return f"{100.0 * (share or 0.0):.0f}\u00a0%"


def _advice(one: Finding) -> str:
    if one.name == "workspace" and one.more.get("trips"):
        return translate("Quality", "The force would be stopped; lower the gain")
    return {
        "estimate": translate("Quality", "Record the motion with the next video"),
        "sync": translate("Quality", "Check the synchronisation")
        if one.more.get("method") in ("pats", "embedded")
        else translate(
            "Quality",
            "Check the synchronisation; next time tap the recorder three times",
        ),
        "drift": translate("Quality", "In long recordings, tap at the end as well"),
        "rate": translate("Quality", "Next time: record at 100 Hz or more"),
        "leak": translate(
            "Quality", "Next time: keep still for a few seconds at the start"
        ),
        "sensor": translate(
            "Quality", "Next time: choose a larger accelerometer range"
        ),
        "gaps": translate(
            "Quality", "There is no force in the gaps; try another memory card"
        ),
        "cover": translate(
            "Quality", "Next time: start the log before the clip and stop it after"
        ),
        "force": translate("Quality", "Lower the gain"),
        "workspace": translate("Quality", "Lower the gain"),
        "heat": translate("Quality", "Lower the gain, or play shorter clips"),
    }.get(one.name, "")
