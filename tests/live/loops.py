"""A flight through a loop: `fly_transfer` through runtime's Transfer, `fly_live` through its Live, run by run."""

import os
import signal
from contextlib import contextmanager

import numpy as np
from judge import N, Record, density, errors_of, predicted, system
from simulator import US, Flight, matrix_of_quaternion, quaternion

from boresight import Message, load, transfer
from boresight.runtime.transfer import Increments, Transfer, Verdict, sensors


class TooLong(Exception):
    """A call that took longer than it may."""


@contextmanager
def within(seconds):
    """Raise TooLong where the body takes more processor time, on the main thread."""

    def stop(*_):
        raise TooLong(f"a call took more than {seconds} s of processor time")

    before = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def true_of(flight: Flight, k, runs=slice(None)):
    """Truth behind the k-th sample for so many runs, arrays of (runs, ...)."""
    truth = flight.truth(k)
    return truth | {name: truth[name][runs] for name in ("gyro_bias", "accel_bias")}


# ---- the loop of today


def fly_transfer(flight: Flight, rules=None, call_s=20.0, empty_batches=False, **settings):
    """All runs side by side; with a batch of no sample before each message, if so asked."""
    model, setting, sent, record = load("velocity-attitude"), flight.setting, flight.messages, Record()
    order = np.argsort(sent.after, kind="stable")
    constants, end = setting.constants(), flight.end_us * US
    tau = np.full(setting.runs, setting.tau_believed)

    def message(m):
        return Message(
            sent.stamp_us[m] * US,
            sent.R[m],
            v_m_n=sent.v_m_n[m],
            q_m2n_wxyz=sent.q_m2n_wxyz[m],
            position=sent.position[m],
            rows=np.repeat(sent.came[m][:, None], 6, axis=1),
        )

    try:
        K = int(sent.after[order[0]]) + 1
        increments = Increments(end[:K] - flight.dt[:K], end[:K], flight.dtheta[:K], flight.dv[:K])
        nav, P, past = transfer.first(
            message(order[0]),
            model,
            constants,
            sigmas=setting.sigmas(),
            increments=increments,
            estimates={"q_b2m_wxyz": flight.q_believed, "tau": tau},
        )
        loop = Transfer(model, nav, P, constants, time=end[K - 1], past=past, rules=rules, every=2, **settings)
        for m in order[1:]:
            k = int(sent.after[m]) + 1
            with within(call_s):
                if k > K:
                    loop.slave(end[K:k], flight.dtheta[K:k], flight.dv[K:k], flight.dt[K:k])
                if empty_batches:
                    loop.slave(end[k:k], flight.dtheta[k:k], flight.dv[k:k], flight.dt[k:k])
                K = k
                result = loop.master(message(m))
            came = result.verdict != Verdict.ABSENT
            record.append(
                time=flight.end[k - 1],
                errors=errors_of(nav_of(loop), true_of(flight, k - 1)),
                P=loop.P.copy(),
                nis=np.where(result.taken & came, result.nis, np.nan),
                came=came,
                refused=came & ~result.taken,
            )
    except Exception as error:
        record.raised = f"{type(error).__name__}: {error}".splitlines()[0]
    if "loop" in locals():
        record.notes = [(note.time, run, note.text) for note in loop.notes for run in note.runs]
    return record


def nav_of(loop):
    """nav, with the delay by the stamps as they come: what the loop adds to them is none of it."""
    return loop.nav | {"tau": loop.nav["tau"] - loop.stamps.clock}


# ---- the live loop
MODEL = os.environ.get("LIVE_MODEL", "velocity-attitude")

# One sigma of a start at the first message: it is late, has no lever arm in it, and the slave's axes are not the
# master's.  So wide that what the message has to do with the mounting is forgotten.
START = {"phi": [0.1, 0.1, 0.3], "dv_n": [3.0, 3.0, 3.0]}
BLOCKS = {"gyro_bias": "d_gyro_bias", "accel_bias": "d_accel_bias", "q_b2m_wxyz": "dmu", "tau": "d_tau"}


def fly_live(flight: Flight, runs=None, rules=None, call_s=2.0, carrying=None):
    """Each run by a loop of its own, begun at the first message; background behind each sample until nothing is left.

    A row is the loop just before a message arrives, when the corrections of the one before are due.  P is that of
    `covariance`, propagated from its instant to now by what is true.  A loop that is lost begins anew from the next
    message, as a driver would do it.  carrying: Sensors, by the composition that has states for them.
    """
    runs, whole, rows = flight.setting.runs if runs is None else runs, Record(), {}
    for run in range(runs):
        try:
            for k, row in one_run(flight, run, rules, call_s, whole.notes, carrying):
                rows.setdefault(k, {})[run] = row
        except Exception as error:
            whole.raised = f"run {run}: {type(error).__name__}: {error}".splitlines()[0]
    together(whole, rows, flight, runs)
    return whole


def one_run(flight, run, rules, call_s, notes, carrying=None):
    """(k, (errors, P, refused, came)) before each message, and at the end."""
    from boresight.runtime.live import Live

    constants = flight.setting.constants()
    k, counted, begun, message, known = -1, {}, False, {}, {}
    if carrying is None:
        message, model = {"lever_b": constants.pop("lever_b")}, MODEL
    else:
        wide = sensors.carried(carrying, constants, flight.setting.sigmas(), {})
        model, constants, P = sensors.MODEL, wide.constants, wide.P.copy()
        P[range(6), range(6)] = np.square([*START["phi"], *START["dv_n"]])
        known = {"P": P, "considered": wide.considered}
    loop = Live(model, rules=rules, **constants)

    def row():
        nonlocal counted
        notes.extend((flight.end[k], run, line) for line in loop.events())
        before, counted = counted, loop.counts()
        new = {name: counted[name] - before.get(name, 0) for name in counted}
        taken = new["TAKEN"]
        refused = sum(
            new[name] for name in ("IN_PART", "GATED", "OLD", "LATE", "TWICE", "AHEAD", "REFUSED", "FULL", "NOT_READY")
        )
        nav = loop.output(int(flight.end_us[k]))
        if not nav:
            return np.full(N, np.nan), np.full((N, N), np.nan), refused, taken + refused
        nav = {name: np.asarray(value, float)[None] for name, value in nav.items()}
        nav["tau"] = nav["tau"] + nav["shift"] * -1.0  # of the stamps as they come
        P, at_us = loop.covariance()
        P = to_now(flight, k, P[:N, :N], (int(flight.end_us[k]) - at_us) * US)
        return errors_of(nav, true_of(flight, k, [run]))[0], P, refused, taken + refused

    for kind, at_us, *given in flight.events(run):
        if kind == "sample":
            k += 1
            if not begun:
                continue
            dt, dtheta, dv = given
            with within(call_s):
                loop.sample(at_us, dt, dtheta_ib_b=dtheta, dv_b=dv)
                while loop.background():
                    pass
            continue
        fields, R = given[0], given[0]["R"]
        if begun:
            yield k, row()
        with within(call_s):
            if not begun or not loop.output(int(flight.end_us[k])):
                loop.begin(int(flight.end_us[k]), start(fields, flight, run) | (wide.estimates if known else {}),
                           **(known or sigmas(flight)))  # fmt: skip
                notes.extend((flight.end[k], run, line) for line in loop.events() if begun)
                begun, counted = True, {}  # it counts from here
                continue
            loop.message("velocity", at_us, R[:3], v_m_n=fields["v_m_n"], **message)
            loop.message("dcm", at_us, R[3:], q_m2n_wxyz=fields["q_m2n_wxyz"])
            while loop.background():
                pass
    yield k, row()


def to_now(flight: Flight, k, P, age):
    """P of so many seconds before the end of the k-th sample, propagated to there by what is true."""
    if not 0 < age < 2:
        return P
    constants = flight.setting.constants()
    W = density(constants)
    steps = int(np.ceil(age / 0.05))
    dt = age / steps
    for F, G in zip(*system(flight.track, flight.end[k] - age + dt * (np.arange(steps) + 0.5)), strict=True):
        P = predicted(P, F, G @ W @ G.T, dt)
    return P


def together(whole, rows, flight, runs):
    """The runs' own rows as arrays of all runs, those without a row as they were before."""
    errors, P = np.full((runs, N), np.nan), np.full((runs, N, N), np.nan)
    for k in sorted(rows):
        refused, came = np.zeros(runs, int), np.zeros(runs, int)
        for run, row in rows[k].items():
            errors[run], P[run], refused[run], came[run] = row
        whole.append(
            time=flight.end[k],
            errors=errors.copy(),
            P=P.copy(),
            nis=np.full(runs, np.nan),
            refused=refused,
            came=came,
        )


def start(fields, flight: Flight, run):
    """nav as a driver has it of the first message."""
    q_b2n = matrix_of_quaternion(fields["q_m2n_wxyz"]) @ matrix_of_quaternion(flight.q_believed[run])
    return {
        "lat_lon_height": fields["position"],
        "v_n": fields["v_m_n"],
        "q_b2n_wxyz": quaternion(q_b2n),
        "q_b2m_wxyz": flight.q_believed[run],
        "gyro_bias": np.zeros(3),
        "accel_bias": np.zeros(3),
        "tau": flight.setting.tau_believed,
    }


def sigmas(flight: Flight):
    named = {BLOCKS[name]: size for name, size in flight.setting.sigmas().items()}
    return {name: np.array(size) for name, size in START.items()} | named
