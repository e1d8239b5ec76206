"""Bad input is refused, whichever number it is in, and nothing is written."""

import json
import re
import shutil

import pytest
from committed import LIVE, NAMES, committed, comparable, folder_of, spoilt
from conftest import ROOT

from boresight.codegen.folder import Folder
from boresight.codegen.generate import generate
from boresight.evidence.guards import guards


@pytest.mark.parametrize("name", NAMES)
def test_every_bad_input_is_refused_and_every_guard_is_taken(name):
    found = committed(name, "guards")
    units = {unit.name: unit.described for unit in folder_of(name).units}
    assert set(found) == set(units)
    assert all(of["tried"] for unit, of in found.items() if units[unit] is not None)
    wrong = {unit: of["wrong"][:5] for unit, of in found.items() if of["wrong"]}
    assert not wrong, wrong
    # A function without arguments cannot fail; what the tests of the loops leave out is listed in the results.
    read = {unit for unit, described in units.items() if described is not None and described["fields"]}
    left = {unit: of["not_taken"][:5] for unit, of in found.items() if unit in read and of["not_taken"]}
    assert not left, left


@pytest.mark.digits
def test_a_live_run_finds_what_is_committed(tmp_path):
    assert guards(folder_of(LIVE), tmp_path) == comparable(LIVE, "guards")


CHECK = "    status = bs_check(imu->dtheta_ib_b"
SPOILT = [  # a file, what is written instead of what, and of which unit which word then says so
    (
        "src/sd_earth.c",
        "BS_REAL(-1.4835298641951802)",
        "BS_REAL(-1.5)",
        "sd_earth",
        r"lon_lat_height\[1\] -1\.4\S+: status 0,",
    ),
    ("src/sd_rates.c", "v_n_high, 3)", "v_n_high, 2)", "sd_rates", r"v_n\[2\] nan: status 0,"),
    ("src/sd_compensated.c", CHECK, f"    dv_b[0] = 0;\n{CHECK}", "sd_compensated", "an output was touched"),
    ("include/boresight.h", "return BS_NOT_FINITE;", "status = BS_OUT_OF_RANGE;", "sd_step", "nan: status 3, not 2"),
]


@pytest.fixture(scope="module")
def lets_pass(tmp_path_factory):
    """What is found of a folder that is spoilt in four places."""
    copy = shutil.copytree(folder_of(LIVE).path, tmp_path_factory.mktemp("spoilt") / LIVE)
    for path, right, wrong, _, _ in SPOILT:
        folder = spoilt(copy, path, right, wrong)
    return guards(folder, tmp_path_factory.mktemp("guards"))


@pytest.mark.parametrize(("path", "right", "wrong", "unit", "word"), SPOILT)
def test_a_guard_that_lets_something_pass_is_seen(path, right, wrong, unit, word, lets_pass):
    said = {name for name, of in lets_pass.items() if any(re.search(word, found) for found in of["wrong"])}
    assert unit in said and ("boresight.h" in path or said == {unit})


def test_a_point_is_refused_as_not_finite_only_where_the_formulas_have_no_value(tmp_path):
    """A tank runs dry within its step: 349 of 4000; where the C takes the root of what is 1 m lower, not only there."""
    target = f"{ROOT / 'examples' / 'own_model.py'}:TANK"
    generate(target, tmp_path / "tank")
    of = guards(Folder(tmp_path / "tank", target), tmp_path / "right", {"tk_next"})["tk_next"]
    assert not of["wrong"] and [re.match(r"\w+, \d+ of 4000", left)[0] for left in of["no_value"]]
    kernel = tmp_path / "tank" / "src" / "tk_next_kernel.h"
    kernel.write_text(kernel.read_text().replace("BS_SQRT(x[0])", "BS_SQRT(x[0] - BS_REAL(1.0))"))
    folder = Folder(tmp_path / "tank", target)
    folder.__dict__["manifest"] = json.loads((tmp_path / "tank" / "manifest.json").read_text())
    wrong = guards(folder, tmp_path / "wrong", {"tk_next"})["tk_next"]["wrong"]
    assert len(wrong) == 2 and all("points of the box that have a value are refused" in line for line in wrong)
