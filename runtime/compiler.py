"""The C compiler of this machine, and a cache of the shared libraries that it made."""

import ctypes
import functools
import hashlib
import os
import shlex
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from boresight import BoresightError
from boresight.runtime.manifest import cache_folder

FLAGS = ("-std=c99", "-O2", "-fPIC", "-ffp-contract=off", "-DBORESIGHT_ROWS", "-Wall", "-Wextra", "-Werror")
# gcc 12 makes sums and differences side by side into one fused instruction, whatever -ffp-contract says
NOT_FUSED = "-fno-tree-slp-vectorize"
LANES = ("-O3", "-fno-math-errno", "-Wno-psabi")  # of C over blocks of runs, which no function of another file is given
# gcc's own order follows the text, whose chains of operations wait for one another; clang always chooses the order
IN_ORDER = ("-fschedule-insns", "-fsched-pressure")
PRECISIONS: dict[str, tuple[str, ...]] = {"float": ("-DBORESIGHT_FLOAT",), "double": ()}


def compiler() -> list[str]:
    """The C compiler as a command: CC, or cc, or gcc."""
    command = shlex.split(os.environ.get("CC", "")) or ["cc" if shutil.which("cc") else "gcc"]
    if shutil.which(command[0]) is None:
        raise BoresightError(f"no C compiler: {command[0]!r} is not found; install gcc or clang, or set CC")
    return command


@functools.cache
def version(*command: str) -> str:
    return run([*command, "--version"])


@functools.cache
def processor(*command: str) -> tuple[tuple[str, ...], str]:
    """Flags by which a compiler uses all of this machine's processor, and the macros that say what this has."""
    for flags in (("-march=native",), ("-mcpu=native",), ()):
        try:
            return (*flags, NOT_FUSED), run([*command, *flags, "-dM", "-E", "-x", "c", os.devnull])
        except BoresightError:
            if not flags:
                raise
    raise AssertionError


@functools.cache
def in_lanes(width: int) -> tuple[str, ...]:
    """Flags of C over blocks of `width` runs."""
    order: tuple[str, ...] = IN_ORDER
    try:
        run([*compiler(), *order, "-E", "-x", "c", os.devnull])
    except BoresightError:
        order = ()
    return (*LANES, *order, f"-DBORESIGHT_LANES={width}")


def lanes() -> int:
    """How many doubles this machine's processor computes at a time."""
    macros = processor(*compiler())[1]
    return 8 if "__AVX512F__" in macros else 4 if "__AVX__" in macros else 2


def run(command: Iterable[object], cwd: Path | None = None) -> str:
    """Standard output of a command.  Raises BoresightError with the first error that it reports."""
    words = [str(word) for word in command]
    done = subprocess.run(words, cwd=cwd, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        report = (done.stderr or done.stdout).strip()
        first = next((line for line in report.splitlines() if "error:" in line), report[:200])
        raise BoresightError(f"{words[0]} failed: {first}")
    return done.stdout


def compile_sources(command: Sequence[object], sources: Mapping[Path, Sequence[object]], out: Path) -> dict[str, Path]:
    """The object of each source by its stem, in the folder `out`; as many at a time as there are processors.

    command: compiler and flags.  sources: C file -> further flags for it alone.
    """
    objects = {source.stem: out / f"{source.stem}.o" for source in sources}
    jobs = [[*command, *flags, "-c", source, "-o", objects[source.stem]] for source, flags in sources.items()]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(run, jobs))
    return objects


def shared_library(
    name: str, contents: str, sources: Mapping[Path, Sequence[object]], include: Path, flags: Sequence[str] = ()
) -> tuple[Path, str]:
    """Path of the library in the cache, compiled for this processor if it is not there, and the hash that it carries.

    contents: a text that differs if any source or header differs, such as their hashes.  sources: see
    `compile_sources`.  include: folder of the headers.
    flags: of all sources, beside FLAGS.
    """
    command = compiler()
    native, macros = processor(*command)
    key = hashlib.sha256()
    own = (str(flag) for each in sources.values() for flag in each)
    for part in (name, contents, *FLAGS, *native, *flags, *own, *command, version(*command), macros):
        key.update(part.encode() + b"\0")
    digest = key.hexdigest()
    target = cache_folder() / f"{name}-{digest[:32]}.so"
    if target.exists():
        return target, digest
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        aside = tempfile.TemporaryDirectory(dir=target.parent)
    except OSError as error:
        raise BoresightError(
            f"cannot write to {target.parent} ({error.strerror}); set BORESIGHT_CACHE to a folder that you can write to"
        ) from None
    with aside as folder:  # then into place: no other process ever sees half a library
        stamp, library = Path(folder) / "stamp.c", Path(folder) / "library.so"
        stamp.write_text(
            f'const char *boresight_build(void);\nconst char *boresight_build(void) {{ return "{digest}"; }}\n'
        )
        objects = compile_sources(
            [*command, *FLAGS, *native, *flags, "-I", include], {stamp: (), **sources}, Path(folder)
        )
        run([*command, "-shared", *objects.values(), "-lm", "-o", library])
        os.replace(library, target)
    return target, digest


def open_library(path: Path, digest: str) -> ctypes.PyDLL:
    """The library that `shared_library` made, if it carries its hash."""
    try:
        # PyDLL keeps the interpreter's lock: a call is shorter than letting go of it and taking it again.
        dll = ctypes.PyDLL(str(path))
        dll.boresight_build.restype = ctypes.c_char_p
        carried = dll.boresight_build().decode()
    except (OSError, AttributeError) as error:
        raise BoresightError(f"{path} is no library of Boresight ({error}); delete it and load again") from None
    if carried != digest:
        raise BoresightError(f"{path} was compiled from other sources than those on disk; delete it and load again")
    return dll
