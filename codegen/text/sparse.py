"""A prediction over the non-zeros of F and Phi, printed row by row: what its templates are filled with.

Sums have the order of the blocked loops, less the terms that are zero; so their bits are the same.
"""

from typing import Any

from boresight.codegen.text.places import Places, coupled, powers, reach, table

SHARE = 1 / 3  # of the operations of the blocked loops: where a printed row takes less, it is worth its bytes


def packed(i: int, j: int) -> int:
    """Where element (i, j) of a symmetric matrix stands, in the columns of its upper triangle."""
    i, j = min(i, j), max(i, j)
    return j * (j + 1) // 2 + i


def squared(F: Places, m: int, i: int, j: int) -> list[int]:
    """The states by way of which element (i, j) of F F may be other than zero."""
    return [k for k in range(m) if (i, k) in F and (k, j) in F]


def worthwhile(n: int, m: int, down: int, row: int, tall: int, Phi: set[tuple[int, int]]) -> bool:
    """Whether Phi P Phi' over the non-zeros takes less than SHARE of the products that blocks take."""
    blocks = down // tall * (down // tall + 1) // 2
    return products(n, m, Phi) < SHARE * (down * n * row + blocks * n * tall * tall)


def products(n: int, m: int, Phi: set[tuple[int, int]]) -> int:
    """Of Phi P, and of the upper triangle of its rows that move times Phi'."""
    return sum(n + i + 1 for i, _ in Phi if i < m)


def sparse_view(n: int, m: int, row: int, F: Places, Qc: Places, order: int) -> dict[str, Any]:
    """Row by row the non-zeros of Phi, as their place, none where they are 1, and their column; what `discretize` is
    printed from; and what noise of states that stay, which meets two states that move, takes from these."""
    Phi = powers(n, F, order)
    found = discretized(n, m, row, F, Qc, order)
    ones = {(k, k) for k in range(m) if (k, k) not in F and not (order == 2 and squared(F, m, k, k))}
    lines = [[(None if (i, k) in ones else i * row + k, k) for k in range(n) if (i, k) in Phi] for i in range(m)]
    crossing = {(i, e["k"]) for i, line in enumerate(found["rows"]) for e in line["entries"] if e["cross"] is not None}
    taken = [
        (packed(i, j), [(i * row + k, packed(j, k)) for k in range(m, n) if (i, k) in crossing and (j, k) in crossing])
        for j in range(m)
        for i in range(j + 1)
    ]
    return found | {
        "Phi": table(tuple((i, k) for i, k in Phi if i < m), m),
        "products": lines,
        "end": 1 + max(k for line in lines for _, k in line),
        "taken": [(place, pairs) for place, pairs in taken if pairs],
    }


def discretized(n: int, m: int, row: int, F: Places, Qc: Places, order: int) -> dict[str, Any]:
    """Rows of Phi and of B U, B being what noise passes through and U the factor of Qc; and the sums of Q."""
    a = {place: p for p, place in enumerate(sorted(F))}
    Phi, first = powers(n, F, order), reach(n, Qc)
    driven = {j for i, j in Qc if i == j} | set(coupled(first))  # columns that noise drives
    steps = [(k, l) for k in coupled(first) for l in range(k - 1, first[k] - 1, -1)]
    rows: list[dict[str, Any]] = []
    at: dict[tuple[int, int], int] = {}
    for i in range(m):
        filled = {k for k in driven if (i, k) in Phi}
        gains = []
        for k, l in steps:
            if l in filled:
                gains.append((k, l, packed(k, l)))
                filled.add(k)
        at |= {(i, k): len(at) + number for number, k in enumerate(sorted(filled))}
        entries = [
            {
                "k": k, "diagonal": i == k, "Phi": i * row + k if (i, k) in Phi else None, "a": a.get((i, k)),
                "twice": [(a[i, l], a[l, k]) for l in (squared(F, m, i, k) if order == 2 else ())],
                "B": at.get((i, k)), "cross": packed(i, k) if k >= m and k in filled else None,
            }
            for k in range(n) if (i, k) in Phi or k in filled
        ]  # fmt: skip
        rows.append({"entries": entries, "gains": gains, "filled": {k for k, _, _ in gains}})
    met = [sorted(k for row, k in at if row == i) for i in range(m)]
    sums: list[dict[str, Any]] = [
        {
            "own": [at[j, k] for k in met[j]],
            "of": [(packed(i, j), shared) for i in range(j + 1) if (shared := pairs(at, met[i], i, j))],
        }
        for j in range(m)
    ]
    of_sums = 2 * sum(len(shared) for column in sums for _, shared in column["of"])
    return {
        "rows": rows, "count": len(at), "sums": sums,
        "cost": cost(rows, len(at), F, Qc, first, m, order) + of_sums,
        "weighed": [(k, packed(k, k)) for k in sorted({k for _, k in at} | set(coupled(first)))],
        "rewritten": noise_rewritten(m, first, order),
    }  # fmt: skip


def pairs(at: dict[tuple[int, int], int], columns: list[int], i: int, j: int) -> list[tuple[int, int]]:
    """Where two rows have both a number in the same column."""
    return [(at[i, k], at[j, k]) for k in columns if (j, k) in at]


def cost(rows: list[dict[str, Any]], count: int, F: Places, Qc: Places, first: list[int], m: int, order: int) -> int:
    """Additions, multiplications and divisions of the rows, and of the noise, where no pivot of Qc vanishes."""
    upper = [(i, j) for i, j in Qc if i <= j]
    inner = sum(i < m for i, _ in upper)
    found = len(F) + (order == 2) + len(upper) + count
    found += 3 * inner if order == 2 else 0
    found += len(upper) - inner if noise_rewritten(m, first, order) else 0
    for k in coupled(first):
        found += 3 + sum(3 + 2 * (i - first[k]) for i in range(first[k], k))
    for line in rows:
        found += 2 * len(line["gains"])
        for e in line["entries"]:
            a, t = e["a"] is not None, bool(e["twice"])
            one = e["diagonal"] and (a or t)
            series = (a or t) * (order == 2)
            found += 2 * len(e["twice"])
            found += (series + t + one) * (e["Phi"] is not None)
            found += (series + a + t + one) * (e["B"] is not None)
    return found


def noise_rewritten(m: int, first: list[int], order: int) -> bool:
    """Whether noise of states that stay is to be written once more: where it was a part of Qc dt alone, or a factor."""
    return order == 2 or any(k >= m for k in coupled(first))
