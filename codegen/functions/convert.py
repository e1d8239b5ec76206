"""SymPy expressions to CasADi expressions: common subexpressions first, then a walk over the tree."""

import functools
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

import casadi as ca
import sympy as sp
from sympy.core import sorting

from boresight import BoresightError
from boresight.derive.expressions import numeric

MOST = sys.float_info.max
FUNCTIONS: dict[Any, Any] = {
    sp.sin: ca.sin,
    sp.cos: ca.cos,
    sp.exp: ca.exp,
    sp.log: ca.log,
    sp.asin: ca.asin,
    sp.acos: ca.acos,
    sp.atan: ca.atan,
    sp.atan2: ca.atan2,
    sp.sinh: ca.sinh,
    sp.cosh: ca.cosh,
    sp.tanh: ca.tanh,
    sp.sign: ca.sign,
    sp.Abs: ca.fabs,
}
LIBRARY = (sp.exp, sp.log, sp.asin, sp.acos, sp.atan, sp.sinh, sp.cosh, sp.tanh)
HAS = "+ - * / **, sqrt exp log, sin cos tan, asin acos atan atan2, sinh cosh tanh, Abs sign Max Min, Piecewise"


def to_casadi(matrices: list[sp.Matrix], symbols: Mapping[sp.Symbol, Any]) -> list[Any]:
    """Each matrix as a sparse SX of the same shape.  symbols: SX scalar for each free symbol.

    A power that is neither whole nor half is the exponential of a logarithm: its base must be positive.  Raises
    BoresightError on a function that flight C does not have.
    """
    with nodes_counted_once():
        replacements, reduced = sp.cse([sp.Matrix(numeric(matrix)) for matrix in matrices], order="canonical")
    known: dict[Any, Any] = dict(symbols)

    def walk(expression: Any) -> Any:
        if expression in known:
            return known[expression]
        known[expression] = result = build(expression)
        return result

    def build(e: Any) -> Any:
        if e.is_Number or e.is_NumberSymbol:
            if e.is_finite is False or abs(e) > MOST:
                raise BoresightError(f"the constant {e} is no finite double; a printed unit holds finite numbers only")
            return ca.SX(float(e))
        if e is sp.true or e is sp.false:
            return ca.SX(1.0 if e else 0.0)
        if e.is_Add:
            # what is subtracted is subtracted, not multiplied by -1 and added
            positive = [a for a in e.args if not a.could_extract_minus_sign()]
            negative = [-a for a in e.args if a.could_extract_minus_sign()]
            if not positive:
                return -chain(negative, lambda a, b: a + b)
            total = chain(positive, lambda a, b: a + b)
            for a in negative:
                total = total - walk(a)
            return total
        if e.is_Mul:
            if e.could_extract_minus_sign():
                return -walk(-e)
            coefficient, rest = e.as_coeff_Mul()
            if coefficient != 1:
                return ca.SX(float(coefficient)) * walk(rest)
            over, under = sp.fraction(e, exact=True)
            if under == 1:
                return chain(list(e.args), lambda a, b: a * b)
            return walk(over) / walk(under)
        if e.is_Pow:
            return power(e)
        if isinstance(e, LIBRARY) and e.is_number:
            if not e.is_real:
                raise BoresightError(f"{e} is no real number")
            return ca.SX(float(e))  # by mpmath: a library's last bit would be another one elsewhere
        arguments = [walk(a) for a in e.args] if not isinstance(e, sp.Piecewise) else []
        if e.func in FUNCTIONS:
            return FUNCTIONS[e.func](*arguments)
        if isinstance(e, sp.tan):
            return walk(sp.sin(*e.args)) / walk(sp.cos(*e.args))
        if isinstance(e, sp.Max | sp.Min):
            return functools.reduce(ca.fmax if isinstance(e, sp.Max) else ca.fmin, arguments)
        if isinstance(e, sp.Piecewise):
            *cases, (last, condition) = e.args
            if condition != sp.true:
                raise BoresightError(f"a Piecewise must end in an otherwise: {e}")
            result = walk(last)
            for value, test in reversed(cases):
                result = ca.if_else(walk(test), walk(value), result)
            return result
        if isinstance(e, sp.StrictLessThan):
            return arguments[0] < arguments[1]
        if isinstance(e, sp.LessThan):
            return arguments[0] <= arguments[1]
        if isinstance(e, sp.StrictGreaterThan):
            return arguments[1] < arguments[0]
        if isinstance(e, sp.GreaterThan):
            return arguments[1] <= arguments[0]
        if e.is_Symbol:
            raise BoresightError(f"the symbol {e} has no value here; name it among the model's inputs or states")
        raise BoresightError(f"{type(e).__name__} in {e} is no operation of flight C, which has {HAS}")

    def chain(terms: list[Any], operation: Any) -> Any:
        total = walk(terms[0])
        for term in terms[1:]:
            total = operation(total, walk(term))
        return total

    def power(e: Any) -> Any:
        base, exponent = e.args
        exponent = sp.Rational(exponent) if exponent.is_Float else exponent
        if exponent.is_Integer:
            if exponent < 0:
                return 1 / walk(base**-exponent)
            n = int(exponent)
            half = walk(base ** (n // 2))
            return half * half if n % 2 == 0 else half * half * walk(base)
        if exponent.is_Rational and exponent.q == 2:
            if exponent < 0:
                return 1 / walk(base**-exponent)
            root = ca.sqrt(walk(base))
            return root if exponent.p == 1 else walk(base ** (exponent.p // 2)) * root
        if base.is_positive is False:
            raise BoresightError(f"{e}: the base of a power that is neither whole nor half must be positive")
        return ca.exp(walk(exponent * sp.log(base)))

    for symbol, expression in replacements:
        known[symbol] = walk(expression)
    result = []
    for matrix in reduced:
        out = ca.SX(*matrix.shape)
        for (row, column), value in matrix.todok().items():
            out[row, column] = walk(value)
        result.append(out)
    return result


@contextmanager
def nodes_counted_once() -> Iterator[None]:
    """SymPy orders by the number of nodes, and counts a part that stands at many places at each of them: most of the
    time of nested rotations."""
    count = sorting._node_count
    sorting._node_count = functools.cache(count)
    try:
        yield
    finally:
        sorting._node_count = count
