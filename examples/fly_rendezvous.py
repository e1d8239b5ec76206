"""The error budget of a rendezvous by linear covariance, after Geller (2006): one burn, aimed by the navigation.

python fly_rendezvous.py

The published dispersion of the position at the end is 11.03987383 m.
"""

from pathlib import Path

import numpy as np

from boresight import budget, generate, load

MODEL = f"{Path(__file__).parent}/rendezvous.py:RENDEZVOUS"
RATE = 0.00114  # rad/s
COAST, TRANSFER = 156.7, 900.0  # s, before the burn and behind it
DRAG = np.sqrt(4.8e-10)  # m/s/sqrt(s)
BURN = np.sqrt(2.5e-7)  # m/s, one sigma of each axis
POSITION, VELOCITY, CORRELATED = slice(0, 3), slice(3, 6), (2, 3)


def covariance(position, velocity, correlation):
    """(6, 6) of sigmas in m and m/s; position down and velocity along the track are correlated."""
    P = np.diag([position**2] * 3 + [velocity**2] * 3)
    P[2, 3] = P[3, 2] = correlation * position * velocity
    return P


def nominal(library):
    """P0 by cause, and the steps: coast, burn, coast."""
    dispersed, wrong = covariance(100 / 3, 0.11 / 3, 0.9), covariance(10 / 3, 0.011 / 3, 0.9)
    zero = np.zeros((6, 6))
    start = {
        "dispersion": np.block([[dispersed, dispersed], [dispersed, dispersed]]),  # known to the navigation
        "navigation": np.block([[zero, zero], [zero, wrong]]),
    }

    def coast(seconds):
        steps = int(np.ceil(seconds))
        given = {"orbit_rate": RATE, "dt": seconds / steps}
        return [{**given, "drag_noise": np.full(3, DRAG)}] * steps, np.linalg.matrix_power(library.Phi(**given), steps)

    before, _ = coast(COAST)
    behind, Phi = coast(TRANSFER)
    # the burn that brings the estimated deviation of the position to zero at the end
    aim = np.linalg.solve(Phi[:3, 3:6], Phi[:3, :3])
    G = np.zeros((6, 6))
    G[VELOCITY, POSITION], G[VELOCITY, VELOCITY] = -aim, -np.eye(3)
    D = np.block([[np.eye(6), G], [zero, np.eye(6) + G]])
    noise = np.zeros((12, 12))
    noise[VELOCITY, VELOCITY] = BURN**2 * np.eye(3)
    burn = {"dt": 0.0, "Phi": D, "Q": {"burn": noise}}
    return start, [*before, burn, *behind]


if __name__ == "__main__":
    found = budget(library := load(generate(MODEL).folder), *nominal(library))
    print(found.report(states=found.states[:6], title="rendezvous, at the end of the transfer"))
    for name, variances in zip(found.sources, found.variances[-1], strict=True):
        print(f"{name:<20}{np.sqrt(variances[POSITION].sum()):9.5f} m")
    print(f"{'all together':<20}{np.sqrt(found.whole[-1, POSITION].sum()):9.5f} m")
