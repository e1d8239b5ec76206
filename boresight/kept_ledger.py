"""Ledgers and pages as the command line prints them: made once, kept in the cache folder until a source changes.

Only the command line reads what is kept.  Tests and evidence call `compute`, or boresight.derive.ledger.entries itself.
"""

import hashlib
import json
import os
import sys
import tomllib
from collections.abc import Callable, Iterable
from contextlib import suppress
from importlib.metadata import version
from pathlib import Path
from typing import Any, TypeVar
from urllib.parse import quote

from boresight.runtime.manifest import built_in, cache_folder, folder_of, generated

Made = TypeVar("Made")
Progress = Callable[[int, int, str], None]  # how many are done, of all, and the last one
DERIVE = Path(__file__).parent / "derive"


def compute(paper: str, progress: Progress = lambda done, total, text: None) -> dict[str, Any]:
    """`entries`, the rows of `boresight equations PAPER --json`, `findings`, the sentences beside them, `unheld`, what
    nothing holds, `conditions`: what the sizes hold for, and the point at which errata are computed, `refused`: the
    numbers whose derivations do not stand, and `labels`: other names of equations, with their numbers."""
    from boresight.codegen.generate import load_model
    from boresight.derive import papers
    from boresight.derive.ledger.entries import findings, ledger, unheld

    one = papers.paper(paper, load_model)
    rows = rows_of(one, one.equations, ledger(one, progress))
    return {**rows, "findings": list(findings(one)), "unheld": list(unheld(one)), "labels": dict(one.labels)}


def rows_of(one: Any, equations: Iterable[Any], entries: Iterable[Any]) -> dict[str, Any]:
    """Of equations of a paper their rows, and what `compute` says of these."""
    from boresight.derive.ledger.lines import standing

    return {
        "entries": [entry.to_dict() for entry in entries],
        "conditions": [one.conditions.text, one.point.text],
        "refused": [equation.number for equation in equations if standing(one, equation).refused],
    }


def ledger(paper: str, progress: Progress = lambda done, total, text: None) -> dict[str, Any]:
    """As `compute` gives it, from the cache folder if nothing that reaches it has changed."""
    if has_own_code(paper):
        return compute(paper, progress)
    return kept(f"ledger/{name_of(paper)}", dict, lambda: compute(paper, progress), files_of(paper))


def equation(paper: str, number: str, check: Callable[[str, list[str]], object]) -> dict[str, Any]:
    """Of a ledger the row of one equation, and `conditions`; where no ledger is kept, the other rows are not computed.

    check: refuses a number that is none of those that there are.
    """
    name, files = name_of(paper), files_of(paper)
    if has_own_code(paper):
        return one_row(paper, number, check)
    whole = held(f"ledger/{name}", dict, files)
    if whole is None:
        place = f"ledger/{name}-{quote(number, safe='')}"
        return kept(place, dict, lambda: one_row(paper, number, check), files)
    number = whole["labels"].get(number, number)
    check(number, [row["number"] for row in whole["entries"]])
    return {**whole, "entries": [row for row in whole["entries"] if row["number"] == number]}


def one_row(paper: str, number: str, check: Callable[[str, list[str]], object]) -> dict[str, Any]:
    from boresight.codegen.generate import load_model
    from boresight.derive import papers
    from boresight.derive.ledger.entries import entry_of

    one = papers.paper(paper, load_model)
    number = one.labels.get(number, number)
    check(number, list(one.numbers))
    chosen = one.equation(number)
    return rows_of(one, [chosen], [entry_of(one, chosen)])


def page(paper: str, number: str | None, form: str, width: int) -> str:
    """A paper, or one equation of it, in a format of boresight.derive.pages.render; kept likewise."""
    if has_own_code(paper):
        return rendered(paper, number, form)
    name = f"pages/{name_of(paper)}-{number or 'all'}-{form}-{width}"
    return kept(name, str, lambda: rendered(paper, number, form), files_of(paper))


def files_of(paper: str) -> tuple[Path, ...]:
    """The files of a paper of one's own; of the papers that come with Boresight none, for they are sources."""
    from boresight.derive.papers import is_folder
    from boresight.derive.papers.files import FILES, STEPS

    return tuple(Path(paper) / name for name in (*FILES, STEPS)) if is_folder(paper) else ()


def has_own_code(paper: str) -> bool:
    """Whether a paper of one's own has a witness or a model in Python: nobody knows what such a file reads."""
    from boresight.derive.papers.files import PYTHON

    try:
        found = [tomllib.loads(path.read_text(encoding="utf-8")) for path in files_of(paper)[:1]]
    except (OSError, ValueError):  # which is refused in words where the paper is read
        return True
    models = [one.get("model") for one in found]
    return any(one.get("witness") == PYTHON for one in found) or any(
        isinstance(one, dict) and ":" in str(one.get("name", "")) for one in models
    )


def name_of(paper: str) -> str:
    """What is kept of a paper is called so: of one's own by what its folder is called from here, for a page says it."""
    where = hashlib.sha256(f"{Path.cwd()} {paper}".encode()).hexdigest()[:16]
    return f"own-{where}" if files_of(paper) else paper


def rendered(paper: str, number: str | None, form: str) -> str:
    from boresight.codegen.generate import load_model
    from boresight.derive import papers
    from boresight.derive.pages.render import render

    return render(papers.paper(paper, load_model), number, form, functions())


def model_page(target: str, form: str, width: int, derived: str = "") -> str:
    """The page of a model; one's own is made anew each time, as nobody knows what its file reads.

    derived: "rate" or "step", for what follows from its strapdown and feedback in the place of what it gives by hand.
    """
    if ":" in target:
        return described(target, form, derived)
    return kept(f"pages/{target}-{form}-{width}{derived}", str, lambda: described(target, form, derived))


def described(target: str, form: str, what: str) -> str:
    from boresight.codegen.generate import load_model, old_manifest
    from boresight.derive.linear import derived
    from boresight.derive.pages.model import model_page
    from boresight.derive.pages.render import write

    model = load_model(target)
    if what:
        return write(model_page(derived(model, what == "step"), {}, target), form)
    folder = Path("generated") / model.name.replace("-", "_") if ":" in target else folder_of(target)
    return write(model_page(model, old_manifest(folder), target), form)


def functions() -> dict[str, dict[str, tuple[str, ...]]]:
    """For each equation, as `song-lee-2001 (19)`, the models that cite it, and their C functions that do."""
    found: dict[str, dict[str, tuple[str, ...]]] = {}
    for model in built_in():
        for unit in json.loads((folder_of(model) / "manifest.json").read_text(encoding="utf-8"))["units"].values():
            for equation in unit["equations"]:
                models = found.setdefault(equation, {})
                models[model] = (*models.get(model, ()), unit["c_name"])
    return found


def kept(name: str, kind: type[Made], make: Callable[[], Made], files: tuple[Path, ...] = ()) -> Made:
    """What `make` makes, a JSON value of a kind, from the cache folder if nothing that reaches it has changed.

    files: which it reads beside the sources.
    """
    if (old := held(name, kind, files)) is not None:
        return old
    path, now, made = cache_folder() / f"{name}.json", key(files=files), make()
    part = path.with_suffix(f".{os.getpid()}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        part.write_text(json.dumps({"key": now, "made": made}, ensure_ascii=False), encoding="utf-8")
        part.replace(path)
    except OSError:  # a folder that cannot be written costs time, no result
        with suppress(OSError):
            part.unlink(missing_ok=True)
    return made


def held(name: str, kind: type[Made], files: tuple[Path, ...] = ()) -> Made | None:
    """What is kept under a name; None where nothing is, where it is damaged, or what reaches it has changed."""
    try:
        old = json.loads((cache_folder() / f"{name}.json").read_text(encoding="utf-8"))
        made = old["made"] if old["key"] == key(files=files) else None
    except (OSError, ValueError, LookupError, TypeError):
        return None
    return made if isinstance(made, kind) else None


def key(derive: Path = DERIVE, files: tuple[Path, ...] = ()) -> str:
    """A hash of all that reaches a page: every source of derive, this file, what the C is, the libraries and Python,
    and these files."""
    digest = hashlib.sha256(repr(sys.version_info[:2]).encode())
    for name in ("sympy", "mpmath", "python-flint", "jinja2"):
        digest.update(f"{name} {version(name)}\n".encode())
    sources = sorted(path for end in ("py", "j2", "toml", "tex") for path in derive.rglob(f"*.{end}"))
    for path in (Path(__file__), *sources, *sorted(generated().glob("*/manifest.json")), *files):
        content = path.read_bytes() if path.is_file() else b""
        digest.update(f"{path.name} {len(content)}\n".encode() + content)
    return digest.hexdigest()
