"""Quantities that have a name: to SymPy what they stand for; on pages, in a difference and in C by their name."""

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any
from weakref import WeakValueDictionary

from sympy import AtomicExpr, Expr, ImmutableMatrix, Matrix, sympify
from sympy.matrices import MatrixBase

from boresight import BoresightError
from boresight.derive.letters import letter_latex
from boresight.derive.where import written_at

NAME = re.compile(r"[A-Za-z]\w*", re.ASCII)


@dataclass(frozen=True, eq=False)
class Quantity:
    """A scalar, a vector or a matrix and what it is called; `named` gives its entries, and `quantity` makes it.

    labels: of the entries, row by row: C_b2n_21 for 21; of a scalar "".
    """

    name: str
    value: ImmutableMatrix
    meaning: str
    labels: tuple[str, ...]

    def __reduce__(self) -> tuple[Any, ...]:
        return quantity, (self.name, self.value, self.meaning, self.labels)

    @cached_property
    def entries(self) -> ImmutableMatrix:
        """Of the shape of the value; what is no more than a letter or a number stays as it is."""
        flat = [value if plain(value) else Named(self, i) for i, value in enumerate(self.value)]
        return ImmutableMatrix(*self.value.shape, flat)

    @cached_property
    def free_symbols(self) -> tuple[frozenset[Any], ...]:
        """Of each value."""
        return tuple(frozenset(value.free_symbols) for value in self.value)

    def mapped(self, change: Callable[[Any], Any]) -> "Quantity":
        """The same with other values; itself where nothing changes."""
        values = [change(value) for value in self.value]
        if all(new is old for new, old in zip(values, self.value, strict=True)):
            return self
        return quantity(self.name, ImmutableMatrix(*self.value.shape, values), self.meaning, self.labels)


# What is equal is one object: names within names would be compared over and over otherwise.
KNOWN: WeakValueDictionary[tuple[Any, ...], Quantity] = WeakValueDictionary()


def quantity(*content: Any) -> Quantity:
    """The quantity of this name, value, meaning and these labels."""
    return KNOWN.setdefault(content, Quantity(*content))


def plain(value: Any) -> bool:
    """Whether it is a symbol, a number or a name already, perhaps with a minus."""
    return not value.args or not (-value).args


class Named(AtomicExpr):
    """An entry of a quantity, made by `named`.

    It has the free symbols, the derivatives and the numbers of its value, and a substitution goes into that.
    """

    __slots__ = ("index", "quantity")
    quantity: Quantity
    index: int
    is_commutative = True

    def __new__(cls, quantity: Quantity, index: int) -> "Named":
        self = super().__new__(cls)
        self.quantity, self.index = quantity, index
        return self

    def __reduce__(self) -> tuple[Any, ...]:  # type: ignore[override]
        return entry_of, (self.quantity, self.index)

    @property
    def value(self) -> Expr:
        """What it stands for, perhaps in terms of other names."""
        value: Expr = self.quantity.value[self.index]
        return value

    @property
    def name(self) -> str:
        return "_".join(filter(None, (self.quantity.name, self.quantity.labels[self.index])))

    def within(self, other: Quantity) -> Expr:
        """The same entry of a quantity with other values."""
        entry: Expr = self if other is self.quantity else other.entries[self.index]
        return entry

    def _hashable_content(self) -> tuple[Any, ...]:
        return self.name, self.value

    def __eq__(self, other: object) -> bool:
        return self is other

    def __hash__(self) -> int:
        return id(self)

    @property
    def free_symbols(self) -> set[Any]:
        return set(self.quantity.free_symbols[self.index])

    @property
    def is_number(self) -> bool:  # type: ignore[override]
        return bool(self.value.is_number)

    def _eval_is_real(self) -> bool | None:
        return self.value.is_real

    def _eval_evalf(self, prec: int) -> Any:
        return self.value._eval_evalf(prec)

    def _eval_derivative(self, symbol: Any) -> Expr:
        slope: Expr = self.value.diff(symbol)
        return slope

    def _eval_derivative_n_times(self, symbol: Any, count: Any) -> Expr:
        slope: Expr = self.value.diff((symbol, count))
        return slope

    def doit(self, **hints: Any) -> Any:
        return self.value.doit(**hints)

    def _eval_subs(self, old: Any, new: Any) -> Expr:
        return self.within(self.quantity.mapped(lambda value: value._subs(old, new)))

    def _xreplace(self, rule: Any) -> tuple[Any, bool]:
        if self in rule:
            return rule[self], True
        made = self.within(self.quantity.mapped(lambda value: value.xreplace(rule)))
        return made, made is not self

    def xreplace(self, rule: Any, hack2: bool = False) -> Any:
        return self._xreplace(rule)[0]

    def _sympystr(self, printer: Any) -> str:
        return self.name

    def _sympyrepr(self, printer: Any) -> str:
        return self.name

    def _latex(self, printer: Any) -> str:
        return letter_latex(self.name)

    def _lambdacode(self, printer: Any) -> str:
        """In Python, NumPy's or mpmath's, as made by lambdify."""
        return f"({printer.doprint(self.value)})"

    _pythoncode = _numpycode = _mpmathcode = _lambdacode


def entry_of(one: Quantity, index: int) -> Any:
    return one.entries[index]


def named(name: str, value: Any, meaning: str = "", components: str = "") -> Any:
    """A quantity under a name: in formulas, in a difference and in the C by it.

    Parameters
    ----------
    name : str
        Of the field: C_b2n, f_n, R_N.
    value : sympy.Expr or sympy.Matrix
        A scalar, a vector or a matrix of scalars.
    meaning : str, optional
        A few words for pages, with the unit where it helps.
    components : str, optional
        Of the entries, row by row, as "n e d"; they follow the name: f_n_d.  Without it they are
        numbered from 1, by row and column: C_b2n_21.

    Returns
    -------
    sympy.Expr or sympy.Matrix
        Of the same shape.  To SymPy each entry is its value: it has its free symbols, derivatives
        and numbers, and a substitution goes into it.  An entry that is a number or a symbol, perhaps
        with a minus, stays as it is.

    Raises
    ------
    BoresightError
        A name that is none in C, a value that is no expression, components that do not fit it.

    Notes
    -----
    When not to use it: for a number, which is a `constant`.  SymPy's `simplify` does not look into
    a name; `.doit()` takes the names off.  In C another name with the same letters gets a number
    behind it, and what no result needs is not there.

    Examples
    --------
    >>> from sympy import symbols
    >>> from boresight import named
    >>> v_n, v_e = symbols("v_n v_e", real=True)
    >>> speed = named("speed", (v_n**2 + v_e**2) ** 0.5, "over the ground, m/s")
    >>> print(2 * speed, speed.diff(v_e), speed.free_symbols == {v_n, v_e})
    2*speed 1.0*v_e/(v_e**2 + v_n**2)**0.5 True
    """
    whole = value if isinstance(value, MatrixBase) else Matrix([[sympify(value)]])
    count = whole.rows * whole.cols
    if not NAME.fullmatch(name):
        raise BoresightError(f"{written_at()}: {name!r} cannot be a name in C; write letters, digits and '_'")
    if not count or not all(isinstance(entry, Expr) for entry in whole):
        raise BoresightError(f"{written_at()}: {name} is {value}; give an expression or a matrix of expressions")
    labels = tuple(components.split()) or tuple(numbered(*whole.shape))
    if len(labels) != count or not all(re.fullmatch(r"\w*", label, re.ASCII) for label in labels):
        raise BoresightError(
            f"{written_at()}: {name} has {count} entries and the components {components!r}; name each, in letters"
        )
    entries = quantity(name, ImmutableMatrix(whole), meaning, labels).entries
    return Matrix(entries) if isinstance(value, MatrixBase) else entries[0]


def numbered(rows: int, columns: int) -> Iterator[str]:
    between = "_" if max(rows, columns) > 9 else ""
    for i in range(rows):
        for j in range(columns):
            yield "" if rows == columns == 1 else str(i + 1) if columns == 1 else f"{i + 1}{between}{j + 1}"


def distinct(entries: Iterable[Named]) -> dict[Named, str]:
    """The name of each; of several quantities of one name the second gets a 2 behind those of its entries."""
    seen: dict[str, list[Quantity]] = {}
    found: dict[Named, str] = {}
    for entry in entries:
        alike = seen.setdefault(entry.quantity.name, [])
        if entry.quantity not in alike:
            alike.append(entry.quantity)
        count = alike.index(entry.quantity) + 1
        found[entry] = entry.name + f"_{count}" * (count > 1)
    return found
