"""The elementary functions that a model calls, as C; templates/include/boresight_math.h.j2 has what they do."""

from typing import Any

import mpmath as mp
import numpy as np

from boresight.codegen.functions.tape import LIBRARY, ULPS
from boresight.codegen.functions.unit import Unit
from boresight.codegen.text.names import rows_of, three_digits

POINTS = {  # of the self-test: small and large, about the ends of what a polynomial serves, and across the quadrants
    "sin": (
        0.0,
        -0.0,
        1e-8,
        0.3,
        -0.785,
        0.786,
        1.5,
        -1.571,
        2.4,
        3.1415926,
        -4.0,
        5.5,
        6.2831855,
        49.9,
        -50.1,
        1e4,
        1e7,
        -1e10,
        1e22,
        -1e30,
        3e38,
    ),
    "exp": (0.0, -0.0, 1e-8, -0.3, 0.34, 0.35, 1.0, -1.5, 10.25, -20.0, 80.0, -80.0),
    "log": (1.0, 0.99999994, 1.0000001, 0.5, 0.7, 0.71, 1.41, 1.42, 2.0, 10.0, 1e-30, 1e30),
    "asin": (0.0, -0.0, 1e-8, 0.3, -0.38, 0.39, 0.707, -0.708, 0.99, -1.0, 1.0),
    "atan": (0.0, -0.0, 1e-8, 0.3, -0.41, 0.42, 0.99999994, -1.0, 2.4, 2.5, -1e8, 1e30),
    "sinh": (0.0, -0.0, 1e-8, 0.3, -0.49, 0.51, -0.99, 1.0, 2.5, -10.0, 80.0),
}
POINTS |= {"cos": POINTS["sin"], "acos": POINTS["asin"], "cosh": POINTS["sinh"], "tanh": POINTS["sinh"]}
PAIRS = (  # of atan2
    *((0.0, 1.0), (-0.0, 1.0), (0.0, -1.0), (-0.0, -1.0), (0.0, 0.0), (-0.0, -0.0), (1.0, 0.0), (-1.0, -0.0)),
    *(
        (0.3, 1.0),
        (0.4, 1.0),
        (0.42, 1.0),
        (1.0, 1.0),
        (2.4, 1.0),
        (2.5, -1.0),
        (0.3, -1.0),
        (-0.42, -1.0),
        (-3.0, 1e-8),
    ),
    *((1e-30, 2e-30), (-1e30, 3e30), (1e-30, -1e30), (1e30, 1e-30), (3e38, 3e38)),
)


def called(made: list[Unit]) -> list[dict[str, str]]:
    """name, result, parameters and arguments in C of each function that the units' lists hold; `sincos` before those
    that it serves."""
    used = {step.op for unit in made for step in unit.tape.steps} & ({"atan2"} | LIBRARY)
    names = (["sincos"] if used & {"sin", "cos"} else []) + sorted(used)
    return [function(name) for name in names]


def function(name: str) -> dict[str, str]:
    parameters: tuple[str, ...]
    if name == "sincos":
        parameters, result = ("bs_real angle", "bs_real *sine", "bs_real *cosine"), "void"
    elif name == "atan2":
        parameters, result = ("bs_real y", "bs_real x"), "bs_real"
    else:
        parameters, result = (f"bs_real {'angle' if name in ('sin', 'cos') else 'x'}",), "bs_real"
    arguments = ", ".join(word.split()[-1].lstrip("*") for word in parameters)
    return {"name": name, "result": result, "parameters": ", ".join(parameters), "arguments": arguments}


def tests(functions: list[dict[str, str]]) -> list[dict[str, Any]]:
    """By function but the pair: how many points, the arguments that a float holds, expected values, tolerances."""
    made = []
    for f in functions:
        if f["name"] == "sincos":
            continue
        points = np.array(PAIRS if f["name"] == "atan2" else [(x,) for x in POINTS[f["name"]]], dtype=np.float32)
        with mp.workdps(50):
            values = np.array([float(exact(f["name"], *map(float, point))) for point in points])

        def rows(real: type[np.floating], name: str = f["name"], values: np.ndarray = values) -> str:
            unit = np.spacing(np.maximum(abs(values.astype(real)), np.finfo(real).tiny)).astype(float)
            return rows_of([ULPS.get(name, 1) * unit + np.spacing(abs(values))], three_digits)

        made.append(
            f
            | {
                "count": len(points),
                "given": rows_of(points),
                "expected": rows_of([values]),
                "tolerance": rows(np.float64),
                "float_tolerance": rows(np.float32),
            }
        )
    return made


def exact(name: str, *given: float) -> Any:
    """The value in as many digits as mpmath works in; where mpmath has no signed zero, as C99 has it."""
    if name == "atan2":
        y, x = given
        turned = mp.pi if np.copysign(1, x) < 0 else mp.mpf(0)
        return mp.atan2(y, x) if y else np.copysign(1, y) * turned
    return getattr(mp, name)(mp.mpf(given[0]))
