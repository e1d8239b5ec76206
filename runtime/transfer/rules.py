"""What is done with input that is not as it should be, and the lines that say so."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.filter import Innovation
from boresight.runtime.transfer.lever import LeverSeen
from boresight.runtime.transfer.messages import Heard, Note, Result, Verdict

AXES = {
    "v_m_n": ("north", "east", "down"),
    "q_m2n_wxyz": ("north", "east", "down"),
    "euler_m": ("roll", "pitch", "yaw"),
}
ROWS = ("velocity north", "velocity east", "velocity down", "the level", "the level", "the heading")
RATE_KNOWN_S = 10.0  # before two messages have come, their rate is not known: silence is told after so long
INTERVALS = 3.5  # of the master, without a message taken, are silence
STILL = 5.0  # sigmas: chance moves one of six numbers so far once in 300 000 messages


@dataclass(frozen=True)
class Rules:
    """What `Transfer` does with input that is not as it should be.

    Parameters
    ----------
    buffer_s : float, optional
        s: how much of the slave's past is kept; an older message is refused.
    ahead_s : float, optional
        s: how far beyond the slave's newest sample a message may lie; the slave is extrapolated.
    half_span_s : float, optional
        s: rates are means, and rates of change differences, over twice this.
    delay_sigmas : float, optional
        How far above their noise the rates are in a message that informs the delay.
    gate : float, optional
        A message is refused if chance alone would exceed its NIS with this probability.
    coarse_rad, coarse_s : float, optional
        rad, s: at first the gate is open while the sigma of an angle, or of the delay, is above
        these.
    settle_s : float, optional
        s: and so long after that.
    reopen_after : int, optional
        Messages gated in a row, after which velocity and attitude are opened.
    silent_s : float, optional
        s without a message taken, after which a note says so; of a slow master 3.5 of its
        intervals.
    full_scale : (float, float), optional
        Of the slave: rad/s and m/s^2; None for sensors without one.
    overshoot : float, optional
        One sigma of what a saturated axis misses, as a part of full scale.
    bridge_s : float, optional
        s of the slave's data that may be missing and is bridged; at most half of buffer_s.
    quiet_s : float, optional
        s: the same verdict on the same run is noted a second time only after this.

    Raises
    ------
    BoresightError
        A span, gate or silence that is not above zero, a bridge beyond half of the buffer,
        reopen_after below 1.

    Notes
    -----
    When not to use it: as a means to make a filter fit a recording.  The rules are for faults;
    noises and sizes of errors belong to `constants` and to `transfer.sensors`.

    Examples
    --------
    >>> from boresight import transfer
    >>> transfer.Rules(full_scale=(5.0, 100.0)).buffer_s
    0.5
    """

    buffer_s: float = 0.5
    ahead_s: float = 0.02
    half_span_s: float = 0.02
    delay_sigmas: float = 8.0
    gate: float = 1e-6
    coarse_rad: float = 0.1
    coarse_s: float = 0.05
    settle_s: float = 5.0
    reopen_after: int = 5
    silent_s: float = 1.0
    full_scale: tuple[float, float] | None = None
    overshoot: float = 0.5
    bridge_s: float = 0.1
    quiet_s: float = 5.0

    def __post_init__(self) -> None:
        for name in ("buffer_s", "half_span_s", "gate", "silent_s"):
            if not getattr(self, name) > 0:
                raise BoresightError(f"transfer: {name} is {getattr(self, name)}; it must be above zero")
        if not 0 <= self.bridge_s <= self.buffer_s / 2:
            raise BoresightError(f"transfer: bridge_s is {self.bridge_s}; it must be at most half of buffer_s")
        if self.reopen_after < 1:
            raise BoresightError(f"transfer: reopen_after is {self.reopen_after}; it must be at least 1")


class Watch:
    """What the rules remember, run by run, and the lines that they have written."""

    def __init__(self, rules: Rules, runs: tuple[int, ...], time: float):
        self.rules, self.runs, self.time = rules, runs, time
        self.notes: list[Note] = []
        self.counts = {code: np.zeros(runs, int) for code in Verdict}
        self.saturated_s = np.zeros((*runs, 6))  # without a break
        self.at_full = np.zeros((*runs, 2), bool)  # told, and its end not yet
        self.saturated_at = np.full((*runs, 6), -np.inf)
        self.stamp = np.full(runs, -np.inf)  # of the last message looked at
        self.taken_at = np.full(runs, time)
        self.silent = np.zeros(runs, bool)
        self.fine_at = np.full(runs, -np.inf)  # from when on the gate works
        self.acquired = np.zeros(runs, bool)
        self.refused = np.zeros(runs, int)  # in a row, for whatever reason
        self.told_at = np.full((len(Verdict), *runs), -np.inf)
        self.open = np.zeros(runs, bool)  # a refusal was told, its end not yet
        self.seen = LeverSeen.nothing(runs)
        self.lever_told = np.zeros(runs, bool)
        self.last: dict[str, Array] = {}  # what the last message said, and what was expected of it, with its variance
        self.count = np.full(runs, np.nan)  # of the last message looked at
        self.interval = np.full(runs, np.nan)  # s between messages, mean of the last ones
        self.came_at = np.full(runs, np.nan)
        self.absent = {kind: np.zeros((*runs, 7), bool) for kind in ("masked", "spoilt")}  # told, and its end not yet
        self.absent_at = np.full((*runs, 7), -np.inf)

    def saturation(self, dtheta: Array, dv: Array, dt: float) -> Array | None:
        """(..., 6) rad^2 and (m/s)^2 that P gains where an axis is at full scale: of one sign while it lasts."""
        gyro, accel = self.rules.full_scale or (np.inf, np.inf)
        full = np.repeat([gyro, accel], 3)
        seen = np.abs(np.concatenate([dtheta, dv], axis=-1)) >= full * dt * (1 - 1e-9)
        before = self.saturated_s
        since = self.time - self.saturated_at
        for i, what in enumerate(("gyro", "accelerometer")):
            # an axis in noise crosses its full scale many times: told once, and its end after a while within
            axes = slice(3 * i, 3 * i + 3)
            now, told = seen[..., axes].any(-1), self.at_full[..., i]
            within = told & (since[..., axes].min(-1) > self.rules.silent_s) & ~now
            self.note(now & ~told, f"the slave's {what} is at full scale; its noise is opened")
            self.note(within, f"the slave's {what} has been within its range again for {self.rules.silent_s:g} s")
            self.at_full[..., i] = (told | now) & ~within
        if not (seen.any() or before.any()):
            return None
        self.saturated_at = np.where(seen, self.time, self.saturated_at)
        self.saturated_s = np.where(seen, before + dt, 0.0)
        missed = self.rules.overshoot * np.where(seen, full, 0.0)  # full scale may be infinite: of a sensor without one
        variance: Array = missed**2 * (self.saturated_s**2 - np.where(seen, before, 0.0) ** 2)
        return variance

    def silence(self) -> None:
        """Write down that no message was taken for a while, as the master's own rate has it."""
        patience = np.fmax(
            self.rules.silent_s, np.where(np.isnan(self.interval), RATE_KNOWN_S, INTERVALS * self.interval)
        )
        silent = self.time - self.taken_at > patience
        new = silent & ~self.silent
        if new.any():
            seconds = float(patience[new].max())
            self.note(new, f"no message of the master was taken for {seconds:.3g} s; the slave goes on alone")
        self.silent = silent

    def came(self, some: Array) -> None:
        """Learn the master's rate.  some: (...,) bool, the runs to which a message came."""
        longest = np.where(np.isnan(self.interval), np.inf, np.fmax(self.rules.silent_s, INTERVALS * self.interval))
        gap = np.minimum(self.time - self.came_at, longest)  # a pause is no rate
        known = np.where(np.isnan(self.interval), gap, self.interval + (gap - self.interval) / 8)
        self.interval = np.where(some, known, self.interval)
        self.came_at = np.where(some, self.time, self.came_at)

    def partly(self, heard: Heard, attitude: str) -> None:
        """Write down which parts of the messages are not there, once until they have been there for a while."""
        names = [f"velocity {axis}" for axis in AXES["v_m_n"]] + [f"attitude {axis}" for axis in AXES[attitude]]
        names.append("position")
        whole = heard.rows.any(-1, keepdims=True)
        no_place = whole & ~np.isfinite(np.zeros(3) if heard.position is None else heard.position).all(
            -1, keepdims=True
        )
        masked = np.concatenate([whole & heard.masked, np.zeros_like(whole)], axis=-1)
        spoilt = np.concatenate([whole & heard.spoilt, no_place], axis=-1)

        def each(where: Array, text: str) -> None:
            """One line for each set of names."""
            for which in np.unique(where.reshape(-1, 7), axis=0):
                if which.any():
                    listed = ", ".join(name for name, one in zip(names, which, strict=True) if one)
                    for kind in ("velocity", "attitude"):
                        listed = listed.replace(", ".join(n for n in names if n.startswith(kind)), kind)
                    self.note((where == which).all(-1), text.format(what=listed))

        for kind, where, text in (
            ("masked", masked, "the master's messages come without {what}"),
            (
                "spoilt",
                spoilt,
                "of the master's message {what} is not finite or beyond the model's range, and is left out",
            ),
        ):
            if (new := where & ~self.absent[kind]).any():
                each(new, text)
            self.absent[kind] |= where
        self.absent_at = np.where(masked | spoilt, self.time, self.absent_at)
        told = self.absent["masked"] | self.absent["spoilt"]
        if told.any():
            again = told & whole & (self.time - self.absent_at > self.rules.quiet_s)
            each(again, "the master's message holds {what} again")
            for kind in self.absent:
                self.absent[kind] &= ~again

    def fine(self, coarse: Array, some: Array) -> Array:
        """(...,) bool: whether the gate works.  coarse: angles or delay are not known yet; some: a row was used."""
        self.fine_at = np.where(coarse & ~self.acquired & some, self.time + self.rules.settle_s, self.fine_at)
        fine: Array = self.time >= self.fine_at
        self.acquired |= fine & some  # what is opened later is opened on purpose
        return fine

    def lever(self, innovation: Innovation, rows: Array, inputs: dict[str, Any]) -> None:
        C = rotation.matrix_from_quaternion(inputs["q_b2n_wxyz"])
        self.seen = self.seen.with_message(innovation.nu, innovation.S, rows, C, inputs["omega_ib_b"])
        suspect = self.seen.suspect
        self.note(suspect & ~self.lever_told, "the velocity residuals are too large and move with the turning of the "
                   "hull: compare the lever arm and its sign (from master to slave, in the slave's axes)")  # fmt: skip
        self.lever_told |= suspect

    def repeats(
        self, said: dict[str, Array], rows: Array, expected: dict[str, Array], variance: Array, R: Array
    ) -> Array:
        """(...,) bool: the same numbers as in the last message, while the hull has moved.

        It has moved where what is expected did so by more than its errors, then and now, and the master's noise allow.
        variance: (..., 6) of what is expected.  As it grows a refusal ends: a master that stands still is believed.
        """
        seen = rows.any(-1)
        new = said | {f"expected {name}": expected[name] for name in ("v_m_n", "q_m2n_wxyz")} | {"variance": variance}
        last = self.last if self.last.keys() == new.keys() else {n: np.full_like(v, np.nan) for n, v in new.items()}
        same = seen & np.all([(value == last[name]).all(-1) for name, value in said.items()], axis=0)
        # what was expected when these numbers came first is kept, so that a slow motion shows too
        fresh = (seen & ~same)[..., None]
        self.last = {name: np.where(fresh, value, last[name]) for name, value in new.items()}
        if not same.any():
            return same
        turn = np.zeros_like(expected["v_m_n"])
        turn[same] = rotation.attitude_error(last["expected q_m2n_wxyz"][same], expected["q_m2n_wxyz"][same])
        change = np.concatenate([expected["v_m_n"] - last["expected v_m_n"], turn], axis=-1)
        # two errors that are not independent differ by no more than the sum of their sigmas
        most = (np.sqrt(variance) + np.sqrt(last["variance"])) ** 2 + 2 * R
        return same & (rows & (change**2 > STILL**2 * most)).any(-1)

    def result(self, verdict: Array, innovations: dict[str, Innovation], nis: Array, used: Array, lag: Array,
               heard: Heard, known_s: float, faults: list[tuple[Array, str]], worst: Array) -> Result:  # fmt: skip
        """What a message did, written down.

        known_s: how far back the slave's past is known.  faults: (...,) bool and why, of runs that the text of a
        verdict alone does not explain.  worst: (...,) the row that fits worst, by number.
        """
        stamp = heard.time
        taken, came = verdict <= Verdict.REOPENED, verdict != Verdict.ABSENT
        came_to = [Verdict(code) for code in np.unique(verdict)]
        for code in came_to:
            self.counts[code] += verdict == code
        saying = {
            Verdict.GATED: "message refused: it does not fit (NIS {nis:.0f} with {used} rows; {worst} fits worst)",
            Verdict.INVALID: "message refused: {why}",
            Verdict.BEYOND: "message refused: {why}",
            Verdict.OUT_OF_ORDER: "message refused: its time, {stamp:.3f} s, is not later than the last one's",
            Verdict.AHEAD: "message refused: it lies {ahead:.3f} s ahead of the slave; compare the clocks, or the "
            "slave's data have stopped",
            Verdict.TOO_OLD: f"message refused: it is {{lag:.3f}} s old and the past is known for {known_s:.3f} s"
            + ("; raise buffer_s" if known_s >= self.rules.buffer_s else ", so far"),
            Verdict.SATURATED: "message refused: the slave was at full scale when it was measured, or since",
            Verdict.MISSED: "message refused: samples of the slave were missing when it was measured, or since",
            Verdict.REPEATED: "message refused: {why}",
        }  # fmt: skip
        for code, text in saying.items():
            if code not in came_to:
                continue
            where = (verdict == code) & (self.time - self.told_at[code] >= self.rules.quiet_s)
            if not where.any():
                continue
            self.told_at[code] = np.where(where, self.time, self.told_at[code])
            self.open |= where & (verdict > Verdict.REOPENED)
            for which, why in faults if "{why}" in text else [(where, "")]:
                now, where = where & which, where & ~which
                if now.any():
                    first = np.unravel_index(np.argmax(now), now.shape)
                    numbers = {"nis": nis, "used": used, "lag": lag, "ahead": -lag, "stamp": stamp} | heard.numbers
                    numbers["worst"] = np.asarray(np.array(ROWS)[np.clip(worst, 0, 5)])  # one run gives no array
                    line = text.replace("{why}", why)
                    self.note(now, line.format(**{name: value[first] for name, value in numbers.items()}), "{" in line)
        returned = taken & self.silent
        if returned.any():
            longest = float(np.max(np.where(returned, self.time - self.taken_at, 0.0)))
            self.note(returned, f"the master is back after {longest:.1f} s")
        again = taken & self.open & ~returned
        if again.any():
            most = int(np.max(np.where(again, self.refused, 0)))
            self.note(again, f"messages are taken again, after {most} refused")
        self.open &= ~taken
        self.refused = np.where(taken, 0, self.refused + came)
        looked_at = came & (verdict != Verdict.AHEAD) & (verdict != Verdict.INVALID)
        self.stamp = np.where(looked_at, np.fmax(stamp, self.stamp), self.stamp)
        self.count = np.where(looked_at, heard.count, self.count)
        self.came(came)
        self.taken_at = np.where(taken, self.time, self.taken_at)
        self.silent = self.silent & ~taken
        entered = {name: replace(part, used=part.used & taken[..., None]) for name, part in innovations.items()}
        rows = np.where(taken, used, 0)
        return Result(verdict, entered, np.where(rows > 0, nis, np.nan), rows, np.asarray(nis), lag)

    def note(self, where: Array, text: str, of_first: bool = False) -> None:
        """of_first: whether the numbers in it are those of the first of the runs."""
        which = np.flatnonzero(where)
        if len(which):
            if self.runs:
                listed = ", ".join(str(run) for run in which[:5]) + (", ..." if len(which) > 5 else "")
                text += (
                    f" (run {listed})"
                    if len(which) == 1
                    else (f" (runs {listed}: {len(which)}{'; numbers of the first of them' if of_first else ''})")
                )
            self.notes.append(Note(self.time, which, text))
