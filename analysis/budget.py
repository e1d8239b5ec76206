"""Error budget by linear covariance: how much each source makes of a filter's error, along a nominal motion.

To first order, and without a random number: the filter's own P, and the true covariance of its error where it believes
other numbers than the true ones.  Truth and filter are propagated together, with the gains of the filter; each source
alone and all together.

    d = x - x_hat,   d' = Phi d + (Phi - Phi_f) x_hat + w,   x_hat' = Phi_f x_hat
    nu = H d + (H - H_f) x_hat + v,   d' = d - K nu,   x_hat' = x_hat + K nu

Phi_f, H_f and K are the filter's.  Where the filter believes the truth, d alone is propagated.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from boresight.analysis.budget_result import ADDED, Budget
from boresight.analysis.linear import (
    PROCESS,
    Flown,
    Prediction,
    Step,
    Update,
    blocks,
    gain,
    named,
    numbers,
    pairs,
    states_of,
    units_of,
)
from boresight.errors import BoresightError, did_you_mean
from boresight.runtime.array import Array
from boresight.runtime.filter.filter import lowered, without

KEPT = 1024  # times that are kept at most; beyond it every second one is dropped


class Shares:
    """Covariances of several sources under one filter: C (N, S, N), slot 0 of all together.

    What adds to one of them adds to slot 0 as well, and neither is made from the other.
    """

    def __init__(self, N: int, n: int, slots: Sequence[str]):
        self.place = {name: 1 + s for s, name in enumerate(slots)}
        self.C, self.N, self.n = np.zeros((N, 1 + len(slots), N)), N, n

    def through(self, A: Array) -> None:
        N, S = self.N, self.C.shape[1]
        self.C = ((A @ self.C.reshape(N, S * N)).reshape(N * S, N) @ A.T).reshape(N, S, N)

    def add(self, name: str, S: Array) -> None:
        part = slice(0, len(S))
        self.C[part, self.place[name], part] += S
        self.C[part, 0, part] += S

    def process(self, Q: Array) -> None:
        """Q (1 + G, n, n): of all, and of the first G sources."""
        self.C[: self.n, : len(Q), : self.n] += Q.swapaxes(0, 1)

    def rounded(self) -> None:
        self.C = (self.C + self.C.transpose(2, 1, 0)) / 2

    def variances(self) -> Array:
        """(1 + S, n)"""
        return np.einsum("isi->si", self.C[: self.n, :, : self.n]).copy()


def budget(
    model: Any,
    P0: Any,
    steps: Iterable[Step],
    *,
    believed: tuple[Any, Iterable[Step]] | None = None,
    considered: Any = None,
    omitted: Any = None,
    uncertain: Mapping[str, Any] | None = None,
    offsets: Mapping[str, Any] | None = None,
    x: Any = None,
    noise: Sequence[str] | None = None,
) -> Budget:
    """The error budget of a filter along a nominal motion, by linear covariance.

    Each source alone and all together: each cause of the start, each process noise, the noise of
    each measurement, each constant that is not known, and what the filter adds to P on purpose.
    No random number is drawn.

    Parameters
    ----------
    model : Library, any object with the same functions, or None
        Offers `Phi`, `Q`, `NAME_H` with `.fields`, and `next` if its state is total.  None where
        every step brings its matrices.
    P0 : (n, n) array, or dict of str to (n, n) or (n,) array
        The start: a covariance, which is split where no correlation links two blocks of states; or
        one for each independent cause, (n,) being sigmas, whose sum is the start.
    steps : iterable
        What is flown, in order, at the nominal motion, with all the inputs of the model's functions.
        A dict is a prediction: the inputs of Phi, Q and `next`, as {"dt": 0.1, "gyro_noise": ...};
        or {"dt": ..., "Phi": (n, n), "Q": {source: (n, n)}} of the caller's own. Without dt it
        counts as 1.
        A tuple is a measurement: (name, R, inputs) or (name, R, inputs, rows), R being a variance,
        (m,) variances or an (m, m) covariance, inputs those of `NAME_H`, or {"H": (m, n)}.
        ("inflate", first, variance), ("set_block", first, block) and ("enable", first, block) change P
        of the filter as its methods do, and no error.
    believed : (P0, steps), optional
        What the filter believes where that is not the truth: a start and as many steps of the same
        kinds, which may differ in every number: noise, R, correlation times, lever arms.
    considered : sequence of str, or (n,) bool array, optional
        States that no measurement corrects (Schmidt filter), by their names or those of their blocks.
    omitted : sequence of str, or (n,) bool array, optional
        States that the filter does not carry; the truth has them all the same.
    uncertain : dict of str to number or array, optional
        One sigma of constants that nobody estimates: of an input of a measurement, as {"lever_b":
        0.01}, or of the rows of a measurement, by its name.
    offsets : dict of str to number or array, optional
        The same, of constants whose size is known and which the filter ignores: true - believed.
    x : (n,) array, optional
        Where the nominal motion of a total state begins.
    noise : sequence of str, optional
        The inputs of Q that are root densities; found by themselves for a `Library`.

    Returns
    -------
    Budget
        `variances` (T, S, n) by source, `whole` (T, n), `P` the filter's own, and `report()`,
        `csv()`, `document()`, `draw(folder)`, `need(state, limit)`.

    Raises
    ------
    BoresightError
        A start or R that is no covariance; a step that is none; an input that is missing, unknown or
        outside its box; a Q that is not the sum of its noises.

    Notes
    -----
    When not to use it: where errors are so large that second-order terms count; fly many
    runs then.  Gates and rejected rows are not in it.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import budget, load
    >>> step = {"q_b2n_wxyz": [1, 0, 0, 0], "omega_in_n": np.zeros(3), "dt": 0.1,
    ...         "gyro_noise": np.full(3, 1e-4)}
    >>> angles = {"euler_b": np.zeros(3), "euler_m": np.zeros(3), "mu": np.zeros(3)}
    >>> fix = ("euler_exact", np.full(3, 1e-6), angles)
    >>> found = budget(load("euler-matching"), np.eye(6) * 1e-4, [step, fix] * 10)
    >>> found.sources
    ('start eps', 'start dmu', 'gyro_noise', 'euler_exact noise')
    >>> print((1e3 * np.sqrt(found.variances[-1, :, 2])).round(3))  # mrad, of eps_d
    [5.002 4.998 0.073 0.158]
    """
    spread, known = ({name: np.atleast_1d(numbers(name, value, least)) for name, value in (given or {}).items()}
                     for given, least in ((uncertain, 0.0), (offsets, -np.inf)))  # fmt: skip
    truth = Flown(model, P0, steps, noise, x, (*spread, *known))
    believer = truth if believed is None else Flown(model, *believed, noise, x, ())
    if believer.n != truth.n or len(believer.steps) != len(truth.steps):
        raise BoresightError(f"budget: believed has {believer.n} states and {len(believer.steps)} steps, the truth "
                             f"{truth.n} and {len(truth.steps)}; both must be the same steps")  # fmt: skip
    kept, dropped = (chosen(model, names, truth.n) for names in (considered, omitted))
    return Linear(truth, believer, kept, dropped, spread, known).run()


def chosen(model: Any, names: Any, n: int) -> Array | None:
    """(n,) bool: the states of these names, or of these blocks of states; None for none."""
    if names is None or len(names) == 0:
        return None
    given = np.asarray(names)
    if given.dtype == bool:
        if given.shape != (n,):
            raise BoresightError(f"budget: considered has shape {given.shape}; it must be ({n},)")
        return given if given.any() else None
    out = np.zeros(n, bool)
    states, parts = states_of(model, n), dict(blocks(model, n))
    for name in [names] if isinstance(names, str) else names:
        if name not in states and name not in parts:
            known = (*parts, *states)
            raise BoresightError(f"budget: there is no state {name!r}{did_you_mean(str(name), known)}; there are "
                                 f"{', '.join(dict.fromkeys(known))}")  # fmt: skip
        out[[states.index(name)] if name in states else parts[name]] = True
    return out


class History:
    """Rows at the times of a flight, at most KEPT of them, evenly."""

    def __init__(self) -> None:
        self.rows: list[tuple[Any, ...]] = []
        self.every, self.count = 1, 0

    def keep(self, row: Callable[[], tuple[Any, ...]], last: bool = False) -> None:
        if last or self.count % self.every == 0:
            self.rows.append(row())
        self.count += 1
        if len(self.rows) > KEPT:
            self.rows, self.every = self.rows[::2], 2 * self.every

    def columns(self) -> list[Array]:
        return [np.array(column) for column in zip(*self.rows, strict=True)]


def differ(one: Mapping[str, Any], other: Mapping[str, Any]) -> bool:
    """Whether two steps have other inputs."""
    return one.keys() != other.keys() or any(
        value is not other[name] and not np.array_equal(value, other[name]) for name, value in one.items()
    )


class Linear:
    """Truth and filter along their steps, with the gains of the filter."""

    def __init__(
        self,
        truth: Flown,
        believer: Flown,
        kept: Array | None,
        dropped: Array | None,
        spread: Mapping[str, Array],
        known: Mapping[str, Array],
    ):
        self.truth, self.believer, self.kept, self.dropped = truth, believer, kept, dropped
        self.spread, self.known = spread, known
        # an error state stands for what the mechanics carry; of a total one the filter has nothing where it is omitted
        self.blind = None if dropped is None or not (truth.total or truth.model is None) else dropped
        self.n, self.wide = truth.n, believer is not truth or self.blind is not None
        self.ceiling = getattr(truth.model, "ceiling", None)
        both = [truth, believer]
        self.starts = list(dict.fromkeys(name for one in both for name in one.start))
        parts = dict.fromkeys(name for one in both for name in one.parts)
        truth.parts = believer.parts = [*(name for name in parts if name != PROCESS), PROCESS]
        self.measured = list(dict.fromkeys(name for one in both for name in one.measurements))
        self.slots = [*truth.parts, *(f"start {name}" for name in self.starts),
                      *(f"{name} noise" for name in self.measured), ADDED]  # fmt: skip
        if len(set(self.slots)) < len(self.slots):
            twice = next(name for name in self.slots if self.slots.count(name) > 1)
            raise BoresightError(f"budget: two sources are named {twice!r}; give the cause in P0 another name")

    def shares(self, of: Flown, N: int) -> Shares:
        made = Shares(N, self.n, self.slots)
        for name, P in of.start.items():
            made.add(f"start {name}", P)
        return made

    def carried(self, P: Array) -> Array:
        """P (..., n, n) without the states that the filter does not carry."""
        return P if self.dropped is None else without(P, self.dropped)

    def leave_out(self, design: Shares) -> None:
        if self.dropped is not None:
            design.C[self.dropped] = 0.0
            design.C[:, :, self.dropped] = 0.0

    def transition(self, one: Prediction, other: Prediction) -> tuple[Array, Array]:
        """A (N, N), and what the means of d and x_hat gain, (N,), where `next` is believed to be another one."""
        if not self.wide:
            return one.Phi, np.zeros(self.n)
        shift = np.zeros(self.n)
        if self.truth.total and "Phi" not in one.inputs and differ(one.inputs, other.inputs):
            ends = (each.call("next", step.inputs, one.x) for each, step in ((self.truth, one), (self.believer, other)))
            shift = self.truth.less_turns("next", np.subtract(*ends))
        Phi = other.Phi
        if self.blind is not None:
            Phi, shift = np.where(self.blind[:, None], 0.0, Phi), np.where(self.blind, 0.0, shift)
        A = np.block([[one.Phi, one.Phi - Phi], [np.zeros_like(Phi), Phi]])
        return A, np.concatenate([shift, -shift])

    def correction(self, K: Array, one: Update, other: Update) -> tuple[Array, Array]:
        """A (..., N, N) and B (..., N, m), by which nu comes to d and x_hat.  K: (..., n, m)."""
        KH = K @ one.H
        if not self.wide:
            return np.eye(self.n) - KH, -K
        by = K @ (one.H - other.H)
        A = np.concatenate([np.concatenate([-KH, -by], -1), np.concatenate([KH, by], -1)], -2)
        return A + np.eye(2 * self.n), np.concatenate([-K, K], -2)

    def off(self, one: Update, other: Update) -> Array:
        """(m,) what nu is in the mean, where a measurement's inputs are believed to be others."""
        if not self.wide or "H" in one.inputs or not differ(one.inputs, other.inputs):
            return np.zeros(len(one.H))
        seen = (
            each.residual(one.name, step.inputs, one.x) for each, step in ((self.believer, other), (self.truth, one))
        )
        off = np.broadcast_to(self.truth.less_turns(one.name, np.atleast_1d(np.subtract(*seen))), one.rows.shape)
        return off[one.rows]

    def run(self) -> Budget:
        n = self.n
        P = self.carried(np.sum(list(self.believer.start.values()), axis=0))
        true = self.shares(self.truth, 2 * n if self.wide else n)
        design = self.shares(self.believer, n) if self.wide or self.dropped is not None else true
        self.leave_out(design)
        mean, columns = np.zeros(true.N), dict[str, Array]()
        history, time, begun = History(), 0.0, False

        def row() -> tuple[Any, ...]:
            unknown = self.spread_of(columns) ** 2
            return (time, true.variances(), unknown.sum(-1), design.variances(), np.diag(P).copy(), mean[:n].copy(),
                    self.offsets_of(columns))  # fmt: skip

        def added(S: Array, anew: Array | None = None) -> None:
            nonlocal design
            if design is true:
                design = Shares(n, n, self.slots)
                design.C[:] = true.C
            if anew is not None:
                design.C[anew], design.C[:, :, anew] = 0.0, 0.0
            design.add(ADDED, S)

        def below(P: Array) -> Array:
            lower, there = lowered(P, self.ceiling)
            if np.any(there):
                added(lower - P)
            return lower

        for one, other in pairs(self.truth, self.believer):
            if isinstance(one, Prediction):
                if one.dt > 0 or not begun:
                    history.keep(row)
                A, shift = self.transition(one, other)
                true.through(A)
                true.process(one.Q)
                if design is not true:
                    design.through(other.Phi)
                    design.process(other.Q)
                    self.leave_out(design)
                P = below(self.carried(other.Phi @ P @ other.Phi.T + other.Q[0]))
                mean = A @ mean + shift
                columns = {name: A @ column for name, column in columns.items()}
                for name, D in one.D.items():
                    columns.setdefault(name, np.zeros((true.N, D.shape[-1])))[:n] += D
                time += one.dt
            elif isinstance(one, Update):
                K, P = gain(P, other.H, other.R, self.kept)
                A, B = self.correction(K, one, other)
                label = f"{one.name} noise"
                true.through(A)
                true.add(label, B @ one.R @ B.T)
                true.rounded()
                if design is not true:
                    design.through(np.eye(n) - K @ other.H)
                    design.add(label, K @ other.R @ K.T)
                    design.rounded()
                mean = A @ mean + B @ self.off(one, other)
                columns = {name: A @ column for name, column in columns.items()}
                for name, D in one.D.items():
                    columns[name] = columns.get(name, 0.0) + B @ D
            else:
                if self.dropped is not None and np.diagonal(other.P)[self.dropped].any():
                    raise BoresightError(
                        "budget: a step gives variance to an omitted state; leave out the step, or omit no such state"
                    )
                added(other.P, other.anew)
                P = below(without(P, other.anew) + other.P)
            begun = True
        history.keep(row, last=True)
        self.apart = design is not true  # the filter's P is not the true covariance
        return self.found(history, P, true, design, columns)

    def scaled(self, factors: Mapping[str, Array]) -> Array:
        """(B, n) true mean squares at the end where sources are so many times as large, and the filter believes so.

        factors: by source (B,); those that are not named stay.  What is added on purpose stays as well, and known
        offsets, whose effect changes with the gains.
        """
        n, wide = self.n, self.wide
        B = len(next(iter(factors.values())))

        def squared(name: str) -> Array:
            return np.asarray(factors.get(name, np.ones(B)), float) ** 2

        by_part = np.stack([squared(name) for name in self.truth.parts], axis=-1)  # (B, G)
        N = 2 * n if wide else n

        def begin(of: Flown, size: int) -> Array:
            out = np.zeros((B, size, size))
            for name, P in of.start.items():
                out[:, :n, :n] += squared(f"start {name}")[:, None, None] * P
            return out

        def through(A: Array, C: Array) -> Array:
            """A C A' of (N, B, N) by one product of large matrices."""
            size = len(C)
            return ((A @ C.reshape(size, -1)).reshape(-1, size) @ A.T).reshape(size, B, size)

        # between measurements the candidates stand in the middle, so that one product serves all
        P, C = (np.swapaxes(one, 0, 1) for one in (self.carried(begin(self.believer, n)), begin(self.truth, N)))
        apart = self.apart
        columns, mean = dict[str, Array](), np.zeros((B, N, 1))
        for one, other in pairs(self.truth, self.believer):
            if isinstance(one, Prediction):
                A, shift = self.transition(one, other)
                mean = A @ mean + shift[:, None]
                P = through(other.Phi, P)
                P += np.einsum("bg,gij->ibj", by_part, other.Q[1:])
                if apart:
                    C = through(A, C)
                    C[:n, :, :n] += np.einsum("bg,gij->ibj", by_part, one.Q[1:])
                P = np.swapaxes(lowered(self.carried(np.swapaxes(P, 0, 1)), self.ceiling)[0], 0, 1)
                columns = {name: A @ column for name, column in columns.items()}
                for name, D in one.D.items():
                    columns.setdefault(name, np.zeros((B, N, D.shape[-1])))[:, :n] += D
            elif isinstance(one, Update):
                size = squared(f"{one.name} noise")[:, None, None]
                quiet = np.maximum(size, 1e-24)  # a gain needs some noise
                K, after = gain(np.swapaxes(P, 0, 1), other.H, quiet * other.R, self.kept)
                P = np.swapaxes(after, 0, 1)
                if apart or columns or one.D:
                    A, by = self.correction(K, one, other)
                if apart:
                    moved = A @ np.swapaxes(C, 0, 1) @ np.swapaxes(A, -1, -2)
                    C = np.swapaxes(moved + by @ (size * one.R) @ np.swapaxes(by, -1, -2), 0, 1)
                    mean = A @ mean + by @ self.off(one, other)[:, None]
                columns = {name: A @ column for name, column in columns.items()}
                for name, D in one.D.items():
                    columns[name] = columns.get(name, 0.0) + by @ D
            else:
                each = without(np.swapaxes(P, 0, 1), other.anew) + other.P
                P = np.swapaxes(lowered(each, self.ceiling)[0], 0, 1)
        out = np.einsum("ibi->bi", (C if apart else P)[:n, :, :n])
        for name, part in zip(self.spread, self.of_sizes(columns, self.spread), strict=True):
            out = out + squared(name)[:, None] * np.sum(part**2, -1)
        known = sum((part.sum(-1) for part in self.of_sizes(columns, self.known)), mean[:, :n, 0])
        return out + known**2

    def of_sizes(self, columns: Mapping[str, Array], sizes: Mapping[str, Array]) -> list[Array]:
        """By parameter, columns (..., N, p) per unit times their sizes: (..., n, p), zero before one is read."""
        out = []
        for name, size in sizes.items():
            column = columns.get(name, np.zeros((self.n, len(size))))
            if len(size) not in (1, column.shape[-1]):
                raise BoresightError(f"budget: {name} has {len(size)} numbers; give one, or {column.shape[-1]}")
            out.append(column[..., : self.n, :] * size)
        return out

    def spread_of(self, columns: Mapping[str, Array]) -> Array:
        """(U, n, 1) one sigma that each constant that is not known makes."""
        each = [np.sqrt(np.sum(part**2, -1, keepdims=True)) for part in self.of_sizes(columns, self.spread)]
        return np.reshape(each, (len(each), self.n, 1))

    def offsets_of(self, columns: Mapping[str, Array]) -> Array:
        """(O, n) what each known constant makes, as a number."""
        return np.reshape([part.sum(-1) for part in self.of_sizes(columns, self.known)], (-1, self.n))

    def found(self, history: History, P: Array, true: Shares, design: Shares, columns: Mapping[str, Array]) -> Budget:
        n, model = self.n, self.truth.model
        if lacking := [name for name in (*self.spread, *self.known) if name not in columns]:
            raise BoresightError(f"budget: no measurement reads {lacking[0]!r}, and none has this name; uncertain "
                                 "takes an input of a measurement, or its name")  # fmt: skip
        times, slots, unknown, believed, variances, mean, shifts = history.columns()
        sources = [*self.slots, *self.spread]
        if len(set(sources)) < len(sources):
            raise BoresightError(f"budget: two sources are named {sources[-1]!r}; give the cause in P0 another name")
        by = np.maximum(np.concatenate([slots[:, 1:], unknown], axis=1), 0.0)  # below it is rounding
        thought = np.concatenate([believed[:, 1:], np.zeros_like(unknown)], axis=1)
        order = sorted(range(len(sources)), key=lambda s: not sources[s].startswith("start "))
        there = [s for s in order if by[:, s].any() or thought[:, s].any()]
        parts = self.of_sizes(columns, self.spread)
        squares = [part @ part.T for part in parts]
        each = np.concatenate([np.swapaxes(true.C[:n, 1:, :n], 0, 1), np.reshape(squares, (-1, n, n))])
        sign = -1.0 if self.truth.total else 1.0  # of what is left: estimated - true
        described = getattr(model, "manifest", {}).get("blocks", ())
        units = [unit for block in described for unit in units_of(block)]
        return Budget(
            model=named(model) if model is not None else "matrices",
            states=states_of(model, n),
            units=tuple(units or [""] * n),
            blocks=dict(blocks(model, n)),
            sources=tuple(sources[s] for s in there),
            times=times,
            variances=by[:, there],
            whole=slots[:, 0] + unknown.sum(1),
            known=tuple(self.known),
            offsets=shifts * sign,
            offset=(mean + shifts.sum(1)) * sign,
            design=thought[:, there],
            P_variances=variances,
            P=P,
            C=true.C[:n, 0, :n] + sum(squares),
            by_source=each[there],
            scaled=self.scaled,
        )
