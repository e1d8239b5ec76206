"""Three answers to one question, and who is right."""

import math
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from importlib.util import module_from_spec
from pathlib import Path
from typing import Any

import numpy as np
from mpmath import mp

from boresight.evidence.crossed.exact import DIGITS

ROUNDING, OURS, THEIRS, NEITHER = "rounding", "ours", "the peer", "neither"
NEARER = 10  # times, from which on one of two approximations is called right


@dataclass(frozen=True)
class Numbers:
    """Three answers of one shape, the largest number on their way, and how many roundings of it that way has."""

    ours: Any
    peer: Any
    exact: Any
    scale: float
    roundings: int

    def result(self) -> dict[str, Any]:
        """The largest number of ours, and by how much two of the answers differ at most."""
        ours, peer, exact = map(flat, (self.ours, self.peer, self.exact))
        if not len(ours) == len(peer) == len(exact):
            raise ValueError(f"answers of {len(ours)}, {len(peer)} and {len(exact)} numbers")
        with mp.workdps(DIGITS):
            return {
                "number": float(max(ours, key=abs)),
                "apart": apart(ours, peer),
                "ours": apart(ours, exact),
                "peer": apart(peer, exact),
                "allowed": self.roundings * self.scale * 2.0**-53,
            }


def flat(values: Any) -> list[Any]:
    """All numbers, row after row, with the digits that they have."""
    if isinstance(values, mp.matrix):
        return list(values)
    if isinstance(values, mp.mpf):
        return [values]
    if isinstance(values, list | tuple):
        return [number for part in values for number in flat(part)]
    return [mp.mpf(float(number)) for number in np.ravel(values)]


def apart(a: list[Any], b: list[Any]) -> float:
    """The largest difference, as a float of three digits, which is enough to compare and to read."""
    return float(f"{float(max(abs(x - y) for x, y in zip(a, b, strict=True))):.2e}")


def verdict(of: Mapping[str, float]) -> str:
    """Who is right by the 50 digits: both within their roundings, or the one that is ten times nearer; else neither.
    What is no number is not right."""
    ours, peer = (of[key] if of[key] < math.inf else math.inf for key in ("ours", "peer"))
    if max(ours, peer) <= of["allowed"]:
        return ROUNDING
    if ours == peer:
        return NEITHER
    return OURS if NEARER * ours <= peer else THEIRS if NEARER * peer <= ours else NEITHER


@dataclass(frozen=True)
class Check:
    """One question.  of: the generated folders and the modules of which our answer is; wanted, why: where the answers
    differ by more than rounding, what the verdict must be and the reason."""

    name: str
    unit: str
    ask: Callable[[], Numbers]
    of: tuple[str, ...]
    wanted: str = ROUNDING
    why: str = ""

    def made(self) -> dict[str, Any]:
        with mp.workdps(DIGITS):
            found = self.ask().result()
        if problem := self.problem(found):
            raise AssertionError(f"{self.name}: {problem}")
        return found

    def problem(self, found: Mapping[str, float]) -> str:
        """What is wrong with a result; nothing if it is as the check says."""
        if (self.wanted == ROUNDING) != (not self.why):
            return "a difference that is not rounding needs a reason, and rounding needs none"
        judged = verdict(found)
        numbers = ", ".join(f"{key} {found[key]:.1e}" for key in ("apart", "ours", "peer", "allowed"))
        return "" if judged == self.wanted else f"{judged} is right, not {self.wanted}: {numbers}"


@dataclass(frozen=True)
class Peer:
    """An independent tool, by the name under which pip installs it; file: the module of its checks."""

    name: str
    file: str
    checks: tuple[Check, ...]

    @property
    def version(self) -> str:
        try:
            return version(self.name)
        except PackageNotFoundError:
            return ""

    @property
    def tools(self) -> str:
        """The versions that its answers hang on."""
        return f"{self.name} {self.version}, numpy {np.__version__}"

    def hashes(self, subject: Any) -> dict[str, str]:
        """By check, of all that its result hangs on."""
        made: dict[str, str] = subject.hashes(
            Path(self.file).resolve(), {check.name: check.of for check in self.checks}
        )
        return made

    @property
    def missing(self) -> str:
        return "" if self.version else f"{self.name} is not installed; make cross-checks"

    def make(self, subject: Any, out: Any, names: Collection[str]) -> dict[str, dict[str, Any]]:
        """By check, of these."""
        return {check.name: check.made() for check in self.checks if check.name in names}


def printed_module(text: str, name: str) -> Any:
    """A module of a text that a peer has printed."""
    from importlib.machinery import ModuleSpec

    made = module_from_spec(ModuleSpec(name, None))
    exec(compile(text, name, "exec"), made.__dict__)
    return made
