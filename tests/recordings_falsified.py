"""A drive of its own, and recordings of it that are wrong in one thing each.  Nothing of the check is used.

`healthy(seed)` draws a vehicle, its motion, its sensors and its rates; FAULTS changes one recording of a turn of 100
degrees.  python tests/recordings_falsified.py [HEALTHY] prints what `--check` says of each, and how many of so many
healthy ones are called wrong.
"""

import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

DEG, G, R_EARTH = np.pi / 180, 9.80665, 6371e3
LATITUDE, LONGITUDE = 47.4 * DEG, 8.5 * DEG
OMEGA = 7.292115e-5 * np.array([np.cos(LATITUDE), 0.0, -np.sin(LATITUDE)])
DESCRIPTION = """title = "a drive"
file = "drive.npz"
[imu]
kind = "rates"
time_marks = "end"
body = "FRD"
time = { columns = "t", unit = "s" }
gyro = { columns = "gyro", unit = "rad/s" }
accel = { columns = "accel", unit = "m/s^2" }
[master]
body = "FRD"
navigation = "NED"
time = { columns = "tm", unit = "s" }
attitude = { columns = "attitude", unit = "rad" }
velocity = { columns = "velocity", unit = "m/s" }
position = { columns = "position", unit = "rad" }
"""


@dataclass
class Written:
    """Columns and description, as files hold them."""

    columns: dict
    toml: str = DESCRIPTION
    notes: dict = field(default_factory=dict)

    def replace(self, *pairs):
        for old, new in pairs:
            assert old in self.toml, old
            self.toml = self.toml.replace(old, new)

    def write(self, folder):
        folder = Path(folder)
        np.savez(folder / "drive.npz", **self.columns)
        path = folder / "drive.toml"
        path.write_text(self.toml)
        return path


@dataclass(frozen=True)
class Plan:
    """A vehicle: functions of time (s), and its sensors."""

    speed: Callable = lambda t: 12 + 2 * np.sin(0.25 * t)
    heading: Callable = lambda t: np.radians(20 + 50 * (1 + np.tanh((t - 25) / 6)) + 1.5 * np.sin(0.5 * t))
    roll: Callable = lambda t: np.radians(2.5 * np.sin(0.9 * t) + 4 / np.cosh((t - 25) / 6) ** 2)
    pitch: Callable = lambda t: np.radians(1.5 * np.sin(0.7 * t + 1) + 1)
    climb: Callable = lambda t: 0.6 * np.sin(0.3 * t)
    crab: Callable = lambda t: np.zeros_like(t)  # course less heading
    seconds: float = 50.0
    imu_hz: float = 50.0
    master_hz: float = 4.0
    mounting: tuple = (0.004, -0.006, 0.008)
    lever: tuple = (0.0, 0.0, 0.0)
    gyro_bias: tuple = (20, -35, 15)  # deg/h
    accel_bias: tuple = (0.03, -0.02, 0.04)
    gyro_noise: float = 0.15 * DEG / 60
    accel_noise: float = 1e-3
    velocity_noise: float = 0.02
    attitude_noise: float = 1.5e-4
    delay: float = 0.01
    fine: int = 10  # steps to a sample of the slave


def fly(plan, seed):
    """The recording of a plan: mean rates of the slave, and its master, each with its noise."""
    rng = np.random.default_rng(seed)
    fine = plan.fine
    steps = round(plan.seconds * plan.imu_hz)
    h = 1 / plan.imu_hz / fine
    t = np.arange(steps * fine + 1) * h
    euler = np.stack([plan.heading(t), plan.pitch(t), plan.roll(t)], axis=-1)
    attitude = Rotation.from_euler("ZYX", euler)
    course = plan.heading(t) + plan.crab(t)
    v = np.stack([plan.speed(t) * np.cos(course), plan.speed(t) * np.sin(course), -plan.climb(t)], axis=-1)
    moved = np.concatenate([np.zeros((1, 3)), np.cumsum((v[1:] + v[:-1]) / 2, axis=0) * h])
    position = np.stack([
        LATITUDE + moved[:, 0] / R_EARTH, LONGITUDE + moved[:, 1] / (R_EARTH * np.cos(LATITUDE)), 450 - moved[:, 2],
    ], axis=-1)  # fmt: skip
    slave = attitude * Rotation.from_rotvec(plan.mounting)
    lever = attitude.apply(plan.lever)
    acceleration = np.gradient(v, h, axis=0) + np.gradient(np.gradient(lever, h, axis=0), h, axis=0)
    turning = OMEGA + np.stack([v[:, 1], -v[:, 0], -v[:, 1] * np.tan(LATITUDE)], axis=-1) / R_EARTH
    force = slave.inv().apply(acceleration + np.cross(OMEGA + turning, v) - [0, 0, G])
    # the whole turn against inertial space, from one fine step to the next
    turn = (slave[:-1].inv() * Rotation.from_rotvec((turning[1:] + turning[:-1]) / 2 * h) * slave[1:]).as_rotvec()
    gyro = turn.reshape(steps, fine, 3).sum(axis=1) * plan.imu_hz
    accel = ((force[1:] + force[:-1]) / 2).reshape(steps, fine, 3).mean(axis=1)
    gyro += np.radians(plan.gyro_bias) / 3600 + plan.gyro_noise * np.sqrt(plan.imu_hz) * rng.standard_normal(gyro.shape)
    accel += plan.accel_bias + plan.accel_noise * np.sqrt(plan.imu_hz) * rng.standard_normal(accel.shape)
    every = np.arange(1, int(plan.seconds * plan.master_hz)) / plan.master_hz
    k = np.round((every - plan.delay) / h).astype(int)
    k = np.clip(k, 0, len(t) - 1)
    noise = rng.standard_normal((2, len(k), 3))
    columns = {
        "t": t[fine::fine], "gyro": gyro, "accel": accel, "tm": every,
        "attitude": euler[k][:, ::-1] + plan.attitude_noise * noise[0],
        "velocity": v[k] + plan.velocity_noise * noise[1], "position": position[k],
    }  # fmt: skip
    return Written(columns)


def drawn(seed):
    """A plan at random: car, aircraft or boat, its grade and its rates."""
    rng = np.random.default_rng(seed)
    kind = ("car", "aircraft", "boat")[seed % 3]
    begin, wide, phase = rng.uniform(0, 360), rng.uniform(3, 8), rng.uniform(0, 6.28, 6)
    turn = rng.choice([-1, 1]) * rng.uniform(20, 150)
    speed = {"car": rng.uniform(6, 30), "aircraft": rng.uniform(45, 120), "boat": rng.uniform(3, 12)}[kind]
    swing = {"car": 1.5, "aircraft": 1.0, "boat": 6.0}[kind]
    bank = {"car": 0.05, "aircraft": 1.0, "boat": 0.1}[kind]
    crab = {"car": 0.0, "aircraft": rng.uniform(-12, 12), "boat": rng.uniform(-8, 8)}[kind]
    seconds = rng.uniform(40, 70)
    middle = seconds / 2

    def rate(t):
        return np.radians(turn / 2 / wide) / np.cosh((t - middle) / wide) ** 2

    return Plan(
        speed=lambda t: speed * (1 + 0.1 * np.sin(0.2 * t + phase[0])),
        heading=lambda t: np.radians(
            begin + turn / 2 * (1 + np.tanh((t - middle) / wide)) + np.sin(0.45 * t + phase[1])
        ),
        roll=lambda t: np.radians(swing * np.sin(0.8 * t + phase[2])) + bank * np.arctan(speed * rate(t) / G),
        pitch=lambda t: np.radians(1.5 + 0.7 * swing * np.sin(0.65 * t + phase[3])),
        climb=lambda t: {"car": 0.3, "aircraft": 2.0, "boat": 0.8}[kind] * np.sin(0.35 * t + phase[4]),
        crab=lambda t: np.radians(crab) + 0 * t, seconds=seconds,
        imu_hz=float(rng.choice([50, 100, 200])), master_hz=float(rng.choice([1, 2, 5, 10])),
        mounting=tuple(np.radians(rng.normal(0, 1, 3))), lever=tuple(rng.normal(0, 0.5, 3)),
        gyro_bias=tuple(rng.normal(0, rng.choice([1, 20, 200]), 3)), accel_bias=tuple(rng.normal(0, 0.03, 3)),
        gyro_noise=rng.choice([0.01, 0.15, 0.5]) * DEG / 60, accel_noise=rng.choice([3e-4, 1e-3, 3e-3]),
        velocity_noise=rng.choice([0.005, 0.03, 0.1]), attitude_noise=rng.choice([1e-4, 5e-4, 1e-3]),
        delay=rng.uniform(0, 0.08),
    )  # fmt: skip


def healthy(seed):
    """A recording of a plan at random, in a format at random."""
    made = fly(drawn(seed), seed)
    form = np.random.default_rng([seed, 1]).integers(4)
    if form == 1:
        dt = np.median(np.diff(made.columns["t"]))
        made.columns |= {"gyro": np.degrees(made.columns["gyro"]) * dt, "accel": made.columns["accel"] * dt}
        made.replace(('kind = "rates"', 'kind = "increments"'), ('unit = "rad/s"', 'unit = "deg"'))
        made.replace(('accel = { columns = "accel", unit = "m/s^2" }', 'accel = { columns = "accel", unit = "m/s" }'))
    elif form == 2:
        quaternion = Rotation.from_euler("ZYX", made.columns["attitude"][:, ::-1]).as_quat()
        made.columns["attitude"] = quaternion
        made.replace(('attitude = { columns = "attitude", unit = "rad" }',
                      'attitude = { columns = "attitude", unit = "1", order = "xyzw" }'))  # fmt: skip
    elif form == 3:
        made.columns |= {"t": made.columns["t"] + 1.7e9, "tm": made.columns["tm"] + 1.7e9}
        made.columns["velocity"] = made.columns["velocity"][:, [1, 0, 2]] * [1, 1, -1]
        made.replace(('navigation = "NED"', 'navigation = "ENU"'),
                     ('unit = "rad" }\nvelocity', 'unit = "rad", yaw_from = "north" }\nvelocity'))  # fmt: skip
    return made


# ---------------------------------------------------------------- one fault each

FAULTS: dict = {}


def fault(cause, *, limit=""):
    """cause: what a right answer says, a pattern.  limit: why the data cannot tell, in one of at most six."""

    def keep(change):
        FAULTS[change.__name__] = (change, cause, limit)
        return change

    return keep


def quaternions(w, order="wxyz", change=lambda q: q):
    q = Rotation.from_euler("ZYX", w.columns["attitude"][:, ::-1]).as_quat()  # x y z w
    q = change(q)
    w.columns["attitude"] = q if order == "xyzw" else np.roll(q, 1, axis=1)
    w.replace(('unit = "rad" }\nvelocity', f'unit = "1", order = "{order}" }}\nvelocity'))


@fault("about front.*57.*deg/s")
def one_gyro_axis_in_degrees(w):
    w.columns["gyro"][:, 0] *= 180 / np.pi


@fault("deg/s declared as rad/s|degrees declared as radians")
def gyro_in_degrees(w):
    w.columns["gyro"] *= 180 / np.pi


@fault("g declared as m/s")
def accel_in_g(w):
    w.columns["accel"] /= G


@fault("down.*g declared|g declared.*down")
def down_accel_in_g(w):
    w.columns["accel"][:, 2] /= G


@fault("right alone in g")
def right_accel_in_g(w):
    w.columns["accel"][:, 1] /= G


@fault("increments declared as rates")
def increments_as_rates(w):
    w.columns["gyro"] /= 50
    w.columns["accel"] /= 50


@fault("roll and pitch")
def roll_and_pitch_swapped(w):
    w.columns["attitude"] = w.columns["attitude"][:, [1, 0, 2]]


@fault(r"\bENU\b|north and east (are )?(swapped|exchanged)|east, north, up")
def velocity_in_enu(w):
    w.columns["velocity"] = w.columns["velocity"][:, [1, 0, 2]] * [1, 1, -1]


def attitudes(w):
    return Rotation.from_euler("ZYX", w.columns["attitude"][:, ::-1])


@fault(r"velocity.*(in|of) the body|body.*declared as.*navigation|axes = \"body\"")
def body_velocity_as_navigation(w):
    w.columns["velocity"] = attitudes(w).inv().apply(w.columns["velocity"])


@fault("navigation.*declared as.*body|velocity.*of navigation")
def navigation_velocity_as_body(w):
    w.replace(('unit = "m/s" }\nposition', 'unit = "m/s", axes = "body" }\nposition'))


@fault("fit until 2[4-7] s and not behind")
def columns_exchanged_half_way(w):
    half = len(w.columns["t"]) // 2
    w.columns["gyro"][half:] = w.columns["gyro"][half:][:, [1, 0, 2]]


@fault("xyzw|order of the quaternion")
def quaternion_xyzw_as_wxyz(w):
    quaternions(w, "wxyz", lambda q: np.roll(q, -1, axis=1))


@fault("conjugate|inverse|navigation to body")
def quaternion_conjugate(w):
    quaternions(w, "wxyz", lambda q: q * [-1, -1, -1, 1])


@fault("FLU")
def quaternion_enu_flu(w):
    a = Rotation.from_matrix([[0, 1, 0], [1, 0, 0], [0, 0, -1]])
    b = Rotation.from_matrix(np.diag([1, -1, -1]))
    quaternions(w, "wxyz", lambda q: (a * Rotation.from_quat(q) * b).as_quat())


@fault("km/h declared as m/s")
def velocity_in_km_h(w):
    w.columns["velocity"] *= 3.6


@fault("kn declared as m/s")
def velocity_in_knots(w):
    w.columns["velocity"] *= 3600 / 1852


@fault("latitude and longitude|longitude.*latitude")
def latitude_and_longitude_swapped(w):
    w.columns["position"] = w.columns["position"][:, [1, 0, 2]]


@fault("sign of (the )?latitude|latitude.*sign|southern")
def sign_of_latitude_lost(w):
    w.columns["position"][:, 0] *= -1


@fault("minutes|ddmm")
def nmea_degrees_and_minutes(w):
    d = np.degrees(w.columns["position"][:, :2])
    whole = np.floor(d)
    w.columns["position"][:, :2] = np.radians(whole * 100 + (d - whole) * 60)


@fault("(repeat|equal|twice|copies|keep one)")
def rows_doubled(w):
    for name in ("t", "gyro", "accel"):
        w.columns[name] = np.repeat(w.columns[name], 2, axis=0)


@fault("time zone")
def time_zone_missing(w):
    w.columns["tm"] = w.columns["tm"] - 7200


@fault("gap")
def two_drives_joined(w):
    half = len(w.columns["t"]) // 2
    w.columns["t"][half:] += 300
    w.columns["tm"][len(w.columns["tm"]) // 2 :] += 300


@fault("gravity (was |is )?(removed|taken off|missing)|without gravity")
def gravity_removed(w):
    w.columns["accel"] += attitudes_of_imu(w).inv().apply([0, 0, G])


def attitudes_of_imu(w):
    a = np.stack([np.interp(w.columns["t"], w.columns["tm"], np.unwrap(x)) for x in w.columns["attitude"].T], axis=-1)
    return Rotation.from_euler("ZYX", a[:, ::-1])


@fault("the sign|or sign")
def accel_sign(w):
    w.columns["accel"] *= -1


@fault("right of its axes is mirrored")
def left_handed(w):
    for name in ("gyro", "accel"):
        w.columns[name] = w.columns[name] * [1, -1, 1]


@fault("front and right of its axes are exchanged")
def front_and_right_swapped(w):
    for name in ("gyro", "accel"):
        w.columns[name] = w.columns[name][:, [1, 0, 2]]


@fault("turned by 90 deg about down")
def slave_turned_by_90(w):
    for name in ("gyro", "accel"):
        w.columns[name] = w.columns[name][:, [1, 0, 2]] * [1, -1, 1]


@fault("front.*(sign|mirrored)")
def one_gyro_axis_mirrored(w):
    w.columns["gyro"][:, 0] *= -1


@fault("counter of 16 bits wraps")
def counter_of_16_bits_wraps(w):
    w.columns["t"] = np.round(w.columns["t"] * 1000 + 40_000) % 65536
    w.replace(('time = { columns = "t", unit = "s" }', 'time = { columns = "t", unit = "ms" }'))
    w.columns["tm"] = w.columns["tm"] + 40


@fault("float32|single precision")
def time_tags_in_float32(w):
    since = 1_234_567.0
    w.columns["t"] = (w.columns["t"] + since).astype(np.float32)
    w.columns["tm"] = (w.columns["tm"] + since).astype(np.float32)


@fault("leap")
def leap_seconds(w):
    w.columns["tm"] = w.columns["tm"] + 18


@fault(r"\+1(\.0\d*)? s late|1 s exactly")
def one_second_late(w):
    w.columns["tm"] = w.columns["tm"] + 1


@fault(r"steps by \+36\d\d")
def clock_steps_by_an_hour(w):
    w.columns["tm"][len(w.columns["tm"]) // 2 :] += 3600


@fault("47.*geoid")
def height_steps_by_the_geoid(w):
    w.columns["position"][len(w.columns["tm"]) // 2 :, 2] += 47


@fault(r"4\.6 deg/s.*saturates")
def gyro_saturates(w):
    w.columns["gyro"] = np.clip(w.columns["gyro"], -4.6 * DEG, 4.6 * DEG)


@fault(r"held at (1|0\.9\d*|1\.0\d*) Hz|held at 1")
def master_held_at_1_hz(w):
    for name in ("attitude", "velocity", "position"):
        w.columns[name] = w.columns[name][np.arange(len(w.columns["tm"])) // 4 * 4]


@fault(r"heading is off by (29|30|31)\.\d")
def heading_off_by_30(w):
    w.columns["attitude"][:, 2] += 30 * DEG


@fault(r"heading is off by (89|90|91)\.\d")
def heading_off_by_90(w):
    w.columns["attitude"][:, 2] += 90 * DEG


@fault(r"heading is off by -?(179|180)\.\d")
def heading_off_by_180(w):
    w.columns["attitude"][:, 2] += 180 * DEG


@fault("yaw is counter-clockwise")
def heading_mirrored(w):
    w.columns["attitude"][:, 2] *= -1


@fault(r"heading is off by [34]\.\d.*magnetic")
def magnetic_heading_4(w):
    w.columns["attitude"][:, 2] += 4 * DEG


@fault(r"heading is off by 1[12]\.\d.*magnetic")
def magnetic_heading_12(w):
    w.columns["attitude"][:, 2] += 12 * DEG


@fault("compass")
def compass_of_soft_iron(w):
    yaw = w.columns["attitude"][:, 2]
    w.columns["attitude"][:, 2] = yaw + 8 * DEG * np.sin(yaw) + 5 * DEG * np.cos(yaw)


@fault("vertical velocity.*up and which down|vertical.*sign")
def vertical_velocity_up(w):
    w.columns["velocity"] = w.columns["velocity"] * [1, 1, -1]


@fault("level velocity")
def level_velocity_as_body(w):
    yaw = w.columns["attitude"][:, 2]
    v = w.columns["velocity"]
    along = np.cos(yaw) * v[:, 0] + np.sin(yaw) * v[:, 1]
    across = -np.sin(yaw) * v[:, 0] + np.cos(yaw) * v[:, 1]
    w.columns["velocity"] = np.stack([along, across, v[:, 2]], axis=-1)
    w.replace(('unit = "m/s" }\nposition', 'unit = "m/s", axes = "body" }\nposition'))


@fault("applied as yaw, roll, pitch")
def another_euler_sequence(w):
    a = attitudes(w).as_euler("ZXY")  # yaw, then roll's axis before pitch's
    w.columns["attitude"] = np.stack([a[:, 1], a[:, 2], a[:, 0]], axis=-1)


@fault(r"held at 2[45]\.?\d* Hz")
def slave_held_at_25_hz(w):
    for name in ("gyro", "accel"):
        w.columns[name] = w.columns[name][np.arange(len(w.columns["t"])) // 2 * 2]


def coarse(w, mean):
    t = w.columns["t"]
    for name in ("gyro", "accel"):
        x = w.columns[name]
        ten = x.reshape(-1, 5, 3).mean(axis=1) if mean else x[4::5]
        w.columns[name] = np.stack([np.interp(t, t[4::5], part) for part in ten.T], axis=-1)


@fault(r"interpolated from about (9\.?\d*|10\.?\d*) Hz")
def means_of_10_hz_interpolated(w):
    coarse(w, True)


@fault(r"interpolated from about (9\.?\d*|10\.?\d*) Hz")
def points_of_10_hz_interpolated(w):
    coarse(w, False)


@fault("copies of the one before")
def one_sample_in_50_a_copy(w):
    for name in ("gyro", "accel"):
        w.columns[name][50::50] = w.columns[name][49::50][: len(w.columns[name][50::50])]


@fault("nothing", limit="the Earth's rate taken off is a constant 15 deg/h: to the data, a bias")
def earth_rate_taken_off(w):
    w.columns["gyro"] -= attitudes_of_imu(w).inv().apply(OMEGA)


@fault(r"run apart by [45]\d\d \+-")
def clocks_500_ppm_apart(w):
    w.columns["tm"] = w.columns["tm"] * (1 + 500e-6)


@fault("rounded to 1 deg")
def angles_rounded_to_1_deg(w):
    w.columns["attitude"] = np.radians(np.round(np.degrees(w.columns["attitude"])))


@fault(r"rounded to 0\.1 deg")
def angles_rounded_to_a_tenth(w):
    w.columns["attitude"] = np.radians(np.round(np.degrees(w.columns["attitude"]), 1))


@fault("nothing", limit="a lever arm that nobody measured is for the filter, which estimates it")
def lever_arm_of_3_m(w):
    made = fly(Plan(lever=(3.0, 0.5, -1.0)), 1)
    w.columns = made.columns


@fault("older than the attitude.*(filtered|averaged)")
def velocity_averaged_over_a_second(w):
    v = w.columns["velocity"]
    w.columns["velocity"] = np.array([v[max(0, k - 3) : k + 1].mean(axis=0) for k in range(len(v))])


@fault("nothing", limit="2 % of an accelerometer's scale are what a bias of 10 mg does to so gentle a drive")
def one_accel_axis_by_2_per_cent(w):
    w.columns["accel"][:, 1] *= 1.024


@fault("feet")
def height_in_feet(w):
    w.columns["position"][:, 2] /= 0.3048


@fault("goes against the vertical velocity")
def depth_in_fathoms(w):
    w.columns["position"][:, 2] /= -1.8288


@fault(r"\+0\.2\d* s late")
def master_200_ms_late(w):
    w.columns["tm"] = w.columns["tm"] + 0.2


@fault("out of order")
def two_rows_swapped(w):
    for name in ("t", "gyro", "accel"):
        w.columns[name][[1200, 1201]] = w.columns[name][[1201, 1200]]


@fault("one increment in 2")
def half_of_the_increments_lost(w):
    dt = 1 / 50
    for name in ("gyro", "accel"):
        w.columns[name] = w.columns[name][::2] * dt
    w.columns["t"] = w.columns["t"][::2]
    w.replace(('kind = "rates"', 'kind = "increments"'), ('unit = "rad/s"', 'unit = "rad"'),
              ('unit = "m/s^2"', 'unit = "m/s"'))  # fmt: skip


@fault("never moves")
def master_never_moves(w):
    for name in ("attitude", "velocity", "position"):
        w.columns[name] = np.tile(w.columns[name][:1] * (name != "velocity"), (len(w.columns["tm"]), 1))


@fault("attitude.*older than its velocity")
def attitude_old_by_400_ms(w):
    t = w.columns["tm"]
    old = np.stack([np.interp(t - 0.4, t, np.unwrap(a)) for a in w.columns["attitude"].T], axis=-1)
    w.columns["attitude"] = old + 1.5e-4 * np.random.default_rng(3).standard_normal(old.shape)


@fault("turned by 30 deg about down")
def slave_turned_by_30(w):
    for name in ("gyro", "accel"):
        w.columns[name] = w.columns[name] @ Rotation.from_euler("z", 30 * DEG).as_matrix()


@fault("yaw_from")
def yaw_from_east(w):
    w.columns["attitude"][:, 2] = np.pi / 2 - w.columns["attitude"][:, 2]


@fault("gyro and accel are exchanged")
def gyro_and_accel_exchanged(w):
    w.columns["gyro"], w.columns["accel"] = w.columns["accel"], w.columns["gyro"]


@fault(r"\bmg declared as m/s")
def accel_in_mg(w):
    w.columns["accel"] *= 1000 / G


@fault(r"raw counts, 13[01]")
def gyro_in_counts(w):
    w.columns["gyro"] = np.round(np.degrees(w.columns["gyro"]) * 131)


@fault(r"repeat.*5\.00 s before")
def five_seconds_written_twice(w):
    for name in ("gyro", "accel"):
        w.columns[name][1000:1250] = w.columns[name][750:1000]


@fault("its roll has the other sign")
def roll_of_the_other_sign(w):
    w.columns["attitude"][:, 0] *= -1


@fault("its pitch has the other sign.*pitch_positive")
def pitch_of_the_other_sign(w):
    w.columns["attitude"][:, 1] *= -1


@fault(r"0\.10\d .* behind the gyros")
def accel_100_ms_behind_the_gyro(w):
    w.columns["accel"][5:] = w.columns["accel"][:-5].copy()


@fault("down is 0 all the time")
def one_gyro_axis_dead(w):
    w.columns["gyro"][:, 2] = 0.0


@fault("front and right are the same numbers")
def one_column_twice(w):
    w.columns["gyro"][:, 1] = w.columns["gyro"][:, 0]


@fault("3 attitudes stand off by up to 20")
def three_wild_headings(w):
    w.columns["attitude"][[40, 90, 150], 2] += 20 * DEG


@fault("aligned anew")
def heading_aligned_anew(w):
    w.columns["attitude"][100:, 2] += 7 * DEG


@fault("interpolated across north")
def heading_interpolated_across_360(w):
    """A logger of 1 Hz, interpolated to 4 Hz number by number."""
    plan = Plan(heading=lambda t: np.radians(-50 + 50 * (1 + np.tanh((t - 25) / 6)) + 1.5 * np.sin(0.5 * t)))
    w.columns = fly(plan, 1).columns
    t, yaw = w.columns["tm"], np.degrees(w.columns["attitude"][:, 2]) % 360
    w.columns["attitude"][:, 2] = np.radians(np.interp(t, t[::4], yaw[::4]))


@fault(r"0\.(8|80\d*|79\d+) times their rate: (50|49\.9\d*) Hz, not 40")
def tags_of_another_rate(w):
    w.columns["t"] = w.columns["t"] * 1.25


@fault("they are angles")
def angles_as_rates(w):
    w.columns["gyro"] = np.cumsum(w.columns["gyro"], axis=0) / 50


@fault("velocity repeats in 75%")
def velocity_held_at_1_hz(w):
    w.columns["velocity"] = w.columns["velocity"][np.arange(len(w.columns["tm"])) // 4 * 4]


@fault("older than the velocity, along the path")
def position_old_by_2_s(w):
    t = w.columns["tm"]
    w.columns["position"] = np.stack([np.interp(t - 2, t, a) for a in w.columns["position"].T], axis=-1)


@fault(r"velocity is turned by 10\.0 deg against the track")
def velocity_turned_by_10(w):
    w.columns["velocity"] = Rotation.from_euler("z", 10 * DEG).apply(w.columns["velocity"])


@fault("accelerometers lie in other axes.*90 deg about down")
def accel_in_other_axes_than_the_gyro(w):
    w.columns["accel"] = w.columns["accel"][:, [1, 0, 2]] * [1, -1, 1]


@fault("20 rows are zero: failed reads.*bad_rows")
def failed_reads_are_zeros(w):
    for name in ("gyro", "accel"):
        w.columns[name][np.append(np.arange(60, 2400, 126), 1301)] = 0


@fault("9 rows are zero: failed reads")
def failed_reads_of_the_gyro(w):
    w.columns["gyro"][1200:1290:10] = 0


@fault("5 rows are at 0, 0: a receiver without a fix")
def rows_without_a_fix(w):
    w.columns["position"][[3, 4, 80, 81, 82]] = 0


@fault("gyro: front stuck at one value from 20.020 s on")
def one_gyro_axis_stuck_from_20_s(w):
    w.columns["gyro"][1000:, 0] = w.columns["gyro"][1000, 0]


@fault("accel: down stuck at one value from 20.020 s to 30.000 s")
def one_accel_axis_stuck_for_10_s(w):
    w.columns["accel"][1000:1500, 2] = w.columns["accel"][1000, 2]


@fault("gyro: front and right and down stuck at one value from 0.020 s to 10.000 s")
def gyro_stuck_for_the_first_10_s(w):
    w.columns["gyro"][:500] = w.columns["gyro"][0]


@fault("sorted as text.*sort the rows by number")
def rows_sorted_as_text(w):
    w.columns["t"] = np.round(w.columns["t"] + 70, 2)
    w.columns["tm"] = w.columns["tm"] + 70
    order = sorted(range(len(w.columns["t"])), key=lambda k: f"{w.columns['t'][k]:.2f}")
    for name in ("t", "gyro", "accel"):
        w.columns[name] = w.columns[name][order]


@fault("milliseconds.* without their leading zeros")
def milliseconds_without_leading_zeros(w):
    ms = np.round(w.columns["t"] * 1000).astype(int)
    w.columns["t"] = np.array([float(f"{one // 1000}.{one % 1000}") for one in ms])


def course(w):
    return np.arctan2(w.columns["velocity"][:, 1], w.columns["velocity"][:, 0])


@fault("heading is the course of the velocity")
def heading_is_the_course(w):
    w.columns["attitude"][:, 2] = course(w)


@fault("heading is the course of the velocity")
def heading_is_the_course_of_one_that_crabs(w):
    w.columns = fly(Plan(crab=lambda t: np.radians(8 * np.sin(0.3 * t) + 4)), 1).columns
    w.columns["attitude"][:, 2] = np.round(course(w), 4)


@fault("bias drifts by .* as of one that warms up")
def gyro_warms_up(w):
    w.columns["gyro"] += np.outer(1 - np.exp(-w.columns["t"] / 15), np.array([1.5, -1, 2.5]) * DEG)


@fault("high-pass of about [4-7]")
def gyro_behind_a_high_pass_of_5_s(w):
    slow = np.zeros(3)
    for k, rate in enumerate(w.columns["gyro"].copy()):
        slow += (rate - slow) / 250
        w.columns["gyro"][k] -= slow


@fault("running mean of about [6-9]")
def gyro_less_its_running_mean(w):
    t, angle = w.columns["t"], np.cumsum(w.columns["gyro"], axis=0) / 50
    late = np.stack([np.interp(t - 8, t, one) for one in angle.T], axis=-1)
    w.columns["gyro"] -= (angle - late) / 8


@fault("rates of roll, pitch and yaw")
def rates_of_euler_angles(w):
    plan = Plan(
        roll=lambda t: np.radians(25 * np.sin(0.9 * t)), pitch=lambda t: np.radians(20 * np.sin(0.7 * t + 1)),
        heading=lambda t: np.radians(20 + 2.5 * t + 30 * np.sin(0.3 * t)),
    )  # fmt: skip
    w.columns = fly(plan, 1).columns
    t = np.append(0, w.columns["t"])
    angles = np.stack([plan.roll(t), plan.pitch(t), plan.heading(t)], axis=-1)
    noise = 1e-4 * np.random.default_rng(4).standard_normal(w.columns["gyro"].shape)
    w.columns["gyro"] = np.diff(angles, axis=0) * 50 + noise


@fault("navigation axes already")
def accel_in_navigation_axes(w):
    w.columns["accel"] = attitudes_of_imu(w).apply(w.columns["accel"])


@fault("counted from the first row")
def attitude_counted_from_its_first_row(w):
    turned = attitudes(w)
    w.columns["attitude"] = (turned[0].inv() * turned).as_euler("ZYX")[:, ::-1]


@fault(r"down wraps at about (5\.99|6) deg/s")
def gyro_wraps(w):
    w.columns["gyro"] = (w.columns["gyro"] + 6 * DEG) % (12 * DEG) - 6 * DEG


@fault("of ECEF")
def velocity_in_ecef(w):
    lat, lon = w.columns["position"][:, :2].T
    north = np.stack([-np.sin(lat) * np.cos(lon), -np.sin(lat) * np.sin(lon), np.cos(lat)], axis=-1)
    east = np.stack([-np.sin(lon), np.cos(lon), 0 * lon], axis=-1)
    axes = np.stack([north, east, np.cross(north, east)], axis=1)
    w.columns["velocity"] = np.einsum("kij,ki->kj", axes, w.columns["velocity"])


@fault("attitude: it repeats in 75%.*held at")
def attitude_held_at_1_hz(w):
    w.columns["attitude"] = w.columns["attitude"][np.arange(len(w.columns["tm"])) // 4 * 4]


@fault("no rate is ever below zero")
def signs_of_the_gyro_lost(w):
    w.columns["gyro"] = np.abs(w.columns["gyro"])


def low_pass(x, tau):
    """Samples of 50 Hz behind a filter of the first order."""
    out, state = x.copy(), x[0].copy()
    for k, one in enumerate(x):
        state = state + (one - state) * 0.02 / tau
        out[k] = state
    return out


@fault(r"different times: front, right and down are \[[+-]0\.0\d, \+0\.(0[89]|1[01]), \+0\.(19|2[01])\] s")
def one_delay_for_each_gyro_axis(w):
    for axis, late in enumerate((0.0, 0.1, 0.2)):
        w.columns["gyro"][:, axis] = np.interp(w.columns["t"] - late, w.columns["t"], w.columns["gyro"][:, axis])


@fault("0.0174[45] times as much.*rad/s declared as deg/s")
def gyro_in_radians_as_degrees(w):
    w.replace(('gyro", unit = "rad/s"', 'gyro", unit = "deg/s"'))


@fault("rounded to steps of 11 m")
def position_of_four_digits(w):
    w.columns["position"][:, :2] = np.radians(np.round(np.degrees(w.columns["position"][:, :2]), 4))


@fault("none of the single mistakes.*a master of another drive")
def master_of_another_drive(w):
    plan = Plan(
        speed=lambda t: 9 + 3 * np.sin(0.13 * t), roll=lambda t: np.radians(2 * np.sin(1.1 * t + 1)),
        heading=lambda t: np.radians(100 - 60 * np.sin(0.11 * t) + 2 * np.sin(0.6 * t)),
    )  # fmt: skip
    w.columns |= {name: fly(plan, 5).columns[name] for name in ("attitude", "velocity", "position")}


@fault(r"0\.4[6-9]\d .* behind the gyros: accel that is filtered")
def accel_behind_a_low_pass(w):
    w.columns["accel"] = low_pass(w.columns["accel"], 0.5)


@fault(r"gyro: they are 0\.2[6-9] .* behind the accelerometers and the master|low-pass of about 0\.(2[5-9]|3[0-3]) s")
def gyro_behind_a_low_pass(w):
    w.columns["gyro"] = low_pass(w.columns["gyro"], 0.3)


@fault(r"bias drifts by \[\+0\.4\d, -0\.2\d, \+0\.[45]\d\] deg/s .*warms up")
def gyro_warms_up_a_little(w):
    w.columns["gyro"] += np.outer(1 - np.exp(-w.columns["t"] / 15), np.array([0.5, -0.3, 0.6]) * DEG)


@fault("other axes than the gyros.*RFU beside FRD")
def accel_in_enu(w):
    w.columns["accel"] = w.columns["accel"][:, [1, 0, 2]] * [1, 1, -1]


@fault("rpm declared as deg/s")
def gyro_in_rpm(w):
    w.columns["gyro"] *= 30 / np.pi
    w.replace(('gyro", unit = "rad/s"', 'gyro", unit = "deg/s"'))


@fault(r"they are (0\.49\d+|0\.50\d+|0\.5) times.*another range")
def accel_of_twice_the_range(w):
    w.columns["accel"] /= 2


@fault("accel.*right of its axes is mirrored")
def right_accel_of_the_other_sign(w):
    w.columns["accel"][:, 1] *= -1


@fault(r"attitude is smoothed, over about (2\.[7-9]|3|3\.[0-5]) s")
def attitude_smoothed_afterwards(w):
    a = np.pad(np.unwrap(w.columns["attitude"], axis=0), ((6, 6), (0, 0)), "edge")
    noise = 1e-4 * np.random.default_rng(2).standard_normal(w.columns["attitude"].shape)
    w.columns["attitude"] = np.array([a[k : k + 13].mean(axis=0) for k in range(len(a) - 12)]) + noise


@fault("yaw alone is in degrees")
def yaw_alone_in_degrees(w):
    w.columns["attitude"][:, 2] = np.degrees(w.columns["attitude"][:, 2])


@fault("mils declared as degrees")
def attitude_in_mils(w):
    w.columns["attitude"] *= 3200 / np.pi
    w.replace(('attitude", unit = "rad"', 'attitude", unit = "deg"'))


@fault("roll and pitch are those of accelerometers")
def level_of_the_accelerometers(w):
    f = low_pass(w.columns["accel"], 0.1)
    front, right, down = (np.interp(w.columns["tm"], w.columns["t"], part) for part in f.T)
    w.columns["attitude"][:, :2] = np.stack([np.arctan2(-right, -down), np.arctan2(front, np.hypot(right, down))], -1)


@fault("its roll is 0 all the time")
def roll_that_nobody_measures(w):
    w.columns["attitude"][:, 0] = 0


@fault("rounded to few digits.*or held")
def quaternion_of_two_digits(w):
    quaternions(w, "xyzw", lambda q: np.round(q, 2))


@fault("rates are in navigation axes already")
def gyro_in_navigation_axes(w):
    w.columns["gyro"] = attitudes_of_imu(w).apply(w.columns["gyro"])


@fault("turned by (19|20|21) deg about right")
def slave_tilted_by_20(w):
    for name in ("gyro", "accel"):
        w.columns[name] = w.columns[name] @ Rotation.from_euler("y", 20 * DEG).as_matrix()


@fault(r"from 2[3-7] s on, by \[-?0\.\d, (4\.9|5\.\d), -?0\.\d\] deg.*moved in its mount")
def mount_that_comes_loose(w):
    for name in ("gyro", "accel"):
        w.columns[name][1250:] = w.columns[name][1250:] @ Rotation.from_euler("y", 5 * DEG).as_matrix()


@fault(r"bias is \[.*, \+0\.5\d\] m/s\^2.*; or, as well explained.* times what they should be")
def accel_with_a_large_bias(w):
    w.columns["accel"][:, 2] += 0.5


@fault("12 samples stand alone, off by up to 80 m/s")
def spikes_of_the_accel(w):
    rng = np.random.default_rng(3)
    w.columns["accel"][rng.choice(2500, 12, replace=False), rng.integers(0, 3, 12)] += 80


@fault("no rate is ever below zero")
def gyro_in_unsigned_numbers(w):
    w.columns["gyro"][w.columns["gyro"] < 0] += 500 * DEG


@fault("clocks run apart from 2[2-7] s on, by -(8|9|10)")
def clock_that_runs_fast_from_half_way_on(w):
    w.columns["t"] = w.columns["t"] + 0.01 * np.maximum(w.columns["t"] - 25, 0)


@fault("tags scatter by 0.1 s.*arrival")
def tags_of_the_arrival(w):
    w.columns["tm"] = w.columns["tm"] + np.random.default_rng(1).uniform(0, 0.24, len(w.columns["tm"]))


@fault(r"1\.05\d* times their rate.*rows are lost, and tags were counted")
def rows_lost_and_tags_counted(w):
    keep = np.random.default_rng(1).random(len(w.columns["t"])) > 0.05
    w.columns |= {name: w.columns[name][keep] for name in ("gyro", "accel")} | {"t": w.columns["t"][: keep.sum()]}


@fault("vertical part is 0 all the time")
def velocity_of_speed_and_course(w):
    w.columns["velocity"][:, 2] = 0


@fault("vertical velocity in ft/s")
def vertical_velocity_in_feet(w):
    w.columns["velocity"][:, 2] /= 0.3048


@fault(r"from (19|20|21|22) s on its tags are \+2\.0\d s off: samples are lost there")
def two_seconds_lost_and_tags_counted(w):
    keep = np.r_[0:1000, 1100:2500]
    w.columns |= {name: w.columns[name][keep] for name in ("gyro", "accel")} | {"t": w.columns["t"][: len(keep)]}


@fault("attitude: 8[78]% of its rows lie on the line")
def attitude_interpolated_from_half_a_hz(w):
    t = w.columns["tm"]
    w.columns["attitude"] = np.stack([np.interp(t, t[::8], part[::8]) for part in w.columns["attitude"].T], axis=-1)


@fault("turned by 8 deg about front.*or the attitude is off by so much")
def roll_off_by_8(w):
    w.columns["attitude"][:, 0] += 8 * DEG


@fault("7 values alone, 1 deg/s apart")
def gyro_in_whole_degrees(w):
    w.columns["gyro"] = np.round(w.columns["gyro"] / DEG) * DEG


@fault("degrees and minutes")
def position_in_degrees_and_minutes(w):
    for i in (0, 1):
        whole, part = np.divmod(w.columns["position"][:, i] / DEG, 1)
        w.columns["position"][:, i] = (whole + 0.6 * part) * DEG


def complaints(path):
    """What the check calls wrong, or warns of: one text a finding."""
    from boresight import BoresightError
    from boresight.runtime.recording import check, read

    try:
        found = check(read(path, strict=False))
    except BoresightError as error:
        return [f"error {error}"]
    return [f"{one.level} {one.where}: {one.text}" for one in found if one.level != "note"]


if __name__ == "__main__":
    import re
    from tempfile import TemporaryDirectory

    right = 0
    with TemporaryDirectory() as folder:
        for name, (change, cause, limit) in FAULTS.items():
            made = fly(Plan(), 1)
            change(made)
            texts = complaints(made.write(folder))
            first = texts[0] if texts else ""
            ok = bool(re.search(cause, first)) if first else cause.startswith("nothing")
            right += ok
            print(f"{'right' if ok else 'LIMIT' if limit else 'WRONG':<6}{name:<34}{len(texts)} {first[:240]}")
        print(f"{right} of {len(FAULTS)}")
        count = int(sys.argv[1]) if len(sys.argv) > 1 else 60
        wrong = 0
        for seed in range(count):
            texts = [text for text in complaints(healthy(seed).write(folder)) if text.startswith("error")]
            wrong += bool(texts)
            if texts:
                print(seed, texts[0][:240])
        print(f"{wrong} of {count} healthy recordings are called wrong")
