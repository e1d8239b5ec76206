"""The ledger of a paper: the status of each printed equation, computed from finite rotations and exact mechanics.

- exact: both sides agree at finite errors, to 28 digits.
- first-order: they differ by a remainder which falls fourfold when the errors are halved; its size is given.
- definition: nothing to prove, and no other equation of the paper contradicts it.
- erratum: read literally with the paper's own definitions the print is refuted, or has no meaning; with numbers at a
  stated point, `kind` from the comparison of the trees, and `origin`.

What is decided by hand is said with each status, and whether it survives each decision made otherwise: see decisions.
"""

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass
from functools import cache
from itertools import zip_longest
from typing import Any

import mpmath as mp

from boresight import BoresightError
from boresight.derive.dimensions import Mismatch
from boresight.derive.ledger import frames
from boresight.derive.ledger.carried import beside, check_maps, held_beside, model_of, unmatched
from boresight.derive.ledger.decisions import decisions
from boresight.derive.ledger.differences import differences
from boresight.derive.ledger.differences import origin as origin_of
from boresight.derive.ledger.dimensions import UNKNOWN, Terms, grids, inferred
from boresight.derive.ledger.equation import Equation, Relation
from boresight.derive.ledger.evaluate import DIGITS, Point, evaluate, residual
from boresight.derive.ledger.judge import (
    EXACT,
    SEEDS,
    Verdict,
    holds_errors,
    judge,
    judge_with,
    largest_residual,
    meant,
    paper_points,
    shares,
)
from boresight.derive.ledger.latex import latex_relations
from boresight.derive.ledger.lines import count_steps, fallen_definitions, standing, without_steps
from boresight.derive.ledger.mends import Mend, contradicted, definition_mends, may_be_to_blame, mends, rivals, users
from boresight.derive.ledger.numbers import digits, entries, middle, middles
from boresight.derive.ledger.paper import Paper
from boresight.derive.ledger.remarks import leans_on_zero, needless
from boresight.derive.ledger.text import on_one_line
from boresight.derive.units import ONE

# In which a size is said, if not in its own unit.
SAID = {"rad": (10800 / mp.pi, "arcmin"), "rad/s": (3600 * 180 / mp.pi, "deg/h"), "1": (mp.mpf(1), "")}


@dataclass(frozen=True)
class Entry:
    """One line of the ledger; `printed` and `derived` are LaTeX, `kind` and `origin` empty but for an erratum.

    found: in a sentence.  decisions: what was decided by hand; depends: whether the status survives other decisions.
    """

    paper: str
    number: str
    status: str
    kind: str
    origin: str
    printed: str
    derived: str
    note: str
    evidence: str
    found: str
    decisions: str
    depends: str

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
        own = paper.findings()
    lines = ((f"({number})" + f", line {at}," * (at != "0"), why) for number, at, why in frames.found(paper).misfits)
    misfits = (f"The frames of {where} do not fit: {why}." for where, why in lines)
    return (*own, *misfits, *(beside(paper) if paper.folder else ()))


def unheld(paper: Paper) -> tuple[str, ...]:
    """What no check of the ledger holds, a sentence each."""
    equations = [standing(paper, equation) for equation in paper.equations]
    entries = [entry_of(paper, equation) for equation in paper.equations]
    flown = held_beside(paper)[0] if paper.folder else ()
    defined = [e.label for e, entry in zip(paper.equations, entries, strict=True)
               if entry.status == "definition" and e.label not in flown]  # fmt: skip
    bare = [e.label for e in equations if e.label not in (*defined, *flown) and not e.derivation.lines]
    counted = count_steps(equations)
    left_out: dict[str, list[str]] = {}
    for equation in paper.equations:
        if equation.number in paper.witness.left_out:
            left_out.setdefault(paper.witness.left_out[equation.number], []).append(equation.label)
    found = [f"Of {', '.join(labels)} the witness leaves out {what}." for what, labels in left_out.items()]
    if defined:
        found.append(f"Definitions are only held against the equations that use them: {', '.join(defined)}.")
    if bare:
        found.append(f"Without a derivation, judged by the witness alone: {', '.join(bare)}.")
    if counted.prose:
        found.append(f"Of {counted.steps} steps {counted.prose} are prose, which proves nothing.")
    names = [one.symbol.name for one in paper.quantities() if one.symbol.name not in inferred(paper)]
    if unitless := [name for name in names if paper.units.get(name) == UNKNOWN]:
        found.append(f'No unit is known of {", ".join(unitless)}: write unit = "...".')
    if unknown := frames.found(paper).unknown:
        found.append(f"No frame is known of {', '.join(unknown)}: by no name, and by no line.")
    if paper.folder:
        for one in paper.maps:
            if left := unmatched(one):
                found.append(f"What {model_of(one).name} makes beside, no equation is held against: {', '.join(left)}.")
    taken = [f"in {where.replace('.', ', line ')} {text}" for where, text in paper.frames.items() if " for " in text]
    if taken:
        found.append(f"One frame is taken for another, as it stands: {'; '.join(taken)}.")
    return tuple(found)


@cache
def entry_of(paper: Paper, equation: Equation) -> Entry:
    """The line of one equation.  Raises BoresightError where the witness refutes its derived form."""
    with digits(DIGITS):
        return _entry(paper, equation)


def _entry(paper: Paper, equation: Equation) -> Entry:
    equation = standing(paper, equation)
    if paper.folder and not equation.derivation.steps:
        return _underived(paper, equation)
    check_maps(paper, equation.number)
    ours = judge(paper, equation, equation.derived)
    if ours.status == "refuted":
        where = f"{paper.folder or 'derive/papers/' + paper.name.replace('-', '_')}/derivation.toml"
        why = f"{equation.paper} {equation.label}: the derived form itself is refuted, {ours.why}; check {where}"
        if paper.folder:
            return _underived(paper, without_steps(equation, why))
        raise BoresightError(why)
    verdict = judge(paper, equation, equation.read())
    status = "erratum" if verdict.status == "refuted" else verdict.status
    kind = origin = ""
    notes = [equation.note] if equation.note else []
    if status == "erratum":
        slips = differences(equation.read(), equation.derived)
        kinds = {slip.kind for slip in slips}
        kind = kinds.pop() if len(kinds) == 1 else "structure"
        origin, why = origin_of(paper, equation, slips)
        edits = mends(paper, equation) if paper.folder else []
        if paper.folder:
            origin = ""
        else:
            notes.insert(0, f"Origin {origin}: {why}.")
        evidence = f"{verdict.why}; {_side_by_side(paper, equation)}"
        letters = dict.fromkeys(f"{slip.printed} for {slip.derived}" for slip in slips)
        if kind == "letter":
            found = f"It prints {', '.join(letters)}."
        else:
            why = f"{_capital(verdict.why)}."
            found = why if verdict.empty or not equation.note else re.split(r"(?<=\.) ", equation.note)[0]
        found += f" True with one edit: {edits[0].what}." if edits else ""
    else:
        evidence, found = _stands(paper, equation, status)
        found += _remarks(paper, equation, status)
    own = paper.evidence(equation.number)
    evidence += f"; {own}" if own else ""
    return _made(paper, equation, verdict, (status, kind, origin), (found, evidence, " ".join(notes)), equation.derived)


def _stands(paper: Paper, equation: Equation, status: str) -> tuple[str, str]:
    """The evidence for an equation that is no erratum, and what was found in a sentence."""
    evidence, found = _agrees(paper, equation, status)
    if left_out := _neglected(paper, equation):
        return f"{evidence}; {left_out}", f"{found} {_capital(left_out)}."
    return evidence, found


def _remarks(paper: Paper, equation: Equation, status: str) -> str:
    """What is measured beside the status of the print, a sentence each with a blank before it."""
    form = meant(equation, equation.read(), (meaning.senses[0] for meaning in equation.meanings))
    text = ""
    for one in needless(paper, equation, form) if status == "first-order" else ():
        sizes = []
        for relation in (form[one.at], one.without):

            def left(given: Relation, point: Point, at=form[one.at], relation=relation, one=one) -> list:
                found = residual((relation if given is at else given).sides, point)
                return [entry if given is at and k in one.changed else 0 for k, entry in enumerate(found)]

            sizes.append(_at_most(paper, equation, form, left))
        term = on_one_line(one.term, equation.alphabet)
        text += f" The term {term} of second order does not bring it clearly nearer to the truth: what is left is "
        text += f"{sizes[0]} with it, and {sizes[1]} without it."
    if zeros := leans_on_zero(paper, equation, form) if status in ("exact", "first-order") else []:
        what = "it" if len(zeros) == 1 else "them"
        text += f" The witness has {', '.join(zeros)} zero everywhere: what stands before {what} is not held."
    return text


def _agrees(paper: Paper, equation: Equation, status: str) -> tuple[str, str]:
    if status == "definition" and equation.introduces:
        what = ", ".join(symbol.name for symbol in equation.introduces)
        evidence = f"both sides agree to 28 digits because the witness makes {what} so"
        return evidence, f"It gives {what} {'its' if len(equation.introduces) == 1 else 'their'} meaning."
    if status == "definition":
        evidence = "holds in every equation that uses " + ", ".join(symbol.name for symbol in equation.defines)
        return evidence, f"It {evidence}."
    if status == "first-order":
        size = _size(paper, equation)
        evidence = f"remainder falls fourfold when the errors are halved; {size} at {paper.conditions.text}"
        return evidence, f"Its remainder is {size}."
    evidence = f"both sides agree to 28 digits at {paper.witness.words}, {len(SEEDS)} points"
    return evidence, "Both sides agree to 28 digits."


def _made(
    paper: Paper,
    equation: Equation,
    verdict: Verdict,
    status: tuple[str, str, str],
    text: tuple[str, str, str],
    derived: tuple[Relation, ...],
) -> Entry:
    """status: with kind and origin; text: found, evidence, note."""
    by_hand = decisions(paper, equation, verdict)
    fallen = fallen_definitions(paper, equation) if paper.folder else ()
    hangs = (f" {one.label} gives {', '.join(map(str, one.defines))} as it is printed, since its derivation is refused."
             for one in fallen)  # fmt: skip
    return Entry(
        paper=equation.paper,
        number=equation.number,
        status=status[0],
        kind=status[1],
        origin=status[2],
        printed=r" \\ ".join(equation.latex),
        derived=latex_relations(derived, equation.page_letters),
        note=text[2],
        evidence=text[1],
        found=text[0] + "".join(hangs),
        decisions=" ".join(by_hand.taken),
        depends=str(by_hand),
    )


def _underived(paper: Paper, equation: Equation) -> Entry:
    """The line of an equation of which nothing is derived: the witness alone says whether it is true, and what single
    edits of a misprint are.  A definition may be to blame for what fails with it."""
    failing = contradicted(paper, equation)
    if edits := definition_mends(paper, equation):
        return _misprinted(paper, equation, Verdict("refuted", f"with it {_fails(failing)}"), edits, failing)
    if failing and any(definition_mends(paper, other) for other in rivals(paper, equation)):
        failing = ()  # another one is to blame
    verdict = judge(paper, equation, equation.read())
    if verdict.status != "refuted":
        evidence, found = _stands(paper, equation, verdict.status)
        if failing:
            suspects = " or ".join(one.label for one in (equation, *rivals(paper, equation), *failing))
            evidence = f"with it {_fails(failing)}: {suspects} is wrong"
            for one in may_be_to_blame(paper, equation)[:1]:
                evidence += f"; with one edit of this one it would hold: {one.what}"
            found = f"{_capital(evidence)}."
        found += _remarks(paper, equation, verdict.status)
        return _alone(paper, equation, verdict, (evidence, _refused(equation) + found))
    if mended := _with_mended(paper, equation):
        verdict, label = mended
        evidence, found = (f"with {label} as it is mended {text[:1].lower()}{text[1:]}"
                           for text in _stands(paper, equation, verdict.status))  # fmt: skip
        return _alone(paper, equation, verdict, (evidence, _capital(found)))
    return _misprinted(paper, equation, verdict, mends(paper, equation), failing)


def _alone(paper: Paper, equation: Equation, verdict: Verdict, text: tuple[str, str]) -> Entry:
    """Of what is true by the witness alone; text: evidence, found."""
    evidence, found = text
    return _made(paper, equation, verdict, (verdict.status, "", ""), (found, evidence, equation.note), equation.derived)


def _misprinted(
    paper: Paper, equation: Equation, verdict: Verdict, edits: Sequence[Mend], failing: tuple[Equation, ...]
) -> Entry:
    kinds = {slip.kind for slip in differences(equation.read(), edits[0].relations)} if edits else set()
    kind = "unknown" if not edits else kinds.pop() if len(kinds) == 1 else "structure"
    off = "" if edits else _off(paper, equation)
    if blamed := rivals(paper, equation) if not edits and not equation.defines else ():
        off = f" One edit of {' or of '.join(one.label for one in blamed)} would."
    edit = f"True with one edit: {edits[0].what}." if edits else f"No single edit makes it true.{off}"
    found = f"{_refused(equation)}{_capital(verdict.why)}. {edit}"
    evidence = verdict.why if failing else f"{verdict.why}; {_true_and_printed(paper, equation)}"
    text = found, evidence, equation.note
    return _made(paper, equation, verdict, ("erratum", kind, ""), text, edits[0].relations if edits else ())


def _refused(equation: Equation) -> str:
    return f"Its derivation is refused: {equation.refused}. By the witness alone: " if equation.refused else ""


def _capital(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}"


def _fails(equations: tuple[Equation, ...]) -> str:
    return f"{_listed(equations)} {'fails' if len(equations) == 1 else 'fail'}"


def _listed(equations: Iterable[Equation]) -> str:
    return ", ".join(equation.label for equation in equations)


def _with_mended(paper: Paper, equation: Equation) -> tuple[Verdict, str] | None:
    """The verdict with the definitions mended that are to blame for what this one is refuted by, and their labels."""
    blamed = [e for e in paper.equations if e.defines and equation in users(paper, e) and definition_mends(paper, e)]
    changed = tuple((e.number, definition_mends(paper, e)[0].relations) for e in blamed)
    verdict = judge_with(paper, equation, changed) if changed else None
    return (verdict, _listed(blamed)) if verdict and verdict.status != "refuted" else None


MEANT = 0.01  # of what a row says: what is off by less may be meant


def _off(paper: Paper, equation: Equation) -> str:
    """By which part of what it says each row is off, at the paper's own numbers."""
    try:
        parts = shares(paper, equation)
    except (ValueError, KeyError, ZeroDivisionError):
        return ""
    if not parts or max(parts) > 1 or len(parts) > LONG:
        return ""
    rows, it = ("It is", "it") if len(parts) == 1 else ("Its rows are", "them")
    of = f"of what the errors make of {it}" if holds_errors(paper, equation, equation.read()) else "of themselves"
    hint = ' If a term is left out on purpose, name it: neglects = "...".' if max(parts) < MEANT else ""
    return f" {rows} off by {', '.join(mp.nstr(part, 2) for part in parts)} {of}.{hint}"


def _true_and_printed(paper: Paper, equation: Equation) -> str:
    """The sides of a misprint at the stated point, as numbers."""
    point, parts, row = Point(paper.witness.values(paper.point.at, paper.definitions)), [], 0
    for relation in equation.read():
        values = []
        for side in relation.sides:
            try:
                values.append(middles(evaluate(side, point)))
            except (ValueError, KeyError, ZeroDivisionError):
                values.append([])
        count = len(values[0])
        units = dict.fromkeys(units_of(paper, equation, relation.sides[0], count, row)) if count else {}
        row += count
        factor, unit = in_words(*units) if len(units) == 1 else (mp.mpf(1), "")
        for side in values[1:]:
            if not count or len(side) != count:
                parts.append("one side has no value")
            elif (apart := max(abs(a - b) for a, b in zip(values[0], side, strict=True))) > EXACT:
                shown = told_apart(values[0], side)
                both = (f"[{', '.join(mp.nstr(entry * factor, shown) for entry in one)}]" for one in (values[0], side))
                differ = f"the sides differ by {mp.nstr(apart * factor, 3)}"
                numbers = "left {}, right {}, ".format(*both) + differ if count <= LONG else differ
                parts.append(f"{numbers} {unit}".strip())
    return f"at {paper.point.text}: " + "; ".join(parts or ["the sides agree there"])


def _size(paper: Paper, equation: Equation) -> str:
    """The largest remainder of the derived form at the paper's own numbers, for each unit of its rows."""
    form = equation.read() if equation.neglected is not None else equation.derived
    return _at_most(paper, equation, form, lambda relation, point: residual(relation.sides, point))


def _at_most(
    paper: Paper, equation: Equation, form: Iterable[Relation], made: Callable[[Relation, Point], list]
) -> str:
    """The largest of the entries made of each relation at the paper's own numbers, for each unit of its rows."""
    largest: dict[str, mp.mpf] = {}
    for point in paper_points(paper):
        rows = 0
        for relation in form:
            left = made(relation, point)
            own = len(left) // (len(relation.sides) - 1)
            units = units_of(paper, equation, relation.sides[0], own, rows)
            for k, entry in enumerate(left):
                unit = units[k % own]
                largest[unit] = max(largest.get(unit, mp.mpf(0)), abs(middle(entry)))
            rows += own
    sizes = [_with_unit(size, unit) for unit, size in largest.items() if size > EXACT]
    return "at most " + " and ".join(filter(None, (", ".join(sizes[:-1]), sizes[-1]))) if sizes else "nothing"


def _neglected(paper: Paper, equation: Equation) -> str:
    """What the print leaves out on purpose, and how large it is; empty where it leaves out nothing."""
    if equation.neglected is None:
        return ""
    term: Any = equation.neglected
    form = (Relation((equation.printed[0].sides[0], term)),)
    size = _at_most(paper, equation, form, lambda _, point: entries(evaluate(term, point)))
    needless = judge_with(paper, equation, (), equation.printed).status != "refuted"
    return f"it neglects {on_one_line(term, equation.alphabet)}, {size}" + ", and holds without it" * needless


def units_of(paper: Paper, equation: Equation, side: Any, count: int, row: int = 0) -> list[str]:
    """The unit of each of `count` entries of a side that begins in this row of the equation: what the equation states,
    and where it states none, that of the letters."""
    unit = equation.unit
    stated = [unit] * count if isinstance(unit, str) else [*unit[row : row + count], *[""] * count][:count]
    own = [""] * count if all(one not in ("", "1") for one in stated) else letter_units(paper, side, count)
    bare = ("", "1", "rad")  # of a letter, no more than the equation states
    return [b if a == "" or (a == "1" and b not in bare) else a for a, b in zip(stated, own, strict=True)]


def letter_units(paper: Paper, side: Any, count: int = 1) -> list[str]:
    """The units of a side's entries by those of its letters, "1" where they do not fit."""
    try:
        found = [str(entry or ONE) for entry in unit_terms(paper)(side)]
    except (Mismatch, LookupError, ValueError, TypeError):
        found = ["1"]
    return found if len(found) != 1 else found * count


@cache
def unit_terms(paper: Paper) -> Terms:
    """The units of the paper's letters, and those of what is made of them."""
    return Terms(grids(paper, (*paper.quantities(), *paper.letters())))


def in_words(unit: str) -> tuple[mp.mpf, str]:
    """By what a value is multiplied, and the unit in which it is then said."""
    return SAID.get(unit, (mp.mpf(1), unit.replace("*", " ")))


def _with_unit(size, unit: str) -> str:
    factor, name = in_words(unit)
    return f"{mp.nstr(size * factor, 3)} {name or '(no unit)'}"


@dataclass(frozen=True)
class Numbers:
    """A side of a relation where print and derivation differ, entry by entry in `unit`.

    what: the left side, if it is a letter.  true: by the witness.  printed: empty if it has no value, or another shape.
    """

    what: str
    true: tuple[mp.mpf, ...]
    printed: tuple[mp.mpf, ...]
    derived: tuple[mp.mpf, ...]
    unit: str


def numbers_of(paper: Paper, equation: Equation) -> list[Numbers]:
    """The numbers of every side that is misprinted, at the paper's stated point."""
    point, rows, result = Point(paper.witness.values(paper.point.at, paper.definitions)), 0, []

    def values(side, factor: Any = 1) -> tuple[mp.mpf, ...]:
        return tuple(entry * factor for entry in middles(evaluate(side, point)))

    for printed, derived in zip(equation.read(), equation.derived, strict=False):
        true = values(derived.sides[0])
        unit = dict.fromkeys(units_of(paper, equation, derived.sides[0], len(true), rows))
        factor, name = in_words(*unit) if len(unit) == 1 else (mp.mpf(1), "SI, by entry")
        true, rows = tuple(entry * factor for entry in true), rows + len(true)
        what = str(derived.sides[0]) if derived.sides[0].is_Symbol else ""
        last = printed.sides[-1]
        for ours, theirs in dict.fromkeys(zip_longest(derived.sides, printed.sides, fillvalue=last)):
            right = values(ours, factor)
            try:
                wrong = values(theirs, factor)
            except (ValueError, KeyError):
                wrong = ()
            if len(wrong) != len(right):
                result.append(Numbers(what, true, (), right, name))
            elif max(abs(a - b) for a, b in zip(wrong, right, strict=True)) > EXACT:
                result.append(Numbers(what, true, wrong, right, name))
    return result


LONG = 4  # of more numbers only the largest difference is said


def _side_by_side(paper: Paper, equation: Equation) -> str:
    """Printed and derived at the stated point, as numbers."""
    parts = []
    for n in numbers_of(paper, equation):
        what, unit = f"{n.what} " if n.what else "", f" {n.unit}" if n.unit else ""
        if n.printed and len(n.true) > LONG:
            printed, derived = (apart(n.true, form) for form in (n.printed, n.derived))
            parts.append(f"{what}sides differ by {printed} as printed, by {derived} as derived{unit}")
        elif n.printed:
            true, printed, derived = (
                "[" + ", ".join(mp.nstr(value, 5) for value in form) + "]" for form in (n.true, n.printed, n.derived)
            )
            parts.append(f"{what}true {true}, printed {printed}, derived {derived}{unit}")
    if not parts:
        left = largest_residual(equation.derived, Point(paper.witness.values(paper.point.at, paper.definitions)))
        parts.append(f"derived leaves {_digits(left)}")
    return f"at {paper.point.text}: " + "; ".join(parts)


def told_apart(a: Iterable[Any], b: Iterable[Any]) -> int:
    """The digits, five or more, at which an entry of one differs from that of the other."""
    pairs = list(zip(a, b, strict=True))
    return next((n for n in range(5, 16) if any(mp.nstr(x, n) != mp.nstr(y, n) for x, y in pairs)), 5)


def apart(true: tuple[mp.mpf, ...], form: tuple[mp.mpf, ...]) -> str:
    return _digits(max(abs(a - b) for a, b in zip(true, form, strict=True)))


def _digits(size) -> str:
    return mp.nstr(size, 3) if size > EXACT else f"less than {float(EXACT):.0e}"
