"""What the templates of the covariance loops are filled with: sizes and index tables."""

from typing import Any

from boresight.codegen.functions.dynamics import left_out, series
from boresight.codegen.functions.units import Unit
from boresight.derive.model import Model

BLOCK = 5  # columns of a product that are summed at a time: what the registers of a small target hold

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


def nonzeros(made: list[Unit], name: str) -> Places:
    (unit,) = (unit for unit in made if unit.name == name)
    return unit.results[0].nonzeros


def phi_places(n: int, F: Places, order: int) -> Places:
    """Non-zeros of I + F + F F ... to the power `order`, whatever the numbers."""
    below: dict[int, set[int]] = {i: {column for row, column in F if row == i} for i in range(n)}
    places = power = {(i, i) for i in range(n)}
    for _ in range(order):
        power = {(i, column) for i, k in power for column in below[k]}
        places = places | power
    return tuple(sorted(places))


def discretize_cost(n: int, F: Places, Qc: Places, order: int, row: int) -> int:
    """Additions and multiplications of `discretize`."""
    of_F, of_Qc = ([sum(i == k for i, _ in places) for k in range(n)] for places in (F, Qc))
    cost = len(F) + len(Qc) + n  # times dt; 1 on the diagonal
    for _, k in F:
        cost += 1
        if order > 1:
            cost += 1 + 2 * of_F[k] + 2 * of_Qc[k]
        if order > 2:
            cost += sum(2 + 2 * of_F[column] for i, column in F if i == k)
    level = 2 * len(Qc) + 2 * len(F) * row  # F X, with what is added to X
    cost += level + (2 * n * n if order == 2 else 0)
    cost += level + 3 * n * n if order == 3 else 0
    return cost + n * (n + 1) // 2 + sum(j <= i for i, j in Qc)


def covariance_view(model: Model, made: list[Unit]) -> dict[str, Any]:
    """Sizes and index tables of the covariance functions."""
    n = model.n
    F: Places = ()
    Qc: Places = ()
    if model.kind == "error-state":
        F, Qc = nonzeros(made, "F"), nonzeros(made, "Qc")
        Phi = phi_places(n, F, model.order)
        given: dict[str, Any] = {"F": table(F, n), "Qc": table(Qc, n)}
    else:
        Phi, given = nonzeros(made, "Phi"), {"F": None, "Q": table(nonzeros(made, "Q"), n)}
    sized = ("F", "Qc") if model.kind == "error-state" or model.loops else ()  # what the filter keeps
    block = -(-n // -(-n // BLOCK))  # as even as the number of states allows
    row = -(-n // block) * block
    leftmost = [min([j, *(column for i, column in Phi if i == j)]) for j in range(n)]
    packed = n * (n + 1) // 2
    rows = max(len(m.rows) for m in model.measurements)
    return {
        "packed": packed,
        "block": block,
        "row": row,
        # a measurement keeps H there, dense where its R is; behind it x and the gain, where states are considered, and
        # then the dense P, where it is linearised again
        "work": max(2 * row * row, n * rows + n * max(n, rows + 1)),
        **given,
        "sizes": {name: len(nonzeros(made, name)) for name in sized},
        "order": model.order,
        "series": series(model.order),
        "left_out": left_out(model.order),
        "cost": discretize_cost(n, F, Qc, model.order, row) if model.kind == "error-state" else None,
        "powers": " + ".join(["I", "F", "F F", "F F F"][: model.order + 1]),
        "highest": ("second", "third", "fourth")[model.order - 1],
        "spread": (
            "Qc + L(Qc) / 2 = Qc + L(Qc / 2)",
            "Qc + L(Qc) / 2 + L(L(Qc)) / 6 = Qc + L(Qc / 2 + L(Qc) / 6)",
            "Qc + L(Qc) / 2 + L(L(Qc)) / 6 + L(L(L(Qc))) / 24 = Qc + L(Qc / 2 + L(Qc / 6 + L(Qc) / 24))",
        )[model.order - 1],
        "Phi": table(Phi, n),
        "first": ", ".join(str(min(leftmost[j:])) for j in range(n)),
        "third": repr(1 / 3),
        "sixth": repr(1 / 6),
        "twentyfourth": repr(1 / 24),
    }
