"""What Sphinx is given: pages of the checkout with their links turned, and a page for each file that they lead to."""

import os
import re
import shutil
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")
FENCED = re.compile(r"^( *```.*?^ *```$)", re.MULTILINE | re.DOTALL)
FILE = re.compile(r"^```(\w+) ([\w.]+)$", re.MULTILINE)  # a block that is a file
LANGUAGES = {".py": "python", ".c": "c", ".h": "c", ".toml": "toml", ".tex": "latex", ".sh": "bash", ".json": "json"}
PICTURES = (".png", ".svg")
LONG = 30_000  # characters: a longer file is shown without colours
CUT = 150_000  # characters: of a longer one the beginning is shown
ORPHAN = "---\norphan: true\n---\n\n"


def turned(text: str, turn: Callable[[str, str, str], str]) -> str:
    """A page with each link, as (sign, text, target), turned; what is fenced stays."""
    parts = FENCED.split(text)
    return "".join(part if i % 2 else LINK.sub(lambda m: turn(*m.groups()), part) for i, part in enumerate(parts))


def docname(path: Path) -> str:
    """Where a file or folder of the checkout stands in the site, without a suffix."""
    inside = path.relative_to(ROOT)
    if inside.parts[:1] == ("docs",) and path.suffix == ".md":
        return inside.relative_to("docs").with_suffix("").as_posix()
    return f"files/{inside.with_suffix('') if path.suffix == '.md' else inside}"


def pages() -> list[Path]:
    """The pages of docs/, without what this package has."""
    docs = ROOT / "docs"
    return [path for path in sorted(docs.rglob("*.md")) if docs / "site" not in path.parents]


def up(name: str) -> str:
    """From a page to the top of the site."""
    return "../" * name.count("/")


def title_of(text: str) -> str:
    return next(line[2:] for line in text.splitlines() if line.startswith("# "))


def fenced(text: str, language: str = "none") -> str:
    return f"`````{{code-block}} {language}\n{text.rstrip()}\n`````\n"


def raw(html: str) -> str:
    return f"`````{{raw}} html\n{html}\n`````\n"


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines) + "\n"


def toctree(names: Iterable[str], caption: str = "", hidden: bool = True) -> str:
    lines = [":hidden:"] * hidden + [f":caption: {caption}"] * bool(caption) + [":maxdepth: 1", "", *names]
    return "```{toctree}\n" + "\n".join(lines) + "\n```\n"


class Source:
    """The folder that Sphinx reads, as it is filled."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.extra = folder.with_name(folder.name + "-extra")  # files that are copied as they are
        for one in (self.folder, self.extra):
            shutil.rmtree(one, ignore_errors=True)
            one.mkdir(parents=True)
        self.files: set[Path] = set()  # of the checkout, which a page links to

    def write(self, name: str, text: str) -> None:
        """A page, by its name; a block that is a file has its name above it."""
        path = self.folder / f"{name}.md"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(FILE.sub(r"```{code-block} \1\n:caption: \2\n", text), encoding="utf-8")

    def keep(self, path: Path) -> str:
        """A file of the checkout as it is; where it stands in the site."""
        name = f"raw/{path.relative_to(ROOT).as_posix()}"
        (self.extra / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, self.extra / name)
        return name

    def link(self, here: str, path: Path, text: str = "") -> str:
        """From a page to the page of a file."""
        if docname(path).startswith("files/"):
            self.files.add(path)
        return f"[{text or f'`{path.relative_to(ROOT)}`'}]({up(here)}{docname(path)}.md)"

    def picture(self, here: str, path: Path) -> str:
        """A figure that a page shows."""
        name = f"figures/{path.name}"
        (self.folder / "figures").mkdir(exist_ok=True)
        shutil.copy(path, self.folder / name)
        return up(here) + name

    def page(self, path: Path, head: str = "") -> None:
        """A page of the checkout, with its links as they are in the site."""
        self.write(docname(path), head + self.included(path.read_text(encoding="utf-8"), path.parent, docname(path)))

    def included(self, text: str, folder: Path, here: str) -> str:
        """Markdown of a folder of the checkout, for a page of the site."""

        def turn(sign: str, words: str, target: str) -> str:
            place, _, anchor = target.partition("#")
            if re.match(r"[a-z]+:", target) or not place:
                return f"{sign}[{words}]({target})"
            there = Path(os.path.normpath(folder / place))
            if not there.exists():
                raise SystemExit(f"site: {here} links to {target}, which is not there")
            if sign:
                return f"![{words}]({self.picture(here, there)})"
            return self.link(here, there, words).replace(".md)", f".md#{anchor})" if anchor else ".md)")

        return turned(text, turn)

    def shown_files(self) -> None:
        """A page for each file of the checkout that a page links to; of a folder what it holds, which is shown too."""
        done: set[Path] = set()
        while left := self.files - done:
            for path in sorted(left):
                self._shown(path)
            done |= left

    def _shown(self, path: Path) -> None:
        name, title = docname(path), path.relative_to(ROOT)
        if path.is_dir():
            inside = sorted(p for p in path.iterdir() if p.suffix in (*LANGUAGES, ".md") and p.is_file())
            text = "\n".join(f"- {self.link(name, p, f'`{p.name}`')}" for p in inside)
        elif path.suffix == ".md":
            return self.page(path, ORPHAN)
        elif path.suffix in PICTURES:
            text = f"![{title}]({self.picture(name, path)})"
        else:
            text = self.text_of(name, path)
        return self.write(name, f"{ORPHAN}# `{title}`\n\n{text}\n")

    def text_of(self, here: str, path: Path) -> str:
        """A file's text, or its beginning and where the rest is."""
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            text = ""
        language = LANGUAGES.get(path.suffix, "none") if len(text) < LONG else "none"
        shown = fenced(text[:CUT].rsplit("\n", 1)[0] if len(text) > CUT else text, language) if text else ""
        if 0 < len(text) <= CUT:
            return shown
        return f'<a href="{up(here)}{self.keep(path)}">The whole file</a>, {path.stat().st_size} bytes.\n\n{shown}'
