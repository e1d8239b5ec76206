"""Derivations for people: the terminal, LaTeX, HTML, PDF, made from the equations and the ledger."""

import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterable
from html import escape
from pathlib import Path
from textwrap import fill

from boresight import BoresightError
from boresight.derive.ledger.entries import Entry, entry_of, findings
from boresight.derive.ledger.equation import Derivation, Equation, Quantity, Relation
from boresight.derive.ledger.paper import Paper
from boresight.derive.pages import maps
from boresight.derive.pages.latex import latex_name, latex_relation
from boresight.derive.pages.mathml import mathml_relation
from boresight.derive.pages.text import columns, text_relation

FORMATS = ("text", "latex", "html")


def render(paper: Paper, number: str | None = None, format: str = "text") -> str:
    """One equation of a paper, or all of them, as text, as a LaTeX document or as an HTML page.

    Raises BoresightError on a number or a format that does not exist.
    """
    chosen, entries = _chosen(paper, number)
    remarks = () if number else (*findings(paper), *maps.remarks(paper))
    return render_equations(paper.name, chosen, entries, format, remarks)


def render_equations(
    title: str, chosen: Iterable[Equation], entries: Iterable[Entry], format: str, remarks: Iterable[str] = ()
) -> str:
    """Equations with their entries of the ledger, in one of FORMATS: for a paper, or for a model made from papers.

    remarks: what else is to be said at the end.
    """
    writers = {"text": _text, "latex": _latex, "html": _html}
    if format not in writers:
        raise BoresightError(f"no format {format!r}: the formats are {', '.join(FORMATS)} and pdf")
    return writers[format](title, list(zip(chosen, entries, strict=True)), tuple(remarks))


def render_derivation(title: str, derivation: Derivation, format: str) -> str:
    """A derivation that belongs to no equation of a paper, in one of FORMATS."""
    if format == "text":
        return "\n".join([title, "=" * len(title), *_text_steps(derivation, ())]) + "\n"
    if format == "latex":
        steps = "\n\n".join(_latex_steps(derivation, ()))
        return "\n".join([PREAMBLE, rf"\section*{{{_tex(title)}}}", steps, r"\end{document}", ""])
    if format == "html":
        return _html_page(title, _html_steps(derivation, ()))
    raise BoresightError(f"no format {format!r}: the formats are {', '.join(FORMATS)} and pdf")


def pdf_from_latex(document: str) -> bytes:
    """A LaTeX document compiled by pdflatex in a folder of its own."""
    if shutil.which("pdflatex") is None:
        raise BoresightError("pdflatex is not installed: install texlive-latex-base, or use --format html")
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "document.tex").write_text(document, encoding="utf-8")
        command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "document.tex"]
        run = subprocess.run(command, cwd=folder, capture_output=True, timeout=120, check=False)
        made = Path(folder) / "document.pdf"
        if run.returncode or not made.exists():
            errors = [line for line in run.stdout.decode(errors="replace").splitlines() if line.startswith("!")]
            raise BoresightError(f"pdflatex failed: {errors[0] if errors else 'see its log'}")
        return made.read_bytes()


def _chosen(paper: Paper, number: str | None) -> tuple[list[Equation], list[Entry]]:
    chosen = [paper.equation(number)] if number else list(paper.equations)
    return chosen, [entry_of(paper, equation) for equation in chosen]


# ---- Text ----------------------------------------------------------------------------------------------------------


def _text(title: str, chosen: list[tuple[Equation, Entry]], remarks: tuple[str, ...]) -> str:
    parts = [] if len(chosen) == 1 else [f"{title}: {len(chosen)} equations, {_counts(entry for _, entry in chosen)}\n"]
    parts += [_text_equation(*pair) for pair in chosen]
    return "\n".join([*parts, *(_wrapped(remark, 2) + "\n" for remark in remarks)])


def _text_equation(equation: Equation, entry: Entry) -> str:
    head = f"{equation.paper} ({equation.number})  {_status(entry)}  [source line {_lines(equation)}]"
    same = equation.read() == equation.derived
    parts = [
        head,
        "=" * len(head),
        "printed" + (" and derived" if same else ""),
        _text_relations(equation.printed, equation.quantities),
    ]
    if not same:
        parts += ["derived", _text_relations(equation.derived, equation.quantities)]
    parts += _text_steps(equation.derivation, equation.quantities)
    parts.append(_wrapped(f"evidence: {entry.evidence}.", 2))
    if entry.note:
        parts.append(_wrapped(f"note: {entry.note}", 2))
    return "\n".join(parts) + "\n"


def _text_steps(derivation: Derivation, quantities: Iterable[Quantity]) -> list[str]:
    parts = []
    for i, step in enumerate(derivation.steps, 1):
        parts.append(_wrapped(f"{i}. {step.name}: {step.why}.", 3))
        if step.formulas:
            parts.append(_text_relations(step.formulas, quantities))
    return parts


def _wrapped(text: str, indent: int) -> str:
    return fill(text, columns(), subsequent_indent=" " * indent, break_long_words=False)


def _text_relations(relations: Iterable[Relation], quantities: Iterable[Quantity]) -> str:
    shown = (text_relation(relation, quantities, columns() - 6) for relation in relations)
    return "\n".join(" " * 6 + line for text in shown for line in text.splitlines())


# ---- LaTeX ---------------------------------------------------------------------------------------------------------

PREAMBLE = r"""\documentclass[a4paper,10pt]{article}
\usepackage[margin=20mm]{geometry}
\usepackage{amsmath,amssymb,graphicx}
\renewcommand{\arraystretch}{1.3}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
% A display that is wider than the page is made smaller, and no other.
\newsavebox{\formula}
\newcommand{\fitted}[1]{\begin{center}\sbox{\formula}{$\displaystyle #1$}%
\ifdim\wd\formula>\linewidth\resizebox{\linewidth}{!}{\usebox{\formula}}\else\usebox{\formula}\fi\end{center}}
\begin{document}
"""


def _latex(title: str, chosen: list[tuple[Equation, Entry]], remarks: tuple[str, ...]) -> str:
    parts = [PREAMBLE, rf"\section*{{{_tex(title)}}}", _tex(_counts(entry for _, entry in chosen)) + "\n"]
    parts += [_latex_equation(*pair) for pair in chosen]
    if remarks:
        parts += [r"\subsection*{Beside the equations}", *(_tex(remark) + "\n" for remark in remarks)]
    return "\n".join([*parts, r"\end{document}", ""])


def _latex_shown(relations: Iterable[Relation], quantities: Iterable[Quantity]) -> str:
    return "\n".join(rf"\fitted{{{latex_relation(r, quantities)}}}" for r in relations)


def _latex_steps(derivation: Derivation, quantities: Iterable[Quantity]) -> list[str]:
    return [
        rf"{i}. \emph{{{_tex(step.name)}}}: {_tex(step.why)}." + "\n" + _latex_shown(step.formulas, quantities)
        for i, step in enumerate(derivation.steps, 1)
    ]


def _latex_equation(equation: Equation, entry: Entry) -> str:
    parts = [
        rf"\subsection*{{({equation.number})\quad {_tex(_status(entry))}}}",
        rf"\textbf{{Printed}}, source line {_lines(equation)}:",
        "\n".join(rf"\fitted{{{display.rstrip(', ')}}}" for display in _displays(equation)),
        r"\textbf{Derived}:",
        _latex_shown(equation.derived, equation.quantities),
        *_latex_steps(equation.derivation, equation.quantities),
    ]
    parts.append(rf"\textbf{{Evidence}}: {_tex(entry.evidence)}.")
    if entry.note:
        parts.append(rf"\textbf{{Note}}: {_tex(entry.note)}")
    return "\n\n".join(part for part in parts if part) + "\n"


def _displays(equation: Equation) -> list[str]:
    """The displays as printed, those that go on joined to what they go on from."""
    joined: list[str] = []
    for display in equation.latex:
        if not display.startswith(r"\begin{aligned}"):  # a row of a display that holds several equations
            display = display.replace("&=", "=")
        if joined and display[0] in "=+-":
            joined[-1] += " " + display
        else:
            joined.append(display)
    return joined


def _tex(text: str) -> str:
    """Plain text for LaTeX: letters and names of quantities become formulas, what needs a backslash gets one."""

    def word(part: str) -> str:
        bare = part.strip("().,;:")
        if not re.search(r"[^\x00-\x7f]|_", bare):
            return re.sub(r"([&%$#{}])", r"\\\1", part).replace("^", r"\^{}").replace("--", "-{}-")
        return part.replace(bare, f"${latex_name(bare)}$")

    return "".join(word(part) for part in re.split(r"(\s+)", text))


# ---- HTML ----------------------------------------------------------------------------------------------------------

STYLE = """body{font:16px/1.5 serif;max-width:70em;margin:2em auto;padding:0 1em;color:#111;background:#fff}
section{border-top:1px solid #bbb;padding:.5em 0}
.pair{display:flex;flex-wrap:wrap;gap:1em 3em}
.pair>div{flex:1 1 30em;overflow-x:auto}
math{display:block;margin:.6em 0;overflow-x:auto}
.erratum{color:#a00000}
pre{overflow-x:auto;background:#f4f4f4;padding:.5em}"""


def _html(title: str, chosen: list[tuple[Equation, Entry]], remarks: tuple[str, ...]) -> str:
    body = "\n".join(_html_equation(*pair) for pair in chosen)
    body += "".join(f"\n<p>{escape(remark)}</p>" for remark in remarks)
    return _html_page(title, f"<p>{escape(_counts(entry for _, entry in chosen))}</p>\n{body}")


def _html_page(title: str, body: str) -> str:
    return (
        f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{escape(title)}</title>\n'
        f"<style>{STYLE}</style></head>\n<body><h1>{escape(title)}</h1>\n{body}\n</body></html>\n"
    )


def _html_formulas(relations: Iterable[Relation], quantities: Iterable[Quantity]) -> str:
    return "".join(mathml_relation(relation, quantities) for relation in relations)


def _html_steps(derivation: Derivation, quantities: Iterable[Quantity]) -> str:
    steps = (
        f"<li><em>{escape(step.name)}</em>: {escape(step.why)}.{_html_formulas(step.formulas, quantities)}</li>"
        for step in derivation.steps
    )
    return f"<ol>{''.join(steps)}</ol>"


def _html_equation(equation: Equation, entry: Entry) -> str:
    letters = equation.quantities
    note = f"<p>Note: {escape(entry.note)}</p>" if entry.note else ""
    return (
        f'<section id="eq-{escape(equation.number)}"><h2>({escape(equation.number)}) '
        f'<span class="{escape(entry.status)}">{escape(_status(entry))}</span></h2>\n'
        f'<div class="pair"><div>Printed, source line {_lines(equation)}'
        f"{_html_formulas(equation.printed, letters)}</div>\n"
        f"<div>Derived{_html_formulas(equation.derived, letters)}</div></div>\n"
        f"{_html_steps(equation.derivation, letters)}\n<p>Evidence: {escape(entry.evidence)}.</p>\n{note}"
        f"<details><summary>LaTeX of the source</summary><pre>{escape(chr(10).join(equation.latex))}</pre></details>"
        "</section>"
    )


# ---- Shared --------------------------------------------------------------------------------------------------------


def _status(entry: Entry) -> str:
    return f"{entry.status}: {entry.kind}, {entry.origin}" if entry.kind else entry.status


def _lines(equation: Equation) -> str:
    first, last = equation.lines
    return str(first) if first == last else f"{first}-{last}"


def _counts(entries: Iterable[Entry]) -> str:
    statuses = [entry.status for entry in entries]
    order = ("exact", "first-order", "definition", "erratum")
    return ", ".join(f"{statuses.count(status)} {status}" for status in order if status in statuses)
