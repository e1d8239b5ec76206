"""The fifteen-state filter: C, Python loop over it, the same loop over plain NumPy: python -m benchmarks.hold

F, Phi and Q alone are timed inside C over many runs.  The loop is 1000 s at rest, 100 Hz strapdown and 1 Hz filter with
zero-velocity and azimuth updates, for one run; NumPy's strapdown and matrices are written below, by hand.
"""

import ctypes
import time

import numpy as np

from boresight.runtime.filter import Filter
from boresight.runtime.library import load
from boresight.runtime.rotation import matrix_from_quaternion, quaternion_from_matrix

CALLS, REPEATS, SECONDS, RATE_HZ = 20_000, 9, 1000, 100
EARTH_RATE, A, E2 = 7.292115e-5, 6378137.0, 0.0066943799901413165
AT_REST = {"position": np.array([2.2, 0.63, 100.0]), "v_n": np.zeros(3), "q_b2n_wxyz": np.array([1.0, 0, 0, 0])}
NOISE = {
    "gyro_noise": np.full(3, 3e-5),
    "accel_noise": np.full(3, 1e-3),
    "gyro_bias_noise": np.full(3, 1e-9),
    "accel_bias_noise": np.full(3, 1e-7),
}


def inside(library, name):
    """Seconds of one call of the C function, from a batch of equal runs."""
    unit = library.units[name]
    bound = unit.bind()
    known = {
        **AT_REST,
        **NOISE,
        "x": 1e-4,
        "gyro_bias": 0.0,
        "accel_bias": 0.0,
        "f_b": [0, 0, 9.8],
        "dt": 1.0,
        "dtheta_ib_b": 1e-6,
        "dv_b": [0, 0, 0.098],
    }
    known |= {"dtheta_before": 1e-6, "dv_before": [0, 0, 0.098]}
    for field, view in bound.inputs.items():
        view[:] = known[field]
    if "dtheta_ib_b" in bound.inputs:
        bound.inputs["dt"][:] = 1 / RATE_HZ
    assert bound() == 0
    arguments = [ctypes.c_size_t(CALLS)]
    for array in bound._arrays.values():
        arguments += [ctypes.c_void_p(array.ctypes.data), ctypes.c_size_t(0)]
    outputs = [np.empty((CALLS, out.size)) for out in bound.outputs.values()]
    status = np.empty(CALLS, np.uint8)
    arguments += [ctypes.c_void_p(a.ctypes.data) for a in (*outputs, status)]
    best = np.inf
    for _ in range(REPEATS):
        start = time.perf_counter()
        unit._many(*arguments)
        best = min(best, (time.perf_counter() - start) / CALLS)
    return best


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
    nav, P, dt = (AT_REST["position"], np.zeros(3), np.eye(3)), np.diag(np.full(15, 1e-6)), 1 / RATE_HZ
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
    lat = AT_REST["position"][1]
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
    return loop.nav["position"], loop.nav["v_n"], matrix_from_quaternion(loop.nav["q_b2n_wxyz"])


def main():
    hold, strapdown = load("azimuth-hold"), load("strapdown")
    print("C alone, ns a call")
    for library, name in ((hold, "F"), (hold, "Phi"), (hold, "Q"), (hold, "feedback"), (strapdown, "step")):
        print(f"  {library.name + ' ' + name:<24}{inside(library, name) * 1e9:8.0f}")
    nav = {**AT_REST, "gyro_bias": np.zeros(3), "accel_bias": np.zeros(3)}
    loop = Filter(hold, nav, np.diag(np.full(15, 1e-6)))
    steps = {
        "predict": lambda: loop.predict(f_b=np.array([0, 0, 9.8]), dt=1.0, **NOISE),
        "update, 3 rows": lambda: loop.update("zupt", np.full(3, 1e-4)),
    }
    print("Python loop over it, us a call: covariance algebra in NumPy")
    for name, step in steps.items():
        best_step = np.inf
        for _ in range(REPEATS):
            start = time.perf_counter()
            for _ in range(200):
                step()
            best_step = min(best_step, (time.perf_counter() - start) / 200)
        print(f"  {name:<24}{best_step * 1e6:8.0f}")
    best = {"generated": np.inf, "plain NumPy": np.inf}
    ends = {}
    for _ in range(3):
        for name, flown in (("generated", generated_loop), ("plain NumPy", plain_loop)):
            start = time.process_time()
            ends[name] = flown()
            best[name] = min(best[name], time.process_time() - start)
    print(f"1000 s at {RATE_HZ} Hz with updates at 1 Hz, one run")
    for name, seconds in best.items():
        print(f"  {name:<24}{seconds:8.2f} s")
    print(f"  ratio {best['plain NumPy'] / best['generated']:.1f}")
    turn = quaternion_from_matrix(ends["generated"][2] @ ends["plain NumPy"][2].T)
    print(f"  they end {2 * np.linalg.norm(turn[1:]):.1e} rad apart in attitude")


if __name__ == "__main__":
    main()
