"""AHAP: the size of the force and its frequency."""

import json

import numpy as np

from hapticplayer.model import ForceTrack


def test_an_ahap_has_the_size_of_the_force(written):
    content = json.loads(written("ahap").read_text())
    curves = [
        one["ParameterCurve"] for one in content["Pattern"] if "ParameterCurve" in one
    ]
    scale_n = float(content["Metadata"]["Description"].split()[-1])
    points = [
        (curve["Time"] + one["Time"], one["ParameterValue"] * scale_n)
        for curve in curves
        if curve["ParameterID"] == "HapticIntensityControl"
        for one in curve["ParameterCurveControlPoints"]
    ]
    size_n = np.interp([0.25, 0.5, 0.75], *zip(*points, strict=True))
    whole_n = np.sqrt(14.0)
    np.testing.assert_allclose(size_n, [whole_n / 2, whole_n, whole_n / 2], atol=0.011)
    assert all(len(one["ParameterCurveControlPoints"]) <= 16 for one in curves)


def test_faster_force_is_sharper(written, tmp_path):
    values = []
    for hertz in (2.0, 20.0):
        wave = np.sin(2.0 * np.pi * hertz * np.arange(3000) / 1000.0)
        track = ForceTrack(np.arange(3000) / 1000.0, np.outer(wave, [0, 2, 0]))
        path = written("ahap", track)
        curves = [
            one.get("ParameterCurve", {})
            for one in json.loads(path.read_text())["Pattern"]
        ]
        sharp = next(
            c for c in curves if c.get("ParameterID") == "HapticSharpnessControl"
        )
        values.append(sharp["ParameterCurveControlPoints"][0]["ParameterValue"])
        path.unlink()
    np.testing.assert_allclose(values, np.log10([2.0, 20.0]) / 2.0, atol=0.03)
