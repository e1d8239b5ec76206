"""One step of a Kalman filter with random covariances, symmetric and positive, from the theory of least squares.

The update is that of weighted least squares, by information; the covariance for any gain is that of the error itself.
Neither uses a formula for a gain.
"""

import random
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from boresight.derive.ledger.numbers import Matrix, exact, eye, sqrt, zeros
from boresight.derive.papers.scenarios.scenario import Name, Scenario

STATES, ROWS = 4, 2


@dataclass(frozen=True)
class Parts:
    """draw: from which all matrices are made."""

    draw: Any = 1.0


NAMES = {
    "x": Name("1", "estimate before the update (4)"),
    "P": Name("1", "covariance before the update (4 x 4)"),
    "H": Name("1", "measurement matrix (2 x 4)"),
    "R": Name("1", "covariance of the measurement noise (2 x 2)"),
    "z": Name("1", "measurement (2)"),
    "S": Name("1", "covariance of the innovation (2 x 2)"),
    "K": Name("1", "the gain of the least variance (4 x 2)"),
    "x_plus": Name("1", "estimate after the update (4)"),
    "P_plus": Name("1", "covariance after the update (4 x 4)"),
    "K_any": Name("1", "any other gain (4 x 2)"),
    "P_any": Name("1", "covariance after an update with that gain (4 x 4)"),
    "Phi": Name("1", "transition matrix (4 x 4)"),
    "Q": Name("1", "covariance of the process noise (4 x 4)"),
    "x_next": Name("1", "prediction from x (4)"),
    "P_next": Name("1", "covariance of the prediction (4 x 4)"),
    "I": Name("1", "identity (4 x 4)"),
    "I_z": Name("1", "identity (2 x 2)"),
    "L": Name("1", "lower triangular root: L L^T = P (4 x 4)"),
    "L_plus": Name("1", "lower triangular root of P_plus (4 x 4)"),
    "L_R": Name("1", "lower triangular root of R (2 x 2)"),
    "U": Name("1", "unit upper triangular: U D U^T = P (4 x 4)"),
    "D": Name("1", "diagonal: U D U^T = P (4 x 4)"),
    "U_plus": Name("1", "unit upper triangular: U D U^T = P_plus (4 x 4)"),
    "D_plus": Name("1", "diagonal: U D U^T = P_plus (4 x 4)"),
    "h": Name("1", "row of a single measurement (1 x 4)"),
    "r": Name("1", "variance of the noise of a single measurement"),
    "z_1": Name("1", "the single measurement"),
    "s_1": Name("1", "variance of the innovation of the single measurement"),
    "k_1": Name("1", "gain of the least variance for the single measurement (4)"),
    "x_1": Name("1", "estimate after the single measurement (4)"),
    "P_1": Name("1", "covariance after the single measurement (4 x 4)"),
}


def lower_root(P: Matrix) -> Matrix:
    """L with L L^T = P, lower triangular, by columns."""
    n, L = P.rows, zeros(P.rows)
    for j in range(n):
        L[j, j] = sqrt(P[j, j] - sum((L[j, k] * L[j, k] for k in range(j)), exact(0)))
        for i in range(j + 1, n):
            L[i, j] = (P[i, j] - sum((L[i, k] * L[j, k] for k in range(j)), exact(0))) / L[j, j]
    return L


def unit_upper(P: Matrix) -> tuple[Matrix, Matrix]:
    """U, unit upper triangular, and D, diagonal, with U D U^T = P: the lower root of P turned end for end."""
    n = P.rows
    turned = Matrix([[P[n - 1 - i, n - 1 - j] for j in range(n)] for i in range(n)])
    L = lower_root(turned)
    root = Matrix([[L[n - 1 - i, n - 1 - j] for j in range(n)] for i in range(n)])
    U, D = zeros(n), zeros(n)
    for j in range(n):
        D[j, j] = root[j, j] * root[j, j]
        for i in range(j + 1):
            U[i, j] = root[i, j] / root[j, j]
    return U, D


def updated(x: Matrix, P: Matrix, H: Matrix, R: Matrix, z: Matrix) -> list[Matrix]:
    """Gain, estimate and covariance of the weighted least squares of x and z."""
    weight = H.T * R.inv()
    after = (P.inv() + weight * H).inv()
    return [after * weight, after * (P.inv() * x + weight * z), after]


def at(base: Parts, t: Any) -> tuple[tuple[str, Callable], ...]:
    generator = random.Random(str(base.draw))

    def free(rows: int, columns: int) -> Matrix:
        return Matrix([[exact(generator.uniform(-1, 1)) for _ in range(columns)] for _ in range(rows)])

    def positive(size: int) -> Matrix:
        root = free(size, size)
        return root * root.T + eye(size)

    given = {
        "x": free(STATES, 1),
        "P": positive(STATES),
        "H": free(ROWS, STATES),
        "R": positive(ROWS),
        "z": free(ROWS, 1),
        "K_any": free(STATES, ROWS),
        "Phi": free(STATES, STATES),
        "Q": positive(STATES),
        "I": eye(STATES),
        "I_z": eye(ROWS),
        "h": free(1, STATES),
        "r": positive(1)[0],
        "z_1": free(1, 1)[0],
    }

    def any_gain(letters: Any) -> list[Matrix]:
        left = eye(STATES) - given["K_any"] * given["H"]  # what is left of the error, and what the noise adds
        return [left * given["P"] * left.T + given["K_any"] * given["R"] * given["K_any"].T]

    def single(letters: Any) -> list[Any]:
        return updated(given["x"], given["P"], given["h"], Matrix([given["r"]]), Matrix([given["z_1"]]))

    return (
        *((name, lambda letters, value=value: [value]) for name, value in given.items()),
        ("S", lambda letters: [given["H"] * given["P"] * given["H"].T + given["R"]]),
        ("K|x_plus|P_plus", lambda letters: updated(*(given[name] for name in ("x", "P", "H", "R", "z")))),
        ("P_any", any_gain),
        ("x_next", lambda letters: [given["Phi"] * given["x"]]),
        ("P_next", lambda letters: [given["Phi"] * given["P"] * given["Phi"].T + given["Q"]]),
        ("L", lambda letters: [lower_root(given["P"])]),
        ("L_plus", lambda letters: [lower_root(letters["P_plus"])]),
        ("L_R", lambda letters: [lower_root(given["R"])]),
        ("U|D", lambda letters: list(unit_upper(given["P"]))),
        ("U_plus|D_plus", lambda letters: list(unit_upper(letters["P_plus"]))),
        ("s_1", lambda letters: [(given["h"] * given["P"] * given["h"].T)[0] + given["r"]]),
        ("k_1|x_1|P_1", single),
    )


KALMAN = Scenario(
    name="kalman",
    sizes=Parts(),
    usual=Parts(),
    at=at,
    names=NAMES,
    units={"draw": "1"},
    moves=False,
    words="random covariances",
)
