"""The picture of a Falcon that is homed."""

from PySide6.QtGui import QColor

from app.player.homing_view import HomingDrawing, HomingView, TravelEstimate, view_of
from app.widgets import theme
from hapticplayer.devices.falcon.homing import WAY_COUNTS, Advice, Guidance
from hapticplayer.devices.falcon.setting_up import Progress, Step


def test_the_travel_of_a_leg_is_shown_from_end_to_end():
    ways = TravelEstimate()
    assert ways.share(0, 0) == 0.5
    assert ways.share(0, WAY_COUNTS) == 1.0
    assert ways.share(0, 0) == 0.0
    assert ways.share(0, -WAY_COUNTS) == 0.0
    assert ways.share(0, 0) == 1.0
    assert ways.share(1, 0) == 0.5  # each for itself


def test_a_view_says_what_the_guidance_says():
    guidance = Guidance(Advice.PUSH, (True, False, True), 600.0, (600, 0, 1200))
    view = view_of(Progress(Step.HOMING, 1.0, guidance), TravelEstimate())
    assert (view.homed, view.arrow, view.is_ready) == ((True, False, True), -1, False)
    assert view.legs == (0.75, 0.5, 1.0)
    view = view_of(
        Progress(Step.READY, 1.0, None, (0.02, -0.04, 0.08)), TravelEstimate()
    )
    assert (view.aside, view.out, view.is_ready) == ((0.5, -1.0), 1.0, True)
    assert view_of(None, TravelEstimate()) == HomingView()


def colours(picture):
    """Return how many pixels have each of the theme's signal colours."""
    image = picture.grab().toImage()
    names = [
        image.pixelColor(x, y).name()
        for x in range(image.width())
        for y in range(image.height())
    ]
    return {n: names.count(QColor(getattr(theme, n)).name()) for n in ("GOOD", "WARN")}


def test_the_picture_shows_rings_discs_and_arrows(application, qtbot):
    picture = HomingDrawing()
    qtbot.addWidget(picture)
    open_rings = HomingView((False,) * 3, (0.5,) * 3, 0.5)
    found = []
    for view in (
        open_rings,
        open_rings._replace(arrow=1),
        open_rings._replace(homed=(True, False, False)),
        open_rings._replace(homed=(True,) * 3),
    ):
        picture.show_view(view)
        found.append(colours(picture))
    none, arrow, one, three = found
    assert none["GOOD"] == 0
    assert none["WARN"] > 100  # three rings
    assert arrow["WARN"] > none["WARN"] + 200
    assert three["GOOD"] > 2.5 * one["GOOD"] > 0
    assert three["WARN"] == 0
