"""A flight through the live loop, run by run."""

import os
import signal
from contextlib import contextmanager

import numpy as np
from judge import N, Record, density, errors_of, predicted, system
from simulator import US, Flight, matrix_of_quaternion, quaternion

from boresight import Live
from boresight.runtime.transfer import sensors


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


MODEL = os.environ.get("LIVE_MODEL", "velocity-attitude")

# One sigma of a start at the first message: it is late, has no lever arm in it, and the slave's axes are not the
# master's.  So wide that what the message has to do with the mounting is forgotten.
START = {"phi": [0.1, 0.1, 0.3], "dv_n": [3.0, 3.0, 3.0]}
BLOCKS = {"gyro_bias": "d_gyro_bias", "accel_bias": "d_accel_bias", "q_b2m_wxyz": "dmu", "tau": "d_tau"}


def fly_live(flight: Flight, runs=None, rules=None, call_s=2.0, carrying=None, considered=None):
    """Each run by a loop of its own, begun at the first message; background behind each sample until nothing is left.

    A row is the loop just before a message arrives, when the corrections of the one before are due.  P is that of
    `covariance`, propagated from its instant to now by what is true.  A loop that is lost begins anew from the next
    message, as a driver would do it.  carrying: Sensors, by the composition that has states for them.
    considered: (16,) bool, states that no measurement corrects.
    """
    runs, whole, rows, steps = flight.setting.runs if runs is None else runs, Record(), {}, steps_of(flight)
    for run in range(runs):
        try:
            for k, row in one_run(flight, run, rules, call_s, whole.notes, steps, carrying, considered):
                rows.setdefault(k, {})[run] = row
        except Exception as error:
            whole.raised = f"run {run}: {type(error).__name__}: {error}".splitlines()[0]
    together(whole, rows, flight, runs)
    return whole


def one_run(flight, run, rules, call_s, notes, steps, carrying=None, considered=None):
    """(k, (errors, P, refused, came)) before each message, and at the end."""
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
        P = to_now(flight, k, P[:N, :N], (int(flight.end_us[k]) - at_us) * US, steps)
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
                           **(known or sigmas(flight) | {"considered": considered}))  # fmt: skip
                notes.extend((flight.end[k], run, line) for line in loop.events() if begun)
                begun, counted = True, {}  # it counts from here
                continue
            loop.message("velocity", at_us, R[:3], v_m_n=fields["v_m_n"], **message)
            loop.message("dcm", at_us, R[3:], q_m2n_wxyz=fields["q_m2n_wxyz"])
            while loop.background():
                pass
    yield k, row()


GRID_S = 0.05


def steps_of(flight: Flight):
    """F (T, 16, 16) and Q (T, 16, 16) of what is true, in the middles of steps of GRID_S from GRID_S before 0 on."""
    times = GRID_S * (np.arange(int(flight.end[-1] / GRID_S) + 3) - 0.5)
    F, G = system(flight.track, times)
    return F, G @ density(flight.setting.constants()) @ np.swapaxes(G, -1, -2)


def to_now(flight: Flight, k, P, age, steps):
    """P of so many seconds before the end of the k-th sample, propagated to there by what is true."""
    if not 0 < age < 2:
        return P
    count = int(np.ceil(age / GRID_S))
    dt = age / count
    for middle in flight.end[k] - age + dt * (np.arange(count) + 0.5):
        at = int(middle / GRID_S + 1)
        P = predicted(P, steps[0][at], steps[1][at], dt)
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
