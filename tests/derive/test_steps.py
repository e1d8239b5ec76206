"""Every step of a derivation is judged: a formula that is falsified, alone or with others, is refused by the ledger."""

import re
from dataclasses import replace
from functools import cache

import pytest

from boresight import BoresightError
from boresight.derive.ledger.entries import entry_of
from boresight.derive.ledger.equation import Derivation, Relation, negative
from boresight.derive.ledger.lines import count_steps
from boresight.derive.ledger.reader import read
from boresight.derive.papers import PAPERS, paper


@cache
def kinds(name):
    """A step of each kind of claim that a paper's lines make: (equation, index)."""
    found = {}
    for equation in paper(name).equations:
        for index, step in enumerate(equation.derivation.steps):
            if step.claim is not None:
                found.setdefault(step.claim.kind, (equation.number, index))
    return found


def spoilt(name, number, index, relation):
    """The equation with another relation in one of its steps."""
    equation = paper(name).equation(number)
    steps = list(equation.derivation.steps)
    steps[index] = replace(steps[index], relation=relation)
    return replace(equation, derivation=Derivation(tuple(steps)))


def refusal(name, equation):
    with pytest.raises(BoresightError) as refused:
        entry_of(paper(name), equation)
    return str(refused.value)


@pytest.mark.parametrize(("name", "kind"), [(name, kind) for name in PAPERS for kind in kinds(name)])
def test_a_falsified_line_of_each_kind_is_refused_with_the_line_in_words(name, kind):
    """The last side changes its sign: or, where that is zero, the first is doubled and one is added."""
    number, index = kinds(name)[kind]
    first, *middle, last = paper(name).equation(number).derivation.steps[index].formulas[0].sides
    assert last != 0
    text = refusal(name, spoilt(name, number, index, Relation((first, *middle, negative(last)))))
    assert re.match(rf"{name} \({number}\), line \d+, .+: .+", text), text
    line = int(re.search(r"line (\d+)", text)[1])
    assert line == index + 1 or (kind == "definition" and line > index + 1)


# Signs, functions, orders and transposes: paper, equation, a piece of one of its steps, and what it is falsified to.
TEN = (
    ("song-lee-2001", "7", "= -E C_b^n", "= E C_b^n"),
    ("song-lee-2001", "8", r"u_\theta = R_3(\psi)", r"u_\theta = R_3(\psi)^T"),
    ("song-lee-2001", "20", r"E \Omega_{in}^n - \Omega_{in}^n E = -[", r"\Omega_{in}^n E - E \Omega_{in}^n = -["),
    ("song-lee-2001", "23", r"\frac{\sin \frac{\epsilon_o}{2}}", r"\frac{\cos \frac{\epsilon_o}{2}}"),
    ("kim-2018", "4", r"\hat{v}_{SINS}^n = v^n + \delta v^n", r"\hat{v}_{SINS}^n = v^n - \delta v^n"),
    ("kim-2018", "5", r"\exp(-[\theta \times]) C_b^r", r"C_b^r \exp(-[\theta \times])"),
    ("kim-2018", "5", "C_r^n C_b^r = C_b^n", "C_r^n C_b^r = C_n^b"),
    ("kang-2025", "1", r"C_S^n [w_{nb}^b \times]", r"[w_{nb}^b \times] C_S^n"),
    ("kang-2025", "2", r"= v_{s,k} - \delta t_d", r"= v_{s,k} + \delta t_d"),
    ("kang-2025", "6", r"\frac{a}{2} \sin\vartheta]", r"\frac{a}{2} \cos\vartheta]"),
)


@pytest.mark.parametrize(("name", "number", "right", "wrong"), TEN)
def test_ten_falsified_formulas_are_refused_each(name, number, right, wrong):
    one = paper(name)
    steps = one.equation(number).derivation.steps
    index = next(i for i, step in enumerate(steps) if right in step.latex)
    (relation,) = read((steps[index].latex.replace(right, wrong),), (*one.quantities(), *one.letters()))
    assert relation != steps[index].formulas[0]
    assert f"{name} ({number}), line {index + 1}, " in refusal(name, spoilt(name, number, index, relation))


@pytest.mark.parametrize("name", PAPERS)
def test_at_most_one_step_in_ten_is_prose_and_all_others_are_evaluated(name):
    counted = count_steps(paper(name).equations)
    assert counted.steps == counted.evaluated + counted.prose
    assert 10 * counted.prose <= counted.steps


def test_the_papers_have_at_least_110_evaluated_steps():
    assert sum(count_steps(paper(name).equations).evaluated for name in PAPERS) >= 110
