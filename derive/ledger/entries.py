"""The ledger of a paper: the status of each printed equation, computed from finite rotations and exact mechanics.

- exact: both sides agree at finite errors, to 28 digits.
- first-order: they differ by a remainder which falls fourfold when the errors are halved; its size is given.
- definition: nothing to prove, and no other equation of the paper contradicts it.
- erratum: read literally with the paper's own definitions the print is refuted, or has no meaning; with numbers at a
  stated point, `kind` from the comparison of the trees, and `origin` by the rule of `_origin`.
"""

from collections.abc import Callable
from dataclasses import asdict, dataclass
from functools import cache

import mpmath as mp

from boresight import BoresightError
from boresight.derive.ledger.carried import check_maps
from boresight.derive.ledger.differences import differences
from boresight.derive.ledger.differences import origin as origin_of
from boresight.derive.ledger.equation import Equation
from boresight.derive.ledger.evaluate import DIGITS, Point, evaluate
from boresight.derive.ledger.judge import EXACT, SEEDS, judge, largest_residual
from boresight.derive.ledger.lines import check_derivation
from boresight.derive.ledger.numbers import Matrix, digits, middle
from boresight.derive.ledger.paper import Paper
from boresight.derive.ledger.witness import draw
from boresight.derive.pages.latex import latex_relations

UNITS = {
    "rad": (10800 / mp.pi, "arcmin"),
    "rad/s": (3600 * 180 / mp.pi, "deg/h"),
    "m/s": (mp.mpf(1), "m/s"),
    "m/s^2": (mp.mpf(1), "m/s^2"),
    "1": (mp.mpf(1), ""),
}


@dataclass(frozen=True)
class Entry:
    """One line of the ledger; `printed` and `derived` are LaTeX, `kind` and `origin` empty but for an erratum."""

    paper: str
    number: str
    status: str
    kind: str
    origin: str
    printed: str
    derived: str
    note: str
    evidence: str

    def to_dict(self) -> dict[str, str]:
        return asdict(self)


def ledger(paper: Paper, progress: Callable[[int, int, str], None] = lambda done, total, text: None) -> list[Entry]:
    """The ledger of a paper, one entry for each numbered equation; `progress` is called after each.

    Raises BoresightError when the witness refutes a derived form: then the derivation is wrong.
    """
    entries = []
    for equation in paper.equations:
        entries.append(entry_of(paper, equation))
        progress(len(entries), len(paper.equations), f"{paper.name} ({equation.number})")
    return entries


def findings(paper: Paper) -> tuple[str, ...]:
    """What was computed about the paper's text and tables, beside its numbered equations."""
    with digits(DIGITS):
        return paper.findings()


@cache
def entry_of(paper: Paper, equation: Equation) -> Entry:
    """The line of one equation.  Raises BoresightError where the witness refutes its derived form."""
    with digits(DIGITS):
        return _entry(paper, equation)


def _entry(paper: Paper, equation: Equation) -> Entry:
    check_derivation(paper, equation)
    check_maps(paper, equation.number)
    ours = judge(paper, equation, equation.derived)
    if ours.status == "refuted":
        raise BoresightError(
            f"{equation.paper} ({equation.number}): the derived form itself is refuted, {ours.why}; "
            f"check derive/papers/{paper.name.replace('-', '_')}/derived.py"
        )
    verdict = judge(paper, equation, equation.read())
    status = "erratum" if verdict.status == "refuted" else verdict.status
    kind = origin = ""
    notes = [equation.note] if equation.note else []
    notes += [f"{r.printed} is read as {r.meant}: {r.why}." for r in equation.readings]
    if status == "erratum":
        found = differences(equation.read(), equation.derived)
        kinds = {difference.kind for difference in found}
        kind = kinds.pop() if len(kinds) == 1 else "structure"
        origin, why = origin_of(paper, equation, found)
        notes.insert(0, f"Origin {origin}: {why}.")
        evidence = f"{verdict.why}; {_side_by_side(paper, equation)}"
    elif status == "definition":
        evidence = "holds in every equation that uses " + ", ".join(symbol.name for symbol in equation.defines)
    elif status == "first-order":
        evidence = "remainder falls fourfold when the errors are halved; " + _size(paper, equation)
    else:
        evidence = f"both sides agree to 28 digits at {paper.witness.words}, {len(SEEDS)} points"
    evidence += paper.evidence(equation.number)
    return Entry(
        paper=equation.paper,
        number=equation.number,
        status=status,
        kind=kind,
        origin=origin,
        printed=r" \\ ".join(equation.latex),
        derived=latex_relations(equation.derived, equation.alphabet),
        note=" ".join(notes),
        evidence=evidence,
    )


def _size(paper: Paper, equation: Equation) -> str:
    """The largest remainder of the derived form at the paper's own numbers."""
    largest = max(largest_residual(equation.derived, point) for point in paper_points(paper))
    factor, unit = UNITS[equation.unit]
    return f"at most {mp.nstr(largest * factor, 3)} {unit}".rstrip() + f" at {paper.conditions.text}"


@cache
def paper_points(paper: Paper) -> tuple[Point, ...]:
    witness, conditions = paper.witness, paper.conditions
    bases = (draw(witness.base, seed, conditions.at) for seed in range(conditions.count))
    return tuple(Point(witness.values(base, paper.definitions)) for base in bases)


def _side_by_side(paper: Paper, equation: Equation) -> str:
    """Printed and derived at the stated point, as numbers."""
    point = Point(paper.witness.values(paper.point.at, paper.definitions))
    factor, unit = UNITS[equation.unit]

    def numbers(side) -> str:
        value = evaluate(side, point)
        entries = value if isinstance(value, Matrix) else [value]
        return "[" + ", ".join(mp.nstr(middle(entry) * factor, 5) for entry in entries) + "]"

    text = f"at {paper.point.text}: "

    def left(relations) -> str:
        size = largest_residual(relations, point)
        return mp.nstr(size, 3) if size > EXACT else f"less than {float(EXACT):.0e}"

    try:
        largest_residual(equation.read(), point)
    except (ValueError, KeyError):
        return text + f"derived leaves {left(equation.derived)}"
    if equation.unit == "1":  # matrices: how far the sides are from one another says more than 9 numbers
        return text + f"sides differ by {left(equation.read())} as printed, by {left(equation.derived)} as derived"
    printed, derived = equation.read()[0].sides, equation.derived[0].sides
    return text + f"true {numbers(derived[0])}, printed {numbers(printed[-1])}, derived {numbers(derived[-1])} {unit}"
