"""An equation of a paper as a value: how it is printed, how it is read, what is derived, and the steps between.

A relation is a chain of SymPy expressions which are said to be equal.  Scalars and the entries of matrices are ordinary
expressions; an explicit matrix is an ImmutableMatrix in MatMul and MatAdd; a matrix, vector or quaternion known by its
letter alone is a noncommutative Symbol.  Terms keep the order of the page.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from unicodedata import normalize

from sympy import Add, ImmutableMatrix, MatAdd, MatMul, Mul, S, StrictLessThan, Symbol
from sympy.matrices import MatrixBase

from boresight.derive.letters import is_number, number_label


@dataclass(frozen=True)
class Quantity:
    """A letter of a paper: its SymPy symbol, its LaTeX as the paper writes it, and its kind.

    kind: symbols of one kind have the same shape and unit, and could be mistaken for one another.
    shape: () for a scalar, else (rows,) or (rows, columns); a quaternion is (4,).
    function: the letter is written with arguments, C(phi, theta, psi).
    """

    symbol: Symbol
    latex: str
    kind: str
    meaning: str
    shape: tuple[int, ...] = ()
    function: bool = False


def letter(
    name: str, latex: str, kind: str, meaning: str, shape: tuple[int, ...] = (), function: bool = False
) -> Quantity:
    """A quantity by the name of its symbol, composed where Unicode has it so."""
    scalar = shape == ()
    symbol = Symbol(normalize("NFC", name), commutative=scalar, real=True if scalar else None)
    return Quantity(symbol, latex, kind, meaning, shape, function)


@dataclass(frozen=True)
class Relation:
    """sides[0] = sides[1] = ...; two or more.

    layout: of a product of scalars, which SymPy sorts, the factors as the page has them; each group is one fraction.
    """

    sides: tuple
    layout: Mapping = field(default_factory=dict, repr=False, compare=False)

    def replaced(self, mapping: Mapping) -> "Relation":
        """Each symbol of `mapping` replaced by another, the layout kept."""
        layout = {
            replaced(whole, mapping): tuple(tuple(replaced(factor, mapping) for factor in group) for group in groups)
            for whole, groups in self.layout.items()
        }
        return Relation(tuple(replaced(side, mapping) for side in self.sides), layout)


@dataclass(frozen=True)
class Claim:
    """What a line of a derivation states of itself; see ledger/lines.py, which judges it.

    kind: exact, definition, identity, first-order, order, limit or approximation.
    small: the errors, parts of the witness's conditions, in which it is of first order, or whose limit is taken.
    order: the order in the one part of `small` through which the line is right.
    dropped: LaTeX of the term which an approximation leaves out of its right side.
    condition: in words, when that term is small.
    """

    kind: str
    small: tuple[str, ...] = ()
    order: int = 1
    dropped: str = ""
    condition: str = ""


@dataclass(frozen=True)
class Passage:
    """The operation that leads from an earlier line to this one; see ledger/passages.py, which carries it out.

    of: the line it begins from, by its number in the derivation, or an equation of the paper as "(8)" or "(9).2"; the
    line before if empty.  using: the lines and equations that the operation takes in.  with_: LaTeX of a factor, or of
    a letter's rate by the letter's own LaTeX, or numbers of rows; letters: LaTeX of the letters that it is about.
    """

    operation: str
    of: str = ""
    using: tuple[str, ...] = ()
    letters: tuple[str, ...] = ()
    with_: tuple[str, ...] = ()
    order: int = 1


@dataclass(frozen=True)
class Line:
    """One line of a derivation in the paper's letters, with what it claims, or prose if it has no claim.

    latex: as it is written; relation: as it is read.  result: whether it is (a row of) the derived form.
    """

    latex: str
    claim: Claim | None
    why: str
    passage: Passage | None = None
    result: bool = False
    relation: "Relation | None" = None

    @property
    def name(self) -> str:
        """What is done, in a word or two."""
        return self.passage.operation if self.passage else self.claim.kind if self.claim else "note"

    @property
    def formulas(self) -> tuple:
        return () if self.relation is None else (self.relation,)


@dataclass(frozen=True)
class Derivation:
    steps: tuple[Line, ...] = ()

    @property
    def lines(self) -> tuple[Line, ...]:
        """The lines that have a relation."""
        return tuple(step for step in self.steps if step.relation is not None)

    @property
    def equations(self) -> set[str]:
        """The numbers of the equations on which its passages stand, "8" of "(8)" and of "(8).2"."""
        rows = (row for one in self.lines if one.passage for row in (one.passage.of, *one.passage.using))
        return {row[1:].partition(")")[0] for row in rows if row.startswith("(")}

    def before(self, index: int) -> int:
        """The index of the line before step `index`.  Raises ValueError if there is none."""
        return max(i for i in range(index) if self.steps[i].formulas)

    def taken(self, index: int) -> set[int]:
        """The indices of the lines which the passage of step `index` begins from or takes in."""
        step = self.steps[index]
        if step.passage is None:
            return set()
        passage = step.passage
        rows = {int(row) - 1 for row in (passage.of, *passage.using) if row.isdigit()}
        begins = not passage.of and passage.operation != "chain"
        return rows | {self.before(index)} if begins else rows


@dataclass(frozen=True)
class Reading:
    """Which of the things that a printed sign means in the paper is read, and why; docs/decisions/0008."""

    printed: Symbol
    meant: Symbol
    why: str


@dataclass(frozen=True)
class Meaning:
    """What letters are taken for that the paper leaves open, and what else they could be; docs/decisions/0008.

    senses: in words, and by name the LaTeX of what the letters are in terms of others; a letter without LaTeX is what
    the witness has for it.  The first sense is taken: what the text says, at `said`, or if it says nothing the one
    with which the print stands, if there is one.
    """

    senses: tuple[tuple[str, tuple[tuple[str, str], ...]], ...]
    stated_in: str = ""


@dataclass(frozen=True)
class Equation:
    """One numbered equation, or a definition without a number under the letter that it defines.

    latex: each display of the source text, verbatim without its number; lines: where it stands there, counted from 1.
    printed: what `latex` says, symbol by symbol.  readings: what of it must be read otherwise to have a meaning at all.
    derived: what follows from the derivation, in the layout of the print.
    defines: the symbols to which it gives their meaning, if it is a definition that the witness takes as given.
    introduces: those to which it gives their meaning by construction, where the witness makes them by itself.
    meanings: what letters are taken for that the paper leaves open.  conventions: what else is read into the notation.
    leads_to: the equations which, as the text says, are made from this one.
    small: the errors, parts of the witness's conditions, in which it is of first order; all of them if empty.
    unit: of all rows, or of each row of one side of the relations in turn.
    quantities: the letters of the print; step_letters: what more the derivation needs.
    neglected: what the print, of one relation, leaves out of its last side on purpose; it is judged with it.
    refused: why a derivation that was written does not stand; it is left out then.
    """

    paper: str
    number: str
    latex: tuple[str, ...]
    lines: tuple[int, int]
    printed: tuple[Relation, ...]
    derived: tuple[Relation, ...]
    derivation: Derivation
    readings: tuple[Reading, ...] = ()
    defines: tuple[Symbol, ...] = ()
    introduces: tuple[Symbol, ...] = ()
    meanings: tuple[Meaning, ...] = ()
    conventions: tuple[str, ...] = ()
    leads_to: tuple[str, ...] = ()
    note: str = ""
    unit: str | tuple[str, ...] = ""
    small: tuple[str, ...] = ()
    refused: str = ""
    quantities: tuple[Quantity, ...] = field(default=(), repr=False, compare=False)
    step_letters: tuple[Quantity, ...] = field(default=(), repr=False, compare=False)
    neglected: object = None

    @property
    def alphabet(self) -> tuple[Quantity, ...]:
        """The letters in which its derivation is shown; of one letter's spellings the last is written."""
        return (*self.quantities, *self.step_letters)

    @property
    def page_letters(self) -> tuple[Quantity, ...]:
        """The same, spelled as the page spells them: for the print, and what is derived in its place."""
        return (*self.step_letters, *self.quantities)

    @property
    def stated(self) -> Iterator[tuple[str, Claim | None, Relation]]:
        """The derived form, as "0" and of no claim, and each line by its number, with its claim."""
        yield from (("0", None, relation) for relation in self.derived)
        for number, step in enumerate(self.derivation.steps, 1):
            yield from ((str(number), step.claim, relation) for relation in step.formulas)

    @property
    def numbered(self) -> bool:
        return is_number(self.number)

    @property
    def label(self) -> str:
        return number_label(self.number)

    def read(self) -> tuple[Relation, ...]:
        """The print after its readings, and with what it neglects."""
        mapping = {reading.printed: reading.meant for reading in self.readings}
        relations = tuple(relation.replaced(mapping) for relation in self.printed) if mapping else self.printed
        if self.neglected is None:
            return relations
        (relation,) = relations
        return (Relation((*relation.sides[:-1], plus(relation.sides[-1], self.neglected))),)


def matrix(rows) -> ImmutableMatrix:
    return ImmutableMatrix(rows)


def column(*entries) -> ImmutableMatrix:
    return ImmutableMatrix(len(entries), 1, list(entries))


def total(*terms):
    """The sum of the terms in this order: MatAdd if they are explicit matrices, Add if letters or scalars."""
    if len(terms) == 1:
        return terms[0]
    if not any(is_explicit(term) for term in terms):
        return Add(*terms, evaluate=False)
    if any(not is_explicit(term) and not term.is_commutative for term in terms):
        return as_written(Add, terms)  # the letter of a matrix beside an explicit one
    # A scalar beside a 1x1 matrix, as in Song-Lee (26), is a 1x1 matrix itself.
    return MatAdd(*(term if is_explicit(term) else _one_by_one(term) for term in terms))


def plus(side, term):
    """The side with one more term."""
    return total(*(side.args if isinstance(side, Add | MatAdd) else (side,)), term)


def _one_by_one(scalar):
    if scalar.could_extract_minus_sign():
        return MatMul(S.NegativeOne, matrix([[-scalar]]))
    return matrix([[scalar]])


def product(*factors):
    """The product of the factors in this order: MatMul if one is an explicit matrix."""
    factors = tuple(part for factor in factors for part in _parts(factor))
    if len(factors) == 1:
        return factors[0]
    if any(is_explicit(factor) for factor in factors):
        if any(not is_explicit(factor) and not factor.is_commutative for factor in factors):
            return as_written(Mul, factors)  # the letter of a matrix beside an explicit one
        return MatMul(*factors)
    if all(factor.is_commutative for factor in factors):
        return Mul(*factors)
    return Mul(*factors, evaluate=False)


def as_written(kind, arguments):
    """A sum or product which SymPy must not touch: even with evaluate=False it would multiply explicit matrices."""
    return kind._from_args(tuple(arguments))


def _parts(factor) -> tuple:
    """A product of letters within a product is one with it."""
    return factor.args if isinstance(factor, Mul) and not factor.is_commutative else (factor,)


def negative(term):
    """-term, the layout kept."""
    if isinstance(term, Mul | MatMul):
        if term.args[0] == S.NegativeOne:
            return product(*term.args[1:])
        return product(S.NegativeOne, *term.args) if not term.is_commutative else -term
    if isinstance(term, StrictLessThan):
        return StrictLessThan(negative(term.lhs), term.rhs, evaluate=False)
    return product(S.NegativeOne, term)


def is_explicit(expression) -> bool:
    """Whether the expression is built on an explicit matrix."""
    return isinstance(expression, MatrixBase | MatMul | MatAdd)


def terms(relation: Relation) -> Iterator[tuple[str, object]]:
    """The terms of a chain in order, each with what stands before it: =, +, - or, at the start, nothing."""
    for i, side in enumerate(relation.sides):
        terms = side.args if isinstance(side, MatAdd) else (side,)
        for j, term in enumerate(terms):
            minus = isinstance(side, MatAdd) and term.args and term.args[0] == S.NegativeOne
            if j == 0:
                yield ("=" if i else ""), term
            else:
                yield ("-" if minus else "+"), (negative(term) if minus else term)


def rebuild(expression, arguments):
    """The node with other arguments, evaluated no further than the page is."""
    if isinstance(expression, MatrixBase):
        return ImmutableMatrix(*expression.shape, list(arguments))
    if isinstance(expression, Add | MatAdd):
        return total(*arguments)
    if isinstance(expression, Mul | MatMul):
        return product(*arguments)
    if isinstance(expression, StrictLessThan):
        return StrictLessThan(*arguments, evaluate=False)
    return expression.func(*arguments)


def children(expression) -> tuple:
    """The arguments of a node; of an explicit matrix its entries, row by row."""
    return tuple(expression) if isinstance(expression, MatrixBase) else expression.args


def replaced(expression, mapping: Mapping):
    """`expression` with each symbol of `mapping` replaced at the same time, the layout kept."""
    if expression in mapping:
        return mapping[expression]
    arguments = children(expression)
    if not arguments:
        return expression
    return rebuild(expression, [replaced(argument, mapping) for argument in arguments])
