"""Logs of units at rest, whose noises are known, made by another road than the fit: spectra and recursions.

python tests/analysis/at_rest.py [LOGS] prints how often the intervals hold the truth, 100 logs of each kind: minutes.
"""

import sys
from math import comb

import numpy as np

from boresight.analysis.allan import TERMS, fitted
from boresight.runtime.recording import Inertial, Recording

DEG_H, G = np.radians(1) / 3600, 9.80665
SI = np.array([np.radians(1 / 3600), np.radians(1) / 60, DEG_H, DEG_H / 60, DEG_H / 3600])
# Gyros: arcsec, deg/sqrt(h), deg/h, deg/h/sqrt(h), deg/h/h.
KINDS = {
    "mems": (0, 0.3, 10, 30, 0),
    "industrial": (0, 0.15, 3, 4, 0),
    "fibre": (0.4, 0.012, 0.1, 0.05, 0),
    "ring laser": (1.6, 0.003, 0.005, 0.006, 0),
}

ACCEL = np.array([0, 60e-6 * G, 30e-6 * G, 60e-6 * G / 60, 0])
SAMPLES, DT = 36_000, 0.05
GYRO_BIAS, FORCE = np.array([2e-4, -3e-4, 1e-4]), np.array([0.02, -0.05, -9.8])


def flicker(samples, rng):
    """(samples,) means over one sample each of a signal of spectrum 1/(2 pi f), by its Fourier series over twice it."""
    length = 2 * samples
    f = np.fft.rfftfreq(length)[1:]
    aliases = f[:, None] + np.arange(-8, 9)
    power = np.sum(np.sinc(aliases) ** 2 / (2 * np.pi * np.abs(aliases)), axis=1)
    parts = rng.standard_normal((len(f), 2)) @ [1, 1j] * np.sqrt(power * length / 2)
    return np.fft.irfft(np.concatenate([[0], parts]), n=length)[:samples]


def rates(coefficients, samples, dt, rng):
    """(samples,) mean rates of a unit with these Q, N, B, K and R, in s and rad."""
    Q, N, B, K, R = coefficients
    angle = Q * rng.standard_normal(samples + 1)
    out = np.diff(angle) / dt + N / np.sqrt(dt) * rng.standard_normal(samples)
    steps, within = rng.standard_normal((2, samples))
    # the mean of a random walk over a sample: half of its step, and what it strays between its ends
    out += K * np.sqrt(dt) * (np.cumsum(steps) - steps / 2 + within / np.sqrt(12))
    return out + B * flicker(samples, rng) + R * dt * np.arange(samples)


def log(seed=1, samples=SAMPLES, kind="industrial"):
    """A healthy one, 30 min."""
    rng = np.random.default_rng(seed)
    truth = np.array(KINDS[kind]) * SI
    gyro = np.stack([rates(truth, samples, DT, rng) for _ in range(3)], axis=-1) + GYRO_BIAS
    accel = np.stack([rates(ACCEL, samples, DT, rng) for _ in range(3)], axis=-1) + FORCE
    return Recording("log", Inertial("rates", "end", np.arange(1, samples + 1) * DT, gyro, accel))


def held(kind, logs, samples, dt, seed):
    """(logs, 5) bool: whether the interval of each noise holds the truth; a limit is one from zero."""
    truth = np.array(KINDS[kind]) * SI
    rng = np.random.default_rng(seed)
    out = []
    for _ in range(logs):
        fit = fitted(rates(truth, samples, dt, rng), dt)
        out.append((fit.low <= truth) & (truth <= fit.high))
    return np.array(out)


def least(trials, probability, by_chance=1e-3):
    """How many of so many trials succeed but once in 1/by_chance."""
    total = 0.0
    for k in range(trials + 1):
        total += comb(trials, k) * probability**k * (1 - probability) ** (trials - k)
        if total > by_chance:
            return k
    return trials


if __name__ == "__main__":
    logs = int(sys.argv[1]) if len(sys.argv) > 1 else 100
    everything = []
    for kind in KINDS:
        found = held(kind, logs, 288_000, 0.05, 7)
        known = np.array(KINDS[kind]) > 0
        everything.append(found[:, known])
        print(kind, {name: int(count) for name, count in zip(TERMS, found.sum(axis=0), strict=True)}, flush=True)
    pooled = np.concatenate([part.ravel() for part in everything])
    print(f"of those that a unit has: {pooled.sum()} of {len(pooled)} = {pooled.mean():.4f}")
