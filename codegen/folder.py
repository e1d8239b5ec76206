"""A generated folder as files: which units there are, what tests them, and a hash of what each is compiled from."""

import re
from collections.abc import Collection
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from typing import Any

from boresight.codegen.reach import WORD, Texts
from boresight.runtime.manifest import generated, read_manifest, sources

TEST = re.compile(r"^int (test_\w+)\(void\)$", re.MULTILINE)


@dataclass(frozen=True)
class Folder:
    """One generated folder: a model or a component.

    own: FILE.py:NAME of a model of one's own.  results: where its evidence is kept, if not where the folder says.
    """

    path: Path
    own: str = ""
    results: Path | None = None

    @cached_property
    def manifest(self) -> dict[str, Any]:
        return read_manifest(self.path)

    @property
    def name(self) -> str:
        return self.path.name

    @property
    def target(self) -> str:
        """As it is named to the commands."""
        return self.own or str(self.manifest["model"])

    @property
    def include(self) -> Path:
        return self.path / "include"

    def files(self, pattern: str) -> list[Path]:
        """Of the files that the manifest lists, those below this folder whose path matches."""
        return [self.path / name for name in sorted(self.manifest["files"]) if Path(name).match(pattern)]

    @property
    def sources(self) -> list[Path]:
        """All C, headers and self-tests, but for what tells the version alone."""
        return sources(self.path, self.manifest["files"])

    @cached_property
    def hash(self) -> str:
        """Of all of them, without their comments."""
        return self.texts.hash(self.sources)

    @cached_property
    def code(self) -> str:
        """Of its C and headers without the self-tests."""
        return Texts(self.code_files).hash(self.code_files)

    @property
    def code_files(self) -> list[Path]:
        return [path for path in self.sources if path.parent.name != "selftest"]

    @cached_property
    def texts(self) -> Texts:
        return Texts(self.sources)

    def filter_hash(self, harness: Path) -> str:
        """Of the filter, of all that it includes and calls, and of the C of evidence that calls it; of no self-test."""
        (header,) = (path for path in self.files("include/*_filter.h") if path.name != "boresight_filter.h")
        roots = {*self.files("src/*_filter.c"), header}
        return Texts(self.code_files).hash(roots, WORD.findall(harness.read_text()), [harness])

    @property
    def identity(self) -> list[Path]:
        """The C file that says what the folder is, which the self-test prints; it computes nothing and is no unit."""
        return self.files("src/*_identity.c")

    @cached_property
    def units(self) -> list["Source"]:
        return [Source(self, path) for path in self.files("src/*.c") if path not in self.identity]

    def chosen(self, names: Collection[str] | None) -> list["Source"]:
        """The units of these names, or all."""
        return [unit for unit in self.units if names is None or unit.name in names]


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
    def hashes(self) -> dict[str, str]:
        """Of the unit's files and of all that they reach: without and with its self-test, and with that and the words
        behind what its kernel gives."""
        kernel = [path for path in [self.path.with_name(f"{self.name}_kernel.h")] if path.is_file()]
        here, test = {self.path, *kernel}, {self.test} if self.test.is_file() else set()
        made = {"code": here, "tested": here | test, "named": here | test}
        texts = self.folder.texts
        return {of: texts.hash(roots, more=kernel if of == "named" else ()) for of, roots in made.items()}

    def hash(self, tested: bool) -> str:
        return self.hashes["tested" if tested else "code"]

    @property
    def elementary(self) -> bool:
        """Whether it holds the elementary functions that the model calls, which no list and no loop is."""
        return self.name.endswith("_math")

    @property
    def operations(self) -> int | None:
        """The printed instruction list's length."""
        return None if self.described is None else int(self.described["operations"])


@cache
def folders() -> tuple[Folder, ...]:
    """Every folder that is committed."""
    return tuple(Folder(path.parent) for path in sorted(generated().resolve().glob("*/manifest.json")))
