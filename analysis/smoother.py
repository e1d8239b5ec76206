"""What a flight knows afterwards of each of its instants: the smoother of Rauch, Tung and Striebel over a record.

A step takes x and P to A x and A P A' + Q.  With the gain C = P A' (A P A' + Q)^-1 the smoothed state goes back by

    xs = x + C (xs_next - x_next)
    Ps = (I - C A) P (I - C A)' + C (Ps_next + Q) C'

which are sums of squares.  A measurement changes what is known of a state and not the state, so it is passed as it is.
Nothing here asks for the best gain: x - x_filter - C (x_next - x_predicted) is linear in the error of x and the noise
of this step, and what is added to it later, whatever the gains, comes from x_next and later noises.  So Ps is that of
the error of xs where states are considered, too; it is then not the least that there is.
A feedback changes the frame of the errors: A is the derivative of the errors after it by those before.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.analysis.record import BLOCKS, STEPS, Record, Table, spread
from boresight.runtime.array import Array, wrapped

STEP = 1e-3  # in the unit of a state, for differences of a feedback
EPS = np.finfo(float).eps
TOGETHER = 2**22  # numbers of matrices that are made at once


@dataclass(frozen=True)
class Smoothed:
    """The smoothed flight, step by step beside its record.

    Parameters
    ----------
    time, piece : (K,) array
        s, and the number of the piece, as in the record.
    x : (K, ..., n) array
        The state after each step.  Of an error state: by what the navigation after that step errs.
    P : (K, ..., n, n) array
        Its covariance.
    nav : dict of str to (K, ..., size) array
        Of an error state whose model has a feedback: the navigation with x taken out; else empty.

    Notes
    -----
    When not to use it: `smooth` makes it.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight.analysis.smoother import Smoothed
    >>> Smoothed(np.zeros(1), np.zeros(1), np.zeros((1, 2)), np.diag([4.0, 9.0])[None], {}).sigma
    array([[2., 3.]])
    """

    time: Array
    piece: Array
    x: Array
    P: Array
    nav: dict[str, Array]

    @property
    def sigma(self) -> Array:
        """(K, ..., n) in the units of the states."""
        return np.sqrt(np.diagonal(self.P, axis1=-2, axis2=-1))


def smooth(record: Record, *, lag_s: float | None = None) -> Smoothed:
    """Estimate each state of a flight from all that was measured in it, or until a lag behind it.

    Parameters
    ----------
    record : Record
        Of any model, in one run or many.
    lag_s : float, optional
        s.  A state takes from what was measured until so much later; without, until the end of its
        piece.

    Returns
    -------
    Smoothed
        For each step of the record.

    Raises
    ------
    BoresightError
        A lag that is negative; x or P that was not what it was before `withdrawn` measurements.

    Notes
    -----
    Rows that were masked, gated or refused, and R that was raised, are what they were in flight.
    `set_block` and `enable` begin states that know nothing of before; `inflate` is process noise;
    a ceiling of a variance adds nothing.  A considered state is smoothed by what corrects it
    elsewhere; the covariance is right, but not the least.  The inverse is that of the covariance scaled to unit
    variances: of states with a variance, or, where these depend on each other, its pseudo-inverse
    over eigenvalues above n 2.2e-16 of the largest.

    When not to use it: while flying.  Of a nonlinear model it is the extended one: where the filter
    was linearised far from the truth, the smoother is.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import CompiledFilter, Record, load, smooth
    >>> nav = {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros(3)}
    >>> loop = CompiledFilter(load("euler-matching"), nav, P=np.eye(6) * 1e-4)
    >>> record = Record(loop)
    >>> for _ in range(3):
    ...     loop.predict(omega_in_n=np.zeros(3), gyro_noise=np.full(3, 1e-4), dt=1.0)
    ...     angles = {"euler_b": loop.call("euler_angles"), "euler_m": np.full(3, 1e-3)}
    ...     found = loop.update("euler_exact", R=np.full(3, 1e-6), **angles)
    ...     loop.feedback()
    >>> done = smooth(record)
    >>> print(done.sigma[0, 3:].round(4), done.nav["mu"][0].round(4))
    [0.0071 0.0071 0.0071] [-0.0005 -0.0005 -0.0005]
    """
    if not isinstance(record, Record):
        raise BoresightError(f"smooth: {record!r} is no record; give Record(loop), or Record.open of its folder")
    if lag_s is not None and not lag_s >= 0:
        raise BoresightError(f"smooth: lag_s is {lag_s}; give 0 or more seconds, or leave it out")
    names, time, piece, x, P = record.names, record.time, record.piece, record.x.copy(), record.P
    if lag_s is not None and (names == "predict").any() and not time.any():
        raise BoresightError("smooth: no prediction has a dt, so that a lag has no meaning; leave lag_s out")
    back = Back(record, x, P)
    if lag_s is None:
        for k in range(len(names) - 2, -1, -1):
            if piece[k] == piece[k + 1]:
                x[k], P[k] = back(k, x[k + 1], P[k + 1])
    else:
        beyond = lag_s * (1 + 1e-12) + 1e-12 * time[-1]  # rounding of sums of dt
        for later in range(1, len(names)):
            rows = np.flatnonzero((piece[later:] == piece[:-later]) & (time[later:] - time[:-later] <= beyond))
            if not len(rows):
                break
            x[rows], P[rows] = back(rows, x[rows + 1], P[rows + 1])
    P = (P + np.swapaxes(P, -1, -2)) / 2
    return Smoothed(time, piece, x, P, corrected(record, x))


class Back:
    """From a step of the record to the one before it."""

    def __init__(self, record: Record, x: Array, P: Array):
        self.filtered, self.wraps = x.copy(), getattr(record.model, "wraps", ()) if record.total else ()
        shape = self.filtered.shape
        n, count = shape[-1], len(shape) - 2
        self.place = np.full(len(x), -1)  # of the matrices of the step behind a row; -1 where it is a measurement
        steps = changes(record)
        rows = np.array(sorted(steps), dtype=int)
        self.place[rows - 1] = np.arange(len(rows))
        self.gain, self.rest = (np.empty((len(rows), *shape[1:], n)) for _ in range(2))
        together = max(1, TOGETHER // int(np.prod(shape[1:]) * n))
        for begin in range(0, len(rows), together):
            some = slice(begin, begin + together)
            A, Q = (np.stack([np.broadcast_to(steps[row][i], (*shape[1:], n)) for row in rows[some]]) for i in range(2))
            before, across = P[rows[some] - 1], np.swapaxes(A, -1, -2)
            is_frame = np.reshape([steps[row][2] for row in rows[some]], (-1, *(1,) * (count + 2)))
            C = np.where(is_frame, np.linalg.inv(np.where(is_frame, A, np.eye(n))), gain(before @ across, A, Q, before))
            left = np.eye(n) - C @ A
            self.gain[some] = C
            self.rest[some] = left @ before @ np.swapaxes(left, -1, -2) + C @ Q @ np.swapaxes(C, -1, -2)

    def __call__(self, rows: Any, x: Array, P: Array) -> tuple[Array, Array]:
        """x and P of some rows, from those of the rows behind them."""
        place = self.place[rows]
        if np.ndim(place) == 0:
            return (x, P) if place < 0 else self._step(rows, place, x, P)
        x, P, moves = x.copy(), P.copy(), place >= 0
        x[moves], P[moves] = self._step(rows[moves], place[moves], x[moves], P[moves])
        return x, P

    def _step(self, rows: Any, place: Any, x: Array, P: Array) -> tuple[Array, Array]:
        C = self.gain[place]
        found = self.filtered[rows] + (C @ self.wrapped(x - self.filtered[rows + 1])[..., None])[..., 0]
        return self.wrapped(found), self.rest[place] + C @ P @ np.swapaxes(C, -1, -2)

    def wrapped(self, x: Array) -> Array:
        if len(self.wraps):
            x[..., self.wraps] = wrapped(x[..., self.wraps])
        return x


def gain(PA: Array, A: Array, Q: Array, P: Array) -> Array:
    """C = P A' (A P A' + Q)^-1 (..., n, n); of PA = P A'.  States without variance have no part in it."""
    M = A @ PA + Q
    variance = np.diagonal(M, axis1=-2, axis2=-1)
    known = ~(variance > 0)
    scale = np.sqrt(np.where(known, 1.0, variance))
    M = M / (scale[..., :, None] * scale[..., None, :])
    M = np.where(known[..., :, None] | known[..., None, :], np.eye(M.shape[-1]), (M + np.swapaxes(M, -1, -2)) / 2)
    B = np.where(known[..., None, :], 0.0, PA / scale[..., None, :])
    try:
        np.linalg.cholesky(M)
        C = np.swapaxes(np.linalg.solve(M, np.swapaxes(B, -1, -2)), -1, -2)
    except np.linalg.LinAlgError:  # of one of them at least, states depend on each other
        C = B @ np.linalg.pinv(M, rcond=M.shape[-1] * EPS, hermitian=True)
    return C / scale[..., None, :]


def changes(record: Record) -> dict[int, tuple[Array, Array, bool]]:
    """By row of the record, A and Q (..., n, n) of each step that measures nothing, and whether A changes the frame."""
    n = record.x.shape[-1]
    steps: dict[int, tuple[Array, Array, bool]] = {}
    for name in ("feedback", *BLOCKS):
        for table in record.tables(name):
            A, Q = (
                (frames(record, table), np.zeros((len(table.rows), n, n))) if name == "feedback" else blocks(table, n)
            )
            steps |= {row: (A[k], Q[k], name == "feedback") for k, row in enumerate(table.rows)}
    predicted = record.tables("predict")
    if predicted:
        Phi, Q, rows = record.Phi(), record.Q(), record.rows("predict")
        for table in predicted:
            kept = 1 - table.given.get("disabled", np.zeros((len(table.rows), n)))
            for k, row in enumerate(table.rows):
                at = np.searchsorted(rows, row)
                steps[row] = kept[k][:, None] * Phi[at], kept[k][:, None] * Q[at] * kept[k], False
    measures = ~np.isin(record.names, ("begin", "withdrawn", *STEPS))
    for row in record.rows("withdrawn"):
        x, P = record.x[row], record.covariance(row)
        before = row - 1 - int(np.argmin(measures[row - 1 :: -1]))  # the last step that was no measurement
        same = [(x == record.x[k]).all(-1) & (record.covariance(k) == P).all((-1, -2)) for k in (row - 1, before)]
        if not np.logical_or(*same).all():
            raise BoresightError(
                f"smooth: at {record.time[row]:g} s measurements were withdrawn, and x or P is not what it was before "
                "them; assign both, or begin a new piece"
            )
    return steps


def blocks(table: Table, n: int) -> tuple[Array, Array]:
    """A (K, n, n) and Q (K, ..., n, n) of a change of some states: begun anew, left out, or with more noise."""
    given, count = table.given, len(table.rows)
    added = given.get("variance", given.get("block", np.zeros((count, 1, 1))))
    if table.name == "inflate":
        added = added[..., None] * np.eye(added.shape[-1])
    A, Q = np.tile(np.eye(n), (count, 1, 1)), np.zeros((*added.shape[:-2], n, n))
    for k, first in enumerate(given["first"].astype(int)):
        states = slice(first, first + (int(given["count"][k]) if table.name == "disable" else added.shape[-1]))
        if table.name != "disable":
            Q[k, ..., states, states] = added[k]
        if table.name != "inflate":
            A[k, states, states] = 0.0
    return A, Q


def frames(record: Record, table: Table) -> Array:
    """(K, ..., n, n) the derivative of the errors after each feedback by those before, at what it took out.

    Both navigations err from one truth: feedback(nav, x + d) = feedback(fed, A d) to first order in d.
    """
    x, n = record.x, record.x.shape[-1]
    taken, one = x[table.rows - 1], np.eye(n)
    before = {name[4:]: value for name, value in table.given.items() if name.startswith("nav ")}
    if not before or "taken" in table.given:  # by hand
        return np.broadcast_to(one, (*taken.shape, n))
    box = getattr(record.model, "field", {}).get("x")
    room = np.full(n, 1.0) if box is None else np.minimum(1.0, np.array(box["high"]) - np.array(box["low"]))
    after = {name: value[table.rows] for name, value in record.nav.items()}
    before = {name: spread(record, name, value) for name, value in before.items()}

    def derivative(nav: dict[str, Array], at: Array) -> tuple[Array, Array]:
        """(K, ..., m, n) of the navigation that is fed back, and by how much rounding leaves it open."""
        nav = {name: value[(slice(None),) * (at.ndim - 1) + (None,)] for name, value in nav.items()}
        ahead, behind = (flat(record, nav, at[..., None, :] + sign * STEP * room * one) for sign in (1, -1))
        steps = 2 * STEP * room[:, None]
        return np.swapaxes((ahead - behind) / steps, -1, -2), np.swapaxes(8 * EPS * np.abs(ahead) / steps, -1, -2)

    (old, open_old), (new, open_new) = derivative(before, taken), derivative(after, np.zeros_like(taken))
    differ = np.where(np.abs(new - old) > open_old + open_new, new - old, 0.0)
    to_old = one + np.linalg.pinv(old) @ differ  # a state that is in no navigation keeps its frame
    inverse: Array = np.linalg.inv(to_old)
    return inverse


def flat(record: Record, nav: dict[str, Array], x: Array) -> Array:
    """What the model's feedback gives, its outputs after one another; (..., m)."""
    unit, known = record.model.feedback, {**nav, "x": x}
    found = unit(**{name: known[name] for name in unit.fields})
    parts = found.values() if isinstance(found, dict) else [found]
    runs = x.shape[:-1]
    return np.concatenate([np.reshape(part, (*runs, -1)) for part in parts], axis=-1)


def corrected(record: Record, x: Array) -> dict[str, Array]:
    """The navigation after each step with x taken out; {} of a model without a feedback."""
    if record.total or not hasattr(record.model, "feedback"):
        return {}
    unit, known = record.model.feedback, {**record.nav, "x": x}
    if any(name not in known for name in unit.fields):
        return {}
    found = unit(**{name: known[name] for name in unit.fields})
    return {**record.nav, **(found if isinstance(found, dict) else {next(iter(record.nav)): found})}
