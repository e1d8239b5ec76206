"""A CasADi function as the list of operations that both C prints follow, in single assignment.

The list is taken from CasADi's public instruction interface.  `evaluate` runs it on numbers together with a bound on
the rounding error of each result, which is what the generated C is held against.
"""

import hashlib
from collections import Counter
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from boresight import BoresightError
from boresight.codegen.functions.elementary import (
    arccosine,
    arcsine,
    arctangent,
    arctangent2,
    cosine,
    exponential,
    hyperbolic_cosine,
    hyperbolic_sine,
    hyperbolic_tangent,
    hypotenuse,
    larger,
    logarithm,
    sine,
    smaller,
)

NAMES = (
    "assign add sub mul div neg sq twice inv sqrt exp log sin cos asin acos atan atan2 sinh cosh tanh fabs sign "
    "fmin fmax lt le eq ne not and or if_else_zero const input output"
)
OPERATIONS = {getattr(ca, f"OP_{name.upper()}"): name for name in NAMES.split()}
FREE = {"const", "input"}  # no work at run time


@dataclass(frozen=True)
class Step:
    """One value: an operation on earlier values (`args` are positions in the tape), a constant, or an input."""

    op: str
    args: tuple[int, ...] = ()
    constant: float = 0.0
    source: tuple[int, int] = (0, 0)  # which input, which of its components


@dataclass(frozen=True)
class Tape:
    """steps in order; results: (output, non-zero, position of its value in steps)."""

    steps: tuple[Step, ...]
    results: tuple[tuple[int, int, int], ...]

    @property
    def operations(self) -> int:
        return sum(step.op not in FREE for step in self.steps)

    def hash(self) -> str:
        """Of the operations alone: the same list, the same hash, whatever the words around it."""
        text = "\n".join(
            [f"{s.op} {s.args} {s.constant.hex()} {s.source}" for s in self.steps] + [str(r) for r in self.results]
        )
        return hashlib.sha256(text.encode()).hexdigest()


def tape(function: Any) -> Tape:
    """The instruction list of an SX function.  Raises BoresightError on an operation that flight C does not have."""
    steps: list[Step] = []
    results: list[tuple[int, int, int]] = []
    seen: dict[Step, int] = {}
    work: dict[int, int] = {}
    for k in range(function.n_instructions()):
        code, into, out = function.instruction_id(k), function.instruction_input(k), function.instruction_output(k)
        op = OPERATIONS.get(code)
        if op is None:
            names = [n for n in dir(ca) if n.startswith("OP_") and getattr(ca, n) == code]
            raise BoresightError(
                f"{function.name()}: flight C has no {names[0] if names else code}; rewrite the equation"
            )
        if op == "output":
            results.append((out[0], out[1], work[into[0]]))
            continue
        if op == "input":
            step = Step("input", source=(into[0], into[1]))
        elif op == "const":
            step = Step("const", constant=function.instruction_constant(k))
        elif op == "assign":
            work[out[0]] = work[into[0]]
            continue
        else:
            step = Step(op, tuple(work[i] for i in into[: 1 if op in UNARY else 2]))
        if step not in seen:
            seen[step] = len(steps)
            steps.append(step)
        work[out[0]] = seen[step]
    return Tape(tuple(steps), tuple(results))


LIBRARY: set[str] = {"sin", "cos", "exp", "log", "asin", "acos", "atan", "sinh", "cosh", "tanh"}  # of one argument
UNARY = {"neg", "sq", "twice", "inv", "sqrt", "fabs", "sign", "not"} | LIBRARY
BOUNDED = {"exp", "log", "asin", "acos", "sinh", "cosh"}  # with no value, or none that a number holds, for some
ULPS = {"asin": 2, "acos": 2, "sinh": 3, "cosh": 3, "tanh": 3}  # what our own may err by; 1 of the others
PLAIN: dict[str, Any] = {  # of CasADi's expressions and of arrays
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b,
    "neg": lambda a: -a,
    "sq": lambda a: a * a,
    "twice": lambda a: 2 * a,
    "inv": lambda a: 1 / a,
    "lt": lambda a, b: a < b,
    "le": lambda a, b: a <= b,
    "eq": lambda a, b: a == b,
    "ne": lambda a, b: a != b,
}
BUILD = PLAIN | {
    **{name: getattr(ca, name) for name in ("sqrt", "atan2", "fabs", "sign", "fmin", "fmax", *LIBRARY)},
    "not": ca.logic_not,
    "and": ca.logic_and,
    "or": ca.logic_or,
    "if_else_zero": lambda c, a: ca.if_else(c, a, 0),
}
COMPUTE = PLAIN | {
    "sqrt": np.sqrt,
    "exp": exponential,
    "log": logarithm,
    "sin": sine,
    "cos": cosine,
    "asin": arcsine,
    "acos": arccosine,
    "atan": arctangent,
    "atan2": arctangent2,
    "sinh": hyperbolic_sine,
    "cosh": hyperbolic_cosine,
    "tanh": hyperbolic_tangent,
    "fabs": abs,
    "sign": np.sign,
    "fmin": smaller,
    "fmax": larger,
    "not": lambda a: a == 0,
    "and": lambda a, b: (a != 0) & (b != 0),
    "or": lambda a, b: (a != 0) | (b != 0),
    "if_else_zero": lambda c, a: np.where(c != 0, a, 0),
}


def share_reciprocals(function: Any) -> Any:
    """The same function with one reciprocal for each divisor that several quotients share.

    CasADi rewrites x * (1 / y) to x / y as an expression is built, so the list is rebuilt with that switched off.
    """
    source = tape(function)
    divisors = Counter(step.args[-1] for step in source.steps if step.op in ("div", "inv"))
    if not any(count > 1 for count in divisors.values()):
        return function
    inputs = [ca.SX.sym(function.name_in(i), function.sparsity_in(i)) for i in range(function.n_in())]
    outputs = [ca.SX(function.sparsity_out(i)) for i in range(function.n_out())]
    simplifying = ca.GlobalOptions.getSimplificationOnTheFly()
    ca.GlobalOptions.setSimplificationOnTheFly(False)
    try:
        values: list[Any] = []
        reciprocals: dict[int, Any] = {}
        for step in source.steps:
            if step.op == "input":
                values.append(inputs[step.source[0]].nz[step.source[1]])
            elif step.op == "const":
                values.append(ca.SX(step.constant))
            elif step.op in ("div", "inv") and divisors[step.args[-1]] > 1:
                if step.args[-1] not in reciprocals:
                    reciprocals[step.args[-1]] = 1 / values[step.args[-1]]
                r = reciprocals[step.args[-1]]
                values.append(r if step.op == "inv" else values[step.args[0]] * r)
            else:
                # A choice is rebuilt with simplification on: off, each would become two.
                ca.GlobalOptions.setSimplificationOnTheFly(step.op == "if_else_zero")
                values.append(BUILD[step.op](*(values[a] for a in step.args)))
                ca.GlobalOptions.setSimplificationOnTheFly(False)
        for output, k, position in source.results:
            outputs[output].nz[k] = values[position]
        return ca.Function(function.name(), inputs, outputs, function.name_in(), function.name_out())
    finally:
        ca.GlobalOptions.setSimplificationOnTheFly(simplifying)


@np.errstate(over="ignore", divide="ignore", invalid="ignore")
def computed(program: Tape, inputs: list[np.ndarray]) -> list[np.ndarray]:
    """What each step of the tape gives in double, (points,) each, the same on every machine; what libraries
    have errs by 4 ulp at most.  inputs: one (points, size) array an argument."""
    zero = np.zeros(len(inputs[0]) if inputs else 1)
    value: list[np.ndarray] = []
    for step in program.steps:
        if step.op == "input":
            value.append(inputs[step.source[0]][:, step.source[1]])
        elif step.op == "const":
            value.append(zero + step.constant)
        else:
            value.append(COMPUTE[step.op](*(value[i] for i in step.args)) + zero)
    return value


def evaluate(
    program: Tape, inputs: list[np.ndarray], real: type[np.floating] = np.float64
) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """Each result of the tape in double and a bound on the error of arithmetic in `real`, at many points at once.

    inputs: one (points, size) array an argument, taken as exact.
    Returns values and bounds, (points,) each, in the order of `program.results`.
    """
    value, error = bounded(program, inputs, real)
    # 1 + 1e-9 covers the rounding of the bounds themselves; the smallest number covers underflow.
    slack = 1 + 1e-9
    tiny = float(np.finfo(real).tiny)
    return (
        [value[position] for _, _, position in program.results],
        [error[position] * slack + tiny for _, _, position in program.results],
    )


def bounded(
    program: Tape, inputs: list[np.ndarray], real: type[np.floating]
) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """The same of every step.  A running error analysis: each operation adds its own rounding to what its operands
    bring; second-order products of errors are covered by what `evaluate` puts on."""
    value = computed(program, inputs)
    error: list[np.ndarray] = []
    for step, v in zip(program.steps, value, strict=True):
        error.append(rounding(step, v, [(value[i], error[i]) for i in step.args], real))
    return value, error


@np.errstate(over="ignore", divide="ignore", invalid="ignore")  # where nothing bounds the error, it is infinite
def rounding(
    step: Step, v: np.ndarray, operands: list[tuple[np.ndarray, np.ndarray]], real: type[np.floating]
) -> np.ndarray:
    """A bound on the error of one step of value v, from the values and errors of its operands."""
    u = float(np.finfo(real).eps) / 2
    zero: np.ndarray = np.zeros(len(v))
    if step.op == "input":
        e = zero
    elif step.op == "const":
        # A constant that is no small dyadic number was rounded once when it was printed.
        exact = float(step.constant * 2**20).is_integer() and float(real(step.constant)) == step.constant
        e = zero if exact else abs(v) * u
    else:
        (x, ex), (y, ey) = (operands + operands)[:2]
        if step.op in ("add", "sub"):
            e = ex + ey + u * abs(v)
        elif step.op == "mul":
            e = abs(x) * ey + abs(y) * ex + ex * ey + u * abs(v)
        elif step.op == "sq":
            e = 2 * abs(x) * ex + ex * ex + u * abs(v)
        elif step.op == "div":
            e = (ex + abs(v) * ey) / np.maximum(abs(y) - ey, 1e-300) + u * abs(v)
        elif step.op == "inv":
            e = abs(v) * ex / np.maximum(abs(x) - ex, 1e-300) + u * abs(v)
        elif step.op == "sqrt":
            # |sqrt(x+e) - sqrt(x)| <= e / (sqrt(x) + sqrt(max(x-e, 0)))
            below = v + np.sqrt(np.maximum(x - ex, 0))
            e = np.where(ex > 0, ex / np.maximum(below, 1e-300), 0) + u * v
        elif step.op in LIBRARY:
            e = carried(step.op, x, v, ex) + 2 * u * ULPS.get(step.op, 1) * abs(v)
        elif step.op == "atan2":
            off = hypotenuse(ex, ey)
            e = off / np.maximum(hypotenuse(x, y) - off, 1e-300) + 2 * u * abs(v)
        elif step.op in ("neg", "twice", "fabs"):
            e = 2 * ex if step.op == "twice" else ex
        elif step.op in ("fmin", "fmax"):
            e = np.maximum(ex, ey)
        elif step.op == "sign":
            e = np.where((abs(x) <= ex) & (ex > 0), np.inf, 0)
        elif step.op == "if_else_zero":
            e = np.where(x != 0, ey, 0) + ex
        elif step.op in ("not", "and", "or"):
            e = ex + ey
        else:
            # what rounding may decide has no bound
            e = np.where((abs(x - y) <= ex + ey) & (ex + ey > 0), np.inf, 0)
    return np.where(abs(v) <= np.finfo(real).max, e, np.inf)


def carried(op: str, x: np.ndarray, v: np.ndarray, ex: np.ndarray) -> np.ndarray:
    """By how much a library function moves at most from its value v where its argument x moves by ex: infinite where
    that may leave the domain."""
    far, near = abs(x) + ex, np.maximum(abs(x) - ex, 0)
    if op in ("sin", "cos"):
        return ex * np.minimum(abs(cosine(x) if op == "sin" else sine(x)) + ex, 1)
    if op == "exp":
        return ex * v * exponential(ex)
    if op == "log":
        return np.where(x > ex, ex / (x - ex), np.inf)
    if op in ("asin", "acos"):
        end = np.sqrt(np.maximum((1 - far) * (1 + far), 0))
        return np.where(ex > 0, np.where(far < 1, ex / end, np.inf), 0)
    if op == "atan":
        return ex / (1 + near * near)
    if op == "tanh":
        return ex / hyperbolic_cosine(near) ** 2
    return ex * (hyperbolic_cosine(far) if op == "sinh" else hyperbolic_sine(far))
