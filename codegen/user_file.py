"""A user's own file: run it, and say in one line what stopped it, at which of its lines, and what was meant."""

import builtins
import importlib.util
import inspect
import os
import re
import sys
import traceback
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from functools import cache
from importlib.metadata import packages_distributions
from pathlib import Path
from types import FrameType, ModuleType
from typing import Any, NoReturn

import boresight
from boresight import PUBLIC
from boresight.codegen.stamp import PACKAGE, imported
from boresight.derive.where import line_of
from boresight.errors import BoresightError, did_you_mean

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


def run(path: Path) -> ModuleType:
    """The module that the file makes.  Raises BoresightError with the line of the file that fails."""
    spec = importlib.util.spec_from_file_location(path.stem, path)
    if spec is None or spec.loader is None:
        raise BoresightError(f"{path} is no Python file; give FILE.py:NAME")
    module = importlib.util.module_from_spec(spec)
    sys.path.insert(0, str(path.parent))
    sys.modules[path.stem] = module
    try:
        spec.loader.exec_module(module)
    except BoresightError:
        raise
    except (Exception, SystemExit) as error:
        explain(error, path)
    finally:
        if str(path.parent) in sys.path:  # no longer the first, where the file has put others in front
            sys.path.remove(str(path.parent))
    return module


def explain(error: BaseException, path: Path) -> NoReturn:
    """Raise BoresightError in the place of what a user's file raised: its line, the error, and the remedy if known."""
    if isinstance(error, SyntaxError):
        at = line_of(error.filename or str(path), error.lineno)
        raise BoresightError(f"{at}: {error.msg}; correct the line: Python cannot read it") from error
    frame, line = users_frame(error, path)
    text = " ".join(f"{type(error).__name__}: {error}".split())
    text = re.sub(r" \(/\S+\)$", "", text)  # the file of a module that lacks a name
    where = line_of(frame.f_code.co_filename, line) if frame else line_of(str(path), 1)
    raise BoresightError(f"{where}: {text}{remedy(error, frame, path)}") from error


def users_frame(error: BaseException, path: Path) -> tuple[FrameType | None, int]:
    """The innermost frame of code that is the user's: of the file or of one beside it."""
    frames = list(traceback.walk_tb(error.__traceback__))
    own = [pair for pair in frames if Path(pair[0].f_code.co_filename).parent == path.parent]
    return own[-1] if own else (None, 0)


def remedy(error: BaseException, frame: FrameType | None, path: Path) -> str:
    """What to do, beginning with what joins it to the error's own words; nothing where those say it all."""
    text = str(error)
    if isinstance(error, NameError):
        known = [*vars(builtins), *(frame.f_globals if frame else ()), *(frame.f_locals if frame else ())]
        return did_you_mean(error.name or "", known) or "; define or import it above this line"
    if isinstance(error, ModuleNotFoundError):
        return module_meant(error.name or "")
    if isinstance(error, ImportError):
        found = re.match(r"cannot import name '(\w+)' from (?:partially initialized module )?'([\w.]+)'", text)
        if found and found[2] == path.stem:
            return f"; this file has the name of the module {path.stem}: rename it"
        return name_meant(*found.groups()) if found else ""
    if isinstance(error, AttributeError) and error.obj is not None:
        return did_you_mean(error.name or "", dir(error.obj))
    called = re.match(r"([\w.]+)\(\) got an unexpected keyword argument '(\w+)'", text)
    if called and frame:
        return keyword_meant(called[1], called[2], frame)
    if isinstance(error, TypeError) and re.search("ufunc|[Cc]annot convert expression to float", text):
        return "; numpy and math take numbers: import the function from sympy"
    if isinstance(error, TypeError) and "is not callable" in text:
        return "; a comma or an operator may be missing before the bracket"
    if isinstance(error, TypeError) and "cannot determine truth value" in text:
        return "; a symbol has no value yet: write Piecewise in the place of if, Max or Min for larger and smaller"
    if isinstance(error, RecursionError):
        return "; a function calls itself without end"
    return ""


def module_meant(name: str) -> str:
    """For a module that is not found: the public name that was meant, or an installed module like it."""
    first, last = name.split(".")[0], name.split(".")[-1]
    if last in PUBLIC and first in ("boresight", last):
        return f" (did you mean 'from boresight import {last}'?)"
    if first == "boresight":
        return "; its names are imported from boresight itself, as 'from boresight import Model, variable'"
    return (
        did_you_mean(name, {*sys.stdlib_module_names, *packages_distributions()}) or "; install it, or remove the line"
    )


def name_meant(name: str, module: str) -> str:
    """For a name that a module does not have: one like it, or where Boresight has it."""
    close = did_you_mean(name, dir(sys.modules[module])) if module in sys.modules else ""
    if close or not module.startswith("boresight"):
        return close
    if name in PUBLIC:
        return f"; write 'from boresight import {name}'"
    for place in ("mechanics", "variables", "models"):
        if hasattr(getattr(boresight, place), name):
            return f"; it is in {place}: write 'from boresight import {place}'"
    return ""


def keyword_meant(function: str, keyword: str, frame: FrameType) -> str:
    """For a keyword that a function does not take: one that it takes."""
    called: Any = None
    for name in function.removesuffix(".__init__").split("."):
        scope = {**frame.f_globals, **frame.f_locals} if called is None else vars(called)
        called = scope.get(name)
        if called is None:
            return ""
    try:
        known = list(inspect.signature(called).parameters)
    except (TypeError, ValueError):
        return ""
    return did_you_mean(keyword, known) or f"; it takes {', '.join(known)}"
