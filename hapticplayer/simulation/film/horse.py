"""A horse's neck, mane and ears, seen by its rider."""

import numpy as np
from scipy.ndimage import gaussian_filter

from hapticplayer.simulation.film.colours import Floats32
from hapticplayer.simulation.film.overlay import Painted, lay, within

_SHARE = 0.56  # of the picture's height
_COAT = np.array((132.0, 84.0, 50.0), np.float32)
_DARK = np.array((46.0, 30.0, 24.0), np.float32)
_LEATHER = np.array((58.0, 38.0, 28.0), np.float32)


def horse(width: int, height: int, rng: np.random.Generator) -> Painted:
    """Return neck, mane, ears and reins; the head nods as one with them."""
    rows = round(_SHARE * height)
    spare = rows // 3
    y, x = np.mgrid[0 : rows + spare, 0:width].astype(np.float32)
    u, v = (x - 0.5 * width) / rows, y / rows
    rgb = np.zeros((*v.shape, 3), np.float32)
    cover = np.zeros(v.shape, np.float32)
    hair = gaussian_filter(rng.standard_normal(v.shape).astype(np.float32), (7.0, 0.8))
    hair /= hair.std()
    for side in (-1.0, 1.0):
        _rein(rgb, cover, side * u, v, rows)
    # the neck narrows to the poll between the ears
    half = 0.095 + 0.30 * np.clip(v - 0.20, 0.0, 2.0) ** 1.25
    light = 1.08 - 0.55 * (u / half) ** 2 - 0.22 * (u / half) + 0.035 * hair
    lay(
        rgb, cover, light[..., None] * _COAT, within(half - np.abs(u), rows) * (v > 0.2)
    )
    poll = 1.0 - np.hypot(u / 0.10, (v - 0.225) / 0.075)
    shade = (1.02 - 0.5 * (u / 0.11) ** 2 + 0.03 * hair)[..., None] * _COAT
    lay(rgb, cover, shade, within(0.08 * poll, rows))
    for side in (-1.0, 1.0):
        _ear(rgb, cover, side * u, v, rows)
    _mane(rgb, cover, u, v, hair)
    return Painted(rgb, cover, spare)


def _ear(rgb: Floats32, cover: Floats32, u: Floats32, v: Floats32, rows: int) -> None:
    """Paint a pointed ear that leans outwards, dark inside."""
    along = (0.21 - v) / 0.19  # 0 at its root, 1 at its tip
    middle = 0.060 + 0.028 * along
    half = (
        0.036
        * np.sqrt(np.clip(along * (1.0 - along), 0.0, 1.0))
        * 2.0
        * (1.15 - 0.5 * along)
    )
    inside = (half - np.abs(u - middle)) * (along > 0.0)
    light = 1.1 - 9.0 * np.abs(u - middle - 0.004)
    lay(rgb, cover, light[..., None] * _COAT, within(inside, rows) * (half > 0.0))
    hollow = 0.55 * half - np.abs(u - middle - 0.003)
    lay(
        rgb,
        cover,
        0.6 * light[..., None] * _COAT,
        0.8 * within(hollow, rows) * (half > 0.004),
    )


def _mane(
    rgb: Floats32, cover: Floats32, u: Floats32, v: Floats32, hair: Floats32
) -> None:
    """Paint the mane: strands that fall to the right of the crest."""
    down = np.clip(v - 0.14, 0.0, 2.0)
    edge = 0.012 + 0.16 * down + 0.011 * hair * (0.4 + down)
    start = -0.018 - 0.03 * down + 0.004 * hair
    cut = np.clip((edge - u) * 90.0, 0.0, 1.0) * np.clip((u - start) * 140.0, 0.0, 1.0)
    over = cut * np.clip((v - 0.125) * 40.0, 0.0, 1.0)
    light = 1.0 + 0.30 * hair + 2.2 * np.clip(0.06 - np.abs(u - 0.03), 0.0, 1.0)
    lay(
        rgb,
        cover,
        np.clip(light, 0.2, 3.0)[..., None] * _DARK,
        np.asarray(over, np.float32),
    )


def _rein(rgb: Floats32, cover: Floats32, u: Floats32, v: Floats32, rows: int) -> None:
    """Paint a rein from the bit up to the hand at the lower edge."""
    middle = 0.11 + 0.30 * np.clip((v - 0.28) / 0.75, 0.0, 2.0) ** 0.8
    half = 0.008 + 0.008 * v
    light = 1.0 + 0.7 * np.clip(1.0 - np.abs(u - middle + 0.3 * half) / half, 0.0, 1.0)
    over = within(half - np.abs(u - middle), rows) * (v > 0.27)
    lay(rgb, cover, light[..., None] * _LEATHER, over)
