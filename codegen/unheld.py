"""What verify did not hold, and why: every function beside which nothing exact is known, and what a model just states.

A model lists with a reason what cannot be held.  Constants that are typed in, the values of noise, and the equations
that everything else is held against, have no other side: they are named, so that somebody compares them.
"""

from collections.abc import Sequence
from dataclasses import replace

from boresight.codegen.mechanics import MechanicsCheck
from boresight.derive.checks import expressions
from boresight.derive.constant import Constant
from boresight.derive.expressions import constants_in, symbols_in
from boresight.derive.linear import OF_F, OF_NEXT
from boresight.derive.mechanics import earth, rotation
from boresight.derive.model import Model

NOTHING_EXACT = "verify knows nothing exact to hold it against"


def with_unheld(model: Model, checks: Sequence[MechanicsCheck]) -> list[MechanicsCheck]:
    """The checks of a model against mechanics, those that it lists with its reasons, and what nothing holds."""
    rows = list(checks)
    known = {check.unit for check in checks}
    rows += [MechanicsCheck(model.name, f.name, "", why=NOTHING_EXACT) for f in model.functions if f.name not in known]
    listed = dict(model.unheld)
    open_ = {check.unit for check in rows if check.ok is None}
    rows = [replace(check, unheld=listed.get(check.unit, "")) if check.ok is None else check for check in rows]
    rows += [
        MechanicsCheck(model.name, name, "the list of what is unheld", entry="it is held; leave it out of the list")
        for name, reason in model.unheld
        if name not in open_ and (name, reason) not in OF_F + OF_NEXT
    ]
    held = {check.unit for check in checks if check.ok is not None}
    held |= {f"{check.unit[:-1]}z" for check in checks if check.against == "z and feedback"}
    return rows + [
        MechanicsCheck(model.name, name, "", why=what, stated=True) for name, what in stated(model, held) if what
    ]


def stated(model: Model, held: set[str]) -> list[tuple[str, str]]:
    """Of what a model states itself: a word for it, and the names.  held: units that exact mechanics holds."""
    modules = (vars(earth), vars(rotation))  # the ledger of mechanics holds theirs
    ours = {one for of in modules for one in of.values() if isinstance(one, Constant)}
    own = sorted(constants_in(*(item.matrix for item in expressions(model))) - ours, key=lambda one: one.name)
    z = [f"{m.name}_z" for m in model.measurements if m.z is not None and f"{m.name}_z" not in held]
    h = [f"{m.name}_h" for m in model.measurements if m.h is not None]
    first = [name for name in ("f", "next") if getattr(model, name) is not None]
    return [
        ("equations", ", ".join((*first, *z, *h))),
        ("constants", ", ".join(f"{one.name} = {float(one):.9g} {one.unit}" for one in own)),
        ("noise", ", ".join(v.name for v in model.inputs if symbols_in(model.noise) & set(v.symbols))),
    ]
