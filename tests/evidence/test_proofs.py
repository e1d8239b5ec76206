"""Rounding over the whole box: the committed bounds are of the lists that are printed, are proved again for small
lists, and fail for a list with another constant."""

import functools
import re
from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from committed import folder_of
from tools import needs

from boresight.codegen.folder import folders
from boresight.codegen.functions.tape import Step, Tape, computed
from boresight.codegen.functions.units import units
from boresight.codegen.generate import load_model
from boresight.codegen.text.views import unit_hash
from boresight.derive.model import Variable
from boresight.evidence.calls import call, callable_units, points_of, shared_library
from boresight.evidence.proofs import coq, forms, kept, prover, script, search
from boresight.evidence.results import OPEN
from boresight.evidence.targets import GCC, compile_units

MODELS = [folder for folder in folders() if kept.wanted(folder)]
OUTPUTS = [output for folder in MODELS for unit in kept.judged(folder).values() for output in unit]
SMALL = ("em_Phi", "em_euler_H")  # lists whose bounds are proved again here


@functools.cache
def small(name):
    """(folder, source, unit, committed outputs in the order of the results) of a small list."""
    folder = next(f for f in MODELS if any(source.name == name for source in f.units))
    source = next(source for source in folder.units if source.name == name)
    unit = next(u for u in units(load_model(folder.manifest["model"])) if u.name == source.described["name"])
    return folder, source, unit, kept.outputs(kept.read(folder)[name])


@pytest.mark.parametrize("folder", MODELS, ids=lambda folder: folder.name)
def test_bounds_are_of_the_lists_and_boxes_that_are_committed(folder):
    found, other = kept.read(folder), kept.of_another_list(folder)
    line = f"proofs of {folder.name}: {', '.join(other)}"
    assert not other or line in OPEN.read_text().splitlines(), "run 'make proofs'"
    for source in kept.wanted(folder):
        if source.name in other or source.name not in found:
            continue
        nonzeros = sum(result["nonzeros"] for result in source.described["results"])
        assert len(found[source.name]["outputs"]) == nonzeros, source.name


def test_no_bounds_are_of_a_folder_that_is_gone():
    assert {path.stem for path in kept.PLACE.glob("*.json")} <= {folder.name for folder in MODELS}


def test_seven_outputs_of_ten_are_bounded_and_of_these_95_of_100_within_ten_times_the_worst_error_found():
    bounded = [output for output in OUTPUTS if output.bounded]
    assert len(bounded) >= 0.7 * len(OUTPUTS)
    assert sum(output.tight for output in bounded) >= 0.95 * len(bounded)


def test_only_long_lists_of_the_largest_model_are_not_tried():
    untried = {source.folder.name for folder in MODELS for source in kept.wanted(folder) if not kept.tried(source)}
    assert untried == {"velocity_attitude_sensors"}


def test_no_error_found_is_beyond_its_bound():
    assert [output for output in OUTPUTS if output.bound is not None and not output.found <= output.bound] == []


def test_what_has_no_bound_says_why_and_nothing_else_does():
    assert all((output.bound is None) == bool(output.why) for output in OUTPUTS)


@needs("gappa")
@pytest.mark.parametrize("name", SMALL)
def test_the_committed_bounds_of_a_small_list_are_proved_again(name):
    _, source, unit, outputs = small(name)
    assert unit_hash(unit) == source.described["hash"]
    for (_, _, position), output in zip(sorted(unit.tape.results), outputs, strict=True):
        assert prover.holds(unit.tape, position, unit.args, output.bound), output
        if output.bound:
            assert not prover.holds(unit.tape, position, unit.args, output.bound / 2), output


@needs("gappa")
def test_a_changed_constant_breaks_the_proof(monkeypatch):
    # C with a literal that is off by a thousandth, against the list as it is meant
    _, _, unit, outputs = small("vd_F")
    true = script.literal

    def off(made, k, constant):
        true(made, k, constant)
        made.lines += [f"c{k} = {float(np.float32(constant * 1.001)).hex()};"]
        made.pairs[k] = (f"c{k}", made.pairs[k][1])

    steps, found = unit.tape.steps, sorted(unit.tape.results)
    # a constant of the Earth in every one of these; the constants 1 and 2 of the others may cancel
    tried = [
        (position, output)
        for (_, _, position), output in zip(found, outputs, strict=True)
        if any(steps[k].op == "const" and steps[k].constant > 1e6 for k in script.cone(unit.tape, position))
    ]
    assert len(tried) > 5
    assert all(prover.holds(unit.tape, position, unit.args, output.bound) for position, output in tried)
    monkeypatch.setattr(script, "literal", off)
    assert not any(prover.holds(unit.tape, position, unit.args, output.bound) for position, output in tried)


def test_a_changed_constant_or_box_changes_the_hash_that_bounds_hang_on():
    _, source, unit, _ = small("vd_F")
    steps = list(unit.tape.steps)
    k = next(k for k, step in enumerate(steps) if step.op == "const")
    steps[k] = replace(steps[k], constant=steps[k].constant * 1.001)
    other = replace(unit)
    other.__dict__["tape"] = replace(unit.tape, steps=tuple(steps))
    assert unit_hash(other) != source.described["hash"]
    arg = unit.args[0]
    wider = replace(unit, args=(replace(arg, high=tuple(2 * v for v in arg.high)), *unit.args[1:]))
    assert unit_hash(wider) != source.described["hash"]


def test_the_list_in_single_precision_is_the_compiled_c_bit_for_bit(tmp_path):
    folder = folder_of("euler_matching")
    objects = compile_units(folder, GCC, "float", tmp_path, "-O0")
    compiled = callable_units(folder, shared_library(folder, "float", tmp_path, objects), "float")
    for name in ("em_Phi", "em_Qc"):  # no sine in them
        _, source, unit, _ = small(name)
        points = points_of(source, 500, 100, np.random.default_rng(5))
        points = {key: values.astype(np.float32).astype(float) for key, values in points.items()}
        outputs, status = call(compiled[name], points)
        assert (status == 0).sum() > 300
        single = search.in_single(unit.tape, [points[arg.name] for arg in unit.args])
        for o, k, position in unit.tape.results:
            row, column = unit.results[o].nonzeros[k]
            got = outputs[o][status == 0, row * unit.results[o].shape[1] + column]
            assert np.array_equal(got, single[position][status == 0])


@pytest.mark.parametrize(
    ("model", "name"), [("azimuth-hold", "azimuth_z"), ("velocity-dcm", "dcm_z"), ("azimuth-hold", "zaru_z")]
)
def test_forms_of_quaternions_stay_in_their_range_and_some_reach_it(model, name):
    unit = next(u for u in units(load_model(model)) if u.name == name)
    rng = np.random.default_rng(3)
    inputs = []
    for arg in unit.args:
        values = rng.uniform(arg.low, arg.high, (20_000, arg.size))
        if arg.norm:
            values = rng.standard_normal(values.shape)
            values *= rng.uniform(*arg.norm, (len(values), 1)) / np.linalg.norm(values, axis=1, keepdims=True)
        inputs.append(values)
    values = computed(unit.tape, inputs)
    within = forms.ranges(unit.tape, unit.args)
    assert len(within) > 20
    for k, (low, high) in within.items():
        assert low <= values[k].min() and values[k].max() <= high, k
    reached = Counter(bool(values[k].max() > 0.8 * high) for k, (_, high) in within.items())
    assert reached[True] > len(within) / 2


def test_the_range_of_a_sine_holds_it():
    rng = np.random.default_rng(4)
    for low, width in rng.uniform((-7, 0), (7, 7), (500, 2)):
        at = np.linspace(low, low + width, 200)
        for op, function in (("sin", np.sin), ("cos", np.cos)):
            least, most = script.extremes(op, low, low + width)
            assert least <= function(at).min() and function(at).max() <= most
            assert most - function(at).max() < 1e-2 and function(at).min() - least < 1e-2


@needs("gappa", "coqc")
def test_coq_accepts_a_proof_and_refuses_a_broken_one():
    # x y / y^2: the product may vanish, so that the proof needs what it is told of quotients
    steps = (
        Step("input", source=(0, 0)), Step("input", source=(0, 1)), Step("mul", (0, 1)), Step("sq", (1,)),
        Step("div", (2, 3)),
    )  # fmt: skip
    args = (Variable("v", sp.symbols("x y"), "1", "", (-3.0, 1.0), (3.0, 2.0)),)
    tape = Tape(steps, ((0, 0, 4),))
    text = coq.proof(tape, 4, args, prover.bound(tape, 4, args))
    assert "Lemma a1 : " in text and coq.accepts(text)
    for word in ("Hypothesis", "Axiom"):
        unproved = re.sub(r"Lemma (a\d+ : .*)\.\nProof\. intros; first.*", rf"{word} \1.", text)
        assert unproved != text and not coq.accepts(unproved), word
    narrower = re.sub(r"Float2 \((-?\d{9,})\)", lambda number: f"Float2 ({int(number[1]) // 2})", text)
    assert narrower != text and not coq.accepts(narrower)
