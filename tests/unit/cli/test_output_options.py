"""`--device` may be there several times."""

import argparse

import pytest

from hapticplayer.cli.common import add_outputs


def parsed(*words):
    parser = argparse.ArgumentParser()
    add_outputs(parser)
    options = parser.parse_args([part for w in words for part in ("--device", w)])
    return options.outputs


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ((), ("simulated",)),
        (("none",), ()),
        (("falcon:12AB",), ("falcon:12AB",)),
        (("falcon", "simulated"), ("falcon", "simulated")),
    ],
)
def test_outputs_keep_their_order_and_the_first_leads(words, expected):
    assert parsed(*words) == expected


@pytest.mark.parametrize(
    ("words", "why"),
    [
        (("chair",), "not a device"),
        (("simulated:3",), "nothing but gain= can follow"),
        (("falcon", "falcon"), "appears twice"),
        (("falcon", "none"), "means no device at all"),
        (("none", "falcon"), "means no device at all"),
    ],
)
def test_a_device_that_cannot_be_played_on_is_wrong_usage(words, why, capsys):
    with pytest.raises(SystemExit) as end:
        parsed(*words)
    assert end.value.code == 2
    assert why in capsys.readouterr().err
