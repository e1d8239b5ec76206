"""What disturbs an azimuth hold at 500 s, and what notices: a detector of motion, a gate on the innovations.

Kim (2018) strikes the unit once and lets the detector stop the updates.  Here five things happen, to both ways of using
the azimuth (its error white, or a state), with and without the detector and the gate, all in one flight.

The rules, beside the filter's own:
  detector  a second in which any window shows motion, and `WAIT_S` after it, has no update of either kind.
  gate      a row whose innovation exceeds `GATE` of its sigmas is left out.
  stale     after `PATIENCE_S` gated azimuths in a row the reference is given up and said to be stale: it is not applied
            again, and phi_u gets the variance z^2, since gyros cannot tell a turn of the platform from an upset of
            their own.
  reset     after `PATIENCE_S` gated velocities in a row velocity and level get `RESET_M_S` and `RESET_TILT`.
  acquire   later a fresh azimuth is given to those whose reference is stale.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime import detector, rotation
from boresight.runtime.array import Array
from boresight.runtime.filter import Filter
from boresight.runtime.simulation import inertial
from boresight.runtime.status import Status
from boresight.runtime.units import ARCMIN, DEG, MILLI_G
from boresight.studies.azimuth_hold.alignment import (
    Aligned,
    Models,
    Scenario,
    accel_walk,
    align,
    checked,
    gyro_walk,
    load_models,
)
from boresight.studies.azimuth_hold.hold import AXES, PHI, REFERENCE_SIGMA, root_mean_square

EVENTS = {
    "none": "nothing happens",
    "ring-down": "8 Hz, 1 mrad and 1 m/s^2, gone within a second",
    "shock": "10 g for 10 ms, there and back",
    "handling": "six seconds in the hand: 3 degrees and 0.3 m/s, put back as it was",
    "upset": "the unit shows 5 deg/s about up and 2 m/s^2 for 0.2 s; the platform rests",
    "turn": "the platform turns by half a degree about up in two seconds, and stays",
}
CONFIGS = (("white", False, False), ("white", True, False), ("white", False, True), ("white", True, True),
           ("state", False, False), ("state", True, False), ("state", False, True), ("state", True, True))  # fmt: skip
LENGTH_S = 8  # of an event, to the last of its motion
TIMES_S = (500, 800, 1000)  # the event, the fresh azimuth, the end
GATE, PATIENCE_S, WAIT_S = 4.0, 10, 1
RESET_M_S, RESET_TILT, FRESH_SIGMA = 1.0, 0.5 * DEG, 3 * ARCMIN
WINDOW, FALSE_ALARM = 50, 1e-6  # half a second; of each of four; 35 h of windows that share nothing


@dataclass(frozen=True)
class Truth:
    """Of the event's seconds: increments (n, runs, 3), and the attitude after it, (runs, 4)."""

    dtheta: Array
    dv: Array
    q_b2n_wxyz: Array


def event(models: Models, scenario: Scenario, start: Aligned, name: str) -> Truth:
    """Ideal increments of LENGTH_S seconds; what is the sensors' own error is added to them too."""
    dt = 1 / scenario.strapdown_hz
    t = np.arange(LENGTH_S * scenario.strapdown_hz + 1)[:, None] * dt
    turn, v = np.zeros((len(t), 3)), np.zeros((len(t), 3))  # rotation vector in the level, m/s
    if name == "ring-down":
        on = t >= 0.5
        swing = np.where(on, np.exp(-(t - 0.5) / 0.15) * np.sin(2 * np.pi * 8 * (t - 0.5)), 0.0)
        swing *= np.clip((2.5 - t) / 0.5, 0, 1)
        turn, v = 1e-3 * swing * [1, 0.5, 1], swing / (2 * np.pi * 8) * [1, 1, 0.3]
    if name == "shock":
        for first, sign in ((0.5, 1), (0.52, -1)):
            inside = (t > first - dt / 2) & (t < first + dt / 2)
            v = v + sign * np.where(inside, 98.0665 * dt, 0.0) * [1, 0, 0]
    if name == "handling":
        s = np.clip((t - 0.5) / 6, 0, 1)
        near = np.sin(np.pi * s) ** 2
        turn = 3 * DEG * near * np.sin(2 * np.pi * (t - 0.5) / 3) * [1, 0.7, 1]
        v = 0.3 * near * np.sin(2 * np.pi * (t - 0.5) / 2) * [1, 1, 0.5]
    if name == "turn":
        s = np.clip((t - 0.5) / 2, 0, 1)
        turn = 0.5 * DEG * (s**3 * (10 - 15 * s + 6 * s**2)) * [0, 0, 1]
    q0 = start.q_b2n_wxyz
    C = np.swapaxes(rotation.matrix_from_quaternion(q0), -1, -2)
    q = rotation.turned(np.broadcast_to(q0, (len(t), *q0.shape)), np.einsum("rij,tj->tri", C, turn))
    v_runs = np.broadcast_to(v[:, None], (len(t), len(q0), 3))
    dtheta, dv, _ = inertial.increments(models.strapdown.step, start.position, v_runs, q, dt)
    if name == "upset":
        wrong = ((t[1:, :] > 0.5) & (t[1:, :] <= 0.7))[:, None]
        dtheta = dtheta + np.where(wrong, 5 * DEG * dt, 0.0) * C[:, :, 2]
        dv = dv + np.where(wrong, 2.0 * dt, 0.0) * C[:, :, 0]
    return Truth(dtheta, dv, q[-1])


def thresholds(models: Models, scenario: Scenario, start: Aligned) -> detector.Settings:
    """From the noise of the unit and a rate of false alarms; nothing of it from a filter."""
    earth = models.strapdown.earth(position=start.position, v_n=np.zeros(3))
    gravity = float(-earth["gravity_n"][2])
    dt = 1 / scenario.strapdown_hz
    return detector.settings(
        WINDOW,
        accel_walk(scenario) / np.sqrt(dt),
        gyro_walk(scenario) / np.sqrt(dt),
        FALSE_ALARM,
        gravity=gravity,
        rest_rate=float(np.linalg.norm(earth["omega_ie_n"])) + 4 * scenario.gyro_bias_deg_h * DEG / 3600,
        gravity_error=4 * scenario.accel_bias_mg * MILLI_G + 4e-6 * scenario.accel_scale_ppm * gravity,
    )


SHOWN = {"turn_plain": ("turn", False), "turn_guarded": ("turn", True), "shock_guarded": ("shock", True)}
SAYS_MOTION = ("gyro_mean", "gyro_std", "accel_mean", "accel_std")


def run(
    models: Models | None = None,
    *,
    runs: int = 5,
    seed: int = 0,
    times_s: tuple[int, int, int] = TIMES_S,
    scenario: Scenario | None = None,
    progress: Callable[[str], None] | None = None,
) -> dict[str, Any]:
    """The table of what each catches.  The result can be written as JSON; its fields are stable:

    study, runs, seed, event_s, acquire_s, end_s, events (name -> what happens), axes, modes (of the histories);
    rows: event, azimuth ("white", "state"), detector, gate; before_arcmin (at event_s), after_arcmin (a second before
    acquire_s), end_arcmin: [error rms, sigma] about up; level_arcmin and level_largest_arcmin, rms and largest of both
    level axes from the event to acquire_s; stopped_s: seconds in the 20 from the event on without a velocity update,
    mean over runs; stale: runs in which the filter said that its reference is stale; resets: of velocity and level,
    mean; nees: of the three angles, a second before acquire_s, mean; silent: runs then more than 4 of their own sigmas
    wrong about up, of which the filter said nothing;
    histories: time_s, and for turn_plain, turn_guarded and shock_guarded (the azimuth's error white, without and with
    detector and gate): error_arcmin (3 runs, T, 3), rms_arcmin and sigma_arcmin (T, 3); what moves during the event is
    left out (null).
    """
    models, scenario = models or load_models(), checked(scenario or Scenario())
    event_s, acquire_s, end_s = times_s
    if runs < 1 or not 20 <= event_s < event_s + 25 < acquire_s < end_s <= 36000:
        raise BoresightError(
            f"azimuth-shock needs at least 1 run, 20 s before the event, 26 s from it to the fresh azimuth, and an end "
            f"after that; got {runs} runs, {times_s}"
        )
    say = progress or (lambda line: None)
    start = align(models, scenario, runs=runs, seed=seed)
    names, events, configs = list(EVENTS), len(EVENTS), len(CONFIGS)
    truths = [event(models, scenario, start, name) for name in names]
    shape = (configs, events, runs)
    white = np.array([c[0] == "white" for c in CONFIGS])[:, None, None]
    has_detector = np.array([c[1] for c in CONFIGS])[:, None, None]
    gate = np.where([c[2] for c in CONFIGS], GATE, np.inf)[:, None, None]

    nav = {name: np.broadcast_to(value, (*shape[:2], *value.shape)).copy() for name, value in start.nav.items()}
    nav["reference_error"] = np.zeros(shape)
    P = np.zeros((*shape, 16, 16))
    P[..., :15, :15] = start.P
    variance = np.broadcast_to(start.P[:, 8, 8], shape).copy()
    coupled = np.where(white[..., None], 0.0, -start.P[:, 8, :])
    P[..., :15, 15] = P[..., 15, :15] = coupled
    P[..., 15, 15] = np.where(white, 0.0, variance)
    loop = Filter(models.hold_reference, nav, P)
    q_ref = loop.nav["q_b2n_wxyz"].copy()

    hz, dt = scenario.strapdown_hz, 1 / scenario.strapdown_hz
    sensors = start.drawn.sensors
    earth = models.strapdown.earth(position=start.position, v_n=np.zeros(3))
    settings = thresholds(models, scenario, start)
    dll = detector.library()
    R_zupt = np.full(3, scenario.zupt_sigma_m_s**2)
    noise = {"gyro_noise": np.full(3, gyro_walk(scenario)), "accel_noise": np.full(3, accel_walk(scenario)),
             "gyro_bias_noise": np.zeros(3), "accel_bias_noise": np.zeros(3)}  # fmt: skip
    q_true = np.broadcast_to(start.q_b2n_wxyz, (events, runs, 4)).copy()
    kept, before, tail = [], None, None
    quiet = np.full((events, runs), WAIT_S)
    rejected_azimuth, rejected_zupt = np.zeros(shape, int), np.zeros(shape, int)
    stale, resets, stopped = np.zeros(shape, bool), np.zeros(shape, int), np.zeros(shape, int)
    generator = np.random.default_rng([seed, 77])

    for second in range(1, end_s + 1):
        k = second - 1 - event_s
        in_event = 0 <= k < LENGTH_S
        if k == LENGTH_S:
            q_true = np.stack([truth.q_b2n_wxyz for truth in truths])
        ideal_dtheta = np.empty((hz, events, runs, 3))
        ideal_dv = np.empty((hz, events, runs, 3))
        C = rotation.matrix_from_quaternion(q_true)
        if in_event:
            for i, truth in enumerate(truths):
                ideal_dtheta[:, i], ideal_dv[:, i] = (
                    truth.dtheta[k * hz : (k + 1) * hz],
                    truth.dv[k * hz : (k + 1) * hz],
                )
        else:
            ideal_dtheta[:] = np.einsum("erji,j->eri", C, earth["omega_ie_n"]) * dt
            ideal_dv[:] = -np.einsum("erji,j->eri", C, earth["gravity_n"]) * dt
        raw_dtheta, raw_dv = disturbed(sensors, ideal_dtheta, ideal_dv, dt)
        # The detector's windows reach back into the second before.
        gyro = np.moveaxis(raw_dtheta / dt, 0, -2)
        accel = np.moveaxis(raw_dv / dt, 0, -2)
        past = tail or (gyro[..., :0, :], accel[..., :0, :])
        said = detector.evaluate(settings, np.concatenate([past[0], gyro], -2), np.concatenate([past[1], accel], -2),
                                 dll=dll)  # fmt: skip
        tail = (gyro[..., -(WINDOW - 1) :, :], accel[..., -(WINDOW - 1) :, :])
        full = said.status == Status.OK
        moving = (full & ~said.rest_by(*SAYS_MOTION)).any(-1)
        quiet = np.where(moving, 0, quiet + 1)
        rest = (quiet > WAIT_S)[None] | ~has_detector

        dtheta, dv = raw_dtheta[:, None], raw_dv[:, None]
        fields, before = inertial.intervals(dtheta, dv, before), (dtheta[-1], dv[-1])
        for j in range(hz):
            loop.strapdown(**{name: values[j] for name, values in fields.items()}, dt=dt)
        loop.predict(f_b=dv.mean(axis=0) / dt - loop.nav["accel_bias"], dt=1.0, **noise)

        zupt_rows = gated(loop, "zupt", R_zupt, rest, gate)
        loop.update("zupt", R_zupt, rows=zupt_rows[..., None])
        rejected_zupt = np.where(rest & ~zupt_rows, rejected_zupt + 1, 0)
        R_azimuth = np.where(white, variance, REFERENCE_SIGMA**2)[..., None]
        wanted = rest & ~stale
        azimuth_rows = gated(loop, "azimuth", R_azimuth, wanted, gate, q_ref_wxyz=q_ref)
        loop.update("azimuth", R_azimuth, rows=azimuth_rows[..., None], q_ref_wxyz=q_ref)
        rejected_azimuth = np.where(wanted & ~azimuth_rows, rejected_azimuth + 1, np.where(wanted, 0, rejected_azimuth))
        z = loop.call("azimuth_z", q_ref_wxyz=q_ref)[..., 0]
        loop.feedback()
        newly = (rejected_azimuth >= PATIENCE_S) & ~stale
        give_up(loop, z, newly)
        stale |= newly
        lost = rejected_zupt >= PATIENCE_S
        reset(loop, lost)
        resets += lost
        rejected_zupt[lost] = 0
        if event_s < second <= event_s + 20:
            stopped += ~zupt_rows
        if second == acquire_s - 1:
            P3 = loop.P[..., PHI, PHI]
            phi_now = rotation.attitude_error(loop.nav["q_b2n_wxyz"], q_true)
            nees = np.einsum("...i,...i->...", phi_now, np.linalg.solve(P3, phi_now[..., None])[..., 0])
        if second == acquire_s:
            said_stale = stale.copy()
            error = FRESH_SIGMA * generator.standard_normal(runs)
            q_fresh = rotation.turned(q_true, np.einsum("erji,j->eri", C, [0.0, 0.0, 1.0]) * error[:, None])
            acquire(loop, q_ref, q_fresh, stale, white)
            variance = np.where(stale, FRESH_SIGMA**2, variance)
            rejected_azimuth[stale], stale = 0, np.zeros(shape, bool)
        phi_now = rotation.attitude_error(loop.nav["q_b2n_wxyz"], q_true)
        # During the event the platform moves: the truth of these seconds is not kept
        sigma = np.sqrt(np.einsum("...ii->...i", loop.P)[..., PHI])
        kept.append((np.where(in_event, np.nan, phi_now), sigma))
        if second % 200 == 0:
            say(f"{second} of {end_s} s")
    phi, sigma = (np.array(part) for part in zip(*kept, strict=True))
    return result_of(runs, seed, times_s, phi, sigma, nees, said_stale, resets, stopped)


def disturbed(sensors: Any, dtheta: Array, dv: Array, dt: float) -> tuple[Array, Array]:
    """Measured increments (samples, events, runs, 3): the same noise in every event."""
    noise_only = sensors.measured(np.zeros_like(dtheta[0, 0]), np.zeros_like(dv[0, 0]), dt, len(dtheta))
    return (
        np.einsum("rij,...rj->...ri", sensors.gyro_gain, dtheta) + noise_only[0][:, None],
        np.einsum("rij,...rj->...ri", sensors.accel_gain, dv) + noise_only[1][:, None],
    )


def gated(loop: Filter, name: str, R: Array, wanted: Array, gate: Array, **inputs: Any) -> Array:
    """(...,) bool: runs whose every row lies within the gate, by itself; all rows or none are taken."""
    z, H = loop.call(f"{name}_z", **inputs), loop.call(f"{name}_H", **inputs)
    S = np.einsum("...ij,...jk,...ik->...i", H, loop.P, H) + R
    return wanted & (z**2 <= gate[..., None] ** 2 * S).all(-1)


def give_up(loop: Filter, z: Array, now: Array) -> None:
    """The reference is stale: what the azimuth may be wrong by is what it and the reference differ by."""
    loop.P[..., 8, 8] += np.where(now, z**2, 0.0)


def reset(loop: Filter, now: Array) -> None:
    """Velocity and level begin anew; what they knew of other states goes with them."""
    for state, sigma in ((3, RESET_M_S), (4, RESET_M_S), (5, RESET_M_S), (6, RESET_TILT), (7, RESET_TILT)):
        row = np.where(now[..., None], 0.0, loop.P[..., state, :])
        loop.P[..., state, :] = row
        loop.P[..., :, state] = row
        loop.P[..., state, state] = np.where(now, sigma**2, row[..., state])


def acquire(loop: Filter, q_ref: Array, q_fresh: Array, now: Array, white: Array) -> None:
    """A new reference, in error by itself and by nothing that the filter knows."""
    q_ref[now] = np.broadcast_to(q_fresh, q_ref.shape)[now]
    loop.nav["reference_error"][now] = 0.0
    loop.P[..., 15, :] = np.where(now[..., None], 0.0, loop.P[..., 15, :])
    loop.P[..., :, 15] = np.where(now[..., None], 0.0, loop.P[..., :, 15])
    loop.P[..., 15, 15] = np.where(now & ~white, FRESH_SIGMA**2, loop.P[..., 15, 15])


def result_of(
    runs: int,
    seed: int,
    times_s: tuple[int, int, int],
    phi: Array,
    sigma: Array,
    nees: Array,
    stale: Array,
    resets: Array,
    stopped: Array,
) -> dict[str, Any]:
    event_s, acquire_s, end_s = times_s
    rows = []
    for c, (azimuth, has_detector, gate) in enumerate(CONFIGS):
        for e, name in enumerate(EVENTS):
            at = {
                key: [
                    float(root_mean_square(phi[second - 1, c, e, :, 2]) / ARCMIN),
                    float(root_mean_square(sigma[second - 1, c, e, :, 2]) / ARCMIN),
                ]
                for key, second in (("before", event_s), ("after", acquire_s - 1), ("end", end_s))
            }
            late = phi[event_s + LENGTH_S : acquire_s - 1, c, e]
            wrong = np.abs(phi[acquire_s - 2, c, e, :, 2]) > 4 * sigma[acquire_s - 2, c, e, :, 2]
            rows.append(
                {
                    "event": name,
                    "azimuth": azimuth,
                    "detector": has_detector,
                    "gate": gate,
                    **{f"{key}_arcmin": value for key, value in at.items()},
                    "level_arcmin": float(root_mean_square(late[..., :2].ravel()) / ARCMIN),
                    "level_largest_arcmin": float(np.abs(late[..., :2]).max() / ARCMIN),
                    "stopped_s": float(stopped[c, e].mean()),
                    "stale": int(stale[c, e].sum()),
                    "resets": float(resets[c, e].mean()),
                    "nees": float(nees[c, e].mean()),
                    "silent": int((wrong & ~stale[c, e]).sum()),
                }
            )
    return {
        "study": "azimuth-shock",
        "runs": runs,
        "seed": seed,
        "event_s": event_s,
        "acquire_s": acquire_s,
        "end_s": end_s,
        "events": EVENTS,
        "rows": rows,
        "axes": list(AXES),
        "modes": list(SHOWN),
        "histories": histories(phi, sigma),
    }


def histories(phi: Array, sigma: Array) -> dict[str, Any]:
    """In the place of the paper's Figures 6 and 7, which show one shock: that, and a turn."""
    out: dict[str, Any] = {"time_s": np.arange(1, len(phi) + 1).tolist()}
    for name, (happens, guarded) in SHOWN.items():
        c, e = CONFIGS.index(("white", guarded, guarded)), list(EVENTS).index(happens)
        error = phi[:, c, e] / ARCMIN
        out[name] = {
            "error_arcmin": nulls(np.moveaxis(error[:, :3], 1, 0)),
            "rms_arcmin": nulls(root_mean_square(error, 1)),
            "sigma_arcmin": (root_mean_square(sigma[:, c, e], 1) / ARCMIN).round(4).tolist(),
        }
    return out


def nulls(values: Array) -> Any:
    """Lists for JSON, which has no NaN."""
    out = values.round(4).astype(object)
    out[np.isnan(values)] = None
    return out.tolist()


def report(result: dict[str, Any]) -> str:
    """One line for each event and configuration, and what was silently wrong."""
    lines = [
        f"azimuth hold disturbed at {result['event_s']} s: error and sigma about up in arcmin, rms of "
        f"{result['runs']} runs, before, at {result['acquire_s']} s and at {result['end_s']} s",
        "event      azimuth detector gate      before          after            end       level, max    stopped "
        "stale silent resets    NEES",
    ]
    for row in sorted(
        result["rows"], key=lambda r: (list(result["events"]).index(r["event"]), r["azimuth"] != "white")
    ):
        times = "  ".join(f"{row[key][0]:6.2f} {row[key][1]:6.2f}" for key in ("before_arcmin", "after_arcmin",
                                                                            "end_arcmin"))  # fmt: skip
        lines.append(
            f"{row['event']:10} {row['azimuth']:7} {'yes' if row['detector'] else '-':8} "
            f"{'yes' if row['gate'] else '-':4} {times}  {row['level_arcmin']:6.2f} {row['level_largest_arcmin']:7.2f}"
            f"  {row['stopped_s']:6.1f} {row['stale']:5} {row['silent']:6} {row['resets']:6.1f} {row['nees']:7.1f}"
        )
    return "\n".join(lines)
