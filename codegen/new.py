"""A model of one's own to begin with: an example, under a name of one's own, and the script that flies it."""

import re
import sys
from importlib.machinery import PathFinder
from pathlib import Path

from boresight import BoresightError
from boresight.codegen.stamp import PACKAGE
from boresight.derive.papers import DERIVATIONS, PAPERS
from boresight.derive.papers.files import FILES
from boresight.runtime.manifest import built_in

# The example that each kind begins as.
KINDS = {"total-state": "pendulum", "error-state": "vertical", "ins": "gnss-ins"}
PAPER = "paper"  # the kind that is a folder: the letters and the equations of a paper
NAME = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")


def new(name: str, kind: str, folder: Path) -> list[Path]:
    """Write NAME.py and fly_NAME.py into the folder, or of a paper the files of the folder NAME; their paths.

    Raises BoresightError on a name that cannot be one, on files that exist, on a folder that cannot be written to.
    """
    if kind not in (*KINDS, PAPER):
        raise BoresightError(f"there is no kind {kind!r}; choose {', '.join((*KINDS, PAPER))}")
    if not NAME.fullmatch(name):
        raise BoresightError(f"{name!r} cannot name a model; join lower-case words by '-', as in my-filter")
    if kind == PAPER:
        return new_paper(name, folder)
    if name in built_in():
        raise BoresightError(f"{name} is a built-in model; choose another name")
    snake = name.replace("-", "_")
    if snake in sys.stdlib_module_names or PathFinder.find_spec(snake):
        raise BoresightError(f"{snake}.py would hide Python's own module {snake}; choose another name")
    example = KINDS[kind].replace("-", "_")
    texts = {
        folder / f"{prefix}{snake}.py": renamed(
            (PACKAGE / "examples" / f"{prefix}{example}.py").read_text(), kind, name
        )
        for prefix in ("", "fly_")
    }
    return written(folder, texts)


def new_paper(name: str, folder: Path) -> list[Path]:
    """The files of a paper to begin with: two equations, one of them with a slip that is named as planted."""
    if name in (*PAPERS, *DERIVATIONS):
        raise BoresightError(f"{name} is a paper that comes with Boresight; choose another name")
    first = PACKAGE / "examples" / "papers" / "first"
    return written(folder / name, {folder / name / file: (first / file).read_text("utf-8") for file in FILES})


def written(folder: Path, texts: dict[Path, str]) -> list[Path]:
    for path in texts:
        if path.exists():
            raise BoresightError(f"{path} exists; choose another name, or another folder with -o")
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for path, text in texts.items():
            path.write_text(text, "utf-8")
    except OSError as error:
        raise BoresightError(f"cannot write to {folder} ({error.strerror}); choose another folder with -o") from None
    return list(texts)


def renamed(text: str, kind: str, name: str) -> str:
    """The example's text with the new name in the place of its own: of the model, its constant, files and C prefix."""
    old, old_snake, snake = KINDS[kind], KINDS[kind].replace("-", "_"), name.replace("-", "_")
    words = [
        (rf'name="{old}"', f'name="{name}"'),
        (r'c_prefix="\w+"', f'c_prefix="{prefix(name)}"'),
        (rf"\b{old_snake.upper()}\b", snake.upper()),
        (rf"\b(fly_)?{old_snake}(?=\.(py|png)\b)", rf"\g<1>{snake}"),
    ]
    for pattern, word in words:
        text = re.sub(pattern, word, text)
    return text


def prefix(name: str) -> str:
    """The first letters of its words, or of a single word its first two, which no other name of C begins with."""
    words = name.split("-")
    letters = "".join(word[0] for word in words) if len(words) > 1 else name[:2]
    return letters if letters != "bs" else "bsf"
