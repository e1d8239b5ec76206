"""What the messages tell of the delay: as much as they would with the true rates in H, and no more.

The witness flies the same recursion with sensors that have no errors, so that H holds the true rates.
"""

import numpy as np
import pytest

from boresight.evidence.flights.fly import Unit, band, fly
from boresight.evidence.flights.motion import DEG, Motion, parked, waves
from boresight.runtime.transfer import Rules
from boresight.runtime.transfer.delay import without
from boresight.runtime.transfer.history import TAU

RUNS, SECONDS = 20, 30.0
TRUE = Unit(gyro_bias=1e-10, accel_bias=1e-8, gyro_noise=1e-9, accel_noise=1e-8, mounting=(1e-9, 1e-9, 1e-9),
            velocity=1e-9, attitude=1e-11)  # fmt: skip


def circle(speed, rate):
    """A velocity that turns with a heading that begins at 0.6 rad."""

    def at(t):
        angle = 0.6 + rate * np.asarray(t, float)
        c, s, zero = speed * np.cos(angle), speed * np.sin(angle), 0 * angle
        along, across = np.stack([c, s, zero], -1), np.stack([-s, c, zero], -1)
        return np.array([along, rate * across, -(rate**2) * along])

    return Motion(sway=at, yaw_rate=rate, seconds=SECONDS + 2)


MOTIONS = {
    "ship": circle(8.0, 1 * DEG), "loiter": circle(25.0, 5 * DEG), "turntable": circle(0.0, 10 * DEG),
    "parked": parked(seconds=SECONDS + 2),
    "roll": Motion(swing=waves(([0.2 * DEG, 0, 0], 0.15, [0, 0, 0])), seconds=SECONDS + 2),
}  # fmt: skip


def sigma(flight):
    return np.sqrt(flight.P[..., TAU, TAU]).mean(1)


@pytest.mark.parametrize("motion", MOTIONS)
def test_the_delay_is_known_as_well_as_the_true_rates_make_it(motion):
    flown = {"seconds": SECONDS, "imu_hz": 50, "hand_over": 0.2, "lost": 0.0}
    tau = 0.05 * np.random.default_rng(5).standard_normal(RUNS)
    flight, unit = fly(MOTIONS[motion], runs=RUNS, tau=tau, **flown), Unit()
    true = fly(MOTIONS[motion], runs=1, tau=0.0, unit=TRUE, rules=Rules(delay_sigmas=0.0),
               R=np.repeat([unit.velocity, unit.attitude], 3) ** 2,
               sigmas={"gyro_bias": unit.gyro_bias, "accel_bias": unit.accel_bias, "q_b2m_wxyz": unit.mounting},
               constants={"gyro_noise": np.full(3, 3e-5), "accel_noise": np.full(3, 1e-3)}, **flown)  # fmt: skip
    late = flight.time > 5.0
    assert (sigma(flight)[late] > 0.95 * sigma(true)[late]).all()
    assert (sigma(flight)[late] < 1.2 * sigma(true)[late]).all()
    assert band(RUNS, 1)[0] < flight.nees_of([TAU])[-1].mean() < band(RUNS, 1)[1]
    low, high = band(RUNS, 16)
    assert low < flight.nees[-1].mean() < high


def test_information_is_taken_out_as_if_it_had_never_come():
    rng = np.random.default_rng(1)
    root = rng.standard_normal((16, 20))
    P = root @ root.T
    e = np.eye(16)[TAU]
    told = np.linalg.inv(np.linalg.inv(P) + 0.3 * np.outer(e, e))
    x, back = without(np.array(0.3), np.zeros(16), told, np.zeros(16), P)
    np.testing.assert_allclose(back, P, rtol=1e-9, atol=1e-9)
    _, all_of_it = without(np.array(np.inf), np.zeros(16), told, np.zeros(16), P)
    np.testing.assert_allclose(all_of_it, P, rtol=1e-9, atol=1e-9)
    nu = told @ e  # what a measurement of the delay alone moves
    x, _ = without(np.array(np.inf), nu, told, np.zeros(16), P)
    np.testing.assert_allclose(x, 0.0, atol=1e-9)
