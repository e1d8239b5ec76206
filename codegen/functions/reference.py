"""SymPy matrices and their derivatives in many digits: straight-line Python over FLINT's balls, which carry their own
error bound.

This is the witness of the generated C: it shares the SymPy expressions with it and nothing else, neither CasADi nor its
differentiation nor the search for common subexpressions.
"""

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import sympy as sp
from flint import arb, ctx

from boresight import BoresightError
from boresight.derive.expressions import numeric

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
    matrices = [numeric(matrix) for matrix in matrices]
    lines: list[str] = []
    known: dict[Any, str] = {symbol: f"x[{i}]" for i, symbol in enumerate(symbols)}
    slopes: dict[tuple[Any, Any], str] = {}

    def named(text: str) -> str:
        lines.append(f"    t{len(lines)} = {text}")
        return f"t{len(lines) - 1}"

    def visit(e: Any) -> str:
        if e not in known:
            known[e] = named(printed(e))
        return known[e]

    def printed(e: Any) -> str:
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
            return chosen((visit(value), visit(test)) for value, test in e.args)
        if e.is_Add:
            return " + ".join(visit(part) for part in e.args)
        if e.is_Mul:
            return " * ".join(visit(part) for part in e.args)
        if e.is_Pow:
            exponent = sp.Rational(e.exp) if e.exp.is_Float else e.exp
            if not exponent.is_Rational or exponent.q > 2:
                return f"({visit(exponent)} * {visit(e.base)}.log()).exp()"
            base = visit(e.base) if exponent.q == 1 else named(f"{visit(e.base)}.sqrt()")
            power = whole(base, abs(exponent.p))
            return power if exponent.p > 0 else f"1 / ({power})"
        if isinstance(e, sp.Max | sp.Min):
            first, *others = map(visit, e.args)
            return first + "".join(f".{e.func.__name__.lower()}({other})" for other in others)
        if e.func in FUNCTIONS:
            return FUNCTIONS[e.func].format(*(visit(part) for part in e.args))
        raise BoresightError(f"the reference cannot evaluate {e.func.__name__} in {e}; write it with what C has")

    def whole(base: str, n: int) -> str:
        if n <= 8:
            return " * ".join([base] * n)  # FLINT's own power of a ball at zero knows nothing
        half = named(whole(base, n // 2))
        return " * ".join([half, half] + [base] * (n % 2))

    def chosen(cases: Iterable[tuple[str, str]]) -> str:
        return " else ".join(f"{value} if {test}" for value, test in cases) + " else arb.nan()"

    def slope(e: Any, s: sp.Symbol) -> str:
        """What holds d(e) / d(s); empty where e does not depend on s."""
        if (e, s) not in slopes:
            slopes[e, s] = named("arb(1)") if e == s else differentiated(e, s)
        return slopes[e, s]

    def differentiated(e: Any, s: sp.Symbol) -> str:
        if isinstance(e, sp.Piecewise):
            cases = [(slope(value, s), visit(test)) for value, test in e.args]
            return named(chosen((value or "arb(0)", test) for value, test in cases)) if any(v for v, _ in cases) else ""
        if isinstance(e, sp.sign):
            return ""
        if isinstance(e, sp.Max | sp.Min):
            value, rate = visit(e.args[0]), slope(e.args[0], s)
            for part in e.args[1:]:  # where both are one, half of either slope
                other, by = visit(part), slope(part, s)
                a, b = (value, other) if isinstance(e, sp.Max) else (other, value)
                rate, by = rate or "arb(0)", by or "arb(0)"
                cases = [(rate, f"{a} > {b}"), (by, f"{a} < {b}"), (f"({rate} + {by}) / 2", f"{a} == {b}")]
                rate = named(chosen(cases))
                value = named(f"{value}.{e.func.__name__.lower()}({other})")
            return rate
        terms = [(i, slope(part, s)) for i, part in enumerate(e.args)]
        parts = [name if e.is_Add else f"{visit(partial(e, i))} * {name}" for i, name in terms if name]
        return named(" + ".join(parts)) if parts else ""

    if by:
        outputs = [
            {(i, j): name for i, entry in enumerate(m) for j, s in enumerate(by) if (name := slope(entry, s))}
            for m in matrices
        ]
    else:
        outputs = [{place: visit(entry) for place, entry in sp.Matrix(m).todok().items()} for m in matrices]
    body = "\n".join(lines)
    listed = ", ".join("{" + ", ".join(f"{place}: {name}" for place, name in one.items()) + "}" for one in outputs)
    namespace: dict[str, Any] = {"arb": arb}
    exec(compile(f"def run(x):\n{body}\n    return [{listed}]\n", "<reference>", "exec"), namespace)
    run = namespace["run"]

    def evaluate(values: Sequence[Any]) -> list[Entries]:
        with precise():
            results = run([arb(value) for value in values])
            return [{place: value for place, value in one.items() if not value.is_zero()} for one in results]

    return evaluate


def partial(e: Any, i: int) -> Any:
    """The derivative of a product, a power or a function by its argument i."""
    if e.is_Mul:
        return sp.Mul(*(part for k, part in enumerate(e.args) if k != i))
    if e.is_Pow:
        return e.exp * e.base ** (e.exp - 1) if i == 0 else e * sp.log(e.base)
    return e.fdiff(i + 1)
