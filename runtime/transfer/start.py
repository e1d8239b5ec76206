"""The slave that takes its master's velocity and attitude over, at the first message."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from boresight.errors import BoresightError, did_you_mean
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.filter import Filter
from boresight.runtime.transfer.history import ACCEL_BIAS, DV, GYRO_BIAS, PHI, SIZES, TAU, History, moment
from boresight.runtime.units import STANDARD_GRAVITY

LEVER = "lever_b"
PASSES = 3  # over the increments: tilt, then velocity, and what is left is of the order of the Earth's rate
SHORTEST = 1e-6  # s, of a step


@dataclass(frozen=True)
class Message:
    """What a master reports at one time, for `first`.

    Leading axes are runs; a field without them is that of all runs.  NED, SI and rad.

    Parameters
    ----------
    time : (...,) array
        s, by the slave's clock: when it was measured, or, where only that is known, when it
        arrived.
    R : (..., 6) array
        Variances of the velocity's three rows, (m/s)^2, then of the attitude's, rad^2: about north,
        east, down, or of roll, pitch, yaw with `euler_m`.
    v_m_n : (..., 3) array, optional
        Velocity of the master, m/s.
    q_m2n_wxyz : (..., 4) array, optional
        Attitude of the master, scalar first, master body to NED.
    euler_m : (..., 3) array, optional
        Roll, pitch, yaw of the master, rad, instead of the quaternion.
    position : (..., 3) array, optional
        Latitude and longitude, rad, and height, m.

    Notes
    -----
    When not to use it: for the messages that follow; `Live.message` and the filters take their
    fields by name.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import Message
    >>> Message(12.3, np.repeat([0.02, 1e-4], 3) ** 2, v_m_n=[10.0, 0, 0]).time
    12.3
    """

    time: Any
    R: Any
    v_m_n: Any = None
    q_m2n_wxyz: Any = None
    euler_m: Any = None
    position: Any = None


class Increments(NamedTuple):
    """What the slave delivered, in order and without a gap: `Increments(*recording.imu.increments)`."""

    begin: Array  # (K,) s
    end: Array  # (K,) s
    dtheta: Array  # (K, ..., 3) rad, biases in it
    dv: Array  # (K, ..., 3) m/s


def first(
    message: Message,
    model: Any,
    constants: Mapping[str, Any],
    *,
    sigmas: Mapping[str, Any] | None = None,
    P: Any = None,
    estimates: Mapping[str, Any] | None = None,
    increments: Increments | None = None,
    rate_sigma: Any = None,
    acceleration_sigma: Any = None,
    matching: tuple[str, str] = ("velocity", "dcm"),
    half_span_s: float = 0.02,
) -> tuple[dict[str, Array], Array]:
    """nav and P (..., n, n) of a slave that takes the master's velocity and attitude over, for a filter to begin with.

    constants: what the model's functions read beside nav and the sensors: root densities of the noises, `lever_b` in m.
    sigmas: of each quantity that `feedback` corrects, by its name: `q_b2m_wxyz` (rad,
    about the master's axes), `gyro_bias`, `accel_bias`, `tau`, `lever_b` if it is a state, and those of a composition;
    one number, or (..., size).  Also that of a lever arm that is a constant, `lever_b`, else it is exact.
    P: (..., n, n) in place of these, of which the block behind attitude and velocity is taken.
    estimates: where these quantities begin, by name; at zero, and the mounting straight, where not given; and what else
    a composition carries in nav.
    increments: the slave's, from four times `half_span_s` before the message was measured until now.  nav and P are
    those of `increments.end[-1]`: what the master said is carried there from `message.time - tau`, and P holds what its
    noise, the mounting, the lever arm, the biases, the delay and the gyros' noise do to it.
    Without increments nav is as the master said, at `message.time`; rate_sigma (rad/s) and acceleration_sigma (m/s^2)
    then say how the slave may move.
    Raises BoresightError on a message without position, velocity or attitude, on a sigma that is missing, and on
    increments with a gap, or that do not reach from the message to now.
    """
    fields = estimated(model)
    given = dict(sigmas or {}) if P is None else dict.fromkeys(fields, 0.0) | dict(sigmas or {})
    start, said = _begun(message, model, fields, given, dict(estimates or {}), matching[1])
    if increments is None and (rate_sigma is None or acceleration_sigma is None):
        raise BoresightError("first: without increments nothing says how the slave moves; give increments, or "
                             "rate_sigma (rad/s) and acceleration_sigma (m/s^2)")  # fmt: skip
    for name in constants:
        if name not in model.field:
            raise BoresightError(f"first: constants holds {name!r}, which {model.name} does not know"
                                 f"{did_you_mean(name, model.field)}")  # fmt: skip
    sizes = {name: model.field[name]["size"] for name in (*start, *constants)}
    runs = np.broadcast_shapes(
        np.shape(P)[:-2], np.shape(message.time), np.shape(message.R)[:-1],
        *(np.shape(part)[1:-1] for part in (increments or ())[2:]),
        *(_leading(value, sizes[name]) for name, value in (start | dict(constants)).items()),
        *(_leading(value, len(fields.get(name, "xyz"))) for name, value in given.items()),
    )  # fmt: skip
    n = len(model.states)
    S = np.zeros((*runs, n, n))
    if P is not None:
        S[..., 6:, 6:] = np.asarray(P, float)[..., 6:, 6:]
    else:
        for name, places in fields.items():
            S[..., places, places] = _spread(given[name], runs, len(places)) ** 2
    nav = {name: _spread(value, runs, sizes[name]) for name, value in start.items()}
    loop = Filter(model, {name: v if sizes[name] > 1 else v[..., 0] for name, v in nav.items()}, S)
    then = np.broadcast_to(np.asarray(message.time, float), runs) - loop.nav["tau"]
    history, moving = _flown(loop, increments, then, said, constants, half_span_s)
    at, density = moving(0.0)

    def H(at: dict[str, Any]) -> Array:
        rows = [loop.call(f"{name}_H", **at, **said, lag=0.0) for name in matching]
        return np.concatenate([np.broadcast_to(row, (*runs, *row.shape[-2:])) for row in rows], axis=-2)

    # What the rates do not know, into the lever arm's velocity; and a lever arm that is no state.
    R = _spread(message.R, runs, 6)[..., None] * np.eye(6)
    by_rate, by_lever = _lever(loop, at)
    rate = np.max(np.asarray(constants["gyro_noise"]), axis=-1) ** 2 * density
    rate = rate[..., None, None] * np.eye(3)
    if increments is None:
        rate = rate + _spread(rate_sigma, runs, 3)[..., None] ** 2 * np.eye(3)
    constant = given.get(LEVER, 0.0) if LEVER not in fields else 0.0
    R[..., :3, :3] += _through(by_rate, rate) + _through(
        by_lever, _spread(constant, runs, 3)[..., None] ** 2 * np.eye(3)
    )
    # The residual is zero, and H x = noise: the errors of attitude and velocity are D (noise - H x of all others).
    H_then = H(at)
    D = np.linalg.inv(H_then[..., :6])
    by_rest, kept = -D @ H_then[..., 6:], S[..., 6:, 6:]
    loop.P[..., :6, 6:] = by_rest @ kept
    loop.P[..., 6:, :6] = np.swapaxes(loop.P[..., :6, 6:], -1, -2)
    loop.P[..., :6, :6] = _through(by_rest, kept) + _through(D, R)
    if increments is None:
        ago = loop.nav["tau"] ** 2 + S[..., TAU, TAU]
        for sigma, block in ((rate_sigma, PHI), (acceleration_sigma, DV)):
            loop.P[..., block, block] += (ago[..., None] * _spread(sigma, runs, 3) ** 2)[..., None] * np.eye(3)
        return loop.nav, loop.P
    # The motion in the delay's error, of the second order: E[d^4] = 3 sigma^4.
    step = 2 * half_span_s
    change = (D @ (H(moving(step)[0]) - H(moving(-step)[0]))[..., TAU, None])[..., 0] / (2 * step)
    loop.P[..., :6, :6] += 0.75 * (S[..., TAU, TAU] ** 2)[..., None, None] * change[..., None] * change[..., None, :]
    # The delay's error times that of the rates: by the biases, and by the axes in which the motion is seen.
    C = rotation.matrix_from_quaternion(at["q_b2n_wxyz"])
    turned = loop.P[..., PHI, PHI].copy()
    for block, bias in ((PHI, GYRO_BIAS), (DV, ACCEL_BIAS)):
        force = by_rest[..., block, TAU - 6] - (STANDARD_GRAVITY * np.eye(3)[2] if block is DV else 0.0)
        rate = np.cross(force[..., None, :], np.eye(3))
        rates = _through(C, S[..., bias, bias]) + _through(rate, turned)
        loop.P[..., block, block] += S[..., TAU, TAU, None, None] * rates
    assert history is not None
    _carry(loop, history, then, 2 * half_span_s, constants)
    return loop.nav, (loop.P + np.swapaxes(loop.P, -1, -2)) / 2


def estimated(model: Any) -> dict[str, list[int]]:
    """What is estimated besides attitude and velocity: the fields of nav that `feedback` corrects, and their states."""
    n = len(model.states)
    x = np.vstack([np.zeros(n), 1e-3 * np.eye(n)])
    out = model.feedback(x=x, **{name: straight(model, name) for name in model.feedback.fields if name != "x"})
    return {
        name: [i for i in range(n) if np.any(value[1 + i] != value[0])]
        for name, value in out.items()
        if name not in ("v_n", "q_b2n_wxyz")
    }


def straight(model: Any, name: str) -> Array:
    """Nothing: zeros, or the quaternion that does not turn."""
    size = model.field[name]["size"]
    return np.array([1.0, 0.0, 0.0, 0.0]) if "wxyz" in name else np.zeros(size) if size > 1 else np.array(0.0)


def _leading(value: Any, size: int) -> tuple[int, ...]:
    """The runs of a value of so many components."""
    shape = np.shape(value)
    return shape[:-1] if size > 1 else shape


def _spread(value: Any, runs: tuple[int, ...], size: int) -> Array:
    """(*runs, size)"""
    array = np.asarray(value, float)
    return np.broadcast_to(array if size > 1 else array[..., None], (*runs, size))


def _through(A: Array, S: Array) -> Array:
    """A S A'"""
    return A @ S @ np.swapaxes(A, -1, -2)


def _begun(
    message: Message,
    model: Any,
    fields: dict[str, list[int]],
    sigmas: dict[str, Any],
    estimates: dict[str, Any],
    attitude: str,
) -> tuple[dict[str, Any], dict[str, Any]]:
    """nav as the message and the estimates have it, and what the message says."""
    for name in ("position", "v_m_n"):
        if getattr(message, name) is None:
            raise BoresightError(f"first: the message holds no {name}; wait for one that does")
    q, euler = message.q_m2n_wxyz, message.euler_m
    if q is None and euler is None:
        raise BoresightError("first: the message holds no q_m2n_wxyz; wait for one that does, or begin by `Headings`")
    for known, names in (
        ({*fields, LEVER}, sigmas),
        (set(model.field) - {"lat_lon_height", "v_n", "q_b2n_wxyz"}, estimates),
    ):
        for name in set(names) - known:
            raise BoresightError(f"first: {model.name} estimates no {name!r}{did_you_mean(name, known)}")
    for name in fields:
        if name not in sigmas:
            raise BoresightError(f"first: sigmas holds no {name!r}; it needs {', '.join(fields)}")
    q = rotation.quaternion_from_euler(euler) if q is None else np.asarray(q, float)
    said = {"v_m_n": np.asarray(message.v_m_n, float), "q_m2n_wxyz": q}
    if attitude.startswith("euler"):
        said["euler_m"] = rotation.euler_from_matrix(rotation.matrix_from_quaternion(q)) if euler is None else euler
    start = {"lat_lon_height": message.position, "v_n": message.v_m_n, "q_b2n_wxyz": q}
    if why := outside(model, {name: np.asarray(value, float) for name, value in start.items()}):
        raise BoresightError(f"first: of the message {why}")
    return start | {name: straight(model, name) for name in fields} | estimates, said


def _flown(
    loop: Filter,
    increments: Increments | None,
    then: Array,
    said: dict[str, Any],
    constants: Mapping[str, Any],
    half_span_s: float,
) -> tuple[History | None, Callable[[float], tuple[dict[str, Any], Any]]]:
    """Brings loop.nav to now, so that at `then` the master is expected to say what it said.

    Returns the past flown, and the slave so many seconds beside `then`, as of `moment`.  The position moves from then.
    """
    start = dict(loop.nav)
    flat = then.reshape(-1)
    history: History | None = None
    parts = None if increments is None else _reaching(increments, flat, half_span_s)

    def beside(seconds: float) -> tuple[dict[str, Any], Any]:
        if history is None:
            still = {"v_n": loop.nav["v_n"], "q_b2n_wxyz": loop.nav["q_b2n_wxyz"]}
            return {**still, "omega_ib_b": np.zeros(3), "a_n": np.zeros(3), **constants}, 0.0
        inputs, factor = moment(loop, history, flat + seconds, half_span_s, constants)
        return {**inputs, **constants}, factor

    def fly() -> dict[str, Any]:
        """Loop and past from `start` on; what was then expected of the master."""
        nonlocal history
        loop.nav = dict(start)
        if parts is not None:
            history = _past(loop, parts, constants)
        at = {name: value for name, value in beside(0.0)[0].items() if name != "a_n"}
        expected: dict[str, Any] = loop.call("expected", **at)
        return expected

    matrix = rotation.matrix_from_quaternion
    for _ in range(PASSES):
        expected = fly()
        turn = matrix(said["q_m2n_wxyz"]) @ np.swapaxes(matrix(expected["q_m2n_wxyz"]), -1, -2)
        start["v_n"] = start["v_n"] + said["v_m_n"] - expected["v_m_n"]
        start["q_b2n_wxyz"] = rotation.quaternion_from_matrix(turn @ matrix(start["q_b2n_wxyz"]))
    fly()
    if history is not None:
        now, begin = history.time[-1], history.time[0]
        part = ((now - then) / (now - begin))[..., None]
        begun = start["lat_lon_height"]
        loop.nav["lat_lon_height"] = begun + part * (loop.nav["lat_lon_height"] - begun)
    return history, beside


def _reaching(increments: Increments, then: Array, half_span_s: float) -> Increments:
    """The increments from four half spans before the earliest `then` on; BoresightError where they do not fit."""
    begin, end, dtheta, dv = (np.asarray(part, float) for part in increments)
    if len(end) == 0:
        raise BoresightError("first: increments is empty; keep the slave's last second for the first message")
    apart = np.abs(begin[1:] - end[:-1]) > 0.5 * (end - begin)[1:]
    if apart.any():
        k = int(np.argmax(apart))
        raise BoresightError(f"first: the increments have a gap from {end[k]:.4f} s to {begin[k + 1]:.4f} s; give "
                             "those behind it, and a message from there")  # fmt: skip
    if then.min() < begin[0] - SHORTEST:
        raise BoresightError(f"first: the message was measured at {then.min():.4f} s, and the increments begin at "
                             f"{begin[0]:.4f} s; keep more of them, or wait for the next message")  # fmt: skip
    if then.max() > end[-1] + half_span_s:
        raise BoresightError(f"first: the message was measured at {then.max():.4f} s, and the increments end at "
                             f"{end[-1]:.4f} s; wait for the slave, or compare the clocks")  # fmt: skip
    k = max(0, int(np.searchsorted(end, then.min() - 4 * half_span_s)) - 1)
    return Increments(begin[k:], end[k:], dtheta[k:], dv[k:])


def _past(loop: Filter, increments: Increments, constants: Mapping[str, Any]) -> History:
    """The strapdown over the increments, which leaves loop.nav at their end."""
    runs = loop.P.shape[:-2]
    angle = push = np.zeros((*runs, 3))
    before = increments.dtheta[0], increments.dv[0]
    kept = [(loop.nav["v_n"], loop.nav["q_b2n_wxyz"], angle, push)]
    for begin, end, dtheta, dv in zip(*increments, strict=True):
        shown = {"dtheta_ib_b": dtheta, "dv_b": dv, "dtheta_before": before[0], "dv_before": before[1]}
        loop.strapdown(**shown, dt=end - begin, **constants)
        before, angle, push = (dtheta, dv), angle + dtheta, push + dv
        kept.append((loop.nav["v_n"], loop.nav["q_b2n_wxyz"], angle, push))
    time = np.concatenate([increments.begin[:1], increments.end])
    columns = zip(SIZES.items(), zip(*kept, strict=True), strict=True)
    return History(time, **{name: np.array(part).reshape(len(time), -1, size) for (name, size), part in columns})


def _carry(loop: Filter, history: History, then: Array, shortest: float, constants: Mapping[str, Any]) -> None:
    """The covariance from `then` to now."""
    lag = history.time[-1] - then
    span = np.maximum(lag, shortest).reshape(-1)
    now = np.full(history.runs, history.time[-1])
    f_b, omega = (history.mean(name, now - span, now).reshape((*then.shape, 3)) for name in ("push", "angle"))
    loop.predict(
        f_b=f_b - loop.nav["accel_bias"], omega_ib_b=omega - loop.nav["gyro_bias"], dt=np.maximum(lag, SHORTEST),
        q_b2n_wxyz=history.at("q_b2n_wxyz", now - span / 2).reshape((*then.shape, 4)), **constants,
    )  # fmt: skip


def _lever(loop: Filter, at: dict[str, Any]) -> tuple[Array, Array]:
    """How the master's expected velocity moves, linearly, with the rate and with the lever arm: (..., 3, 3) each."""
    at = {name: value for name, value in at.items() if name != "a_n"}
    v = loop.call("expected", **at)["v_m_n"]
    out = []
    for field, value in (("omega_ib_b", at["omega_ib_b"]), (LEVER, {**loop.nav, **at}[LEVER])):
        moved = [loop.call("expected", **{**at, field: value + 0.1 * e})["v_m_n"] - v for e in np.eye(3)]
        out.append(np.stack(moved, axis=-1) / 0.1)
    return out[0], out[1]


def outside(model: Any, nav: Mapping[str, Array]) -> str:
    """The first quantity of nav that is beyond its box or no number, in words; "" where there is none."""
    for name, value in nav.items():
        if (box := model.field.get(name)) is None:
            continue
        each = value if box["size"] > 1 else value[..., None]
        off = ~((each >= np.array(box["low"])) & (each <= np.array(box["high"])))
        if off.any():
            at = tuple(np.argwhere(off)[0])
            label = f"{name}[{at[-1]}]" if box["size"] > 1 else name
            if name == "lat_lon_height":
                label = ("latitude", "longitude", "height")[at[-1]]
            span = f"{box['low'][at[-1]]:.6g} to {box['high'][at[-1]]:.6g}"
            return f"{label} is {each[at]:.6g}, and the model's range is {span}"
    return ""
