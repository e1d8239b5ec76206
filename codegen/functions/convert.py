"""SymPy expressions to CasADi expressions: common subexpressions first, then a walk over the tree."""

import functools
import operator
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

import casadi as ca
import sympy as sp
from sympy.core import sorting

from boresight import BoresightError
from boresight.derive.expressions import names_in, numeric
from boresight.derive.named import Named

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


COMPARED: dict[Any, Any] = {
    sp.StrictLessThan: lambda a, b: a < b,
    sp.LessThan: lambda a, b: a <= b,
    sp.StrictGreaterThan: lambda a, b: b < a,
    sp.GreaterThan: lambda a, b: b <= a,
}


def to_casadi(
    matrices: list[sp.Matrix], symbols: Mapping[sp.Symbol, Any], names: dict[Named, Any] | None = None
) -> list[Any]:
    """Each matrix as a sparse SX of the same shape.  symbols: SX scalar for each free symbol.

    names: gets the SX of each named entry, with numbers in the place of its constants.

    A power that is neither whole nor half is the exponential of a logarithm: its base must be positive.  Raises
    BoresightError on a function that flight C does not have.
    """
    matrices = [numeric(matrix, names=True) for matrix in matrices]
    named = names_in(*matrices)
    values = sp.Matrix([entry.value for entry in named])
    with nodes_counted_once():
        replacements, reduced = sp.cse([*map(sp.Matrix, matrices), values], order="canonical")
    walk = Walk(symbols, dict([*replacements, *zip(named, reduced.pop(), strict=True)]))
    result = []
    for matrix in reduced:
        out = ca.SX(*matrix.shape)
        for (row, column), value in matrix.todok().items():
            out[row, column] = walk(value)
        result.append(out)
    if names is not None:
        names |= {entry: walk(entry) for entry in named}
    return result


class Walk:
    """An expression's SX, made of those of its arguments; each is made once.

    values: of common subexpressions and of names.
    """

    def __init__(self, symbols: Mapping[sp.Symbol, Any], values: Mapping[Any, Any]):
        self.known: dict[Any, Any] = dict(symbols)
        self.values = values

    def __call__(self, e: Any) -> Any:
        if e not in self.known:
            self.known[e] = self(self.values[e]) if e in self.values else self.built(e)
        return self.known[e]

    def built(self, e: Any) -> Any:
        if e.is_Number or e.is_NumberSymbol:
            if e.is_finite is False or abs(e) > MOST:
                raise BoresightError(f"the constant {e} is no finite double; a printed unit holds finite numbers only")
            return ca.SX(float(e))
        if e is sp.true or e is sp.false:
            return ca.SX(1.0 if e else 0.0)
        if e.is_Add:
            return self.sum(e)
        if e.is_Mul:
            return self.product(e)
        if e.is_Pow:
            return self.power(*e.args)
        if isinstance(e, sp.Piecewise):
            return self.piecewise(e)
        if isinstance(e, LIBRARY) and e.is_number:
            if not e.is_real:
                raise BoresightError(f"{e} is no real number")
            return ca.SX(float(e))  # by mpmath: a library's last bit would be another one elsewhere
        arguments = [self(a) for a in e.args]
        if e.func in FUNCTIONS:
            return FUNCTIONS[e.func](*arguments)
        if e.func in COMPARED:
            return COMPARED[e.func](*arguments)
        if isinstance(e, sp.tan):
            return self(sp.sin(*e.args)) / self(sp.cos(*e.args))
        if isinstance(e, sp.Max | sp.Min):
            return functools.reduce(ca.fmax if isinstance(e, sp.Max) else ca.fmin, arguments)
        if e.is_Symbol:
            raise BoresightError(f"the symbol {e} has no value here; name it among the model's inputs or states")
        raise BoresightError(f"{type(e).__name__} in {e} is no operation of flight C, which has {HAS}")

    def sum(self, e: Any) -> Any:
        """What is subtracted is subtracted, not multiplied by -1 and added."""
        positive = [a for a in e.args if not a.could_extract_minus_sign()]
        negative = [-a for a in e.args if a.could_extract_minus_sign()]
        if not positive:
            return -self.chain(negative, operator.add)
        total = self.chain(positive, operator.add)
        for a in negative:
            total = total - self(a)
        return total

    def product(self, e: Any) -> Any:
        if e.could_extract_minus_sign():
            return -self(-e)
        coefficient, rest = e.as_coeff_Mul()
        if coefficient == 2 and rest.is_Mul and all(not factor.args for factor in rest.args):
            return self.chain(e.args, operator.mul)  # of a quaternion: 2 w x and 2 w y share 2 w
        if coefficient != 1:
            return ca.SX(float(coefficient)) * self(rest)
        over, under = sp.fraction(e, exact=True)
        return self.chain(e.args, operator.mul) if under == 1 else self(over) / self(under)

    def chain(self, terms: Sequence[Any], operation: Callable[[Any, Any], Any]) -> Any:
        total = self(terms[0])
        for term in terms[1:]:
            total = operation(total, self(term))
        return total

    def power(self, base: Any, exponent: Any) -> Any:
        exponent = sp.Rational(exponent) if exponent.is_Float else exponent
        half = exponent.is_Rational and exponent.q == 2
        if (exponent.is_Integer or half) and exponent < 0:
            return 1 / self(base**-exponent)
        if exponent.is_Integer:
            n = int(exponent)
            root = self(base ** (n // 2))
            return root * root if n % 2 == 0 else root * root * self(base)
        if half:
            root = ca.sqrt(self(base))
            return root if exponent.p == 1 else self(base ** (exponent.p // 2)) * root
        if base.is_positive is False:
            raise BoresightError(
                f"{base**exponent}: the base of a power that is neither whole nor half must be positive"
            )
        return ca.exp(self(exponent * sp.log(base)))

    def piecewise(self, e: Any) -> Any:
        *cases, (last, condition) = e.args
        if condition != sp.true:
            raise BoresightError(f"a Piecewise must end in an otherwise: {e}")
        result = self(last)
        for value, test in reversed(cases):
            result = ca.if_else(self(test), self(value), result)
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
