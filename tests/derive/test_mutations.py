"""A status that is computed changes with every mutation: the survivors are listed, each with a computed reason."""

from collections import Counter
from functools import cache

import pytest

from boresight.derive.ledger.mutation import ALIAS, SAME, SECOND_ORDER, UNEXPLAINED, mutants, survivors
from boresight.derive.papers import paper

# number: (mutants, survivors that say the same, that put another name, that differ in second order).
# (26) to (28) have a zero entry in each row: whatever it multiplies may change.
SONG_LEE = {
    "1": (53, 0, 0, 0),
    "2": (53, 0, 0, 0),
    "3": (53, 0, 0, 0),
    "4": (84, 0, 3, 0),
    "5": (163, 0, 9, 6),
    "6": (83, 0, 2, 0),
    "7": (126, 0, 6, 6),
    "8": (243, 0, 10, 14),
    "9": (306, 0, 13, 20),
    "10": (210, 0, 10, 0),
    "11": (39, 0, 0, 0),
    "12": (244, 0, 10, 14),
    "13": (306, 0, 13, 20),
    "14": (157, 0, 3, 0),
    "15": (306, 0, 0, 20),
    "16": (170, 0, 3, 0),
    "17": (264, 0, 6, 0),
    "18": (306, 0, 0, 20),
    "19": (582, 0, 10, 90),
    "20": (69, 0, 0, 3),
    "21": (11, 1, 0, 0),
    "22": (97, 0, 0, 0),
    "23": (277, 0, 1, 0),
    "24": (14, 0, 1, 0),
    "25": (36, 0, 0, 0),
    "B": (63, 0, 0, 0),
    "δμ": (153, 0, 0, 0),
    "26": (345, 16, 5, 36),
    "27": (260, 32, 3, 18),
    "28": (345, 16, 5, 36),
}
KIM = {
    "1": (48, 0, 0, 0),
    "2": (71, 0, 2, 0),
    "3": (113, 0, 8, 0),
    "4": (46, 0, 0, 0),
    "5": (52, 0, 0, 1),
    "6": (112, 0, 8, 0),
    "7": (18, 0, 2, 0),
    "8": (30, 0, 0, 0),
    "9": (138, 0, 0, 11),
    "10": (80, 0, 0, 3),
    "11": (61, 0, 0, 1),
    "12": (19, 0, 1, 0),
    "13": (17, 0, 2, 0),
    "14": (31, 0, 3, 0),
    "15": (15, 0, 2, 0),
    "16": (20, 0, 0, 0),
    "17": (41, 0, 4, 0),
    "18": (120, 0, 1, 0),
    "19": (67, 0, 1, 0),
    "20": (83, 0, 2, 0),
    "21": (40, 0, 0, 0),
    "22": (26, 0, 0, 0),
    "23": (94, 0, 9, 0),
    "24": (32, 0, 3, 0),
    "25": (30, 0, 0, 0),
    "26": (26, 0, 3, 0),
    "27": (34, 0, 0, 0),
    "28": (54, 0, 0, 0),
    "29": (89, 0, 0, 0),
    "30": (31, 0, 0, 0),
    "31": (20, 0, 0, 0),
    "32": (20, 0, 1, 0),
    "Ω_n": (11, 2, 0, 0),
}
# The slave's velocity has three names, v_s, v_S and v_s(k); eye(3) is its own transpose.
KANG = {
    "1": (74, 0, 4, 0),
    "2": (60, 0, 2, 0),
    "3": (132, 0, 4, 0),
    "4": (57, 0, 2, 0),
    "5": (24, 0, 0, 0),
    "6": (15, 0, 0, 0),
}
EXPECTED = {"song-lee-2001": SONG_LEE, "kim-2018": KIM, "kang-2025": KANG}


@cache
def count_and_survivors(name, number):
    one = paper(name)
    return survivors(one, one.equation(number))


@pytest.mark.parametrize(("name", "number"), [(name, number) for name in EXPECTED for number in EXPECTED[name]])
def test_every_single_mutation_changes_the_status_or_says_the_same(name, number):
    count, found = count_and_survivors(name, number)
    reasons = Counter(survivor.reason for survivor in found)
    assert not reasons[UNEXPLAINED], [survivor for survivor in found if survivor.reason == UNEXPLAINED]
    assert (count, reasons[SAME], reasons[ALIAS], reasons[SECOND_ORDER]) == EXPECTED[name][number]


def test_no_changed_sign_function_transpose_or_order_survives_but_of_what_is_zero_or_one():
    for number in ("8", "9", "12", "13", "15", "18", "19", "20", "23", "24", "25"):
        for survivor in count_and_survivors("song-lee-2001", number)[1]:
            before, _, after = survivor.what.partition(" -> ")
            assert after and len(before) <= 6, survivor  # one letter for another, nothing else


def test_mutants_cover_each_class():
    what = [text for number in ("7", "19", "20", "24") for text, _ in _mutants(number)]
    for piece in ("its negative", "sign of", "without", "sin(ψ_b) -> cos", "ψ_b -> φ_b", "transpose", "other order"):
        assert any(piece in text for text in what), piece


def _mutants(number):
    equation = paper("song-lee-2001").equation(number)
    return mutants(equation.read(), equation.quantities)
