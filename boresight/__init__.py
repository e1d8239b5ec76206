"""Boresight: from the equations of an inertial-navigation filter to C that can be flown.

The conventions, said once; every generated artefact prints them, docs/conventions.md explains them.

- Error = computed - true.  ``C_hat = (I - [e x]) C``: the small rotation ``e`` is what must be applied to remove it.
- ``C_b2n`` takes body components to navigation components: ``v_n = C_b2n @ v_b``.  NED with front-right-down,
  or ENU with right-front-up; never mixed.  A rate names all its frames: ``omega_ie_n``.
- SI and radians inside and in C.  Where another unit enters or leaves, it is in the name: ``gyro_bias_deg_h``.
- Quaternions are Hamilton, scalar first, body to navigation: ``q_b2n_wxyz``.
- A master's data is old by ``tau > 0``; a lever arm runs from master to slave in slave body axes.
- Matrices are row-major.
"""

from collections.abc import Iterable
from importlib.util import find_spec

__version__ = "0.1.0"

# The modules that each extra of the installation brings.
EXTRAS = {
    "derive": ("sympy", "mpmath", "flint", "casadi", "jinja2", "markupsafe", "pint"),
    "replay": ("pydantic", "pandas", "matplotlib", "jinja2", "markdown_it"),
    "parquet": ("pandas", "pyarrow"),
    "excel": ("pandas", "openpyxl"),
    "hdf5": ("h5py",),
    "ulog": ("pyulog",),
    "ardupilot": ("pymavlink",),
    "ros": ("rosbags",),
    "cluster": ("dask", "distributed"),
    "cli": ("typer", "rich"),
}


class BoresightError(Exception):
    """One line for the user: what is wrong, where, and what to do about it."""


def need(extra: str) -> None:
    """Raise a BoresightError that says what to install, unless all modules of the extra are there."""
    missing = [name for name in EXTRAS[extra] if find_spec(name) is None]
    if missing:
        raise BoresightError(f"{', '.join(missing)} not found; run pip install 'boresight[{extra}]'")


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """` (did you mean 'gyro_noise'?)` where one of the known names is like this one, else nothing."""
    from difflib import get_close_matches

    folded = {other.lower(): other for other in known}
    close = get_close_matches(name.lower(), folded, 1)
    return f" (did you mean {folded[close[0]]!r}?)" if close else ""
