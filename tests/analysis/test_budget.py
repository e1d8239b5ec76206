"""The error budget: its parts are the whole, its design is the filter's P, and its truth is what flights show."""

import time

import numpy as np
import pytest

from boresight import BoresightError, Filter, budget, load
from boresight.analysis import nominal

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
    "noise": ["gyro_noise 0.05 deg/sqrt(h)", "velocity 0.05"],
    "start": ["dmu 0.1, 0.1, 0.2 deg", "d_gyro_bias 200 deg/h"],
    "geometry": ["lever_b 3.1, 1, -1"],
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


# ---------------------------------------------------------------- the design is the filter's P


def fly(model, start, steps, considered=None, disabled=None):
    """`Filter` along the same steps, its state at zero: its P depends on no measured number."""
    loop = Filter(model, {}, sum(start.values()))
    if disabled is not None:
        loop.disable(*disabled)
    for step in steps:
        if isinstance(step, dict):
            loop.predict(**step)
        elif step[0] == "inflate":
            loop.inflate(*step[1:])
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
    believed = budget(matching, *true, believed=flown(matching, turning, "lever_b 3.0001, 1, -1")).offset
    known = budget(matching, *true, offsets={"lever_b": [-1e-4, 0, 0]}).offset
    assert np.abs(known[-1]).max() > 0
    assert believed == pytest.approx(known, rel=1e-3, abs=1e-3 * np.abs(known).max(0).min())


def test_an_unknown_constant_is_what_a_known_one_of_its_size_makes(matching, turning):
    true = flown(matching, turning)
    known = budget(matching, *true, believed=flown(matching, turning, "lever_b 3.0001, 1, -1")).offset[-1]
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
    ],
)
def test_bad_input_gets_one_line(start, steps, how, line):
    with pytest.raises(BoresightError, match=line) as told:
        budget(None, start, steps, **how)
    assert "\n" not in str(told.value)


def test_an_input_that_lacks_or_is_unknown_is_named(matching, turning):
    start, steps = flown(matching, turning)
    with pytest.raises(BoresightError, match="Phi needs f_b; add it to the inputs of the step"):
        budget(matching, start, [{k: v for k, v in steps[0].items() if k != "f_b"}])
    with pytest.raises(BoresightError, match=r"has no input 'gyro_nois' .did you mean 'gyro_noise'"):
        budget(matching, start, [{**steps[0], "gyro_nois": 1.0}])


# ---------------------------------------------------------------- time


def test_sixteen_states_and_twelve_sources_over_a_minute_at_100_hz_take_two_seconds(matching):
    along = nominal.nominal(matching, "s turn", 60.0, 100.0, 1.0)
    begin = time.process_time()
    found = budget(matching, *flown(matching, along))
    assert time.process_time() - begin < 2.0 and len(found.sources) >= 12 and len(found.states) == 16
