"""Which axes a recording's columns would have to have: what the check proposes where those that are named do not."""

from dataclasses import replace

import numpy as np

from boresight.runtime import frames
from boresight.runtime.array import Array
from boresight.runtime.recording.types import Finding, Master
from boresight.runtime.units import STANDARD_GRAVITY as G

ALIKE = 0.3  # of the squares of the master's turns or steps that may be left over where axes fit
NAMES = {"down", "gravity", "turns", "side"}


def bodies(force: Array, slave: Array | None = None, master: Array | None = None) -> list[str]:
    """The right-handed body frames in which the file's axes would fit, best first; none where none does.

    force: (3,) m/s^2, mean specific force in the file's axes, which must point up.  slave, master: (K, 3) rad, turns
    in the file's axes and of the master in FRD; without them four frames fit that differ in what is front.
    """
    up = {name: M for name, M in frames.every_body().items() if -(M @ force)[2] > 0.8 * np.linalg.norm(force)}
    if slave is None or master is None or not len(master):
        return sorted(up, key=lambda name: name[0] != "F")
    slave, master = slave - slave.mean(axis=0), master - master.mean(axis=0)
    whole = np.sum(master**2, axis=0)
    left = {name: float(np.max(np.sum((slave @ M.T - master) ** 2, axis=0) / whole)) for name, M in up.items()}
    return [name for name in sorted(left, key=left.__getitem__) if left[name] < ALIKE]


def orders(master: Master, columns: Array) -> list[str]:
    """The orders of the velocity's columns (M, 3) in which it would sum to what the position moves, best first."""
    assert master.position is not None
    lat, lon, height = master.position.T
    place = np.column_stack([lat, lon * np.cos(lat[0]), np.zeros_like(lat)]) * (6371e3 + height[0])
    place[:, 2] = -height
    summed = np.cumsum((columns[1:] + columns[:-1]) / 2 * np.diff(master.time)[:, None], axis=0)
    cuts = np.unique(np.linspace(0, len(summed) - 1, 25).round().astype(int))
    moved, summed = np.diff(place[1:][cuts], axis=0), np.diff(summed[cuts], axis=0)
    left = {name: np.sum((summed @ T.T - moved) ** 2, axis=0) for name, T in frames.every_order().items()
            if "south" not in name}  # fmt: skip
    whole = np.sum(moved**2, axis=0)
    if (whole < 1.0).any():  # a component that hardly moves fits either sign
        return []
    off = {name: float(np.max(parts / whole)) for name, parts in left.items()}
    return [name for name in sorted(off, key=off.__getitem__) if off[name] < ALIKE / 3]


def proposed(findings: list[Finding], text: str, names: set[str]) -> list[Finding]:
    """The findings, with a proposal at the first error of these names."""
    at = next((i for i, one in enumerate(findings) if one.level != "note" and one.name in names), None)
    if at is None or not text:
        return findings
    return [replace(one, text=f"{one.text}; {text}") if i == at else one for i, one in enumerate(findings)]


def of_body(force: Array, fits: list[str], declared: str) -> str:
    """What to write of the slave's axes: "" where those that are declared fit, or none do."""
    if not fits or declared in fits or not 0.5 * G < np.linalg.norm(force) < 2 * G:
        return ""
    axis = int(np.argmax(np.abs(force)))
    sign = "-" if force[axis] < 0 else "+"
    side = "down" if force[axis] < 0 else "up"
    more = f" (or {', '.join(fits[1:])}, by what is front)" if len(fits) > 1 else ""
    return f'body = "{fits[0]}" fits{more}: the mean force is along {sign}{"xyz"[axis]} of the file, which is {side}'
