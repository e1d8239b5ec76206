"""What the matrices of a model are made of, and matrices with other things in their places."""

from collections.abc import Mapping
from typing import Any

from sympy import Matrix, Symbol

from boresight.derive.constant import Constant


def parts_of(*matrices: Matrix) -> set[Any]:
    """Every expression within the matrices.  What is held many times is looked at once: SymPy's own free_symbols takes
    seconds where residuals are nested rotations."""
    seen: set[Any] = set()
    stack = [entry for matrix in matrices for entry in matrix]
    while stack:
        part = stack.pop()
        if part not in seen:
            seen.add(part)
            stack += part.args
    return seen


def symbols_in(*matrices: Matrix) -> set[Symbol]:
    """All symbols that the matrices read."""
    return {part for part in parts_of(*matrices) if part.is_Symbol}


def constants_in(*matrices: Matrix) -> set[Constant]:
    """All named constants that the matrices read."""
    return {part for part in parts_of(*matrices) if isinstance(part, Constant)}


def numeric(matrix: Matrix) -> Matrix:
    """The matrix with numbers in the place of its constants, as it is printed and flown."""
    found = constants_in(matrix)
    return substituted(matrix, {one: one.exact for one in found}) if found else matrix


def substituted(matrix: Matrix, mapping: Mapping[Any, Any]) -> Matrix:
    """The matrix with expressions in the place of symbols or constants; what is held many times is done once."""
    known: dict[Any, Any] = dict(mapping)

    def visit(part: Any) -> Any:
        if part not in known:
            args = tuple(map(visit, part.args))
            known[part] = part if args == part.args else part.func(*args)
        return known[part]

    return Matrix(*matrix.shape, [visit(entry) for entry in matrix])
