"""A page of every equation, every model and every unit of C, each linked to the next and back.

The pages are those of `boresight show`, `boresight.evidence.trace` and `export`: what is added is the links.
"""

import ast
import re
import tempfile
from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from html import escape
from itertools import chain
from pathlib import Path
from typing import Any

from boresight import kept_ledger
from boresight.codegen.export import export
from boresight.codegen.folder import Folder, Source, folders
from boresight.codegen.generate import COMPONENTS, load_model
from boresight.derive.pages.blocks import Block, Formulas, Page, Section
from boresight.derive.pages.html import html_cell
from boresight.derive.pages.model import model_page
from boresight.derive.pages.page import anchor, equations_page, paper_page
from boresight.derive.papers import DERIVATIONS, PAPERS, paper
from boresight.evidence import trace as statements
from boresight.evidence.crossed import PEERS
from boresight.evidence.crossed import table as crossed
from boresight.studies.known import STUDIES, study
from docs.site import layout, reference
from docs.site.layout import ORPHAN, ROOT, fenced, raw, table, toctree

ALL = (*PAPERS, *DERIVATIONS)
CITED = re.compile(rf"\b({'|'.join(ALL)}) \(([^()\s]+)\)")
CODE = re.compile(r"<code>(\w+)</code>")
EQUATION = re.compile(r'href="#eq-([^"]+)"')
FUNCTION = re.compile(
    r"(?P<comment>/\*(?:(?!\*/).)*\*/\n)?^(?P<text>(?!static|typedef|return|else)[a-z]\w*(?: \w+)*[ *]+(?P<name>\w+)"
    r"\([^;{}()]*\));$",
    re.MULTILINE | re.DOTALL,
)
DEFINED = re.compile(r"^(?!static|typedef|return|else)[a-z]\w*(?: \w+)*[ *]+(\w+)\([^;{}()]*\)\n?\s*\{", re.MULTILINE)
NAMED_PAGES = re.compile(r"\bPages?:([^.]*)\.")
APART = 30_000  # characters: a longer section of a model has its own page
TOGETHER = 40  # formulas of a block
MOST = 150_000  # characters: what is longer has several
LISTED = 80_000  # characters of the table of statements
EMBED = (
    "`boresight export MODEL -o DIR` writes the C of a model as one folder that needs nothing of Python: [embed the C]"
    "(../own-model.md#embed-the-c), [show what is known of it](../how-to/evidence-of-an-export.md).\n\n"
)
STATEMENT = "By `python -m boresight.evidence.trace`: each statement, and the blocks of the result that depend on it."


# ---------------------------------------------------------------- C


@dataclass(frozen=True)
class Prototype:
    """A function as a header declares it."""

    name: str
    text: str
    header: Path


def prototypes(folder: Folder) -> dict[str, Prototype]:
    """name -> what the folder's own headers say of each function that they declare."""
    found = {}
    for header in sorted(folder.include.glob("*.h")):
        for one in FUNCTION.finditer(header.read_text(encoding="utf-8")):
            found[one["name"]] = Prototype(one["name"], (one["comment"] or "") + one["text"] + ";", header)
    return found


@dataclass(frozen=True, eq=False)
class Unit:
    """A file of src/ with the functions that it defines; described: what the manifest says of a printed one."""

    folder: Folder
    path: Path
    functions: tuple[Prototype, ...]
    described: Mapping[str, Any]

    @property
    def page(self) -> str:
        return f"c/{self.folder.name}/{self.path.stem}"

    @cached_property
    def equations(self) -> tuple[str, ...]:
        """Those that it, the measurement that it is of, its prototypes, or a component's header cites."""
        measured = self.folder.manifest.get("measurements", {})
        name = self.described.get("name", "")
        of = [m["equations"] for key, m in measured.items() if name.startswith(f"{key}_")]
        text = "".join(function.text for function in self.functions)
        if self.folder.manifest["model"] in COMPONENTS:
            text = self.functions[0].header.read_text(encoding="utf-8")
        in_text = (found[0] for found in CITED.finditer(text))
        return tuple(dict.fromkeys((*self.described.get("equations", ()), *chain(*of), *in_text)))


def units_of(folder: Folder) -> list[Unit]:
    """Every file of src/ that defines a function of a header."""
    declared = prototypes(folder)
    made = []
    for path in sorted((folder.path / "src").glob("*.c")):
        defined = set(DEFINED.findall(path.read_text(encoding="utf-8")))
        functions = tuple(one for name, one in declared.items() if name in defined)
        if functions:
            made.append(Unit(folder, path, functions, Source(folder, path).described or {}))
    return made


def cited_pages(folder: Folder) -> set[str]:
    """The pages of the site that the folder's headers cite, by name."""
    found: set[str] = set()
    for header in folder.include.glob("*.h"):
        for text in NAMED_PAGES.findall(header.read_text(encoding="utf-8")):
            found |= {page.strip(" *\n") for page in text.split(",")}
    return found


# ---------------------------------------------------------------- what is linked with what


@dataclass(frozen=True, eq=False)
class Equation:
    """A printed equation: its page, the HTML of `show`, and the numbers that its derivation names."""

    paper: str
    number: str
    title: str
    status: str
    source: str
    html: str

    @property
    def page(self) -> str:
        return f"equations/{self.paper}/{self.number}"

    @cached_property
    def uses(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(n for n in EQUATION.findall(self.html) if n != self.number))


@dataclass
class Trace:
    """All of it, by name."""

    units: list[Unit] = field(default_factory=list)
    equations: dict[tuple[str, str], Equation] = field(default_factory=dict)
    why: dict[tuple[str, str], str] = field(default_factory=dict)  # no function computes a side of it
    tests: Mapping[tuple[str, str], list[tuple[Path, str]]] = field(default_factory=dict)
    blocks: dict[str, dict[str, str]] = field(default_factory=dict)  # model's folder -> section -> page#anchor

    @cached_property
    def functions(self) -> dict[str, Unit]:
        return {function.name: unit for unit in self.units for function in unit.functions}

    @cached_property
    def cited(self) -> dict[tuple[str, str], list[Unit]]:
        found: dict[tuple[str, str], list[Unit]] = defaultdict(list)
        for unit in self.units:
            for text in unit.equations:
                if match := CITED.fullmatch(text):
                    found[match[1], match[2]].append(unit)
        return found

    def used_by(self, one: Equation) -> list[Equation]:
        return [e for e in self.equations.values() if e.paper == one.paper and one.number in e.uses]

    def reached(self, one: Equation) -> list[Unit]:
        """The units that cite it; else those that cite the next equations that stand on it."""
        done, now = {one.number}, [one]
        while now:
            if found := [unit for e in now for unit in self.cited.get((e.paper, e.number), ())]:
                return list(dict.fromkeys(found))
            now = [e for e in dict.fromkeys(e for one in now for e in self.used_by(one)) if e.number not in done]
            done |= {e.number for e in now}
        return []

    def block(self, unit: Unit) -> str:
        """The place on the model's page that a unit is made from, or nothing."""
        known, name = self.blocks.get(unit.folder.name, {}), unit.described.get("name", "")
        while name:
            for anchored in (name, f"function-{name}"):
                if anchored in known:
                    return known[anchored]
            name = name.rpartition("_")[0]
        return known.get("F", known.get("step", "")) if unit.described else ""

    def linked(self, html: str, here: str) -> str:
        """HTML of `show` or `export`, with links from the names of equations and of C to their pages."""
        top = layout.up(here)

        def code(found: re.Match[str]) -> str:
            unit = self.functions.get(found[1])
            return f'<a href="{top}{unit.page}.html"><code>{found[1]}</code></a>' if unit else found[0]

        def equation(found: re.Match[str]) -> str:
            one = self.equations.get((found[1], found[2]))
            return f'<a href="{top}{one.page}.html">{found[0]}</a>' if one else found[0]

        return CITED.sub(equation, CODE.sub(code, html))


def sections(page: Page) -> str:
    """The sections as HTML, without a style of their own."""
    return re.sub(r"<style>.*?</style>", "", html_cell(page), flags=re.DOTALL).strip()


def tests_of() -> dict[tuple[str, str], list[tuple[Path, str]]]:
    """(paper, number) -> the tests that are marked with it."""
    found: dict[tuple[str, str], list[tuple[Path, str]]] = defaultdict(list)
    for name in PAPERS:
        path = ROOT / "tests" / "derive" / f"test_{name.replace('-', '_')}.py"
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            for mark in getattr(node, "decorator_list", []):
                if isinstance(mark, ast.Call) and ast.unparse(mark.func) == "pytest.mark.equations":
                    for number in ast.literal_eval(mark.args[0]).split():
                        found[name, number].append((path, node.name))  # type: ignore[attr-defined]
    return found


# ---------------------------------------------------------------- equations


def shown_paper(name: str) -> dict[str, Any]:
    """A paper as `show` has it, in parts; kept until its sources change."""

    def made() -> dict[str, Any]:
        one, functions = paper(name), kept_ledger.functions()
        whole = paper_page(one, functions)
        labels = {e.label: anchor(e) for e in one.equations if e.numbered}
        parts = []
        for e in one.equations:
            page = equations_page(name, [(one, e)], functions)
            (section,) = page.sections
            body = replace(section, title="", status="", anchor="", source="")
            html = sections(replace(page, sections=(body,), anchors=labels | dict(page.anchors)))
            number = e.number if e.number.isascii() else anchor(e)
            parts.append((number, e.label, section.status, section.source, html))
        around = replace(whole, sections=(), anchors=labels | dict(whole.anchors))
        front, back = (sections(replace(around, sections=part, back=())) for part in (whole.front, whole.back))
        return {"lead": whole.lead, "front": front, "back": back, "equations": parts, "why": dict(one.unflown)}

    return kept_ledger.kept(f"site/{name}", dict, made, (Path(__file__),))


def chip(status: str) -> str:
    return f'<span class="chip {re.split(r"[^a-z-]", status)[0]}">{escape(status)}</span>'


def equation_page(source: layout.Source, known: Trace, one: Equation) -> None:
    """Where it leads, its print and derivation, and back."""
    here, top = one.page, layout.up(one.page)
    units = known.cited.get((one.paper, one.number), [])
    by_model: dict[str, list[Unit]] = defaultdict(list)
    for unit in units:
        by_model[unit.folder.name].append(unit)
    rows = []
    for name, of in by_model.items():
        places = dict.fromkeys(place for unit in of if (place := known.block(unit)))
        blocks = ", ".join(f'<a href="{top}{p}">{p.rpartition("#block-")[2]}</a>' for p in places)
        c = ", ".join(f"[`{unit.path.stem}`]({top}{unit.page}.md)" for unit in of)
        evidence = f"[evidence]({top}models/{name}-evidence.md)"
        rows.append((f"[{of[0].folder.manifest['model']}]({top}models/{name}.md)", blocks, c, evidence))
    trail = table(("model", "block", "C", ""), rows) if rows else ""
    if why := known.why.get((one.paper, one.number)):
        trail += f"\nNo function gives a side of it by itself: {why}.\n"
    links = {
        "Stands on": [known.equations[one.paper, n] for n in one.uses if (one.paper, n) in known.equations],
        "Used by": known.used_by(one),
    }
    lines = [f"{word} " + ", ".join(f"[{e.title}]({top}{e.page}.md)" for e in of) for word, of in links.items() if of]
    if not units and (reached := known.reached(one)):
        lines.append("In C through these: " + ", ".join(f"[`{u.path.stem}`]({top}{u.page}.md)" for u in reached))
    models = dict.fromkeys(unit.folder.manifest["model"] for unit in units or known.reached(one))
    flown_on = dict.fromkeys(page for model in models for page in studied().get(model, ()))
    if flown_on:
        lines.append("Flown in " + ", ".join(titled(source, here, page) for page in flown_on))
    if tests := known.tests.get((one.paper, one.number)):
        lines.append("Tested by " + ", ".join(source.link(here, path, f"`{name}`") for path, name in tests))
    head = f"[All of {one.paper}](../{one.paper}.md)" + (f", {one.source}" if one.source else "")
    text = f"{ORPHAN}# {one.paper} {one.title}\n\n{chip(one.status)} {head}\n\n" + "\n".join(f"- {x}." for x in lines)
    body = known.linked(EQUATION.sub(r'href="\1.html"', one.html), here)
    source.write(here, f"{text}\n\n{trail}\n## Print, derivation, evidence\n\n{raw(body)}")


def graph(of: list[Equation], prefix: str) -> str:
    """The equations in a row, each in the colour of its status, and an arc from each to every one it stands on."""
    wide = 14 + 8 * max(len(e.title) for e in of)
    place = {e.number: wide * (i + 0.5) for i, e in enumerate(of)}
    arcs = [(place[e.number], place[n]) for e in of for n in e.uses if n in place]
    top = 12 + max((abs(a - b) for a, b in arcs), default=0) / 4
    drawn = [
        f'<path d="M{max(a, b):g} {top:g}A{abs(a - b) / 2:g} {abs(a - b) / 4:g} 0 0 0 {min(a, b):g} {top:g}"/>'
        for a, b in arcs
    ]
    nodes = [
        f'<a href="{prefix}{e.number}.html" class="square {e.status.partition(":")[0]}">'
        f'<rect x="{place[e.number] - wide / 2 + 2:g}" y="{top:g}" width="{wide - 4}" height="24" rx="4"/>'
        f'<text x="{place[e.number]:g}" y="{top + 17:g}">{escape(e.title)}</text></a>'
        for e in of
    ]
    size = f'width="{wide * len(of)}" height="{top + 28:g}"'
    return f'<div class="wide"><svg class="graph" {size}>{"".join(drawn + nodes)}</svg></div>'


def equations(source: layout.Source, known: Trace) -> None:
    """A page of each equation, one of each paper, and the table of all."""
    papers = {name: shown_paper(name) for name in ALL}
    for name, shown in papers.items():
        for number, label, status, where, html in shown["equations"]:
            known.equations[name, number] = Equation(name, number, label, status, where, html)
        known.why |= {(name, number): why for number, why in shown["why"].items()}
    rows, maps = [], []
    for name, shown in papers.items():
        of = [e for e in known.equations.values() if e.paper == name]
        for one in of:
            equation_page(source, known, one)
            c = ", ".join(f"[`{u.path.stem}`](../{u.page}.md)" for u in known.cited.get((name, one.number), ()))
            rows.append((f"[{name} {one.title}](../{one.page}.md)", chip(one.status), c or "none"))
        squares = "".join(
            f'<a class="square {e.status.partition(":")[0]}" href="../{e.page}.html">{escape(e.title)}</a>' for e in of
        )
        maps.append(f"<p><b>{name}</b></p><p>{squares}</p>")
        here = f"equations/{name}"
        around = known.linked(EQUATION.sub(rf'href="{name}/\1.html"', shown["front"] + shown["back"]), here)
        linked = raw(f"<p>{squares}</p><p>What each stands on, by arcs:</p>{graph(of, f'{name}/')}")
        source.write(here, "\n\n".join((f"# {name}", *shown["lead"], linked, raw(around))))
    colours = " ".join(map(chip, ("exact", "first-order", "definition", "erratum")))
    head = (
        "# Equations\n\nEach printed equation, with the status that `boresight equations` computes of it: "
        f"{colours}. The page of a paper draws which stands on which.\n\n"
    )
    listed = f"::::{{container}} filterable\n{table(('equation', 'status', 'in C'), rows)}::::\n\n"
    source.write("equations/index", head + raw("".join(maps)) + "\n" + listed + toctree(ALL))


# ---------------------------------------------------------------- models and their C


def shown_model(folder: Folder) -> dict[str, Any]:
    """The page of `show` of a model, in parts; kept until its sources change."""

    def made() -> dict[str, Any]:
        name = folder.manifest["model"]
        page = model_page(load_model(name), folder.manifest)

        def html(blocks: Iterable[Block]) -> str:
            return sections(replace(page, sections=(Section("", tuple(blocks)),), back=()))

        def parts(section: Section) -> Iterable[tuple[str, str, str]]:
            groups: list[list[str]] = [[]]
            for block in chain.from_iterable(map(shorter, section.blocks)):
                made = html([block])
                if groups[-1] and sum(map(len, groups[-1])) + len(made) > MOST:
                    groups.append([])
                groups[-1].append(made)
            for i, group in enumerate(groups, 1):
                more = f", {i} of {len(groups)}" if len(groups) > 1 else ""
                yield f"{section.anchor}-{i}" if i > 1 else section.anchor, section.title + more, "".join(group)

        return {"lead": page.lead, "sections": [part for one in page.sections for part in parts(one)]}

    return kept_ledger.kept(f"site/{folder.name}", dict, made, (Path(__file__),))


def shorter(block: Block) -> Iterable[Block]:
    """Many formulas as several blocks."""
    if not isinstance(block, Formulas) or len(block.forms) <= TOGETHER:
        return [block]
    starts = range(0, len(block.forms), TOGETHER)
    return [Formulas(block.forms[i : i + TOGETHER], "" if i else block.label) for i in starts]


def models(source: layout.Source, known: Trace, shown: Mapping[str, dict[str, Any]]) -> None:
    """A page of every model, one of its evidence, and one of each of its units."""
    rows = []
    for folder in folders():
        here, m = f"models/{folder.name}", folder.manifest
        own = [unit for unit in known.units if unit.folder.name == folder.name]
        headers = (source.link(here, path, f"`{path.name}`") for path in sorted(folder.include.glob("*.h")))
        lead = (
            *(shown[folder.name]["lead"] if folder.name in shown else ()),
            f"[Evidence of its C]({folder.name}-evidence.md). `boresight export {m['model']} -o DIR` writes it.",
            f"Headers: {', '.join(headers)}.",
            f"Explained in {', '.join(explained(source, here, m['model']))}.",
            beside(source, here, folder),
        )
        text = f"# {m['model']}\n\n" + "\n\n".join(filter(None, lead)) + "\n"
        for name, title, html in shown.get(folder.name, {"sections": ()})["sections"]:
            place = known.blocks[folder.name].get(name, here)
            page = place.partition(".html")[0] or here
            body = raw(f'<div id="block-{name}">{known.linked(html, page)}</div>' if name else known.linked(html, page))
            if page == here:
                text += f"\n## {title}\n\n{body}"
            else:
                source.write(page, f"{ORPHAN}# {m['model']}: {title}\n\nOf [{m['model']}]({folder.name}.md).\n\n{body}")
                text += f"\n## {title}\n\n[On a page of its own]({page.rpartition('/')[2]}.md): it is long.\n"
        functions = [
            (f"[`{f.name}`](../{unit.page}.md)", str(unit.described.get("operations", "")), f"`{unit.path.name}`")
            for unit in own
            for f in unit.functions
        ]
        text += flown(source, here, m["model"])
        text += "\n## Every function\n\n" + table(("function", "operations", "of"), functions)
        source.write(here, text)
        rows.append((f"[{m['model']}]({folder.name}.md)", m["title"], f"[evidence]({folder.name}-evidence.md)"))
        evidence_page(source, known, folder)
        for unit in own:
            unit_page(source, known, unit)
    text = "# Models\n\n" + EMBED + table(("model", "what it is", ""), rows) + "\n" + toctree(f.name for f in folders())
    source.write("models/index", text)


@cache
def studied() -> dict[str, list[Path]]:
    """Model -> the pages of docs/ on the studies that fly it; a page shows the command of its study."""
    found: dict[str, list[Path]] = defaultdict(list)
    texts = {path: path.read_text(encoding="utf-8") for path in layout.pages()}
    for name in STUDIES:
        shown = [path for path, text in texts.items() if re.search(rf"^boresight study {name}\b", text, re.MULTILINE)]
        for model in study(name).models:
            found[model] += [path for path in shown if path not in found[model]]
    return found


def beside(source: layout.Source, here: str, folder: Folder) -> str:
    """The tools that were asked for the same numbers as the folder's C; nothing if none was."""
    tools = ", ".join(peer.name for peer in PEERS if any(folder.name in check.of for check in peer.checks))
    return f"The same numbers by {tools}: {titled(source, here, crossed.PAGE)}." if tools else ""


def titled(source: layout.Source, here: str, page: Path) -> str:
    """A link to a page of docs/, in the words of its title."""
    return source.link(here, page, reference.title_at(page))


def explained(source: layout.Source, here: str, model: str) -> list[str]:
    """Links to the page of docs/ that is called like a model, and to those that name it most often."""
    word = re.compile(rf"(?<![\w-]){model}(?![\w-])")
    named = [(path.stem == model, len(word.findall(path.read_text(encoding="utf-8"))), path) for path in layout.pages()]
    most = sorted((one for one in named if one[1]), key=lambda one: (-one[0], -one[1]))[:4]
    return [titled(source, here, path) for _, _, path in most]


def flown(source: layout.Source, here: str, model: str) -> str:
    """A figure of a study whose code names the model, and the page that explains it; nothing if there is none."""
    for figure, pages in sorted(reference.shown_on(layout.pages()).items()):
        drawn = reference.code_of(Path(figure).stem)
        if not drawn or ROOT / "studies" not in drawn[0].parents:
            continue
        if any(f'"{model}"' in path.read_text(encoding="utf-8") for path in drawn[0].parent.glob("*.py")):
            page, words = pages[0]
            picture = f"![{words}]({source.picture(here, ROOT / 'docs' / 'figures' / figure)})"
            on = titled(source, here, page)
            return f"\n## In a study\n\n{picture}\n\n{words}, of {on}; [its code](../gallery/{Path(figure).stem}.md).\n"
    return ""


def evidence_page(source: layout.Source, known: Trace, folder: Folder) -> None:
    """What `export` writes of it, with a place for each unit."""
    here = f"models/{folder.name}-evidence"
    with tempfile.TemporaryDirectory() as out:
        export(folder.manifest["model"], Path(out) / "c")
        html = (Path(out) / "c" / "EVIDENCE.html").read_text(encoding="utf-8")
    body = html.partition("</h1>")[2].partition("</body>")[0]
    pages = {unit.path.stem: unit.page for unit in known.units}

    def placed(found: re.Match[str]) -> str:
        name = found[1]
        cell = f'<a href="../{pages[name]}.html"><code>{name}</code></a>' if name in pages else f"<code>{name}</code>"
        return f'<tr id="{name}"><td>{cell}</td>'

    by_unit, rest = body.split("</table>", 1)
    by_unit = re.sub(r"<tr><td><code>(\w+)</code></td>", placed, by_unit)
    before, heading, behind = rest.partition("<h2>Requirements</h2>")
    listed, _, after = behind.partition("<h2>")
    rest = before
    if heading:  # some hundred: a page of their own
        there, top = f"models/{folder.name}-requirements", f"{ORPHAN}# {folder.manifest['model']}: requirements\n\n"
        source.write(there, f"{top}Of [its evidence]({folder.name}-evidence.md).\n\n{raw(known.linked(listed, there))}")
        rest += f'{heading}<p><a href="{folder.name}-requirements.html">On a page of their own</a></p><h2>{after}'
    body = raw(by_unit + "</table>" + known.linked(rest, here))
    source.write(here, f"{ORPHAN}# {folder.manifest['model']}: evidence\n\n[The model]({folder.name}.md).\n\n{body}")


def unit_page(source: layout.Source, known: Trace, unit: Unit) -> None:
    """A file of C: what it computes and from what, its prototypes, its statements."""
    here, top, of = unit.page, layout.up(unit.page), unit.folder
    links = [f"Model [{of.manifest['model']}]({top}models/{of.name}.md)"]
    if block := known.block(unit):
        links.append(f'block <a href="{top}{block}">{block.rpartition("#block-")[2]}</a>')
    row = "" if unit.path in of.identity else f"#{unit.path.stem}"  # the identity computes nothing
    links.append(f'<a href="{top}models/{of.name}-evidence.html{row}">evidence</a>')
    text = f"{ORPHAN}# {unit.path.stem}\n\n{unit.described.get('meaning', '')}\n\n{', '.join(links)}.\n\n"
    cited = [known.equations.get((match[1], match[2])) for one in unit.equations if (match := CITED.fullmatch(one))]
    cited_links = [f"[{e.paper} {e.title}]({top}{e.page}.md) {chip(e.status)}" for e in cited if e]
    text += f"Equations: {', '.join(cited_links)}\n\n" if cited_links else ""
    headers = dict.fromkeys(function.header for function in unit.functions)
    text += f"## Prototypes\n\nOf {', '.join(source.link(here, path, f'`{path.name}`') for path in headers)}.\n\n"
    text += "".join(fenced(function.text, "c") + "\n" for function in unit.functions)
    if unit.described:
        listed = statements.table(Source(of, unit.path))
        if len(listed) > LISTED:
            listed = listed[:LISTED].rsplit("\n", 1)[0] + "\n..."
        text += f"## Statements\n\n{STATEMENT}\n\n{fenced(listed)}\n"
        kernel = unit.path.with_name(f"{unit.path.stem}_kernel.h")
        files = [path for path in (kernel, unit.path) if path.is_file()]
        text += "".join(f'<a href="{top}{source.keep(path)}">{path.name}</a> ' for path in files) + "\n"
    else:
        text += f"## {unit.path.name}\n\n{source.text_of(here, unit.path)}"
    source.write(here, text)


# ---------------------------------------------------------------- all


def write(source: layout.Source) -> Trace:
    """All pages; what they are linked by."""
    known = Trace(units=[unit for folder in folders() for unit in units_of(folder)], tests=tests_of())
    shown = {f.name: shown_model(f) for f in folders() if f.manifest["model"] not in COMPONENTS}
    for name, page in shown.items():
        for anchored, _, html in page["sections"]:
            apart = f"models/{name}-{anchored}" if len(html) > APART else f"models/{name}"
            known.blocks.setdefault(name, {})[anchored] = f"{apart}.html#block-{anchored}"
    equations(source, known)
    models(source, known, shown)
    return known


def ends(known: Trace) -> Iterable[tuple[Equation, list[Unit]]]:
    """Each printed, numbered equation of the papers with the units that make C of it."""
    return [(e, known.reached(e)) for e in known.equations.values() if e.paper in PAPERS and e.title.startswith("(")]
