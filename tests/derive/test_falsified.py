"""What a derivation must refuse: true lines between which nothing leads, and false lines whatever they claim."""

from dataclasses import replace
from random import Random

import making as mk
import pytest

from boresight import BoresightError
from boresight.derive.ledger import lines as ln
from boresight.derive.ledger import passages as ps
from boresight.derive.ledger.equation import Derivation, Equation
from boresight.derive.ledger.free import Kind, Of
from boresight.derive.ledger.judge import EXACT, FULL, SEEDS, witness_point
from boresight.derive.ledger.numbers import Matrix, largest
from boresight.derive.papers import DERIVATIONS, PAPERS, paper

KANG = paper("kang-2025")

pytestmark = pytest.mark.usefixtures("many_digits")


def derivation(*lines, small=()):
    """Lines in Kang's letters, as of an equation that the paper does not have."""
    letters = (*KANG.quantities(), *KANG.letters())
    steps = ln.read_lines(lines, letters)
    return Equation("kang-2025", "0", (), (0, 0), (), (), Derivation(steps), quantities=letters, small=small)


def true(latex, claim=mk.EXACT_LINE, passage=None):
    return mk.line(latex, claim, "it is true", passage)


RATE = true(r"\dot{C}_S^n = C_S^n [w_{nb}^b \times]")
CHAINED = true("C_S^n = C_e^n C_S^e")
GYROS = true(r"w_{nb}^b = w_{ib}^b - (C_S^n)^T w_{in}^n")
TURN = true(r"\exp([e \times]) = C_S^n C_M^S C_M^{nT}")
A_IS = true(r"A = [e \times]")
ARM = true(r"\frac{dL}{dt} \Big|_n = \dot{C}_S^n L")
DELAYED = true(r"v_{s,k+\alpha} = v_{s,k} - \delta t_d \dot{v}_s", mk.first_order("delay"))
BODY = true("w_{nb}^n = C_S^n w_{nb}^b")
PARTS = true(r"\dot{C}_S^n = \dot{C}_e^n C_S^e + C_e^n \dot{C}_S^e")
LEVER = true(r"u_k = [w_{in}^n \times] C_S^n L - C_S^n [w_{ib}^b \times] L")
TWO = mk.of_order(2)

INFERENCES = {
    "a product from the wrong side": ([CHAINED], true("(C_e^n)^T C_S^n L = C_S^e L", passage=mk.multiply(right="L"))),
    "a factor on one side alone": ([BODY], true("(C_S^n)^T w_{nb}^n = w_{nb}^b", passage=mk.multiply(left="C_S^n"))),
    "a transpose for an inverse of what is no rotation": (
        [RATE], true(r"(\dot{C}_S^n)^T = -[w_{nb}^b \times] (C_S^n)^T", passage=mk.invert())),
    "a transpose with its factors in the old order": (
        [RATE], true(r"(\dot{C}_S^n)^T C_S^n = -[w_{nb}^b \times]", passage=mk.transpose())),
    "a substitution of a line that is about other letters": (
        [RATE, ARM], true(r"\dot{C}_S^n = [w_{nb}^n \times] C_S^n", passage=mk.substitute("2", of="1"))),
    "a substitution with a line too many": (
        [RATE, GYROS, BODY],
        true(r"\dot{C}_S^n = C_S^n [w_{ib}^b - (C_S^n)^T w_{in}^n \times]", passage=mk.substitute("2", "3", of="1"))),
    "a substitution of the line itself": ([A_IS, TURN], true(r"e = \vee(A)", passage=mk.substitute("3", of="1"))),
    "a chain of itself": ([A_IS], true("w_{nb}^n = C_S^n w_{nb}^b", passage=mk.chain("2"))),
    "a chain of lines that do not meet": ([A_IS, RATE], true("w_{nb}^n = C_S^n w_{nb}^b", passage=mk.chain("1", "2"))),
    "terms that change sides and change": (
        [PARTS], true(r"C_e^n \dot{C}_S^e = \dot{C}_S^n - \dot{C}_e^n (C_e^n)^T C_S^n", passage=mk.rearrange())),
    "a side between two": (
        [PARTS],
        true(r"\dot{C}_S^n - \dot{C}_e^n C_S^e = \dot{C}_S^n - \dot{C}_e^n (C_e^n)^T C_S^n = C_e^n \dot{C}_S^e",
             passage=mk.rearrange())),
    "the vector of what is not skew-symmetric": (
        [TURN], true(r"\vee(\exp([e \times])) = \vee(C_S^n C_M^S C_M^{nT})", passage=mk.take_vector())),
    "a skew-symmetric part that leaves out an order": (
        [TURN], true(r"A = \frac{1}{2} (C_S^n C_M^S C_M^{nT} - (C_S^n C_M^S C_M^{nT})^T)", TWO, mk.take_skew_part())),
    "an expansion in fewer letters": (
        [true(r"C_S^n = (eye(3) + \delta t_d [w_{nb}^n \times]) C_{S,k+\alpha}^n", mk.first_order("delay"))],
        true("C_S^n = C_{S,k+\\alpha}^n", mk.limit("delay"), mk.expand("z_{DCM}"))),
    "an order too few": (
        [TURN], true(r"eye(3) + [e \times] + \frac{1}{2} [e \times] [e \times] = C_S^n C_M^S C_M^{nT}", TWO,
                     mk.expand("e"))),
    "a term left out of its letter": (
        [true(r"v_m^n = v_s^n - \frac{dL}{dt} \Big|_n + \dot{C}_e^n C_S^e L + \Delta C_e^n \dot{r}_m^e")],
        true(r"v_m^n = v_s^n - \frac{dL}{dt} \Big|_n + \Delta C_e^n \dot{r}_m^e",
             mk.approximately(r"\dot{C}_e^n C_S^e L", "it is small"), mk.leave_out(r"\Delta C_e^n"))),
    "a product of which one factor is differentiated": (
        [CHAINED], true(r"\dot{C}_S^n = \dot{C}_e^n C_S^e + C_e^n \dot{C}_S^e", passage=mk.differentiate(
            {"C_S^n": r"\dot{C}_S^n", "C_S^e": r"\dot{C}_S^e"}))),
    "a rate that no line says": (
        [true(r"v_s^n = C_e^n \dot{r}_s^e")],
        true(r"\dot{C}_S^n L = \frac{dL}{dt} \Big|_n", passage=mk.differentiate(
            {"v_s^n": r"\dot{C}_S^n L", r"\dot{r}_s^e": r"(C_e^n)^T \frac{dL}{dt} \Big|_n"}))),
    "a solution of what is not linear": (
        [true(r"Seawave Seawave = \frac{a a}{4} \sin(2\pi f t) \sin(2\pi f t)")],
        true(r"Seawave = \frac{a}{2} \sin(2\pi f t)", passage=mk.solve_for("Seawave"))),
    "a solution with the letter on both sides": (
        [GYROS],
        true("w_{ib}^b = w_{nb}^b + (C_S^n)^T w_{in}^n + w_{ib}^b - w_{ib}^b", passage=mk.solve_for("w_{ib}^b"))),
    "lines subtracted the other way": (
        [GYROS, BODY], true("w_{nb}^b - w_{nb}^n = w_{ib}^b - (C_S^n)^T w_{in}^n - C_S^n w_{nb}^b",
                            passage=mk.subtract_line("1", of="2"))),
    "the minimum of what is no rate": ([BODY], true("C_S^n w_{nb}^b = w_{nb}^n", passage=mk.find_minimum())),
    "an identity that is none": (
        [RATE, BODY], true(r"\dot{C}_S^n = C_S^n [w_{nb}^b \times] + C_S^n - C_S^n",
                           passage=mk.multiply_out("2", of="1"))),
    "a norm that has one sign": (
        [true(r"w_{nb}^n (\|L dt\|) = C_S^n w_{nb}^b (\|L dt\|)")],
        true(r"w_{nb}^n (\|L\|) dt = C_S^n w_{nb}^b (\|L\|) dt", passage=mk.multiply_out())),
    "another quantity of another kind": (
        [ARM], true(r"A L = A L - \dot{C}_S^n L + \frac{dL}{dt} \Big|_n", passage=mk.elsewhere(
            {r"\frac{dL}{dt} \Big|_n": "L"}))),
    "another time of one letter alone": (
        [ARM], true(r"-u_k = \dot{C}_S^n L", passage=mk.elsewhere({r"\frac{dL}{dt} \Big|_n": "u_k"}))),
}  # fmt: skip


@pytest.mark.parametrize("what", INFERENCES)
def test_a_true_line_to_which_nothing_leads_is_refused(what):
    before, after = INFERENCES[what]
    equation = derivation(*before, after)
    with pytest.raises(BoresightError, match=rf"line {len(before) + 1}, "):
        ln.check_derivation(KANG, equation)


FORMULAS = [
    ("a sign", r"\dot{C}_S^n = -C_S^n [w_{nb}^b \times]", mk.EXACT_LINE),
    ("an order of factors", r"\dot{C}_S^n = [w_{nb}^b \times] C_S^n", mk.EXACT_LINE),
    ("a transpose", r"w_{nb}^b = w_{ib}^b - C_S^n w_{in}^n", mk.EXACT_LINE),
    ("a frame", r"\dot{C}_S^n = [w_{nb}^b \times] C_S^n", mk.first_order()),
    ("a factor", r"v_{s,k+\alpha} = v_{s,k} - \frac{1}{2} \delta t_d \dot{v}_s", mk.first_order("delay")),
    ("a sign of one row", r"[-A(2,3); A(1,3); A(1,2)] = e", mk.EXACT_LINE),
    ("a row of the second order", r"[A(2,3) A(1,3); A(1,3); -A(1,2)] = e", mk.first_order()),
    ("an order that is not reached", r"C_S^n C_M^S C_M^{nT} = eye(3) + [e \times]", mk.of_order(2)),
    ("an exact line that is of first order", r"C_S^n C_M^S C_M^{nT} = eye(3) + [e \times]", mk.EXACT_LINE),
    ("nothing of first order", r"A A = [e \times] [e \times] + A A A", mk.first_order()),
    ("nothing of a limit", r"A = [e \times] + A A", mk.limit()),
    ("an identity of one point", r"[w_{nb}^b \times] = (C_S^n)^T \dot{C}_S^n", mk.IDENTITY),
    ("an identity of another order", r"[C_S^n L \times] = (C_S^n)^T [L \times] C_S^n", mk.IDENTITY),
    ("an identity of positive numbers", r"\|L dt\| = dt (\|L\|)", mk.IDENTITY),
    ("an identity that is claimed as a result", r"[C_S^n L \times] = C_S^n [L \times] (C_S^n)^T", mk.EXACT_LINE),
    ("terms of a sum in another order", r"v_s^n - v_m^n = -v_m^n + v_s^n", mk.EXACT_LINE),
    ("a definition of what is known", r"\dot{C}_S^n = C_S^n [w_{nb}^b \times]", mk.DEFINITION),
    ("a definition by itself", r"X = X C_S^n", mk.DEFINITION),
    ("a definition that nothing uses", r"X = C_S^n", mk.DEFINITION),
    ("an approximation that leaves out half", r"v_m^n = 2 v_s^n",
     mk.approximately(r"-v_s^n - \frac{dL}{dt} \Big|_n + \dot{C}_e^n C_S^e L + \Delta C_e^n \dot{r}_m^e", "never")),
    ("an approximation that leaves out nothing", "w_{nb}^n = C_S^n w_{nb}^b",
     mk.approximately("w_{nb}^n - w_{nb}^n", "always")),
    ("an approximation with a false side between",
     r"v_m^n = v_s^n + \frac{dL}{dt} \Big|_n = v_s^n + [w_{in}^n \times] C_S^n L - C_S^n [w_{ib}^b \times] L",
     mk.approximately(r"\dot{C}_e^n C_S^e L + \Delta C_e^n \dot{r}_m^e", "small")),
    ("shapes that do not fit", r"\dot{C}_S^n = C_S^n w_{nb}^b", mk.EXACT_LINE),
    ("an error that the witness does not have", r"C_S^n C_M^S C_M^{nT} = eye(3) + [e \times]", mk.first_order("tilt")),
]  # fmt: skip


@pytest.mark.parametrize(("what", "latex", "claim"), FORMULAS, ids=[one[0] for one in FORMULAS])
def test_a_false_line_is_refused_whatever_it_claims(what, latex, claim):
    equation = derivation(mk.line(latex, claim, what))
    with pytest.raises(BoresightError, match="line 1, "):
        ln.check_derivation(KANG, equation)


@pytest.mark.parametrize("what", INFERENCES)
def test_the_lines_themselves_are_true(what):
    """So that it is the step between them which is refused."""
    before, after = INFERENCES[what]
    equation = derivation(*before, replace(after, passage=None))
    verdicts = [ln.judge_line(KANG, equation, index) for index in range(len(before) + 1)]
    assert all(verdict.holds for verdict in verdicts), verdicts


def test_two_equations_cannot_stand_on_one_another():
    on_3 = derivation(true("v_m^n = v_s^n + u_k", passage=mk.substitute("(3)"))).derivation
    one = replace(KANG.equation("1"), derivation=on_3)
    with pytest.raises(BoresightError, match=r"kang-2025 \(1\): its derivation stands on itself"):
        ln.check_derivation(KANG, one)


@pytest.mark.parametrize("name", [*PAPERS, *DERIVATIONS])
def test_what_letters_are_by_their_nature_they_are_at_the_witness(name):
    one = paper(name)
    known = witness_point(one, SEEDS[0], FULL).values
    for letter, rule in one.structure.items():
        if letter not in known or letter in ("random", "mean"):  # what E takes
            continue
        if isinstance(rule, Kind):
            assert rule.holds(known[letter]), letter
        elif isinstance(rule, Of):
            if all(part in known for part in rule.letters):
                difference = known[letter] - rule.function(*(known[part] for part in rule.letters))
                assert largest(difference if isinstance(difference, Matrix) else [difference]) < EXACT, letter
        else:
            first, second = rule(Random(1)), rule(Random(2))  # a constant
            for value in (first, second):
                difference = known[letter] - value
                assert largest(difference if isinstance(difference, Matrix) else [difference]) < EXACT, letter


# Of Kang. Every other passage that names a row, a letter, an order or a line less or otherwise is refused.
SAME_INFERENCES = {
    ("1", 15, "without row 14"), ("5", 16, "without row 15"),  # they follow as well without the name of why
    ("5", 11, "of line 8"), ("5", 11, "of line 9"), ("5", 17, "of line 14"),  # lines that say the same
}  # fmt: skip


def otherwise(passage, index):
    """The passage with one thing in it changed."""

    def without(parts, k):
        return (*parts[:k], *parts[k + 1 :])

    for k, row in enumerate(passage.using):
        yield f"without row {row}", replace(passage, using=without(passage.using, k))
    for k, name in enumerate(passage.letters):
        with_ = without(passage.with_, k) if passage.with_ else ()
        yield f"without {name}", replace(passage, letters=without(passage.letters, k), with_=with_)
    if passage.operation != "multiply out":
        yield "as multiply out", replace(passage, operation="multiply out", using=(), letters=(), with_=())
    if passage.operation == "multiply":
        yield "from the other side", replace(passage, with_=passage.with_[::-1])
    if passage.operation == "expand":
        yield "another order", replace(passage, order=3 - passage.order)
    if passage.operation == "add":
        yield "minus", replace(passage, with_=(f"-({passage.with_[0]})",))
    for k in range(index) if passage.operation != "chain" else ():
        yield f"of line {k + 1}", replace(passage, of=str(k + 1))


def test_a_passage_of_which_anything_is_changed_leads_nowhere():
    left = set()
    for equation in KANG.equations:
        steps = equation.derivation.steps
        for i, step in enumerate(steps):
            for what, passage in otherwise(step.passage, i) if step.passage else ():
                changed = Derivation((*steps[:i], replace(step, passage=passage), *steps[i + 1 :]))
                if ps.judge_passage(KANG, replace(equation, derivation=changed), i).holds:
                    left.add((equation.number, i + 1, what))
    given = {
        (e.number, i + 1, f"of line {int(s.passage.of or e.derivation.before(i) + 1)}")
        for e in KANG.equations
        for i, s in enumerate(e.derivation.steps)
        if s.passage and not s.passage.of.startswith("(")
    }
    assert left - given == SAME_INFERENCES
