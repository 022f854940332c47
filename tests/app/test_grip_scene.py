"""The scene of the grip: the projection and the shapes in closed form."""

import math
from dataclasses import replace

import numpy as np
import pytest

from app.plots.grip_moving import arrow_tip
from app.plots.grip_scene import (
    ARROW_RADII,
    GRIP_RADII,
    LEAST_ZOOM,
    MOST_ZOOM,
    Activity,
    Camera,
    Grip,
    Projection,
    cap,
    hull,
)

RADIUS_M, SIDE_PX = 0.040, 320.0
FRONT = Camera(0.0, 0.0)
ACTIVE = Grip("Grip", "", Activity.ACTIVE, position_m=(0.01, 0.005, 0.0))


def projection(camera: Camera = FRONT, **more) -> Projection:
    return Projection(camera, RADIUS_M, SIDE_PX, more.get("height_px", SIDE_PX))


# --- projection ---------------------------------------------------------------


def test_from_the_users_place_right_is_right_and_up_is_up():
    view = projection()
    x0_px, y0_px = view.px((0, 0, 0))
    x_px, y_px = view.px((0.02, 0, 0))
    assert x_px > x0_px
    assert y_px == pytest.approx(y0_px)
    x_px, y_px = view.px((0, 0.02, 0))
    assert x_px == pytest.approx(x0_px)
    assert y_px < y0_px  # pixels count downwards


def test_a_grip_towards_the_user_grows_as_perspective_says():
    view = projection()
    for z_m in (-0.03, 0.01, 0.03):
        grown = view.px_per_m((0, 0, z_m)) / view.px_per_m((0, 0, 0))
        assert grown == pytest.approx(view.distance_m / (view.distance_m - z_m))


@pytest.mark.parametrize("yaw_deg", [-140, -28, 0, 65])
@pytest.mark.parametrize("pitch_deg", [-80, 0, 20])
def test_a_point_lands_where_the_pinhole_equation_says(yaw_deg, pitch_deg, rng):
    view = projection(Camera(math.radians(yaw_deg), math.radians(pitch_deg)))
    points = rng.uniform(-0.04, 0.04, (20, 3))
    yaw, pitch = np.radians([yaw_deg, pitch_deg])
    turn_y = np.array(
        [
            [np.cos(yaw), 0, -np.sin(yaw)],
            [0, 1, 0],
            [np.sin(yaw), 0, np.cos(yaw)],
        ]
    )
    turn_x = np.array(
        [
            [1, 0, 0],
            [0, np.cos(pitch), -np.sin(pitch)],
            [0, np.sin(pitch), np.cos(pitch)],
        ]
    )
    seen = points @ (turn_x @ turn_y).T
    scale = view.focal_px / (view.distance_m - seen[:, 2])
    x0_px, y0_px = view.middle_px
    wanted = np.stack([x0_px + scale * seen[:, 0], y0_px - scale * seen[:, 1]], 1)
    got = np.array([view.px(tuple(point)) for point in points])
    assert np.allclose(got, wanted, atol=1e-9)


def test_the_outline_of_the_sphere_is_tight(rng):
    view = projection(Camera(0.4, -0.3, 1.3))
    points = rng.standard_normal((20_000, 3))
    points *= RADIUS_M / np.linalg.norm(points, axis=1)[:, None]
    away = [math.dist(view.px(tuple(point)), view.middle_px) for point in points]
    assert max(away) <= view.sphere_px + 1e-9
    assert max(away) == pytest.approx(view.sphere_px, rel=1e-3)


def test_the_front_of_the_sphere_faces_the_camera():
    view = projection()
    rim_m = RADIUS_M**2 / view.distance_m  # where the rays touch
    across_m = math.sqrt(RADIUS_M**2 - rim_m**2)
    assert view.is_in_front((0, 0, RADIUS_M))
    assert not view.is_in_front((0, 0, -RADIUS_M))
    assert view.is_in_front((across_m, 0, 1.001 * rim_m))
    assert not view.is_in_front((across_m, 0, 0.999 * rim_m))


def test_a_point_behind_the_camera_still_has_a_place_in_numbers():
    x_px, y_px = projection().px((0.1, 0.1, 5.0))
    assert math.isfinite(x_px)
    assert math.isfinite(y_px)


def test_the_camera_never_goes_over_the_top_nor_through_the_grip():
    camera = Camera().turned(50.0, 9.0).zoomed(1e6)
    assert abs(camera.yaw_rad) <= math.pi
    assert camera.pitch_rad < math.pi / 2
    assert camera.zoom == MOST_ZOOM
    assert camera.zoomed(1e-9).zoom == LEAST_ZOOM


# --- shapes -------------------------------------------------------------------


@pytest.mark.parametrize(
    "force_n", [(2.0, 0, 0), (0, -3.0, 0), (0, 0, 4.5), (1.0, 2.0, -2.0)]
)
def test_the_arrow_has_direction_and_length_of_the_force(force_n):
    grip = replace(ACTIVE, force_n=force_n)
    tip = np.array(arrow_tip(grip, grip.position_m)) - grip.position_m
    strength_n = np.linalg.norm(force_n)
    assert np.allclose(np.cross(tip, force_n), 0.0, atol=1e-12)
    assert tip @ force_n > 0
    length_m = np.linalg.norm(tip) - GRIP_RADII * RADIUS_M
    assert length_m == pytest.approx(ARROW_RADII * RADIUS_M * strength_n / 4.5)


def test_a_force_that_nobody_feels_has_no_arrow():
    assert arrow_tip(replace(ACTIVE, force_n=(0.02, 0, 0)), (0, 0, 0)) is None


def test_the_cap_lies_on_the_sphere_around_its_direction():
    around = np.array(cap((1.0, 2.0, -0.5), RADIUS_M, 0.4))
    axis = np.array([1.0, 2.0, -0.5]) / np.linalg.norm([1.0, 2.0, -0.5])
    assert np.allclose(np.linalg.norm(around, axis=1), RADIUS_M)
    assert np.allclose(around @ axis, RADIUS_M * math.cos(0.4))


def test_the_hull_is_convex_and_leaves_no_point_outside(rng):
    points = [tuple(point) for point in rng.standard_normal((60, 2))]
    outline = np.array(hull(points))
    sides = np.roll(outline, -1, axis=0) - outline
    for point in np.array(points):
        to = point - outline
        assert np.all(sides[:, 0] * to[:, 1] - sides[:, 1] * to[:, 0] > -1e-12)
