"""A model's expressions with names put in: R_N for a radius of curvature, f_n for C_b2n f_b, omega_ie for a number.

Nothing is looked up in the model's source: a name is found where an expression has the form of what it stands for.  A
test holds the expressions with their names against the model's own, by value.
"""

import re
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import count
from typing import Any

from sympy import Add, Basic, Function, ImmutableMatrix, Matrix, Mul, Pow, Rational, S, Symbol, sin, sqrt
from sympy.functions.elementary.complexes import transpose
from sympy.matrices import MatrixBase

from boresight.derive.checks import expressions
from boresight.derive.constant import Constant, behind
from boresight.derive.expressions import constants_in, substituted, symbols_in
from boresight.derive.ledger.equation import product
from boresight.derive.mechanics import earth, rotation
from boresight.derive.mechanics.rotation import skew
from boresight.derive.model import Model, Variable

FRAMES = earth.FRAMES
LONG = 60  # operations of a rotation vector that stays part of a longer expression
SMALL = 1000  # numerator and denominator of a number that is shown as it is


@dataclass(frozen=True)
class Named:
    """A letter that stands for an expression.

    letter: as a whole, a matrix or a vector or a number.  entries: its scalars, row by row.  value: what they are, in
    letters that come before.  shown: the same as a reader wants it.  constant: it is a number, and `shown` may be its
    text.
    """

    letter: Symbol
    meaning: str
    value: ImmutableMatrix
    entries: ImmutableMatrix
    shown: Any = None
    constant: bool = False


def scalar(name: str, value, meaning: str, constant: bool = False, shown=None) -> Named:
    letter = Symbol(name, positive=True) if constant else Symbol(name)
    one = ImmutableMatrix([[value]])
    return Named(letter, meaning, one, ImmutableMatrix([[letter]]), value if shown is None else shown, constant)


def renamed(one: Named, name: str) -> Named:
    entries = [Symbol(str(s).replace(one.letter.name, name, 1)) if s != v else s
               for s, v in zip(one.entries, one.value, strict=True)]  # fmt: skip
    letter = Symbol(name, commutative=False)
    return replace(one, letter=letter, entries=ImmutableMatrix(*one.entries.shape, entries))


def array(
    name: str, value: Matrix, meaning: str, shown=None, suffixes: Iterable[str] | None = None, short: int = 1000
) -> Named:
    """A matrix or a vector.  Its scalars are the name with a suffix; what is no sum, and no product of at least `short`
    factors, stays as it is."""
    if suffixes is None:
        suffixes = [f"{i + 1}{j + 1}" for i in range(value.rows) for j in range(value.cols)]
    value = ImmutableMatrix(value)
    letters = [Symbol(f"{name}_{suffix}") for suffix in suffixes]
    entries = [
        letter if entry.is_Add or (entry.is_Mul and len(_factors(entry)[1]) >= short) else entry
        for letter, entry in zip(letters, value, strict=True)
    ]
    letter = Symbol(name, commutative=False)
    return Named(letter, meaning, value, ImmutableMatrix(*value.shape, entries), value if shown is None else shown)


# ---------------------------------------------------------------- constants


def letter_of(one: Constant) -> Symbol:
    return Symbol(one.name, positive=True)


def lettered(expression):
    """An expression or a matrix with letters in the place of its constants."""
    if not isinstance(expression, MatrixBase):
        return lettered(Matrix([expression]))[0]
    put = substituted(Matrix(expression), {one: letter_of(one) for one in constants_in(expression)})
    return type(expression)(put)


def constants(matrices: Iterable[Matrix]) -> list[Named]:
    """The constants that stand in the matrices, each after those in its value."""
    return [
        scalar(
            one.name,
            one.exact,
            one.meaning + f", {one.unit}" * (one.unit != "1"),
            constant=True,
            shown=_decimal(one.value) if one.value.is_Rational else lettered(one.value),
        )
        for one in behind(constants_in(*matrices))
    ]


a, f, e2, g_e, k, m, epsilon = map(
    letter_of,
    (
        earth.SEMI_MAJOR_AXIS,
        earth.FLATTENING,
        earth.ECCENTRICITY_SQUARED,
        earth.GRAVITY_EQUATOR,
        earth.SOMIGLIANA,
        earth.CENTRIFUGAL_RATIO,
        rotation.TINY_SQUARE,
    ),
)


# ---------------------------------------------------------------- how a form is found


class Rewriter:
    """Puts letters for expressions: a sum within a sum, a product within a product, each up to a rational factor.

    patterns: (letter, expression).  found: the numbers of those patterns that stood somewhere.
    """

    def __init__(self, patterns: Iterable[tuple[Any, Any]]):
        self.sums: dict = {}  # a term of a sum -> the sums
        self.products: list = []
        self.others: dict = {}
        self.found: set[int] = set()
        self.memo: dict = {}
        for index, (letter, value) in enumerate(patterns):
            if value.is_Add:
                terms = value.as_coefficients_dict()
                self.sums.setdefault(next(iter(terms)), []).append((terms, letter, index))
            elif value.is_Mul or value.is_Pow:
                self.products.append((*_factors(value), letter, index))
            else:
                self.others[value] = letter, index
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
        if expression in self.others:
            letter, index = self.others[expression]
            self.found.add(index)
            return letter
        if expression.is_Mul or (expression.is_Pow and expression.exp.is_Rational):
            number, factors = _factors(expression)
            changed = {}
            for base, exponent in factors.items():
                base = self(base)
                changed[base] = changed.get(base, 0) + exponent
            return self._product(expression, number, factors, changed)
        within = rebuilt(expression, [self(argument) for argument in expression.args])
        return self.sum(within) if within.is_Add and self.sums else within

    def sum(self, expression):
        """A sum with letters for parts of it."""
        terms, changed = dict(expression.as_coefficients_dict()), False
        for term in list(terms):
            for wanted, letter, index in self.sums.get(term, ()):
                if letter not in terms and wanted.keys() <= terms.keys():
                    ratio = terms[term] / wanted[term]
                    if all(terms[t] == ratio * c for t, c in wanted.items()):
                        terms = {t: c for t, c in terms.items() if t not in wanted} | {letter: ratio}
                        changed = True
                        self.found.add(index)
        return Add(*(number * term for term, number in terms.items())) if changed else expression

    def _product(self, expression, number, before: dict, factors: dict):
        changed = factors.keys() != before.keys()
        for coefficient, wanted, letter, index in self.products:
            while all(_holds(factors.get(base), exponent, base) for base, exponent in wanted.items()):
                for base, exponent in wanted.items():
                    factors[base] -= exponent
                number, factors[letter] = number / coefficient, factors.get(letter, 0) + 1
                changed = True
                self.found.add(index)
        return Mul(number, *(power(*factor) for factor in factors.items())) if changed else expression


def rebuilt(expression, arguments: list):
    """The node with other arguments, which SymPy does not search for a simpler form: that takes seconds."""
    if all(new is old for new, old in zip(arguments, expression.args, strict=True)):
        return expression
    if expression.is_Add or expression.is_Mul:
        return expression.func(*arguments)
    if expression.is_Pow:
        return power(*arguments)
    return Basic.__new__(expression.func, *arguments)


def power(base, exponent):
    return Pow(base, exponent, evaluate=not base.is_Add or exponent is S.One)


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
    """Whether this power of a base contains the wanted one; a root of the ellipsoid only as a whole."""
    if power is None or power == 0:
        return False
    if base.is_Symbol and re.fullmatch(r"w(_\d+)?", base.name):
        return bool(power == wanted)
    return bool(power >= wanted > 0 or power <= wanted < 0)


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


def operations(expressions: Iterable[Any]) -> int:
    """How many operations a reader sees where they are written out."""
    expressions = list(expressions)
    seen: dict[Any, int] = {}
    for node in nodes([expressions]):
        seen[node] = sum(seen[part] for part in node.args) + len(node.args) - 1 + node.is_Function if node.args else 0
    return sum(seen[part] for part in expressions)


@dataclass
class Naming:
    """The expressions of a model, group by group, and the names that have been put into them so far."""

    model: Model
    groups: dict[str, Matrix]
    vectors: dict[str, Named]  # states and inputs, by name
    named: list[Named] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.named += constants(self.groups.values())
        self.groups = {key: lettered(matrix) for key, matrix in self.groups.items()}
        self.read = {key: symbols_in(matrix) for key, matrix in self.groups.items()}
        self.names = {s.name for one in (*self.vectors.values(), *self.named) for s in (one.letter, *one.entries)}

    def put(self, candidates: Iterable[Named], groups: Collection[str] | None = None) -> list[Named]:
        """Put these names into all groups, or into some; those that stand somewhere are kept."""
        candidates = list(candidates)
        places = [(one, i) for one in candidates for i, letter in enumerate(one.entries) if letter != one.value[i]]
        rewriter = Rewriter([(one.entries[i], one.value[i]) for one, i in places])
        self.rewrite(rewriter, groups, [symbols_in([one.value[i]]) for one, i in places])
        found = {id(places[k][0]) for k in rewriter.found}
        kept = [one for one in candidates if id(one) in found]
        self.named += kept
        self.names |= {s.name for one in kept for s in (one.letter, *one.entries) if s.is_Symbol}
        return kept

    def rewrite(
        self, rewriter: Rewriter, groups: Collection[str] | None = None, needs: Iterable[set[Symbol]] = (set(),)
    ) -> None:
        """Put letters into the groups that read all letters of one of `needs`."""
        needs = list(needs)
        for key in self.groups if groups is None else groups:
            if any(letters <= self.read[key] for letters in needs):
                before, self.groups[key] = self.groups[key], rewriter.matrix(self.groups[key])
                if before != self.groups[key]:
                    self.read[key] = symbols_in(self.groups[key])

    def together(self, *letters: Iterable[Symbol]) -> bool:
        """Whether one of each stands in the same group."""
        return any(all(not here.isdisjoint(some) for some in letters) for here in self.read.values())

    def put_found(self, candidates: Iterable[Named]) -> list[Named]:
        """The same of candidates that may bear one name: those of which two entries stand somewhere get a number."""
        candidates = list(candidates)
        sums = [(one, value) for one in candidates for value in one.value if value.is_Add]
        trial = Rewriter([(Symbol(str(i)), value) for i, (_, value) in enumerate(sums)])
        for node in nodes(self.groups.values()):
            if node.is_Add:
                trial.sum(node)
        parts = [sums[i][0] for i in sorted(trial.found)]
        found = [
            one
            for one in candidates
            if sum(part is one for part in parts) >= min(2, sum(value.is_Add for value in one.value))
        ]
        for index, one in enumerate(found[1:], 2):
            found[index - 1] = renamed(one, f"{one.letter.name}_{index}")
        return self.put(found)

    def free(self, name: str) -> bool:
        """Whether nothing has this name yet."""
        return name not in self.names


def naming(model: Model, groups: dict[str, Matrix]) -> Naming:
    """The groups of expressions with names put in."""
    letters = component_letters(model)
    vectors = {}
    for v in (*model.states, *model.inputs):
        entries = ImmutableMatrix([letters[s] for s in v.symbols])
        vectors[v.name] = Named(Symbol(v.name, commutative=v.size == 1), v.meaning, entries, entries)
    called = Rewriter((letter, symbol) for symbol, letter in letters.items())
    made = Naming(model, {key: called.matrix(matrix) for key, matrix in groups.items()}, vectors)
    rotations = made.put(_rotations(made))
    for index in count():
        latitudes = _latitudes(made)
        if not latitudes:
            break
        _at_latitude(made, latitudes[0], f"_{index}" * bool(index))
    _turned(made, rotations)
    for _ in range(2):  # a rotation vector may hold a rotation
        _quaternion_products(made, _finite_rotations(made))
    _numbers(made)
    return made


def component_letters(model: Model) -> dict[Symbol, Symbol]:
    """What each component is called: where v_n is a vector, its component along n is v_N, and so for all such axes."""
    every = (*model.states, *model.inputs)
    names = {v.name for v in every if v.size > 1}
    kept = {one.letter.name for one in constants(item.matrix for item in expressions(model))}

    def axes(v: Variable) -> tuple[str, ...]:
        """Suffixes of the components, if they have some."""
        return tuple(s.name.rpartition("_")[2] for s in v.symbols) if all("_" in s.name for s in v.symbols) else ()

    clashing = {axes(v) for v in every if v.size > 1 and any(s.name in names for s in v.symbols)} - {()}

    def letter(v: Variable, s: Symbol) -> Symbol:
        if axes(v) not in clashing:
            return Symbol(s.name + "_0" * (s.name in kept))
        base, _, axis = s.name.rpartition("_")
        return Symbol(f"{base}_{axis.upper()}")

    return {s: letter(v, s) for v in every for s in v.symbols}


# ---------------------------------------------------------------- rotations


def _rotations(made: Naming) -> Iterator[Named]:
    """The matrix of each quaternion, and of each triple of roll, pitch and yaw, that the model reads."""
    for v in (*made.model.inputs, *made.model.states):
        entries = made.vectors[v.name].entries
        if v.size == 4 and v.norm is not None:
            name = "C_" + v.name.removeprefix("q_").removesuffix("_wxyz")
            yield array(name, rotation.dcm_from_quaternion(entries), f"the matrix of {v.name}, {v.frame}")
        elif [s.name.partition("_")[0] for s in v.symbols] == ["roll", "pitch", "yaw"]:
            yield array(
                f"C_{v.name}",
                rotation.dcm_from_euler(*entries),
                f"the matrix of {v.name}, which leads back from {v.frame}",
                short=2,
            )


def _finite_rotations(made: Naming) -> list[Named]:
    """The quaternion of each rotation vector: its angle is the root of the squares and of TINY_SQUARE."""
    order = [s for v in made.vectors.values() for s in v.entries]
    squares = [node for node in nodes(made.groups.values())
               if node.is_Add and len(node.args) == 4 and epsilon in node.args]  # fmt: skip
    result: list[Named] = []
    for square in squares:
        index = sum(one.letter.name.startswith("angle_") for one in made.named) + 1
        parts = [_root(part) for part in square.args if part != epsilon]
        if operations(parts) > LONG:
            continue
        parts.sort(key=lambda part: min(order.index(s) for s in symbols_in([part]) if s in order))
        if any(part.is_Add or operations([part]) > 2 for part in parts):
            here = [key for key, matrix in made.groups.items() if square in nodes([matrix])]
            turn = array(f"turn_{index}", ImmutableMatrix(parts), "a rotation vector, rad", suffixes="xyz")
            made.put([turn], here)
            parts = list(turn.entries)
        total = epsilon + sum(part**2 for part in parts)
        angle = scalar(f"angle_{index}", S.One, "", shown=sqrt(total), constant=True)
        root = Rewriter([(angle.letter**2, total)])
        made.rewrite(root, None, [symbols_in([total])])
        made.named.append(replace(angle, meaning="the angle of a rotation, rad", constant=False))
        value = root.matrix(lettered(ImmutableMatrix(rotation.quaternion_from_rotation_vector(parts))))
        entries = ImmutableMatrix([Symbol(f"r_{index}_{part}") for part in "wxyz"])
        meaning = f"the quaternion of the rotation by ({', '.join(map(str, parts))})"
        result += made.put([Named(Symbol(f"r_{index}", commutative=False), meaning, value, entries, value)])
    return result


def _root(square):
    """Of a product of squares the product of what is squared."""
    number, factors = _factors(square)
    return sqrt(number) * Mul(*(power(base, exponent / 2) for base, exponent in factors.items()))


def _quaternion_products(made: Naming, turns: list[Named]) -> list[Named]:
    """Products of two quaternions, perhaps with one turned round, and the matrices of them and of finite rotations."""
    every = [v for v in made.vectors.values() if v.entries.shape == (4, 1)]
    candidates = []
    for one in (*every, *turns):
        for other in (*every, *turns):
            if one is not other and made.together(one.entries, other.entries):
                back = ImmutableMatrix(rotation.conjugate(other.entries))
                for factor, text in ((other.entries, ""), (back, "the inverse of ")):
                    meaning = f"the quaternion {one.letter} times {text}{other.letter}"
                    candidates.append(
                        array("p", rotation.quaternion_product(one.entries, factor), meaning, suffixes="wxyz")
                    )
    found = made.put_found(candidates)
    return found + made.put(
        array(f"C_{one.letter}", rotation.dcm_from_quaternion(one.entries), f"the matrix of {one.letter}")
        for one in (*turns, *found)
    )


def _level_axes(model: Model) -> list[str]:
    """Suffixes of vectors in the level, if the model has one."""
    found = [frame for frame in FRAMES.values() if any(frame.name in v.frame for v in model.inputs)]
    return [axis.upper() for axis in found[0].axes] if found else list("xyz")


def _turned(made: Naming, rotations: list[Named]) -> None:
    """Vectors that a matrix C_b2n or its transpose turns, as f_n = C_b2n f_b, and C (omega x lever)."""
    vectors = [one for one in (*made.vectors.values(), *made.named) if one.entries.shape == (3, 1)]
    level = _level_axes(made.model)
    once, twice = [], []
    for C in rotations:
        frames = re.fullmatch(r"C_(\w)2(\w)", C.letter.name)
        if not frames:
            continue
        for source, target, letter, matrix in (
            (frames[1], frames[2], C.letter, C.entries),
            (frames[2], frames[1], transpose(C.letter), C.entries.T),
        ):
            here = [v for v in vectors if v.letter.name.endswith(f"_{source}")]
            axes = level if target == "n" else list("xyz")
            for v in here:
                name = v.letter.name.removesuffix(source) + target
                if made.free(name) and made.together(C.entries, v.entries):
                    once.append(
                        array(
                            name,
                            matrix * v.entries,
                            f"{v.meaning}, in the axes {target}",
                            product(letter, v.letter),
                            axes,
                        )
                    )
                for w in here if v.letter.name.startswith("omega") else ():
                    if v is not w and made.free(f"u_{target}") and made.together(C.entries, v.entries, w.entries):
                        meaning = f"the cross product of {v.letter} and {w.letter}, in the axes {target}"
                        turned = product(letter, crossed(v.letter), w.letter)
                        twice.append(array(f"u_{target}", matrix * skew(v.entries) * w.entries, meaning, turned, axes))
    made.put(once)
    made.put_found(twice)


crossed = Function("skew", commutative=False)  # [v x], the matrix of the cross product


# ---------------------------------------------------------------- the Earth


def _latitudes(made: Naming) -> list:
    """The angles X of which 1 - e^2 sin(X)^2 stands somewhere, inner ones first."""
    found = []
    for node in nodes(made.groups.values()):
        if node.is_Add and len(node.args) == 2 and node.args[0] is S.One:
            base, power = (-node.args[1] / e2).as_base_exp()
            if power == 2 and isinstance(base, sin):
                found.append(base.args[0])
    return found


def _at_latitude(made: Naming, lat, suffix: str) -> None:
    """Radii of curvature, gravity and the rate of the level at one place that the model speaks of."""
    if not lat.is_Symbol:
        (place,) = made.put([scalar(f"lat{suffix}", lat, "rad, latitude on the way")])
        lat = place.letter
    s2 = sin(lat) ** 2
    w = scalar(f"w{suffix}", S.One, "", shown=sqrt(1 - e2 * s2), constant=True)
    root = Rewriter([(w.letter**2, 1 - e2 * s2)])

    made.rewrite(root, None, [{lat}])
    meridian, transverse = (root(lettered(value)) for value in earth.radii(lat))
    heights = []
    for node in nodes(made.groups.values()):
        if node.is_Add:
            rest = [node - radius for radius in (meridian, transverse) if radius in node.args]
            heights += [height for height in rest if height not in heights]
    places = []
    for index, height in enumerate(heights):
        if not height.is_Symbol:
            places.append(scalar(f"height{suffix}" + f"_{index}" * bool(index), height, "m, height on the way"))
    made.put(places)
    heights = [next((one.letter for one in places if one.value[0] == height), height) for height in heights]

    R_N, R_E = a * (1 - e2) / (1 - e2 * s2) ** Rational(3, 2), a / sqrt(1 - e2 * s2)
    N, E = f"R_N{suffix}", f"R_E{suffix}"
    by_lat = [root(lettered(value)) for value in earth.radii_by_latitude(lat)]
    candidates = [
        scalar(N, meridian, "meridian radius of curvature, m", shown=R_N),
        scalar(E, transverse, "transverse radius of curvature, m", shown=R_E),
        scalar(f"{N}_lat", by_lat[0], f"derivative of {N} by {lat}", shown=R_N.diff(lat)),
        scalar(f"{E}_lat", by_lat[1], f"derivative of {E} by {lat}", shown=R_E.diff(lat)),
    ]
    above_ground = []
    for index, h in enumerate(heights):
        suffixed = suffix + f"_{index}" * bool(index)
        above = 1 - 2 * (1 + f + m - 2 * f * s2) * h / a + 3 * h**2 / a**2
        ground = g_e * (1 + k * s2) / sqrt(1 - e2 * s2)
        by_lat, by_height = map(lettered, earth.gravity_gradient(lat, h))
        above_ground += [
            scalar(f"g{suffixed}", root(lettered(earth.normal_gravity(lat, h))), "normal gravity, m/s^2",
                   shown=ground * above),
            scalar(f"g_lat{suffixed}", root(by_lat), f"derivative of g by {lat}",
                   shown=ground.diff(lat) * above + ground * above.diff(lat)),
            scalar(f"g_h{suffixed}", root(by_height), f"derivative of g by {h}", shown=ground * above.diff(h)),
        ]  # fmt: skip
    made.put(above_ground)
    found = made.put(candidates)
    radii = Rewriter((one.letter, one.value[0]) for one in found if one.letter.name in (N, E))
    rates = []
    for v in made.model.inputs:
        frame = FRAMES.get(v.frame)
        if frame is None or v.size != 3 or not made.free(f"omega_in_n{suffix}"):
            continue
        for h in heights:
            at = made.vectors[v.name].entries
            rate = lettered(earth.omega_ie_n(lat, frame) + earth.omega_en_n(lat, h, at, frame))
            rate = root.matrix(rate).applyfunc(radii)
            axes = [axis.upper() for axis in frame.axes]
            meaning = "rate of the level against inertial space, rad/s"
            rates.append(array(f"omega_in_n{suffix}", rate, meaning, suffixes=axes))
    made.put_found(rates)
    if w.letter in symbols_in(*made.groups.values()):
        made.named.append(w)


# ---------------------------------------------------------------- numbers


def _numbers(made: Naming) -> None:
    """Decimals for decimal numbers, and a letter of its own for any other long number."""
    own: dict = {}
    memo: dict = {}

    def number(value):
        if abs(value.p) < SMALL and value.q < SMALL and value.q not in (100, 1000):
            return value
        if value.q == 1 and abs(value.p) < 10**9:
            return value
        if abs(value) not in own:
            name = next(f"c_{i}" for i in count(len(own) + 1) if made.free(f"c_{i}"))
            own[abs(value)] = scalar(
                name, abs(value), "a number of the model", constant=True, shown=_decimal(abs(value))
            )
        return (-1 if value < 0 else 1) * own[abs(value)].letter

    def visit(expression):
        if expression not in memo:
            if expression.is_Rational:
                memo[expression] = number(expression)
            elif expression.is_Pow:
                memo[expression] = power(visit(expression.base), expression.exp)
            else:
                memo[expression] = rebuilt(expression, [visit(argument) for argument in expression.args])
        return memo[expression]

    made.groups = {key: matrix.applyfunc(visit) for key, matrix in made.groups.items()}
    made.named = [
        replace(one, shown=one.shown if one.constant else visited(one.shown, visit), value=visited(one.value, visit))
        for one in made.named
    ] + list(own.values())


def _decimal(value) -> str:
    """A decimal number where there is one of few digits, or one over it, else a fraction."""
    exact = Fraction(int(value.p), int(value.q))
    texts = (format(float(number), ".12g") for number in (exact, 1 / exact))
    text, below = texts
    return text if Fraction(text) == exact else f"1/{below}" if 1 / Fraction(below) == exact else str(exact)


def visited(shown, visit):
    """What is shown of a name: an explicit matrix, an expression, or a product of letters."""
    if isinstance(shown, MatrixBase):
        return ImmutableMatrix(shown.applyfunc(visit))
    return visit(shown) if shown.is_commutative else shown
