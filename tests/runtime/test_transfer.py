"""The transfer-alignment loop on a ship whose motion is analytic: truth, both ways with a delay, and NEES."""

from dataclasses import dataclass, replace
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.stats import chi2

from boresight import BoresightError
from boresight.runtime import rotation
from boresight.runtime.library import load
from boresight.runtime.simulation import hull, inertial
from boresight.runtime.simulation.sensors import generator
from boresight.runtime.transfer import Message, Rules, Transfer, Verdict, first

DEG, MIL = np.pi / 180, 2 * np.pi / 6400
RATE_HZ = 100
PLACE = np.array([0.6, 2.2, 20.0])
LEVER_B = np.array([-4.0, 2.0, 3.0])
MOUNTING = rotation.quaternion_from_euler(np.array([0.4, -0.3, 2.0]) * DEG)
V_SIGMA, A_SIGMA = 0.01, 0.3e-3  # m/s, rad of the master
NOISE = {"gyro_noise": np.full(3, 3e-5), "accel_noise": np.full(3, 1e-3), "gyro_bias_noise": np.full(3, 1e-8),
         "accel_bias_noise": np.full(3, 1e-7), "mu_noise": np.full(3, 1e-8), "tau_noise": 1e-7}  # fmt: skip
R = np.repeat([V_SIGMA, A_SIGMA], 3) ** 2
STEP = np.array([1.0, -0.5, 0.0])  # m/s, a jump
BIAS_G, BIAS_A = 5e-5, 0.01  # rad/s, m/s^2, one sigma


def sea():
    """A sea of 0.1 to 0.17 Hz: roll 6, pitch 3, yaw 3 deg, heave 1 m, and some way over the ground."""
    return hull.sinusoids(
        amplitude=[0.5, 0.6, 1.0, 6 * DEG, 3 * DEG, 3 * DEG], phase=[0.0, 1.0, 2.0, 0.3, 1.2, 2.1], frequency_hz=0.15,
        heading=0.5, speed=4.0,
    )  # fmt: skip


@dataclass(frozen=True)
class Ship:
    """Truth of one motion: the slave's increments without error, and its trajectory."""

    motion: hull.Motion
    model: object
    dtheta: np.ndarray  # (T, 3)
    dv: np.ndarray
    track: inertial.Trajectory

    def master(self, time):
        """(R,) s -> v_n (R, 3), q_m2n_wxyz (R, 4)."""
        pose = hull.ride(self.motion, np.asarray(time))
        return pose.v_n, pose.q_b2n_wxyz


def sail(motion, seconds, rate_hz=RATE_HZ, lever_b=LEVER_B):
    model = load("velocity-attitude")
    time = np.arange(round(seconds * rate_hz) + 1) / rate_hz
    slave = hull.carried(hull.ride(motion, time), lever_b, MOUNTING)
    v_n, q_b2n_wxyz = slave.v_n[:, None], slave.q_b2n_wxyz[:, None]
    dtheta, dv, track = inertial.increments(model.strapdown, PLACE, v_n, q_b2n_wxyz, 1 / rate_hz)
    return Ship(motion, model, dtheta[:, 0], dv[:, 0], track)


@dataclass
class Flight:
    loop: Transfer
    errors: np.ndarray  # (K, runs, 16) after each message, estimated - true
    sigmas: np.ndarray
    nees: np.ndarray  # (K, runs)
    nis: np.ndarray  # (K, runs), of messages taken; nan otherwise
    every_nis: np.ndarray  # (K, runs), of all that came, before the gate
    verdicts: np.ndarray
    times: np.ndarray


def fly(ship, *, runs=20, seed=0, heading=2 * DEG, seconds=None, compensation="buffer", delay=None, known_age=0.0,
        jitter=0.003, drop=0.1, change=None, slave_change=None, lever_b=LEVER_B, tau_sigma=0.01, master_hz=10,
        **more):  # fmt: skip
    """Sensor errors, delays, jitter and drop-outs run by run.

    A message measured at s is stamped s + tau, and handed over known_age later, at the slave's next sample.
    change(k, message, truth) may spoil the k-th message, slave_change(time, dtheta, dv) an interval.
    """
    streams = [generator(seed, run) for run in range(runs)]

    def normals(*shape):
        return np.array([stream.standard_normal(shape) for stream in streams])

    dt = ship.track.dt
    bias_g, bias_a = BIAS_G * normals(3), BIAS_A * normals(3)
    tau = np.abs(tau_sigma * normals()) if delay is None else np.broadcast_to(delay, (runs,))
    q_m2n = ship.master(np.zeros(1))[1][0]
    start = Message(
        0.0, np.repeat([0.02, A_SIGMA], 3) ** 2, v_m_n=ship.track.v_n[0, 0] + 0.02 * normals(3),
        q_m2n_wxyz=rotation.turned(np.tile(q_m2n, (runs, 1)), A_SIGMA * normals(3)), position=PLACE,
    )  # fmt: skip
    # so much of heading, one sigma, is believed to be none; of two levels 0.6 deg
    sigma = np.array([0.6 * DEG, 0.6 * DEG, heading])
    q_believed = rotation.turned(MOUNTING, -sigma * normals(3))
    nav, P, _ = first(
        start, ship.model, {"lever_b": lever_b, **NOISE}, estimates={"q_b2m_wxyz": q_believed},
        sigmas={"q_b2m_wxyz": sigma, "gyro_bias": BIAS_G, "accel_bias": BIAS_A, "tau": tau_sigma},
        rate_sigma=0.0, acceleration_sigma=0.0,
    )  # fmt: skip
    loop = Transfer(
        ship.model,
        nav,
        P,
        {"lever_b": lever_b, **NOISE},
        compensation=compensation,
        every=round(0.04 / ship.track.dt),
        **more,
    )

    steps = len(ship.dtheta) if seconds is None else round(seconds / dt)
    stamps = 1 / master_hz * np.arange(1, int(steps * dt * master_hz)) + jitter * np.abs(normals(10000)[:, None, 0])
    errors, sigmas, nees, nis, every_nis, verdicts, times = ([] for _ in range(7))
    noise_g, noise_a = NOISE["gyro_noise"] * np.sqrt(dt), NOISE["accel_noise"] * np.sqrt(dt)
    k, waiting = 0, []  # intervals since the last message, which are given together

    def deliver():
        if waiting:
            *increments, ends = (np.array(part) for part in zip(*waiting, strict=True))
            loop.slave(ends, *increments, dt)
            waiting.clear()

    for step in range(steps):
        if step % 1000 == 0:
            noise = normals(1000, 6)
        white = noise[:, step % 1000]
        dtheta = ship.dtheta[step] + bias_g * dt + noise_g * white[:, :3]
        dv = ship.dv[step] + bias_a * dt + noise_a * white[:, 3:]
        time = (step + 1) * dt
        if slave_change is not None:
            dtheta, dv = slave_change(time, dtheta, dv)
        waiting.append((dtheta, dv, time))
        if k < stamps.shape[1] and time >= (k + 1) / master_hz + known_age + 0.02:
            at = stamps[:, k]
            v, q = ship.master(at - tau)
            v = v + V_SIGMA * normals(3)
            q = rotation.turned(q, A_SIGMA * normals(3))
            rows = np.array([stream.random() for stream in streams]) >= drop
            position = ship.track.position[step, 0]
            message = Message(at, R, v_m_n=v, q_m2n_wxyz=q, position=position, rows=np.repeat(rows[:, None], 6, 1))
            if change is not None:
                message = change(k, message)
            k += 1
            if message is None:
                continue
            deliver()
            result = loop.master(message)
            e = error(loop, ship, step + 1, bias_g, bias_a, tau)
            errors.append(e)
            sigmas.append(np.sqrt(np.einsum("rii->ri", loop.P)))
            nees.append(np.einsum("ri,ri->r", e, np.linalg.solve(loop.P, e[..., None])[..., 0]))
            nis.append(np.where(result.taken, result.nis, np.nan))
            every_nis.append(np.where(result.before_gate > 0, result.before_gate, np.nan))
            verdicts.append(result.verdict)
            times.append(time)
    deliver()
    return Flight(loop, *(np.array(part) for part in (errors, sigmas, nees, nis, every_nis, verdicts, times)))


def error(loop, ship, sample, bias_g, bias_a, tau):
    nav, track = loop.nav, ship.track
    return np.concatenate([
        rotation.attitude_error(nav["q_b2n_wxyz"], track.q_b2n_wxyz[sample]), nav["v_n"] - track.v_n[sample],
        nav["gyro_bias"] - bias_g, nav["accel_bias"] - bias_a,
        rotation.attitude_error(nav["q_b2m_wxyz"], MOUNTING), (nav["tau"] - tau)[:, None],
    ], axis=-1)  # fmt: skip


@pytest.fixture(scope="module")
def flights(short):
    """Both ways, messages that arrive 20 to 30 ms after their stamp: jitter, one in ten lost, and the delay."""
    return {way: fly(short, compensation=way, runs=12) for way in ("buffer", "extrapolate")}


@pytest.mark.parametrize("way", ["buffer", "extrapolate"])
def test_errors_are_as_large_as_the_filter_says(flights, way):
    flight = flights[way]
    runs = flight.nees.shape[1]
    assert set(np.unique(flight.verdicts)) == {Verdict.TAKEN, Verdict.ABSENT}
    assert not flight.loop.notes
    # NEES of 12 independent runs at one instant; NIS of all messages together, 6 rows each
    low, high = chi2.ppf([1e-4, 1 - 1e-4], 16 * runs) / runs
    assert (low < flight.nees[::40].mean(axis=1)).all() and (flight.nees[::40].mean(axis=1) < high).all()
    count = np.isfinite(flight.nis).sum()
    low, high = chi2.ppf([1e-4, 1 - 1e-4], 6 * count) / count
    assert low < np.nanmean(flight.nis) < high
    # heading and delay, which began at 36 mil and 10 ms, alone
    low, high = chi2.ppf([1e-4, 1 - 1e-4], runs) / runs
    for state, most in ((14, 0.7 * MIL), (15, 0.8e-3)):
        assert flight.sigmas[-1, :, state].max() < most
        assert low < np.mean((flight.errors[-1, :, state] / flight.sigmas[-1, :, state]) ** 2) < high


# ---- what the two ways do with a message that is old


def without_errors(ship, seconds, compensation, runs=()):
    """A loop that knows everything and has flown ideal sensors up to a time."""
    rate_hz = round(1 / ship.track.dt)
    nav = {
        "lat_lon_height": PLACE, "v_n": ship.track.v_n[0, 0], "q_b2n_wxyz": ship.track.q_b2n_wxyz[0, 0],
        "gyro_bias": np.zeros(3), "accel_bias": np.zeros(3), "q_b2m_wxyz": MOUNTING, "tau": 0.0,
    }  # fmt: skip
    P = np.diag(np.repeat([1e-6, 1e-4, 1e-10, 1e-6, 1e-6, 1e-6], [3, 3, 3, 3, 3, 1])) * np.ones((*runs, 1, 1))
    loop = Transfer(ship.model, nav, P, {"lever_b": LEVER_B, **NOISE}, compensation=compensation)
    for step in range(round(seconds * rate_hz)):
        loop.slave((step + 1) / rate_hz, ship.dtheta[step], ship.dv[step], ship.track.dt)
    return loop


@pytest.mark.parametrize("lag", [0.05, 0.1, 0.2])
def test_the_buffer_meets_the_master_and_extrapolation_misses_it_by_the_second_derivative(short, lag):
    now = 3.0
    pose = hull.ride(short.motion, np.array([now - lag, now]))
    v, q = pose.v_n, pose.q_b2n_wxyz
    message = Message(now - lag, R, v_m_n=v[0], q_m2n_wxyz=q[0])
    residual = {}
    for way in ("buffer", "extrapolate"):
        loop = without_errors(short, now, way)
        result = loop.master(message)
        assert result.taken
        residual[way] = np.concatenate([result.innovations[name].nu for name in ("velocity", "dcm")])
    # 10 ms between samples, means over 40 ms: what is left is 1 mm/s and 5 urad
    assert np.abs(residual["buffer"][:3]).max() < 1e-3
    assert np.abs(residual["buffer"][3:]).max() < 5e-6
    # analytic: v(t) - lag a(t) - v(t - lag), and the turn from then to now less lag omega
    C = rotation.matrix_from_quaternion(q)
    missed_v = v[1] - lag * pose.a_n[1] - v[0]
    missed_turn = -rotation.attitude_error(q[1], q[0]) - lag * C[1] @ pose.omega_nb_b[1]
    z = loop_residuals(without_errors(short, now, "extrapolate"), message)
    np.testing.assert_allclose(z[:3], missed_v, atol=0.05 * np.abs(missed_v).max() + 1e-3)
    np.testing.assert_allclose(z[3:], missed_turn, atol=0.05 * np.abs(missed_turn).max() + 5e-6)


def loop_residuals(loop, message):
    """(6,) velocity and attitude, before any update."""
    around, _ = loop._match(np.array([loop.time - message.time]))
    inputs = loop.constants | {name: value[0] for name, value in around.items()}
    inputs |= {"v_m_n": message.v_m_n, "q_m2n_wxyz": message.q_m2n_wxyz}
    return np.concatenate([loop.filter.call(f"{name}_z", **inputs) for name in ("velocity", "dcm")])


def test_late_messages_leave_the_slave_where_it_would_be_had_they_come_in_time(short):
    """Four messages, a tenth of a second apart, at once or 0.25 s late; process noise, which is neglected, is none."""
    rng = np.random.default_rng(6)
    stamps = 0.5 + 0.1 * np.arange(4)
    v, q = short.master(stamps)
    q = rotation.turned(q, [0.0, 0.0, 2 * DEG])  # far off, so that the first correction is large
    v = v + 0.01 * rng.standard_normal((4, 3))
    messages = [Message(t, R, v_m_n=v[i], q_m2n_wxyz=q[i]) for i, t in enumerate(stamps)]
    end = {}
    for late in (0.0, 0.25):
        loop = without_errors(short, 0.0, "buffer")
        loop.constants |= {name: 0 * np.asarray(value) for name, value in NOISE.items()}
        # angles to 1 deg: what they do in the second order is taken for what it is when the message comes
        loop.filter.P[:] = np.diag(np.repeat([3e-4, 1e-1, 1e-8, 1e-2, 3e-4, 1e-4], [3, 3, 3, 3, 3, 1]))
        waiting = list(messages)
        for step in range(110):
            loop.slave((step + 1) / 100, short.dtheta[step], short.dv[step], 0.01)
            while waiting and waiting[0].time + late <= loop.time + 1e-9:
                assert loop.master(waiting.pop(0)).taken
        end[late] = loop
    at_once, late = end[0.0], end[0.25]
    clean = without_errors(short, 1.1, "buffer")
    turn = rotation.attitude_error(clean.nav["q_b2n_wxyz"], at_once.nav["q_b2n_wxyz"])
    push = at_once.nav["v_n"] - clean.nav["v_n"]
    assert np.linalg.norm(turn) > 1e-3
    assert np.linalg.norm(push) > 1e-3
    sigma = np.sqrt(np.diag(at_once.P))
    assert np.abs(np.sqrt(np.diag(late.P)) / sigma - 1).max() < 0.01
    difference = {name: late.nav[name] - at_once.nav[name] for name in ("v_n", "gyro_bias", "accel_bias", "tau")}
    away = np.concatenate([
        rotation.attitude_error(late.nav["q_b2n_wxyz"], at_once.nav["q_b2n_wxyz"]), difference["v_n"],
        difference["gyro_bias"], difference["accel_bias"],
        rotation.attitude_error(late.nav["q_b2m_wxyz"], at_once.nav["q_b2m_wxyz"]), [difference["tau"]],
    ])  # fmt: skip
    assert np.abs(away / sigma).max() < 0.1


def test_a_feedback_corrects_the_kept_past_as_the_error_was_then(short):
    """The error is known: what is left of it in the past falls with the square of the age, not with the age."""
    loop = without_errors(short, 2.0, "buffer")
    clean = loop.history.recent("v_n").copy(), loop.history.recent("q_b2n_wxyz").copy()
    wrong = without_errors(short, 1.5, "buffer")
    wrong.nav["q_b2n_wxyz"] = rotation.turned(wrong.nav["q_b2n_wxyz"], [2e-3, -1e-3, 3e-3])
    for step in range(150, 200):
        wrong.slave((step + 1) * 0.01, short.dtheta[step], short.dv[step], 0.01)
    x = np.zeros(16)
    x[:3] = rotation.attitude_error(wrong.nav["q_b2n_wxyz"], loop.nav["q_b2n_wxyz"])
    x[3:6] = wrong.nav["v_n"] - loop.nav["v_n"]
    wrong.filter.x = x
    F = wrong.filter.call("F", **wrong._over(np.array([0.04])))
    before = wrong.history.recent("v_n")[-20] - clean[0][-20]
    wrong._correct_past(F)
    left = np.linalg.norm(wrong.history.recent("v_n") - clean[0], axis=-1)[:, 0]
    assert left[-1] < 1e-6
    assert left[-20] < 0.02 * np.linalg.norm(before - x[3:6])  # of what taking out the error of now would leave
    assert 3 < left[-41] / left[-21] < 5
    assert np.abs(rotation.attitude_error(wrong.history.recent("q_b2n_wxyz"), clean[1])[-45:]).max() < 1e-6


def test_runs_side_by_side_are_the_runs_alone(short):
    """Two by three runs, each with its own time, noise and mask, against six loops of one run."""
    rng = np.random.default_rng(4)
    stamp = 0.95 - 0.03 * rng.random((2, 3))
    v, q = short.master(stamp.ravel())
    v, q = v.reshape(2, 3, 3) + 0.01 * rng.standard_normal((2, 3, 3)), q.reshape(2, 3, 4)
    rows = rng.random((2, 3, 6)) > 0.3
    together = without_errors(short, 1.0, "buffer", (2, 3))
    result = together.master(Message(stamp, R, v_m_n=v, q_m2n_wxyz=q, rows=rows))
    for i in np.ndindex(2, 3):
        alone = without_errors(short, 1.0, "buffer")
        one = alone.master(Message(stamp[i], R, v_m_n=v[i], q_m2n_wxyz=q[i], rows=rows[i]))
        assert one.verdict == result.verdict[i] == Verdict.TAKEN
        np.testing.assert_allclose(one.nis, result.nis[i], rtol=1e-10)
        np.testing.assert_allclose(alone.P, together.P[i], rtol=1e-10, atol=1e-20)
        for name, value in alone.nav.items():
            np.testing.assert_allclose(
                value, np.broadcast_to(together.nav[name], (2, 3, *np.shape(value)))[i], atol=1e-13
            )


def test_old_messages_cost_the_buffer_nothing_and_extrapolation_its_consistency(short):
    """Handed over 0.1 s after they were stamped."""
    buffer = fly(short, runs=8, seconds=15.0, known_age=0.1)
    extrapolated = fly(short, runs=8, seconds=15.0, known_age=0.1, compensation="extrapolate")
    assert buffer.nees[-50:].mean() < 23
    assert np.nanmean(buffer.nis) == pytest.approx(6, abs=0.25)
    assert extrapolated.nees[-50:].mean() > 2 * 16  # its 95 % band ends at 19
    assert np.nanmean(extrapolated.nis) > 8


@pytest.mark.parametrize("matching", ["dcm", "quaternion"])
def test_a_heading_that_is_unknown_to_35_degrees_is_found(short, matching):
    """One sigma: of eight runs the furthest begins 68 degrees off."""
    flight = fly(short, runs=8, heading=35 * DEG, matching=("velocity", matching))
    assert np.abs(flight.errors[0, :, 14]).max() > 0.5
    assert np.sqrt(np.mean(flight.errors[-1, :, 14] ** 2)) < 1.0 * MIL
    assert flight.nees[-50:].mean() < 23
    assert not any("lever" in text for text in said(flight))


def test_a_delay_that_turns_out_longer_than_the_buffer_is_told_and_found_with_a_longer_one(short):
    unknown = {"runs": 4, "seconds": 15.0, "delay": 0.7, "tau_sigma": 0.5, "drop": 0.0}
    flight = fly(short, **unknown)
    assert flight.verdicts[-1].tolist() == [Verdict.TOO_OLD] * 4
    assert any("raise buffer_s" in text for text in said(flight))
    flight = fly(short, **unknown, rules=Rules(buffer_s=1.5))
    assert np.abs(flight.errors[-1, :, 15]).max() < 5e-3
    assert abs(np.nanmean(flight.nis[-50:]) - 6) < 1.0


def test_two_angles_of_a_gps_are_enough_and_the_third_may_be_anything(short):
    """Pitch and heading; the roll that is masked is not a number."""

    def two_antennas(k, message):
        euler = rotation.euler_from_matrix(rotation.matrix_from_quaternion(message.q_m2n_wxyz))
        euler[..., 0] = np.nan
        rows = message.rows & np.array([True, True, True, False, True, True])
        return replace(message, q_m2n_wxyz=None, euler_m=euler, rows=rows)

    flight = fly(short, runs=6, seconds=17.0, matching=("velocity", "euler"), change=two_antennas)
    assert only(flight)
    assert np.nanmean(flight.nis) == pytest.approx(5, abs=4 * np.sqrt(10 / np.isfinite(flight.nis).sum()))
    assert flight.nees[-50:].mean() < 25
    assert np.sqrt(np.mean(flight.errors[-1, :, 14] ** 2)) < 1.5 * MIL


def test_a_message_without_what_the_matching_needs_is_refused_in_one_line(short):
    loop = without_errors(short, 0.2, "buffer")
    assert loop.master(Message(0.1, R, euler_m=np.zeros(3))).verdict == Verdict.INVALID
    assert loop.notes[-1].text == "message refused: it holds neither v_m_n nor q_m2n_wxyz"
    with pytest.raises(BoresightError, match="compensation is 'kalman'; give 'buffer' or 'extrapolate'"):
        without_errors(short, 0.0, "kalman")
    with pytest.raises(BoresightError, match="buffer_s is 0"):
        Rules(buffer_s=0.0)


# ---- bad input: what each rule does, what it says, and that the filter recovers


@pytest.fixture(scope="module")
def short(compiled_once):
    """Twenty-five seconds of the same."""
    return sail(sea(), 25.0)


def within(begin, end, change):
    """The messages number begin to end - 1, ten a second, are changed."""
    return lambda k, message: change(message) if begin <= k < end else message


def absent(message):
    return replace(message, rows=np.zeros_like(message.rows))


def swapped():
    """Every tenth message comes after the one that follows it, and once more; every tenth comes twice."""
    earlier = {}

    def change(k, message):
        if k % 10 in (3, 7):
            earlier["message"] = message
        if k % 10 == 3:
            return absent(message)
        return earlier["message"] if k % 10 in (5, 6, 8) else message

    return change


def frozen():
    """From message 80 to 110 what it says is that of message 80; none is lost."""
    kept = {}

    def change(k, message):
        if k == 80:
            kept["message"] = message
        if 80 < k < 110:
            message = replace(message, v_m_n=kept["message"].v_m_n, q_m2n_wxyz=kept["message"].q_m2n_wxyz)
        return replace(message, rows=np.ones_like(message.rows))

    return change


EACH = 4  # runs of a fault
FAULTS = {
    "too old": within(80, 88, lambda m: replace(m, time=m.time - 0.7)),
    "ahead": within(80, 88, lambda m: replace(m, time=m.time + 0.3)),
    "stopped": within(80, 160, absent),
    "swapped": swapped(),
    "nothing finite": within(80, 110, lambda m: replace(m, v_m_n=np.nan * m.v_m_n, q_m2n_wxyz=0 * m.q_m2n_wxyz)),
    "no velocity": within(80, 110, lambda m: replace(m, v_m_n=np.nan * m.v_m_n)),
    "no time": within(80, 110, lambda m: replace(m, time=np.nan * m.time)),
    "outlier": within(80, 81, lambda m: replace(m, v_m_n=m.v_m_n + 1.0)),
    "for good": within(80, 10000, lambda m: replace(m, v_m_n=m.v_m_n + STEP)),
    "frozen": frozen(),
    "velocity": within(80, 130, lambda m: replace(m, v_m_n=m.v_m_n + STEP)),
    "roll": within(80, 130, lambda m: turned_in_n(m, [1 * DEG, 0, 0])),
    "heading-1": within(80, 130, lambda m: turned_in_n(m, [0, 0, 1 * DEG])),
    "heading-60": within(80, 130, lambda m: turned_in_n(m, [0, 0, 60 * DEG])),
    "noisy": within(0, 10000, lambda m: replace(m, R=R / 4)),
}
SPOILT = ("time", "R", "v_m_n", "q_m2n_wxyz", "rows")  # of a message, with an axis of runs


def part(flight, runs):
    """Some runs of a flight, and the notes that are about them."""
    numbers = set(range(flight.nees.shape[1])[runs])
    notes = [note for note in flight.loop.notes if numbers & set(note.runs.tolist())]
    of_runs = ("errors", "sigmas", "nees", "nis", "every_nis", "verdicts")
    cut = {name: getattr(flight, name)[:, runs] for name in of_runs}
    return replace(flight, loop=SimpleNamespace(notes=notes), **cut)


@pytest.fixture(scope="module")
def spoilt(short):
    """All faults side by side, a few runs each: of a fault, its runs."""
    places = {name: slice(EACH * i, EACH * (i + 1)) for i, name in enumerate(FAULTS)}
    runs = EACH * len(FAULTS)

    def change(k, message):
        message = replace(message, R=np.tile(R, (runs, 1)))
        whole = {name: np.array(getattr(message, name)) for name in SPOILT}
        for name, where in places.items():
            own = FAULTS[name](k, replace(message, **{field: value[where].copy() for field, value in whole.items()}))
            for field, value in whole.items():
                value[where] = getattr(own, field)
        return replace(message, **whole)

    flight = fly(short, runs=runs, seconds=21.0, change=change)
    return lambda name: part(flight, places[name])


def most_nees(runs):
    """Of 16 states the mean over so many runs that is exceeded once in 100000."""
    return chi2.ppf(1 - 1e-5, 16 * runs) / runs


def said(flight):
    return [note.text for note in flight.loop.notes]


def only(flight, *verdicts):
    return set(np.unique(flight.verdicts)) == {Verdict.TAKEN, Verdict.ABSENT, *verdicts}


def recovered(flight):
    """In the last five seconds: NIS in its band, and NEES of 16 below what its runs exceed once in 100000."""
    nis = flight.nis[-50:]
    spread = np.sqrt(2 * 6 / np.isfinite(nis).sum())
    return abs(np.nanmean(nis) - 6) < 4 * spread and flight.nees[-50:].mean() < most_nees(EACH)


def test_a_delay_longer_than_the_buffer_is_refused_and_told(spoilt):
    flight = spoilt("too old")
    assert only(flight, Verdict.TOO_OLD)
    assert "the past is known for 0.5" in said(flight)[0] and "raise buffer_s" in said(flight)[0]
    assert any("messages are taken again, after 8 refused" in text for text in said(flight))
    assert recovered(flight)


def test_a_master_that_stops_leaves_the_slave_alone_and_is_welcome_when_it_comes_back(spoilt):
    flight = spoilt("stopped")
    assert only(flight)
    assert "no message of the master was taken for 1 s" in said(flight)[0]
    assert "the master is back after 8." in said(flight)[-1]
    first_after = np.flatnonzero(flight.times > 16)[0]
    # eight seconds alone: the error has grown, and the filter knows it
    assert flight.sigmas[first_after - 90, :, 3].mean() < 0.003
    assert np.abs(flight.errors[first_after + 1, :, 3:6]).max() < 0.03
    assert flight.nees[first_after : first_after + 20].mean() < most_nees(EACH)
    assert recovered(flight)


def test_messages_out_of_order_and_sent_twice_are_refused(spoilt):
    flight = spoilt("swapped")
    assert only(flight, Verdict.OUT_OF_ORDER)
    # the held back one, its copy and that of one that was taken; of a run that lost its rows none has come
    assert (flight.verdicts == Verdict.OUT_OF_ORDER).mean() == pytest.approx(0.3 * 0.9, abs=0.05)
    assert "is not later than the last one's" in said(flight)[0]
    assert recovered(flight)


def test_a_message_from_the_future_is_refused(spoilt):
    flight = spoilt("ahead")
    assert only(flight, Verdict.AHEAD)
    assert "compare the clocks" in said(flight)[0]
    assert recovered(flight)


def test_what_is_not_finite_counts_as_absent(spoilt):
    flight = spoilt("nothing finite")
    assert only(flight, Verdict.INVALID)
    assert "no finite value" in said(flight)[0]
    assert recovered(flight)
    flight = spoilt("no velocity")
    assert only(flight)  # the attitude is taken, alone
    assert np.nanmean(flight.nis[80:110]) == pytest.approx(3, abs=4 * np.sqrt(6 / (27 * EACH)))
    assert recovered(flight)
    assert only(spoilt("no time"), Verdict.INVALID)


def test_a_single_outlier_is_refused_and_changes_nothing(spoilt):
    flight = spoilt("outlier")
    assert only(flight, Verdict.GATED)
    assert "it does not fit (NIS 2" in said(flight)[0]
    assert "taken again, after 1 refused" in said(flight)[1]
    assert recovered(flight)


def turned_in_n(message, vector):
    C = rotation.matrix_from_vector(np.array(vector)) @ rotation.matrix_from_quaternion(message.q_m2n_wxyz)
    return replace(message, q_m2n_wxyz=rotation.quaternion_from_matrix(C))


def test_a_velocity_that_jumps_for_good_is_followed_after_five_messages(spoilt):
    flight = spoilt("for good")
    assert only(flight, Verdict.GATED, Verdict.REOPENED)
    assert (flight.verdicts == Verdict.REOPENED).sum(axis=0).tolist() == [1] * EACH
    assert (flight.verdicts == Verdict.GATED).sum(axis=0).tolist() == [4] * EACH
    assert any("velocity and attitude are opened" in text for text in said(flight))
    # the slave has the master's velocity, and keeps what it knew of mounting, delay and biases
    off = flight.errors[-1, :, 3:6] - STEP
    assert np.abs(off).max() < 0.02
    rest = slice(6, 16)
    assert (np.abs(flight.errors[-1, :, rest]) < 4 * flight.sigmas[-1, :, rest]).all()
    assert abs(np.nanmean(flight.nis[-50:]) - 6) < 4 * np.sqrt(12 / (50 * EACH))


def survived(flight):
    """Five seconds of a jump.  A large turn is taken in parts, since the model's range ends at 0.5 rad."""
    assert only(flight, Verdict.GATED, Verdict.REOPENED)
    assert recovered(flight)
    assert np.abs(flight.errors[-1, :, 14]).max() < 1.0 * MIL


@pytest.mark.parametrize("jump", ["velocity", "roll", "heading-60"])
def test_a_jump_there_and_back_is_survived(spoilt, jump):
    survived(spoilt(jump))


def test_a_jump_that_turns_around_is_survived_by_the_quaternion(short):
    jump = within(80, 130, lambda m: turned_in_n(m, [0, 0, 150 * DEG]))
    survived(fly(short, runs=EACH, matching=("velocity", "quaternion"), change=jump))


def test_a_master_that_repeats_itself_is_refused_while_the_slave_moves(spoilt):
    flight = spoilt("frozen")
    assert set(np.unique(flight.verdicts)) == {Verdict.TAKEN, Verdict.REPEATED}
    assert (flight.verdicts == Verdict.REPEATED).sum(axis=0).tolist() == [29] * EACH
    assert "repeats its last one while the slave moves" in said(flight)[0]
    assert recovered(flight)


@pytest.fixture(scope="module")
def saturated(short):
    """For 0.2 s the gyro's first axis stands at its full scale, 0.3 rad/s, where the truth is some 0.1; of the other
    runs the accelerometer's second one for 0.1 s."""

    def shock(time, dtheta, dv):
        dtheta, dv = dtheta.copy(), dv.copy()
        if 12.0 < time <= 12.2:
            dtheta[:EACH, 0] = 0.3 * 0.01
        if 12.0 < time <= 12.1:
            dv[EACH:, 1] = -20.0 * 0.01
        return dtheta, dv

    told = fly(short, runs=2 * EACH, seconds=19.0, slave_change=shock, rules=Rules(full_scale=(0.3, 20.0)))
    blind = fly(short, runs=EACH, seconds=13.5, slave_change=shock)  # the same without being told the full scale
    return part(told, slice(EACH)), part(told, slice(EACH, 2 * EACH)), blind


def test_a_saturated_gyro_opens_the_attitude_and_recovers(saturated):
    flight, _, blind = saturated
    assert only(flight, Verdict.SATURATED)
    assert said(flight)[0].startswith("the slave's gyro is at full scale")
    assert any(text.startswith("the slave's gyro has been within its range again for 1 s") for text in said(flight))
    assert recovered(flight)
    assert (blind.verdicts == Verdict.GATED).any()
    now, then = ((each.times > 12.2) & (each.times < 13) for each in (flight, blind))
    assert flight.nees[now].mean() < 0.01 * blind.nees[then].mean()


def test_a_saturated_accelerometer_opens_the_velocity_and_recovers(saturated):
    _, flight, _ = saturated
    assert only(flight, Verdict.SATURATED)
    assert said(flight)[0].startswith("the slave's accelerometer is at full scale")
    assert recovered(flight)


def test_a_lever_arm_of_the_wrong_sign_shows_in_the_nis_and_is_told(short):
    signs, nis = (1.0, 0.0, -1.0), {}
    whole = fly(short, runs=12, seconds=15.0, lever_b=np.repeat(signs, 4)[:, None] * LEVER_B)
    for i, sign in enumerate(signs):
        runs = slice(4 * i, 4 * i + 4)
        flight = part(whole, runs)
        nis[sign] = np.nanmean(flight.every_nis)
        told = [text for text in said(flight) if "compare the lever arm and its sign" in text]
        assert bool(told) == (sign != 1.0)
        assert len(told) == 0 or whole.loop.watch.lever_told[runs].all()
    assert nis[1.0] == pytest.approx(6, abs=0.3)
    assert nis[0.0] > 50
    assert nis[-1.0] > 2 * nis[0.0]


def test_other_faults_are_not_blamed_on_the_lever_arm(spoilt):
    for name in ("velocity", "heading-1"):
        assert not any("lever arm" in text for text in said(spoilt(name)))
    noisy = spoilt("noisy")
    assert np.nanmean(noisy.nis) > 15
    assert not any("lever arm" in text for text in said(noisy))
