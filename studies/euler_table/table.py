"""Table 1 of Song and Lee (2001): which attitude error can be estimated from which Euler angle under which motion.

49 cases, 7 matchings by 7 motions, and in each the three components of the slave's attitude error: 147 cells.  Each is
judged twice, by one criterion under one motion: (a) from the filter's covariance with H along the true motion, and
(b) from the errors of the closed loop over many runs.  docs/euler-matching.md says what the paper leaves open.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.consistency import nees
from boresight.analysis.observability import Moment, Replaced, along, taken_over, with_fields
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.filter import Filter
from boresight.runtime.library import load
from boresight.runtime.simulation import sensors
from boresight.runtime.units import ARCMIN, DEG
from boresight.studies.euler_table import figures
from boresight.studies.study import Claim, Progress, Result, Seeded, Study, claim_lines, option, silent, table

ANGLES = ("roll", "pitch", "yaw")
ERRORS = ("eps_n", "eps_e", "eps_d")
COMBINATIONS = ((0,), (1,), (2,), (0, 1), (0, 2), (1, 2), (0, 1, 2))  # the paper's order, of matchings and of motions
NAMES = tuple(", ".join(ANGLES[i] for i in chosen) for chosen in COMBINATIONS)
CHOSEN = np.array([[i in chosen for i in range(3)] for chosen in COMBINATIONS])  # (7, 3) bool

PAPER = np.array(
    [
        [[letter == "O" for letter in case] for case in row.split()]
        for row in (  # rows: matching; columns: motion; letters: eps_n eps_e eps_d, O where it can be estimated
            "XXX XXO XOX XXO XOX XOO XOO",
            "XXO XXX OXX XXO OXO OXX OXO",
            "XOX OXX XXX OOX XOX OXX OOX",
            "XXO XXO OOX XXO OOO OOO OOO",
            "XOX OXO XOX OOO XOX OOO OOO",
            "XOO OXX OXX OOO OOO OXX OOO",
            "XOO OXO OOX OOO OOO OOO OOO",
        )
    ]
)


@dataclass(frozen=True)
class Scenario(Seeded):
    """The one motion, the one filter and the one criterion of all 147 cells."""

    seconds: float = option(120.0, "Length of a run.")
    switch: tuple[str, ...] = option((), "A change of the declared scenario; may be repeated.")
    # The paper's: "sinusoidal motion of 2 to 3 degrees", 1 deg/h, 1 arcmin, 3 degrees, 1 s.
    motion_amplitude_deg: tuple[float, float, float] = (2.5, 2.5, 2.5)
    gyro_bias_deg_h: float = 1.0  # constant in a run, N(0, this) on each axis; sets the filter's Q too
    angle_noise_arcmin: float = 1.0  # the master's, white from update to update
    misalignment_deg: float = 3.0
    update_s: float = 1.0
    # Open in the paper: chosen here.
    misalignment: str = "signs"  # "signs": plus or minus 3 degrees on each axis; "normal": N(0, 3 degrees)
    motion_period_s: tuple[float, float, float] = (7.0, 5.0, 9.0)
    motion_phase_deg: tuple[float, float, float] = (0.0, 0.0, 0.0)
    heading_deg: float = 0.0
    latitude_deg: float = 36.0
    earth_rate: bool = True
    strapdown_s: float = 0.1
    prior: str = "from-master"  # the slave starts from the master's attitude; or "independent"
    # What the filter is told.  The paper's first-order (18) is wrong by 5 arcmin at 3 degrees, almost constant in time.
    filter_angle_arcmin: float = 3.0  # R: the master's noise, and what second order adds to it
    filter_offset_arcmin: float = 10.0  # P0: the master's noise at the start, and the constant part of second order
    bias_time_s: float = 120.0  # Q: white noise that has drifted as far as the bias after this time
    measurement: str = "euler"  # or "euler_exact", relinearised `iterations` times
    iterations: int = 1
    turn_covariance: bool = False  # after a feedback, carry P to the corrected attitude: beyond the paper
    # The criterion: an error is estimated once it, or its sigma, has fallen below this part of what it was at first.
    threshold: float = 1 / 3
    error_axes: str = "ned"  # or "platform": level axes along the master's mean heading


def as_printed_25(model: Any) -> Replaced:
    """(25) as printed: mu + dmu, where error = computed - true asks for mu - dmu."""

    def feedback(q_b2n_wxyz: Array, mu: Array, x: Array) -> dict[str, Array]:
        right = model.feedback(q_b2n_wxyz=q_b2n_wxyz, mu=mu, x=x)
        return {**right, "mu": np.asarray(mu) + x[..., 3:]}

    return Replaced(model, {"feedback": with_fields(feedback, "q_b2n_wxyz", "mu", "x")})


def as_printed_26(model: Any) -> Replaced:
    """(26) to (28) as printed, and (8), (9) with them: phi_b in the place of psi_b.

    The slave's half of H holds only psi_b and theta_b, so that H at (phi, theta, phi) is the printed matrix.
    """

    def euler_H(euler_b: Array, euler_m: Array) -> Array:
        return model.euler_H(euler_b=np.asarray(euler_b)[..., [0, 1, 0]], euler_m=euler_m)

    return Replaced(model, {"euler_H": with_fields(euler_H, "euler_b", "euler_m")})


@dataclass(frozen=True)
class Switch:
    """One departure from the declared scenario."""

    says: str
    changes: dict[str, Any] = field(default_factory=dict)
    model: Callable[[Any], Any] | None = None


SWITCHES = {
    "independent-prior": Switch("P0 does not know that the slave started from the master", {"prior": "independent"}),
    "in-phase": Switch("roll, pitch and yaw move with one period and phase", {"motion_period_s": (7.0, 7.0, 7.0)}),
    "as-printed-25": Switch("(25) as printed, mu + dmu", model=as_printed_25),
    "as-printed-26-28": Switch("(26) to (28) as printed, and (8), (9): phi_b for psi_b", model=as_printed_26),
    "heading-60": Switch("the master heads 60 degrees east of north", {"heading_deg": 60.0}),
    "platform-axes": Switch("errors in level axes along the master's heading", {"error_axes": "platform"}),
    "text-noises": Switch(
        "the filter is told 1 arcmin, as the text says", {"filter_angle_arcmin": 1.0, "filter_offset_arcmin": 1.0}
    ),
    "normal-misalignment": Switch("misalignments of N(0, 3 degrees) an axis", {"misalignment": "normal"}),
    "no-bias": Switch("no gyro bias, and Q = 0", {"gyro_bias_deg_h": 0.0}),
    "no-earth-rate": Switch("the Earth stands still", {"earth_rate": False}),
    "amplitude-2": Switch("motion of 2 degrees", {"motion_amplitude_deg": (2.0, 2.0, 2.0)}),
    "amplitude-3": Switch("motion of 3 degrees", {"motion_amplitude_deg": (3.0, 3.0, 3.0)}),
    "exact": Switch(
        "exact residual, H re-evaluated, P carried through the feedback",
        {"measurement": "euler_exact", "iterations": 3, "turn_covariance": True},
    ),
}


def switched(model: Any, scenario: Scenario, switches: Sequence[str]) -> tuple[Any, Scenario]:
    """Model and scenario under the named switches, in the order given.  Raises BoresightError for an unknown name."""
    for name in switches:
        if name not in SWITCHES:
            raise BoresightError(f"no switch {name!r} in euler-table; there are: {', '.join(SWITCHES)}")
        switch = SWITCHES[name]
        scenario = replace(scenario, **switch.changes)
        model = switch.model(model) if switch.model else model
    return model, scenario


# ---- truth and filter, common to (a) and (b)


def motion(scenario: Scenario, seconds: float, step_s: float) -> Array:
    """The master's true Euler angles, (T+1, 7 motions, 3) rad."""
    sinusoids = sensors.Sinusoids(
        amplitude=CHOSEN * np.array(scenario.motion_amplitude_deg) * DEG,
        period=np.array(scenario.motion_period_s),
        phase=np.array(scenario.motion_phase_deg) * DEG,
        mean=np.array([0.0, 0.0, scenario.heading_deg]) * DEG,
    )
    return sinusoids.euler(np.arange(round(seconds / step_s) + 1) * step_s)


def earth_rate(scenario: Scenario) -> Array:
    return sensors.earth_rate_n(scenario.latitude_deg * DEG) * scenario.earth_rate


def gyro_noise(scenario: Scenario) -> Array:
    """Root PSD, (3,) rad/sqrt(s), of the white noise that stands for the bias: b^2 t^2 = q t at t = bias_time_s."""
    return np.full(3, scenario.gyro_bias_deg_h * DEG / 3600 * np.sqrt(scenario.bias_time_s))


def initial_covariance(model: Any, scenario: Scenario, euler: Array) -> Array:
    """P0 (..., 6, 6) of the scenario: `first_covariance`, or the same without the tie of eps and dmu."""
    noise = np.full(3, scenario.filter_offset_arcmin * ARCMIN)
    P = first_covariance(model, euler, scenario.misalignment_deg * DEG, noise)
    if scenario.prior == "independent":
        P[..., :3, 3:] = P[..., 3:, :3] = 0.0
    return P


def first_covariance(model: Any, euler: Array, misalignment: float, angle_noise: Array) -> Array:
    """P0 (..., 6, 6): eps = -C dmu, plus the master's noise (..., 3) rad, which keeps it positive definite.

    euler: (..., 3) rad, the master's.  The noise is mapped to eps by the inverse of (9).
    """
    P = taken_over(rotation.matrix_from_euler(euler), misalignment)
    eps_D_euler = np.linalg.inv(model.euler_H(euler_b=euler, euler_m=euler)[..., :3])
    noise = (eps_D_euler * angle_noise[..., None, :] ** 2) @ np.swapaxes(eps_D_euler, -1, -2)
    P = P + np.zeros((*noise.shape[:-2], 6, 6))
    P[..., :3, :3] += noise
    return P


def to_error_axes(scenario: Scenario) -> Array:
    """(3, 3): from n, e, d to the axes in which the cells are read."""
    if scenario.error_axes == "ned":
        return np.eye(3)
    return rotation.matrix_from_vector(np.array([0.0, 0.0, -scenario.heading_deg]) * DEG)


def sigmas(P: Array, axes: Array) -> Array:
    """(..., 3) rad, of eps in the given axes."""
    return np.sqrt(np.maximum(np.einsum("ij,...jk,ik->...i", axes, P[..., :3, :3], axes), 0.0))


# ---- (a)


def covariance(model: Any, scenario: Scenario, seconds: float, *, first_order: bool = False) -> Array:
    """Sigma of eps, (T+1, 7 matchings, 7 motions, 3) rad: the filter's covariance with H along the true motion.

    Deterministic.  first_order: H with only the first power of the motion, to see what the higher ones add.
    """
    euler = motion(scenario, seconds, scenario.update_s)
    q = rotation.quaternion_from_euler(euler)
    H = model.euler_H(euler_b=euler, euler_m=euler)
    if first_order:
        mean, part = np.array([0.0, 0.0, scenario.heading_deg]) * DEG, 1e-3
        ahead, back = ((mean + part * sign * (euler - mean)) for sign in (1, -1))
        H_ahead, H_back = (model.euler_H(euler_b=at, euler_m=at) for at in (ahead, back))
        H = model.euler_H(euler_b=mean, euler_m=mean) + (H_ahead - H_back) / (2 * part)

    # over 7 motions beside the 7 matchings, whose covariances differ
    P0 = np.tile(initial_covariance(model, scenario, euler[0]), (7, 1, 1, 1))
    R, axes = np.full(3, (scenario.filter_angle_arcmin * ARCMIN) ** 2), to_error_axes(scenario)
    given = {"omega_in_n": earth_rate(scenario), "gyro_noise": gyro_noise(scenario), "dt": scenario.update_s}
    moments = (
        Moment({**given, "q_b2n_wxyz": q[instant - 1]}, H[instant], R, CHOSEN[:, None, :])
        for instant in range(1, len(euler))
    )
    history = [sigmas(P0, axes)] + [sigmas(P, axes) for P in along(model, P0, moments)]
    return np.array(history)


# ---- (b)


@dataclass(frozen=True)
class Flight:
    """Closed loops of 7 matchings by 7 motions by runs.  Errors and sigmas in the scenario's error axes."""

    error: Array  # (T+1, 7, 7, runs, 3) rad, eps
    sigma: Array  # (T+1, 7, 7, runs, 3) rad, the filter's own
    nees: Array  # (7, 7, runs) at the end, of all six states
    nis: Array  # (T, 7, 7, runs)
    lost: Array  # (7, 7, runs) bool: left the model's box; the error stays at its last value


def fly(model: Any, scenario: Scenario, seconds: float, *, runs: int, seed: int, first_run: int = 0) -> Flight:
    """The whole loop: gyros, strapdown, filter, feedback, each run with its own misalignment, bias and noise.

    A run's numbers are keyed by [seed, 49 run + case], whatever runs are flown beside it.
    """
    euler = motion(scenario, seconds, scenario.strapdown_s)
    q_m = rotation.quaternion_from_euler(euler)
    omega_in_n, axes = earth_rate(scenario), to_error_axes(scenario)
    increments = rotation.body_increments(q_m, omega_in_n, scenario.strapdown_s)
    every = round(scenario.update_s / scenario.strapdown_s)
    updates = len(increments) // every

    key = 49 * np.arange(first_run, first_run + runs) + np.arange(49).reshape(7, 7, 1)
    draws = sensors.standard_normals(seed, key, 6 + 3 * (updates + 1))
    unit = draws[..., :3] if scenario.misalignment == "normal" else np.where(draws[..., :3] < 0, -1.0, 1.0)
    mu = unit * scenario.misalignment_deg * DEG
    drift = draws[..., 3:6] * scenario.gyro_bias_deg_h * DEG / 3600 * scenario.strapdown_s
    noise = draws[..., 6:].reshape(*mu.shape[:-1], updates + 1, 3) * scenario.angle_noise_arcmin * ARCMIN

    P0 = np.broadcast_to(initial_covariance(model, scenario, euler[0])[:, None], (*mu.shape[:-1], 6, 6))
    q_start = rotation.quaternion_from_euler(euler[0][:, None] + noise[..., 0, :])
    loop = Filter(model, {"q_b2n_wxyz": q_start, "mu": np.zeros_like(mu)}, P0)
    rows, R = CHOSEN[:, None, None, :], np.full(3, (scenario.filter_angle_arcmin * ARCMIN) ** 2)
    lost = np.zeros(mu.shape[:-1], bool)
    error: list[Array] = []
    sigma: list[Array] = []
    nis: list[Array] = []

    def state_error(sample: int) -> Array:
        q_b = rotation.turned(q_m[sample][:, None], mu)
        return np.concatenate([rotation.attitude_error(loop.nav["q_b2n_wxyz"], q_b), loop.nav["mu"] - mu], axis=-1)

    def keep(sample: int) -> Array:
        now = state_error(sample)
        eps = now[..., :3] @ axes.T
        error.append(np.where(lost[..., None], error[-1], eps) if error else eps)
        sigma.append(sigmas(loop.P, axes))
        return now

    def lose(sample: int) -> None:
        lost[out_of_box(loop)] = True
        if lost.any():  # a lost run waits at rest on the truth, so that the others can go on
            loop.nav["q_b2n_wxyz"][lost] = rotation.turned(q_m[sample][:, None], mu)[lost]
            loop.nav["mu"][lost], loop.x[lost], loop.P[lost] = 0.0, 0.0, P0[lost]

    keep(0)
    for k in range(1, updates + 1):
        turns = increments[(k - 1) * every : k * every, None, :, None]
        for dtheta in sensors.mounted(turns, mu) + drift:
            loop.strapdown(dtheta_ib_b=dtheta, omega_in_n=omega_in_n, dt=scenario.strapdown_s)
        loop.predict(omega_in_n=omega_in_n, gyro_noise=gyro_noise(scenario), dt=scenario.update_s)
        euler_b = loop.call("euler_angles")
        # An angle that is not matched is not known of the master: the slave's own stands in, as below (28).
        euler_m = np.where(rows, euler[k * every][:, None] + noise[..., k, :], euler_b)
        innovation = loop.update(
            scenario.measurement, R, rows=rows, iterations=scenario.iterations, euler_b=euler_b, euler_m=euler_m
        )
        lose(k * every)
        if scenario.turn_covariance:
            turn_covariance(loop)
        loop.feedback()
        nis.append(innovation.nis)
        full = keep(k * every)
        lose(k * every)
    return Flight(np.array(error), np.array(sigma), nees(full, loop.P), np.array(nis), lost)


def out_of_box(loop: Filter) -> Array:
    """(...,) bool: runs whose estimate is not finite or has left the model's box (0.5 rad; a pitch of 80 degrees)."""
    angles = np.concatenate([loop.nav["mu"], loop.x], axis=-1)
    finite = np.isfinite(angles).all(-1) & np.isfinite(loop.P).all((-1, -2))
    sin_pitch = rotation.matrix_from_quaternion(loop.nav["q_b2n_wxyz"])[..., 2, 0]
    return ~finite | (np.abs(angles) > 0.5).any(-1) | (np.abs(sin_pitch) > np.sin(80 * DEG))


def turn_covariance(loop: Filter) -> None:
    """Carry P from the attitude before the feedback to the one after it.

    With eps = x + d, exp([x x]) exp(-[eps x]) = exp(-[J d x]) to first order in d, where J is the left Jacobian of x:
    the correction x need not be small.  The paper, like most, leaves J out; at 3 degrees it matters.
    """
    x = loop.x[..., :3]
    angle = np.maximum(np.linalg.norm(x, axis=-1), 1e-6)[..., None, None]  # the limits 1/2 and 1/6, to 1e-13
    X = np.cross(x[..., None, :], np.eye(3)).swapaxes(-1, -2)  # [x x]
    J = np.eye(3) + (1 - np.cos(angle)) / angle**2 * X + (angle - np.sin(angle)) / angle**3 * X @ X
    loop.P[..., :3, :] = J @ loop.P[..., :3, :]
    loop.P[..., :, :3] = loop.P[..., :, :3] @ J.swapaxes(-1, -2)


# ---- the study


def ratios(history: Array) -> Array:
    """(7, 7, 3): the last over the first, of sigmas (T+1, 7, 7, 3) or of the rms over runs (T+1, 7, 7, runs, 3)."""
    first, last = history[0], history[-1]
    if history.ndim == 5:
        first, last = (np.sqrt(np.mean(np.square(part), axis=-2)) for part in (first, last))
    return last / first


def judged(ratio: Array, threshold: float) -> dict[str, Any]:
    """Agreement with the paper: cells out of 147, and how far the nearest stands from the threshold."""
    factor = np.where(PAPER, threshold / ratio, ratio / threshold)  # above 1: on the paper's side
    nearest = np.unravel_index(np.argmin(factor), factor.shape)
    return {
        "agree": int(np.sum((ratio < threshold) == PAPER)),
        "margin": {"factor": float(factor[nearest]), "cell": cell_name(nearest), "ratio": float(ratio[nearest])},
        "largest_estimated": float(ratio[PAPER].max()),
        "smallest_not_estimated": float(ratio[~PAPER].min()),
        "disagree": [cell_name(cell) for cell in np.argwhere((ratio < threshold) != PAPER)],
        "ratio": ratio.tolist(),
    }


def cell_name(cell: Any) -> str:
    i, j, k = (int(part) for part in cell)
    return f"{NAMES[i]} match; {NAMES[j]} motion; {ERRORS[k]}"


def run(scenario: Scenario, progress: Progress = silent, model: Any = None) -> Result:
    """Table 1 twice: cells (147), runs, seconds, threshold, lost_runs;

    matchings, motions, errors: the names along the three axes of each table; paper: (7, 7, 3) bool;
    linear, monte_carlo: agree (cells out of 147), margin (of the nearest cell: factor from the threshold, above 1 on
    the paper's side; its name and ratio), largest_estimated and smallest_not_estimated (the extreme ratios of the
    paper's two kinds), disagree (names), ratio (7, 7, 3); of monte_carlo also claimed, by the filter's sigmas.
    history: of the nine cases of Figures 2 to 10, (T+1, 3 matchings, 3 motions, ...).
    """
    runs, seconds = scenario.runs, scenario.seconds
    if runs < 1 or not np.isfinite(seconds) or seconds < 2:
        raise BoresightError(f"euler-table needs at least 1 run and 2 seconds; got {runs} runs, {seconds} seconds")
    model, scenario = switched(model or load("euler-matching"), scenario, scenario.switch)
    progress("linear covariance")
    linear = covariance(model, scenario, seconds)
    progress(f"Monte Carlo: 49 cases of {runs} runs, {seconds:g} s")
    flight = fly(model, scenario, seconds, runs=runs, seed=scenario.seed)
    error, sigma = flight.error[:, :3, :3] / DEG, flight.sigma[:, :3, :3] / DEG
    return {
        "cells": PAPER.size,
        "runs": runs,
        "seed": scenario.seed,
        "seconds": seconds,
        "switches": list(scenario.switch),
        "threshold": scenario.threshold,
        "matchings": list(NAMES),
        "motions": list(NAMES),
        "errors": list(ERRORS),
        "paper": PAPER.tolist(),
        "lost_runs": int(flight.lost.sum()),
        "linear": judged(ratios(linear), scenario.threshold),
        "monte_carlo": {
            **judged(ratios(flight.error), scenario.threshold),
            "claimed": ratios(flight.sigma).tolist(),
        },
        "history": {
            "time_s": np.arange(len(error)) * scenario.update_s,
            "error_deg": error[..., :3, :],
            "rms_deg": np.sqrt(np.mean(error**2, axis=-2)),
            "sigma_deg": np.sqrt(np.mean(sigma**2, axis=-2)),
            "linear_sigma_deg": linear[:, :3, :3] / DEG,
        },
    }


def claims(result: Result) -> list[Claim]:
    """That the table is the paper's, twice, and that the filter's own sigma is no witness."""
    out = []
    for part, says in (("linear", "by linear covariance"), ("monte_carlo", "by Monte Carlo")):
        got = result[part]
        numbers = {"cells": got["agree"], "nearest cell, factor": got["margin"]["factor"]}
        numbers |= {name.replace("_", " "): got[name] for name in ("largest_estimated", "smallest_not_estimated")}
        out.append(Claim(f"all 147 cells are as in the paper {says}", got["agree"] == result["cells"], numbers))
    claimed = (np.array(result["monte_carlo"]["claimed"]) < result["threshold"]) & ~np.array(result["paper"])
    says = "the filter's sigma calls estimated what the paper calls not estimable"
    return [*out, Claim(says, bool(claimed.any()), {"cells": float(claimed.sum())})]


def report(result: Result) -> str:
    """The paper's table, the cells of (a) and (b) that disagree with it, and the claims."""
    lines = [
        "Table 1 of Song and Lee (2001): O where eps_n, eps_e, eps_d can be estimated,",
        "x where not.  A row is named by the angles matched, a column by those that move.",
    ]
    short = ["".join(angle[0] for angle in name.split(", ")) for name in NAMES]
    cells = [["".join("xO"[int(k)] for k in case) for case in row] for row in result["paper"]]
    lines += table(("", *short), [(name, *row) for name, row in zip(NAMES, cells, strict=True)])
    lines += ["", f"{result['runs']} runs of {result['seconds']:g} s, seed {result['seed']}"]
    for part in ("linear", "monte_carlo"):
        got = result[part]
        lines.append(f"  {part.replace('_', ' ')}: nearest to {result['threshold']:.3f} is {got['margin']['cell']}")
        lines += [f"    differs from the paper: {cell}" for cell in got["disagree"][:12]]
        if len(got["disagree"]) > 12:
            lines.append(f"    ... and {len(got['disagree']) - 12} more")
    if result["lost_runs"]:
        lines.append(f"  {result['lost_runs']} of {49 * result['runs']} runs left the model's box")
    if result["switches"]:
        lines.append(f"  flown with {', '.join(result['switches'])}")
    return "\n".join([*lines, *claim_lines(claims(result))])


STUDY = Study(
    "euler-table", ("euler-matching",), Scenario, run, report, figures.draw, claims,
    good=lambda result: all(claim.holds for claim in claims(result)[:2]),
)  # fmt: skip
