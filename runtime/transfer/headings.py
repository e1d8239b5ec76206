"""A start without a master's heading: candidates all round, flown side by side, until the messages have chosen.

Velocity matching shows the heading as soon as the vehicle accelerates: a candidate that is turned by d sees each change
of velocity v turned by d, a residual of 2 v sin(d / 2).  Roll and pitch of the master count as they are.
"""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from boresight.runtime import rotation
from boresight.runtime.array import Array, wrapped
from boresight.runtime.filter import Innovation
from boresight.runtime.transfer.filter import Transfer
from boresight.runtime.transfer.history import History
from boresight.runtime.transfer.messages import Message, Note, Result
from boresight.runtime.transfer.rules import Rules
from boresight.runtime.transfer.start import Increments, estimated, first

SPACING = np.radians(7.5)  # with 15, velocity and attitude are not linear enough: NEES 25 to 60 of 16
SETTLED = np.radians(2.5)  # sigma of the candidates' mixture
FAR = 1e-6  # probability that may be left beyond the spacing
MATCHING = ("velocity", "euler")


def log_likelihood(innovations: Mapping[str, Innovation]) -> Array:
    """(...,) of one message, up to a constant of its rows."""
    total: Array = sum(
        (-0.5 * np.where(one.used, one.nu**2 / one.S + np.log(one.S), 0.0).sum(-1) for one in innovations.values()),
        start=np.zeros(()),
    )
    return total


class Headings:
    """A transfer alignment whose heading is not known: as `Transfer`, with `slave` and `master`, `nav` and `P`.

    message, model, constants, sigmas, estimates, increments: as of `first`; of the message's attitude roll and pitch
    count alone, of all messages.  spacing: rad, between candidates; each begins with a third of it as sigma.
    settings: of `Transfer`.

    loop: the Transfer that flies, of (K, ...) runs, K candidates, until in each run the heading's sigma over all of
    them is below SETTLED and what lies further than `spacing` from the likeliest has lost its probability; then of
    (...) runs, the mixture's mean and covariance, and a note says so.  nav and P are those of the mixture at any time.
    """

    def __init__(
        self,
        message: Message,
        model: Any,
        constants: Mapping[str, Any],
        *,
        sigmas: Mapping[str, Any],
        estimates: Mapping[str, Any] | None = None,
        increments: Increments,
        spacing: float = SPACING,
        rules: Rules | None = None,
        **settings: Any,
    ):
        self.rules, self.settings, self.spacing = rules or Rules(), settings, spacing
        count = round(2 * np.pi / spacing)
        level = np.asarray(self._level(message).euler_m, float)[..., :2]
        yaw = wrapped(2 * np.pi / count * np.arange(count)).reshape((-1, *(1 for _ in level.shape[:-1]), 1))
        shape = (count, *level.shape[:-1])
        euler = np.concatenate([np.broadcast_to(level, (*shape, 2)), np.broadcast_to(yaw, (*shape, 1))], axis=-1)
        R = np.array(np.broadcast_to(message.R, (*np.shape(message.R)[:-1], 6)), float)
        R[..., 5] = (spacing / 3) ** 2
        nav, P, past = first(
            replace(message, euler_m=euler, q_m2n_wxyz=None, R=R), model, constants, sigmas=sigmas,
            estimates=estimates, increments=increments, matching=MATCHING,
        )  # fmt: skip
        self.loop = Transfer(model, nav, P, constants, time=float(increments.end[-1]), past=past, matching=MATCHING,
                             rules=replace(self.rules, gate=1e-300), **settings)  # fmt: skip
        self.log_weight = np.zeros(self.loop.runs)
        self._notes: list[Note] = []
        self._estimated = estimated(self.loop.filter.model)

    def _level(self, message: Message) -> Message:
        """The message as Euler angles whose heading is absent."""
        euler = message.euler_m
        if euler is None and message.q_m2n_wxyz is not None:
            euler = rotation.euler_from_matrix(rotation.matrix_from_quaternion(message.q_m2n_wxyz))
        rows = np.asarray(message.rows) & np.array([True] * 5 + [False])
        return replace(message, euler_m=euler, q_m2n_wxyz=None, rows=rows)

    @property
    def settled(self) -> bool:
        return len(self.loop.runs) < self.log_weight.ndim

    @property
    def time(self) -> float:
        """The slave's, of `loop`."""
        return self.loop.time

    @property
    def notes(self) -> list[Note]:
        return self._notes + self.loop.notes if self.settled else self._notes

    @property
    def weight(self) -> Array:
        """(K, ...) probability of each candidate."""
        weight = np.exp(self.log_weight - self.log_weight.max(0))
        return weight / weight.sum(0)

    def slave(self, time: Any, dtheta_ib_b: Any, dv_b: Any, dt: Any) -> None:
        """As of `Transfer`."""
        self.loop.slave(time, dtheta_ib_b, dv_b, dt)

    def master(self, message: Message) -> Result:
        """As of `Transfer`; that of the likeliest candidate, while there are several."""
        result = self.loop.master(self._level(message))
        if self.settled:
            return result
        counts = result.taken | ~result.taken.any(0)
        self.log_weight = self.log_weight + np.where(counts, log_likelihood(result.innovations), -np.inf)
        self.log_weight -= self.log_weight.max(0)
        best = self.likeliest
        nav, P, apart = self._mixture()
        heading = np.abs(wrapped(apart[..., 2]))
        far = np.where(heading > self.spacing, self.weight, 0.0).sum(0)
        if ((P[..., 2, 2] < SETTLED**2) & (far < FAR)).all():
            self._settle(nav, P, best)
        likely = {
            name: Innovation(*(_of(part, best) for part in (one.nu, one.S, one.used)))
            for name, one in result.innovations.items()
        }
        rest = {name: _of(value, best) for name, value in vars(result).items() if isinstance(value, np.ndarray)}
        return replace(result, innovations=likely, **rest)

    @property
    def likeliest(self) -> Array:
        """(...,) number of the candidate."""
        best: Array = np.argmax(self.log_weight, axis=0)
        return best

    @property
    def nav(self) -> dict[str, Array]:
        return self.loop.nav if self.settled else self._mixture()[0]

    @property
    def P(self) -> Array:
        return self.loop.P if self.settled else self._mixture()[1]

    def _mixture(self) -> tuple[dict[str, Array], Array, Array]:
        """Mean and covariance of the candidates, and how far each is (K, ..., n) from the likeliest."""
        loop, best, weight = self.loop.filter, self.likeliest, self.weight[..., None]
        likely = {name: _of(value, best) for name, value in loop.nav.items()}
        apart = np.zeros(loop.P.shape[:-1])
        apart[..., 0:3] = rotation.attitude_error(loop.nav["q_b2n_wxyz"], likely["q_b2n_wxyz"])
        apart[..., 3:6] = loop.nav["v_n"] - likely["v_n"]
        for name, places in self._estimated.items():
            if "wxyz" in name:
                apart[..., places] = rotation.attitude_error(loop.nav[name], likely[name])
            else:
                apart[..., places] = (loop.nav[name] - likely[name]).reshape((*loop.P.shape[:-2], len(places)))
        mean = np.sum(weight * apart, axis=0)
        off = apart - mean
        P = np.sum(weight[..., None] * (loop.P + off[..., None] * off[..., None, :]), axis=0)
        fields = {name: likely[name] for name in loop.model.feedback.fields if name != "x"}
        corrected = loop.model.feedback(x=np.clip(-mean, -0.45, 0.45), **fields)
        return {**likely, **corrected}, (P + np.swapaxes(P, -1, -2)) / 2, apart

    def _settle(self, nav: dict[str, Array], P: Array, best: Array) -> None:
        """One filter in each run, with the likeliest candidate's past."""
        old, runs = self.loop, best.shape
        past = History(self.rules.buffer_s, int(np.prod(runs, dtype=int)))
        for sample in old.history.samples():
            time = sample.pop("time")
            past.append(time, **{n: _of(v.reshape((*old.runs, -1)), best) for n, v in sample.items()})
        notes = [
            note for note in old.notes if (best.reshape(-1)[note.runs % best.size] == note.runs // best.size).any()
        ]
        self.loop = Transfer(old.filter.model, nav, P, old.constants, time=old.time, past=past, matching=MATCHING,
                             rules=self.rules, **self.settings)  # fmt: skip
        sigma = float(np.degrees(np.sqrt(P[..., 2, 2]).max()))
        text = (
            f"the heading is known to {sigma:.2g} deg; one filter goes on in place of {len(self.log_weight)} candidates"
        )
        self._notes = [*notes, Note(old.time, np.arange(best.size), text)]


def _of(values: Array, best: Array) -> Array:
    """Of (K, ..., any) those of the candidate `best` (...)."""
    index = best[(None, ..., *(None for _ in range(values.ndim - 1 - best.ndim)))]
    return np.take_along_axis(values, index, axis=0)[0]
