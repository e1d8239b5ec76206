"""SymPy matrices and their derivatives in many digits: straight-line Python over FLINT's balls, which carry their own
error bound.

This is the witness of the generated C: it shares the SymPy expressions with it and nothing else, neither CasADi nor its
differentiation nor the search for common subexpressions.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import sympy as sp
from flint import arb, ctx

from boresight import BoresightError
from boresight.derive.expressions import numeric
from boresight.derive.named import Named

DIGITS = 50  # wanted of the largest number on the way
GUARD = 30  # digits beyond the wanted ones, which cancellation may take

Entries = dict[tuple[int, int], Any]  # a matrix as its non-zeros: (row, column) -> arb

FUNCTIONS = {
    sp.sin: "{0}.sin()",
    sp.cos: "{0}.cos()",
    sp.tan: "{0}.tan()",
    sp.atan2: "arb.atan2({0}, {1})",
    sp.exp: "{0}.exp()",
    sp.log: "{0}.log()",
    sp.asin: "{0}.asin()",
    sp.acos: "{0}.acos()",
    sp.atan: "{0}.atan()",
    sp.sinh: "{0}.sinh()",
    sp.cosh: "{0}.cosh()",
    sp.tanh: "{0}.tanh()",
    sp.Abs: "abs({0})",
    sp.sign: "{0}.sgn()",
    sp.StrictLessThan: "{0} < {1}",
    sp.LessThan: "{0} <= {1}",
    sp.StrictGreaterThan: "{0} > {1}",
    sp.GreaterThan: "{0} >= {1}",
}


def precise() -> Any:
    """The context in which balls are calculated with: elsewhere FLINT rounds to 15 digits."""
    return ctx.workdps(DIGITS + GUARD)


def evaluator(
    symbols: Sequence[sp.Symbol], matrices: Sequence[sp.Matrix], by: Sequence[sp.Symbol] = ()
) -> Callable[[Sequence[Any]], list[Entries]]:
    """f(values): the non-zeros of each of `matrices`, at values of the symbols, floats or balls.

    With `by`, the Jacobian of each, a column, by these symbols instead: the chain rule, step by step along the
    expressions.  Raises BoresightError on a function that it does not know.
    """
    matrices = [numeric(matrix, names=True) for matrix in matrices]
    program = Program(symbols)
    if by:
        outputs = [
            {(i, j): name for i, entry in enumerate(m) for j, s in enumerate(by) if (name := program.slope(entry, s))}
            for m in matrices
        ]
    else:
        outputs = [{place: program.value(e) for place, e in sp.Matrix(m).todok().items()} for m in matrices]
    run = program.compiled(outputs)

    def evaluate(values: Sequence[Any]) -> list[Entries]:
        with precise():
            results = run([arb(value) for value in values])
            return [{place: value for place, value in one.items() if not value.is_zero()} for one in results]

    return evaluate


class Program:
    """Straight-line Python: each expression, and each slope of one by a symbol, is a line with a name of its own."""

    def __init__(self, symbols: Sequence[sp.Symbol]):
        self.lines: list[str] = []
        self.values: dict[Any, str] = {symbol: f"x[{i}]" for i, symbol in enumerate(symbols)}
        self.slopes: dict[tuple[Any, Any], str] = {}

    def compiled(self, outputs: Sequence[Mapping[tuple[int, int], str]]) -> Callable[[list[Any]], list[Entries]]:
        """The function of x that returns what the names of `outputs` hold."""
        body = "\n".join(self.lines)
        listed = ", ".join("{" + ", ".join(f"{place}: {name}" for place, name in one.items()) + "}" for one in outputs)
        namespace: dict[str, Any] = {"arb": arb}
        exec(compile(f"def run(x):\n{body}\n    return [{listed}]\n", "<reference>", "exec"), namespace)
        run: Callable[[list[Any]], list[Entries]] = namespace["run"]
        return run

    def named(self, text: str) -> str:
        self.lines.append(f"    t{len(self.lines)} = {text}")
        return f"t{len(self.lines) - 1}"

    def value(self, e: Any) -> str:
        """The name of what holds the expression."""
        if e not in self.values:
            self.values[e] = self.value(e.value) if isinstance(e, Named) else self.named(self.printed(e))
        return self.values[e]

    def printed(self, e: Any) -> str:
        if e.is_Integer:
            return f"arb({int(e)})"
        if e.is_Rational:
            return f"arb({e.p}) / {e.q}"
        if e.is_Float:
            sign, man, exp, _ = e._mpf_
            return f"arb(({-int(man) if sign else int(man)}, {exp}))"
        if e in (sp.pi, sp.E):
            return "arb.pi()" if e == sp.pi else "arb.const_e()"
        if e in (sp.true, sp.false):
            return str(bool(e))
        if isinstance(e, sp.Piecewise):
            return chosen((self.value(value), self.value(test)) for value, test in e.args)
        if e.is_Add or e.is_Mul:
            return (" + " if e.is_Add else " * ").join(self.value(part) for part in e.args)
        if e.is_Pow:
            return self.power(e.base, sp.Rational(e.exp) if e.exp.is_Float else e.exp)
        if isinstance(e, sp.Max | sp.Min):
            first, *others = map(self.value, e.args)
            return first + "".join(f".{e.func.__name__.lower()}({other})" for other in others)
        if e.func in FUNCTIONS:
            return FUNCTIONS[e.func].format(*(self.value(part) for part in e.args))
        raise BoresightError(f"the reference cannot evaluate {e.func.__name__} in {e}; write it with what C has")

    def power(self, base: Any, exponent: Any) -> str:
        if not exponent.is_Rational or exponent.q > 2:
            return f"({self.value(exponent)} * {self.value(base)}.log()).exp()"
        root = self.value(base) if exponent.q == 1 else self.named(f"{self.value(base)}.sqrt()")
        power = self.whole(root, abs(exponent.p))
        return power if exponent.p > 0 else f"1 / ({power})"

    def whole(self, base: str, n: int) -> str:
        """A power as products: FLINT's own power of a ball at zero knows nothing."""
        if n <= 8:
            return " * ".join([base] * n)
        half = self.named(self.whole(base, n // 2))
        return " * ".join([half, half] + [base] * (n % 2))

    def slope(self, e: Any, s: sp.Symbol) -> str:
        """The name of what holds d(e) / d(s); empty where e does not depend on s."""
        if (e, s) not in self.slopes:
            self.slopes[e, s] = self.named("arb(1)") if e == s else self.differentiated(e, s)
        return self.slopes[e, s]

    def differentiated(self, e: Any, s: sp.Symbol) -> str:
        if isinstance(e, Named):
            return self.slope(e.value, s)
        if isinstance(e, sp.sign):
            return ""
        if isinstance(e, sp.Piecewise):
            cases = [(self.slope(value, s), self.value(test)) for value, test in e.args]
            if not any(value for value, _ in cases):
                return ""
            return self.named(chosen((value or "arb(0)", test) for value, test in cases))
        if isinstance(e, sp.Max | sp.Min):
            return self.extreme(e, s)
        terms = [(i, self.slope(part, s)) for i, part in enumerate(e.args)]
        parts = [name if e.is_Add else f"{self.value(partial(e, i))} * {name}" for i, name in terms if name]
        return self.named(" + ".join(parts)) if parts else ""

    def extreme(self, e: Any, s: sp.Symbol) -> str:
        """The slope of a Max or Min: where two parts are one, half of either's."""
        value, rate = self.value(e.args[0]), self.slope(e.args[0], s)
        for part in e.args[1:]:
            other, by = self.value(part), self.slope(part, s)
            a, b = (value, other) if isinstance(e, sp.Max) else (other, value)
            rate, by = rate or "arb(0)", by or "arb(0)"
            cases = [(rate, f"{a} > {b}"), (by, f"{a} < {b}"), (f"({rate} + {by}) / 2", f"{a} == {b}")]
            rate = self.named(chosen(cases))
            value = self.named(f"{value}.{e.func.__name__.lower()}({other})")
        return rate


def chosen(cases: Iterable[tuple[str, str]]) -> str:
    return " else ".join(f"{value} if {test}" for value, test in cases) + " else arb.nan()"


def partial(e: Any, i: int) -> Any:
    """The derivative of a product, a power or a function by its argument i."""
    if e.is_Mul:
        return sp.Mul(*(part for k, part in enumerate(e.args) if k != i))
    if e.is_Pow:
        return e.exp * e.base ** (e.exp - 1) if i == 0 else e * sp.log(e.base)
    return e.fdiff(i + 1)
