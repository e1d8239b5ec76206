"""The reference: public names from their docstrings, commands from their own help; and the gallery, and llms.txt."""

import ast
import inspect
import re
from collections.abc import Mapping, Sequence
from ctypes import Structure
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import boresight
from boresight import PUBLIC
from boresight.derive.pages.reference import prose
from docs.site import layout
from docs.site.layout import ROOT, fenced

GROUP = re.compile(r"^(\w[\w ]*)\n((?:    .*\n)+)", re.MULTILINE)
NAME = re.compile(r"`(\w+)`")
# Figures whose name the caller gives, and the function that draws them.
NAMED_BY_CALLER = {
    "autopilot_log": "examples/fly_autopilot_log.py:draw",
    "labelled_rest": "tests/studies/labelled_rest.py:draw",
    "noise": "analysis/noise.py:draw",
    "noise_flight": "analysis/likelihood.py:draw",
    "tutorial": "analysis/consistency.py:draw",
}
BY_HAND = ("measurement", "pipe")
ROOMS = ("studies", "analysis", "benchmarks", "examples")
DRAWS = re.compile(r"sheets\(|\.savefig\(")
LITERAL = 5  # characters of a name that a string must have as they are


def groups() -> dict[str, list[str]]:
    """Title -> the public names that `help(boresight)` lists under it."""
    text = boresight.__doc__ or ""
    found = {title: [n for n in NAME.findall(body) if n in PUBLIC] for title, body in GROUP.findall(text)}
    return {title: list(dict.fromkeys(names)) for title, names in found.items() if names}


def slug(title: str) -> str:
    return title.lower().replace(" ", "-")


def public(module: ModuleType) -> list[tuple[str, Any]]:
    """What a public module offers: its `__all__`, else the functions and classes that it defines."""
    names = getattr(module, "__all__", None) or [
        name for name, value in vars(module).items() if getattr(value, "__module__", "") == module.__name__
    ]
    found = [(name, getattr(module, name)) for name in names if not name.startswith("_")]
    return [(name, value) for name, value in found if not (inspect.isclass(value) and issubclass(value, Structure))]


def directive(kind: str, name: str, members: bool = False) -> str:
    return f"```{{eval-rst}}\n.. auto{kind}:: {name}\n{'   :members:' * members}\n```\n"


def module_text(name: str, module: ModuleType) -> str:
    """A module's docstring, and those of what it offers."""
    parts = [prose(inspect.getdoc(module) or "")]
    for own, value in public(module):
        if inspect.isclass(value) or inspect.isfunction(value):
            of = f"{value.__module__}.{value.__qualname__}"
            parts.append(directive("class" if inspect.isclass(value) else "function", of, inspect.isclass(value)))
        elif inspect.ismodule(value):
            parts.append(f"### `{name}.{own}`\n\n{module_text(own, value)}")
    return "\n\n".join(parts)


def names(source: layout.Source) -> list[str]:
    """A page for each group of public names; their page names."""
    made = []
    for title, of in groups().items():
        text = f"# {title}\n\nEach is imported as `from boresight import NAME`.\n"
        for name in of:
            value = getattr(boresight, name)
            text += f"\n## {name}\n\n"
            if name == "mechanics":
                text += prose(inspect.getdoc(value) or "") + "\n\n[Its functions](mechanics.md).\n"
            elif inspect.ismodule(value):
                text += module_text(name, value) + "\n"
            else:
                kind = "class" if inspect.isclass(value) else "function" if callable(value) else "data"
                text += directive(kind, f"boresight.{name}", kind == "class")
        made.append(f"reference/{slug(title)}")
        source.write(made[-1], text)
    return made


def commands(source: layout.Source) -> str:
    """Each command and subcommand by its own help; the page's name."""
    from typer.main import get_command

    from boresight.cli import app

    parts = ["# The command line\n"]

    def helped(one: Any, path: tuple[str, ...], parent: Any) -> None:
        with one.make_context(path[-1], [], parent=parent, resilient_parsing=True, terminal_width=90) as context:
            context.info_name = path[-1]
            parts.append(f"{'#' * min(len(path) + 1, 3)} {' '.join(path)}\n\n{fenced(one.get_help(context))}")
            for name in one.list_commands(context) if hasattr(one, "list_commands") else ():
                helped(one.get_command(context, name), (*path, name), context)

    helped(get_command(app), ("boresight",), None)
    source.write("reference/commands", "\n".join(parts))
    return "reference/commands"


# ---------------------------------------------------------------- gallery


@cache
def drawing() -> tuple[tuple[Path, ast.FunctionDef, str], ...]:
    """Every function that draws a figure: its file, itself and its text."""
    found = []
    for path in (path for room in ROOMS for path in sorted((ROOT / room).rglob("*.py"))):
        text = path.read_text(encoding="utf-8")
        if DRAWS.search(text):
            own = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.FunctionDef)]
            found += [(path, node, "\n".join(text.splitlines()[node.lineno - 1 : node.end_lineno])) for node in own]
    return tuple(one for one in found if DRAWS.search(one[2]))


def drawn_by(figure: str) -> tuple[Path, str, str] | None:
    """The function that names the figure, whole or but for what it puts in: its file, its name and its text."""
    found = [(max(fits(n, figure) for n in ast.walk(node)), path, node.name, text) for path, node, text in drawing()]
    literal, *best = max(found, key=lambda one: one[0])
    return tuple(best) if literal else None  # type: ignore[return-value]


def fits(node: ast.AST, figure: str) -> int:
    """How many characters of a figure's name a string has as they are, if all of it can be that name; else 0."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return len(figure) if Path(node.value).stem == figure else 0
    if not isinstance(node, ast.JoinedStr):
        return 0
    constant = [str(v.value) if isinstance(v, ast.Constant) else "" for v in node.values]
    pattern = "".join(re.escape(text) if text else ".+" for text in constant)
    literal = sum(map(len, constant))
    return literal if literal >= LITERAL and re.fullmatch(pattern, figure) else 0


def code_of(figure: str) -> tuple[Path, str, str] | None:
    """The function that draws it; of what is drawn by hand None."""
    if figure not in NAMED_BY_CALLER:
        return drawn_by(figure)
    path, _, name = NAMED_BY_CALLER[figure].partition(":")
    text = (ROOT / path).read_text(encoding="utf-8")
    (node,) = (n for n in ast.walk(ast.parse(text)) if isinstance(n, ast.FunctionDef) and n.name == name)
    return ROOT / path, name, "\n".join(text.splitlines()[node.lineno - 1 : node.end_lineno])


def shown_on(pages: list[Path]) -> dict[str, list[tuple[Path, str]]]:
    """Figure -> the pages that show it, with what they say of it."""
    found: dict[str, list[tuple[Path, str]]] = {}
    for page in pages:
        for sign, words, target in layout.LINK.findall(page.read_text(encoding="utf-8")):
            if sign:
                found.setdefault(Path(target).name, []).append((page, words))
    return found


def gallery(source: layout.Source) -> None:
    """Each figure on a card, and on a page of its own with the pages that show it and the code that draws it."""
    text = "# Gallery\n\nEach figure leads to the page that explains it and to the function that draws it.\n\n"
    cards = ["::::{grid} 1 2 2 3\n:gutter: 2\n"]
    for name, pages in sorted(shown_on([ROOT / "README.md", *layout.pages()]).items()):
        here, (_, words) = f"gallery/{Path(name).stem}", pages[0]
        picture = source.picture(here, ROOT / "docs" / "figures" / name)
        cards.append(
            f":::{{grid-item-card}} {words}\n:link: {here}\n:link-type: doc\n:img-bottom: figures/{name}\n:::\n"
        )
        on = ", ".join(source.link(here, page, title_at(page)) for page in dict.fromkeys(page for page, _ in pages))
        own = f"{layout.ORPHAN}# {words}\n\n![{words}]({picture})\n\nOn {on}; [all figures](../gallery.md).\n\n"
        if drawn := code_of(Path(name).stem):
            file, function, code = drawn
            own += f"Drawn by `{function}` of {source.link(here, file)}:\n\n{fenced(code, 'python')}"
        else:
            own += "Drawn by hand, as SVG.\n"
        source.write(here, own)
    source.write("gallery", text + "\n".join([*cards, "::::\n"]))


def title_at(page: Path) -> str:
    return layout.title_of(page.read_text(encoding="utf-8"))


# ---------------------------------------------------------------- for programs


def for_programs(source: layout.Source, about: str, kinds: Mapping[str, Sequence[str]]) -> None:
    """llms.txt lists the pages of the menu by kind, llms-full.txt has the text of docs/."""
    lines = [f"# Boresight\n\n> {about}"]
    for kind, names in kinds.items():
        lines.append(f"\n## {kind}\n")
        for name in names:
            title = layout.title_of((source.folder / f"{name}.md").read_text(encoding="utf-8"))
            lines.append(f"- [{title}]({name}.html)")
    (source.extra / "llms.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")
    whole = "\n\n".join(page.read_text(encoding="utf-8") for page in (ROOT / "README.md", *layout.pages()))
    (source.extra / "llms-full.txt").write_text(whole, encoding="utf-8")
