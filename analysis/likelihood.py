"""Which noises make the innovations of a flight most likely, of any model whose flight was recorded.

The record is linearised once: transitions, noise covariances, H and gains are those of the generated C along the flight
that was flown.  With other noises the covariance runs anew, and the estimates differ from the flown ones by what other
gains make of the same innovations.  Derivatives of both by the logarithm of each noise run beside them, so that one
walk gives likelihood, gradient and information.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.figures import AXES, GREY, figure
from boresight.analysis.record import Record
from boresight.analysis.smoother import changes
from boresight.runtime.array import Array

SURE = 1.96  # sigmas, 95 %
REACH = 1e4  # times what was flown with, and its inverse: where a noise is looked for
ENOUGH = 0.02  # of minus the log likelihood; half of one is one sigma
UNSEEN = 1.0  # sigma of a logarithm from which a noise has a limit alone


@dataclass(frozen=True)
class Row:
    """One row of a measurement that was used by some runs: nu was flown with the gain, r is its R."""

    h: Array  # (..., n)
    r: Array  # (...)
    nu: Array  # (...)
    gain: Array  # (..., n)
    used: Array  # (...) bool
    noise: int  # the number of its noise


@dataclass(frozen=True)
class Change:
    """What measures nothing: x = A x, P = A P A' + Q + the sum over noises of their own parts."""

    A: Array  # (..., n, n)
    Q: Array  # (..., n, n)
    parts: Array | None  # (..., noises, n, n)


class Linearised:
    """A record as it is walked with other noises.

    names: of the noises: what the model's Q reads and Phi does not, and "R of NAME" of each measurement.
    sizes: (noises,) what they were flown with, in SI: the largest axis, and the median of a measurement's sigmas.
    units: of each.
    """

    def __init__(self, record: Record):
        self.n, self.runs = record.x.shape[-1], record.x.shape[1:-1]
        model: Any = record.model
        given: dict[str, list[Array]] = {}
        for table in record.tables("predict"):
            for name, value in table.given.items():
                given.setdefault(name, []).append(np.abs(value).reshape(len(value), -1).max(axis=1))
        read = [name for name in model.Q.fields if name in given and name not in model.Phi.fields]
        driving = [name for name in read if np.max(np.hstack(given[name])) > 0]
        measured = sorted({t.name for t in record._all().tables if "nu" in t.given})
        self.names = (*driving, *(f"R of {name}" for name in measured))
        fields = getattr(model, "field", {})
        described = getattr(model, "measurements", {})
        units = [fields[name]["unit"] if name in fields else "" for name in driving]
        self.units = (*units, *(described.get(name, {}).get("unit", "") for name in measured))
        self.steps: list[Row | Change | Array] = [np.empty(0)] * len(record.names)
        walked: dict[int, list[Row]] = {}
        sizes = [float(np.median(np.hstack(given[name]))) for name in driving]
        if any(np.any(table.given.get("considered", False)) for table in record._all().tables):
            raise BoresightError(
                "the flight has considered states, for which noises cannot be found; fly it without them"
            )
        for number, name in enumerate(measured, len(driving)):
            found, H, gains = record.innovation(name), record.jacobian(name), record.gain(name)
            if found.inflated is not None and found.inflated.any():
                raise BoresightError(
                    f"rows of {name} were taken with a larger R (inflate); fly with a gate that rejects them"
                )
            r = found.S * (1 - np.einsum("...mi,...im->...m", H, gains))
            sizes.append(float(np.sqrt(np.median(r[found.used]))) if found.used.any() else 0.0)
            for k, row in enumerate(record.rows(name)):
                walked[int(row)] = [
                    Row(
                        H[k, ..., i, :],
                        r[k, ..., i],
                        found.nu[k, ..., i],
                        gains[k, ..., :, i],
                        found.used[k, ..., i],
                        number,
                    )
                    for i in range(H.shape[-2])
                ]
        self.sizes = np.array(sizes)
        parts = self._parts(record, driving)
        self.walk: list[Row | Change | Array] = []
        steps = changes(record)
        for k, name in enumerate(record.names):
            if k in walked:
                self.walk += walked[k]
            elif name == "begin":
                self.walk.append(record.covariance(k))
            else:
                A, Q, is_frame = steps[k]
                if not is_frame:  # the filter leaves P as it is, and the change of what is small is of second order
                    own = parts.get(k)
                    self.walk.append(Change(A, Q if own is None else np.zeros_like(Q), own))

    def _parts(self, record: Record, driving: list[str]) -> dict[int, Array]:
        """By row of the record, what each noise adds to P; (..., noises, n, n)."""
        model, out = record.model, {}
        for table in record.tables("predict"):
            known = record._known(table.rows, table.given)
            known = {name: known[name] for name in model.Q.fields}
            whole = np.asarray(model.Q(**known))
            none = {name: np.zeros_like(known[name]) for name in driving}
            each = np.stack([np.asarray(model.Q(**(known | none | {name: known[name]}))) for name in driving], axis=-3)
            off = np.abs(each.sum(axis=-3) - whole).max(initial=0.0)
            if off > 1e-9 * np.abs(whole).max(initial=0.0):
                raise BoresightError(
                    f"Q of {model.name} is not the sum of the parts of {', '.join(driving)}, so they cannot be scaled"
                )
            kept = 1 - table.given.get("disabled", np.zeros((len(table.rows), self.n)))
            for k, row in enumerate(table.rows):
                out[int(row)] = kept[k][:, None] * each[k] * kept[k]
        return out

    def __call__(self, logs: Array) -> tuple[Array, Array, Array]:
        """Minus the log likelihood, its gradient and its information, by the logarithms of the noises over `sizes`.

        logs: (noises,), then of all runs together; or (*runs, noises), of each run for itself.  -> (...), (..., p) and
        (..., p, p), with the axes of logs but its last.
        """
        p, n = len(self.names), self.n
        logs, alone = np.asarray(logs, float), np.ndim(logs) > 1
        scale = np.broadcast_to(np.exp(2 * logs), (*self.runs, p))
        cost, gradient, information = np.zeros(self.runs), np.zeros((*self.runs, p)), np.zeros((*self.runs, p, p))
        P, x = np.zeros((*self.runs, p + 1, n, n)), np.zeros((*self.runs, p + 1, n))  # each with its derivatives behind
        for step in self.walk:
            if isinstance(step, Row):
                taken = np.asarray(step.used)
                b = P @ step.h[..., None, :, None]  # (..., p + 1, n, 1)
                b = b[..., 0]
                S = (b * step.h[..., None, :]).sum(-1)
                r = step.r * scale[..., step.noise]
                S[..., 0] += r
                S[..., 1 + step.noise] += 2 * r
                down = -(x * step.h[..., None, :]).sum(-1)
                nu, dnu, dS, one = step.nu + down[..., 0], down[..., 1:], S[..., 1:], np.where(taken, S[..., 0], 1.0)
                gain = b[..., 0, :] / one[..., None]
                swing = (b[..., 1:, :] - gain[..., None, :] * dS[..., None]) / one[..., None, None]
                ratio = nu / one
                here = taken.astype(float)
                cost += here * 0.5 * (np.log(one) + nu * ratio)
                slope = 0.5 * dS * (1 / one - ratio**2)[..., None] + dnu * ratio[..., None]
                gradient += here[..., None] * slope
                share, tilt = dS / one[..., None], dnu / np.sqrt(one)[..., None]
                both = 0.5 * share[..., :, None] * share[..., None, :] + tilt[..., :, None] * tilt[..., None, :]
                information += here[..., None, None] * both
                moved = np.concatenate(
                    [(gain * nu[..., None] - step.gain * step.nu[..., None])[..., None, :],
                     swing * nu[..., None, None] + gain[..., None, :] * dnu[..., None]], axis=-2,
                )  # fmt: skip
                x = x + here[..., None, None] * moved
                # P - b b' / S, and of its derivatives a the terms of both factors and of S
                lead = gain[..., None, None, :] * here[..., None, None, None]
                taken_out = b[..., :, None] * lead
                less = taken_out + np.swapaxes(taken_out, -1, -2)
                less[..., 0, :, :] /= 2
                more = gain[..., :, None] * gain[..., None, :]
                less[..., 1:, :, :] -= here[..., None, None, None] * more[..., None, :, :] * dS[..., None, None]
                P = P - less
            elif isinstance(step, Change):
                A = np.broadcast_to(step.A, (*self.runs, n, n))[..., None, :, :]
                P, x = A @ P @ np.swapaxes(A, -1, -2), (A @ x[..., None])[..., 0]
                P[..., 0, :, :] += step.Q
                if step.parts is not None:
                    count = step.parts.shape[-3]
                    each = scale[..., :count, None, None] * step.parts
                    P[..., 0, :, :] += each.sum(axis=-3)
                    P[..., 1 : count + 1, :, :] += 2 * each
            else:
                P, x = np.zeros_like(P), np.zeros_like(x)
                P[..., 0, :, :] = step
        if alone or not self.runs:
            return cost, gradient, information
        axes = tuple(range(len(self.runs)))
        return cost.sum(axes), gradient.sum(axes), information.sum(axes)


def damped_step(gradient: Array, information: Array, radius: float) -> Array:
    """The step downhill, no component longer than `radius`: damping turns a step that is too long to the gradient.

    Cutting the components instead would spoil the direction: where one noise hides another they change together.
    """
    damping = 1e-3
    while True:
        step: Array = -np.linalg.solve(information + damping * np.eye(len(gradient)), gradient)
        if np.abs(step).max() <= radius:
            return step
        damping *= 3


def settled(
    walk: Linearised, *, each_run: bool = False, progress: Callable[[str], None] = lambda line: None
) -> tuple[Array, Array, Array, int]:
    """Logarithms of the likeliest noises over `sizes`, their information, minus the log likelihood, and the passes.

    By Fisher scoring with a limited step.  It ends where the next step promises less than ENOUGH.  each_run: of each
    run for itself, (*runs, noises), else of all together, (noises,).
    Raises BoresightError if it does not settle in 40 passes.
    """
    p, most = len(walk.names), np.log(REACH)
    shape = (*walk.runs, p) if each_run and walk.runs else (p,)
    centre = trial = np.zeros(shape)
    best = np.full(shape[:-1], np.inf)
    gradient, information, radius = np.zeros(shape), np.zeros((*shape, p)), np.full(shape[:-1], 1.5)
    for passes in range(1, 41):
        cost, slope, seen = walk(trial)
        better = cost < best
        centre = np.where(better[..., None], trial, centre)
        gradient, information = (
            np.where(better.reshape(*better.shape, *(1,) * (new.ndim - better.ndim)), new, old)
            for new, old in ((slope, gradient), (seen, information))
        )
        best, radius = np.where(better, cost, best), np.where(better, np.minimum(2 * radius, 1.5), radius / 4)
        step = np.empty(shape)
        for at in np.ndindex(shape[:-1]):
            step[at] = damped_step(gradient[at], information[at], float(radius[at]))
        trial = np.clip(centre + step, -most, most)
        progress(f"choosing the noises: pass {passes}, minus log likelihood {best.sum():.1f}")
        promised = -np.sum(gradient * (trial - centre), axis=-1)
        if ((promised < ENOUGH) | (radius < 1e-3)).all():
            return centre, information, best, passes
    raise BoresightError("the choice of noises did not settle in 40 passes; was the flight near the truth?")


@dataclass(frozen=True)
class Likeliest:
    """The noises of a flight: by `names` and `units`, in SI.

    given: what it was flown with.  value, low, high: the likeliest, and its interval of 95 % from the information
    matrix; where `seen` is False the noise has no lower limit, and `value` is not to be used.
    cost: minus the log likelihood as flown and with the likeliest.  w: (rows,) normalised innovations of each row of a
    measurement as flown, by its name.
    """

    names: tuple[str, ...]
    units: tuple[str, ...]
    given: Array
    value: Array
    low: Array
    high: Array
    seen: Array
    cost: tuple[float, float]
    passes: int
    w: dict[str, Array]
    seconds: float

    def report(self) -> str:
        """A table for a person."""
        rows = [("noise", "unit", "flown with", "likeliest", "95 %")]
        for i, name in enumerate(self.names):
            span = f"{self.low[i]:.3g} to {self.high[i]:.3g}" if self.seen[i] else ""
            found = f"{self.value[i]:.3g}" if self.seen[i] else f"below {self.high[i]:.3g}"
            rows.append((name, self.units[i], f"{self.given[i]:.3g}", found, span))
        width = [max(len(row[k]) for row in rows) for k in range(5)]
        lines = ["  ".join(cell.ljust(w) for cell, w in zip(row, width, strict=True)).rstrip() for row in rows]
        lines += ["", f"minus log likelihood {self.cost[0]:.1f} as flown, {self.cost[1]:.1f} with the likeliest, "
                  f"{self.passes} passes"]  # fmt: skip
        changed = [name for name, old, low, high in zip(self.names, self.given, self.low, self.high, strict=True)
                   if not low <= old <= high]  # fmt: skip
        if changed:
            lines.append(f"flown with a size outside its interval: {', '.join(changed)}; fly it with the likeliest,")
            lines.append("and look again: all of this is linearised about the estimates that were flown")
        return "\n".join(lines)

    def document(self) -> dict[str, Any]:
        """The same for `--json`."""
        noises = [
            {"name": name, "unit": self.units[i], "given": float(self.given[i]), "value": float(self.value[i]),
             "low": float(self.low[i]), "high": float(self.high[i]), "seen": bool(self.seen[i])}
            for i, name in enumerate(self.names)
        ]  # fmt: skip
        return {"seconds": self.seconds, "noises": noises, "minus_log_likelihood": {"flown": self.cost[0],
                "likeliest": self.cost[1]}, "passes": self.passes}  # fmt: skip

    def draw(self, path: str | Path, made_from: str = "") -> Path:
        """The Allan deviation of the innovations over their sigmas, and what the model predicts: white noise."""
        from boresight.analysis.allan import averages, covariance, variances

        with figure(Path(path), 3.6 * len(self.w), 3.2, made_from=made_from, ncols=len(self.w), squeeze=False) as (
            _,
            axes,
        ):
            for ax, (name, w) in zip(axes[0], self.w.items(), strict=True):
                count = averages(w.shape[-1])
                spread = np.diagonal(covariance(np.array([0, 1.0, 0, 0, 0]), w.shape[-1], 1.0, count))
                reach = SURE * np.sqrt(spread) * count / 2  # of a deviation's logarithm, whose variance is 1 / count
                ax.fill_between(count, np.exp(-reach) / np.sqrt(count), np.exp(reach) / np.sqrt(count), color=GREY,
                                alpha=0.3, lw=0, label="predicted: white, 95 %")  # fmt: skip
                for i, row in enumerate(w):
                    ax.plot(count, np.sqrt(variances(row, 1.0, count)), "o-", ms=2.5, lw=0.8,
                            color=AXES[i % 3], label=f"row {i + 1}, measured")  # fmt: skip
                ax.set(xscale="log", yscale="log", xlabel="average over [updates]", ylabel="Allan deviation [sigmas]")
                ax.set_title(f"innovations of {name}", loc="left")
                ax.legend(loc="lower left")
        return Path(path)


def likeliest(record: Record, *, progress: Callable[[str], None] = lambda line: None) -> Likeliest:
    """The noises under which the innovations of a flight are most likely, with intervals.

    Parameters
    ----------
    record : Record
        Of any model; of many runs the noises of all together.
    progress : callable, optional
        Is given a line after each pass.

    Returns
    -------
    Likeliest
        One factor for each noise that the model's Q reads, all its axes together, and one for R of
        each measurement: `report()`, `document()` for JSON, `draw(path)`.

    Raises
    ------
    BoresightError
        A flight with considered states or inflated rows; a Q that is no sum over its noises; noises
        that do not settle.

    Notes
    -----
    When not to use it: of a flight that is far from the truth, or of one whose innovations hold
    something else than noise, as a lever arm that is not estimated: noises take that up.  A noise
    that was flown as zero stays zero.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import CompiledFilter, Record, load, noise
    >>> rng, still = np.random.default_rng(1), np.zeros(3)
    >>> loop = CompiledFilter(load("euler-matching"), {"q_b2n_wxyz": [1, 0, 0, 0], "mu": still}, P=np.eye(6) * 1e-8)
    >>> record = Record(loop)
    >>> for _ in range(400):
    ...     turned = 1e-4 * rng.standard_normal(3)
    ...     loop.strapdown(dtheta_ib_b=turned, omega_in_n=still, dt=1.0)
    ...     loop.predict(omega_in_n=still, gyro_noise=np.full(3, 1e-3), dt=1.0)
    ...     angles = {"euler_b": loop.call("euler_angles"), "euler_m": 1e-3 * rng.standard_normal(3)}
    ...     found = loop.update("euler_exact", R=np.full(3, 1e-6), **angles)
    ...     loop.feedback()
    >>> found = noise.likeliest(record)
    >>> print(found.low[0] < 1e-4 < found.high[0], found.low[1] < 1e-3 < found.high[1])
    True True
    """
    walk = Linearised(record)
    p = len(walk.names)
    if not any(isinstance(step, Row) for step in walk.walk):
        raise BoresightError("the flight has no measurement, and so no innovation; record its updates")
    flown = float(walk(np.zeros(p))[0])
    logs, information, cost, passes = settled(walk, progress=progress)
    sigma = np.sqrt(np.diagonal(np.linalg.pinv(information, hermitian=True)))
    alone = 1 / np.sqrt(np.maximum(np.diagonal(information), 1e-300))
    sigma = np.maximum(sigma, alone)  # a pseudo-inverse has none of what nothing is known of
    seen = (sigma < UNSEEN) & (np.abs(logs) < np.log(REACH) - 1e-6)
    # of one that is not seen the limit, by what it adds to the likelihood
    high = np.exp(np.minimum(logs + SURE * sigma, np.log(REACH)))
    for i in np.flatnonzero(~seen):
        high[i] = np.exp(limit(walk, logs, int(i), float(cost)))
    w = {
        name: whitened(record, name)
        for name in (one.removeprefix("R of ") for one in walk.names if one.startswith("R of "))
    }
    value = walk.sizes * np.exp(logs)
    low = np.where(seen, walk.sizes * np.exp(logs - SURE * sigma), 0.0)
    return Likeliest(
        walk.names, walk.units, walk.sizes, value, low, walk.sizes * high, seen, (flown, float(cost)), passes, w,
        float(record.time[-1]),
    )  # fmt: skip


def limit(walk: Linearised, logs: Array, i: int, least: float) -> float:
    """The logarithm of noise i from which on minus the log likelihood is SURE^2 / 2 above the least, others kept."""
    low, high = float(logs[i]), np.log(REACH)
    for _ in range(20):
        middle = (low + high) / 2
        trial = np.where(np.arange(len(logs)) == i, middle, logs)
        low, high = (middle, high) if float(walk(trial)[0]) - least < SURE**2 / 2 else (low, middle)
    return high


def whitened(record: Record, name: str) -> Array:
    """(m, K) normalised innovations of a measurement, of the first run, where all its rows were used."""
    found = record.innovation(name)
    w, used = found.nu / np.sqrt(found.S), found.used
    while w.ndim > 2:
        w, used = w[:, 0], used[:, 0]
    return w[used.all(-1)].T
