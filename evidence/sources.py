"""What evidence is made of beside the generated folders, and a hash of what each result depends on."""

import hashlib
import json
import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from boresight.codegen.folder import Folder, folders
from boresight.codegen.reach import Texts
from boresight.codegen.stamp import GENERATOR, PACKAGE, hashed, reached
from boresight.derive.papers import DERIVATIONS, PAPERS
from boresight.derive.papers.displays import displays

HERE = Path(__file__).resolve().parent
OWN = re.compile(r"boresight\.derive\.papers\.own")  # what reads a paper of one's own
MATCHED = {"velocity", "dcm", "euler"}  # the measurements of the transfer alignment


@dataclass(frozen=True)
class Derivations:
    """One paper, or one derivation of our own: its equations, their steps, and how they are shown."""

    name: str

    def reached(self, *judges: str) -> set[Path]:
        """Its modules with what they and the reader of its files import of derive, and the modules of evidence that
        judge it with what those import."""
        own = {HERE / f"{name}.py" for name in judges}
        begin = {path.resolve() for path in (*self.place.glob("*.py"), self.place.parent / "built_in.py", *own)}
        return {path for path in reached(begin, OWN) if path.is_relative_to(PACKAGE / "derive")} | own

    @property
    def place(self) -> Path:
        return PACKAGE / "derive" / "papers" / self.name.replace("-", "_")

    @property
    def written(self) -> str:
        """What its files say: no comment, and not the maps to the models that make C from it, which no judge reads."""
        tables = [tomllib.loads(path.read_bytes().decode()) for path in sorted(self.place.glob("*.toml"))]
        prints = [displays(path) for path in self.place.glob("*.tex")]
        printed = [(one.number, one.latex, one.source) for shown in prints for one in shown]
        return json.dumps([[{**table, "model": None} for table in tables], printed])

    def hash(self, *judges: str) -> str:
        return hashlib.sha256(f"{hashed(self.reached(*judges))}\n{self.written}".encode()).hexdigest()


@dataclass(frozen=True)
class CrossChecks:
    """The same numbers by Boresight and by its peers."""

    name: str = "cross-checks"

    @property
    def place(self) -> Path:
        return HERE / "crossed"

    def hashes(self, module: Path, checks: Mapping[str, tuple[str, ...]]) -> dict[str, str]:
        """Of each check: its module with what all of them share, and what our answer is of, generated folders by their
        C and modules by their syntax trees."""
        by_name = {folder.name: folder for folder in folders()}
        shared = {module, *(self.place / f"{name}.py" for name in ("judge", "exact", "flights"))}
        found = {}
        for check, of in checks.items():
            parts = [hashed(shared | {PACKAGE / name for name in of if name not in by_name})]
            parts += [by_name[name].code for name in of if name in by_name]
            found[check] = hashlib.sha256("\n".join(parts).encode()).hexdigest()
        return found


@dataclass(frozen=True)
class Examples:
    """The examples: models, and the scripts that fly them."""

    name: str = "examples"

    @property
    def place(self) -> Path:
        return PACKAGE / "examples"

    def hash(self, example: str) -> str:
        """Of one example, of all that generates and flies it, and of what judges it."""
        return generating(self.place / f"{example}.py", self.place / f"fly_{example}.py", HERE / "examples.py")


@dataclass(frozen=True)
class Drawn:
    """Models drawn by a number, and the self-test that is printed of each."""

    name: str = "drawn"

    @property
    def hash(self) -> str:
        """Of all that draws and generates them: the templates and their views, and what reads a model."""
        return generating(HERE / "drawn.py")


@dataclass(frozen=True)
class Flights:
    """The live loop of the transfer alignment in every condition of tests/live."""

    name: str = "flights"

    @property
    def hash(self) -> str:
        """Of what it is tried by with what that imports, and of the C of its models."""
        tried = (path for path in (PACKAGE / "tests" / "live").glob("*.py") if not path.name.startswith("test_"))
        python = reached({path.resolve() for path in (HERE / "flights" / "campaign.py", *tried)})
        models = [folder for folder in folders() if folder.name.startswith("velocity_attitude")]
        return hashlib.sha256("\n".join([hashed(python), *map(matched, models)]).encode()).hexdigest()


def generating(*more: Path) -> str:
    """Hash of all that generates C, of these modules, and of what they import."""
    begin = {path for folder in GENERATOR for path in folder.rglob("*") if path.suffix in (".py", ".j2")}
    return hashed(reached({path.resolve() for path in begin.union(more)}))


def matched(folder: Folder) -> str:
    """Hash of the C of a model that the alignment calls: all of it but for measurements that it does not take."""
    others = "|".join(folder.manifest["measurements"].keys() - MATCHED)
    other = re.compile(rf"\w+?_(filter_measure_)?({others})(_\w+)?" if others else r"(?!)")
    code = Texts(path for path in folder.sources if path.parent.name != "selftest")
    return code.hash((), [name for name in code.by_name if not other.fullmatch(name)])


def derivations() -> list[Derivations]:
    return [Derivations(name) for name in (*PAPERS, *DERIVATIONS)]
