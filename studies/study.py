"""A study: what can be chosen of it, what it flies, what it prints, what it draws, and which claims it judges.

The command line makes a command of each in `known` and of its scenario's options; a replay is a study whose scenario
is a recording.
"""

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, fields, is_dataclass, replace
from hashlib import sha256
from textwrap import wrap
from typing import Any

import numpy as np

from boresight import BoresightError, __version__
from boresight.analysis.figures import Sheets
from boresight.runtime.manifest import folder_of, read_manifest

Progress = Callable[[str], None]
Result = dict[str, Any]  # can be written as JSON, but for what stands under "history", which only figures show


@dataclass(frozen=True)
class Claim:
    """A statement that a run decides; numbers: those that decide it, by name, None where one was never reached."""

    says: str
    holds: bool
    numbers: Mapping[str, float | None]


@dataclass(frozen=True)
class Study:
    """One experiment.

    scenario: a frozen dataclass; its fields made by `option` can be chosen on the command line.  run: of a scenario and
    of a function that is told what is done now.  claims: what a result says of the paper.  good: whether all is well.
    """

    name: str
    models: tuple[str, ...]  # generated ones that it flies
    scenario: type
    run: Callable[[Any, Progress], Result]
    report: Callable[[Result], str]
    figures: Callable[[Result, Sheets], None] | None = None
    claims: Callable[[Result], list[Claim]] | None = None
    good: Callable[[Result], bool] = lambda result: True
    markdown: bool = False  # what `report` writes

    def options(self) -> list[Any]:
        """The fields of the scenario that can be chosen."""
        return [one for one in fields(self.scenario) if "help" in one.metadata]

    def made_from(self, scenario: Any) -> str:
        """Seed, version and hash of the generated C that flies, for the edge of a figure."""
        files = [read_manifest(folder_of(name))["files"] for name in self.models]
        digest = sha256(json.dumps(files, sort_keys=True).encode()).hexdigest()[:8]
        seed = f"seed {scenario.seed}, " if hasattr(scenario, "seed") else ""
        return f"{self.name}, {seed}boresight {__version__}, C {digest}"


def option(default: Any, says: str) -> Any:
    """A field of a scenario that can be chosen on the command line."""
    return field(default=default, metadata={"help": says})


@dataclass(frozen=True)
class Seeded:
    """What every scenario of random runs has."""

    runs: int = option(20, "Monte Carlo runs of each case.")
    seed: int = option(0, "Seed of the random numbers; those of a run depend only on seed and run.")


@dataclass(frozen=True)
class Replay:
    """The scenario of a replay: a recording, and what the replay's `run` takes by name."""

    recording: Any
    settings: Mapping[str, Any] = field(default_factory=dict)


def checked(name: str, scenario: Any, signed: Sequence[str], limits: Mapping[str, tuple[float, float]]) -> None:
    """Raises BoresightError for a number of the scenario that has no meaning: not finite, negative, beyond its limits.

    name: of the study.  signed: fields that may be negative.  limits: lowest and highest of a field.
    """
    for key, value in asdict(scenario).items():
        numbers = np.asarray(value)
        if numbers.dtype.kind not in "biuf":
            continue
        low, high = limits.get(key, (-np.inf if key in signed else 0.0, np.inf))
        if not np.isfinite(numbers).all() or (numbers < low).any() or (numbers > high).any():
            span = f"within {low:g} to {high:g}" if key in limits else "and not negative" * (key not in signed)
            raise BoresightError(f"{name}: {key} is {value}; it must be finite {span}".rstrip())


def silent(line: str) -> None:
    """Progress of which nobody wants to know."""


def lasting(progress: Progress, line: str) -> None:
    """A line of progress that stays where progress has such."""
    getattr(progress, "line", progress)(line)


def plain(value: Any) -> Any:
    """For JSON: arrays and tuples as lists, a scenario by its fields, a recording by its name."""
    if isinstance(value, Mapping):
        return {name: plain(one) for name, one in value.items()}
    if isinstance(value, np.ndarray | np.generic | tuple | list):
        return [plain(one) for one in value] if np.ndim(value) else value.item()  # type: ignore[union-attr]
    if hasattr(value, "imu"):
        return value.name
    return plain(vars(value)) if is_dataclass(value) else value


def document(one: Study, scenario: Any, result: Result, figures: Iterable[Any] = ()) -> dict[str, Any]:
    """What `--json` prints, of every study alike."""
    return {
        "study": one.name,
        "made_from": one.made_from(scenario),
        "scenario": plain(scenario),
        "good": one.good(result),
        "claims": [asdict(claim) for claim in one.claims(result)] if one.claims else [],
        "result": {name: value for name, value in result.items() if name != "history"},
        "figures": [str(path) for path in figures],
    }


# ---- claims over seeds


def over_seeds(one: Study, scenario: Any, seeds: int, progress: Progress = silent) -> dict[str, Any]:
    """Each claim over so many seeds, from the scenario's on: of how many it holds, and the band of its numbers.

    claims: says, held, and numbers: name -> lowest, median and highest of the seeds; None: never reached.
    """
    assert one.claims is not None
    found = []
    for seed in range(scenario.seed, scenario.seed + seeds):
        progress(f"seed {seed}")
        found.append(one.claims(one.run(replace(scenario, seed=seed), silent)))

    def band(values: Sequence[float | None]) -> list[float | None]:
        known = sorted(np.inf if value is None else value for value in values)
        return [float(v) if np.isfinite(v) else None for v in (known[0], np.median(known), known[-1])]

    return {
        "study": one.name,
        "made_from": one.made_from(scenario),
        "scenario": plain(scenario),
        "seeds": seeds,
        "claims": [
            {
                "says": same[0].says,
                "held": sum(claim.holds for claim in same),
                "numbers": {name: band([claim.numbers[name] for claim in same]) for name in same[0].numbers},
            }
            for same in zip(*found, strict=True)
        ],
    }


def seeds_report(found: dict[str, Any]) -> str:
    """The claims and, below each, the lowest, the median and the highest of its numbers."""
    lines = [f"{found['study']}: claims over {found['seeds']} seeds; of each number lowest, median and highest"]
    for claim in found["claims"]:
        lines += ["", f"holds in {claim['held']} of {found['seeds']}: {claim['says']}"]
        lines += table(("", "lowest", "median", "highest"), [(name, *band) for name, band in claim["numbers"].items()])
    return "\n".join(lines)


# ---- text


def table(head: Sequence[str], rows: Iterable[Any], formats: str | Sequence[str] = ".4g") -> list[str]:
    """The lines of a table: the first column to the left, the others to the right.

    formats: of the numbers, one or one a column.  None is '-', and several numbers stand side by side.
    """
    specs = [formats] * len(head) if isinstance(formats, str) else formats
    text = [[shown(value, spec) for value, spec in zip(row, specs, strict=True)] for row in rows]
    width = [max(len(row[i]) for row in [head, *text]) for i in range(len(head))]
    return [
        "  " + "  ".join(f"{cell:{'>' if i else '<'}{width[i]}}" for i, cell in enumerate(row)).rstrip()
        for row in [list(head), *text]
    ]


def shown(value: Any, spec: str) -> str:
    if value is None:
        return "-"
    if isinstance(value, bool | np.bool_):
        return "yes" if value else "-"
    if isinstance(value, list | tuple | np.ndarray):
        return " ".join(f"{shown(one, spec):>6}" for one in value)
    return value if isinstance(value, str) else format(value, spec)


def claim_lines(claims: Iterable[Claim]) -> list[str]:
    """Of each claim whether it holds, and below it the numbers that decide."""
    lines = []
    for claim in claims:
        numbers = (f"{name} {'never' if v is None else shown(v, '.3g')}" for name, v in claim.numbers.items())
        lines += [f"  {'holds ' if claim.holds else 'NOT SO'}  {claim.says}"]
        lines += wrap("; ".join(numbers), 80, initial_indent=" " * 10, subsequent_indent=" " * 10)
    return lines
