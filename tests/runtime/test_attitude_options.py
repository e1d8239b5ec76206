"""Compositions of velocity-attitude: what they add is seen, carried and corrected with its sign, and is consistent."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pytest
from numpy_euler_matching import exp, matrix, quaternion

from boresight.runtime import rotation, transfer
from boresight.runtime.library import load
from boresight.runtime.live import Live
from boresight.runtime.simulation import hull, inertial, sensors
from boresight.runtime.transfer import Message
from boresight.studies.explorations.sea_state import pitched

DEG = np.pi / 180
POSITION = np.array([0.61, 2.1, 12.0])
RUNS = 24
MOUNTING = np.array([0.5, 0.5, 2.0]) * DEG


NONE = {"lat_lon_height": POSITION, "v_n": np.zeros(3), "q_b2n_wxyz": np.eye(4)[0], "q_b2m_wxyz": np.eye(4)[0],
        "tau": 0.0, "gyro_bias": np.zeros(3), "accel_bias": np.zeros(3), "gyro_turn_on": np.zeros(3),
        "accel_turn_on": np.zeros(3), "gyro_bias_beta": np.zeros(3), "accel_bias_beta": np.zeros(3),
        "lever_b": np.zeros(3), "a_n": np.zeros(3), "lag": 0.0, "omega_ib_b": np.zeros(3),
        "f_b": np.array([0, 0, -9.8]), "dtheta_ib_b": np.zeros(3), "dv_b": np.zeros(3),
        "dtheta_before": np.zeros(3), "dv_before": np.zeros(3), "flexure": np.zeros(3),
        "flexure_rate": np.zeros(3), "flexure_omega": np.ones(3), "flexure_damping": np.zeros(3),
        "flexure_noise": np.zeros(3), "gyro_scale": np.zeros(3), "accel_scale": np.zeros(3),
        "gyro_axes": np.zeros(6), "accel_axes": np.zeros(3), "x": np.zeros(46)}  # fmt: skip
LEVER, BENT, SCALED = slice(16, 19), slice(19, 25), slice(25, 40)  # of the states of the model with all of it


@pytest.fixture(scope="module")
def base():
    return load("velocity-attitude")


@pytest.fixture(scope="module")
def lever():
    return load("velocity-attitude-lever")


@pytest.fixture(scope="module")
def whole():
    """Bending, scale factors and axes, which the options of examples/velocity_attitude_options.py are made of too."""
    return load("velocity-attitude-sensors")


def of(unit, **fields):
    """A function of the model where what is not given is nothing."""
    return unit(**{name: fields.get(name, NONE.get(name)) for name in unit.fields})


# ---------------------------------------------------------------- signs, against finite differences of exact mechanics


def drawn(seed):
    rng = np.random.default_rng(seed)
    return {
        "C": matrix(unit(rng)), "mount": matrix(unit(rng)), "v": rng.uniform(-9, 9, 3),
        "omega": rng.uniform(-0.4, 0.4, 3), "lever": rng.uniform(-8, 8, 3), "rng": rng,
    }  # fmt: skip


def unit(rng):
    q = rng.standard_normal(4)
    return q / np.linalg.norm(q)


def first_order(z, H, states, direction, sizes=(1e-4, 1e-5), floor=1e-12):
    """z(size) follows H: a tenth of the error leaves a hundredth, or nothing but rounding."""
    column = H[:, states] @ direction
    left = [np.abs(z(size) - z(0.0) - size * column).max() for size in sizes]
    assert np.abs(column).max() > 0.01
    assert left[0] < 30 * sizes[0] ** 2 + floor
    assert left[1] < left[0] / 80 + floor


def at_truth(d, omega_hull=None, C_b2m=None):
    """What the master reports of a slave as drawn, and the fields that both sides share."""
    C_b2m = d["mount"] if C_b2m is None else C_b2m
    level = np.zeros(3)  # at the pole's height of nothing: the level's own rate cancels to 1e-4 m/s, and is the same
    v_m = d["v"] - d["C"] @ np.cross(d["omega"] if omega_hull is None else omega_hull, d["lever"]) + level
    return {"lat_lon_height": POSITION, "v_n": d["v"], "a_n": np.zeros(3), "lag": 0.0}, v_m, d["C"] @ C_b2m.T


def test_velocity_sees_the_lever_arm_and_feedback_corrects_it(lever, base):
    for seed in range(5):
        d = drawn(seed)
        shared, v_m, _ = at_truth(d)
        error = d["rng"].standard_normal(3)

        def z(size, d=d, shared=shared, v_m=v_m, error=error):
            return lever.velocity_z(**shared, q_b2n_wxyz=quaternion(d["C"]), omega_ib_b=d["omega"], v_m_n=v_m,
                                    lever_b=d["lever"] + size * error)  # fmt: skip

        fields = {"lat_lon_height": POSITION, "v_n": d["v"], "q_b2n_wxyz": quaternion(d["C"]), "omega_ib_b": d["omega"],
                  "lever_b": d["lever"], "a_n": np.zeros(3)}  # fmt: skip
        H = lever.velocity_H(**fields)
        np.testing.assert_array_equal(H[:, :16], base.velocity_H(**fields))
        first_order(z, H, slice(16, 19), error)
        x = np.zeros(19)
        x[16:] = error
        out = lever.feedback(x=x, v_n=d["v"], q_b2n_wxyz=quaternion(d["C"]), gyro_bias=np.zeros(3), tau=0.0,
                             accel_bias=np.zeros(3), q_b2m_wxyz=quaternion(d["mount"]),
                             lever_b=d["lever"] + error)  # fmt: skip
        np.testing.assert_allclose(out["lever_b"], d["lever"], atol=1e-14)


@pytest.mark.parametrize("seen", ["velocity", "dcm", "quaternion"])
def test_measurements_see_bending_and_its_rate(whole, seen):
    """The mounting is bent: C_b2m = exp([bend x]) C_mounting; the slave's gyros feel its rate, the hull does not."""
    for seed in range(5):
        d = drawn(seed)
        bend, rate = 1e-6 * d["rng"].standard_normal((2, 3))
        C_b2m = exp(bend) @ d["mount"]
        hull_rate = d["omega"] - C_b2m.T @ rate
        shared, v_m, C_m2n = at_truth(d, hull_rate, C_b2m)
        error = d["rng"].standard_normal(6)
        fields = {**shared, "q_b2n_wxyz": quaternion(d["C"]), "omega_ib_b": d["omega"], "lever_b": d["lever"],
                  "v_m_n": v_m, "q_m2n_wxyz": quaternion(C_m2n), "q_b2m_wxyz": quaternion(d["mount"]),
                  "flexure": bend, "flexure_rate": rate}  # fmt: skip

        def z(size, seen=seen, fields=fields, bend=bend, rate=rate, error=error):
            wrong = {"flexure": bend + size * error[:3], "flexure_rate": rate + size * error[3:]}
            return of(getattr(whole, f"{seen}_z"), **(fields | wrong))

        first_order(z, of(getattr(whole, f"{seen}_H"), **fields), BENT, error, floor=1e-9)


def test_the_bending_estimate_is_carried_as_its_error_and_as_the_process_it_is(whole, base):
    rng = np.random.default_rng(5)
    omega, damping, dt = np.array([0.5, 1.0, 4.0]), np.array([1.0, 0.0, 0.5]), 0.01
    bend, rate = 1e-3 * rng.standard_normal((2, 3))
    process = {"flexure_omega": omega, "flexure_damping": damping, "dt": dt}
    made = of(whole.strapdown, q_b2n_wxyz=unit(rng), flexure=bend, flexure_rate=rate, **process)
    q = unit(rng)
    Phi = of(whole.Phi, q_b2n_wxyz=q, **process)
    carried = np.concatenate([made["flexure"], made["flexure_rate"]])
    np.testing.assert_allclose(carried, Phi[BENT, BENT] @ np.concatenate([bend, rate]), rtol=1e-13)
    # a bias that could wander about its constant is one more factor: an ulp, and one of what is subtracted to nothing
    np.testing.assert_allclose(Phi[:16, :16], of(base.Phi, q_b2n_wxyz=q, dt=dt), rtol=5e-16, atol=1e-20)
    # the oscillator's closed forms, critically damped, undamped and half damped, to the third power of omega dt
    t, at_half = dt, np.sqrt(0.75)
    closed = np.array([
        (bend[0] + (rate[0] + 0.5 * bend[0]) * t) * np.exp(-0.5 * t),
        bend[1] * np.cos(t) + rate[1] * np.sin(t),
        np.exp(-2 * t) * (bend[2] * np.cos(4 * at_half * t)
                          + (rate[2] + 2 * bend[2]) / (4 * at_half) * np.sin(4 * at_half * t)),
    ])  # fmt: skip
    np.testing.assert_allclose(made["flexure"], closed, atol=1e-3 * (4 * dt) ** 3)


def triads(rng, size):
    """K of the gyros and of the accelerometers (3, 3), the second lower triangular, and the 15 numbers in the order of
    the states: both diagonals, then row by row what lies beside them."""
    gyro, accel = size * rng.standard_normal((2, 3, 3))
    accel = np.tril(accel)
    beside = ~np.eye(3, dtype=bool)
    return gyro, accel, np.concatenate([
        np.diag(gyro), np.diag(accel), gyro[beside], accel[np.tril_indices(3, -1)]
    ])  # fmt: skip


FIELDS = {"gyro_scale": slice(0, 3), "accel_scale": slice(3, 6), "gyro_axes": slice(6, 12), "accel_axes": slice(12, 15)}


def fields(numbers):
    return {name: numbers[..., part] for name, part in FIELDS.items()}


def test_scaled_sensors_are_read_right_and_their_errors_enter_as_biases_in_proportion(whole, base):
    rng = np.random.default_rng(6)
    nav = {"lat_lon_height": POSITION, "v_n": rng.uniform(-9, 9, 3), "q_b2n_wxyz": unit(rng)}
    dt, omega, f = 0.01, rng.uniform(-0.5, 0.5, 3), rng.uniform(-12, 12, 3)
    gyro, accel, numbers = triads(rng, 0.03)
    bias_g, bias_a = 1e-3 * rng.standard_normal(3), 0.1 * rng.standard_normal(3)

    def step(library, dtheta, dv, **more):
        told = {"dtheta_ib_b": dtheta, "dv_b": dv, "dtheta_before": dtheta, "dv_before": dv, "dt": dt}
        return of(library.strapdown, **nav, **told, **more)

    shown_rate, shown_force = np.linalg.solve(np.eye(3) - gyro, omega), np.linalg.solve(np.eye(3) - accel, f)
    measured = (shown_rate + bias_g) * dt, (shown_force + bias_a) * dt
    read = step(whole, *measured, gyro_bias=bias_g, accel_bias=bias_a, **fields(numbers))
    ideal = step(base, omega * dt, f * dt)
    for name, value in ideal.items():
        np.testing.assert_allclose(read[name], value, atol=1e-14)
    # an error of K over a step, against Phi
    *_, error = triads(rng, 1e-3)
    wrong = step(whole, omega * dt, f * dt, **fields(error))
    grown = np.concatenate([
        rotation.attitude_error(wrong["q_b2n_wxyz"], ideal["q_b2n_wxyz"]), wrong["v_n"] - ideal["v_n"]
    ])  # fmt: skip
    Phi = of(whole.Phi, **nav, f_b=f, omega_ib_b=omega, dt=dt)
    calibrated = of(whole.Phi, **nav, f_b=shown_force, omega_ib_b=shown_rate, dt=dt, **fields(numbers))
    # a bias error is less by K, and an error of K multiplies what is shown and not what is true
    both = np.eye(6)
    both[:3, :3], both[3:, 3:] = np.eye(3) - gyro, np.eye(3) - accel
    np.testing.assert_allclose(calibrated[:6, 6:12], Phi[:6, 6:12] @ both, atol=1e-15)
    expected = Phi[:6, SCALED] @ error
    np.testing.assert_allclose(grown, expected, atol=0.01 * np.abs(expected).max())
    assert np.abs(expected[:3]).max() > 1e-6 and np.abs(expected[3:]).max() > 1e-5


# ---------------------------------------------------------------- closed loops


@dataclass(frozen=True)
class Extra:
    """What a composition adds to a flight: estimates at the start, their sigmas and their truth, in the order of its
    states; constants: what its functions ask for beside them."""

    start: dict[str, Any]
    sigma: Any  # (k,)
    truth: Any  # (U + 1 or 1, runs, k)
    constants: dict[str, Any] = field(default_factory=dict)


def closed_loop(
    library,
    motion,
    extra,
    states,
    *,
    lever,
    seconds,
    update_hz,
    bending=None,
    gains=None,
    seed=0,
    tau=(0.0, 0.01),
    askew=1.0,
):
    """errors (runs, n) and P (runs, n, n) at the end of flights of the live loop: 20 deg/h, 2 mg, a master of
    1 cm/s and 0.003 deg, 5 ms late.

    states: places of what is added; n is 16 and these, and what else the model has is nothing.
    tau: s, where the delay's estimate begins, and its sigma.  askew: of .5, .5 and 2 deg of mounting.
    """
    rate = 50
    dt, every = 1 / rate, rate // update_hz
    time = np.arange(seconds * rate + 2) * dt  # one more, by which the covariance is carried to the last
    streams = [sensors.generator(seed, run) for run in range(RUNS)]
    n = np.array([stream.standard_normal(9) for stream in streams])
    bias_g, bias_a, wrong = 20 * DEG / 3600 * n[:, :3], 0.02 * n[:, 3:6], n[:, 6:] * MOUNTING * askew
    delay, R = 0.005, np.repeat([0.01, 0.003 * DEG], 3) ** 2
    mounting = rotation.quaternion_from_matrix(rotation.matrix_from_vector(wrong))
    slave = hull.carried(hull.ride(motion, time), lever, mounting, bending)
    plain = load("velocity-attitude")
    dtheta, dv, true = inertial.increments(plain.strapdown, POSITION, slave.v_n, slave.q_b2n_wxyz, dt)
    if gains is not None:
        dtheta, dv = (np.einsum("rij,...rj->...ri", one, part) for one, part in zip(gains, (dtheta, dv), strict=True))
    master = hull.ride(motion, time[:-1:every, None] - delay)

    def message(update):
        noise = np.array([stream.standard_normal(6) for stream in streams])
        return Message(time=update / update_hz, R=R, v_m_n=master.v_n[update] + 0.01 * noise[:, :3],
                       q_m2n_wxyz=rotation.turned(master.q_b2n_wxyz[update], 0.003 * DEG * noise[:, 3:]),
                       position=true.position[update * every])  # fmt: skip

    first = message(0)
    nothing = dict.fromkeys(("gyro_bias_noise", "accel_bias_noise", "mu_noise"), np.zeros(3))
    walk = np.repeat([0.15 * DEG / 60, 0.05 / 60], 3)
    constants = {"lever_b": lever, "gyro_noise": walk[:3], "accel_noise": walk[3:], "tau_noise": 0.0, **nothing}
    sigmas = {"q_b2m_wxyz": MOUNTING * askew, "gyro_bias": 20 * DEG / 3600, "accel_bias": 0.02,
              "tau": tau[1]}  # fmt: skip
    nav, narrow = transfer.first(first, plain, constants, sigmas=sigmas, estimates={"tau": tau[0]}, rate_sigma=0.0,
                                 acceleration_sigma=0.0)  # fmt: skip
    narrow[:, :3, :3] += np.eye(3) * (0.1 * DEG) ** 2  # the master's first report is late, at 0.3 rad/s
    narrow[:, 3:6, 3:6] += np.eye(3) * 0.5**2
    n = len(library.states)
    added = np.arange(n)[states]
    P = np.zeros((RUNS, n, n))
    P[:, :16, :16] = narrow
    P[:, added, added] = np.square(extra.sigma)
    own = {name: NONE.get(name) for struct in library.manifest["filter"]["carried"] for name in library.layout[struct]}
    constants = {name: value for name, value in constants.items() if name not in own}
    nav = {**own, **nav, "lever_b": lever, **extra.start, **extra.constants}
    noise = walk * np.sqrt(dt) * np.array([stream.standard_normal((len(dtheta), 6)) for stream in streams])
    sensed = {"dtheta_ib_b": dtheta + bias_g * dt + np.moveaxis(noise, 0, 1)[..., :3],
              "dv_b": dv + bias_a * dt + np.moveaxis(noise, 0, 1)[..., 3:]}  # fmt: skip
    end_us = (np.arange(len(dtheta)) + 1) * 1_000_000 // rate
    messages = [message(update) for update in range(1, seconds * update_hz)]
    of_runs = {name: np.broadcast_to(value, (RUNS, *np.shape(NONE[name]))) for name, value in nav.items()}
    flown, P_end = [], []
    for run in range(RUNS):
        loop = Live(library, {"gate": 0.0, "astray": 0, "every": 5}, **constants)
        loop.begin(0, {name: value[run] for name, value in of_runs.items()}, P=P[run])
        for k in range(0, len(dtheta), every):
            if k == seconds * rate:  # P is carried to a message, also to one of which no row is there
                flown.append(loop.output(int(end_us[k - 1])))
                loop.message("velocity", int(end_us[k - 1]), R[:3], rows=0)
            part = slice(k, k + every)
            loop.sample(end_us[part], dt, **{name: value[part, run] for name, value in sensed.items()})
            if k // every < len(messages):
                one, at_us = messages[k // every], int(end_us[part][-1])
                loop.message("velocity", at_us, R[:3], v_m_n=one.v_m_n[run])
                loop.message("dcm", at_us, R[3:], q_m2n_wxyz=one.q_m2n_wxyz[run])
        covariance, at_us = loop.covariance()
        assert abs(end_us[-2] - 1e6 * delay - at_us) < 6e4  # by the delay as it is estimated
        P_end.append(covariance)
    now = {name: np.array([one[name] for one in flown]) for name in flown[0]}
    error = np.concatenate([
        rotation.attitude_error(now["q_b2n_wxyz"], true.q_b2n_wxyz[-2]), now["v_n"] - true.v_n[-2],
        now["gyro_bias"] - bias_g, now["accel_bias"] - bias_a, rotation.attitude_error(now["q_b2m_wxyz"], mounting),
        (now["tau"] - delay)[:, None], np.concatenate([now[name] for name in extra.start], axis=-1) - extra.truth,
    ], axis=-1)  # fmt: skip
    seen = [*range(16), *added]
    return error, np.array(P_end)[:, seen][:, :, seen]


def assert_consistent(error, P):
    """The mean NEES within the 99.9 % band of chi-square: one seed in a thousand may miss it, and this one does not."""
    from scipy.stats import chi2

    n = error.shape[-1]
    nees = np.einsum("ri,ri->r", error, np.linalg.solve(P, error[..., None])[..., 0])
    low, high = chi2.ppf([0.0005, 0.9995], n * RUNS) / RUNS
    assert low < nees.mean() < high, (low, nees.mean(), high)


def violent():
    """Roll of 15, pitch of 10 and yaw of 30 deg, and metres of surge, sway and heave: 0.3 to 0.5 g."""
    amplitude = np.array([[20.0, 15.0, 5.0, 15 * DEG, 10 * DEG, 30 * DEG]])
    return hull.sinusoids(amplitude, np.array([[0.0, 1.0, 2.0, 0.5, 1.5, 2.5]]), np.array([0.08]))


def test_a_lever_arm_that_is_wrong_by_a_third_of_a_metre_is_found(lever):
    rng = np.random.default_rng(7)
    lever_b, wrong = np.array([3.0, 1.0, -1.0]), 0.3 * rng.standard_normal((RUNS, 3))
    extra = Extra({"lever_b": lever_b + wrong}, np.full(3, 0.3), lever_b)
    error, P = closed_loop(lever, violent(), extra, LEVER, lever=lever_b, seconds=40, update_hz=1)
    sigma = np.sqrt(np.diagonal(P, axis1=-2, axis2=-1))[:, 16:]
    assert (sigma < 0.1).all()
    assert np.sqrt(np.mean(error[:, 16:] ** 2, axis=0)).max() < 0.05
    assert_consistent(error, P)
    assert_consistent(error[:, 16:], P[:, 16:, 16:])


def test_a_hull_that_heaves_says_nothing_of_the_lever_arm(lever):
    lever_b, wrong = np.array([3.0, 1.0, -1.0]), 0.3 * np.random.default_rng(7).standard_normal((RUNS, 3))
    extra = Extra({"lever_b": lever_b + wrong}, np.full(3, 0.3), lever_b)
    heave = hull.sinusoids(np.array([[0, 0, 1.0, 0, 0, 0]]), np.zeros((1, 6)), np.array([0.1]))
    error, P = closed_loop(lever, heave, extra, LEVER, lever=lever_b, seconds=20, update_hz=1)
    assert (np.sqrt(np.diagonal(P, axis1=-2, axis2=-1))[:, 16:] > 0.29).all()
    np.testing.assert_allclose(error[:, 16:], wrong, atol=0.05)


def test_scale_factors_and_axes_of_a_part_in_a_hundred_are_found_in_violent_motion(whole):
    rng = np.random.default_rng(8)
    gyro, accel, numbers = (np.array(part) for part in zip(*(triads(rng, 0.01) for _ in range(RUNS)), strict=True))
    gains = tuple(np.linalg.inv(np.eye(3) - K) for K in (gyro, accel))
    extra = Extra(fields(np.zeros((RUNS, 15))), np.full(15, 0.01), numbers)
    error, P = closed_loop(whole, violent(), extra, SCALED, lever=np.array([3.0, 1.0, -1.0]), seconds=40, update_hz=1,
                           gains=gains)  # fmt: skip
    sigma = np.sqrt(np.diagonal(P, axis1=-2, axis2=-1))[:, 16:]
    assert (sigma < 0.01 / 3).all(), sigma.max(0)
    assert_consistent(error, P)
    assert_consistent(error[:, 16:], P[:, 16:, 16:])


def test_bending_of_a_milliradian_is_followed_ten_times_a_second(whole):
    sigma_bend, correlation = 1e-3, 1.0
    streams = [sensors.generator(9, run) for run in range(RUNS)]
    bending = hull.bending(np.full(3, sigma_bend), correlation, hull.phases(streams, 3 * 40))
    seconds = 20
    at_end = [part[0] for part in bending.thrice(np.array([float(seconds)]))[:2]]
    beta = 1 / correlation
    extra = Extra(
        {"flexure": np.zeros((RUNS, 3)), "flexure_rate": np.zeros((RUNS, 3))},
        np.repeat([sigma_bend, sigma_bend * beta], 3),
        np.concatenate(at_end, axis=-1),
        {"flexure_omega": np.full(3, beta), "flexure_damping": np.ones(3),
         "flexure_noise": np.full(3, 2 * sigma_bend * beta**1.5)},
    )  # fmt: skip
    motion = pitched(np.array([0.0]))
    error, P = closed_loop(whole, motion, extra, BENT, lever=np.array([3.0, 1.0, -1.0]), seconds=seconds, update_hz=10,
                           bending=bending, tau=(0.0055, 1e-3), askew=0.05)  # fmt: skip
    sigma = np.sqrt(np.diagonal(P, axis1=-2, axis2=-1))
    # part of it is taken for misalignment, which differs from it only in that it lasts; about down more so
    assert (sigma[:, 16:19] < sigma_bend * np.array([0.52, 0.52, 0.7])).all()  # a tenth of a second behind a message
    np.testing.assert_allclose(np.std(error[:, 16:19], axis=0), sigma[:, 16:19].mean(0), rtol=0.3)
    assert_consistent(error[:, 16:], P[:, 16:, 16:])
    assert_consistent(error, P)
