"""Rendezvous on a circular orbit: how far a burn that aims by the navigation misses.

boresight generate rendezvous.py:RENDEZVOUS
boresight budget rendezvous.py:RENDEZVOUS --motion fly_rendezvous.py:nominal
python fly_rendezvous.py

Two times six states: the true deviation from the nominal transfer, and the one that the navigation estimates.  Both
follow the equations of Clohessy and Wiltshire; what disturbs the orbit moves the true one alone.
"""

from sympy import Matrix, diag, eye, zeros

from boresight import Model, Struct, variable

AXES = "along cross down"


def both(name, letter, unit, meaning):
    """The three components of a deviation, true and estimated."""
    return [
        variable(f"{kind}{name}", " ".join(f"{kind[:1]}{letter}_{axis}" for axis in AXES.split()), unit,
                 f"{meaning}, {kind.strip('_') or 'true'}", -1e4, 1e4)
        for kind in ("", "estimated_")
    ]  # fmt: skip


position, estimated_position = both("position", "p", "m", "deviation of the position")
velocity, estimated_velocity = both("velocity", "v", "m/s", "deviation of the velocity")
rate = variable("orbit_rate", "n", "rad/s", "rate of the orbit", 0.0, 0.01)
dt = variable("dt", "dt", "s", "length of the step", 1e-3, 10.0)
drag = variable("drag_noise", " ".join(f"w_{axis}" for axis in AXES.split()), "m/s/sqrt(s)",
                "root density of what disturbs the orbit", 0.0, 1.0)  # fmt: skip

n = rate.scalar
F = zeros(6)  # Clohessy-Wiltshire: along the track, across it, down
F[:3, 3:] = eye(3)
F[3, 5], F[4, 1], F[5, 2], F[5, 3] = 2 * n, -(n**2), 3 * n**2, -2 * n
G = zeros(12, 3)
G[3:6, :] = eye(3)

RENDEZVOUS = Model(
    name="rendezvous",
    c_prefix="rv",
    title="rendezvous on a circular orbit, true and estimated deviation, 12 states",
    frame="local vertical, local horizontal: along the track, across it, down",
    states=(position, velocity, estimated_position, estimated_velocity),
    structs=(Struct("orbit", "the orbit", (rate,)), Struct("step", "one step", (dt, drag))),
    F=diag(F, F),
    G=Matrix(G),
    noise=drag.vector,
    dt=dt.scalar,
)
