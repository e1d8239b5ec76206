"""The filter that every tool is given: azimuth-hold, fifteen states, as formulas over any kind of number.

A sparse matrix is a list of rows {column: value}; a symmetric one is packed, column after column of its upper triangle.
What a tool reads is `v`, the numbers of the model's structs one after another, then z, R and x; P and Q are packed.
"""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, reduce
from operator import add
from typing import Any

import numpy as np
import sympy as sp
from sympy.printing.str import StrPrinter

from boresight.derive.expressions import numeric
from boresight.derive.model import Model
from boresight.derive.models.azimuth_hold import azimuth_hold

KINDS = ("F", "predict 1", "predict 2", "updates, plain", "updates, Joseph", "propagate")
WRITES_X = ("updates, plain", "updates, Joseph", "propagate")
Rows = list[dict[int, Any]]
Statements = tuple[tuple[str, str], ...]
FUNCTIONS = ("sin", "cos", "tan", "sqrt")


class Plain(StrPrinter):
    """What C and Python both read: + - * /, sin, cos, tan, sqrt; powers of whole and half numbers written out."""

    def _print_Pow(self, expr: Any, rational: bool = False) -> str:
        base, power = self.parenthesize(expr.base, 1000), expr.exp
        if power == -1:
            return f"(1.0/{base})"
        if not (2 * power).is_Integer:
            raise ValueError(f"{expr} has another power than a whole or half number")
        halves = abs(int(2 * power))
        text = "*".join([base] * (halves // 2) + [f"sqrt({self._print(expr.base)})"] * (halves % 2))
        return f"(1.0/({text}))" if power < 0 else f"({text})"

    def _print_Mul(self, expr: Any) -> str:
        negative, factors = expr.args[0] == -1, expr.args[expr.args[0] == -1 :]
        text = "*".join(self.parenthesize(factor, 50) for factor in factors)
        return f"(-({text}))" if negative else text

    def _print_Rational(self, expr: Any) -> str:
        return repr(float(expr))

    _print_Integer = _print_Float = _print_NegativeOne = _print_One = _print_Half = _print_Rational


@dataclass(frozen=True)
class Problem:
    """inputs: name and size of the fields at the head of v; names: their scalars.  entries: F and Qc, (i, j) ->
    expression.  statements: (name, text) of their common terms, then of `entries`, in the subset of `Plain`.
    rows: h, {state: value}, of each scalar measurement.
    """

    n: int
    inputs: tuple[tuple[str, int], ...]
    names: tuple[str, ...]
    entries: tuple[dict[tuple[int, int], Any], dict[tuple[int, int], Any]]
    statements: Statements
    rows: tuple[dict[int, float], ...]

    @property
    def upper(self) -> list[tuple[int, int]]:
        return [(i, j) for j in range(self.n) for i in range(j + 1)]

    @property
    def width(self) -> int:
        """Numbers of v."""
        return len(self.names) + 2 * len(self.rows) + self.n

    def writes(self, kind: str) -> int:
        """Numbers that a kind writes: F dense, or P and, of some, x."""
        return self.n**2 if kind == "F" else len(self.upper) + self.n * (kind in WRITES_X)


def nonzeros(M: Any) -> dict[tuple[int, int], Any]:
    return {(i, j): M[i, j] for i in range(M.rows) for j in range(M.cols) if M[i, j] != 0}


def problem(model: Model | None = None) -> Problem:
    """Of a model in which every scalar measurement but those of `zaru` is taken, one after another."""
    model = model or azimuth_hold()
    F = numeric(model.F)
    Qc = numeric(model.G) * sp.diag(*(w**2 for w in model.noise)) * numeric(model.G).T
    entries = nonzeros(F), nonzeros(Qc)
    terms, values = sp.cse([value for part in entries for value in part.values()], sp.numbered_symbols("t"))
    labels = [f"{name}_{i}_{j}" for name, part in zip(("F", "Qc"), entries, strict=True) for i, j in part]
    text = Plain().doprint
    statements = [(str(name), text(value)) for name, value in terms]
    statements += [(label, text(value)) for label, value in zip(labels, values, strict=True)]
    taken = [numeric(m.H) for m in model.measurements if m.H is not None and m.name != "zaru"]
    H = [whole[i, :] for whole in taken for i in range(whole.rows)]
    rows = tuple({k: float(h[k]) for k in range(model.n) if h[k] != 0} for h in H)
    inputs = tuple((item.name, item.size) for item in model.inputs)
    names = tuple(str(symbol) for item in model.inputs for symbol in item.symbols)
    return Problem(model.n, inputs, names, entries, tuple(statements), rows)


def statements(all_of_them: Statements, noise: bool) -> Statements:
    """Those that F needs, and Qc if there is noise."""
    wanted = {name for name, _ in all_of_them if name.startswith("F_") or (noise and name.startswith("Qc_"))}
    kept = []
    for name, text in reversed(all_of_them):
        if name in wanted:
            kept.append((name, text))
            wanted |= set(re.findall(r"[A-Za-z_]\w*", text))
    return tuple(kept[::-1])


@cache
def code(all_of_them: Statements, noise: bool) -> Any:
    lines = [f"{name} = {text}" for name, text in statements(all_of_them, noise)]
    return compile("\n".join(lines), "model", "exec")


def matrices(p: Problem, v: Any, functions: dict[str, Any], noise: bool = True) -> tuple[Rows, Rows]:
    """F and, if there is noise, Qc of the numbers v.  functions: sin, cos, tan and sqrt of these."""
    scope = dict(functions) | {name: v[k] for k, name in enumerate(p.names)}
    exec(code(p.statements, noise), {}, scope)
    made: tuple[Rows, Rows] = ([{} for _ in range(p.n)], [{} for _ in range(p.n)])
    for M, name, part in zip(made, ("F", "Qc")[: 1 + noise], p.entries, strict=False):
        for i, j in part:
            M[i][j] = scope[f"{name}_{i}_{j}"]
    return made


def times(a: Any, b: Any) -> Any:
    """a b, where a whole 1 costs nothing."""
    return b if isinstance(a, int) and a == 1 else a if isinstance(b, int) and b == 1 else a * b


def total(terms: Any) -> Any:
    return reduce(add, terms)


def product(A: Rows, X: Rows) -> Rows:
    """A X."""
    out: Rows = []
    for row in A:
        columns = sorted({j for k in row for j in X[k]})
        out.append({j: total(times(a, X[k][j]) for k, a in row.items() if j in X[k]) for j in columns})
    return out


def plus(*parts: Rows) -> Rows:
    return [
        {j: total(part[i][j] for part in parts if j in part[i]) for j in sorted({j for part in parts for j in part[i]})}
        for i in range(len(parts[0]))
    ]


def scaled(M: Rows, factor: Any) -> Rows:
    return [{j: value * factor for j, value in row.items()} for row in M]


def full(packed: Any, n: int) -> Rows:
    return [{j: packed[max(i, j) * (max(i, j) + 1) // 2 + min(i, j)] for j in range(n)} for i in range(n)]


def outputs(
    p: Problem,
    kind: str,
    given: Sequence[Any],
    functions: dict[str, Any],
    named: Callable[[Rows], Rows] = lambda rows: rows,
) -> list[Any]:
    """What a kind writes.  given: v, P and Q.  named: is given each matrix and may put names in its place."""
    v, P, Q = given
    x = [v[len(v) - p.n + i] for i in range(p.n)]
    if kind.startswith("updates"):
        return updates(p, v, P, x, kind.endswith("Joseph"), named)
    F, Qc = matrices(p, v, functions, kind == "propagate")
    if kind == "F":
        return [F[i].get(j, 0.0) for i in range(p.n) for j in range(p.n)]
    dt = v[p.names.index("dt")]
    A = named(scaled(named(F), dt))
    identity: Rows = [{i: 1} for i in range(p.n)]
    squared = [] if kind == "predict 1" else [named(product(scaled(A, 0.5), A))]
    Phi = named(plus(identity, A, *squared))
    if kind == "propagate":
        # as Boresight has it at second order, a sum of squares: W / 4 + 3/4 B W B', B = I + 2/3 A + 2/9 A^2, W = Qc dt
        W = named(scaled(named(Qc), 0.25 * dt))
        B = named(plus(identity, scaled(A, 2 / 3), scaled(squared[0], 4 / 9)))
        BW = named(product(B, scaled(W, 3.0)))
        terms = {(i, j): [times(BW[i][k], b) for k, b in B[j].items() if k in BW[i]] for i, j in p.upper}
        Q = [total([*terms[i, j], *([W[i][j]] if j in W[i] else [])] or [0.0]) for i, j in p.upper]
        x = [total(times(a, x[k]) for k, a in row.items()) for row in Phi]
    Y = named(product(Phi, full(P, p.n)))
    out = [total(times(Y[i][k], a) for k, a in Phi[j].items()) + q for (i, j), q in zip(p.upper, Q, strict=True)]
    return out + x if kind == "propagate" else out


def updates(p: Problem, v: Any, P: Any, x: list[Any], joseph: bool, named: Callable[[Rows], Rows]) -> list[Any]:
    """Scalar after scalar, P - K g', or that as A in A - (A h - R K) K', which is Joseph's form in two products."""
    P, first = list(P), len(p.names)
    for row, h in enumerate(p.rows):
        z, R = v[first + row], v[first + len(p.rows) + row]
        M = full(P, p.n)
        signed = {k: 1 if value == 1.0 else value for k, value in h.items()}
        (g,) = named([{i: total(times(value, M[i][k]) for k, value in signed.items()) for i in range(p.n)}])
        S = total(times(value, g[k]) for k, value in signed.items()) + R
        nu = z - total(times(value, x[k]) for k, value in signed.items())
        (scalars,) = named([{0: 1.0 / S, 1: nu}])
        (K,) = named([{i: g[i] * scalars[0] for i in range(p.n)}])
        c: dict[int, Any] = {}
        if joseph:
            for i in range(p.n):
                c[i] = total(times(value, M[i][k] - K[i] * g[k]) for k, value in signed.items()) - R * K[i]
            (c,) = named([c])
        new = {}
        for at, (i, j) in enumerate(p.upper):
            new[at] = P[at] - K[i] * g[j]
            if joseph:
                new[at] = new[at] - c[i] * K[j]
        (new, stepped) = named([new, {i: x[i] + K[i] * scalars[1] for i in range(p.n)}])
        P, x = [new[at] for at in range(len(P))], [stepped[i] for i in range(p.n)]
    return P + x


class Counted:
    """A number that counts what is done with it."""

    done: dict[str, int]

    def __init__(self, done: dict[str, int]):
        self.done = done

    def _one(self, name: str) -> "Counted":
        self.done[name] = self.done.get(name, 0) + 1
        return self

    def __add__(self, other: Any) -> "Counted":
        return self._one("add")

    def __mul__(self, other: Any) -> "Counted":
        return self._one("multiply")

    def __rtruediv__(self, other: Any) -> "Counted":
        return self._one("divide")

    def __neg__(self) -> "Counted":
        return self

    __radd__ = __sub__ = __rsub__ = __add__
    __rmul__ = __mul__
    __truediv__ = __rtruediv__


def operations(p: Problem, kind: str) -> dict[str, int]:
    """Additions, multiplications, divisions and functions of a kind, as the formulas above have them."""
    done: dict[str, int] = {}
    one = Counted(done)
    packed = [one] * len(p.upper)
    outputs(p, kind, ([one] * p.width, packed, packed), dict.fromkeys(FUNCTIONS, lambda a: a._one("function")))
    return done


def numbers(p: Problem, seed: int = 0) -> dict[str, np.ndarray]:
    """v, P and Q packed at a place of the Earth, of a covariance with every correlation in units of all sizes.

    The step is long and the noise large, so that every term of Phi and Q shows in the result.
    """
    rng = np.random.default_rng(seed)
    q = np.array([0.9, 0.1, -0.2, 0.3])
    given = {
        "lon_lat_height": [2.2, 0.63, 100.0], "v_n": [3.0, -2.0, 0.5],
        "q_b2n_wxyz": q / np.linalg.norm(q), "q_ref_wxyz": q / np.linalg.norm(q),
        "f_b": [0.5, -0.3, 9.8], "f_n": [0.5, -0.3, 9.8], "omega_ib_b": [0.01, -0.02, 0.03], "dt": [1.0],
        "gyro_noise": [1e-3] * 3, "accel_noise": [0.5] * 3, "gyro_bias_noise": [1e-5] * 3,
        "accel_bias_noise": [1e-2] * 3,
    }  # fmt: skip
    sigma = np.array([1e-6] * 2 + [10.0] + [0.1] * 3 + [1e-3] * 3 + [1e-5] * 3 + [1e-3] * 3 + [1e-3] * p.n)[: p.n]
    at = tuple(np.array(p.upper).T)

    def covariance(size: float) -> Any:
        root = rng.standard_normal((p.n, 2 * p.n))
        return (np.outer(sigma, sigma) * size * (root @ root.T) / (2 * p.n))[at]

    v = np.zeros(p.width)
    place = 0
    for name, size in p.inputs:
        v[place : place + size] = given.get(name, 0.0)
        place += size
    m = len(p.rows)
    # the measurements are what the model's own functions of z give at v
    v[len(p.names) :] = np.concatenate([[3.0, -2.0, 0.5, 0.0][:m], [1e-2, 1e-2, 1e-2, 1e-6][:m], 0.1 * sigma])
    return {"v": v, "P": covariance(1.0), "Q": covariance(1e-4)}


def reference(p: Problem, kind: str, given: Mapping[str, np.ndarray]) -> np.ndarray:
    """The same by dense matrices in NumPy, in the textbook's form: what every tool is held against."""
    v, n, m = given["v"], p.n, len(p.rows)
    functions = {name: getattr(np, name) for name in FUNCTIONS}
    F, Qc = (np.array([[row.get(j, 0.0) for j in range(n)] for row in M]) for M in matrices(p, v, functions))
    at = tuple(np.array(p.upper).T)
    P, Q = np.zeros((n, n)), np.zeros((n, n))
    for M, packed in ((P, given["P"]), (Q, given["Q"])):
        M[at] = M[at[::-1]] = packed
    x = v[-n:].copy()
    if kind == "F":
        return F.ravel()
    if kind.startswith("updates"):
        for h, z, R in zip(p.rows, v[len(p.names) :], v[len(p.names) + m :], strict=False):
            H = np.array([h.get(k, 0.0) for k in range(n)])
            K = P @ H / (H @ P @ H + R)
            x = x + K * (z - H @ x)
            left = np.eye(n) - np.outer(K, H)
            P = left @ P @ left.T + R * np.outer(K, K)
        return np.concatenate([P[at], x])
    A = F * v[p.names.index("dt")]
    Phi = np.eye(n) + A + (0 if kind == "predict 1" else A @ A / 2)
    if kind == "propagate":
        W, B = Qc * v[p.names.index("dt")], np.eye(n) + A * 2 / 3 + A @ A * 2 / 9
        Q = W / 4 + 3 / 4 * B @ W @ B.T
    P = Phi @ P @ Phi.T + Q
    return np.concatenate([P[at], Phi @ x]) if kind == "propagate" else P[at]


def apart(p: Problem, kind: str, got: Any, wanted: np.ndarray) -> float:
    """The largest difference, of covariances in parts of the two sigmas, of F and x in parts of the largest entry of
    the row or block."""
    got = np.asarray(got, dtype=float)
    if kind == "F":
        M = np.abs(wanted.reshape(p.n, p.n)).max(axis=1, keepdims=True)
        return float((np.abs(got - wanted).reshape(p.n, p.n) / np.where(M > 0, M, 1.0)).max())
    i, j = np.array(p.upper).T
    count = len(i)
    sigma = np.sqrt(wanted[:count][i == j])
    off = np.abs(got - wanted)
    of_x = off[count:] / sigma[: len(off) - count]
    return float(max((off[:count] / (sigma[i] * sigma[j])).max(), of_x.max(initial=0.0)))
