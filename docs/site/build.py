"""`make site`: the pages of docs/, and a page of every equation, model, C function, public name, command and figure.

    python docs/site/build.py [-o FOLDER]

Everything is laid out below FOLDER/source, with links that lead out of docs/ to a page that shows that file; Sphinx
makes FOLDER/html of it, and a warning is an error.  Pages of papers and models are those of `show`, evidence is that of
`export`.  At the end the links are followed: none may be dead, and from each equation of which a function that flies
computes a side to that function's page, and back, are three clicks at most.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict, deque
from html import unescape
from pathlib import Path
from urllib.parse import unquote

from boresight import PUBLIC, kept_ledger
from boresight.codegen.export import export
from boresight.codegen.folder import Folder, folders
from boresight.codegen.generate import COMPONENTS
from boresight.derive.papers import DERIVATIONS, PAPERS

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).resolve().parent
LINK = re.compile(r"(?<!`)(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")
SECTION = re.compile(r'(<section id="eq-([^"]+)">.*?</section>)', re.DOTALL)
CITED = re.compile(r"([\w-]+) \((.+?)\)$")
CLICKS = 3
ORPHAN = "---\norphan: true\n---\n\n"
LANGUAGES = {".py": "python", ".c": "c", ".h": "c", ".toml": "toml", ".tex": "latex", ".md": "markdown"}
DOORS = (
    ("Write a model", "tutorial", "From an equation to a filter that flies, line by line."),
    ("Check a paper", "your-paper", "Its formulas in, a status of each out, with numbers and mends."),
    ("Fly and replay", "recordings", "A recording aligned, its sensors and delays found; and simulated flights."),
    ("Embed the C", "how-to/evidence-of-an-export", "One folder of C99, with the evidence of exactly that text."),
)
PARTS = {
    "Tutorials": ("tutorial", "your-paper", "design-questions"),
    "Explanation": ("conventions", "covariance", "float", "live", "mechanics", "own-model", "equation-to-test"),
    "Studies": ("euler-matching", "azimuth-hold", "sea-state", "sea-exploration", "transfer-alignment"),
    "Data": ("recordings", "noise", "zero-velocity", "stationary-detectors"),
    "Design": ("error-budget", "observability", "smoother"),
    "Held": ("evidence", "benchmarks", "batch", "from-ekf2-and-kf-gins"),
}


class Source:
    """What Sphinx is given, as it is laid out."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.files: set[Path] = set()  # of the checkout that a page links to

    def write(self, name: str, text: str) -> None:
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def page(self, path: Path, name: str) -> None:
        """A page of the checkout, with its links as they are here."""

        def linked(found: re.Match[str]) -> str:
            sign, text, target = found.groups()
            place, _, anchor = target.partition("#")
            if re.match(r"[a-z]+:", target) or not place:
                return found[0]
            there = Path(os.path.normpath(path.parent / place))
            if sign:
                self.copy(there)
            else:
                self.files.add(there)
            home = "/".join([".."] * name.count("/")) or "."
            return f"{sign}[{text}]({home}/{self.name_of(there)}{'#' + anchor if anchor else ''})"

        lone = "" if name == self.name_of(path) and not name.startswith("files/") else ORPHAN
        self.write(name, lone + LINK.sub(linked, path.read_text(encoding="utf-8")))

    def name_of(self, path: Path) -> str:
        """Where a file of the checkout stands in the site."""
        inside = path.relative_to(ROOT)
        if path.suffix in (".png", ".svg"):
            return f"figures/{path.name}"
        if path.suffix == ".md" and inside.parts[0] == "docs":
            return str(Path(*inside.parts[1:]))
        return f"files/{inside}.md"

    def copy(self, path: Path) -> None:
        (self.folder / "figures").mkdir(parents=True, exist_ok=True)
        shutil.copy(path, self.folder / "figures")

    def shown_files(self) -> None:
        """A page for each file of the checkout that a page links to; of a folder what it holds."""
        done: set[Path] = set()
        while left := {p for p in self.files if self.name_of(p).startswith("files/")} - done:
            for path in sorted(left):
                done.add(path)
                name, title = self.name_of(path), str(path.relative_to(ROOT))
                if path.is_dir():
                    inside = [
                        p for p in sorted(path.iterdir()) if p.name != "__pycache__" and not p.name.startswith(".")
                    ]
                    self.files |= {p for p in inside if p.is_file() and p.suffix in LANGUAGES}
                    depth = "../" * name.count("/")
                    lines = [f"- [{p.name}]({depth}{self.name_of(p)})" for p in inside if p in self.files]
                    self.write(name, f"{ORPHAN}# {title}\n\n" + "\n".join(lines) + "\n")
                elif path.suffix == ".md":
                    self.page(path, name)
                else:
                    text = path.read_text(encoding="utf-8")
                    self.write(name, f"{ORPHAN}# {title}\n\n{fenced(text, LANGUAGES.get(path.suffix, 'text'))}")


def fenced(text: str, language: str) -> str:
    return f"````{{code-block}} {language}\n{text.rstrip()}\n````\n"


def beside(text: str, page: str) -> str:
    """A link to a page that Sphinx does not make."""
    return f'<a href="{page}">{text}</a>'


def raw(html: str) -> str:
    return f"````{{raw}} html\n{html}\n````\n"


def table(head: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    lines = [head, ("---",) * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines) + "\n"


def toctree(names: list[str], hidden: bool = True, caption: str = "") -> str:
    lines = [":hidden:"] * hidden + [f":caption: {caption}"] * bool(caption) + [":maxdepth: 1", "", *names]
    return "```{toctree}\n" + "\n".join(lines) + "\n```\n"


# ---------------------------------------------------------------- equations, models, C


def cited() -> dict[tuple[str, str], list[tuple[Folder, str]]]:
    """(paper, number) -> the units of C that cite it, or whose measurement does."""
    found: dict[tuple[str, str], list[tuple[Folder, str]]] = defaultdict(list)
    for folder in folders():
        for name, unit in folder.manifest["units"].items():
            measured = folder.manifest.get("measurements", {}).get(name.rsplit("_", 1)[0], {})
            for text in (*unit.get("equations", ()), *measured.get("equations", ())):
                if match := CITED.match(text):
                    found[match[1], match[2]].append((folder, unit["file"]))
    return {key: list(dict.fromkeys(of)) for key, of in found.items()}


def equations(source: Source) -> dict[tuple[str, str], bool]:
    """A page of every equation of the papers and of our own derivations; whether a unit of C cites it."""
    found: dict[tuple[str, str], bool] = {}
    by_equation = cited()
    for paper in (*PAPERS, *DERIVATIONS):
        html = kept_ledger.page(paper, None, "html", 100)
        entries = {str(e["number"]): e for e in kept_ledger.ledger(paper)["entries"]} if paper in PAPERS else {}
        rows: list[tuple[str, ...]] = []
        names = []
        for section, number in SECTION.findall(html):
            units = by_equation.get((paper, number), [])
            found[paper, number] = bool(units)
            links = [f"[`{file}`](../../c/{folder.name}/{file}.md)" for folder, file in units]
            names.append(f"{paper}/{number}")
            title = re.sub(r"<[^>]+>", "", re.search(r"<h2>(.*?)</h2>", section, re.DOTALL)[1])  # type: ignore[index]
            # a page refers to others by anchors of one long page
            body = re.sub(
                r'href="#eq-([^"]+)"', r'href="\1.html"', re.sub(r"<h2>.*?</h2>", "", section, flags=re.DOTALL)
            )
            where = f"In C: {', '.join(links)}.\n\n" if links else "No function that flies computes a side of it.\n\n"
            head = f"# {paper} {unescape(title)}\n\n[All equations of {paper}](../{paper}.md). {where}"
            source.write(f"equations/{paper}/{number}.md", head + raw(body))
            status = entries.get(number, {}).get("status", "")
            rows.append((f"[{number}]({paper}/{number}.md)", str(status), " ".join(links).replace("../../", "../")))
        more = f"Whole: {beside('one page', f'{paper}-whole.html')}, as `boresight show` writes it.\n\n"
        head = f"# {paper}\n\n{more}{table(('equation', 'status', 'in C'), rows)}\n"
        source.write(f"equations/{paper}.md", head + toctree(names))
        source.write(f"_extra/equations/{paper}-whole.html", html)
    lines = [f"- [{paper}]({paper}.md)" for paper in (*PAPERS, *DERIVATIONS)]
    text = "# Equations\n\nEach with its print, its derivation by steps, its status, and the C that computes it.\n\n"
    source.write("equations/index.md", text + "\n".join(lines) + "\n\n" + toctree([*PAPERS, *DERIVATIONS]))
    return found


def models(source: Source) -> None:
    """A page of every model, of each of its C functions, and its evidence."""
    names = []
    for folder in folders():
        m, name = folder.manifest, folder.name
        names.append(name)
        units = [(unit["file"], function, unit) for function, unit in m["units"].items()]
        rows = []
        for file, function, unit in units:
            source.write(f"c/{name}/{file}.md", unit_page(folder, file, function, unit))
            operations = str(unit.get("operations") or "")
            rows.append((f"[`{unit.get('c_name', file)}`](../c/{name}/{file}.md)", operations, unit.get("meaning", "")))
        with tempfile.TemporaryDirectory() as out:
            export(m["model"], Path(out) / "c")
            source.write(f"_extra/evidence/{name}.html", (Path(out) / "c" / "EVIDENCE.html").read_text())
        if m["model"] not in COMPONENTS:
            source.write(f"_extra/models/{name}-show.html", kept_ledger.model_page(m["model"], "html", 100, ""))
        evidence = beside("Evidence", f"../evidence/{name}.html")
        text = f"# {m['model']}\n\n{m['title']}.\n\n{evidence} of its C, hash `{m['hash']}`."
        if m["model"] not in COMPONENTS:
            text += f" {beside('States, F, G, H and the cycle', f'{name}-show.html')}, as `show` writes them."
        text += "\n\n"
        for block in m.get("blocks", ()):
            text += f"- `{block['name']}`, {block['unit']}: {block['meaning']}\n"
        headers = [
            f"[{p.name}](../files/generated/{name}/include/{p.name}.md)" for p in sorted(folder.include.iterdir())
        ]
        source.files |= set(folder.include.iterdir())
        text += "\n" + table(("function", "operations", "what"), rows) + f"\nHeaders: {', '.join(headers)}.\n\n"
        text += toctree([f"../c/{name}/{file}" for file in dict.fromkeys(file for file, *_ in units)])
        source.write(f"models/{name}.md", text)
    source.write(
        "models/index.md", "# Models\n\n" + "\n".join(f"- [{n}]({n}.md)" for n in names) + "\n\n" + toctree(names)
    )


def unit_page(folder: Folder, file: str, function: str, unit: dict) -> str:
    """One function of C: what it is, the equations behind it, its prototype and its statements."""
    name = unit.get("c_name", file)
    links = []
    measured = folder.manifest.get("measurements", {}).get(function.rsplit("_", 1)[0], {})
    for text in dict.fromkeys((*unit.get("equations", ()), *measured.get("equations", ()))):
        match = CITED.match(text)
        known = match and match[1] in (*PAPERS, *DERIVATIONS)
        links.append(f"[{text}](../../equations/{match[1]}/{match[2]}.md)" if known else text)  # type: ignore[index]
    head = f"# {name}\n\n{unit.get('meaning', '')}. Of [{folder.manifest['model']}](../../models/{folder.name}.md).\n\n"
    head += f"Equations: {', '.join(links)}.\n\n" if links else ""
    header = folder.include / f"{folder.name}.h"
    declared = re.search(
        rf"(/\*(?:(?!\*/).)*\*/\n)?^bs_status {name}\([^;]*\);", header.read_text(), re.DOTALL | re.MULTILINE
    )
    text = f"{head}## Prototype\n\n{fenced(declared[0], 'c')}\n" if declared else head
    kernel = folder.path / "src" / f"{file}_kernel.h"
    path = kernel if kernel.is_file() else folder.path / "src" / f"{file}.c"
    body = path.read_text()
    shown = body if len(body) < 60_000 else body[:60_000] + "\n/* ... */\n"
    return f"{text}## {path.name}\n\n{fenced(shown, 'c')}"


# ---------------------------------------------------------------- reference, gallery, home


def reference(source: Source) -> None:
    """Every public name by its docstring, every command by its help."""
    import inspect
    from pkgutil import resolve_name

    text = "# Public names\n\nEach is imported as `from boresight import NAME`.\n\n"
    for name, where in PUBLIC.items():
        value = resolve_name(where)
        module, _, attribute = where.partition(":")
        kind = (
            "module"
            if inspect.ismodule(value)
            else "class"
            if inspect.isclass(value)
            else "function"
            if callable(value)
            else "data"
        )
        options = "   :members:\n" if kind in ("class", "module") else ""
        directive = f".. auto{kind}:: {module}{'.' * bool(attribute)}{attribute}\n{options}"
        text += f"## {name}\n\n```{{eval-rst}}\n{directive}```\n\n"
    source.write("reference/public-names.md", text)
    env = {**os.environ, "COLUMNS": "90", "NO_COLOR": "1", "TERM": "dumb"}

    def helped(*words: str) -> str:
        command = [
            sys.executable,
            "-c",
            "import sys; from boresight.cli import main; main(sys.argv[1:])",
            *words,
            "--help",
        ]
        return subprocess.run(command, capture_output=True, text=True, env=env, check=True).stdout

    whole = helped()
    listed = re.search(r"Commands:\n(.*?)(?:\n\n|\Z)", whole, re.DOTALL)
    commands = re.findall(r"^  (\w[\w-]*)", listed[1], re.MULTILINE) if listed else []
    text = f"# Commands\n\n{fenced(whole, 'text')}\n"
    text += "".join(f"## boresight {name}\n\n{fenced(helped(name), 'text')}\n" for name in commands)
    source.write("reference/commands.md", text)


def gallery(source: Source) -> None:
    """Each figure of the documentation, with the pages that show it."""
    users = defaultdict(list)
    for page in sorted((ROOT / "docs").rglob("*.md")):
        for sign, text, target in LINK.findall(page.read_text(encoding="utf-8")):
            if sign:
                users[Path(os.path.normpath(page.parent / target))].append((page, text))
    text = "# Gallery\n\n"
    for figure, pages in sorted(users.items()):
        source.copy(figure)
        named = ", ".join(f"[{page.stem}]({source.name_of(page)})" for page in dict.fromkeys(page for page, _ in pages))
        text += f"![{pages[0][1]}](figures/{figure.name})\n\nIn {named}.\n\n"
    source.write("gallery.md", text)


def home(source: Source) -> None:
    cards = "".join(
        f":::{{grid-item-card}} {title}\n:link: {page}\n:link-type: doc\n{text}\n:::\n" for title, page, text in DOORS
    )
    wrong = (ROOT / "examples" / "wrong_axes.py").read_text(encoding="utf-8")
    text = (
        "# Boresight\n\nFrom the equations of an inertial-navigation filter to C that can be flown: derived step by "
        "step, held against the paper and against exact mechanics, printed as C99, and flown as that very C in "
        "Python.\n\n"
        f"::::{{grid}} 1 2 2 2\n{cards}::::\n\n"
        "```\npip install 'boresight[all]'\nboresight equations kim-2018 9\nboresight replay --example\n```\n\n"
        "## What `verify` finds\n\nA model in which the uncertainty stands about the wrong axes after a turn, "
        f"`boresight verify wrong_axes.py:WRONG_AXES` says where:\n\n{fenced(wrong, 'python')}\n"
    )
    held = {name for names in PARTS.values() for name in names}
    rest = sorted(p.stem for p in (ROOT / "docs").glob("*.md") if p.stem not in held)
    for caption, names in (*PARTS.items(), *((("More", tuple(rest)),) if rest else ())):
        text += toctree([n for n in names if (ROOT / "docs" / f"{n}.md").is_file()], caption=caption)
    how = [f"how-to/{p.stem}" for p in sorted((ROOT / "docs" / "how-to").glob("*.md"))]
    decisions = [f"decisions/{p.stem}" for p in sorted((ROOT / "docs" / "decisions").glob("*.md"))]
    known = ["reference/public-names", "reference/commands"]
    known += [f"reference/{p.stem}" for p in sorted((ROOT / "docs" / "reference").glob("*.md"))]
    text += toctree(how, caption="How to") + toctree(
        ["equations/index", "models/index", *known, "gallery"], caption="Reference"
    )
    text += toctree(
        [*decisions, *[f"derivations/{p.stem}" for p in sorted((ROOT / "docs" / "derivations").glob("*.md"))]],
        caption="Decisions",
    )
    source.write("index.md", text)


def texts_for_programs(source: Source) -> None:
    """llms.txt names every page of docs/, llms-full.txt has their text."""
    pages = sorted((ROOT / "docs").rglob("*.md"))
    titles = [
        (p, next(line[2:] for line in p.read_text(encoding="utf-8").splitlines() if line.startswith("# ")))
        for p in pages
    ]
    lines = [f"- [{title}]({Path(source.name_of(p)).with_suffix('.html')})" for p, title in titles]
    head = "# Boresight\n\n> From the equations of an inertial-navigation filter to C that can be flown.\n\n"
    source.write("_extra/llms.txt", head + "\n".join(lines) + "\n")
    source.write("_extra/llms-full.txt", "\n\n".join(p.read_text(encoding="utf-8") for p in pages))


# ---------------------------------------------------------------- links


def links(html: Path) -> dict[str, set[str]]:
    """Of each page the pages that its text links to, not its menus; raises SystemExit with those that are dead."""
    found: dict[str, set[str]] = {}
    dead = []
    for path in sorted(html.rglob("*.html")):
        text = path.read_text(encoding="utf-8")
        article = re.search(r"<article.*?</article>", text, re.DOTALL)
        name = path.relative_to(html).as_posix()
        found[name] = set()
        for target in re.findall(r'href="([^"]+)"', article[0] if article else text):
            place = unquote(unescape(target)).partition("#")[0]
            if re.match(r"[a-z]+:", place) or not place:
                continue
            there = Path(os.path.normpath(path.parent / place))
            if not there.is_file():
                dead.append(f"{name}: {target}")
            elif there.suffix == ".html":
                found[name].add(there.relative_to(html).as_posix())
    if dead:
        raise SystemExit("site: dead links:\n" + "\n".join(dead[:40]))
    return found


def clicks(links_of: dict[str, set[str]], start: str, wanted: str) -> int:
    """The least clicks from a page to one whose name begins so; -1 if there is no way."""
    far, waiting = {start: 0}, deque([start])
    while waiting:
        page = waiting.popleft()
        if page.startswith(wanted):
            return far[page]
        for other in links_of[page]:
            if other not in far:
                far[other] = far[page] + 1
                waiting.append(other)
    return -1


def main() -> None:
    parser = argparse.ArgumentParser(description="Make the site of the documentation.")
    parser.add_argument("-o", "--out", type=Path, default=ROOT / "out" / "site")
    out = parser.parse_args().out.resolve()
    shutil.rmtree(out / "source", ignore_errors=True)
    source = Source(out / "source")
    for path in sorted((ROOT / "docs").rglob("*.md")):
        source.page(path, source.name_of(path))
    flies = equations(source)
    models(source)
    reference(source)
    gallery(source)
    home(source)
    texts_for_programs(source)
    source.shown_files()
    done = subprocess.run(
        [
            sys.executable,
            "-m",
            "sphinx",
            "-W",
            "--keep-going",
            "-q",
            "-j",
            "2",
            "-c",
            HERE,
            out / "source",
            out / "html",
        ],
        check=False,
    )
    if done.returncode:
        raise SystemExit("site: Sphinx warns, see above")
    shutil.copytree(out / "source" / "_extra", out / "html", dirs_exist_ok=True)
    links_of = links(out / "html")
    far = Counter()
    for (paper, number), in_c in flies.items():
        if in_c:
            page = f"equations/{paper}/{number}.html"
            there = clicks(links_of, page, "c/")
            back = min(clicks(links_of, p, page) for p in links_of[page] if p.startswith("c/"))
            far[max(there, back)] += 1
    print(f"site: {len(links_of)} pages, {sum(map(len, links_of.values()))} links; {len(flies)} equations, of which "
          f"{sum(flies.values())} lead to C and back in {dict(far)} clicks; {out / 'html' / 'index.html'}")  # fmt: skip
    if max(far) > CLICKS or -1 in far:
        raise SystemExit("site: an equation and its C are further apart")


if __name__ == "__main__":
    main()
