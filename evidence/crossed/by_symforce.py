"""SymForce: symbols, Lie groups and printed code."""

import tempfile
from functools import partial
from pathlib import Path

import numpy as np
from mpmath import mp

from boresight.evidence.crossed import exact, flights
from boresight.evidence.crossed.judge import OURS, Check, Numbers, Peer, printed_module
from boresight.runtime.library import load

MU = np.array([0.02, -0.01, 0.03])


def symbols():
    import contextlib

    import symforce

    with contextlib.suppress(symforce.AlreadyUsedEpsilon):
        symforce.set_epsilon_to_number()
    import symforce.symbolic as sf

    return sf


def turned(vector: np.ndarray) -> Numbers:
    sf = symbols()
    theirs = np.array(sf.Rot3.from_tangent(list(vector)).to_rotation_matrix().to_numpy(), float)
    return flights.turn(vector, theirs)


def flown(part: int) -> Numbers:
    """Its pre-integration, which has a gravity that does not change and no Earth that turns."""
    sf = symbols()
    from symforce.slam.imu_preintegration.manifold_symbolic import integrate_state, roll_forward_state

    begin, end, ours = flights.flown()
    DR, Dv, Dp, dt = sf.Rot3(), sf.V3.zero(), sf.V3.zero(), 1 / flights.RATE_HZ
    accel, gyro = sf.V3(*flights.FORCE), sf.V3(*flights.OMEGA)
    for _ in range(flights.SECONDS * flights.RATE_HZ):
        DR, Dv, Dp = integrate_state(DR, Dv, Dp, accel=accel, gyro=gyro, dt=dt, epsilon=sf.numeric_epsilon)
    gravity = float(exact.with_height(mp.mpf(flights.PLACE[1]), mp.mpf(0)))
    pose = sf.Pose3(R=sf.Rot3.from_rotation_matrix(sf.M33(flights.start()[1])), t=sf.V3.zero())
    made, v = roll_forward_state(pose, sf.V3(*flights.V_N), DR, Dv, Dp, sf.V3(0, 0, -gravity), flights.SECONDS)
    parts = made.t, v, made.R.to_rotation_matrix()
    theirs = np.array(parts[part].to_numpy(), float)
    right, own = (exact.in_level_of_start(begin, y)[part] for y in (end, ours))
    return Numbers(own, theirs, right, *flights.ROUNDINGS[part])


def euler_of(sf, C):
    return sf.V3(sf.atan2(C[2, 1], C[2, 2], epsilon=0), -sf.asin(C[2, 0]), sf.atan2(C[1, 0], C[0, 0], epsilon=0))


def jacobian() -> Numbers:
    """H of the master's angles by its derivatives, printed by it as Python, and called."""
    sf = symbols()
    from symforce.codegen import Codegen, PythonConfig
    from symforce.values import Values

    x, mu, euler = sf.V6.symbolic("x"), sf.V3.symbolic("mu"), sf.V3.symbolic("euler")
    axes = (sf.V3.unit_x(), sf.V3.unit_y(), sf.V3.unit_z())
    roll, pitch, yaw = (sf.Rot3.from_angle_axis(angle, axis) for angle, axis in zip(euler, axes, strict=True))
    mounted = sf.Rot3.from_tangent([x[3 + i] - mu[i] for i in range(3)])
    turn = sf.Rot3.from_tangent(list(x[:3])) * yaw * pitch * roll * mounted
    h = -euler_of(sf, turn.to_rotation_matrix())
    inputs, outputs = Values(x=x, mu=mu, euler=euler), Values(H=h.jacobian(x))
    code = Codegen(inputs=inputs, outputs=outputs, config=PythonConfig(use_numba=False), name="angles_H")
    with tempfile.TemporaryDirectory() as folder:
        made = code.generate_function(output_dir=Path(folder), skip_directory_nesting=True)
        text = next(path for path in made.generated_files if path.stem == "angles_H").read_text()
    theirs = printed_module(text, "angles_H").angles_H(np.zeros(6), MU, flights.EULER)
    ours = load("euler-matching").euler_exact_H(x=np.zeros(6), mu=MU, euler_b=flights.EULER)

    def h_of(x):
        C = exact.rotation(x[:3]) if mp.norm(x[:3]) else mp.eye(3)
        C = C * exact.of_euler(*flights.EULER)
        return -exact.to_euler(C * exact.rotation(mp.matrix(x[3:]) - mp.matrix(MU)))

    return Numbers(ours, theirs, exact.jacobian(h_of, 6), 1.0, 100)


HELD = "SymForce holds the axes of the beginning of a step through it, and knows no Earth that turns"
PEER = Peer("symforce", __file__,
    (
        Check("turn by a rotation vector", "1", partial(turned, flights.TURN), ("euler_matching",)),
        Check("turn by 4e-8 rad", "1", partial(turned, flights.SMALL), ("euler_matching",)),
        Check("place after a second of flight", "m", partial(flown, 0), ("strapdown",), OURS, HELD),
        Check("velocity after a second of flight", "m/s", partial(flown, 1), ("strapdown",), OURS, HELD),
        Check("attitude after a second of flight", "rad", partial(flown, 2), ("strapdown",), OURS,
              "SymForce's pre-integration knows no Earth that turns"),
        Check("H of matched Euler angles", "1", jacobian, ("euler_matching",)),
    ),
)  # fmt: skip
