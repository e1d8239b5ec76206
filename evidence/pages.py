"""Whether every page of a paper, a derivation or a model is written in every format, and its LaTeX compiles."""

import hashlib
import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from unicodedata import combining
from xml.etree import ElementTree

from boresight.codegen.folder import Folder
from boresight.codegen.generate import load_model, source_of
from boresight.codegen.stamp import PACKAGE, hashed, reached
from boresight.derive.pages.booklet import pdf_from_latex
from boresight.derive.pages.model import model_page
from boresight.derive.pages.page import paper_page
from boresight.derive.pages.render import write
from boresight.derive.papers import paper
from boresight.evidence.sources import Derivations

WIDTHS = (60, 100)
MISSING = "" if shutil.which("pdflatex") else "pdflatex is not here"


def pages(subject: Folder | Derivations, out: Path) -> dict[str, dict[str, Any]]:
    """By format: of text at each width the lines and the widest of them, of HTML its elements, of PDF its bytes."""
    name = subject.manifest["model"] if isinstance(subject, Folder) else subject.name

    def page(form: str) -> str:
        if isinstance(subject, Folder):
            return write(model_page(load_model(name), subject.manifest, name), form)
        return write(paper_page(paper(name), {}), form)

    return {subject.name: written(page)}


def written(page: Callable[[str], str]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for width in WIDTHS:
        with columns(width):
            lines = page("text").splitlines()
        found[f"text {width}"] = {"lines": len(lines), "widest": max(map(glyphs, lines))}
    html = page("html")
    found["html"] = sum(1 for _ in ElementTree.fromstring(closed(html)).iter())
    document = page("latex")
    found["latex"] = {"characters": len(document), "ascii formulas": formulas_are_ascii(document)}
    found["pdf"] = pdf_from_latex(document).startswith(b"%PDF")
    return found


def closed(html: str) -> str:
    """HTML as XML: what has no end tag is closed, the names of signs are signs."""
    body = html[html.index("<body") : html.index("</body>") + len("</body>")]
    for tag in ("<wbr>", "<br>"):
        body = body.replace(tag, tag[:-1] + "/>")
    return body.replace("&nbsp;", " ")


def glyphs(line: str) -> int:
    return sum(not combining(c) for c in line)


def formulas_are_ascii(document: str) -> bool:
    return all(line.isascii() for line in document.splitlines() if line.startswith(r"\piece{"))


@contextmanager
def columns(width: int) -> Iterator[None]:
    before = os.environ.get("COLUMNS")
    os.environ["COLUMNS"] = str(width)
    try:
        yield
    finally:
        os.environ.pop("COLUMNS")
        if before is not None:
            os.environ["COLUMNS"] = before


def of_model(folder: Folder) -> dict[str, str]:
    """One hash: of the model and of what writes its page, as Python, and of what its C is called."""
    model = source_of(folder.manifest["model"])
    assert model, f"{folder.name} is of no model"
    python = hashed(reached({model.resolve(), (PACKAGE / "derive" / "pages" / "model.py").resolve(), Path(__file__)}))
    names = sorted(unit["c_name"] for unit in folder.manifest["units"].values())
    return {folder.name: hashlib.sha256(f"{python}\n{names}".encode()).hexdigest()}
