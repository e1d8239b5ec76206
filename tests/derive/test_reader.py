"""The reader of printed LaTeX: what it reads it reads in the order of the page, what it does not know it refuses."""

import pytest
from sympy import (
    Function,
    MatAdd,
    MatMul,
    Mul,
    Rational,
    StrictLessThan,
    Symbol,
    atan,
    atan2,
    cos,
    exp,
    sin,
    sinh,
    sqrt,
    symbols,
    tan,
)
from sympy.functions.elementary.complexes import transpose

from boresight import BoresightError
from boresight.derive.ledger.equation import Quantity, column, matrix
from boresight.derive.ledger.evaluate import Point, evaluate
from boresight.derive.ledger.judge import names
from boresight.derive.ledger.numbers import Matrix, digits, exact, largest
from boresight.derive.ledger.rates import rate_of
from boresight.derive.ledger.reader import read
from boresight.derive.letters import dotted

a, b = symbols("a b", real=True)
A, B = symbols("A B", commutative=False)
TABLE = (
    Quantity(a, r"\alpha", "angle", "an angle"),
    Quantity(b, r"\hat{\alpha}_b", "angle", "another"),
    Quantity(A, "A_n^{n'}", "3x3", "a matrix", (3, 3)),
    Quantity(B, r"\epsilon^n", "vector", "a vector", (3,)),
    Quantity(Symbol("f"), "f", "function", "a function", (3, 3), True),
)


@pytest.mark.parametrize(
    "latex, right",
    [
        (r"\sin \alpha \tan\hat{\alpha}_b", sin(a) * tan(b)),
        (r"-\cos\alpha/\cos\hat{\alpha}_b", -cos(a) / cos(b)),
        (r"\frac{\alpha}{\hat{\alpha}_b} \sin \frac{\alpha}{2}", a / b * sin(a / 2)),
        (r"\sqrt{\alpha^2 + \hat{\alpha}_b^2}", sqrt(a**2 + b**2)),
        (r"[\alpha \ \hat{\alpha}_b]^T", column(a, b)),
        (r"\begin{bmatrix} \alpha & 0 \\ -1 & \hat{\alpha}_b \end{bmatrix}", matrix([[a, 0], [-1, b]])),
        (r"A_n^{n'} \varepsilon^n", A * B),
        (r"\boxed{A_n^{n'} \epsilon^n}", A * B),
        (r"f(\alpha, \hat{\alpha}_b)", Function("f", commutative=False)(a, b)),
        (r"f[(\alpha), (\hat{\alpha}_b)]", Function("f", commutative=False)(a, b)),
        (r"A_n^{n'} A_n^{n'}^T \epsilon^n", A * transpose(A) * B),
        (r"(A_n^{n'} + \epsilon^n)^{-1}", (A + B) ** -1),
        (r"[\alpha \quad \hat{\alpha}_b]", matrix([[a, b]])),
        (r"[-\alpha; \hat{\alpha}_b]", column(-a, b)),
        (r"(A_n^{n'} + \epsilon^n)^T", transpose(A + B, evaluate=False)),
        (r"\|\epsilon^n\|^2", Function("norm")(B) ** 2),
        (r"\frac{1}{\alpha} \sum_{k \in \Omega_n} \alpha", Function("Σ")(a) / a),
        (r"\{\alpha \leq \hat{\alpha}_b \leq 3\}", Function("samples")(a, b, 3)),
        (r"A_n^{n'} \epsilon^n(1,2)", Function("entry")(A * B, 1, 2)),
        (r"\alpha < \hat{\alpha}_b", StrictLessThan(a, b)),
    ],
)
def test_latex_is_read_symbol_by_symbol(latex, right):
    (relation,) = read((rf"\alpha = {latex}",), TABLE)
    assert relation.sides[0] == a and relation.sides[1] == right


def test_order_of_terms_and_factors_is_that_of_the_page():
    (relation,) = read((r"\epsilon^n = -\epsilon^n A_n^{n'} + A_n^{n'}",), TABLE)
    first, second = relation.sides[1].args
    assert first.args == (-1, B, A) and second == A


def test_matrices_are_multiplied_and_added_but_not_evaluated():
    row, col = r"\begin{bmatrix} \alpha & 1 \end{bmatrix}", r"\begin{bmatrix} \alpha \\ 2 \end{bmatrix}"
    (relation,) = read((rf"\alpha = {row} {col} - \alpha",), TABLE)
    side = relation.sides[1]
    assert isinstance(side, MatAdd) and isinstance(side.args[0], MatMul)


def test_displays_that_begin_with_an_operator_go_on():
    relations = read((r"\alpha = \hat{\alpha}_b", r"= 1", r"- \alpha", r"\alpha = 2"), TABLE)
    assert [len(relation.sides) for relation in relations] == [3, 2]


def test_rows_of_aligned_are_relations_and_a_row_that_begins_with_equals_goes_on():
    latex = (
        r"\begin{aligned} \alpha &= \begin{bmatrix} 1 \\ 2 \end{bmatrix} \\ &= 3 \\ \hat{\alpha}_b &= 4 \end{aligned}"
    )
    relations = read((latex,), TABLE)
    assert [len(relation.sides) for relation in relations] == [3, 2]
    assert relations[1].sides == (b, 4)


def test_a_product_whose_shapes_do_not_fit_is_read_and_has_no_value():
    two, three = (rf"\begin{{bmatrix}} {' & '.join('1' * n)} \end{{bmatrix}}" for n in (2, 3))
    (relation,) = read((rf"\alpha = {two} {three}",), TABLE)
    with pytest.raises(ValueError, match="a product of shapes"):
        evaluate(relation.sides[1], Point({}))


@pytest.mark.parametrize("latex", [r"\alpha = \gamma", r"\alpha = \frac{1}{2", r"\alpha + ", r"\alpha = \int \alpha"])
def test_what_is_not_known_is_refused_by_name(latex):
    with pytest.raises(BoresightError, match="cannot read"):
        read((latex,), TABLE)


q, p, v, w = (Symbol(name, commutative=False) for name in "qpvw")
x, y = symbols("x y", real=True)
TYPED = (
    *(Quantity(one, str(one), "s", "") for one in (x, y)),
    Quantity(v, r"\mathbf{v}", "v", "", (3,)),
    Quantity(w, r"\boldsymbol{\omega}", "v", "", (3,)),
    Quantity(q, r"\mathbf{q}", "q", "", (4,)),
    Quantity(p, r"\mathbf{p}", "q", "", (4,)),
    Quantity(A, "A", "m", "", (3, 3)),
)
SKEW = Function("skew", commutative=False)(w)
BRACKETS = (("(", ")"), ("[", "]"), (r"\{", r"\}"), (r"\left[", r"\right]"))
NORM, CONJ = Function("norm")(w), Function("conj", commutative=False)(q)


@pytest.mark.parametrize(
    "latex, right",
    [
        *((rf"A^{{{t}}}", transpose(A)) for t in ("T", r"\mathrm{T}", r"\mathrm T", r"\top", r"\mathsf{T}")),
        (r"A^\top", transpose(A)),
        (r"[\boldsymbol{\omega}]_\times", SKEW),
        (r"[\boldsymbol{\omega}]_{\times}", SKEW),
        (r"(\boldsymbol{\omega} \times)", SKEW),
        (r"\left\lfloor \boldsymbol{\omega} \times \right\rfloor", SKEW),
        (r"\boldsymbol{\omega}^\wedge", SKEW),
        (r"\mathbf{p} \otimes \mathbf{q}", p * q),
        (r"\mathbf{p} \otimes \mathbf{q}^*", p * CONJ),
        (r"\tfrac{1}{2} y", y / 2),
        (r"\frac12 y", y / 2),
        ("0.5 y", y / 2),
        (r"10^{-3} y", y / 1000),
        (r"x^{2} \, y", x**2 * y),
        (r"\bigl( x + y \bigr) y", (x + y) * y),
        (r"\begin{pmatrix} x \\ y \end{pmatrix}", column(x, y)),
        (r"\left[ \begin{array}{c} x \\ y \end{array} \right]", column(x, y)),
        (r"\mathrm{diag}(x, y)", matrix([[x, 0], [0, y]])),
        (r"\|\boldsymbol{\omega}\|", NORM),
        (r"|\boldsymbol{\omega}|", NORM),
        (r"\lVert \boldsymbol{\omega} \rVert", NORM),
        (r"\mathbf{v} \cdot \boldsymbol{\omega}", transpose(v) * w),
        (r"x \cdot y", x * y),
        (r"\sin^2 y", sin(y) ** 2),
        (r"\tan^{-1} y", atan(y)),
        (r"\operatorname{atan2}(x, y)", atan2(x, y)),
        (r"\exp(y)", exp(y)),
        (r"e^{y}", exp(y)),
        (r"\sqrt[3]{y}", y ** Rational(1, 3)),
        (r"\mathbf{0}_{3 \times 3}", Symbol("0_3x3", commutative=False)),
        *((latex, Symbol("I_3x3", commutative=False)) for latex in ("I_{3}", "I_3", r"\mathbf{I}_3")),
        (r"\begin{bmatrix} x & y \end{bmatrix}^T", column(x, y)),
        (r"\begin{bmatrix} A & x \end{bmatrix}^{\mathsf{T}}", column(transpose(A), x)),
        (r"\max(x, y)", Function("max")(x, y)),
        *(
            (latex, (x + y) * y)
            for latex in (r"\left\{ x + y \right\} y", r"\{ x + y \} y", r"\lbrace x + y \rbrace y")
        ),
        *((rf"{left} A + \mathbf{{v}} {right}^{{-1}}", (A + v) ** -1) for left, right in BRACKETS),
        *((rf"{left} A + \mathbf{{v}} {right}^T", transpose(A + v, evaluate=False)) for left, right in BRACKETS),
        *((rf"{left} \boldsymbol{{\omega}} {right}_\times", SKEW) for left, right in BRACKETS),
        *((latex, SKEW) for latex in (r"\{ \boldsymbol{\omega} \times \}", r"\boldsymbol\omega^\times")),
        *((rf"{left}x, y{right}^T", column(x, y)) for left, right in BRACKETS[:2]),
        *((rf"{left}\mathbf{{v}}^T, \boldsymbol\omega^T{right}^T", column(v, w)) for left, right in BRACKETS[:2]),
        (r"{x \over y}", x / y),
        ("+ x + y", x + y),
        (r"\begin{bmatrix} + x \\[2pt] y \end{bmatrix}", column(x, y)),
        (r"10^3 y^23", 1000 * y**2 * 3),
        ("A^{-T}", transpose(A**-1, evaluate=False)),
        (r"A \mathbf v \cdot \boldsymbol \omega", transpose(A * v, evaluate=False) * w),
        (r"\mathbf{I} - A", Symbol("I_3x3", commutative=False) - A),
    ],
)
def test_what_people_type_is_read(latex, right):
    for sign in ("=", r"\triangleq", ":=", r"\approx", r"\cong"):
        (relation,) = read((rf"x {sign} {latex}",), TYPED)
        assert relation.sides == (x, right)


@pytest.mark.parametrize("latex", [r"C_b^{nT}", r"C_b^{n\,\mathrm{T}}", r"{C_b^n}^T", r"(C_b^n)^\top"])
def test_a_transpose_may_stand_within_what_is_above_a_letter(latex):
    (relation,) = read((f"A = {latex} A",), (*TYPED, Quantity(v, "C_b^n", "m", "", (3, 3))))
    assert relation.sides[1] == transpose(v) * A


@pytest.mark.parametrize(
    "latex, other",
    [
        (r"\mathbf v_{N}^{n}", r"\mathbf{v}_N^n"),
        (r"\mathbf{v}^{n}_{N}", r"\mathbf{v}_N^n"),
        (r"\hat\omega_{\tau}", r"\hat{\omega}_\tau"),
        (r"\bm P_{k}^{-}", r"\boldsymbol{P}_k^-"),
        ("C^n_{b_{k}}", "C_{b_k}^n"),
    ],
)
def test_what_looks_the_same_is_one_letter_and_what_does_not_is_not(latex, other):
    for one, two in ((latex, other), (other, latex)):
        (relation,) = read((f"x = y {one}",), (*TYPED[:2], Quantity(v, two, "v", "", (3,))))
        assert relation.sides[1].args == (y, v)
    for unlike in (r"\mathbf{v}_{Nn}", r"\mathbf{v}_n^N", "v_N^n", r"\omega_\tau", "P_k^-", "C_{bk}^n", "C_{b_k^n}"):
        with pytest.raises(BoresightError, match="cannot read"):
            read((f"x = {unlike}",), (*TYPED[:2], Quantity(v, other, "v", "", (3,))))


@pytest.mark.parametrize(
    "between", [", ", r"\quad ", r", \qquad ", r"; \quad\quad ", r" \text{ and } ", r", \quad \mbox{and} \quad "]
)
def test_equations_of_one_row_stand_apart(between):
    first, second = read(
        (rf"\max(x, y) = y{between} \begin{{bmatrix}} x & y \end{{bmatrix}}^T = A \mathbf{{v}}.",), TYPED
    )
    assert first.sides == (Function("max")(x, y), y) and second.sides == (column(x, y), A * v)


@pytest.mark.parametrize(("latex", "hint"), [
    (r"[x, y]", "for a commutator: it can be each"),
    (r"\mathbf{I} y", "as an identity its size is open: write I_3"),
    (r"y \wedge \int x", r"write \times for a cross product"),
    (r"y + \int_0^t x \, dt", r"cannot read '\int_0^t x \, dt' in 'x = y + \int_0^t x \, dt': no integral and no sum"),
    (r"\frac{d}{dt} (x + y)", r"ẋ, ẏ is no letter of the table, and the rate is made of it"),
    (r"\frac{d}{dt} \int x", r"a rate is read of one letter that has a value, or of brackets"),
    (r"\{ x, y \}", "write an equation for each"),
])  # fmt: skip
def test_what_stays_refused_is_shown_as_it_is_typed_with_what_to_do(latex, hint):
    with pytest.raises(BoresightError) as refused:
        read((f"x = {latex}",), TYPED)
    assert hint in str(refused.value)


@pytest.mark.parametrize(
    "latex",
    [
        *(r"y + \cdots", r"y + \mathcal{O}(x^2)", r"\pm y", r"\int_0^x y", r"\frac{\partial x}{\partial y}"),
        *(
            r"\begin{cases} y & x \\ 0 & y \end{cases}",
            r"\begin{vmatrix} x & y \\ y & x \end{vmatrix}",
            r"y \text{ for } x",
        ),
        *(r"A \otimes A", r"A \otimes \mathbf{q}", r"\mathrm{diag}(\mathbf{v})", r"A^{x}", r"\sinh^{-1} y"),
    ],
)
def test_what_is_not_known_is_refused_and_never_read_otherwise(latex):
    with pytest.raises(BoresightError, match="cannot read"):
        read((f"x = {latex}",), TYPED)


def test_what_latex_sets_apart_is_no_command_of_the_same_letters():
    h, t = symbols("h t", real=True)
    letters = (*TYPED, Quantity(h, "h", "s", ""), Quantity(t, r"\tau", "s", ""), Quantity(y, r"\tau h", "s", ""))
    for latex, right in ((r"\sin h x", sin(h) * x), (r"\sinh x", sinh(x)), (r"\tau x h", t * x * h), (r"\tau h", y)):
        assert read((f"x = {latex}",), letters)[0].sides[1] == right
    with pytest.raises(BoresightError, match=r"cannot read '\\tauh'"):
        read((r"x = \tauh",), letters)


def test_what_can_be_read_in_two_ways_is_asked_for():
    with pytest.raises(BoresightError, match=r"write \\sin\^2\(x\), or \\sin\(\(x\)\^2\): this can be either"):
        read((r"x = \sin(y)^2",), TYPED)


def test_a_conjugate_and_an_inverse_of_a_quaternion_have_values():
    point = Point({"q": Matrix([1, 2, 3, 4]), "p": Matrix([2, 0, 0, 0])})
    assert [float(entry) for entry in evaluate(CONJ, point)] == [1, -2, -3, -4]
    inverse = [entry / 15 for entry in (1, -2, -3, -4)]
    assert [float(entry) for entry in evaluate(q**-1 * p, point)] == pytest.approx(inverse, abs=1e-15)


I3, I2 = (Symbol(f"I_{n}x{n}", commutative=False) for n in (3, 2))
B2 = Symbol("B", commutative=False)


@pytest.mark.parametrize(("latex", "right"), [
    (r"\begin{bmatrix} \mathbf I & -x A \\ 0 & \mathbf{I} \end{bmatrix}", matrix([[I3, -x * A], [0, I3]])),
    (r"\begin{bmatrix} y\mathbf I & B \\ B^T & \mathbf I \end{bmatrix}", matrix([[y * I3, B2], [transpose(B2), I2]])),
    (r"\begin{bmatrix} \mathbf I & 0 \\ \mathbf v^T & 1 \end{bmatrix}", matrix([[I3, 0], [transpose(v), 1]])),
    (r"A \mathbf I B", A * I3 * B2),
    (r"B \frac12 \mathbf I B^T", Mul(B2, Rational(1, 2), I2, transpose(B2), evaluate=False)),
])  # fmt: skip
def test_an_identity_has_the_size_of_what_stands_beside_it(latex, right):
    (relation,) = read((f"x = {latex}",), (*TYPED, Quantity(B2, "B", "m", "", (3, 2))))
    assert relation.sides[1] == right


@pytest.mark.parametrize(("latex", "asked"), [
    (r"\mathbf I \mathbf v", "before a vector it can be an identity, or a letter, as of inertia: write I_3, or add"),
    (r"A \mathbf I \mathbf v", "before a vector it can be an identity"),
    (r"\mathbf v^T \mathbf I A", "before a vector it can be an identity"),
    (r"\begin{bmatrix} \mathbf I & 0 \\ 0 & \mathbf I \end{bmatrix}", "as an identity its size is open: write I_3"),
    (r"\begin{bmatrix} \mathbf I & y \\ A & 0 \end{bmatrix}", "as an identity its size is open: write I_3"),
    (r"A \mathbf I B^T", "as an identity its size is open: write I_3"),
    (r"\frac{d}{dt} (x) y", r"write \left(\frac{d}{dt}(x)\right) y, or \frac{d}{dt}(x y): this can be either"),
    (r"\frac{d}{dt} (x)^2", r"write \left(\frac{d}{dt}(x)\right) y, or"),
    (r"\frac{d}{dt} x y", r"write \dot{x} y, or \frac{d}{dt}(x y): this can be either"),
    (r"\frac{d}{dt} (x x_2)", "ẋ_2 is no letter of the table, and the rate is made of it"),
    (r"\frac{d}{dt} \|\mathbf v\|", "a rate is read of one letter that has a value, or of brackets"),
    (r"\frac{d}{dt} (\|\mathbf v\|)", "no rate of norm(v) is read"),
])  # fmt: skip
def test_what_can_be_an_identity_or_a_rate_is_asked_for(latex, asked):
    with pytest.raises(BoresightError) as refused:
        read((f"A = {latex}",), RATES)
    assert asked in str(refused.value)


DOTTED = [(x, r"\dot{x}", ()), (y, r"\dot{y}", ()), (v, r"\dot{\mathbf{v}}", (3,)), (A, r"\dot{A}", (3, 3))]
RATES = (
    *TYPED,
    *(Quantity(rate_of(one), latex, "rate", "", shape) for one, latex, shape in DOTTED),
    Quantity(rate_of(x), r"\frac{d}{d t} x", "rate", ""),
    Quantity(Symbol("x_2", real=True), "x_2", "s", ""),
    Quantity(B2, "B", "m", "", (3, 2)),
)


@pytest.mark.parametrize("latex", [
    r"\frac{d}{dt} (A \mathbf v)", r"\frac{d}{dt} \left[ A \mathbf v \right]", r"\frac{d(A \mathbf v)}{dt}",
    r"\frac{\mathrm d}{\mathrm d t} \left( A \mathbf v \right)", r"\frac{{\rm d}}{{\rm d} t} (A \mathbf v)",
])  # fmt: skip
def test_the_rate_of_a_product_has_the_value_of_the_sum_of_products_with_rates(latex):
    (relation,) = read((rf"{latex} = \dot{{A}} \mathbf v + A \dot{{\mathbf v}}",), RATES)
    made = Matrix([[1, 2, 3], [0, 1, 4], [5, 6, 0]])
    values = {"A": made, "Ȧ": made.T, "v": Matrix([1, 2, 3]), "v̇": Matrix([7, 5, 3])}
    left, right = ([*map(str, evaluate(side, Point(values)))] for side in relation.sides)
    assert left == right
    assert names([relation]) == {"A", "v", "Ȧ", "v̇"}


@pytest.mark.parametrize("latex", [
    r"y \sin x^2 - \frac{x}{\sqrt{y}}",
    r"(A^T + A^{-1})^2 \mathbf v", r"[\mathbf v \times] A (\mathbf v \times A \mathbf v)",
   
    r"\begin{bmatrix} x \mathbf v \\ 1 \end{bmatrix}", r"\mathbf q \otimes \mathbf q^*",
])  # fmt: skip
def test_a_rate_is_the_limit_of_a_difference(latex):
    (relation,) = read((f"x = {latex}",), RATES)
    now = {
        "x": Matrix([0.7])[0],
        "y": Matrix([1.3])[0],
        "v": Matrix([1, 2, 3]),
        "A": Matrix([[1, 2, 3], [0, 1, 4], [5, 6, 1]]),
    }
    now["q"] = Matrix([1, 2, 3, 4])
    rates = {"ẋ": -2, "ẏ": 1, "v̇": Matrix([7, 5, 3]), "Ȧ": now["A"].T, "q̇": Matrix([0, 1, 0, 1])}
    with digits(60):
        step = exact("1e-20")
        found = evaluate(rate_of(relation.sides[1]), Point(now | rates))
        sides = [
            evaluate(relation.sides[1], Point({name: now[name] + rates[dotted(name)] * h for name in now}))
            for h in (step, -step)
        ]
        off = (sides[0] - sides[1]) / (2 * step) - found
        off, found = (list(one) if isinstance(one, Matrix) else [one] for one in (off, found))
        assert largest(off) < 1e-30 < largest(found)
