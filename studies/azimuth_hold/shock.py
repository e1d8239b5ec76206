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

import itertools
from dataclasses import dataclass
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.consistency import nees
from boresight.runtime import detector, rotation
from boresight.runtime.array import Array
from boresight.runtime.filter import CompiledFilter
from boresight.runtime.simulation import inertial
from boresight.runtime.status import Status
from boresight.runtime.units import ARCMIN, DEG, MILLI_G
from boresight.studies.azimuth_hold import alignment, figures
from boresight.studies.azimuth_hold.alignment import Aligned, Models, Scenario
from boresight.studies.azimuth_hold.hold import PHI, a_second, carry, root_mean_square, start_filter
from boresight.studies.study import Claim, Progress, Result, Study, claim_lines, option, silent, table

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
TIMES_S = (500, 800)  # the event, the fresh azimuth
GATE, PATIENCE_S, WAIT_S = 4.0, 10, 1
RESET_M_S, RESET_TILT, FRESH_SIGMA = 1.0, 0.5 * DEG, 3 * ARCMIN
WINDOW, FALSE_ALARM = 50, 1e-6  # half a second; of each of four; 35 h of windows that share nothing


def event(models: Models, scenario: Scenario, start: Aligned, name: str) -> tuple[Array, Array, Array]:
    """Ideal dtheta and dv (n, runs, 3) of LENGTH_S seconds, and the attitude after them (runs, 4).

    What is the unit's own error, in the upset, is added to the increments too.
    """
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
    return dtheta, dv, q[-1]


def thresholds(scenario: Scenario, start: Aligned) -> detector.Settings:
    """From the noise of the unit and a rate of false alarms; nothing of it from a filter."""
    dt = 1 / scenario.strapdown_hz
    return detector.settings(
        WINDOW,
        alignment.accel_walk(scenario) / np.sqrt(dt),
        alignment.gyro_walk(scenario) / np.sqrt(dt),
        FALSE_ALARM,
        gravity=start.gravity,
        rest_rate=float(np.linalg.norm(start.earth["omega_ie_n"])) + 4 * scenario.gyro_bias_deg_h * DEG / 3600,
        gravity_error=4 * scenario.accel_bias_mg * MILLI_G + 4e-6 * scenario.accel_scale_ppm * start.gravity,
    )


SHOWN = {"turn_plain": ("turn", False), "turn_guarded": ("turn", True), "shock_guarded": ("shock", True)}
SAYS_MOTION = ("gyro_mean", "gyro_std", "accel_mean", "accel_std")


@dataclass(frozen=True)
class Disturbed(Scenario):
    runs: int = option(5, "Monte Carlo runs of each event and configuration.")
    seconds: int = option(1000, f"At rest; the event comes at {TIMES_S[0]}, a fresh azimuth at {TIMES_S[1]}.")
    times_s: tuple[int, int] = TIMES_S


def run(scenario: Disturbed, progress: Progress = silent, models: Models | None = None) -> Result:
    """The table of what each catches: runs, seed, event_s, acquire_s, end_s, modes (of the history);

    rows: event, azimuth ("white", "state"), detector, gate; before_arcmin (at event_s), after_arcmin (a second before
    acquire_s), end_arcmin: [error rms, sigma] about up; level_arcmin and level_largest_arcmin, rms and largest of both
    level axes from the event to acquire_s; stopped_s: seconds in the 20 from the event on without a velocity update,
    mean over runs; stale: runs in which the filter said that its reference is stale; resets: of velocity and level,
    mean; nees: of the three angles, a second before acquire_s, mean; silent: runs then more than 4 of their own sigmas
    wrong about up, of which the filter said nothing;
    history: time_s, and for turn_plain, turn_guarded and shock_guarded (the azimuth's error white, without and with
    detector and gate): error_arcmin (T, modes, runs, 3), sigma_arcmin (T, modes, 3); what moves during the event is
    left out (nan).
    """
    alignment.checked(scenario)
    models = models or alignment.load_models()
    runs, end_s = scenario.runs, scenario.seconds
    event_s, acquire_s = scenario.times_s
    if not 20 <= event_s < event_s + 25 < acquire_s < end_s:
        raise BoresightError(
            f"azimuth-shock needs 20 s before the event, 26 s from it to the fresh azimuth, and an end after that; "
            f"got {event_s}, {acquire_s} and {end_s} s"
        )
    start = alignment.align(models, scenario, runs=runs, seed=scenario.seed)
    names, events, configs = list(EVENTS), len(EVENTS), len(CONFIGS)
    flown = zip(*(event(models, scenario, start, name) for name in names), strict=True)
    moved_dtheta, moved_dv, q_after = (np.stack(part, axis=-3) for part in flown)
    shape = (configs, events, runs)
    ways, has_detector, has_gate = (np.array(part)[:, None, None] for part in zip(*CONFIGS, strict=True))
    white, gate = ways == "white", np.where(has_gate, GATE, np.inf)
    loop, R_azimuth = start_filter(models, start, np.broadcast_to(~white[..., 0], (configs, events)))
    q_ref = loop.nav["q_b2n_wxyz"].copy()

    hz, dt = scenario.strapdown_hz, 1 / scenario.strapdown_hz
    sensors = start.drawn.sensors
    settings, dll = thresholds(scenario, start), detector.library()
    R_zupt = np.full(3, scenario.zupt_sigma_m_s**2)
    epoch = a_second(loop, hz, alignment.rest_noise(scenario))
    q_true = np.broadcast_to(start.q_b2n_wxyz, (events, runs, 4)).copy()
    kept, before, tail = [], None, [np.empty((events, runs, 0, 3))] * 2
    quiet = np.full((events, runs), WAIT_S)
    rejected_azimuth, rejected_zupt = np.zeros(shape, int), np.zeros(shape, int)
    stale, resets, stopped = np.zeros(shape, bool), np.zeros(shape, int), np.zeros(shape, int)
    generator = np.random.default_rng([scenario.seed, 77])

    for second in range(1, end_s + 1):
        k = second - 1 - event_s
        in_event = 0 <= k < LENGTH_S
        if k == LENGTH_S:
            q_true = q_after
        C = rotation.matrix_from_quaternion(q_true)
        if in_event:
            part = slice(k * hz, (k + 1) * hz)
            ideal = moved_dtheta[part], moved_dv[part]
        else:
            at_rest = (np.einsum("erji,j->eri", C, start.earth[name]) * dt for name in ("omega_ie_n", "gravity_n"))
            omega, gravity = (np.broadcast_to(one, (hz, *one.shape)) for one in at_rest)
            ideal = omega, -gravity
        raw_dtheta, raw_dv = sensors.measured(*ideal, dt, hz)
        # The detector's windows reach back into the second before.
        seen = [
            np.concatenate([past, np.moveaxis(raw / dt, 0, -2)], -2)
            for past, raw in zip(tail, (raw_dtheta, raw_dv), strict=True)
        ]
        detected = detector.evaluate(settings, seen[0], seen[1], dll=dll)
        tail = [one[..., -(WINDOW - 1) :, :] for one in seen]
        full = detected.status == Status.OK
        moving = (full & ~detected.rest_by(*SAYS_MOTION)).any(-1)
        quiet = np.where(moving, 0, quiet + 1)
        rest = (quiet > WAIT_S)[None] | ~has_detector

        before = carry(epoch, raw_dtheta[:, None], raw_dv[:, None], before)

        zupt_rows = gated(loop, "zupt", R_zupt, rest, gate)
        loop.update("zupt", R_zupt, rows=zupt_rows[..., None])
        rejected_zupt = np.where(rest & ~zupt_rows, rejected_zupt + 1, 0)
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
            weighed = nees(rotation.attitude_error(loop.nav["q_b2n_wxyz"], q_true), loop.P[..., PHI, PHI])
        if second == acquire_s:
            said_stale = stale.copy()
            error = FRESH_SIGMA * generator.standard_normal(runs)
            q_fresh = rotation.turned(q_true, np.einsum("erji,j->eri", C, [0.0, 0.0, 1.0]) * error[:, None])
            acquire(loop, q_ref, q_fresh, stale, white)
            R_azimuth = np.where((stale & white)[..., None], FRESH_SIGMA**2, R_azimuth)
            rejected_azimuth[stale], stale = 0, np.zeros(shape, bool)
        phi_now = rotation.attitude_error(loop.nav["q_b2n_wxyz"], q_true)
        # During the event the platform moves: the truth of these seconds is not kept
        sigma = np.sqrt(np.einsum("...ii->...i", loop.P)[..., PHI])
        kept.append((np.where(in_event, np.nan, phi_now), sigma))
        if second % 200 == 0:
            progress(f"{second} of {end_s} s")
    phi, sigma = (np.array(part) for part in zip(*kept, strict=True))
    kinds = [(CONFIGS.index(("white", guard, guard)), names.index(happens)) for happens, guard in SHOWN.values()]
    return {
        "runs": runs,
        "seed": scenario.seed,
        "event_s": event_s,
        "acquire_s": acquire_s,
        "end_s": end_s,
        "modes": list(SHOWN),
        "rows": rows_of((event_s, acquire_s, end_s), phi, sigma, weighed, said_stale, resets, stopped),
        "history": {
            "time_s": np.arange(1, end_s + 1),
            "error_arcmin": np.stack([phi[:, c, e] for c, e in kinds], axis=1) / ARCMIN,
            "sigma_arcmin": np.stack([root_mean_square(sigma[:, c, e], 1) for c, e in kinds], axis=1) / ARCMIN,
        },
    }


def gated(loop: CompiledFilter, name: str, R: Array, wanted: Array, gate: Array, **inputs: Any) -> Array:
    """(...,) bool: runs whose every row lies within the gate, by itself; all rows or none are taken."""
    z, H = loop.call(f"{name}_z", **inputs), loop.call(f"{name}_H", **inputs)
    S = np.einsum("...ij,...jk,...ik->...i", H, loop.P, H) + R
    return wanted & (z**2 <= gate[..., None] ** 2 * S).all(-1)


def give_up(loop: CompiledFilter, z: Array, now: Array) -> None:
    """The reference is stale: what the azimuth may be wrong by is what it and the reference differ by."""
    loop.P[..., 8, 8] += np.where(now, z**2, 0.0)


def reset(loop: CompiledFilter, now: Array) -> None:
    """Velocity and level begin anew; what they knew of other states goes with them."""
    for state, sigma in ((3, RESET_M_S), (4, RESET_M_S), (5, RESET_M_S), (6, RESET_TILT), (7, RESET_TILT)):
        row = np.where(now[..., None], 0.0, loop.P[..., state, :])
        loop.P[..., state, :] = row
        loop.P[..., :, state] = row
        loop.P[..., state, state] = np.where(now, sigma**2, row[..., state])


def acquire(loop: CompiledFilter, q_ref: Array, q_fresh: Array, now: Array, white: Array) -> None:
    """A new reference, in error by itself and by nothing that the filter knows."""
    q_ref[now] = np.broadcast_to(q_fresh, q_ref.shape)[now]
    loop.nav["reference_error"][now] = 0.0
    loop.P[..., 15, :] = np.where(now[..., None], 0.0, loop.P[..., 15, :])
    loop.P[..., :, 15] = np.where(now[..., None], 0.0, loop.P[..., :, 15])
    loop.P[..., 15, 15] = np.where(now & ~white, FRESH_SIGMA**2, loop.P[..., 15, 15])


def rows_of(
    times_s: tuple[int, int, int], phi: Array, sigma: Array, weighed: Array, stale: Array, resets: Array, stopped: Array
) -> list[dict[str, Any]]:
    event_s, acquire_s, end_s = times_s
    rows = []
    for (e, name), (c, config) in itertools.product(enumerate(EVENTS), enumerate(CONFIGS)):
        late = phi[event_s + LENGTH_S : acquire_s - 1, c, e, :, :2] / ARCMIN
        wrong = np.abs(phi[acquire_s - 2, c, e, :, 2]) > 4 * sigma[acquire_s - 2, c, e, :, 2]
        row = {"event": name, **dict(zip(("azimuth", "detector", "gate"), config, strict=True))}
        for key, second in (("before", event_s), ("after", acquire_s - 1), ("end", end_s)):
            both = (root_mean_square(part[second - 1, c, e, :, 2]) / ARCMIN for part in (phi, sigma))
            row[f"{key}_arcmin"] = [float(value) for value in both]
        rows.append(row | {
            "level_arcmin": float(root_mean_square(late.ravel())),
            "level_largest_arcmin": float(np.abs(late).max()),
            "stopped_s": float(stopped[c, e].mean()),
            "stale": int(stale[c, e].sum()),
            "silent": int((wrong & ~stale[c, e]).sum()),
            "resets": float(resets[c, e].mean()),
            "nees": float(weighed[c, e].mean()),
        })  # fmt: skip
    return rows


def claims(result: Result) -> list[Claim]:
    """That a turned platform is pulled back silently without the gate, and that with it none is."""
    moved = [row for row in result["rows"] if row["event"] in ("turn", "upset")]
    silent = {gate: sum(row["silent"] for row in moved if row["gate"] == gate) for gate in (False, True)}
    stopped = [row["stopped_s"] for row in result["rows"] if row["detector"] and row["event"] != "none"]
    turned = [row for row in result["rows"] if row["event"] == "turn" and row["gate"]]
    return [
        Claim("the detector stops the updates in every event", min(stopped) > 0, {"least, s": min(stopped)}),
        Claim("after a turn or an upset some runs are silently wrong without the gate", silent[False] > 0,
              {"runs": silent[False]}),
        Claim("and none with it", silent[True] == 0, {"runs": silent[True]}),
        Claim("with the gate every turn is called stale", all(row["stale"] == result["runs"] for row in turned),
              {"error after 300 s, arcmin": max(row["after_arcmin"][0] for row in turned)}),
    ]  # fmt: skip


def report(result: Result) -> str:
    """One line for each event and configuration, and what was silently wrong."""
    head = ("event", "azimuth", "detector", "gate", "before", "after", "end", "level", "max", "stopped", "stale",
            "silent", "resets", "NEES")  # fmt: skip
    return "\n".join([
        f"azimuth hold disturbed at {result['event_s']} s: error and sigma about up in arcmin, rms of "
        f"{result['runs']} runs, before, at {result['acquire_s']} s and at {result['end_s']} s",
        *table(head, [list(row.values()) for row in result["rows"]],
               [*[""] * 4, *[".2f"] * 5, ".1f", "d", "d", ".1f", ".1f"]),
        "",
        *claim_lines(claims(result)),
    ])  # fmt: skip


STUDY = Study("azimuth-shock", alignment.MODELS, Disturbed, run, report, figures.draw_shock, claims)
