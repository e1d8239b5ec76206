"""verify says what it did not hold: by its rows, by its exit status, and against the list of the model."""

from dataclasses import replace

import pytest
from conftest import ROOT
from sympy import Matrix
from test_mechanics import climbing, model
from typer.testing import CliRunner

from boresight import BoresightError, cli, report, terminal
from boresight.codegen import verify as v
from boresight.codegen.functions.units import units
from boresight.codegen.generate import load_model
from boresight.codegen.mechanics import MechanicsCheck
from boresight.codegen.unheld import with_unheld
from boresight.derive.model import Function, Output
from boresight.derive.models import MODELS, built_in

EXAMPLES = {
    "vertical.py": "VERTICAL",
    "pendulum.py": "PENDULUM",
    "radar.py": "RADAR",
    "gnss_ins.py": "GNSS_INS",
    "autopilot.py": "AUTOPILOT",
    "own_model.py": "TANK",
}
VERTICAL = f"{ROOT / 'examples' / 'vertical.py'}:VERTICAL"


def held(made):
    """Every row of the model against mechanics; no C is made of it."""
    return v.laws(made, units(made))


def rows(made):
    return {check.unit: check for check in held(made)}


@pytest.mark.parametrize("file", EXAMPLES)
def test_all_of_an_example_is_held_or_listed_with_its_reason(file):
    checks = held(load_model(f"{ROOT / 'examples' / file}:{EXAMPLES[file]}"))
    assert [check for check in checks if check.ok is not True] == []
    assert v.status(checks) == 0


@pytest.mark.parametrize("name", MODELS)
def test_each_function_of_a_model_is_a_row_or_listed(name):
    made = built_in(name)
    checked = [MechanicsCheck(made.name, unit, "", 0.0) for unit in ("F", "G", "feedback")]
    listed = {check.unit for check in with_unheld(made, checked)}
    assert {f.name for f in made.functions} <= listed


def test_a_function_that_nothing_holds_is_no_right_and_the_status_says_so():
    made = replace(load_model(VERTICAL), unheld=())
    more = Function("twice", "the double height", (Output("twice", Matrix([2 * made.inputs[0].scalar]), "m", "it"),))
    checks = held(replace(made, functions=(*made.functions, more)))
    lost = {check.unit: check.why for check in checks if check.ok is None}
    nothing = "verify knows nothing exact to hold it against"
    assert lost == {"strapdown": nothing, "twice": nothing}
    assert v.status(checks) == 3
    wrong = MechanicsCheck("vertical", "F", "", entry="a sign")
    assert v.status([*checks, wrong]) == 1


def test_what_is_listed_counts_as_held_but_not_strictly():
    checks = held(load_model(VERTICAL))
    assert v.counted(checks) == {"passed": len(held_rows(checks)), "failed": 0, "not checked": 0, "listed": 1}
    assert (v.status(checks), v.status(checks, strict=True)) == (0, 3)
    without = [check for check in checks if not check.unheld]
    assert v.status(without, strict=True) == 0


def held_rows(checks):
    return [check for check in checks if not check.why]


def test_a_list_that_names_what_is_held_fails():
    made = replace(load_model(VERTICAL), unheld=(("strapdown", "mine"), ("F", "mine too")))
    wrong = [check for check in held(made) if check.ok is False]
    assert [(check.unit, check.entry) for check in wrong] == [("F", "it is held; leave it out of the list")]


@pytest.mark.parametrize("unheld, message", [
    ((("strapdwn", "mine"),), r"unheld names 'strapdwn', which verify does not know \(did you mean 'strapdown'\?\)"),
    ((("strapdown", " "),), "unheld gives no reason for 'strapdown'"),
    ((("F", "a"), ("F", "b")), "unheld names 'F' twice"),
])  # fmt: skip
def test_a_list_that_says_nothing_is_refused(unheld, message):
    with pytest.raises(BoresightError, match=message):
        replace(load_model(VERTICAL), unheld=unheld)


def test_a_larger_model_keeps_the_list():
    assert dict(built_in("velocity-attitude-lever").unheld).keys() == {"expected"}
    grown = load_model(VERTICAL).extend(name="larger", c_prefix="la", unheld=(("altitude_H", "mine"),))
    assert [name for name, _ in grown.unheld] == ["strapdown", "altitude_H"]


def test_constants_noise_and_equations_that_nothing_holds_are_named():
    named = {check.unit: check.why for check in held(load_model(VERTICAL)) if check.stated}
    assert named == {
        "equations": "altitude_h",
        "constants": "g = 9.81 m/s^2",
        "noise": "accel_noise, bias_noise",
    }
    assert "constants" not in rows(model("phi-error"))  # those of the Earth have a ledger


def test_a_z_of_the_other_sign_than_h_is_found():
    made = load_model(VERTICAL)
    (altitude,) = made.measurements
    assert rows(made)["altitude_z"].ok
    turned = replace(made, measurements=(replace(altitude, z=-altitude.z),))
    check = rows(turned)["altitude_z"]
    assert (check.ok, check.entry) == (False, "height falls where h grows; z is computed - measured")
    # what z does not read of the estimates says nothing
    (baro,) = made.structs[-1].fields
    brought = replace(made, measurements=(replace(altitude, z=baro.vector),))
    assert "altitude_z" not in rows(brought)


def test_the_table_says_what_is_listed_and_stated(capsys):
    terminal.page(*report.verified(held(load_model(VERTICAL))))
    lines = capsys.readouterr().out.splitlines()
    assert any(line.split()[:1] == ["strapdown"] and line.endswith("listed") for line in lines)
    assert any(line.split()[:1] == ["constants"] and line.endswith("stated") for line in lines)
    assert lines[-1] == "verify: 10 passed, 0 failed, 1 listed"


@pytest.mark.parametrize("words, status", [([], 0), (["--strict"], 3)])
def test_the_exit_status_of_the_command(words, status, monkeypatch):
    monkeypatch.setattr(v, "verify_all", lambda *_, **__: held(load_model(VERTICAL)))
    assert CliRunner().invoke(cli.app, ["verify", "vertical", *words, "--json"]).exit_code == status


def test_a_measurement_without_z_is_listed_by_its_H():
    made = replace(
        climbing(Matrix([[1, 0, 0]])), unheld=(("altitude_H", "the barometer is mine"), ("strapdown", "mine"))
    )
    checks = held(made)
    assert v.status(checks) == 0
    assert next(check for check in checks if check.unit == "altitude_H").unheld == "the barometer is mine"
