"""The step of a total state by loops over f, F and Qc: that of the printed next, Phi and Q, in less code."""

import json

import numpy as np
import pytest
from building import passed, run
from conftest import ROOT

from boresight import BoresightError
from boresight.codegen.export import export
from boresight.codegen.generate import generate
from boresight.runtime.filter import CompiledFilter, Filter
from boresight.runtime.library import load

# The pendulum of the examples, its noise at Radau's two nodes apart.
SWING = (
    (ROOT / "examples" / "pendulum.py")
    .read_text(encoding="utf-8")
    .replace("    dt=dt.scalar,", "    dt=dt.scalar,\n    loops=True,")
    .replace("Matrix([0, 1])", "Matrix([0, 1 + theta**2 / 8])")
)
GIVEN = {"rod": [1.0, 0.1], "torque": 0.1}


@pytest.fixture(scope="module")
def swing(tmp_path_factory):
    folder = tmp_path_factory.mktemp("swing")
    (folder / "swing.py").write_text(SWING, encoding="utf-8")
    generate(f"{folder / 'swing.py'}:PENDULUM", folder / "made")
    return folder


def test_loops_fly_what_the_printed_units_do_to_rounding(swing):
    library = load(swing / "made")
    printed, looped = (kind(library, {}, np.diag([1e-2, 1e-3]), x=[2.0, 1.0]) for kind in (Filter, CompiledFilter))
    for _ in range(60):  # over the top
        for loop in (printed, looped):
            loop.predict(dt=0.05, **GIVEN)
        np.testing.assert_allclose(looped.x, printed.x, rtol=0, atol=1e-12)
        sigma = np.sqrt(np.diag(printed.P))
        np.testing.assert_allclose(looped.P / np.outer(sigma, sigma), printed.P / np.outer(sigma, sigma), atol=1e-11)
    assert looped.x.tobytes() != printed.x.tobytes()  # so they are two


def test_a_step_by_loops_that_leaves_the_box_changes_nothing(swing):
    loop = CompiledFilter(load(swing / "made"), {}, np.eye(2), x=[-1.5, 19.9])
    with pytest.raises(BoresightError, match="leaves its box or is no number"):
        loop.predict(dt=0.1, **GIVEN)
    assert (loop.x.tolist(), loop.P.tolist()) == ([-1.5, 19.9], np.eye(2).tolist())


def test_an_exported_filter_of_loops_agrees_with_the_printed_units_on_the_target(swing, tmp_path):
    for precision, *goals in (("double", "test", "example"), ("float", "test")):
        export(f"{swing / 'swing.py'}:PENDULUM", tmp_path / precision, precision, swing / "made")
        done = run("make", "-C", tmp_path / precision, "CFLAGS=-O0", *goals)
        assert done.returncode == 0, done.stdout + done.stderr
        assert passed(tmp_path / precision) in done.stdout
        assert ("60 s flown; state and sigmas within" in done.stdout) == ("example" in goals)


def test_manifest_and_header_tell_of_the_loops(swing):
    manifest = json.loads((swing / "made" / "manifest.json").read_text())
    assert manifest["filter"]["propagate"]["loops"] is True
    assert {"f", "F", "Qc"} <= manifest["units"].keys()
    header = (swing / "made" / "include" / "pendulum_filter.h").read_text()
    assert "loops over pd_f, pd_F and pd_Qc" in header
    source = (swing / "made" / "src" / "pd_filter.c").read_text()
    assert not [name for name in ("pd_next(", "pd_Phi", "pd_Q(", "pd_Q_nz(") if name in source]
