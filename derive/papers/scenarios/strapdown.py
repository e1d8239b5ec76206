"""Strapdown navigation over the WGS-84 ellipsoid, and a navigator that errs: in a level, or in the Earth's axes.

True and computed rates follow from Newton's law in many digits; true and computed attitude differ by a finite rotation.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from boresight.derive.ledger import ellipsoid
from boresight.derive.ledger.ellipsoid import Level
from boresight.derive.ledger.navigation import Navigator
from boresight.derive.ledger.numbers import Matrix, norm
from boresight.derive.ledger.witness import finite_rotation, quaternion, rotation_vector, skew, vector
from boresight.derive.papers.scenarios.motion import sensed
from boresight.derive.papers.scenarios.scenario import Name, Scenario


@dataclass(frozen=True)
class Parts:
    """What a point is made of, or how large each part may be: SI and rad, three components or one size for each.

    position: longitude, latitude, height.  position_error: as position, or in ECEF metres along the Earth's axes.
    """

    position: Any = (3.0, 1.2, 1000.0)
    velocity: Any = 100.0
    attitude: Any = 1.2
    force: Any = 10.0
    rate: Any = 1.0
    jerk: Any = 2.0
    turn: Any = 1.0
    lever: Any = 2.0
    gyro_bias: Any = 0.01
    accel_bias: Any = 0.1
    position_error: Any = (1e-3, 1e-3, 1000.0)
    velocity_error: Any = 1.0
    attitude_error: Any = 0.1
    gyro_bias_error: Any = 0.01
    accel_bias_error: Any = 0.1
    gyro_noise: Any = 0.01
    accel_noise: Any = 0.1
    gyro_walk: Any = 0.01
    accel_walk: Any = 0.01
    gnss_position_noise: Any = 10.0
    gnss_velocity_noise: Any = 1.0


ERRORS = {
    "position_error": "the position error",
    "velocity_error": "the velocity error",
    "attitude_error": "the attitude error",
    "gyro_bias_error": "the error of the gyro bias",
    "accel_bias_error": "the error of the accelerometer bias",
    "gyro_noise": "the gyros' noise",
    "accel_noise": "the accelerometers' noise",
    "gyro_walk": "the walk of the gyro bias",
    "accel_walk": "the walk of the accelerometer bias",
    "gnss_position_noise": "the noise of the GNSS position",
    "gnss_velocity_noise": "the noise of the GNSS velocity",
}
UNITS = {
    "rad/s": "rate gyro_bias gyro_bias_error gyro_noise",
    "rad/s^2": "turn gyro_walk",
    "rad": "attitude attitude_error",
    "m": "lever gnss_position_noise",
    "m/s": "velocity velocity_error gnss_velocity_noise",
    "m/s^2": "force accel_bias accel_bias_error accel_noise",
    "m/s^3": "jerk accel_walk",
}

# Of x and of x_hat, what the navigator computes in its place; {n}: the axes, {v}: those of the velocity.
BOTH = {
    "lat": Name("rad", "geodetic latitude"),
    "lon": Name("rad", "longitude"),
    "height": Name("m", "height above the ellipsoid"),
    "v_{n}": Name("m/s", "velocity over the ground, in {n}"),
    "C_b2{n}": Name("1", "attitude: turns components in b into components in {n}"),
    "q_b2{n}": Name("1", "attitude as a quaternion, scalar first, Hamilton's"),
    "f_b": Name("m/s^2", "specific force, in b"),
    "omega_ib_b": Name("rad/s", "angular rate of b against inertial space, in b"),
    "f_{n}": Name("m/s^2", "specific force, in {n}"),
    "omega_ie_{n}": Name("rad/s", "the Earth's rate, in {n}"),
    "gravity_{n}": Name("m/s^2", "gravity with the centrifugal part, in {n}"),
}
LEVEL_BOTH = {
    "omega_en_n": Name("rad/s", "transport rate, in n"),
    "omega_in_n": Name("rad/s", "omega_ie_n + omega_en_n"),
    "R_M": Name("m", "meridian radius of curvature"),
    "R_P": Name("m", "transverse radius of curvature"),
}
ECEF_BOTH = {"r_e": Name("m", "position in the Earth's axes")}
ONCE = {
    "phi": Name("rad", "rotation vector in {n}: C_b2{n}_hat = exp(-[phi x]) C_b2{n}"),
    "gyro_bias": Name("rad/s", "bias of the gyros"),
    "accel_bias": Name("m/s^2", "bias of the accelerometers"),
    "gyro_bias_hat": Name("rad/s", "the gyro bias that the navigator believes in"),
    "accel_bias_hat": Name("m/s^2", "the accelerometer bias that the navigator believes in"),
    "gyro": Name("rad/s", "what the gyros show: omega_ib_b + gyro_bias + gyro_noise"),
    "accel": Name("m/s^2", "what the accelerometers show: f_b + accel_bias + accel_noise"),
    "gyro_noise": Name("rad/s", "noise of the gyros"),
    "accel_noise": Name("m/s^2", "noise of the accelerometers"),
    "gyro_walk": Name("rad/s^2", "rate of change of the gyro bias"),
    "accel_walk": Name("m/s^3", "rate of change of the accelerometer bias"),
    "lever_b": Name("m", "lever arm from the sensors to the antenna, in b"),
    "omega_ie": Name("rad/s", "the Earth's rate, a number"),
}
LEVEL_ONCE = {
    "psi": Name("rad", "rotation vector in c: C_b2n_hat = exp(-[psi x]) C_n2c C_b2n"),
    "C_n2c": Name("1", "turns components in n into those in c, the level of the computed position"),
    "gnss_velocity": Name("m/s", "velocity of the antenna over the ground, in n, with noise"),
    "gnss_velocity_noise": Name("m/s", "noise of the GNSS velocity"),
}
ECEF_ONCE = {
    "gravity_gradient_e": Name("1/s^2", "how gravity_e changes with r_e"),
    "gnss_position": Name("m", "position of the antenna, in e, with noise"),
    "gnss_position_noise": Name("m", "noise of the GNSS position"),
    "gnss_velocity": Name("m/s", "velocity of the antenna, in e, with noise"),
    "gnss_velocity_noise": Name("m/s", "noise of the GNSS velocity"),
}


def names(axes: str, both: Mapping[str, Name], once: Mapping[str, Name]) -> dict[str, Name]:
    """The names of a scenario in these axes."""
    found: dict[str, Name] = {}
    for name, one in {**BOTH, **both}.items():
        name, meaning = name.format(n=axes), one.meaning.format(n=axes)
        found |= {name: Name(one.unit, meaning), f"{name}_hat": Name(one.unit, f"computed: {meaning}")}
    return found | {name: Name(one.unit, one.meaning.format(n=axes)) for name, one in {**ONCE, **once}.items()}


@dataclass(frozen=True)
class State:
    """Position, velocity and attitude, in the order and the axes of a scenario, and what the sensors show."""

    position: Matrix
    velocity: Matrix
    C: Matrix
    f_b: Matrix
    omega: Matrix

    def later(self, rates: "State", t: Any) -> "State":
        """The state after a short time: right to first order, which a rate asks for."""
        return State(*(getattr(self, name) + getattr(rates, name) * t for name in self.__dataclass_fields__))


def drawn(base: Parts) -> dict[str, Matrix]:
    return {name: Matrix(list(getattr(base, name))) for name in Parts.__dataclass_fields__}


def states(part: Mapping[str, Matrix], position: Matrix, error: Matrix) -> tuple[State, State]:
    """The true and the computed one at t = 0; error: of the position."""
    C = finite_rotation(part["attitude"])
    gyro, accel = part["gyro_bias_error"] + part["gyro_noise"], part["accel_bias_error"] + part["accel_noise"]
    true = State(position, part["velocity"], C, part["force"], part["rate"])
    hat = State(
        position + error,
        part["velocity"] + part["velocity_error"],
        finite_rotation(-part["attitude_error"]) * C,
        part["force"] + accel,
        part["rate"] + gyro,
    )
    return true, hat


def sensors(part: Mapping[str, Matrix], t: Any) -> tuple[tuple[str, Callable], ...]:
    return (
        *sensed(part),
        ("gyro_bias", lambda letters: [part["gyro_bias"] + part["gyro_walk"] * t]),
        ("accel_bias", lambda letters: [part["accel_bias"] + part["accel_walk"] * t]),
        ("gyro_bias_hat", lambda letters: [part["gyro_bias"] - part["gyro_bias_error"]]),
        ("accel_bias_hat", lambda letters: [part["accel_bias"] - part["accel_bias_error"]]),
        ("gyro", lambda letters: [letters["omega_ib_b"] + letters["gyro_bias"] + part["gyro_noise"]]),
        ("accel", lambda letters: [letters["f_b"] + letters["accel_bias"] + part["accel_noise"]]),
        ("lever_b", lambda letters: [part["lever"]]),
        ("omega_ie", lambda letters: [ellipsoid.SPIN]),
        ("gnss_velocity_noise", lambda letters: [part["gnss_velocity_noise"]]),
    )


def sensed_rates(part: Mapping[str, Matrix], hat: bool) -> tuple[Matrix, Matrix]:
    """How specific force and angular rate change: of the computed ones with what walks."""
    share = int(hat)
    return part["jerk"] + part["accel_walk"] * share, part["turn"] + part["gyro_walk"] * share


# ---- A local level ---------------------------------------------------------------------------------------------------


def in_level(level: Level, base: Parts, t: Any) -> tuple[tuple[str, Callable], ...]:
    part = drawn(base)

    def ordered(geographic: Matrix) -> Matrix:
        return vector(*(geographic[i] for i in level.order))

    def navigator(hat: bool) -> tuple[State, Navigator]:
        state = states(part, ordered(part["position"]), ordered(part["position_error"]))[hat]
        if t != 0:
            now = Navigator(state.position, state.velocity, state.C, state.f_b, state.omega, level)
            rates = State(now.position_rate, now.velocity_rate, now.C_rate, *sensed_rates(part, hat))
            state = state.later(rates, t)
        return state, Navigator(state.position, state.velocity, state.C, state.f_b, state.omega, level)

    def of(hat: bool, end: str) -> tuple[tuple[str, Callable], ...]:
        own, state = f"navigator{end}", f"state{end}"

        def geographic(letters: Any) -> Matrix:
            return level.geographic(letters[state].position)

        def radii(letters: Any) -> list:
            lon, lat, height = geographic(letters)
            place = vector(lon, lat, height)
            slope = ellipsoid.slope(place)
            meridian, parallel = norm(slope[:, 1]) - height, norm(slope[:, 0]) / ellipsoid.cos(lat) - height
            return [meridian, parallel]

        names = ("f_n", "omega_ie_n", "omega_en_n", "omega_in_n", "gravity_n")
        return (
            (f"{state}|{own}", lambda letters: navigator(hat)),
            (f"lon{end}|lat{end}|height{end}", lambda letters: list(geographic(letters))),
            (
                f"v_n{end}|C_b2n{end}|f_b{end}|omega_ib_b{end}",
                lambda letters: [getattr(letters[state], name) for name in ("velocity", "C", "f_b", "omega")],
            ),
            (f"q_b2n{end}", lambda letters: [quaternion(letters[f"C_b2n{end}"])]),
            (
                "|".join(f"{name}{end}" for name in names),
                lambda letters: [getattr(letters[own], name) for name in names],
            ),
            (f"R_M{end}|R_P{end}", radii),
        )

    def antenna(letters: Any) -> Matrix:
        turned = skew(letters["omega_ib_b"]) * part["lever"]
        earth = skew(letters["omega_ie_n"]) * letters["C_b2n"] * part["lever"]
        return letters["v_n"] + letters["C_b2n"] * turned - earth + part["gnss_velocity_noise"]

    return (
        *of(False, ""),
        *of(True, "_hat"),
        *sensors(part, t),
        ("phi", lambda letters: [-rotation_vector(letters["C_b2n_hat"] * letters["C_b2n"].T)]),
        ("C_n2c", lambda letters: [letters["navigator_hat"].axes.T * letters["navigator"].axes]),
        ("psi", lambda letters: [-rotation_vector(letters["C_b2n_hat"] * (letters["C_n2c"] * letters["C_b2n"]).T)]),
        ("gnss_velocity", lambda letters: [antenna(letters)]),
    )


# ---- The Earth's axes ------------------------------------------------------------------------------------------------


def gravity_e(place: Matrix, near: Matrix) -> Matrix:
    """Gravity (m/s^2) at a place (m), both in the Earth's axes; near: geographic coordinates not far from it."""
    return ellipsoid.axes(position := geographic_of(place, near)) * ellipsoid.ENU.gravity(position)


def geographic_of(place: Matrix, near: Matrix) -> Matrix:
    """Longitude, latitude, height of a place, by Newton's method with one slope."""
    position, inverse = near, ellipsoid.slope(near).inv()
    for _ in range(200):
        missing = place - ellipsoid.point(position)
        if norm(missing) < 1e-100:
            return position
        position = Matrix([entry.mid() for entry in position + inverse * missing])
    raise ValueError("a place too far from where it is looked for")


def in_ecef(base: Parts, t: Any) -> tuple[tuple[str, Callable], ...]:
    part = drawn(base)
    near = part["position"]
    spin = vector(0, 0, ellipsoid.SPIN)

    def rates(state: State, hat: bool) -> State:
        acceleration = state.C * state.f_b + gravity_e(state.position, near) - skew(spin) * state.velocity * 2
        turning = state.C * skew(state.omega) - skew(spin) * state.C
        return State(state.velocity, acceleration, turning, *sensed_rates(part, hat))

    def made(hat: bool) -> State:
        state = states(part, ellipsoid.point(near), part["position_error"])[hat]
        return state.later(rates(state, hat), t) if t != 0 else state

    def of(hat: bool, end: str) -> tuple[tuple[str, Callable], ...]:
        own = f"state{end}"
        return (
            (own, lambda letters: [made(hat)]),
            (
                f"r_e{end}|v_e{end}|C_b2e{end}|f_b{end}|omega_ib_b{end}",
                lambda letters: [getattr(letters[own], name) for name in State.__dataclass_fields__],
            ),
            (f"lon{end}|lat{end}|height{end}", lambda letters: list(geographic_of(letters[f"r_e{end}"], near))),
            (f"q_b2e{end}", lambda letters: [quaternion(letters[f"C_b2e{end}"])]),
            (f"f_e{end}", lambda letters: [letters[f"C_b2e{end}"] * letters[f"f_b{end}"]]),
            (f"omega_ie_e{end}", lambda letters: [spin]),
            (f"gravity_e{end}", lambda letters: [gravity_e(letters[f"r_e{end}"], near)]),
        )

    def antenna(letters: Any) -> Matrix:
        return letters["r_e"] + letters["C_b2e"] * part["lever"] + part["gnss_position_noise"]

    def antenna_velocity(letters: Any) -> Matrix:
        turning = letters["C_b2e"] * skew(letters["omega_ib_b"]) - skew(spin) * letters["C_b2e"]
        return letters["v_e"] + turning * part["lever"] + part["gnss_velocity_noise"]

    return (
        *of(False, ""),
        *of(True, "_hat"),
        *sensors(part, t),
        ("phi", lambda letters: [-rotation_vector(letters["C_b2e_hat"] * letters["C_b2e"].T)]),
        (
            "gravity_gradient_e",
            lambda letters: [ellipsoid.jacobian(lambda change: gravity_e(letters["r_e"] + change, near), 3)],
        ),
        ("gnss_position_noise", lambda letters: [part["gnss_position_noise"]]),
        ("gnss_position", lambda letters: [antenna(letters)]),
        ("gnss_velocity", lambda letters: [antenna_velocity(letters)]),
    )


USUAL = Parts(
    position=(3.0, 1.2, 100.0),
    velocity=20.0,
    rate=0.2,
    position_error=(1e-6, 1e-6, 5.0),
    velocity_error=0.1,
    attitude_error=1e-3,
    gyro_bias_error=1e-5,
    accel_bias_error=1e-2,
    gyro_noise=1e-4,
    accel_noise=1e-2,
    gyro_walk=1e-7,
    accel_walk=1e-5,
    gnss_position_noise=3.0,
    gnss_velocity_noise=0.1,
)
BY_PART = {name: unit for unit, listed in UNITS.items() for name in listed.split()}


def level_scenario(level: Level) -> Scenario:
    return Scenario(
        name=f"strapdown-{level.name.lower()}",
        sizes=Parts(),
        usual=USUAL,
        at=lambda base, t: in_level(level, base, t),
        names=names("n", LEVEL_BOTH, LEVEL_ONCE),
        errors=tuple(name for name in ERRORS if name != "gnss_position_noise"),
        parts=ERRORS,
        units=BY_PART | dict.fromkeys(("position", "position_error"), "rad, rad, m"),
        words="exact mechanics",
    )


NED, ENU = level_scenario(ellipsoid.NED), level_scenario(ellipsoid.ENU)
ECEF = Scenario(
    name="strapdown-ecef",
    sizes=Parts(position_error=1000.0),
    usual=Parts(**{**USUAL.__dict__, "position_error": 5.0}),
    at=in_ecef,
    names=names("e", ECEF_BOTH, ECEF_ONCE),
    errors=tuple(ERRORS),
    parts=ERRORS,
    units=BY_PART | {"position": "rad, rad, m", "position_error": "m"},
    words="exact mechanics",
)
