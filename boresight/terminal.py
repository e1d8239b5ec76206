"""Output for a person: wrapped to the terminal, paged where it is longer than the screen, whole in a pipe."""

import os
import pydoc
import re
import shutil
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager

from rich.console import Console, RenderableType
from rich.markdown import Markdown
from rich.padding import Padding
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    SpinnerColumn,
    TaskProgressColumn,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)
from rich.table import Table


def page(*parts: RenderableType) -> None:
    """Print the parts one below the other; through the user's pager where they do not fit on the terminal."""
    out = Console(highlight=False, markup=False, emoji=False)
    with out.capture() as captured:
        out.print(*parts, sep="\n")
    page_text("".join(f"{line.rstrip()}\n" for line in captured.get().splitlines()))


def page_markdown(text: str) -> None:
    page(Markdown(text))


def page_text(text: str) -> None:
    """The same for lines that are wrapped already."""
    if not sys.stdout.isatty() or text.count("\n") < shutil.get_terminal_size().lines:
        sys.stdout.write(text)
    else:
        os.environ.setdefault("LESS", "-RS")  # colours as they are; a formula that is too wide is not folded
        pydoc.pager(text)


def marked(text: str) -> str:
    """On a terminal, what stands between › and ‹ in red and underlined as well; not where NO_COLOR is set."""
    if not sys.stdout.isatty() or os.environ.get("NO_COLOR"):
        return text
    return re.sub("›[^‹\n]*‹", lambda found: f"\x1b[4;31m{found.group()}\x1b[0m", text)


def columns() -> int:
    """Columns of the terminal, or of COLUMNS."""
    return shutil.get_terminal_size().columns


def table(*names: str, prose: str | None = None, right: tuple[str, ...] = ()) -> Table:
    """An empty table with these columns, none of which is ever cut: the column `prose` wraps, the others do not."""
    made = Table(box=None, padding=(0, 2, 0, 0), pad_edge=False)
    for name in names:
        made.add_column(name, no_wrap=name != prose, overflow="fold", justify="right" if name in right else "left")
    return made


def indented(part: RenderableType, columns: int = 2) -> Padding:
    return Padding(part, (0, 0, 0, columns))


def bullets(texts: Iterable[str]) -> Padding:
    rows = Table.grid(padding=(0, 1, 0, 0))
    for text in texts:
        rows.add_row("-", text)
    return indented(rows)


@contextmanager
def progress() -> Iterator[Callable[[int, int, str], None]]:
    """A bar on standard error that goes when the work is done.

    Yields a function of how many pieces are done, how many there are, and the name of the last one.
    """
    columns = (
        TextColumn("{task.description}", markup=False),
        BarColumn(12),
        MofNCompleteColumn(),
        TaskProgressColumn(),
    )
    err = Console(stderr=True)
    with Progress(*columns, TimeRemainingColumn(), console=err, transient=True, disable=not err.is_terminal) as bar:
        task = bar.add_task("", total=None)
        yield lambda done, total, text: bar.update(task, completed=done, total=total, description=text)


class Working:
    """Called with what is done now: behind a spinner on a terminal, else a line on standard error every EVERY_S."""

    EVERY_S = 5.0

    def __init__(self, err: Console, bar: Progress):
        self.err, self.bar, self.task = err, bar, bar.add_task("", total=None)
        self.printed = time.monotonic()

    def __call__(self, text: str) -> None:
        self.bar.update(self.task, description=text)
        if not self.err.is_terminal and time.monotonic() - self.printed >= self.EVERY_S:
            self.line(text)

    def line(self, text: str) -> None:
        """One that stays."""
        self.printed = time.monotonic()
        self.err.print(text, markup=False, highlight=False, soft_wrap=True)


@contextmanager
def working() -> Iterator[Working]:
    """The same where nobody knows how much there is: a function of what is done now, and the time that has passed."""
    columns = (SpinnerColumn(), TextColumn("{task.description}", markup=False), TimeElapsedColumn())
    err = Console(stderr=True)
    with Progress(*columns, console=err, transient=True, disable=not err.is_terminal) as bar:
        yield Working(err, bar)
