"""Which errors a motion shows, and how soon: a filter's covariance with H taken along the true motion.

An H at estimates that are wrong pretends to information that is not there; along the truth it does not.  Deterministic.
`observe` follows any model along a nominal flight; `along` a covariance of many runs with an H of one's own.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from boresight.analysis.figures import Sheets
from boresight.analysis.linear import Flown, Prediction, Update, gain, pairs, states_of
from boresight.errors import BoresightError
from boresight.runtime.array import Array
from boresight.runtime.filter import Filter


@dataclass(frozen=True)
class Replaced:
    """A model with some functions exchanged, each with its `.fields`."""

    model: Any
    functions: dict[str, Any]

    def __getattr__(self, name: str) -> Any:
        return self.functions[name] if name in self.functions else getattr(self.model, name)


def with_fields(function: Any, *fields: str) -> Any:
    """The function, saying what it takes as a compiled one does."""
    function.fields = fields
    return function


@dataclass(frozen=True)
class Moment:
    """One step: what Phi and Q are called with, and then, if H is given, a measurement."""

    inputs: dict[str, Any]
    H: Array | None = None  # (..., m, n)
    R: Array | None = None  # (..., m) variances
    rows: Any = True  # (..., m) bool


def taken_over(C_b2n: Array, sigma: float) -> Array:
    """(..., 6, 6) of [eps dmu] of a slave that takes the master's attitude for its own: eps = -C dmu.

    Exact, with mu_hat = 0: exp(-[C mu x]) C exp([mu x]) = C.  sigma: rad, of the misalignment about each axis.
    """
    couple = np.concatenate([C_b2n, np.broadcast_to(-np.eye(3), C_b2n.shape)], axis=-2)
    P: Array = sigma**2 * couple @ np.swapaxes(couple, -1, -2)
    return P


def along(model: Any, P0: Array, steps: Iterable[Moment]) -> Iterator[Array]:
    """The covariance of a filter with H along the true motion: what a motion makes observable.

    An H at estimates that are wrong pretends to information that is not there; along the truth it
    does not.  Deterministic: no noise is drawn and no state is estimated.

    Parameters
    ----------
    model : Library, or any object with Phi and Q
        An error state, or a total state whose Phi and Q the steps give inputs for.
    P0 : (..., n, n) array
        Covariance at the start.
    steps : iterable of Moment
        Of each `inputs`, what Phi and Q are called with at the truth; and, where something is
        measured, `H` (..., m, n), `R` (..., m) variances, `rows` (..., m) bool.

    Yields
    ------
    (..., n, n) array
        P after each step, in the states' units.

    Raises
    ------
    BoresightError
        Inputs that the model does not have, P0 that is no covariance, R that is not above zero.

    Notes
    -----
    When not to use it: to ask how large the errors of a flight are; that is what `Consistency`
    shows.  A variance that falls says that a motion informs a state, not that a filter uses it
    rightly.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import load, observability
    >>> inputs = {"q_b2n_wxyz": [1, 0, 0, 0], "omega_in_n": np.zeros(3), "dt": 1.0,
    ...           "gyro_noise": np.full(3, 1e-5)}
    >>> H = np.hstack([np.eye(3), np.eye(3)])  # attitude and mounting, seen as their sum
    >>> step = observability.Moment(inputs, H, R=np.full(3, 1e-8))
    >>> *_, P = observability.along(load("euler-matching"), np.eye(6) * 1e-4, [step] * 10)
    >>> print(np.sqrt(np.diag(P)).round(4))
    [0.0071 0.0071 0.0071 0.0071 0.0071 0.0071]
    """

    def known_H(H: Array) -> Array:
        return H

    def no_z(H: Array) -> Array:
        return np.zeros(H.shape[:-1])

    known = Replaced(model, {"known_z": with_fields(no_z, "H"), "known_H": with_fields(known_H, "H")})
    flown = Filter(known, {}, P0)
    for moment in steps:
        flown.predict(**moment.inputs)
        if moment.H is not None:
            flown.update("known", moment.R, rows=moment.rows, H=moment.H)
        yield flown.P


def since(true: Array) -> Array:
    """Number of the first sample from which on (T, ...) stays true to the end; nan where the last one is not."""
    stays = np.flip(np.logical_and.accumulate(np.flip(true, axis=0), axis=0), axis=0)
    return np.where(stays.any(0), stays.argmax(0), np.nan)


# ---------------------------------------------------------------- what a motion shows of a model's states

HALF = 0.5  # of the sigma at the start: below it for good, a state is observable
PART = 0.3  # of the largest component of a direction: what it is made of


@dataclass(frozen=True)
class Observed:
    """What one flight shows of each state.

    Parameters
    ----------
    states : tuple of str
        Names.
    labels : tuple of str
        The same in words.
    times : (K + 1,) array
        s, from the start on; K instants.
    sigma : (K + 1, n) array
        In the units of the states, after all that was measured at that instant.
    start, P : (n, n) array
        Covariance at the start and at the end.
    information : (n, n) array
        What was measured tells of the state at the start, without process noise, in sigmas of the
        start: sum of (H Psi)' R^-1 H Psi.

    Notes
    -----
    When not to use it: `observe` makes it.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight.observability import Observed
    >>> sigma = np.array([[2.0, 1.0], [0.5, 1.0]])
    >>> P0, P = (np.diag(row**2) for row in sigma)
    >>> one = Observed(("a", "b"), ("a", "b"), np.array([0.0, 1.0]), sigma, P0, P, np.diag([15.0, 0.0]))
    >>> one.part, one.seconds, one.worst()
    (array([0.25, 1.  ]), array([ 1., nan]), 'b alone: 1.00 of its sigma at the start is left')
    """

    states: tuple[str, ...]
    labels: tuple[str, ...]
    times: Array
    sigma: Array
    start: Array
    P: Array
    information: Array

    @property
    def part(self) -> Array:
        """(n,) sigma at the end over sigma at the start; nan of a state without variance at the start."""
        return np.where(self.sigma[0] > 0, self.sigma[-1] / np.where(self.sigma[0] > 0, self.sigma[0], 1.0), np.nan)

    @property
    def seconds(self) -> Array:
        """(n,) s until sigma stays below half of what it was at the start; nan where it does not."""
        first = since(self.sigma < HALF * self.sigma[0])
        known = np.where(np.isnan(first), 0, first).astype(int)
        return np.where(np.isnan(first), np.nan, self.times[known])

    @property
    def condition(self) -> float:
        """Largest over smallest eigenvalue of `information`; infinite where a direction was never shown."""
        some = self.sigma[0] > 0
        values = np.linalg.eigvalsh(self.information[np.ix_(some, some)])
        lowest = values[0] if values[0] > len(values) * np.finfo(float).eps * values[-1] else 0.0
        return float(values[-1] / lowest) if lowest > 0 else float("inf")

    @property
    def direction(self) -> tuple[Array, float]:
        """The unit direction (n,), in sigmas of the start, of which most is left, and which part of its sigma."""
        scale = np.where(self.sigma[0] > 0, self.sigma[0], np.inf)
        before, after = (P / scale[:, None] / scale for P in (self.start, self.P))
        vector = np.linalg.eigh(after)[1][:, -1]
        return vector, float(np.sqrt((vector @ after @ vector) / (vector @ before @ vector)))

    def worst(self) -> str:
        """The direction of which most is left, in words.

        Returns
        -------
        str
            Its states, the correlation of the first two at the end, and what is left of its sigma.
        """
        vector, left = self.direction
        order = np.argsort(-np.abs(vector), kind="stable")
        places = [int(i) for i in order if abs(vector[i]) >= PART * abs(vector[order[0]])]
        one, *others = places
        linked = {i: self.P[one, i] / np.sqrt(self.P[one, one] * self.P[i, i]) for i in others}
        others = [i for i in others if abs(linked[i]) >= PART]  # of directions with as much left, any mixture may come
        if not others:
            return f"{self.labels[one]} alone: {self.part[one]:.2f} of its sigma at the start is left"
        two, *more = others
        how = "together" if linked[two] >= 0 else "against each other"
        beside = f", with {', '.join(self.labels[i] for i in more[:3])}" if more else ""
        return (
            f"{self.labels[one]} and {self.labels[two]} move {how}, {abs(linked[two]):.2f}{beside}; {left:.2f} is left"
        )

    def document(self) -> dict[str, Any]:
        """All of it for JSON; None for what is not finite."""

        def plain(values: Array) -> list[float | None]:
            return [float(v) if np.isfinite(v) else None for v in values]

        vector, left = self.direction
        return {
            "seconds": float(self.times[-1]),
            "states": list(self.states),
            "sigma_start": plain(self.sigma[0]),
            "sigma_end": plain(self.sigma[-1]),
            "part": plain(self.part),
            "seconds_to_half": plain(self.seconds),
            "condition": self.condition if np.isfinite(self.condition) else None,
            "worst": {"words": self.worst(), "direction": plain(vector), "left": left},
        }


def observe(model: Any, P0: Any, steps: Iterable[Any], *, x: Any = None) -> Observed:
    """What a flight shows of each state of a model, by the covariance along its nominal motion.

    The posterior Cramer-Rao bound of the flight in covariance form, which takes a Q that is singular.
    No random number is drawn.

    Parameters
    ----------
    model : Library, or any object with the functions Phi, Q and NAME_H
        Of any model, of an error or of a total state.
    P0 : (n, n) array, or dict of str to (n, n) or (n,) array
        Covariance at the start, or its independent causes; of (n,) they are sigmas.
    steps : iterable
        As of `budget`: a dict of inputs is a prediction; (name, R, inputs) or (name, R, inputs, rows)
        a measurement.
    x : (n,) array, optional
        Where a total state begins; it goes on by `next`.

    Returns
    -------
    Observed

    Raises
    ------
    BoresightError
        A step that the model cannot fly, P0 that is no covariance.

    Notes
    -----
    When not to use it: to learn how large the errors of a filter are that believes something wrong;
    that is `budget`.  A sigma that stays where it was says that this flight does not show a state; it
    does not say that no flight does.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import load, observability
    >>> q = [1.0, 0, 0, 0]
    >>> predict = {"q_b2n_wxyz": q, "omega_in_n": np.zeros(3), "gyro_noise": np.full(3, 1e-5), "dt": 1.0}
    >>> angles = {"euler_b": np.zeros(3), "euler_m": np.zeros(3)}
    >>> flight = [predict, ("euler", np.full(3, 1e-8), angles)] * 20
    >>> found = observability.observe(load("euler-matching"), {"eps": np.repeat([0.01, 0.0], 3),
    ...                                                        "dmu": np.repeat([0.0, 0.01], 3)}, flight)
    >>> print(found.part.round(2), found.worst().split(",")[0])
    [0.71 0.71 0.71 0.71 0.71 0.71] attitude error n and misalignment error x move against each other
    """
    try:
        return followed(Flown(model, P0, list(steps), None, x, ()))
    except BoresightError as error:
        raise BoresightError(str(error).replace("budget:", "observe:", 1)) from None


def followed(flown: Flown) -> Observed:
    n = flown.n
    P = sum(flown.start.values(), np.zeros((n, n)))
    P0, start = P, np.sqrt(np.diag(P))
    if not start.any():
        raise BoresightError("observe: no state has a variance at the start; give P0 the initial sigmas")
    Psi, information = np.diag(start), np.zeros((n, n))
    times, sigmas, time, measured = [0.0], [start], 0.0, False

    def keep() -> None:
        if len(times) > 1 and times[-1] == time:  # the first row is the start
            sigmas[-1] = np.sqrt(np.diag(P))
        else:
            times.append(time)
            sigmas.append(np.sqrt(np.diag(P)))

    for step, _ in pairs(flown, flown):
        if isinstance(step, Prediction):
            if measured:
                keep()
            time, measured = time + step.dt, False
            P, Psi = step.Phi @ P @ step.Phi.T + step.Q[0], step.Phi @ Psi
            P = (P + P.T) / 2
        elif isinstance(step, Update):
            _, P = gain(P, step.H, step.R, None)
            seen = np.linalg.solve(np.linalg.cholesky(step.R), step.H @ Psi)
            information, measured = information + seen.T @ seen, True
        else:
            raise BoresightError(
                "observe: a step is neither a prediction nor a measurement; leave out inflate, set_block and enable"
            )
    keep()
    names = states_of(flown.model, n)
    return Observed(names, words(flown.model, names), np.array(times), np.array(sigmas), P0, P, information)


def words(model: Any, states: tuple[str, ...]) -> tuple[str, ...]:
    """The states as their meaning says, with the component: "gyro bias z"."""
    out = []
    for block in getattr(model, "manifest", {}).get("blocks", ()):
        meaning = block["meaning"].split(",")[0].removeprefix("error of the ").strip()
        for name in block["components"]:
            out.append(meaning if block["size"] == 1 else f"{meaning} {name.rpartition('_')[2]}")
    return tuple(out) if len(set(out)) == len(states) else tuple(states)


def cell(part: float, seconds: float) -> str:
    """Of one state and motion."""
    if np.isnan(part):
        return "known"
    return f"{part:.3f}" + ("        " if np.isnan(seconds) else f"{seconds:6.4g} s")


def report(found: Mapping[str, Observed]) -> str:
    """Motions beside each other: of each state what is left of its sigma, and after which time half of it was.

    Parameters
    ----------
    found : mapping of str to Observed
        By motion.

    Returns
    -------
    str
        A table in text.
    """
    first = next(iter(found.values()))
    wide = max(len("state"), *map(len, first.states))
    lines = ["sigma at the end / at the start, and the seconds until it stays below half"]
    columns = [[name, *map(cell, one.part, one.seconds)] for name, one in found.items()]
    room = [max(map(len, column)) + 2 for column in columns]
    for label, *row in zip(("state", *first.states), *columns, strict=True):
        lines.append((label.ljust(wide) + "".join(map(str.rjust, row, room))).rstrip())
    lines.append("")
    for name, one in found.items():
        lines.append(f"{name}, {one.times[-1]:g} s: {one.worst()}")
        lines.append(f"  condition number of the information: {one.condition:.2g}")
    return "\n".join(lines) + "\n"


def draw(found: Mapping[str, Observed], sheets: Sheets) -> None:
    """The table as a figure: states down, motions across, the darker the more is left.

    Parameters
    ----------
    found : mapping of str to Observed
        By motion.
    sheets : Sheets
        Where it goes.
    """
    first = next(iter(found.values()))
    parts = np.array([one.part for one in found.values()]).T
    with sheets("observe", 2.2 + 1.1 * len(found), 0.8 + 0.26 * len(first.states)) as (_, ax):
        ax.imshow(np.clip(parts, 0, 1), cmap="Blues", vmin=0, vmax=1.4, aspect="auto")
        ax.grid(visible=False)
        ax.set_yticks(range(len(first.states)), first.labels)
        ax.set_xticks(range(len(found)), list(found))
        ax.tick_params(length=0)
        for j, one in enumerate(found.values()):
            for i, (part, seconds) in enumerate(zip(one.part, one.seconds, strict=True)):
                after = "" if np.isnan(seconds) else f"\n{seconds:.3g} s"
                text = "known" if np.isnan(part) else f"{part:.2g}{after}"
                ax.text(j, i, text.replace("\n", "  "), ha="center", va="center", fontsize=7,
                        color="white" if part > 0.8 else "0.15")  # fmt: skip
        ax.set_title("sigma at the end / at the start; seconds until it stays below half")
