"""How a name in code is written as a letter of a formula, and the number of an equation in prose."""

import re
from unicodedata import normalize

GREEK = """alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi
omega Phi"""


NUMBER = r"(?:[A-Z][.-]?)?\d+(?:[.-]\d+)*[a-z]?'*"  # 19, 2.14, A.3, 12a


def is_number(number: str) -> bool:
    """Whether an equation is called by a number, and not by a letter that it defines."""
    return re.fullmatch(NUMBER, number) is not None


def number_label(number: str) -> str:
    """(19), or the letter of a definition without a number."""
    return f"({number})" if is_number(number) else number


def dotted(name: str) -> str:
    """The name of its rate: a dot over the last letter before the scripts."""
    stem, under, scripts = name.partition("_")
    return normalize("NFC", f"{stem}\u0307{under}{scripts}")


def letter_latex(name: str) -> str:
    """LaTeX of a name in code: omega_ie, C_b2n_11, dmu_x, roll_b, F_phi,dv_n."""
    if block := re.fullmatch(r"([A-Z]\w*?)_(\w+),([a-zA-Z]\w*)", name):
        return rf"{letter_latex(block[1])}_{{{letter_latex(block[2])},{letter_latex(block[3])}}}"
    head, *below = name.split("_")
    if head == "d" and below and below[0] in GREEK.split():
        head, below = f"d{below[0]}", below[1:]
    above = ""
    if below and (turn := re.fullmatch(r"(\w)2(\w)", below[0])):
        below[0], above = turn[1], f"^{{{turn[2]}}}"
    index = ",".join(_word(part) for part in ",".join(below).split(",") if part)
    return _word(head) + (f"_{{{index}}}" if index else "") + above


def _word(word: str) -> str:
    error = word.startswith("d") and word[1:] in GREEK.split()
    base = word[1:] if error else word
    if base in GREEK.split():
        return r"\delta " * error + f"\\{base}"
    return base if len(base) <= 2 or base.isdigit() else rf"\mathrm{{{base}}}"
