"""A user's own file: run it, and say in one line what stopped it, at which of its lines, and what was meant."""

import builtins
import importlib.util
import inspect
import re
import sys
import traceback
from importlib.metadata import packages_distributions
from pathlib import Path
from types import FrameType, ModuleType
from typing import Any, NoReturn

import boresight
from boresight import PUBLIC
from boresight.derive.where import line_of
from boresight.errors import BoresightError, did_you_mean


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
