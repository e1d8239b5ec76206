"""A filter's flight along a nominal motion as matrices: Phi, Q by noise, H and R, and the gain that they make.

A step is what a filter is called with: a dict of inputs for a prediction, a tuple for a measurement, as `budget` lists.
Matrices of alike steps are made in one call of the functions of the model.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Any

import numpy as np

from boresight.errors import BoresightError, did_you_mean
from boresight.runtime.array import Array, wrapped
from boresight.runtime.filter.filter import check_covariance

TOGETHER = 256  # steps whose matrices are made in one call
PROCESS = "process noise"  # what no noise density of the model makes
PROBE = 1e-6  # of a differential quotient

Step = Any  # a dict: a prediction; a tuple: a measurement, or one of ADDING, the first state and what it is given
ADDING = ("inflate", "set_block", "enable")


@dataclass(frozen=True)
class Prediction:
    """Phi (n, n); Q (1 + G, n, n), of all noises and of each alone; what the mean gains, in all and by parameter."""

    dt: float
    Phi: Array
    Q: Array
    inputs: dict[str, Any]
    x: Array
    D: dict[str, Array]


@dataclass(frozen=True)
class Update:
    """H (m, n) and R (m, m) of the rows that are taken, and by parameter what its unit adds to them, (m, p)."""

    name: str
    H: Array
    R: Array
    inputs: dict[str, Any]
    x: Array
    rows: Array
    D: dict[str, Array]


@dataclass(frozen=True)
class Added:
    """What the filter gives some of its states: (n, n).  anew: (n,) bool, states that lose what they had before."""

    P: Array
    anew: Array


class Flown:
    """A filter's model and steps as matrices.  start: by cause, (n, n)."""

    def __init__(
        self,
        model: Any,
        start: Any,
        steps: Iterable[Step],
        noise: Sequence[str] | None,
        x: Any,
        parameters: Sequence[str],
    ):
        self.model = model
        self.start = causes(model, start)
        self.n = len(next(iter(self.start.values())))
        self.steps = steps if isinstance(steps, Sequence) else list(steps)
        if not self.steps:
            raise BoresightError("budget: there are no steps; give predictions and measurements")
        self.total = model is not None and (
            getattr(model, "manifest", {}).get("kind") == "total-state" or hasattr(model, "next")
        )
        if self.total and x is None:
            raise BoresightError(f"budget: {named(model)} has a total state; give x, where the nominal motion begins")
        self.x = np.asarray(x, float) if self.total else np.zeros(self.n)
        if self.x.shape != (self.n,):
            raise BoresightError(f"budget: x has shape {self.x.shape}; it must be ({self.n},)")
        self.parameters = parameters
        known = [step for step in self.steps if isinstance(step, Mapping) and "Phi" not in step]
        self.noises = self.noises_of(noise) if known else []
        brought = {name for step in self.steps if isinstance(step, Mapping) and isinstance(step.get("Q"), Mapping)
                   for name in step["Q"]}  # fmt: skip
        self.parts = [*self.noises, *sorted(brought - set(self.noises)), PROCESS]
        self.measurements = list(dict.fromkeys(step[0] for step in self.steps
                                               if isinstance(step, tuple) and step[0] not in ADDING))  # fmt: skip

    def noises_of(self, noise: Sequence[str] | None) -> list[str]:
        """The inputs of Q that are root densities: those given, or those that Phi does not read and may be zero."""
        fields, boxes = self.model.Q.fields, getattr(self.model, "field", {})
        if noise is not None:
            for name in noise:
                if name not in fields:
                    raise BoresightError(f"budget: Q of {named(self.model)} has no input {name!r}"
                                         f"{did_you_mean(name, fields)}")  # fmt: skip
            return list(noise)
        return [name for name in fields
                if name not in self.model.Phi.fields and name in boxes and boxes[name].get("norm") is None
                and np.max(boxes[name]["low"]) == 0.0]  # fmt: skip

    def matrices(self, chunk: Sequence[Step], nominal: Sequence[Array]) -> list[Prediction | Update | Added]:
        """Of these steps and the state before each; alike ones in one call."""
        out: list[Any] = [None] * len(chunk)
        alike: dict[Any, list[int]] = {}
        for i, step in enumerate(chunk):
            if isinstance(step, Mapping):
                key: Any = ("", *sorted(step))
            elif isinstance(step, tuple) and len(step) >= 3 and step[0] in ADDING:
                out[i] = self.added(step)
                continue
            elif isinstance(step, tuple) and len(step) in (3, 4) and isinstance(step[2], Mapping):
                key = (step[0], np.shape(step[2].get("H", ())), *sorted(step[2]))
            else:
                raise BoresightError(
                    f"budget: {step!r} is no step; give a dict of inputs for a prediction, and a tuple "
                    "(name, R, inputs) or (name, R, inputs, rows) for a measurement"
                )
            alike.setdefault(key, []).append(i)
        for key, places in alike.items():
            made = self.updates if key[0] else self.predictions
            for i, one in zip(places, made([chunk[i] for i in places], [nominal[i] for i in places]), strict=True):
                out[i] = one
        return out

    def call(self, function: str, inputs: Mapping[str, Any], x: Array, **instead: Any) -> Any:
        """A function of the model, with those of the inputs that it reads."""
        unit = getattr(self.model, function, None)
        if unit is None:
            raise BoresightError(f"budget: {named(self.model)} has no function {function!r}; give matrices, or a "
                                 "measurement of the model")  # fmt: skip
        given = {**inputs, "x": x, **instead}
        if missing := [name for name in unit.fields if name not in given]:
            raise BoresightError(f"budget: {function} needs {', '.join(missing)}; add it to the inputs of the step")
        return unit(**{name: given[name] for name in unit.fields})

    def unknown(self, inputs: Mapping[str, Any], brought: Sequence[str]) -> None:
        """Raise BoresightError on an input that the model does not have."""
        fields = getattr(self.model, "field", None)
        for name in () if fields is None else inputs:
            assert fields is not None
            if name not in fields and name not in brought:
                raise BoresightError(f"budget: {named(self.model)} has no input {name!r}"
                                     f"{did_you_mean(name, fields) or '; it has ' + ', '.join(fields)}")  # fmt: skip

    def predictions(self, steps: Sequence[Mapping[str, Any]], x: Sequence[Array]) -> list[Prediction]:
        n, count = self.n, len(steps)
        Q = np.zeros((count, 1 + len(self.parts), n, n))
        if "Phi" in steps[0]:
            Phi = np.stack([shaped("Phi", step["Phi"], (n, n)) for step in steps])
            for k, step in enumerate(steps):
                given = step.get("Q", {})
                for name, one in (given if isinstance(given, Mapping) else {PROCESS: given}).items():
                    one = shaped("Q", one, (n, n))
                    check_covariance(f"budget: Q of {name}", one, n)
                    Q[k, 1 + self.parts.index(name)] += one
            Q[:, 0] = Q[:, 1:].sum(1)
            inputs: Mapping[str, Any] = {}
        else:
            self.unknown(steps[0], ())
            inputs = stacked(steps)
            states = np.stack(x)
            Phi = np.broadcast_to(self.call("Phi", inputs, states), (count, n, n))
            nothing = {name: np.zeros_like(np.asarray(inputs[name], float)) for name in self.noises if name in inputs}
            base = self.call("Q", inputs, states, **nothing)
            Q[:, 0] = self.call("Q", inputs, states)
            Q[:, -1] = base
            for g, name in enumerate(self.noises):
                if name in inputs:
                    Q[:, 1 + g] = self.call("Q", inputs, states, **{**nothing, name: inputs[name]}) - base
            apart = np.abs(Q[:, 1:].sum(1) - Q[:, 0]).max((-1, -2))
            if (apart > 1e-9 * np.abs(Q[:, 0]).max((-1, -2))).any():
                raise BoresightError(
                    f"budget: Q of {named(self.model)} is not the sum of its noises {', '.join(self.noises)}; name by "
                    "noise=(...) the inputs that are noise densities"
                )
        for name, value in (("Phi", Phi), ("Q", Q)):
            if not np.isfinite(value).all():
                raise BoresightError(f"budget: {name} holds a value that is not finite")
        D = self.by_parameter("next", inputs, x, count) if self.total and inputs else {}
        return [
            Prediction(numbers("dt", step.get("dt", 1.0), least=0.0).item(), Phi[k], Q[k], dict(step), x[k],
                       {name: one[k] for name, one in D.items()})
            for k, step in enumerate(steps)
        ]  # fmt: skip

    def updates(self, steps: Sequence[tuple[Any, ...]], x: Sequence[Array]) -> list[Update]:
        name, inputs = steps[0][0], stacked([step[2] for step in steps])
        states, count = np.stack(x), len(steps)
        if "H" in inputs:
            H = np.asarray(inputs["H"], float)
        else:
            self.unknown(inputs, ("z",))
            H = self.call(f"{name}_H", inputs, states)
        if not np.isfinite(H).all():
            raise BoresightError(f"budget: H of {name} holds a value that is not finite")
        if H.ndim < 2 or H.shape[-1] != self.n:
            raise BoresightError(f"budget: H of {name} has shape {H.shape}; its last axis must be {self.n} long")
        H = np.broadcast_to(H, (count, *H.shape[-2:]))
        m = H.shape[-2]
        D = {} if "H" in inputs else self.by_parameter(name, inputs, x, count)
        if name in self.parameters:
            D[name] = np.broadcast_to(np.eye(m), (count, m, m))
        out = []
        for k, step in enumerate(steps):
            rows = np.broadcast_to(np.asarray(step[3] if len(step) > 3 else True, bool), (m,))
            R = np.asarray(step[1], float)
            R = shaped(f"R of {name}", R if R.shape == (m, m) and m > 1 else np.diag(np.resize(R, m))
                       if R.size in (1, m) and R.ndim < 2 else R, (m, m))  # fmt: skip
            check_covariance(f"budget: R of {name}", R, m)
            if not (np.diagonal(R)[rows] > 0).all():
                raise BoresightError(
                    f"budget: every variance in R of {name} must be above zero; leave a row out by its mask, rows"
                )
            some = np.ix_(rows, rows)
            by = {parameter: one[k][rows] for parameter, one in D.items()}
            out.append(Update(name, H[k][rows], R[some], dict(step[2]), x[k], rows, by))
        return out

    def added(self, step: tuple[Any, ...]) -> Added:
        name, first, given = step[0], step[1], np.atleast_1d(np.asarray(step[2], float))
        block = np.diag(given) if name == "inflate" and given.ndim == 1 else given
        count = len(block)
        if not isinstance(first, int) or not 0 <= first <= self.n - count:
            raise BoresightError(f"budget: {name} of {count} states from state {first!r} on; there are {self.n} states")
        check_covariance(f"budget: {name}", shaped(name, block, (count, count)), count)
        P, anew = np.zeros((self.n, self.n)), np.zeros(self.n, bool)
        P[first : first + count, first : first + count] = block
        anew[first : first + count] = name != "inflate"
        return Added(P, anew)

    # ---- constants that are not known, and what is believed wrongly

    def residual(self, name: str, inputs: Mapping[str, Any], x: Array) -> Array:
        """What the filter takes for nu at x, but for what was measured: z - h, or of a total state -h."""
        there = [part for part in ("z", "h") if hasattr(self.model, f"{name}_{part}")]
        total: Any = 0.0
        for part in there:
            value = self.call(f"{name}_{part}", inputs, x)
            total = total + (value if part == "z" else -value)
        return np.asarray(total, float)

    def by_parameter(self, name: str, inputs: Mapping[str, Any], x: Sequence[Array], count: int) -> dict[str, Array]:
        """By uncertain input, what its unit adds to `next`, (count, n, p), or to what is measured, (count, m, p)."""
        parts = ["next"] if name == "next" else [f"{name}_{part}" for part in ("z", "h")]
        reads = {f for part in parts for f in getattr(getattr(self.model, part, None), "fields", ())}
        out = {}
        for parameter in self.parameters:
            if parameter not in reads:
                continue
            at = np.asarray(inputs[parameter], float)
            size = (
                self.model.field[parameter]["size"] if hasattr(self.model, "field") else at.shape[-1] if at.ndim else 1
            )
            at = np.broadcast_to(at if size > 1 else at[..., None], (count, size))
            columns = []
            for i in range(size):
                step = PROBE * np.maximum(1.0, np.abs(at[:, i : i + 1])) * np.eye(size)[i]
                ends = []
                for side in (1, -1):
                    moved = at + side * step
                    given = {**inputs, parameter: moved if size > 1 else moved[:, 0]}
                    states = np.stack(x)
                    ends.append(self.call("next", given, states) if name == "next"
                                else -self.residual(name, given, states))  # fmt: skip
                off = ends[0] - ends[1]
                columns.append(self.less_turns(name, off) / (2 * step[:, i : i + 1]))
            out[parameter] = np.stack([np.broadcast_to(c, (count, c.shape[-1])) for c in columns], axis=-1)
        return out

    def less_turns(self, name: str, off: Array) -> Array:
        """A difference (..., m) of a measurement's rows, or of states, with angles in [-pi, pi)."""
        if name == "next":
            places = list(getattr(self.model, "wraps", ()))
        else:
            described = getattr(self.model, "measurements", {}).get(name, {})
            angle, rows = described.get("angle"), described.get("rows", ())
            places = [i for i, row in enumerate(rows) if angle is True or row in (angle or ())]
        off = np.array(off, float)
        off[..., places] = wrapped(off[..., places])
        return off


def named(model: Any) -> str:
    return str(getattr(model, "name", None) or "the model")


def numbers(what: str, value: Any, least: float = -np.inf) -> Array:
    """Finite numbers, none below the least."""
    try:
        out = np.asarray(value, float)
    except (TypeError, ValueError):
        raise BoresightError(f"budget: {what} is {value!r}; give numbers") from None
    if not (np.isfinite(out) & (out >= least)).all():
        raise BoresightError(f"budget: {what} is {value}; give finite numbers{' from zero on' if least == 0 else ''}")
    return out


def shaped(what: str, value: Any, shape: tuple[int, ...]) -> Array:
    value = np.asarray(value, float)
    if value.shape != shape:
        raise BoresightError(f"budget: {what} has shape {value.shape}; it must be {shape}")
    return value


def stacked(dicts: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """The inputs of several steps side by side; what is the same object in all of them as it is."""
    out = {}
    for name, first in dicts[0].items():
        same = all(one[name] is first for one in dicts)
        out[name] = np.asarray(first, float) if same else np.array([one[name] for one in dicts], float)
    return out


def blocks(model: Any, n: int) -> list[tuple[str, list[int]]]:
    """The states by the variable that they are components of: its name and its places."""
    described = getattr(model, "manifest", {}).get("blocks")
    if not described:
        return [(name, [i]) for i, name in enumerate(states_of(model, n))]
    out, first = [], 0
    for block in described:
        out.append((block["name"], list(range(first, first + block["size"]))))
        first += block["size"]
    return out


def states_of(model: Any, n: int) -> tuple[str, ...]:
    return tuple(getattr(model, "states", None) or (f"x{i}" for i in range(n)))


def causes(model: Any, start: Any) -> dict[str, Array]:
    """The start by independent causes: as given, or of one covariance the parts that share no correlation."""
    if isinstance(start, Mapping):
        out = {name: np.asarray(P, float) for name, P in start.items()}
        out = {name: np.diag(numbers(f"sigma of {name}", P, 0.0) ** 2) if P.ndim == 1 else P for name, P in out.items()}
        if not out:
            raise BoresightError("budget: P0 names no cause; give a covariance, or one for each cause by name")
        n = len(next(iter(out.values())))
    else:
        P0 = np.asarray(start, float)
        n, out = len(P0), {}
    states = getattr(model, "states", None)
    n = len(states) if states else n
    for name, P in (out or {"P0": P0}).items():
        check_covariance(f"budget: {name}", P, n)
    if out:
        return out
    groups = [(name, set(places)) for name, places in blocks(model, n)]
    together: list[tuple[list[str], set[int]]] = []
    for name, places in groups:
        linked = [one for one in together if np.any(P0[np.ix_(sorted(one[1]), sorted(places))])]
        together = [one for one in together if one not in linked]
        together.append(
            ([part for one in linked for part in one[0]] + [name], set.union(places, *(one[1] for one in linked)))
        )
    for names, places in together:
        inside = np.zeros(n, bool)
        inside[list(places)] = True
        part = np.where(inside[:, None] & inside, P0, 0.0)
        if part.any():
            out["+".join(names)] = part
    return out or {"nothing": P0}


def gain(P: Array, H: Array, R: Array, kept: Array | None) -> tuple[Array, Array]:
    """K (..., n, m) of a measurement taken row after row, and P (..., n, n) behind it, in Joseph form as `Filter`.

    H: (m, n).  R: (..., m, m).  kept: (n,) bool, the considered states, whose rows of K are zero.
    """
    root = np.linalg.cholesky(R)
    sigma = np.diagonal(root, axis1=-2, axis2=-1)
    less = np.linalg.inv(root / sigma[..., None, :])  # which makes the rows independent, of variances sigma^2
    rows = less @ H
    before, K, P = P, np.zeros((*P.shape[:-1], H.shape[-2])), P.copy()
    for i in range(H.shape[-2]):
        h, variance = rows[..., i, :], sigma[..., i, None] ** 2
        Ph = (P @ h[..., None])[..., 0]
        k = Ph / (np.einsum("...i,...i->...", h, Ph)[..., None] + variance)
        K -= k[..., :, None] * (h[..., None, :] @ K)
        K[..., i] += k
        P -= k[..., :, None] * (h[..., None, :] @ P)
        P -= ((P @ h[..., None])[..., 0] - variance * k)[..., :, None] * k[..., None, :]
    P = (P + np.swapaxes(P, -1, -2)) / 2
    if kept is not None:
        K[..., kept, :] = 0.0
        P = np.where(kept[:, None] & kept, before, P)
    return K @ less, P


def pairs(truth: Flown, believer: Flown) -> Iterator[tuple[Any, Any]]:
    """The steps of truth and filter as matrices, both at the nominal motion of the truth."""
    x, steps, others = truth.x, iter(truth.steps), iter(believer.steps)
    places = list(getattr(truth.model, "wraps", ()))
    while chunk := list(islice(steps, TOGETHER)):
        nominal = []
        for step in chunk:
            nominal.append(x)
            if truth.total and isinstance(step, Mapping) and "Phi" not in step:
                x = truth.call("next", step, x)
                x[places] = wrapped(x[places])
        made = truth.matrices(chunk, nominal)
        second = made if believer is truth else believer.matrices(list(islice(others, TOGETHER)), nominal)
        for one, other in zip(made, second, strict=True):
            alike = type(one) is type(other) and getattr(one, "name", "") == getattr(other, "name", "")
            if not alike or (
                isinstance(one, Update) and isinstance(other, Update) and not np.array_equal(one.rows, other.rows)
            ):
                raise BoresightError("budget: believed has another step than the truth; give the same steps, with "
                                     "the same rows of the same measurements")  # fmt: skip
            yield one, other


def units_of(block: Mapping[str, Any]) -> list[str]:
    """The unit of each component of a block of states."""
    each = [unit.strip() for unit in str(block["unit"]).split(",")]
    return each if len(each) == block["size"] else each[:1] * block["size"]
