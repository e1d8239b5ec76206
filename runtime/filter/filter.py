"""A Kalman filter over a model's functions, of an error state or of a total state: one run, or many side by side.

Everything here broadcasts: P is (..., n, n), and what stands before the last axes are runs.  The same loop flies the
compiled C of `boresight.runtime.library` and any object that offers the same functions in plain NumPy.
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from boresight.errors import BoresightError, did_you_mean
from boresight.runtime.arguments import check_inputs, check_own_state, check_start, check_state, check_taking, whole
from boresight.runtime.array import Array, wrapped

STILL = 0.01  # sigmas by which an estimate may move and need not be linearised again


@dataclass(frozen=True)
class Innovation:
    """The innovation of one measurement, as `Filter.update` returns it.

    Parameters
    ----------
    nu : (..., m) array
        z - h(x), or z - H x, in the unit of the row: row after row, each given the rows before it,
        of the last linearisation.
    S : (..., m) array
        The variance of nu.
    used : (..., m) bool array
        Which rows corrected the state, by the first linearisation.  A row that was masked or gated
        is False and adds nothing to nis.
    nis : (...,) array, optional
        Sum of nu^2 / S over the rows used: chi-square with `used.sum(-1)` degrees of freedom if the
        filter is consistent.  Computed if left out.
    inflated : (..., m) bool array, optional
        Which rows used lay beyond the gate and were taken with a larger R, by `inflate=True`; S has
        it in it.  None of them if left out.

    Notes
    -----
    Where the joint gate leaves a measurement out, used is False in every row, and nis is the number
    that exceeded the gate.  When not to use it: for several measurements together; each `update`
    has its own.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import Innovation
    >>> found = Innovation(nu=np.array([0.2, 3.0]), S=np.array([0.04, 1.0]), used=np.array([True, False]))
    >>> float(round(found.nis, 3))
    1.0
    """

    nu: Array
    S: Array
    used: Array
    nis: Array = field(default=None)  # type: ignore[arg-type]
    inflated: Array = field(default=None)  # type: ignore[arg-type]

    def __post_init__(self) -> None:
        if self.inflated is None:
            object.__setattr__(self, "inflated", np.zeros_like(self.used))
        if self.nis is None:
            with np.errstate(over="ignore"):  # an infinite one is refused
                nis = np.sum(np.where(self.used, self.nu**2 / self.S, 0.0), axis=-1)
            object.__setattr__(self, "nis", nis)


class Filter:
    """A Kalman filter in NumPy over a model's functions: predict, update, feed back.

    One run, or many side by side: what stands before the last axes are runs, and everything
    broadcasts.  Units are SI and rad, frames those of the model (`boresight models NAME`).

    Parameters
    ----------
    model : Library, or any object with the same functions
        Offers `Phi`, `Q`, `NAME_H`, `NAME_z` unless the caller brings z, `NAME_h` unless h is H x,
        `feedback`, `strapdown`, and `next` if its state is total; each is called with the fields
        that it lists in `.fields`.  It may offer `measurements` and `wraps`, as a `Library` does:
        which rows and states are angles.
    nav : dict of str to (..., size) array
        What the strapdown carries and the feedback corrects, by field name; {} for a model without.
    P : (..., n, n) array
        Covariance of the state at the start: finite, symmetric, no negative eigenvalue.
    x : (..., n) array, optional
        Where a total state begins.  An error state begins, by default, and after each feedback, at
        zero.

    Attributes
    ----------
    x, P, nav
        As above, now; each may be assigned.
    considered : None or (..., n) bool array
        May be assigned: states that no measurement corrects (a Schmidt filter).
    disabled : None or (n,) bool array
        States that take no part, by `disable` and `enable`.
    at_ceiling : (...,) bool array
        Whether the last prediction, or `inflate`, met a ceiling of a variance.

    Raises
    ------
    BoresightError
        A name that the model does not have, a wrong shape, P that is no covariance, x that is not
        finite or is missing for a total state, a sigma beyond the ceiling that the generated
        filter's header states.

    See Also
    --------
    CompiledFilter : the same in C, equal to rounding: for speed, and to fly what is exported.

    Notes
    -----
    When not to use it: for many runs or long flights `CompiledFilter` takes a fraction of the time.
    This one is for reading, for R with correlated rows of a model that does not declare them, for a
    Jacobian of one's own, and for models that are plain Python objects.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import Filter, load
    >>> nav = {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros(3)}
    >>> loop = Filter(load("euler-matching"), nav, P=np.eye(6) * 1e-4)
    >>> loop.strapdown(dtheta_ib_b=[0, 0, 0.01], omega_in_n=np.zeros(3), dt=1.0)
    >>> loop.predict(omega_in_n=np.zeros(3), gyro_noise=np.full(3, 1e-4), dt=1.0)
    >>> angles = {"euler_b": loop.call("euler_angles"), "euler_m": np.zeros(3)}
    >>> found = loop.update("euler_exact", R=np.full(3, 1e-6), **angles)
    >>> print(found.nu.round(4), found.used)
    [0.   0.   0.01] [ True  True  True]
    >>> loop.feedback()
    >>> print(loop.nav["mu"].round(4))
    [0.    0.    0.005]
    """

    considered: Any = None
    disabled: Any = None
    at_ceiling: Any = False  # (...,) bool
    recorder: Any = None  # what writes down each step, by standing in the place of the methods

    def __init__(self, model: Any, nav: dict[str, Array], P: Array, x: Any = None):
        self.model = model
        self.nav = {name: np.array(value, dtype=float) for name, value in nav.items()}
        self.P = np.array(P, dtype=float)
        check_start(model, self.nav, self.P)
        check_covariance("P", self.P)
        self._ceiling = getattr(model, "ceiling", None)
        self._below_ceiling("P", np.einsum("...ii->...i", self.P), 0)
        kind = getattr(model, "manifest", {}).get("kind") or ("total-state" if "next" in dir(model) else "")
        self.total = kind == "total-state"
        if x is None and self.total:
            raise BoresightError(f"{getattr(model, 'name', model)!s} has a total state; give x, where it begins")
        self.x = self._start(x)

    def _below_ceiling(self, what: str, variance: Array, first: int) -> None:
        """Raise BoresightError where a variance (..., count) of the states from `first` on is above its ceiling."""
        if self._ceiling is None:
            return
        above = variance > self._ceiling[first : first + variance.shape[-1]]
        if above.any():
            over = int(np.argwhere(above)[0][-1])
            raise BoresightError(
                f"{what}: the sigma of {self.model.states[first + over]} is {np.sqrt(variance[..., over].max()):.3g}; "
                f"the filter lets it be {np.sqrt(self._ceiling[first + over]):.3g} at most"
            )

    def _start(self, x: Any) -> Array:
        n = self.P.shape[-1]
        x = np.zeros(n) if x is None else np.asarray(x, dtype=float)
        check_state(x, n)
        if not np.isfinite(x).all():
            raise BoresightError("x holds a value that is not finite; start from a finite state")
        runs = np.broadcast_shapes(self.P.shape[:-2], x.shape[:-1])
        return self.wrapped(np.array(np.broadcast_to(x, (*runs, n))))

    def _leading(self) -> tuple[int, ...]:
        return tuple(self.x.shape[:-1])

    def wrapped(self, x: Array) -> Array:
        """The state with those of its angles that wrap in [-pi, pi).

        Parameters
        ----------
        x : (..., n) array
            A state, total or error.

        Returns
        -------
        (..., n) array
            x itself if no state of the model wraps.
        """
        places = getattr(self.model, "wraps", ())
        if places:
            x = x.copy()
            x[..., places] = wrapped(x[..., places])
        return x

    def call(self, name: str, **inputs: Any) -> Any:
        """A function of the model, with nav, the state x and the inputs given.

        Parameters
        ----------
        name : str
            Of the model's function, as "euler_angles" or "position_H".
        **inputs
            Its other fields by name, each (..., size) or (...,) if it has one component; they stand
            above nav and x.

        Returns
        -------
        array, or dict of arrays where the function has several outputs

        Raises
        ------
        BoresightError
            No such function or input, an input that is missing, not finite or outside its box.
        """
        unit = getattr(self.model, name)
        check_inputs(name, self.model, inputs, self.nav, self.P, unit.fields)
        known = {**self.nav, "x": self.x, **inputs}
        missing = [field for field in unit.fields if field not in known]
        if missing:
            raise BoresightError(f"{name} needs {', '.join(missing)}; pass it as a keyword")
        return unit(**{field: known[field] for field in unit.fields})

    def strapdown(self, **inputs: Any) -> None:
        """Carry nav over one interval of inertial data, by the model's function `strapdown`.

        Parameters
        ----------
        **inputs
            The other fields of `strapdown` by name, each (..., size) or (...,): increments in rad
            and m/s, dt in s.

        Raises
        ------
        BoresightError
            A model without a strapdown; an input that is unknown, missing, not finite or outside
            its box.
        """
        check_own_state("strapdown", inputs)
        self.nav.update(named(self.call("strapdown", **inputs), self.nav))

    def predict(self, **inputs: Any) -> None:
        """Carry x and P over `dt`: a total state by `next`, an error state by Phi.

        A variance beyond its ceiling, which the generated filter's header states, becomes a quarter
        as often as it takes, its row and column a half as often; `at_ceiling` says so.

        Parameters
        ----------
        **inputs
            The fields of Phi, Q and `next` that nav does not hold, by name, each (..., size) or
            (...,).  One that another function of the model takes may stand among them, and is left
            alone.

        Raises
        ------
        BoresightError
            The state x among the inputs, which is the filter's own; an input that is unknown,
            missing, not finite or outside its box; a P that is not finite.
        """
        check_own_state("predict", inputs)
        if not np.isfinite(self.P).all():
            raise BoresightError("predict: P holds a value that is not finite; assign a finite covariance")
        Phi, Q = self.call("Phi", **inputs), self.call("Q", **inputs)
        after = self.call("next", **inputs) if self.total else np.einsum("...ij,...j->...i", Phi, self.x)
        self.x = self.wrapped(after)
        P = Phi @ self.P @ np.swapaxes(Phi, -1, -2) + Q
        if self.disabled is not None:
            P = without(P, self.disabled)
        self.P, self.at_ceiling = lowered(P, self._ceiling)

    def update(
        self,
        measurement: str,
        R: Any,
        *,
        rows: Any = True,
        gate: float | None = None,
        joint: float | None = None,
        iterations: int = 1,
        inflate: bool = False,
        relinearize: bool = False,
        considered: Any = None,
        jacobian: Any = None,
        **inputs: Any,
    ) -> Innovation:
        """Take one measurement, row after row, in Joseph form.

        Parameters
        ----------
        measurement : str
            Its name in the model.
        R : (..., m) or (..., m, m) array, or a number
            Variances of the rows, whose errors are independent; or their covariance L D L', L lower
            with ones on its diagonal: then the rows are those of L^-1 z, of variances D, and so are
            nu and S.  For m runs (m, m) are variances, and (1, m, m) is a covariance.
        rows : (..., m) bool array, optional
            False for a row that is absent, which has no part in L.  False for all: nu and S of each
            row by itself; nothing is taken.
        gate : float, optional
            Sigmas: a row whose abs(nu) exceeds as many, where it is linearised first, is left out.
            Of correlated rows each is judged by itself, before R is factored without those that are
            left out.
        joint : float, optional
            A quantile of chi-square: a measurement whose nis, of the rows within their gate,
            exceeds it where it is linearised first is left out as a whole.
        iterations : int, optional
            How often at most a nonlinear measurement is linearised, about the last estimate and
            always from the same x and P; 1 is the plain extended filter.  It ends where no state
            and no row moves by more than 0.01 sigma.  Where one moves by more than a sigma and by
            more than before, or x leaves its box, the first result is taken.
        inflate : bool, optional
            A row beyond its gate is not left out: its R is raised by so much that abs(nu) is at the
            gate, and `inflated` says so.  Of correlated rows each is judged by itself.
        relinearize : bool, optional
            Each row is linearised at where the rows before it have led x, and judged there; with
            one iteration.  Nothing changes where H does not depend on x.
        considered : (..., n) bool array, optional
            In the place of the attribute `considered`: states whose rows of the whole measurement's
            gain are zero.  They and their covariance among themselves stay, and their covariance
            with the others is right.  nu and S are those of the optimal filter, so that nis is
            chi-square.
        jacobian : (..., m, n) array, optional
            What `NAME_H` gives where the filter is, of a caller who has it already.  `Filter` alone
            takes it; `CompiledFilter` refuses it, for its C makes its own.
        **inputs
            The fields of the measurement by name, each (..., size) or (...,); z (..., m), the
            measured value, of a measurement that has no `NAME_z`.

        Returns
        -------
        Innovation

        Raises
        ------
        BoresightError
            No such measurement, an input that is unknown, missing, not finite or outside its box,
            the state x among the inputs, R that is no covariance, an innovation that is no number,
            a nis that is not finite, a total state that would leave its box.  The filter stays as it was.
        """
        check_taking(measurement, rows, gate, joint, iterations, inflate, relinearize)
        check_own_state(measurement, inputs)
        kept = self._considered(measurement, considered)
        z, rows = self._measured(measurement, inputs), np.asarray(rows, dtype=bool)
        if jacobian is not None:
            jacobian, shape = np.asarray(jacobian, dtype=float), (z.shape[-1], self.P.shape[-1])
            if jacobian.shape[-2:] != shape:
                raise BoresightError(
                    f"{measurement}: jacobian has shape {jacobian.shape}; its last axes must be {shape[0]} and "
                    f"{shape[1]} long"
                )
        D, L_inverse = self._noise(measurement, R, z.shape, rows)
        raised: Any = False
        if L_inverse is not None and gate is not None:  # what a rejected row says has no part in the others
            at = self._linear(measurement, z, self.x, inputs, jacobian)
            rows, R, raised = self._within(gate, rows, np.asarray(R, float), *at, inflate)
            gate = None
            D, L_inverse = self._noise(measurement, R, z.shape, rows)

        def linear(at: Array, H: Array | None = None) -> tuple[Array, Array]:
            """Rows z and H that are linear in the state about `at`."""
            target, H = self._linear(measurement, z, at, inputs, H)
            if L_inverse is None:
                return target, H
            return np.einsum("...ij,...j->...i", L_inverse, target), L_inverse @ H

        nonlinear = "x" in getattr(self.model, f"{measurement}_H").fields
        target, H = linear(self.x, jacobian)
        again = linear if relinearize and nonlinear else None
        x, P, innovation, D = self._rows(target, H, D, rows, gate, kept, inflate, again)
        raised = innovation.inflated | raised
        if not (np.isfinite(innovation.nu).all() and np.isfinite(innovation.S).all() and (innovation.S > 0).all()):
            raise BoresightError(f"{measurement}: an innovation or its variance is no number; start from a new P")
        beyond = False if joint is None else ~(innovation.nis <= joint)
        first = innovation.nis
        if iterations > 1 and nonlinear:
            x, P, innovation = self._again(linear, D, iterations - 1, kept, H, x, P, innovation)
        x = self.wrapped(x)
        if not np.isfinite(first).all():
            raise BoresightError(
                f"{measurement}: nis is not finite; what was measured is too far from what was expected"
            )
        if joint is not None:
            keep = np.asarray(beyond)
            raised = raised & ~keep[..., None]
            x, P = np.where(keep[..., None], self.x, x), np.where(keep[..., None, None], self.P, P)
            innovation = Innovation(
                innovation.nu, innovation.S, innovation.used & ~keep[..., None], np.where(keep, first, innovation.nis)
            )
        if getattr(self.model, "manifest", {}).get("kind") == "total-state" and not self._inside(x).all():
            raise BoresightError(f"{measurement}: it would lead x out of its box; give a gate, or leave it out")
        self.x, self.P = x, P
        return replace(innovation, inflated=np.asarray(raised) & innovation.used)

    def _measured(self, measurement: str, inputs: dict[str, Any]) -> Array:
        """z (..., m), of the model's own function or out of the inputs."""
        z = self._brought(measurement, inputs)
        return self.call(f"{measurement}_z", **inputs) if z is None else z

    def _brought(self, measurement: str, inputs: dict[str, Any]) -> Array | None:
        """z (..., m) out of the inputs, or None where the model has a function for it."""
        if hasattr(self.model, f"{measurement}_z"):
            if "z" in inputs:
                raise BoresightError(f"{measurement} makes its z of its inputs; leave z out")
            return None
        known = getattr(self.model, "measurements", None)
        if known is not None and measurement not in known:
            listed = f"it has {', '.join(known)}{did_you_mean(measurement, known)}"
            raise BoresightError(f"{self.model.name} has no measurement {measurement!r}; {listed}")
        if "z" not in inputs:
            raise BoresightError(f"{measurement} needs z, the measured value; pass it as a keyword")
        z: Array = np.atleast_1d(np.asarray(inputs.pop("z"), dtype=float))
        m = len(known[measurement]["rows"]) if known else z.shape[-1]
        if z.shape[-1] != m:
            raise BoresightError(f"{measurement}: z has shape {z.shape}; its last axis must be {m} long")
        if not np.isfinite(z).all():
            raise BoresightError(f"{measurement}: z holds a value that is not finite; leave its row out by rows")
        low, high = (self._described(measurement, end) for end in ("low", "high"))
        if low and not ((z >= low) & (z <= high)).all():
            raise BoresightError(f"{measurement}: z lies outside its box, {low} to {high}")
        return z

    def _noise(self, measurement: str, given: Any, shape: tuple[int, ...], rows: Array) -> tuple[Array, Array | None]:
        """Variances of independent rows (..., m), and L^-1 (..., m, m) which makes them so, or None.  shape: of z."""
        m, runs = shape[-1], np.broadcast_shapes(shape[:-1], self._leading())
        if rows.ndim and rows.shape[-1] not in (1, m):
            raise BoresightError(f"{measurement}: rows has shape {rows.shape}; its last axis must be {m} long")
        R: Array = np.atleast_1d(np.asarray(given, dtype=float))
        correlated = self._described(measurement, "correlated")
        full = R.shape[-2:] == (m, m) and (correlated or (m > 1 and R.shape[:-1] != runs[1 - R.ndim :]))
        if not full and (correlated or R.shape[-1] != m):
            first = "" if correlated else f"(..., {m}), its variances, or "
            raise BoresightError(
                f"{measurement}: R has shape {R.shape}; it must be {first}(..., {m}, {m}), its covariance"
            )
        variances = np.diagonal(R, axis1=-2, axis2=-1) if full else R
        if not (np.isfinite(R).all() and (variances > 0).all()):
            raise BoresightError(f"{measurement}: every variance in R must be finite and above zero")
        if not full:
            return np.broadcast_to(R, np.broadcast_shapes(shape, R.shape)), None
        # An absent row keeps to itself.
        present = np.broadcast_to(rows, np.broadcast_shapes(rows.shape, (m,)))
        R = np.where(present[..., :, None] & present[..., None, :] | np.eye(m, dtype=bool), R, 0.0)
        check_covariance(f"{measurement}: R", R, m)
        try:
            root = np.linalg.cholesky(R)
        except np.linalg.LinAlgError:
            root = np.zeros_like(R)
        sigma = np.diagonal(root, axis1=-2, axis2=-1)
        if not (sigma**2 > np.finfo(float).eps * variances).all():
            raise BoresightError(f"{measurement}: R is not positive definite; a row of it follows from the others")
        return sigma**2, np.linalg.inv(root / sigma[..., None, :])

    def _within(
        self, gate: float, rows: Array, R: Array, target: Array, H: Array, inflate: bool
    ) -> tuple[Array, Array, Array]:
        """The rows (..., m) bool to be taken, R (..., m, m), and the rows whose R is raised; a row is judged by itself.

        The rows within the gate are taken; or all, and beyond the gate R is raised.
        """
        nu = target - np.einsum("...ij,...j->...i", H, self.x)
        S = np.einsum("...ij,...jk,...ik->...i", H, self.P, H) + np.diagonal(R, axis1=-2, axis2=-1)
        within = nu**2 <= gate**2 * S
        if not inflate:
            return rows & within, R, np.zeros_like(within)
        more = np.where(rows & ~within, np.maximum((nu / gate) ** 2 - S, 0.0), 0.0)
        return rows, R + more[..., None] * np.eye(R.shape[-1]), more > 0

    def _linear(
        self, measurement: str, z: Array, at: Array, inputs: dict[str, Any], H: Array | None = None
    ) -> tuple[Array, Array]:
        """z and H (..., m, n) of rows that are linear in the state about `at`: an h is taken there; angles turn.

        H: as it is there, if it is known.
        """
        inside, angles = self.wrapped(at), self._angles(measurement)
        if H is None:
            H = self.call(f"{measurement}_H", **{**inputs, "x": inside})
        explicit = hasattr(self.model, f"{measurement}_h")
        if not (explicit or angles.any()):
            return z, H
        Hx = np.einsum("...ij,...j->...i", H, at)
        if explicit:
            off = z - self.call(f"{measurement}_h", **{**inputs, "x": inside})
            return np.where(angles, wrapped(off), off) + Hx, H
        off = z - Hx
        return np.where(angles, z - (off - wrapped(off)), z), H

    def _again(
        self,
        linear: Callable[[Array], tuple[Array, Array]],
        R: Array,
        iterations: int,
        kept: Array | None,
        H: Array,
        x: Array,
        P: Array,
        innovation: Innovation,
    ) -> tuple[Array, Array, Innovation]:
        """The result of the first linearisation, linearised again about itself; each run ends by itself."""
        used = innovation.used

        def corrected(by: Array, P: Array, H: Array) -> Array:
            """(...,) by how many sigmas a state or a row moved at most."""
            variance = np.einsum("...ii->...i", P)
            states = np.where(variance > 0, by**2 / np.where(variance > 0, variance, 1.0), 0.0)
            by_rows = np.where(used, np.einsum("...ij,...j->...i", H, by) ** 2 / R, 0.0)
            return np.sqrt(np.maximum(states.max(-1), by_rows.max(-1)))

        first: tuple[Array, ...] = (x, P, innovation.nu, innovation.S)
        last = first
        before = corrected(x - self.x, P, H)
        going = before > STILL
        for _ in range(iterations):
            inside = self._inside(last[0])
            last, going = chosen(going & ~inside, first, last), going & inside
            if not going.any():
                break
            at = np.where(going[..., None], last[0], self.x)  # a run that has ended stays where there is an answer
            target, H = linear(at)
            x, P, innovation, _ = self._rows(target, H, R, used, None, kept)
            step = corrected(x - at, P, H)
            diverges = ~(step <= np.maximum(before, 1.0))
            last = chosen(going, (x, P, innovation.nu, innovation.S), last)
            last = chosen(going & diverges, first, last)
            going, before = going & ~diverges & (step > STILL), step
        return last[0], last[1], Innovation(last[2], last[3], used)

    def _described(self, measurement: str, what: str) -> Any:
        """What the model says of a measurement, or None."""
        return getattr(self.model, "measurements", {}).get(measurement, {}).get(what)

    def _angles(self, measurement: str) -> Array:
        """(m,) bool: which rows are angles; (1,) if the model does not say."""
        angle = self._described(measurement, "angle")
        return np.array([angle is True or row in (angle or ()) for row in self._described(measurement, "rows") or "x"])

    def _inside(self, x: Array) -> Array:
        """(...,) whether the model's functions answer for x."""
        box = getattr(self.model, "field", {}).get("x")
        at = self.wrapped(x)
        return np.isfinite(at).all(-1) if box is None else ((at >= box["low"]) & (at <= box["high"])).all(-1)

    def _considered(self, measurement: str, given: Any) -> Array | None:
        """(..., n) bool: the states that this measurement does not correct, or None."""
        given = self.considered if given is None else given
        if given is None:
            return None
        kept, n = np.asarray(given), self.P.shape[-1]
        if kept.dtype != bool or kept.shape[-1:] != (n,):
            what = f"has shape {kept.shape}" if kept.dtype == bool else f"is {given!r}"
            raise BoresightError(
                f"{measurement}: considered {what}; it must be (..., {n}), True or False for each state"
            )
        return kept if kept.any() else None

    def _rows(
        self,
        z: Array,
        H: Array,
        R: Array,
        rows: Array,
        gate: float | None,
        kept: Array | None,
        inflate: bool = False,
        linear: Callable[[Array], tuple[Array, Array]] | None = None,
    ) -> tuple[Array, Array, Innovation, Array]:
        """x, P, the innovation and R (..., m) of the rows one after another.

        inflate: whether R rises where a row is beyond the gate.  linear: of x, z and H for the rows behind the first.
        """
        x, n = self.x, self.P.shape[-1]
        runs = np.broadcast_shapes(self.P.shape[:-2], *(one.shape[:-1] for one in (x, z, R, rows)), H.shape[:-2])
        rows = np.broadcast_to(rows, (*runs, z.shape[-1]))
        P, product = np.empty((*runs, n, n)), np.empty((*runs, n, n))  # in place: new memory is slower than the sums
        P[:] = self.P
        nus, Ss, used, raised = (np.empty((*runs, z.shape[-1]), kind) for kind in (float, float, bool, bool))
        R = np.array(np.broadcast_to(R, nus.shape))
        for i in range(z.shape[-1]):
            if i and linear is not None:
                z, H = linear(x)
            h = H[..., i, :]
            Ph = (P @ h[..., None])[..., 0]
            S = np.einsum("...i,...i->...", h, Ph) + R[..., i]
            nu = z[..., i] - np.einsum("...i,...i->...", h, x)
            within = np.ones_like(S, bool) if gate is None else nu**2 <= gate**2 * S
            more = np.zeros_like(S)
            if inflate and gate is not None:
                more = np.where(rows[..., i] & ~within, np.maximum((nu / gate) ** 2 - S, 0.0), 0.0)
                within, S, R[..., i] = np.ones_like(within), S + more, R[..., i] + more
            use = rows[..., i] & within
            K = np.where(use[..., None], Ph / S[..., None], 0.0)
            x = x + K * nu[..., None]
            # Joseph form in its two products, (I - K h') P and that times (I - K h')': multiplied out at once it would
            # lose as much as the first alone does where a good measurement meets a coarse start.
            # By h' P, and not by P h: the rounding by which P is skew stays skew, and the sum at the end takes it out.
            hP = (h[..., None, :] @ P)[..., 0, :]
            P -= np.multiply(K[..., :, None], hP[..., None, :], out=product)
            b = (P @ h[..., None])[..., 0] - R[..., i, None] * K
            P -= np.multiply(b[..., :, None], K[..., None, :], out=product)
            nus[..., i], Ss[..., i], used[..., i], raised[..., i] = nu, S, use, more > 0
        P = np.add(P, np.swapaxes(P, -1, -2), out=product)
        P /= 2
        if kept is not None:
            x, P = left(kept, x, P, self.x, self.P)
        return x, P, Innovation(nus, Ss, used, inflated=raised), R

    def set_block(self, first: int, block: Any) -> None:
        """Make states independent of the others, with a new covariance of their own; x stays.

        What the others have among themselves stays.  For a reset: a heading found anew, a wind that
        has changed.

        Parameters
        ----------
        first : int
            The first of the states, by its place in `model.states`.
        block : (..., count, count) array
            The covariance of this one and those behind it, in the products of their units.

        Raises
        ------
        BoresightError
            No such states, one that is disabled, a block that is no covariance, a sigma beyond its
            ceiling, a P that is not finite.  The filter stays as it was.
        """
        block = np.asarray(block, dtype=float)
        chosen = self._chosen("set_block", first, block.shape[-1] if block.ndim else 0, barred=True)
        self.P = self._replaced("set_block", chosen, block)

    def inflate(self, first: int, variance: Any) -> None:
        """Raise variances of states; nothing else of P changes.

        Parameters
        ----------
        first : int
            The first of the states, by its place in `model.states`.
        variance : (..., count) array
            What is added to the variance of this one and those behind it, in the squares of their
            units.  Beyond its ceiling a variance is lowered, as by `predict`; `at_ceiling` says so.

        Raises
        ------
        BoresightError
            No such states, one that is disabled, a variance that is not finite or negative, a P
            that is not finite.  The filter stays as it was.
        """
        variance = np.asarray(variance, dtype=float)
        chosen = self._chosen("inflate", first, variance.shape[-1] if variance.ndim else 0, barred=True)
        if not (np.isfinite(variance) & (variance >= 0)).all():
            raise BoresightError(f"inflate: variance is {variance}; each must be finite and at least 0")
        states = np.arange(self.P.shape[-1])[chosen]
        P = np.array(
            np.broadcast_to(self.P, (*np.broadcast_shapes(variance.shape[:-1], self.P.shape[:-2]), *self.P.shape[-2:]))
        )
        P[..., states, states] += variance
        self.P, self.at_ceiling = lowered(P, self._ceiling)

    def disable(self, first: int, count: int = 1) -> None:
        """Let states take no part from now on: no variance, no covariance, no gain, in every run.

        No noise and no other state gives them any variance.  Their x stays, but for what a
        prediction makes of it, and counts as known.  `disabled` says which they are.

        Parameters
        ----------
        first, count : int
            The first of the states, by its place in `model.states`, and how many.

        Raises
        ------
        BoresightError
            No such states, a P that is not finite.  The filter stays as it was.
        """
        chosen = self._chosen("disable", first, count)
        disabled = np.zeros(self.P.shape[-1], dtype=bool) if self.disabled is None else self.disabled.copy()
        disabled[chosen] = True
        self.P, self.disabled = without(self.P, disabled), disabled

    def enable(self, first: int, block: Any) -> None:
        """Let states take part, independent of the others; those that are not disabled too.

        Parameters
        ----------
        first : int
            The first of the states, by its place in `model.states`.
        block : (..., count, count) array
            Their covariance, as of `set_block`.

        Raises
        ------
        BoresightError
            As `set_block`, but that a state may be disabled.
        """
        block = np.asarray(block, dtype=float)
        chosen = self._chosen("enable", first, block.shape[-1] if block.ndim else 0)
        self.P = self._replaced("enable", chosen, block)
        if self.disabled is not None:
            disabled = self.disabled.copy()
            disabled[chosen] = False
            self.disabled = disabled if disabled.any() else None

    def _chosen(self, function: str, first: Any, count: Any, barred: bool = False) -> slice:
        """The states from `first` on.  Raise BoresightError where there are none, or one is disabled and barred."""
        n = self.P.shape[-1]
        if not (whole(first) and whole(count) and first >= 0 and 1 <= count <= n - first):
            raise BoresightError(f"{function}: there are no {count!r} states from {first!r} on; the model has {n}")
        chosen = slice(int(first), int(first + count))
        if barred and self.disabled is not None and self.disabled[chosen].any():
            raise BoresightError(f"{function}: a state from {first} on is disabled; enable it")
        if not np.isfinite(self.P).all():
            raise BoresightError(f"{function}: P holds a value that is not finite; assign a finite covariance")
        return chosen

    def _replaced(self, function: str, states: slice, block: Array) -> Array:
        """P with these states independent of the others, and `block` as their covariance."""
        P, count = self.P, states.stop - states.start
        check_covariance(f"{function}: block", block, count)
        self._below_ceiling(f"{function}: block", np.diagonal(block, axis1=-2, axis2=-1), states.start)
        dropped = np.zeros(P.shape[-1], dtype=bool)
        dropped[states] = True
        runs = np.broadcast_shapes(P.shape[:-2], block.shape[:-2])
        P = np.array(np.broadcast_to(without(P, dropped), (*runs, *P.shape[-2:])))
        P[..., states, states] = block
        return P

    def feedback(self) -> None:
        """Correct nav by the estimate x of an error state, and begin anew with x = 0; P stays.

        Call it after the measurements of one instant, and not between them and their prediction.

        Raises
        ------
        BoresightError
            A model without a function `feedback`, as one of a total state.
        """
        self.nav.update(named(self.call("feedback"), self.nav))
        self.x = np.zeros_like(self.x)


def without(P: Array, dropped: Array) -> Array:
    """P with no variance and no covariance of the states (n,) in `dropped`; the others keep theirs."""
    return np.where(dropped[:, None] | dropped, 0.0, P)


def lowered(P: Array, ceiling: Array | None) -> tuple[Array, Array | bool]:
    """P with no variance above its ceiling (n,), by powers of two that change no correlation; and (...,) where."""
    if ceiling is None:
        return P, False
    variance = np.einsum("...ii->...i", P)
    over = variance > ceiling
    if not over.any():
        return P, over.any(-1)
    ratio = np.where(over, variance, ceiling) / ceiling
    scale = np.where(over, 0.5 ** np.ceil(np.log2(ratio) / 2), 1.0)
    return P * scale[..., :, None] * scale[..., None, :], over.any(-1)


def named(result: Any, nav: dict[str, Array]) -> dict[str, Array]:
    """A function with several outputs returns them by name; one with a single output is nav's first entry."""
    return result if isinstance(result, dict) else {next(iter(nav)): result}


def chosen(which: Array, new: tuple[Array, ...], old: tuple[Array, ...]) -> tuple[Array, ...]:
    """Of the runs (...,) in `which` the new arrays, of the others the old ones."""
    return tuple(
        np.where(which.reshape(which.shape + (1,) * depth), a, b)
        for a, b, depth in zip(new, old, (1, 2, 1, 1), strict=True)
    )


def left(kept: Array, x: Array, P: Array, x_before: Array, P_before: Array) -> tuple[Array, Array]:
    """x and P of a measurement with the rows of its gain zeroed for the states (..., n) in `kept`.

    With K the optimal gain, K_s the one that is zeroed and S of the whole measurement, the Joseph form gives
    P + (K - K_s) S (K - K_s)': P differs among the kept states alone, where it is what it was before.
    """
    both = kept[..., :, None] & kept[..., None, :]
    return np.where(kept, x_before, x), np.where(both, P_before, P)


def of_unit_variances(P: Array) -> Array:
    """P scaled to unit variances, so that radians and metres are judged alike."""
    variance = np.diagonal(P, axis1=-2, axis2=-1)
    sigma = np.sqrt(np.where(variance > 0, variance, 1.0))
    scaled: Array = P / (sigma[..., :, None] * sigma[..., None, :])
    return scaled


def check_symmetric(name: str, scaled: Array) -> None:
    """scaled: `of_unit_variances`."""
    skew = np.abs(scaled - np.swapaxes(scaled, -1, -2)).max(initial=0.0)
    if skew > 1e-9:
        raise BoresightError(f"{name} is not symmetric, by {skew:.1e} of its variances; give (P + P') / 2")


def check_covariance(name: str, P: Array, n: int | None = None) -> None:
    """Raise BoresightError unless P is (..., n, n), finite, symmetric, and without a negative eigenvalue."""
    P = np.asarray(P, dtype=float)
    if P.ndim < 2 or P.shape[-2:] != (n or P.shape[-1],) * 2:
        raise BoresightError(f"{name} has shape {P.shape}; it must be (..., {n or 'n'}, {n or 'n'})")
    if not np.isfinite(P).all():
        raise BoresightError(f"{name} holds a value that is not finite; start from a finite covariance")
    variance = np.diagonal(P, axis1=-2, axis2=-1)
    if (variance < 0).any():
        raise BoresightError(f"{name} has a negative variance, {variance.min():.3g}; a covariance has none")
    scaled = of_unit_variances(P)
    check_symmetric(name, scaled)
    lowest = np.linalg.eigvalsh(scaled).min(initial=0.0)
    if lowest < -1e-9:
        raise BoresightError(f"{name} has a negative eigenvalue, {lowest:.1e} of unit variances; it is no covariance")
