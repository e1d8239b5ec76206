"""GTSAM: factor graphs; pre-integration on the manifold and in the tangent space."""

from functools import partial

import numpy as np
from mpmath import mp

from boresight.evidence.crossed import exact, flights
from boresight.evidence.crossed.judge import OURS, THEIRS, Check, Numbers, Peer


def turned(vector: np.ndarray) -> Numbers:
    import gtsam

    theirs = gtsam.Rot3.Expmap(vector).matrix()
    return flights.turn(vector, theirs)


def flown(part: int) -> Numbers:
    """In the level of the start, with its own words for the Earth: a constant gravity and the Earth's rate."""
    import gtsam

    begin, end, ours = flights.flown()
    gravity = float(exact.with_height(mp.mpf(flights.PLACE[1]), mp.mpf(0)))
    params = gtsam.PreintegrationParams(np.array([0.0, 0.0, -gravity]))
    params.setOmegaCoriolis(np.array(exact.earth_rate(mp.mpf(flights.PLACE[1])), float).ravel())
    sums = gtsam.PreintegratedImuMeasurements(params, gtsam.imuBias.ConstantBias())
    for _ in range(flights.SECONDS * flights.RATE_HZ):
        sums.integrateMeasurement(flights.FORCE, flights.OMEGA, 1 / flights.RATE_HZ)
    C = gtsam.Rot3(flights.start()[1])
    made = sums.predict(gtsam.NavState(C, np.zeros(3), flights.V_N), gtsam.imuBias.ConstantBias())
    theirs = made.position(), made.velocity(), made.attitude().matrix()
    right, own = (exact.in_level_of_start(begin, y)[part] for y in (end, ours))
    return Numbers(own, theirs[part], right, *flights.ROUNDINGS[part])


def smoothed() -> Numbers:
    """One linear graph of all steps; the misalignment, which does not change, is one variable."""
    import gtsam

    from boresight.analysis.smoother import smooth

    _, record, P0, steps, _ = flights.filtered()
    found, graph, mu = smooth(record), gtsam.GaussianFactorGraph(), 1000

    def add(variables, b, covariance):
        half = np.linalg.inv(np.linalg.cholesky(covariance))
        parts = [part for key, A in variables for part in (key, half @ A)]
        graph.add(gtsam.JacobianFactor(*parts, half @ b, gtsam.noiseModel.Unit.Create(len(b))))

    eye = np.eye(3)
    add([(0, eye)], np.zeros(3), P0[:3, :3])
    add([(mu, eye)], np.zeros(3), P0[3:, 3:])
    for k, (Phi, Q, H, R, z) in enumerate(steps):
        add([(k, -Phi[:3, :3]), (k + 1, eye)], np.zeros(3), Q[:3, :3])
        add([(k + 1, H[:, :3]), (mu, H[:, 3:])], z, R)
    best = graph.optimize()
    of = gtsam.Marginals(graph, best)
    theirs = [best.at(0), best.at(mu), of.marginalCovariance(0), of.marginalCovariance(mu)]
    x, P = found.x[0], found.P[0]
    x_true, P_true = exact.smoothed(P0, steps)
    true = [x_true, P_true[:3, :3], P_true[3:, 3:]]
    return Numbers([x, P[:3, :3], P[3:, 3:]], theirs, true, 0.05, 20 * 200)


HELD = "GTSAM holds the axes of the beginning of a step through it: its error falls with the first power of the step"
PEER = Peer("gtsam", __file__,
    (
        Check("turn by a rotation vector", "1", partial(turned, flights.TURN), ("euler_matching",)),
        Check("turn by 4e-8 rad", "1", partial(turned, flights.SMALL), ("euler_matching",)),
        Check("place after a second of flight", "m", partial(flown, 0), ("strapdown",), OURS, HELD),
        Check("velocity after a second of flight", "m/s", partial(flown, 1), ("strapdown",), OURS, HELD),
        Check("attitude after a second of flight", "rad", partial(flown, 2), ("strapdown",), THEIRS,
              "at constant rates of body and Earth GTSAM is exact; ours turns the level by its rate in the middle of a "
              "step"),
        Check("first state, smoothed over 20 steps", "rad, rad^2", smoothed, flights.SMOOTHER),
    ),
)  # fmt: skip
