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
from boresight.derive.model import numeric

DIGITS = 50  # wanted of the largest number on the way
GUARD = 30  # digits beyond the wanted ones, which cancellation may take

Entries = dict[tuple[int, int], Any]  # a matrix as its non-zeros: (row, column) -> arb

FUNCTIONS = {
    sp.sin: "{0}.sin()",
    sp.cos: "{0}.cos()",
    sp.tan: "{0}.tan()",
    sp.atan2: "arb.atan2({0}, {1})",
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
        if e == sp.pi:
            return "arb.pi()"
        if e in (sp.true, sp.false):
            return str(bool(e))
        if isinstance(e, sp.Piecewise):
            return chosen((visit(value), visit(test)) for value, test in e.args)
        if e.is_Add:
            return " + ".join(visit(part) for part in e.args)
        if e.is_Mul:
            return " * ".join(visit(part) for part in e.args)
        if e.is_Pow and e.exp.is_Rational and e.exp.q in (1, 2):
            base = visit(e.base) if e.exp.q == 1 else named(f"{visit(e.base)}.sqrt()")
            power = " * ".join([base] * abs(e.exp.p))  # FLINT's own power of a ball at zero knows nothing
            return power if e.exp.p > 0 else f"1 / ({power})"
        if e.func in FUNCTIONS:
            return FUNCTIONS[e.func].format(*(visit(part) for part in e.args))
        raise BoresightError(f"the reference cannot evaluate {e.func.__name__} in {e}; write it with what C has")

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
        return e.exp * e.base ** (e.exp - 1)
    return e.fdiff(i + 1)
