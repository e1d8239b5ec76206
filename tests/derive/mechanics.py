"""What the tests of the mechanics share: numbers for the symbols, and derivatives by CasADi."""

import casadi as ca
import numpy as np
from sympy import Matrix, lambdify, symbols

from boresight.codegen.functions.convert import to_casadi

POSITION, V_N, F_N = (Matrix(symbols(f"{name}_:3", real=True)) for name in ("p", "v", "f"))


def numbers(expression, *columns):
    """The expression as a function of one (n,) array a column of symbols."""
    compiled = lambdify([list(column) for column in columns], expression, modules="numpy", cse=True)
    return lambda *values: np.array(compiled(*values), dtype=float)


def differentiable(expressions, *columns):
    """CasADi's functions of the expressions, as SX beside the SX columns they are made of."""
    made = [ca.SX.sym(f"a{i}", len(column)) for i, column in enumerate(columns)]
    known = {s: made[i][k] for i, column in enumerate(columns) for k, s in enumerate(column)}
    return to_casadi(list(expressions), known), made


def states(frame, count, seed=3, latitude=1.4, speed=300.0):
    """Random (position, v_n, f_n) in the frame's order."""
    rng = np.random.default_rng(seed)
    for _ in range(count):
        place = {
            "lat": rng.uniform(-latitude, latitude),
            "lon": rng.uniform(-3, 3),
            "height": rng.uniform(-400, 20000),
        }
        yield (
            np.array([place[name] for name in frame.coordinates]),
            rng.uniform(-speed, speed, 3),
            rng.uniform(-30, 30, 3),
        )


def skew(v):
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
