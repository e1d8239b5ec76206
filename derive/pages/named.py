"""A model's expressions with names put in: R_N for a radius of curvature, f_n for C_b2n f_b, omega_ie for a number.

Nothing is looked up in the model's source: a name is found where an expression has the form of what it stands for.  A
test holds the expressions with their names against the model's own, by value.
"""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from itertools import count

from sympy import Add, ImmutableMatrix, Integer, Matrix, Mul, Pow, Rational, S, Symbol, cos, cse, sin, tan
from sympy.core.function import AppliedUndef

from boresight.derive.ledger.equation import product, replaced
from boresight.derive.mechanics import earth, rotation
from boresight.derive.mechanics.rotation import skew
from boresight.derive.model import Model, Variable

FRAMES = earth.FRAMES
SMALL = 1000  # numerator and denominator of a number that is shown as it is


@dataclass(frozen=True)
class Named:
    """A letter that stands for an expression.

    letter: as a whole, a matrix or a vector or a number.  entries: its scalars, row by row.  value: what they are, in
    letters that come before.  shown: the same as a reader wants it.  constant: it reads nothing.
    """

    letter: Symbol
    meaning: str
    value: ImmutableMatrix
    entries: ImmutableMatrix
    shown: object = None
    constant: bool = False


def scalar(name: str, value, meaning: str, constant: bool = False, shown=None) -> Named:
    letter = Symbol(name, positive=True) if constant or name == "w" else Symbol(name, real=True)
    one = ImmutableMatrix([[value]])
    return Named(letter, meaning, one, ImmutableMatrix([[letter]]), value if shown is None else shown, constant)


def array(name: str, value: Matrix, meaning: str, shown=None, suffixes: Iterable[str] | None = None) -> Named:
    """A matrix or a vector, whose scalars are the name with a suffix."""
    if suffixes is None:
        suffixes = [f"{i + 1}{j + 1}" for i in range(value.rows) for j in range(value.cols)]
    entries = [Symbol(f"{name}_{suffix}", real=True) for suffix in suffixes]
    value = ImmutableMatrix(value)
    letter = Symbol(name, commutative=False)
    return Named(letter, meaning, value, ImmutableMatrix(*value.shape, entries), value if shown is None else shown)


# ---------------------------------------------------------------- how a form is found


class Rewriter:
    """Puts letters for expressions: a sum within a sum, a product within a product, each up to a rational factor."""

    def __init__(self, patterns: Iterable[tuple[Symbol, object]]):
        self.exact: dict = {}
        self.sums: dict = {}  # the first term of a sum -> the sums
        self.products: list = []
        self.found: set[Symbol] = set()
        self.memo: dict = {}
        for letter, value in patterns:
            if value.is_Add:
                terms = value.as_coefficients_dict()
                self.sums.setdefault(next(iter(terms)), []).append((terms, letter))
            elif value.is_Mul or value.is_Pow:
                self.products.append((*_factors(value), letter))
        for listed in self.sums.values():
            listed.sort(key=lambda found: -len(found[0]))
        self.products.sort(key=lambda found: -len(found[1]))

    def matrix(self, matrix: Matrix) -> Matrix:
        return matrix.applyfunc(self)

    def __call__(self, expression):
        if expression not in self.memo:
            self.memo[expression] = self._rewritten(expression)
        return self.memo[expression]

    def _rewritten(self, expression):
        if not expression.args:
            return expression
        if expression.is_Add:
            return self._sum(Add(*map(self, expression.args)))
        if expression.is_Mul or expression.is_Pow:
            number, factors = _factors(expression)
            return self._product(number, {self(base): power for base, power in factors.items()})
        return expression.func(*map(self, expression.args))

    def _sum(self, expression):
        if not expression.is_Add:
            return expression
        terms = dict(expression.as_coefficients_dict())
        again = True
        while again:
            again = False
            for term in list(terms):
                for wanted, letter in self.sums.get(term, ()):
                    if wanted.keys() <= terms.keys() and letter not in terms:
                        ratio = terms[term] / wanted[term]
                        if all(terms[t] == ratio * c for t, c in wanted.items()):
                            terms = {t: c for t, c in terms.items() if t not in wanted}
                            terms[letter] = ratio
                            self.found.add(letter)
                            again = True
                            break
                if again:
                    break
        return Add(*(coefficient * term for term, coefficient in terms.items()))

    def _product(self, number, factors: dict):
        for coefficient, wanted, letter in self.products:
            if all(_holds(factors.get(base), power, base) for base, power in wanted.items()):
                for base, power in wanted.items():
                    factors[base] -= power
                number, factors[letter] = number / coefficient, factors.get(letter, 0) + 1
                self.found.add(letter)
        return Mul(number, *(Pow(base, power) for base, power in factors.items()))


def _factors(expression) -> tuple:
    """A product as its number and the powers of its bases."""
    number, rest = expression.as_coeff_Mul()
    powers: dict = {}
    for factor in Mul.make_args(rest):
        base, power = factor.as_base_exp()
        if not power.is_Rational:
            base, power = factor, S.One
        powers[base] = powers.get(base, 0) + power
    return number, powers


def _holds(power, wanted, base) -> bool:
    """Whether this power of a base contains the wanted one: of sums and roots the whole, of letters a part."""
    if power is None:
        return False
    if base.is_Symbol and base.name != "w" or base.is_Function:
        return bool(power >= wanted > 0 or power <= wanted < 0)
    return bool(power == wanted)


def nodes(matrices: Iterable[Matrix]) -> list:
    """Every expression within the matrices, once, inner ones first."""
    seen: dict = {}

    def visit(expression) -> None:
        stack = [(expression, False)]
        while stack:
            part, left = stack.pop()
            if left:
                seen[part] = True
            elif part not in seen:
                stack.append((part, True))
                stack += [(argument, False) for argument in part.args if argument not in seen]

    for matrix in matrices:
        for entry in matrix:
            visit(entry)
    return list(seen)


@dataclass
class Naming:
    """The expressions of a model, group by group, and the names that have been put into them so far."""

    model: Model
    groups: dict[object, Matrix]
    vectors: dict[str, Named] = field(default_factory=dict)  # by the name of the variable
    named: list[Named] = field(default_factory=list)

    def put(self, candidates: Iterable[Named], exact: bool = False) -> list[Named]:
        """Put these names into all groups; those that stand somewhere are kept."""
        candidates = list(candidates)
        pairs = [pair for one in candidates for pair in zip(one.entries, one.value, strict=True)]
        rewriter = Rewriter(pairs)
        self.groups = {key: rewriter.matrix(matrix) for key, matrix in self.groups.items()}
        kept = [one for one in candidates if rewriter.found & set(one.entries)]
        self.named += kept
        return kept

    def taken(self) -> set[str]:
        return {str(s) for v in (*self.model.states, *self.model.inputs) for s in (v.name, *v.symbols)} | {
            str(s) for one in self.named for s in (one.letter, *one.entries)
        }


def naming(model: Model, groups: dict[object, Matrix]) -> Naming:
    """The groups of expressions with names put in."""
    letters = component_letters(model)
    made = Naming(model, {key: matrix.xreplace(letters) for key, matrix in groups.items()})
    for v in (*model.states, *model.inputs):
        entries = ImmutableMatrix([letters.get(s, s) for s in v.symbols])
        made.vectors[v.name] = Named(Symbol(v.name, commutative=v.size == 1), v.meaning, entries, entries)
    rotations = made.put(_rotations(made))
    _earth(made)
    _turned(made, rotations)
    _constants(made)
    return made


def component_letters(model: Model) -> dict[Symbol, Symbol]:
    """Components whose name is that of a vector too get a capital axis: v_N is a component of v_n."""
    vectors = {v.name for v in (*model.states, *model.inputs) if v.size > 1}
    every = [v for v in (*model.states, *model.inputs) if v.size > 1]

    def suffixes(v: Variable) -> tuple[str, ...]:
        return tuple(s.name.rpartition("_")[2] for s in v.symbols)

    clashing = {suffixes(v) for v in every if any(s.name in vectors for s in v.symbols)}
    return {
        s: Symbol(f"{s.name.rpartition('_')[0]}_{s.name.rpartition('_')[2].upper()}", real=True)
        for v in every
        if suffixes(v) in clashing
        for s in v.symbols
    }


# ---------------------------------------------------------------- rotations


def _rotations(made: Naming) -> Iterator[Named]:
    """The matrix of each quaternion, and of each triple of roll, pitch and yaw, that the model reads."""
    for v in (*made.model.inputs, *made.model.states):
        entries = made.vectors[v.name].entries
        if v.size == 4 and v.norm is not None:
            name = "C_" + v.name.removeprefix("q_").removesuffix("_wxyz")
            yield array(name, rotation.dcm_from_quaternion(entries), f"matrix of {v.name}: {v.meaning}, {v.frame}")
        elif v.size == 3 and [s.name.partition("_")[0] for s in v.symbols] == ["roll", "pitch", "yaw"]:
            value = rotation.dcm_from_euler(*entries)
            yield array(f"C_{v.name}", value, f"matrix of {v.name}: {v.meaning}, {v.frame}, transposed")


def axes_of(made: Naming, name: str) -> list[str]:
    """Suffixes of the components of a vector which a matrix, C_b2n, leads to."""
    target = name.rpartition("2")[2] if "2" in name else ""
    if target == "n":
        for frame in FRAMES.values():
            if any(frame.name in v.frame for v in made.model.inputs):
                return [axis.upper() for axis in frame.axes]
    return ["x", "y", "z"]


def _turned(made: Naming, rotations: list[Named]) -> None:
    """Vectors that such a matrix turns, and the velocity of a lever arm, C (omega x lever)."""
    inputs = [made.vectors[v.name] for v in made.model.inputs if v.size == 3]
    vectors = [*inputs, *(one for one in made.named if one.entries.shape == (3, 1))]
    plain = re.compile(r"C_(\w)2(\w)\Z")
    candidates = []
    for C in rotations:
        frames = plain.match(C.letter.name)
        for v in vectors:
            for transposed in (False, True):
                source, target = (frames.groups()[:: -1 if transposed else 1]) if frames else ("", "")
                if not v.letter.name.endswith(f"_{source}") or not source:
                    continue
                name = v.letter.name[: -len(source)] + target
                matrix, letter = (C.entries.T, _transposed(C.letter)) if transposed else (C.entries, C.letter)
                if name not in made.taken():
                    suffixes = axes_of(made, C.letter.name) if not transposed else "xyz"
                    candidates.append(
                        array(name, matrix * v.entries, f"{v.letter.name} in the axes {target}",
                              product(letter, v.letter), suffixes)
                    )  # fmt: skip
    by_name = {one.letter.name: one for one in candidates}
    made.put(by_name.values())


def _transposed(letter: Symbol):
    from sympy.functions.elementary.complexes import transpose

    return transpose(letter)
