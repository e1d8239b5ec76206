"""Between a sensor's wire and the live loop: tags, units, calibration, the first seconds, the first message."""

from collections import deque
from collections.abc import Mapping
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime import rotation
from boresight.runtime.array import Array
from boresight.runtime.calibration import Calibration
from boresight.runtime.clock import Clock
from boresight.runtime.library import Library, load
from boresight.runtime.live import Fate, Layout, Live
from boresight.runtime.recording.check import check
from boresight.runtime.recording.types import Inertial, Master, Recording
from boresight.runtime.transfer.start import Increments, Message, first, straight

LEAST_MESSAGES = 3  # that the first seconds are looked at by
KEPT_S = 2.0  # of the slave's increments, for the first message
MOST = 60_000  # samples, and messages, that are kept until they are looked at, and those of twice check_s


class Driver:
    """What a slave and its master send, as it comes from a wire, into the live loop of an alignment.

    The first seconds are held against the master as `replay --check` does it: units, signs, axes
    and clocks that do not fit are refused by name. The next message begins the loop, with a
    covariance of all that goes into it.

    Parameters
    ----------
    model : Library or str
        A transfer alignment, such as "velocity-attitude".
    velocity_sigma, attitude_sigma : float or (3,) array
        m/s and rad, one sigma of the noise of the master's messages: north, east, down, and about
        these axes. Not a variance.
    sigmas : mapping of str to float or array
        How well each of these is known before the flight, one sigma: `q_b2m_wxyz` (rad, the mounting),
        `gyro_bias` (rad/s), `accel_bias` (m/s^2), `tau` (s), `lever_b` (m).
    estimates : mapping of str to array, optional
        Where they begin; at zero, and the mounting straight.
    rates : bool, optional
        Whether the sensors deliver rates, rad/s and m/s^2, and not increments, rad and m/s.
    interval_s : float, optional
        s, of a regular sensor whose tags jitter; else tags are the ends of the intervals.
    calibration : Calibration, optional
        Taken off what is delivered.
    full_scale : (2,) array, optional
        rad/s and m/s^2, at which the gyros and the accelerometers clip.
    check_s : float, optional
        s, of the first seconds that are looked at, three messages at least; 0 for none of it. Units and
        signs of accelerometers show at once, those of gyros once the master has turned.
    rules : mapping of str to value, optional
        Of the loop, see `Live`.
    **constants : array
        Of the model: `gyro_noise`, `accel_noise`, `lever_b`.

    Attributes
    ----------
    live : Live
        The loop; begun once `flying` is true.

    Raises
    ------
    BoresightError
        What `Live`, `first` and `Clock` refuse; and, of `sample` and `message`, first seconds that
        do not fit the master.

    Notes
    -----
    When not to use it: for a model that is no transfer alignment, or a master without a heading
    (`Headings`); begin `Live` yourself.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import Driver
    >>> driver = Driver(
    ...     "velocity-attitude", velocity_sigma=0.02, attitude_sigma=1e-3, check_s=0,
    ...     sigmas={"q_b2m_wxyz": 0.02, "gyro_bias": 1e-5, "accel_bias": 5e-3, "tau": 0.02},
    ...     gyro_noise=np.full(3, 6e-5), accel_noise=np.full(3, 1e-3), lever_b=np.zeros(3),
    ... )
    >>> for k in range(1, 101):
    ...     status = driver.sample(0.01 * k, np.zeros(3), [0, 0, -0.0979])
    ...     if k % 20 == 0:
    ...         fate = driver.message(
    ...             0.01 * k - 0.03, v_m_n=np.zeros(3), q_m2n_wxyz=[1, 0, 0, 0], position=[0.6, 0.1, 0]
    ...         )
    >>> driver.flying, driver.live.counts()["TAKEN"]
    (True, 6)
    """

    def __init__(
        self,
        model: Library | str,
        *,
        velocity_sigma: Any,
        attitude_sigma: Any,
        sigmas: Mapping[str, Any],
        estimates: Mapping[str, Any] | None = None,
        rates: bool = False,
        interval_s: float | None = None,
        calibration: Calibration | None = None,
        full_scale: Any = None,
        check_s: float = 10.0,
        rules: Mapping[str, Any] | None = None,
        **constants: Any,
    ):
        self.library = load(model) if not isinstance(model, Library) else model
        self.R = np.square(
            np.concatenate([_three("velocity_sigma", velocity_sigma), _three("attitude_sigma", attitude_sigma)])
        )
        self.sigmas, self.estimates = dict(sigmas), dict(estimates or {})
        self.rates, self.calibration = rates, calibration or Calibration()
        self.clock = None if interval_s is None else Clock(interval_s)
        limits = {} if full_scale is None else {"full_scale": np.repeat(np.asarray(full_scale, float), 3)}
        fields = [name for s in Layout(self.library).described["rules"] for name in self.library.layout[s]]
        of_rules = {name: constants[name] for name in fields if name in constants}
        self.live = Live(self.library, {**limits, **(rules or {})}, **of_rules)
        self.constants = {name: straight(self.library, name) for name in fields} | constants
        self.of_message = {name: value for name, value in constants.items() if name not in of_rules}
        self.check_s, self.flying = check_s, False
        self._past: deque[tuple[float, float, Array, Array]] = deque()
        self._messages: list[Message] = []
        self._checked = check_s <= 0
        self._end: float | None = None

    def sample(self, time_s: float, gyro: Any, accel: Any, *, count: int | None = None) -> int:
        """One sample of the slave's sensors.

        Parameters
        ----------
        time_s : float
            s, when its interval ends, by the slave's clock.
        gyro, accel : (3,) array
            In body axes, front, right, down: increments, or rates, as `rates` has it.
        count : int, optional
            Of the sensor's own counter.

        Returns
        -------
        int
            Status of the C; 0 where it was taken, or kept for the beginning.
        """
        if self.clock is not None:
            tick = self.clock.sample(time_s, count)
            if tick.missing < 0:
                return 0
            end, dt = tick.time, tick.dt
        else:
            end, dt = float(time_s), float(time_s) - (self._end if self._end is not None else np.nan)
        before, self._end = self._end, end
        if before is None and self.clock is None:
            return 0  # how long its interval was is not known
        dtheta, dv = (np.asarray(part, float) * (dt if self.rates else 1.0) for part in (gyro, accel))
        dtheta, dv = self.calibration.increments(dtheta, dv, dt)
        if self.flying:
            taken = self.live.sample(
                round(1e6 * end), dt, serial=0 if count is None else count + 1, dtheta_ib_b=dtheta, dv_b=dv
            )
            return int(taken)
        self._past.append((end - dt, end, dtheta, dv))
        most, kept_s = (0, KEPT_S) if self._checked else (MOST, 2 * self.check_s)
        while len(self._past) > most and end - self._past[0][0] > kept_s:
            self._past.popleft()
        if not self._checked and end - self._past[0][0] >= self.check_s and len(self._messages) >= LEAST_MESSAGES:
            self._check()
        return 0

    def message(
        self,
        time_s: float,
        *,
        v_m_n: Any,
        q_m2n_wxyz: Any = None,
        euler_m: Any = None,
        position: Any = None,
        velocity_sigma: Any = None,
        attitude_sigma: Any = None,
    ) -> Fate:
        """One message of the master.

        Parameters
        ----------
        time_s : float
            s, when it was measured, by the slave's clock as far as the message knows.
        v_m_n : (3,) array
            m/s, north, east, down.
        q_m2n_wxyz : (4,) array, optional
            Master body to NED; or
        euler_m : (3,) array, optional
            rad, roll, pitch and yaw.
        position : (3,) array, optional
            Latitude and longitude, rad, and height, m; of the message that begins.
        velocity_sigma, attitude_sigma : float or (3,) array, optional
            Of this message.

        Returns
        -------
        Fate
            WAITING; NOT_READY where it was looked at, or kept, and none of it flies.
        """
        if (q_m2n_wxyz is None) == (euler_m is None):
            raise BoresightError("message: give q_m2n_wxyz or euler_m")
        q = np.asarray(
            rotation.quaternion_from_euler(np.asarray(euler_m, float)) if q_m2n_wxyz is None else q_m2n_wxyz, float
        )
        R = self.R.copy()
        for name, sigma, rows in (
            ("velocity_sigma", velocity_sigma, slice(3)),
            ("attitude_sigma", attitude_sigma, slice(3, 6)),
        ):
            if sigma is not None:
                R[rows] = _three(name, sigma) ** 2
        if not self.flying:
            made = Message(float(time_s), R, v_m_n=np.asarray(v_m_n, float), q_m2n_wxyz=q, position=position)
            if not self._checked:
                self._messages.append(made)
                del self._messages[:-MOST]
            elif position is not None and self._reaches(made):
                self._begin(made)
            return Fate.NOT_READY
        at_us = round(1e6 * time_s)
        fates = [
            self.live.message("velocity", at_us, R[:3], v_m_n=v_m_n, **self.of_message),
            self.live.message("dcm", at_us, R[3:], q_m2n_wxyz=q),
        ]
        return max(fates)

    def output(self, time_s: float) -> dict[str, Array]:
        """The navigation at an instant not before the newest sample; {} before it flies.

        Parameters
        ----------
        time_s : float
            s, by the slave's clock.

        Returns
        -------
        dict of str to array
            As `Live.output` has it.
        """
        return self.live.output(round(1e6 * time_s)) if self.flying else {}

    def _reaches(self, message: Message) -> bool:
        """Whether the increments kept reach from before the message until now."""
        tau = float(np.max(np.asarray(self.estimates.get("tau", 0.0))))
        return (
            bool(self._past) and self._past[0][0] < message.time - tau - 0.1 and message.time - tau <= self._past[-1][1]
        )

    def _begin(self, message: Message) -> None:
        columns = [np.array(part) for part in zip(*self._past, strict=True)]
        nav, P = first(message, self.library, self.constants, sigmas=self.sigmas, estimates=self.estimates,
                       increments=Increments(*columns))  # fmt: skip
        layout = self.live.layout
        carried = {name: value for name, value in nav.items() if layout.owner(layout.carried, name)}
        self.live.begin(round(1e6 * self._past[-1][1]), carried, P=P)
        self.flying, self._messages = True, []
        self._past.clear()

    def _check(self) -> None:
        """The first seconds beside the master.  Raises BoresightError with what does not fit, a line each."""
        _, end, dtheta, dv = (np.array(part) for part in zip(*self._past, strict=True))
        sent = self._messages
        euler = np.array([rotation.euler_from_matrix(rotation.matrix_from_quaternion(m.q_m2n_wxyz)) for m in sent])
        position = None if any(m.position is None for m in sent) else np.array([m.position for m in sent], float)
        master = Master(np.array([m.time for m in sent]), euler, np.array([m.v_m_n for m in sent]), position)
        found = check(Recording("the first seconds", Inertial("increments", "end", end, dtheta, dv), master))
        wrong = [f"{one.where}: {one.text}" for one in found if one.level == "error"]
        if wrong:
            raise BoresightError("; ".join(["driver: the slave does not fit its master", *wrong]))
        self._checked = True


def _three(name: str, value: Any) -> Array:
    """Three sigmas, above zero.  Raises BoresightError."""
    sigma = np.broadcast_to(np.asarray(value, float), (3,)) if np.shape(value) in ((), (3,)) else np.full(3, np.nan)
    if not (np.isfinite(sigma).all() and (sigma > 0).all()):
        raise BoresightError(f"driver: {name} is {value}; give one sigma or three, above zero")
    return np.array(sigma)
