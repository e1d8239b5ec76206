"""F and H of velocity-attitude against exact mechanics that share nothing with them: no small angle in any of it.

The truth is put together here from rotation matrices in 50 digits: a slave, its mounting, and what the master on the
same hull reports.  The estimates are the truth with finite errors, C_hat = exp(-[phi x]) C.
"""

import casadi as ca
import mpmath as mp
import numpy as np
import pytest
from flint import arb
from mechanics import F_N, POSITION, V_N, differentiable, numbers, states
from sympy import Matrix, symbols

from boresight.codegen.functions.reference import evaluator, precise
from boresight.derive.expressions import symbols_in
from boresight.derive.ledger.numbers import middle
from boresight.derive.mechanics import mechanization
from boresight.derive.mechanics import rotation as rot
from boresight.derive.mechanics.earth import NED
from boresight.derive.models import velocity_attitude as va
from boresight.runtime.library import load

MODEL = va.velocity_attitude()
BLOCK = {name: slice(3 * i, 3 * i + 3) for i, name in enumerate(("phi", "dv", "dbg", "dba", "dmu"))} | {
    "d_tau": slice(15, 16)
}
DIGITS = 50


def measurement(name):
    return next(m for m in MODEL.measurements if m.name == name)


# ---------------------------------------------------------------- F


def test_F_and_G_are_the_derivative_of_the_exact_mechanization():
    """Between two exact mechanizations at one place, one of them wrong in all 16 states, with noise on its sensors."""
    q, w_b, x = (Matrix(symbols(f"{name}_:{n}", real=True)) for name, n in (("q", 4), ("w", 3), ("x", 16)))
    noise = Matrix(symbols("e_:6", real=True))
    C = rot.dcm_from_quaternion(q)
    f_b = C.T * F_N
    C_hat = rot.small_rotation(-x[:3, 0]) * C
    v_hat = V_N + x[3:6, 0]
    # a bias estimated too high leaves too little
    w_hat, f_hat = w_b - x[6:9, 0] + noise[:3, 0], f_b - x[9:12, 0] + noise[3:, 0]
    C_hat_rate = mechanization.dcm_rate(NED, POSITION, v_hat, C_hat, w_hat)
    C_rate = mechanization.dcm_rate(NED, POSITION, V_N, C, w_b)
    velocity = mechanization.velocity_rate
    rate = Matrix.vstack(
        -rot.vee(C_hat_rate * C.T + C_hat * C_rate.T),
        velocity(NED, POSITION, v_hat, C_hat * f_hat) - velocity(NED, POSITION, V_N, C * f_b),
    )
    (made,), given = differentiable([rate], POSITION, V_N, F_N, q, w_b, x, noise)
    exact = ca.Function("J", given, [ca.jacobian(made, given[5]), ca.jacobian(made, given[6])])

    inputs = [va.POSITION.vector, va.V_N.vector, va.Q.vector, va.F_B.vector]
    F, G = numbers(MODEL.F, *inputs), numbers(MODEL.G, *inputs)
    rng = np.random.default_rng(1)
    for p, v, f in states(NED, 30):
        attitude = rng.standard_normal(4)
        attitude /= np.linalg.norm(attitude)
        sensed = numbers(C.T * F_N, q, F_N)(attitude, f)[:, 0]
        F_exact, G_exact = (
            np.array(part) for part in exact(p, v, f, attitude, rng.uniform(-1, 1, 3), np.zeros(16), np.zeros(6))
        )
        got = F(p, v, attitude, sensed)
        for rows in (slice(0, 3), slice(3, 6)):
            for name, columns in BLOCK.items():
                here, there = got[rows, columns], F_exact[rows, columns]
                # rates of 1 rad/s cancel in the derivative, and leave their last bit
                assert np.abs(here - there).max() <= 1e-11 * np.abs(there).max() + 1e-15, name
        assert not got[6:].any()
        np.testing.assert_allclose(G(p, v, attitude, sensed)[:6, :6], G_exact, atol=1e-12)
        np.testing.assert_array_equal(G(p, v, attitude, sensed)[6:, 6:], np.eye(10))


# ---------------------------------------------------------------- the truth, in 50 digits


def column(values):
    return mp.matrix([mp.mpf(float(value)) for value in values])


def cross(a, b):
    return mp.matrix([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def turn(v):
    """exp([v x]) by its series."""
    return mp.expm(mp.matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]]), method="taylor")


def quaternion_of(C):
    """Of a rotation by less than half a turn."""
    w = mp.sqrt(1 + C[0, 0] + C[1, 1] + C[2, 2]) / 2
    return [w, (C[2, 1] - C[1, 2]) / 4 / w, (C[0, 2] - C[2, 0]) / 4 / w, (C[1, 0] - C[0, 1]) / 4 / w]


def euler_of(C):
    return [mp.atan2(C[2, 1], C[2, 2]), -mp.asin(C[2, 0]), mp.atan2(C[1, 0], C[0, 0])]


def evaluated(expression):
    """The matrix as a function of mp numbers by symbol, in 50 digits."""
    free = sorted(symbols_in(expression), key=str)
    compiled, (rows, columns) = evaluator(free, [expression]), expression.shape

    def at(known):
        with precise():
            (entries,) = compiled([arb(known[s]) for s in free])
            return mp.matrix([[middle(entries.get((i, j), 0)) for j in range(columns)] for i in range(rows)])

    return at


LEVEL_RATE = evaluated(mechanization.omega_in_n(NED, va.POSITION.vector, va.V_N.vector))


def situation(seed, lag=0.0, level="estimated"):
    """x -> the inputs of a measurement, mp numbers by symbol, whose estimates are wrong by x (16).

    lag: how old the master's data truly is.  level: what turns the level, the "estimated" velocity as in the model, or
    the "true" one.
    """
    rng = np.random.default_rng(seed)
    C, mount = (turn(column(rng.uniform(-0.7, 0.7, 3))) for _ in range(2))
    position = [mp.mpf(float(value)) for value in (rng.uniform(-1.2, 1.2), rng.uniform(-3, 3), rng.uniform(-10, 100))]
    v, omega, lever = column(rng.uniform(-9, 9, 3)), column(rng.uniform(-0.4, 0.4, 3)), column(rng.uniform(-8, 8, 3))
    a = column(rng.uniform(-3, 3, 3))

    def at(x):
        phi, dv, dbg, dmu, d_tau = (mp.matrix([x[i] for i in range(16)[BLOCK[n]]]) for n in
                                    ("phi", "dv", "dbg", "dmu", "d_tau"))  # fmt: skip
        v_hat = v + dv
        v_level = v_hat if level == "estimated" else v
        level_rate = LEVEL_RATE(dict(zip([*va.POSITION.symbols, *va.V_N.symbols], [*position, *v_level], strict=True)))
        # a body that turns against the level: the lever arm's end moves by omega_nb x lever
        omega_nb = omega - C.T * level_rate
        v_m, C_m2n = v - C * cross(omega_nb, lever), C * mount.T
        v_m, C_m2n = v_m - a * mp.mpf(lag), turn(-(C * omega_nb) * mp.mpf(lag)) * C_m2n
        fields = {
            va.POSITION: position, va.V_N: v_hat, va.Q: quaternion_of(turn(-phi) * C),
            va.Q_MOUNT: quaternion_of(turn(-dmu) * mount), va.OMEGA_IB_B: omega - dbg, va.LEVER_B: lever, va.A_N: a,
            va.LAG: [mp.mpf(lag) + d_tau[0]], va.V_M: v_m, va.Q_M: quaternion_of(C_m2n), va.EULER_M: euler_of(C_m2n),
        }  # fmt: skip
        return {s: value for field, values in fields.items() for s, value in zip(field.symbols, values, strict=True)}

    return at


def state(values):
    return dict(zip(MODEL.x, values, strict=True))


def direction(seed):
    """Of unit variance in units of 1 rad, 1 m/s, 1 deg/s, 1 m/s^2, 1 s."""
    return np.random.default_rng(100 + seed).standard_normal(16) * np.repeat([1, 1, 0.02, 1, 1, 1], [3, 3, 3, 3, 3, 1])


# ---------------------------------------------------------------- H


@pytest.mark.parametrize("name", ["velocity", "dcm", "quaternion", "euler"])
def test_the_compiled_H_is_the_first_order_of_the_residual_between_finite_rotations(name, compiled_once):
    """A tenth of the error leaves a hundredth of the remainder: residuals in 50 digits, H as it flies."""
    H, sizes = getattr(load("velocity-attitude"), f"{name}_H"), (mp.mpf("1e-4"), mp.mpf("1e-5"))
    with mp.workdps(DIGITS):
        z = evaluated(measurement(name).z)
        for seed in range(3):
            at, x = situation(seed), column(direction(seed))
            perfect = at(0 * x)
            assert mp.norm(z(perfect)) < mp.mpf(10) ** -45
            fields = {v.name: [float(perfect.get(s, 0)) for s in v.symbols] for v in MODEL.inputs} | {"x": np.zeros(16)}
            scalars = {v.name: fields[v.name][0] for v in MODEL.inputs if v.size == 1}
            given = {f: (fields | scalars)[f] for f in H.fields}
            jacobian = mp.matrix(H(**given).tolist())
            left = [mp.norm(z(at(size * x)) - jacobian * (size * x)) for size in sizes]
            assert left[0] < 100 * sizes[0] ** 2
            assert 90 < left[0] / left[1] < 110


@pytest.mark.parametrize(
    ("name", "lag"), [("velocity", 0.3), ("dcm", 0.0), ("quaternion", 0.0), ("quaternion", 0.3), ("euler", 0.3)]
)
def test_the_exact_h_expects_the_residual_of_errors_of_any_size(name, lag):
    """Attitude and misalignment wrong by a third of a radian an axis, the delay by a third of a second."""
    m = measurement(name)
    with mp.workdps(DIGITS):
        z, h = evaluated(m.z), evaluated(m.h)
        for seed in range(2):
            at, x = situation(seed, lag), column(direction(seed) / 3)
            known = at(x) | state(list(x))
            assert mp.norm(z(known) - h(known)) < mp.mpf(10) ** -29  # its rotation vectors are exact to 1e-30


def test_the_delay_compensation_of_the_dcm_residual_is_of_second_order_in_the_turn():
    """Kang (5) takes omega lag off the residual; the quaternion residual turns the attitude back exactly."""
    with mp.workdps(DIGITS):
        z = {name: evaluated(measurement(name).z) for name in ("dcm", "quaternion")}
        zero = mp.matrix(16, 1)
        left = [mp.norm(z["dcm"](situation(1, lag)(zero))) for lag in (0.1, 0.05)]
        assert mp.norm(z["quaternion"](situation(1, 0.1)(zero))) < mp.mpf(10) ** -29
        # the skew part of a rotation is the sine of its angle, about its own axis: third order
        assert 7.5 < left[0] / left[1] < 8.5


def test_what_velocity_leaves_out_is_the_level_turned_by_the_velocity_error():
    """The level turns with the velocity: an error of 1 m/s over 6371 km, on a lever arm of 8 m, is some 1e-6 m/s."""
    m = measurement("velocity")
    with mp.workdps(DIGITS):
        z, H = evaluated(m.z), evaluated(m.H)
        at = situation(1, level="true")
        x = mp.matrix(16, 1)
        x[4] = mp.mpf("1e-6")
        left = mp.norm(z(at(x)) - H(at(0 * x)) * x) / x[4]
        assert mp.mpf("1e-7") < left < 8 * mp.sqrt(3) * 3 / mp.mpf(6.37e6)
