"""What the templates of the covariance loops are filled with: sizes and index tables."""

from collections.abc import Iterable
from typing import Any

from boresight.codegen.functions.dynamics import left_of_Q, left_out, series, spread
from boresight.codegen.functions.unit import Unit
from boresight.codegen.text import sparse
from boresight.codegen.text.places import Places, coupled, met, moving, powers, reach, staying_pairs, table
from boresight.derive.model import Model

LANES = 4
TILE = 16  # columns of a row that are summed at a time on a host: what half of its registers hold
BLOCK, TALL = 5, 3  # columns and rows of a product that are summed at a time: what the registers of a small target hold


def nonzeros(made: list[Unit], name: str) -> Places:
    (unit,) = (unit for unit in made if unit.name == name)
    return unit.results[0].nonzeros


def even(count: int, most: int) -> tuple[int, int]:
    """Blocks of at most this size, as even as `count` allows: their size, and the numbers in all of them."""
    blocks = -(-count // most)
    size = -(-count // blocks)
    return size, size * blocks


def drivers(F: Places, m: int, tall: int) -> list[tuple[int, int, int, int]]:
    """The rows of F that move in whole blocks: the first, how many, and the first and the end of the moving states that
    drive them, blocks of the same as one."""
    found: list[tuple[int, int, int, int]] = []
    for row in range(0, m, tall):
        by = [k for i, k in F if row <= i < row + tall and k < m] or [0]
        span, rows = (min(by), max(by) + 1), tall
        if found and found[-1][2:] == span:
            row, rows = found[-1][0], found[-1][1] + tall
            found.pop()
        found.append((row, rows, *span))
    return found


def discretize_cost(n: int, F: Places, Qc: Places, order: int) -> int:
    """Additions, multiplications and divisions of `discretize`, where no pivot of Qc vanishes."""
    m = moving(n, F)
    (_, row), (tall, down), first = even(n, BLOCK), even(m, TALL), reach(n, Qc)
    upper = [(i, j) for i, j in Qc if i <= j]
    inner, wide = sum(i < m for i, _ in upper), n - min([m, *(i for i, _ in Qc)])
    nodes, blocks = 1 + (order == 3), down // tall * (down // tall + 1) // 2
    powers_of_F = (order - 1) * sum(2 * rows * row * (end - begin) for _, rows, begin, end in drivers(F, m, tall))
    cost = len(F) + powers_of_F + (1, 5, 12)[order - 1] * down * row + 2 * m  # Phi and B
    cost += (order == 2) + len(upper)
    for k in coupled(first):  # the factors of Qc, and B times them
        cost += 3 + sum(3 + 2 * (i - first[k]) + 2 * down * nodes for i in range(first[k], k))
    cost += (2 * nodes - 1) * down * wide + nodes * blocks * 2 * wide * tall * tall  # squares
    if staying_pairs(m, first):
        cost += m * (n - m) * (n - m - 1)
    cost += m * (m + 1) // 2 if order == 3 else 0
    return cost + len(upper) - inner + (3 * inner if order == 2 else 0)


def movers(model: Model, made: list[Unit]) -> int:
    """How many states of a model may move: in discrete time, where no rate of them says it, all."""
    return model.n if model.discrete else moving(model.n, nonzeros(made, "F"))


def arranged(model: Model, made: list[Unit]) -> dict[str, Any]:
    """Where the printed non-zeros of Phi stand in the rows that move."""
    (_, row), m = even(model.n, BLOCK), movers(model, made)
    places = [i * row + j for i, j in nonzeros(made, "Phi") if i < m]
    return {"Phi_count": len(places), "Phi_places": ", ".join(map(str, places))}


def whole(count: int) -> int:
    """Numbers of the blocks of four that hold so many."""
    return -(-count // LANES) * LANES


def runs(columns: Iterable[int]) -> list[tuple[int, int]]:
    """Ascending numbers as ranges without gaps: begin and end of each."""
    found: list[tuple[int, int]] = []
    for k in columns:
        if found and found[-1][1] == k:
            found[-1] = (found[-1][0], k + 1)
        else:
            found.append((k, k + 1))
    return found


def tiles(count: int) -> list[tuple[int, int]]:
    """So many columns in parts of TILE: where each begins, and its columns."""
    return [(begin, min(TILE, count - begin)) for begin in range(0, count, TILE)]


def groups(m: int) -> list[tuple[int, int, int, int]]:
    """Of the upper triangle of m columns, what one loop sums: the first row, how many rows, and for which columns."""
    found = []
    for begin, count in tiles(m):
        last = begin + whole(count) - LANES
        found += [(begin, at + LANES - begin, at, at + LANES) for at in range(begin, last, LANES)]
        found.append((begin, whole(count), last, m))
    return found


def index_type(numbers: str | list[int]) -> str:
    """The smallest type in C that holds these, which may be a text of numbers and commas."""
    listed = [int(word) for word in numbers.split(",")] if isinstance(numbers, str) else numbers
    return "unsigned char" if max(listed) < 256 else "unsigned short"


def covariance_view(model: Model, made: list[Unit]) -> dict[str, Any]:
    """Sizes and index tables of the covariance functions."""
    n = model.n
    F: Places = ()
    Qc: Places = ()
    given: dict[str, Any]
    if model.F is not None:
        F, Qc = nonzeros(made, "F"), nonzeros(made, "Qc")
        given = {"F": table(F, n), "Qc": table(Qc, n)}
    else:
        given = {"F": None, "Phi": table(nonzeros(made, "Phi"), n), "Q": table(nonzeros(made, "Q"), n)}
    sized = ("F", "Qc") if model.F is not None or model.loops else ()  # what the filter keeps
    m = movers(model, made)
    (block, row), (tall, down) = even(n, BLOCK), even(m, TALL)
    region = max(n * row, down * down, m + row + m + tall)
    # of Qc the upper triangle, first what has a part in rows that move
    upper = sorted((i >= m, p, j * (j + 1) // 2 + i) for p, (i, j) in enumerate(sorted(Qc)) if i <= j)
    first = reach(n, Qc)
    rows = max(len(m.rows) for m in model.measurements)
    begin = min([m, *(i for i, _ in Qc)])  # columns of B before this one meet no noise
    Phi = powers(n, F, model.order) if F else set(nonzeros(made, "Phi")) if not model.loops else set()
    by_rows = bool(Phi) and m >= whole(n) - n  # whole blocks that end with a row of N begin in the M numbers before it
    over_nonzeros = bool(F) and model.order < 3 and not staying_pairs(m, first)
    over_nonzeros = over_nonzeros and sparse.worthwhile(n, m, down, row, tall, Phi)
    printed = sparse.sparse_view(n, m, row, F, Qc, model.order) if over_nonzeros else None
    cost = discretize_cost(n, F, Qc, model.order) if model.F is not None else None
    if printed:
        cost = printed["cost"]
        region = max(region, printed["end"] ** 2, m * (m + row))
    return {
        "sparse": printed,
        "by_rows": by_rows,
        "Phi_runs": [runs(k for k in range(n) if (i, k) in Phi) for i in range(m)] if by_rows else [],
        "tile": TILE,
        "tiles": tiles,
        "groups": groups,
        "lanes": LANES,
        "wide": whole(n),
        "deep": whole(m),
        "discretize_rows": by_rows and bool(F) and model.order < 3,
        "only_loops_multiply": by_rows and not (F and model.order == 3),
        "only_loops_cross": by_rows and m == n and not (F and model.order == 3),
        "A_from": [[sorted(F).index((i, j)) if (i, j) in F else None for j in range(whole(n))] for i in range(m)],
        "A": table(tuple((i, k) for i, k in F if k < m), m),
        "B": table(tuple((i, k) for i, row in enumerate(met(m, Phi, first, begin)) for k in row), m),
        "packed_at": sparse.packed,
        "packed": n * (n + 1) // 2,
        "block": block,
        "row": row,
        "tall": tall,
        "down": down,
        "moving": m,
        "region": region,
        # a measurement keeps H there, dense where its R is, and behind it the gain, where states are considered; a
        # beginning keeps its factors and a dense P, a step by loops two dense matrices
        "work": max(
            region + down * (m + row),
            region + down * ((row if model.order == 3 else 0) + row + down),
            2 * n * rows,
            n * (n + 1) // 2 + n * n,
            2 * n * n if model.loops else 0,
            2 * printed["count"] + len(F) if printed else 0,
        ),
        **given,
        "sizes": {name: len(nonzeros(made, name)) for name in sized},
        "order": model.order,
        "series": series(model.order),
        "drivers": drivers(F, m, tall),
        "left_out": left_out(model.order),
        "left_of_Q": left_of_Q(model.order),
        "cost": cost,
        "spread": spread(model.order),
        "F_place": ", ".join(str(i * row + j) for i, j in sorted(F)),
        "Qc_count": len(upper),
        "Qc_moving": sum(not stays for stays, _, _ in upper),
        "Qc_from": ", ".join(str(p) for _, p, _ in upper),
        "Qc_place": ", ".join(str(at) for _, _, at in upper),
        "coupled": coupled(first),
        "reach": [first[k] for k in coupled(first)],
        "begin": begin,
        "staying_pairs": staying_pairs(m, first),
        "index": index_type,
        "fraction": lambda a, b: repr(a / b),
    }
