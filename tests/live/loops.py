"""A flight through a loop: `transferred` through runtime's Transfer, `live` through its Live, run by run."""

import signal
from contextlib import contextmanager

import numpy as np
from judge import Flown, N, errors_of
from simulator import US, Flight, matrix_of_euler, quaternion

from boresight import Message, load, transfer
from boresight.runtime.transfer import Increments, Transfer, Verdict


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


def transferred(flight: Flight, rules=None, call_s=20.0, empty_batches=False, **settings):
    """All runs side by side; with a batch of no sample before each message, if so asked."""
    model, setting, sent, flown = load("velocity-attitude"), flight.setting, flight.messages, Flown()
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
        past = Increments(end[:K] - flight.dt[:K], end[:K], flight.dtheta[:K], flight.dv[:K])
        nav, P, kept = transfer.first(
            message(order[0]),
            model,
            constants,
            sigmas=setting.sigmas(),
            increments=past,
            estimates={"q_b2m_wxyz": flight.q_believed, "tau": tau},
        )
        loop = Transfer(model, nav, P, constants, time=end[K - 1], past=kept, rules=rules, every=2, **settings)
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
            flown.append(
                time=flight.end[k - 1],
                errors=errors_of(nav_of(loop), true_of(flight, k - 1)),
                P=loop.P.copy(),
                nis=np.where(result.taken & came, result.nis, np.nan),
                came=came,
                refused=came & ~result.taken,
            )
    except Exception as error:
        flown.raised = f"{type(error).__name__}: {error}".splitlines()[0]
    if "loop" in locals():
        flown.notes = [(note.time, run, note.text) for note in loop.notes for run in note.runs]
    return flown


def nav_of(loop):
    """nav, with the delay by the stamps as they come: what the loop adds to them is none of it."""
    return loop.nav | {"tau": loop.nav["tau"] - loop.stamps.clock}


# ---- the live loop

# one sigma of a start that is only roughly known, by block of the state; the others are the setting's
ROUGH = {"phi": [0.5, 0.5, 2.0], "dv": [100.0, 100.0, 10.0]}
BLOCKS = {"gyro_bias": "dbg", "accel_bias": "dba", "q_b2m_wxyz": "dmu", "tau": "d_tau"}


def live(flight: Flight, runs=None, rules=None, call_s=2.0, taken=lambda fate: fate == 0):
    """Each run by a loop of its own, from the first sample on; background once behind each sample.

    output()["P"] is what NEES is of; without it, of the sigmas alone, as if the errors were independent.
    A loop that states the NIS of its last message as `nis` has its mean too; one that adds to the stamps says how much
    by output()["clock"], s.
    """
    from boresight.runtime.live import Live

    setting, whole = flight.setting, Flown()
    rows = {}
    for run in range(setting.runs if runs is None else runs):
        try:
            loop, k = Live("velocity-attitude", rules=rules, **setting.constants()), -1
            loop.begin(0, rough(flight, run), sigmas(flight))
            for kind, at_us, *given in flight.events(run):
                with within(call_s):
                    if kind == "sample":
                        k += 1
                        dt, dtheta, dv = given
                        status = loop.sample(at_us, dt, dtheta_ib_b=dtheta, dv_b=dv)
                        if status:
                            whole.notes.append((flight.end[k], run, f"sample {status}"))
                        loop.background()
                        continue
                    fields, R = given[0], given[0]["R"]
                    lever = setting.constants()["lever_b"]
                    fates = [
                        loop.message("velocity", at_us, R[:3], v_m_n=fields["v_m_n"], lever_b=lever),
                        loop.message("dcm", at_us, R[3:], q_m2n_wxyz=fields["q_m2n_wxyz"]),
                    ]
                    while loop.background():
                        pass
                    nav = loop.output(int(flight.end_us[k]))
                nav["tau"] = nav["tau"] - nav.pop("clock", 0.0)
                sigma = np.asarray(nav["sigma"], float)
                P = np.asarray(nav.get("P", np.diag(sigma**2)), float)
                refused = not all(taken(fate) for fate in fates)
                if refused:
                    whole.notes.append((flight.end[k], run, f"message {fates}"))
                rows.setdefault(k, {})[run] = (
                    errors_of({n: np.asarray(v)[None] for n, v in nav.items()}, true_of(flight, k, [run]))[0],
                    P,
                    np.nan if refused else getattr(loop, "nis", np.nan),
                    refused,
                )
        except Exception as error:
            whole.raised = f"run {run}: {type(error).__name__}: {error}".splitlines()[0]
    together(whole, rows, flight, setting.runs if runs is None else runs)
    return whole


def together(whole, rows, flight, runs):
    """The runs' own rows as arrays of all runs, those that nothing came to as they were before."""
    errors, P = np.full((runs, N), np.nan), np.full((runs, N, N), np.nan)
    for k in sorted(rows):
        nis, refused, came = np.full(runs, np.nan), np.zeros(runs, bool), np.zeros(runs, bool)
        for run, row in rows[k].items():
            errors[run], P[run], nis[run], refused[run] = row
            came[run] = True
        whole.append(time=flight.end[k], errors=errors.copy(), P=P.copy(), nis=nis, refused=refused, came=came)


def rough(flight: Flight, run):
    """nav at the first sample as somebody has it who knows the place, and nothing of velocity and heading."""
    return {
        "lat_lon_height": flight.messages.position[0, run],
        "v_n": np.zeros(3),
        "q_b2n_wxyz": quaternion(matrix_of_euler(np.zeros(3))),
        "gyro_bias": np.zeros(3),
        "accel_bias": np.zeros(3),
        "q_b2m_wxyz": flight.q_believed[run],
        "tau": flight.setting.tau_believed,
    }


def sigmas(flight: Flight):
    named = {BLOCKS[name]: np.atleast_1d(size) for name, size in flight.setting.sigmas().items()}
    return {name: np.array(size) for name, size in ROUGH.items()} | named
