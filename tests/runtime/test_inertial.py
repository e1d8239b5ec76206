"""The strapdown integrator in C against truths that know nothing of it, and its inverse against itself."""

import numpy as np
import pytest
from analytic import NED2ENU, flight, integrals
from scipy.spatial.transform import Rotation

from boresight import BoresightError
from boresight.runtime.library import load
from boresight.runtime.rotation import attitude_error, quaternion_from_euler
from boresight.runtime.simulation.inertial import increments, integrate

SECONDS = 60
METRES = np.array([6.4e6, 6.4e6, 1.0])  # a longitude counts as at the equator: the strict side


@pytest.fixture(scope="module")
def strapdown(compiled_once):
    return load("strapdown")


def wxyz(C):
    return Rotation.from_matrix(C.reshape(-1, 3, 3)).as_quat(scalar_first=True).reshape(*C.shape[:-2], 4)


def flown(library, rate_hz):
    """Largest error of position (m), velocity (m/s) and attitude (deg) over the analytic flight."""
    known, t = flight(), np.arange(SECONDS * rate_hz + 1) / rate_hz
    position, v_n, q = known["position"](t), known["v_n"](t), wxyz(known["C_b2n"](t))
    dtheta, dv = integrals(SECONDS, rate_hz)
    start = {"lon_lat_height": position[0], "v_n": v_n[0], "q_b2n_wxyz": q[0]}
    made = integrate(library.step, start, dtheta[1:], dv[1:], 1 / rate_hz, first=(dtheta[0], dv[0]))
    return np.array([
        np.abs((made.position - position) * METRES).max(),
        np.abs(made.v_n - v_n).max(),
        np.degrees(np.abs(attitude_error(made.q_b2n_wxyz, q)).max()),
    ])  # fmt: skip


def test_strapdown_stays_on_an_analytic_flight_and_errs_with_the_third_power_of_the_step(strapdown):
    errors = [flown(strapdown, rate_hz) for rate_hz in (100, 50, 25)]
    assert errors[0][0] < 0.5e-3
    assert errors[0][2] < 2e-5
    orders = np.log2([errors[1] / errors[0], errors[2] / errors[1]])
    assert np.abs(orders - 3).max() < 0.1, orders


def test_strapdown_stays_on_the_flight_of_pyins(strapdown):
    """At sea level: pyins takes gravity as linear in height, which alone is 0.05 mm over these 60 s."""
    from pyins import sim, transform

    truth, imu = sim.generate_sine_velocity_motion(
        0.01, SECONDS, [50, 60, 0], [10, -5, 0], [3, 2, 1], velocity_change_period=20, sensor_type="increment"
    )
    lat, lon, height = truth[["lat", "lon", "alt"]].to_numpy().T
    position = np.column_stack([np.radians(lon), np.radians(lat), height])
    v_n = truth[["VN", "VE", "VD"]].to_numpy() @ NED2ENU
    q = wxyz(NED2ENU @ transform.mat_from_rph(truth[["roll", "pitch", "heading"]].to_numpy()) @ NED2ENU)
    dtheta = imu[["gyro_x", "gyro_y", "gyro_z"]].to_numpy() @ NED2ENU
    dv = imu[["accel_x", "accel_y", "accel_z"]].to_numpy() @ NED2ENU
    start = {"lon_lat_height": position[0], "v_n": v_n[0], "q_b2n_wxyz": q[0]}
    made = integrate(strapdown.step, start, dtheta[1:], dv[1:], 0.01)
    assert np.abs((made.position - position) * METRES).max() < 0.5e-3
    assert np.degrees(np.abs(attitude_error(made.q_b2n_wxyz, q)).max()) < 2e-5


def motions(seconds, rate_hz):
    """Three runs: the rolling flight, one fast and high, and one at rest; (position, v_n, q) with runs on axis 1."""
    t = np.arange(seconds * rate_hz + 1)[:, None] / rate_hz
    turn = np.array([[0.2, 0.1, 0.0], [0.02, 0.03, 0.0], [0, 0, 0]])
    euler = [0.1, 0.05, 0.4] + turn * np.sin(2 * np.pi * t[..., None] / [3, 4, 9])
    v_n = np.array([[60.0, 40, 1], [700.0, -600, 5], [0, 0, 0]])
    v_n = v_n + np.array([[8.0, 6, 3], [20.0, 10, 5], [0, 0, 0]]) * np.sin(2 * np.pi * t[..., None] / [7, 8, 11])
    position = np.array([[2.2, 0.6, 100], [2.2, 1.2, 25000], [2.2, 0.63, 120]])
    return position, v_n, quaternion_from_euler(euler)


def test_the_inverse_reproduces_its_trajectory(strapdown):
    """And the integrator with the inverse's increments keeps the velocities and attitudes that were asked for."""
    position, v_n, q = motions(SECONDS, 100)
    dtheta, dv, wanted = increments(strapdown.step, position, v_n, q, 0.01)
    made = integrate(strapdown.step, wanted.nav(0), dtheta, dv, 0.01)
    np.testing.assert_array_equal(wanted.v_n, v_n)
    np.testing.assert_array_equal(wanted.q_b2n_wxyz, q)
    assert np.abs((made.position - wanted.position) * METRES).max() < 1e-9
    assert np.abs(made.v_n - v_n).max() < 1e-10
    assert np.abs(attitude_error(made.q_b2n_wxyz, q)).max() < 1e-12
    assert np.ptp(wanted.position[:, 2], axis=0).max() == 0, "it moved at rest"


def test_the_inverse_finds_the_increments_of_the_analytic_flight(strapdown):
    """To what the integrator errs by in one step."""
    known, t = flight(), np.arange(10 * 100 + 1) / 100
    dtheta, dv, made = increments(
        strapdown.step, known["position"](0.0), known["v_n"](t), wxyz(known["C_b2n"](t)), 0.01
    )
    exact = integrals(10, 100)
    assert np.abs(dtheta - exact[0][1:])[1:].max() < 1e-9
    assert np.abs(dv - exact[1][1:])[1:].max() < 1e-7
    assert np.abs((made.position - known["position"](t)) * METRES).max() < 1e-4


def test_at_rest_the_sensors_see_the_earth_and_gravity(strapdown):
    position, v_n, q = np.array([2.2, 0.6, 50.0]), np.zeros((11, 3)), np.tile([1.0, 0, 0, 0], (11, 1))
    dtheta, dv, _ = increments(strapdown.step, position, v_n, q, 0.01)
    seen = strapdown.earth(lon_lat_height=position, v_n=np.zeros(3))
    np.testing.assert_allclose(dtheta / 0.01, np.broadcast_to(seen["omega_ie_n"], (10, 3)), atol=1e-13)
    np.testing.assert_allclose(dv / 0.01, np.broadcast_to(-seen["gravity_n"], (10, 3)), atol=1e-9)


def test_one_run_and_many_are_the_same(strapdown):
    position, v_n, q = motions(2, 100)
    dtheta, dv, wanted = increments(strapdown.step, position, v_n, q, 0.01)
    many = integrate(strapdown.step, wanted.nav(0), dtheta, dv, 0.01)
    start = {name: value[1] for name, value in wanted.nav(0).items()}
    one = integrate(strapdown.step, start, dtheta[:, 1], dv[:, 1], 0.01)
    np.testing.assert_array_equal(one.position, many.position[:, 1])
    np.testing.assert_array_equal(one.q_b2n_wxyz, many.q_b2n_wxyz[:, 1])


@pytest.mark.parametrize("how", [{}, {"lanes": 1}, {"precision": "float"}, {"backend": "casadi"}], ids=str)
def test_every_library_is_flown_by_its_own_function(how, compiled_once):
    """In lanes, without them, and where there are none: sample by sample, to the bit."""
    step, rng = load("strapdown", **how).step, np.random.default_rng(0)
    dtheta, dv = rng.normal(0, 1e-3, (20, 5, 3)), rng.normal(0, 0.1, (20, 5, 3))
    nav = {"lon_lat_height": np.array([0.1, 0.7, 10.0]), "v_n": rng.normal(size=(5, 3)), "q_b2n_wxyz": np.eye(4)[0]}
    made = integrate(step, nav, dtheta, dv, 0.01)
    none = {name: np.zeros(3) for name in ("gyro_bias", "accel_bias") if name in step.fields}
    for k, before in enumerate(np.maximum(np.arange(20) - 1, 0)):
        nav = step(**nav, **none, dtheta_ib_b=dtheta[k], dv_b=dv[k], dtheta_before=dtheta[before], dv_before=dv[before],
                   dt=0.01)  # fmt: skip
        for name, value in made.nav(k + 1).items():
            assert np.array_equal(nav[name], value), (name, k)


@pytest.mark.parametrize("how", [{}, {"lanes": 1}, {"precision": "float"}], ids=str)
def test_what_all_runs_share_is_spread_and_no_other_shape_is_flown(how, compiled_once):
    step, rng = load("strapdown", **how).step, np.random.default_rng(1)
    dtheta, dv = rng.normal(0, 1e-3, (6, 5, 3)), rng.normal(0, 0.1, (6, 3))
    start = {"lon_lat_height": np.array([0.1, 0.7, 10.0]), "v_n": np.zeros(3), "q_b2n_wxyz": np.eye(4)[0]}
    whole = np.repeat(dv[:, None], 5, axis=1)
    wanted = integrate(step, start, dtheta, whole, 0.01, (dtheta[0], whole[0]))
    made = integrate(step, start, dtheta, dv, 0.01, (dtheta[0], dv[0]))
    assert np.array_equal(made.v_n, wanted.v_n) and np.array_equal(made.q_b2n_wxyz, wanted.q_b2n_wxyz)
    alike = integrate(step, start | {"v_n": np.zeros((5, 3))}, dtheta[:, 0], dv, 0.01)
    assert np.array_equal(alike.v_n[:, 3], integrate(step, start, dtheta[:, 0], dv, 0.01).v_n)
    turned = integrate(step, start, dtheta[:1], whole[:1][::-1], 0.01)  # of one interval, whose stride says nothing
    assert np.array_equal(turned.v_n[1], integrate(step, start, dtheta[:1], whole[:1], 0.01).v_n[1])
    for one, other, dt, match in (
        (dtheta, whole[:-1], 0.01, r"dv has shape \(5, 5, 3\)"), (dtheta, whole[:1], 0.01, r"dv has shape \(1, 5, 3\)"),
        (dtheta[..., :2], whole, 0.01, "dtheta has shape"), (dtheta[0, 0], dv, 0.01, r"dtheta has shape \(3,\)"),
        (dtheta, whole[:, :2], 0.01, "do not go together"), (dtheta, whole, np.full(6, 0.01), "dt has shape"),
        (dtheta, whole, np.nan, "in interval 0: step: dt"),
    ):  # fmt: skip
        with pytest.raises(BoresightError, match=match):
            integrate(step, start, one, other, dt)


def test_a_walk_goes_through_no_array_that_is_shorter(strapdown):
    T, zero = 4, np.zeros(3)
    out = {
        "lon_lat_height": np.zeros((T + 1, 2, 3)),
        "v_n": np.zeros((T + 1, 2, 3)),
        "q_b2n_wxyz": np.tile(np.eye(4)[0], (T + 1, 2, 1)),
    }
    given = {**out, **{name: np.zeros((T, 2, 3)) for name in ("dtheta_ib_b", "dv_b", "dtheta_before", "dv_before")},
             "dt": np.array([0.01])}  # fmt: skip
    given |= {name: zero for name in ("gyro_bias", "accel_bias") if name in strapdown.step.fields}
    ends = {name: values[1:] for name, values in out.items()}
    assert strapdown.step.walk(given, ends) == T
    for wrong in (np.zeros((T, 3)), np.zeros((T - 1, 2, 3)), np.zeros((T, 2, 3), np.float32), np.zeros((T, 3, 2)).mT):
        with pytest.raises(BoresightError, match=r"dv_b has shape .*; it must be \(4, 2, 3\)"):
            strapdown.step.walk(given | {"dv_b": wrong}, ends)


def test_rates_are_what_a_short_step_does(strapdown):
    position, v_n, q = motions(1, 100)
    f_b, omega = np.array([1.0, -2.0, 9.0]), np.array([0.3, -0.2, 0.1])
    nav = {"lon_lat_height": position, "v_n": v_n[50], "q_b2n_wxyz": q[50]}
    rates = strapdown.rates(**nav, f_b=f_b, omega_ib_b=omega)

    def slope(dt):
        made = strapdown.step(
            **nav, dtheta_ib_b=omega * dt, dv_b=f_b * dt, dtheta_before=omega * dt, dv_before=f_b * dt, dt=dt
        )
        return {name: (made[name] - nav[name]) / dt for name in nav}

    full, half = slope(2e-3), slope(1e-3)
    for name, rate in (("lon_lat_height", "position_rate"), ("v_n", "v_n_rate"), ("q_b2n_wxyz", "q_b2n_rate")):
        limit = 2 * half[name] - full[name]  # what is of first order in dt is taken out
        np.testing.assert_allclose(limit, rates[rate], atol=2e-5 * np.abs(rates[rate]).max(), err_msg=name)


def test_a_jump_that_no_sensor_could_follow_is_refused(strapdown):
    position, v_n, q = motions(1, 100)
    v_n = v_n.copy()
    v_n[50:] -= 150.0
    with pytest.raises(BoresightError, match="dv_b"):
        increments(strapdown.step, position, v_n, q, 0.01)


def test_leaving_the_box_names_the_field(strapdown):
    start = {"lon_lat_height": [0.0, 1.4835, 0.0], "v_n": [0.0, 900.0, 0.0], "q_b2n_wxyz": [1.0, 0, 0, 0]}
    with pytest.raises(BoresightError, match=r"lon_lat_height\[1\]"):
        integrate(strapdown.step, start, np.zeros((100, 3)), np.tile([0, 0, 9.8], (100, 1)), 1.0)


def errors_of(made, true):
    """[position, v_n, phi] of one flown trajectory against another, (T+1, 9)."""
    phi = attitude_error(made.q_b2n_wxyz, true.q_b2n_wxyz)
    return np.concatenate([made.position - true.position, made.v_n - true.v_n, phi], axis=-1)


def predicted(model, true, dtheta, dv, x):
    """The error x after the whole trajectory, by the model's own transition matrices in C, middle of step by middle."""
    first, last = true.nav(slice(None, -1)), true.nav(slice(1, None))
    middle = {name: (first[name] + last[name]) / 2 for name in first}
    q = middle["q_b2n_wxyz"] / np.linalg.norm(middle["q_b2n_wxyz"], axis=-1, keepdims=True)
    f_n = np.einsum("kij,kj->ki", Rotation.from_quat(q, scalar_first=True).as_matrix(), dv / true.dt)
    for Phi in model.Phi(lon_lat_height=middle["lon_lat_height"], v_n=middle["v_n"], f_n=f_n, dt=true.dt):
        x = Phi @ x
    return x


def test_the_generated_error_models_foretell_how_two_strapdown_runs_part(strapdown):
    """What they do not foretell is of second order: half the first error leaves a quarter, for phi and for psi."""
    phi, psi = load("phi-error"), load("psi-error")
    position, v_n, q = (part[..., 0, :] for part in motions(100, 20))
    dtheta, dv, true = increments(strapdown.step, position, v_n, q, 0.05)
    x = np.array([2e-5, -3e-5, 200.0, 0.5, -0.3, 0.1, 2e-3, -1e-3, 4e-3])
    start, end = true.nav(0), true.nav(-1)
    there = phi.psi_from_phi(lon_lat_height=start["lon_lat_height"], v_n=start["v_n"])
    back = psi.phi_from_psi(lon_lat_height=end["lon_lat_height"], v_n=end["v_n"])
    scale = np.array([5e6, 6e6, 1, 1, 1, 1, 1, 1, 1])
    left = []
    for s in (1.0, 0.5):
        wrong = {name: start[name] + s * x[part] for name, part in ((true.place, slice(0, 3)), ("v_n", slice(3, 6)))}
        turn = Rotation.from_rotvec(-s * x[6:])  # C_hat = exp(-[phi x]) C
        wrong["q_b2n_wxyz"] = (turn * Rotation.from_quat(start["q_b2n_wxyz"], scalar_first=True)).as_quat(
            scalar_first=True
        )
        parted = errors_of(integrate(strapdown.step, wrong, dtheta, dv, 0.05), true)[-1]
        by_phi = predicted(phi, true, dtheta, dv, s * x)
        by_psi = back @ predicted(psi, true, dtheta, dv, there @ (s * x))
        left.append([(parted - guess) * scale / s for guess in (by_phi, by_psi)])
        for guess in (by_phi, by_psi):
            for block in (slice(0, 3), slice(3, 6), slice(6, 9)):
                whole = np.linalg.norm((parted * scale)[block])
                assert np.linalg.norm(((parted - guess) * scale)[block]) < 0.01 * whole
    for full, half in zip(*left, strict=True):
        for block in (slice(0, 3), slice(3, 6), slice(6, 9)):
            assert abs(np.linalg.norm(half[block]) / np.linalg.norm(full[block]) - 0.5) < 0.01
