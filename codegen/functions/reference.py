"""SymPy matrices evaluated in many digits: straight-line Python over FLINT's balls, which carry their own error bound.

This is the witness of the generated C: it shares the SymPy expressions with it and nothing else, neither CasADi nor the
search for common subexpressions.  Numbers go in and come out as mpmath's.
"""

from collections.abc import Callable, Sequence
from typing import Any

import mpmath as mp
import sympy as sp
from flint import arb, ctx
from mpmath.libmp import from_man_exp

from boresight import BoresightError

GUARD = 30  # digits beyond the wanted ones, which cancellation may take

FUNCTIONS = {
    sp.sin: "{0}.sin()",
    sp.cos: "{0}.cos()",
    sp.tan: "{0}.tan()",
    sp.atan2: "arb.atan2({0}, {1})",
    sp.Abs: "abs({0})",
    sp.StrictLessThan: "{0} < {1}",
    sp.LessThan: "{0} <= {1}",
    sp.StrictGreaterThan: "{0} > {1}",
    sp.GreaterThan: "{0} >= {1}",
}


def evaluator(symbols: Sequence[sp.Symbol], matrices: Sequence[sp.Matrix]) -> Callable[[Sequence[Any], int], list[Any]]:
    """f(values, digits): one mp.matrix for each of `matrices`, at mpf values of the symbols, right to `digits` digits
    of the largest number on the way.  Raises BoresightError on a function that it does not know."""
    lines: list[str] = []
    known: dict[Any, str] = {symbol: f"x[{i}]" for i, symbol in enumerate(symbols)}

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
            cases = [(visit(value), visit(test)) for value, test in e.args]
            return " else ".join(f"{value} if {test}" for value, test in cases) + " else arb.nan()"
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

    outputs = [[visit(entry) for entry in sp.Matrix(m)] for m in matrices]
    body = "\n".join(lines)
    listed = ", ".join("[" + ", ".join(row) + "]" for row in outputs)
    namespace: dict[str, Any] = {"arb": arb}
    exec(compile(f"def run(x):\n{body}\n    return [{listed}]\n", "<reference>", "exec"), namespace)
    run, shapes = namespace["run"], [m.shape for m in matrices]

    def evaluate(values: Sequence[Any], digits: int) -> list[Any]:
        before = ctx.dps
        ctx.dps = digits + GUARD
        try:
            results = run([ball(value) for value in values])
            out = []
            for (rows, columns), flat in zip(shapes, results, strict=True):
                matrix = mp.zeros(rows, columns)
                for i, value in enumerate(flat):
                    if not value.is_zero():
                        matrix[i // columns, i % columns] = number(value)
                out.append(matrix)
            return out
        finally:
            ctx.dps = before

    return evaluate


def ball(value: Any) -> Any:
    """An mpf as a ball of radius zero."""
    sign, man, exp, _ = value._mpf_
    return arb((-int(man) if sign else int(man), exp))


def number(value: Any) -> Any:
    """The middle of a ball as an mpf, exactly; a ball that knows nothing (0/0) is NaN."""
    if not value.is_finite():
        return mp.nan
    man, exp = value.mid().man_exp()
    return mp.mp.make_mpf(from_man_exp(int(man), int(exp)))
