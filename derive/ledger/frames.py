"""Whether the terms of a paper's equations stand in frames that fit.

A letter's frames are those that `Paper.frames` gives it, by a declaration or by its value, or those of its name: C_b^n
takes b to n, f^b stands in b, omega_{ie}^n is the rate of e against i in n.  A letter without any, as phi, has those
that the paper's lines give it; one that gets two is named.  A sum wants one frame, a product the frame at its left
that its right factor has, and rates of one sum must meet: i to e and e to n is i to n.

A computed frame, as c or n', differs by an error from the one that it stands for (`Paper.computed`).  A term may be in
either if what that changes is of higher order than the line's claim, or nothing at the witness.  Beside the turn from
one to the other it may not: who writes C_n^c holds the two apart.
"""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cache, cached_property
from itertools import count, groupby, pairwise
from math import inf
from typing import Any

import mpmath as mp
from sympy import Add, MatAdd, MatMul, Mul, Pow, S, StrictLessThan, Symbol
from sympy.core.function import AppliedUndef
from sympy.functions.elementary.complexes import transpose
from sympy.matrices import MatrixBase

from boresight import BoresightError
from boresight.derive.dimensions import Mismatch
from boresight.derive.ledger.equation import Claim, Equation, Quantity, Relation
from boresight.derive.ledger.evaluate import DIGITS, Point, evaluate
from boresight.derive.ledger.judge import EXACT, FULL, SCALES, SEEDS, witness_point
from boresight.derive.ledger.numbers import digits, entries, eye, largest
from boresight.derive.ledger.paper import Paper

FRAME = r"[A-Za-z]'?|ENU|NED"
TURN = re.compile(rf"(?:^|[^a-z])[CQRq]_\{{?({FRAME})(?:,[^}}]*)?\}}?\^\{{?({FRAME})(T?)\}}?")
RATE = re.compile(rf"(?:omega|Omega|w)_\{{(\w)(\w)\}}\^\{{?({FRAME})\}}?")
UPPER = re.compile(rf"\^\{{?({FRAME})\}}?(?:[ (\\].*)?$")
DERIVATIVE = re.compile(r"\\d?dot|dt\}")
LEADS = re.compile(rf"\b(?:from|of) ({FRAME}) to ({FRAME}),")
CROSSED = re.compile(r"\[(\S+) x\]")
MEANT = re.compile(rf", in ({FRAME})(?:,|$| axes)")
COMPUTED = re.compile(r"\\(?:hat|tilde|bar|check|overline)\b")
ACCENTED = re.compile(rf"{COMPUTED.pattern}|{DERIVATIVE.pattern}")
ACCENTS = re.compile(r"\\(?:hat|dot|ddot|bar|overline|check|tilde|mathbf|boldsymbol|bm|mathrm|mathsf|mathit|vec)"
                     r"\{((?:[^{}]|\{[^{}]*\})*)\}")  # fmt: skip
BEFORE = re.compile(r"\{\}(?:\^(\{\w+\}|\w))?(?:_(\{\w+\}|\w))?(\\?[^_^]+(?:_(?:\{[^{}]*\}|\w))?)")
RAISED_FIRST = re.compile(r"(\^(?:\{[^{}]*\}|\w))(_(?:\{[^{}]*\}|\w))")
NONE, SAME = "none", "same"  # of what is in no frame, as Euler angles; of an identity


@dataclass(frozen=True)
class Axis:
    """of: the frame, a computed one by what it stands for, or a number for one that is not known yet, or several of a
    column of vectors.

    exact: the frame itself, where the name tells a computed one from the other; strict: of a computed quantity that is
    printed in both, so that this is not taken for the computed frame.
    """

    of: "str | int | tuple[Axis, ...]"
    exact: str = ""
    strict: bool = False


ONE = Axis("")  # of a scalar or a column


@dataclass(frozen=True)
class Framed:
    """The frames of a term: rows, columns, and its rate as the frames' turns against one another, if it has one."""

    rows: Axis = ONE
    columns: Axis = ONE
    rate: tuple[tuple[str, int], ...] | None = None
    turn: bool = False  # of one frame to another: a rate beside it stays a rate
    apart: bool = False  # the turn between a frame and its computed one
    leads: tuple[Axis, Axis] | None = None  # of a small turn: from, to; its exponential takes the second to the first

    @property
    def T(self) -> "Framed":
        rate = self.rate and tuple((name, -times) for name, times in self.rate)  # of a skew matrix
        return Framed(self.columns, self.rows, rate, self.turn, self.apart, back(self.leads))


def back(leads: tuple[Axis, Axis] | None) -> tuple[Axis, Axis] | None:
    return leads and (leads[1], leads[0])


SCALAR = Framed()
ANY = None  # stacked, or written by components: it says nothing
IDENTITY = Framed(turn=True)  # between a frame and itself, or its computed one


@dataclass
class Frames:
    """The frames of a paper's letters, by name or by its lines."""

    paper: Paper
    known: dict[int, str | tuple[Axis, ...]] = field(default_factory=dict)  # of numbered axes
    joined: dict[int, int] = field(default_factory=dict)
    letters: dict[str, Framed | None] = field(default_factory=dict)
    acts: dict[tuple[str, str], tuple[tuple[str, int], ...]] = field(default_factory=dict)
    number: Iterator[int] = field(default_factory=count)

    # ---- names

    @cached_property
    def alphabet(self) -> tuple[Quantity, ...]:
        """The letters of all equations; what several have stands there as often."""
        return tuple(letter for one in self.paper.equations for letter in one.alphabet)

    @cached_property
    def names(self) -> set[str]:
        """Frames that a turn of the paper leads to or from, and those that it declares."""
        found = (TURN.search(plain(letter.latex)) for letter in self.alphabet)
        names = {name for match in found if match for name in match.groups()[:2]}
        of_letters = {text for name, text in self.paper.frames.items() if " for " not in text}
        declared = {part for text in of_letters for part in re.split(r"^from | to ", text) if part}
        return names | declared - {NONE, SAME}

    def alias(self, name: str) -> str:
        """A frame that is called by two letters has a row `frame l` of what it is."""
        return self.paper.frames.get(f"frame {name}", name)

    def axis(self, name: str, letter: Quantity | None = None) -> Axis:
        """letter: whose axis it is."""
        name = self.alias(name)
        of = self.paper.computed.get(name, name.rstrip("'"))
        if letter is None or r"\hat" not in letter.latex or of != name or not self.has_computed(of):
            return Axis(of, name)
        # of a computed quantity the frame that is written may stand for the computed one
        return Axis(of, name, True) if letter.latex in self.held_apart else Axis(of)

    @cached_property
    def turns(self) -> dict[tuple[str, str], str]:
        """(from, to) -> the letter of the true turn; from a frame to itself none."""
        found = dict.fromkeys(((name, name) for name in self.names), "")
        for letter in self.alphabet:
            match = TURN.fullmatch(plain(letter.latex))
            if match and not ACCENTED.search(letter.latex) and letter.shape == (3, 3) and not match[3]:
                found[match[1], match[2]] = letter.symbol.name
        return found

    @cached_property
    def held_apart(self) -> set[str]:
        """Letters that are printed in a computed frame too, so that of these two each is in the frame that it names."""
        found = set()
        for letter in self.alphabet:
            for name, of in self.paper.computed.items():
                if letter.latex.endswith(f"^{name}"):
                    found |= {letter.latex, f"{letter.latex.removesuffix(name)}{of}"}
        return found

    def has_computed(self, name: str) -> bool:
        return f"{name}'" in self.names or name in self.paper.computed.values()

    def new(self) -> Axis:
        return Axis(next(self.number))

    def of_letter(self, letter: Quantity, number: str = "") -> Framed | None:
        """number: of the equation, in which it may mean something of its own."""
        own = f"({number}).{letter.symbol.name}"
        name = own if own in self.paper.frames else letter.symbol.name
        if name not in self.letters:
            self.letters[name] = self.named(letter, self.paper.frames.get(name, ""))
        return self.letters[name]

    def named(self, letter: Quantity, given: str) -> Framed | None:
        """given: as `Paper.frames` has it."""
        if not letter.shape:
            return SCALAR
        if given:
            return self.declared(letter, given)
        if letter.meaning == "zeros":
            return ANY
        if letter.shape not in ((3,), (3, 3), (4,)):
            return Framed(self.new(), self.new() if len(letter.shape) == 2 else ONE)
        if letter.meaning.startswith("identity"):
            return IDENTITY
        if letter.shape == (3,):
            return self.vector(letter) or Framed(self.new())
        if (turn := TURN.search(plain(letter.latex))) and self.turns_axes(letter):
            return self.turn(letter, *turn.groups())
        return ANY if letter.shape == (4,) else self.matrix(letter)

    def declared(self, letter: Quantity, given: str) -> Framed | None:
        """`n` of a vector, `b to n` of a turn, `from n to c` of a small one; NONE and SAME."""
        if given in (NONE, SAME):
            return ANY if given == NONE else IDENTITY
        start, _, end = given.removeprefix("from ").partition(" to ")
        rows = self.axis(start, letter)
        if given.startswith("from "):
            small = Axis(rows.of)
            return Framed(small, small if len(letter.shape) == 2 else ONE, leads=(rows, self.axis(end)))
        if end:
            return self.turn(letter, start, end, "")
        shown = self.vector(letter) if letter.shape in ((3,), (3, 3)) else None
        rate = shown.rate if shown and shown.rows == rows else None
        return Framed(rows, ONE if letter.shape == (3,) else rows, rate)

    def turn(self, letter: Quantity, start: str, end: str, transposed: str) -> Framed:
        rows, columns = self.axis(end, letter), self.axis(start, letter)
        apart = rows.of == columns.of
        turn, rate = r"\Delta" not in letter.latex, None
        if r"\dot" in letter.latex and letter.shape == (3, 3):
            unknown = [(UNKNOWN, 1)] * (apart or r"\hat" in letter.latex)
            turn, rate = False, combined([(str(columns.of), 1), (str(rows.of), -1), *unknown])
        made = Framed(rows, columns, rate, turn, apart)
        return made.T if transposed else made

    def matrix(self, letter: Quantity) -> Framed:
        """3x3: the skew matrix of a vector, by its meaning or as it is written, or one of any two frames."""
        if of := CROSSED.match(letter.meaning):
            found = (letter for letter in self.alphabet if letter.symbol.name == of[1])
            one = next((self.of_letter(vector) for vector in found), None)
        else:
            one = self.vector(letter)
            if one and not (r"\times" in letter.latex or one.rate):  # or Omega_in
                one = None
        return Framed(one.rows, one.rows, one.rate, leads=one.leads) if one else Framed(self.new(), self.new())

    def turns_axes(self, letter: Quantity) -> bool:
        """Whether the witness gives it a rotation, or a rate of one, or nothing: R_k^n may be a covariance."""
        if r"\dot" in letter.latex or letter.function or letter.shape != (3, 3):
            return True
        with digits(DIGITS):
            try:
                value = witness_point(self.paper, SEEDS[0], FULL).values[letter.symbol.name]
                off = size(value * value.T - eye(3))
            except (KeyError, ValueError, ZeroDivisionError, TypeError, BoresightError):
                return True
        return bool(off < EXACT) or r"\Delta" in letter.latex

    def vector(self, letter: Quantity) -> Framed | None:
        """Of its indices, or of its meaning, `..., in b`; a rotation vector by its meaning `from n to c` too."""
        latex, moves = plain(letter.latex), r"\dot" in letter.latex
        if (rate := RATE.search(latex)) and rate[3] in self.names:
            parts = [(str(self.axis(rate[2]).of), 1), (str(self.axis(rate[1]).of), -1)]
            errors = [(f"δ{frame}", times) for frame, times in parts]
            whole = errors if r"\delta" in latex else parts + errors * bool(COMPUTED.search(letter.latex))
            return Framed(self.axis(rate[3], letter), rate=None if moves else combined(whole))
        leads = None
        if (turn := LEADS.search(f"{letter.meaning},")) and not moves and {*turn.groups()} <= self.names:
            leads = self.axis(turn[1]), self.axis(turn[2])
        for found in (UPPER.search(latex.removesuffix(r"\times]").rstrip()), MEANT.search(letter.meaning)):
            if found and found[1] in self.names:
                return Framed(self.axis(found[1], letter), leads=leads)
        return Framed(self.new(), leads=leads) if leads else None

    def unknown(self) -> tuple[str, ...]:
        """The vectors and matrices of three components that got no frame, in the order of the paper."""
        names = dict.fromkeys(letter.symbol.name for letter in self.alphabet if letter.shape in ((3,), (3, 3)))
        found = ((name, self.letters.get(name)) for name in names)
        return tuple(name for name, framed in found if framed and isinstance(self.root(framed.rows), int))

    # ---- what is one

    def root(self, axis: Axis) -> str | int | tuple[Axis, ...]:
        of = axis.of
        while isinstance(of, int):
            if of in self.known:
                return self.known[of]
            if of not in self.joined:
                return of
            of = self.joined[of]
        return of

    def join(self, a: Axis, b: Axis) -> None:
        """One frame, or computed frames of one.  Raises Mismatch."""
        x, y = self.root(a), self.root(b)
        if x == y:
            return
        if isinstance(x, int):
            if isinstance(y, int):
                self.joined[x] = y
            else:
                self.known[x] = y
        elif isinstance(y, int):
            self.known[y] = x
        elif isinstance(x, tuple) or isinstance(y, tuple):
            raise ValueError
        else:
            raise Mismatch(f"{a.exact or x} and {b.exact or y}")


def plain(latex: str) -> str:
    """Without accents and fonts, so that the letter stands beside its indices; C^n_b and {}_b^n C as C_b^n."""
    text = latex
    for _ in range(4):
        text = ACCENTS.sub(r"\1", text)
    if before := BEFORE.fullmatch(text):
        upper, lower, stem = before.groups()
        text = f"{stem}_{lower}^{upper}" if upper and lower else f"{stem}^{upper or lower}"
    return RAISED_FIRST.sub(r"\2\1", text)


UNKNOWN = "?"  # beside a rate: an error of it that no name shows


def true(rate: Iterable[tuple[str, int]]) -> tuple[tuple[str, int], ...]:
    """Without errors."""
    return tuple((name, times) for name, times in rate if name != UNKNOWN and not name.startswith("δ"))


def combined(parts: Iterable[tuple[str, int]]) -> tuple[tuple[str, int], ...]:
    sums: dict[str, int] = {}
    for name, times in parts:
        sums[name] = sums.get(name, 0) + times
    return tuple(sorted((name, times) for name, times in sums.items() if times))


@dataclass
class Line:
    """A relation's terms: where it is judged, and to which order it claims to be right."""

    frames: Frames
    number: str  # of the equation
    letters: dict[str, Quantity]
    order: float
    points: Any  # of the witness at two scales, made when asked for
    lenient: tuple[frozenset[str], ...] = ()  # frames of which one is taken for the other all the same
    printed: bool = False  # without a claim; true in numbers, it may subtract components in n from those in n'
    of: tuple[Any, ...] = ()  # the sides that are judged
    mixed: bool = False  # a rate and what shows none stand in one sum that turns
    held: int = 0  # sums and products that were compared

    def one(self, a: Axis, b: Axis, orders: Any, strict: bool = False) -> None:
        """Two axes of a sum or a product are one frame; orders: gives that of the term that may be in the other."""
        if ONE in (a, b):
            if a != b:
                raise ValueError
            return
        x, y = self.frames.root(a), self.frames.root(b)
        if isinstance(x, tuple) and isinstance(y, tuple):
            if len(x) != len(y):  # one by blocks, one by components
                raise ValueError
            for pair in zip(x, y, strict=True):
                self.one(*pair, orders, strict)
            return
        self.held += 1
        self.frames.join(a, b)
        strict |= a.strict or b.strict
        if a.exact and b.exact and a.exact != b.exact and (strict or not self.small(a, b, orders)):
            raise Mismatch(f"{a.exact} and {b.exact}")

    def small(self, a: Axis, b: Axis, orders: Any) -> bool:
        """Whether it changes nothing that the line claims, if a term is in one and not in the other."""
        if {a.exact, b.exact} in self.lenient:
            return True
        apart = self.apart(a.exact, b.exact)
        return apart == inf or bool(apart and (orders() + apart > self.order or (self.printed and self.equal())))

    def apart(self, one: str, other: str) -> float:
        """By how the turn from one frame to another falls with the errors that the line takes for small."""
        turns = self.frames.turns
        pairs: list[tuple[str, str, bool]] = []
        for z in sorted(self.frames.names):
            for (x, y), backward in ((((one, z), (other, z)), False), (((z, one), (z, other)), True)):
                if x in turns and y in turns:
                    pairs.append((turns[x], turns[y], backward))
        sizes = []
        for point in self.points():
            for *pair, backward in pairs:
                try:
                    A, B = (point.values[name] if name else eye(3) for name in pair)
                except KeyError:
                    continue
                sizes.append(size((A * B.T if backward else A.T * B) - eye(3)))
                break
        if len(sizes) < 2:
            return 0
        return inf if sizes[0] < EXACT else float(mp.nint(mp.log(sizes[0] / sizes[1], 2)))

    def order_of(self, e: Any) -> float:
        """By how the term falls when the errors are halved."""
        try:
            sizes = [size(evaluate(e, point)) for point in self.points()]
        except (KeyError, ValueError, ZeroDivisionError, TypeError, BoresightError):
            return 0
        if sizes[0] < EXACT:
            return inf
        return float(mp.nint(mp.log(sizes[0] / sizes[1], 2))) if sizes[1] else inf

    def equal(self) -> bool:
        """Whether the sides are one, to the order that is claimed: as rates of two frames that are fixed together."""
        offs = (Add(a, Mul(-1, b, evaluate=False), evaluate=False) for a, b in pairwise(self.of))
        return all(off == inf or off > self.order for off in map(self.order_of, offs))

    def __call__(self, e: Any) -> Framed | None:
        if isinstance(e, Symbol):
            return self.frames.of_letter(self.letters[e.name], self.number) if e.name in self.letters else ANY
        if isinstance(e, MatrixBase):
            return self.blocks(e)
        if e.is_Number or e.is_NumberSymbol:
            return SCALAR
        if isinstance(e, AppliedUndef):
            return self.applied(e)
        if isinstance(e, Add | MatAdd | StrictLessThan):
            return self.sum(e.args)
        if isinstance(e, Mul | MatMul):
            return self.product(e.args)
        if isinstance(e, transpose):
            one = self(e.args[0])
            return one and one.T
        if isinstance(e, Pow):
            one = self(e.base)
            return one if one in (ANY, SCALAR) else one.T if e.exp == -1 else ANY
        for part in e.args:
            self(part)
        return SCALAR if e.is_commutative else ANY

    def blocks(self, e: Any) -> Framed:
        """A matrix of blocks; one of components has an axis of its own for its rows, and one for its columns."""
        new = self.frames.new
        if all(entry.is_commutative is True for entry in e):
            for entry in e:
                self(entry)
            return Framed(new() if e.rows > 1 else ONE, new() if e.cols > 1 else ONE)
        parts = [[self(e[i, j]) for j in range(e.cols)] for i in range(e.rows)]
        lines: list[list[Any]] = [parts, [*zip(*parts, strict=True)]]
        axes: list[Axis] = []
        for at, those in zip(("rows", "columns"), lines, strict=True):
            of: list[Axis] = []
            for components, run in groupby(those, lambda row: all(part is SCALAR for part in row)):
                of += [new()] if components else [self.block(at, row) for row in run]
            axes.append(of[0] if len(of) == 1 else Axis(tuple(of)))
        rows, columns = axes
        return Framed(rows, columns)

    def block(self, at: str, row: Iterable[Framed | None]) -> Axis:
        """The axis that the blocks of a row, or of a column, have in common."""
        silent = (ANY, IDENTITY, SCALAR)
        there = [getattr(part, at) for part in row if not any(part is nothing for nothing in silent)]
        for one, other in pairwise(there):
            self.one(one, other, lambda: 0)
        return next((axis for axis in there if axis.exact), there[0]) if there else self.frames.new()

    def sum(self, terms: Iterable[Any]) -> Framed | None:
        parts = [(term, self(term)) for term in terms]
        there = [(term, part) for term, part in parts if part is not ANY and part is not IDENTITY]
        identity = any(part is IDENTITY for _, part in parts)
        if identity:
            for _, part in there:
                self.one(part.rows, part.columns, lambda: inf)
        for (one, a), (other, b) in ((there[0], later) for later in there[1:]):
            for x, y in ((a.rows, b.rows), (a.columns, b.columns)):
                self.one(x, y, lambda one=one, other=other: max(self.order_of(one), self.order_of(other)))
        if identity and any(part is ANY for _, part in parts):
            return ANY
        if not there:
            return IDENTITY if identity else ANY
        rows, columns = (self.of_sum([getattr(part, at) for _, part in there]) for at in ("rows", "columns"))
        either = any(axis.exact and self.frames.has_computed(str(axis.of)) for axis in (rows, columns))
        if (
            either and len({self.order_of(term) == 0 for term, _ in there}) == 2
        ):  # what is true, and its error: computed
            rows, columns = Axis(rows.of), Axis(columns.of)
        if identity:  # and small turns: it leads from a frame to its computed one, or back
            return self.turned(there[0][1] if len(there) == 1 else Framed(rows, columns))
        rates = [part.rate for _, part in parts if part is not ANY]
        whole = None
        if len(there) == len(parts) and all(rate is not None for rate in rates):
            whole = combined(pair for rate in rates for pair in rate or ())
        return Framed(rows, columns, whole)

    def of_sum(self, axes: list[Axis]) -> Axis:
        """The one that says most."""
        return max(axes, key=lambda axis: (axis.strict, bool(axis.exact)))

    def product(self, factors: Iterable[Any]) -> Framed | None:
        factors = tuple(factors)
        parts = [(factor, self(factor)) for factor in factors]
        whole = Mul._from_args(factors)
        times, others = 1, []
        for factor, part in parts:
            if factor.is_Integer:
                times *= int(factor)
            elif part is not SCALAR and part is not IDENTITY:
                others.append(part)
        numbers = all(part is not SCALAR or factor.is_Integer for factor, part in parts)
        for a, b in pairwise(others):
            if a is not ANY and b is not ANY:
                self.one(a.columns, b.rows, lambda: self.order_of(whole), a.apart or b.apart)
        if not others:
            return IDENTITY if any(part is IDENTITY for _, part in parts) else SCALAR
        first, last = others[0], others[-1]
        if first is None or last is None:
            return ANY
        rates = [part.rate for part in others if part is not ANY and not part.turn]
        rate = None
        if numbers and len(rates) == 1 and rates[0] is not None and ANY not in others:
            rate = combined((name, times * n) for name, n in rates[0])
        turn = numbers and times == 1 and all(part is not ANY and part.turn for part in others)
        leads = None
        if numbers and len(others) == 1 and abs(times) == 1:
            leads = first.leads if times == 1 else back(first.leads)
        return Framed(first.rows, last.columns, rate, turn, leads=leads)

    @staticmethod
    def turned(small: Framed) -> Framed:
        """The turn by a small one."""
        rows, columns = small.leads or (Axis(small.rows.of), Axis(small.columns.of))
        return Framed(rows, columns, turn=True)

    def applied(self, e: Any) -> Framed | None:
        name, parts = e.func.__name__, [self(part) for part in e.args]
        one = parts[0]
        if name in self.letters:
            return self.frames.of_letter(self.letters[name], self.number)
        if one is None or one is IDENTITY:
            return ANY
        if name == "rate":
            self.mixed = True  # of the rates of its letters it says nothing
            return SCALAR if one is SCALAR else Framed(one.rows, one.columns)
        if name in ("E", "Σ", "conj"):
            return one.T if name == "conj" else one
        for arg in e.args:
            if isinstance(arg, Add):
                rates = [part is not ANY and part.rate is not None for part in map(self, arg.args)]
                self.mixed |= any(rates) and not all(rates)
        if name == "skew":
            return Framed(one.rows, one.rows, one.rate, leads=one.leads)
        if name == "cross":
            if (other := parts[1]) is not None:
                self.one(one.rows, other.rows, lambda: self.order_of(e))
            return Framed(one.rows)
        if name == "vee":
            self.one(one.rows, one.columns, lambda: inf)
            return Framed(one.rows, rate=one.rate, leads=one.leads)
        if name == "exp":  # of a small turn it leads from a frame to its computed one, or back
            self.one(one.rows, one.columns, lambda: inf)
            return self.turned(one)
        return SCALAR if name in ("norm", "entry") else ANY

    def relation(self, relation: Relation) -> None:
        """Each side against the one before.  What is equal to the order of a claim is judged in numbers: here, whether
        its frames may be one.  Raises Mismatch."""
        self.of = tuple(relation.sides)
        for left, right in pairwise(relation.sides):
            self.sides(left, right)
        self.act(*relation.sides[:2])

    def act(self, left: Any, right: Any) -> None:
        """By which rate a vector turns in one equation it turns in all that have the same derivative."""
        terms = [*self.terms(left, 1), *self.terms(right, -1)]
        derivatives = [(sign, one) for sign, term in terms if (one := self.derivative(term))]
        if len(derivatives) != 1:
            return
        ((of, subject),) = derivatives
        sums: dict[str, list[tuple[str, int]]] = {}
        beside: set[str] = set()
        for sign, term in terms:
            if self.derivative(term) is None:
                found = [*self.acting(term, -of * sign)]
                for x, rate in found:
                    sums.setdefault(x, []).extend(rate)
                if not found:
                    beside |= {s.name for s in term.free_symbols if (part := self(s)) is ANY or not part.turn}
        if self.mixed:
            return
        subject = " ".join((subject, *sorted(beside)))
        for x, parts in sums.items():
            rate = combined(parts)
            if UNKNOWN in dict(rate):
                continue
            rate = true(rate) or rate
            before = self.frames.acts.setdefault((subject, x), rate)
            if before != rate and not self.equal():
                raise Mismatch(f"{x or 'it'} turns by {words(rate)}, elsewhere by {words(before)}")

    def terms(self, e: Any, times: int) -> Iterator[tuple[int, Any]]:
        sign, rest = signed(e)
        if isinstance(rest, Add | MatAdd):
            for term in rest.args:
                yield from self.terms(term, times * sign)
        else:
            yield times * sign, rest

    def derivative(self, term: Any) -> str | None:
        """The letter, if the term is a rate of change, perhaps turned, or its skew matrix."""
        factors = term.args if isinstance(term, Mul | MatMul) else (term,)
        others = [factor for factor in factors if (part := self(factor)) is ANY or not part.turn]
        (one,) = others if len(others) == 1 else (S.Zero,)
        if isinstance(one, AppliedUndef) and one.func.__name__ == "skew":
            one = one.args[0]
        if isinstance(one, Symbol) and one.name in self.letters and DERIVATIVE.search(self.letters[one.name].latex):
            return str(one.name)
        return None

    def acting(self, e: Any, times: int) -> Iterator[tuple[str, tuple[tuple[str, int], ...]]]:
        """What a rate stands beside, and the rate."""
        if isinstance(e, Add | MatAdd):
            for term in e.args:
                yield from self.acting(term, times)
            return
        factors = list(e.args) if isinstance(e, Mul | MatMul) else [e]
        if isinstance(last := factors[-1], AppliedUndef) and last.func.__name__ == "cross":
            one, other = last.args
            rate = self(one)
            if rate is not ANY and rate.rate is not None:
                factors[-1:] = [one, other]
            else:
                factors[-1:], times = [other, one], -times
        rates, others = [], []
        for factor in factors:
            if factor.is_Integer:
                times *= int(factor)
                continue
            part = self(factor)
            if part is not ANY and part.rate is not None:
                rates.append(part.rate)
            elif part is ANY or not part.turn:
                others.append(factor)
        if len(rates) != 1 or len(others) > 1:
            return
        if not others:
            yield "", tuple((name, times * n) for name, n in rates[0])
            return
        for term in others[0].args if isinstance(others[0], Add) else others:
            sign, x = signed(term)
            yield str(x), tuple((name, times * sign * n) for name, n in rates[0])

    def sides(self, left: Any, right: Any) -> None:
        if isinstance(left, MatrixBase) and isinstance(right, MatrixBase) and left.shape == right.shape:
            for one, other in zip(left, right, strict=True):
                self.sides(one, other)
            return
        a, b = self(left), self(right)
        if a is ANY or b is ANY or a is SCALAR or b is SCALAR:
            return
        if IDENTITY in (a, b):
            one = b if a is IDENTITY else a
            if one is not IDENTITY:
                self.one(one.rows, one.columns, lambda: inf)
            return
        if self.either(a, b):
            return
        for x, y in ((a.rows, b.rows), (a.columns, b.columns)):
            self.one(x, y, lambda: max(self.order_of(left), self.order_of(right)))
        if a.rate is not None and b.rate is not None:
            of = true if self.lenient or self.order < 1 or UNKNOWN in dict((*a.rate, *b.rate)) else tuple
            if of(a.rate) != of(b.rate) and not self.equal():
                raise Mismatch(f"the rates {words(of(a.rate))} and {words(of(b.rate))}")

    def either(self, a: Framed, b: Framed) -> bool:
        """Whether these are one computed turn: an error at its left is one at its right, b to n' is b' to n."""
        of = self.frames.axis
        pairs = [(x.exact, y.exact) for x, y in ((a.rows, b.rows), (a.columns, b.columns))]
        if not all(x and y and x != y and of(x).of == of(y).of for x, y in pairs):
            return False
        (x, y), (u, v) = pairs
        return (x == of(x).of) != (u == of(u).of) and (y == of(y).of) != (v == of(v).of)


def signed(e: Any) -> tuple[int, Any]:
    """The sign before a term, and what stands behind it."""
    if isinstance(e, Mul | MatMul) and e.args[0] == -1:
        return -1, e.args[1] if len(e.args) == 2 else type(e)._from_args(e.args[1:]) if isinstance(e, Mul) else e.func(
            *e.args[1:]
        )
    return 1, e


def words(rate: Iterable[tuple[str, int]]) -> str:
    """`n - i`: the turn of n against i."""
    text = "".join(
        f" {'-' if times < 0 else '+'} {abs(times) if abs(times) != 1 else ''}{name}" for name, times in rate
    )
    return text.strip(" +") or "0"


def size(value: Any) -> Any:
    return largest(entries(value))


def claimed(claim: Claim | None) -> float:
    """The order through which a line is right; a derived form is of first order."""
    if claim is None:
        return 1
    return {"first-order": 1, "limit": 0, "order": claim.order}.get(claim.kind, 1 if claim.small else inf)


def line(frames: Frames, equation: Equation, at: str, claim: Claim | None) -> Line:
    small = (claim and claim.small) or equation.small

    def points() -> tuple[Point, Point]:
        one, other = (witness_point(frames.paper, SEEDS[0], scale, small) for scale in SCALES[:2])
        return one, other

    given = frames.paper.frames.get(f"({equation.number}).{at}", "").partition(":")[0]
    lenient = tuple(frozenset(pair.split(" for ")) for pair in given.split(", ") if pair)
    letters = {q.symbol.name: q for q in equation.alphabet}
    return Line(frames, equation.number, letters, claimed(claim), points, lenient, claim is None)


@dataclass(frozen=True)
class Found:
    """held: how many sums and products were compared; misfits: equation, line (0: the equation itself) and why;
    unknown: the vectors and matrices of which no frame is known."""

    held: int
    misfits: tuple[tuple[str, str, str], ...]
    unknown: tuple[str, ...]


@cache
def found(paper: Paper) -> Found:
    """What the frames of all equations and lines are, against one another."""
    frames, held, misfits = Frames(paper), 0, []
    for one in paper.equations:
        for at, claim, relation in one.stated:
            judge = line(frames, one, at, claim)
            try:
                with digits(DIGITS):
                    judge.relation(relation)
            except Mismatch as error:
                misfits.append((one.number, at, str(error)))
            except ValueError:  # shapes that do not fit, which the judge of numbers names
                pass
            held += judge.held
    return Found(held, tuple(misfits), frames.unknown())
