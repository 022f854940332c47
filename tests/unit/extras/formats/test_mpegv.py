"""MPEG-V: newtons, times, groups and references, and what others write."""

import re

import numpy as np
import pytest

from hapticplayer.errors import InputError, from_json
from hapticplayer.model import ForceTrack, MotionTrack
from hapticplayer.sequence.force_files import WriteChoices
from hapticplayer.sequence.force_formats import (
    export_track,
    force_formats,
    read_force,
)
from tests.unit.extras.formats.conftest import at

SEM = (
    '<SEM xmlns="urn:mpeg:mpeg-v:2010:01-SEDL-NS" '
    'xmlns:sev="urn:mpeg:mpeg-v:2010:01-SEV-NS" '
    'xmlns:si="urn:mpeg:mpeg21:2003:01-DIA-XSI-NS" '
    'xmlns:mpeg7="urn:mpeg:mpeg7:schema:2004" '
    'xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" si:timeScale="1000">{}</SEM>'
)


def test_mpegv_holds_newtons_and_milliseconds(written):
    text = written("mpegv").read_text()
    assert 'si:timeScale="1000"' in text
    assert 'xsi:type="sev:PassiveKinestheticForceType" si:pts="0"' in text
    assert "1.0000 2.0000 -3.0000" in text


def test_mpegv_is_valid_by_the_schema_of_2010(written, shared_data):
    etree = pytest.importorskip("lxml.etree")
    schema = shared_data / "interchange" / "mpegv-2010" / "MPEG-V-SEV.xsd"
    if not schema.is_file():
        pytest.skip("the schema (interchange/mpegv-2010) is not in the shared data")
    parser = etree.XMLParser(no_network=True, resolve_entities=False)
    rules = etree.XMLSchema(etree.parse(str(schema), parser))
    path = written("mpegv", motion=moving((1, 2, 3)))
    assert rules.validate(etree.parse(str(path), parser))


def test_mpegv_effects_of_others_are_read_and_the_rest_is_listed(read):
    effects = (
        '<Effect xsi:type="sev:PassiveKinestheticForceType" si:pts="1000" '
        'duration="100" timeSamples="3"><sev:PassiveKinestheticForce mpeg7:dim="3 3">'
        "0 2 0 0 4 0 0 0 0</sev:PassiveKinestheticForce></Effect>"
        '<GroupOfEffects><Effect xsi:type="sev:ActiveKinestheticType" si:pts="2000" '
        'duration="100"><sev:ActiveKinesthetic fx="1" fy="-1.5" fz="0.5"/></Effect>'
        '<Effect xsi:type="sev:WindType" si:pts="0" duration="10"/></GroupOfEffects>'
    )
    found = read(SEM.format(effects), ".sem")
    np.testing.assert_allclose(at(found.track, 1.0, 1.025, 1.075)[:, 1], [2, 3, 2])
    np.testing.assert_allclose(at(found.track, 2.05)[0], [1, -1.5, 0.5])
    assert [str(note) for note in found.notes] == ["not read: Wind (1)"]


def test_mpegv_motion_and_vibration_become_force(read):
    effects = (
        '<Effect xsi:type="sev:RigidBodyMotionType" si:pts="0" duration="1000">'
        '<sev:MoveToward directionH="0" directionV="0" acceleration="2.5"/></Effect>'
        '<Effect xsi:type="sev:VibrationType" si:pts="2000" duration="1000" '
        'intensity-value="50" intensity-range="0 100"/>'
    )
    found = read(SEM.format(effects), ".xml", full_scale_n=2.0)
    np.testing.assert_allclose(at(found.track, 0.5)[0], [0, 0, -1.0], atol=1e-6)
    assert np.abs(found.track.force_n[:, 1]).max() == pytest.approx(1.0, abs=1e-3)


HALF = 'intensity-value="50" intensity-range="0 100"'


def shake(more="", begin=0, length=1000, level=HALF):
    timed = f'duration="{length}"' if length else ""
    when = "" if begin is None else f'si:pts="{begin}"'
    return f'<Effect xsi:type="sev:VibrationType" {when} {timed} {level} {more}/>'


def felt(track, *spans_s):
    """Largest force in spans of media time."""
    return [
        np.abs(track.at(np.arange(begin_s, end_s, 0.001))).max()
        for begin_s, end_s in spans_s
    ]


def test_durations_of_playsem_are_seconds(read):
    pair = (
        shake('activate="true"', 900_000, 0, 'intensity-value="100"')
        + shake('activate="false"', 1_080_000, 0, "")
    )  # fmt: skip
    text = SEM.format(shake('activate="true"', 90_000, 3) + pair)
    found = read(text.replace('"1000">', '"90000">'), ".sem")
    spans = [(0, 1), (1, 4), (4.001, 10), (10, 12), (12.001, 14)]
    np.testing.assert_allclose(felt(found.track, *spans), [0, 0.5, 0, 1, 0], atol=1e-3)
    assert "seconds" in str(found.assumed[0])
    assert found.unread == ()


@pytest.mark.parametrize("scale", [1000, 90_000])
def test_durations_of_the_standard_are_ticks(read, scale):
    effects = shake(begin=scale, length=scale // 2) + shake(
        begin=3 * scale, length=scale
    )
    found = read(SEM.format(effects).replace('"1000">', f'"{scale}">'), ".sem")
    spans = [(0, 1), (1, 1.5), (1.501, 3), (3, 4), (4.001, 5)]
    np.testing.assert_allclose(
        felt(found.track, *spans), [0, 0.5, 0, 0.5, 0], atol=1e-3
    )
    assert len(found.notes) == 1


def test_short_taps_that_follow_each_other_are_ticks(read):
    taps = "".join(shake(begin=500 * row, length=15) for row in range(4))
    found = read(SEM.format(taps), ".sem")
    assert felt(found.track, (0.016, 0.5), (0.516, 1.0)) == [0.0, 0.0]
    assert felt(found.track, (1.5, 1.515))[0] > 0.4


def test_an_effect_lasts_until_the_next_of_its_kind(read):
    effects = (
        shake('activate="true"', 1000, 0)
        + shake('activate="true"', 2000, 0, 'intensity-value="100"')
        + '<Effect xsi:type="sev:WindType" si:pts="2500" duration="100"/>'
        + shake('activate="false"', 3000, 0, "")
    )
    found = read(SEM.format(effects), ".sem")
    spans = [(0, 1), (1, 2), (2, 3), (3.001, 4)]
    np.testing.assert_allclose(felt(found.track, *spans), [0, 0.5, 1, 0], atol=1e-3)
    assert [str(note) for note in found.unread] == ["not read: Wind (1)"]


def test_an_effect_without_an_end_lasts_as_long_as_the_clip(read):
    text = SEM.format(shake(length=100) + shake('activate="true"', 1000, 0))
    found = read(text, ".sem")
    assert [str(note) for note in found.unread] == [
        "not read: Vibration without an end (1)"
    ]
    assert felt(found.track, (0.2, 5)) == [0.0]
    found = read(text, ".sem", until_s=5.0)
    assert found.unread == ()
    assert felt(found.track, (4, 5))[0] == pytest.approx(0.5, abs=1e-3)


def test_an_effect_that_is_not_active_is_not_felt(read):
    effects = shake() + shake('activate="false"', 5000, 1000)
    found = read(SEM.format(effects), ".sem")
    assert felt(found.track, (1.001, 9)) == [0.0]
    with pytest.raises(InputError, match="activate must be true or false"):
        read(SEM.format(shake('activate="maybe"')), ".sem")


def test_switching_off_without_a_place_ends_all_of_its_kind(read):
    left, right = (f'activate="true" location="{side}"' for side in ("left", "right"))
    effects = (
        shake(left, 0, 0)
        + shake(right, 500, 0)
        + shake('activate="false"', 2000, 0, "")
    )
    found = read(SEM.format(effects), ".sem")
    spans = [(0, 0.5), (1, 2), (2.001, 9)]
    np.testing.assert_allclose(felt(found.track, *spans), [0.5, 1.0, 0.0], atol=1e-3)
    one = shake(left, 0, 0) + shake(right, 500, 0)
    one += shake('activate="false" location="left"', 2000, 0, "")
    one += shake('activate="false" location="right"', 3000, 0, "")
    found = read(SEM.format(one), ".sem")
    spans = [(1, 2), (2.001, 3), (3.001, 9)]
    np.testing.assert_allclose(felt(found.track, *spans), [1.0, 0.5, 0.0], atol=1e-3)


def test_a_vibration_without_an_intensity_is_listed(read):
    (note,) = read(SEM.format(shake(level="") + shake(begin=2000)), ".sem").unread
    assert "vibration without an intensity (1)" in str(note)


def test_times_without_a_scale_are_said_to_be_milliseconds(read):
    found = read(
        SEM.format(shake(begin=2000)).replace('si:timeScale="1000"', ""), ".sem"
    )
    assert "times were taken as milliseconds" in map(str, found.assumed)
    assert felt(found.track, (2, 3))[0] > 0.4


def test_switching_off_ends_a_duration(read):
    effects = shake(length=5000) + shake('activate="0"', 1000, 0)
    found = read(SEM.format(effects), ".sem")
    np.testing.assert_allclose(
        felt(found.track, (0, 1), (1.001, 5)), [0.5, 0.0], atol=1e-3
    )


@pytest.mark.parametrize(
    ("level", "share"),
    [
        ('intensity-value="0.5" intensity-range="0.0 1.0"', 0.5),
        ('intensity-value="5" intensity-range="0 10"', 0.5),
        ('intensity-value="-15" intensity-range="-30 30"', 0.5),
        ('intensity-value="75" intensity-range="50 100"', 0.5),
        ('intensity-value="300" intensity-range="0 255"', 1.0),
        ('intensity-value="50"', 0.5),
        ('intensity="25" intensity-range="0 1e2"', 0.25),
    ],
)
def test_an_intensity_is_a_share_of_its_range(read, level, share):
    found = read(SEM.format(shake(level=level)), ".sem")
    assert felt(found.track, (0, 1))[0] == pytest.approx(share, abs=1e-3)


def test_an_intensity_beyond_its_range_is_limited_and_said(read):
    most = 'intensity-value="150" intensity-range="0 100"'
    found = read(SEM.format(shake(level=most)), ".sem")
    assert np.abs(found.track.force_n).max() == pytest.approx(1.0, abs=1e-3)
    assert "beyond their range" in " ".join(map(str, found.notes))


def test_a_refusal_of_mpegv_names_what_was_not_understood(read):
    with pytest.raises(InputError, match=r"not read: Vibration without an end \(1\)"):
        read(SEM.format(shake(length=0)), ".sem")


def test_an_attribute_that_is_no_number_is_named(read):
    with pytest.raises(InputError, match="duration must be a number, not 'PT2S'"):
        read(SEM.format(shake(length="PT2S")), ".sem")


@pytest.mark.parametrize(
    "level",
    [
        'intensity-value="1_0"',
        'intensity-value="1j"',
        'intensity-value="1e400"',
        'intensity-value="5" intensity-range="100 0"',
        'intensity-value="5" intensity-range="0"',
        'intensity-value="5" intensity-range="a b"',
        'intensity-value="5" intensity-range="0 nan"',
    ],
)
def test_an_intensity_that_is_no_number_is_refused(read, level):
    with pytest.raises(InputError, match=r"intensity-(value|range) (is out|must be)"):
        read(SEM.format(shake(level=level)), ".sem")


def test_a_fade_rises_to_the_level(read):
    constant = (
        '<Effect xsi:type="sev:ActiveKinestheticType" si:pts="0" duration="1000" '
        'fade="400" ><sev:ActiveKinesthetic fx="1"/></Effect>'
    )
    force_n = at(read(SEM.format(constant), ".sem").track, 0.1, 0.2, 0.4, 0.9)[:, 0]
    np.testing.assert_allclose(force_n, [0.25, 0.5, 1, 1], atol=1e-4)


def test_a_fade_from_level_to_level_and_to_nothing(read):
    effects = (
        shake('activate="true"', 0, 0, 'intensity-value="40"')
        + shake('activate="true" fade="1000"', 1000, 0, 'intensity-value="80"')
        + shake('activate="false" fade="500"', 3000, 0, "")
    )
    found = read(SEM.format(effects), ".sem")
    spans = [(0, 1), (1, 1.02), (1.48, 1.52), (2, 3), (3.24, 3.26), (3.501, 4)]
    wanted = [0.4, 0.4, 0.6, 0.8, 0.4, 0.0]
    np.testing.assert_allclose(felt(found.track, *spans), wanted, atol=0.03)


def test_a_group_gives_its_time_to_its_effects(read):
    group = (
        '<GroupOfEffects si:pts="5000" duration="2000" fade="1000">'
        f"{shake(begin=None, length=0)}{shake(begin=9000, length=500)}</GroupOfEffects>"
    )
    found = read(SEM.format(group), ".sem")
    spans = [(0, 5), (5.48, 5.52), (6, 7), (7.001, 9)]
    np.testing.assert_allclose(felt(found.track, *spans), [0, 0.25, 0.5, 0], atol=0.03)
    assert felt(found.track, (9, 9.5))[0] > 0.2
    assert found.unread == ()


@pytest.mark.parametrize(("first", "second"), [(0, 1000), (10, 1010), (0, 4000)])
def test_times_before_that_of_the_group_count_from_it(read, first, second):
    both = shake(begin=first, length=500) + shake(begin=second, length=500)
    group = f'<GroupOfEffects si:pts="5000">{both}</GroupOfEffects>'
    found = read(SEM.format(group), ".sem")
    begins_s = [5.0 + first / 1000.0, 5.0 + second / 1000.0]
    spans = [(0, 5), *((one + 0.02, one + 0.5) for one in begins_s), (9.5, 12)]
    np.testing.assert_allclose(felt(found.track, *spans), [0, 0.5, 0.5, 0], atol=1e-3)
    assert "times before that of their group" in " ".join(map(str, found.assumed))


def test_one_time_before_that_of_the_group_is_not_read(read):
    both = shake(begin=10) + shake(begin=6000)
    group = f'<GroupOfEffects si:pts="5000">{both}</GroupOfEffects>'
    found = read(SEM.format(group), ".sem")
    np.testing.assert_allclose(felt(found.track, (0, 6), (6, 7)), [0, 0.5], atol=1e-3)
    (note,) = found.unread
    assert "a time before that of its group (1)" in str(note)


@pytest.mark.parametrize(
    ("declared", "first", "second"),
    [("", 0, 1000), ('si:pts="0"', 0, 1000), ('si:pts="3000"', 3000, 4000)],
)
@pytest.mark.parametrize("scale", [1000, 90_000])
def test_a_declared_group_is_played_at_its_reference(
    read, declared, first, second, scale
):
    both = shake(begin=first, length=500) + shake(begin=second, length=500)
    text = SEM.format(
        f'<Declarations><GroupOfEffects id="g" {declared}>{both}</GroupOfEffects>'
        '</Declarations><ReferenceEffect uri="#g" si:pts="5000"/>'
        '<GroupOfEffects si:pts="8000"><ReferenceEffect uri="#g"/></GroupOfEffects>'
    )
    factor = scale // 1000
    text = re.sub(
        '(pts|duration|timeScale)="([0-9]+)"',
        lambda m: f'{m[1]}="{int(m[2]) * factor}"',
        text,
    )
    found = read(text, ".sem")
    spans = [(0, 5), (5, 5.5), (5.501, 6), (6, 6.5), (6.501, 8), (8, 8.5), (9, 9.5)]
    wanted = [0, 0.5, 0, 0.5, 0, 0.5, 0.5]
    np.testing.assert_allclose(felt(found.track, *spans), wanted, atol=1e-3)
    assert found.unread == ()


def test_a_declared_effect_in_a_group_has_its_time(read):
    one = shake('id="buzz"', 700, 400)
    text = SEM.format(
        f"<Declarations>{one}</Declarations>"
        '<GroupOfEffects si:pts="3000"><ReferenceEffect uri="#buzz"/></GroupOfEffects>'
    )
    found = read(text, ".sem")
    spans = [(0, 3), (3, 3.4), (3.401, 9)]
    np.testing.assert_allclose(felt(found.track, *spans), [0, 0.5, 0], atol=1e-3)


def test_an_effect_without_any_time_is_said_to_begin_at_0(read):
    found = read(SEM.format(shake(begin=None)), ".sem")
    assert "effects without a time begin at 0 s" in map(str, found.assumed)
    assert felt(found.track, (0, 1))[0] == pytest.approx(0.5, abs=1e-3)


def test_a_reference_plays_what_was_declared_at_its_own_time(read):
    one = shake('id="buzz"', 700, 400)
    text = SEM.format(
        f"<Declarations>{one}</Declarations>"
        '<ReferenceEffect uri="#buzz" si:pts="2000"/>'
        '<ReferenceEffect uri="#buzz" si:pts="4000" duration="1000"/>'
        '<ReferenceEffect uri="http://127.0.0.1/other.sem#buzz2" si:pts="9000"/>'
    )
    found = read(text, ".sem")
    spans = [(0, 2), (2, 2.4), (2.401, 4), (4, 5), (5.001, 7)]
    np.testing.assert_allclose(
        felt(found.track, *spans), [0, 0.5, 0, 0.5, 0], atol=1e-3
    )
    assert [str(note) for note in found.unread] == ["not read: ReferenceEffect (1)"]


def test_references_in_a_circle_are_refused(read):
    ring = '<GroupOfEffects id="a"><ReferenceEffect uri="#a"/></GroupOfEffects>'
    text = SEM.format(
        f'<Declarations>{ring}</Declarations><ReferenceEffect uri="#a" si:pts="0"/>'
    )
    with pytest.raises(InputError, match="too many values"):
        read(text, ".sem")


@pytest.mark.parametrize("old", ["si:pts", "si:timeScale"])
def test_a_time_without_its_prefix_counts(read, old):
    text = SEM.format(shake(begin=2000, length=500)).replace(old, old[3:])
    found = read(text, ".sem")
    assert felt(found.track, (0, 2)) == [0.0]
    assert felt(found.track, (2, 2.5))[0] == pytest.approx(0.5, abs=1e-3)


OTHER_TIMES = ("ptsDelta", "absTime", "absTimeDelta", "relTime", "start", "begin")


@pytest.mark.parametrize("name", OTHER_TIMES)
@pytest.mark.parametrize("of", ["Effect", "GroupOfEffects", "ReferenceEffect", "SEM"])
def test_another_time_base_is_listed_and_not_felt(read, name, of):
    prefix = "si:" if "ime" in name or name == "ptsDelta" else ""
    timed = f'{prefix}{name}="3000"'
    later = {
        "Effect": shake(timed, begin=None),
        "GroupOfEffects": f"<GroupOfEffects {timed}>{shake()}</GroupOfEffects>",
        "ReferenceEffect": f'<ReferenceEffect uri="#buzz" {timed}/>',
        "SEM": "",
    }[of]
    buzz = shake('id="buzz"')
    text = f"<Declarations>{buzz}</Declarations>"
    text = SEM.format(text + shake(begin=6000) + later)
    if of == "SEM":
        text = text.replace("si:timeScale", f"{timed} si:timeScale")
    found = read(text, ".sem")
    assert felt(found.track, (0, 6), (6, 7)) == pytest.approx([0.0, 0.5], abs=1e-3)
    assert f"{of} with another time (1)" in str(found.unread[0])


@pytest.mark.parametrize("words", ["1 2 3 4", "1 2 x", "1 2 1_0", "1 2 3j", "1 2 nan"])
def test_a_matrix_of_other_words_is_refused(read, words):
    matrix = (
        '<Effect xsi:type="sev:PassiveKinestheticForceType" si:pts="0" duration="9">'
        f"<sev:PassiveKinestheticForce>{words}</sev:PassiveKinestheticForce></Effect>"
    )
    with pytest.raises(InputError, match="three numbers a row"):
        read(SEM.format(matrix), ".sem")


def test_a_matrix_that_lies_on_its_side_is_refused(written, read):
    text = written("mpegv").read_text()
    rows = re.search(r'dim="(\d+) 3"', text)[1]
    turned = text.replace(f'dim="{rows} 3"', f'dim="3 {rows}"')
    assert read(text, ".sem").track.peak_n() > 1.0
    with pytest.raises(InputError, match="three numbers a row"):
        read(turned, ".sem")


def test_effects_without_a_namespace_are_read(read):
    found = read(
        '<SEM><SensoryEffects><Effect type="vibration" timestamp="1500" '
        'duration="700" intensity="50" location="center"/>'
        '<Effect type="wind" timestamp="0" duration="10" intensity="60"/>'
        "</SensoryEffects></SEM>",
        ".xml",
        full_scale_n=2.0,
    )
    np.testing.assert_allclose(at(found.track, 1.4, 2.3), np.zeros((2, 3)))
    assert np.abs(found.track.force_n[:, 1]).max() == pytest.approx(1.0, abs=1e-3)
    assert str(found.notes[-1]) == "not read: Wind (1)"


def moving(acceleration_mps2, valid=True):
    rows = np.tile(np.asarray(acceleration_mps2, dtype=float), (201, 1))
    return MotionTrack(
        time_s=np.arange(201) / 200.0,
        acceleration_mps2=rows,
        gravity_mps2=np.zeros((201, 3)),
        accelerometer_gain=1.0,
        quaternion_wxyz=np.tile([1.0, 0.0, 0.0, 0.0], (201, 1)),
        gravity_sigma_mps2=None,
        valid=np.full(201, valid),
    )


NO_FORCE = ForceTrack([0.0, 1.0], np.zeros((2, 3)))


@pytest.mark.parametrize("way", [(0, 2, 0), (1, 0, 0), (0, 0, -3), (-1, -2, 1.5)])
def test_mpegv_motion_is_the_acceleration_of_the_actor(written, read, way):
    text = written("mpegv", NO_FORCE, motion=moving(way)).read_text()
    alone = SEM.format("".join(re.findall("<Effect.*RigidBody.*</Effect>", text)))
    force_n = at(read(alone, ".sem").track, 0.01, 0.5, 0.99)
    right, front, up = 0.4 * np.array(way)
    np.testing.assert_allclose(force_n, [[right, up, -front]] * 3, atol=0.02)
    assert text.count("MoveToward") == 20


def test_motion_beside_a_force_adds_nothing_to_it(written, read):
    plain = written("mpegv").read_bytes()
    path = written("mpegv", motion=moving((0, 2, 0)), overwrite=True)
    both = read_force(path)
    assert b"RigidBodyMotion" in path.read_bytes()
    np.testing.assert_array_equal(both.track.force_n, read(plain, ".sem").track.force_n)
    assert "left out (20)" in str(both.notes[0])


@pytest.mark.parametrize("motion", [moving((0, 0, 0)), moving((1, 2, 3), False)])
def test_motion_that_is_still_or_invalid_is_not_written(written, motion):
    assert "Rigid" not in written("mpegv", motion=motion).read_text()


@pytest.mark.parametrize("valid", [True, False])
def test_motion_that_is_not_valid_is_said_to_be_left_out(tmp_path, valid):
    choices = WriteChoices(motion=moving((1, 2, 3), valid))
    form = force_formats()["mpegv"]
    report = export_track(NO_FORCE, tmp_path / "a.sem", form, choices)
    said = [str(from_json(one)) for one in report["left_out"]]
    assert said[0] == "rotations, and what of the motion changes within 50 ms"
    assert said[1:] == [] if valid else ["the motion where it is not valid"]


def test_more_motion_than_is_read_is_refused(written, monkeypatch):
    monkeypatch.setattr("hapticplayer.extras.formats.mpegv.MAX_TAGS", 60)
    with pytest.raises(InputError, match="too long"):
        written("mpegv", motion=moving((0, 2, 0)))


@pytest.mark.parametrize(
    "head",
    [
        '<!DOCTYPE a [<!ENTITY b "c">]>',
        '<!DOCTYPE a SYSTEM "http://127.0.0.1/x.dtd">',
        '<!DOCTYPE a [<!ENTITY b SYSTEM "file:///etc/passwd">]>',
    ],
)
def test_xml_with_a_document_type_is_refused(read, head):
    with pytest.raises(InputError, match="not valid XML"):
        read(head + SEM.format(""), ".xml")


PRIORITY, NAMED = "priority='2'", "id='a' xml:lang='de'"


def test_an_attribute_that_is_not_read_is_listed(read):
    move = (
        '<Effect xsi:type="sev:RigidBodyMotionType" si:pts="0" duration="900">'
        '<sev:MoveToward directionH="0" acceleration="2.5" speed="3"/></Effect>'
    )
    plain = (
        f'<GroupOfEffects si:pts="9000" wobble="1">{shake(PRIORITY)}'
        f"</GroupOfEffects>{shake(NAMED)}{move}"
    )
    found = read(SEM.format(plain).replace("<SEM ", '<SEM puMode="ancestors" '), ".sem")
    assert {str(note) for note in found.unread} == {
        "not read: wobble of GroupOfEffects (1)",
        "not read: priority of Effect (1)",
        "not read: speed of MoveToward (1)",
        "not read: puMode of SEM (1)",
    }


@pytest.mark.parametrize("given", ["٣", "1_0", "x", "1e400"])
def test_a_number_in_other_digits_is_refused(read, given):
    with pytest.raises(InputError, match=r"must be a number|out of range"):
        read(SEM.format(shake(f'fade="{given}"')), ".sem")


@pytest.mark.parametrize(("count", "is_said"), [("3", False), ("7", True), ("x", True)])
def test_a_number_of_samples_that_is_not_the_rows_is_said(read, count, is_said):
    force = (
        '<Effect xsi:type="sev:PassiveKinestheticForceType" si:pts="0" duration="100" '
        f'timeSamples="{count}"><sev:PassiveKinestheticForce mpeg7:dim="3 3">'
        "0 2 0 0 4 0 0 0 0</sev:PassiveKinestheticForce></Effect>"
    )
    found = read(SEM.format(force), ".sem")
    np.testing.assert_allclose(at(found.track, 0.025)[:, 1], [3])
    assert any("timeSamples" in note for note in found.assumed) == is_said
