"""A Kalman filter over a model's functions, of an error state or of a total state: one run, or many side by side.

Everything here broadcasts: P is (..., n, n), and what stands before the last axes are runs.  The same loop flies the
compiled C of `boresight.runtime.library` and any object that offers the same functions in plain NumPy.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.arguments import check_inputs, check_start
from boresight.runtime.array import Array
from boresight.runtime.rotation import wrapped


@dataclass(frozen=True)
class Innovation:
    """The innovation of one measurement.  Rows that were masked or gated have used = False and add nothing to nis."""

    nu: Array  # (..., m) z - H x, or z - h(x) where h is not linear: row after row, each given the rows before it
    S: Array  # (..., m) the variance of nu
    used: Array  # (..., m) bool

    @property
    def nis(self) -> Array:
        """(...,) sum of nu^2 / S over the rows used: chi-square with `used.sum(-1)` degrees of freedom."""
        return np.sum(np.where(self.used, self.nu**2 / self.S, 0.0), axis=-1)


class Filter:
    """Predict, update by a named measurement, feed back.

    model: offers `Phi`, `Q`, `NAME_z`, `NAME_H` (and `NAME_h` where H depends on x), `feedback`, `strapdown`, and
    `next` if its state is total; each is called with the fields that it lists in `.fields`.  `wraps`: the places
    of the states that are kept in [-pi, pi).
    nav: the quantities that the strapdown carries and the feedback corrects, by field name, each (..., size).
    P: (..., n, n) covariance of the state.
    x: (..., n) where a total state begins.  An error state begins, by default, and after each feedback, at zero.
    """

    def __init__(self, model: Any, nav: dict[str, Array], P: Array, x: Any = None):
        self.model = model
        self.nav = {name: np.array(value, dtype=float) for name, value in nav.items()}
        self.P = np.array(P, dtype=float)
        check_start(model, self.nav, self.P)
        check_covariance("P", self.P)
        self.total = "next" in dir(model)
        if x is None and self.total:
            raise BoresightError(f"{getattr(model, 'name', model)!s} has a total state; give x, where it begins")
        self.x = self._start(x)

    def _start(self, x: Any) -> Array:
        n = self.P.shape[-1]
        x = np.zeros(n) if x is None else np.asarray(x, dtype=float)
        if x.ndim < 1 or x.shape[-1] != n:
            raise BoresightError(f"x has shape {x.shape}; it must be (..., {n}), as P is (..., {n}, {n})")
        runs = np.broadcast_shapes(self.P.shape[:-2], x.shape[:-1])
        return self.wrapped(np.array(np.broadcast_to(x, (*runs, n))))

    def wrapped(self, x: Array) -> Array:
        """The state x with those of its angles that wrap in [-pi, pi)."""
        places = getattr(self.model, "wraps", ())
        if places:
            x = x.copy()
            x[..., places] = wrapped(x[..., places])
        return x

    def call(self, name: str, **inputs: Any) -> Any:
        """The model's function NAME, fed from nav, the state x and the inputs."""
        unit = getattr(self.model, name)
        check_inputs(name, self.model, inputs, self.nav, self.P, unit.fields)
        known = {**self.nav, "x": self.x, **inputs}
        missing = [field for field in unit.fields if field not in known]
        if missing:
            raise BoresightError(f"{name} needs {', '.join(missing)}; pass it as a keyword")
        return unit(**{field: known[field] for field in unit.fields})

    def strapdown(self, **inputs: Any) -> None:
        """Carry nav over one interval of inertial data."""
        self.nav.update(named(self.call("strapdown", **inputs), self.nav))

    def predict(self, **inputs: Any) -> None:
        """Carry x and P over `dt`: a total state by `next`, an error state by Phi."""
        Phi, Q = self.call("Phi", **inputs), self.call("Q", **inputs)
        after = self.call("next", **inputs) if self.total else np.einsum("...ij,...j->...i", Phi, self.x)
        self.x = self.wrapped(after)
        self.P = Phi @ self.P @ np.swapaxes(Phi, -1, -2) + Q

    def update(
        self,
        measurement: str,
        R: Any,
        *,
        rows: Any = True,
        gate: float | None = None,
        iterations: int = 1,
        **inputs: Any,
    ) -> Innovation:
        """Take one measurement, row after row, in Joseph form.

        R: (..., m) variances of the rows, which are independent.  rows: (..., m) bool, False for a row that is absent.
        gate: a row whose |nu| exceeds this many sigmas is left out.  iterations: how often a nonlinear measurement is
        linearised again about the estimate it gave; 1 is the plain extended filter.
        """
        z = self.call(f"{measurement}_z", **inputs)
        R = np.broadcast_to(np.asarray(R, dtype=float), np.broadcast_shapes(z.shape, np.shape(R)))
        if not (np.isfinite(R).all() and (R > 0).all()):
            raise BoresightError(f"{measurement}: every variance in R must be finite and above zero")
        if iterations < 1:
            raise BoresightError(f"{measurement}: iterations is {iterations}; it must be at least 1")
        nonlinear = "x" in getattr(self.model, f"{measurement}_H").fields
        x = self.x
        for _ in range(iterations if nonlinear else 1):
            H = self.call(f"{measurement}_H", x=x, **inputs)
            target = z
            if nonlinear:  # h about x, so that the rows below may treat it as linear in the state
                h = self.call(f"{measurement}_h", x=x, **inputs)
                target = z - h + np.einsum("...ij,...j->...i", H, x)
            x, P, innovation = self._rows(target, H, R, np.asarray(rows), gate)
        self.x, self.P = x, P
        return innovation

    def _rows(self, z: Array, H: Array, R: Array, rows: Array, gate: float | None) -> tuple[Array, Array, Innovation]:
        x, P = self.x, self.P
        rows = np.broadcast_to(rows, np.broadcast_shapes(rows.shape, x.shape[:-1] + z.shape[-1:]))
        nus, Ss, used = [], [], []
        for i in range(z.shape[-1]):
            h = H[..., i, :]
            Ph = np.einsum("...ij,...j->...i", P, h)
            S = np.einsum("...i,...i->...", h, Ph) + R[..., i]
            nu = z[..., i] - np.einsum("...i,...i->...", h, x)
            use = rows[..., i] & (np.ones_like(S, bool) if gate is None else nu**2 <= gate**2 * S)
            K = np.where(use[..., None], Ph / S[..., None], 0.0)
            x = x + K * nu[..., None]
            # Joseph form in its two products, (I - K h') P and that times (I - K h')': multiplied out at once it would
            # lose as much as the first alone does where a good measurement meets a coarse start.
            A = P - K[..., :, None] * Ph[..., None, :]
            b = np.einsum("...ij,...j->...i", A, h)
            KK = K[..., :, None] * K[..., None, :]
            P = A - b[..., :, None] * K[..., None, :] + R[..., i, None, None] * KK
            P = (P + np.swapaxes(P, -1, -2)) / 2
            nus.append(nu)
            Ss.append(S)
            used.append(use)
        stack = [np.stack(np.broadcast_arrays(*part), axis=-1) for part in (nus, Ss, used)]
        return x, P, Innovation(*stack)

    def feedback(self) -> None:
        """Correct nav by the estimate and begin again from zero."""
        self.nav.update(named(self.call("feedback"), self.nav))
        self.x = np.zeros_like(self.x)


def named(result: Any, nav: dict[str, Array]) -> dict[str, Array]:
    """A function with several outputs returns them by name; one with a single output is nav's first entry."""
    return result if isinstance(result, dict) else {next(iter(nav)): result}


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
    # Scaled to unit variances, so that radians and metres are judged alike.
    sigma = np.sqrt(np.where(variance > 0, variance, 1.0))
    scaled = P / (sigma[..., :, None] * sigma[..., None, :])
    skew = np.abs(scaled - np.swapaxes(scaled, -1, -2)).max(initial=0.0)
    if skew > 1e-9:
        raise BoresightError(f"{name} is not symmetric, by {skew:.1e} of its variances; give (P + P') / 2")
    lowest = np.linalg.eigvalsh(scaled).min(initial=0.0)
    if lowest < -1e-9:
        raise BoresightError(f"{name} has a negative eigenvalue, {lowest:.1e} of unit variances; it is no covariance")
