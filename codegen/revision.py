"""What git holds of a file at a revision."""

import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from boresight import BoresightError
from boresight.derive.papers.files import FILES, PYTHON, STEPS


def committed(path: Path, revision: str) -> str:
    """The text of a file as the revision has it.  Raises BoresightError where there is none."""
    home = top(path)
    commit = named(home, revision)
    inside = path.resolve().relative_to(home)
    done = git(home, "show", f"{commit}:{inside.as_posix()}")
    if done.returncode:
        raise BoresightError(
            f"{revision} has no {inside.as_posix()}: it is older than such files, or they were not committed; "
            "choose another revision with --against"
        )
    return done.stdout


def top(path: Path) -> Path:
    """The folder of the repository that the path lies in."""
    folder = next(parent for parent in path.resolve().parents if parent.is_dir())
    done = git(folder, "rev-parse", "--show-toplevel")
    if done.returncode:
        raise BoresightError(f"{folder} lies in no git repository; name a generated folder with --against")
    return Path(done.stdout.rstrip("\n"))


def named(home: Path, revision: str) -> str:
    """The commit that a revision names."""
    done = git(home, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{commit}}")
    if done.returncode:
        raise BoresightError(f"there is no folder {revision!r}, and {home} has no such revision; choose another")
    return done.stdout.strip()


@contextmanager
def worktree(home: Path, revision: str) -> Iterator[Path]:
    """A folder with all files of the revision, which is removed again."""
    with tempfile.TemporaryDirectory(prefix="boresight-") as aside:
        folder = Path(aside) / "tree"
        done = git(home, "worktree", "add", "--detach", "--quiet", str(folder), named(home, revision))
        if done.returncode:
            raise BoresightError(f"git cannot lay out {revision}: {done.stderr.strip().splitlines()[-1]}")
        try:
            yield folder
        finally:
            git(home, "worktree", "remove", "--force", str(folder))


@contextmanager
def paper_as_of(folder: Path, against: str) -> Iterator[Path]:
    """The folder of a paper of one's own as a revision of git has it, or another folder."""
    if Path(against).is_dir():
        yield Path(against)
        return
    with tempfile.TemporaryDirectory(prefix="boresight-") as aside:
        if git(folder, "rev-parse", "--show-toplevel").returncode:
            raise BoresightError(f"{folder} lies in no git repository; name another folder of a paper with --against")
        for name in FILES:
            (Path(aside) / name).write_text(committed(folder / name, against), encoding="utf-8")
        for name in (STEPS, PYTHON):
            with suppress(BoresightError):  # there may have been none
                (Path(aside) / name).write_text(committed(folder / name, against), encoding="utf-8")
        yield Path(aside)


def git(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    try:
        return subprocess.run(
            ["git", *words], cwd=folder, capture_output=True, text=True, encoding="utf-8", check=False
        )
    except FileNotFoundError:
        raise BoresightError("git is not installed; name another folder with --against") from None
