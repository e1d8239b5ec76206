"""The generated C as files: which units there are, what tests them, and a hash of what each is compiled from."""

import hashlib
import re
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from boresight.codegen.stamp import GENERATOR, reached
from boresight.derive.papers import DERIVATIONS, PAPERS
from boresight.runtime.manifest import generated, read_manifest, sources

TEST = re.compile(r"^int (test_\w+)\(void\)$", re.MULTILINE)
INCLUDED = re.compile(r'^#include "(\w+\.h)"', re.MULTILINE)


@dataclass(frozen=True)
class Folder:
    """One generated folder: a model or a component."""

    path: Path

    @cached_property
    def manifest(self) -> dict[str, Any]:
        return read_manifest(self.path)

    @property
    def name(self) -> str:
        return self.path.name

    @property
    def include(self) -> Path:
        return self.path / "include"

    def files(self, pattern: str) -> list[Path]:
        """Of the files that the manifest lists, those below this folder whose path matches."""
        return [self.path / name for name in sorted(self.manifest["files"]) if Path(name).match(pattern)]

    @property
    def sources(self) -> list[Path]:
        """What its results depend on."""
        return sources(self.path, self.manifest["files"])

    @property
    def identity(self) -> list[Path]:
        """The C file that says what the folder is, which the self-test prints; it computes nothing and is no unit."""
        return self.files("src/*_identity.c")

    @cached_property
    def units(self) -> list["Source"]:
        return [Source(self, path) for path in self.files("src/*.c") if path not in self.identity]


@dataclass(frozen=True)
class Derivations:
    """One paper, or one derivation of our own: its equations, their steps, and how they are shown."""

    name: str

    @property
    def sources(self) -> list[Path]:
        """What its results depend on: all that derives and shows, and what judges it."""
        root = Path(__file__).resolve().parent
        judges = (root / f"{name}.py" for name in ("formula_tokens", "read_back", "spoilt", "steps"))
        return [*sorted((root.parent / "derive").rglob("*.py")), *judges]


@dataclass(frozen=True)
class Examples:
    """The examples: models, and the scripts that fly them."""

    name: str = "examples"

    @property
    def place(self) -> Path:
        return Path(__file__).resolve().parent.parent / "examples"

    @property
    def sources(self) -> list[Path]:
        """What their results depend on: they, all that generates and flies them, and what judges them."""
        begin = {*self.place.glob("*.py"), Path(__file__).with_name("examples.py")}
        begin |= {path for folder in GENERATOR for path in folder.rglob("*") if path.suffix in (".py", ".j2")}
        return sorted(reached(begin))


@dataclass(frozen=True)
class Flights:
    """The transfer alignment in every condition that it was tried in."""

    name: str = "flights"

    @property
    def sources(self) -> list[Path]:
        """What their results depend on: the filter, what it is tried by, and the C of its models."""
        begin = set(Path(__file__).with_name("flights").glob("*.py"))
        models = [
            path
            for folder in folders()
            if folder.name.startswith("velocity_attitude")
            for path in folder.files("src/*.c")
        ]
        return sorted(reached(begin)) + sorted(models)


@dataclass(frozen=True)
class Source:
    """One unit: a C file of src/, with the headers that it includes."""

    folder: Folder
    path: Path

    @property
    def name(self) -> str:
        return self.path.stem

    @cached_property
    def described(self) -> dict[str, Any] | None:
        """What the manifest says of a printed unit; None for loops, whose structs it does not list."""
        for name, unit in self.folder.manifest["units"].items():
            if unit["file"] == self.name and "structs" in unit:
                return {"name": name, **unit}
        return None

    @cached_property
    def test(self) -> Path:
        """The shipped test of this unit."""
        return self.folder.path / "selftest" / f"test_{self.name}.c"

    @cached_property
    def test_function(self) -> str:
        (name,) = TEST.findall(self.test.read_text())
        return str(name)

    @cached_property
    def text(self) -> list[Path]:
        """The C file and every header of the folder that it includes, directly or not; not the names of identity."""
        found = [self.path]
        for path in found:
            for name in INCLUDED.findall(path.read_text()):
                for place in (self.path.parent / name, self.folder.include / name):
                    if place.is_file() and place not in found and not name.endswith("_identity.h"):
                        found.append(place)
        return found

    def hash(self, *more: Path) -> str:
        """Of the unit's text, and of further files."""
        key = hashlib.sha256()
        for path in (*self.text, *more):
            key.update(path.name.encode() + b"\0" + path.read_bytes() + b"\0")
        return key.hexdigest()

    @property
    def elementary(self) -> bool:
        """Whether it holds the elementary functions that the model calls, which no list and no loop is."""
        return self.name.endswith("_math")

    @property
    def operations(self) -> int | None:
        """The printed instruction list's length."""
        return None if self.described is None else int(self.described["operations"])


def derivations() -> list[Derivations]:
    return [Derivations(name) for name in (*PAPERS, *DERIVATIONS)]


def folders() -> list[Folder]:
    """Every folder that is committed."""
    return [Folder(path.parent) for path in sorted(generated().resolve().glob("*/manifest.json"))]
