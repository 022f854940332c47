"""What lies around each kind of vehicle."""

from dataclasses import dataclass

from hapticplayer.simulation.rides.scenes import Vehicle

Rgb = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Surroundings:
    """A kind of way through the country.

    Attributes:
        road_half_m: half its width.
        lane_aside_m: how far its middle lies to the left of where one goes.
        verge_m: width of the strip beside it.
        road_rgb: its colour.
        verge_rgb: of the strip.
        road_mottle: how uneven the colour of the way is.
        is_marked: whether lines are painted on it.
        posts_m: distance between two posts; 0 for none.
        trees_m: distance between two trees on each side.
        trees_aside_m: how far the nearest of them stand from the verge.
        near_pixel_m: resolution of the nearest ground.
        near_reach_m: up to where that is drawn.
    """

    road_half_m: float = 2.6
    lane_aside_m: float = 1.1
    verge_m: float = 0.55
    road_rgb: Rgb = (92.0, 93.0, 97.0)
    verge_rgb: Rgb = (150.0, 136.0, 112.0)
    road_mottle: float = 7.0
    is_marked: bool = True
    posts_m: float = 8.0
    trees_m: float = 3.6
    trees_aside_m: float = 3.2
    near_pixel_m: float = 0.02
    near_reach_m: float = 8.5


_PATH = Surroundings(
    road_half_m=1.6,
    lane_aside_m=0.0,
    verge_m=0.8,
    road_rgb=(150.0, 124.0, 92.0),
    verge_rgb=(122.0, 128.0, 76.0),
    road_mottle=17.0,
    is_marked=False,
    posts_m=3.0,
    trees_m=4.5,
    trees_aside_m=4.0,
    near_pixel_m=0.025,
    near_reach_m=10.0,
)

SURROUNDINGS: dict[Vehicle, Surroundings] = {
    "bicycle": Surroundings(),
    "horse": _PATH,
    "car": Surroundings(
        road_half_m=3.5,
        lane_aside_m=1.75,
        trees_m=5.5,
        trees_aside_m=4.5,
        posts_m=16.0,
        near_pixel_m=0.03,
        near_reach_m=12.0,
    ),
    "foot": Surroundings(
        road_half_m=1.4,
        lane_aside_m=0.0,
        road_rgb=(158.0, 152.0, 140.0),
        is_marked=False,
        posts_m=0.0,
        trees_aside_m=2.0,
    ),
    "tripod": Surroundings(
        road_half_m=0.9,
        lane_aside_m=-2.2,
        road_rgb=(150.0, 130.0, 100.0),
        road_mottle=14.0,
        is_marked=False,
        posts_m=0.0,
        trees_m=3.0,
    ),
}
"""By vehicle."""

SHAKES_PX: dict[Vehicle, float] = {
    "bicycle": 1.2,
    "horse": 0.5,
    "car": 0.12,
    "foot": 0.0,
    "tripod": 0.0,
}
"""How far the foreground moves, in 540 lines, for each m/s2 upwards: arms give way."""
