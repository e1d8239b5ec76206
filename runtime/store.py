"""Final states of many runs, by blocks: files of a directory that are whole or not there."""

import hashlib
import json
import os
from collections.abc import Iterator
from pathlib import Path
from time import monotonic
from typing import Any

import numpy as np

from boresight.errors import BoresightError, need
from boresight.runtime.array import Array

BLOCK = 1024  # runs of a file; a power of two, so that each is a node of the tree of sums
SUM = b"sha256"  # in the metadata of a file
KEPT_S = 30.0  # what is flown waits no longer to be written


class Store:
    """Final states by block: in files of a directory, or in memory without one.

    A file is written aside and put in its place whole.  `held` counts the runs that are there.
    """

    def __init__(self, directory: str | Path | None, columns: list[str], identity: dict[str, Any]):
        self.columns = columns
        self.folder = None if directory is None else Path(directory)
        self.tables: dict[int, tuple[Array, Array]] = {}  # of a block the rows, and (BLOCK,) bool which are there
        self.whole: set[int] = set()  # blocks that are on the disk
        self.unwritten: set[int] = set()
        self.written = monotonic()
        self.held = 0
        if self.folder is None:
            return
        need("parquet")
        try:
            (self.folder / "runs").mkdir(parents=True, exist_ok=True)
            self._claim(self.folder, identity)
            for path in (self.folder / "runs").glob("block-*.parquet"):
                self._found(path)
        except OSError as error:
            raise BoresightError(f"cannot write to {self.folder} ({error.strerror}); choose another folder") from None

    def _claim(self, folder: Path, identity: dict[str, Any]) -> None:
        """The directory is this experiment's from now on; raises BoresightError where it is another's."""
        path = folder / "experiment.json"
        if not path.exists():
            if any((folder / "runs").iterdir()):
                raise BoresightError(f"{folder} holds runs and no experiment.json; choose another folder")
            _replace(path, (json.dumps(identity, indent=2) + "\n").encode())
            return
        try:
            there = json.loads(path.read_text())
        except ValueError:
            there = None
        if not isinstance(there, dict):
            raise BoresightError(f"{path} cannot be read; choose another folder")
        differing = [name for name, value in identity.items() if there.get(name) != value]
        if not differing:
            return
        name = differing[0]
        ours, theirs = identity[name], there.get(name)
        if isinstance(ours, dict) and isinstance(theirs, dict):
            inner = next(key for key in {**ours, **theirs} if ours.get(key) != theirs.get(key))
            name = inner if name == "settings" else f"{name}, {inner}"
            ours, theirs = ours.get(inner), theirs.get(inner)
        differs = f": {theirs!s:.40} there, {ours!s:.40} here"
        raise BoresightError(f"{folder} holds runs of another {name}{differs}; choose another folder")

    def _found(self, path: Path) -> None:
        number = path.stem.removeprefix("block-")
        if not number.isdecimal() or path != self._path(int(number)):  # its runs would be there twice
            raise BoresightError(f"{path} is not one of the files that are written here; move it away")
        block = int(number)
        rows, there = self._read(path, block)
        self.held += int(there.sum())
        if there.all():
            self.whole.add(block)
        else:
            self.tables[block] = rows, there

    def _read(self, path: Path, block: int) -> tuple[Array, Array]:
        import pyarrow
        import pyarrow.parquet as parquet

        rows, there = np.full((BLOCK, len(self.columns)), np.nan), np.zeros(BLOCK, bool)
        try:
            # from memory: a path that is a folder would be read as a data set
            source = pyarrow.BufferReader(path.read_bytes())
            table = parquet.read_table(source)
            number = table["run"].to_numpy() - block * BLOCK
            values = np.stack([table[name].to_numpy() for name in self.columns], axis=-1)
            if (number < 0).any() or (number >= BLOCK).any():  # NumPy would count a negative one from the end
                raise ValueError("it holds runs of another block")
            rows[number], there[number] = values, True
            differs = (table.schema.metadata or {}).get(SUM)  # which an older file has not
            if differs is not None and differs != checksum(rows, there):
                raise ValueError("its numbers are not those that were written")
        # of a damaged file pyarrow raises plain OSError as well
        except (OSError, LookupError, TypeError, ValueError, pyarrow.ArrowException) as error:
            reason = getattr(error, "strerror", None) or str(error).partition("\n")[0][:80]
            raise BoresightError(f"{path} cannot be read ({reason}); delete it, and its runs are flown again") from None
        return rows, there

    def _path(self, block: int) -> Path:
        assert self.folder is not None
        return self.folder / "runs" / f"block-{block:06d}.parquet"

    def block(self, block: int) -> tuple[Array, Array]:
        """Rows (BLOCK, columns) and which of them are there, (BLOCK,) bool."""
        if block in self.tables:
            return self.tables[block]
        if block in self.whole:
            return self._read(self._path(block), block)
        return np.full((BLOCK, len(self.columns)), np.nan), np.zeros(BLOCK, bool)

    def has(self, block: int) -> bool:
        """Whether all runs of a block are there."""
        return block in self.whole or (block in self.tables and bool(self.tables[block][1].all()))

    def missing(self, count: int, chunk: int) -> Iterator[range]:
        """Runs below `count` that are not there, in pieces of at most `chunk`, none across two blocks.

        Those that were given may be taken while it goes on.
        """
        none = np.zeros(BLOCK, bool)
        for block in range(-(-count // BLOCK)):
            if block in self.whole:
                continue
            first, there = block * BLOCK, self.tables[block][1] if block in self.tables else none
            run, end = 0, min(BLOCK, count - first)
            while run < end:
                if there[run]:
                    run += 1
                    continue
                stop = min(run + chunk, end)
                if (later := there[run:stop]).any():
                    stop = run + int(later.argmax())
                yield range(first + run, first + stop)
                run = stop

    def take(self, piece: range, rows: Array) -> None:
        """Final states of runs that were flown."""
        block = piece.start // BLOCK
        table, there = self.tables.setdefault(block, self.block(block))
        part = slice(piece.start % BLOCK, piece.start % BLOCK + len(piece))
        table[part], there[part] = rows, True
        self.held += len(piece)
        self.unwritten.add(block)
        if there.all() and self.folder is not None:
            self._write(block)
        elif monotonic() - self.written > KEPT_S:
            self.keep()

    def keep(self) -> None:
        """Write what is not written yet."""
        self.written = monotonic()
        for block in sorted(self.unwritten) if self.folder is not None else ():
            self._write(block)

    def _write(self, block: int) -> None:
        import pyarrow
        import pyarrow.parquet as parquet

        rows, there = self.tables[block]
        columns = {"run": block * BLOCK + np.flatnonzero(there)}
        columns |= {name: rows[there, i] for i, name in enumerate(self.columns)}
        sink = pyarrow.BufferOutputStream()
        table = pyarrow.table(columns, metadata={SUM: checksum(rows, there)})
        parquet.write_table(table, sink, compression="none", use_dictionary=False)
        try:
            _replace(self._path(block), sink.getvalue().to_pybytes())
        except OSError as error:
            raise BoresightError(f"{self._path(block)} cannot be written ({error.strerror})") from None
        self.unwritten.discard(block)
        if there.all():
            self.whole.add(block)
            del self.tables[block]


def checksum(rows: Array, there: Array) -> bytes:
    """Of the runs of a block that are there."""
    return hashlib.sha256(there.tobytes() + rows[there].tobytes()).hexdigest().encode()


def _replace(path: Path, content: bytes) -> None:
    """The file has its content whole, or is as it was."""
    aside = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        with open(aside, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        os.replace(aside, path)
    finally:
        aside.unlink(missing_ok=True)
