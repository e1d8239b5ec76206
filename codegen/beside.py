"""Functions of a model beside its filter, held against exact mechanics where what they return is known by its name.

Rates and gravity by Newton's law on the turning ellipsoid; Euler angles by the rotation that they make; the maps
between the phi and the psi model by one navigator whose errors are read in either; an attitude that turns by given
rates.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

from flint import arb

from boresight.codegen.functions.reference import precise
from boresight.codegen.mechanics import (
    MANY,
    STEP,
    MechanicsCheck,
    Values,
    Verdict,
    compiled,
    points,
    quaternion_rate,
    rotation_of,
    row_sizes,
)
from boresight.codegen.points import nearest_zero
from boresight.derive.expressions import symbols_in
from boresight.derive.ledger import ellipsoid
from boresight.derive.ledger.navigation import Navigator, Truth, stack, truth
from boresight.derive.ledger.numbers import Matrix, digits, zeros
from boresight.derive.ledger.witness import attitude, rotation_vector
from boresight.derive.model import Function, Model, Output

NEWTON = "Newton's law on the turning ellipsoid"
READ = {"lon", "lat", "height", "v_n", "q_b2n_wxyz", "f_b", "omega_ib_b"}  # by which a navigator is known


BY_NEWTON: dict[str, Callable[[Any, Matrix, Matrix], Matrix]] = {  # of a Navigator, its attitude and its turn
    "omega_ie_n": lambda now, q, omega: now.omega_ie_n,
    "omega_en_n": lambda now, q, omega: now.omega_en_n,
    "omega_in_n": lambda now, q, omega: now.omega_in_n,
    "gravity_n": lambda now, q, omega: now.gravity_n,
    "position_rate": lambda now, q, omega: now.position_rate,
    "v_n_rate": lambda now, q, omega: now.velocity_rate,
    "q_b2n_rate": lambda now, q, omega: quaternion_rate(q, omega, now.omega_in_n),
}
STATES = 9  # of the phi and of the psi model


def check_beside(model: Model) -> list[MechanicsCheck]:
    """A row of each function that is known, all of whose outputs are held."""
    level = ellipsoid.LEVELS.get(model.frame[:3])
    if level is None:
        return []
    found = []
    for f in model.functions:
        held = [how for o in f.outputs if (how := known(model, f, o, level))]
        if len(held) == len(f.outputs):
            verdict = Verdict()
            for one, _ in held:
                one(verdict)
            found.append(verdict.check(model, f.name, held[0][1]))
    return found


def known(model: Model, f: Function, o: Output, level: ellipsoid.Level) -> tuple[Callable[[Verdict], None], str] | None:
    """What holds an output, and by what; None where nothing does."""
    read = symbols_in(o.value)
    names = {s.name if v.name not in READ else v.name for v in model.inputs for s in v.symbols if s in read}
    if o.name in BY_NEWTON and names <= READ:
        return partial(by_newton, model, o, level), NEWTON
    if o.name == "euler_b" and names == {"q_b2n_wxyz"}:
        return partial(by_rotation, model, o), "the rotation that the angles make"
    if f.name in MAPS and names <= READ and o.value.shape == (STATES, STATES):
        return partial(by_errors, model, f, o, level), "one navigator, its errors read in either model"
    increments = {s.name for v in model.inputs if v.name == "dtheta_ib_b" for s in v.symbols}
    given = {s.name for v in model.inputs if v.name == "omega_in_n" for s in v.symbols}
    if f.name == "strapdown" and o.name == "q_b2n_wxyz" and names <= {*READ, *increments, *given, str(model.dt)}:
        return partial(by_given_rates, model, o), "a quaternion that turns by given rates"
    return None


def values_of(model: Model, values: Values, name: str, size: int = 3) -> Matrix:
    """An input by its name; zero where there is none."""
    symbols = next((v.symbols for v in model.inputs if v.name == name), ())
    return Matrix([values[s] for s in symbols]) if symbols else zeros(size, 1)


def position_of(model: Model, values: Values, level: ellipsoid.Level) -> Matrix:
    by_name = {s.name: values[s] for v in model.inputs for s in v.symbols}
    names = [("lon", "lat", "height")[i] for i in level.order]
    return Matrix([by_name.get(name, arb(0)) for name in names])


def by_newton(model: Model, o: Output, level: ellipsoid.Level, verdict: Verdict) -> None:
    run, rows = compiled(o.value), [f"{o.name}[{i}]" for i in range(o.value.rows)]
    for values in points(model, "beside", MANY):
        with precise():
            (mine,) = run(values)
        with digits(ellipsoid.WORKING):
            q, omega, force = (
                values_of(model, values, n, k) for n, k in (("q_b2n_wxyz", 4), ("omega_ib_b", 3), ("f_b", 3))
            )
            C = rotation_of(q)
            now = Navigator(position_of(model, values, level), values_of(model, values, "v_n"), C, force, omega, level)
            theirs = BY_NEWTON[o.name](now, q, omega)
        with precise():
            verdict.compare(mine, theirs, rows, ["value"], [1], row_sizes(theirs))


def by_rotation(model: Model, o: Output, verdict: Verdict) -> None:
    run = compiled(o.value)
    names = [f"C[{i}, {j}] of roll, pitch, yaw" for i in range(3) for j in range(3)]
    for values in points(model, "beside", MANY):
        with precise():
            made, C = attitude(run(values)[0]), rotation_of(values_of(model, values, "q_b2n_wxyz"))
            verdict.compare(Matrix(list(made)), Matrix(list(C)), names, ["value"], [1], [1.0] * 9)


def of_phi(at: Truth, x: Matrix) -> Matrix:
    """The errors psi of the navigator that has the errors phi."""
    hat, C_n2c = at.hat(stack(x, zeros(6, 1)), zeros(6, 1)), at.computed_level(x[0:3, 0])
    return stack(x[0:3, 0], hat.v_n - C_n2c * at.v_n, -rotation_vector(hat.C_b2n * (C_n2c * at.C).T))


def of_psi(at: Truth, x: Matrix) -> Matrix:
    """The errors phi of the navigator that has the errors psi."""
    hat = at.psi_hat(x)
    return stack(x[0:3, 0], hat.v_n - at.v_n, -rotation_vector(hat.C_b2n * at.C.T))


MAPS = {"psi_from_phi": of_phi, "phi_from_psi": of_psi}


def by_errors(model: Model, f: Function, o: Output, level: ellipsoid.Level, verdict: Verdict) -> None:
    run, names = compiled(o.value), [s.name for s in model.x]
    for values in points(model, "beside"):
        with precise():
            (mine,) = run(values)
        with digits(ellipsoid.WORKING):
            place, v_n = position_of(model, values, level), values_of(model, values, "v_n")
            C = rotation_of(values_of(model, values, "q_b2n_wxyz"))
            at = truth(place, v_n, C, zeros(3, 1), zeros(3, 1), level)
            theirs = ellipsoid.jacobian(partial(MAPS[f.name], at), STATES)
        with precise():
            verdict.compare(mine, theirs, names, names, [1] * STATES, row_sizes(theirs))


def by_given_rates(model: Model, o: Output, verdict: Verdict) -> None:
    run, rows = compiled(o.value), [f"q[{i}]" for i in range(4)]
    dtheta = next(v for v in model.inputs if v.name == "dtheta_ib_b")
    dt: Any = model.dt
    for values in points(model, "beside", MANY):
        now = {**values, **dict(zip(dtheta.symbols, nearest_zero(dtheta), strict=True)), dt: STEP}
        omega = values_of(model, values, "dtheta_ib_b")  # rad/s here, of the size of its box
        with precise():
            now.update((s, rate * STEP) for s, rate in zip(dtheta.symbols, omega, strict=True))
            q, omega_in = values_of(model, values, "q_b2n_wxyz"), values_of(model, values, "omega_in_n")
            theirs = quaternion_rate(q, omega, omega_in)
            mine = (run(now)[0] - q) / STEP
            verdict.compare(mine, theirs, rows, ["t"], [1], row_sizes(theirs))
