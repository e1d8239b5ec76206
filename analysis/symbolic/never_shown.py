"""Directions of the state that a class of motions never shows, as formulas.

With x' = F x and z = H x along a motion, z and its derivatives are N_k x, N_0 = H, N_k+1 = N_k F + dN_k/dt: what is in
the null space of all N_k is in no measurement.  The motions are those of a vehicle that is level and heads north at the
instant of the formula; place and speed vary so slowly that what hangs on these alone, as the Earth's rate, is constant.
"""

import random
import signal
import textwrap
import threading
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import Any

import mpmath
import sympy as sp
from sympy.polys.matrices import DomainMatrix

from boresight.analysis.nominal import MATCHED
from boresight.derive.mechanics.rotation import TINY_SQUARE
from boresight.derive.model import Model
from boresight.derive.named import Named

T = sp.Symbol("t", real=True)  # s, from the instant of the formula on
SPEED, RATE, GRAVITY = sp.symbols("V w g", positive=True)
AHEAD, JERK = sp.symbols("a j", real=True)  # acceleration ahead, and how it changes
SLOW = ("lat_lon_height", "lon_lat_height", "lat", "height", "v_n")
ORDERS, POINTS, LIMIT_S = 6, 3, 20.0
CLASSES, CONSTANT = ("straight", "constant attitude", "steady turn"), "constant inputs"


@dataclass(frozen=True)
class NeverShown:
    """A class of motions, and what it never shows.

    vectors: of each direction (state, formula as text) of what is not zero in it.  unsolved: why there are none, or "".
    """

    motion: str
    vectors: tuple[tuple[tuple[str, str], ...], ...]
    unsolved: str = ""


def never_shown(model: Model, limit_s: float = LIMIT_S, measured: Collection[str] = ()) -> list[NeverShown]:
    """By class of motions, the null vectors of what a model measures.

    model: completed.  limit_s: for each class; what takes longer is unsolved.  measured: names of the measurements;
    without, those of a motion by name, or all.  Each vector is checked at random points in 30 digits, and their number
    against the rank there.
    """
    moved = {v.name for v in model.inputs} & set(along("straight", model, sp.zeros(3, 1)))
    if model.kind == "error-state" and model.F is not None and moved:
        classes: Sequence[str] = CLASSES
    else:
        classes = (CONSTANT,)
    return [solved(model, name, limit_s, measured) for name in classes]


def along(name: str, model: Model, omega_in: sp.Matrix) -> dict[str, sp.Matrix]:
    """Inputs of the models' functions along a motion of this class, by name, as functions of T."""
    up = model.frame.startswith("ENU")
    ahead, right, down = (sp.Matrix(v) for v in (((0, 1, 0), (1, 0, 0), (0, 0, -1)) if up else
                                                 ((1, 0, 0), (0, 1, 0), (0, 0, 1))))  # fmt: skip
    psi = RATE * T if name == "steady turn" else sp.Integer(0)
    c, s = sp.cos(psi), sp.sin(psi)
    sign = -1 if up else 1  # a turn to the right is about down
    C = sp.Matrix([[c, -sign * s, 0], [sign * s, c, 0], [0, 0, 1]])
    q = sp.Matrix([sp.cos(psi / 2), 0, 0, sign * sp.sin(psi / 2)])
    a_b = SPEED * RATE * right if name == "steady turn" else sp.zeros(3, 1)
    if name == "constant attitude":
        a_b = (AHEAD + JERK * T) * ahead
    omega_b = RATE * down if name == "steady turn" else sp.zeros(3, 1)
    f_b = a_b - GRAVITY * down
    level, zero = sp.Matrix([1, 0, 0, 0]), sp.zeros(3, 1)
    euler = sp.Matrix([0, 0, psi])
    v_n = SPEED * C * ahead
    return {
        "v_n": v_n, "v_m_n": v_n, "a_n": C * a_b, "q_b2n_wxyz": q, "q_m2n_wxyz": q, "q_ref_wxyz": q,
        "q_b2m_wxyz": level, "mu": zero, "euler_b": euler, "euler_m": euler, "f_b": f_b, "f_n": C * f_b,
        "omega_in_n": omega_in, "omega_ib_b": omega_b + C.T * omega_in, "omega_nm_n": C * omega_b,
        "lag": sp.zeros(1, 1), "tau": sp.zeros(1, 1), "gyro_bias": zero, "accel_bias": zero,
    }  # fmt: skip


def solved(model: Model, name: str, limit_s: float, measured: Collection[str]) -> NeverShown:
    try:
        with limited(limit_s):
            return NeverShown(name, tuple(vectors(model, name, measured)))
    except TimeoutError:
        return NeverShown(name, (), f"not solved in {limit_s:g} s")
    except ArithmeticError as error:
        return NeverShown(name, (), f"not solved: {error}")


@contextmanager
def limited(seconds: float) -> Iterator[None]:
    """Raise TimeoutError in the block after so long; of the main thread, which alone has signals."""

    def ring(*_: Any) -> None:
        raise TimeoutError

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def vectors(model: Model, name: str, measured: Collection[str]) -> list[tuple[tuple[str, str], ...]]:
    """The null vectors of a class."""
    x = list(model.x)
    H, F = powers(model, name, measured)
    symbols = sorted(set().union(*(part.free_symbols for part in (*H, *F))), key=str)
    points = [point(model, symbols, k) for k in range(POINTS)]
    with mpmath.workdps(30):
        numbers = []
        for here in points:
            values, rates = (
                [mpmath.matrix(part.xreplace(here).evalf(30).tolist()) for part in parts] for parts in (H, F)
            )
            numbers.append(orders(values, rates, mpmath.mpf))
        rows = [row for N in numbers[0] for row in N.tolist()]
        supports = sparse(rows, len(x))
        chosen = [ranked([[row[i] for i in places] for row in rows], len(places) - 1) for places in supports]
    if not supports:
        return []
    count = 1 + max(max(taken, default=0) // H[0].rows for taken in chosen)  # orders that are needed
    H, F = H[:count], F[:count]
    together = sp.Matrix.vstack(*H, *F)
    kernels = {k: sp.Dummy(str(k)) for k in sorted(irrational(together), key=sp.count_ops, reverse=True)}
    back = {dummy: kernel for kernel, dummy in kernels.items()}
    field = DomainMatrix.from_Matrix(together.xreplace(kernels)).to_field()
    ends, made = 0, []
    for part in (*H, *F):
        made.append(field.extract(range(ends, ends + part.rows), range(len(x))))
        ends += part.rows
    N = DomainMatrix.vstack(*orders(made[: len(H)], made[len(H) :], field.domain))
    found = []
    for places, taken in zip(supports, chosen, strict=True):
        null = N.extract(taken, places).nullspace().to_Matrix().tolist()
        if len(null) != 1:
            raise ArithmeticError(f"{len(null)} formulas of {len(places)} states, where a random point has one")
        entries = dict(zip(places, simple(null[0]), strict=True))
        found.append(sp.Matrix([sp.factor(entries.get(i, 0)).xreplace(back) for i in range(len(x))]))
    with mpmath.workdps(30):
        for here, each in zip(points, numbers, strict=True):
            for v in found:
                there = mpmath.matrix(v.xreplace(here).evalf(30).tolist())
                for part in each:
                    if mpmath.norm(part * there, mpmath.inf) > 1e-18 * mpmath.mnorm(part, 1) * mpmath.norm(there, 1):
                        raise ArithmeticError("a formula is not in the null space at a random point")
    return [tuple((str(s), str(e)) for s, e in zip(x, v, strict=True) if e != 0) for v in found]


def orders(H: Sequence[Any], F: Sequence[Any], number: Callable[[int], Any]) -> list[Any]:
    """N_k at T = 0, of the powers of T in H and F.  Of no F they are H themselves."""
    if not F:
        return list(H)
    out, N = [], list(H)
    while N:
        out.append(N[0])
        N = [reduce(add, (N[j - i] * F[i] for i in range(j + 1)), N[j + 1] * number(j + 1)) for j in range(len(N) - 1)]
    return out


def powers(model: Model, name: str, measured: Collection[str]) -> tuple[list[sp.Matrix], list[sp.Matrix]]:
    """What stands with the powers of T in H and in F; of a total state with f, N_k by derivatives along f, and none."""
    x = list(model.x)
    slow = set() if name == CONSTANT else {s for v in model.inputs if v.name in SLOW for s in v.symbols}
    names = set(measured) or {names[0] for names in MATCHED}
    seen = [m for m in model.measurements if m.name in names] or list(model.measurements)
    rates = sp.Matrix(model.f) if model.f is not None else sp.zeros(len(x), 1)
    F = rates.jacobian(x) if model.f is not None else model.F if model.F is not None else model.Phi
    if F is None:
        raise ArithmeticError("its next is that of a step; give f")
    F = sp.Matrix(F)
    flown: dict[Any, Any] = {}
    if name != CONSTANT:
        given = [F, *(sp.Matrix(m.h if m.H is None else m.H) for m in seen)]
        known = along(name, model, level_rate(sp.Matrix([e for part in given for e in part]), slow))
        flown = {s: e for v in model.inputs if v.name in known for s, e in zip(v.symbols, known[v.name], strict=True)}
    zero: dict[Any, Any] = dict.fromkeys(x, sp.Integer(0)) if model.kind == "error-state" else {}

    def here(part: sp.Matrix) -> sp.Matrix:
        return spelled(sp.Matrix(part), slow).xreplace(flown)

    H = sp.Matrix.vstack(*(here(m.h).jacobian(x) if m.H is None else here(m.H) for m in seen))
    F, H, rates = (without_tiny(part.xreplace(zero).doit()) for part in (here(F), H, here(rates)))
    count = min(ORDERS, len(x))
    if model.f is None:
        return taylor(H, count), taylor(F, count)
    N = [H]
    for _ in range(count - 1):
        slopes = (N[-1].diff(s) * rate for s, rate in zip(x, rates, strict=True))
        N.append(N[-1] * F + reduce(add, slopes))
    return N, []


def taylor(part: sp.Matrix, count: int) -> list[sp.Matrix]:
    """What stands with the first powers of T."""
    out = []
    for j in range(count):
        out.append(part.subs(T, 0) / sp.factorial(j))
        part = part.applyfunc(lambda e: e.diff(T))
    return out


def level_rate(matrix: sp.Matrix, slow: set[Any]) -> sp.Matrix:
    """(3,) the rate of the level, in the letters of the model where it has some."""
    names = set(matrix.atoms(Named))
    while names:
        for one in names:
            if one.quantity.name == "omega_in_n":
                return spelled(sp.Matrix(one.quantity.entries), slow)
        names = set().union(*(sp.Matrix([one.value]).atoms(Named) for one in names))
    return sp.Matrix(sp.symbols("omega_in_1:4", real=True))


def spelled(matrix: sp.Matrix, slow: set[Any]) -> sp.Matrix:
    """A matrix without names, but for what hangs on `slow` alone, which becomes a constant of its name."""
    while names := matrix.atoms(Named):
        constant = {
            one: sp.Symbol(one.name, real=True) for one in names if one.free_symbols and one.free_symbols <= slow
        }
        rest = {one: one.value for one in names if one not in constant}
        matrix = matrix.xreplace({**constant, **rest})
    return matrix


def without_tiny(matrix: sp.Matrix) -> sp.Matrix:
    """A matrix in which the sine and cosine of the tiny angle, which stands in the C against 0/0, are their limits."""
    angles = [e for e in matrix.atoms(sp.sin, sp.cos) if e.has(TINY_SQUARE) and not e.free_symbols]
    return matrix.xreplace({e: e.args[0] if isinstance(e, sp.sin) else sp.Integer(1) for e in angles})


def irrational(matrix: sp.Matrix) -> set[Any]:
    """What is neither a symbol nor made of these by the four operations."""
    return {e for e in matrix.atoms(sp.Function, sp.Pow) if isinstance(e, sp.Function) or not e.exp.is_integer}


def simple(v: Sequence[Any]) -> list[Any]:
    """The vector with its first entry that is a number as 1."""
    first = next((e for e in v if e.is_number and e != 0), next(e for e in v if e != 0))
    return [sp.cancel(e / first) for e in v]


def point(model: Model, symbols: Sequence[Any], seed: int) -> dict[Any, Any]:
    """A value of each symbol, within its box where it has one."""
    rng = random.Random(seed)
    box = {s: (low, high) for v in (*model.inputs, *model.states) for s, low, high in
           zip(v.symbols, v.low, v.high, strict=True)}  # fmt: skip
    return {s: sp.Float(rng.uniform(0.3, 0.7), 30) * (sp.Float(box[s][1]) if s in box and abs(box[s][1]) < 1 else 1)
            for s in symbols}  # fmt: skip


def sparse(rows: Sequence[Sequence[Any]], n: int) -> list[list[int]]:
    """Of each direction that rows of n numbers do not show, the places of its states, as few as elimination leaves."""
    some = [rows[i] for i in ranked(rows, n)]
    pivots = ranked(list(zip(*some, strict=True)), len(some)) if some else []
    A = mpmath.matrix([[row[i] for i in pivots] for row in some])
    out = []
    for j in set(range(n)) - set(pivots):
        y = mpmath.lu_solve(A, -mpmath.matrix([row[j] for row in some])) if some else []
        size = max((abs(e) for e in y), default=0)
        out.append(sorted([j, *(i for i, e in zip(pivots, y, strict=True) if abs(e) > 1e-12 * size)]))
    return out


def ranked(rows: Sequence[Sequence[Any]], most: int) -> list[int]:
    """The places of rows that span all of them, at most so many, in 30 digits."""
    kept: list[int] = []
    basis: list[list[Any]] = []
    for at, row in enumerate(rows):
        left, size = list(row), max(map(abs, row))
        for one in basis * 2:  # twice is enough, of an orthonormal basis
            share = mpmath.fdot(left, one)
            left = [a - share * b for a, b in zip(left, one, strict=True)]
        rest = mpmath.sqrt(mpmath.fdot(left, left))
        if size and rest > 1e-15 * size:
            basis.append([e / rest for e in left])
            kept.append(at)
        if len(kept) == most:
            break
    return kept


def lines(found: Sequence[NeverShown]) -> str:
    """The formulas as text of 80 columns."""
    where = "" if found[0].motion == CONSTANT else ", of a vehicle that is level and heads north"
    out = [f"never shown, by the equations{where}:"]
    for one in found:
        if one.unsolved or not one.vectors:
            out.append(f"{one.motion}: {one.unsolved or 'every direction is shown'}")
        for vector in one.vectors:
            text = f"{one.motion}: " + ", ".join(f"{state} = {value}" for state, value in vector)
            out += textwrap.wrap(text, 80, subsequent_indent="  ", break_long_words=False)
    return "\n".join(out) + "\n"


def document(found: Sequence[NeverShown]) -> list[dict[str, Any]]:
    """The same for JSON."""
    return [
        {"motion": one.motion, "directions": [dict(v) for v in one.vectors], "unsolved": one.unsolved or None}
        for one in found
    ]
