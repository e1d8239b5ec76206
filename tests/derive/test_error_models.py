"""The phi and psi models against the exact mechanization, differentiated by CasADi, and against two other packages."""

import casadi as ca
import numpy as np
import pandas as pd
import pytest
from mechanics import F_N, POSITION, V_N, differentiable, numbers, skew, states
from sympy import Matrix, eye, symbols

from boresight.derive.mechanics import earth, mechanization
from boresight.derive.mechanics import error_models as em
from boresight.derive.mechanics import rotation as rot
from boresight.derive.mechanics.earth import ENU, NED

FRAMES = pytest.mark.parametrize("frame", [NED, ENU], ids=lambda frame: frame.name)
BLOCKS = {
    (row, column): (slice(3 * i, 3 * i + 3), slice(3 * j, 3 * j + 3))
    for i, row in enumerate("PVA")
    for j, column in enumerate("PVA")
}
SENSED = Matrix(symbols("w_:3", real=True))  # omega_ib_b
ERROR = Matrix(symbols("x_:9", real=True))
FAULT = Matrix(symbols("e_:6", real=True))  # of gyros and accelerometers
Q = Matrix(symbols("q_:4", real=True))


def exact_rate(frame):
    """Rate of the errors between two exact mechanizations, at an error ERROR with faulty sensors FAULT; 9x1 SymPy.

    The attitude error is that of C_hat = (I - [phi x]) C: its rate is read off (C_hat C')'.
    """
    C = rot.dcm_from_quaternion(Q)
    f_b = C.T * F_N
    C_hat = rot.small_rotation(-ERROR[6:9, 0]) * C
    p_hat, v_hat = POSITION + ERROR[0:3, 0], V_N + ERROR[3:6, 0]
    f_hat, w_hat = f_b + FAULT[3:6, 0], SENSED + FAULT[0:3, 0]
    position = mechanization.position_rate
    velocity = mechanization.velocity_rate
    C_hat_rate = mechanization.dcm_rate(frame, p_hat, v_hat, C_hat, w_hat)
    C_rate = mechanization.dcm_rate(frame, POSITION, V_N, C, SENSED)
    return Matrix.vstack(
        position(frame, p_hat, v_hat) - position(frame, POSITION, V_N),
        velocity(frame, p_hat, v_hat, C_hat * f_hat) - velocity(frame, POSITION, V_N, C * f_b),
        -rot.vee(C_hat_rate * C.T + C_hat * C_rate.T),
    )


def jacobians(frame):
    """d(exact rate) / d(error) and / d(fault) at none, by automatic differentiation, as functions of the true state."""
    (rate,), made = differentiable([exact_rate(frame)], POSITION, V_N, F_N, Q, SENSED, ERROR, FAULT)
    x, e = made[-2:]
    both = ca.Function("J", made, [ca.jacobian(rate, x), ca.jacobian(rate, e), rate])

    def at(p, v, f, q, w, error=None):
        return [np.array(part) for part in both(p, v, f, q, w, np.zeros(9) if error is None else error, np.zeros(6))]

    return at


def attitude(seed):
    rng = np.random.default_rng(seed)
    q = rng.standard_normal(4)
    return q / np.linalg.norm(q), rng.uniform(-1, 1, 3)


def in_metres(frame, position):
    """(9,) what makes a matrix of coordinates one of metres, so that the entries of a block have one unit."""
    lat, height = frame.latitude_and_height(position)
    return np.concatenate([np.array(earth.metres(lat, height, frame), dtype=float).ravel(), np.ones(6)])


def assert_blocks(got, expected, relative, scale, cancelling=None):
    """Each block to `relative` of its largest entry; one that should vanish, exactly, but for what cancels in it.

    scale: (9,) units of the states.  cancelling: 9x9, the size of terms whose rounding is left in a block.
    """
    for name, block in BLOCKS.items():
        here, there, terms = (
            (F * scale[:, None] / scale)[block] for F in (got, expected, expected if cancelling is None else cancelling)
        )
        largest = max(np.abs(there).max(), np.abs(terms).max())
        difference = np.abs(here - there).max()
        assert difference <= relative * largest, f"block {name}: {difference:.3e} of {largest:.3e}"


@FRAMES
def test_every_block_of_the_phi_model_is_the_derivative_of_the_exact_mechanization(frame):
    F = numbers(em.phi_matrix(frame, POSITION, V_N, F_N), POSITION, V_N, F_N)
    G = numbers(em.noise_matrix(rot.dcm_from_quaternion(Q)), Q)
    exact = jacobians(frame)
    for k, (p, v, f) in enumerate(states(frame, 100)):
        q, w = attitude(k)
        F_exact, G_exact, _ = exact(p, v, f, q, w)
        assert_blocks(F(p, v, f), F_exact, 1e-10, in_metres(frame, p))
        assert np.abs(G(q) - G_exact).max() < 1e-12


@FRAMES
def test_what_the_phi_model_leaves_out_falls_fourfold_with_half_the_error(frame):
    F = numbers(em.phi_matrix(frame, POSITION, V_N, F_N), POSITION, V_N, F_N)
    exact = jacobians(frame)
    rng = np.random.default_rng(1)
    lengths = np.array([1e-3 if name != "height" else 3e3 for name in frame.coordinates])
    for k, (p, v, f) in enumerate(states(frame, 5, latitude=1.0)):
        q, w = attitude(k)
        x = np.concatenate([lengths, np.full(3, 10.0), np.full(3, 0.02)]) * rng.uniform(0.5, 1, 9)
        left = [exact(p, v, f, q, w, s * x)[2][:, 0] - F(p, v, f) @ (s * x) for s in (1.0, 0.5)]
        for block in (slice(0, 3), slice(3, 6), slice(6, 9)):
            ratio = np.linalg.norm(left[0][block]) / np.linalg.norm(left[1][block])
            assert abs(ratio - 4) < 0.1, ratio


def carried(T, frame):
    """(T' + T F) T^-1 as a function of F and the state, for a T of position and velocity that move."""
    rates = [
        mechanization.position_rate(frame, POSITION, V_N),
        mechanization.velocity_rate(frame, POSITION, V_N, F_N),
    ]
    (T_, p_rate, v_rate), made = differentiable([T, *rates], POSITION, V_N, F_N)
    p, v, _ = made
    T_rate = ca.reshape(ca.jtimes(ca.vec(ca.densify(T_)), ca.vertcat(p, v), ca.vertcat(p_rate, v_rate)), 9, 9)
    both = ca.Function("T", made, [T_, T_rate])

    def at(F, *state):
        here, rate = (np.array(part) for part in both(*state))
        return (rate + here @ F) @ np.linalg.inv(here)

    return at


@FRAMES
def test_every_block_of_the_psi_model_is_the_exact_phi_model_through_the_map(frame):
    F = numbers(em.psi_matrix(frame, POSITION, V_N, F_N), POSITION, V_N, F_N)
    phi = numbers(em.phi_matrix(frame, POSITION, V_N, F_N), POSITION, V_N, F_N)
    exact, mapped = jacobians(frame), carried(em.psi_from_phi(frame, POSITION, V_N), frame)
    for k, (p, v, f) in enumerate(states(frame, 100)):
        expected = mapped(exact(p, v, f, *attitude(k))[0], p, v, f)
        assert_blocks(F(p, v, f), expected, 1e-10, in_metres(frame, p), cancelling=phi(p, v, f))


@FRAMES
def test_the_map_to_psi_and_back_is_the_identity(frame):
    there, back = em.psi_from_phi(frame, POSITION, V_N), em.phi_from_psi(frame, POSITION, V_N)
    assert (there * back).expand() == eye(9)
    assert there != eye(9)


@FRAMES
def test_psi_is_the_attitude_error_against_the_level_of_the_computed_position(frame):
    """By finite rotations: C_c2n of two places in Earth-fixed axes, half the error leaves a quarter."""
    T = numbers(em.psi_from_phi(frame, POSITION, V_N), POSITION, V_N)
    axes = numbers(Matrix.hstack(Matrix(frame.north), Matrix(frame.east), -Matrix(frame.up)), [])([])

    def level(p):
        """C_n2e, from the normal and the poles: no formula of the model."""
        lat, lon = (p[frame.coordinates.index(name)] for name in ("lat", "lon"))
        up = np.array([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)])
        east = np.cross([0, 0, 1.0], up)
        east /= np.linalg.norm(east)
        return np.column_stack([np.cross(up, east), east, -up]) @ axes.T

    p, v, _ = next(states(frame, 1, latitude=1.0))
    x = np.concatenate([[2e-3 if name != "height" else 100.0 for name in frame.coordinates], np.zeros(6)])
    x[3:] = 1e-3 * np.arange(1, 7)
    left = []
    for s in (1.0, 0.5):
        C_n2c = level(p + s * x[:3]).T @ level(p)
        dv_c = v + s * x[3:6] - C_n2c @ v
        C_hat = np.eye(3) - skew(s * x[6:9])  # of C_b2n = I
        against_c = np.eye(3) - C_hat @ C_n2c.T
        psi = np.array([against_c[2, 1] - against_c[1, 2], against_c[0, 2] - against_c[2, 0],
                        against_c[1, 0] - against_c[0, 1]]) / 2  # fmt: skip
        mapped = T(p, v) @ (s * x)
        left.append([np.linalg.norm(dv_c - mapped[3:6]), np.linalg.norm(psi - mapped[6:9])])
    assert np.abs(np.array(left[0]) / np.array(left[1]) - 4).max() < 0.1


def test_ned_and_enu_are_one_model():
    N = np.array([[0, 1, 0], [1, 0, 0], [0, 0, -1.0]])
    swap = np.array([[0, 1, 0], [1, 0, 0], [0, 0, 1.0]])
    P = np.zeros((9, 9))
    P[:3, :3], P[3:6, 3:6], P[6:, 6:] = swap, N, N
    for matrix in (em.phi_matrix, em.psi_matrix):
        ned, enu = (numbers(matrix(frame, POSITION, V_N, F_N), POSITION, V_N, F_N) for frame in (NED, ENU))
        for p, v, f in states(NED, 20):
            assert_blocks(P @ ned(p, v, f) @ P.T, enu(swap @ p, N @ v, N @ f), 1e-14, in_metres(ENU, swap @ p))


def test_the_phi_model_is_that_of_inu_but_for_the_latitude_column(monkeypatch):
    """inu takes the radii as constant in latitude; everything else agrees to rounding, with the same constants."""
    import inu

    monkeypatch.setattr(inu, "W_EI", float(earth.EARTH_RATE))
    monkeypatch.setattr(inu, "E2", float(earth.ECCENTRICITY_SQUARED))
    monkeypatch.setattr(inu, "GRAV_K", float(earth.SOMIGLIANA))
    monkeypatch.setattr(inu, "GRAV_F", float(earth.FLATTENING))
    monkeypatch.setattr(inu, "GRAV_M", float(earth.CENTRIFUGAL_RATIO))
    F = numbers(em.phi_matrix(NED, POSITION, V_N, F_N), POSITION, V_N, F_N)
    for p, v, f in states(NED, 50, latitude=np.deg2rad(70)):
        ours, theirs = F(p, v, f), inu.jacobian(f, p, v, np.eye(3))
        here, there = ours.copy(), theirs.copy()
        here[:, 0] = there[:, 0] = 0
        assert_blocks(here, there, 1e-11, in_metres(NED, p))
        assert_latitude_column(ours[:, 0] - theirs[:, 0], p, v)


def assert_latitude_column(difference, p, v):
    """What inu omits: the radii's growth with latitude, by differences of pyins' radii."""
    from pyins import earth as other

    step = 1e-5

    def turning(lat):
        """Rates that the radii enter: position', omega_en with the tangent held at the place itself."""
        rn, re, _ = other.principal_radii(np.rad2deg(lat), p[2])
        north, east = v[0] / rn, v[1] / re
        return np.array([north, east / np.cos(p[0]), 0.0]), np.array([east, -north, -east * np.tan(p[0])])

    (rate_a, en_a), (rate_b, en_b) = turning(p[0] + step), turning(p[0] - step)
    rate, en = (rate_a - rate_b) / (2 * step), (en_a - en_b) / (2 * step)
    expected = np.concatenate([rate, np.cross(v, en), en])
    assert np.abs(difference[:3] - expected[:3]).max() < 1e-12
    assert np.abs(difference[3:6] - expected[3:6]).max() < 1e-9
    assert np.abs(difference[6:] - expected[6:]).max() < 1e-12


def neglected_by_pyins(p, v):
    """Terms of the exact model which pyins leaves out, in pyins' states, and its gravity linear in height instead."""
    from pyins import earth as other

    lat, _, height = p
    step = 1e-5

    def at(where):
        rn, re, _ = other.principal_radii(np.rad2deg(where), height)
        return np.array([rn, re, gravity(where, height)])

    def gravity(where, h):
        return float(earth.normal_gravity(where, h))

    (M, R, g), (M_lat, R_lat, g_lat) = at(lat), (at(lat + step) - at(lat - step)) / (2 * step)
    g_height = (gravity(lat, height + 100) - gravity(lat, height - 100)) / 200
    vN, vE, vD = v
    tangent = np.tan(lat)
    Om = other.RATE * np.array([np.cos(lat), 0, -np.sin(lat)])
    curvature = np.array([[0, 1 / R, 0], [-1 / M, 0, 0], [0, -tangent / R, 0]])
    D = np.zeros((9, 9))
    D[:3, :3] = [[-vD / M, 0, vN / M], [vE * tangent / R, -(vD + vN * tangent) / R, vE / R], [0, 0, 0]]
    D[3:6, :3] = skew(v) @ skew(Om) @ curvature
    D[5, 0] += g_lat / M
    D[3:6, 6:] = -skew(v) @ skew(Om)
    D[6:, 0] = np.array([-vE * R_lat / R**2, vN * M_lat / M**2,
                         -vE / np.cos(lat) ** 2 / R + vE * tangent * R_lat / R**2]) / M  # fmt: skip
    D[6:, 2] = [vE / R**2, -vN / M**2, -vE * tangent / R**2]
    theirs = float(other.gravity(np.rad2deg(lat), height))
    D[3:6, 6:] -= skew([0, 0, g - theirs])
    D[5, 2] += -g_height - 2 * float(other.gravity(np.rad2deg(lat), 0)) / other.A
    return D


def test_the_phi_model_is_that_of_pyins_after_its_change_of_variables_and_its_neglected_terms():
    from pyins import error_model
    from pyins.util import TRAJECTORY_COLS

    F = numbers(em.phi_matrix(NED, POSITION, V_N, F_N), POSITION, V_N, F_N)
    T = eye(9)
    T[0:3, 0:3] = em.displacement_by_position(NED, POSITION)
    T[3:6, 6:9] = -rot.skew(V_N)
    mapped = carried(T, NED)
    changed, entering = numbers(T, POSITION, V_N), numbers(em.noise_matrix(eye(3)), [])([])
    for p, v, f in states(NED, 100, latitude=np.deg2rad(70)):
        pva = pd.Series(np.r_[np.rad2deg(p[0]), np.rad2deg(p[1]), p[2], v, np.zeros(3)], index=TRAJECTORY_COLS)
        theirs, B_gyro, B_accel = error_model.InsErrorModel().system_matrices(pva)
        complete = theirs + neglected_by_pyins(p, v)
        ours = mapped(F(p, v, f), p, v, f)
        # what cancels on the way to a block that is small or zero: a velocity or a specific force times a rotation
        scale = {("P", "A"): np.abs(v).max(), ("P", "V"): 1.0, ("P", "P"): 1e-3}
        for name, block in BLOCKS.items():
            largest = max(np.abs(complete[block]).max(), scale.get(name, 0.0))
            assert np.abs(ours[block] - complete[block]).max() <= 1e-9 * largest, name
        noise = changed(p, v) @ entering
        assert np.abs(noise - np.hstack([B_gyro, B_accel])).max() < 1e-9
