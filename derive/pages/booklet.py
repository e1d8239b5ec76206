"""A page as a LaTeX document, and a document as PDF."""

import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import MappingProxyType

from boresight import BoresightError
from boresight.derive.ledger.equation import Quantity, Relation
from boresight.derive.ledger.latex import LETTERS, SIGNS, ascii_latex, latex_name, latex_relation, script_latex
from boresight.derive.pages.blocks import (
    NAME,
    REFERENCE,
    TYPED,
    Block,
    Form,
    Formulas,
    Page,
    Pair,
    Prose,
    Section,
    Table,
    is_name,
)

PREAMBLE = r"""\documentclass[a4paper,11pt]{article}
\usepackage[margin=25mm]{geometry}
\usepackage{amsmath,amssymb,array,longtable,multicol,graphicx,xcolor}
\usepackage[hidelinks]{hyperref}
\definecolor{wrong}{HTML}{B00020}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt plus 2pt}
\setlength{\emergencystretch}{3em}
\renewcommand{\arraystretch}{1.25}
\setlength{\extrarowheight}{2pt}
\setcounter{MaxMatrixCols}{30}
\setcounter{secnumdepth}{0}
\setlength{\LTpre}{2pt}
\setlength{\LTpost}{4pt}
\setlength{\columnsep}{2.5em}
\raggedbottom
% Where print and derivation differ.
\newcommand{\slip}[1]{\textcolor{wrong}{\underline{{}#1}}}
% No heading at the foot of a page: a new one begins if less than this is left.
\newcommand{\room}[1]{\par\vskip 0pt plus #1\penalty-200\vskip 0pt plus -#1\relax}
% A fraction within a matrix is as large as another.
\let\frac\dfrac
% A formula is a paragraph of pieces that breaks between them.  A piece wider than the line is made smaller.
\newsavebox{\piecebox}
\newcommand{\piece}[1]{\sbox{\piecebox}{$\displaystyle #1$}%
\ifdim\wd\piecebox>0.94\linewidth\resizebox{0.94\linewidth}{!}{\usebox{\piecebox}}\else\usebox{\piecebox}\fi
\hskip 0pt plus 1em\penalty0\hskip 0pt plus -1em\relax}
\newenvironment{formula}{\par\nobreak\begingroup\lineskiplimit=4pt\lineskip=5pt
\leftskip=1.5em\hangindent=2em\hangafter=1\rightskip=0pt plus 1fil\noindent}{\par\endgroup}
\begin{document}
"""


def latex_page(page: Page) -> str:
    """Of several sections with their contents; equations are subsections where something stands before them."""
    parts = [PREAMBLE, rf"\begin{{center}}\LARGE\bfseries {tex(page.title)}\end{{center}}"]
    parts += [tex(text) + r"\par" for text in page.lead]
    contents = r"\begin{multicols}{2}\tableofcontents\end{multicols}"
    parts += [contents] if len(page.sections) > 1 else []
    parts += [_section(section, "section", page) for section in page.front]
    parts += [r"\room{16\baselineskip}\section{Equations}"] if page.front else []
    parts += [_section(section, "subsection" if page.front else "section", page) for section in page.sections]
    parts += [_section(section, "section", page) for section in page.back]
    return "\n".join([*parts, r"\end{document}", ""])


def _section(section: Section, level: str, page: Page) -> str:
    title = tex(section.title.removeprefix(f"{page.name or page.title} ")) + rf"\quad {section.status}" * bool(
        section.status
    )
    room = 16 if any(isinstance(block, Table) for block in section.blocks) else 9
    head = [rf"\room{{{room}\baselineskip}}\{level}{{{title}}}"] if section.title else []
    anchor = [rf"\label{{{section.anchor}}}"] if section.anchor else []
    source = [rf"{{\small {section.source}}}\par\nobreak"] if section.source else []
    return "\n".join([*head, *anchor, *source, *(_block(block, page) for block in section.blocks), ""])


def _block(block: Block, page: Page) -> str:
    if isinstance(block, Prose):
        label = rf"\textbf{{{tex(block.label)}}} " if block.label else ""
        if block.code:
            return rf"{{\raggedright {label}{_code(block.text)}\par}}"
        return label + tex(block.text, page.anchors) + r"\par"
    if isinstance(block, Formulas):
        head = [rf"\textbf{{{tex(block.label.capitalize())}}}"] if block.label else []
        formulas = map(_formula, block.verbatim or map(_latex, block.forms))
        return "\n".join([*head, "\n\\par\\penalty100\n".join(formulas)])  # a page may end between two of them
    if isinstance(block, Pair):
        return "\n".join(_block(part, page) for part in (block.left, block.right))
    return _table(block)


SPECIAL = {c: f"\\{c}" for c in "_&%$#{}"} | {c: rf"\char{ord(c)}\relax{{}}" for c in r"\^~"}


def _code(text: str) -> str:
    """Names which may be broken behind a sign."""
    escaped = re.sub(r"[_&%$#{}\\^~]", lambda found: SPECIAL[found[0]], ascii_latex(text))
    broken = re.sub(r"(/|::|\\_)", r"\1\\allowbreak{}", escaped)
    return ", ".join(rf"\texttt{{\small {name}}}" for name in broken.split(", "))


def _latex(form: Form) -> str:
    return latex_relation(form.relation, form.quantities, form.marks)


def _formula(latex: str) -> str:
    lines = (rf"\piece{{{piece}}}%" for piece in pieces(latex))
    return "\n".join([r"\begin{formula}", *lines, r"\end{formula}"])


def latex_cell(relations: Iterable[Relation], letters: tuple[Quantity, ...]) -> str:
    """What a notebook shows: relations, one below the other."""
    rows = r" \\ ".join(latex_relation(relation, letters) for relation in relations)
    return rf"$$\begin{{gathered}} {rows} \end{{gathered}}$$"


def pieces(latex: str) -> list[str]:
    """A formula cut before each =, + and - that stands in no bracket, and not behind another of them."""
    cuts, depth, last = [0], 0, "="
    for token in re.finditer(r"\\(?:left|right)\s*\\?.|\\[A-Za-z]+|\\.|\S", latex):
        text = token.group()
        if text in ("{", "(", "[", r"\{", r"\begin") or text.startswith(r"\left"):
            depth += 1
        elif text in ("}", ")", "]", r"\}", r"\end") or text.startswith(r"\right"):
            depth -= 1
        elif depth == 0 and text in "=+-<" and last not in "=+-<^_":
            cuts.append(token.start())
        last = "x" if last in "^_" else text
    found = [latex[a:b].strip() for a, b in zip(cuts, [*cuts[1:], None], strict=True)]
    return found[:1] + ["{}" + piece for piece in found[1:]]


def _table(block: Table) -> str:
    columns = "@{}" + "".join(
        r">{\raggedright\arraybackslash}p{.55\linewidth}" if i == block.prose else "l" for i in range(len(block.head))
    )
    rows = [" & ".join(rf"\textbf{{{tex(cell)}}}" for cell in block.head) + r" \\ \hline\endhead"]
    rows += [
        " & ".join(
            _code(cell) if i in block.typed and isinstance(cell, str) else _cell(cell) for i, cell in enumerate(row)
        )
        + r" \\"
        for row in block.rows
    ]
    begin = rf"\begingroup\small\renewcommand{{\arraystretch}}{{1.1}}\begin{{longtable}}[l]{{{columns}}}"
    return "\n".join([begin, *rows, r"\end{longtable}\endgroup"])


def _cell(cell: str | tuple[Form, ...]) -> str:
    return tex(cell) if isinstance(cell, str) else ", ".join(f"${latex}$" for latex in dict.fromkeys(map(_latex, cell)))


def tex(text: str, anchors: Mapping[str, str] = MappingProxyType({})) -> str:
    """Plain text for LaTeX: names of letters become formulas, what names a section a link to it."""
    parts: list[str] = []
    end = 0
    for found in re.finditer(rf"{TYPED.pattern}|{NAME.pattern}|{REFERENCE.pattern}", text):
        name = found.group()
        if found[1]:
            made = _code(found[1])
        elif name in anchors:
            made = rf"\hyperref[{anchors[name]}]{{{name}}}"
        elif name[0] != "(" and is_name(name):
            made = f"${latex_name(name)}$"
        else:
            continue
        parts += [_plain(text[end : found.start()]), made]
        end = found.end()
    return "".join([*parts, _plain(text[end:])])


TEXT_SIGNS = SIGNS | LETTERS | {"⋅": r"\cdot", "≤": r"\leq", "∈": r"\in"}


def _plain(text: str) -> str:
    text = re.sub(r"([&%$#{}_])", r"\\\1", text).replace("--", "-{}-")
    text = re.sub("[<>]", r"$\g<0>$", text)
    text = re.sub(f"[{''.join(TEXT_SIGNS)}]", lambda found: f"${TEXT_SIGNS[found[0]]}$", text)
    text = "".join(f"${script}$" if (script := script_latex(c)) else c for c in text)
    return re.sub(r"\^(-?\d+|T\b)?(?!\{)", lambda found: rf"$^{{{found[1]}}}$" if found[1] else r"\^{}", text)


def pdf_from_latex(document: str) -> bytes:
    """A LaTeX document compiled by pdflatex in a folder of its own, three times for the pages of its contents."""
    if shutil.which("pdflatex") is None:
        raise BoresightError("pdflatex is not installed: install texlive-latex-recommended, or use --format html")
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "document.tex").write_text(document, encoding="utf-8")
        command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "document.tex"]
        for _ in range(3 if r"\tableofcontents" in document else 1):
            run = subprocess.run(command, cwd=folder, capture_output=True, timeout=120, check=False)
        made = Path(folder) / "document.pdf"
        if run.returncode or not made.exists():
            log = run.stdout.decode(errors="replace")
            if package := re.search(r"File `(.*?)' not found", log):
                raise BoresightError(
                    f"pdflatex lacks {package[1]}: install texlive-latex-recommended, or use --format html"
                )
            if sign := re.search(r"Unicode character (\S+) \(U\+", log):
                raise BoresightError(f"pdflatex has no sign {sign[1]!r}: write it in LaTeX, or use --format html")
            errors = [line for line in log.splitlines() if line.startswith("!")]
            raise BoresightError(f"pdflatex failed: {errors[0] if errors else 'see its log'}")
        return made.read_bytes()
