"""pyins: inertial navigation in NED, with NumPy and Numba; ours is in ENU."""

from functools import partial

import numpy as np
from mpmath import mp

from boresight.evidence.crossed import exact, flights
from boresight.evidence.crossed.judge import NEITHER, OURS, Check, Numbers, Peer
from boresight.runtime.library import load

LAT, HIGH = 0.63, 10_000.0
SWAP = np.array([[0, 1, 0], [1, 0, 0], [0, 0, -1.0]])  # NED to ENU, and front, right, down to right, front, up


def earth(height: float) -> dict[str, np.ndarray]:
    return load("strapdown").earth(lon_lat_height=np.array([2.2, LAT, height]), v_n=flights.V_N)


def gravity(height: float) -> Numbers:
    from pyins import earth as other

    true = exact.gravity(mp.mpf(LAT), mp.mpf(height))
    return Numbers(-earth(height)["gravity_n"][2], other.gravity(np.degrees(LAT), height), true, 10.0, 20)


def rates() -> Numbers:
    from pyins import earth as other

    lat, ours = np.degrees(LAT), earth(100.0)
    theirs = SWAP @ np.stack([other.rate_n(lat), other.curvature_matrix(lat, 100.0) @ SWAP @ flights.V_N], axis=-1)
    true = [exact.earth_rate(mp.mpf(LAT)), exact.transport_rate(mp.mpf(LAT), mp.mpf(100), mp.matrix(flights.V_N))]
    return Numbers([ours["omega_ie_n"], ours["omega_en_n"]], theirs.T, true, float(exact.RATE), 20)


def flight() -> tuple[list[float], list[float]]:
    """The second of flight by its integrator: where, how fast and how turned, in ENU."""
    import pandas as pd
    from pyins import strapdown, transform
    from pyins.util import TRAJECTORY_COLS

    _, C = flights.start()
    lon, lat, height = flights.PLACE
    begin = [np.degrees(lat), np.degrees(lon), height, *(SWAP @ flights.V_N), *transform.mat_to_rph(SWAP @ C @ SWAP)]
    count = flights.SECONDS * flights.RATE_HZ
    sensed = np.tile(np.concatenate([SWAP @ flights.OMEGA, SWAP @ flights.FORCE]) / flights.RATE_HZ, (count + 1, 1))
    columns = ["gyro_x", "gyro_y", "gyro_z", "accel_x", "accel_y", "accel_z"]
    imu = pd.DataFrame(sensed, index=np.arange(count + 1) / flights.RATE_HZ, columns=columns)
    integrator = strapdown.Integrator(pd.Series(begin, index=TRAJECTORY_COLS))
    integrator.integrate(strapdown.compute_increments_from_imu(imu, "increment"))
    end = integrator.get_pva().to_numpy()
    place = [np.radians(end[1]), np.radians(end[0]), end[2]]
    turned = SWAP @ transform.mat_from_rph(end[6:]) @ SWAP
    return place, [*place, *(SWAP @ end[3:6]), *turned.ravel()]


def navigated(part: int) -> Numbers:
    begin, end, ours = flights.flown()
    parts = [exact.in_level_of_start(begin, y)[part] for y in (ours, flight()[1], end)]
    return Numbers(*parts, *flights.ROUNDINGS[part])


def updated() -> Numbers:
    from pyins import kalman

    loop, _, P0, steps, _ = flights.filtered()
    x, P = np.zeros(6), P0
    for Phi, Q, H, R, z in steps:
        x, P = Phi @ x, Phi @ P @ Phi.T + Q
        x, P, _ = kalman.correct(x, P, z, H, R)
    x_true, P_true, _ = exact.filtered(np.zeros(6), P0, steps)
    return Numbers([loop.x, loop.P], [x, P], [x_true, P_true], 0.05, 20 * 40)


EARTH = ("strapdown",)
SECOND = "within a step pyins turns the specific force to the first power of the turn, ours to the second"
PEER = Peer("python-ins", __file__,
    (
        Check("gravity on the ellipsoid", "m/s^2", partial(gravity, 0.0), EARTH, NEITHER,
              "both take gravity at equator and pole as printed, with 11 digits; at the pole it is 9.83218493786, "
              "where we have 9.8321849379 and pyins 9.8321849378"),
        Check("gravity at 10 km", "m/s^2", partial(gravity, HIGH), EARTH, OURS,
              "ours has the second power of the height, pyins the first"),
        Check("rate of the Earth and of the level", "rad/s", rates, EARTH),
        Check("place after a second of flight", "m", partial(navigated, 0), EARTH, OURS, SECOND),
        Check("velocity after a second of flight", "m/s", partial(navigated, 1), EARTH, OURS, SECOND),
        Check("attitude after a second of flight", "rad", partial(navigated, 2), EARTH, NEITHER,
              "each predicts the rate of the level within a step in its own way; the error of ours falls with the "
              "second power of the step"),
        Check("state and covariance after 20 updates", "rad, rad^2", updated, flights.LOOP),
    ),
)  # fmt: skip
