"""The reader of printed LaTeX: what it reads it reads in the order of the page, what it does not know it refuses."""

import pytest
from sympy import Function, MatAdd, MatMul, Symbol, cos, sin, sqrt, symbols, tan

from boresight import BoresightError
from boresight.derive.equation import Quantity, column, matrix
from boresight.derive.reader import read

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


@pytest.mark.parametrize("latex", [r"\alpha = \gamma", r"\alpha = \frac{1}{2", r"\alpha + ", r"\alpha = \int \alpha"])
def test_what_is_not_known_is_refused_by_name(latex):
    with pytest.raises(BoresightError, match="cannot read"):
        read((latex,), TABLE)
