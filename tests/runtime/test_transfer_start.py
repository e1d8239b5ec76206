"""The first message, late and of unknown age: the slave that is handed over, and P beside its errors.

Held against the independent simulator; NEES in its 99.9 % band; seeds fixed beforehand.
"""

import numpy as np
import pytest
from scipy.stats import chi2

from boresight import BoresightError
from boresight.evidence.flights.motion import DEG, Motion, matrix, quaternion, swinging, turn, turn_between, waves
from boresight.runtime.library import load
from boresight.runtime.transfer import Increments, Message, first
from boresight.runtime.units import HOUR, STANDARD_GRAVITY

RUNS = 60
C_B2M = matrix(np.array([0.4, -0.3, 2.0]) * DEG)
SIGMAS = {"q_b2m_wxyz": 0.02, "gyro_bias": 1e-4, "accel_bias": 0.01, "tau": 0.01}
CONSTANTS = {"lever_b": np.array([1.0, -2.0, 1.5]), "gyro_noise": np.full(3, 3e-5), "accel_noise": np.full(3, 1e-3),
             "gyro_bias_noise": np.full(3, 1e-6), "accel_bias_noise": np.full(3, 1e-5), "mu_noise": np.full(3, 1e-5),
             "tau_noise": 1e-6}  # fmt: skip


def rolling():
    """Roll of 6 deg/s."""
    return Motion(swing=waves(([6 * DEG / (2 * np.pi * 0.17), 0, 0], 0.17, [0, 0, 0])), steady=np.array([7.0, 4.0, 0]))


@pytest.fixture(scope="module")
def model(compiled_once):
    return load("velocity-attitude")


# One sigma of a slave and a master: rad/s, m/s^2, their white noise, m/s, rad.
PLAIN = {"gyro_bias": 10 * DEG / HOUR, "accel_bias": 1e-3 * STANDARD_GRAVITY, "gyro_noise": 3e-5, "accel_noise": 1e-3,
         "velocity": 0.02, "attitude": 0.3e-3}  # fmt: skip
MOUNTING = np.array([0.6, 0.6, 2.0]) * DEG


def handed_over(model, motion, tau, *, believed=0.0, sigma=0.05, hz=50, after=0.2, unit=PLAIN, seed=11):
    """NEES (runs,) of nav that `first` makes of a message stamped 0 that saw what was tau (runs,) before, and of the
    increments until `after`."""
    rng, runs, lever_b = np.random.default_rng(seed), len(tau), np.array([1.2, -2.4, 1.8])
    edges = np.arange(-round((0.3 + believed) * hz), round(after * hz) + 1) / hz
    dt = 1 / hz
    bias = [unit[name] * rng.standard_normal((runs, 3)) for name in ("gyro_bias", "accel_bias")]
    noise = [unit[name] * np.sqrt(dt) for name in ("gyro_noise", "accel_noise")]
    dtheta, dv = (
        part[:, None] + b * dt + n * rng.standard_normal((len(part), runs, 3))
        for part, b, n in zip(motion.increments(edges), bias, noise, strict=True)
    )
    v, C = motion.master(-tau, lever_b, C_B2M)
    q = quaternion(turn(unit["attitude"] * rng.standard_normal((runs, 3))) @ C)
    R = np.repeat([unit["velocity"], unit["attitude"]], 3) ** 2
    opening = Message(np.zeros(runs), R, v_m_n=v + unit["velocity"] * rng.standard_normal((runs, 3)), q_m2n_wxyz=q,
                      position=motion.position(-tau))  # fmt: skip
    constants = CONSTANTS | {name: np.full(3, unit[name]) for name in ("gyro_noise", "accel_noise")}
    q_b2m = quaternion(turn(MOUNTING * rng.standard_normal((runs, 3))) @ C_B2M)
    nav, P = first(
        opening, model, constants | {"lever_b": lever_b}, increments=Increments(edges[:-1], edges[1:], dtheta, dv),
        sigmas={"q_b2m_wxyz": MOUNTING, "gyro_bias": unit["gyro_bias"], "accel_bias": unit["accel_bias"], "tau": sigma},
        estimates={"q_b2m_wxyz": q_b2m, "tau": believed},
    )  # fmt: skip
    now = edges[-1]
    error = np.concatenate([
        turn_between(nav["q_b2n_wxyz"], motion.C_b2n(now)), nav["v_n"] - motion.velocity(np.array(now))[0],
        nav["gyro_bias"] - bias[0], nav["accel_bias"] - bias[1], turn_between(nav["q_b2m_wxyz"], C_B2M),
        (nav["tau"] - tau)[:, None],
    ], axis=-1)  # fmt: skip
    return np.einsum("ri,ri->r", error, np.linalg.solve(P, error[..., None])[..., 0])


def band(runs):
    """99.9 % of the means of so many NEES of sixteen states."""
    return chi2.ppf([0.0005, 0.9995], 16 * runs) / runs


def drawn(sigma, about=0.0):
    return about + sigma * np.random.default_rng(7).standard_normal(RUNS)


@pytest.mark.parametrize(
    ("sigma", "about", "hz"), [(1e-3, 0.035, 50), (1e-3, 0.035, 200), (0.05, 0.0, 50), (0.05, 0.0, 200)]
)
@pytest.mark.parametrize("motion", [rolling, swinging])
def test_what_is_handed_over_is_as_wrong_as_P_says(model, motion, sigma, about, hz):
    found = handed_over(model, motion(), drawn(sigma, about), believed=about, sigma=sigma, hz=hz)
    low, high = band(RUNS)
    assert low < found.mean() < high


def test_the_delay_is_handed_over_with_what_large_biases_do_over_it(model):
    """720 deg/h over 50 ms are 0.17 mrad, and the master is finer than that."""
    mems = {"gyro_bias": 0.2 * DEG, "accel_bias": 0.2, "gyro_noise": 1e-4, "accel_noise": 2e-3, "velocity": 3e-3,
            "attitude": 5e-5}  # fmt: skip
    found = handed_over(model, Motion(), drawn(0.05), unit=mems)
    assert found.mean() < band(RUNS)[1]  # a product of two has fewer large values than its variance says


def still(seconds, hz=100):
    """A slave at rest and level, turned by nothing but the Earth, which it knows to 1e-4 rad/s."""
    edges = np.arange(round(seconds * hz) + 1) / hz
    dv = np.tile([0, 0, -9.8 / hz], (len(edges) - 1, 1))
    return Increments(edges[:-1], edges[1:], np.zeros_like(dv), dv)


def cut(part):
    return Increments(*(values[part] for values in still(0.4)))


def message(time=0.2, **more):
    return Message(time, np.full(6, 1e-6), v_m_n=np.zeros(3), q_m2n_wxyz=np.array([1.0, 0, 0, 0]),
                   position=np.array([0.7, 0.2, 0.0]), **more)  # fmt: skip


@pytest.mark.parametrize(
    ("change", "line"),
    [
        ({}, "without increments nothing says how the slave moves; give increments, or rate_sigma"),
        ({"increments": cut(slice(30, None))}, "0.2000 s, and the increments begin at 0.3000 s"),
        ({"increments": cut(slice(None, 10))}, "0.2000 s, and the increments end at 0.1000 s"),
        ({"increments": cut(np.arange(40) != 25)}, "gap from 0.2500 s to 0.2600 s"),
        ({"sigmas": {k: v for k, v in SIGMAS.items() if k != "tau"}}, "sigmas holds no 'tau'"),
        ({"sigmas": {**SIGMAS, "tao": 1.0}}, r"'tao' \(did you mean 'tau'\?\)"),
        ({"estimates": {"gyro_bais": np.zeros(3)}}, r"'gyro_bais' \(did you mean 'gyro_bias'\?\)"),
    ],
)  # fmt: skip
def test_a_start_that_cannot_be_right_is_one_line(model, change, line):
    with pytest.raises(BoresightError, match=line):
        first(message(), model, CONSTANTS, **{"sigmas": SIGMAS, **change})


def test_an_unknown_motion_opens_attitude_by_rate_times_delay_and_velocity_by_rate_times_lever(model):
    _, P = first(message(), model, CONSTANTS, sigmas={**SIGMAS, "q_b2m_wxyz": 0.0}, rate_sigma=0.1,
                       acceleration_sigma=1.0)  # fmt: skip
    assert np.sqrt(P[0, 0]) == pytest.approx(np.hypot(1e-3, 0.1 * 0.01), rel=1e-3)
    # about x: the lever arm's z and y go with it; two axes of the rate reach each axis of the velocity
    assert np.sqrt(P[3, 3]) == pytest.approx(np.sqrt(1e-6 + 0.01 * (2.0**2 + 1.5**2) + (1.0 * 0.01) ** 2), rel=1e-2)


def test_a_constant_that_the_model_does_not_know_is_named(model):
    message = Message(0.0, np.full(6, 1e-4), v_m_n=np.zeros(3), q_m2n_wxyz=[1.0, 0, 0, 0], position=[0.7, 0.2, 50.0])
    with pytest.raises(BoresightError, match=r"constants holds .gyro_nois., which .*did you mean .gyro_noise."):
        first(message, model, CONSTANTS | {"gyro_nois": 0.0}, sigmas=SIGMAS, rate_sigma=0.1, acceleration_sigma=1.0)
