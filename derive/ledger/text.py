"""Relations as text for the terminal: nothing is stacked but the rows of a matrix."""

import re
import shutil
from collections.abc import Collection, Iterable
from unicodedata import combining, normalize

from boresight import BoresightError
from boresight.derive.ledger.equation import Quantity, Relation
from boresight.derive.ledger.formula import ATOM, ELEMENTARY, FRACTION, PREFIX, Piece, Place, Writer
from boresight.derive.ledger.latex import greek

FIRST = 0xE000  # a matrix is one character of the private area until the lines are laid out


def columns() -> int:
    """Columns of the terminal, or of COLUMNS, 100 at most; 80 in a pipe."""
    return min(100, shutil.get_terminal_size((80, 24)).columns)


def text_relation(
    relation: Relation, quantities: Iterable[Quantity], width: int | None = None, marks: Collection[Place] = ()
) -> str:
    """Text of one relation, broken before a sign where a line would be wider than `width`.

    marks: places that stand between › and ‹.
    """
    writer = _Text(quantities, marks)
    pieces = writer.pieces(relation)
    return writer.laid_out(pieces, columns() if width is None else width)


def on_one_line(term: object, quantities: Iterable[Quantity]) -> str:
    """Text of a term within a sentence; of a matrix, how many rows it has."""
    text = text_relation(Relation((term,)), quantities, 1000)
    return f"a term of {len(text.splitlines())} rows" if "\n" in text else text


class _Text(Writer):
    TIMES = "⋅"
    OPEN_MARK, CLOSE_MARK = "›", "‹"
    NORM, CURLY = ("‖", "‖"), ("{", "}")
    AT_MOST, CROSS, TRANSPOSED, VECTOR = "≤", "×", "T", "∨"

    def __init__(self, quantities, marks):
        super().__init__(quantities, marks)
        self.grids: list[list[str]] = []

    def letter(self, name):
        """Names are as a reader wants them: C_b2n, not C with scripts that no font has."""
        if "/" in name:
            return name, FRACTION
        name = re.sub(r"_(\w+[-+,]\w+)$", r"_{\1}", name)  # Φ_{k-1} is not Φ_k - 1
        base = re.split(r"[_(\[]", normalize("NFC", name))[0]
        # δφ^2 could be δ(φ^2): a power of a letter of several glyphs needs brackets.
        return re.sub(r" x\]$", " ×]", name), ATOM if len(base) < 2 or base.isascii() else PREFIX

    def head(self, name):
        return name

    def fraction(self, above, below):
        over = self.TIMES.join(self.hold(piece, PREFIX) for piece in above) or "1"
        under = [self.hold(piece, PREFIX) for piece in below]
        return over + "/" + (under[0] if len(under) == 1 else self.bracketed(self.TIMES.join(under))), FRACTION

    def factor(self, piece: Piece, index: int, last: bool) -> str:
        if piece[0].startswith("Σ") and not last:
            return self.bracketed(piece[0])
        return self.hold(piece, FRACTION if index == 0 else PREFIX)

    def root(self, text):
        return "√" + self.bracketed(text)

    def raised(self, base, exponent):
        return f"{base}^{exponent if re.fullmatch(r'›?(-?[0-9]+|T|∨)‹?', exponent) else self.bracketed(exponent)}"

    def applied(self, name, argument, exponent):
        text = ELEMENTARY[name] + self.bracketed(argument[0])
        return (self.raised(text, exponent), PREFIX) if exponent else (text, ATOM)

    def summed(self, name, argument):
        index = re.sub(r"\s|\\sum_|[{}]", "", self.letters[name + "("])
        for word in re.findall(r"\\[A-Za-z]+", index):
            index = index.replace(word, "∈" if word == r"\in" else greek(word[1:]))
        return f"Σ_{{{index}}} {argument}", PREFIX

    def entry(self, base, row, column):
        base = self.bracketed(base) if "_" in base and base[0] != "(" else base
        return f"{base}_{{{row},{column}}}", ATOM

    # ---- matrices and lines ----------------------------------------------------------------------------------------

    def grid(self, rows):
        rows = [[self._flat(cell) for cell in row] for row in rows]
        widths = [max(map(cells, column)) for column in zip(*rows, strict=True)]
        lines = ["  ".join(cell + " " * (w - cells(cell)) for cell, w in zip(row, widths, strict=True)) for row in rows]
        if len(lines) == 1:
            return f"[{lines[0]}]"
        edges = ["⎡⎤", *["⎢⎥"] * (len(lines) - 2), "⎣⎦"]
        self.grids.append([f"{left}{line}{right}" for (left, right), line in zip(edges, lines, strict=True)])
        return chr(FIRST + len(self.grids) - 1)

    def _flat(self, cell: str) -> str:
        if any(FIRST <= ord(character) < FIRST + len(self.grids) for character in cell):
            raise BoresightError("a matrix within a matrix cannot be written as text: name it")
        return cell

    def _extent(self, line: str) -> int:
        return sum(cells(self.grids[ord(c) - FIRST][0]) if ord(c) >= FIRST else cells(c) for c in line)

    def laid_out(self, pieces: list[tuple[str, str]], width: int) -> str:
        lines = [""]
        for sign, text in pieces:
            piece = f"{sign} {text}" if sign else text
            joined = f"{lines[-1]} {piece}".strip()
            if lines[-1] and self._extent(joined) > width >= self._extent(piece):
                lines.append(piece)
            else:
                lines[-1] = joined
            while self._extent(lines[-1]) > width and (at := self._break(lines[-1], width)):
                lines[-1:] = [lines[-1][:at].rstrip(), lines[-1][at:]]
        return "\n".join(row.rstrip() for line in lines for row in self._rows(line))

    def _break(self, line: str, width: int) -> int:
        """Where to break a wide term: before a sign, in the later half, outside of brackets; 0 if nowhere.

        Behind a matrix that is itself too wide, at the first sign.
        """
        depth, places = 0, [(4, 0, 0)]
        for at, character in enumerate(line):
            depth += (character in "([{") - (character in ")]}")
            if at and re.match(r"⋅|[-+<=] ", line[at:]):
                extent = self._extent(line[:at])
                places.append((3, at, at) if extent > width else (int(2 * extent < width), depth, -at))
        return abs(min(places)[2])

    def _rows(self, line: str) -> list[str]:
        """The lines of text of one line of formulas; what is not a matrix stands in the middle row."""
        grids = [self.grids[ord(c) - FIRST] for c in line if ord(c) >= FIRST]
        height = max((len(grid) for grid in grids), default=1)
        middle, rows = (height - 1) // 2, [""] * height
        for c in line:
            block = self.grids[ord(c) - FIRST] if ord(c) >= FIRST else [c]
            top = middle - (len(block) - 1) // 2
            empty = " " * cells(block[0])
            rows = [row + (block[i - top] if 0 <= i - top < len(block) else empty) for i, row in enumerate(rows)]
        return rows


def cells(text: str) -> int:
    return sum(not combining(c) for c in text)
