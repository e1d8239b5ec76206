"""Whether a filter knows how wrong it is: errors against P, innovations against S, over the runs of a flight.

Of a filter that does, the squared error weighed by P (NEES) is chi-square with as many degrees of freedom as there are
states, and the squared innovation weighed by S (NIS) with as many as there are rows; their means over the runs lie
in a band that is known beforehand.
"""

from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from boresight import BoresightError, __version__
from boresight.runtime.array import Array
from boresight.runtime.filter import Innovation

DRAWN = 20  # runs whose errors are drawn
SURE = 0.95


def chi_square_band(freedom: int, count: int) -> list[float]:
    """95 % band of the mean of `count` chi-square numbers of so many degrees of freedom."""
    from scipy.special import gammaincinv  # of scipy.stats, which takes a second to import, the same number

    return [float(2 * gammaincinv(freedom * count / 2, q) / count) for q in ((1 - SURE) / 2, (1 + SURE) / 2)]


def nees(error: Array, P: Array) -> Array:
    """(...,) the squared error (..., n) weighed by its covariance (..., n, n)."""
    weighed: Array = np.einsum("...i,...i->...", error, np.linalg.solve(P, error[..., None])[..., 0])
    return weighed


class Consistency:
    """Whether a filter knows how wrong it is: errors against P (NEES), innovations against S (NIS).

    Give it the errors and innovations of a flight whose truth is known, of one run or of many, then
    `report` or `draw`.

    Parameters
    ----------
    shown : dict of str to float
        Each state's label and the factor by which it is shown, as {"heading, deg": 180 / pi}; in
        the order of P.

    Attributes
    ----------
    times : list of float
        s, of the errors.
    errors, sigmas : (T, runs, n) array
        By the factors.
    nees : (T,) array
        Mean over the runs of the squared error weighed by P; n of a consistent filter.
    nees_band : list of float
        Where `nees` lies at 95 % of all times.
    nees_inside : float
        The part of all times at which it does.
    measurements : tuple of str
        Those of which innovations were given.

    Raises
    ------
    BoresightError
        An error or covariance of another number of states than `shown` has.

    Notes
    -----
    When not to use it: without truth; then NIS alone says something, and it does not see every
    mistake.  Errors of one run at neighbouring times are not independent: the bands are those of
    each time.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import Consistency, Innovation
    >>> judged = Consistency({"height, m": 1.0})
    >>> judged.error(1.0, np.array([[2.0], [-2.0]]), np.array([[4.0]]))
    >>> judged.innovation(1.0, "baro", Innovation(np.array([1.0]), np.array([1.0]), np.array([True])))
    >>> print(judged.report())
    at 1 s, 2 runs   rms error       sigma
    height, m                2           2
    NEES 1.00 of 1; in 0.03 to 3.69 at 100% of all times (95 % expected)
    NIS of baro 1.000 per row; 0.001 to 5.024 expected
    """

    def __init__(self, shown: dict[str, float]):
        self.labels, self.factors = list(shown), np.array(list(shown.values()))
        self.times: list[float] = []
        self._errors: list[Array] = []
        self._sigmas: list[Array] = []
        self._nees: list[Array] = []
        self._innovations: dict[str, list[tuple[float, Array, Array]]] = {}

    def error(self, time: float, error: Array, P: Array) -> None:
        """Add the errors of one time.

        Parameters
        ----------
        time : float
            s.
        error : (runs, n) or (n,) array
            Computed - true, in the units of P; of an angle less whole turns.
        P : (runs, n, n) or (n, n) array
            The filter's covariance.

        Raises
        ------
        BoresightError
            Another number of states than `shown` has.
        """
        error, n = np.atleast_2d(error), len(self.labels)
        if error.shape[-1] != n or np.shape(P)[-2:] != (n, n):
            raise BoresightError(
                f"the error has shape {np.shape(error)} and P {np.shape(P)}; they must be (..., {n}) and "
                f"(..., {n}, {n}) of {', '.join(self.labels)}"
            )
        self.times.append(time)
        P = np.broadcast_to(P, (*error.shape, error.shape[-1]))
        self._errors.append(error * self.factors)
        self._sigmas.append(np.sqrt(np.diagonal(P, axis1=-2, axis2=-1)) * self.factors)
        self._nees.append(nees(error, P))

    def innovation(self, time: float, measurement: str, found: Innovation) -> None:
        """Add the innovation of one measurement.

        Parameters
        ----------
        time : float
            s.
        measurement : str
            Its name.
        found : Innovation
            What `Filter.update` returned.
        """
        taken = (time, np.atleast_1d(found.nis), np.atleast_1d(found.used.sum(-1)))
        self._innovations.setdefault(measurement, []).append(taken)

    @property
    def errors(self) -> Array:
        """(T, runs, n) by the factors."""
        return np.array(self._errors)

    @property
    def sigmas(self) -> Array:
        """(T, runs, n) by the factors."""
        return np.array(self._sigmas)

    @property
    def nees(self) -> Array:
        """(T,) mean over the runs."""
        return np.array(self._nees).mean(-1)

    @property
    def nees_band(self) -> list[float]:
        """Where `nees` lies at 95 % of all times."""
        return chi_square_band(len(self.labels), self.errors.shape[1])

    @property
    def nees_inside(self) -> float:
        """The part of all times at which `nees` lies in its band."""
        low, high = self.nees_band
        return float(np.mean((low <= self.nees) & (self.nees <= high)))

    @property
    def measurements(self) -> tuple[str, ...]:
        return tuple(self._innovations)

    def nis_sum(self, measurement: str) -> tuple[float, int]:
        """NIS of all runs and times together.

        Parameters
        ----------
        measurement : str
            Its name.

        Returns
        -------
        total : float
            The sum.
        rows : int
            How many rows were used: its degrees of freedom.
        """
        _, nis, rows = map(np.array, zip(*self._innovations[measurement], strict=True))
        return float(nis.sum()), int(rows.sum())

    def nis(self, measurement: str) -> tuple[float, list[float]]:
        """NIS for each row used, mean of all runs and times.

        Parameters
        ----------
        measurement : str
            Its name.

        Returns
        -------
        mean : float
            1 of a consistent filter.
        band : list of float
            Where the mean lies 95 times of 100.
        """
        total, rows = self.nis_sum(measurement)
        return total / rows, chi_square_band(1, rows)

    def report(self) -> str:
        """The errors at the end, NEES and NIS with their bands.

        Returns
        -------
        str
            A table in text.
        """
        width = max(map(len, self.labels))
        rms = np.sqrt(np.mean(self.errors[-1] ** 2, axis=0))
        sigma = np.sqrt(np.mean(self.sigmas[-1] ** 2, axis=0))
        lines = [f"at {self.times[-1]:g} s, {self.errors.shape[1]} runs".ljust(width) + "   rms error       sigma"]
        width = max(width, len(lines[0]) - 24)
        lines += [f"{name:{width}}{e:12.4g}{s:12.4g}" for name, e, s in zip(self.labels, rms, sigma, strict=True)]
        low, high = self.nees_band
        lines.append(
            f"NEES {self.nees.mean():.2f} of {len(self.labels)}; "
            f"in {low:.2f} to {high:.2f} at {self.nees_inside:.0%} of all times (95 % expected)"
        )
        for name in self._innovations:
            mean, (low, high) = self.nis(name)
            lines.append(f"NIS of {name} {mean:.3f} per row; {low:.3f} to {high:.3f} expected")
        return "\n".join(lines)

    def draw(self, path: str | Path) -> str:
        """Draw errors with 3 sigma, NEES and NIS with their bands.

        Parameters
        ----------
        path : str or Path
            Of the figure, PNG or SVG by its ending.

        Returns
        -------
        str
            A line that says where the figure is, or what to install.
        """
        if find_spec("matplotlib") is None:
            return "no figure: matplotlib is missing; run pip install 'boresight[replay]'"
        from boresight.analysis.figures import BLUE, ORANGE, figure

        panels = len(self.labels) + 1 + len(self._innovations)
        columns = 1 if panels <= 4 else 3
        rows = -(-panels // columns)
        size: dict[str, Any] = {"nrows": rows, "ncols": columns, "sharex": True, "squeeze": False}
        size["made_from"] = f"boresight {__version__}, {self.errors.shape[1]} runs"
        with figure(Path(path), 8 if columns == 1 else 12, 0.5 + 1.7 * rows, **size) as (drawing, axes):
            axes = axes.ravel()
            for i, (ax, label) in enumerate(zip(axes, self.labels, strict=False)):
                limit = 3 * np.sqrt(np.mean(self.sigmas[..., i] ** 2, axis=1))
                ax.plot(self.times, self.errors[:, :DRAWN, i], color=BLUE, linewidth=0.6, alpha=0.5)
                ax.plot(self.times, limit, color=ORANGE)
                ax.plot(self.times, -limit, color=ORANGE)
                ax.set_title(label)
            self._chi_square(axes[len(self.labels)], "NEES", self.times, self.nees, self.nees_band)
            for ax, (name, taken) in zip(axes[len(self.labels) + 1 :], self._innovations.items(), strict=False):
                times, nis, used = map(np.array, zip(*taken, strict=True))
                m = int(used.max())
                self._chi_square(ax, f"NIS of {name}", times, nis.mean(-1), chi_square_band(m, nis.shape[-1]))
            for ax in axes[panels:]:
                ax.remove()
            for ax in axes[max(panels - columns, 0) : panels]:
                ax.set_xlabel("time [s]")
                ax.tick_params(labelbottom=True)
            runs = min(DRAWN, self.errors.shape[1])
            drawing.suptitle(f"errors of {runs} runs (blue), and 3 sigma of the filter (orange)")
        return f"figure in {path}"

    def _chi_square(self, ax: Any, title: str, times: Any, mean: Array, band: list[float]) -> None:
        from boresight.analysis.figures import BLUE, FAINT

        ax.axhspan(*band, **FAINT)
        ax.plot(times, mean, color=BLUE, linewidth=0.8)
        ax.margins(y=0.1)
        ax.set_title(f"{title}, mean of the runs, and 95 % band")
