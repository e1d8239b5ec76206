"""Ten-state transfer alignment on a moving bench, up to the start of the hold: velocity and DCM matching of Kim (2018).

The slave, a tactical-grade unit with the errors of Kim's Table 1, is bolted to a bench beside a master of about one
nautical mile per hour.  The bench sways and turns, the master's data arrives late, and what the filter does not
estimate (the slave's biases, the master's own errors) is carried beside it, so that the hold begins with a covariance
that is true.  ENU, body axes right-front-up.  Axes of arrays: runs, then components.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.observability import taken_over
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.filter import CompiledFilter
from boresight.runtime.library import load
from boresight.runtime.simulation import inertial, sensors
from boresight.runtime.units import ARCMIN, DEG, FOOT, HOUR, MILLI_G
from boresight.studies import study
from boresight.studies.azimuth_hold import handover
from boresight.studies.study import Seeded, option


@dataclass(frozen=True)
class Scenario(Seeded):
    """Everything that is chosen, for alignment and hold.  All errors are one sigma, drawn for each run."""

    seconds: int = option(3600, "Length of the hold at rest.")
    # Table 1 of the paper.
    gyro_bias_deg_h: float = 1.0
    gyro_scale_ppm: float = 150.0
    gyro_misalignment_urad: float = 100.0
    gyro_walk_deg_sqrt_h: float = 0.125
    accel_bias_mg: float = 1.0
    accel_scale_ppm: float = 300.0
    accel_misalignment_urad: float = 100.0
    accel_walk_ft_s_sqrt_h: float = 0.065
    # The place and the platform: the paper says nothing.
    latitude_deg: float = 36.4
    longitude_deg: float = 127.4
    height_m: float = 60.0
    roll_deg: float = 2.0
    pitch_deg: float = -1.0
    heading_deg: float = 30.0
    # The bench: sinusoids, faded in and out; yaw roll pitch as seen by a right-front-up body.
    align_s: float = 120.0
    fade_s: float = 5.0
    bench_deg: tuple[float, float, float] = (5.0, 5.0, 10.0)  # roll, pitch, yaw
    bench_period_s: tuple[float, float, float] = (7.0, 5.0, 11.0)
    bench_m_s: tuple[float, float, float] = (0.6, 0.6, 0.1)  # east, north, up
    bench_velocity_period_s: tuple[float, float, float] = (6.0, 8.0, 4.0)
    # The master, of about a nautical mile per hour: gyros of 0.01 deg/h, which find north to 0.8 mrad, and 50 ug.
    master_velocity_m_s: float = 0.3
    master_level_urad: float = 50.0
    master_azimuth_urad: float = 820.0
    master_position_m: float = 400.0
    master_height_m: float = 10.0
    velocity_noise_m_s: float = 0.01
    attitude_noise_arcmin: float = 0.3
    mounting_deg: float = 0.5
    delay_s: float = 0.05
    # What the alignment filter is told: its Q carries the biases as white noise that has drifted as far after this.
    bias_time_s: float = 10.0
    strapdown_hz: int = 100
    covariance_hz: int = 10  # of the alignment; its updates, and all of the hold, are at 1 Hz
    # The hold's filter.
    zupt_sigma_m_s: float = 0.01

    @property
    def master_sigma(self) -> tuple[Array, Array, Array]:
        """(3,) each of the master's own errors: position in m and velocity in m/s, east north up, and psi in rad."""
        return (
            np.array([self.master_position_m, self.master_position_m, self.master_height_m]),
            self.master_velocity_m_s * np.array([1, 1, 0.1]),  # a master's height is damped
            1e-6 * np.array([self.master_level_urad, self.master_level_urad, self.master_azimuth_urad]),
        )


SIGNED = ("seed", "longitude_deg", "roll_deg", "pitch_deg", "heading_deg")
LIMITS = {
    "runs": (1, np.inf),
    "seconds": (10, 36000),
    "latitude_deg": (-85, 85),
    "height_m": (-500, 30000),
    "zupt_sigma_m_s": (1e-9, 100),
    "align_s": (10, 3600),
}


def checked(scenario: Scenario) -> Scenario:
    """The scenario; raises BoresightError for a value that has no meaning or lies outside the models' box."""
    study.checked("azimuth-hold", scenario, SIGNED, LIMITS)
    if scenario.covariance_hz < 1 or scenario.strapdown_hz % scenario.covariance_hz:
        raise BoresightError(
            f"azimuth-hold: covariance_hz is {scenario.covariance_hz}; "
            f"strapdown_hz, {scenario.strapdown_hz}, must be a multiple of it"
        )
    return scenario


@dataclass(frozen=True)
class Models:
    """The generated functions that the study flies."""

    strapdown: Any
    alignment: Any
    hold: Any
    hold_reference: Any  # with the error of the reference as a sixteenth state; of no variance, it is the hold
    psi: Any


MODELS = ("strapdown", "velocity-dcm", "azimuth-hold", "azimuth-hold-reference", "psi-error")


def load_models() -> Models:
    return Models(*map(load, MODELS))


@dataclass(frozen=True)
class Sensors:
    """The slave's inertial unit, run by run: measured = gain true + bias + white noise."""

    gyro_gain: Array  # (runs, 3, 3)
    gyro_bias: Array  # (runs, 3) rad/s
    accel_gain: Array
    accel_bias: Array  # (runs, 3) m/s^2
    gyro_walk: float  # rad/sqrt(s)
    accel_walk: float  # m/s/sqrt(s)
    streams: tuple[np.random.Generator, ...]  # one a run

    def measured(self, dtheta: Array, dv: Array, dt: float, samples: int) -> tuple[Array, Array]:
        """Increments (samples, ..., runs, 3) of the true ones, which may be given once for all samples, (runs, 3).

        Axes between samples and runs see the same noise.
        """
        noise = np.empty((len(self.streams), samples, 6))
        for row, stream in zip(noise, self.streams, strict=True):
            stream.standard_normal(out=row)
        between = tuple(range(1, np.ndim(dtheta) - 2))
        noise = np.expand_dims(np.moveaxis(noise, 0, 1), between) * np.sqrt(dt)
        return (
            np.einsum("rij,...rj->...ri", self.gyro_gain, dtheta) + self.gyro_bias * dt
            + noise[..., :3] * self.gyro_walk,
            np.einsum("rij,...rj->...ri", self.accel_gain, dv) + self.accel_bias * dt
            + noise[..., 3:] * self.accel_walk,
        )  # fmt: skip

    def bias_at(self, omega_ib_b: Array, f_b: Array) -> tuple[Array, Array]:
        """What the gyros and accelerometers are wrong by, but for noise, in this constant input: (runs, 3) each."""
        return (
            np.einsum("rij,rj->ri", self.gyro_gain - np.eye(3), omega_ib_b) + self.gyro_bias,
            np.einsum("rij,rj->ri", self.accel_gain - np.eye(3), f_b) + self.accel_bias,
        )


def gyro_walk(scenario: Scenario) -> float:
    return scenario.gyro_walk_deg_sqrt_h * DEG / np.sqrt(HOUR)


def accel_walk(scenario: Scenario) -> float:
    return scenario.accel_walk_ft_s_sqrt_h * FOOT / np.sqrt(HOUR)


def rest_noise(scenario: Scenario) -> dict[str, Array]:
    """Of the fifteen states; the biases are "random constants", the paper says below (8)."""
    return {
        "gyro_noise": np.full(3, gyro_walk(scenario)),
        "accel_noise": np.full(3, accel_walk(scenario)),
        "gyro_bias_noise": np.zeros(3),
        "accel_bias_noise": np.zeros(3),
    }


def bias_variances(scenario: Scenario, f_b: Array) -> Array:
    """(6,) of gyro and accelerometer bias at rest; to the latter scale factor and misalignment of gravity belong."""
    gyro = np.full(3, (scenario.gyro_bias_deg_h * DEG / HOUR) ** 2)
    square = np.asarray(f_b) ** 2
    scale = (scenario.accel_scale_ppm * 1e-6) ** 2 * square
    across = (scenario.accel_misalignment_urad * 1e-6) ** 2 * (square.sum() - square)
    accel = (scenario.accel_bias_mg * MILLI_G) ** 2 + scale + across
    return np.concatenate([gyro, accel])


@dataclass(frozen=True)
class Drawn:
    """The constants of each run."""

    sensors: Sensors
    mu: Array  # (runs, 3) rad
    delay: Array  # (runs,) s
    position: Array  # (runs, 3) m east, north, up
    master_velocity: Array  # (runs, 3) m/s
    master_psi: Array  # (runs, 3) rad


def draw(scenario: Scenario, seed: int, runs: int, first_run: int = 0) -> Drawn:
    """Keyed by [seed, run], whatever runs are flown beside it; the white noise follows from the same streams."""
    streams = tuple(sensors.generator(seed, run) for run in range(first_run, first_run + runs))
    position, velocity, psi = scenario.master_sigma
    n = np.array([stream.standard_normal(37) for stream in streams])

    def gain(scale_ppm: float, misalignment_urad: float, numbers: Array) -> Array:
        out = np.zeros((runs, 3, 3))
        out[:, np.arange(3), np.arange(3)] = 1 + scale_ppm * 1e-6 * numbers[:, :3]
        out[:, [0, 0, 1, 1, 2, 2], [1, 2, 0, 2, 0, 1]] = misalignment_urad * 1e-6 * numbers[:, 3:]
        return out

    s = scenario
    return Drawn(
        sensors=Sensors(
            gyro_gain=gain(s.gyro_scale_ppm, s.gyro_misalignment_urad, n[:, 0:9]),
            gyro_bias=s.gyro_bias_deg_h * DEG / HOUR * n[:, 9:12],
            accel_gain=gain(s.accel_scale_ppm, s.accel_misalignment_urad, n[:, 12:21]),
            accel_bias=s.accel_bias_mg * MILLI_G * n[:, 21:24],
            gyro_walk=gyro_walk(s),
            accel_walk=accel_walk(s),
            streams=streams,
        ),
        mu=s.mounting_deg * DEG * n[:, 24:27],
        delay=np.abs(s.delay_s * n[:, 27]),
        position=n[:, 28:31] * position,
        master_velocity=n[:, 31:34] * velocity,
        master_psi=n[:, 34:37] * psi,
    )


# ---- the bench


def attitude_enu(roll_pitch_heading: Array) -> Array:
    """(..., 4) q_b2n_wxyz of a right-front-up body in ENU from (..., 3) rad; heading clockwise from north."""
    q = rotation.quaternion_from_euler(roll_pitch_heading)  # front-right-down in NED: the same turn, x and y changed
    return np.stack([q[..., 0], q[..., 2], q[..., 1], -q[..., 3]], axis=-1)


def rest_attitude(scenario: Scenario) -> Array:
    return attitude_enu(np.array([scenario.roll_deg, scenario.pitch_deg, scenario.heading_deg]) * DEG)


def place(scenario: Scenario) -> Array:
    """(3,) longitude, latitude, height."""
    return np.array([scenario.longitude_deg * DEG, scenario.latitude_deg * DEG, scenario.height_m])


def bench(models: Models, scenario: Scenario) -> tuple[Array, Array, inertial.Trajectory]:
    """The master's ideal increments and its trajectory; the bench begins and ends at rest."""
    dt = 1 / scenario.strapdown_hz
    time = np.arange(round(scenario.align_s * scenario.strapdown_hz) + 1)[:, None] * dt
    near = np.clip(np.minimum(time, scenario.align_s - time) / scenario.fade_s, 0, 1)
    fade = near**3 * (10 - 15 * near + 6 * near**2)  # twice differentiable
    rest = np.array([scenario.roll_deg, scenario.pitch_deg, scenario.heading_deg])
    turn = np.array(scenario.bench_deg) * np.sin(2 * np.pi * time / np.array(scenario.bench_period_s))
    sway = np.array(scenario.bench_m_s) * np.sin(2 * np.pi * time / np.array(scenario.bench_velocity_period_s))
    return inertial.increments(
        models.strapdown.step, place(scenario), fade * sway, attitude_enu((rest + fade * turn) * DEG), dt
    )


# ---- the filter


@dataclass(frozen=True)
class Aligned:
    """The end of an alignment and the start of a hold."""

    nav: dict[str, Array]  # the fields of the hold, (runs, ...)
    P: Array  # (runs, 15, 15)
    earth: dict[str, Array]  # omega_ie_n, gravity_n
    position: Array  # (3,) true
    q_b2n_wxyz: Array  # (runs, 4) true
    drawn: Drawn
    complete_s: Array  # (runs,) when the criterion was met, nan if never
    mu_error: Array  # (runs, 3) rad
    delay_error: Array  # (runs,) s
    psi_history: Array  # (T, runs, 3) rad, against the true attitude in the computed level
    sigma_history: Array  # (T, runs, 3) rad, of the filter's own ten states
    nis: Array  # (T, runs), of six rows

    @property
    def gravity(self) -> float:
        return float(-self.earth["gravity_n"][2])


COMPLETE = handover.Completion(level_sigma=1.0 * ARCMIN, azimuth_sigma=2.0 * ARCMIN)


def align(models: Models, scenario: Scenario, *, runs: int, seed: int, first_run: int = 0) -> Aligned:
    """Fly the bench.  Updates once a second; the slave's data of tau_hat ago stands against the master's."""
    hz, dt = scenario.strapdown_hz, 1 / scenario.strapdown_hz
    drawn = draw(scenario, seed, runs, first_run)
    dtheta_m, dv_m, truth = bench(models, scenario)
    C_b2m = rotation.matrix_from_vector(drawn.mu)
    to_level = models.psi.phi_from_psi(lon_lat_height=truth.position[0], v_n=np.zeros(3))
    per_metre = coordinates_per_metre(models, truth.position[0])
    d_position = drawn.position * per_metre
    phi_m = drawn.master_psi + d_position @ to_level[6:9, :3].T

    def master(second: int, noise: Array) -> tuple[Array, Array]:
        """Velocity and attitude that arrive at this time: what was measured a delay before."""
        at = np.maximum(second * hz - drawn.delay * hz, 0)
        v, q = between(truth.v_n, truth.q_b2n_wxyz, at)
        error = phi_m + scenario.attitude_noise_arcmin * ARCMIN * noise[:, 3:]
        return v + drawn.master_velocity + scenario.velocity_noise_m_s * noise[:, :3], turned_level(q, -error)

    def master_noise() -> Array:
        return np.array([stream.standard_normal(6) for stream in drawn.sensors.streams])

    v_start, q_start = master(0, master_noise())
    loop = CompiledFilter(
        models.alignment,
        {"lon_lat_height": truth.position[0] + d_position, "v_n": v_start, "q_b2n_wxyz": q_start,
         "mu": np.zeros((runs, 3)), "tau": np.zeros(runs)},
        first_covariance(scenario, rotation.matrix_from_quaternion(q_start)),
    )  # fmt: skip
    S = np.zeros((runs, 10, handover.CONSIDERED))
    S[:, :6, 6:] = np.eye(6)  # the slave has taken over the master's errors
    R = np.repeat([scenario.velocity_noise_m_s, scenario.attitude_noise_arcmin * ARCMIN], 3) ** 2
    q_noise = process_noise(scenario)
    psi_history, sigma_history, nis = [], [], []
    complete = np.full(runs, np.nan)
    before = None
    every = hz // scenario.covariance_hz

    for second in range(1, round(scenario.align_s) + 1):
        part = slice((second - 1) * hz, second * hz)
        dtheta, dv = drawn.sensors.measured(
            np.einsum("rji,tj->tri", C_b2m, dtheta_m[part]), np.einsum("rji,tj->tri", C_b2m, dv_m[part]), dt, hz
        )
        fields, before = inertial.intervals(dtheta, dv, before), (dtheta[-1], dv[-1])
        v, q = [loop.nav["v_n"]], [loop.nav["q_b2n_wxyz"]]
        for k in range(hz):
            loop.strapdown(**{name: values[k] for name, values in fields.items()}, dt=dt)
            v.append(loop.nav["v_n"])
            q.append(loop.nav["q_b2n_wxyz"])
            if (k + 1) % every == 0:
                f_b = dv[k + 1 - every : k + 1].mean(axis=0) / dt
                inputs = {"f_b": f_b, "dt": every * dt, **q_noise}
                Phi = loop.call("Phi", **inputs)
                loop.predict(**inputs)
                C_b2n = rotation.matrix_from_quaternion(loop.nav["q_b2n_wxyz"])
                S = handover.predicted(S, Phi, C_b2n, every * dt)
        at = hz - loop.nav["tau"] * hz
        ahead = np.minimum(at + 5, hz)
        (v_then, q_then), (v_past, q_past), (v_next, q_next) = (
            between(np.array(v), np.array(q), moment, own=True) for moment in (at, at - 5, ahead)
        )
        span = (ahead - (at - 5)) * dt
        v_m, q_m = master(second, master_noise())
        seen = {
            "v_m_n": v_m,
            "q_m2n_wxyz": q_m,
            "a_n": (v_next - v_past) / span[:, None],
            "omega_nm_n": rotation.attitude_error(q_past, q_next) / span[:, None],
        }
        now = {"v_n": loop.nav["v_n"], "q_b2n_wxyz": loop.nav["q_b2n_wxyz"]}
        loop.nav.update({"v_n": v_then, "q_b2n_wxyz": q_then})
        H = np.concatenate([np.broadcast_to(loop.call(f"{name}_H", **seen), (runs, 3, 10)) for name in MATCHED], axis=1)
        P_before = loop.P
        # both residuals before either update, which must not see the other's estimate twice
        taken = [loop.update(name, R[3 * i : 3 * i + 3], **seen) for i, name in enumerate(MATCHED)]
        S = handover.updated(S, P_before, loop.P, H, R)
        loop.nav.update(now)
        loop.feedback()
        loop.nav["lon_lat_height"] = truth.position[second * hz] + d_position

        q_true = rotation.turned(truth.q_b2n_wxyz[second * hz], drawn.mu)
        phi = rotation.attitude_error(loop.nav["q_b2n_wxyz"], q_true)
        psi_history.append(phi - d_position @ to_level[6:9, :3].T)
        sigma_history.append(np.sqrt(np.einsum("rii->ri", loop.P)[:, 3:6]))
        nis.append(taken[0].nis + taken[1].nis)
        last = np.array(nis[-10:])
        if len(last) == 10:
            done = handover.alignment_complete(loop.P, last, np.full(last.shape, 6), COMPLETE)
            complete[done & np.isnan(complete)] = second

    rest_f = rest_specific_force(models, truth.position[-1], truth.q_b2n_wxyz[-1])
    position, velocity, psi = scenario.master_sigma
    considered = np.diag(np.concatenate([bias_variances(scenario, rest_f), velocity**2, psi**2]))
    P = handover.hand_over(loop.P, S, considered, np.diag((position * per_metre) ** 2), to_level)
    nav = {name: loop.nav[name] for name in ("lon_lat_height", "v_n", "q_b2n_wxyz")}
    nav |= {"gyro_bias": np.zeros((runs, 3)), "accel_bias": np.zeros((runs, 3))}
    return Aligned(
        nav=nav,
        P=P,
        earth=models.strapdown.earth(lon_lat_height=truth.position[-1], v_n=np.zeros(3)),
        position=truth.position[-1],
        q_b2n_wxyz=rotation.turned(truth.q_b2n_wxyz[-1], drawn.mu),
        drawn=drawn,
        complete_s=complete,
        mu_error=loop.nav["mu"] - drawn.mu,
        delay_error=loop.nav["tau"] - drawn.delay,
        psi_history=np.array(psi_history),
        sigma_history=np.array(sigma_history),
        nis=np.array(nis),
    )


MATCHED = ("velocity", "dcm")


def first_covariance(scenario: Scenario, C_b2n: Array) -> Array:
    """(runs, 10, 10): the slave has taken over the master's attitude, so that psi = -C dmu; and its velocity."""
    noise = np.repeat([scenario.velocity_noise_m_s, scenario.attitude_noise_arcmin * ARCMIN, 0.0], 3)
    P = np.diag([*noise**2, scenario.delay_s**2]) + np.zeros((*C_b2n.shape[:-2], 10, 10))
    P[..., 3:9, 3:9] += taken_over(C_b2n, scenario.mounting_deg * DEG)
    return P


def process_noise(scenario: Scenario) -> dict[str, Array]:
    """Random walks, and the biases as white noise: b^2 t^2 = q t at t = bias_time_s."""
    gyro = scenario.gyro_bias_deg_h * DEG / HOUR * np.sqrt(scenario.bias_time_s)
    accel = scenario.accel_bias_mg * MILLI_G * np.sqrt(scenario.bias_time_s)
    return {
        "gyro_noise": np.full(3, np.hypot(gyro, gyro_walk(scenario))),
        "accel_noise": np.full(3, np.hypot(accel, accel_walk(scenario))),
    }


def coordinates_per_metre(models: Models, position: Array) -> Array:
    """(3,) by how much longitude, latitude and height change in a metre to the east, north and up."""
    rates = models.strapdown.rates(
        lon_lat_height=position, v_n=np.ones(3), q_b2n_wxyz=[1.0, 0, 0, 0], f_b=np.zeros(3), omega_ib_b=np.zeros(3)
    )
    per_metre: Array = np.asarray(rates["position_rate"])
    return per_metre


def rest_specific_force(models: Models, position: Array, q_b2n_wxyz: Array) -> Array:
    """(..., 3) m/s^2, of a body at rest."""
    gravity = models.strapdown.earth(lon_lat_height=position, v_n=np.zeros(3))["gravity_n"]
    return -np.einsum("...ji,j->...i", rotation.matrix_from_quaternion(q_b2n_wxyz), gravity)


def between(v: Array, q: Array, at: Array, own: bool = False) -> tuple[Array, Array]:
    """Velocity and attitude at sample numbers `at` (runs,), which need not be whole.

    v: (T, 3) common to all runs, or with own=True (T, runs, 3).  Beyond either end the line goes on.
    """
    i = np.clip(np.floor(at).astype(int), 0, len(v) - 2)
    part = (at - i)[:, None]
    pick = (i, np.arange(len(at))) if own else (i,)
    following = (i + 1, *pick[1:])
    q_at = (1 - part) * q[pick] + part * q[following]  # 0.2 rad/s for 10 ms: a chord is an arc, to 1e-6 rad
    return (1 - part) * v[pick] + part * v[following], q_at / np.linalg.norm(q_at, axis=-1, keepdims=True)


def turned_level(q_b2n_wxyz: Array, rotation_vector: Array) -> Array:
    """exp([v x]) C: the attitude turned by v (..., 3) rad in the level's axes."""
    C = rotation.matrix_from_quaternion(q_b2n_wxyz)
    return rotation.turned(q_b2n_wxyz, np.einsum("...ji,...j->...i", C, rotation_vector))
