"""What is decided by hand beside a status, and whether the status survives each decision made otherwise.

The rules are in docs/decisions/0008.  A neighbour is one decision changed; without a meaning of its own it is none.
"""

import re
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from unicodedata import lookup

from sympy.matrices.exceptions import ShapeError

from boresight import BoresightError
from boresight.derive.ledger.equation import Equation, Meaning, Relation
from boresight.derive.ledger.judge import (
    SCALES,
    SEEDS,
    Sense,
    Verdict,
    falls,
    holds_errors,
    judge,
    judge_at,
    meant,
    names,
    witness_point,
)
from boresight.derive.ledger.paper import Paper
from boresight.derive.ledger.reader import plain, read
from boresight.derive.ledger.text import on_one_line, text_relation

NOTHING = "Nothing."


@dataclass(frozen=True)
class Decisions:
    """taken: a sentence for each.  depends: what the status would be, and if what; tried: how many neighbours."""

    taken: tuple[str, ...]
    depends: tuple[str, ...]
    tried: int

    def __str__(self) -> str:
        """Whether the status is robust, in a sentence."""
        if self.depends:
            return f"It depends on a decision: {'; '.join(self.depends)}."
        if not self.taken:
            return NOTHING
        if not self.tried:
            return "Robust: no decision could be made otherwise with a meaning."
        if self.tried == 1:
            return "Robust: the one other decision gives the same status."
        return f"Robust: none of {self.tried} other decisions gives another status."


def decisions(paper: Paper, equation: Equation, verdict: Verdict) -> Decisions:
    """Those which the verdict on the print rests on."""
    needed = _needed(paper, equation) if verdict.status == "first-order" else ()
    found = [(words, other) for words, other in _neighbours(paper, equation, verdict, needed) if not other.empty]
    depends = tuple(f"{other.status}, if {words}" for words, other in found if other.status != verdict.status)
    return Decisions(tuple(_taken(paper, equation, verdict, needed)), depends, len(found))


# ---- Neighbours ------------------------------------------------------------------------------------------------------


def _neighbours(
    paper: Paper, equation: Equation, verdict: Verdict, needed: tuple[str, ...]
) -> Iterator[tuple[str, Verdict]]:
    """Each decision made otherwise, in words, and the verdict on the print with it."""
    print_, own = equation.read(), _small(paper, equation)
    if verdict.status == "first-order" or _falls_too_slowly(paper, equation, verdict):
        for part in _candidates(paper):
            if part not in own:
                yield f"{_word(paper, part)} is small too", _judge_small(paper, equation, (*own, part))
            elif part in needed and part not in paper.witness.errors:
                rest = tuple(other for other in own if other != part)
                yield f"{_word(paper, part)} is not small", _judge_small(paper, equation, rest)
    for reading in equation.readings:
        others = {other.printed: other.meant for other in equation.readings if other is not reading}
        literal = tuple(relation.replaced(others) for relation in equation.printed)
        yield f"{reading.printed} is not read as {reading.meant}", judge(paper, equation, literal)
    for _, letter, rivals in _spelled(paper, equation):
        for rival in rivals:
            with suppress(ShapeError):  # it cannot even be written
                other = tuple(relation.replaced({letter: rival}) for relation in print_)
                yield f"{letter} is {rival}, which is spelled alike", judge(paper, equation, other)
    for i, meaning in enumerate(equation.meanings):
        for sense in meaning.senses[1:]:
            senses = [m.senses[0] for m in equation.meanings]
            senses[i] = sense
            found = judge(paper, equation, print_, senses)
            broken = _broken(paper, equation, sense) if found.status not in ("refuted", verdict.status) else ()
            yield sense[0] + (f" (then {_listed(broken)} would not hold)" if broken else ""), found
    for definition in _misprinted(paper, equation):
        changed = ((definition.number, definition.read()),)
        yield (
            f"{definition.label} is taken as it is printed",
            judge_at(print_, lambda seed, scale, c=changed: witness_point(paper, seed, scale, equation.small, c)),  # type: ignore[misc]
        )


def _falls_too_slowly(paper: Paper, equation: Equation, verdict: Verdict) -> bool:
    """Whether it is refuted because of which errors are small."""
    if verdict.status != "refuted" or verdict.empty or equation.defines:
        return False
    return holds_errors(paper, equation, meant(equation, equation.read(), (m.senses[0] for m in equation.meanings)))


def _small(paper: Paper, equation: Equation) -> tuple[str, ...]:
    return equation.small or paper.witness.errors


def _candidates(paper: Paper) -> tuple[str, ...]:
    """The errors, and whatever an equation of the paper calls small."""
    return tuple(dict.fromkeys((*paper.witness.errors, *paper.small)))


def _judge_small(paper: Paper, equation: Equation, small: Iterable[str]) -> Verdict:
    """The verdict on the print where these parts are small, at one seed."""
    chosen = set(small)
    order = [part for part in _candidates(paper) if part in chosen]
    parts = () if order == list(paper.witness.errors) else tuple(order)
    taken = tuple(meaning.senses[0] for meaning in equation.meanings)
    relations = meant(equation, equation.read(), taken)
    constant = bool(paper.folder)
    return judge_at(relations, lambda seed, scale: witness_point(paper, seed, scale, parts), SEEDS[:1], constant)


def _needed(paper: Paper, equation: Equation) -> tuple[str, ...]:
    """The small parts in which what the equation drops is of second order: held at full size they refute it."""
    own = _small(paper, equation)
    if len(own) == 1:
        return own
    relations = meant(equation, equation.read(), tuple(meaning.senses[0] for meaning in equation.meanings))

    def refutes(part: str) -> bool:
        small = tuple(other for other in own if other != part)
        at = [witness_point(paper, SEEDS[0], scale, small) for scale in SCALES[:2]]
        return any(falls(relation, at, 2).why for relation in relations)

    return tuple(part for part in own if refutes(part))


def _misprinted(paper: Paper, equation: Equation) -> Iterator[Equation]:
    """The definitions which the print uses, and which are errata."""
    used = names(equation.read())
    for definition in paper.defining if not equation.defines else ():
        if used & {symbol.name for symbol in definition.defines} and definition.read() != definition.derived:
            yield definition


def _broken(paper: Paper, equation: Equation, sense: Sense) -> tuple[str, ...]:
    """The other equations whose derived form does not hold with letters in this sense."""
    changed = {name for name, _ in sense[1]}
    found = []
    for other in paper.equations:
        if other.number != equation.number and not other.defines and changed & names(other.derived):
            relations = meant(equation, other.derived, (sense,))

            def point(seed, scale, small=other.small):
                return witness_point(paper, seed, scale, small)

            if judge_at(relations, point, SEEDS[:1]).status == "refuted":
                found.append(other.label)
    return tuple(found)


# ---- In words --------------------------------------------------------------------------------------------------------


def _taken(paper: Paper, equation: Equation, verdict: Verdict, needed: tuple[str, ...]) -> Iterator[str]:
    small = equation.small or paper.witness.errors
    words = _listed(_word(paper, part) for part in small) if equation.small else "all errors"
    if needed and set(needed) == set(small):
        yield f"Small: {words}; what is dropped is of second order in {'them' if len(small) > 1 else 'it'}."
    elif needed:
        dropped = _listed(_word(paper, part) for part in needed)
        yield f"Small: {words}; what is dropped is of second order in {dropped}."
    elif _falls_too_slowly(paper, equation, verdict):
        yield f"Small: {words}."
    for reading in equation.readings:
        yield f"{_written(reading.printed)} is read as {_written(reading.meant)}: {reading.why}."
    for spelling, letter, rivals in _spelled(paper, equation):
        others = " or ".join(map(str, rivals))
        if others:
            yield f"{spelling} is {letter} here, and not {others}, which is spelled alike."
        elif spelling != str(letter):
            yield f"{spelling} is {letter}."
    for convention in equation.conventions:
        yield f"{convention}."
    if equation.neglected is not None:
        yield f"It neglects {on_one_line(equation.neglected, equation.alphabet)}."
    for meaning in equation.meanings:
        yield from _meaning(paper, equation, meaning)
    for definition in _misprinted(paper, equation):
        yield f"{definition.label} is taken as it is corrected."
    if equation.number in paper.witness.left_out:
        yield f"The witness leaves out: {paper.witness.left_out[equation.number]}."


def _written(expression) -> str:
    """As a page has it, not as code."""
    return str(expression) if expression.is_Symbol else text_relation(Relation((expression,)), (), 1000)


def _meaning(paper: Paper, equation: Equation, meaning: Meaning) -> Iterator[str]:
    sense, *others = meaning.senses
    source = f"{meaning.stated_in} says it" if meaning.stated_in else "the paper leaves it open"
    if len(others) > 1:
        yield f"It is taken that {sense[0]} ({source}); {len(others)} other meanings are tried."
    else:
        yield f"It is taken that {sense[0]} ({source}), and not that {others[0][0]}."
    broken = _broken(paper, equation, sense)
    if broken:
        yield f"With that meaning {_listed(broken)} would not hold."


def _word(paper: Paper, part: str) -> str:
    return paper.witness.parts.get(part, part.replace("_", " "))


def _listed(words: Iterable[str]) -> str:
    *first, last = words
    return f"{', '.join(first)} and {last}" if first else last


@cache
def _spelled(paper: Paper, equation: Equation) -> list[tuple[str, object, tuple]]:
    """The spellings of the print which are not those of its letters' own, or are those of others too.

    Each with the letter that is meant, and the letters that are spelled alike.
    """
    if paper.folder:  # where no two letters are spelled alike
        return []
    letters = paper.letters_of(equation.number) if paper.letters_of else paper.quantities()
    own = {quantity.symbol: plain(quantity.latex) for quantity in paper.quantities()}
    used, text = names(equation.printed), "".join(map(plain, equation.latex))
    alike: dict[str, list] = {}
    for quantity in letters:
        if not quantity.function:
            alike.setdefault(plain(quantity.latex), []).append(quantity)
    found = []
    for spelling, (*others, quantity) in alike.items():  # the last one is meant
        rivals = dict.fromkeys(other.symbol for other in others if other.symbol != quantity.symbol)
        usual = own[quantity.symbol] == spelling and not rivals
        if usual or quantity.symbol.name not in used or spelling not in text:
            continue
        try:
            same = _without(read(equation.latex, [q for q in letters if plain(q.latex) != spelling]), equation)
        except BoresightError:
            same = False
        if not same:
            found.append((_text(quantity.latex), quantity.symbol, tuple(rivals)))
    return found


def _without(relations: tuple[Relation, ...], equation: Equation) -> bool:
    return names(relations) == names(equation.printed)


def _text(latex: str) -> str:
    """A letter's LaTeX as a line of text: \\delta t is δt, O_{3 \\times 3} is O_3x3."""

    def greek(found: re.Match) -> str:
        size = "CAPITAL" if found[1][0].isupper() else "SMALL"
        try:
            return lookup(f"GREEK {size} LETTER {found[1].upper()}")
        except KeyError:
            return ""

    return re.sub(r"\\([A-Za-z]+)", greek, latex.replace(r"\times", "x")).translate(str.maketrans("", "", "{} "))
