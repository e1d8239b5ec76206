"""The page of a model, an algorithm description: what it estimates and reads, its matrices block by block, its cycle.

Everything comes from the Model, so that one's own gets the same page.  A manifest, if the model is generated, adds the
names and costs of its C functions.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import count
from math import factorial
from typing import Any

from sympy import (
    Add,
    DiracDelta,
    Heaviside,
    ImmutableMatrix,
    Integer,
    Matrix,
    Mul,
    Piecewise,
    Pow,
    Rational,
    S,
    Symbol,
    cse,
    exp,
    eye,
    log,
    sign,
)
from sympy import Function as Letter
from sympy.core.function import AppliedUndef
from sympy.core.relational import GreaterThan, LessThan, StrictGreaterThan, StrictLessThan
from sympy.functions.elementary.complexes import transpose
from sympy.matrices import MatrixBase

from boresight import BoresightError
from boresight.derive.expressions import symbols_in, unnamed
from boresight.derive.ledger.equation import Quantity, Relation, as_written, product, total
from boresight.derive.letters import letter_latex
from boresight.derive.mechanics.rotation import skew
from boresight.derive.model import SPREAD, Measurement, Model, Variable
from boresight.derive.pages.named import (
    Named,
    Naming,
    component_letters,
    crossed,
    naming,
    nodes,
    operations,
    rebuilt,
)
from boresight.derive.pages.page import Block, Form, Formulas, Page, Pair, Prose, Section, Table

LONG = 150  # operations: what is longer is broken into parts that have letters
WIDE = 52  # characters: a matrix that is wider is given entry by entry
LETTERED = ("atan2", "Abs", "sign", "Max", "Min")  # functions that stand under their name
JACOBIAN = 60  # operations: a longer h or f is not differentiated for the reader

z_, h_, f_, F_, G_, H_, Q_, Q_c, S_, Phi = (
    Symbol(name, commutative=False) for name in ["z", "h", "f", "F", "G", "H", "Q", "Q_c", "S", "Phi"]
)


# ---------------------------------------------------------------- what the model states, with names


class Description:
    """A model's matrices with names put in, and the relations that a reader sees of them."""

    def __init__(self, model: Model, target: str = ""):
        self.model, self.target = model, target or model.name
        self.jacobians: set[str] = set()  # what has been differentiated here
        groups = dict(self.stated())
        self.naming: Naming = naming(model, groups)
        self.called = component_letters(model)
        self.counted = count(1)
        self.noise: list[tuple[Any, Any]] = []  # densities that are no inputs themselves
        self.shapes: dict[str, tuple[int, ...]] = {}
        for one in (*self.naming.vectors.values(), *self.naming.named):
            if one.entries.shape != (1, 1):
                self.shaped(one.letter, one.entries.shape)
        n, m = model.n, model.noise.rows
        for letter, shape in ((F_, (n, n)), (G_, (n, m)), (S_, (m, m)), (Q_, (n, n)), (Q_c, (n, n)), (Phi, (n, n))):
            self.shaped(letter, shape)
        for size in range(2, max(n, 6) + 1):
            self.shaped(identity(size), (size, size))

    def stated(self) -> Iterator[tuple[str, Matrix]]:
        model = self.model
        if model.discrete:
            if model.next is not None:
                yield "next", model.next
                yield from self._differentiated("Phi", model.next)
            else:
                yield "Phi", model.Phi
            yield "Q", model.Q
        elif model.n:
            if model.F is not None:
                yield "F", model.F
            else:
                yield "f", model.f
                yield from self._differentiated("F", model.f)
            yield "G", model.G
            yield "noise", model.noise
        for m in model.measurements:
            if m.z is not None:
                yield f"{m.name} z", m.z
            if m.h is not None:
                yield f"{m.name} h", m.h
                if m.H is None:
                    yield from self._differentiated(f"{m.name} H", m.h)
            if m.H is not None:
                yield f"{m.name} H", m.H
        for function in model.functions:
            for output in function.outputs:
                yield f"{function.name} {output.name}", output.value

    def _differentiated(self, key: str, column: Matrix) -> Iterator[tuple[str, Matrix]]:
        self.jacobians.add(key)
        if operations(unnamed(column)) < JACOBIAN:
            yield key, slopes(column, self.model.x)

    # ---- blocks of a matrix ------------------------------------------------------------------------------------

    def matrix(self, key: str, letter: Symbol, rows: Sequence["Part"], columns: Sequence["Part"]) -> list[Formulas]:
        """The blocks that are not zero, those that are a matrix with a name first as such; then what they need."""
        M = self.naming.groups[key]
        relations: list[tuple[Any, Any]] = []
        top = 0
        for row in rows:
            left = 0
            for column in columns:
                block = M[top : top + row.size, left : left + column.size]
                if not block.is_zero_matrix:
                    relations += self._block(letter, row, column, block)
                left += column.size
            top += row.size
        return self.formulas(relations)

    def _block(self, letter: Symbol, row: "Part", column: "Part", block: Matrix) -> Iterator[tuple[Any, Any]]:
        tree = self.written(block)
        if block.shape == (1, 1):
            yield self.label(letter, row.letter, column.letter), block[0] if tree is None else tree
        elif tree is not None or width(block) <= WIDE:
            yield self.label(letter, row.letter, column.letter, block.shape), block if tree is None else tree
        else:
            yield from self.entries(letter, row.letters, column.letters, block)

    def entries(
        self, letter: Symbol, rows: Sequence[Symbol], columns: Sequence[Symbol], block: Matrix
    ) -> list[tuple[Any, Any]]:
        return [
            (self.label(letter, a, b), block[i, j])
            for i, a in enumerate(rows)
            for j, b in enumerate(columns)
            if block[i, j] != 0
        ]

    def label(self, letter: Symbol, row: Symbol, column: Symbol, shape: tuple[int, ...] = ()) -> Symbol:
        """F_phi,dv_n: a block, or an entry, of F."""
        return self.shaped(Symbol(f"{letter}_{row},{column}", commutative=not shape), shape)

    def shaped(self, letter: Symbol, shape: tuple[int, ...]) -> Symbol:
        self.shapes[letter.name] = shape[:1] if shape[1:] == (1,) else shape
        return letter

    def column(self, key: str, letter: Symbol, names: Sequence[str]) -> list[tuple[Any, Any]]:
        """A vector: as a whole if it has a name or is narrow, else by its components; a matrix by its entries."""
        value = self.naming.groups[key]
        tree = self.written(value)
        if value.shape == (1, 1):
            return [(letter, value[0] if tree is None else tree)]
        if value.cols > 1:
            rows, columns = ([Symbol(str(i + 1)) for i in range(n)] for n in value.shape)
            return self.entries(letter, rows, columns, value)
        if tree is not None or width(value) <= WIDE:
            return [(self.shaped(letter, value.shape), value if tree is None else tree)]
        return [(Symbol(f"{letter}_{name}"), part) for name, part in zip(names, value, strict=True)]

    def written(self, block: Matrix) -> Any:
        """The block as a matrix or a vector that has a name, perhaps with a sign, or as a sum of vectors; or None."""
        for form, tree in self._forms(block):
            if block == form:
                return tree
            if block == -form:
                return product(S.NegativeOne, tree)
        return self._combination(block) if block.shape == (3, 1) else None

    def _forms(self, block: Matrix) -> Iterator[tuple[Matrix, Any]]:
        if block.rows == block.cols > 1:
            yield eye(block.rows), identity(block.rows)
        read = symbols_in(block)
        vectors = [v for v in self._vectors() if read & symbols_in(v.entries)]
        turning = [C for C in self.naming.named if C.entries.shape == (3, 3) and read & symbols_in(C.entries)]
        if block.shape == (3, 1):
            yield from ((v.entries, v.letter) for v in vectors)
            for C in turning:
                for matrix, letter in ((C.entries, C.letter), (C.entries.T, transpose(C.letter))):
                    for v in vectors:
                        yield matrix * v.entries, product(letter, v.letter)
                        for w in vectors if v.letter.name.startswith("omega") else ():
                            yield matrix * skew(v.entries) * w.entries, product(letter, crossed(v.letter), w.letter)
        if block.shape == (3, 3):
            yield from ((skew(v.entries), crossed(v.letter)) for v in vectors)
            for C in turning:
                for matrix, letter in ((C.entries, C.letter), (C.entries.T, transpose(C.letter))):
                    yield matrix, letter
                    for v in vectors:
                        yield matrix * skew(v.entries), product(letter, crossed(v.letter))

    def _vectors(self) -> list[Named]:
        return [one for one in (*self.naming.vectors.values(), *self.naming.named) if one.entries.shape == (3, 1)]

    def _combination(self, block: Matrix) -> Any:
        rows = [part.as_coefficients_dict() for part in block]
        parts = []
        for v in self._vectors():
            ratio = rows[0].get(v.entries[0], 0)
            if ratio in (1, -1) and all(row.get(s, 0) == ratio for row, s in zip(rows, v.entries, strict=True)):
                parts.append(v.letter if ratio == 1 else product(S.NegativeOne, v.letter))
        return (
            total(*sorted(parts, key=lambda part: part.is_Mul))
            if parts and all(len(row) == len(parts) for row in rows)
            else None
        )

    # ---- long expressions --------------------------------------------------------------------------------------

    def formulas(self, relations: Iterable[tuple[Any, Any]]) -> list[Formulas]:
        """The relations; where they are long, parts that stand in several places get letters of their own."""
        relations = list(relations)
        plain = [i for i, (_, right) in enumerate(relations) if isinstance(right, MATRICES) or right.is_commutative]
        entries = [
            e for i in plain for e in (relations[i][1] if isinstance(relations[i][1], MATRICES) else [relations[i][1]])
        ]
        where: list[Formulas] = []
        if operations(entries) > LONG:
            definitions, entries = self._parted(entries)
            where = [Formulas(tuple(Form(Relation((s, ordered(value)))) for s, value in definitions), "where")]
        left = iter(entries)
        for i in plain:
            value = relations[i][1]
            if isinstance(value, MATRICES):
                value = ImmutableMatrix(*value.shape, [ordered(next(left)) for _ in value])
            else:
                value = ordered(next(left))
            relations[i] = relations[i][0], value
        shown = Formulas(tuple(Form(Relation(pair)) for pair in relations))
        return [shown, *where] if relations else []

    def _parted(self, entries: list[Any]) -> tuple[list[tuple[Symbol, Any]], list[Any]]:
        replacements, reduced = cse(entries, symbols=(Symbol(f"#{i}") for i in count()), order="none")
        letters: dict[Any, Any] = {}
        definitions = []

        def put(expression: Any) -> Any:
            memo: dict[Any, Any] = {}

            def visit(part: Any) -> Any:
                if part not in memo:
                    memo[part] = letters[part] if part in letters else rebuilt(part, [visit(a) for a in part.args])
                return memo[part]

            return visit(expression)

        for symbol, value in replacements:
            value = put(value)
            if operations([value]) <= 2:
                letters[symbol] = value
            else:
                letters[symbol] = Symbol(f"t_{next(self.counted)}")
                definitions.append((letters[symbol], value))
        return definitions, [put(e) for e in reduced]


def slopes(column: Matrix, by: Matrix) -> Matrix:
    """The Jacobian of a column: at a corner the mean of both slopes, as in C, and of a jump none."""
    found = column.jacobian(by).replace(DiracDelta, lambda *_: S.Zero)
    return found.replace(Heaviside, lambda a, *_: (1 + sign(a)) / 2)


class Part:
    """Some rows or columns: a state, a noise, a measurement."""

    def __init__(self, letter: Symbol, letters: Sequence[Symbol]):
        self.letter, self.letters, self.size = letter, list(letters), len(letters)


MATRICES = MatrixBase


def identity(size: int) -> Symbol:
    return Symbol(f"I_{size}", commutative=False)


def width(matrix: Matrix) -> int:
    """About how many characters a matrix is wide."""
    if operations(matrix) > LONG:
        return LONG
    return sum(max(len(str(part)) for part in matrix[:, j]) + 2 for j in range(matrix.cols))


def ordered(expression: Any) -> Any:
    """As one would write it: numbers before letters before functions before sums, what is subtracted last."""
    if isinstance(expression, Piecewise):
        *cases, (last, _) = expression.args
        value = ordered(last)
        for then, condition in reversed(cases):
            value = _case(condition, ordered(then), value)
        return value
    if not expression.args or expression.is_Rational:
        return expression
    arguments = [ordered(argument) for argument in expression.args]
    if expression.is_Add:
        arguments.sort(
            key=lambda part: (part.could_extract_minus_sign(), not part.is_Number, operations([part]), written(part))
        )
        return as_written(Add, arguments)
    if expression.is_Mul:
        arguments.sort(key=_place)
        return as_written(Mul, arguments)
    if expression.is_Pow:
        if expression.exp.is_Rational:
            return Pow(*arguments, evaluate=False)
        return exp(ordered(expression.exp * log(expression.base)), evaluate=False)  # as C has it
    name = type(expression).__name__
    return Letter(name.lower())(*arguments) if name in LETTERED else expression.func(*arguments, evaluate=False)


@cache
def written(expression: Any) -> str:
    """Something to sort by; SymPy's own text takes longer than all the rest."""
    if not expression.args:
        return str(expression)
    return f"{type(expression).__name__}({','.join(map(written, expression.args))})"


def _place(factor: Any) -> tuple[int, str]:
    base, exponent = (factor, S.One) if isinstance(factor, exp) else factor.as_base_exp()
    kind = 0 if factor.is_Number else 1 if base.is_Symbol else 2 if base.is_Function else 3
    return kind + 4 * bool(exponent.is_number and exponent < 0), written(factor)


def _case(condition: Any, then: Any, otherwise: Any) -> Any:
    """below(a, b, then, else): `then` where a < b."""
    a, b = map(ordered, condition.args)
    below = Letter("below")
    if isinstance(condition, StrictLessThan):
        return below(a, b, then, otherwise)
    if isinstance(condition, StrictGreaterThan):
        return below(b, a, then, otherwise)
    if isinstance(condition, LessThan):
        return below(b, a, otherwise, then)
    if isinstance(condition, GreaterThan):
        return below(a, b, otherwise, then)
    raise BoresightError(f"a condition {condition} cannot be shown; use <, <=, > or >=")


# ---------------------------------------------------------------- the page


def model_page(model: Model, manifest: Mapping[str, Any] | None = None, target: str = "") -> Page:
    """manifest: of the generated C, if there is any.  target: how a command names the model, if not by its name."""
    shown = Description(model, target)
    units = (manifest or {}).get("units", {})
    sections = [
        *([Section("States", tuple(_states(model)), "states")] if model.n else []),
        Section("Inputs", tuple(_inputs(model)), "inputs"),
        *(_dynamics(shown, units) if model.n else []),
        *(_measurement(shown, m, units) for m in model.measurements),
        *([Section("One cycle of the filter", tuple(_cycle(model)), "cycle")] if model.n else []),
        *(_function(shown, f, units) for f in model.functions),
    ]
    used = {s for section in sections for form in forms(section) for s in letters_of(form.relation)}
    sections += names_of(shown, used)
    sections += [Section("C functions", tuple(_functions(model, units)), "c-functions"), *_equations(model)]
    lead = (f"{model.title[0].upper()}{model.title[1:]}.", f"Frame: {model.frame}.", *model.conventions)
    return lettered(shown, Page(model.name, tuple(sections), lead))


def formulas(model: Model) -> list[Form]:
    """Those of F, in discrete time those of the step, or of a model without states those of its functions."""
    sections = model_page(model).sections
    first = "F" if model.next is None else "step"
    chosen = [s for s in sections if s.anchor == first] or [s for s in sections if s.anchor.startswith("function-")]
    return [form for section in chosen for form in forms(section)]


def forms(section: Section) -> Iterator[Form]:
    for block in section.blocks:
        if isinstance(block, Formulas):
            yield from block.forms
        elif isinstance(block, Pair):
            yield from (*block.left.forms, *block.right.forms)
        elif isinstance(block, Table):
            yield from (form for row in block.rows for cell in row if not isinstance(cell, str) for form in cell)


def letters_of(relation: Relation) -> Iterator[Symbol]:
    for side in relation.sides:
        yield from (node for node in nodes([[side]]) if node.is_Symbol)


def form(*sides: Any) -> Form:
    return Form(Relation(sides))


def _variables(model: Model, listed: Iterable[Variable]) -> Table:
    """A row for each variable, and one for each component where they differ."""
    called = component_letters(model)
    rows: list[tuple[Any, ...]] = []
    for v in listed:
        units = v.unit.split(", ") if v.unit.count(",") == v.size - 1 else [v.unit] * v.size
        boxes = [_box(low, high) for low, high in zip(v.low, v.high, strict=True)]
        if v.norm:
            boxes = [f"norm {_box(*v.norm)}"] * v.size
        alike = len(set(zip(units, boxes, strict=True))) == 1
        symbols = [called[s] for s in v.symbols]
        heads, axes = zip(*(s.name.rpartition("_")[::2] for s in symbols), strict=True)
        if v.size > 1 and len(set(heads)) == 1 and heads[0]:
            symbols = [Symbol(f"{heads[0]}_{','.join(axes)}")]
        meaning = v.meaning + f" ({v.frame})" * bool(v.frame)
        letters: str | tuple[Form, ...] = tuple(map(form, symbols))
        if heads[0] == v.name or symbols[0].name == v.name:
            letters = ", ".join(axes) if v.size > 1 else ""
        rows.append(
            (
                v.name,
                (form(Symbol(v.name)),),
                letters if alike else (),
                units[0] if alike else "",
                boxes[0] if alike else "",
                meaning,
            )
        )
        if not alike:
            rows += [
                ("", "", (form(called[s]),), u, box, "") for s, u, box in zip(v.symbols, units, boxes, strict=True)
            ]
    head = ("name", "letter", "components", "unit", "valid", "meaning")
    return Table(head, tuple(rows), prose=5, typed=(0,), drawn=(1,))


def _box(low: float, high: float) -> str:
    if low == -high:
        return f"\N{PLUS-MINUS SIGN}{high:.6g}"
    if low > 0 and abs(2 - low - high) < 1e-12:  # of a unit quaternion
        return f"1 \N{PLUS-MINUS SIGN} {high - 1:.3g}"
    return f"{low:.6g} to {high:.6g}"


def _states(model: Model) -> Iterator[Block]:
    yield _variables(model, model.states)
    yield Prose(", ".join(s.name for s in model.x), "Components of x, as one types them", code=True)
    macro = f"{model.c_prefix}_IX_{model.x[0].name}".upper()
    yield Prose(f"In C they are macros in capitals: the first is `x[{macro}]`.")


def _inputs(model: Model) -> Iterator[Block]:
    if model.structs:
        first = model.structs[0]
        own = f"`{first.name}->{first.fields[0].name}` of `{model.c_prefix}_{first.name} *{first.name}`"
        yield Prose(f"In Python an input is given by its name; in C it is a field of its struct, as {own}.")
    for struct in model.structs:
        yield Prose(struct.meaning, struct.name)
        yield _variables(model, struct.fields)


def names_of(shown: Description, used: set[Symbol]) -> list[Section]:
    """The names that stand in the formulas, and the constants; what defines them is followed."""
    named: list[tuple[Named, list[Relation]]] = []
    constants: list[tuple[Named, list[Relation]]] = []
    for one in reversed(shown.naming.named):
        if one.letters & used:
            relations = list(_defined(shown, one))
            used |= {s for relation in relations for s in letters_of(relation)}
            (constants if one.constant else named).insert(0, (one, relations))
    blocks: list[Block] = []
    for one, relations in named:
        blocks += [Prose(one.meaning, one.letter.name), Formulas(tuple(Form(relation) for relation in relations))]
    rows = tuple(
        ((form(one.letter),), one.shown if isinstance(one.shown, str) else (form(ordered(one.shown)),), one.meaning)
        for one, _ in constants
    )
    return [
        *([Section("Named expressions", tuple(blocks), "names")] if blocks else []),
        *(
            [Section("Constants", (Table(("constant", "value", "meaning"), rows, prose=2),), "constants")]
            if rows
            else []
        ),
    ]


def _defined(shown: Description, one: Named) -> Iterator[Relation]:
    """A matrix or a vector as what it is of others that have a name, or entry by entry."""
    if one.value.shape == (1, 1):
        if not isinstance(one.shown, str):
            yield Relation((one.letter, ordered(one.value[0] if one.shown is None else one.shown)))
        return
    tree = shown.written(one.value)
    yield Relation((one.letter, *[tree] * (tree is not None), one.entries.applyfunc(ordered)))
    if tree is None:
        pairs = zip(one.entries, one.value, strict=True)
        yield from (Relation((s, ordered(value))) for s, value in pairs if s != value)


def _dynamics(shown: Description, units: Mapping[str, Any]) -> list[Section]:
    model = shown.model
    if model.discrete:
        return [_discrete(shown, units)]
    states = [Part(Symbol(v.name), [shown.called[s] for s in v.symbols]) for v in model.states]
    noises = _noises(shown)
    blocks: list[Block] = [Prose("x' = F x + G w, with the errors x and white noise w.")]
    if model.f is not None:
        blocks = [Prose("x' = f(x) + G w, with the states x and white noise w; F is the Jacobian of f by x.")]
        blocks += shown.formulas(shown.column("f", f_, [s.name for s in model.x]))
    if "F" in shown.naming.groups:
        blocks += shown.matrix("F", F_, states, states)
        blocks.append(Prose("Every other entry of F is zero."))
    F = Section("System matrix F", (*blocks, *_in_c(shown, units, "F"), *_stands_on(model.equations)), "F")
    listed = ", ".join(str(part.letter) for part in noises)
    G = Section(
        "Noise",
        (
            Prose(f"The columns of G are in this order: {listed}. These are the root densities of the white noises w."),
            *shown.formulas(shown.noise),
            *shown.matrix("G", G_, states, noises),
            Prose("Every other entry of G is zero. S is the diagonal matrix of the squares of the root densities."),
            Formulas((form(Q_c, product(G_, S_, transpose(G_))),)),
            *_in_c(shown, units, "Qc"),
        ),
        "G",
    )
    return [F, G, _flown(shown, units) if model.f is not None else _series(shown, units)]


def _series(shown: Description, units: Mapping[str, Any]) -> Section:
    """Phi and Q of an error state."""
    model, dt = shown.model, shown.called[shown.model.dt]
    I = identity(model.n)

    def times(factor: Any, *others: Any) -> Any:
        return product(*[Rational(factor)] * (factor != 1), *others)

    def powers(factors: Sequence[Any]) -> Any:
        """The sum of the factors, each with its power of F dt; the first is 1 or 0."""
        terms = [times(factor, dt**k, *[F_] * k) for k, factor in enumerate(factors) if k and factor]
        return total(*[I] * bool(factors[0]), *terms)

    onward: list[Form] = []
    squares = []
    for weight, factors in SPREAD[model.order]:
        B = Symbol("BC"[len(onward)], commutative=False)
        if len(factors) == 1:  # the noise at the end of the step, which nothing carries on
            squares.append(times(weight, dt, Q_c))
            continue
        shown.shaped(B, (model.n, model.n))
        onward.append(form(B, powers(factors)))
        squares.append(times(weight, dt, B, Q_c, transpose(B)))
    names = ("first", "second", "third", "fourth")
    return Section(
        f"Over a step {dt}",
        (
            Prose(f"The transition matrix to the {names[model.order - 1]} power of the step; F and Q_c are those of "
                  "its start."),
            Formulas((form(Phi, powers([Fraction(1, factorial(k)) for k in range(model.order + 1)])),)),
            Prose("What the noise adds, as a sum of squares, which no step makes indefinite; it is right to the "
                  f"{names[model.order]} power of the step."),
            Formulas((*onward, form(Q_, total(*squares)))),
            *_in_c(shown, units, "Phi", "Q"),
        ),
        "step",
    )  # fmt: skip


def _flown(shown: Description, units: Mapping[str, Any]) -> Section:
    """The step of a total state: Runge and Kutta's, its derivative, and the noise by the two nodes of Radau."""
    model, dt = shown.model, shown.called[shown.model.dt]
    x, x_next, x_m, B = (Symbol(name, commutative=False) for name in ("x", "x_next", "x_m", "B"))
    k = [Symbol(f"k_{i}", commutative=False) for i in range(1, 5)]
    for letter in (x, x_next, x_m, *k):
        shown.shaped(letter, (model.n, 1))
    shown.shaped(B, (model.n, model.n))
    f, F, spread = (Letter(name) for name in ("f", "F", "Q_c"))
    I, half, third, sixth, quarter = identity(model.n), Rational(1, 2), Rational(1, 3), Rational(1, 6), Rational(1, 4)

    def displaced(start: Any, share: Any, by: Any) -> Any:
        return total(start, product(share, dt, by))

    ends = product(sixth, dt, total(k[0], product(Integer(2), k[1]), product(Integer(2), k[2]), k[3]))
    steps = (
        form(k[0], f(x)),
        form(k[1], f(displaced(x, half, k[0]))),
        form(k[2], f(displaced(x, half, k[1]))),
        form(k[3], f(total(x, product(dt, k[2])))),
        form(x_next, total(x, ends)),
    )
    onward = product(Rational(2, 3), dt, F(displaced(x_m, third, f(x_m))), total(I, product(third, dt, F(x_m))))
    noise = (
        form(x_m, displaced(x, third, f(displaced(x, sixth, k[0])))),
        form(B, total(I, onward)),
        form(
            Q_,
            total(
                product(quarter, dt, spread(x_next)),
                product(Rational(3, 4), dt, B, spread(x_m), transpose(B)),
            ),
        ),
    )
    return Section(
        f"Over a step {dt}",
        (
            Prose("The state is flown by f itself, the inputs held: a step of the fourth-order Runge-Kutta method."),
            Formulas(steps),
            Prose("Phi is the derivative of x_next by x. What the noise adds is taken at the two nodes of Radau, at a "
                  "third of the step and at its end, so that Q errs by the fourth power of the step."),
            Formulas(noise),
            *_in_c(shown, units, "next", "Phi", "Q"),
            *[Prose("The filter in C computes all three by loops over f, F and Qc = G W G'.")] * model.loops,
        ),
        "step",
    )  # fmt: skip


def _discrete(shown: Description, units: Mapping[str, Any]) -> Section:
    """The step of a model in discrete time."""
    model = shown.model
    states = [Part(Symbol(v.name), [shown.called[s] for s in v.symbols]) for v in model.states]
    law, kind = ("next(x)", "states") if model.next is not None else ("Phi x", "errors")
    blocks: list[Block] = [Prose(f"x_next = {law} + noise of covariance Q, with the {kind} x, from step to step.")]
    if model.next is not None:
        blocks += shown.formulas(shown.column("next", Symbol("x_next", commutative=False), [s.name for s in model.x]))
    if "Phi" in shown.naming.groups:
        blocks += shown.matrix("Phi", Phi, states, states)
        blocks.append(Prose("Every other entry of Phi is zero."))
    if model.next is not None:
        blocks.append(Prose("Phi is the derivative of x_next by x."))
    blocks += shown.matrix("Q", Q_, states, states)
    blocks += [Prose("Every other entry of Q is zero."), *_in_c(shown, units, "next", "Phi", "Q")]
    return Section("From step to step", (*blocks, *_stands_on(model.equations)), "step")


def _noises(shown: Description) -> list[Part]:
    """The columns of G: those of one input together."""
    model = shown.model
    rest, parts = list(model.noise), []
    while rest:
        for v in model.inputs:
            if tuple(rest[: v.size]) == v.symbols:
                parts.append(Part(Symbol(v.name), [shown.called[s] for s in v.symbols]))
                rest = rest[v.size :]
                break
        else:
            letter = Symbol(f"w_{len(parts) + 1}")
            parts.append(Part(letter, [letter]))
            shown.noise.append((letter, shown.naming.groups["noise"][model.noise.rows - len(rest)]))
            rest = rest[1:]
    return parts


def _measurement(shown: Description, m: Measurement, units: Mapping[str, Any]) -> Section:
    model = shown.model
    states = [Part(Symbol(v.name), [shown.called[s] for s in v.symbols]) for v in model.states]
    rows = Part(Symbol(m.name), [Symbol(row) for row in m.rows])
    of = "H x" if m.H is not None else "h(x)"
    text = f"{m.meaning}. Rows {', '.join(m.rows)}, in {m.unit}; z = {of} + noise."
    blocks: list[Block] = [Prose(text[0].upper() + text[1:])]
    if m.z is None:
        blocks.append(Prose("The caller brings z, the measured value."))
    z_and_h = shown.column(f"{m.name} z", z_, m.rows) if m.z is not None else []
    if m.h is not None:
        z_and_h += shown.column(f"{m.name} h", h_, m.rows)
    blocks += shown.formulas(z_and_h)
    if f"{m.name} H" in shown.naming.groups:
        blocks += shown.matrix(f"{m.name} H", H_, [rows], states)
        blocks.append(Prose("Every other entry of H is zero."))
    if m.H is None:
        blocks.append(Prose("H is the Jacobian of h by x."))
    if m.angles:
        of = "" if len(m.angles) == len(m.rows) else " of " + ", ".join(m.rows[i] for i in m.angles)
        blocks.append(Prose(f"z and h{of} are angles, and are wrapped to -pi to pi."))
    if first := m.first_order:
        small = f", once {first.small} is zero" if first.small else ""
        blocks.append(Prose(f"H is the Jacobian of the exact h{f' of `{first.of}`' * bool(first.of)} at x = 0{small}."))
    names = [f"{m.name}_{part}" for part in "zhH"]
    return Section(f"Measurement {m.name}", (*blocks, *_in_c(shown, units, *names), *_stands_on(m.equations)), m.name)


def _function(shown: Description, function: Any, units: Mapping[str, Any]) -> Section:
    blocks: list[Block] = [Prose(function.meaning[0].upper() + function.meaning[1:] + ".")]
    taken = {v.name: v for v in shown.model.inputs}
    relations: list[tuple[Any, Any]] = []
    for output in function.outputs:
        name = output.name + "_new" * (output.name in taken)
        frame = f", {output.frame}" * bool(output.frame)
        blocks.append(Prose(f"{output.meaning}, {output.unit}{frame}", name))
        letter = Symbol(name, commutative=output.value.shape == (1, 1))
        rows = [str(i + 1) for i in range(output.value.rows)]
        if output.name in taken:
            rows = [shown.called[s].name.rpartition("_")[2] for s in taken[output.name].symbols]
        relations += shown.column(f"{function.name} {output.name}", letter, rows)
    blocks += shown.formulas(relations)
    made = (*blocks, *_in_c(shown, units, function.name), *_stands_on(function.equations))
    return Section(f"Function {function.name}", made, f"function-{function.name}")


def _in_c(shown: Description, units: Mapping[str, Any], *names: str) -> list[Block]:
    found = [units[name] for name in names if name in units]
    if not found:
        return []
    functions = ", ".join(f"`{unit['c_name']}` ({unit['operations']} operations)" for unit in found)
    tests = ", ".join([*(f"selftest/test_{unit['file']}.c" for unit in found), f"boresight verify {shown.target}"])
    return [Prose(functions, "In C"), Prose(tests, "Held by", code=True)]


def _stands_on(equations: Sequence[str]) -> list[Block]:
    return [Prose(", ".join(equations), "Stands on")] if equations else []


def _cycle(model: Model) -> Iterator[Block]:
    """In the order of calls; what a model lacks the caller does."""
    fields = {v.name: struct.name for struct in model.structs for v in struct.fields}
    functions = {f.name: f for f in model.functions}

    def moves(name: str) -> str:
        """The struct that a function writes, if all of its results are fields."""
        results = [output.name for output in functions[name].outputs] if name in functions else []
        return ", ".join(dict.fromkeys(fields[r] for r in results)) if results and set(results) <= set(fields) else ""

    number = count(1)
    p = model.c_prefix
    if carried := moves("strapdown"):
        yield Prose(f"`{p}_strapdown` carries {carried} over the step.", f"{next(number)}.")
    else:
        yield Prose(
            "The caller brings the inputs at this step; no function of the model carries them.", f"{next(number)}."
        )
    predicted = "x becomes next(x) and P becomes Phi P Phi^T + Q, with Phi and Q of the x before"
    if model.kind == "error-state":
        predicted = "x becomes Phi x and P becomes Phi P Phi^T + Q"
    wraps = ", ".join(s.name for v in model.states if v.wraps for s in v.symbols)
    wrapped = f" Then {wraps} is put in [-pi, pi), as after every update." if wraps else ""
    yield Prose(f"Predict: {predicted} (in C `{p}_filter_propagate`).{wrapped}", f"{next(number)}.")
    if not model.measurements:
        yield Prose(
            "The model has no measurement: it is the dynamics of a filter that one composes.", f"{next(number)}."
        )
        return
    names = ", ".join(f"`{p}_filter_measure_{m.name}`" for m in model.measurements)
    yield Prose(
        "Update by each measurement at hand: nu = z - H x, or z - h(x); S = H P H^T + R; K = P H^T S^-1; x becomes "
        f"x + K nu and P becomes P - K S K^T (in C {names}).",
        f"{next(number)}.",
    )  # fmt: skip
    if fed := moves("feedback"):
        yield Prose(
            f"`{p}_feedback` takes x out of {fed}, and x becomes zero (`{p}_filter_correct`).", f"{next(number)}."
        )
    elif model.kind == "error-state":
        yield Prose("x is kept: the model has no feedback.", f"{next(number)}.")
    else:
        yield Prose("x is the state itself, and stays.", f"{next(number)}.")


def _functions(model: Model, units: Mapping[str, Any]) -> Iterator[Block]:
    if not units:
        yield Prose("The model has not been generated: 'boresight generate' writes its C and counts the operations.")
        return
    rows = []
    for unit in units.values():
        results = ", ".join(r["name"] + "".join(f"[{n}]" for n in r["shape"] if n > 1) for r in unit["results"])
        rows.append((unit["c_name"], str(unit["operations"]), f"{', '.join(unit['fields'])} -> {results}"))
    yield Table(("function", "operations", "reads -> gives"), tuple(rows), prose=2, typed=(0, 2))


def _equations(model: Model) -> Iterator[Section]:
    """The equations of papers that the model names, and what stands on each."""
    cited: dict[str, list[str]] = {}
    parts = (("F", model.equations), *((m.name, m.equations) for m in model.measurements))
    for name, equations in (*parts, *((f.name, f.equations) for f in model.functions)):
        for text in equations:
            cited.setdefault(text, []).append(name)
    rows = tuple((text, text.replace("(", "").replace(")", ""), ", ".join(cited[text])) for text in cited)
    if rows:
        table = Table(("equation", "boresight show", "what stands on it"), rows, prose=2, typed=(1, 2))
        yield Section("What it stands on", (table,), "equations")


# ---------------------------------------------------------------- letters


def lettered(shown: Description, page: Page) -> Page:
    """Every formula of the page with the LaTeX of its letters."""
    named = {
        quantity.symbol.name + "(" * quantity.function: quantity
        for section in page.sections
        for form in forms(section)
        for quantity in _quantities(form.relation, shown.shapes)
    }
    letters = tuple(named.values())

    def formed(form: Form) -> Form:
        return form if form.quantities else replace(form, quantities=letters)

    def block(one: Block) -> Block:
        if isinstance(one, Formulas):
            return replace(one, forms=tuple(map(formed, one.forms)))
        if isinstance(one, Pair):
            return Pair(*(replace(side, forms=tuple(map(formed, side.forms))) for side in (one.left, one.right)))
        if isinstance(one, Table):
            rows = tuple(tuple(c if isinstance(c, str) else tuple(map(formed, c)) for c in row) for row in one.rows)
            return replace(one, rows=rows)
        return one

    sections = tuple(replace(s, blocks=tuple(map(block, s.blocks))) for s in page.sections)
    return replace(page, sections=sections)


def _quantities(relation: Relation, shapes: Mapping[str, tuple[int, ...]]) -> Iterator[Quantity]:
    for side in relation.sides:
        for node in nodes([[side]]):
            if node.is_Symbol:
                latex = letter_latex(node.name).replace(r"\mathrm{eps}", r"\epsilon")
                yield Quantity(node, latex, "", "", shapes.get(node.name, ()))
            elif isinstance(node, AppliedUndef) and node.func.__name__ in ("below", *map(str.lower, LETTERED)):
                name = node.func.__name__
                yield Quantity(Symbol(name), rf"\mathrm{{{name}}}", "", "", function=True)
            elif isinstance(node, AppliedUndef) and node.func.__name__ in ("f", "F", "Q_c"):
                name = node.func.__name__
                shape = shapes["x" if name == "f" else name]
                yield Quantity(Symbol(name), letter_latex(name), "", "", shape, function=True)
