"""A strapdown over a flat Earth that stands still, held by Newton's law where all that it reads and carries is known.

An attitude turns by the rate of the body, a velocity grows by the specific force and by gravity downwards, a place by
the velocity.  Variables are known by their axes and units; errors of the sensors are put to nothing, and must say what
they are (codegen/words.py), so that they are held there.
"""

from typing import Any

from flint import arb

from boresight.codegen.functions.reference import precise
from boresight.codegen.functions.samples import generator
from boresight.codegen.mechanics import STEP, MechanicsCheck, Verdict, compiled, points, quaternion_rate, rotation_of
from boresight.codegen.points import nearest_zero
from boresight.codegen.residuals import FROM_BODY, OF_BODY, SHOWN, TO_LEVEL, attitude, letters
from boresight.derive.checks import mechanics_of
from boresight.derive.expressions import symbols_in
from boresight.derive.ledger.numbers import Matrix, zeros
from boresight.derive.mechanics.earth import FRAMES
from boresight.derive.model import Model, Variable
from boresight.derive.within import within

AXES = tuple(frame.axes for frame in FRAMES.values())
GRAVITY: tuple[float, float] = 9.7, 9.9  # m/s^2, near the ground
LAW = "a body over a flat Earth"
NEAR = 1e-12  # over STEP what is of the second order is less
# Of a unit: whether it is of a turn, and whether it is an integral over the step.
SENSORS = {"rad/s": (True, False), "rad": (True, True), "m/s^2": (False, False), "m/s": (False, True)}


def check_flat(model: Model) -> list[MechanicsCheck]:
    """One row; none of a strapdown that reads or carries something else."""
    parts = known(model)
    if parts is None:
        return []
    verdict = Verdict()
    with precise():
        for k, values in enumerate(points(model, "flat")):
            compare(model, parts, values, k, verdict)
    if verdict.entry:  # it may be right, of a body that moves otherwise
        return [MechanicsCheck(model.name, "strapdown", "", why=f"it is not {LAW}: {verdict.entry}")]
    return [verdict.check(model, "strapdown", LAW)]


def known(model: Model) -> dict[str, Variable] | None:
    """What strapdown reads and carries: q, v, p, and each sensor under its unit; None if there is more than that."""
    strapdown, feedback = mechanics_of(model)
    if model.kind != "error-state" or strapdown is None or model.dt is None:
        return None
    read = symbols_in(*(o.value for o in strapdown.outputs))
    returned = {o.name for o in (*strapdown.outputs, *(feedback.outputs if feedback else ()))}
    carried, found = {o.name for o in strapdown.outputs}, dict[str, Variable]()
    for v in model.inputs:
        if v.name not in carried and (not read & {*v.symbols} or model.dt in v.symbols):
            continue
        if attitude(v, FROM_BODY) and attitude(v, TO_LEVEL):
            part = "q"
        elif v.name in carried:
            part = {"m/s": "v", "m": "p"}.get(v.unit, "") if letters(v) in AXES else ""
        elif letters(v) in OF_BODY and v.frame in ("", "body"):
            error = v.name in returned and SHOWN.search(v.meaning)
            part = f"less {v.unit}" if error else v.unit if v.unit in SENSORS and v.name not in returned else ""
        else:
            part = ""
        if not part or part in found:
            return None
        found[part] = v
    moving = {v.name for part, v in found.items() if part in "qvp"}
    return found if "q" in found and ("v" in found or "p" not in found) and carried == moving else None


def compare(model: Model, parts: dict[str, Variable], values: dict[Any, Any], k: int, verdict: Verdict) -> None:
    strapdown, _ = mechanics_of(model)
    rng = generator("flat", str(k))
    sensed = {True: zeros(3, 1), False: zeros(3, 1)}  # rad/s and m/s^2
    here = values | {model.dt: STEP}
    for unit, v in parts.items():
        if unit in SENSORS:
            turn, whole = SENSORS[unit]
            sensed[turn] = Matrix([arb(float(e)) for e in rng.uniform(-1, 1, 3)])
            column = list(sensed[turn] * (STEP if whole else 1))
        elif unit.startswith("less"):
            column = nearest_zero(v)
        else:
            continue
        here.update(zip(v.symbols, column, strict=True))
    now = {part: Matrix([here[s] for s in v.symbols]) for part, v in parts.items() if part in "qvp"}
    columns = compiled(*(o.value for o in strapdown.outputs))(here)
    after = dict(zip((o.name for o in strapdown.outputs), columns, strict=True))
    rates = {part: (after[parts[part].name] - column) / STEP for part, column in now.items()}
    exact = {"q": quaternion_rate(now["q"], sensed[True], zeros(3, 1))}
    if "v" in now:
        exact["v"] = rotation_of(now["q"]) * sensed[False]
        down = letters(parts["v"]).index("d") if "d" in letters(parts["v"]) else letters(parts["v"]).index("u")
        g = rates["v"][down, 0] - exact["v"][down, 0]
        downwards = float(g) * (1 if letters(parts["v"])[down] == "d" else -1)
        if not GRAVITY[0] <= downwards <= GRAVITY[1]:
            verdict.entry = verdict.entry or f"{parts['v'].symbols[down]} has gravity {downwards:.6g} downwards"
        exact["v"][down, 0] += g
    if "p" in now:
        exact["p"] = now["v"]
    for part, stated in rates.items():
        most = max(1.0, *(abs(float(e)) for e in exact[part]))
        for s, mine, theirs in zip(parts[part].symbols, stated, exact[part], strict=True):
            off = float(abs(mine - theirs)) / most
            verdict.difference = max(verdict.difference, off)
            if not within(off, NEAR):
                text = f"{s} by t: {float(mine):.6g} stated, {float(theirs):.6g} exact"
                verdict.entry = verdict.entry or text
