"""A model's file watched: after each save its equations, its mechanics and its C, in a process that is warm.  Of a
paper of one's own, its statuses.

The process that watches has SymPy, CasADi and what they need in memory, and nothing of Boresight that reads a model.
For each save it forks: the copy imports the user's files anew, as nothing has seen them yet, and ends when it has said
what it found.  The files are looked at by their times, some hundred of them in a millisecond, which needs no library
and works on every file system.
"""

import multiprocessing
import signal
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from multiprocessing.connection import Connection
from multiprocessing.synchronize import Lock
from pathlib import Path
from typing import Any

from boresight import BoresightError

EVERY = 0.1  # s between two looks at the files
Say = Callable[[str], None]


def watch(target: str, say: Say) -> None:
    """Look at the model now and after each save, until it is interrupted.

    say: takes the lines for the user.  Raises BoresightError where there is no such file or model.
    """
    from boresight.codegen.generate import known, model_names, source_of
    from boresight.derive.papers.files import FILES, PYTHON, STEPS, holds_paper

    files = {Path(target) / name for name in (*FILES, STEPS, PYTHON)} if holds_paper(target) else set()
    if not files:
        if ":" not in target:
            known(target, model_names())
        source = source_of(target)
        assert source is not None
        files = {source}
    warm()
    good: Any = ""
    writing = multiprocessing.get_context("fork").Lock()
    while True:
        seen = settled(files)
        with looking(target, good, writing) as answers:
            while times(files) == seen:
                if not answers.poll(EVERY):
                    continue
                try:
                    kind, value = answers.recv()
                except EOFError:  # it has said all
                    break
                if kind == "line":
                    say(value)
                elif kind == "good":
                    good = value
                else:
                    files |= value
                    seen = times(files) | seen
        while times(files) == seen:
            time.sleep(EVERY)


def warm() -> None:
    """Import what takes longest, and nothing that an edit of a model or of Boresight may change."""
    import casadi  # noqa: F401
    import flint  # noqa: F401
    import jinja2  # noqa: F401
    import mpmath  # noqa: F401
    import numpy  # noqa: F401
    import pint  # noqa: F401
    import sympy  # noqa: F401


def times(files: Iterable[Path]) -> dict[Path, tuple[int, int]]:
    """When each was written, and its size; what an editor is about to replace has none."""
    found = {}
    for path in files:
        try:
            status = path.stat()
            found[path] = status.st_mtime_ns, status.st_size
        except OSError:
            found[path] = 0, 0
    return found


def settled(files: set[Path]) -> dict[Path, tuple[int, int]]:
    """The times once nothing has changed for a moment: an editor may write a file in pieces."""
    seen = times(files)
    while True:
        time.sleep(EVERY)
        before, seen = seen, times(files)
        if seen == before:
            return seen


# ---------------------------------------------------------------- one look


@contextmanager
def looking(target: str, good: Any, writing: Lock) -> Iterator[Connection]:
    """What a forked process says that looks at the model.

    It is ended with the context, but never while it puts files in their places.
    """
    context = multiprocessing.get_context("fork")
    answers, sender = context.Pipe(duplex=False)
    process = context.Process(target=look, args=(target, good, writing, sender), daemon=True)
    process.start()
    sender.close()
    try:
        yield answers
    finally:
        free = writing.acquire(timeout=10)
        process.kill()
        process.join()
        if free:
            writing.release()
        answers.close()


def look(target: str, good: Any, writing: Lock, sender: Connection) -> None:
    """What the forked process does.  good: the equations, or the statuses, as they last stood, or nothing."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C ends the one that watches, which ends this one
    sys.dont_write_bytecode = True  # what is compiled is known by the second in which its source was written
    opened: set[str] = set()
    sys.addaudithook(lambda event, args: opened.add(args[0]) if event == "open" and isinstance(args[0], str) else None)

    def line(text: str) -> None:
        sender.send(("line", text))

    start = time.monotonic()
    try:
        from boresight.derive.papers.files import holds_paper

        if holds_paper(target):
            sender.send(("good", judged(Path(target), good or {}, line)))
            line(f"  {time.monotonic() - start:.1f} s")
            return
        try:
            from boresight.codegen.generate import load_model

            model = load_model(target)
        finally:
            sender.send(("files", watched(opened)))
        sender.send(("good", compared(model, good, line)))
        mechanics(model, line)
        line(f"  equations and mechanics in {time.monotonic() - start:.1f} s")
        generated(target, model, writing, line)
        line(f"  golden vectors and C in {time.monotonic() - start:.1f} s")
    except BoresightError as error:
        line(str(error))
    except Exception as error:
        line(f"{target}: {type(error).__name__}: {' '.join(str(error).split())}")


def judged(folder: Path, good: dict[str, Any], line: Say) -> dict[str, Any]:
    """Say which statuses of a paper are others than before, all at first; what they are now."""
    from boresight.codegen.generate import load_model
    from boresight.derive.papers.edits import lines, statuses

    now = statuses(folder, load_model)
    for text in [*lines(good, now)] or [f"{folder}: the same statuses"]:
        line(text)
    return now


def watched(opened: Iterable[str]) -> set[Path]:
    """What an edit may change: the sources that were imported and the files that were opened, but for libraries."""
    from boresight.codegen.user_file import own_files

    modules = (getattr(module, "__file__", None) for module in list(sys.modules.values()))
    return own_files(name for name in (*modules, *opened) if name)


def compared(model: Any, good: str, line: Say) -> str:
    """Say how the equations differ from the last good ones; what they are now."""
    from boresight.codegen.text.equations import equations_text, read_equations

    text = equations_text(model)
    if not good:
        line(f"{model.name}: {model.title}")
    elif text == good:
        line(f"{model.name}: the same equations")
    else:
        from boresight.codegen.difference import compared as difference
        from boresight.codegen.difference_page import differences_page
        from boresight.derive.pages.render import write

        old, new = (read_equations(one, model.name) for one in (good, text))
        line(write(differences_page([difference(model.name, "the last good state", old, new)]), "text").rstrip())
    return text


def mechanics(model: Any, line: Say) -> None:
    """Say what is not what exact mechanics does; what cannot be held against any is no finding."""
    from boresight.codegen.functions.units import units
    from boresight.codegen.mechanics import check_mechanics

    checks = check_mechanics(model, {unit.name: unit.reference for unit in units(model)})
    for check in checks:
        if check.ok is False:
            line(f"  {check.unit} against {check.against}: {check.entry}")
    held = [check.unit for check in checks if check.ok]
    if held:
        line(f"  held against exact mechanics: {', '.join(dict.fromkeys(held))}")


def generated(target: str, model: Any, writing: Lock, line: Say) -> None:
    from boresight.codegen.generate import default_folder, generate

    report = generate(target, default_folder(target, model), model=model, writing=writing)
    for change in report.changes:
        line(f"  {change}")
    line(f"  {len(report.written)} files written in {report.folder}" if report.written else "  no file changed")
