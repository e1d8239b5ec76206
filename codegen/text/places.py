"""Where the non-zeros of a step stand: of F, Phi, and of the factors of the noise."""

from typing import Any

Places = tuple[tuple[int, int], ...]


def table(places: Places, rows: int) -> dict[str, Any]:
    """Where row after row of a sparse matrix begins, and the columns of its non-zeros, as text."""
    ordered = sorted(places)
    start = [sum(row < i for row, _ in ordered) for i in range(rows + 1)]
    return {
        "nnz": len(ordered),
        "start": ", ".join(map(str, start)),
        "at": ", ".join(str(column) for _, column in ordered),
    }


def moving(n: int, F: Places) -> int:
    """How many states there are up to the last with a row in F, at least one: those behind keep their values."""
    return max((i + 1 for i, _ in F), default=1)


def reach(n: int, places: Places) -> list[int]:
    """Of each column of U in U D U', the factors of a symmetric matrix, the first row that may not be zero."""
    first = [min([j, *(i for i, column in places if column == j)]) for j in range(n)]
    for j in reversed(range(n)):
        for k in range(first[j], j):
            first[k] = min(first[k], first[j])
    return first


def coupled(first: list[int]) -> list[int]:
    """The states, from the last, whose columns of a factor have more than a diagonal, or are in the reach of such."""
    n = len(first)
    return [k for k in reversed(range(n)) if first[k] < k or any(first[j] <= k < j for j in range(n))]


def staying_pairs(m: int, first: list[int]) -> bool:
    """Whether noises of two states that do not move have a part in common."""
    return any(m <= i for j, begin in enumerate(first) for i in range(begin, j))


def powers(n: int, F: Places, order: int) -> set[tuple[int, int]]:
    """Where I + F + F F + ... may have non-zeros."""
    found = term = {(i, i) for i in range(n)}
    for _ in range(order):
        term = {(i, j) for i, k in term for other, j in F if k == other}
        found = found | term
    return found


def met(m: int, B: set[tuple[int, int]], first: list[int], begin: int) -> list[list[int]]:
    """Of each row of B U that moves, where it may have non-zeros in the columns that meet noise."""
    n = len(first)
    return [[k for k in range(begin, n) if any((i, l) in B for l in range(first[k], k + 1))] for i in range(m)]
