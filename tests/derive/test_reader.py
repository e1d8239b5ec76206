"""The reader of printed LaTeX: what it reads it reads in the order of the page, what it does not know it refuses."""

import pytest
from sympy import Function, MatAdd, MatMul, StrictLessThan, Symbol, cos, sin, sqrt, symbols, tan
from sympy.functions.elementary.complexes import transpose

from boresight import BoresightError
from boresight.derive.ledger.equation import Quantity, column, matrix
from boresight.derive.ledger.evaluate import Point, evaluate
from boresight.derive.ledger.reader import read

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
