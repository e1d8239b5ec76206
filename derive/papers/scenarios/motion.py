"""A body that turns and moves in axes that do not turn, its sensors, and a navigator that errs; a lever arm, a delay.

True and computed attitude differ by a finite rotation; the computed state is integrated from what the sensors show less
the biases that the navigator believes in.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from boresight.derive.ledger import ellipsoid
from boresight.derive.ledger.numbers import Matrix
from boresight.derive.ledger.witness import finite_rotation, quaternion, rotation_vector, vector
from boresight.derive.papers.scenarios.scenario import Name, Scenario


@dataclass(frozen=True)
class Parts:
    """What a point is made of, or how large each part may be: SI and rad, three components or one size for each."""

    attitude: Any = 1.2
    rate: Any = 1.0
    turn: Any = 1.0
    position: Any = 10.0
    velocity: Any = 10.0
    acceleration: Any = 3.0
    jerk: Any = 2.0
    gravity: Any = 9.8
    field: Any = 1.0
    lever: Any = 2.0
    gyro_bias: Any = 0.1
    accel_bias: Any = 0.5
    attitude_error: Any = 0.1
    position_error: Any = 1.0
    velocity_error: Any = 1.0
    gyro_bias_error: Any = 0.05
    accel_bias_error: Any = 0.1
    gyro_noise: Any = 0.05
    accel_noise: Any = 0.1
    gyro_walk: Any = 0.01
    accel_walk: Any = 0.01
    delay: Any = 0.1
    step: Any = 0.1


ERRORS = {
    "attitude_error": "the attitude error",
    "position_error": "the position error",
    "velocity_error": "the velocity error",
    "gyro_bias_error": "the error of the gyro bias",
    "accel_bias_error": "the error of the accelerometer bias",
    "gyro_noise": "the gyros' noise",
    "accel_noise": "the accelerometers' noise",
    "gyro_walk": "the walk of the gyro bias",
    "accel_walk": "the walk of the accelerometer bias",
    "delay": "the delay",
    "step": "the step",
}

UNITS = {
    "1": "field",
    "rad": "attitude attitude_error",
    "rad/s": "rate gyro_bias gyro_bias_error gyro_noise",
    "rad/s^2": "turn gyro_walk",
    "m": "position lever position_error",
    "m/s": "velocity velocity_error",
    "m/s^2": "acceleration gravity accel_bias accel_bias_error accel_noise",
    "m/s^3": "jerk accel_walk",
    "s": "delay step",
}

NAMES = {
    "C_b2n": Name("1", "attitude: turns components in b into components in n"),
    "q_b2n": Name("1", "attitude as a quaternion, scalar first, Hamilton's"),
    "omega_b": Name("rad/s", "angular rate of b against n, in b"),
    "omega_n": Name("rad/s", "angular rate of b against n, in n"),
    "p_n": Name("m", "position, in n"),
    "v_n": Name("m/s", "velocity, in n"),
    "a_n": Name("m/s^2", "acceleration, in n"),
    "gravity_n": Name("m/s^2", "gravity, in n"),
    "f_b": Name("m/s^2", "specific force, in b"),
    "field_n": Name("1", "a fixed field, as the magnetic one, in n"),
    "field_b": Name("1", "the fixed field, in b"),
    "lever_b": Name("m", "lever arm to a second point of the body, in b"),
    "p_2_n": Name("m", "position of the second point, in n"),
    "v_2_n": Name("m/s", "velocity of the second point, in n"),
    "a_2_n": Name("m/s^2", "acceleration of the second point, in n"),
    "gyro_bias": Name("rad/s", "bias of the gyros"),
    "accel_bias": Name("m/s^2", "bias of the accelerometers"),
    "gyro_noise": Name("rad/s", "noise of the gyros"),
    "accel_noise": Name("m/s^2", "noise of the accelerometers"),
    "gyro_walk": Name("rad/s^2", "rate of change of the gyro bias"),
    "accel_walk": Name("m/s^3", "rate of change of the accelerometer bias"),
    "gyro": Name("rad/s", "what the gyros show: omega_b + gyro_bias + gyro_noise"),
    "accel": Name("m/s^2", "what the accelerometers show: f_b + accel_bias + accel_noise"),
    "gyro_bias_hat": Name("rad/s", "the gyro bias that the navigator believes in"),
    "accel_bias_hat": Name("m/s^2", "the accelerometer bias that the navigator believes in"),
    "omega_hat": Name("rad/s", "computed angular rate: gyro - gyro_bias_hat"),
    "f_hat": Name("m/s^2", "computed specific force: accel - accel_bias_hat"),
    "C_hat": Name("1", "computed attitude"),
    "q_hat": Name("1", "computed attitude as a quaternion"),
    "p_hat": Name("m", "computed position, in n"),
    "v_hat": Name("m/s", "computed velocity, in n"),
    "theta_local": Name("rad", "rotation vector in b: C_b2n = C_hat exp([theta_local x])"),
    "theta_global": Name("rad", "rotation vector in n: C_b2n = exp([theta_global x]) C_hat"),
    "delay": Name("s", "delay: old(x) is x so long ago"),
    "step": Name("s", "time step: after(x) is x so much later, before(x) so much earlier"),
}


def sensed(part: Mapping[str, Matrix]) -> tuple[tuple[str, Callable], ...]:
    """The errors of the sensors, as they are drawn."""
    names = ("gyro_noise", "accel_noise", "gyro_walk", "accel_walk")
    return tuple((name, lambda letters, one=name: [part[one]]) for name in names)


def at(base: Parts, t: Any) -> tuple[tuple[str, Callable], ...]:
    """Groups of values at the time t (s)."""
    part = {name: Matrix(list(getattr(base, name))) for name in Parts.__dataclass_fields__}
    start = finite_rotation(part["attitude"])

    def C(s: Any) -> Matrix:
        return start * finite_rotation(part["rate"] * s + part["turn"] * (s * s / 2))

    def p(s: Any) -> Matrix:
        a, j = part["acceleration"] * (s * s / 2), part["jerk"] * (s * s * s / 6)
        return part["position"] + part["velocity"] * s + a + j

    def second(s: Any) -> Matrix:
        return p(s) + C(s) * part["lever"]

    def after(function: Callable, s: Any = t) -> Any:
        return ellipsoid.rate(lambda change: function(s + change))

    def omega(letters: Any) -> Matrix:
        W = letters["C_b2n"].T * after(C)
        return vector(W[2, 1], W[0, 2], W[1, 0])

    # The computed state from t = 0 on: right to first order in time, which a rate asks for.
    gyro_hat = part["rate"] + part["gyro_bias_error"] + part["gyro_noise"]
    f_0 = start.T * (part["acceleration"] - part["gravity"])
    f_hat = f_0 + part["accel_bias_error"] + part["accel_noise"]
    C_hat_0 = start * finite_rotation(-part["attitude_error"])
    v_hat_0 = part["velocity"] - part["velocity_error"]
    return (
        *sensed(part),
        ("C_b2n", lambda letters: [C(t)]),
        ("q_b2n", lambda letters: [quaternion(letters["C_b2n"])]),
        ("omega_b", lambda letters: [omega(letters)]),
        ("omega_n", lambda letters: [letters["C_b2n"] * letters["omega_b"]]),
        ("p_n", lambda letters: [p(t)]),
        ("v_n", lambda letters: [part["velocity"] + part["acceleration"] * t + part["jerk"] * (t * t / 2)]),
        ("a_n", lambda letters: [part["acceleration"] + part["jerk"] * t]),
        ("gravity_n", lambda letters: [part["gravity"]]),
        ("f_b", lambda letters: [letters["C_b2n"].T * (letters["a_n"] - letters["gravity_n"])]),
        ("field_n", lambda letters: [part["field"]]),
        ("field_b", lambda letters: [letters["C_b2n"].T * part["field"]]),
        ("lever_b", lambda letters: [part["lever"]]),
        ("p_2_n", lambda letters: [second(t)]),
        ("v_2_n", lambda letters: [after(second)]),
        ("a_2_n", lambda letters: [ellipsoid.rate(lambda change: after(second, t + change))]),
        ("gyro_bias", lambda letters: [part["gyro_bias"] + part["gyro_walk"] * t]),
        ("accel_bias", lambda letters: [part["accel_bias"] + part["accel_walk"] * t]),
        ("gyro", lambda letters: [letters["omega_b"] + letters["gyro_bias"] + part["gyro_noise"]]),
        ("accel", lambda letters: [letters["f_b"] + letters["accel_bias"] + part["accel_noise"]]),
        ("gyro_bias_hat", lambda letters: [part["gyro_bias"] - part["gyro_bias_error"]]),
        ("accel_bias_hat", lambda letters: [part["accel_bias"] - part["accel_bias_error"]]),
        ("omega_hat", lambda letters: [letters["gyro"] - letters["gyro_bias_hat"]]),
        ("f_hat", lambda letters: [letters["accel"] - letters["accel_bias_hat"]]),
        ("C_hat", lambda letters: [C_hat_0 * finite_rotation(gyro_hat * t)]),
        ("q_hat", lambda letters: [quaternion(letters["C_hat"])]),
        ("p_hat", lambda letters: [part["position"] - part["position_error"] + v_hat_0 * t]),
        ("v_hat", lambda letters: [v_hat_0 + (C_hat_0 * f_hat + part["gravity"]) * t]),
        ("theta_local", lambda letters: [rotation_vector(letters["C_hat"].T * letters["C_b2n"])]),
        ("theta_global", lambda letters: [rotation_vector(letters["C_b2n"] * letters["C_hat"].T)]),
        ("delay", lambda letters: [part["delay"][0]]),
        ("step", lambda letters: [part["step"][0]]),
    )


EXACT = """C_b2n q_b2n omega_b omega_n p_n v_n a_n gravity_n f_b field_n field_b lever_b p_2_n v_2_n a_2_n gyro_bias
accel_bias gyro_noise accel_noise gyro_walk accel_walk gyro accel delay step"""
USUAL = Parts(
    attitude_error=1e-3,
    position_error=1.0,
    velocity_error=0.1,
    gyro_bias_error=1e-5,
    accel_bias_error=1e-2,
    gyro_noise=1e-4,
    accel_noise=1e-2,
    gyro_walk=1e-7,
    accel_walk=1e-5,
    delay=1e-2,
    step=1e-2,
)
MOTION = Scenario(
    name="motion",
    sizes=Parts(),
    usual=USUAL,
    at=at,
    names=NAMES,
    errors=tuple(ERRORS),
    parts=ERRORS,
    units={name: unit for unit, names in UNITS.items() for name in names.split()},
    exact=frozenset(EXACT.split()),
)
