"""Orders: what a design promises is counted, not trusted."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hapticplayer.errors import StudyError
from hapticplayer.study.creation import change_definition, definition_text
from hapticplayer.study.definition_reader import parse_definition
from hapticplayer.study.order_list import read_orders
from hapticplayer.study.orders import (
    assign,
    balance_of,
    cyclic_square,
    first_repeat,
    random_order,
    rows_of,
    williams_design,
)
from hapticplayer.study.plan import LETTERS, checked_code, new_code, number_of
from hapticplayer.study.study_folder import begin_session, drop_session, open_study

codes = st.text(alphabet=LETTERS, min_size=6, max_size=6)


def with_order(template, **changes):
    template["order"].update(changes)
    return parse_definition(definition_text(template), "study.json")


@given(st.integers(2, 30))
def test_a_williams_design_balances_neighbouring_pairs(count):
    rows = williams_design(count)
    times = 1 if count % 2 == 0 else 2
    assert len(rows) == count * times
    pairs = [pair for row in rows for pair in itertools.pairwise(row)]
    wanted = set(itertools.permutations(range(count), 2))
    assert set(pairs) == wanted
    assert len(pairs) == times * len(wanted)
    for position in range(count):
        column = sorted(row[position] for row in rows)
        assert column == sorted(list(range(count)) * times)


@given(st.integers(2, 30))
def test_a_latin_square_has_each_condition_once_in_each_place(count):
    square = np.array(cyclic_square(count))
    assert all(len(set(line)) == count for line in (*square, *square.T))


def test_twelve_williams_participants_are_balanced(template):
    study = with_order(template, method="williams")
    rows, used = [], []
    for number in range(12):
        made = assign(study, LETTERS[number] * 6, used)
        rows.append(made.conditions)
        used.append(made.row)
    balance = balance_of(study, rows)
    assert (balance.at_position == 1).all()
    off_diagonal = ~np.eye(12, dtype=bool)
    assert (balance.followed[off_diagonal] == 1).all()
    assert (np.diag(balance.followed) == 0).all()


def test_the_row_of_one_who_dropped_out_is_given_again(template, study, manual_clock):
    template.update(id=study.definition.id)
    template["order"]["method"] = "williams"
    study = change_definition(study, template)
    first = [begin_session(study, "en", {}, manual_clock) for _ in range(5)]
    assert sorted(s.plan.row for s in first) == [0, 1, 2, 3, 4]
    drop_session(study, first[2].code, "felt sick", manual_clock)
    rest = [begin_session(study, "en", {}, manual_clock) for _ in range(8)]
    assert sorted(s.plan.row for s in rest) == [2, 5, 6, 7, 8, 9, 10, 11]
    balance = study.balance()
    assert (balance.at_position == 1).all()


@given(codes)
@settings(max_examples=30)
def test_a_random_order_is_found_again_from_seed_and_code(code):
    from hapticplayer.study.creation import TEMPLATES

    study = parse_definition((TEMPLATES / "qoe2012.json").read_bytes(), "t")
    order = random_order(study, code)
    assert sorted(c.key for c in order) == sorted(c.key for c in study.conditions)
    assert order == random_order(study, code)


def test_random_orders_are_uniform_over_places(template):
    study = with_order(template, method="random")
    rng = np.random.default_rng(1)
    made = [
        random_order(study, "".join(rng.choice(list(LETTERS), 6))) for _ in range(1200)
    ]
    counts = balance_of(study, made).at_position
    # 1200 orders put 100 +- 9.6 of each condition at each place
    chi2 = ((counts - 100.0) ** 2 / 100.0).sum()
    assert 70.0 < chi2 < 190.0  # 121 degrees of freedom: 5 sigma are 43 to 199
    assert len(set(made)) == len(made)


@pytest.mark.parametrize("method", ["random", "latin-square"])
def test_no_sequence_comes_twice_in_a_row_where_that_is_asked(template, method):
    study = with_order(template, method=method, no_sequence_twice_in_a_row=True)
    orders = (
        rows_of(study)
        if method == "latin-square"
        else [random_order(study, letter * 6) for letter in LETTERS]
    )
    for order in orders:
        assert first_repeat(order) is None
        assert all(a.sequence != b.sequence for a, b in itertools.pairwise(order))


def test_a_constraint_that_cannot_be_met_is_refused(template):
    template["sequences"] = template["sequences"][:2]
    template["sequences"][0]["key"] = "only"
    template["feedbacks"] = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l"]
    study = with_order(template, no_sequence_twice_in_a_row=True)
    with pytest.raises(StudyError, match="twice in a row"):
        random_order(study, "CCCCCC")


def write_orders(path, definition, count=3):
    lines = ["order,position,sequence,feedback"]
    for number in range(count):
        conditions = definition.conditions[number:] + definition.conditions[:number]
        lines += [
            f"{number + 1},{place + 1},{c.sequence},{c.feedback}"
            for place, c in enumerate(conditions)
        ]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return lines


def test_orders_made_elsewhere_are_given_in_turn(template, study, manual_clock):
    template.update(id=study.definition.id)
    template["order"]["method"] = "list"
    study = change_definition(study, template)
    write_orders(study.folder / "orders.csv", study.definition)
    made = [begin_session(study, "en", {}, manual_clock) for _ in range(4)]
    assert [s.plan.row for s in made] == [0, 1, 2, 0]
    assert made[1].plan.order[0] == study.definition.conditions[1]
    assert open_study(study.folder).listed_orders()


@pytest.mark.parametrize(
    ("line", "text", "reported"),
    [
        (1, "order,sequence,feedback", "columns"),
        (3, "1,2,boat,none", "boat/none"),
        (3, "1,1,bike,none", "two trials at position 1"),
        (3, "1,x,bike,none", "position"),
        (3, "1,2,Bike,none", "sequence"),
        (3, "1,2,bike,realistic", "lacks"),
        (3, "1,2,bike", "columns"),
        (1, 'order,"position', "unexpected end"),
    ],
)
def test_a_wrong_line_of_a_list_is_named(study, tmp_path, line, text, reported):
    path = tmp_path / "orders.csv"
    lines = write_orders(path, study.definition)
    lines[line - 1] = text
    path.write_text("\n".join(lines), encoding="utf-8")
    with pytest.raises(StudyError, match=r"orders\.csv, line") as refusal:
        read_orders(path, study.definition)
    assert reported in str(refusal.value)


def test_codes_hold_no_words_and_are_read_however_they_are_typed():
    made = {new_code(()) for _ in range(500)}
    assert len(made) == 500
    assert all(not set(code) & set("AEIOU01258SBLZ") for code in made)
    assert checked_code(" cdfghj ") == "CDFGHJ"
    for wrong in ("", "../../", "CDFGH", "CDFGHI", "CDFGHJK"):
        with pytest.raises(StudyError):
            checked_code(wrong)
    assert len({number_of(code) for code in made}) == 500
