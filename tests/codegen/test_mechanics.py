"""What a user breaks in F, G, H, feedback or strapdown is named beside exact mechanics, with its place and its size."""

import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from flint import arb
from sympy import Matrix, Rational, Symbol, diag

from boresight import report, terminal
from boresight.codegen.functions.maker import UnitMaker
from boresight.codegen.functions.reference import precise
from boresight.codegen.generate import load_model
from boresight.codegen.mechanics import Seen, check_mechanics, check_residual
from boresight.derive.ledger import numbers as ledger
from boresight.derive.mechanics import earth
from boresight.derive.mechanics.earth import ENU
from boresight.derive.mechanics.rotation import conjugate, skew
from boresight.derive.model import FirstOrder, Function, Measurement, Model, Output, Struct, constant, variable
from boresight.derive.models import variables as var

EXAMPLES = Path(__file__).parent.parent.parent / "examples"


@cache
def model(name):
    return load_model(name)


def checked(made):
    """The checks by unit, straight from the model: no C is generated for them."""
    maker = UnitMaker(made)
    reference = {
        f"{m.name}_H": maker.numeric(m.h, jacobian=True) if m.H is None else maker.numeric(m.H)
        for m in made.measurements
    }
    if made.n:
        reference["F"] = maker.numeric(made.f, jacobian=True) if made.F is None else maker.numeric(made.F)
    return {check.unit: check for check in check_mechanics(made, reference)}


def measured(made, name, **change):
    return replace(made, measurements=tuple(replace(m, **change) if m.name == name else m for m in made.measurements))


def measurement(made, name):
    return next(m for m in made.measurements if m.name == name)


def function(made, name, output, value):
    """The model with another value of one output of a function."""
    return replace(made, functions=tuple(
        replace(f, outputs=tuple(replace(o, value=value(o.value)) if o.name == output else o for o in f.outputs))
        if f.name == name else f
        for f in made.functions
    ))  # fmt: skip


@pytest.mark.parametrize("name", ["phi-error", "velocity-dcm", "euler-matching"])
def test_what_a_model_states_is_what_exact_mechanics_does(name):
    checks = checked(model(name))
    assert {"F", "G", "feedback"} <= set(checks)
    assert [check for check in checks.values() if not check.ok] == []
    assert max(check.difference for check in checks.values()) < 1e-18
    # of what F leaves out something is seen, and it is of the second order
    assert name == "euler-matching" or checks["F"].ratio == pytest.approx(0.25, rel=1e-3)
    assert name == "euler-matching" or checks["F"].coefficient > 0.01


@pytest.mark.parametrize("name", ["flexure", "scale_factors"])
def test_compositions_of_ones_own_are_what_exact_mechanics_does(name):
    made = load_model(f"{EXAMPLES / 'velocity_attitude_options.py'}:{name}")
    checks = checked(replace(made, measurements=tuple(m for m in made.measurements if m.H is not None)))
    assert {"F", "G", "feedback", "velocity_H", "dcm_H", "euler_H"} <= set(checks)
    assert [check for check in checks.values() if not check.ok] == []


def spoilt_F(name, row, column, factor):
    made = model(name)
    F = Matrix(made.F)
    F[row, column] *= factor
    return replace(made, F=F)


def without_coriolis(name):
    """F with once the Earth's rate where twice is right."""
    made = model(name)
    F, v = Matrix(made.F), [str(s) for s in made.x].index("dv_e")
    lat = next(v for v in made.inputs if v.name == "lon_lat_height").symbols[1]
    F[v : v + 3, v : v + 3] += skew(earth.omega_ie_n(lat, ENU))
    return replace(made, F=F)


def strapdown_without_coriolis():
    made = model("strapdown")
    lat, v = var.position(ENU).symbols[1], var.velocity(ENU).vector
    return function(made, "step", "v_n", lambda value: value + var.DT.scalar * skew(earth.omega_ie_n(lat, ENU)) * v)


def mounting_of_the_other_sign():
    made = model("velocity-dcm")
    law = measurement(made, "dcm").first_order
    flipped = Matrix(law.tied[0][1]).xreplace({s: -s for s in var.MU.symbols})
    return measured(made, "dcm", first_order=replace(law, tied=(("q_m2n_wxyz", flipped),)))


def twice_z(name, of):
    """h as twice z less what is left of it: its slope is right, and it is z where no error is."""
    one = measurement(model(name), of)
    return measured(model(name), of, h=one.h + one.z)


def tau(factor):
    made = measurement(model("velocity-dcm"), "velocity")
    return measured(model("velocity-dcm"), "velocity", H=made.H * diag(*[1] * 9, factor))


OTHER_WAY = {psi: -psi for psi in var.psi_angle(ENU).symbols}
BROKEN = {
    "twice the Earth's rate": (lambda: without_coriolis("azimuth-hold"), "F", r"dv_\w by dv_\w: "),
    "a sign of F": (lambda: spoilt_F("phi-error", 3, 7, -1), "F", r"dv_e by phi_n: (\S+) stated, -?(\S+) exact"),
    "a small term of F": (lambda: spoilt_F("psi-error", 5, 1, 1.001), "F", "dvc_u by d_lat"),
    "the sign of a bias": (lambda: spoilt_F("azimuth-hold", 6, 9, -1), "F", "phi_e by dbg_x"),
    "a noise put to another state": (
        lambda: replace(model("velocity-dcm"), G=model("velocity-dcm").G * diag(*[1] * 5, 2)), "G", "by accel_noise_z"),
    "the sign of a correction": (
        lambda: function(model("velocity-dcm"), "feedback", "tau", lambda v: 2 * var.TAU.vector - v),
        "feedback", "tau by d_tau: 1 stated, -1 exact"),
    "an attitude corrected the wrong way": (
        lambda: function(model("velocity-dcm"), "feedback", "q_b2n_wxyz", lambda q: q.xreplace(OTHER_WAY)),
        "F", r"by psi_\w"),
    "the column of the delay": (lambda: tau(-1), "velocity_H", "by d_tau"),
    "an h that is not zero without an error": (lambda: twice_z("velocity-dcm", "dcm_exact"), "dcm_exact_H",
                                               r"h of \w is \S+ where no error is"),
    "the sign of mu in what H is tied to": (mounting_of_the_other_sign, "dcm_H", "dcm_exact_z is .* for a mu of"),
    "Coriolis in the step": (strapdown_without_coriolis, "step", r"v_\w by t"),
    "the step turned back": (
        lambda: function(model("strapdown"), "step", "q_b2n_wxyz", lambda q: conjugate(q)), "step", "q_. by t"),
}  # fmt: skip


@pytest.mark.parametrize("what", BROKEN)
def test_what_is_broken_is_named_with_its_place(what):
    broken, unit, entry = BROKEN[what]
    check = checked(broken())[unit]
    assert check.ok is False
    assert re.search(entry, check.entry), check.entry


def test_an_error_that_both_F_and_strapdown_share_is_found_by_newtons_law():
    made = without_coriolis("azimuth-hold")
    lat, v = var.position(ENU).symbols[1], var.velocity(ENU).vector
    pull = var.DT.scalar * skew(earth.omega_ie_n(lat, ENU)) * v
    both = function(made, "strapdown", "v_n", lambda value: value + pull)
    assert checked(both)["strapdown"].ok is False


def test_where_a_model_has_no_mechanics_nothing_is_called_right():
    bare = replace(model("phi-error"), functions=(), mechanics=None, unheld=())
    checks = checked(bare)
    assert {unit: check.ok for unit, check in checks.items()} == {"F": None, "G": None, "feedback": None}
    assert checks["F"].why == "the model has no strapdown and feedback"
    without = function(model("velocity-dcm"), "feedback", "tau", lambda value: var.TAU.vector)
    assert checked(without)["F"].why == "feedback does not take out d_tau"


def test_a_rate_of_ones_own_is_the_mechanics_of_its_F(capsys):
    tank = load_model(f"{EXAMPLES / 'own_model.py'}:TANK")
    assert checked(tank)["G"].against == "each noise drives one state by itself"
    checks = checked(replace(tank, G=tank.G * diag(1, 2)))
    assert [(c.unit, c.ok) for c in checks.values()] == [("F", True), ("G", None), ("reading_H", True)]
    terminal.page(*report.verified(list(checks.values())))
    lines = capsys.readouterr().out.splitlines()
    assert next(line for line in lines if line.split()[:1] == ["G"]).endswith("not checked")
    assert lines[-1] == "verify: 2 passed, 0 failed, 1 not checked"


# ---------------------------------------------------------------- z before and after feedback


def climbing(H, z=None, **more):
    """Height and speed, a barometer, and an H by hand; no h."""
    return replace(
        load_model(f"{EXAMPLES / 'vertical.py'}:VERTICAL"),
        measurements=(Measurement("altitude", ("height",), "m", "height", z=z, H=H, **more),),
    )


HEIGHT, BARO = (Symbol(name, real=True) for name in ("height", "baro"))
Z = Matrix([HEIGHT - BARO])


@pytest.mark.parametrize("H, right", [((1, 0, 0), True), ((-1, 0, 0), False), ((1, 0.001, 0), False)])
def test_an_H_of_a_measured_value_is_held_by_z_before_and_after_feedback(H, right):
    check = checked(climbing(Matrix([H]), Z))["altitude_H"]
    assert check.against == "z and feedback"
    assert check.ok is right
    assert right or "; baro kept constant, as a measured value is" in check.entry


def test_where_the_caller_brings_z_the_row_names_first_order():
    check = checked(climbing(Matrix([[1, 0, 0]])))["altitude_H"]
    assert check.ok is None
    assert check.why == "it has no z, which the caller brings; state an h beside H, with first_order=FirstOrder()"
    h = Matrix([Symbol("d_height", real=True)])
    for H, right in (((1, 0, 0), True), ((-1, 0, 0), False)):
        tied = checked(climbing(Matrix([H]), h=h, first_order=FirstOrder()))["altitude_H"]
        assert (tied.against, tied.ok) == ("h", right)


@pytest.mark.parametrize("name, model_name", [("zaru", "azimuth-hold"), ("velocity", "velocity-dcm")])
def test_a_rate_without_its_bias_follows_the_estimate_of_the_bias(name, model_name):
    bare = measured(model(model_name), name, h=None, first_order=None)
    check = checked(bare)[f"{name}_H"]
    # the delay is known to h alone, and z does not read it
    assert check.ok is (name == "zaru"), check.entry
    if name == "zaru":
        H = Matrix(measurement(bare, name).H)
        H[0, 9] = -H[0, 9]
        assert re.search(r"x by dbg_x: 1 stated, -1 exact", checked(measured(bare, name, H=H))["zaru_H"].entry)
        without = replace(bare, mechanics=replace(bare.mechanics, step=()))
        assert "omega_ib_b kept constant" in checked(without)["zaru_H"].entry


def test_every_H_of_the_autopilot_is_held_by_z_and_feedback():
    whole = load_model(f"{EXAMPLES / 'autopilot.py'}:AUTOPILOT")
    by_hand = tuple(replace(m, h=None, first_order=None) for m in whole.measurements)  # as if somebody had written H
    checks = checked(replace(whole, measurements=by_hand))
    of_H = [check for unit, check in checks.items() if unit.endswith("_H")]
    assert len(of_H) == 10
    assert [(check.against, check.ok) for check in of_H] == [("z and feedback", True)] * 10


def test_a_heading_that_passes_south_is_less_whole_turns():
    made = load_model(f"{EXAMPLES / 'autopilot.py'}:AUTOPILOT")
    seen = Seen(made, next(m for m in made.measurements if m.name == "yaw"))
    with precise():
        assert abs(float(seen.less_turns(ledger.Matrix([2 * arb.pi() - arb("1e-9")]))[0]) + 1e-9) < 1e-20
        assert not seen.less_turns(ledger.Matrix([arb("nan")]))[0].is_finite()


# ---------------------------------------------------------------- what is right and has another form


def ship(by=1, unit="m"):
    """A ship on a meridian whose error of the latitude is in metres, or in rad."""
    radius = constant("R", "6378137", "m", "radius of a sphere")
    lat = variable("lat", "lat", "rad", "latitude", -1.5, 1.5)
    speed = variable("v", "v", "m/s", "speed north", -100.0, 100.0)
    d_north = variable("d_north", "d_north", unit, "error of the place", -1e3, 1e3, wide=True)
    dv = variable("dv", "dv", "m/s", "error of the speed", -10.0, 10.0)
    dt = variable("dt", "dt", "s", "step", 1e-3, 0.1)
    noise = variable("n", "n", "m/s/sqrt(s)", "noise density", 0.0, 1.0)
    length = radius if unit == "m" else 1
    return Model(
        name="ship", c_prefix="sh", title="a ship on a meridian", frame="none", states=(d_north, dv),
        structs=(Struct("nav", "carried", (lat, speed)), Struct("step", "one step", (dt, noise))),
        F=Matrix([[0, length / radius], [0, 0]]), G=Matrix([0, 1]), noise=noise.vector, dt=dt.scalar,
        measurements=(Measurement("place", ("lat",), "rad", "place", H=Matrix([[1 / length, 0]]), z=lat.vector),),
        functions=(
            Function("strapdown", "one step", (
                Output("lat", lat.vector + speed.vector * dt.scalar / radius, "rad", "latitude"),)),
            Function("feedback", "errors out", (
                Output("lat", lat.vector - by * d_north.vector / length, "rad", "latitude"),
                Output("v", speed.vector - dv.vector, "m/s", "speed"))),
        ),
    )  # fmt: skip


def test_an_error_in_another_unit_than_its_estimate_is_held_by_what_reads_it_out():
    assert [check for check in checked(ship()).values() if not check.ok] == []
    wrong = checked(ship(-1))
    assert wrong["feedback"].ok
    assert wrong["F"].ok is False and wrong["place_H"].ok is False


def test_an_error_in_the_unit_of_its_estimate_is_computed_minus_true():
    assert checked(ship(unit="rad"))["feedback"].ok
    assert checked(ship(-1, "rad"))["feedback"].entry == "lat by d_north: 1 stated, -1 exact"


def driven(noise):
    """velocity-dcm with no word of what this noise adds to."""
    made = model("velocity-dcm")
    kept = tuple(pair for pair in made.mechanics.driven if pair[0].name != noise)
    return replace(made, mechanics=replace(made.mechanics, driven=kept))


def test_a_noise_that_is_said_to_add_to_nothing_is_not_held_and_the_remedy_is_named():
    check = checked(driven("gyro_noise"))["G"]
    assert check.ok is None
    assert (
        check.why == "gyro_noise is not said to add to anything; state driven=((gyro_noise, dtheta_ib_b),) of Mechanics"
    )
    assert checked(model("velocity-dcm"))["G"].ok


def test_what_is_wrong_beside_a_noise_that_is_not_held_is_named_still():
    made = driven("gyro_noise")
    check = checked(replace(made, G=made.G * diag(*[1] * 5, 2)))["G"]
    assert check.ok is False
    assert "by accel_noise_z" in check.entry


def test_a_noise_that_drives_one_state_by_itself_needs_no_word():
    made = model("azimuth-hold")
    made = replace(made, mechanics=replace(made.mechanics, driven=made.mechanics.driven[:2]))
    names = {noise.name for noise, _ in made.mechanics.driven}
    assert "gyro_bias_noise" not in names
    assert checked(made)["G"].ok
    twice = replace(made, G=made.G * diag(*[1] * 11, 2))
    assert checked(twice)["G"].why.startswith("accel_bias_noise is not said to add to anything")


@pytest.mark.parametrize(
    ("file", "name", "row", "factor"),
    [("vertical.py:VERTICAL", "altitude", 0, 1000), ("vertical.py:VERTICAL", "altitude", 0, Rational(1, 1000)),
     ("gnss_ins.py:GNSS_INS", "velocity", 2, -1)],
)  # fmt: skip
def test_an_h_of_another_size_or_sign_than_its_z_is_wrong(file, name, row, factor):
    made = load_model(f"{EXAMPLES / file.split(':')[0]}:{file.split(':')[1]}")
    h = Matrix(measurement(made, name).h)
    h[row] *= factor
    wrong = measured(made, name, h=h)
    check = check_residual(wrong, measurement(wrong, name))
    assert check.unit == f"{name}_z" and check.ok is False


def test_a_z_that_errs_in_what_it_neglects_is_wrong():
    made = model("euler-matching")
    z = Matrix(measurement(made, "euler").z)
    z[0] += next(v for v in made.inputs if v.name == "mu").symbols[1] / 2
    check = checked(measured(made, "euler", z=z))["euler_H"]
    assert check.ok is False and check.entry.startswith("euler_z is")
