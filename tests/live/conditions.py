"""Conditions of the live loop: what is wrong with a flight, and what is asked of the loop.

A change takes a flight and gives the one that the loop sees; truth stays as it was.  Asked is one of

    consistent  NEES in its band over the second half
    informed    so too, and the sigma of the delay is what the true rates leave of it, within -5 and +20 %
    recovers    NEES in its band over the last five seconds, and in most runs a code has named what happened
    named       NEES may leave its band, and in most runs a code names it: never silent

and nothing raised, nothing that takes seconds, in all of them.

Times are seconds of the flight, and changes are the same in all runs.
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np
from simulator import (
    DEG,
    DEG_H,
    MG,
    MOTIONS,
    US,
    Flight,
    Setting,
    fly,
    matrix,
    matrix_of_quaternion,
    quaternion,
    times,
    track,
    turn_between,
)

from boresight.runtime.transfer.sensors import Sensors, calibration


def unchanged(flight):
    return flight


@dataclass(frozen=True)
class Condition:
    name: str
    asked: str
    motion: str = "ship"
    setting: dict = field(default_factory=dict)
    change: Callable[[Flight], Flight] = unchanged
    carrying: Sensors | None = None  # flown by the composition that has states for them
    refused: float = 0.01  # share of the messages that may be refused, of what is to be consistent
    held: bool = True  # docs/live.md says what is not

    def flight(self, **changes) -> Flight:
        arm = {"lever_b": (3.0, 0.0, 0.0)} if self.motion == "turntable" else {}
        return self.change(fly(Setting(motion=MOTIONS[self.motion]), **(arm | self.setting | changes)))


# ---- changes of messages


def messages(flight, **fields):
    return replace(flight, messages=replace(flight.messages, **fields))


def turned(q, turn):
    """Quaternions (..., 4) with the level turned by a rotation vector (..., 3)."""
    return quaternion(matrix(turn) @ matrix_of_quaternion(q))


def from_time(flight, begin, end=np.inf):
    """(M,) bool: messages that arrive between two times."""
    arrives = flight.end[flight.messages.after.clip(0, len(flight.end) - 1)]
    return (arrives >= begin) & (arrives < end)


def one_off(when, v=(0, 0, 0), turn=(0, 0, 0), count=1):
    """The first message from `when` on, or several, is off by a velocity, m/s, and a turn about n, e, d, rad."""

    def change(flight):
        first = np.flatnonzero(from_time(flight, when))[:count]
        v_m_n, q, came = (getattr(flight.messages, name).copy() for name in ("v_m_n", "q_m2n_wxyz", "came"))
        v_m_n[first] += v
        q[first] = turned(q[first], np.broadcast_to(np.asarray(turn, float), v_m_n[first].shape))
        came[first] = True
        return messages(flight, v_m_n=v_m_n, q_m2n_wxyz=q, came=came)

    return change


def message_of(when, **fields):
    """The first message from `when` on has these values in place of its own."""

    def change(flight):
        m, new = int(np.argmax(from_time(flight, when))), {"came": flight.messages.came.copy()}
        new["came"][m] = True
        for name, value in fields.items():
            new[name] = getattr(flight.messages, name).copy()
            new[name][m] = value
        return messages(flight, **new)

    return change


def silent(begin, end):
    """No message between two times."""
    return lambda flight: messages(flight, came=flight.messages.came & ~from_time(flight, begin, end)[:, None])


def arriving(order):
    """Messages arrive behind other samples: order(after (M,), flight) -> (M,) int."""
    return lambda flight: messages(flight, after=order(flight.messages.after, flight).clip(0, len(flight.end) - 1))


def bursts(count, reverse=False):
    """Messages arrive in bursts of `count`, in order or the newest first."""

    def order(after, flight):
        groups = np.arange(len(after)) // count
        newest = np.array([after[groups == g].max() for g in groups])
        # a sample of its own for each keeps the order of arrival
        place = np.arange(len(after)) % count
        return newest + (count - 1 - place if reverse else place)

    return arriving(order)


def swapped(share=0.3, seed=7):
    """Of so many neighbours the older one arrives one sample behind the newer one."""

    def order(after, flight):
        after, random = after.copy(), np.random.default_rng(seed)
        for m in range(1, len(after) - 1, 2):
            if random.random() < share:
                after[m] = after[m + 1] + 1
        return after

    return arriving(order)


def copied(later=0.0, samples=1):
    """Each message comes a second time, `samples` later, with its own stamp or one so many seconds later."""

    def change(flight):
        sent = flight.messages
        names = ("stamp_us", "came", "v_m_n", "q_m2n_wxyz", "position", "R", "measured")
        twice = {name: np.concatenate(2 * [getattr(sent, name)]) for name in names}
        twice["stamp_us"][len(sent.after) :] += round(later / US)
        after = np.concatenate([sent.after, sent.after + samples]).clip(0, len(flight.end) - 1)
        return messages(flight, after=after, **twice)

    return change


def by_tau(tau):
    """What is measured is as old as tau(stamp in s) says, with the noise that it had."""

    def change(flight):
        sent = flight.messages
        stamp = sent.stamp_us * US
        measured = stamp - tau(stamp)
        v_old, q_old, _ = flight.track.master(sent.measured)
        v, q, place = flight.track.master(measured)
        noise = matrix_of_quaternion(sent.q_m2n_wxyz) @ np.swapaxes(matrix_of_quaternion(q_old), -1, -2)
        q = quaternion(noise @ matrix_of_quaternion(q))
        return messages(flight, v_m_n=v + sent.v_m_n - v_old, q_m2n_wxyz=q, position=place, measured=measured)

    return change


def stamps_step(when, by):
    """The master's clock steps."""

    def change(flight):
        stamp, ahead = flight.messages.stamp_us, flight.clock + by * (flight.end >= when)
        late = (round(by / US) * from_time(flight, when))[:, None]
        return messages(replace(flight, clock=ahead), stamp_us=stamp + late)

    return change


def master_off(off):
    """off(measured (M, runs) s, random) -> errors of velocity, m/s, and attitude about n, e, d, rad, (M, runs, 3)."""

    def change(flight):
        sent = flight.messages
        v, turn = off(sent.measured, np.random.default_rng(flight.setting.seed + 1))
        return messages(flight, v_m_n=sent.v_m_n + v, q_m2n_wxyz=turned(sent.q_m2n_wxyz, turn))

    return change


def gauss_markov(measured, sigma, seconds, random):
    """(M, runs, n) of sigma (n,), at times (M, runs)."""
    out = np.empty((*measured.shape, len(sigma)))
    white = random.standard_normal(out.shape)
    out[0] = white[0]
    for m in range(1, len(out)):
        keep = np.exp(-np.abs(measured[m] - measured[m - 1]) / seconds)[:, None]
        out[m] = keep * out[m - 1] + np.sqrt(1 - keep**2) * white[m]
    return out * np.asarray(sigma)


def attitude_walks(sigma, seconds):
    return master_off(lambda t, random: (np.zeros((*t.shape, 3)), gauss_markov(t, sigma, seconds, random)))


def schuler(size=0.5, period=200.0):
    """Velocity in a slow swing and the tilt that belongs to it: v' = g theta."""

    def off(t, random):
        phase, w = random.uniform(0, 2 * np.pi, (2, t.shape[1])), 2 * np.pi / period
        north, east = size * np.sin(w * t + phase[0]), size * np.sin(w * t + phase[1])
        tilt_e, tilt_n = -w / 9.8 * size * np.cos(w * t + phase[0]), w / 9.8 * size * np.cos(w * t + phase[1])
        return np.stack([north, east, 0 * t], -1), np.stack([tilt_n, tilt_e, 0 * t], -1)

    return master_off(off)


def two_masters(tau=0.08, turn=(2e-3, -2e-3, 2e-3)):
    """Every second message is another master's, with another delay and other axes."""

    def change(flight):
        other = by_tau(lambda stamp: tau)(flight).messages
        even = (np.arange(len(other.after)) % 2 == 0)[:, None, None]
        sent = flight.messages
        q = turned(other.q_m2n_wxyz, np.broadcast_to(np.array(turn), other.v_m_n.shape))
        return messages(
            flight, v_m_n=np.where(even, sent.v_m_n, other.v_m_n), q_m2n_wxyz=np.where(even, sent.q_m2n_wxyz, q)
        )

    return change


def velocity_filtered(seconds):
    """The master's velocity is behind a low-pass of the first order."""

    def change(flight):
        sent, true = flight.messages, flight.track
        grid = np.arange(-10 * seconds, true.time[-1] + 0.01, 0.01)
        v = true.master(grid)[0]
        keep, low = np.exp(-0.01 / seconds), np.empty_like(v)
        low[0] = v[0]
        for i in range(1, len(v)):
            low[i] = keep * low[i - 1] + (1 - keep) * (v[i] + v[i - 1]) / 2
        behind = np.stack([np.interp(sent.measured, grid, (low - v)[:, i]) for i in range(3)], -1)
        return messages(flight, v_m_n=sent.v_m_n + behind)

    return change


def R_times(factor):
    """The master is as it was, and its R is wrong."""
    return lambda flight: messages(flight, R=flight.messages.R * factor)


def rounded(v=0.01, angle=1e-4):
    """The master prints so few digits, and says so in R."""

    def change(flight):
        sent = flight.messages
        e = np.round(turn_between(np.array([1.0, 0, 0, 0]), sent.q_m2n_wxyz) / angle) * angle
        R = sent.R + np.repeat([v, angle], 3) ** 2 / 12
        return messages(flight, v_m_n=np.round(sent.v_m_n / v) * v, q_m2n_wxyz=quaternion(matrix(e)), R=R)

    return change


# ---- changes of the slave


def only(flight, which):
    """The flight with these samples alone, (K,) bool; messages arrive behind the last sample before them."""
    number = np.cumsum(which) - 1
    after = number[flight.messages.after.clip(0, len(which) - 1)]
    names = ("interval", "end_us", "dt", "clock", "dtheta", "dv")
    return messages(replace(flight, **{name: getattr(flight, name)[which] for name in names}), after=after)


def gap(begin, seconds):
    return lambda flight: only(flight, (flight.end <= begin) | (flight.end > begin + seconds + 1e-9))


def tags_step(when, by, stamps=False, behind=0.0):
    """The slave's clock steps, and the stamps of the messages with it if they are by the same clock.

    behind: s, what the tags are at the start of the flight.
    """

    def change(flight):
        end_us = flight.end_us + round(by / US) * (flight.end > when)
        if not stamps:
            return replace(flight, end_us=end_us, clock=flight.clock - by * (flight.end > when))
        stamp = flight.messages.stamp_us
        return messages(replace(flight, end_us=end_us), stamp_us=stamp + round(by / US) * (stamp * US > when + behind))

    return change


def restarts(when, after):
    """The slave's counter, which had run for so many seconds before the flight, begins at 0.2 s; stamps are by it."""

    def change(flight):
        before = round(after / US)
        sent = messages(replace(flight, end_us=flight.end_us + before), stamp_us=flight.messages.stamp_us + before)
        return tags_step(when, 0.2 - when - after, stamps=True, behind=after)(sent)

    return change


def sample_of(when, **fields):
    """One sample, the first from `when` on, has these values in place of its own."""

    def change(flight):
        k, new = int(np.argmax(flight.end >= when)), {}
        for name, value in fields.items():
            new[name] = getattr(flight, name).copy()
            new[name][k] = value
        return replace(flight, **new)

    return change


def sensed(off):
    """off(flight) -> what is added to dtheta and dv, (K, runs or 1, 3) each."""

    def change(flight):
        dtheta, dv = off(flight)
        return replace(flight, dtheta=flight.dtheta + dtheta, dv=flight.dv + dv)

    return change


def true_increments(flight):
    """(K, 1, 3) of dtheta and dv, and (K, 1, 1) s."""
    i = flight.interval
    return flight.track.dtheta[i, None], flight.track.dv[i, None], flight.dt[:, None, None]


def drawn(flight, *shape):
    """(runs, ...) standard normal, one draw a run."""
    return np.random.default_rng(flight.setting.seed + 2).standard_normal((flight.setting.runs, *shape))


def g_sensitivity(deg_h_per_g):
    def off(flight):
        by_g = drawn(flight, 3, 3) * deg_h_per_g * DEG_H / 9.80665
        _, dv, _ = true_increments(flight)
        return times(by_g, dv), 0.0

    return sensed(off)


def scale_and_axes(ppm, mrad):
    def off(flight):
        by = drawn(flight, 2, 3, 3) * mrad * 1e-3
        by[..., range(3), range(3)] = drawn(flight, 2, 3) * ppm * 1e-6
        dtheta, dv, _ = true_increments(flight)
        return times(by[:, 0], dtheta), times(by[:, 1], dv)

    return sensed(off)


def miscalibrated(sizes):
    """Scale factors and axes of so many ppm and mrad, in the axes of the accelerometers."""

    def off(flight):
        K = drawn(flight, 15) @ np.linalg.cholesky(calibration(sizes) + 1e-30 * np.eye(15)).T
        gyro, accel = np.zeros((2, len(K), 3, 3))
        gyro[:, range(3), range(3)], accel[:, range(3), range(3)] = K[:, :3], K[:, 3:6]
        gyro[:, ~np.eye(3, dtype=bool)], accel[:, [1, 2, 2], [0, 0, 1]] = K[:, 6:12], K[:, 12:]
        dtheta, dv, _ = true_increments(flight)
        return [times(np.linalg.inv(np.eye(3) - k) - np.eye(3), part) for k, part in ((gyro, dtheta), (accel, dv))]

    return sensed(off)


def wander(gyro, accel, seconds):
    """Biases that wander by first-order Gauss-Markov processes about their constants: rad/s, m/s^2, one sigma."""

    def change(flight):
        random = np.random.default_rng(flight.setting.seed + 3)
        value, course = random.standard_normal((2, flight.setting.runs, 3)), []
        for dt in flight.dt:
            keep = np.exp(-dt / seconds)
            value = keep * value + np.sqrt(1 - keep**2) * random.standard_normal(value.shape)
            course.append(value)
        drift = np.array(course).swapaxes(0, 1) * np.array([gyro, accel])[:, None, None, None]
        dt = flight.dt[:, None, None]
        return replace(flight, dtheta=flight.dtheta + drift[0] * dt, dv=flight.dv + drift[1] * dt, drift=drift)

    return change


def ramps(deg_h_min, mg_min):
    def off(flight):
        size = drawn(flight, 2, 3)
        t, dt = flight.end[:, None, None] / 60, flight.dt[:, None, None]
        return size[:, 0] * deg_h_min * DEG_H * t * dt, size[:, 1] * mg_min * MG * t * dt

    return sensed(off)


def slave_filtered(gyro_s=0.015, accel_s=0.0, fine=20):
    """A low-pass of the first order in the slave's sensors."""

    def off(flight):
        setting, true = flight.setting, flight.track
        rate_hz = fine * setting.slave_hz
        thin = track(true.motion, setting.seconds, rate_hz, lever_b=true.lever_b)
        out = []
        for name, seconds in (("dtheta", gyro_s), ("dv", accel_s)):
            low = getattr(thin, name).copy()
            keep = np.exp(-1 / rate_hz / seconds) if seconds else 0.0
            for k in range(1, len(low)):
                low[k] = keep * low[k - 1] + (1 - keep) * low[k]
            low = low.reshape(-1, fine, 3).sum(axis=1)[:, None]
            out.append((low - getattr(true, name)[:, None])[flight.interval])
        return out

    return sensed(off)


def vibration(hz, deg_s):
    """A rate that the slave measures and has not: aliased to `hz`."""

    def off(flight):
        phase = 2 * np.pi * np.random.default_rng(3).random((flight.setting.runs, 3))
        rate = deg_s * DEG * np.sin(2 * np.pi * hz * flight.end[:, None, None] + phase)
        return rate * flight.dt[:, None, None], 0.0

    return sensed(off)


def flexure(mrad, hz):
    """The seat of the slave bends against the master: the master's attitude is off by a sine, and by nothing else."""

    def off(t, random):
        phase = random.uniform(0, 2 * np.pi, (1, t.shape[1], 3))
        return np.zeros((*t.shape, 3)), 1e-3 * mrad * np.sqrt(2) * np.sin(2 * np.pi * hz * t[..., None] + phase)

    return master_off(off)


def crystal(ppm):
    """The slave's clock is fast: it counts more seconds, in its tags as in dt, and stamps by the same clock."""

    def change(flight):
        fast = 1 + ppm * 1e-6
        out = replace(flight, end_us=np.round(flight.end_us * fast).astype(np.int64), dt=flight.dt * fast)
        return messages(out, stamp_us=np.round(flight.messages.stamp_us * fast).astype(np.int64))

    return change


def copies_of_samples(each):
    """One increment in so many is a copy of the one before."""

    def change(flight):
        dtheta, dv = flight.dtheta.copy(), flight.dv.copy()
        dtheta[each::each], dv[each::each] = flight.dtheta[each - 1 : -1 : each], flight.dv[each - 1 : -1 : each]
        return replace(flight, dtheta=dtheta, dv=dv)

    return change


def stuck(begin, seconds, gyro=(0, 1, 2), accel=(0, 1, 2), at_zero=False):
    """These axes deliver what they did last, or nothing."""

    def change(flight):
        now = (flight.end > begin) & (flight.end <= begin + seconds)
        first, out = int(np.argmax(now)), {}
        for name, axes in (("dtheta", gyro), ("dv", accel)):
            out[name] = getattr(flight, name).copy()
            for axis in axes:
                out[name][now, :, axis] = 0.0 if at_zero else out[name][first - 1, :, axis]
        return replace(flight, **out)

    return change


def axes_swapped(when):
    def change(flight):
        late = (flight.end > when)[:, None, None]
        order = [1, 0, 2]
        return replace(
            flight,
            dtheta=np.where(late, flight.dtheta[..., order], flight.dtheta),
            dv=np.where(late, flight.dv[..., order], flight.dv),
        )

    return change


def clipped(rate, force):
    """Axes at full scale, rad/s and m/s^2."""

    def change(flight):
        dt = flight.dt[:, None, None]
        return replace(
            flight, dtheta=np.clip(flight.dtheta, -rate * dt, rate * dt), dv=np.clip(flight.dv, -force * dt, force * dt)
        )

    return change


# ---- the list

S4 = {"seconds": 80.0}
PLAIN, POOR = (Sensors(size, size, size, size) for size in (1e-3, 3e-3))
WANDERS = Sensors(gyro_instability=3 * DEG_H, accel_instability=0.1 * MG, correlation_s=100.0)
STANDING = {"seconds": 75.0}
MINUTES = {"seconds": 300.0}  # for what is seen by many messages alone; a fifth of the runs
EARLY = {"seconds": 34.0}
HEADING_10 = {"seconds": 75.0, "mounting": (0.6 * DEG, 0.6 * DEG, 10 * DEG), "tau_believed": 0.035, "tau_sigma": 0.02}
OLD = {"tau": 0.6, "tau_believed": 0.6, "tau_sigma": 0.005, "begin": 1.2}

CONDITIONS = [
    # nothing is wrong
    *(
        Condition(f"healthy, {name}", "consistent", name)
        for name in ("ship", "ship, steady course", "calm", "s-turns", "catapult", "parked", "steady course")
    ),
    Condition("healthy, 200 Hz and 10 Hz", "consistent", setting={"slave_hz": 200, "master_hz": 10.0, "seconds": 30.0}),
    Condition("healthy, 10 Hz and 1 Hz", "consistent", "calm", {"slave_hz": 10, "master_hz": 1.0, "seconds": 60.0}),
    Condition("healthy, parked, mounting 10 deg", "consistent", "parked", HEADING_10),
    Condition("healthy, mounting 10 deg", "consistent", "ship", HEADING_10 | {"seconds": 40.0}),
    Condition("few digits", "consistent", change=rounded()),
    Condition("84 N", "consistent", "far north"),
    # S1: one message off, at rest and early
    Condition("parked, one velocity 500 m/s off", "recovers", "parked", STANDING, one_off(55, v=(500, 0, 0))),
    Condition("parked, one velocity 20 m/s off", "recovers", "parked", STANDING, one_off(55, v=(0, 20, 0))),
    Condition("parked, one velocity 3 m/s off", "recovers", "parked", STANDING, one_off(55, v=(0, 3, 0))),
    Condition("parked, one heading 90 deg off", "recovers", "parked", STANDING, one_off(55, turn=(0, 0, 90 * DEG))),
    Condition(
        "parked, mounting 10 deg, one heading 20 deg off",
        "recovers",
        "parked",
        HEADING_10,
        one_off(55, turn=(0, 0, 20 * DEG)),
        held=False,
    ),
    Condition("moving, one velocity 500 m/s off at 4.1 s", "recovers", "ship", EARLY, one_off(4.1, v=(500, 0, 0))),
    Condition("moving, one velocity 20 m/s off at 4.1 s", "recovers", "ship", EARLY, one_off(4.1, v=(0, 20, 0))),
    Condition("moving, one velocity 3 m/s off at 4.1 s", "recovers", "ship", EARLY, one_off(4.1, v=(3, 0, 0))),
    Condition(
        "moving, one heading 90 deg off at 4.1 s", "recovers", "ship", EARLY, one_off(4.1, turn=(0, 0, 90 * DEG))
    ),
    Condition(
        "moving, one heading 20 deg off at 4.1 s", "recovers", "ship", EARLY, one_off(4.1, turn=(0, 0, 20 * DEG))
    ),
    # S2, S3, S5, S12, S13: nothing raises, nothing hangs, clocks heal
    Condition("delay of 0.6 s, 0.2 s of the slave lost", "named", "ship", OLD, gap(10.2, 0.2)),
    Condition("delay of 0.6 s", "named", "ship", OLD),
    Condition("0.04 s of the slave lost", "recovers", change=gap(20.0, 0.04)),
    Condition("10 s of the slave lost", "recovers", "ship", {"seconds": 50.0}, gap(15.0, 10.0)),
    Condition("counter of the slave restarts, 20 s to 0.2 s", "recovers", change=tags_step(20.0, -19.8, stamps=True)),
    Condition("counter of the slave restarts after an hour", "recovers", change=restarts(20.0, 3600.0)),
    Condition("tags of the slave step by +50 ms", "recovers", change=tags_step(20.0, 0.05)),
    Condition("tags of the slave step by -50 ms", "recovers", change=tags_step(20.0, -0.05)),
    Condition("tags and stamps step by -50 ms", "recovers", change=tags_step(20.0, -0.05, stamps=True)),
    Condition("one dt of 1e-9 s", "recovers", change=sample_of(20.0, dt=1e-9)),
    Condition("one dt of 1e-5 s", "recovers", change=sample_of(20.0, dt=1e-5)),
    Condition("one gyro sample is no number", "recovers", change=sample_of(20.0, dtheta=np.nan)),
    Condition("one increment of 1e30", "recovers", change=sample_of(20.0, dv=1e30)),
    # messages late, lost, copied, out of order
    Condition("messages 0.2 s late", "consistent", setting={"late": 0.2}),
    Condition("half of the messages lost", "consistent", setting={"lost": 0.5}),
    Condition("no message for 10 s", "recovers", change=silent(15.0, 25.0)),
    Condition("bursts of five", "consistent", setting={"master_hz": 25.0, "seconds": 24.0}, change=bursts(5)),
    Condition(
        "bursts of five, newest first",
        "consistent",
        setting={"master_hz": 25.0, "seconds": 24.0},
        change=bursts(5, reverse=True),
        held=False,
    ),
    Condition("neighbours out of order", "consistent", change=swapped(), held=False),
    Condition("one velocity is no number", "recovers", change=message_of(20.0, v_m_n=np.nan)),
    Condition("one R is 0", "recovers", change=message_of(20.0, R=0.0)),
    Condition("one quaternion of norm 2", "recovers", change=message_of(20.0, q_m2n_wxyz=(2.0, 0.0, 0.0, 0.0))),
    Condition("each message twice, same stamp", "consistent", change=copied(), refused=0.51),
    Condition("each message twice, 20 ms later with a new stamp", "named", change=copied(0.02)),
    Condition("delay steps by 100 ms", "recovers", setting={"tau_step": (20.0, 0.1)}),
    Condition("stamps step by -0.3 s", "recovers", change=stamps_step(20.0, -0.3), held=False),
    Condition("stamps step by a week", "recovers", change=stamps_step(20.0, 604800.0)),
    Condition("clocks 500 ppm apart", "named", setting=MINUTES | {"tau_drift": 5e-4}),
    Condition("delay drifts by 10 ms/min", "named", setting=MINUTES | {"tau_drift": 1e-2 / 60}),
    # S4: what steady motion does not show
    *(
        Condition(f"delay, {name}", "informed", name, S4, held=name not in ("turntable", "small roll"))
        for name in ("steady turn", "loiter", "turntable", "small roll", "parked")
    ),
    # S6: the master's errors are not white
    Condition("heading walks, 1 mrad, 300 s", "named", "ship", MINUTES, change=attitude_walks((0, 0, 1e-3), 300.0)),
    Condition(
        "attitude walks, .2 .2 2 mrad, 60 s",
        "named",
        "ship",
        MINUTES,
        change=attitude_walks((0.2e-3, 0.2e-3, 2e-3), 60.0),
    ),
    Condition("attitude walks, 1 mrad, 2 s", "named", change=attitude_walks((1e-3, 1e-3, 1e-3), 2.0)),
    Condition("Schuler, .5 m/s", "named", "ship", MINUTES, change=schuler()),
    Condition("two masters, 35 and 80 ms, 2 mrad", "named", change=two_masters()),
    Condition("velocity behind a low-pass of .1 s", "named", change=velocity_filtered(0.1)),
    Condition("velocity behind a low-pass of .5 s", "named", change=velocity_filtered(0.5)),
    Condition("R a hundredth", "named", change=R_times(0.01)),
    Condition("R a tenth", "named", change=R_times(0.1)),
    Condition("R ten times", "named", change=R_times(10.0)),
    Condition("lever arm 2 m wrong, right", "named", setting={"lever_believed": (-2.4, 3.2, 1.75)}),
    Condition("lever arm 2 m wrong, front", "named", setting={"lever_believed": (-0.4, 1.2, 1.75)}),
    Condition("flexure .5 mrad at .1 Hz", "named", change=flexure(0.5, 0.1)),
    # S7: the slave's sensors
    Condition("g-sensitivity 108 deg/h/g", "named", "ship", MINUTES, change=g_sensitivity(108.0)),
    Condition("g-sensitivity 108 deg/h/g, S-turns", "named", "s-turns", MINUTES, change=g_sensitivity(108.0)),
    Condition("15 ms filter in the gyros", "named", "ship", MINUTES, change=slave_filtered()),
    Condition("15 ms filter in both", "named", "ship", MINUTES, change=slave_filtered(0.015, 0.015)),
    Condition("ramps of 20 deg/h/min, .5 mg/min", "named", "ship", MINUTES, change=ramps(20.0, 0.5)),
    Condition("crystal 500 ppm fast", "named", "ship", MINUTES, change=crystal(500.0)),
    Condition("one increment in 20 a copy", "named", "ship", MINUTES, change=copies_of_samples(20)),
    Condition("vibration aliased to 13 Hz, 2 deg/s", "named", change=vibration(13.0, 2.0)),
    Condition("vibration aliased to 1 Hz, 1 deg/s", "named", change=vibration(1.0, 1.0)),
    Condition("scale 300 ppm, axes .3 mrad, S-turns", "named", "s-turns", MINUTES, change=scale_and_axes(300.0, 0.3)),
    Condition("scale 1000 ppm, axes 1 mrad, carried", "consistent", change=miscalibrated(PLAIN), carrying=PLAIN),
    Condition("the same in S-turns", "consistent", "s-turns", change=miscalibrated(PLAIN), carrying=PLAIN, held=False),
    Condition(
        "scale 3000 ppm, axes 3 mrad, carried", "consistent", change=miscalibrated(POOR), carrying=POOR, held=False
    ),
    Condition(
        "instability 3 deg/h, 100 ug, carried",
        "consistent",
        change=wander(3 * DEG_H, 0.1 * MG, 100.0),
        carrying=WANDERS,
    ),
    Condition("slave stuck for 1 s", "recovers", change=stuck(15.0, 1.0), held=False),
    Condition("one gyro axis frozen", "named", change=stuck(20.0, 99.0, gyro=(0,), accel=())),
    Condition("one gyro axis reads 0", "named", change=stuck(20.0, 99.0, gyro=(0,), accel=(), at_zero=True)),
    Condition("axes x and y swapped at 20 s", "named", change=axes_swapped(20.0)),
    Condition("accelerometers clip at 2 g, catapult", "named", "catapult", change=clipped(10.0, 2 * 9.80665)),
]


def condition(name) -> Condition:
    return next(one for one in CONDITIONS if one.name == name)
