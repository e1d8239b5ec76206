"""What a user's own file reads while it is run: the modules of the user's own that it imports, and files."""

import os
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path
from typing import Any

from boresight.codegen.stamp import PACKAGE, imported
from boresight.errors import BoresightError

LAYERS = ("boresight", "derive", "codegen", "runtime", "analysis", "studies", "evidence")
READ: dict[Path, set[Path]] = {}  # by file that was run, what it imported and read, libraries apart


@contextmanager
def noting(path: Path) -> Iterator[None]:
    """Keep in READ which files are imported and opened for reading while a user's file is run.

    What it imports of the user's own is imported anew, so that it is what the files say now.
    """
    for name in imported_by(path, set()):
        del sys.modules[name]
    before, opened = set(sys.modules), listened()
    opened.clear()
    yield
    read = own_files({*imported_by(path, set(sys.modules) - before).values(), *opened}) - {path}
    ours = [PACKAGE / layer for layer in LAYERS]
    READ[path] = {
        file
        for file in read
        if not hidden(Path(os.path.relpath(file, path.parent))) and not any(map(file.is_relative_to, ours))
    }


def imported_by(path: Path, more: set[str]) -> dict[str, str]:
    """The user's own modules, with their files, that a file names, at any depth, or that are of one of more names."""
    files = {name: file for name, module in list(sys.modules.items())
             if (file := getattr(module, "__file__", None)) and "site-packages" not in file
             and name.split(".")[0] not in ("__main__", "boresight", path.stem)}  # fmt: skip
    tops, found, waiting = {name.split(".")[0] for name in more}, dict[str, str](), [path]
    while waiting:
        with suppress(BoresightError):  # of a file that Python cannot read, which is told where it is run
            tops |= {name.split(".")[0] for name in imported(waiting.pop())}
        new = {name: file for name, file in files.items()
               if name.split(".")[0] in tops and name not in found and own_files([file])}  # fmt: skip
        found |= new
        waiting += map(Path, new.values())
    return found


@cache
def listened() -> set[str]:
    """The names of files that are opened for reading from now on; it is emptied by who asks."""
    opened: set[str] = set()

    def hear(event: str, args: tuple[Any, ...]) -> None:
        if event == "open" and isinstance(args[0], str) and "r" in (args[1] or "r"):
            opened.add(args[0])

    sys.addaudithook(hear)
    return opened


def own_files(names: Iterable[str]) -> set[Path]:
    """Of these files those that may be edited: neither of a library nor compiled."""
    libraries = [Path(folder).resolve() for folder in {sys.prefix, sys.base_prefix, "/dev", "/proc", "/etc", "/usr"}]
    return {
        path
        for path in {Path(name).resolve() for name in names}
        if path.suffix != ".pyc" and path.is_file() and "site-packages" not in path.parts
        and not any(path.is_relative_to(folder) for folder in libraries)
    }  # fmt: skip


def hidden(path: Path) -> bool:
    """Whether it lies in a folder of a program, such as a cache."""
    return any(part.startswith(".") and part != ".." for part in path.parts)
