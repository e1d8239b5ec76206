"""The error budget: its parts are the whole, its design is the filter's P, and its truth is what flights show."""

import csv
import json
import re
import runpy
import shlex
import time
from contextlib import chdir, contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT
from test_docs import FENCED, shown

from boresight import BoresightError, Filter, Message, budget, cli, generate, load, transfer
from boresight.analysis import nominal
from boresight.analysis.figures import Sheets
from boresight.runtime.recording.read import EXAMPLE

DEG = np.pi / 180
RIGHT = 1e-9  # of the whole: rounding over thousands of steps, and a start that nearly cancels


@pytest.fixture(scope="module")
def matching():
    return load("velocity-attitude")


@pytest.fixture(scope="module")
def turning(matching):
    return nominal.nominal(matching, "s turn", 20.0, 10.0, 1.0)


def flown(model, along, *words):
    return nominal.flight(model, along, nominal.settings(model) | nominal.sizes(words, model))


def parts(found):
    """The largest part by which the sources miss the whole, over times and states."""
    return np.max(np.abs(found.variances.sum(1) - found.whole) / np.where(found.whole > 0, found.whole, 1.0))


WRONG = {
    "noise": ["gyro_noise 0.05 deg/sqrt(h)", "velocity 0.05 m/s"],
    "start": ["dmu 0.1, 0.1, 0.2 deg", "d_gyro_bias 200 deg/h"],
    "geometry": ["lever_b 3.1, 1, -1 m"],
}


# ---------------------------------------------------------------- the parts are the whole


@pytest.mark.parametrize("wrong", [None, *WRONG])
@pytest.mark.parametrize("how", [{}, {"considered": ["d_tau", "dmu"]}, {"omitted": ["d_accel_bias"]},
                                 {"uncertain": {"lever_b": 0.01, "dcm": 1e-4}}])  # fmt: skip
def test_the_variances_of_the_sources_sum_to_the_whole(matching, turning, wrong, how):
    believed = None if wrong is None else flown(matching, turning, *WRONG[wrong])
    found = budget(matching, *flown(matching, turning), believed=believed, **how)
    assert len(found.times) == 201 and len(found.sources) >= 12
    assert parts(found) < RIGHT
    assert np.abs(found.by_source.sum(0) - found.C).max() < RIGHT * np.abs(found.C).max()
    assert found.variances[-1] == pytest.approx(np.einsum("sii->si", found.by_source))
    design = found.design.sum(1)
    assert np.abs(design - found.P_variances).max() < RIGHT * found.P_variances.max()


def test_a_correlated_start_is_split_by_its_causes_or_stays_one(matching, turning):
    start, steps = flown(matching, turning)
    split = budget(matching, start, steps)
    whole = budget(matching, sum(start.values()), steps)
    assert "start dmu" in split.sources and "start phi+dv_n+d_gyro_bias+d_tau+dmu" not in split.sources
    joined = next(name for name in whole.sources if name.startswith("start") and "phi" in name)
    assert "dmu" in joined and "dv_n" in joined
    assert whole.sigma == pytest.approx(split.sigma, rel=1e-9)
    alone = split.variances[:, [s for s, name in enumerate(split.sources) if name.startswith("start")]].sum(1)
    together = whole.variances[:, [s for s, name in enumerate(whole.sources) if name.startswith("start")]].sum(1)
    assert np.abs(alone - together).max() < RIGHT * alone.max()


def test_an_inflation_is_a_source_of_the_design_and_none_of_the_truth(matching, turning):
    start, steps = flown(matching, turning)
    often = [one for step in steps for one in ((step, ("inflate", 3, np.full(3, 1e-4))) if isinstance(step, dict)
                                               else (step,))]  # fmt: skip
    found, plain = budget(matching, start, often), budget(matching, start, steps)
    place = found.sources.index("added on purpose")
    assert found.design[-1, place, 3] > 0 and not found.variances[:, place].any()
    assert found.P_variances[-1] == pytest.approx(found.design[-1].sum(0), rel=1e-9)
    assert (found.whole[-1, 3:6] > plain.whole[-1, 3:6]).all()  # a filter that trusts itself less flies worse
    loop = fly(matching, start, often)
    assert apart(found.P, loop.P) < 1e-12


@pytest.mark.parametrize("name", ["set_block", "enable"])
def test_a_block_that_is_set_is_a_source_of_the_design_and_the_truth_goes_on(matching, turning, name):
    start, steps = flown(matching, turning)
    block = np.diag([0.02, 0.03, 0.04]) ** 2
    middle = len(steps) // 2
    often = [*steps[:middle], (name, 12, block), *steps[middle:]]
    found, plain = budget(matching, start, often), budget(matching, start, steps)
    assert apart(found.P, fly(matching, start, often).P) < 1e-12
    place, last = found.sources.index("added on purpose"), found.whole[-1, 12:15]
    assert found.design[-1, place, 12] > 0 and not found.variances[:, place].any()
    assert found.P_variances[-1] == pytest.approx(found.design[-1].sum(0), rel=1e-9)
    at = found.at(found.times[-1] / 2)
    assert np.array_equal(found.whole[:at], plain.whole[:at]) and (last > plain.whole[-1, 12:15]).all()
    just = budget(matching, start, [*steps[:middle], (name, 12, block)])
    before = budget(matching, start, steps[:middle])
    assert just.P[12:15, 12:15] == pytest.approx(block) and not just.P[12:15, :12].any()
    assert np.array_equal(just.whole[-1], before.whole[-1])
    with pytest.raises(BoresightError, match=f"{name} of 3 states from state 15 on; there are 16"):
        budget(matching, start, [(name, 15, block)])
    with pytest.raises(BoresightError, match="gives variance to an omitted state"):
        budget(matching, start, [(name, 12, block)], omitted=["dmu"])
    with pytest.raises(BoresightError, match=name):
        budget(matching, start, [(name, 12, -block)])


def test_an_omitted_state_has_no_row_in_the_filter_and_goes_its_own_way_in_truth(matching, turning):
    start, steps = flown(matching, turning)
    found = budget(matching, start, steps, omitted=["d_accel_bias"])
    assert not found.P_variances[:, 9:12].any() and not found.design[:, :, 9:12].any() and not found.P[9:12].any()
    walk = next(np.square(step["accel_bias_noise"]) for step in steps if isinstance(step, dict))
    assert found.whole[:, 9:12] == pytest.approx(np.diag(sum(start.values()))[9:12] + np.outer(found.times, walk))
    assert (found.whole[-1, 3:6] > found.P_variances[-1, 3:6]).all()


# ---------------------------------------------------------------- the design is the filter's P


def fly(model, start, steps, considered=None, disabled=None):
    """`Filter` along the same steps, its state at zero: its P depends on no measured number."""
    loop = Filter(model, {}, sum(start.values()))
    if disabled is not None:
        loop.disable(*disabled)
    for step in steps:
        if isinstance(step, dict):
            loop.predict(**step)
        elif step[0] in ("inflate", "set_block", "enable"):
            getattr(loop, step[0])(*step[1:])
        else:
            name, R, inputs, *rows = step
            loop.update(name, R, rows=rows[0] if rows else True, considered=considered, **inputs)
            loop.x[:] = 0
    return loop


def apart(P, other):
    """The largest difference, of unit variances."""
    sigma = np.sqrt(np.diag(other))
    scale = np.where(sigma > 0, sigma, 1.0)
    return np.abs((P - other) / np.outer(scale, scale)).max()


@pytest.mark.parametrize("case", ["plain", "rows", "correlated", "considered", "omitted"])
def test_the_design_is_the_covariance_of_the_filter(matching, turning, case):
    start, steps = flown(matching, turning)
    how, other = {}, {}
    if case == "rows":
        steps = [(*s, [True, False, True]) if isinstance(s, tuple) and s[0] == "dcm" else s for s in steps]
    if case == "correlated":
        R = 1e-4 * np.array([[1, 0.5, 0], [0.5, 1, 0.2], [0, 0.2, 2]])
        steps = [(s[0], R, *s[2:]) if isinstance(s, tuple) and s[0] == "velocity" else s for s in steps]
    if case == "considered":
        other = {"considered": np.arange(16) >= 12}
        how = {"considered": ["dmu", "d_tau"]}
    if case == "omitted":
        how, other = {"omitted": ["d_accel_bias"]}, {"disabled": (9, 3)}
    assert apart(budget(matching, start, steps, **how).P, fly(matching, start, steps, **other).P) < 1e-12


def test_a_correlated_measurement_is_taken_as_it_scatters(matching, turning):
    start, steps = flown(matching, turning)
    R = 1e-4 * np.array([[1, 0.5, 0], [0.5, 1, 0.2], [0, 0.2, 2]])
    steps = [(s[0], R, *s[2:]) if isinstance(s, tuple) and s[0] == "velocity" else s for s in steps]
    found = budget(matching, start, steps)
    assert found.C == pytest.approx(found.P, rel=1e-9, abs=1e-18)  # noqa: SIM300


def test_the_start_is_that_of_a_slave_that_takes_its_master_over(matching):
    """As `transfer.first` has it at rest, but for the rate of the level, which turns the delay into 1e-6 rad."""
    along, values = nominal.nominal(matching, "still", 2.0), nominal.settings(matching)
    start, _ = nominal.flight(matching, along, values)
    taken = sum(P for name, P in start.items() if name not in ("phi", "dv_n"))
    at = {name: along.inputs[name][0] for name in ("v_m_n", "q_m2n_wxyz", "lever_b", "lat_lon_height")}
    R = np.repeat([values["velocity"], values["dcm"]], 3) ** 2
    message = Message(time=0.0, R=R, v_m_n=at["v_m_n"], q_m2n_wxyz=at["q_m2n_wxyz"], position=at["lat_lon_height"])
    noise = {name: 0.0 if name == "tau_noise" else np.zeros(3) for name in matching.Q.fields if name.endswith("_noise")}
    names = {"q_b2m_wxyz": "dmu", "gyro_bias": "d_gyro_bias", "accel_bias": "d_accel_bias", "tau": "d_tau"}
    sigmas = {there: values[here] for there, here in names.items()}
    P = transfer.first(message, matching, {"lever_b": at["lever_b"], **noise}, sigmas=sigmas, rate_sigma=0.0,
                       acceleration_sigma=0.0)[1]  # fmt: skip
    assert apart(taken, P) < 5e-3


def test_where_the_filter_believes_the_truth_its_covariance_is_true(matching, turning):
    found = budget(matching, *flown(matching, turning), considered=["dmu"])
    assert pytest.approx(found.P, rel=1e-9, abs=1e-18) == found.C
    same = budget(matching, *flown(matching, turning), believed=flown(matching, turning))
    assert pytest.approx(same.P, rel=1e-7, abs=1e-18) == same.C


# ---------------------------------------------------------------- an independent recursion


def witness(start, steps, start_f, steps_f, kept):
    """Covariance of (x, x_hat) as they are, with textbook gains: the error is their difference."""
    n = len(start)
    P, C = start_f.copy(), np.zeros((2 * n, 2 * n))
    C[:n, :n] = start
    for one, other in zip(steps, steps_f, strict=True):
        if isinstance(one, dict):
            A = np.zeros((2 * n, 2 * n))
            A[:n, :n], A[n:, n:] = one["Phi"], other["Phi"]
            C = A @ C @ A.T
            C[:n, :n] += sum(one["Q"].values())
            P = other["Phi"] @ P @ other["Phi"].T + sum(other["Q"].values())
        else:
            H, R, H_f, R_f = one[2]["H"], np.diag(one[1]), other[2]["H"], np.diag(other[1])
            K = P @ H_f.T @ np.linalg.inv(H_f @ P @ H_f.T + R_f)
            K[kept] = 0
            left = np.eye(n) - K @ H_f
            P = left @ P @ left.T + K @ R_f @ K.T
            A = np.block([[np.eye(n), np.zeros((n, n))], [K @ H, left]])
            B = np.vstack([np.zeros_like(K), K])
            C = A @ C @ A.T + B @ R @ B.T
    minus = np.hstack([np.eye(n), -np.eye(n)])
    return P, minus @ C @ minus.T


@pytest.mark.parametrize("seed", range(4))
def test_true_covariances_are_those_of_another_recursion(seed):
    """Everything is believed wrongly: Phi, Q, H, R and the start; some states are considered."""
    rng = np.random.default_rng(seed)
    n = 5

    def covariance(size):
        L = rng.normal(size=(size, size))
        return L @ L.T

    phi, phi_f = (np.eye(n) + 0.05 * rng.normal(size=(n, n)) for _ in range(2))
    steps, steps_f = [], []
    for k in range(30):
        for where, Phi in ((steps, phi), (steps_f, phi_f)):
            where.append({"dt": 0.1, "Phi": Phi, "Q": {"gusts": 0.01 * covariance(n), "drift": 0.001 * covariance(n)}})
        if k % 3 == 0:
            H = rng.normal(size=(2, n))
            steps.append(("range", rng.uniform(0.1, 1, 2), {"H": H}))
            steps_f.append(("range", rng.uniform(0.1, 1, 2), {"H": H + 0.1 * rng.normal(size=(2, n))}))
    start, start_f = covariance(n), covariance(n)
    kept = np.arange(n) == seed
    found = budget(None, start, steps, believed=(start_f, steps_f), considered=kept)
    P, C = witness(start, steps, start_f, steps_f, kept)
    assert pytest.approx(P, rel=1e-9) == found.P and pytest.approx(C, rel=1e-9) == found.C
    assert set(found.sources) == {"start x0+x1+x2+x3+x4", "gusts", "drift", "range noise"}
    for name in ("gusts", "drift"):  # a source alone is a flight in which all others are silent, under the same gains
        silent = [
            {**s, "Q": {part: Q * (part == name) for part, Q in s["Q"].items()}} if isinstance(s, dict)
            else (s[0], 1e-30 * np.ones(2), s[2]) for s in steps
        ]  # fmt: skip
        _, only = witness(0 * start, silent, start_f, steps_f, kept)
        assert found.by_source[found.sources.index(name)] == pytest.approx(only, rel=1e-9, abs=1e-20)


def test_an_omitted_state_of_a_total_one_follows_the_others_themselves_and_not_their_errors():
    """A swing whose rate the filter does not have: to the angle's deviation the truth answers, corrected or not."""
    Phi, Q, H, R = np.array([[0.9, 0.3], [-0.3, 0.9]]), 0.01 * np.eye(2), np.array([[1.0, 0]]), 0.1
    found = budget(None, np.eye(2), [{"Phi": Phi, "Q": {"q": Q}}, ("m", R, {"H": H})] * 9, omitted=[False, True])
    C, p = np.zeros((3, 3)), 1.0  # of angle, rate and the filter's angle; of the filter
    C[:2, :2] = np.eye(2)
    for _ in range(9):
        p = Phi[0, 0] ** 2 * p + Q[0, 0]
        k = p / (p + R)
        p *= 1 - k
        A = np.block([[Phi, np.zeros((2, 1))], [k * Phi[:1], (1 - k) * Phi[:1, :1]]])
        B = np.vstack([np.eye(2), [k, 0]])  # what disturbs the truth is in the measurement too
        C = A @ C @ A.T + B @ Q @ B.T + np.diag([0, 0, k * R * k])
    error = np.array([[1.0, 0, -1], [0, 1, 0]])
    assert pytest.approx(error @ C @ error.T, rel=1e-12) == found.C and found.P[0, 0] == pytest.approx(p)


def test_a_wrong_correlation_time_is_propagated_with_the_state_itself():
    """A Gauss-Markov bias that is measured once and believed to last: the error is what the truth has forgotten."""
    lasting, sigma = np.exp(-0.1), 2.0
    true = {"dt": 1.0, "Phi": [[lasting]], "Q": {"wander": [[sigma**2 * (1 - lasting**2)]]}}
    thought = {"dt": 1.0, "Phi": [[1.0]], "Q": {"wander": [[0.0]]}}
    look = ("look", 1e-12, {"H": [[1.0]]})
    found = budget(
        None, np.array([[sigma**2]]), [look, *[true] * 10], believed=(np.eye(1) * sigma**2, [look, *[thought] * 10])
    )
    assert found.P[0, 0] < 1e-11
    assert found.C[0, 0] == pytest.approx(2 * sigma**2 * (1 - np.exp(-1.0)), rel=1e-9)  # E (b(0) - b(10))^2


# ---------------------------------------------------------------- known numbers, and unknown constants


def test_known_offsets_add_as_numbers(matching, turning):
    true = flown(matching, turning)
    x, y = {"lever_b": [0.01, 0.0, 0.0]}, {"dcm": [0.0, 0.0, 1e-3]}
    found, one, other = (budget(matching, *true, offsets=which) for which in ({**x, **y}, x, y))
    assert np.abs(one.offset[-1]).max() > 0 and np.abs(other.offset[-1]).max() > 0
    assert found.offset == pytest.approx(one.offset + other.offset, rel=1e-12, abs=1e-18)
    assert found.offsets.sum(1) == pytest.approx(found.offset, rel=1e-12, abs=1e-18)
    assert np.array_equal(found.whole, one.whole)  # and are no spread
    assert found.rms**2 == pytest.approx(found.whole + found.offset**2)


def test_a_wrong_input_of_a_measurement_is_a_known_offset(matching, turning):
    """The filter believes a lever arm that is longer: to first order as if the true one were shorter."""
    true = flown(matching, turning)
    believed = budget(matching, *true, believed=flown(matching, turning, "lever_b 3.0001, 1, -1 m")).offset
    known = budget(matching, *true, offsets={"lever_b": [-1e-4, 0, 0]}).offset
    assert np.abs(known[-1]).max() > 0
    assert believed == pytest.approx(known, rel=1e-3, abs=1e-3 * np.abs(known).max(0).min())


def with_fields(function, *fields):
    function.fields = fields
    return function


class Decay:
    """One total state that shrinks by a part per step: plain Python, and linear, so that nothing is left out."""

    name, states = "decay", ("x",)
    Phi = staticmethod(with_fields(lambda part: np.asarray(part)[..., None, None] * np.eye(1), "part"))
    Q = staticmethod(with_fields(lambda gust: np.asarray(gust)[..., None, None] ** 2 * np.eye(1), "gust"))
    next = staticmethod(with_fields(lambda x, part: part * x, "x", "part"))


def test_the_mean_of_a_wrong_parameter_is_the_difference_of_two_motions():
    true, thought = ({"part": part, "gust": 0.1} for part in (0.9, 0.5))
    found = budget(Decay(), np.eye(1), [true] * 6, believed=(np.eye(1), [thought] * 6), x=[5.0], noise=["gust"])
    assert found.offset[:, 0] == pytest.approx([5 * (0.5**k - 0.9**k) for k in range(7)])


def test_an_unknown_constant_is_what_a_known_one_of_its_size_makes(matching, turning):
    true = flown(matching, turning)
    known = budget(matching, *true, believed=flown(matching, turning, "lever_b 3.0001, 1, -1 m")).offset[-1]
    found = budget(matching, *true, uncertain={"lever_b": [1e-4, 0.0, 0.0]})
    alone = np.sqrt(found.variances[-1, found.sources.index("lever_b")])
    assert alone == pytest.approx(np.abs(known), rel=1e-3)


def test_the_rows_of_a_measurement_may_have_an_unknown_constant():
    """One state, measured ever more often: what is wrong with the meter stays."""
    fix = ("meter", 1.0, {"H": [[1.0]]})
    found = budget(None, np.eye(1) * 100, [fix] * 1000, uncertain={"meter": 0.5})
    assert dict(zip(found.sources, np.sqrt(found.variances[-1, :, 0]), strict=True)) == pytest.approx(
        {"start x0": 10 / (1 + 1000 * 100), "meter noise": 1 / np.sqrt(1000), "meter": 0.5}, rel=2e-3
    )


# ---------------------------------------------------------------- bad input, one line


STILL = {"dt": 1.0, "Phi": np.eye(2), "Q": {"q": np.eye(2)}}
SEEN = ("m", 1.0, {"H": [[1.0, 0]]})


@pytest.mark.parametrize(
    ("start", "steps", "how", "line"),
    [
        (np.eye(2), [], {}, "there are no steps"),
        (np.eye(2), ["predict"], {}, "'predict' is no step"),
        (-np.eye(2), [STILL], {}, "P0 has a negative variance"),
        (np.eye(3), [STILL], {}, r"Phi has shape \(2, 2\); it must be \(3, 3\)"),
        (np.eye(2), [("m", 0.0, {"H": [[1.0, 0]]})], {}, "every variance in R of m must be above zero"),
        (np.eye(2), [("m", 1.0, {"H": [[1.0]]})], {}, "its last axis must be 2 long"),
        (np.eye(2), [STILL], {"considered": ["x7"]}, "there is no state 'x7'"),
        (np.eye(2), [STILL], {"uncertain": {"lever": 1.0}}, "no measurement reads 'lever'"),
        (np.eye(2), [STILL], {"believed": (np.eye(2), [STILL, STILL])}, "both must be the same steps"),
        (np.eye(2), [STILL], {"believed": (np.eye(2), [("m", 1.0, {"H": [[1.0, 0]]})])}, "another step than the truth"),
        (np.eye(2), [{**STILL, "Phi": np.full((2, 2), np.nan)}], {}, "Phi holds a value that is not finite"),
        ({"q": np.eye(2), "x": -np.eye(2)}, [STILL], {}, "x has a negative variance"),
        ({"x": np.array([1.0, -1.0])}, [STILL], {}, "sigma of x is .*; give finite numbers from zero on"),
        (np.eye(2), [{**STILL, "dt": -1.0}], {}, "dt is -1.0; give finite numbers from zero on"),
        (np.eye(2), [{**STILL, "dt": "a"}], {}, "dt is 'a'; give numbers"),
        (np.eye(2), [("m", 1.0, {"H": [[np.nan, 0]]})], {}, "H of m holds a value that is not finite"),
        (np.eye(2), [SEEN], {"uncertain": {"m": -1.0}}, "m is -1.0; give finite numbers from zero on"),
        (np.eye(2), [SEEN], {"offsets": {"m": np.nan}}, "m is nan; give finite numbers"),
        (np.eye(2), [STILL], {"considered": [1]}, "there is no state 1"),
    ],
)
def test_bad_input_gets_one_line(start, steps, how, line):
    with pytest.raises(BoresightError, match=line) as told:
        budget(None, start, steps, **how)
    assert "\n" not in str(told.value)


def test_a_measurement_may_have_other_rows_in_another_step():
    two = ("m", 1.0, {"H": np.eye(2)})
    one = [("m", 1.0, {"H": row}) for row in np.eye(2)[:, None]]
    assert np.allclose(budget(None, np.eye(2), [STILL, SEEN, STILL, two]).P,
                       budget(None, np.eye(2), [STILL, SEEN, STILL, *one]).P, rtol=1e-14)  # fmt: skip


def test_an_input_that_lacks_or_is_unknown_is_named(matching, turning):
    start, steps = flown(matching, turning)
    with pytest.raises(BoresightError, match="Phi needs f_b; add it to the inputs of the step"):
        budget(matching, start, [{k: v for k, v in steps[0].items() if k != "f_b"}])
    with pytest.raises(BoresightError, match=r"has no input 'gyro_nois' .did you mean 'gyro_noise'"):
        budget(matching, start, [{**steps[0], "gyro_nois": 1.0}])


# ---------------------------------------------------------------- time


def test_sixteen_states_and_fifteen_sources_over_a_minute_at_100_hz_take_two_seconds(matching):
    along = nominal.nominal(matching, "s turn", 60.0, 100.0, 1.0)
    constants = {"lever_b": 0.01, "dcm": 1e-4, "velocity": 0.01}
    begin = time.process_time()
    found = budget(matching, *flown(matching, along), uncertain=constants)
    assert time.process_time() - begin < 2.0 and len(found.sources) == 15 and len(found.states) == 16


# ---------------------------------------------------------------- a model of one's own


def test_the_rendezvous_that_is_published(tmp_path, monkeypatch):
    """Geller's transfer: 11.03987383 m as published, and its split as another program of the equations has it."""
    monkeypatch.setenv("BORESIGHT_CACHE", str(tmp_path / "cache"))
    script = runpy.run_path(str(ROOT / "examples" / "fly_rendezvous.py"))
    library = load(generate(script["MODEL"], tmp_path / "rendezvous").folder)
    found = budget(library, *script["nominal"](library))
    assert np.sqrt(found.whole[-1, :3].sum()) == pytest.approx(11.03987383, rel=2e-6)
    alone = dict(zip(found.sources, np.sqrt(found.variances[-1, :, :3].sum(-1)), strict=True))
    assert alone == pytest.approx(
        {"start dispersion": 0.0, "start navigation": 10.982287, "drag_noise": 0.778994, "burn": 0.813139},
        rel=2e-6, abs=1e-6,
    )  # fmt: skip
    true = found.variances[..., :6], found.whole[..., :6]  # of what is estimated the burn leaves rounding
    assert np.abs(true[0].sum(1) - true[1]).max() < RIGHT * true[1].max()


def test_a_total_state_is_linearised_along_its_own_motion_and_wraps(tmp_path, monkeypatch):
    """A pendulum that goes over the top: the filter that flies the same is `Filter` at its true state."""
    monkeypatch.setenv("BORESIGHT_CACHE", str(tmp_path / "cache"))
    library = load(generate(f"{ROOT / 'examples' / 'pendulum.py'}:PENDULUM", tmp_path / "pendulum").folder)
    step = {"rod": np.array([1.0, 0.2]), "dt": 0.02, "torque": 0.05}
    begin, P0 = np.array([2.0, 6.0]), np.diag([0.1, 0.3]) ** 2
    steps = ([step] * 5 + [("encoder", 4e-4, {})]) * 20
    found = budget(library, P0, steps, x=begin)
    loop = Filter(library, {}, P0, begin)
    for one in steps:
        if isinstance(one, dict):
            loop.predict(**one)
        else:
            loop.update("encoder", 4e-4, z=loop.x[:1])
    assert abs(loop.x[0]) < np.pi and apart(found.P, loop.P) < 1e-12
    # a longer rod than the filter believes: the mean is the difference of two motions, until squares count
    longer = {**step, "rod": np.array([1.0 + 1e-6, 0.2])}
    off = budget(library, P0, [longer] * 20, believed=(P0, [step] * 20), x=begin).offset[-1]
    ends = []
    for one in (step, longer):
        x = begin
        for _ in range(20):
            x = library.next(x=x, **{name: one[name] for name in library.next.fields if name != "x"})
            x[0] = (x[0] + np.pi) % (2 * np.pi) - np.pi
        ends.append(x)
    assert off == pytest.approx(ends[0] - ends[1], rel=1e-3)


# ---------------------------------------------------------------- text, files and what is needed


@pytest.fixture(scope="module")
def found(matching, turning):
    return budget(matching, *flown(matching, turning), offsets={"dcm": 1e-4})


def read_back(text, state):
    """By row of the table that has this state, its number and its share, as they are printed."""
    rows, column = {}, None
    for line in text.splitlines():
        if line.startswith("at "):
            heads = line.split(" s ", 1)[1].split()
            column = heads.index(state) if state in heads else None
        elif column is not None and (row := re.match(r"(\S+(?: \S+)*) {2,}(.*)$", line)):
            cells = re.findall(r"(-?[\d.e+-]+)(?: +(\d+)%)?", row[2])
            rows[row[1]] = cells[column] if len(cells) > column else None
    return rows


def test_the_text_shows_each_source_in_the_unit_of_its_head(found):
    text = found.report()
    assert max(map(len, text.splitlines())) <= 80
    rows = read_back(text, "phi_d")
    for s, name in enumerate(found.sources):
        value, share = rows[name]
        assert float(value) == pytest.approx(1e3 * np.sqrt(found.variances[-1, s, 2]), rel=5e-3)
        assert float(share) == pytest.approx(100 * found.variances[-1, s, 2] / found.whole[-1, 2], abs=0.51)
    assert float(rows["root sum square"][0]) == pytest.approx(1e3 * found.sigma[-1, 2], rel=5e-3)
    assert float(rows["mean and sigma"][0]) == pytest.approx(1e3 * found.rms[-1, 2], rel=5e-3)
    assert float(rows["offset dcm"][0]) == pytest.approx(1e3 * found.offset[-1, 2], rel=5e-3)
    assert float(rows["filter's own sigma"][0]) == pytest.approx(1e3 * np.sqrt(found.P[2, 2]), rel=5e-3)
    assert found.report([5.0], ["heading"]).count("at 5 s") == 1


def test_a_state_goes_by_its_name_its_letter_and_its_block(found):
    assert found.places("dmu") == [found.states.index(f"dmu_{axis}") for axis in "xyz"]
    assert found.state("dmu_Z") == found.state("dmu_z") == found.states.index("dmu_z")
    one = replace(found, blocks={"velocity": (3,)})  # of a model whose state `velocity` is written v
    assert one.state("velocity") == 3
    with pytest.raises(BoresightError, match=r"has no state 'v'; it has .*, velocity, heading$"):
        one.state("v")


def test_csv_and_json_hold_the_numbers_of_the_arrays(found):
    rows = list(csv.DictReader(found.csv([20.0]).splitlines()))
    own = {(row["source"], row["state"]): row for row in rows}
    s = found.sources.index("gyro_noise")
    assert float(own["gyro_noise", "d_tau"]["sigma"]) == pytest.approx(np.sqrt(found.variances[-1, s, 15]))
    assert float(own["gyro_noise", "d_tau"]["share"]) == pytest.approx(found.variances[-1, s, 15] / found.whole[-1, 15])
    assert own["gyro_noise", "d_tau"]["unit"] == "s" and own["gyro_noise", "dba_z"]["unit"] == "m/s^2"
    shares = sum(float(row["share"]) for row in rows if row["state"] == "phi_d" and row["source"] in found.sources)
    assert shares == pytest.approx(1.0)
    document = json.loads(json.dumps(found.document(), allow_nan=False))
    assert np.shape(document["sigma"]) == (61, len(found.sources), 16) and document["times_s"][-1] == 20.0
    assert document["whole_sigma"][-1] == pytest.approx(found.sigma[-1].tolist())


def test_a_need_is_met_by_the_factors_that_are_printed(matching, turning):
    """Each factor is tried: as it flies by a truth that is better than the filter believes, retuned by both."""
    values = nominal.settings(matching)
    design = nominal.flight(matching, turning, values)
    found = budget(matching, *design)
    limit = 0.8 * found.rms[-1, 2]
    needed = found.need("heading", limit)
    assert not needed["met"] and needed["together"] == pytest.approx(0.8, rel=1e-9)
    tried = {one["source"]: one for one in needed["sources"] if one["source"] in ("gyro_noise", "dcm noise")}
    factors = []
    for name, one in tried.items():
        key = name.removesuffix(" noise")
        for how in ("as_it_flies", "retuned"):
            factor = one[how]
            factors.append(factor)
            better = nominal.flight(matching, turning, values | {key: np.asarray(values[key]) * (factor or 1e-12)})
            new = budget(matching, *better, believed=design if how == "as_it_flies" else None)
            expected = limit if factor else one[f"least_{how}"]
            assert new.rms[-1, 2] == pytest.approx(expected, rel=2e-3), (name, how)
    assert any(factors) and None in factors  # one source can, another cannot
    text = found.need_report(needed)
    assert max(map(len, text.splitlines())) <= 80 and f"x {tried['gyro_noise']['as_it_flies']:.3f}" in text
    assert found.need("heading", 1.0)["met"] and "met, with" in found.need_report(found.need("heading", 1.0))


def test_retuned_with_a_wrong_belief_keeps_the_rest_of_the_belief(matching, turning):
    true, values = flown(matching, turning), nominal.settings(matching)
    thought = values | {"velocity": 0.1}
    found = budget(matching, *true, believed=nominal.flight(matching, turning, thought), uncertain={"lever_b": 0.01},
                   considered=["d_tau"], omitted=["d_accel_bias"])  # fmt: skip
    half = {"gyro_noise": np.array([1.0, 0.5]), "dcm noise": np.array([1.0, 0.5])}
    tried = found.scaled(half)
    assert tried[0] == pytest.approx(found.whole[-1], rel=1e-6)
    smaller = {name: np.asarray(values[name]) / 2 for name in ("gyro_noise", "dcm")}
    start, steps = nominal.flight(matching, turning, values | smaller)
    start_f, steps_f = nominal.flight(matching, turning, thought | smaller)
    start["dcm taken over"], start_f["dcm taken over"] = true[0]["dcm taken over"], true[0]["dcm taken over"]
    new = budget(matching, start, steps, believed=(start_f, steps_f), uncertain={"lever_b": 0.01},
                 considered=["d_tau"], omitted=["d_accel_bias"])  # fmt: skip
    assert tried[1] == pytest.approx(new.whole[-1], rel=1e-6)


@pytest.mark.parametrize("name", ["inflate", "set_block", "enable"])
def test_retuned_keeps_what_the_filter_gives_its_states(name):
    def flight(size):
        step = {**STILL, "Phi": np.array([[1, 1], [0, 1]])}
        seen = ("m", size**2, SEEN[2])
        given = (name, 1, [5.0] if name == "inflate" else [[5.0]])
        return np.eye(2), [step, seen, step, seen, given, step, seen]

    found = budget(None, *flight(1.0))
    need = found.need("x0", 0.9 * np.sqrt(found.whole[-1, 0]))
    size = next(one["retuned"] for one in need["sources"] if one["source"] == "m noise")
    assert np.sqrt(budget(None, *flight(size)).whole[-1, 0]) == pytest.approx(need["limit"], rel=2e-3)


def test_retuned_a_known_offset_comes_through_with_the_new_gains():
    def flight(size):
        step = {**STILL, "Phi": np.array([[1, 1], [0, 1]]), "Q": {"q": np.diag([0, 0.01])}}
        return np.eye(2), [step, ("m", size**2, SEEN[2]), ("v", 0.3, {"H": [[0, 1.0]]})] * 15

    found = budget(None, *flight(1.0), offsets={"m": 0.8})
    need = found.need("x0", 0.93 * found.rms[-1, 0])
    size = next(one["retuned"] for one in need["sources"] if one["source"] == "m noise")
    assert budget(None, *flight(size), offsets={"m": 0.8}).rms[-1, 0] == pytest.approx(need["limit"], rel=2e-3)


def test_the_mean_alone_may_be_beyond_what_is_needed(matching, turning):
    found = budget(matching, *flown(matching, turning), offsets={"dcm": [0, 0, 1e-2]})
    needed = found.need("heading", 1e-4)
    assert needed["together"] is None and "the mean alone is beyond it" in found.need_report(needed)


def test_two_designs_stand_side_by_side(matching, turning, found):
    other = budget(matching, *flown(matching, turning, "gyro_noise 0.3 deg/sqrt(h)"))
    text = found.beside(other.document(), "other.json", "heading")
    assert max(map(len, text.splitlines())) <= 80
    row = next(line.split() for line in text.splitlines() if line.startswith("phi_d "))
    assert float(row[4]) == pytest.approx(found.rms[-1, 2] / other.rms[-1, 2], abs=1e-3)
    row = next(line.split() for line in text.splitlines() if line.startswith("gyro_noise"))
    s = found.sources.index("gyro_noise")
    assert float(row[2]) == pytest.approx(1e3 * np.sqrt(found.variances[-1, s, 2]), rel=5e-3)
    assert float(row[3]) == pytest.approx(1e3 * np.sqrt(other.variances[-1, s, 2]), rel=5e-3)


def test_the_figure_stacks_the_sources_up_to_the_sigma(found, tmp_path):
    drawn = {}

    class Kept(Sheets):
        @contextmanager
        def __call__(self, stem, *size, **subplots):
            with super().__call__(stem, *size, **subplots) as made:
                yield made
                drawn["axes"] = made[1]

    found.draw(Kept(tmp_path), ["heading"], 5e-4)
    ax = drawn["axes"][0, 0]
    top = np.max([collection.get_paths()[0].vertices[:, 1].max() for collection in ax.collections])
    assert top == pytest.approx(1e3 * found.sigma[:, 2].max(), rel=1e-9)
    last = [c.get_paths()[0].vertices for c in ax.collections][-1]
    at_end = last[last[:, 0] == found.times[-1], 1].max()
    assert at_end == pytest.approx(1e3 * found.sigma[-1, 2], rel=1e-9)
    assert next(line for line in ax.lines if line.get_label() == "needed").get_ydata()[0] == pytest.approx(0.5)
    assert (tmp_path / "budget.png").stat().st_size > 1e4


# ---------------------------------------------------------------- the command


@pytest.fixture
def run(capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")

    def run(*words):
        with pytest.raises(SystemExit) as ended:
            cli.main(["budget", *map(str, words)])
        return ended.value.code or 0, *capsys.readouterr()

    return run


SHORT = ("velocity-attitude", "--seconds", 10)


def test_the_command_prints_what_the_function_finds(run, tmp_path):
    status, out, err = run(*SHORT, "--need", "heading 0.001 mrad", "--state", "heading", "-o", tmp_path / "new")
    assert status == 1 and not err and max(len(line) for line in out.splitlines() if "wrote" not in line) <= 80
    assert "phi_d within 0.001 mrad" in out or "0.001 mrad at 10 s: not met" in out
    kept = json.loads((tmp_path / "new" / "budget.json").read_text())
    assert {path.name for path in (tmp_path / "new").iterdir()} == {"budget.json", "budget.csv", "budget.png"}
    assert kept["need"]["limit"] == pytest.approx(1e-6)
    status, out, _ = run(*SHORT, "--against", tmp_path / "new" / "budget.json", "--set", "gyro_noise 1 deg/sqrt(h)")
    assert status == 0 and "against" in out
    status, out, _ = run(*SHORT, "--json", "--need", "phi_D 10 rad")
    assert status == 0 and json.loads(out)["need"]["met"] and json.loads(out)["not_flown"] == []


def test_beliefs_constants_and_states_by_words(run):
    words = ("--believe", "gyro_noise 0.01 deg/sqrt(h)", "--uncertain", "lever_b 1 cm", "--offset", "dcm -0.1 mrad",
             "--set", "lever_b 2, 0, -1 m", "--set", "tau_noise 0 sqrt(s)",
             "--consider", "d_tau", "--omit", "d_accel_bias", "--at", 5, "--state", "phi_n")  # fmt: skip
    status, out, _ = run(*SHORT, *words, "--motion", "sea 4")
    assert status == 0 and "lever_b" in out and "offset dcm" in out and "at 5 s" in out
    rows = read_back(out, "phi_n")
    assert float(rows["root sum square"][0]) > float(rows["filter's own sigma"][0])


def test_a_recording_is_a_motion_and_a_grade_takes_the_model_of_sensors(run):
    status, out, err = run(*SHORT, "--motion", EXAMPLE, "--state", "heading")
    assert status == 0, err
    status, out, _ = run(
        "velocity-attitude", "--grade", "tactical", "--seconds", 3, "--step-hz", 2, "--motion", "sea 4"
    )
    assert status == 0 and "velocity-attitude-sensors" in out and "start gyro_instability" in out


@pytest.mark.parametrize("name", ["euler-matching", "azimuth-hold", "azimuth-hold-reference", "velocity-dcm",
                                  "velocity-attitude-lever", "phi-error", "psi-error"])  # fmt: skip
def test_every_built_in_filter_has_a_budget(run, name):
    status, out, err = run(name, "--seconds", 3, "--motion", "yaw 3 deg")
    assert status == 0 and "root sum square" in out, err


def test_a_flight_of_ones_own_is_a_function(run, tmp_path):
    (tmp_path / "own.py").write_text(
        "import numpy as np\n"
        "def flight(library, noise=1e-4):\n"
        "    step = {'q_b2n_wxyz': [1, 0, 0, 0], 'omega_in_n': np.zeros(3), 'dt': 0.1, 'gyro_noise': noise}\n"
        "    step['gyro_noise'] = np.full(3, noise)\n"
        "    return np.eye(6) * 1e-4, [step] * 10\n"
        "def thought(library): return flight(library, 1e-5)\n"
        "def none(library): return 1\n"
        "def wrong(library): return 1 / 0\n"
    )
    words = ("euler-matching", "--motion", f"{tmp_path}/own.py:flight")
    status, out, err = run(*words, "--believe", f"{tmp_path}/own.py:thought", "--state", "heading")
    rows = read_back(out, "eps_d")
    assert status == 0 and float(rows["gyro_noise"][0]) == pytest.approx(0.1, rel=1e-3), err
    for name, line in (
        ("none", "it must return P0, steps"),
        ("wrong", "division by zero"),
        ("lacks", "is no function"),
    ):
        status, _, err = run("euler-matching", "--motion", f"{tmp_path}/own.py:{name}")
        assert status == 1 and line in err and len(err.splitlines()) == 1
    status, _, err = run(*words, "--set", "gyro_noise 1")
    assert status == 1 and "returns the sizes" in err


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (("--motion", "s-trun"), "no motion 's-trun'"),
        (("--set", "gyro_nose 1"), "has no input or other name 'gyro_nose' (did you mean 'gyro_noise'?)"),
        (("--set", "gyro_noise 1 m"), "give numbers and one of the units rad/sqrt(s), deg/sqrt(h)"),
        (("--set", "gyro_noise 0.1"), "give numbers and one of the units rad/sqrt(s), deg/sqrt(h)"),
        (("--set", "tau_noise 0.1"), "give numbers and the unit sqrt(s)"),
        (("--need", "heading 0.3"), "give numbers and one of the units rad, mrad"),
        (("--set", "dmu 1, -1, 1 deg"), "a sigma is not negative"),
        (("--believe", "dcm -1 mrad"), "a sigma is not negative"),
        (("--uncertain", "lever_b -5 cm"), "a sigma is not negative"),
        (("--estimate",), "give a --grade"),
        (("--set", "dmu 1, 2 deg"), "give one number or 3"),
        (("--need", "headng 1 mrad"), "has no state 'headng' (did you mean 'heading'?); it has phi_n, phi_e"),
        (("--need", "dmu 1 mrad"), "dmu is 3 states: name one of dmu_x, dmu_y, dmu_z"),
        (("--need", "heading 0 mrad"), "is not possible; give a size above zero"),
        (("--at", "70"), "there is no time 70 s"),
        (("--grade", "tactcal"), "no grade 'tactcal'"),
        (("--believe", "own.py:thought"), "--believe own.py:thought needs a --motion FILE.py:NAME"),
        (("--seconds", "1e9"), "more than 1,000,000 steps; give fewer seconds"),
        (("--seconds", "0"), "seconds is 0.0; it must be above zero"),
        (("--update-hz", "3"), "step-hz 10 must be a multiple of update-hz 3"),
        (("--against", "none.json"), "none.json cannot be compared"),
        (("--motion", "none.toml"), "none.toml"),
    ],
)
def test_a_wrong_word_is_one_line(run, words, line):
    status, out, err = run(*SHORT, *words)
    assert status == 1 and not out and line in err and len(err.splitlines()) == 1, err


# ---------------------------------------------------------------- the page


def test_what_the_page_shows_is_what_is_printed(run, tmp_path, monkeypatch):
    page = (ROOT / "docs" / "error-budget.md").read_text()
    (tmp_path / "pendulum.py").write_text((ROOT / "examples" / "pendulum.py").read_text())
    seen = 0
    with chdir(tmp_path):
        for language, file, block in FENCED.findall(page):
            if file:
                Path(file).write_text(block)
            for command in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:] if language == "console" else ():
                line, expected = command.split("\n", 1)
                words, _, kept = (part.strip() for part in line.partition(" > "))
                _, name, *rest = shlex.split(words)
                if name == "generate":
                    generate(rest[0])
                    continue
                status, out, err = run(*rest)
                assert not err and status == ("--need" in rest), line
                if kept:
                    Path(kept).write_text(out)
                else:
                    assert shown(expected.strip(), out.strip()), (line, out)
                    seen += 1
    assert seen == 6
