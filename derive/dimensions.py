"""Whether every term of a model has the unit that it must have.

Angle is weak: a sum may hold terms that differ in powers of rad, and so may an entry and what it stands for.  A bare
number has no unit, but zero has every unit.  What no unit shows, such as rad/s in the place of 1/s, is not seen.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

from sympy import (
    Abs,
    Max,
    Min,
    Mul,
    Piecewise,
    Symbol,
    acos,
    asin,
    atan,
    atan2,
    cos,
    pi,
    preorder_traversal,
    sign,
    sin,
    tan,
)

from boresight import BoresightError
from boresight.derive.checks import Expressions, expressions, fail
from boresight.derive.constant import Constant, behind
from boresight.derive.expressions import constants_in, symbols_in
from boresight.derive.model import Function, Measurement, Model, Output, Variable
from boresight.derive.named import Named
from boresight.derive.units import ONE, RADIAN, SECOND, Unit, unit, units

TURNS = 2  # of an angle: a box that is wider looks like one in degrees
LONG = 24  # nodes of a term that a message writes out
MIXED = "mixed"  # the unit of a matrix whose entries have different ones
DEGREES = [factor for part in (1, 60, 3600) for factor in (math.pi / 180 / part, 180 / math.pi * part)]
ROOT_SECOND = SECOND ** Fraction(1, 2)


class Mismatch(Exception):
    """Units that do not fit, in words."""


# ---------------------------------------------------------------- expressions


class Terms:
    """The unit of an expression from those of its symbols; each part is looked at once."""

    def __init__(self, symbols: Mapping[Symbol, Unit]):
        self.known: dict[Any, Unit | None] = dict(symbols)

    def __call__(self, e: Any) -> Unit | None:
        """None of zero, which has every unit.  Raises Mismatch."""
        if e not in self.known:
            self.known[e] = self._unit(e)
        return self.known[e]

    def _unit(self, e: Any) -> Unit | None:
        if isinstance(e, Constant):
            return unit(e.unit)
        if isinstance(e, Named):
            return self(e.value)
        if e.is_Symbol:
            raise Mismatch(f"reads {e}, of which no unit is known")
        if e.is_Number or e.is_NumberSymbol:
            return None if e == 0 else ONE
        if e.is_Add or isinstance(e, Max | Min):
            return self.alike(e, e.args)
        if e.is_Mul:
            return self._product(e)
        if e.is_Pow:
            return self._power(e)
        if isinstance(e, Piecewise):
            for _, condition in e.args:
                self._condition(condition)
            return self.alike(e, [value for value, _ in e.args])
        if isinstance(e, Abs):
            return self(e.args[0])
        if isinstance(e, atan2):
            self.alike(e, e.args)
            return RADIAN
        found = [self(part) for part in e.args]
        for part, u in zip(e.args, found, strict=True):
            turned = isinstance(e, sin | cos | tan)
            if u is not None and not isinstance(e, sign) and (u.powers if turned else not u.plain):
                takes = "an angle or a number" if turned else "a number"
                raise Mismatch(f"{e.func.__name__} takes {takes}, and {shown(part)} is {u}{advice(part)}")
        return RADIAN if isinstance(e, asin | acos | atan) else ONE

    def alike(self, e: Any, parts: Iterable[Any]) -> Unit | None:
        """The unit of all of the parts that are not zero; no power of rad is its own where they differ in it."""
        found = [(part, u) for part in parts if (u := self(part)) is not None]
        for part, u in found:
            first, other = found[0]
            if not u.like(other):
                what = "adds" if e.is_Add else "compares" if e.is_Relational else f"has {e.func.__name__} of"
                raise Mismatch(f"{what} {shown(first)}, which is {other}, and {shown(part)}, which is {u}"
                               + advice(first, part))  # fmt: skip
        rads = {u.rad for _, u in found}
        return Unit(found[0][1].powers, rads.pop() if len(rads) == 1 else None) if found else None

    def _product(self, e: Any) -> Unit:
        number, rest = e.as_coeff_Mul()
        factors = Mul.make_args(rest)
        exact = number.is_Rational and (
            (pi in factors and number.q % 180 == 0) or (1 / pi in factors and number.p % 180 == 0)
        )
        if exact or any(abs(abs(float(number)) / factor - 1) < 1e-5 for factor in DEGREES):
            raise Mismatch(f"turns degrees into rad, or back, by pi/180 in {shown(e)}; declare rad and convert at the "
                           "border")  # fmt: skip
        total = ONE
        for factor in factors:
            total *= self(factor) or ONE
        return total

    def _power(self, e: Any) -> Unit | None:
        base, exponent = self(e.base), self(e.exp)
        if exponent is not None and not exponent.plain:
            raise Mismatch(f"has the exponent {shown(e.exp)}, which is {exponent}; an exponent is a number")
        if base is None or base.plain:
            return base
        if not e.exp.is_Rational and not e.exp.is_Float:
            raise Mismatch(f"raises {shown(e.base)}, which is {base}, to {shown(e.exp)}; divide it by a scale first")
        return base ** Fraction(str(e.exp)).limit_denominator(24)

    def _condition(self, condition: Any) -> None:
        if condition.is_Relational:
            self.alike(condition, condition.args)
        else:
            for part in condition.args:
                self._condition(part)


def shown(e: Any) -> str:
    """The expression, or what a long one reads."""
    for count, _ in enumerate(preorder_traversal(e)):
        if count > LONG:
            letters = sorted(symbol.name for symbol in symbols_in([e]))
            return f"an expression of {', '.join(letters[:4])}{' ...' * (len(letters) > 4)}"
    return str(e)


def advice(*terms: Any) -> str:
    """What to do where a number may be the cause: 981/100, or one that is a whole term."""
    numbers = [term for term in terms if term.is_Number]
    numbers += [part for term in terms for part in term.args if part.is_Float or (part.is_Rational and part.q > 12)]
    return f"; {numbers[0]} has no unit, and if it stands for a quantity, make it a constant(...)" if numbers else ""


# ---------------------------------------------------------------- models

Need = Callable[[int, int], tuple[Unit, str] | None]  # of an entry, and what that is


def check_units(model: Model) -> None:
    """Raise BoresightError on a unit that is unknown or not coherent SI, on a box in degrees, and on a term whose unit
    is not that of what it is added to or stands for."""
    read = [v for v, _ in model.mechanics.step] if model.mechanics else []
    variables = list(dict.fromkeys((*model.states, *model.inputs, *read)))
    fields = {v.name: declared(v, v.unit, v.size) for v in variables}
    for v in variables:
        check_turns(v, fields[v.name])
    terms = Terms({s: u for v in variables for s, u in zip(v.symbols, fields[v.name], strict=True)})
    check_constants(model, terms)
    noise = [check_entry(model, f"noise[{w}]", w, None, terms) or ONE for w in model.noise]
    x = [u for v in model.states for u in fields[v.name]]
    check_densities(model, x, noise, terms)
    for item in (*expressions(model), *beside(model)):
        check_matrix(item, needed(item, x, noise, fields), terms)
    for density, increment in model.mechanics.driven if model.mechanics else ():
        made, added = fields[density.name][0] * ROOT_SECOND, fields[increment.name][0]
        if not made.like(added) and not made.like(added * SECOND):
            fail(
                density,
                f"it is that of {made}, or of {made / SECOND} as a rate, and {increment.name} is {added}; name what it "
                "adds to",
            )


def check_densities(model: Model, x: Sequence[Unit], noise: Sequence[Unit], terms: Terms) -> None:
    """A noise that G takes as it stands is the root of a density, of the state that it drives."""
    owners = {s: v for v in model.inputs for s in v.symbols}
    names = [s.name for s in model.x]
    for (i, j), value in model.G.todok().items():
        density, w = x[i] / ROOT_SECOND, model.noise[j]
        if not value.is_Number or noise[j].like(density):
            continue
        if w.is_Pow and w.exp == 2 and (base := terms(w.base)) is not None and base.like(density):
            fail(model, f"noise[{w}] is a square; noise is the root of a density: leave the square of {w.base} out")
        sample = noise[j].like(x[i]) or noise[j].like(x[i] / SECOND)
        hint = "; a sigma per sample is none: multiply it by the root of the sample time" if sample else ""
        named = f"{w} is" if w in owners else f"noise[{w}] is"
        fail(owners.get(w, model), f"{named} {noise[j]}; the root density that drives {names[i]} has {density}{hint}")


def declared(part: Any, text: str, count: int) -> list[Unit]:
    try:
        return units(text, count)
    except BoresightError as error:
        fail(part, str(error))


def check_turns(v: Variable, found: Sequence[Unit]) -> None:
    for symbol, low, high, u in zip(v.symbols, v.low, v.high, found, strict=True):
        most = max(abs(low), abs(high))
        if u == RADIAN and most > 2 * math.pi * TURNS and not v.wide:
            turns = f"the box of {symbol} goes to {most:.6g} rad, {most / 2 / math.pi:.3g} turns"
            fail(v, f"{turns}; if these are degrees write radians(...), and if it is meant wide=True")


def check_constants(model: Model, terms: Terms) -> None:
    """Each has a unit, which is that of its value, and a name of its own."""
    names: dict[str, Any] = {s.name: v for v in (*model.states, *model.inputs) for s in v.symbols}
    for one in behind(constants_in(*(item.matrix for item in expressions(model)))):
        (need,) = declared(one, one.unit, 1)
        other = names.setdefault(one.name, one)
        if other != one:
            fail(one, f"it is {float(one):.6g}, and something else has that name too: {other.meaning}; choose another")
        if one.value.atoms(Constant):
            check_entry(one, "its value", one.value, (need, "its unit"), terms)


def beside(model: Model) -> Iterator[Expressions]:
    """What is held against the model and not printed: its mechanics, and inputs that are tied to others."""
    stated = [
        (Output(name, matrix, "", ""), f"{m.name}, tied")
        for m in model.measurements
        for name, matrix in (m.first_order.tied if m.first_order else ())
    ]
    if mechanics := model.mechanics:
        functions: list[Function] = [one for one in (mechanics.strapdown, mechanics.feedback) if one]
        stated += [(output, "value") for function in functions for output in function.outputs]
        stated += [(Output(v.name, matrix, v.unit, ""), "step") for v, matrix in mechanics.step]
        stated += [(Output("axes", mechanics.level.axes, "1", ""), "level")] if mechanics.level else []
    for output, label in stated:
        yield Expressions(output, label, output.value, output.value.shape, ())


def needed(item: Expressions, x: Sequence[Unit], noise: Sequence[Unit], fields: Mapping[str, Sequence[Unit]]) -> Need:
    """The unit of each entry of a matrix, where it is known."""
    part, rows, columns = item.part, item.rows, item.columns
    if isinstance(part, Measurement):
        row = declared(part, part.unit, len(part.rows))
        if item.label == "H":
            return lambda i, j: (row[i] / x[j], f"{rows[i]} per {columns[j]}")
        return lambda i, j: (row[i], f"the unit of {part.name}")
    if isinstance(part, Output):
        return of_output(part, fields)
    laws: dict[str, Need] = {
        "f": lambda i, j: (x[i] / SECOND, f"{rows[i]} per second"),
        "F": lambda i, j: (x[i] / x[j] / SECOND, f"{rows[i]} per {columns[j]} and second"),
        "G": lambda i, j: (x[i] / noise[j] / ROOT_SECOND, f"{rows[i]} per {columns[j]} and root second"),
        "next": lambda i, j: (x[i], f"the unit of {rows[i]}"),
        "Phi": lambda i, j: (x[i] / x[j], f"{rows[i]} per {columns[j]}"),
        "Q": lambda i, j: (x[i] * x[j], f"{rows[i]} times {columns[j]}"),
    }
    return laws.get(item.label, lambda i, j: None)


def of_output(output: Output, fields: Mapping[str, Sequence[Unit]]) -> Need:
    """Of an output its own unit, and that of the field which it replaces."""
    size = output.value.rows
    field = fields.get(output.name)
    if output.unit == MIXED:
        return lambda i, j: None
    if field is None or len(field) != size:
        own = declared(output, output.unit, size)
        return lambda i, j: (own[i], "its unit")
    if output.unit:
        for a, b in zip(declared(output, output.unit, size), field, strict=True):
            if not a.like(b):
                fail(output, f"its unit is {output.unit}, and the input {output.name} that it replaces has {b}")
    return lambda i, j: (field[i], f"the unit of {output.name}")


def check_matrix(item: Expressions, need: Need, terms: Terms) -> None:
    entries = item.matrix.todok().items()
    try:
        for (i, j), value in entries:
            check_entry(item.part, item.entry(i, j), value, need(i, j), terms)
    except BoresightError as error:
        if item.label in ("F", "G", "H") and turns_over(entries, item.matrix.shape, need, terms):
            raise BoresightError(f"{error}; {item.label} is transposed: give its .T") from None
        raise


def turns_over(entries: Any, shape: tuple[int, int], need: Need, terms: Terms) -> bool:
    """Whether each entry has the unit of the place across the diagonal."""
    try:
        pairs = [(terms(value), need(j, i)) for (i, j), value in entries] if shape[0] == shape[1] else []
    except Mismatch:
        return False
    return bool(pairs) and all(u is None or w is None or u.like(w[0]) for u, w in pairs)


def check_entry(part: Any, entry: str, value: Any, need: tuple[Unit, str] | None, terms: Terms) -> Unit | None:
    """The unit of an entry."""
    try:
        found = terms(value)
    except Mismatch as error:
        fail(part, f"{entry} {error}" + (f"; {entry} is to be {need[0]}, {need[1]}" if need else ""))
    if need is not None and found is not None and not found.like(need[0]):
        fail(part, f"{entry} is {shown(value)}, which is {found}, and not {need[0]}, {need[1]}{advice(value)}")
    return found
