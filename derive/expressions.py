"""What the matrices of a model are made of, and matrices with other things in their places."""

from collections.abc import Mapping
from functools import reduce
from typing import Any

from sympy import Add, Matrix, Symbol
from sympy.matrices import MatrixBase

from boresight.derive.constant import Constant
from boresight.derive.named import Named, Quantity


def below(part: Any) -> tuple[Any, ...]:
    """What an expression is made of: of a name its value."""
    return (part.value,) if isinstance(part, Named) else part.args


def parts_of(*matrices: Matrix) -> set[Any]:
    """Every expression within the matrices.  What is held many times is looked at once: SymPy's own free_symbols takes
    seconds where residuals are nested rotations."""
    seen: set[Any] = set()
    stack = [entry for matrix in matrices for entry in matrix]
    while stack:
        part = stack.pop()
        if part not in seen:
            seen.add(part)
            stack += below(part)
    return seen


def product(*matrices: Matrix) -> Matrix:
    """The matrices multiplied from the left.  SymPy's own asks each entry whether it is infinite, which takes as long
    as all the rest."""

    def times(A: Matrix, B: Matrix) -> Matrix:
        rows, columns = A.tolist(), B.T.tolist()
        return Matrix(
            [
                [Add(*(a * b for a, b in zip(row, column, strict=True) if a != 0 and b != 0)) for column in columns]
                for row in rows
            ]
        )

    return reduce(times, matrices)


def symbols_in(*matrices: Matrix) -> set[Symbol]:
    """All symbols that the matrices read."""
    return {part for part in parts_of(*matrices) if part.is_Symbol}


def constants_in(*matrices: Matrix) -> set[Constant]:
    """All named constants that the matrices read."""
    return {part for part in parts_of(*matrices) if isinstance(part, Constant)}


def names_in(*matrices: Matrix) -> list[Named]:
    """All named entries that the matrices read, each after those in its value, in the order of reading."""
    found: dict[Any, None] = {}

    def visit(part: Any) -> None:
        if part not in found:
            for inner in below(part):
                visit(inner)
            found[part] = None

    for matrix in matrices:
        for entry in matrix:
            visit(entry)
    return [part for part in found if isinstance(part, Named)]


def quantities_in(*matrices: Matrix) -> list[Quantity]:
    """All quantities of which the matrices read an entry, and those that all their entries are made of, each after
    those in its value."""
    found: dict[Quantity, None] = {}

    def visit(*matrices: Matrix) -> None:
        for entry in names_in(*matrices):
            if entry.quantity not in found:
                visit(entry.quantity.value)
                found[entry.quantity] = None

    visit(*matrices)
    return list(found)


def numeric(matrix: Matrix, names: bool = False) -> Matrix:
    """The matrix with numbers in the place of its constants, and without names if these are not to stay."""
    found = constants_in(matrix)
    if not found and (names or not names_in(matrix)):
        return matrix
    return substituted(matrix, {one: one.exact for one in found}, names)


def unnamed(value: Any) -> Any:
    """An expression or a matrix with what its names stand for in their places."""
    made = substituted(value if isinstance(value, MatrixBase) else Matrix([value]), {}, names=False)
    return made if isinstance(value, MatrixBase) else made[0]


def substituted(matrix: Matrix, mapping: Mapping[Any, Any], names: bool = True) -> Matrix:
    """The matrix with expressions in the place of symbols, constants or names; what is held many times is done once.

    names: False to put what they stand for in the place of all others too.
    """
    known: dict[Any, Any] = dict(mapping)

    def quantity(one: Quantity) -> Quantity:
        if one not in known:
            known[one] = one.mapped(visit)
        made: Quantity = known[one]
        return made

    def visit(part: Any) -> Any:
        if part not in known:
            if isinstance(part, Named):
                known[part] = part.within(quantity(part.quantity)) if names else visit(part.value)
            else:
                args = tuple(map(visit, part.args))
                known[part] = part if args == part.args else part.func(*args)
        return known[part]

    return Matrix(*matrix.shape, [visit(entry) for entry in matrix])
