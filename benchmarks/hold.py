"""A whole flight of the fifteen-state filter, over the C and over plain NumPy: python -m benchmarks.hold

It is 1000 s at rest, 100 Hz strapdown and 1 Hz filter with zero-velocity and azimuth updates, for one run; NumPy's
strapdown and matrices are written below, by hand.
"""

import numpy as np

from benchmarks import interleaved
from boresight.runtime.filter import Filter
from boresight.runtime.library import load
from boresight.runtime.rotation import matrix_from_quaternion, quaternion_from_matrix

SECONDS, RATE_HZ = 1000, 100
EARTH_RATE, A, E2 = 7.292115e-5, 6378137.0, 0.0066943799901413165
AT_REST = {"lon_lat_height": np.array([2.2, 0.63, 100.0]), "v_n": np.zeros(3), "q_b2n_wxyz": np.array([1.0, 0, 0, 0])}
NOISE = {
    "gyro_noise": np.full(3, 3e-5),
    "accel_noise": np.full(3, 1e-3),
    "gyro_bias_noise": np.full(3, 1e-9),
    "accel_bias_noise": np.full(3, 1e-7),
}


def cross(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


class Plain:
    """Strapdown and filter matrices at rest, in NumPy: what one writes without a generator."""

    def step(self, nav, dtheta, dv, dt):
        p, v, C = nav
        lat, h = p[1], p[2]
        w = np.sqrt(1 - E2 * np.sin(lat) ** 2)
        m, n = A * (1 - E2) / w**3 + h, A / w + h
        ie = EARTH_RATE * np.array([0, np.cos(lat), np.sin(lat)])
        en = np.array([-v[1] / m, v[0] / n, v[0] / n * np.tan(lat)])
        g = np.array([0, 0, -9.7803253359 * (1 + 0.00193185 * np.sin(lat) ** 2) / w * (1 - 2 * h / A)])
        v = v + C @ dv + dt * (g - np.cross(2 * ie + en, v))
        p = p + dt * np.array([v[0] / (n * np.cos(lat)), v[1] / m, v[2]])
        C = (np.eye(3) - cross((ie + en) * dt)) @ C @ (np.eye(3) + cross(dtheta) + cross(dtheta) @ cross(dtheta) / 2)
        return p, v, C

    def matrices(self, nav, f_b, dt):
        p, _, C = nav
        lat, h = p[1], p[2]
        w = np.sqrt(1 - E2 * np.sin(lat) ** 2)
        m, n = A * (1 - E2) / w**3 + h, A / w + h
        ie = EARTH_RATE * np.array([0, np.cos(lat), np.sin(lat)])
        F = np.zeros((15, 15))
        F[0, 3], F[1, 4], F[2, 5] = 1 / (n * np.cos(lat)), 1 / m, 1.0
        F[5, 2] = 2 * 9.8 / A
        F[3:6, 3:6], F[3:6, 6:9], F[3:6, 12:15] = -2 * cross(ie), cross(C @ f_b), -C
        F[6, 4], F[7, 3], F[8, 3] = -1 / m, 1 / n, np.tan(lat) / n
        F[6:9, 1] = EARTH_RATE * np.array([0, -np.sin(lat), np.cos(lat)])
        F[6:9, 6:9], F[6:9, 9:12] = -cross(ie), C
        Phi = np.eye(15) + F * dt + F @ F * dt**2 / 2
        G = np.zeros((15, 12))
        G[3:6, 3:6], G[6:9, :3], G[9:, 6:] = C, -C, np.eye(6)
        S = G @ np.diag(np.concatenate(list(NOISE.values())) ** 2) @ G.T
        return Phi, (S + Phi @ S @ Phi.T) * dt / 2


def plain_loop():
    plain, C_ref = Plain(), np.eye(3)
    nav, P, dt = (AT_REST["lon_lat_height"], np.zeros(3), np.eye(3)), np.diag(np.full(15, 1e-6)), 1 / RATE_HZ
    H = np.zeros((4, 15))
    H[:3, 3:6], H[3, 8] = np.eye(3), 1.0
    R = np.diag([1e-4, 1e-4, 1e-4, 1e-6])
    dtheta, dv = earth_and_gravity()
    for _ in range(SECONDS):
        for _ in range(RATE_HZ):
            nav = plain.step(nav, dtheta, dv, dt)
        Phi, Q = plain.matrices(nav, dv / dt, 1.0)
        P = Phi @ P @ Phi.T + Q
        D = nav[2] @ C_ref.T
        z = np.append(nav[1], (D[0, 1] - D[1, 0]) / 2)
        K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
        x = K @ z
        IKH = np.eye(15) - K @ H
        P = IKH @ P @ IKH.T + K @ R @ K.T
        nav = nav[0] - x[:3], nav[1] - x[3:6], (np.eye(3) + cross(x[6:9])) @ nav[2]
    return nav


def earth_and_gravity():
    lat = AT_REST["lon_lat_height"][1]
    return EARTH_RATE * np.array([0, np.cos(lat), np.sin(lat)]) / RATE_HZ, np.array([0, 0, 9.798]) / RATE_HZ


def generated_loop():
    """The same with the compiled functions: the strapdown bound, the filter loop of `boresight.runtime.filter`."""
    hold, step = load("azimuth-hold"), load("strapdown").step.bind()
    nav = {**AT_REST, "gyro_bias": np.zeros(3), "accel_bias": np.zeros(3)}
    loop = Filter(hold, nav, np.diag(np.full(15, 1e-6)))
    step.inputs["dt"][:] = 1 / RATE_HZ
    dtheta, dv = earth_and_gravity()
    carried = [(step.inputs[name], step.outputs[name]) for name in AT_REST]
    for name in ("dtheta_ib_b", "dtheta_before"):
        step.inputs[name][:] = dtheta
    for name in ("dv_b", "dv_before"):
        step.inputs[name][:] = dv
    for _ in range(SECONDS):
        for name in AT_REST:
            step.inputs[name][:] = loop.nav[name]
        for _ in range(RATE_HZ):
            if step():
                raise ValueError("the strapdown refused its input")
            for into, out in carried:
                into[:] = out
        for name in AT_REST:
            loop.nav[name] = step.outputs[name].copy()
        loop.predict(f_b=dv * RATE_HZ, dt=1.0, **NOISE)
        loop.update("zupt", np.full(3, 1e-4))
        loop.update("azimuth", np.full(1, 1e-6), q_ref_wxyz=AT_REST["q_b2n_wxyz"])
        loop.feedback()
    return loop.nav["lon_lat_height"], loop.nav["v_n"], matrix_from_quaternion(loop.nav["q_b2n_wxyz"])


def main():
    loops = {"generated": generated_loop, "plain NumPy": plain_loop}
    seconds = interleaved(loops, rounds=3)
    print(f"1000 s at {RATE_HZ} Hz with updates at 1 Hz, one run")
    for name, spent in seconds.items():
        print(f"  {name:<24}{spent:8.2f} s")
    print(f"  ratio {seconds['plain NumPy'] / seconds['generated']:.1f}")
    ends = {name: loop()[2] for name, loop in loops.items()}
    turn = quaternion_from_matrix(ends["generated"] @ ends["plain NumPy"].T)
    print(f"  they end {2 * np.linalg.norm(turn[1:]):.1e} rad apart in attitude")


if __name__ == "__main__":
    main()
