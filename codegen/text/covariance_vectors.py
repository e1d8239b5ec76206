"""Golden vectors of the covariance functions: rational arithmetic on numbers of a few bits.

The self-test in C draws the same numbers, by the same generator; here they are integers with a common power of two, and
`test_covariance.c.j2` must draw in this order.  A state is scaled by its own power of two, which is exact, so it is put
on at the end.

Tolerances, u being the unit roundoff: with s_i = sum_k |Phi_ik| sqrt(P_kk) every term of (Phi P Phi')_ij is bounded by
s_i s_j in sum, because |P_kl|^2 <= P_kk P_ll, and likewise for Q with the variances of Qc; a sum of n products rounds n
times.  In the factors, sum_k |U_ik| d_k |U_jk| <= sqrt(P_ii P_jj) by Cauchy-Schwarz, so that each of the n columns of a
factorization or an update adds n roundings of the same size, and an orthogonalization, which sums over the columns of
Phi U and of the factor of Q that moves, as many as these are; a pivot that is rounding alone,
but above the last that counts, may add n^2 of them.  In an update, rounding of g = P h is relative to
sum_k |h_k| sqrt(P_kk) sqrt(P_ii) and that of S to R + (sum_k |h_k| sqrt(P_kk))^2, whose ratio to S multiplies all.
"""

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import factorial, ldexp, sqrt
from typing import Any

import numpy as np

from boresight.codegen.text.names import rows_of, three_digits
from boresight.derive.model import SPREAD

VECTORS = 4  # one of each kind of P: four kill every mutant of the loops that eight kill
DT_POWER = -4
Places = tuple[tuple[int, int], ...]


def generator(seed: int) -> Iterator[int]:
    """0 to 255, as `draw` in C."""
    while True:
        seed = (seed * 1664525 + 1013904223) % 2**32
        yield seed >> 24


@dataclass(frozen=True)
class Case:
    """Integers: A, B and P in 2^-8, x in 2^-4, h in 2^-6, R in 2^-24, z in 2^-3; scale are powers of two.

    A and B are F and Qc of an error state, Phi and Q of a total state.
    """

    scale: list[int]
    P: Any  # (n, n) of int
    A: Any
    B: Any
    x: Any
    h: Any
    R: int
    z: int


def draw_case(k: int, n: int, A_places: Places, B_places: Places) -> Case:
    kind, numbers = k % 8, generator(k + 1)

    def draw() -> int:
        return next(numbers)

    def table() -> Any:
        return np.zeros((n, n), dtype=object)

    for _ in range(4):
        draw()
    scale = [(draw() % 8 - 4) * (4 if k % 4 == 3 else 1) for _ in range(n)]
    root = table()
    for i in range(n):
        for j in range(n):
            value = draw() // 8 - 16
            empty = kind in (0, 6) or (kind == 1 and i != j) or (kind == 2 and j > 1)
            root[i, j] = 0 if empty else value
    A, B = table(), table()
    for place in A_places:
        value = draw()
        A[place] = 0 if kind == 4 else value // 2 + 64 if value % 2 else -(value // 2 + 64)
    for i, j in B_places:
        if i < j:
            B[i, j] = B[j, i] = draw() - 128
    for i, j in B_places:
        if i == j:
            B[i, i] = sum(abs(B[i, other]) for other in range(n) if other != i) + draw() + 1
    if kind in (5, 6):
        B = table()
    x, h = np.zeros(n, dtype=object), np.zeros(n, dtype=object)
    for i in range(n):
        value = draw() - 128
        chosen = draw() % 4 == 0 or k % 3 == 0 or i == k % n
        x[i] = draw() - 128
        h[i] = value if chosen else 0
    R = (draw() + 1) * (1 if k % 5 == 4 else 2**16)
    return Case(scale, root @ root.T, A, B, x, h, R, draw() - 128)


def rounded(value: int | Fraction, power: int = 0) -> float:
    """value 2^power, rounded once."""
    exact = Fraction(value)
    return float(exact * 2**power if power >= 0 else exact / 2**-power)


def upper(size: int) -> list[tuple[int, int]]:
    return [(i, j) for j in range(size) for i in range(j + 1)]


def total(terms: Iterable[float]) -> float:
    """From the left, as written: what `sum` gives depends on Python's version, what NumPy gives on the processor."""
    result = 0.0
    for term in terms:
        result += term
    return result


@dataclass(frozen=True)
class Step:
    """Integers: Phi, and what bounds it, in 1 / per; Q in 1 / parts; and the variances that bound Q's elements."""

    Phi: Any
    size: Any
    per: int
    Q: Any
    parts: int
    variance: list[float]


def step(case: Case, order: int | None, moving: int) -> Step:
    """Phi and Q of a case: where `order` is None Phi's rows that move and Q as drawn, otherwise from F, Qc and dt to
    that power of F dt."""
    n = len(case.scale)
    one = np.array([[int(i == j) for j in range(n)] for i in range(n)], dtype=object)
    if order is None:
        Phi = np.vstack([case.A[:moving], 2**8 * one[moving:]])
        return Step(Phi, abs(Phi), 2**8, case.B, 2**8, [v / 2**8 for v in np.diag(case.B)])
    a = 8 - DT_POWER  # F dt and Qc dt in 2^-a
    per = factorial(order) * 2 ** (a * order)

    def series(A: Any) -> Any:
        """1 + A + A A / 2 + ..., in 1 / per."""
        total, power = 0 * one, one
        for i in range(order + 1):
            total, power = total + (per // (factorial(i) * 2 ** (a * i))) * power, power @ A
        return total

    # Q = weight B S B' + ..., with B in 1 / (72 2^(a order)): all factors are in 1 / 72, and the weights in 1 / 12
    Q, parts = 0 * one, 12 * 72**2 * 2 ** (a * (2 * order + 1))
    for weight, factors in SPREAD[order]:
        B, power = 0 * one, one
        for i, factor in enumerate(factors):
            B, power = B + int(72 * factor) * 2 ** (a * (order - i)) * power, power @ case.A
        Q = Q + int(12 * weight) * B @ case.B @ B.T
    return Step(series(case.A), series(abs(case.A)), per, Q, parts, [v / 2**a for v in np.diag(case.B)])


def predicted(case: Case, order: int | None, moving: int) -> tuple[list[float], list[float], list[float], list[float]]:
    """Phi P Phi' + Q packed, Phi x, sizes of rounding errors in both."""
    n = len(case.scale)
    s = step(case, order, moving)
    PhiPPhi = s.Phi @ case.P @ s.Phi.T
    first = [Fraction(PhiPPhi[at], s.per**2 * 2**8) + Fraction(s.Q[at], s.parts) for at in upper(n)]
    P = [rounded(value, case.scale[i] + case.scale[j]) for (i, j), value in zip(upper(n), first, strict=True)]
    Phi_x, size_x = s.Phi @ case.x, s.size @ abs(case.x)
    x = [rounded(Fraction(v, s.per * 2**4), scale) for v, scale in zip(Phi_x, case.scale, strict=True)]
    sigma = [sqrt(v / 2**8) for v in np.diag(case.P)]
    noise = [sqrt(v) for v in s.variance]
    size = []  # s_i s_j + q_i q_j <= the product of these
    for k, row in enumerate(s.size):
        along = total(v / s.per * w for v, w in zip(row, sigma, strict=True))
        spread = noise[k] if order is None else total(v / s.per * w for v, w in zip(row, noise, strict=True))
        size.append(sqrt(along * along + spread * spread))
    size, size_x = (
        [ldexp(v, scale) for v, scale in zip(values, case.scale, strict=True)]
        for values in (size, [v / (s.per * 2**4) for v in size_x])
    )
    return P, x, size, size_x


def updated(case: Case) -> tuple[list[float], list[float], list[float], list[float], list[float]]:
    """P after one row, x, the sizes of rounding errors in both, and nu, S with theirs."""
    n = len(case.scale)
    P = [[Fraction(value, 2**8) for value in row] for row in case.P]
    h, x = [Fraction(v, 2**6) for v in case.h], [Fraction(v, 2**4) for v in case.x]
    R, z = Fraction(case.R, 2**24), Fraction(case.z, 2**3)
    seen = [i for i in range(n) if h[i]]
    g = [sum((P[i][k] * h[k] for k in seen), Fraction(0)) for i in range(n)]
    S = R + sum((h[i] * g[i] for i in seen), Fraction(0))
    nu = z - sum((h[i] * x[i] for i in seen), Fraction(0))
    after = [rounded(P[i][j] - g[i] * g[j] / S, case.scale[i] + case.scale[j]) for i, j in upper(n)]
    after_x = [rounded(x[i] + g[i] * nu / S, case.scale[i]) for i in range(n)]
    sigma = [sqrt(P[i][i]) for i in range(n)]
    spread = total(float(abs(h[i])) * sigma[i] for i in seen)
    size_nu = float(abs(z) + sum((abs(h[i] * x[i]) for i in seen), Fraction(0)))
    size_S = float(R) + spread**2
    ratio = size_S / float(S)
    size = [ldexp(sigma[i] * sqrt(ratio), case.scale[i]) for i in range(n)]
    size_x = [
        ldexp(float(abs(x[i])) + ratio * sigma[i] / sqrt(S) * size_nu, case.scale[i]) for i in range(n)
    ]  # |K_i| <= sigma_i / sqrt(S)
    return after, after_x, size, size_x, [float(nu), float(S), size_nu, size_S]


def paths(n: int, F: Places) -> Counter[tuple[int, int]]:
    """How many products of one, two or three elements of F each element of 1 + F + F F / 2 + F F F / 6 sums."""
    total, power = Counter({(i, i): 1 for i in range(n)}), Counter({(i, i): 1 for i in range(n)})
    for _ in range(3):
        longer: Counter[tuple[int, int]] = Counter()
        for (i, k), count in power.items():
            longer.update({(i, j): count for row, j in F if row == k})
        power = longer
        total += power
    return total


def vectors_view(n: int, A: Places, B: Places, order: int | None, moving: int) -> dict[str, Any]:
    """The tables of `test_covariance.c.j2`.

    A and B: places of F and Qc, or of Phi and Q where `order` is None; moving: how many rows of Phi are not those of a
    unit matrix."""
    cases = [draw_case(k, n, A, B) for k in range(VECTORS)]
    ahead, taken = [predicted(case, order, moving) for case in cases], [updated(case) for case in cases]

    terms = n if order != 3 else max(paths(n, A).values()) + 2  # that are summed in an element of Phi
    return {
        "count": VECTORS,
        "dt_power": DT_POWER,
        # Phi x: n products and sums, on those of Phi
        "of_state": n + terms + 8,
        # twice Phi, twice a sum of n; three terms of an update with n roundings in each of g, g and S
        "of_joseph": 10 * n + 30,
        "of_ud": 5 * n * (n + moving) + 10 * n + 30,
        "predicted_P": rows_of([row[0] for row in ahead]),
        "predicted_x": rows_of([row[1] for row in ahead]),
        "predicted_size": rows_of([row[2] for row in ahead], three_digits),
        "predicted_size_x": rows_of([row[3] for row in ahead], three_digits),
        "updated_P": rows_of([row[0] for row in taken]),
        "updated_x": rows_of([row[1] for row in taken]),
        "updated_size": rows_of([row[2] for row in taken], three_digits),
        "updated_size_x": rows_of([row[3] for row in taken], three_digits),
        "updated_row": rows_of([row[4] for row in taken]),
        "A_rows": ", ".join(str(row) for row, _ in A),
        "B_rows": ", ".join(str(row) for row, _ in B),
        "diagonal": all((i, i) in A for i in range(n)),
    }
