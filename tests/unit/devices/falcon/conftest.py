"""Simulated Falcons under the real pyusb, in virtual time."""

import json
import random

import pytest

from hapticplayer.devices.falcon.firmware import MemoryBlock, build_image, parse_image


@pytest.fixture(scope="session")
def golden(shared_data):
    """Reference values that were computed before this package was written."""
    return json.loads((shared_data / "falcon" / "golden.json").read_text())


@pytest.fixture(scope="session")
def image():
    """A synthetic program of about a tenth of the real ones' length."""
    random_words = random.Random(1)
    words = tuple(random_words.randrange(0x10000) for _ in range(400))
    return parse_image(
        build_image(
            0x3F8002, (MemoryBlock(0x3F8002, words), MemoryBlock(0x93A2, (1, 0, 0, 2)))
        )
    )


@pytest.fixture
def bench(image):
    """A Falcon that was just plugged in."""
    from tests.unit.devices.falcon.bench import Bench

    return Bench(image)


@pytest.fixture
def running(image):
    """A Falcon whose firmware runs."""
    from tests.unit.devices.falcon.bench import Bench, Stage

    return Bench(image, Stage.RUNNING)
