"""The C of a function hangs on what that function reads: a neighbour in the model changes no byte of it."""

from dataclasses import replace

import pytest
from sympy import Matrix

from boresight.codegen.functions.maker import UnitMaker
from boresight.codegen.functions.units import measurement
from boresight.codegen.generate import load_model
from boresight.codegen.text.files import folder_files
from boresight.codegen.text.views import unit_hash
from boresight.derive.mechanics.rotation import dcm_from_quaternion, skew
from boresight.derive.model import Function, Measurement, Model, Output, Struct, variable
from boresight.derive.models.velocity_attitude import DV, PHI, V_N, Q
from boresight.runtime.manifest import folder_of, read_manifest

PAIRS = 12
level = variable("level", "left right", "m", "levels of two tanks", -1.0, 1.0)
dt = variable("dt", "dt", "s", "length of the step", 1e-3, 1.0)
noise = variable("noise", "w", "m/sqrt(s)", "noise density", 0.0, 1.0)
left = variable("left", " ".join(f"a_{k}" for k in range(PAIRS)), "1", "numbers", 1.0, 3.0)
right = variable(
    "right", " ".join(f"b_{k}" for k in range(PAIRS)), "1", "numbers", [2.3 + 0.1 * k for k in range(PAIRS)], 8.0
)
odometer = variable("odometer", "odometer", "m/s", "speed along the front axis, measured", -100.0, 100.0)

# Of two that are equal the second is printed as the first unless that rounds more at one of the points: most rarely do.
DIFFERENCES = [
    form for a, b in zip(left.symbols, right.symbols, strict=True) for form in (a**2 - b**2, (a - b) * (a + b))
]

TANKS = Model(
    name="tanks",
    c_prefix="tk",
    title="two tanks, 2 states",
    frame="none",
    states=(level,),
    structs=(Struct("step", "one step", (dt, noise)), Struct("numbers", "numbers", (left, right))),
    f=-level.vector / dt.scalar,
    G=Matrix([1, 1]),
    noise=noise.vector,
    dt=dt.scalar,
    measurements=(Measurement("gauge", ("left", "right"), "m", "levels", h=level.vector),),
    functions=(Function("differences", "differences", (Output("d", Matrix(DIFFERENCES), "1", "differences"),)),),
)
WHEEL = Struct("wheel", "what the wheel measures", (odometer,))


def printed(model):
    """The C of a model but for its self-tests."""
    _, files = folder_files(model, kept=lambda test, tested: "left out")
    return {path: text for path, text in files.items() if path.startswith(("src/", "include/", "casadi/"))}


@pytest.mark.parametrize("first", [False, True], ids=["behind", "in front"])
def test_another_measurement_changes_no_other_function_of_the_model(first):
    def placed(old, new):
        return (new, *old) if first else (*old, new)

    roll = Measurement("roll", ("left",), "m", "distance", h=level.vector[:1, :] + odometer.vector * dt.scalar)
    more = replace(TANKS, structs=placed(TANKS.structs, WHEEL), measurements=placed(TANKS.measurements, roll))
    before, after = printed(TANKS), printed(more)
    changed = {path for path in before if after[path] != before[path]}
    whole = {"include/tanks.h", "include/tanks_filter.h", "include/tanks_identity.h", "src/tk_filter.c"}
    assert changed <= whole, changed - whole
    assert {path.split("/")[1] for path in after.keys() - before.keys() if path.startswith("src/")} == {
        f"tk_roll_{part}{end}" for part in ("hx", "H") for end in (".c", "_kernel.h")
    }


def test_another_state_changes_no_function_that_does_not_read_it():
    other = variable("other", "other", "m", "level of a third tank", -1.0, 1.0)
    f, G = Matrix([other.scalar / dt.scalar, *TANKS.f]), Matrix([1, 1, 1])
    before, after = printed(TANKS), printed(replace(TANKS, states=(other, level), f=f, G=G))
    assert [path for path in before if "differences" in path and after[path] != before[path]] == []


def test_an_odometer_changes_no_other_measurement_of_velocity_attitude():
    """That of the attitude by a quaternion, where two forms of one value are nearest to each other."""
    model = load_model("velocity-attitude")
    front = dcm_from_quaternion(Q.vector).T[0, :]
    assert model.states[:2] == (PHI, DV)
    H = Matrix([[*(-front * skew(V_N.vector)), *front, *[0] * (model.n - 6)]])
    more = replace(
        model,
        structs=(*model.structs, WHEEL),
        measurements=(
            *model.measurements,
            Measurement("odometer", ("front",), "m/s", "speed along the front axis: z = computed - measured",
                        z=front * V_N.vector - odometer.vector, H=H),
        ),
    )  # fmt: skip
    maker = UnitMaker(more)
    quaternion = next(m for m in more.measurements if m.name == "quaternion")
    committed = read_manifest(folder_of("velocity-attitude"))["units"]
    for unit in measurement(maker, quaternion):
        assert unit_hash(unit) == committed[unit.name]["hash"], unit.name
