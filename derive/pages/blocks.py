"""What a page is made of, before any format: sections of blocks, which plain.py, booklet.py and html.py set."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from boresight.derive.ledger.differences import Place
from boresight.derive.ledger.equation import Quantity, Relation
from boresight.derive.letters import NUMBER


@dataclass(frozen=True)
class Form:
    """A relation, the letters that it is written in, and the places in it that are marked."""

    relation: Relation
    quantities: tuple[Quantity, ...] = ()
    marks: frozenset[Place] = frozenset()


@dataclass(frozen=True)
class Prose:
    """code: names of files or of C, separated by ", "; in other text what stands in backticks is one."""

    text: str
    label: str = ""
    code: bool = False


@dataclass(frozen=True)
class Formulas:
    """verbatim: the same as LaTeX, as its source has it."""

    forms: tuple[Form, ...]
    label: str = ""
    verbatim: tuple[str, ...] = ()


@dataclass(frozen=True)
class Pair:
    """Two labelled lists of formulas to be compared."""

    left: Formulas
    right: Formulas


@dataclass(frozen=True)
class Table:
    """Rows under a head; a cell is text, or letters and expressions.  prose: the column that may wrap.

    typed: the columns whose text is names as one types them.  drawn: those of letters alone, which text leaves out: it
    spells a letter as its name.
    """

    head: tuple[str, ...]
    rows: tuple[tuple[str | tuple[Form, ...], ...], ...]
    prose: int | None = None
    typed: tuple[int, ...] = ()
    drawn: tuple[int, ...] = ()


Block = Prose | Formulas | Pair | Table

# A letter's name within prose: [v x], or one that has an index or is not of ASCII.
NAME = re.compile(r"\[[^\]\s]+ x\]|(?:[^\W\d_]|∂)[\w'\u0300-\u036f]*(?:\([kn][-+\dα]*\)|\^[a-z]\b)?")


TYPED = re.compile(r"`([^`]+)`")
REFERENCE = re.compile(rf"(?<![\w)])\({NUMBER}\)")  # (8)


def is_name(text: str) -> bool:
    return not text.isascii() or "_" in text or "^" in text or text.endswith("x]")


@dataclass(frozen=True)
class Section:
    """anchor: what a link goes to.  status: begins with one of STATUSES, for colours.  source: where it stands."""

    title: str
    blocks: tuple[Block, ...]
    anchor: str = ""
    status: str = ""
    source: str = ""


@dataclass(frozen=True)
class Page:
    """sections: the equations, or what else the page is of.  front, back: what stands before them and after.

    lead: the paragraphs under the title.  anchors: what is written in prose, and the section that it names.
    letters: those whose names stand in the prose.  name: what the titles of its sections begin with.
    """

    title: str
    sections: tuple[Section, ...]
    lead: tuple[str, ...] = ()
    front: tuple[Section, ...] = ()
    back: tuple[Section, ...] = ()
    anchors: Mapping[str, str] = field(default_factory=dict)
    letters: tuple[Quantity, ...] = ()
    name: str = ""
