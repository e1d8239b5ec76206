"""Numbers with a name, a unit and a meaning: in expressions by their names, and as numbers in what is printed as C."""

from collections.abc import Iterable
from typing import Any

from sympy import Expr, Float, NumberSymbol, Rational, nan, sympify

from boresight import BoresightError
from boresight.derive.letters import letter_latex
from boresight.derive.where import written_at


class Constant(NumberSymbol):
    """A constant of nature or of a model; made by `constant`.

    Like pi it is a number to SymPy: no free symbol, and evalf and lambdify know its value.
    value: as it was given, perhaps in terms of other constants.  exact: without them.
    """

    __slots__ = ("exact", "meaning", "name", "unit", "value", "where")
    name: str
    value: Expr
    exact: Expr
    unit: str
    meaning: str
    where: str
    is_real = True
    is_zero = False

    def __new__(cls, name: str, value: Expr, unit: str, meaning: str, where: str = "") -> "Constant":
        self = super().__new__(cls)
        self.name, self.value, self.unit, self.meaning, self.where = name, value, unit, meaning, where
        self.exact = value.xreplace({part: part.exact for part in value.atoms(Constant)})
        return self

    def __getnewargs__(self) -> tuple[str, Expr, str, str, str]:
        return self.name, self.value, self.unit, self.meaning, self.where

    def __getstate__(self) -> None:
        return None

    def _hashable_content(self) -> tuple[Any, ...]:
        return self.name, self.exact, self.unit

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, Constant) and self._hashable_content() == other._hashable_content())

    def __hash__(self) -> int:
        return super().__hash__()

    def _eval_is_positive(self) -> bool:
        return bool(self.exact.is_positive)

    def _as_mpf_val(self, prec: int) -> Any:
        return self.exact._eval_evalf(prec)._mpf_

    def __int__(self) -> int:
        return int(self.exact)

    def approximation_interval(self, number_cls: Any) -> Any:
        whole = self.exact.__floor__()
        return (whole, whole + 1) if issubclass(number_cls, type(whole)) else None

    def _sympystr(self, printer: Any) -> str:
        return self.name

    def _sympyrepr(self, printer: Any) -> str:
        return self.name

    def _latex(self, printer: Any) -> str:
        return letter_latex(self.name)

    def _lambdacode(self, printer: Any) -> str:
        """In Python, NumPy's or mpmath's, as made by lambdify."""
        return str(printer.doprint(self.exact))

    _pythoncode = _numpycode = _mpmathcode = _lambdacode


def constant(name: str, value: Expr | str | float, unit: str, meaning: str) -> Constant:
    """A named number with a unit: in formulas by its name, in C as a number.

    Parameters
    ----------
    name : str
        In formulas and in the file of a model's equations.
    value : sympy.Expr, str or float
        Exact as text or a Rational, as "9.81"; a float is taken for the decimal number that it
        shows; or an expression of other constants.
    unit : str
        SI, angles in rad.
    meaning : str
        A few words for pages.

    Returns
    -------
    Constant
        To SymPy a number, as pi is: no free symbol, and evalf knows its value.

    Raises
    ------
    BoresightError
        A value that is no finite number, or is zero.

    Notes
    -----
    When not to use it: for what may differ from one vehicle or flight to the next; that is an
    input, a `variable`.  A bare number in an expression has no unit, and is refused where one is
    needed.

    Examples
    --------
    >>> from boresight import constant
    >>> g = constant("g", "9.81", "m/s^2", "gravity")
    >>> print(2 * g, float(2 * g))
    2*g 19.62
    """
    try:
        number = sympify(Rational(str(value)) if isinstance(value, str | float | Float) else value)
    except (TypeError, ValueError):  # no number at all
        number = nan
    if not (isinstance(number, Expr) and number.is_number and number.is_finite and number.is_real):
        raise BoresightError(
            f"{written_at()}: the constant {name} is {value}; give a finite number, or an expression of constants"
        )
    if number.is_zero:
        raise BoresightError(f"{written_at()}: the constant {name} is zero; write 0, which has every unit")
    return Constant(name, number, unit, meaning, written_at())


def behind(constants: Iterable[Constant]) -> list[Constant]:
    """The constants and those that their values are made of, each after the latter."""
    found: dict[Constant, None] = {}

    def visit(one: Constant) -> None:
        for part in sorted(one.value.atoms(Constant), key=str):
            visit(part)
        found[one] = None

    for one in sorted(constants, key=str):
        visit(one)
    return list(found)
