"""The rate of an expression by the rates of its letters: of `C v` it is `Ċ v + C v̇`."""

from sympy import Add, Function, Integer, MatAdd, MatMul, Mul, Pow, S, Symbol
from sympy.core.function import AppliedUndef
from sympy.functions.elementary.complexes import transpose
from sympy.matrices import MatrixBase

from boresight.derive.ledger.equation import children, is_explicit, product, rebuild, total
from boresight.derive.letters import dotted

RATE = Function("rate")  # as it is printed, \frac{d}{dt}(...)
LINEAR = ("skew", "vee", "conj", "row")


def rate_of(e):
    """Raises ValueError on what has no rate here."""
    if isinstance(e, Symbol):
        fixed = e.name[:2] in ("0_", "I_") and e.name[2:].replace("x", "").isdigit()
        real = True if e.is_commutative else None
        return S.Zero if fixed else Symbol(dotted(e.name), commutative=e.is_commutative, real=real)
    if not getattr(e, "free_symbols", ()):
        return S.Zero
    if isinstance(e, MatrixBase) or (isinstance(e, AppliedUndef) and e.func.__name__ in LINEAR):
        return rebuild(e, [rate_of(part) for part in children(e)])
    if isinstance(e, transpose):
        return transpose(rate_of(e.args[0]), evaluate=False)
    if isinstance(e, Add | MatAdd):
        return total(*filter(None, map(rate_of, e.args))) or S.Zero
    if isinstance(e, Mul | MatMul) or (isinstance(e, AppliedUndef) and e.func.__name__ == "cross"):
        return _one_by_one(e)
    if isinstance(e, Pow) and e.exp.is_Integer and not e.base.is_commutative:
        if e.exp == -1:
            return product(Integer(-1), e, rate_of(e.base), e)
        return _one_by_one(Mul._from_args((e.base if e.exp > 0 else e.base**-1,) * abs(int(e.exp))))
    if e.is_commutative and not isinstance(e, AppliedUndef) and not is_explicit(e):
        return total(*(e.diff(symbol) * rate_of(symbol) for symbol in sorted(e.free_symbols, key=str)))
    raise ValueError(f"no rate of {e} is read")


def _one_by_one(e):
    """The sum of the products in which one factor after the other is its rate."""
    rates = [(i, rate_of(part)) for i, part in enumerate(e.args)]
    terms = [[*e.args[:i], rate, *e.args[i + 1 :]] for i, rate in rates if rate != 0]
    make = e.func if isinstance(e, AppliedUndef) else product
    return total(*(make(*factors) for factors in terms)) if terms else S.Zero
