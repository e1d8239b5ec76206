"""A model as text that can be read back: names, units, boxes and every expression, one entry per line.

It lies as equations.json among what is generated, so that two states of a model can be compared without running the
source of either.  `read_equations(equations_text(model))` equals the model, node by node of its expressions, but for
`mechanics`, from which nothing is generated.
"""

import ast
import json
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import MISSING, Field, fields, is_dataclass
from itertools import count
from keyword import iskeyword
from types import UnionType
from typing import Any, Union, get_args, get_origin, get_type_hints

import sympy as sp
from sympy.matrices import MatrixBase

from boresight import BoresightError
from boresight.derive.constant import Constant, behind, constant
from boresight.derive.expressions import constants_in
from boresight.derive.model import Mechanics, Model
from boresight.derive.named import Named, Quantity, named
from boresight.derive.named import numbered as numbered_labels

FILE = "equations.json"
FORMAT = 1
SHORT = 16  # characters: what is longer and stands in several places gets a name
WIDE = 100  # characters of a line that holds several values
SUM, PRODUCT, POWER, ATOM = range(4)  # how strongly a text holds together

FUNCTIONS = {
    function.__name__: function
    for function in (
        *(sp.sin, sp.cos, sp.tan, sp.asin, sp.acos, sp.atan, sp.atan2, sp.exp, sp.log, sp.sinh, sp.cosh, sp.tanh),
        *(sp.sqrt, sp.Abs, sp.sign, sp.Max, sp.Min, sp.Piecewise),
    )
}
NUMBERS = {"pi": sp.pi, "E": sp.E}  # a symbol of such a name, or of a keyword of Python, gets a _ in front
COMPARED: dict[Any, tuple[Any, str]] = {
    ast.Lt: (sp.StrictLessThan, "<"),
    ast.LtE: (sp.LessThan, "<="),
    ast.Gt: (sp.StrictGreaterThan, ">"),
    ast.GtE: (sp.GreaterThan, ">="),
}
SIGNS = dict(COMPARED.values())
# What the rows and columns of a matrix are called after: states x, noises w, the rows of its measurement.
AXES = {"F": "xx", "G": "xw", "Q": "xx", "f": "x", "next": "x", "z": "r", "h": "r", "H": "rx"}
Labels = Mapping[str, Sequence[str]]


def labels_of(states: Sequence[str], noise: Sequence[Any]) -> Labels:
    """x: the states; w: the noise densities by name, where each is an input of its own, else by number."""
    names = [density.name for density in noise if density.is_Symbol]
    return {"x": states, "w": names if len(set(names)) == len(noise) else numbered(len(noise))}


def numbered(count: int) -> list[str]:
    return [str(i + 1) for i in range(count)]


def places(name: str, shape: Sequence[int], labels: Labels) -> dict[str, tuple[int, int]]:
    """What each entry of a matrix is called, as `dv_e by dphi_n`, and its row and column."""
    rows, columns = (
        labels[axis] if axis and len(labels[axis]) == size else numbered(size)
        for axis, size in zip((*AXES.get(name, ""), "", "")[:2], shape, strict=True)
    )
    if shape[1] == 1:
        return {row: (i, 0) for i, row in enumerate(rows)}
    return {f"{row} by {column}": (i, j) for i, row in enumerate(rows) for j, column in enumerate(columns)}


# ---------------------------------------------------------------- written


def equations_text(model: Model) -> str:
    """The model as JSON: the same bytes for the same model."""
    words = Words(entry for matrix in matrices(model) for entry in matrix)
    body = encoded(model, words, labels_of([s.name for s in model.x], list(model.noise)))
    constants = {
        one.name: {"value": Words(())(one.value), "unit": one.unit, "meaning": one.meaning}
        for one in behind(constants_in(*matrices(model)))
    }
    beside = {"constants": constants, "named": words.named, "where": words.where}
    return laid_out({"format": FORMAT, **body, **beside}) + "\n"


def stated(kind: Any) -> dict[str, tuple[Field[Any], Any]]:
    """The fields that say what something is, and their types: not where it was written nor what it is held against."""
    hints = get_type_hints(kind)
    return {f.name: (f, hints[f.name]) for f in fields(kind) if f.init and Mechanics not in get_args(hints[f.name])}


def matrices(part: Any) -> Iterator[Any]:
    """Every matrix of a model or of a part of it, in the order of the fields."""
    if isinstance(part, MatrixBase):
        yield part
    elif isinstance(part, tuple):
        for item in part:
            yield from matrices(item)
    elif is_dataclass(part):
        for name in stated(type(part)):
            yield from matrices(getattr(part, name))


def encoded(part: Any, words: "Words", labels: Labels, name: str = "") -> Any:
    if is_dataclass(part):
        labels = {**labels, "r": getattr(part, "rows", ())}
        listed = ((key, field, getattr(part, key)) for key, (field, _) in stated(type(part)).items())
        return {key: encoded(v, words, labels, key) for key, f, v in listed if f.default is MISSING or v != f.default}
    if isinstance(part, tuple):
        return [encoded(item, words, labels) for item in part]
    if isinstance(part, MatrixBase):
        named = places(name, part.shape, labels)
        return {"shape": list(part.shape)} | {place: words(part[at]) for place, at in named.items() if part[at] != 0}
    return part.name if isinstance(part, sp.Symbol) else part


def laid_out(value: Any, indent: str = "") -> str:
    """JSON of which what fits on a line stands on one."""
    line = json.dumps(value, ensure_ascii=False)
    if len(indent) + len(line) <= WIDE or not isinstance(value, dict | list):
        return line
    inner = indent + " "
    if isinstance(value, dict):
        items = [f"{json.dumps(key, ensure_ascii=False)}: {laid_out(item, inner)}" for key, item in value.items()]
    else:
        items = [laid_out(item, inner) for item in value]
    left, right = "{}" if isinstance(value, dict) else "[]"
    return f"{left}\n{inner}" + f",\n{inner}".join(items) + f"\n{indent}{right}"


class Words:
    """Expressions as text; what stands in several places is written once, in `where`, as _1, _2, ...

    An entry of a named quantity is C_b2n(2, 1), f_n(3) or g(), and what the quantities are stands in `named`.
    """

    def __init__(self, expressions: Iterable[Any]):
        self.uses: Counter[Any] = Counter()
        self.known: dict[Any, tuple[str, int]] = {}
        self.where: dict[str, str] = {}
        self.named: dict[str, dict[str, Any]] = {}
        self.keys: dict[Quantity, str] = {}
        stack = list(expressions)
        quantities: set[Quantity] = set()
        self.uses.update(stack)
        while stack:
            part = stack.pop()
            if self.uses[part] > 0 and part not in self.known:
                self.known[part] = ("", ATOM)
                inner = part.args
                if isinstance(part, Named) and part.quantity not in quantities:
                    quantities.add(part.quantity)
                    inner = tuple(part.quantity.value)
                self.uses.update(inner)
                stack += inner
        self.known.clear()

    def __call__(self, expression: Any) -> str:
        return self.text(expression)[0]

    def text(self, e: Any) -> tuple[str, int]:
        if e not in self.known:
            text, level = self.written(e)
            if self.uses[e] > 1 and len(text) > SHORT and not e.is_Relational and not isinstance(e, sp.Tuple):
                name = f"_{len(self.where) + 1}"
                self.where[name] = text
                text, level = name, ATOM
            self.known[e] = text, level
        return self.known[e]

    def held(self, e: Any, level: int) -> str:
        text, own = self.text(e)
        return text if own >= level else f"({text})"

    def written(self, e: Any) -> tuple[str, int]:
        if e.is_Rational:
            text = str(e)
            return text, ATOM if text.isdigit() else PRODUCT if e > 0 else SUM
        if e.is_Float:
            return (repr(float(e)), ATOM) if e >= 0 else (repr(float(e)), SUM)
        if isinstance(e, Named):
            return f"{self.key(e.quantity)}({', '.join(at(e))})", ATOM
        if e.is_Symbol or isinstance(e, Constant):
            return f"_{e.name}" if iskeyword(e.name) or e.name in NUMBERS else e.name, ATOM
        if e.is_NumberSymbol or e in (sp.true, sp.false):
            return str(e), ATOM
        if e.is_Add:
            first, *rest = (self.held(term, SUM) for term in e.args)
            return first + "".join(f" - {t[1:]}" if t[0] == "-" else f" + {t}" for t in rest), SUM
        if e.is_Mul:
            return self.product(e)
        if e.is_Pow:
            base, exponent = e.args
            if exponent == sp.S.Half:
                return f"sqrt({self(base)})", ATOM
            if exponent.is_Rational and exponent < 0:
                return f"1/{self.divisor(e)}", PRODUCT
            return f"{self.held(base, ATOM)}**{self.held(exponent, ATOM)}", POWER
        if e.is_Relational:
            return f"{self(e.lhs)} {SIGNS[e.func]} {self(e.rhs)}", SUM
        arguments = ", ".join(map(self, e.args))
        return (f"({arguments})" if isinstance(e, sp.Tuple) else f"{e.func.__name__}({arguments})"), ATOM

    def key(self, one: Quantity) -> str:
        """What the quantity is called here; of several of one name the second has a 2 behind it."""
        if one not in self.keys:
            shape = one.value.shape
            values = {place: self(one.value[i]) for place, i in places("", shape, {}).items() if one.value[i] != 0}
            names = (one.name + f"_{i}" * (i > 1) for i in count(1))
            key = self.keys[one] = next(n for n in names if n not in self.named and n not in FUNCTIONS)
            components = {} if one.labels == tuple(numbered_labels(*shape)) else {"components": " ".join(one.labels)}
            self.named[key] = {"name": one.name, "meaning": one.meaning} | components
            self.named[key] |= {"value": {"shape": list(shape)} | values}
        return self.keys[one]

    def product(self, e: Any) -> tuple[str, int]:
        number, rest = e.as_coeff_Mul()
        factors = list(sp.Mul.make_args(rest))
        under = [f for f in factors if f.is_Pow and f.exp.is_Rational and f.exp < 0]
        over = [self.held(f, POWER) for f in factors if f not in under]
        if number.is_Rational:
            over = [str(abs(number.p))] * (abs(number.p) != 1 or not over) + over
            below = [str(number.q)] * (number.q != 1)
        else:
            over, below = [self.held(abs(number), POWER), *over], []
        text = "/".join(["*".join(over), *below, *map(self.divisor, under)])
        return (f"-{text}", SUM) if number < 0 else (text, PRODUCT)

    def divisor(self, e: Any) -> str:
        """What a power with a negative exponent divides by."""
        return self.held(e.base, POWER) if e.exp == -1 else self.held(sp.Pow(e.base, -e.exp, evaluate=False), POWER)


def at(entry: Named) -> tuple[str, ...]:
    """Row and column of the entry, as far as its quantity has several."""
    rows, columns = entry.quantity.value.shape
    place = [str(i + 1) for i in divmod(entry.index, columns)]
    return tuple(place[: (rows > 1 or columns > 1) + (columns > 1)])


# ---------------------------------------------------------------- read back


def read_equations(text: str, name: str) -> Model:
    """The model of such a text; name: where it comes from, for messages.  Raises BoresightError on any other text."""
    try:
        document = json.loads(text)
        if document["format"] != FORMAT:
            raise ValueError(f"its format is {document['format']}, not {FORMAT}")
        fields = [field for struct in document["structs"] for field in struct["fields"]]
        states = [symbol for state in document["states"] for symbol in state["symbols"]]
        names = [*states, *(symbol for field in fields for symbol in field["symbols"])]
        reader = Reader(names, document["constants"], document["where"], document.get("named", {}))
        noise = document.get("noise", {"shape": (0, 0)})
        labels = labels_of(states, list(reader.matrix(noise, places("noise", noise["shape"], {}))))
        made: Model = decoded(Model, document, reader, labels)
        return made
    except (ValueError, LookupError, TypeError, AttributeError, SyntaxError, RecursionError) as error:
        raise BoresightError(f"{name} cannot be read ({error}); generate the model again") from None


def decoded(kind: Any, value: Any, reader: "Reader", labels: Labels, name: str = "") -> Any:
    """The value of this type.  What a model had to pass when it was written is not asked again."""
    if is_dataclass(kind):
        labels = {**labels, "r": value.get("rows", ())}
        hints = {key: hint for key, (_, hint) in stated(kind).items() if key in value}
        return unchecked(kind, **{key: decoded(hint, value[key], reader, labels, key) for key, hint in hints.items()})
    if get_origin(kind) in (UnionType, Union):
        kinds = [one for one in get_args(kind) if isinstance(value, list) == (get_origin(one) is tuple)]
        return None if value is None else decoded(kinds[0], value, reader, labels, name)
    if get_origin(kind) is tuple:
        first, *others = get_args(kind)
        parts = [first] * len(value) if others == [...] else [first, *others]
        return tuple(decoded(one, item, reader, labels) for one, item in zip(parts, value, strict=True))
    if isinstance(kind, type) and issubclass(kind, MatrixBase):
        return reader.matrix(value, places(name, value["shape"], labels))
    return reader.symbols[value] if kind is sp.Symbol else value


def unchecked(kind: Any, **values: Any) -> Any:
    """A dataclass whose values are not looked at."""
    made = object.__new__(kind)
    for field in fields(kind):
        object.__setattr__(made, field.name, "" if field.default is MISSING else field.default)
    for name, value in values.items():
        object.__setattr__(made, name, value)
    return made


class Reader:
    """Expressions from their text.  Sums and products are made at once from all of their terms, as they were."""

    def __init__(
        self,
        names: Iterable[str],
        constants: Mapping[str, Mapping[str, str]],
        where: Mapping[str, str],
        named: Mapping[str, Any],
    ):
        self.symbols: dict[str, Any] = {name: sp.Symbol(name, real=True) for name in names}
        self.known: dict[str, Any] = {}
        self.where, self.listed = where, named
        self.quantities: dict[str, Any] = {}  # their entries
        for name, one in constants.items():
            self.symbols[name] = constant(name, self(one["value"]), one["unit"], one["meaning"])

    def matrix(self, value: Mapping[str, Any], named: Mapping[str, tuple[int, int]]) -> sp.ImmutableMatrix:
        made = sp.zeros(*value["shape"])
        for place, text in value.items():
            if place != "shape":
                made[named[place]] = self(text)
        return sp.ImmutableMatrix(made)

    def __call__(self, text: str) -> Any:
        return self.read(ast.parse(text, mode="eval").body)

    def read(self, node: ast.expr) -> Any:
        match node:
            case ast.Name(id=name):
                return self.named(name)
            case ast.Constant(value=bool() as truth):
                return sp.true if truth else sp.false
            case ast.Constant(value=int() | float() as number):
                return sp.sympify(number)
            case ast.BinOp(op=ast.Add() | ast.Sub()):
                return sp.Add(*self.terms(node))
            case ast.BinOp(op=ast.Mult() | ast.Div()) | ast.UnaryOp(op=ast.USub()):
                return sp.Mul(*self.factors(node))
            case ast.BinOp(op=ast.Pow()):
                return sp.Pow(self.read(node.left), self.read(node.right))
            case ast.Call(func=ast.Name(id=name)) if name in self.listed:
                rows = [ast.literal_eval(arg) - 1 for arg in node.args]
                return self.quantity(name)[(*rows, 0, 0)[:2]]
            case ast.Call(func=ast.Name(id=name)):
                return FUNCTIONS[name](*map(self.read, node.args))
            case ast.Compare(left=left, ops=[op], comparators=[right]):
                return COMPARED[type(op)][0](self.read(left), self.read(right))
            case ast.Tuple(elts=parts):
                return sp.Tuple(*map(self.read, parts))
        raise ValueError(f"no expression: {ast.unparse(node)}")

    def quantity(self, name: str) -> Any:
        if name not in self.quantities:
            one = self.listed[name]
            value = self.matrix(one["value"], places("", one["value"]["shape"], {}))
            self.quantities[name] = named(one["name"], value, one["meaning"], one.get("components", ""))
        return self.quantities[name]

    def named(self, name: str) -> Any:
        if name in self.where and name not in self.known:
            self.known[name] = self(self.where[name])
        if name in self.known:
            return self.known[name]
        return self.symbols[name.removeprefix("_")] if name not in NUMBERS else NUMBERS[name]

    def terms(self, node: ast.expr) -> list[Any]:
        found = []
        while isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
            minus = isinstance(node.op, ast.Sub)
            found.append(sp.Mul(-1, *self.factors(node.right)) if minus else self.read(node.right))
            node = node.left
        return [self.read(node), *reversed(found)]

    def factors(self, node: ast.expr) -> list[Any]:
        found = []
        while True:
            if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult | ast.Div):
                divides = isinstance(node.op, ast.Div)
                found.append(sp.Pow(self.read(node.right), -1) if divides else self.read(node.right))
                node = node.left
            elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
                found.append(sp.S.NegativeOne)
                node = node.operand
            else:
                return [self.read(node), *reversed(found)]
