"""What \flown{H} stands for in the derivation: the measurement of the master's attitude, as the model has it."""

from collections.abc import Mapping

from sympy import Function, ImmutableMatrix, Integer, Symbol

from boresight.derive.papers.kang_2025.results import attitude_matrix


def flown(letters: Mapping[str, Symbol]) -> dict[str, object]:
    return {"H": attitude_matrix(entries(letters["C"], 3, 3), entries(letters["ω"], 3)).as_immutable()}


def entries(letter: Symbol, rows: int, columns: int = 1) -> ImmutableMatrix:
    """The matrix of a letter's entries, for a function that takes them one by one."""
    entry = Function("entry")
    return ImmutableMatrix(rows, columns, lambda i, j: entry(letter, Integer(i + 1), Integer(j + 1)))
