"""Formulas as tokens: LaTeX, MathML as an HTML parser has it, and text; and how a letter is spelled in each.

A row is a tuple of tokens, each its kind and what it is; fractions, roots, scripts and matrices have rows in them.
Nothing here is shared with the writers in derive/pages or with the reader in derive/ledger: a letter is known by its
own spelling, the paper's LaTeX of it or, failing that, its name.
"""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache, lru_cache
from html.parser import HTMLParser
from itertools import takewhile
from typing import Any
from unicodedata import combining, lookup, normalize

Token = tuple[str, Any]
Row = tuple[Token, ...]


class RefusedError(Exception):
    """It is no formula, or it has no value."""


# ---- LaTeX -----------------------------------------------------------------------------------------------------------

GREEK = "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau phi chi psi omega"
GLYPHS = {
    "\\" + word: lookup(f"GREEK {size} LETTER {word.upper().replace('LAMBDA', 'LAMDA')}")
    for size, words in (("SMALL", GREEK.split()), ("CAPITAL", map(str.capitalize, GREEK.split())))
    for word in words
} | {r"\partial": "∂", r"\varphi": "ϕ", r"\vartheta": "ϑ", r"\varrho": "ϱ", r"\varepsilon": "ε", r"\ell": "ℓ"}
ACCENTS = {r"\hat": "hat", r"\dot": "dot", r"\ddot": "ddot", r"\bar": "bar", r"\overline": "bar", r"\check": "check"}
NAMED = {"sin", "cos", "tan", "arcsin", "arccos", "arctan", "exp", "ln", "sinh", "cosh", "tanh"}
SIGNS = {
    r"\,": "*", r"\times": "×", r"\leq": "≤", r"\in": "∈", r"\to": "→", r"\vee": "∨", r"\|": "‖", r"\{": "{",
    r"\}": "}", r"\langle": "⟨", r"\rangle": "⟩", "'": "′", **{sign: sign for sign in "+-=<,;|/()[]"},
}  # fmt: skip
PLAIN = set("()[]‖{}")  # fences that \left and \right may set


@lru_cache(10_000)
def latex_tokens(latex: str) -> Row:
    """The row of tokens of one formula."""
    found = re.findall(r"\\[A-Za-z]+|\\.|\s+|.", latex, re.DOTALL)
    reader = _Latex([token for token in found if not token.isspace()])
    row = reader.row(None)
    if reader.at < len(reader.tokens):
        raise RefusedError(f"{reader.tokens[reader.at]} closes nothing")
    return row


class _Latex:
    def __init__(self, tokens: list[str]):
        self.tokens, self.at = tokens, 0

    def take(self) -> str:
        if self.at == len(self.tokens):
            raise RefusedError("it ends too early")
        self.at += 1
        return self.tokens[self.at - 1]

    def need(self, *tokens: str) -> None:
        for token in tokens:
            if self.take() != token:
                raise RefusedError(f"{token} is missing")

    def row(self, end: str | None) -> Row:
        """Tokens up to `end`, which is taken, or all that follow."""
        result: list[Token] = []
        while end is not None or (self.at < len(self.tokens) and self.tokens[self.at] != "}"):
            token = self.take()
            if token == end:
                break
            result += self.tokens_of(token)
        return _digits_joined(result)

    def argument(self) -> Row:
        token = self.take()
        return self.row("}") if token == "{" else _digits_joined(self.tokens_of(token))

    def group(self) -> Row:
        self.need("{")
        return self.row("}")

    def tokens_of(self, token: str) -> list[Token]:
        if token in GLYPHS:
            return [("glyph", GLYPHS[token])]
        if re.fullmatch("[A-Za-z]", token):
            return [("glyph", token)]
        if re.fullmatch("[0-9]", token):
            return [("number", token)]
        if token in ACCENTS:
            return [("accent", (ACCENTS[token], self.group()))]
        if token in ("_", "^"):
            return [("down" if token == "_" else "up", self.argument())]
        if token == r"\frac":
            return [("fraction", (self.group(), self.group()))]
        if token == r"\sqrt":
            return [("root", self.group())]
        if token[1:] in NAMED:
            return [("named", token[1:])]
        if token == r"\mathrm":
            return [("upright", self.group())]
        if token == r"\mathbf":
            return list(self.group())
        if token == r"\slip":
            return list(self.group())
        if token == r"\sum":
            self.need("_")
            return [("sum", self.argument())]
        if token == r"\Big":
            return []
        if token in (r"\left", r"\right"):
            fence = SIGNS.get(self.take())
            if fence not in PLAIN:
                raise RefusedError(f"{token} sets no bracket")
            return [("sign", fence)]
        if token == r"\begin":
            self.need("{", *"bmatrix", "}")
            return [("table", self.table())]
        if token in SIGNS:
            return [("sign", SIGNS[token])]
        raise RefusedError(f"{token} is unknown")

    def table(self) -> tuple[tuple[Row, ...], ...]:
        rows: list[list[Row]] = [[]]
        cell: list[Token] = []
        while True:
            token = self.take()
            if token not in ("&", r"\\", r"\end"):
                cell += self.tokens_of(token)
                continue
            rows[-1].append(_digits_joined(cell))
            cell = []
            if token == r"\\":
                rows.append([])
            if token == r"\end":
                self.need("{", *"bmatrix", "}")
                return tuple(map(tuple, rows))


def _digits_joined(tokens: Iterable[Token]) -> Row:
    result: list[Token] = []
    for kind, what in tokens:
        if kind in ("up", "down") and kind in _scripts(result):
            raise RefusedError("two scripts at one place")
        if kind == "number" and result and result[-1][0] == "number":
            result[-1] = ("number", result[-1][1] + what)
        else:
            result.append((kind, what))
    return tuple(_scripts_in_order(result))


def _scripts(tokens: list[Token]) -> list[str]:
    """The kinds of the scripts that the last sign has so far."""
    kinds = [kind for kind, _ in tokens]
    return list(takewhile(("up", "down").__contains__, reversed(kinds)))


def _scripts_in_order(tokens: list[Token]) -> list[Token]:
    """x^a_b is x_b^a."""
    for i in range(1, len(tokens)):
        if tokens[i][0] == "down" and tokens[i - 1][0] == "up":
            tokens[i - 1 : i + 1] = [tokens[i], tokens[i - 1]]
    return tokens


# ---- MathML ----------------------------------------------------------------------------------------------------------

OVER = {"^": "hat", "˙": "dot", "¨": "ddot", "¯": "bar", "ˇ": "check"}
OPERATORS = {"−": "-", "\u2062": "*", **{sign: sign for sign in "×≤∈→∨‖{}⟨⟩′+=<,;|/()[]"}}
COUNT = {"mfrac": 2, "msub": 2, "msup": 2, "msubsup": 3, "mover": 2, "munder": 2}


@dataclass
class Node:
    tag: str
    upright: bool
    children: list["Node"]
    text: str = ""


class _Document(HTMLParser):
    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.open = [Node("", False, [])]

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        node = Node(tag, ("mathvariant", "normal") in attrs, [])
        self.open[-1].children.append(node)
        self.open.append(node)

    def handle_endtag(self, tag: str) -> None:
        if self.open.pop().tag != tag:
            raise RefusedError(f"</{tag}> closes nothing")

    def handle_data(self, data: str) -> None:
        self.open[-1].text += data.strip()


def parsed(html: str) -> Node:
    """The one element of a piece of HTML."""
    document = _Document()
    document.feed(html)
    document.close()
    (root,) = document.open[:1]
    if len(document.open) != 1 or len(root.children) != 1 or root.text:
        raise RefusedError("it is not one element")
    return root.children[0]


def mathml_tokens(html: str) -> Row:
    return node_tokens(parsed(html))


def node_tokens(root: Node) -> Row:
    if root.tag != "math":
        raise RefusedError("it is not MathML")
    return _applied(_row(root))


def _row(node: Node) -> Row:
    if node.text:
        raise RefusedError(f"text stands in <{node.tag}>")
    return _fenced(_digits_joined(token for child in node.children for token in _tokens(child)))


def _fenced(row: Row) -> Row:
    """A table with the brackets that a matrix has; it must have them."""
    result: list[Token] = []
    for i, (kind, what) in enumerate(row):
        if kind == "rows":
            if (row[i - 1 : i], row[i + 1 : i + 2]) != ((("sign", "["),), (("sign", "]"),)):
                raise RefusedError("a table without brackets")
            result[-1] = ("table", what)
        elif not (i and row[i - 1][0] == "rows"):
            result.append((kind, what))
    return tuple(result)


def _tokens(node: Node) -> Row:
    tag, parts = node.tag, node.children
    if tag == "mrow":
        return _row(node)
    if tag in ("mi", "mn", "mo"):
        if parts or not node.text:
            raise RefusedError(f"<{tag}> is not one sign")
        return (_leaf(tag, node),)
    if tag == "msqrt":
        return (("root", _row(node)),)
    if tag == "mtable":
        return (("rows", tuple(tuple(map(_cell, _only(row, "mtr"))) for row in _only(node, "mtable"))),)
    if COUNT.get(tag) != len(parts):
        raise RefusedError(f"<{tag}> of {len(parts)}")
    rows = [_tokens(part) for part in parts]
    if tag == "mfrac":
        return (("fraction", (rows[0], rows[1])),)
    if tag == "mover":
        if len(rows[1]) != 1 or rows[1][0][0] != "over":
            raise RefusedError("it is no accent")
        return (("accent", (rows[1][0][1], rows[0])),)
    if tag == "munder":
        if rows[0] != (("sign", "∑"),):
            raise RefusedError("it is no sum")
        return (("sum", rows[1]),)
    names = {"msub": ["down"], "msup": ["up"], "msubsup": ["down", "up"]}[tag]
    if not rows[0]:
        raise RefusedError("a script of nothing")
    return (*rows[0], *zip(names, rows[1:], strict=True))


def _only(node: Node, tag: str) -> list[Node]:
    if node.tag != tag or node.text:
        raise RefusedError(f"<{node.tag}> for <{tag}>")
    return node.children


def _cell(node: Node) -> Row:
    if node.tag != "mtd":
        raise RefusedError(f"<{node.tag}> for <mtd>")
    return _row(node)


def _leaf(tag: str, node: Node) -> Token:
    text = node.text
    if tag == "mn" and re.fullmatch("[0-9]+", text):
        return ("number", text)
    if tag == "mi" and node.upright:
        return ("upright", _digits_joined(("number" if c.isdigit() else "glyph", c) for c in text))
    if tag == "mi" and text in NAMED:
        return ("named", text)
    if tag == "mi" and text in (*GLYPHS.values(), *"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"):
        return ("glyph", text)
    if tag == "mo" and text in OPERATORS:
        return ("sign", OPERATORS[text])
    if tag == "mo" and text in OVER:
        return ("over", OVER[text])
    if tag == "mo" and text in ("∑", "\u2061"):
        return ("sign", text)
    raise RefusedError(f"<{tag}> of {text!r}")


def _applied(row: Row) -> Row:
    """The row, and those within it, without the signs of application, each of which must stand where it belongs."""
    result: list[Token] = []
    for i, (kind, what) in enumerate(row):
        after = row[i + 1] if i + 1 < len(row) else ("", "")
        before = row[i - 1] if i else ("", "")
        letter = before[0] in ("glyph", "accent", "up", "down", "upright", "named") and _heads(row[:i])
        if (kind, what) == ("sign", "\u2061"):
            named = before[0] in ("named", "upright") or (letter and before[0] == "up" and _named(row[:i]))
            if not (letter or named) or not (named or after in (("sign", "("), ("sign", "["))):
                raise RefusedError("nothing is applied")
            continue
        if letter and (kind, what) in (("sign", "("), ("sign", "[")):
            raise RefusedError("an application is not marked")
        if kind == "fraction":
            what = (_applied(what[0]), _applied(what[1]))
        elif kind in ("root", "up", "down", "sum"):
            what = _applied(what)
        elif kind == "accent":
            what = (what[0], _applied(what[1]))
        elif kind == "table":
            what = tuple(tuple(map(_applied, cells)) for cells in what)
        result.append((kind, what))
    return tuple(result)


def _heads(row: Row) -> bool:
    """Whether a letter or a function ends the row, not a power of a bracket."""
    kinds = [kind for kind, _ in row]
    while kinds and kinds[-1] in ("up", "down"):
        kinds.pop()
    return bool(kinds) and kinds[-1] in ("glyph", "accent", "upright", "named")


def _named(row: Row) -> bool:
    return len(row) > 1 and row[-2][0] == "named"


# ---- Text ------------------------------------------------------------------------------------------------------------

Line = list[Any]  # of columns: a character with its hats and dots, or a matrix as rows of cells, each a Line


def text_tokens(text: str, names: tuple[str, ...]) -> Row:
    """names: of the letters, as text shows them."""
    line: Line = []
    for block in _blocks([_clusters(row) for row in text.splitlines()]):
        line += [*([" "] if line else []), *_level(block)]
    return _text_row(line, _by_first(names))


@cache
def _by_first(names: tuple[str, ...]) -> dict[str, list[str]]:
    """The names that begin with a letter, the longest first."""
    found: dict[str, list[str]] = {}
    for name in sorted(names, key=len, reverse=True):
        found.setdefault(name[0], []).append(name)
    return found


def _clusters(row: str) -> list[str]:
    """The columns of a row: a letter is one with its hats and dots."""
    result: list[str] = []
    for character in row:
        if combining(character) and result:
            result[-1] += character
        else:
            result.append(character)
    return result


def _blocks(rows: list[list[str]]) -> Iterable[list[list[str]]]:
    """The rows of each line of formulas: as many as its tallest matrix has."""
    block: list[list[str]] = []
    for row in rows:
        block.append(row)
        joined = [column for part in block for column in part]
        if joined.count("⎡") == joined.count("⎣"):
            yield block
            block = []
    if block:
        raise RefusedError("a matrix is not closed")


def _level(rows: list[list[str]]) -> Line:
    """One line of formulas out of its rows: what is not a matrix stands in the middle one."""
    width = max(map(len, rows))
    grid = [row + [" "] * (width - len(row)) for row in rows]
    middle = (len(grid) - 1) // 2
    line: Line = []
    column = 0
    while column < width:
        edge = "".join(row[column] for row in grid)
        inked = edge.strip()
        if inked[:1] != "⎡":
            if inked and grid[middle][column] != inked:
                raise RefusedError(f"{inked} is not on the line")
            line.append(grid[middle][column])
            column += 1
            continue
        top, height = len(edge) - len(edge.lstrip()), len(inked)
        end = next((j for j in range(column, width) if grid[top][j] == "⎤"), column)
        block = [row[column : end + 1] for row in grid]
        right = "".join(row[-1] for row in block)
        if not re.fullmatch(" *⎡⎢*⎣ *", edge) or right != edge.translate(str.maketrans("⎡⎢⎣", "⎤⎥⎦")):
            raise RefusedError("the edges of a matrix are broken")
        if top != middle - (height - 1) // 2 or any(set(row) != {" "} for row in block[:top] + block[top + height :]):
            raise RefusedError("a matrix is not on the line")
        line.append([_cells(row[1:-1]) for row in block[top : top + height]])
        column = end + 1
    return line


def _cells(columns: Line) -> list[Line]:
    """The cells of a row of a matrix, which are two columns apart."""
    cells: list[Line] = [[]]
    depth = spaces = 0
    for column in columns:
        depth += (column == "[") - (column == "]")
        if column == " " and not depth:
            spaces += 1
            continue
        if cells[-1] and spaces:
            cells += [[]] if spaces > 1 else []
            cells[-1] += [" "] if spaces == 1 else []
        cells[-1].append(column)
        spaces = 0
    return cells


def _text_row(line: Line, names: dict[str, list[str]]) -> Row:
    line = [column for column in line if column not in ("›", "‹")]  # marks
    tokens: list[Token] = []
    at = 0
    while at < len(line):
        if isinstance(line[at], list):
            tokens.append(("table", tuple(tuple(_text_row(cell, names) for cell in row) for row in line[at])))
            at += 1
            continue
        stop = next((i for i in range(at, len(line)) if isinstance(line[i], list)), len(line))
        rest = "".join(line[at:stop])
        if rest[0] == "[" and (size := _row_matrix(line[at:stop])):
            cells = _cells(line[at + 1 : at + size - 1])
            tokens.append(("table", (tuple(_text_row(cell, names) for cell in cells),)))
            at += size
            continue
        text, token = _text_token(rest, names)
        tokens += [token] if token else []
        at += len(_clusters(text))
    return tuple(tokens)


def _row_matrix(columns: Line) -> int:
    """The columns of a matrix of one row that begins here; 0 if the bracket holds no two cells."""
    depth = 0
    for i, column in enumerate(columns):
        depth += (column == "[") - (column == "]")
        if not depth:
            return i + 1 if len(_cells(columns[1:i])) > 1 else 0
    return 0


def _text_token(rest: str, names: dict[str, list[str]]) -> tuple[str, Token | None]:
    """The text of the next token and the token, which is None for a space."""
    for name in names.get(rest[0], ()):
        if rest.startswith(name) and not re.match(rf"(?!_\{{)[\w']|{HATS}", rest[len(name) :]):
            return name, ("letter", name)
    for pattern, kind in TEXT.items():
        if match := re.match(rf"(?:{pattern})(?!{HATS})", rest):
            return match[0], _text_meaning(kind, match)
    raise RefusedError(f"{rest[:12]!r} is unknown")


HATS = "[\u0300-\u036f]"
TEXT = {
    r" ": "",
    r"\^(?:(T)|(∨)|(-)?([0-9]+)|\((-)?([0-9]+)/([0-9]+)\))": "up",
    r"_\{([0-9]+),([0-9]+)\}": "down",
    r"Σ_\{([^{}]+)\}(?= )": "sum",
    r"[0-9]+(?!\w)": "number",
    r"(?:(?:arc)?(?:sin|cos|tan)|(?:sin|cos|tan)h|exp|ln)(?=\()": "named",
    r"√(?=\()": "named",
    r"E(?=\[)": "upright",
    r"[-+=<≤×⋅,/()\[\]{}‖]": "sign",
}


def _text_meaning(kind: str, match: re.Match[str]) -> Token | None:
    if not kind:
        return None
    if kind == "up":
        turned, vector, *number = match.groups()
        if turned or vector:
            return "up", (("glyph", "T") if turned else ("sign", "∨"),)
        minus, whole, minus_of, above, below = number
        over = (("sign", "/"), ("number", below)) if below else ()
        return "up", (*((("sign", "-"),) if minus or minus_of else ()), ("number", whole or above), *over)
    if kind == "sum":
        letters = re.findall("_?[^_]|_", match[1])
        return "sum", tuple(("down", (("glyph", c[1:]),)) if c[0] == "_" else _sum_sign(c) for c in letters)
    if kind == "down":
        return "down", (("number", match[1]), ("sign", ","), ("number", match[2]))
    return {
        "upright": ("upright", (("glyph", "E"),)),
        "sign": ("sign", "*" if match[0] == "⋅" else match[0]),
    }.get(kind, (kind, match[0]))


def _sum_sign(letter: str) -> Token:
    return ("glyph", letter) if letter.isalpha() else ("sign", letter)


# ---- How a letter is spelled -----------------------------------------------------------------------------------------

HAT = {"\u0302": "hat", "\u0307": "dot", "\u0308": "ddot", "\u0304": "bar", "\u030c": "check"}


def text_name(name: str) -> str:
    """A name as text shows it: [a x] with a cross, operators within a script in braces."""
    if name.startswith("["):
        return name.replace(" x]", " ×]")
    below = re.fullmatch(r"([^_(]+)_(\w+[-+,]\w+)", name)
    return f"{below[1]}_{{{below[2]}}}" if below else name


@cache
def name_tokens(name: str) -> Row:
    """A name as a formula shows it, if the paper has no LaTeX of its own for it."""
    if turned := re.fullmatch(r"\[(.+) x\]", name):
        return ("sign", "["), *name_tokens(turned[1]), ("sign", "×"), ("sign", "]")
    if moment := re.fullmatch(r"<(\S+) (\S+)>", name):
        return ("sign", "⟨"), *name_tokens(moment[1]), ("sign", "*"), *name_tokens(moment[2]), ("sign", "⟩")
    if slope := re.fullmatch(r"(d|∂)(.+)/\1(.+)", name):
        above, below = ((("glyph", slope[1]), *name_tokens(part)) for part in slope.groups()[1:])
        return (("fraction", (above, below)),)
    base, *scripts = re.split("_", name)
    if turns := re.fullmatch(r"(\w'?)2(\w'?)", scripts[0] if len(scripts) == 1 else ""):
        scripts = list(turns.groups())
    if len(scripts) > 2:
        raise RefusedError(f"{name} has {len(scripts)} scripts")
    kinds = zip(("down", "up"), map(_script_tokens, scripts), strict=False)
    return *_base_tokens(base), *kinds


def _base_tokens(base: str) -> Row:
    tokens: list[Token] = []
    for word in re.findall(rf"[A-Za-z]{HATS}+|[A-Za-z]+(?!{HATS})|.{HATS}*", normalize("NFD", base)):
        d, rest = word[:1], word[1:]
        if "\\" + word in GLYPHS:
            tokens.append(("glyph", GLYPHS["\\" + word]))
        elif d == "d" and "\\" + rest in GLYPHS:
            tokens += [("glyph", "δ"), ("glyph", GLYPHS["\\" + rest])]
        elif word[0].isalpha() or word[0] == "∂":
            tokens += [("glyph", letter) for letter in word if letter not in HAT]
            for hat in (letter for letter in word if letter in HAT):
                tokens[-1:] = [("accent", (HAT[hat], tuple(tokens[-1:])))]
        elif word[0].isdigit():
            tokens.append(("number", word))
        elif word in ("'", "(", ")", "-", "+", "→"):
            tokens.append(("sign", "′" if word == "'" else word))
        elif word != " ":
            raise RefusedError(f"{word!r} in the name {base!r}")
    return _digits_joined(tokens)


def _script_tokens(script: str) -> Row:
    return _digits_joined(token for letter in script for token in _base_tokens(letter))


@dataclass(frozen=True)
class Spelling:
    """The letters that may stand in a formula: each spelling with the names that it has."""

    letters: Mapping[Row, tuple[str, ...]]
    functions: Mapping[Row, str]
    text: Mapping[str, str]
    samples: Row | None = None  # the index of a sum

    @property
    def longest(self) -> int:
        return max(map(len, (*self.letters, *self.functions)))


def spelling(names: Iterable[str], functions: Iterable[str], latex: Mapping[str, str]) -> Spelling:
    """latex: how the paper writes some of them; of a function under its name with a bracket."""
    letters: dict[Row, tuple[str, ...]] = {}
    names, functions = list(names), list(functions)
    for name in names:
        row = _letter_tokens(name, latex)
        letters[row] = (*letters.get(row, ()), name)
    sums = [row for name in latex if name == "Σ(" for row in latex_tokens(latex[name])]
    heads = {latex_tokens(latex[f + "("]) if f + "(" in latex else name_tokens(f): f for f in functions}
    text = {text_name(name): name for name in (*names, *functions)}
    return Spelling(letters, heads, text, sums[0][1] if sums else None)


def _letter_tokens(name: str, latex: Mapping[str, str]) -> Row:
    """A turning is shown as one, though the paper may write the vector alone."""
    own = latex_tokens(latex[name]) if name in latex else None
    if (turned := re.fullmatch(r"\[(.+) x\]", name)) and ("sign", "×") not in (own or ()):
        return ("sign", "["), *_letter_tokens(turned[1], latex), ("sign", "×"), ("sign", "]")
    return own or name_tokens(name)
