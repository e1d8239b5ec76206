"""filterpy: Kalman filters and smoothers in NumPy."""

import numpy as np
from mpmath import mp

from boresight.evidence.crossed import exact, flights
from boresight.evidence.crossed.judge import THEIRS, Check, Numbers, Peer
from boresight.runtime.library import load


def fly():
    """Its filter over the same steps: the filter, and its states and covariances after each."""
    from filterpy.kalman import KalmanFilter

    _, _, P0, steps, _ = flights.filtered()
    loop, means, covariances = KalmanFilter(dim_x=6, dim_z=3), [np.zeros((6, 1))], [P0]
    loop.x, loop.P = means[0], P0
    for Phi, Q, H, R, z in steps:
        loop.predict(F=Phi, Q=Q)
        loop.update(z[:, None], R=R, H=H)
        means.append(loop.x)
        covariances.append(loop.P)
    return loop, np.array(means), np.array(covariances)


def updated() -> Numbers:
    ours, _, P0, steps, _ = flights.filtered()
    loop, _, _ = fly()
    true = exact.filtered(np.zeros(6), P0, steps)
    return Numbers([ours.x, ours.P], [loop.x, loop.P], list(true[:2]), 0.05, 20 * 40)


def nis() -> Numbers:
    _, _, P0, steps, found = flights.filtered()
    loop, _, _ = fly()
    theirs = loop.y.T @ np.linalg.inv(loop.S) @ loop.y
    true = exact.filtered(np.zeros(6), P0, steps)[2]
    return Numbers(found.nis, theirs, true, float(true), 20 * 40)


def smoothed() -> Numbers:
    from boresight.analysis.smoother import smooth

    _, record, P0, steps, _ = flights.filtered()
    found = smooth(record)
    loop, means, covariances = fly()
    eye = [np.eye(6)]
    x, P, _, _ = loop.rts_smoother(
        means, covariances, Fs=eye + [step[0] for step in steps], Qs=eye + [step[1] for step in steps]
    )
    return Numbers([found.x[0], found.P[0]], [x[0], P[0]], list(exact.smoothed(P0, steps)), 0.05, 20 * 200)


def noise() -> Numbers:
    from filterpy.common import van_loan_discretization

    given = {
        "q_b2n_wxyz": flights.start()[0],
        "omega_in_n": np.array([4e-3, -6e-3, 5e-3]),
        "gyro_noise": np.full(3, 1e-4),
    }
    library, dt = load("euler-matching"), 10.0
    G = np.zeros((6, 6))
    G[:3, :3] = 1e-4 * np.eye(3)
    F = library.F(omega_in_n=given["omega_in_n"])
    _, theirs = van_loan_discretization(F, G, dt)
    _, true = exact.discrete(F, G @ G.T, mp.mpf(dt))
    return Numbers(library.Q(**given, dt=dt), theirs, true, 1e-7, 200)


PEER = Peer("filterpy", __file__,
    (
        Check("state and covariance after 20 updates", "rad, rad^2", updated, flights.LOOP),
        Check("NIS of the 20th update", "1", nis, flights.LOOP),
        Check("first state, smoothed over 20 steps", "rad, rad^2", smoothed, flights.SMOOTHER),
        Check("process noise over 10 s", "rad^2", noise, ("euler_matching",), THEIRS,
              "the generated Q is a rule of second order in the step; the peer has the exponential"),
    ),
)  # fmt: skip
