"""The shortest way to write an expression: as a polynomial, on the unit sphere of a quaternion or a direction."""

import operator
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import reduce
from typing import Any

import sympy as sp
from sympy import QQ, Matrix, ring

from boresight.derive.expressions import symbols_in
from boresight.derive.gradients import polynomial
from boresight.derive.named import Named


class Sphere:
    """A quaternion or a direction: what is equal where the squares of its letters add up to 1.

    What is reduced is multiplied by what keeps that norm, so that derivatives are taken before.  known: how polynomials
    of the letters are written, such as the entries of a rotation matrix.
    """

    def __init__(self, letters: Sequence[Any], known: Iterable[Any] = ()):
        self.letters = tuple(letters)
        self.ring, *_ = ring([f"s{k}" for k in range(len(self.letters))], QQ)
        self.forms: dict[Any, tuple[Any, Any]] = {}  # a polynomial over its first coefficient -> that, and its writing
        for entry in known:
            value = entry.value if isinstance(entry, Named) else entry
            if polynomial(value) and symbols_in([value]) <= set(self.letters):
                form = self.normal(Polynomials(self.letters, self.ring)(value))
                self.forms[form.monic()] = (form.LC, entry)

    def normal(self, p: Any) -> Any:
        """A polynomial of the letters without squares of the first one."""
        first, *others = self.ring.gens
        rest = 1 - sum(g**2 for g in others)
        while high := [(m, c) for m, c in p.terms() if m[0] >= 2]:
            part = self.ring.from_dict({(m[0] - 2, *m[1:]): c for m, c in high})
            p = p - part * first**2 + part * rest
        return p

    def written(self, p: Any) -> Any:
        """A polynomial of the letters by what it is called, or as short as it goes."""
        form = self.normal(p)
        if form and not form.is_ground and form.monic() in self.forms:
            own, entry = self.forms[form.monic()]
            return rational(form.LC / own) * entry
        return expression(form if len(form) < len(p) else p, self.letters)


class Polynomials:
    """Expressions of some letters as elements of a ring."""

    def __init__(self, letters: Sequence[Any], of: Any):
        self.of = of
        self.known: dict[Any, Any] = dict(zip(letters, of.gens, strict=True))

    def __call__(self, e: Any) -> Any:
        if e not in self.known:
            self.known[e] = self.made(e)
        return self.known[e]

    def made(self, e: Any) -> Any:
        if e.is_Number:
            return self.of(QQ.from_sympy(sp.Rational(e)))
        if e.is_Pow:
            return self(e.base) ** int(e.exp)
        parts = map(self, e.args)
        return reduce(operator.add if e.is_Add else operator.mul, parts)


def rational(value: Any) -> Any:
    return QQ.to_sympy(value)


def expression(p: Any, letters: Sequence[Any]) -> Any:
    terms = (sp.Mul(rational(c), *(x**k for x, k in zip(letters, m, strict=True) if k)) for m, c in p.terms())
    return sp.Add(*terms)


class Shortener:
    """Writes expressions as sums of products, on the spheres of a model's quaternions and directions."""

    def __init__(self, spheres: Sequence[Sphere]):
        self.spheres = list(spheres)
        self.opaque: dict[Any, Any] = {}  # what is no polynomial -> a letter for it
        self.known: dict[Any, Any] = {}

    def __call__(self, matrix: Matrix) -> Matrix:
        return Matrix(*matrix.shape, [self.short(e) for e in matrix])

    def short(self, e: Any) -> Any:
        if e not in self.known:
            self.known[e] = self.found(e)
        return self.known[e]

    def found(self, e: Any) -> Any:
        flat = self.flat(e)
        letters = list(dict.fromkeys(leaves(flat)))
        if not letters:
            return flat
        of, *_ = ring([f"x{k}" for k in range(len(letters))], QQ)
        made = self.written(Polynomials(letters, of)(flat), letters, self.spheres)
        return replaced(made, {letter: value for value, letter in self.opaque.items()})

    def written(self, p: Any, letters: Sequence[Any], spheres: Sequence[Sphere]) -> Any:
        """A polynomial of the letters: one sphere's letters after another's."""
        at = next((k for k, sphere in enumerate(spheres) if set(sphere.letters) & set(letters)), None)
        if at is None:
            return expression(p, letters)
        sphere, rest = spheres[at], [k for k, x in enumerate(letters) if x not in spheres[at].letters]
        place = [letters.index(x) if x in letters else None for x in sphere.letters]
        groups: dict[Any, dict[Any, Any]] = {}
        for m, c in p.terms():
            own = tuple(0 if k is None else m[k] for k in place)
            groups.setdefault(tuple(m[k] for k in rest), {})[own] = c
        others: dict[Any, dict[Any, Any]] = {}
        for other, terms in groups.items():
            number, form = sphere.written(sphere.ring.from_dict(terms)).as_coeff_Mul()
            others.setdefault(form, {})[other] = QQ.from_sympy(number)
        left = [letters[k] for k in rest]
        if not left:
            return sp.Add(*(rational(c) * form for form, terms in others.items() for c in terms.values()))
        of, *_ = ring([f"x{k}" for k in range(len(left))], QQ)
        return sp.Add(*(form * self.written(of.from_dict(t), left, spheres[at + 1 :]) for form, t in others.items()))

    def flat(self, e: Any) -> Any:
        """The expression with a letter in the place of what is no polynomial, powers of short bases apart."""
        if not e.args or isinstance(e, Named):
            return e
        if e.is_Add or e.is_Mul or (e.is_Pow and e.exp.is_Integer and e.exp > 0):
            return e.func(*map(self.flat, e.args))
        if e.is_Pow:
            base = self.short(e.base)
            if base.is_Number:
                return base**e.exp
            e = base**e.exp
            if not e.is_Pow:
                return self.flat(e)
        if e not in self.opaque:
            self.opaque[e] = sp.Dummy(real=True)
            if isinstance(e, sp.sin | sp.cos):
                pair = [self.opaque.setdefault(f(e.args[0]), sp.Dummy(real=True)) for f in (sp.cos, sp.sin)]
                self.spheres.append(Sphere(pair))
        return self.opaque[e]


def leaves(e: Any) -> Iterator[Any]:
    """The letters of a polynomial, one after the other."""
    if e.args:
        for part in e.args:
            yield from leaves(part)
    elif not e.is_Number:
        yield e


def replaced(e: Any, by: Mapping[Any, Any]) -> Any:
    """With others in the place of some letters, which are in no name."""
    if e in by:
        return by[e]
    if not e.args:
        return e
    args = tuple(replaced(part, by) for part in e.args)
    return e if args == e.args else e.func(*args)


def mirrored(matrix: Matrix) -> Matrix:
    """Symmetric to the letter, by its lower triangle."""
    return Matrix(*matrix.shape, lambda i, j: matrix[max(i, j), min(i, j)])


def squares(e: Any) -> bool:
    """Whether it is a sum of squares."""
    return e.is_Add and all(part.is_Pow and part.exp == 2 for part in e.args)
