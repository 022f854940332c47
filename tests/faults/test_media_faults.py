"""A named part of what benchmarks/robust.py plays: damaged files of five kinds."""

import media_cases as cases
import pytest

MUTATIONS = 25


@pytest.fixture(scope="module", params=cases.CONTAINERS)
def clip(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp("whole")
    return request.param, cases.make_clip(folder, request.param)


def test_a_whole_file_is_played_and_not_marked(clip):
    assert cases.play(clip[1]) == (cases.PICTURES, False)


def test_damaged_files_neither_crash_nor_hang_and_lost_pictures_are_marked(
    clip, tmp_path
):
    container, whole = clip
    content, path = whole.read_bytes(), tmp_path / f"damaged.{container}"
    kinds = set()
    for number in range(MUTATIONS):
        path.write_bytes(cases.mutation(content, container, number))
        outcome = cases.play_in_child(path)
        assert outcome.kind in {"played", "refused"}, (number, outcome)
        assert outcome.extra_bytes <= cases.EXTRA_BYTES
        assert outcome.kind == "played" or outcome.text
        if outcome.kind == "played" and outcome.pictures < cases.PICTURES:
            assert outcome.is_marked, (number, outcome)
        kinds.add(outcome.kind)
    assert kinds == {"played", "refused"}
