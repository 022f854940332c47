"""Pictures of what an experimenter does with recordings: import, library, analysis."""

import shutil
from pathlib import Path

from app.experimenter.analysis import AnalysisPage
from app.experimenter.import_wizard import FILES, MOUNTING, SYNC, ImportWizard
from app.experimenter.library_page import LibraryPage
from app.experimenter.rendering_page import RenderingPage
from app.player.dialogs import video_question
from app.player.share_page import SharePage
from app.widgets.layout import resize_within_screen
from hapticplayer.clock import SystemClock
from hapticplayer.errors import InputError, Progress
from hapticplayer.simulation.participants import simulated_answers
from tools.pages.stage import Pictures, Stage

PARTICIPANTS = 12
SHOWN = "Videos/hapticplayer"  # in place of a folder that is gone afterwards


def pictures(stage: Stage) -> Pictures:
    """Yield every page about recordings and their answers."""
    yield from _import(stage)
    yield from _library(stage)
    yield from _rendering(stage)
    yield from _share(stage)
    yield from _analysis(stage)


def _import(stage: Stage) -> Pictures:
    found = stage.material
    wizard = ImportWizard(str(stage.folder), Path("Documents/rides"))
    with stage.shown(wizard):
        yield "import-empty", wizard.grab()
        wizard.files.blockSignals(True)
        wizard.files.take([found.video, found.log])
        wizard.files.blockSignals(False)
        wizard.files.show_problem(found.question)
        yield "import-question", stage.picture(wizard)
        wizard.files.show_problem(InputError("holds no motion", where="log.csv"))
        yield "import-error", stage.picture(wizard)
        for name, preview in (("doubt", found.doubtful), ("sure", found.certain)):
            wizard.on_found(preview)
            wizard.preview = preview
            wizard.go_to(SYNC)
            yield f"import-sync-{name}", stage.picture(wizard, 500)
        wizard.go_to(FILES)
        yield "import-found", stage.picture(wizard)
        wizard.go_to(MOUNTING)
        yield "import-mounting", stage.picture(wizard)
        is_over: list[bool] = []
        wizard.jobs.run(
            wizard.tr("Importing {0}").format("ride.mp4"),
            lambda progress: _go_on(progress, is_over),
            lambda _none: None,
        )
        wizard.sync.decided.emit()
        yield "import-busy", stage.picture(wizard, 200)
        is_over.append(True)
        stage.wait_until(lambda: not wizard.jobs.is_busy)
        wizard.problem.setText(str(InputError("is full", where="/media/disk")))
        yield "import-failed", stage.picture(wizard)
        wizard.on_made(found.made)
        yield "import-report", stage.picture(wizard)


def _go_on(progress: Progress, is_over: list[bool]) -> None:
    while not is_over:
        progress(0.4, "removing gravity")


def _library(stage: Stage) -> Pictures:
    empty = stage.folder / "empty"
    empty.mkdir(exist_ok=True)
    page = LibraryPage(empty)
    page.place.set_text(SHOWN)
    with stage.shown(page):
        yield "library-empty", page.grab()
    page = LibraryPage(stage.material.library)
    page.place.set_text(SHOWN)
    with stage.shown(page):
        stage.wait_until(lambda: len(page.thumbnails) >= 3)
        for row in range(page.list.count()):
            page.list.setCurrentRow(row)
            yield f"library-{row + 1}", stage.picture(page)
        page.list.setCurrentRow(page.list.count() - 1)
        entry = page.chosen()
        yield "library-delete", stage.asked(lambda: page.is_sure(entry))
        yield "library-rename", stage.asked(page.buttons["rename"].click)
        page.status.show_text(
            page.tr("Moved {title} to the bin.").format(title=entry.title)
        )
        page.undo.show()
        page.search.setText("nothing is called so")
        yield "library-nothing-found", stage.picture(page)


def _rendering(stage: Stage) -> Pictures:
    folder = shutil.copytree(stage.source.path, stage.folder / "rendered")
    page = RenderingPage(folder, stage.source.title, Path(SHOWN))
    with stage.shown(page):
        yield "rendering-reading", page.grab()
        stage.wait_until(lambda: page.before is not None)
        yield "rendering-before", stage.picture(page)
        fields = page.fields
        fields.preset.setCurrentIndex(fields.preset.count() - 1)
        fields.gain_kind.setCurrentIndex(1)
        for number, box in enumerate(fields.gains.boxes):
            box.setValue(0.4 + 0.2 * number)
        stage.wait_until(lambda: page.after is not None)
        yield "rendering-equal", stage.picture(page)
        fields.gain_kind.setCurrentIndex(2)
        fields.preset.setCurrentIndex(0)
        for combo in (fields.device, fields.lever_arm):
            combo.setCurrentIndex(combo.count() - 1)
        fields.axes.setText("x,y")
        stage.wait_until(lambda: not page.jobs.is_busy and bool(page.status.text()))
        yield "rendering-wrong-axes", stage.picture(page)
        fields.axes.setText("0.6,0.8,0,0,0,1,0.8,-0.6,0")
        fields.knee.setChecked(True)
        stage.wait_until(lambda: page.after is not None)
        yield "rendering-fitted", stage.picture(page)
        page.render_in_place()
        stage.wait_until(page.progress.isVisible)
        yield "rendering-writing", page.grab()
        page.jobs.cancel()
        stage.wait_until(lambda: not page.jobs.is_busy)
    nowhere = stage.folder / "nowhere"
    page = RenderingPage(nowhere, "A name that is much too long " * 8, Path(SHOWN))
    with stage.shown(page):
        stage.wait_until(lambda: not page.jobs.is_busy)
        yield "rendering-damaged", stage.picture(page)


def _share(stage: Stage) -> Pictures:
    page = SharePage(stage.source.path, SHOWN, stage.source.title)
    with stage.shown(page):
        stage.wait_until(page.save_button.isEnabled)
        yield "share-ready", page.grab()
        page.with_motion.setChecked(True)
        page.write(stage.folder / f"ride-{stage.language}.mkv")
        stage.wait_until(lambda: page.progress.bar.value() > 0 or not page.jobs.is_busy)
        yield "share-writing", page.grab()
        stage.wait_until(lambda: not page.jobs.is_busy)
        stage.wait()
        yield "share-written", page.grab()
        page.write(Path("/proc/nowhere/ride.mkv"))
        stage.wait_until(lambda: not page.jobs.is_busy)
        stage.wait()
        yield "share-failed", page.grab()
    yield "share-another-video", stage.picture(video_question(stage.source, page))


def _analysis(stage: Stage) -> Pictures:
    answers = simulated_answers(PARTICIPANTS, seed=1)
    page = AnalysisPage("Rides", lambda _progress: answers, print, SystemClock())
    resize_within_screen(page, 1040, 860)
    with stage.shown(page):
        page.analyse()
        yield "analysis-busy", stage.picture(page, 600)
        stage.wait_until(lambda: not page.is_busy)
        yield "analysis", stage.picture(page)
        bar = page.text.verticalScrollBar()
        bar.setValue(bar.maximum() // 2)
        yield "analysis-further", stage.picture(page)
        page.close_jobs()
