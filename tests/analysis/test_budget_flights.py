"""The error budget beside flights: many runs of the nonlinear C, whose errors scatter as the budget says.

For a right belief and three wrong ones.  The mean square of each state's error at each update, over its variance, is
chi-square over the runs; every one of them lies in its band, at 99.9 % for all together.
"""

import numpy as np
import pytest
from scipy.stats import chi2

from boresight import CompiledFilter, budget, load, rotation
from boresight.analysis import nominal
from boresight.runtime.simulation import motions
from boresight.simulation import hull, inertial

SECONDS, NAVIGATION_HZ, STEP_HZ = 20, 50, 10
EVERY = NAVIGATION_HZ // STEP_HZ
# Angles at the start are so small that their squares are below the noise of the master.
TRUE = ("dmu 0.1, 0.1, 0.2 deg", "gyro_noise 0.3 deg/sqrt(h)")
CASES = {
    "right": {},
    "noise": {"believe": ("gyro_noise 0.05 deg/sqrt(h)", "velocity 3 cm/s")},
    "start": {"believe": ("dmu 0.03, 0.03, 0.05 deg", "d_gyro_bias 5 deg/h")},
    "omitted": {"omit": ("d_accel_bias", (9, 3))},
}
SURE = 0.999
MOTION = "s turn"


def case(model, name):
    """The budget of a case, its believed start, and the sizes of truth and belief."""
    along = nominal.nominal(model, MOTION, SECONDS, STEP_HZ, 1.0)
    true = nominal.settings(model) | nominal.sizes(TRUE, model)
    believed = true | nominal.sizes(CASES[name].get("believe", ()), model)
    start, steps = nominal.flight(model, along, true)
    thought = nominal.flight(model, along, believed)
    omitted = CASES[name].get("omit", (None, None))[0]
    how = {"believed": thought} if "believe" in CASES[name] else {}
    found = budget(model, start, steps, omitted=omitted and [omitted], **how)
    return found, sum(start.values()), sum(thought[0].values()), true, believed


def fly(model, name, runs, seed, begun=lambda loop: None):
    """Errors (updates, runs, 16) of closed loops, computed - true, before the first update and behind each.

    begun: is called with the filter before it flies.
    """
    _, true_P, P, true, believed = case(model, name)
    rng = np.random.default_rng(seed)
    dt = 1 / NAVIGATION_HZ
    times = np.arange(SECONDS * NAVIGATION_HZ + 1) * dt
    master = motions.motion(MOTION, times)
    lever = np.array(nominal.LEVER_B)
    slave = hull.carried(master, lever, np.array([1.0, 0, 0, 0]))
    place = np.array([nominal.LATITUDE, 0.0, 0.0])
    dtheta, dv, truth = inertial.increments(model.strapdown, place, slave.v_n[:, 0], slave.q_b2n_wxyz[:, 0], dt)

    root = np.linalg.cholesky(true_P + 1e-30 * np.eye(16))
    error = rng.standard_normal((runs, 16)) @ root.T
    gyro_bias, accel_bias = -error[:, 6:9], -error[:, 9:12]
    straight = np.array([1.0, 0, 0, 0])
    nav = {
        "lat_lon_height": np.broadcast_to(truth.position[0], (runs, 3)),
        "v_n": truth.v_n[0] + error[:, 3:6], "q_b2n_wxyz": rotation.turned(truth.q_b2n_wxyz[0], -error[:, :3]),
        "gyro_bias": np.zeros((runs, 3)), "accel_bias": np.zeros((runs, 3)),
        "q_b2m_wxyz": rotation.turned(straight, -error[:, 12:15]), "tau": error[:, 15],
    }  # fmt: skip
    loop = CompiledFilter(model, nav, P)
    if "omit" in CASES[name]:
        loop.disable(*CASES[name]["omit"][1])
    begun(loop)
    fields = model.Q.fields
    noise = {name: believed[name] * np.ones(3) for name in ("gyro_noise", "accel_noise")}
    noise |= {name: 0.0 if model.field[name]["size"] == 1 else np.zeros(3)
              for name in fields if name.endswith("_noise") and name not in noise}  # fmt: skip

    def white(name):
        return true[name] * np.sqrt(dt) * rng.standard_normal((runs, 3))

    errors = [error]
    before, summed = None, np.zeros((2, runs, 3))
    for k in range(len(dtheta)):
        sample = dtheta[k] + gyro_bias * dt + white("gyro_noise"), dv[k] + accel_bias * dt + white("accel_noise")
        earlier = before or sample
        loop.strapdown(dtheta_ib_b=sample[0], dv_b=sample[1], dtheta_before=earlier[0], dv_before=earlier[1], dt=dt)
        before, summed = sample, summed + np.array(sample)
        if (k + 1) % EVERY:
            continue
        omega, f = summed / (EVERY * dt)
        imu = {"omega_ib_b": omega - loop.nav["gyro_bias"], "f_b": f - loop.nav["accel_bias"]}
        loop.predict(**imu, **noise, dt=EVERY * dt)
        summed = np.zeros_like(summed)
        if (k + 1) % NAVIGATION_HZ:
            continue
        now = k + 1
        v_m = master.v_n[now, 0] + true["velocity"] * rng.standard_normal((runs, 3))
        q_m = rotation.turned(master.q_b2n_wxyz[now, 0], true["dcm"] * rng.standard_normal((runs, 3)))
        # the rate of now: the mean is that of half a step ago
        rate = slave.omega_nb_b[now, 0] + rotation.matrix_from_quaternion(truth.q_b2n_wxyz[now]).T @ earth(
            truth.v_n[now]
        )
        given = {"omega_ib_b": rate + gyro_bias - loop.nav["gyro_bias"], "lag": loop.nav["tau"]}
        R_v, R_a = (believed[name] ** 2 * np.ones(3) for name in ("velocity", "dcm"))
        loop.update("velocity", R_v, v_m_n=v_m, lever_b=lever, a_n=master.a_n[now, 0], **given)
        loop.update("dcm", R_a, q_m2n_wxyz=q_m, **given)
        loop.feedback()
        errors.append(np.concatenate([
            rotation.attitude_error(loop.nav["q_b2n_wxyz"], truth.q_b2n_wxyz[now]),
            loop.nav["v_n"] - truth.v_n[now],
            loop.nav["gyro_bias"] - gyro_bias,
            loop.nav["accel_bias"] - accel_bias,
            rotation.attitude_error(loop.nav["q_b2m_wxyz"], straight),
            np.reshape(loop.nav["tau"], (runs, 1)),
        ], axis=-1))  # fmt: skip
    return np.array(errors)


def earth(v_n):
    """Rate of the level against inertial space, at these velocities (..., 3) over the ground."""
    lat = nominal.LATITUDE
    transport = np.array([v_n[1], -v_n[0], -v_n[1] * np.tan(lat)]) / motions.RADIUS_M
    return motions.sensors.earth_rate_n(lat) + transport


def ratios(model, name, runs, seed=1):
    """(updates, 16) mean square of the errors over their true variance, and over the variance that is believed."""
    found = case(model, name)[0]
    square = np.mean(fly(model, name, runs, seed) ** 2, axis=1)
    at = [found.at(second) for second in range(SECONDS + 1)]
    believed = found.P_variances[at]
    return square / found.whole[at], square / np.where(believed > 0, believed, np.inf)


def band(runs, count):
    part = (1 - SURE) / count / 2
    return chi2.ppf(part, runs) / runs, chi2.ppf(1 - part, runs) / runs


@pytest.mark.parametrize("name", CASES)
def test_flights_scatter_as_the_budget_says(name):
    model, runs = load("velocity-attitude"), 300
    true, believed = ratios(model, name, runs)
    low, high = band(runs, len(CASES) * true.size)
    assert ((true > low) & (true < high)).all(), (true.min(), true.max(), low, high)
    if name != "right":  # what the filter believes is refuted by the same band
        assert (believed > high).any()


if __name__ == "__main__":
    import sys

    model, runs = load("velocity-attitude"), int(sys.argv[1])
    for name in CASES:
        true, believed = ratios(model, name, runs)
        low, high = band(runs, len(CASES) * true.size)
        print(f"{name:<8} mean square over true variance {true.min():.3f} to {true.max():.3f}, band {low:.3f} to "
              f"{high:.3f}; over the filter's up to {believed.max():.2f}")  # fmt: skip
