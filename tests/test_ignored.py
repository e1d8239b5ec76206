"""What a public name would take and ignore is refused in one line; and what a library and a page show of a model."""

import re

import numpy as np
import pytest
from conftest import ROOT
from sympy import Matrix

from boresight import (
    BoresightError,
    Consistency,
    Experiment,
    Measurement,
    Model,
    Struct,
    generate,
    load,
    many,
    variable,
    verify,
)


def model(**changes):
    place = variable("place", "x", "m", "place on the line", -100.0, 100.0)
    dt = variable("dt", "dt", "s", "length of the step", 1e-3, 1.0)
    walk = variable("walk", "q", "m/sqrt(s)", "noise density of the place", 0.0, 1.0)
    parts = {
        "name": "walker", "c_prefix": "wk", "title": "a walk on a line, 1 state", "frame": "none",
        "states": (place,), "structs": (Struct("step", "one step", (dt, walk)),),
        "f": Matrix([0]), "G": Matrix([1]), "noise": walk.vector, "dt": dt.scalar,
        "measurements": (Measurement("fix", ("x",), "m", "the place that is read", h=place.vector),),
    }  # fmt: skip
    return Model(**parts | changes)


def test_an_input_does_not_wrap():
    yaw = variable("yaw", "yaw", "rad", "heading", -4.0, 4.0, wraps=True)
    structs = (*model().structs, Struct("more", "another input", (yaw,)))
    with pytest.raises(BoresightError, match="variable yaw: only a state wraps"):
        model(structs=structs)


@pytest.mark.parametrize("choice", [{"backend": "casadi"}, {"precision": "float"}])
def test_lanes_belong_to_the_flight_c_in_double(choice):
    with pytest.raises(BoresightError, match="several lanes are of the flight C in double; leave lanes=4 out"):
        load("euler-matching", lanes=4, **choice)


def test_processes_and_a_cluster_are_not_both_taken():
    walk = Experiment("walk", "euler-matching", {"error": "m"}, lambda *given: np.zeros((1, 1)))
    with pytest.raises(BoresightError, match="leave one of them out"):
        many(walk, runs=1, jobs=2, dask="tcp://127.0.0.1:1")


def test_consistency_refuses_errors_of_another_number_of_states():
    judged = Consistency({"height, m": 1.0, "speed, m/s": 1.0})
    with pytest.raises(BoresightError, match=r"error has shape \(3, 1\).*must be \(..., 2\)"):
        judged.error(0.0, np.zeros((3, 1)), np.eye(2))
    with pytest.raises(BoresightError, match=r"P \(3, 3\)"):
        judged.error(0.0, np.zeros((3, 2)), np.eye(3))
    assert judged.times == []


def test_verify_wants_at_least_one_point_and_a_model():
    for points in (0, -1, 2.5):
        with pytest.raises(BoresightError, match="points is"):
            verify("euler-matching", points=points)
    with pytest.raises(BoresightError, match=r"7 is no model; give a built-in name, FILE\.py:NAME or a Model"):
        generate(7)


def test_a_library_shows_model_states_and_functions(library):
    assert repr(library).startswith("<euler-matching, double: states eps_n, eps_e, eps_d, dmu_x")
    assert "euler_H" in repr(library)


def test_the_page_of_an_own_model_names_the_command_that_holds_it(folder_of):
    from boresight.derive.pages.model import model_page
    from boresight.runtime.manifest import read_manifest

    target = f"{ROOT / 'tests' / 'pendulum.py'}:PENDULUM"
    from boresight.codegen.generate import load_model

    shown = str(model_page(load_model(target), read_manifest(folder_of(target)), target))
    held = set(re.findall(r"boresight verify ([^\s',\"]+)", shown))
    assert held == {target}
