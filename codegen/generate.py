"""From a model's name to its generated folder: what changed is written, and nothing else.

SymPy and CasADi are imported only once the hashes of the sources say that something has to be made anew.
"""

import hashlib
import importlib
import importlib.metadata
import importlib.util
import json
import os
import sys
import sysconfig
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from boresight import BoresightError
from boresight.codegen.kernels import KERNELS, make_kernel
from boresight.runtime.manifest import GENERATED, cache_folder

VERSIONED = ("casadi", "sympy")  # what the bytes of the output depend on, beside Boresight itself
PACKAGE = Path(__file__).parent.parent
MODELS = PACKAGE / "derive" / "models"


@dataclass(frozen=True)
class Change:
    """A function that was added, changed or removed, with its operation counts before and after (None: not there).

    The loops of a kernel have lines, not operations.
    """

    name: str
    before: int | None
    after: int | None
    counted: str = "operations"

    def __str__(self) -> str:
        if self.before is None:
            return f"{self.name}: new, {self.after} {self.counted}"
        if self.after is None:
            return f"{self.name}: removed, {self.before} {self.counted}"
        return f"{self.name}: {self.before} -> {self.after} {self.counted} ({self.after - self.before:+d})"


@dataclass(frozen=True)
class Report:
    """What generating one model did, or with `check` would do."""

    model: str
    folder: Path
    changes: tuple[Change, ...]
    written: tuple[str, ...]  # files that were, or would be, written or removed
    up_to_date: bool  # known from hashes alone
    comparable: bool = True  # with check: the versions of SymPy and CasADi are those of the committed files


def model_names() -> list[str]:
    """The built-in models: each is a file that defines a function of the file's own name."""
    files = [path for path in MODELS.glob("*.py") if f"\ndef {path.stem}(" in path.read_text()]
    return sorted(path.stem.replace("_", "-") for path in files)


def target_names() -> list[str]:
    """Everything that is generated with Boresight: the models and the kernels."""
    return sorted([*model_names(), *KERNELS])


def versions() -> dict[str, str]:
    return {name: importlib.metadata.version(name) for name in VERSIONED}


def default_folder(target: str) -> Path:
    """generated/ of the checkout for a built-in model, ./generated/NAME for a user's own."""
    if ":" in target:
        return Path("generated") / target.rsplit(":", 1)[1].lower().replace("-", "_")
    if not os.access(PACKAGE / "pyproject.toml", os.F_OK):
        return Path("generated") / target.replace("-", "_")  # an installed package is never written to
    return GENERATED / target.replace("-", "_")


def load_model(target: str) -> Any:
    """The Model that `target` names: a built-in, or FILE.py:NAME with NAME a Model or a function that makes one."""
    from boresight.derive.model import Model

    if ":" not in target:
        if target in KERNELS:
            raise BoresightError(f"{target} is a kernel and not a model; models are {', '.join(model_names())}")
        if target not in model_names():
            raise BoresightError(f"no model {target!r}; there are {', '.join(model_names())}, or give FILE.py:NAME")
        name = target.replace("-", "_")
        value = getattr(importlib.import_module(f"boresight.derive.models.{name}"), name)
    else:
        file, name = target.rsplit(":", 1)
        path = Path(file).resolve()
        if not path.is_file():
            raise BoresightError(f"{file} is not found; give FILE.py:NAME with the path of a Python file")
        sys.path.insert(0, str(path.parent))
        try:
            spec = importlib.util.spec_from_file_location(path.stem, path)
            assert spec is not None and spec.loader is not None
            module = importlib.util.module_from_spec(spec)
            sys.modules[path.stem] = module
            spec.loader.exec_module(module)
        except BoresightError:
            raise
        except Exception as error:  # whatever a user's file raises is the user's to see, in one line
            raise BoresightError(f"{file} cannot be run: {type(error).__name__}: {error}") from error
        finally:
            sys.path.pop(0)
        if not hasattr(module, name):
            models = [n for n, v in vars(module).items() if isinstance(v, Model)]
            raise BoresightError(f"{file} has no {name!r}; its models are {', '.join(models) or 'none'}")
        value = getattr(module, name)
    model = value() if callable(value) else value
    if not isinstance(model, Model):
        raise BoresightError(
            f"{target} is a {type(model).__name__}, not a Model; build one with boresight.derive.model.Model"
        )
    return model


# ---------------------------------------------------------------- what is known without SymPy


def digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def stamp_path(target: str, folder: Path) -> Path:
    key = hashlib.sha256(f"{target}\0{folder.resolve()}".encode()).hexdigest()
    return cache_folder() / f"generated-{key[:32]}.json"


def sources() -> dict[str, str]:
    """Every file that the loaded code came from, outside Python and its packages, and the templates; with hashes."""
    outside = tuple(os.path.realpath(sysconfig.get_path(name)) + os.sep for name in ("stdlib", "platstdlib", "purelib"))
    files = {Path(PACKAGE / "boresight" / "__init__.py").resolve()}
    for name, module in list(sys.modules.items()):
        path = getattr(module, "__file__", None)
        if path is None or name.startswith(("boresight.cli", "boresight.runtime", "__main__", "pytest", "_pytest")):
            continue
        real = Path(path).resolve()
        if real.suffix == ".py" and (name.startswith("boresight") or not str(real).startswith(outside)):
            files.add(real)
    files |= {
        path.resolve() for name in ("templates", "kernels") for path in (Path(__file__).parent / name).glob("*.j2")
    }
    return {str(path): digest(path) for path in sorted(files) if path.is_file()}


def read_stamp(target: str, folder: Path) -> dict[str, Any]:
    try:
        return dict(json.loads(stamp_path(target, folder).read_text()))
    except (OSError, ValueError):
        return {}


def unchanged(known: dict[str, str]) -> bool:
    try:
        return bool(known) and all(digest(Path(path)) == value for path, value in known.items())
    except OSError:
        return False


def edited(folder: Path, manifest: dict[str, Any]) -> list[str]:
    """Generated files that are no longer what the manifest says they were."""
    return [
        path
        for path, value in manifest.get("files", {}).items()
        if (folder / path).is_file() and digest(folder / path) != value
    ]


def old_manifest(folder: Path) -> dict[str, Any]:
    try:
        return dict(json.loads((folder / "manifest.json").read_text()))
    except (FileNotFoundError, NotADirectoryError):
        return {}
    except (OSError, ValueError) as error:
        raise BoresightError(f"{folder}/manifest.json cannot be read ({error}); delete it and generate again") from None


# ---------------------------------------------------------------- generate


def generate(target: str, folder: Path | None = None, check: bool = False) -> Report:
    """Make the folder of one model agree with its source; with `check`, only say what would change.

    Raises BoresightError on a model that does not fit together, a generated file edited by hand, a folder that cannot
    be written to.  Nothing is left half written.
    """
    if ":" not in target and target not in target_names():
        raise BoresightError(f"no model {target!r}; there are {', '.join(target_names())}, or give FILE.py:NAME")
    folder = folder or default_folder(target)
    before = old_manifest(folder)
    by_hand = edited(folder, before)
    if by_hand and not check:
        raise BoresightError(
            f"{folder / by_hand[0]} was edited since it was generated; put the change into the model, delete the file, "
            "and generate again"
        )
    stamp = read_stamp(target, folder)
    complete = all((folder / path).is_file() for path in before.get("files", {}))
    same_tools = stamp.get("versions") == versions()
    if (
        not check
        and complete
        and same_tools
        and before
        and stamp.get("manifest") == digest(folder / "manifest.json")
        and unchanged(stamp.get("sources", {}))
    ):
        return Report(before["model"], folder, (), (), up_to_date=True)
    if check and before and before.get("versions") != versions():
        return Report(before["model"], folder, (), (), up_to_date=False, comparable=False)
    if check and not before:
        raise BoresightError(f"{folder} holds no generated model; run 'boresight generate {target}'")

    if target in KERNELS:
        name, counted = target, "lines"
        files, counts, hashes = make_kernel(target, versions())
    else:
        model = load_model(target)
        name, counted = model.name, "operations"
        refuse_taken(model.c_prefix, name, folder)
        files, counts, hashes = make(model, folder, before, stamp if same_tools and not check else {})
    old_units = before.get("units", {})
    changes = tuple(
        Change(unit, old_units.get(unit, {}).get(counted), counts.get(unit), counted)
        for unit in dict.fromkeys([*counts, *old_units])
        if old_units.get(unit, {}).get("hash") != hashes.get(unit)
    )
    stale = [path for path in before.get("files", {}) if path not in files and (folder / path).is_file()]
    differing = [path for path, text in files.items() if not same(folder / path, text)]
    if not check:
        write(folder, {path: files[path] for path in differing}, stale)
        save_stamp(target, folder, name)
    return Report(name, folder, changes, tuple(sorted(differing + stale)), up_to_date=False)


def refuse_taken(prefix: str, name: str, folder: Path) -> None:
    """Raise BoresightError where a folder beside this one holds another model of the same prefix."""
    for path in sorted(folder.resolve().parent.glob("*/manifest.json")):
        try:
            other = json.loads(path.read_text())
            taken = other["c_prefix"] == prefix and other["model"] != name and path.parent != folder.resolve()
        except (OSError, ValueError, TypeError, KeyError):
            continue  # no manifest of a model
        if taken:
            raise BoresightError(
                f"model {name}: c_prefix {prefix!r} is that of {other['model']} in {path.parent}, and C of "
                "both would not link; choose another"
            )


def same(path: Path, text: str) -> bool:
    try:
        return path.read_bytes() == text.encode()
    except OSError:
        return False


def make(
    model: Any, folder: Path, before: dict[str, Any], stamp: dict[str, Any]
) -> tuple[dict[str, str], dict[str, int], dict[str, str]]:
    """All files of the model, and of each unit its operation count and hash.

    Golden vectors cost most of the time.  Those of a unit whose C did not change are taken from the folder, if the
    generator itself is the one that made them.
    """
    from boresight.codegen import emit
    from boresight.codegen.units import units

    made = units(model)
    generator = str(Path(__file__).parent.resolve())
    known = {path: value for path, value in stamp.get("sources", {}).items() if path.startswith(generator)}
    may_keep = unchanged(known)
    files: dict[str, str] = {}
    hashes = {unit.name: emit.unit_hash(unit) for unit in made}
    for unit in made:
        vectors = f"selftest/test_{emit.file_stem(model, unit.name)}.c"
        printed = emit.unit_files(model, unit, with_vectors=False)
        keep = (
            may_keep
            and before.get("units", {}).get(unit.name, {}).get("hash") == hashes[unit.name]
            # names of structs are in the text, not in the hash
            and all(same(folder / path, text) for path, text in printed.items())
            and (folder / vectors).is_file()
        )
        if keep:
            files |= printed
            files[vectors] = (folder / vectors).read_text()
        else:
            files |= emit.unit_files(model, unit)
    files |= emit.model_files(model, made)
    if emit.has_filter(model):
        kernels, vectors = f"src/{model.c_prefix}_covariance.c", f"selftest/test_{model.c_prefix}_covariance.c"
        keep = may_keep and same(folder / kernels, files[kernels]) and (folder / vectors).is_file()
        files[vectors] = (folder / vectors).read_text() if keep else emit.covariance_test(model, made)
    files["manifest.json"] = emit.manifest(model, made, files, versions())
    return files, {unit.name: unit.tape.operations for unit in made}, hashes


def write(folder: Path, files: dict[str, str], stale: list[str]) -> None:
    """Write all files aside, then move each into place; remove what is no longer generated."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder, prefix=".writing-") as aside:
            for i, text in enumerate(files.values()):
                (Path(aside) / str(i)).write_text(text)
            for i, path in enumerate(files):
                (folder / path).parent.mkdir(parents=True, exist_ok=True)
                os.replace(Path(aside) / str(i), folder / path)
        for path in stale:
            (folder / path).unlink()
    except OSError as error:
        raise BoresightError(f"cannot write to {folder} ({error.strerror}); choose another folder with -o") from None


def save_stamp(target: str, folder: Path, model: str) -> None:
    """Remember what was generated from what.  Without it the next run only takes longer."""
    content = {
        "model": model,
        "versions": versions(),
        "sources": sources(),
        "manifest": digest(folder / "manifest.json"),
    }
    path = stamp_path(target, folder)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        aside = path.with_suffix(f".{os.getpid()}")
        aside.write_text(json.dumps(content))
        os.replace(aside, path)
    except OSError:
        return
