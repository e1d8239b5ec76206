"""What of a folder's C a unit reaches: all of its own files, and of all others what it names, at any depth.

The header of a model declares every function of it, and the self-test calls them all: a hash of whole files would move
for every unit when one is added.  Comments do not count, but for annotations (/*@ ... */); what ships has none.
"""

import hashlib
import re
from collections import defaultdict
from collections.abc import Collection, Iterable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

COMMENT = re.compile(r"/\*(?!@).*?\*/", re.DOTALL)  # but for annotations, which a prover reads
INCLUDE = re.compile(r"^#include .*$", re.MULTILINE)  # what is included is what is named
OF_CXX = re.compile(r"^#ifdef __cplusplus\n.*?^#endif\n", re.MULTILINE | re.DOTALL)
WORD = re.compile(r"[A-Za-z_]\w*")
BRACED = re.compile(r"\{[^{}]*\}")
DEFINED = re.compile(r"#define (\w+)")
CALLED = re.compile(r"(\w+)\s*\(")
LAST = re.compile(r"(\w+)\s*(?:\[[^\]]*\]\s*)*(?:=.*)?;$", re.DOTALL)
CHOSEN = "#define BORESIGHT_UD ", "boresight_precision.h"  # by an export: what hangs on it has another text there
HIDDEN = ("static ", "BS_INSIDE ", "#", "typedef ", "enum ")  # how a line of a C file begins that names nothing outside


@dataclass(frozen=True, eq=False)
class Piece:
    """A declaration, a definition or a macro, without comments.

    names: what it declares; nothing of a condition of the preprocessor, which belongs to all of its file.
    public: whether other files may mean it.
    """

    path: Path
    text: str
    names: frozenset[str]
    public: bool

    @cached_property
    def words(self) -> frozenset[str]:
        return frozenset(WORD.findall(self.text))


def pieces(path: Path) -> list[Piece]:
    """A generated C file or header split at its margin, what is for C++ alone left out."""
    text = COMMENT.sub(" ", INCLUDE.sub("", OF_CXX.sub("", path.read_text())))
    found: list[Piece] = []
    lines: list[str] = []
    left_open = 0  # braces
    for line in map(str.rstrip, text.splitlines()):
        if not line:
            continue
        lines.append(line)
        left_open += line.count("{") - line.count("}")
        if lines[0].startswith("#"):
            ended = not line.endswith("\\")
        else:  # conditions of the preprocessor may leave braces open, which one at the margin closes
            ended = line.startswith("}") or (line.endswith((";", "}")) and not left_open)
        if ended:
            whole = "\n".join(lines)
            found.append(Piece(path, " ".join(whole.split()), declared(whole), is_public(path, whole)))
            lines, left_open = [], 0
    return found


def is_public(path: Path, text: str) -> bool:
    """Whether other files may mean a piece."""
    define, header = CHOSEN
    if path.name == header and text.startswith(define):
        return False
    return path.suffix == ".h" or not text.startswith(HIDDEN)


def declared(text: str) -> frozenset[str]:
    """The names that a piece gives."""
    if text.startswith("#"):
        return frozenset(DEFINED.findall(text)[:1])
    outer = text
    while BRACED.search(outer):
        outer = BRACED.sub(" ", outer)
    outer = outer.split("__attribute__")[0].rstrip() + ";"
    named = None if text.startswith("typedef") else CALLED.search(outer)
    names = {(named or LAST.search(outer.replace(";;", ";")) or [""] * 2)[1]}
    if "enum" in outer.split("(")[0].split():
        names |= set(WORD.findall(BRACED.findall(text)[0]))
    return frozenset(names - {""})


class Texts:
    """The C files of a folder, those apart that tell the version alone."""

    def __init__(self, paths: Iterable[Path]):
        self.paths = tuple(paths)
        self.meant: dict[Piece, set[Piece]] = {}

    @cached_property
    def by_path(self) -> dict[Path, list[Piece]]:
        return {path: pieces(path) for path in self.paths if "_identity." not in path.name}

    @cached_property
    def in_order(self) -> list[tuple[Piece, bytes]]:
        """Each piece, and what a hash that reaches it is of."""
        ordered = (one for path in sorted(self.by_path) for one in self.by_path[path])
        return [(one, f"{one.path.name} {one.text}\0".encode()) for one in ordered]

    @cached_property
    def by_name(self) -> dict[str, list[Piece]]:
        found = defaultdict(list)
        for of_one in self.by_path.values():
            for one in of_one:
                for name in one.names if one.public else ():
                    found[name].append(one)
        return found

    def means(self, one: Piece) -> set[Piece]:
        """The pieces that a piece names, and the conditions of its file."""
        if one not in self.meant:
            named = (other for word in one.words for other in self.by_name.get(word, ()))
            own = (other for other in self.by_path[one.path] if not other.names or other.names & one.words)
            self.meant[one] = {*named, *own}
        return self.meant[one]

    def reached(self, roots: Collection[Path], words: Iterable[str] = ()) -> set[Piece]:
        """The pieces of the roots, and those that they or these words name, at any depth."""
        found = {one for path in roots for one in self.by_path.get(path, ())}
        found |= {one for word in words for one in self.by_name.get(word, ())}
        waiting = list(found)
        while waiting:
            new = self.means(waiting.pop()) - found
            found |= new
            waiting += new
        return found

    def hash(self, roots: Collection[Path], words: Iterable[str] = (), more: Iterable[Path] = ()) -> str:
        """Of the roots and of what they and these words reach, without comments; and of more files as they stand."""
        key = hashlib.sha256()
        for path in sorted(roots):
            key.update("\0".join([path.name, *INCLUDE.findall(path.read_text())]).encode() + b"\0")
        for path in more:
            key.update(path.name.encode() + b"\0" + path.read_bytes() + b"\0")
        found = self.reached(roots, words)
        key.update(b"".join(text for one, text in self.in_order if one in found))
        return key.hexdigest()
