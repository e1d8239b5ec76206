"""What a model must be so that a filter and its C can be made from it.

A message begins with the line in which the part at fault is written, names it, and says what to do.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass, fields
from functools import cache
from math import isfinite, pi, sqrt
from numbers import Integral, Real
from types import UnionType
from typing import TYPE_CHECKING, Any, NoReturn, Union, get_args, get_origin, get_type_hints

import sympy
from sympy import Expr, I, Matrix, MatrixBase, Symbol, nan, oo, zoo
from sympy.core.function import AppliedUndef
from sympy.matrices.expressions.matexpr import MatrixElement

from boresight.derive.expressions import numeric, parts_of, symbols_in
from boresight.errors import BoresightError, did_you_mean

if TYPE_CHECKING:
    from boresight.derive.model import Model, Variable

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")
RESULTS = ("F", "Phi", "Q", "Qc")  # the functions of models with states
ORDERS = (1, 2, 3)  # of Phi
ERRORS: tuple[str, str] = ("computed - true", "true - computed")
# C's own words: no symbol may be one, though it stands in C only within longer names.
KEYWORDS = """
    auto break case char const continue default do double else enum extern float for goto if inline int long register
    restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
    bool true false asm NULL NAN INFINITY HUGE_VAL size_t offsetof isnan isinf isfinite signbit errno assert
"""
# Names that mean something in the generated C already.
TAKEN = f"""{KEYWORDS}
    sin cos atan2 sqrt fabs exp log asin acos atan sinh cosh tanh
    x z R P status filter innovation rows gate iterations covariance next arg res iw w mem
"""
# What the functions of the filter call numbers of their own, and those of loops.
OF_FILTER = "i j k l m p q trial layout columns row_start found gates target answer L D"
OF_LOOPS = "f rate K sum h third share weight places stage at"
# Types of the live loop, and what its functions call numbers of their own.
OF_LIVE = "live sample carried message output past waiting correction events"
IN_LIVE = """
    now before part mean span from to last then missing after best means apart sigma other density seeming root
    expected still change between turn k
"""
UNDEFINED = {nan, zoo, oo, -oo, I}
LARGEST = 1e18  # of a box
UNEVALUATED = (sympy.Derivative, sympy.Integral, sympy.Sum, sympy.Product, sympy.Limit, AppliedUndef)
OF_UNIT = ("_nz", "_kernel", "_checked", "_shared", "_batch", "_bound")  # what is made of a function's name
OF_OUTPUT = ("_nz", "_nz_made", "_index", "_least", "_most")
OF_FIELD = ("_low", "_high")


def kind(part: Any) -> str:
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", type(part).__name__).lower()


def fail(part: Any, text: str) -> NoReturn:
    """Raise BoresightError about a part of a model, at the line where it is written."""
    place = f"{part.where}: " if getattr(part, "where", "") else ""
    name = getattr(part, "name", "")
    raise BoresightError(f"{place}{kind(part)} {name}: {text}" if name else f"{place}{kind(part)}: {text}")


# ---------------------------------------------------------------- one part


def check_part(part: Any) -> None:
    """Raise BoresightError unless each field holds what its annotation says."""
    for name, hint in hints(part.__class__).items():
        wrong = mismatch(getattr(part, name), hint, name)
        if wrong:
            fail(part, wrong)
    empty = next((name for name in ("fields", "outputs") if getattr(part, name, None) == ()), "")
    if empty:
        fail(part, f"{empty} is empty; give at least one, or leave the {kind(part)} out")
    if isinstance(getattr(part, "value", None), MatrixBase) and 0 in part.value.shape:
        fail(part, "value has no entry; give at least one, or leave the output out")


@cache
def hints(cls: Any) -> dict[str, Any]:
    found = get_type_hints(cls)
    return {field.name: found[field.name] for field in fields(cls) if field.init}


def mismatch(value: Any, hint: Any, name: str) -> str:
    """What is wrong with a value that should be of this type, and what to write; nothing if it is right."""
    origin, inner = get_origin(hint), get_args(hint)
    if origin in (Union, UnionType):
        found = [mismatch(value, one, name) for one in inner if one is not type(None)]
        return "" if (value is None and type(None) in inner) or not all(found) else found[-1]
    if origin is tuple:
        return mismatch_of_tuple(value, inner, name)
    if hint is str and isinstance(value, str) and ("*/" in value or "\n" in value):
        return f"{name} is {value!r}, which would end a comment in C; write one line without '*/'"
    accepted: Any = {float: Real, int: Integral, Matrix: MatrixBase}.get(hint, hint)
    right = hint is Any or (isinstance(value, accepted) and (hint is bool or not isinstance(value, bool)))
    return "" if right else f"{name} is {described(value)}; {instead(value, hint)}"


def mismatch_of_tuple(value: Any, inner: tuple[Any, ...], name: str) -> str:
    if not isinstance(value, tuple):
        one = inner[0]
        if not mismatch(value, one, name):
            shown = repr(value) if isinstance(value, str) else "..."
            return f"{name} is {described(value)}, not a tuple; a tuple of one has a comma: ({shown},)"
        return f"{name} is {described(value)}; write a tuple, in round brackets: (a, b), or (a,) of one"
    if inner[-1] is not Ellipsis and len(value) != len(inner):
        return f"{name} has {len(value)} entries; it needs {len(inner)}"
    expected = [inner[0]] * len(value) if inner[-1] is Ellipsis else inner
    wrong = (mismatch(one, hint, f"{name}[{i}]") for i, (one, hint) in enumerate(zip(value, expected, strict=True)))
    return next((text for text in wrong if text), "")


def described(value: Any) -> str:
    if value is None or isinstance(value, str | bool | int | float):
        return repr(value)
    name = type(value).__name__
    named = f" {value.name}" if isinstance(getattr(value, "name", None), str) else ""
    return f"{'an' if name[0] in 'AEIOUaeiou' else 'a'} {name}{named}"


def instead(value: Any, hint: Any) -> str:
    """What to write in the place of a value of the wrong type."""
    if hint is Matrix:
        if kind(value) == "variable":
            return "its column of symbols is its .vector"
        if type(value).__module__.startswith("numpy"):
            return "write Matrix(array.tolist()), with Matrix from sympy"
        return "write Matrix([...]), with Matrix from sympy"
    if hint is Symbol and kind(value) == "variable":
        return "its symbol is its .scalar"
    if getattr(hint, "__name__", "") == "Variable" and isinstance(value, Symbol):
        return "give the variable that it belongs to"
    if hint is float and isinstance(value, Expr):
        return "write float(...) of it"
    if callable(value):
        return "call it"
    plain = {str: "a text", float: "a number", int: "a whole number", bool: "True or False"}
    return f"give {plain.get(hint) or described_type(hint)}"


def described_type(hint: Any) -> str:
    name = getattr(hint, "__name__", str(hint))
    return f"{'an' if name[0] in 'AEIOU' else 'a'} {name}"


def check_variable(item: "Variable") -> None:
    """Raise BoresightError unless it has a box for each symbol, a norm that a point of the box can have, and the frame
    of its name."""
    check_box(item)
    check_norm(item)
    check_frame(item)


# The end of a name that says a frame, and what the frame of the other kind is called.  `_e` may be an axis, east.
ENDS = {"_n": ("the navigation frame", ("body",)), "_b": ("the body", ("NED", "ENU"))}


def check_frame(item: "Variable") -> None:
    for end, (words, others) in ENDS.items():
        if item.name.endswith(end) and any(item.frame.endswith(other) for other in others):
            fail(item, f"its name ends in {end}, of {words}, but frame is {item.frame!r}; change one of them")
    turn = re.match(r"[Cq]_([nb])2([nb])(?:_|$)", item.name)
    if turn and " to " in item.frame:
        sides = ("b" if "body" in side else "n" for side in item.frame.split(" to "))
        if tuple(sides) != turn.groups():
            fail(item, f"its name takes {turn[1]} to {turn[2]}, but frame is {item.frame!r}; change one of them")


def check_box(item: "Variable") -> None:
    for bound in (item.low, item.high):
        if len(bound) != len(item.symbols):
            given = f"{len(item.symbols)} components, but a box of {len(bound)}"
            fail(item, f"{given}; give one bound for all, or one for each")
    check_bounds(item, item.symbols)


def check_bounds(item: Any, components: tuple[Any, ...]) -> None:
    for symbol, low, high in zip(components, item.low, item.high, strict=True):
        if not (isfinite(low) and isfinite(high)):
            fail(item, f"the box of {symbol} is {low:.6g} to {high:.6g}; give finite bounds: tests draw points in it")
        if max(abs(low), abs(high)) > LARGEST:
            fail(item, f"the box of {symbol} is {low:.6g} to {high:.6g}; beyond {LARGEST:.0e} its square is no float")
        if not low < high:
            fail(
                item,
                f"the box of {symbol} is {low:.6g} to {high:.6g}; each lower bound of the box must lie below the upper "
                "one",
            )


# ---------------------------------------------------------------- the whole model


def check_norm(item: "Variable") -> None:
    if item.norm is None:
        return
    least, most = item.norm
    far = sqrt(sum(max(abs(low), abs(high)) ** 2 for low, high in zip(item.low, item.high, strict=True)))
    near = sqrt(sum(max(low, -high, 0.0) ** 2 for low, high in zip(item.low, item.high, strict=True)))
    if not 0 <= least < most:
        fail(item, f"norm is {item.norm}; give the least and the most, (0.99, 1.01) for a quaternion")
    if least > far or most < near:
        fail(item, f"norm is {item.norm}, but in its box norms are {near:.6g} to {far:.6g}; widen the box")


def check_model(model: "Model") -> None:
    """Raise BoresightError on parts that do not fit together: names, shapes, symbols, states that nothing touches."""
    check_names(model)
    check_given(model)
    check_rows(model)
    for item in expressions(model):
        check_shape(item)
    for item in expressions(model):
        check_kinds(item)
        check_symbols(model, item)
        check_constants(item)
    check_measurements(model)
    check_turns(model)
    check_noise(model)
    check_step(model)
    check_idle(model)
    check_carried(model)
    check_unheld(model)


def check_names(model: "Model") -> None:
    if not re.fullmatch(r"[a-z][a-z0-9]*(-[a-z0-9]+)*", model.name):
        fail(model, f"a name is lower-case words joined by '-'; write {suggested_name(model.name)!r}")
    if not re.fullmatch(r"[a-z][a-z0-9]*", model.c_prefix) or model.c_prefix in ("bs", *KEYWORDS.split()):
        fail(
            model,
            f"c_prefix {model.c_prefix!r} must be lower-case letters and digits, not 'bs' and no word of C; choose "
            "another",
        )
    variables = (*model.states, *model.inputs)
    check_places(model)
    by_field = unique((item, "field", item.name) for item in variables)
    unique((item, "symbol", symbol.name) for item in variables for symbol in item.symbols)
    # a state's index is a macro in upper case
    unique((item, "symbol", symbol.name.upper()) for item in model.states for symbol in item.symbols)
    by_unit = unique(
        [(model, "function", name) for name in (*RESULTS, *(["f"] if model.loops else [])) if model.n]
        + [(m, "measurement", m.name) for m in model.measurements]
        + [(m, "function", f"{m.name}_{part}") for m in model.measurements for part in "zhH"]
        + [(f, "function", f.name) for f in model.functions]
        + [(s, "struct", s.name) for s in model.structs]
    )
    for f in model.functions:
        unique((o, "output", o.name) for o in f.outputs)
    outputs = {o.name: o for f in model.functions for o in f.outputs}

    for table in (by_field, by_unit, outputs):
        for name, part in table.items():
            if not NAME.match(name):
                fail(part, f"{name!r} cannot be a name in C; write letters, digits and '_'")
            own = f"{OF_FILTER} {OF_LOOPS if model.loops else ''}" if kind(part) == "struct" else ""
            if table is by_unit and {"strapdown", "feedback"} <= {f.name for f in model.functions}:
                own += f" {OF_LIVE} {IN_LIVE if kind(part) == 'struct' else ''}"
            reserved = f"{TAKEN} {own}".split()
            if name in reserved or re.fullmatch(r"t\d+|(bs|BS)_.*|filter_.*", name):
                fail(part, f"the name {name!r} has a meaning in C or in the generated code; choose another")
    for item in variables:
        if not item.symbols:
            fail(item, "it has no component; name each of them, as in 'x y z'")
        for symbol in item.symbols:
            if not NAME.match(symbol.name):
                fail(item, f"the symbol {symbol.name!r} cannot be a name in C; write letters, digits and '_'")
            if symbol.name in KEYWORDS.split():
                fail(item, f"the symbol {symbol.name!r} has a meaning in C; choose another")
    inner = {**outputs, **by_field, **{s.name: s for s in model.structs}}
    made = {f"{name}{end}": name for name in outputs for end in OF_OUTPUT}
    made |= {f"{name}{end}": name for name in by_field for end in OF_FIELD}
    made |= {f"{f}_{s.name}": s.name for f in ("sin", "cos") for item in variables for s in item.symbols}
    for name, part in inner.items():
        if name in made:
            fail(part, f"the generated code makes {name!r} of {made[name]!r} for itself; choose another name")
    for name in by_unit:
        for end in OF_UNIT:
            if f"{name}{end}" in by_unit:
                taken = f"{name}{end}"
                fail(by_unit[taken], f"the generated code makes {taken!r} of {name!r} for itself; choose another name")
    for name, output in outputs.items():
        if name in {s.name for s in model.structs}:
            fail(output, f"{name!r} is the name of a struct too, and C passes both to one function; choose another")


def check_places(model: "Model") -> None:
    """Each variable stands in one place: among the states, or in one struct."""
    places: dict[Any, str] = {}
    every = [(block, "the states") for block in model.states]
    every += [(v, f"struct {s.name}") for s in model.structs for v in s.fields]
    for v, place in every:
        other = places.setdefault((v, v.where), place)
        if [one for one, _ in every if (one, one.where) == (v, v.where)] != [v]:
            second = next((p for one, p in every if (one, one.where) == (v, v.where) and p != other), "")
            both = f"in {other} and in {second}" if second else f"twice in {other}"
            fail(v, f"it stands {both}; leave it in one: a function reads what it needs of any")


def suggested_name(name: str) -> str:
    words = re.findall(r"[a-z0-9]+", re.sub(r"(?<=[a-z])(?=[A-Z])", "-", name).lower())
    return "-".join(words).lstrip("0123456789-") or "my-model"


def unique(named: Any) -> dict[str, Any]:
    """The part of each name; raises BoresightError on a name that two have."""
    parts: dict[str, Any] = {}
    for part, what, name in named:
        if name in parts:
            other = parts[name]
            owner = "a function of every model" if kind(other) == "model" else f"{kind(other)} {other.name}"
            at = f" in {other.where}" if other.where and kind(other) != "model" else ""
            fail(part, f"the {what} name {name!r} is used twice: it is that of {owner}{at}; choose another")
        parts[name] = part
    return parts


@dataclass(frozen=True)
class Expressions:
    """A matrix of the model with the names of its rows and columns; of a column, none for the latter."""

    part: Any
    label: str
    matrix: Matrix
    shape: tuple[int, int]
    rows: tuple[str, ...]
    columns: tuple[str, ...] = ()
    of_state: bool = False  # whether it may read the state

    def entry(self, i: int, j: int) -> str:
        """As `F[omega, theta]`."""
        names = [self.rows[i] if i < len(self.rows) else str(i)]
        names += [self.columns[j] if j < len(self.columns) else str(j)] if self.columns or self.shape[1] != 1 else []
        return f"{self.label}[{', '.join(names)}]"


def expressions(model: "Model") -> Iterator[Expressions]:
    """Every matrix that the model is given by."""
    n, x = model.n, tuple(symbol.name for symbol in model.x)
    noise, total = tuple(map(str, model.noise)), model.kind == "total-state"
    square = {"F": False, "Phi": False, "Q": total}
    columns = {"f": True, "next": True}
    for name in ("F", "f", "next", "Phi", "Q"):
        matrix = getattr(model, name, None)
        if matrix is not None and name in square:
            yield Expressions(model, name, matrix, (n, n), x, x, square[name])
        elif matrix is not None:
            yield Expressions(model, name, matrix, (n, 1), x, (), columns[name])
    if model.noise.rows:
        if model.G.rows or total or model.F is not None:
            yield Expressions(model, "G", model.G, (n, len(noise)), x, noise, total)
        yield Expressions(model, "noise", model.noise, (len(noise), 1), noise, (), total)
    for m in model.measurements:
        rows = len(m.rows)
        for name, shape in (("z", (rows, 1)), ("h", (rows, 1)), ("H", (rows, n))):
            matrix = getattr(m, name)
            if matrix is not None:
                yield Expressions(m, name, matrix, shape, m.rows, x if name == "H" else (), name == "h")
    sizes = {item.name: item for item in model.inputs}
    for f in model.functions:
        for o in f.outputs:
            known = sizes.get(o.name)
            named = tuple(s.name for s in known.symbols) if known and known.size == o.value.rows else ()
            yield Expressions(o, "value", o.value, o.value.shape, named, (), True)


def check_shape(item: Expressions) -> None:
    if item.matrix.shape != item.shape:
        rows = f": its rows are {', '.join(item.rows)}" if item.rows else ""
        turned = "; it is transposed: give its .T" if item.matrix.shape == item.shape[::-1] else rows
        fail(item.part, f"{item.label} has shape {item.matrix.shape}, not {item.shape}{turned}")


def entries_with(item: Expressions, wanted: Any) -> str:
    """The first entry that holds the expression."""
    for (i, j), value in item.matrix.todok().items():
        if wanted in parts_of([value]):
            return item.entry(i, j)
    return item.label


def check_kinds(item: Expressions) -> None:
    """What looks like a symbol of the model and is none, and what has no value where it matters."""
    strange = MatrixElement | AppliedUndef | sympy.DiracDelta
    for part in sorted((part for part in parts_of(item.matrix) if isinstance(part, strange)), key=str):
        if isinstance(part, MatrixElement):
            fail(
                item.part,
                f"{entries_with(item, part)} holds {part}, an entry of a MatrixSymbol, which is no variable of the "
                "model; take the symbols of one: its .symbols, or its .vector",
            )
        if isinstance(part, AppliedUndef) and part.args and all(arg.is_Symbol for arg in part.args):
            fail(
                item.part,
                f"{entries_with(item, part)} holds {part}, a function of {listed(map(str, part.args))}; a variable is "
                "a symbol: take its .scalar, or one of its .symbols",
            )
        if isinstance(part, sympy.DiracDelta):
            fail(
                item.part,
                f"{entries_with(item, part)} holds {part}, the slope of a sign, which has none at 0; write a Piecewise "
                "in the place of sign, or give h and let H be derived",
            )


def check_symbols(model: "Model", item: Expressions) -> None:
    states = set(model.x)
    owners = {symbol: variable for variable in (*model.states, *model.inputs) for symbol in variable.symbols}
    known = set(owners) if item.of_state else set(owners) - states
    for symbol in sorted(symbols_in(item.matrix) - known, key=str):
        at = entries_with(item, symbol)
        twin = next((owner for own, owner in owners.items() if own.name == symbol.name and own != symbol), None)
        if twin is not None:
            its = ".scalar" if twin.size == 1 else ".symbols"
            fail(
                item.part,
                f"{at} uses another {symbol} than variable {twin.name} ({twin.where}), which is declared as real; take "
                f"it from the variable's {its}",
            )
        if symbol in states:
            fail(item.part, f"{at} uses the state {symbol}, {OF_STATE[item.label]}")
        guess = did_you_mean(symbol.name, [own.name for own in owners])
        allowed = "no input or state" if item.of_state else "no input"
        fail(item.part, f"{at} uses {symbol}, which is {allowed}{guess}; add a variable for it to a Struct")


OF_STATE = {
    **dict.fromkeys(("F", "G", "Phi", "Q", "noise"), "which is an error: use f for x' = f(x) + G w"),
    "H": "which H may not: write h, whose Jacobian is printed as H",
    "z": "which z may not: it is made from inputs alone, and what the state predicts is h",
}


def check_constants(item: Expressions) -> None:
    parts = parts_of(item.matrix)
    for part in sorted((part for part in parts if isinstance(part, UNEVALUATED)), key=str):
        fail(
            item.part,
            f"{entries_with(item, part)} holds {part}, which is not evaluated; write its expression, or .doit()",
        )
    for part in sorted(UNDEFINED & parts, key=str):
        fail(
            item.part,
            f"{entries_with(item, part)} holds {part}, which is no real number: look for a division by zero, the root "
            "of a negative number or a constant that is not finite",
        )


def check_given(model: "Model") -> None:
    """What belongs together is there and nothing else: an error state has F, a total state f, or next with Q."""
    given = [name for name in ("F", "f", "next", "Phi") if getattr(model, name) is not None]
    if model.loops and model.f is None:
        already = "; an error state is carried by loops already" if model.F is not None else ""
        fail(model, f"loops are for the step of a total state that is flown by f{already}: leave loops out")
    if not model.n:
        if given or model.Q is not None or model.dt is not None or model.measurements:
            fail(
                model,
                "without states there is no F, f, next, Q, dt and no measurement; give states, or leave these out",
            )
        return
    follows = not given and all(mechanics_of(model))
    if len(given) != 1 and not follows:
        named = " and ".join(given) or "none"
        fail(
            model,
            f"give one of F or Phi, of an error state, and f or next, of a total state; given is {named}; where "
            "none is, F follows from functions strapdown and feedback",
        )
    if follows and model.G.rows:
        fail(model, "G follows from strapdown and from mechanics, as F does: leave it out, or give both")
    if model.exact and not follows:
        fail(model, "exact is for an error state whose Phi follows from strapdown and feedback: leave it out")
    discrete = "next" if model.next is not None else "Phi" if model.Phi is not None else ""
    if bool(discrete) != (model.Q is not None):
        fail(
            model,
            "next or Phi and Q, the covariance that the noise adds over the step, belong together; f and F have G and "
            "noise",
        )
    if discrete and (model.G.rows or model.noise.rows):
        fail(model, f"{discrete} has its noise in Q; G and noise belong to f and F")
    if not discrete and not model.noise.rows:
        fail(model, "give at least one noise: without one, the filter soon believes its state and takes no measurement")
    if model.error not in ERRORS:
        fail(model, f"error is {model.error!r}; it is {' or '.join(map(repr, ERRORS))}")
    if model.order not in ORDERS:
        fail(model, f"order is {model.order!r}; it is 1, 2 or 3")
    if model.kind == "error-state" and (model.Phi is not None or model.exact) and model.order != type(model).order:
        fail(model, f"order {model.order} is that of a series in F dt, which Phi here is not: leave order out")
    if model.kind == "total-state":
        flown = f"a total state is flown by {given[0]}"
        if model.order != type(model).order:
            fail(model, f"order {model.order} is that of an error state's Phi and Q; {flown}: leave order out")
        if model.error != ERRORS[0]:
            fail(model, f"error is the sign of an error state's errors; {flown}: leave error out")
        for f in model.functions:
            if f.name in ("feedback", "strapdown"):
                fail(f, f"{f.name} belongs to an error state, given by F; {flown} and holds what {f.name} would carry")
        if model.mechanics is not None:
            fail(model, f"mechanics belongs to an error state, given by F; {flown}")
    for item in model.inputs:
        if item.wraps:
            fail(item, "only a state wraps; an input is read as the caller gives it: leave wraps out")
    check_kept_norms(model)
    for block in model.states:
        if block.wraps and block.unit != "rad":
            fail(block, f"it wraps, but its unit is {block.unit!r}; angles in rad wrap")
        if block.wraps and not all(lo <= -pi and hi >= pi for lo, hi in zip(block.low, block.high, strict=True)):
            fail(block, "it wraps to [-pi, pi), which its box must hold; widen the box, or leave wraps out")


def mechanics_of(model: "Model") -> tuple[Any, Any]:
    """The strapdown and the feedback that hold for a model, of its mechanics or its own; None of what it has not."""
    own = {f.name: f for f in model.functions}
    strapdown, feedback = (
        (model.mechanics and getattr(model.mechanics, name)) or own.get(name) for name in ("strapdown", "feedback")
    )
    return strapdown, feedback


def check_kept_norms(model: "Model") -> None:
    """A state with a norm is a unit quaternion of a total state; no step and no update keeps another norm."""
    normed = [block for block in model.states if block.norm is not None]
    for block in normed:
        if model.kind != "total-state" or block.size != 4 or not block.unit_norm:
            fail(
                block,
                "it is a state with a norm, which no step and no update of a filter keeps but of a quaternion of a "
                "total state, of unit 1 and norm 1: make it an input of nav that an error state corrects by feedback, "
                "or leave norm out",
            )
    turning = next((block for block in model.states if normed and block.wraps), None)
    if turning is not None:
        fail(
            turning,
            f"it wraps beside the quaternion {normed[0].name}, whose model is made an error state; leave wraps out",
        )


def check_rows(model: "Model") -> None:
    """Each measurement has rows, and either h or H, or what these follow from."""
    fed = any(f.name == "feedback" for f in model.functions)
    for m in model.measurements:
        if m.at_zero and (not fed or m.z is None or m.H is not None):
            fail(m, "at_zero is for an error state with a feedback, and for a z that is given without H")
        own = m.first_order is not None and m.first_order.of is None
        if not m.rows:
            fail(m, "it has no row; name one for each scalar that is measured")
        if len({*m.rows}) < len(m.rows):
            fail(m, f"two of its rows have one name: {listed(m.rows)}; a filter masks rows by their names")
        if (m.H is None) == (m.h is None) and not (own and m.H is not None) and not (fed and m.z is not None):
            fail(m, "give either h or H, or both with a first_order of its own; of z alone H follows by a feedback")


def check_noise(model: "Model") -> None:
    """Each noise acts on a state; Q is symmetric."""
    for i in range(model.noise.rows if model.G.rows else 0):
        if model.noise[i].is_zero or model.G[:, i].is_zero_matrix:
            fail(model, f"noise {model.noise[i]} has no effect: it or column {i} of G is zero; leave it out")
    Q: Any = model.Q
    for at, difference in (Q - Q.T).todok().items() if Q is not None else ():
        if difference.simplify() != 0:
            fail(model, f"Q is not symmetric: {Q[at]} at {at} is {Q[at[::-1]]} at {at[::-1]}")


def check_measurements(model: "Model") -> None:
    estimated = {
        s
        for f in model.functions
        if f.name == "feedback"
        for o in f.outputs
        for v in model.inputs
        if v.name == o.name
        for s in v.symbols
    }
    for m in model.measurements:
        shown = [e for e in (m.h, m.z if m.h is None else None) if e is not None]
        if m.H.is_zero_matrix if m.H is not None else not symbols_in(*shown) & {*model.x, *estimated}:
            fail(m, f"it depends on no state; its h or H must use one of {', '.join(map(str, model.x))}")
        for name in m.angle if isinstance(m.angle, tuple) else ():
            if name not in m.rows:
                fail(m, f"angle names {name!r}, which is no row{did_you_mean(name, m.rows)}; rows are {listed(m.rows)}")
        check_box_of_z(m)
        if m.first_order is None:
            continue
        exact = [other.name for other in model.measurements if other.h is not None]
        named = m.first_order.of or m.name
        if named not in exact:
            guess = did_you_mean(named, exact)
            fail(m, f"first_order names {named!r}, which is no measurement with an h{guess}")
        inputs = [v.name for v in model.inputs]
        for item in (m.first_order.small, *(name for name, _ in m.first_order.tied)):
            if item is not None and item not in inputs:
                fail(m, f"first_order names {item!r}, which is no input{did_you_mean(item, inputs)}")


def check_turns(model: "Model") -> None:
    """A row in rad that grows with a state that wraps is an angle, or is said to be none."""
    wrapping = [symbol for block in model.states if block.wraps for symbol in block.symbols]
    for m in model.measurements if wrapping else ():
        if m.angle is not None:
            continue
        units = [unit.strip() for unit in m.unit.split(",")]
        of = m.h if m.h is not None else m.H * model.x
        label = "h" if m.h is not None else "H"
        for i, (row, unit) in enumerate(zip(m.rows, units * len(m.rows) if len(units) == 1 else units, strict=False)):
            grows = numeric(of[i : i + 1, :]).jacobian(wrapping) if unit == "rad" else []
            for symbol, by in zip(wrapping, grows, strict=False):
                if by != 0 and symbol not in by.free_symbols:
                    fail(
                        m,
                        f"{label}[{row}] turns with {symbol}, which wraps; give angle=True or the rows that are angles "
                        "(angle=False to mean it)",
                    )


def check_box_of_z(m: Any) -> None:
    if {len(m.low), len(m.high)} not in ({0}, {len(m.rows)}):
        fail(m, f"it has {len(m.low)} lower and {len(m.high)} upper bounds for {len(m.rows)} rows; give one for each")
    if m.low and m.z is not None:
        fail(m, "low and high bound a z that the caller brings; leave them out, since z is given")
    if m.low:
        check_bounds(m, m.rows)


def listed(names: Any) -> str:
    return ", ".join(names)


def check_step(model: "Model") -> None:
    """dt is an input, above zero; the step of a model in discrete time need not be named."""
    if not model.n or (model.discrete and model.dt is None):
        return
    owner = next((v for v in model.inputs if model.dt in v.symbols), None)
    if model.dt is None:
        fail(model, "dt is None, which is no input; give dt=, the symbol of the step's length, which is in a Struct")
    if owner is None:
        guess = did_you_mean(str(model.dt), [str(s) for v in model.inputs for s in v.symbols])
        fail(model, f"dt is {model.dt}, which is no input{guess}; add its variable to a Struct")
    if owner.low[owner.symbols.index(model.dt)] < 0:
        fail(owner, f"the box of {model.dt} reaches below zero; a step is forward in time")


def check_idle(model: "Model") -> None:
    """A constant is a state where something sees it; what nothing touches is refused."""
    if not model.n:
        return
    flow = next((m for m in (model.F, model.f, model.next, model.Phi) if m is not None), None)
    if flow is None:
        return
    seen = symbols_in(*(m.h for m in model.measurements if m.h is not None))
    for i, (symbol, block) in enumerate((s, item) for item in model.states for s in item.symbols):
        if model.F is not None or model.Phi is not None:
            rest = Matrix.eye(model.n) if model.F is None else Matrix.zeros(model.n)
            moves = any(flow[i, j] != rest[i, j] or flow[j, i] != rest[j, i] for j in range(model.n))
        else:
            rest = symbol if model.next is not None else 0
            moves = flow[i] != rest or any(symbol in flow[j].free_symbols for j in range(model.n) if j != i)
        driven = model.G.rows > i and any(model.G[i, j] != 0 for j in range(model.G.cols))
        driven = driven or (model.Q is not None and model.Q[i, i] != 0)
        seen_by_H = any(m.H is not None and not m.H[:, i].is_zero_matrix for m in model.measurements)
        if not (moves or driven or seen_by_H or symbol in seen):
            fail(
                block,
                f"the state {symbol} has no dynamics and no noise, and no other state or measurement uses it; couple "
                "it, or leave it out",
            )


def check_carried(model: "Model") -> None:
    """An output's box has a bound for each component; strapdown and feedback return inputs by their names."""
    inputs = {item.name: item for item in model.inputs}
    for o in (o for f in model.functions for o in f.outputs):
        if {len(o.low), len(o.high)} not in ({0}, {len(o.value)}):
            given = f"{len(o.low)} lower and {len(o.high)} upper bounds for {len(o.value)}"
            fail(o, f"its box has {given}; give one of each for each component, or none")
    for f in model.functions:
        for o in f.outputs if f.name in ("strapdown", "feedback") else ():
            if o.name not in inputs:
                guess = did_you_mean(o.name, list(inputs))
                fail(
                    o,
                    f"{f.name} returns {o.name!r}, which is no input{guess}; its outputs carry on the inputs of their "
                    "names",
                )
            if o.value.shape != (inputs[o.name].size, 1):
                fail(
                    o,
                    f"{f.name} returns {o.name} of shape {o.value.shape}; the input {o.name} has "
                    f"{(inputs[o.name].size, 1)}",
                )


def check_unheld(model: "Model") -> None:
    """What is listed as held against nothing is a function of the model, once, with a reason."""
    known = {f.name for f in model.functions} | {f"{m.name}_{part}" for m in model.measurements for part in "zhH"}
    known |= {"F", "G", "Phi", "Q", "next", "feedback", "strapdown"} if model.n else set()
    names = [name for name, _ in model.unheld]
    for name, reason in model.unheld:
        if name not in known:
            fail(model, f"unheld names {name!r}, which verify does not know{did_you_mean(name, sorted(known))}")
        if not reason.strip():
            fail(model, f"unheld gives no reason for {name!r}; say why nothing exact can be held against it")
        if names.count(name) > 1:
            fail(model, f"unheld names {name!r} twice; give one reason")
