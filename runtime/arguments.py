"""What a filter is given, checked against what its model declares: one line for a wrong name, shape or size."""

from collections.abc import Collection, Mapping
from typing import Any

import numpy as np

from boresight.errors import BoresightError, did_you_mean
from boresight.runtime.array import Array

MOST_ITERATIONS = 64  # as BS_MOST_ITERATIONS in boresight_filter.h


def whole(number: Any) -> bool:
    return isinstance(number, int | np.integer) and not isinstance(number, bool)


def check_inputs(
    function: str,
    model: Any,
    inputs: Mapping[str, Any],
    nav: Mapping[str, Array],
    P: Array,
    taken: Collection[str] = (),
) -> None:
    """Raise BoresightError on an input that the model does not have, and in one run on a number that comes in a list.

    nav, P: of the filter, whose leading axes are runs.  taken: what the function takes, a field of the model or not.
    A model that declares no fields is not checked.
    """
    fields = getattr(model, "field", None)
    if fields is None:
        return
    for name, value in inputs.items():
        if name in taken and name not in fields:
            continue
        if name not in fields:
            guess = did_you_mean(name, fields) or f"; it has {', '.join(fields)}"
            raise BoresightError(f"{function}: {model.name} has no input {name!r}{guess}")
        if P.ndim == 2 and fields[name]["size"] == 1 and np.shape(value) == (1,) and one_run(fields, nav):
            raise BoresightError(f"{function}: {name} has shape (1,), an axis of runs; for one run give a number")


def one_run(fields: Mapping[str, Any], nav: Mapping[str, Array]) -> bool:
    return all(np.ndim(value) == (fields[name]["size"] > 1) for name, value in nav.items() if name in fields)


def check_own_state(function: str, inputs: Mapping[str, Any]) -> None:
    """Raise BoresightError on the state among the inputs: it is the filter's own, and would not be read."""
    if "x" in inputs:
        raise BoresightError(f"{function}: x is the filter's own state; assign it, as loop.x = ..., and leave x out")


def check_taking(
    measurement: str, rows: Any, gate: Any, joint: Any, iterations: Any, inflate: bool, relinearize: bool
) -> None:
    """Raise BoresightError on rows that are neither True nor False, gates of no size, iterations of no number, and
    options that do not go together."""
    if np.asarray(rows).dtype.kind not in "biuf":
        raise BoresightError(f"{measurement}: rows is {rows!r}; give True or False for each row")
    if gate is not None and not (np.asarray(gate).dtype.kind in "iuf" and 0 < gate < np.inf):
        raise BoresightError(
            f"{measurement}: gate is {gate!r} sigmas; give a number above zero, or leave it out for no gate"
        )
    if joint is not None and not (np.asarray(joint).dtype.kind in "iuf" and 0 < joint < np.inf):
        raise BoresightError(
            f"{measurement}: joint is {joint!r}; give a quantile of chi-square above zero, or leave it out for no gate"
        )
    if not (isinstance(iterations, int | np.integer) and 1 <= iterations <= MOST_ITERATIONS):
        raise BoresightError(
            f"{measurement}: iterations is {iterations!r}; it must be a whole number from 1 to {MOST_ITERATIONS}"
        )
    if inflate and gate is None:
        raise BoresightError(f"{measurement}: inflate raises R of a row beyond its gate; give a gate too")
    if relinearize and iterations > 1:
        raise BoresightError(f"{measurement}: relinearize takes each row once; leave iterations out")


def check_start(model: Any, nav: Mapping[str, Array], P: Array) -> None:
    """The same for what a filter begins with, and for the sizes of nav and P."""
    check_shape(model, P)
    check_nav(model, nav, P)


def check_shape(model: Any, P: Array) -> None:
    """Raise BoresightError unless P is (..., n, n)."""
    states = getattr(model, "states", None)
    n = len(states) if states is not None else P.shape[-1] if P.ndim else 0
    if P.shape[-2:] != (n, n):
        named = f" for the states {', '.join(states)}" if states is not None else ""
        raise BoresightError(f"P has shape {P.shape}; it must be (..., {n}, {n}){named}")


def check_state(x: Array, n: int) -> None:
    """Raise BoresightError unless x is (..., n)."""
    if x.shape[-1:] != (n,):
        raise BoresightError(f"x has shape {x.shape}; it must be (..., {n}), as P is (..., {n}, {n})")


def check_nav(model: Any, nav: Mapping[str, Array], P: Array) -> None:
    """Raise BoresightError unless the model has these fields, each (..., size).  P: as of `check_inputs`."""
    check_inputs("nav", model, nav, {}, P)
    fields = getattr(model, "field", None) or {}
    for name, value in nav.items():
        size = fields[name]["size"] if name in fields else 1
        if size > 1 and value.shape[-1:] != (size,):
            raise BoresightError(f"nav: {name} has shape {value.shape}; its last axis must be {size} long")
