"""Numbers of a witness as SymPy's, and back: all digits kept."""

from flint import arb
from sympy import Float
from sympy import Matrix as Symbols

from boresight.derive.ledger.evaluate import DIGITS
from boresight.derive.ledger.numbers import Matrix, middle


def symbols_at(values):
    """The entries of a column, or of a matrix in its shape."""
    shape = (values.rows, values.cols) if isinstance(values, Matrix) else (len(values), 1)
    return Symbols(*shape, [Float(middle(entry), DIGITS) for entry in values])


def numbers(M):
    return Matrix([[arb(str(entry.evalf(DIGITS))) for entry in M.row(i)] for i in range(M.rows)])
