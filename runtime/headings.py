"""A start without a master's heading: candidates all round, each a live loop, until the messages have chosen.

Velocity shows the heading as soon as the vehicle accelerates: a candidate that is turned by d sees each change of
velocity v turned by d, a residual of 2 v sin(d / 2).
"""

import copy
from collections.abc import Mapping
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime import rotation
from boresight.runtime.array import Array, wrapped
from boresight.runtime.live import ALL_ROWS, Fate, Live

SPACING = float(np.radians(7.5))  # with 15, velocity and attitude are not linear enough
SETTLED = float(np.radians(2.5))  # sigma of the heading over all candidates
FAR = 1e-6  # probability that may be left further than the spacing from the likeliest
GATE = 6.0  # sigmas of an innovation that count at most
ATTITUDE, ERROR = "q_b2n_wxyz", "phi"  # the carried attitude, body to level, and the block of its errors
EULER, MOUNTING = "euler_m", "q_b2m_wxyz"  # of a message, and carried: body to master
PATIENCE = 16  # messages until one that a candidate refused counts as the worst


class Headings:
    """A bank of live loops that finds an unknown heading: as `Live`, by candidates all round.

    One goes on alone, `settled`, as soon as the sigma of the heading over all of them is below 2.5
    degrees and no more than that of the likeliest itself, and what lies further than `spacing` from
    it has lost its probability.

    Parameters
    ----------
    model : Library or str
        As of `Live`, of one that carries `q_b2n_wxyz` with its errors `phi`, the third about the
        vertical.
    rules : mapping of str to value, optional
        As of `Live`.
    spacing : float, optional
        rad, between candidates; each begins with a third of it as the sigma of its heading.
    **constants : array
        As of `Live`.

    Raises
    ------
    BoresightError
        As of `Live`; a model without such an attitude.

    Notes
    -----
    Give attitudes without their heading, `message("euler", ..., rows=3)`: the third of the Euler
    angles is not read.  When not to use it: where the heading is known to .1 rad; it costs as much
    as all of its candidates, and a vehicle that does not accelerate keeps them all.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import Headings
    >>> bank = Headings("velocity-attitude", gyro_noise=np.full(3, 6e-5), accel_noise=np.full(3, 1e-3))
    >>> bank.begin(0, {"lat_lon_height": [0.6, 0.1, 0], "v_n": np.zeros(3), "q_b2n_wxyz": [1, 0, 0, 0],
    ...                "q_b2m_wxyz": [1, 0, 0, 0]}, phi=0.02, dv_n=1.0, d_tau=0.05)
    >>> for k in range(1, 21):
    ...     status = bank.sample(10_000 * k, 0.01, dtheta_ib_b=np.zeros(3), dv_b=[0, 0, -0.0979])
    >>> len(bank.loops), bank.settled
    (48, False)
    """

    def __init__(
        self, model: Any, rules: Mapping[str, Any] | None = None, *, spacing: float = SPACING, **constants: Any
    ):
        self.one, self.spacing = Live(model, rules, **constants), spacing
        start, self.down = 0, -1
        for block in self.one.library.manifest["blocks"]:
            self.down = start + 2 if block["name"] == ERROR and block["size"] == 3 else self.down
            start += block["size"]
        if self.down < 0 or not self.one.layout.owner(self.one.layout.carried(), ATTITUDE):
            raise BoresightError(f"headings: {self.one.library.name} does not carry {ATTITUDE} with its errors {ERROR}")
        self.loops: list[Live] = []
        self.log_weight = np.zeros(0)
        self._likely: dict[int, Array] = {}  # of each message that not all candidates have judged
        self._came: list[list[int]] = []  # of each candidate: which messages were put to wait
        self._rows: list[int] = []  # of each message
        self._lines: list[str] = []
        self._at_us = 0  # of the newest sample

    @property
    def settled(self) -> bool:
        """Whether one loop goes on alone."""
        return len(self.loops) == 1

    @property
    def weight(self) -> Array:
        """(K,) probability of each candidate."""
        weight: Array = np.exp(self.log_weight - self.log_weight.max())
        return weight / weight.sum()

    @property
    def likeliest(self) -> Live:
        """The loop of the candidate with the largest probability."""
        return self.loops[int(np.argmax(self.log_weight))]

    def begin(self, at_us: int, nav: Mapping[str, Any], **sigmas: Any) -> None:
        """Begin all candidates.

        Parameters
        ----------
        at_us : int
            us; the next sample's interval begins here.
        nav : mapping of str to array
            The carried fields; of the attitude roll and pitch count alone.
        **sigmas : float or (size,) array
            By block of states, as of `Live`.

        Raises
        ------
        BoresightError
            As of `Live`.
        """
        count = round(2 * np.pi / self.spacing)
        C = rotation.matrix_from_quaternion(np.asarray(nav[ATTITUDE], float))
        spread = np.array(np.broadcast_to(sigmas.get(ERROR, 0.0), 3), float)
        spread[2] = self.spacing / 3
        self.loops = []
        for yaw in 2 * np.pi / count * np.arange(count):
            turn = rotation.matrix_from_quaternion(rotation.quaternion_from_euler(np.array([0.0, 0.0, yaw])))
            begun = {**nav, ATTITUDE: rotation.quaternion_from_matrix(turn @ C)}
            self.one.begin(at_us, begun, **(sigmas | {ERROR: spread}))
            self.loops.append(copy.copy(self.one))
        self.log_weight = np.zeros(count)
        self._likely, self._rows, self._came = {}, [], [[] for _ in range(count)]

    def sample(self, at_us: int, dt: float, *, serial: int = 0, **sensed: Any) -> int:
        """One sample of the sensors, with all that is to be done behind it.

        Parameters
        ----------
        at_us : int
            us, when the interval ends, by the sensors' clock.
        dt : float
            s, the length of the interval.
        serial : int, optional
            Counts samples; 0 where there is no counter.
        **sensed : (size,) array
            What the sensors deliver.

        Returns
        -------
        int
            Status of the C; 0 where it was taken.

        Raises
        ------
        BoresightError
            As of `Live`.
        """
        self._at_us, status = at_us, 0
        if self.settled:
            return int(self.likeliest.sample(at_us, dt, serial=serial, **sensed))
        for k, loop in enumerate(self.loops):
            status = max(status, int(loop.sample(at_us, dt, serial=serial, background=False, **sensed)))
            count = loop.measured().get("count", 0)
            while loop.background():
                if (found := loop.measured()) and found["count"] != count:
                    count = found["count"]
                    self._judged(k, found)
        self._weigh()
        return status

    def message(self, measurement: str, at_us: int, variance: Any, *, rows: int = ALL_ROWS, **fields: Any) -> Fate:
        """One measurement, for all candidates.

        Parameters
        ----------
        measurement : str
            Its name in the model.
        at_us : int
            us, when it was measured.
        variance : (m,) array
            R, the squares of its sigmas.
        rows : int, optional
            Bit i: row i is there.
        **fields : array
            What its functions read; of `euler_m` the third is put in for each candidate.

        Returns
        -------
        Fate
            Of the likeliest candidate: WAITING, or why it was refused at once.

        Raises
        ------
        BoresightError
            As of `Live`.
        """
        fates = [
            loop.message(measurement, at_us, variance, rows=rows, **(fields | self._with_heading(loop, fields)))
            for loop in self.loops
        ]
        if self.settled:
            return fates[0]
        self._rows.append(rows)
        for came, fate in zip(self._came, fates, strict=True):
            if fate == Fate.WAITING:
                came.append(len(self._rows) - 1)
        return fates[int(np.argmax(self.log_weight))]

    def _with_heading(self, loop: Live, fields: Mapping[str, Any]) -> dict[str, Any]:
        """Euler angles of a master with the heading that a candidate expects: where H is linearised, and no more."""
        nav = loop.output(self._at_us) if EULER in fields else {}
        if not nav:
            return {}
        C_b2n, C_b2m = (rotation.matrix_from_quaternion(nav[name]) for name in (ATTITUDE, MOUNTING))
        yaw = rotation.euler_from_matrix(C_b2n @ C_b2m.T)[2]
        return {EULER: np.append(np.asarray(fields[EULER], float)[:2], yaw)}

    def output(self, at_us: int) -> dict[str, Array]:
        """The navigation of the likeliest candidate at an instant not before the newest sample.

        Parameters
        ----------
        at_us : int
            us, by the sensors' clock.

        Returns
        -------
        dict of str to array
            As of `Live`; the sigma of the heading is that over all candidates.
        """
        found = self.likeliest.output(at_us)
        if found and not self.settled:
            found["sigma"][self.down] = self._mixture()[0]
        return found

    def events(self) -> list[str]:
        """What has happened to the likeliest candidate since the last call.

        Returns
        -------
        list of str
            One line for each event; one more when a loop goes on alone.
        """
        lines, self._lines = self._lines + self.likeliest.events(), []
        return lines

    def _judged(self, k: int, found: dict[str, Any]) -> None:
        """Of one candidate the log-likelihood of a message, up to a constant of its rows."""
        which = self._came[k][found["order"]]
        asked = np.array([bool(self._rows[which] >> i & 1) for i in range(len(found["nu"]))]) & (found["S"] > 0)
        nu, S = found["nu"][asked], found["S"][asked]
        likely = self._likely.setdefault(which, np.full(len(self.loops), np.nan))
        likely[k] = -0.5 * np.sum(np.minimum(nu**2 / S, GATE**2) + np.log(S))

    def _weigh(self) -> None:
        """Messages that all candidates have judged, or have had the time to, choose among them."""
        before = self.log_weight
        for which in sorted(self._likely):
            likely = self._likely[which]
            if np.isfinite(likely).all() or which < len(self._rows) - PATIENCE:
                worst = np.nanmin(likely) - 0.5 * GATE**2
                self.log_weight = self.log_weight + np.where(np.isfinite(likely), likely, worst)
                del self._likely[which]
        if self.log_weight is before:
            return
        self.log_weight = self.log_weight - self.log_weight.max()
        sigma, own, far = self._mixture()
        if sigma < SETTLED and sigma < 1.05 * own and far < FAR:
            self._lines.append(
                f"the heading is known to {np.degrees(sigma):.2g} deg; one loop goes on in place of {len(self.loops)}"
            )
            self.loops, self.log_weight = [self.likeliest], np.zeros(1)

    def _mixture(self) -> tuple[float, float, float]:
        """Sigma of the heading over all candidates, that of the likeliest, rad; the probability far from it."""
        near = [k for k, w in enumerate(self.weight) if w > FAR / len(self.loops) / 10]
        weight = self.weight[near]
        P = [self.loops[k].covariance()[0][self.down, self.down] for k in near]
        yaw = np.array([self._yaw(self.loops[k]) for k in near])
        best = int(np.argmax(weight))
        apart = wrapped(yaw - yaw[best])
        off = apart - np.sum(weight * apart)
        far = float(np.sum(weight[np.abs(apart) > self.spacing]))
        return float(np.sqrt(np.sum(weight * (P + off**2)))), float(np.sqrt(P[best])), far

    def _yaw(self, loop: Live) -> float:
        nav = loop.output(self._at_us)
        C = rotation.matrix_from_quaternion(nav[ATTITUDE]) if nav else np.eye(3)
        return float(rotation.euler_from_matrix(C)[2])
