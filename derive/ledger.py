"""The ledger of a paper: the status of each printed equation, computed from finite rotations and exact mechanics.

- exact: both sides agree at finite errors, to 28 digits.
- first-order: they differ by a remainder which falls fourfold when the errors are halved; its size is given.
- definition: nothing to prove, and no other equation of the paper contradicts it.
- erratum: read literally with the paper's own definitions the print is refuted, or has no meaning; with numbers at a
  stated point, `kind` from the comparison of the trees, and `origin` by the rule of `_origin`.
"""

import re
from collections.abc import Callable, Iterable
from dataclasses import asdict, dataclass
from functools import cache
from importlib import import_module
from itertools import zip_longest
from types import ModuleType

import mpmath as mp
from sympy import Symbol
from sympy.matrices import MatrixBase

from boresight import BoresightError
from boresight.derive.equation import Equation, Relation, is_explicit, negative
from boresight.derive.latex import latex_relations
from boresight.derive.numbers import Matrix, digits, largest, middle
from boresight.derive.papers import PAPERS
from boresight.derive.witness import DIGITS, Point, evaluate, residual

EXACT = mp.mpf("1e-28")
FOURFOLD = mp.mpf("0.25025")  # a quarter; at errors of 5e-8 rad the next order changes it by far less than 0.1 %
SEEDS = (1, 2, 3)
FULL, SMALL, HALF = 1.0, 1e-6, 5e-7

UNITS = {
    "rad": (10800 / mp.pi, "arcmin"),
    "rad/s": (3600 * 180 / mp.pi, "deg/h"),
    "m/s": (mp.mpf(1), "m/s"),
    "m/s^2": (mp.mpf(1), "m/s^2"),
    "1": (mp.mpf(1), ""),
}
# Letters which a scanner, or a tired eye, takes for one another.
LOOK_ALIKE = ({"φ", "ψ"}, {"ε", "e", "p", "o"})


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


@dataclass(frozen=True)
class Verdict:
    """What the witness says: exact, first-order, definition or refuted; why, in a few words."""

    status: str
    why: str = ""


def paper_module(paper: str) -> ModuleType:
    """The module of a paper by its name.  Raises BoresightError with the right names."""
    if paper not in PAPERS:
        raise BoresightError(f"no paper {paper!r}: the papers are {', '.join(PAPERS)}")
    return import_module(PAPERS[paper])


def equations(paper: str) -> tuple[Equation, ...]:
    """All numbered equations of a paper, in its order."""
    return paper_module(paper).equations()


def ledger(paper: str, progress: Callable[[int, int, str], None] = lambda done, total, text: None) -> list[Entry]:
    """The ledger of a paper, one entry for each numbered equation; `progress` is called after each.

    Raises BoresightError on an unknown name, and when the witness refutes a derived form: then the derivation is wrong.
    """
    entries = []
    for equation in (printed := equations(paper)):
        entries.append(entry_of(equation))
        progress(len(entries), len(printed), f"{paper} ({equation.number})")
    return entries


def findings(paper: str) -> tuple[str, ...]:
    """What was computed about the paper's text and tables, beside its numbered equations."""
    paper_module(paper)
    with digits(DIGITS):
        return import_module(PAPERS[paper] + "_world").findings()


def conditions(paper: str) -> tuple[str, str]:
    """What the sizes of its first-order equations hold for, and the point at which its errata are computed."""
    paper_module(paper)
    world = import_module(PAPERS[paper] + "_world")
    return world.CONDITIONS_TEXT, world.STATED_TEXT


# ---- Status --------------------------------------------------------------------------------------------------------


def judge(equation: Equation, relations: tuple[Relation, ...]) -> Verdict:
    """The verdict on `relations` in the place of the equation's own."""
    if equation.defines:
        return _judge_definition(equation, relations)
    return _judge_at(relations, lambda seed, scale: witness_point(equation.paper, seed, scale, equation.small))


def _judge_at(relations, point, seeds=SEEDS) -> Verdict:
    """exact, first-order or refuted, from the residuals at points of three sizes."""
    order = 0
    for seed in seeds:
        try:
            small, half = (_largest(relations, point(seed, scale)) for scale in (SMALL, HALF))
            if small > EXACT and half > FOURFOLD * small:
                return Verdict("refuted", f"halving the errors leaves {mp.nstr(half / small, 4)} of the difference")
            if small > EXACT or _largest(relations, point(seed, FULL)) > EXACT:
                order = 1
        except (ValueError, KeyError, ZeroDivisionError) as error:
            return Verdict("refuted", f"it has no meaning: {error.args[0] if error.args else error}")
    return Verdict(("exact", "first-order")[order])


def _judge_definition(equation: Equation, relations: tuple[Relation, ...]) -> Verdict:
    """definition, unless another equation of the paper, in its derived form, fails with what this one defines."""

    paper, seed, changed = equation.paper, SEEDS[0], ((equation.number, relations),)
    try:
        given, usual = witness_point(paper, seed, FULL, (), changed), witness_point(paper, seed, FULL)
        moved = {
            name for name, value in usual.values.items() if not callable(value) and _differs(value, given.values[name])
        }
    except (ValueError, KeyError, ZeroDivisionError) as error:
        return Verdict("refuted", f"it does not define {', '.join(map(str, equation.defines))}: {error}")
    users = [e for e in equations(paper) if e.number != equation.number and moved & _names(e.derived)]
    # What held exactly must hold exactly still: one point tells, and most contradictions show here.
    for user in users:
        try:
            contradicted = _largest(user.derived, usual) < EXACT < _largest(user.derived, given)
        except ValueError:
            contradicted = True
        if contradicted:
            return Verdict("refuted", f"contradicted by ({user.number})")
    for user in users:

        def point(seed, scale, small=user.small):
            return witness_point(paper, seed, scale, small, changed)

        if _judge_at(user.derived, point, (seed,)).status == "refuted":
            return Verdict("refuted", f"contradicted by ({user.number})")
    return Verdict("definition")


@cache
def witness_point(paper: str, seed: int, scale: float, small: tuple = (), changed: tuple = ()) -> Point:
    """The witness's values at a random point, the errors `small` times `scale`; `changed`: other definitions."""
    world = import_module(PAPERS[paper] + "_world")
    conditions = world.Conditions().scaled(scale, small)
    return Point(world.world(world.draw(seed, conditions), _definitions(paper) | dict(changed)))


@cache
def _own_definitions(paper: str) -> tuple:
    return tuple((equation.number, equation.read()) for equation in equations(paper) if equation.defines)


def _definitions(paper: str) -> dict:
    return dict(_own_definitions(paper))


def _largest(relations: Iterable[Relation], point: Point) -> mp.mpf:
    return largest(entry for relation in relations for entry in residual(relation.sides, point))


def _differs(a, b) -> bool:
    if a is b:
        return False
    difference = a - b
    return largest(difference if isinstance(difference, Matrix) else [difference]) > EXACT


def _names(relations: Iterable[Relation]) -> set[str]:
    return {
        symbol.name for relation in relations for side in relation.sides for symbol in getattr(side, "free_symbols", ())
    }


# ---- Errata: kind and origin ---------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Difference:
    """One place where print and derivation differ."""

    kind: str
    printed: object
    derived: object


def differences(printed: Iterable[Relation], derived: Iterable[Relation]) -> list[Difference]:
    """The places where two forms differ, found by walking both trees."""
    found: list[Difference] = []
    for a, b in zip_longest(printed, derived):
        if a is None:  # what more the derivation says is no slip of the print
            continue
        if b is None or len(a.sides) != len(b.sides):
            # A shorter chain of equalities is compared side by side as far as it goes.
            found.append(Difference("structure", a, b))
        else:
            for left, right in zip(a.sides, b.sides, strict=True):
                found += _compare(left, right)
    return found


def _compare(a, b) -> list[Difference]:
    if a == b:
        return []
    if isinstance(a, MatrixBase) and isinstance(b, MatrixBase):
        if a.shape != b.shape:
            return [Difference("shape", a, b)]
        return [difference for x, y in zip(a, b, strict=True) for difference in _compare(x, y)]
    if _equal(a, negative(b)):
        return [Difference("sign", a, b)]
    if isinstance(a, Symbol) and isinstance(b, Symbol):
        return [Difference("shape" if _sized(a) and _sized(b) else "letter", a, b)]
    letters = _swapped_letters(a, b)
    if letters:
        return [Difference("letter", x, y) for x, y in letters]
    if getattr(a, "func", a) == getattr(b, "func", b) and a.args and len(a.args) == len(b.args):
        return [difference for x, y in zip(a.args, b.args, strict=True) for difference in _compare(x, y)]
    return [Difference("structure", a, b)]


def _equal(a, b) -> bool:
    plain = not any(is_explicit(side) or side.is_Relational for side in (a, b))
    return a == b or (plain and getattr(a - b, "is_zero", False) is True)


def _sized(letter: Symbol) -> bool:
    """Whether the letter is a block of zeros or ones that says its size, 0_3x18."""
    return re.fullmatch(r"[0I]_\d+x\d+", letter.name) is not None


def _swapped_letters(a, b) -> list[tuple[Symbol, Symbol]]:
    """The letters to be exchanged in a to make it b, if that is all that differs and the entries are scalars."""
    if is_explicit(a) or is_explicit(b) or not (a.is_commutative and b.is_commutative):
        return []
    lost, gained = a.free_symbols - b.free_symbols, b.free_symbols - a.free_symbols
    if len(lost) == len(gained) == 1:
        pair = (*lost, *gained)
        if a.subs(*pair) == b:
            return [pair]
    return []


def _origin(equation: Equation, found: list[Difference]) -> tuple[str, str]:
    """Where the slip is from, and why: `print`, `transcription` or `undecidable`.

    Only letters that look alike, or the small scripts of one letter, can be a scanner's slip.  It is one of copying,
    not of the derivation, if an equation that the text makes from this one, or makes this one from, prints the right
    letter and holds; whose hand copied, the text cannot say.  Where nothing shows the right letter, nobody can tell.
    """
    pairs = sorted({(str(d.printed), str(d.derived)) for d in found if d.kind == "letter"})
    if any(d.kind != "letter" for d in found):
        return "print", "no scanner turns one sign into the other or adds a term"
    if not all(_look_alike(a, b) for a, b in pairs):
        return "print", "the letters do not look alike"
    shown = ", ".join(f"{a} for {b}" for a, b in pairs)
    for other in _connected(equation):
        names = _names(other.printed)
        if all(b in names or f"{b}_b" in names for _, b in pairs) and _sound(other):
            return "transcription", (
                f"{shown}: look-alikes, and ({other.number}), which the text ties to this one by substitution, "
                "prints the right letter and holds; so the derivation was right and a copy of it is not"
            )
    return (
        "undecidable",
        f"{shown}: small scripts or look-alikes, and no equation tied to this one prints the right letter",
    )


def _look_alike(a: str, b: str) -> bool:
    if any({a[0], b[0]} <= group and a[1:] == b[1:] for group in LOOK_ALIKE):
        return True
    stem_a, stem_b = (name.replace("\u0108", "C").split("_")[0] for name in (a, b))
    return "_" in a and "_" in b and stem_a == stem_b


@cache
def _connected(equation: Equation) -> tuple[Equation, ...]:
    """Those made from this one, and from those in turn; and those which this one is made from."""
    by_number = {other.number: other for other in equations(equation.paper)}
    ahead, queue = [], list(equation.leads_to)
    while queue:
        number = queue.pop(0)
        if number not in ahead:
            ahead.append(number)
            queue += by_number[number].leads_to
    behind = [other.number for other in by_number.values() if equation.number in other.leads_to]
    return tuple(by_number[number] for number in (*ahead, *behind))


@cache
def _sound(equation: Equation) -> bool:
    return judge(equation, equation.read()).status != "refuted"


# ---- One entry -----------------------------------------------------------------------------------------------------


@cache
def entry_of(equation: Equation) -> Entry:
    """The line of one equation.  Raises BoresightError where the witness refutes its derived form."""
    with digits(DIGITS):
        return _entry(equation)


def _entry(equation: Equation) -> Entry:
    ours = judge(equation, equation.derived)
    if ours.status == "refuted":
        raise BoresightError(
            f"{equation.paper} ({equation.number}): the derived form itself is refuted, {ours.why}; "
            f"check derive/papers/{equation.paper.replace('-', '_')}.py"
        )
    world = import_module(PAPERS[equation.paper] + "_world")
    verdict = judge(equation, equation.read())
    status = "erratum" if verdict.status == "refuted" else verdict.status
    kind = origin = ""
    notes = [equation.note] if equation.note else []
    notes += [f"{r.printed} is read as {r.meant}: {r.why}." for r in equation.readings]
    if status == "erratum":
        found = differences(equation.read(), equation.derived)
        kinds = {difference.kind for difference in found}
        kind = kinds.pop() if len(kinds) == 1 else "structure"
        origin, why = _origin(equation, found)
        notes.insert(0, f"Origin {origin}: {why}.")
        evidence = f"{verdict.why}; {_side_by_side(equation)}"
    elif status == "definition":
        evidence = "holds in every equation that uses " + ", ".join(symbol.name for symbol in equation.defines)
    elif status == "first-order":
        evidence = "remainder falls fourfold when the errors are halved; " + _size(equation)
    else:
        evidence = (
            f"both sides agree to 28 digits at {getattr(world, 'WITNESS', 'finite rotations')}, {len(SEEDS)} points"
        )
    evidence += world.evidence(equation.number)
    return Entry(
        paper=equation.paper,
        number=equation.number,
        status=status,
        kind=kind,
        origin=origin,
        printed=r" \\ ".join(equation.latex),
        derived=latex_relations(equation.derived, equation.quantities),
        note=" ".join(notes),
        evidence=evidence,
    )


def _size(equation: Equation) -> str:
    """The largest remainder of the derived form at the paper's own numbers."""
    world = import_module(PAPERS[equation.paper] + "_world")
    largest = max(_largest(equation.derived, point) for point in _paper_points(equation.paper))
    factor, unit = UNITS[equation.unit]
    return f"at most {mp.nstr(largest * factor, 3)} {unit}".rstrip() + f" at {world.CONDITIONS_TEXT}"


@cache
def _paper_points(paper: str) -> tuple[Point, ...]:
    world = import_module(PAPERS[paper] + "_world")
    count = getattr(world, "POINTS", 16)
    return tuple(Point(world.world(world.draw(seed, world.CONDITIONS), _definitions(paper))) for seed in range(count))


def _side_by_side(equation: Equation) -> str:
    """Printed and derived at the stated point, as numbers."""
    world = import_module(PAPERS[equation.paper] + "_world")
    point = Point(world.world(world.STATED, _definitions(equation.paper)))
    factor, unit = UNITS[equation.unit]

    def numbers(side) -> str:
        value = evaluate(side, point)
        entries = value if isinstance(value, Matrix) else [value]
        return "[" + ", ".join(mp.nstr(middle(entry) * factor, 5) for entry in entries) + "]"

    text = f"at {world.STATED_TEXT}: "

    def left(relations) -> str:
        size = _largest(relations, point)
        return mp.nstr(size, 3) if size > EXACT else f"less than {float(EXACT):.0e}"

    try:
        _largest(equation.read(), point)
    except (ValueError, KeyError):
        return text + f"derived leaves {left(equation.derived)}"
    if equation.unit == "1":  # matrices: how far the sides are from one another says more than 9 numbers
        return text + f"sides differ by {left(equation.read())} as printed, by {left(equation.derived)} as derived"
    printed, derived = equation.read()[0].sides, equation.derived[0].sides
    return text + f"true {numbers(derived[0])}, printed {numbers(printed[-1])}, derived {numbers(derived[-1])} {unit}"
