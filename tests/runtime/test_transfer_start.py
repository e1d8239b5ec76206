"""The first message, late and of unknown age: the slave that is handed over, and P beside its errors.

Held against the independent simulator; NEES in its 99.9 % band; seeds fixed beforehand.
"""

from dataclasses import replace

import numpy as np
import pytest

from boresight import BoresightError
from boresight.evidence.flights.fly import Unit, band, fly, nees
from boresight.evidence.flights.motion import DEG, Motion, matrix, quaternion, swinging, turn, waves
from boresight.runtime import rotation
from boresight.runtime.library import load
from boresight.runtime.transfer import Headings, Increments, Message, Transfer, Verdict, again, first
from boresight.runtime.transfer.lever import LeverOfMaster

RUNS = 60
C_B2M = matrix(np.array([0.4, -0.3, 2.0]) * DEG)
SIGMAS = {"q_b2m_wxyz": 0.02, "gyro_bias": 1e-4, "accel_bias": 0.01, "tau": 0.01}
CONSTANTS = {"lever_b": np.array([1.0, -2.0, 1.5]), "gyro_noise": np.full(3, 3e-5), "accel_noise": np.full(3, 1e-3),
             "gyro_bias_noise": np.full(3, 1e-6), "accel_bias_noise": np.full(3, 1e-5), "mu_noise": np.full(3, 1e-5),
             "tau_noise": 1e-6}  # fmt: skip


def rolling():
    """Roll of 6 deg/s."""
    return Motion(swing=waves(([6 * DEG / (2 * np.pi * 0.17), 0, 0], 0.17, [0, 0, 0])), steady=np.array([7.0, 4.0, 0]))


def within(values):
    low, high = band(len(values), 16)
    return low < values.mean() < high


@pytest.fixture(scope="module")
def model(compiled_once):
    return load("velocity-attitude")


def drawn(sigma, runs=RUNS, about=0.0):
    return about + sigma * np.random.default_rng(7).standard_normal(runs)


@pytest.mark.parametrize(
    ("sigma", "about", "imu_hz"), [(1e-3, 0.035, 50), (1e-3, 0.035, 200), (0.05, 0.0, 50), (0.05, 0.0, 200)]
)
@pytest.mark.parametrize("motion", [rolling, swinging])
def test_what_is_handed_over_is_as_wrong_as_P_says(model, motion, sigma, about, imu_hz):
    flown = fly(motion(), model=model, runs=RUNS, seed=11, tau=drawn(sigma, about=about), tau_believed=about,
                tau_sigma=sigma, hand_over=0.2, seconds=0.5, imu_hz=imu_hz)  # fmt: skip
    assert within(flown.start_nees)


def test_the_delay_is_handed_over_with_what_large_biases_do_over_it(model):
    """720 deg/h over 50 ms are 0.17 mrad, and the master is finer than that."""
    mems = Unit(gyro_bias=0.2 * DEG, accel_bias=0.2, gyro_noise=1e-4, accel_noise=2e-3, velocity=3e-3, attitude=5e-5)
    flown = fly(Motion(), model=model, runs=RUNS, seed=11, unit=mems, tau=drawn(0.05), hand_over=0.2, seconds=0.3)
    assert flown.start_nees.mean() < band(RUNS, 16)[1]  # a product of two has fewer large values than its variance says


@pytest.mark.parametrize(("master_hz", "sigma", "about"), [(1, 0.05, 0.0), (5, 0.05, 0.0), (50, 1e-3, 0.035)])
def test_and_so_it_is_after_the_messages_that_follow(model, master_hz, sigma, about):
    flown = fly(swinging(), model=model, runs=30, seed=11, tau=drawn(sigma, 30, about), tau_believed=about,
                tau_sigma=sigma, master_hz=master_hz, hand_over=0.2, seconds=0.2 + 10 / master_hz + 0.1)  # fmt: skip
    assert within(flown.nees[2]) and within(flown.nees[-1])
    assert (flown.verdict <= Verdict.ABSENT).all()  # nothing is too old: the past is handed over too


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
    _, P, past = first(message(), model, CONSTANTS, sigmas={**SIGMAS, "q_b2m_wxyz": 0.0}, rate_sigma=0.1,
                       acceleration_sigma=1.0)  # fmt: skip
    assert past is None
    assert np.sqrt(P[0, 0]) == pytest.approx(np.hypot(1e-3, 0.1 * 0.01), rel=1e-3)
    # about x: the lever arm's z and y go with it; two axes of the rate reach each axis of the velocity
    assert np.sqrt(P[3, 3]) == pytest.approx(np.sqrt(1e-6 + 0.01 * (2.0**2 + 1.5**2) + (1.0 * 0.01) ** 2), rel=1e-2)


def test_a_new_beginning_keeps_what_was_estimated_and_its_block_of_P(model):
    rng = np.random.default_rng(4)
    root = rng.standard_normal((16, 16)) * np.repeat([1e-3, 0.1, 1e-5, 1e-2, 1e-3, 1e-3], [3, 3, 3, 3, 3, 1])[:, None]
    q = quaternion(matrix(np.array([0.1, 0.2, 0.3])))
    nav = {"lat_lon_height": np.zeros(3), "v_n": np.ones(3), "q_b2n_wxyz": q,
           "gyro_bias": np.full(3, 1e-4), "accel_bias": np.full(3, 0.02), "tau": np.array(0.013),
           "q_b2m_wxyz": quaternion(C_B2M)}  # fmt: skip
    begun, P, past = again(message(), model, CONSTANTS, nav, root @ root.T, seconds=100.0, walk={"gyro_bias": 2e-6},
                           increments=still(0.4))  # fmt: skip
    for name in ("gyro_bias", "accel_bias", "tau", "q_b2m_wxyz"):
        np.testing.assert_array_equal(begun[name], nav[name])
    opened = (root @ root.T)[6:, 6:]
    opened[range(10), range(10)] += 100 * np.repeat([1e-6**2 + 2e-6**2, 1e-5**2, 1e-5**2, 1e-6**2], [3, 3, 3, 1])
    # and 0.2 s of the model's own noise on the way to now
    np.testing.assert_allclose(P[6:, 6:], opened, rtol=1e-3, atol=1e-13)
    # attitude is the master's, through the mounting, not what it was
    np.testing.assert_allclose(rotation.matrix_from_quaternion(begun["q_b2n_wxyz"]), C_B2M, atol=1e-4)
    np.testing.assert_allclose(P[:3, 12:15], opened[6:9, 6:9], rtol=0.01, atol=1e-9)
    loop = Transfer(model, begun, P, CONSTANTS, time=0.4, past=past)
    assert loop.master(replace(message(0.3), rows=True)).taken


# ---------------------------------------------------------------- the lever arm in the master's axes


def test_a_lever_arm_in_the_masters_axes_enters_H_as_the_mounting_turns_it(model):
    owner = LeverOfMaster(model)
    rng = np.random.default_rng(3)
    fields = {"lat_lon_height": np.array([0.7, 0.2, 50.0]), "v_n": np.array([7.0, 4.0, 0.1]), "a_n": np.zeros(3),
              "lag": 0.0, "q_b2n_wxyz": quaternion(turn(rng.standard_normal(3))),
              "omega_ib_b": np.array([0.2, -0.1, 0.3]), "v_m_n": np.zeros(3),
              "lever_m": np.array([18.0, -19.0, 14.0])}  # fmt: skip
    error = rng.standard_normal(3)

    def z(size):
        q = quaternion(turn(-size * error) @ C_B2M)  # C_hat = exp(-[dmu x]) C
        return owner.velocity_z(**{n: (fields | {"q_b2m_wxyz": q})[n] for n in owner.velocity_z.fields})

    at = fields | {"q_b2m_wxyz": quaternion(C_B2M)}
    column = owner.velocity_H(**{n: at[n] for n in owner.velocity_H.fields})[:, 12:15] @ error
    assert np.abs(column).max() > 1.0
    left = [np.abs(z(size) - z(0.0) - size * column).max() for size in (1e-3, 1e-4)]
    assert left[1] < left[0] / 80
    # with the same lever arm in the slave's axes all other columns, and z, are the model's own
    own = at | {"lever_b": C_B2M.T @ fields["lever_m"]}
    H = model.velocity_H(**{n: own[n] for n in model.velocity_H.fields})
    np.testing.assert_allclose(owner.velocity_H(**{n: at[n] for n in owner.velocity_H.fields})[:, :12], H[:, :12])


def test_thirty_metres_known_in_the_masters_axes_and_a_mounting_known_to_two_degrees_are_consistent(model):
    lever_b = 30 * np.array([0.6, -0.64, 0.48])
    flown = fly(swinging(), model=model, runs=30, seed=5, seconds=6, lever_b=lever_b,
                constants={"lever_m": C_B2M @ lever_b})  # fmt: skip
    assert within(flown.start_nees) and within(flown.nees[-1])


def test_a_sigma_of_the_lever_arm_in_the_masters_axes_is_turned_to_its_states():
    lever_b = 30 * np.array([0.6, -0.64, 0.48])
    wrong = 0.1 * np.random.default_rng(9).standard_normal((30, 3))
    flown = fly(swinging(), model="velocity-attitude-lever", runs=30, seed=5, seconds=4, lever_b=lever_b,
                constants={"lever_m": C_B2M @ lever_b + wrong}, sigmas={"lever_m": 0.1})  # fmt: skip
    assert within(flown.start_nees) and within(flown.nees_of(list(range(16)))[-1])


# ---------------------------------------------------------------- no heading from the master


def without_heading(time, said):
    euler = rotation.euler_from_matrix(rotation.matrix_from_quaternion(said.q_m2n_wxyz))
    return replace(said, q_m2n_wxyz=None, euler_m=euler * [1, 1, np.nan])


@pytest.mark.parametrize("yaw_deg", [3.0, 130.0, -95.0])
def test_a_heading_that_nobody_gives_is_found_from_all_round(model, yaw_deg):
    flown = fly(swinging(euler=np.array([0.0, 0.0, yaw_deg * DEG])), model=model, runs=8, seed=5, seconds=4, imu_hz=25,
                start=Headings, said=without_heading, tau=0.01, tau_sigma=0.02)  # fmt: skip
    assert flown.loop.settled
    assert any("one filter goes on in place of 48 candidates" in str(note) for note in flown.loop.notes)
    assert within(flown.nees[-1])
    heading, sigma = np.abs(flown.errors[-1, :, 2]), np.sqrt(flown.P[-1, :, 2, 2])
    assert (heading < 4 * sigma).all() and (sigma < 1 * DEG).all()


def test_a_vehicle_that_does_not_accelerate_keeps_all_its_headings(model):
    flown = fly(Motion(steady=np.array([8.0, 0.0, 0.0])), model=model, runs=2, seed=5, seconds=4, start=Headings,
                said=without_heading, tau=0.01, tau_sigma=0.02)  # fmt: skip
    assert not flown.loop.settled
    assert (nees(flown.errors[-1][:, [2]], flown.P[-1][:, 2:3, 2:3]) < 15).all()


def test_a_constant_that_the_model_does_not_know_is_named(model):
    message = Message(0.0, np.full(6, 1e-4), v_m_n=np.zeros(3), q_m2n_wxyz=[1.0, 0, 0, 0], position=[0.7, 0.2, 50.0])
    with pytest.raises(BoresightError, match=r"constants holds .gyro_nois., which .*did you mean .gyro_noise."):
        first(message, model, CONSTANTS | {"gyro_nois": 0.0}, sigmas=SIGMAS, rate_sigma=0.1, acceleration_sigma=1.0)
