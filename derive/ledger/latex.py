"""LaTeX of relations and of the names of quantities."""

import re
from collections.abc import Collection, Iterable
from unicodedata import decomposition, lookup, normalize
from unicodedata import name as name_of

from boresight.derive.ledger.equation import Quantity, Relation
from boresight.derive.ledger.formula import ATOM, ELEMENTARY, PREFIX, Piece, Place, Writer


def latex_relations(relations: Iterable[Relation], quantities: Iterable[Quantity]) -> str:
    """LaTeX of relations, with the paper's letters."""
    quantities = tuple(quantities)
    return r" \\ ".join(latex_relation(relation, quantities) for relation in relations)


def latex_relation(relation: Relation, quantities: Iterable[Quantity], marks: Collection[Place] = ()) -> str:
    r"""LaTeX of one relation.  marks: places that are set in \slip{...}, a command of the document's."""
    pieces = _Latex(quantities, marks).pieces(relation)
    return " ".join(part for piece in pieces for part in piece if part)


class _Latex(Writer):
    TIMES = r" \, "
    OPEN_MARK, CLOSE_MARK = r"\slip{", "}"
    NORM, CURLY = (r"\|", r"\|"), (r"\{", r"\}")
    AT_MOST, CROSS, TRANSPOSED, VECTOR = r"\leq", r"\times", "T", r"\vee"
    RATE = r"\frac{d}{d t}"

    def letter(self, name):
        latex = self._spelled(name)
        # A power of a letter of several glyphs, or with a superscript of its own, needs brackets.
        simple = re.fullmatch(r"\\(?:hat|dot|ddot|bar|check|overline|mathbf)\{[^{}]*\}|\\\w+|\w|\[.*\]", _stem(latex))
        return latex, ATOM if simple and "^" not in latex.partition("[")[0] else PREFIX

    def _spelled(self, name):
        turning = re.fullmatch(r"\[(.*) x\]", name)
        if turning and r"\times" not in self.letters.get(name, ""):
            return rf"[{self._spelled(turning[1])}\times]"
        return ascii_latex(self.letters.get(name, "")) or latex_name(name)

    def head(self, name):
        return ascii_latex(self.letters.get(name + "(", "")) or latex_name(name)

    def bracketed(self, text, left="(", right=")"):
        return rf"\left{left}{text}\right{right}"

    def fraction(self, above, below):
        return rf"\frac{{{self.multiplied(above)}}}{{{self.multiplied(below)}}}", PREFIX

    def root(self, text):
        return rf"\sqrt{{{text}}}"

    def raised(self, base, exponent):
        return rf"{base}^{{{exponent}}}"

    def applied(self, name, argument, exponent):
        power = f"^{{{exponent}}}" if exponent else ""
        text, level = argument
        bare = level == ATOM and name != "exp" and not text.isdigit() and not text.startswith((r"\left", r"\begin"))
        return rf"\{ELEMENTARY[name]}{power}" + (" " + text if bare else self.bracketed(text)), PREFIX

    def grid(self, rows):
        inside = r" \\ ".join(" & ".join(row) for row in rows)
        return rf"\begin{{bmatrix}} {inside} \end{{bmatrix}}"

    def summed(self, name, argument):
        return f"{self.head(name)} {argument}", PREFIX

    def factor(self, piece: Piece, index: int, last: bool) -> str:
        text = super().factor(piece, index, last)
        return text if last or not text.startswith(r"\sum") else self.bracketed(text)

    def entry(self, base, row, column):
        if "_" in base and not base.startswith(r"\left"):
            base = self.bracketed(base)
        return rf"{base}_{{{row},{column}}}", ATOM

    def expectation(self, text):
        return r"\mathrm{E}" + self.bracketed(text, "[", "]")


def _stem(latex: str) -> str:
    """A letter without its scripts."""
    return latex if latex.startswith("[") else re.split(r"[_^]", latex)[0].strip()


SIGNS = {"→": r"\to", "−": "-", "×": r"\times"}
LETTERS = {"∂": r"\partial", "∇": r"\nabla", "ℓ": r"\ell", "ħ": r"\hbar"}
LETTERS |= {"ϕ": r"\varphi", "ϑ": r"\vartheta", "ϱ": r"\varrho"}
MARKS = {"\u0302": "hat", "\u0307": "dot", "\u0308": "ddot", "\u0304": "bar", "\u030c": "check", "\u0303": "tilde"}
CAPITALS = ("gamma", "delta", "theta", "lambda", "xi", "pi", "sigma", "upsilon", "phi", "psi", "omega")


def greek(word: str) -> str:
    """The Greek letter that a word names, small or capital, or nothing."""
    size = "SMALL" if word.islower() else "CAPITAL"
    try:
        return lookup(f"GREEK {size} LETTER {word.upper().replace('LAMBDA', 'LAMDA')}") if len(word) > 1 else ""
    except KeyError:
        return ""


def latex_name(name: str) -> str:
    """LaTeX of a symbol's name: Greek letters, hats and dots, scripts, C_b2n, [v x], dR_E/dL."""
    name = re.sub(r"^([^_^]+)((?:_[^_]+?)*?)_hat(?![a-z])", "\\1\u0302\\2", name)  # as the headers of C write it
    if "^" in name:
        base, _, above = name.partition("^")
        return f"{latex_name(base)}^{{{_scripted(above)}}}"
    transformation = re.fullmatch(r"(.*?)_(\w'?)2(\w'?)", name)
    if transformation:
        letter, source, target = transformation.groups()
        return f"{latex_name(letter)}_{{{_scripted(source)}}}^{{{_scripted(target)}}}"
    turning = re.fullmatch(r"\[(.*) x\]", name)
    if turning:
        return rf"[{latex_name(turning[1])}\times]"
    slope = re.fullmatch(r"([d∂])(.+)/\1(.+)", name)
    if slope:
        d = latex_name(slope[1])
        return rf"\frac{{{d} {latex_name(slope[2])}}}{{{d} {latex_name(slope[3])}}}"
    moment = re.fullmatch(r"<(\S+) (\S+)>", name)
    if moment:
        return rf"\langle {latex_name(moment[1])} \, {latex_name(moment[2])} \rangle"
    text, _, scripts = name.partition("_")
    result = ""
    for word, marks in _letters(text):
        if word[:1] == "d" and greek(word[1:]):
            result, word = result + r"\delta ", word[1:]
        result += _marked(f"\\{word} " if greek(word) else word, marks)
    below, _, above = map(_scripted, scripts.partition("_"))
    return result.strip() + (f"_{{{below}}}" if below else "") + (f"^{{{above}}}" if above else "")


def _letters(text: str) -> list[tuple[str, str]]:
    """Words of plain letters, and each other character alone, with the marks above it."""
    return re.findall(rf"([A-Za-z]+|.)([{''.join(MARKS)}]*)", normalize("NFD", text))


def _scripted(text: str) -> str:
    """LaTeX of what stands below or above a letter: its words are names, no Greek letters."""
    return "".join(_marked(word, marks) for word, marks in _letters(text)).strip()


def _marked(word: str, marks: str) -> str:
    latex = word if word.isascii() else _character(word)
    for mark in marks:
        latex = rf"\{MARKS[mark]}{{{latex.strip()}}}"
    return latex


def ascii_latex(latex: str) -> str:
    """LaTeX with the name of each letter that stands in it as itself: \\hat{φ} is \\hat{\\phi}."""
    return latex if latex.isascii() else "".join(_marked(word, marks) for word, marks in _letters(latex))


def _character(character: str) -> str:
    """LaTeX of one letter or sign, in a formula."""
    greek = re.fullmatch(r"GREEK (SMALL|CAPITAL) LETTER (FINAL )?(\w+)", name_of(character, ""))
    if greek:
        word = greek[3].lower().replace("lamda", "lambda")
        if greek[1] == "CAPITAL" and word not in CAPITALS:  # it looks like a Latin one, and LaTeX has no name for it
            return {"eta": "H", "rho": "P", "chi": "X"}.get(word, word[0].upper())
        return "o" if word == "omicron" else "\\" + (word.capitalize() if greek[1] == "CAPITAL" else word) + " "
    if script := script_latex(character):
        return script
    sign = (SIGNS | LETTERS).get(character)
    return sign + " " if sign else character


def script_latex(character: str) -> str:
    """LaTeX of a sign that stands above or below by itself, as ⁺ and ₀, or nothing."""
    where, _, plain = decomposition(character).partition("> ")
    sign = {"<super": "^", "<sub": "_"}.get(where)
    return f"{sign}{{{chr(int(plain, 16)).replace('−', '-')}}}" if sign and " " not in plain else ""
