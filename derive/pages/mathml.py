"""MathML of relations: their LaTeX, piece by piece, with products and applications of functions made explicit."""

import re
import unicodedata
from collections.abc import Collection, Iterable
from html import escape

from boresight import BoresightError
from boresight.derive.ledger.equation import Quantity, Relation
from boresight.derive.ledger.formula import ELEMENTARY, Place
from boresight.derive.ledger.latex import LETTERS as NAMED_LETTERS
from boresight.derive.ledger.latex import MARKS, SIGNS, greek, latex_relation
from boresight.derive.ledger.tokens import tokens

APPLY, TIMES = "<mo>&#x2061;</mo>", "<mo>&#x2062;</mo>"
ACCENTS = {"hat": "^", "dot": "˙", "ddot": "¨", "bar": "¯", "overline": "¯", "check": "ˇ", "tilde": "~", "vec": "→"}
OPERATORS = {
    r"\times": "×", r"\leq": "≤", r"\in": "∈", r"\vee": "∨", r"\|": "‖", r"\{": "{", r"\}": "}", "-": "−", "'": "′",
    r"\langle": "⟨", r"\rangle": "⟩", **{latex: sign for sign, latex in SIGNS.items()},
}  # fmt: skip
LETTERS = {latex: letter for letter, latex in NAMED_LETTERS.items()} | {r"\varepsilon": "ε"}
BOLD = (r"\mathbf", r"\boldsymbol", r"\bm", r"\pmb", r"\vec")
UPRIGHT = (r"\mathrm", r"\mathit", r"\mathsf", r"\text", r"\operatorname")
NAMED = {"\\" + word for word in ELEMENTARY.values()}
assert set(MARKS.values()) <= set(ACCENTS)


def mathml_relation(relation: Relation, quantities: Iterable[Quantity], marks: Collection[Place] = ()) -> str:
    """One <math> element.  marks: places that stand in <mrow class="slip">."""
    return mathml(latex_relation(relation, quantities, marks))


def mathml(latex: str) -> str:
    """One <math> element from LaTeX as ledger.latex writes it."""
    inside = _Translator(latex).row()
    return f'<math xmlns="http://www.w3.org/1998/Math/MathML" display="block">{_grouped(inside)}</math>'


def _grouped(items: list[str]) -> str:
    return items[0] if len(items) == 1 else f"<mrow>{''.join(items)}</mrow>"


def _operator(text: str, more: str = "") -> str:
    return f"<mo{more}>{escape(text)}</mo>"


def bold(character: str) -> str:
    """The bold letter of Unicode: browsers make no other bold in a formula."""
    kind = "DIGIT" if character.isdigit() else "CAPITAL" if character.isupper() else "SMALL"
    try:
        return unicodedata.lookup(f"MATHEMATICAL BOLD {kind} {unicodedata.name(character).split()[-1]}")
    except (KeyError, ValueError):
        return character


class _Translator:
    def __init__(self, latex: str):
        self.tokens = [*tokens(latex), ""]
        self.at = 0

    def ahead(self) -> str:
        return self.tokens[self.at]

    def take(self) -> str:
        self.at += 1
        return self.tokens[self.at - 1]

    def group(self) -> str:
        """What stands in braces, or one token."""
        if self.ahead() != "{":
            return _grouped(self.item(self.take()))
        self.take()
        return _grouped(self.row("}"))

    def plain(self) -> str:
        """The characters in braces."""
        self.take()
        return "".join(iter(self.take, "}"))

    def row(self, *ends: str) -> list[str]:
        """The items up to one of `ends`, which is taken too, or to the end."""
        items: list[str] = []
        run = 0  # where the glyphs begin that are one letter
        applies = False  # whether a bracket that comes now holds arguments
        while (token := self.take()) not in (*ends, ""):
            if token in ("_", "^"):
                base = _grouped(items[run:])
                items[run:] = [self.scripts(token, base)]
                run = len(items)
                continue
            bracket = token == "(" or (token == r"\left" and self.ahead() in "([")
            if bracket and applies:
                items.append(APPLY)
            glyph = self.is_glyph(token)
            if not glyph or run == len(items) or not applies:
                run = len(items)
            items += self.item(token)
            if token == r"\slip" and run and not items[run - 1].startswith("<mo"):
                items[run] = items[run].replace("<mo>−</mo>", '<mo form="infix">−</mo>', 1)
            applies = glyph
            if token in NAMED:
                run = len(items) - 1
                if self.ahead() == "^":
                    items[run:] = [self.scripts(self.take(), items[run])]
                items.append(APPLY)
                run = len(items)
        return items

    def is_glyph(self, token: str) -> bool:
        word = token[1:]
        return token.isalpha() or token in (*UPRIGHT, *BOLD, *LETTERS) or word in ACCENTS or bool(greek(word))

    def scripts(self, first: str, base: str) -> str:
        found = {first: self.group()}
        if self.ahead() in "_^" and self.ahead() not in ("", first):
            second = self.take()
            found[second] = self.group()
        if base == _operator("∑"):
            return f"<munder>{base}{found['_']}</munder>"
        name = {"_": "msub", "^": "msup"}[first] if len(found) == 1 else "msubsup"
        return f"<{name}>{base}{found.get('_', '')}{found.get('^', '')}</{name}>"

    def item(self, token: str) -> list[str]:
        word = token[1:]
        if token == r"\,":
            return [TIMES]
        if token.isdigit():
            return [f"<mn>{token}</mn>"]
        if token.isalpha():
            return [f"<mi>{token}</mi>"]
        if token == "{":
            return self.row("}")
        if token == r"\slip":
            self.take()
            return [f'<mrow class="slip">{"".join(self.row("}"))}</mrow>']
        if token == r"\frac":
            return [f"<mfrac>{self.group()}{self.group()}</mfrac>"]
        if token == r"\sqrt":
            return [f"<msqrt>{self.group()}</msqrt>"]
        if token in BOLD:
            return [re.sub("(<m[in]>)(.)(</m[in]>)", lambda found: found[1] + bold(found[2]) + found[3], self.group())]
        if token in UPRIGHT:
            return [f'<mi mathvariant="normal">{self.plain()}</mi>']
        if token == r"\left":
            left, inside, right = self.take(), self.row(r"\right"), self.take()
            fences = (_operator(OPERATORS.get(fence, fence)) for fence in (left, right))
            return [f"<mrow>{next(fences)}{''.join(inside)}{next(fences)}</mrow>"]
        if token == r"\begin":
            self.plain()
            return [f"<mrow>{_operator('[')}<mtable>{''.join(self.rows())}</mtable>{_operator(']')}</mrow>"]
        if token == r"\sum":
            return [_operator("∑")]
        if token == r"\Big":
            return [_operator(self.take())]
        if token in NAMED:
            return [f"<mi>{word}</mi>"]
        if word in ACCENTS:
            return [f'<mover accent="true">{self.group()}{_operator(ACCENTS[word])}</mover>']
        if letter := greek(word):
            return [f"<mi>{letter}</mi>"]
        if token in LETTERS:
            return [f"<mi>{LETTERS[token]}</mi>"]
        if token == r"\times" and self.ahead() == "]":
            return [_operator("×", ' lspace="0" rspace="0"')]
        if token in OPERATORS or token in "+=<>()[],;|/.":
            return [_operator(OPERATORS.get(token, token), ' stretchy="false"' if token in "()[]" else "")]
        raise BoresightError(f"no MathML for {token} in {''.join(self.tokens)!r}")

    def rows(self) -> Iterable[str]:
        row: list[str] = []
        while True:
            cell = self.row("&", r"\\", r"\end")
            row.append(f"<mtd>{''.join(cell)}</mtd>")
            if (end := self.tokens[self.at - 1]) != "&":
                yield f"<mtr>{''.join(row)}</mtr>"
                row = []
            if end == r"\end":
                self.plain()
                return
