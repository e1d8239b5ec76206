"""What a record loop did, beside the truth and beside what the data can tell."""

from dataclasses import dataclass, field

import numpy as np
from scipy.stats import chi2
from simulator import (
    Flight,
    derivative,
    omega_en_n,
    omega_ie_n,
    radii,
    times,
    turn_between,
)

PHI, DV, GYRO_BIAS, ACCEL_BIAS, MOUNT = (slice(k, k + 3) for k in range(0, 15, 3))
TAU, N = 15, 16


def errors_of(nav, truth):
    """(..., 16) computed - true, in the order of the sixteen states."""
    tau = np.asarray(nav["tau"], float) - truth["tau"]
    return np.concatenate(
        [
            turn_between(nav["q_b2n_wxyz"], np.broadcast_to(truth["q_b2n_wxyz"], np.shape(nav["q_b2n_wxyz"]))),
            nav["v_n"] - truth["v_n"],
            nav["gyro_bias"] - truth["gyro_bias"],
            nav["accel_bias"] - truth["accel_bias"],
            turn_between(nav["q_b2m_wxyz"], np.broadcast_to(truth["q_b2m_wxyz"], np.shape(nav["q_b2m_wxyz"]))),
            tau.reshape(*np.shape(nav["v_n"])[:-1], 1),
        ],
        axis=-1,
    )


@dataclass
class Record:
    """A loop behind each of L messages; what never came is nan and not counted."""

    time: list = field(default_factory=list)  # (L,) s, true
    errors: list = field(default_factory=list)  # (L, runs, 16)
    P: list = field(default_factory=list)  # (L, runs, 16, 16)
    nis: list = field(default_factory=list)  # (L, runs) of the messages taken, else nan
    refused: list = field(default_factory=list)  # (L, runs) how many messages, of
    came: list = field(default_factory=list)  # (L, runs) so many
    notes: list = field(default_factory=list)  # (s, run or None, code or text)
    raised: str = ""  # what ended it, if anything did

    def append(self, **row):
        for name, value in row.items():
            getattr(self, name).append(value)


def nees(errors, P):
    """(...,) of errors (..., n) by P (..., n, n); nan where P is no covariance."""
    bad = ~(np.isfinite(P).all((-1, -2)) & np.isfinite(errors).all(-1))
    P, errors = np.where(bad[..., None, None], np.eye(P.shape[-1]), P), np.where(bad[..., None], np.nan, errors)
    return np.sum(errors * np.linalg.solve(P, errors[..., None])[..., 0], axis=-1)


def inside(mean, runs):
    """Whether the mean NEES of 16 states, of so many runs at one instant, is as 99.9 % of such means are.

    12.8 to 19.6 of 30 runs.  Means over time as well lie closer to 16.
    """
    low, high = chi2.ppf([0.0005, 0.9995], N * runs) / runs
    return low < mean < high


@dataclass(frozen=True)
class Judged:
    runs: int
    nees: float  # mean of the second half
    nees_end: float  # mean of the last 5 s
    nees_nav: float  # of velocity, attitude and mounting alone, per 9 states, second half
    nis: float  # mean of the messages taken, second half
    refused: float  # share of all that came
    rms: np.ndarray  # (16,) of the last 5 s
    claimed: np.ndarray  # (16,)
    notes: int
    raised: str

    @property
    def consistent(self):
        return not self.raised and inside(self.nees, self.runs)

    def __str__(self):
        phi, tau = slice(0, 3), TAU
        text = f"NEES {self.nees:8.1f} end {self.nees_end:8.1f} NIS {self.nis:7.2f} refused {100 * self.refused:4.1f} %"
        text += f" phi {1e3 * np.sqrt(np.mean(self.rms[phi] ** 2)):6.2f}"
        text += f" ({1e3 * np.sqrt(np.mean(self.claimed[phi] ** 2)):.2f}) mrad"
        text += f" tau {1e3 * self.rms[tau]:6.2f} ({1e3 * self.claimed[tau]:.2f}) ms, {self.notes} notes"
        return text + (f"; {self.raised}" if self.raised else "")


def judged(record: Record, last=None) -> Judged:
    """Of a flight that was to end at `last` s; one that was ended is judged until its end."""
    time = np.array(record.time)
    if not len(time):
        nothing = np.full(N, np.nan)
        return Judged(0, *5 * [np.nan], nothing, nothing, len(record.notes), record.raised or "no message was taken")
    errors, P, nis = (np.array(part) for part in (record.errors, record.P, record.nis))
    refused, came = np.array(record.refused), np.array(record.came)
    last = time[-1] if last is None else last
    half, end = time >= last / 2, time >= time[-1] - 5
    half = half if half.any() else end
    keep = [i for i in range(N) if np.nanmax(P[..., i, i]) != 0]
    whole = nees(errors[..., keep], P[..., keep, :][..., keep])
    nav = [*range(6), *range(12, 15)]
    part = nees(errors[half][..., nav], P[half][..., nav, :][..., nav])
    mean_nis = np.nanmean(nis[half]) if np.isfinite(nis[half]).any() else np.nan
    return Judged(
        errors.shape[1],
        whole[half].mean(),
        whole[end].mean(),
        part.mean(),
        mean_nis,
        refused.sum() / came.sum(),
        np.sqrt(np.mean(errors[end] ** 2, axis=(0, 1))),
        np.sqrt(np.mean(np.einsum("...ii->...i", P[end]), axis=(0, 1))),
        len(record.notes),
        record.raised,
    )


# ---- what the data can tell: the covariance of the linear filter, with what is true in F and H


def cross(v):
    """(..., 3) -> (..., 3, 3) of v x."""
    zero = np.zeros(v.shape[:-1])
    x, y, z = np.moveaxis(v, -1, 0)
    return np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-1).reshape(*v.shape, 3)


def system(true, t):
    """F and G (..., 16, 16), (..., 16, 16) of x' = F x + G w: w of gyros, accelerometers, biases, mounting, delay."""
    place, v = true.place_at(t), true.motion.v_n(t)
    C = true.attitude(t)[1]
    f_n, ie, en = times(C, true.rates(t, place)[2]), omega_ie_n(place[..., 0]), omega_en_n(place, v)
    meridian, normal = radii(place[..., 0], place[..., 2])
    by_v = np.zeros((*t.shape, 3, 3))  # of the transport rate
    by_v[..., 0, 1], by_v[..., 1, 0] = 1 / normal, -1 / meridian
    by_v[..., 2, 1] = -np.tan(place[..., 0]) / normal
    F = np.zeros((*t.shape, N, N))
    F[..., PHI, PHI], F[..., PHI, DV], F[..., PHI, GYRO_BIAS] = -cross(ie + en), by_v, C
    F[..., DV, PHI], F[..., DV, ACCEL_BIAS] = cross(f_n), -C
    F[..., DV, DV] = -cross(2 * ie + en) + cross(v) @ by_v
    G = np.zeros((*t.shape, N, 16))
    G[..., PHI, 0:3], G[..., DV, 3:6] = C, C
    G[..., 6:, 6:] = np.eye(10)
    return F, G


def observed(true, t):
    """H (..., 6, 16) of velocity and attitude that are measured at t, with the rates that are true then."""
    place = true.place_at(t)
    C_m2n, C = true.attitude(t)
    omega_ib_b, ie = true.rates(t, place)[0], omega_ie_n(place[..., 0])
    spinning, lever_n = times(C, np.cross(omega_ib_b, true.lever_b)), times(C, true.lever_b)
    rate_nm_n = times(C, omega_ib_b) - ie - omega_en_n(place, true.motion.v_n(t))
    H = np.zeros((*t.shape, 6, N))
    H[..., 0:3, PHI], H[..., 0:3, DV] = cross(ie) @ cross(lever_n) - cross(spinning), np.eye(3)
    H[..., 0:3, GYRO_BIAS] = -C @ cross(true.lever_b)
    H[..., 0:3, TAU] = -derivative(lambda s: true.master(s)[0], t)
    H[..., 3:6, PHI], H[..., 3:6, MOUNT], H[..., 3:6, TAU] = -np.eye(3), C_m2n, -rate_nm_n
    return H


def information(flight: Flight, runs=4):
    """(M,) s, (M, runs, 16) sigmas behind each message, of a filter that knows the true rates.

    Messages are taken at the time that they tell of, in the runs' own order and with their own losses.  Nothing is
    taken for a noise of what F and H are made of, so that no filter that is right can know more.
    """
    setting, true, sent = flight.setting, flight.track, flight.messages
    constants, sigmas = setting.constants(), setting.sigmas()
    W = density(constants)
    start = np.concatenate(
        [
            np.full(3, 10.0),
            np.full(3, 100.0),
            sigmas["gyro_bias"],
            sigmas["accel_bias"],
            sigmas["q_b2m_wxyz"],
            [setting.tau_sigma],
        ]
    )
    out = np.full((*sent.came.shape[:1], runs, N), np.nan)
    for run in range(runs):
        measured = sent.measured[:, run]
        H = observed(true, measured)
        P, now = np.diag(start**2), measured[0]
        for m in np.argsort(measured):
            steps = max(1, int(np.ceil((measured[m] - now) / 0.05)))
            dt = (measured[m] - now) / steps
            F, G = system(true, now + dt * (np.arange(steps) + 0.5))
            for F_k, G_k in zip(F, G, strict=True):
                P = predicted(P, F_k, G_k @ W @ G_k.T, dt)
            now = measured[m]
            if sent.came[m, run]:
                P = corrected(P, H[m], np.diag(sent.R[m, run]))
            out[m, run] = np.sqrt(np.diagonal(P))
    return sent.measured[:, :runs].mean(axis=1), out


def density(constants):
    """(16, 16) of the white noise w of `system`."""
    names = "gyro_noise", "accel_noise", "gyro_bias_noise", "accel_bias_noise", "mu_noise"
    return np.diag(np.append([constants[name] for name in names], constants["tau_noise"]) ** 2)


def predicted(P, F, Q, dt):
    """P after dt, s; F and the density Q are those of its middle."""
    step = np.eye(N) + F * dt + F @ F * (dt**2 / 2)
    return step @ (P + Q * (dt / 2)) @ step.T + Q * (dt / 2)


def corrected(P, H, R):
    gain = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    rest = np.eye(len(P)) - gain @ H
    return rest @ P @ rest.T + gain @ R @ gain.T


# ---- what is asked


def met(asked, most_refused, flight: Flight, record: Record) -> bool:
    """Whether a record condition is as it is asked to be, see `conditions`."""
    found = judged(record, flight.setting.seconds)
    if record.raised or np.isnan(found.nees_end):
        return False
    most = len({run for _, run, _ in record.notes}) >= 0.9 * flight.setting.runs
    if asked == "recovers":
        return most and inside(found.nees_end, found.runs)
    if asked == "named":
        return most or found.consistent
    well = found.consistent and found.refused <= most_refused
    return well and (asked == "consistent" or informed(flight, record)[0].all())


def informed(flight: Flight, record: Record):
    """(L, runs) bool of the second half: the sigma of the delay is within -5 and +20 % of what the true rates leave of
    it; and the two, (L,) ms."""
    time, sigma = information(flight, runs=1)
    of = np.interp(record.time, time, sigma[:, 0, TAU])[:, None]
    claimed = np.sqrt(np.array(record.P)[..., TAU, TAU])
    half = np.array(record.time) > flight.setting.seconds / 2
    within = (claimed > 0.95 * of) & (claimed < 1.2 * of)
    return within[half], 1e3 * claimed[half].mean(axis=1), 1e3 * of[half, 0]
