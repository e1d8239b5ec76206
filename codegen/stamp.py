"""What a generated folder is made from, as two hashes that stand in its manifest.

They are of syntax trees, so that a comment moves neither, and are found without importing what they are of.
"""

import ast
import atexit
import hashlib
import json
import os
import re
from collections.abc import Iterable
from contextlib import suppress
from functools import cache
from pathlib import Path

import boresight
from boresight import PUBLIC, BoresightError
from boresight.runtime.manifest import cache_folder

PACKAGE = Path(__file__).resolve().parent.parent  # of the layers: the checkout, or boresight/ where it is installed
FRONT = Path(boresight.__file__).parent  # where the public names are; in the checkout it has links to the layers
GENERATOR = tuple(PACKAGE / "codegen" / name for name in ("functions", "text", "templates"))
EXPORTED = PACKAGE / "codegen" / "templates" / "export"  # which no generated folder is made of
DERIVED = PACKAGE / "derive" / "linear.py"  # what a model leaves open is made by it, before any C
# What judges and shows a model, imported only when it is asked to, and words of errors: no C is made by it.
BESIDE = re.compile(r"boresight\.(errors|derive\.(ledger|pages|papers\.\w+\.paper))\b")


def made_from(model: Path | None, read: Iterable[Path] = ()) -> dict[str, str]:
    """Hashes of the generator and of a model's file, each with all of Boresight that it imports; a component has no
    model.  read: what else a file of one's own imports and reads."""
    inside = (path for folder in GENERATOR for path in folder.rglob("*") if EXPORTED not in path.parents)
    generator = {DERIVED, *(path for path in inside if path.suffix in (".py", ".j2"))}
    files = {"generator": reached(generator)}
    if model is not None:
        files["model"] = reached({model.resolve(), *(path.resolve() for path in read)})
    return {name: hashed(paths) for name, paths in files.items()}


def reached(start: set[Path], beside: re.Pattern[str] = BESIDE) -> set[Path]:
    """The files, and those of Boresight that they import, at any depth; not what is `beside`."""
    found, waiting = set(start), list(start)
    while waiting:
        path = waiting.pop()
        names = (name for name in imported(path) if not beside.match(name))
        new = {file for name in names for file in located(name, FRONT)} - found
        found |= new
        waiting += new
    return found


def imported(path: Path) -> tuple[str, ...]:
    """Dotted names of all that a Python file may import: `from a import b` names a and a.b."""
    return parsed(path.read_bytes(), path.name)[0] if path.suffix == ".py" else ()


@cache
def located(name: str, front: Path) -> tuple[Path, ...]:
    """The file of a module of Boresight and those of the packages that it lies in; none for other people's.

    front: the folder of the package boresight.
    """
    first, *parts = name.split(".")
    if first == "boresight" and parts and parts[0] in PUBLIC:
        _, *parts = PUBLIC[parts[0]].partition(":")[0].split(".")
    places = [front.joinpath(*parts[: k + 1]) for k in range(len(parts))] if first == "boresight" else []
    files = [file for place in places for file in (place.with_suffix(".py"), place / "__init__.py")]
    return tuple(file.resolve() for file in files if file.is_file())


def content_hash(path: Path) -> str:
    """Of a Python file's syntax tree, the same on every supported Python; of any other file its bytes'."""
    content = path.read_bytes()
    return parsed(content, path.name)[1] if path.suffix == ".py" else hashlib.sha256(content).hexdigest()


Tree = tuple[tuple[str, ...], str]


def parsed(content: bytes, name: str) -> Tree:
    """What the code may import, and the hash of its tree; known by the content from earlier runs."""
    key = hashlib.sha256(content).hexdigest()
    trees = known_trees()
    if key not in trees:
        trees[key] = of_tree(content, name)
    names, digest = trees[key]
    return tuple(names), digest


@cache
def known_trees() -> dict[str, Tree]:
    """By the hash of a content what `parsed` gives, from the cache folder; what is new is put there at the end."""
    place = cache_folder() / f"trees-{hashlib.sha256(Path(__file__).read_bytes()).hexdigest()[:16]}.json"
    trees: dict[str, Tree] = {}
    with suppress(OSError, ValueError):
        trees = json.loads(place.read_text(encoding="utf-8"))
    atexit.register(keep_trees, place, trees, len(trees))
    return trees


def keep_trees(place: Path, trees: dict[str, Tree], before: int) -> None:
    if len(trees) > before:
        with suppress(OSError):  # a folder that cannot be written costs time, no result
            place.parent.mkdir(parents=True, exist_ok=True)
            part = place.with_suffix(f".{os.getpid()}")
            part.write_text(json.dumps(trees), encoding="utf-8")
            part.replace(place)


def of_tree(content: bytes, name: str) -> Tree:
    try:
        tree = ast.parse(content)
    except SyntaxError as error:
        raise BoresightError(f"{name}, line {error.lineno}: {error.msg}") from None
    names: list[str] = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module:
            names += [node.module, *(f"{node.module}.{alias.name}" for alias in node.names)]
    return tuple(dict.fromkeys(names)), hashlib.sha256(repr(plain(tree)).encode()).hexdigest()


def plain(node: object) -> object:
    """A tree as tuples, without what is empty: versions of Python differ in the fields that they add."""
    if isinstance(node, ast.AST):
        fields = ((name, plain(value)) for name, value in ast.iter_fields(node))
        return (type(node).__name__, *((name, value) for name, value in fields if value not in (None, ())))
    if isinstance(node, list):
        return tuple(plain(item) for item in node)
    return repr(node) if node is not None else None


def hashed(paths: set[Path]) -> str:
    """Of the files' contents in an order that does not depend on where they lie."""
    return hashlib.sha256("\n".join(sorted(f"{path.name} {content_hash(path)}" for path in paths)).encode()).hexdigest()
