"""The error that a user sees, and the two remedies that many messages end with."""

from collections.abc import Iterable
from importlib.util import find_spec

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
    "evidence": ("unicorn", "elftools", "pycparser"),
    "gpu": ("cuda", "nvidia"),
}


class BoresightError(Exception):
    """One line for the user: what is wrong, where, and what to do about it.

    Every refusal of the library is one: bad input, a model that does not fit together, a missing file, compiler or
    extra.  Do not catch it to go on with what was refused: nothing was changed by the call that raised it.

    Examples
    --------
    >>> from boresight import BoresightError, load
    >>> try:
    ...     load("euler-maching")
    ... except BoresightError as error:
    ...     print(error)  # doctest: +ELLIPSIS
    no generated model 'euler-maching' (did you mean 'euler-matching'?); built in are ...
    """


BoresightError.__module__ = "boresight"  # where a user finds it, and reads it in a traceback


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
