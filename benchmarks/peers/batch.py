"""Whole steps of many runs from Python: `propagate`, and the four updates in Joseph form.

A tool is given v (N, width) and P (N, n, n), and returns functions that give P, and x, afterwards.  What is the same in
each step, such as arrays of results, is made beforehand.  A tool that keeps P itself from call to call may return two:
one that begins from P and gives the results, and the call alone, which is timed.
"""

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np

from benchmarks import interleaved
from benchmarks.peers.compiled import EQUAL, Differs
from benchmarks.peers.formulas import FUNCTIONS, Problem, apart, matrices, numbers, reference, statements

STEPS = ("propagate", "updates, Joseph")
SIZES = (1, 16, 256, 4096)
CARRIED = ("lon_lat_height", "v_n", "q_b2n_wxyz", "gyro_bias", "accel_bias")  # by the filter in C
Call = Callable[[], Any]
Made = dict[str, Call | tuple[Call, Call]]


def fields(p: Problem, v: np.ndarray) -> dict[str, np.ndarray]:
    """The model's inputs by name, each (N, size)."""
    at = np.cumsum([0, *(size for _, size in p.inputs)])
    return {name: v[:, at[k] : at[k + 1]] for k, (name, _) in enumerate(p.inputs)}


def scalars(p: Problem, v: Any) -> Iterator[tuple[dict[int, float], Any, Any]]:
    """h, z and R of each row of measurement."""
    first, m = len(p.names), len(p.rows)
    return ((h, v[..., first + k], v[..., first + m + k]) for k, h in enumerate(p.rows))


def row(p: Problem, h: dict[int, float]) -> np.ndarray:
    return np.array([h.get(k, 0.0) for k in range(p.n)])


def discrete(p: Problem, xp: Any, v: Any) -> tuple[Any, Any]:
    """Phi and Q (..., n, n) in the array library xp."""
    zero = v[..., 0] * 0.0
    columns = [v[..., k] for k in range(p.width)]
    F, Qc = (
        xp.stack([zero + row.get(j, 0.0) for row in M for j in range(p.n)], -1).reshape(*v.shape[:-1], p.n, p.n)
        for M in matrices(p, columns, {name: getattr(xp, name) for name in FUNCTIONS})
    )
    dt = v[..., p.names.index("dt"), None, None]
    A, W = F * dt, Qc * dt
    AA = A @ A
    B = xp.eye(p.n) + A * (2 / 3) + AA * (2 / 9)
    return xp.eye(p.n) + A + AA / 2, W / 4 + 0.75 * (B @ W @ xp.swapaxes(B, -1, -2))


def propagated(p: Problem, xp: Any, v: Any, P: Any) -> tuple[Any, Any]:
    Phi, Q = discrete(p, xp, v)
    return Phi @ P @ xp.swapaxes(Phi, -1, -2) + Q, (Phi @ v[..., -p.n :, None])[..., 0]


def updated(p: Problem, xp: Any, v: Any, P: Any) -> tuple[Any, Any]:
    x = v[..., -p.n :]
    for h, z, R in scalars(p, v):
        H = xp.asarray(row(p, h))
        g = P @ H
        K = g / (g @ H + R)[..., None]
        A = P - K[..., :, None] * g[..., None, :]
        x = x + K * (z - x @ H)[..., None]
        P = A - (A @ H - R[..., None] * K)[..., :, None] * K[..., None, :]
    return P, x


def by_numpy(p: Problem, v: np.ndarray, P: np.ndarray) -> Made:
    return {"propagate": partial(propagated, p, np, v, P), "updates, Joseph": partial(updated, p, np, v, P)}


def ready(jitted: Callable[..., Any], *arguments: Any) -> Any:
    import jax

    return jax.block_until_ready(jitted(*arguments))


def by_jax(p: Problem, v: np.ndarray, P: np.ndarray) -> Made:
    import jax

    jax.config.update("jax_enable_x64", True)
    made: Made = {}
    v, P = jax.numpy.asarray(v), jax.numpy.asarray(P)
    for kind, function in zip(STEPS, (propagated, updated), strict=True):
        jitted = jax.jit(jax.vmap(partial(function, p, jax.numpy)))
        made[kind] = partial(ready, jitted, v, P)
    return made


_NUMBA: dict[str, Callable[..., Any]] = {}


def by_numba(p: Problem, v: np.ndarray, P: np.ndarray) -> Made:
    """Loops over the runs, one after another; the products by BLAS, as `@` in Numba has them."""
    import numba

    if not _NUMBA:
        n, first, m = p.n, len(p.names), len(p.rows)
        read = "\n        ".join(f"{name} = v[k, {at}]" for at, name in enumerate(p.names))
        text = "\n        ".join(f"{name} = {value}" for name, value in statements(p.statements, True))
        fill = "\n        ".join(
            f"{M}[{i}, {j}] = {M}_{i}_{j}" for M, part in zip(("F", "Qc"), p.entries, strict=True) for i, j in part
        )
        source = f"""
def propagate(v, P, P_out, x_out):
    F, Qc, one = np.zeros(({n}, {n})), np.zeros(({n}, {n})), np.eye({n})
    for k in range(len(v)):
        {read}
        {text}
        {fill}
        A, W = F * dt, Qc * dt
        AA = A @ A
        B = one + A * (2 / 3) + AA * (2 / 9)
        Phi = one + A + AA / 2
        P_out[k] = Phi @ P[k] @ Phi.T + W / 4 + 0.75 * (B @ W @ B.T)
        x_out[k] = Phi @ v[k, {first + 2 * m}:]

def update(v, P, H, P_out, x_out):
    g, K, c = np.empty({n}), np.empty({n}), np.empty({n})
    for k in range(len(v)):
        M, x = P_out[k], x_out[k]
        M[:], x[:] = P[k], v[k, {first + 2 * m}:]
        for r in range({m}):
            z, R, nu = v[k, {first} + r], v[k, {first + m} + r], v[k, {first} + r]
            S = R
            for i in range({n}):
                g[i] = 0.0
                for j in range({n}):
                    g[i] += M[i, j] * H[r, j]
                S += H[r, i] * g[i]
                nu -= H[r, i] * x[i]
            for i in range({n}):
                K[i] = g[i] / S
                x[i] += K[i] * nu
            for i in range({n}):
                c[i] = -R * K[i]
                for j in range({n}):
                    M[i, j] -= K[i] * g[j]
                    c[i] += M[i, j] * H[r, j]
            for i in range({n}):
                for j in range({n}):
                    M[i, j] -= c[i] * K[j]
"""
        scope: dict[str, Any] = {"np": np, **{name: getattr(np, name) for name in FUNCTIONS}}
        exec(source, scope)
        _NUMBA.update({name: numba.njit(scope[name]) for name in ("propagate", "update")})
    H, out = np.array([row(p, h) for h in p.rows]), (np.empty_like(P), np.empty((len(v), p.n)))

    def stepped(*arguments: Any, name: str) -> Any:
        _NUMBA[name](*arguments, *out)
        return out

    return {
        "propagate": partial(stepped, v, P, name="propagate"),
        "updates, Joseph": partial(stepped, v, P, H, name="update"),
    }


def by_filterpy(p: Problem, v: np.ndarray, P: np.ndarray) -> Made:
    """F, Phi and Q by NumPy, for it has none."""
    from filterpy.kalman import KalmanFilter

    loop = KalmanFilter(dim_x=p.n, dim_z=1)
    H = [row(p, h)[None] for h in p.rows]

    def begin() -> None:
        loop.x, loop.P = v[0, -p.n :, None], P[0]

    def propagate() -> Any:
        begin()
        Phi, Q = discrete(p, np, v[0])
        loop.predict(F=Phi, Q=Q)
        return loop.P[None], loop.x.T

    def update() -> Any:
        begin()
        for at, (_, z, R) in zip(H, scalars(p, v[0]), strict=True):
            loop.update(z, R=R, H=at)
        return loop.P[None], loop.x.T

    return {"propagate": propagate, "updates, Joseph": update}


def by_pyins(p: Problem, v: np.ndarray, P: np.ndarray) -> Made:
    from pyins import kalman

    H = [row(p, h)[None] for h in p.rows]

    def update() -> Any:
        x, C = v[0, -p.n :], P[0]
        for at, (_, z, R) in zip(H, scalars(p, v[0]), strict=True):
            x, C, _ = kalman.correct(x, C, np.array([z]), at, np.array([[R]]))
        return C[None], x[None]

    return {"updates, Joseph": update}


def by_simdkalman(p: Problem, v: np.ndarray, P: np.ndarray) -> Made:
    """F, Phi and Q by NumPy, for it has none; its update is P - K H P."""
    from simdkalman import primitives

    x, H = v[:, -p.n :, None], [row(p, h)[None, None] for h in p.rows]

    def propagate() -> Any:
        mean, C = primitives.predict(x, P, *discrete(p, np, v))
        return C, mean[..., 0]

    def update() -> Any:
        mean, C = x, P
        for at, (_, z, R) in zip(H, scalars(p, v), strict=True):
            mean, C = primitives.update(mean, C, at, R[:, None, None], z[:, None, None])
        return C, mean[..., 0]

    return {"propagate": propagate, "updates, Joseph": update}


def by_boresight(compiled: bool, p: Problem, v: np.ndarray, P: np.ndarray) -> Made:
    from boresight.runtime.filter import CompiledFilter, Filter
    from boresight.runtime.library import load

    model, given, x = load("azimuth-hold"), fields(p, v), v[:, -p.n :]
    imu = {name: given[name] for name in given if name == "f_b" or name.endswith("_noise")}
    R = v[:, len(p.names) + len(p.rows) :]
    dt, q_ref = given["dt"][:, 0], given["q_ref_wxyz"]
    loop = (CompiledFilter if compiled else Filter)(model, {name: given[name] for name in CARRIED}, P, x)

    def propagate() -> Any:
        loop.P, loop.x = P, x
        loop.predict(**imu, dt=dt)
        return loop.P, loop.x

    def update() -> Any:
        loop.P, loop.x = P, x
        loop.update("zupt", R[:, :3])
        loop.update("azimuth", R[:, 3:4], q_ref_wxyz=q_ref)
        return loop.P, loop.x

    return {"propagate": propagate, "updates, Joseph": update}


def by_epoch(p: Problem, v: np.ndarray, P: np.ndarray) -> Made:
    """A call that is bound to its arrays; P and x stay in the C."""
    from boresight.runtime.filter import CompiledFilter, Epoch
    from boresight.runtime.library import load

    model, given, x = load("azimuth-hold"), fields(p, v), v[:, -p.n :]
    loop = CompiledFilter(model, {name: given[name] for name in CARRIED}, P, x)
    R = v[:, len(p.names) + len(p.rows) :]
    step = Epoch(loop, 0, feedback=False)
    for name in step.predict.fields.keys() & given.keys():
        step.predict[name] = given[name].reshape(step.predict[name].shape)
    update = Epoch(loop, 0, ("zupt", "azimuth"), predict=False, feedback=False)
    update.measured["zupt"]["R"], update.measured["azimuth"]["R"] = R[:, :3], R[:, 3:4]
    update.measured["azimuth"]["q_ref_wxyz"] = given["q_ref_wxyz"]

    def begun(epoch: Epoch) -> Any:
        loop.P, loop.x = P, x
        assert not epoch(), epoch.refused()
        return loop.P, loop.x

    return {"propagate": (partial(begun, step), step), "updates, Joseph": (partial(begun, update), update)}


TOOLS: dict[str, tuple[Callable[..., Made], int]] = {  # and the most runs at once
    "Boresight, Epoch": (by_epoch, 4096),
    "Boresight, CompiledFilter": (partial(by_boresight, True), 4096),
    "Boresight, Filter": (partial(by_boresight, False), 4096),
    "Numba": (by_numba, 4096),
    "JAX": (by_jax, 4096),
    "NumPy by hand": (by_numpy, 4096),
    "simdkalman": (by_simdkalman, 4096),
    "filterpy": (by_filterpy, 1),
    "python-ins": (by_pyins, 1),
}


def measure(p: Problem, sizes: tuple[int, ...] = SIZES, rounds: int = 15) -> tuple[dict[Any, float], dict[str, str]]:
    """(tool, step, N) -> ns a run; and the tools that are missing, with the reason.  Raises Differs."""
    found: dict[Any, float] = {}
    missing: dict[str, str] = {}
    given = numbers(p)
    place = tuple(np.array(p.upper).T)
    dense = np.zeros((p.n, p.n))
    dense[place] = dense[place[::-1]] = given["P"]
    for N in sizes:
        functions = {}
        for tool, (make, most) in TOOLS.items():
            if most < N or tool in missing:
                continue
            v, P = np.tile(given["v"], (N, 1)), np.tile(dense, (N, 1, 1))
            try:
                made = make(p, v, P)
            except ImportError as error:
                missing[tool] = str(error)
                continue
            for step, function in made.items():
                begun, timed = function if isinstance(function, tuple) else (function, function)
                C, x = (np.asarray(part) for part in begun())
                off = apart(p, step, np.concatenate([C[-1][place], x[-1]]), reference(p, step, given))
                if not off <= EQUAL:
                    raise Differs(f"{tool}, {step}: {off:.1e} from NumPy, where {EQUAL:.0e} is allowed")
                functions[tool, step, N] = timed
        found |= {key: seconds / N * 1e9 for key, seconds in interleaved(functions, rounds).items()}
    return found, missing
