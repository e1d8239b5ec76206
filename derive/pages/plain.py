"""A page for the terminal: text in at most 100 columns."""

import re
from collections.abc import Iterable
from itertools import zip_longest
from textwrap import indent, wrap
from typing import Any
from unicodedata import combining

from boresight.derive.ledger.text import FIRST, cells, columns, text_relation
from boresight.derive.pages.blocks import TYPED, Block, Form, Formulas, Page, Pair, Prose, Section, Table

INDENT = 4  # of a formula
MARKS = "".join(filter(combining, map(chr, range(0x300, 0x370))))


def text_page(page: Page) -> str:
    """One section stands alone; of several the title and the paragraphs under it stand before them."""
    several = len(page.sections) > 1 or not page.sections[0].title
    title = fill(page.title, columns())
    rule = "=" * max(map(len, title.split("\n")))
    head = [f"{title}\n{rule}", *(fill(text, columns()) for text in page.lead)] if several else []
    return "\n\n".join([*head, *map(_section, (*page.front, *page.sections, *page.back))]) + "\n"


def fill(text: str, width: int, **more: Any) -> str:
    return "\n".join(wrapped(text, width, **more))


def wrapped(text: str, width: int, **more: Any) -> list[str]:
    """Lines as textwrap makes them, where a letter and the marks above it are one character."""
    letters: list[str] = []

    def sign(found: re.Match) -> str:
        letters.append(found[0])
        return chr(FIRST + len(letters) - 1)

    lines = wrap(re.sub(f"[^{MARKS}][{MARKS}]+", sign, text), width, **more)
    return [line.translate({FIRST + n: letter for n, letter in enumerate(letters)}) for line in lines]


def _section(section: Section) -> str:
    source = f"[{section.source}]" * bool(section.source)
    title = "  ".join(part for part in (section.title, section.status, source) if part)
    head = [title, "-" * len(title)] if title else []
    return "\n".join([*head, *(_block(block) for block in section.blocks)])


def _block(block: Block) -> str:
    if isinstance(block, Prose):
        return _prose(block)
    if isinstance(block, Formulas):
        return "\n".join([block.label] * bool(block.label) + [_form(form) for form in block.forms])
    if isinstance(block, Pair):
        left, right = map(_block, (block.left, block.right))
        return f"{left}\n{right}"
    return _table(block)


def _prose(block: Prose) -> str:
    label = block.label and (block.label if block.label[-1] in ".]" else f"{block.label}:") + " "
    hang = 2 + (label[:1].isdigit() or label[:1] == "[")
    text = label + TYPED.sub(r"\1", block.text)
    return fill(text, columns(), subsequent_indent=" " * hang, break_long_words=False, break_on_hyphens=False)


def _form(form: Form) -> str:
    return indent(text_relation(form.relation, form.quantities, columns() - INDENT, form.marks), " " * INDENT)


def _table(block: Table) -> str:
    """Columns as wide as their longest cell, but for the one of prose, which wraps where the line would be too long."""
    places = [i for i in range(len(block.head)) if i not in block.drawn]
    rows = [[_cell(row[i]) for i in places] for row in (block.head, *block.rows)]
    widths = [max(1, *map(cells, column)) for column in zip(*rows, strict=True)]
    if block.prose is not None:
        prose = places.index(block.prose)
        others = sum(widths) - widths[prose] + 2 * (len(widths) - 1)
        widths[prose] = max(20, min(widths[prose], columns() - INDENT - others))
    lines = [line for row in rows for line in _wrapped(row, widths)]
    return indent("\n".join(lines), " " * INDENT)


def _wrapped(row: Iterable[str], widths: list[int]) -> list[str]:
    parts = [wrapped(cell, width) or [""] for cell, width in zip(row, widths, strict=True)]
    lines = zip_longest(*parts, fillvalue="")
    return [
        "  ".join(part + " " * (w - cells(part)) for part, w in zip(line, widths, strict=True)).rstrip()
        for line in lines
    ]


def _cell(cell: str | tuple[Form, ...]) -> str:
    return cell if isinstance(cell, str) else ", ".join(text_relation(f.relation, f.quantities, 100) for f in cell)
