"""The printed units of a model: for each, CasADi's function and a reference in 50 digits that shares nothing with it
but the SymPy expressions themselves."""

from dataclasses import replace

import casadi as ca
import sympy as sp

from boresight import BoresightError
from boresight.codegen.functions.dynamics import dynamics
from boresight.codegen.functions.maker import UnitMaker
from boresight.codegen.functions.tape import BOUNDED
from boresight.codegen.functions.unit import Unit, described
from boresight.derive.checks import expressions, fail
from boresight.derive.model import Function, Measurement, Model


def units(model: Model) -> list[Unit]:
    """Every printed unit of the model, in a fixed order.  Raises BoresightError on an entry that C cannot hold."""
    maker = UnitMaker(model)
    try:
        made = made_by(maker)
    except BoresightError:
        for item in expressions(model):
            for (i, j), entry in item.matrix.todok().items():
                try:
                    maker.convert(sp.Matrix([entry]))
                    maker.numeric(sp.Matrix([entry]))
                except BoresightError as error:
                    fail(item.part, f"{item.entry(i, j)}: {error}")
        raise
    return made


def guarded(part: list[Unit]) -> list[Unit]:
    """The units of one part of a model, which answer with finite numbers only if one of them has what may give none."""
    bounded = any(step.op in BOUNDED for unit in part for step in unit.tape.steps)
    return [replace(unit, guarded=bounded) for unit in part]


def made_by(maker: UnitMaker) -> list[Unit]:
    """The units of the maker's model."""
    model = maker.model
    parts = [dynamics(maker)] if model.n else []
    parts += [measurement(maker, m) for m in model.measurements]
    parts += [[function(maker, f)] for f in model.functions]
    return [unit for part in parts for unit in guarded(part)]


def function(maker: UnitMaker, f: Function) -> Unit:
    values = maker.convert(*(output.value for output in f.outputs))
    return maker.unit(
        f.name,
        f.meaning,
        [
            (
                v,
                described(o.name, o.unit, o.meaning + (f", {o.frame}" if o.frame else ""), low=o.low, high=o.high),
            )
            for o, v in zip(f.outputs, values, strict=True)
        ],
        maker.numeric(*(output.value for output in f.outputs)),
        f.equations,
        tuple(output.value for output in f.outputs),
    )


def measurement(maker: UnitMaker, m: Measurement) -> list[Unit]:
    made = []
    rows = f"row{'s' if len(m.rows) > 1 else ''} {', '.join(m.rows)}"
    error = maker.model.kind == "error-state"

    part = 0 < len(m.angles) < len(m.rows)
    names = [row + " (wrapped to [-pi, pi])" * (part and i in m.angles) for i, row in enumerate(m.rows)]

    def wrapped(matrix: sp.Matrix) -> sp.Matrix:
        return sp.Matrix([sp.atan2(sp.sin(a), sp.cos(a)) if i in m.angles else a for i, a in enumerate(matrix)])

    for label, matrix, meaning in (
        ("z", m.z, "z = H x + noise" if m.H is not None else "z = h(x) + noise"),
        ("h", m.h, f"h(x), the z of {'an error' if error else 'a'} state x without noise"),
    ):
        if matrix is not None and not (label == "h" and m.H is not None):
            printed = wrapped(matrix)
            made.append(
                maker.unit(
                    f"{m.name}_{label}",
                    f"{m.meaning}; {meaning}; {rows}",
                    [(maker.convert(printed)[0], described(label, m.unit, ", ".join(names), angle=m.angles))],
                    maker.numeric(printed),
                    m.equations,
                    (printed,),
                )
            )
    if m.H is not None:
        value, reference = maker.convert(m.H)[0], maker.numeric(m.H)
    else:
        value = ca.jacobian(maker.convert(m.h)[0], maker.vectors["x"])
        reference = maker.numeric(m.h, jacobian=True)
    slope = "d z / d x" if m.H is not None else "d h / d x at x"
    meaning = f"{m.meaning}; measurement matrix H = {slope}; {rows}"
    made.append(
        maker.unit(
            f"{m.name}_H",
            meaning,
            [(value, described("H", f"{m.unit} per unit of state", rows))],
            reference,
            m.equations,
            (m.H if m.H is not None else m.h,),
        )
    )
    return made
