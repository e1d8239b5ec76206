"""Lines and passages on a small paper of their own: each operation leads to the right line and to no wrong one."""

from dataclasses import dataclass, replace

import making as mk
import pytest
from sympy import Symbol

from boresight import BoresightError
from boresight.derive.ledger import lines as ln
from boresight.derive.ledger import passages as ps
from boresight.derive.ledger.equation import Derivation, Equation, Quantity
from boresight.derive.ledger.evaluate import DIGITS
from boresight.derive.ledger.free import of, positive_number, rotation
from boresight.derive.ledger.numbers import Matrix, digits, eye
from boresight.derive.ledger.paper import Paper, Stated, Witness
from boresight.derive.ledger.witness import finite_rotation, quaternion, skew


@dataclass(frozen=True, eq=False)
class Base:
    error: tuple
    rate: tuple


@dataclass(frozen=True)
class Sizes:
    error: float = 0.1
    rate: float = 1.0


def values(base, definitions):
    e, w = Matrix(base.error), Matrix(base.rate)
    C = finite_rotation((1, 2, 3))
    e_x, e_y, _ = e
    return {"e": e, "w": w, "C": C, "D": finite_rotation(-e) * C, "I": eye(3), "s": e_x, "t": e_y, "r": e_x * e_y}


def quantities():
    matrices = [(name, (3, 3)) for name in "CDMI"]
    vectors = [*((name, (3,)) for name in ("e", "w", "p")), ("q", (4,)), ("h", (4,))]
    shapes = dict([*matrices, *vectors, *((name, ()) for name in ("s", "t", "r", "u"))])
    return tuple(
        Quantity(Symbol(name, commutative=not shape), name, str(shape), "", shape) for name, shape in shapes.items()
    )


TOY = Paper(
    name="toy",
    reference="",
    make_equations=tuple,
    quantities=quantities,
    witness=Witness(Base, values, Sizes(), ("error",)),
    conditions=Stated(Sizes(), ""),
    point=Stated(None, ""),
    evidence=lambda number: "",
    findings=tuple,
    structure={
        "C": rotation,
        "I": lambda generator: eye(3),
        "M": of("p", skew),
        "u": positive_number,
        "q": of("C", quaternion),
        "h": of("M", lambda M: quaternion(M.exp())),
    },
)


def derivation(*lines):
    steps = ln.read_lines(lines, quantities())
    blank = Equation("toy", "1", (), (0, 0), (), (), Derivation(steps), quantities=quantities())
    return blank


def follows(before, passage, after, *others):
    """Whether `after` follows from `before`; others: lines before both, the first of which is number 1."""
    written = [mk.line(text, mk.EXACT_LINE, "") for text in (*others, before)]
    equation = derivation(*written, replace(mk.line(after, mk.EXACT_LINE, ""), passage=passage))
    return ps.judge_passage(TOY, equation, len(equation.derivation.steps) - 1).holds


B, O, D = "\\begin{bmatrix} ", " \\\\ ", " \\end{bmatrix}"


@pytest.mark.parametrize(
    ("before", "passage", "right", "wrong", "others"),
    [
        ("p = C w", mk.substitute("1"), "p = C (e + C e)", "p = C (e - C e)", ["w = e + C e"]),
        ("p = C w", mk.substitute("1", letters=["w"]), "p = C (C^T e)", "p = C (C e)", ["C w = e"]),
        ("p = C w", mk.multiply(left="C^T"), "C^T p = C^T C w", "C^T p = C w", []),
        ("D = M", mk.multiply(right="w"), "D w = M w", "w^T D = M w", []),
        ("D - M = C", mk.add("M"), "D = C + M", "D = C - M", []),
        ("p + w = e", mk.rearrange(), "p = e - w", "p = e + w", []),
        ("p = C w", mk.add_line("1"), "p + e = C w + w", "p + e = C w - w", ["e = w"]),
        ("p = C w", mk.subtract_line("1"), "p - e = C w - w", "p - e = w - C w", ["e = w"]),
        ("D = C M", mk.transpose(), "D^T = M^T C^T", "D^T = C^T M^T", []),
        ("D = C C", mk.invert(), "D^{-1} = C^{-1} C^{-1}", "D^{-1} = C^{-1} C", []),
        ("p = C C^T w", mk.multiply_out(), "p = w", "p = C w", []),
        ("p = [w \\times] e", mk.multiply_out(), "p = - e \\times w", "p = e \\times w", []),
        ("C = D M", mk.chain("1", "2"), "C = I", "D = M", ["D M = I"]),
        ("u = s t + s + s^2", mk.expand("s"), "u = s t + s", "u = s t + s + s^2", []),
        ("u = s t + s + s^2", mk.expand("s", "t"), "u = s", "u = s + s t", []),
        ("u = \\cos s + t s^2", mk.expand("s", order=2), "u = 1 - s^2/2 + t s^2", "u = 1 + s^2/2 + t s^2", []),
        ("D = \\exp([e \\times]) C", mk.expand("e"), "D = (I + [e \\times]) C", "D = (I - [e \\times]) C", []),
        ("u = s t + r", mk.leave_out("r"), "u = s t", "u = s", []),
        ("r = s t", mk.differentiate({"s": "u", "r": "1"}), "1 = u t", "1 = u s", []),
        ("M = C [w \\times] C^T", mk.take_vector(), "p = C w", "p = C^T w", []),
        ("D = C", mk.take_skew_part(), "(D - D^T)/2 = (C - C^T)/2", "(D - D^T)/2 = (C + C^T)/2", []),
        (r"\exp([p \times]) = \exp(C [w \times] C^T)", mk.take_rotation_vector(), "p = C w", "p = C^T w", []),
        (r"\exp([p \times]) C = C \exp([p \times])", mk.take_quaternion(), "h q = q h", "h q = q q", []),
        ("p = C w", mk.substitute("1"), "p = 0", "p = C e", ["w = 0"]),
        ("D = C", mk.take_entry(1, 2), "D(1,2) = C(1,2)", "D(1,2) = C(2,1)", []),
        (
            "p = e",
            mk.stack("1", "2"),
            B + "p " + O + "w" + D + " = " + B + "e" + O + "C e" + D,
            B + "p" + O + "w" + D + " = " + B + "C e" + O + "e" + D,
            ["p = e", "w = C e"],
        ),
        ("u^2 = 4", mk.take_root(), "u = 2", "u = 4", []),
        ("D p = C p", mk.identify("p"), "D = C", "D = C^T", []),
        ("D p + w = C p + e", mk.identify("p"), "D = C", "w = e", []),
        ("p = C w", mk.put_in("1"), "p = C (e + C e)", "p = C (e - C e)", ["w = e + C e"]),
        ("p = C w", mk.elsewhere({"w": "e", "p": "w"}), "w = C e", "e = C w", []),
        ("u = 2 s t - 4", mk.find_minimum(), "s t = 2", "s t = 1", []),
        ("u = 2 s t - 4", mk.find_minimum(), "2 = s t", "s s t = 2 s", []),
        ("u = p^T C w - p^T e", mk.find_minimum("p"), "C w = e", "C w = 2 e", []),
        ("p = C w", mk.solve_for("w"), "w = C^T p", "w = C p", []),
        ("s t + r = u", mk.solve_for("t"), "t = (u - r)/s", "t = (u + r)/s", []),
    ],
)
def test_an_operation_leads_to_its_line_and_to_no_other(before, passage, right, wrong, others):
    assert follows(before, passage, right, *others)
    assert not follows(before, passage, wrong, *others)


def test_a_row_that_changes_nothing_is_no_reason():
    assert not follows("p = C w", mk.substitute("1"), "p = C w + w - w", "e = w")


def test_a_line_that_repeats_the_one_before_is_no_step():
    assert not follows("p = C w", mk.multiply_out(), "p = C w")


def test_a_true_line_that_does_not_follow_is_refused():
    """Both are true at the witness: D = exp(-[e x]) C."""
    lines = [mk.line("D = \\exp(-[e \\times]) C", mk.EXACT_LINE, "")]
    second = mk.line("D C^T = \\exp(-[e \\times])", mk.EXACT_LINE, "", mk.transpose())
    equation = derivation(*lines, second)
    with digits(DIGITS):
        assert ln.judge_line(TOY, equation, 1).holds and not ps.judge_passage(TOY, equation, 1).holds


@pytest.mark.parametrize(
    ("latex", "claim", "holds"),
    [
        ("D = \\exp(-[e \\times]) C", mk.EXACT_LINE, True),
        ("D = (I - [e \\times]) C", mk.EXACT_LINE, False),
        ("D = (I - [e \\times]) C", mk.first_order(), True),
        ("D = (I + [e \\times]) C", mk.first_order(), False),
        ("D = \\exp(-[e \\times]) C", mk.first_order(), False),  # it is exact
        ("D = (I - [e \\times]) C", mk.limit("error"), False),  # it is right to first order
        ("r = s t", mk.first_order(), False),  # true, and nothing of it is of first order
        ("D = C", mk.limit("error"), True),
        ("D = C^T", mk.limit("error"), False),
        ("D = (I - [e \\times] + [e \\times] [e \\times]/2) C", mk.of_order(2, "error"), True),
        ("D = (I - [e \\times]) C", mk.of_order(2, "error"), False),
        ("[C w \\times] = C [w \\times] C^T", mk.IDENTITY, True),
        ("[C w \\times] = C^T [w \\times] C", mk.IDENTITY, False),
        ("D = (I - [e \\times]) C", mk.approximately("D - (I - [e \\times]) C", "e is small"), True),
        ("D = \\exp(-[e \\times]) C", mk.approximately("D - D", "e is small"), False),  # nothing is dropped
        ("u = s + t", mk.DEFINITION, True),
        ("s = r + t", mk.DEFINITION, False),  # the witness knows s
        ("s + t = s + t", mk.EXACT_LINE, False),  # one side twice
    ],
)
def test_a_claim_is_judged_by_its_kind(latex, claim, holds):
    equation = derivation(mk.line(latex, claim, ""))
    with digits(DIGITS):
        assert ln.judge_line(TOY, equation, 0).holds is holds


def test_a_definition_that_nothing_uses_is_refused_and_a_wrong_one_breaks_a_later_line():
    def lines(value):
        return [mk.line(f"u = {value}", mk.DEFINITION, ""), mk.line("u r = s s t + s t t", mk.EXACT_LINE, "")]

    with digits(DIGITS):
        ln.check_derivation(TOY, derivation(*lines("s + t")))
        with pytest.raises(BoresightError, match=r"toy \(1\), line 2, u r = .*differ"):
            ln.check_derivation(TOY, derivation(*lines("s - t")))
        with pytest.raises(BoresightError, match=r"line 1, .*nothing uses u"):
            ln.check_derivation(TOY, derivation(*lines("s + t")[:1]))


def test_an_expectation_has_exact_second_moments():
    from boresight.derive.ledger.evaluate import Point, evaluate

    (one,) = ln.read_lines([mk.line("M = \\mathrm{E}[p p^T] + \\mathrm{E}[C p]", mk.EXACT_LINE, "")], quantities())
    root = Matrix([[1, 0, 0], [2, 3, 0], [0, 1, 5]])
    columns = [root[:, k] for k in range(3)]
    point = Point({"p": Matrix([0, 0, 0]), "C": eye(3), "random": {"p": columns}})
    with digits(DIGITS), pytest.raises(ValueError, match="sum of shapes"):
        evaluate(one.relation.sides[1], point)
    with digits(DIGITS):
        moment = evaluate(one.relation.sides[1].args[0], point)
        assert max(abs(entry) for entry in moment - root * root.T) < 1e-40


def test_what_is_not_linear_in_a_letter_is_not_solved_for_it():
    assert not follows("t = s s", mk.solve_for("s"), "s = t")
    assert not follows("r = s", mk.substitute("1", letters=["s"]), "r = t", "t = s s")


def test_prose_alone_derives_nothing_and_a_result_is_of_what_is_printed():
    printed = ln.read_lines([mk.line("D = C", mk.EXACT_LINE, "")], quantities())[0].formulas
    other = ln.read_lines([mk.line("D = \\exp(-[e \\times]) C", mk.EXACT_LINE, "", result=True)], quantities())
    foreign = ln.read_lines([mk.line("r = s t", mk.EXACT_LINE, "", result=True)], quantities())
    blank = replace(derivation(), printed=printed, derived=printed)
    with digits(DIGITS):
        ln.check_derivation(TOY, replace(blank, derivation=Derivation(other), derived=other[0].formulas))
        with pytest.raises(BoresightError, match=r"toy \(1\): D is not what is derived"):
            ln.check_derivation(TOY, replace(blank, derivation=Derivation(foreign), derived=foreign[0].formulas))
        with pytest.raises(BoresightError, match=r"toy \(1\): prose derives nothing"):
            ln.check_derivation(TOY, replace(blank, derivation=Derivation((mk.prose("it is so"),))))
