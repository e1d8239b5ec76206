"""Models drawn by a number, of every kind that a filter may have: what holds of the built-in ones alone shows here."""

import random
import sys
from collections.abc import Collection, Iterable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from sympy import Matrix, cos, sin, zeros

from boresight import BoresightError, Measurement, Model, Struct, constant, export, generate, variable
from boresight.derive.model import Variable
from boresight.evidence.sources import Drawn

NUMBERS = tuple(map(str, range(10)))

PI = 3.141592653589793
PER_S = constant("per_s", "1", "1/s", "one per second")


def drawn(number: int) -> Model:
    """A model of 1 to 20 states: total or error, in continuous or discrete time, with rows that are angles, seen
    through functions or matrices, brought or computed, of noise that may hang on the state."""
    rng = random.Random(number)
    n, total = rng.choice((1, 2, 3, 4, 5, 7, 10, 15, 20)), rng.random() < 0.6
    states = [state(rng, i, total) for i in range(n)]
    x = [v.scalar for v in states]
    size = {v.scalar: (v.high[0] - v.low[0]) / 2 for v in states}
    dt = variable("dt", "dt", "s", "length of the step", 1e-4, rng.choice((0.05, 0.5, 1.0, 10.0)))
    given = [variable(f"input_{i}", f"w{i}", "1", "an input", rng.uniform(-9, -1), rng.uniform(1, 9)) for i in range(3)]
    noise = [
        variable(f"noise_{i}", f"n{i}", "rad/sqrt(s)", "a noise density", 0.0, 10.0 ** rng.randint(-4, -1))
        for i in range(n)
    ]
    w = [v.scalar for v in given]

    def rate(i: int) -> Any:
        """What a state changes by per second: a small part of its box, of others, of inputs."""
        part = sum(rng.uniform(-0.1, 0.1) * size[x[i]] * term for term in rng.sample(terms(x, size, w, rng), 2))
        return PER_S * (part - rng.uniform(0, 0.1) * x[i])

    measurements = tuple(measured(rng, k, x, size, w, total, states) for k in range(rng.randint(1, 3)))
    parts = {
        "name": f"drawn-{number}", "c_prefix": f"d{number}", "title": f"drawn by {number}, {n} states", "frame": "none",
        "states": tuple(states), "dt": dt.scalar, "measurements": measurements,
        "structs": (Struct("step", "one step", (dt, *given)), Struct("noise", "noise densities", tuple(noise))),
    }  # fmt: skip
    flow = Matrix([rate(i) for i in range(n)])
    q = Matrix([v.scalar for v in noise])
    by_state = int(total and rng.random() < 0.3)
    G = Matrix(n, n, lambda i, j: (size[x[i]] * (1 + (x[i] / size[x[i]]) ** 2 * by_state)) if i == j else 0)
    if total and rng.random() < 0.3:
        Q = Matrix(n, n, lambda i, j: dt.scalar * (G[i, i] * q[i]) ** 2 if i == j else 0)
        return Model(**parts, next=Matrix(x) + dt.scalar * flow, Q=Q)
    if total:
        return Model(**parts, f=flow, G=G, noise=q)
    return Model(**parts, F=Matrix(n, n, lambda i, j: flow[i].diff(x[j])).subs({s: 0 for s in x}), G=G, noise=q)


def state(rng: random.Random, i: int, total: bool) -> Variable:
    if total and rng.random() < 0.2:
        return variable(f"angle_{i}", f"x{i}", "rad", "an angle", -PI, PI, wraps=True)
    size = 10.0 ** rng.randint(-3, 5)
    low, high = rng.choice(((-size, size), (-size, size), (0.0, size), (size, 4 * size)) if total else ((-size, size),))
    return variable(f"state_{i}", f"x{i}", "rad", "a state", low, high, wide=True)


def terms(x: list[Any], size: dict[Any, float], w: list[Any], rng: random.Random) -> list[Any]:
    unit = [s / size[s] for s in x]
    return [sin(unit[rng.randrange(len(x))]), unit[rng.randrange(len(x))] * w[0] / 9, w[1] / 9, cos(w[2]) * unit[0]]


def measured(
    rng: random.Random, k: int, x: list[Any], size: dict[Any, float], w: list[Any], total: bool, states: list[Variable]
) -> Measurement:
    """Rows that see some states; a function of them, or a matrix."""
    m = rng.randint(1, min(4, len(x)))
    seen = rng.sample(range(len(x)), m)
    rows = tuple(f"row_{i}" for i in range(m))
    linear = Matrix([x[i] + int(total) * w[0] / 9 * size[x[i]] * 0.01 for i in seen])
    curved = Matrix([x[i] + size[x[i]] * 0.2 * sin(x[i] / size[x[i]]) * cos(w[1]) for i in seen])
    more: dict[str, Any] = {"correlated": True} if m > 1 and rng.random() < 0.3 else {}
    more |= {"angle": tuple(row for row, i in zip(rows, seen, strict=True) if states[i].wraps)}
    if not total and rng.random() < 0.5:
        H = zeros(m, len(x))
        for row, i in enumerate(seen):
            H[row, i] = 1
        z = Matrix([w[0] / 9 * size[x[i]] * 0.1 for i in seen])
        return Measurement(f"seen_{k}", rows, "rad", "some states", z=z, H=H, **more)
    h = rng.choice((linear, curved))
    return Measurement(f"seen_{k}", rows, "rad", "some states", h=h, **more)


def tried(number: int, out: Path) -> dict[str, Any]:
    """A drawn model, and of each precision whether the self-test of its export passes: `export` runs it."""
    model = drawn(number)
    generate(model, out / f"made-{number}")
    found = {"kind": model.kind, "states": len(model.x)}
    for precision in ("double", "float"):
        try:
            export(model, out / f"{number}-{precision}", precision, out / f"made-{number}")
            found[precision] = "passes"
        except BoresightError as error:
            found[precision] = str(error)
    return found


def drawn_models(of: Drawn, out: Path, names: Collection[str] = NUMBERS) -> dict[str, dict[str, Any]]:
    """By number: kind, states, and what the self-test says in each precision."""
    return {name: tried(int(name), out) for name in names}


def main(numbers: Iterable[int]) -> int:
    """How many of these fail, each named as it is tried."""
    failed = 0
    for number in numbers:
        with TemporaryDirectory() as out:
            found = tried(number, Path(out))
        failed += sum(found[precision] != "passes" for precision in ("double", "float"))
        print(f"{number}: {', '.join(map(str, found.values()))}", flush=True)
    return failed


if __name__ == "__main__":
    sys.exit(main(map(int, sys.argv[1:] or range(50))) > 0)
