"""From a model's name to its generated folder: what changed is written, and nothing else.

SymPy and CasADi are imported only once the hashes of the sources say that something has to be made anew.
"""

import hashlib
import importlib.metadata
import json
import os
import re
import sys
import tempfile
from collections.abc import Callable, Collection
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from boresight import __version__
from boresight.codegen.stamp import PACKAGE, hashed, made_from
from boresight.derive.models import MODELS, built_in
from boresight.errors import BoresightError, did_you_mean

if TYPE_CHECKING:
    from boresight.derive.model import Model

VERSIONED = ("casadi", "numpy", "sympy")  # what the bytes of the output depend on, beside Boresight itself
COMPONENTS = ("stationary-detector",)  # C that comes from no model


@dataclass(frozen=True)
class Change:
    """A function that was added, changed or removed, with its operation counts before and after (None: not there).

    A component has lines, not operations.
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
    up_to_date: bool  # known from the manifest alone
    comparable: bool = True  # with check: the versions of SymPy and CasADi are those of the committed files
    strange: tuple[str, ...] = ()  # files in the folder that are not generated


def model_names() -> list[str]:
    """The built-in models."""
    return list(MODELS)


def target_names() -> list[str]:
    """Everything that is generated with Boresight: the models and the components."""
    return sorted([*model_names(), *COMPONENTS])


def source_of(target: str) -> Path | None:
    """The file of a model; None of a component."""
    if ":" in target:
        file = target.rsplit(":", 1)[0]
        if not in_a_file(target):
            raise BoresightError(f"{file} is not found; give FILE.py:NAME with the path of a Python file")
        return Path(file).resolve()
    return None if target in COMPONENTS else PACKAGE / "derive" / "models" / f"{target.replace('-', '_')}.py"


def in_a_file(target: str) -> bool:
    """Whether it can be made once more; a Model that was made at a prompt cannot."""
    return ":" not in target or Path(target.rsplit(":", 1)[0]).is_file()


def versions() -> dict[str, str]:
    return {name: importlib.metadata.version(name) for name in VERSIONED}


def stamp(target: str, read: Collection[str] = ()) -> dict[str, Any]:
    """What a manifest says of how its folder was made.

    read: of a model of one's own the files that its file read, by their paths from there.  Raises OSError where one of
    them is gone.
    """
    source = source_of(target) if in_a_file(target) else None
    made: dict[str, Any] = dict(made_from(source, [source.parent / path for path in read] if source else []))
    if ":" in target and source:
        made |= {"of": f"{source.name}:{target.rsplit(':', 1)[1]}", "read": sorted(read)}
        made["own"] = hashed({source, *(source.parent / path for path in read)})  # without what it imports of Boresight
    return {"made_from": made, "versions": versions(), "version": __version__}


def default_folder(target: str, model: Any = None) -> Path:
    """generated/ of the checkout for a built-in model, from any folder; ./generated/ for a user's own."""
    name = (model or load_model(target)).name if ":" in target else target
    home = PACKAGE if is_checkout() and ":" not in target and Path.cwd() != PACKAGE else Path()
    return home / "generated" / name.replace("-", "_")


def is_checkout() -> bool:
    """Whether the package lies in the repository, where the generated files belong to it; else it was installed."""
    return (PACKAGE / "pyproject.toml").is_file()


def load_model(target: str) -> Any:
    """The Model that `target` names, with what it leaves to be derived: a built-in, or FILE.py:NAME with NAME a Model
    or a function that makes one."""
    if ":" in target:
        model = own_model(target)
    else:
        known(target, model_names())
        model = built_in(target)
    return whole(model)


def whole(model: Any) -> Any:
    """The model once its units are right, with what it leaves to be derived."""
    from boresight.derive.dimensions import check_units
    from boresight.derive.linear import completed

    check_units(model)
    return completed(model)


def own_model(target: str) -> Any:
    """The Model of FILE.py:NAME."""
    from boresight.codegen.user_file import noting
    from boresight.derive import user_file
    from boresight.derive.model import Model

    file, name = target.rsplit(":", 1)
    path = source_of(target)
    assert path is not None
    with noting(path):
        module = user_file.run(path)
        if not hasattr(module, name):
            raise BoresightError(f"{file} has no {name!r}{did_you_mean(name, vars(module))}; {models_in(module)}")
        value: Any = getattr(module, name)
        try:
            model = value() if callable(value) else value
        except BoresightError:
            raise
        except Exception as error:
            user_file.explain(error, path)
    if not isinstance(model, Model):
        raise BoresightError(f"{target} is a {type(model).__name__}, not a Model; {models_in(module)}")
    if model.name in target_names():
        raise BoresightError(f"{model.where}: model {model.name}: that is a model of Boresight; choose another name")
    return model


def models_in(module: Any) -> str:
    """What of a user's file can be named behind the colon."""
    from boresight.derive.model import Model

    models = [name for name, value in vars(module).items() if isinstance(value, Model)]
    return f"its models are {', '.join(models)}" if models else "it has no Model; build one with Model(...)"


def known(target: str, names: list[str]) -> None:
    """Raise BoresightError unless the target is one of these names; of a Python file, list what it has."""
    if target in names:
        return
    if target in COMPONENTS:
        raise BoresightError(f"{target} comes from no model; models are {', '.join(model_names())}")
    if target.endswith(".py") and Path(target).is_file():
        from boresight.derive import user_file

        listed = models_in(user_file.run(Path(target).resolve()))
        raise BoresightError(f"{target} is a file; name a model in it, as {target}:NAME: {listed}")
    raise BoresightError(
        f"no model {target!r}{did_you_mean(target, names)}; there are {', '.join(names)}, or give FILE.py:NAME"
    )


# ---------------------------------------------------------------- what is known without SymPy


def digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def edited(folder: Path, manifest: dict[str, Any]) -> list[str]:
    """Generated files that are no longer what the manifest says they were."""
    return [
        path
        for path, value in manifest.get("files", {}).items()
        if (folder / path).is_file() and digest(folder / path) != value
    ]


def strange_files(folder: Path, files: Collection[str]) -> tuple[str, ...]:
    """What lies in a generated folder beside these files; of the folder that one works in, in its subfolders."""
    places = {Path(path).parts[0] for path in files if "/" in path} if folder.resolve() == Path.cwd() else {""}
    found = (path for place in places for path in (folder / place).rglob("*") if path.is_file())
    return tuple(sorted(name for path in found if (name := path.relative_to(folder).as_posix()) not in files))


def generated_folder(target: str, folder: Path | None = None, model: Any = None) -> Path:
    """The folder that a model of one's own was generated in: the one given, or that of its name."""
    folder = folder or default_folder(target, model)
    if not (folder / "manifest.json").is_file():
        raise BoresightError(
            f"{folder} holds no generated model; run 'boresight generate {target}', or name the folder it was "
            "generated in with --generated"
        )
    return folder


def old_manifest(folder: Path) -> dict[str, Any]:
    try:
        manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
        if not (isinstance(manifest, dict) and {"model", "files", "units"} <= manifest.keys()):
            raise ValueError("it is not a manifest")
        return manifest
    except (FileNotFoundError, NotADirectoryError):
        return {}
    except (OSError, ValueError) as error:
        raise BoresightError(f"{folder}/manifest.json cannot be read ({error}); delete it and generate again") from None


# ---------------------------------------------------------------- generate


def named(target: "str | Model", model: Any = None) -> tuple[str, Any]:
    """How the target is named, as FILE.py:NAME where it is a Model itself, and the model as far as it is there."""
    from boresight.derive.model import Model

    if isinstance(target, str):
        return target, model
    if not isinstance(target, Model):
        raise BoresightError(f"{target!r} is no model; give a built-in name, FILE.py:NAME or a Model")
    if target.name in target_names():
        raise BoresightError(f"{target.where}: model {target.name}: that is a model of Boresight; choose another name")
    file = target.where.rpartition(":")[0]
    bound = (key for module in list(sys.modules.values()) if same_file(getattr(module, "__file__", None), file)
             for key, value in list(vars(module).items()) if value is target)  # fmt: skip
    return f"{file}:{next(bound, target.name)}", whole(target)


def same_file(one: str | None, other: str) -> bool:
    return one is not None and Path(one).resolve() == Path(other).resolve()


def generate(
    target: "str | Model",
    folder: str | Path | None = None,
    check: bool = False,
    model: Any = None,
    writing: AbstractContextManager[Any] = nullcontext(),  # noqa: B008
    tell: Callable[[str], object] = lambda line: None,
) -> Report:
    """Make the folder of one model's C agree with its source.

    Parameters
    ----------
    target : str or Model
        A built-in name, FILE.py:NAME with NAME a Model or a function that makes one, or the Model
        itself.
    folder : str or Path, optional
        Where to write: by default ./generated/NAME, of a built-in model in a checkout its own
        folder.
    check : bool, optional
        Write nothing, and report what would change.
    model : Model, optional
        What `target` names, if it is loaded already.
    writing : context manager, optional
        Held while files are put in their places.
    tell : callable, optional
        Given one line before anything is written, where the model is as it was and another version
        of Boresight, SymPy or CasADi makes other operations of its equations.

    Returns
    -------
    Report
        `folder`; `changes`, each function that is new, changed or removed with its operations
        before and after; `written`, the files that were, or would be, written or removed;
        `up_to_date`.

    Raises
    ------
    BoresightError
        A model that does not fit together, a term of the wrong unit, a prefix that a model beside
        it has, a generated file that was edited by hand, a folder that cannot be written to.
        Nothing is left half written.

    Notes
    -----
    When not to use it: in flight or in a loop; it takes seconds.  Generate once, then `load` the
    folder.

    Examples
    --------
    >>> from sympy import Matrix
    >>> from boresight import Measurement, Model, Struct, generate, variable
    >>> place = variable("place", "x", "m", "place on the line", -100.0, 100.0)
    >>> dt = variable("dt", "dt", "s", "length of the step", 1e-3, 1.0)
    >>> walk = variable("walk", "q", "m/sqrt(s)", "noise density of the place", 0.0, 1.0)
    >>> model = Model(
    ...     name="walker", c_prefix="wk", title="a walk on a line, 1 state", frame="none",
    ...     states=(place,), structs=(Struct("step", "one step", (dt, walk)),),
    ...     f=Matrix([0]), G=Matrix([1]), noise=walk.vector, dt=dt.scalar,
    ...     measurements=(Measurement("fix", ("x",), "m", "the place that is read", h=place.vector),),
    ... )
    >>> report = generate(model)
    >>> print(report.folder, report.changes[0].name)
    generated/walker F
    """
    if not isinstance(target, str):
        target, model = named(target)
    if ":" not in target:
        known(target, target_names())
    folder = Path(folder) if folder else None
    if not check and model is None and (report := unchanged(target, folder)):
        return report
    if folder is None:
        model = model or (load_model(target) if ":" in target else None)
        folder = default_folder(target, model)
    before = old_manifest(folder)
    by_hand = edited(folder, before)
    if by_hand and not check:
        raise BoresightError(
            f"{folder / by_hand[0]} was edited since it was generated; put the change into the model, delete the file, "
            "and generate again"
        )
    if check and before and before.get("versions") != versions():
        return Report(before["model"], folder, (), (), up_to_date=False, comparable=False)
    if check and not before:
        generated_folder(target, folder)

    if target not in COMPONENTS:
        model = model or load_model(target)
        refuse_taken(model.c_prefix, model.name, folder)
    document, files = make(target, folder, not check and same_generator(before, stamp(target)), model)
    hashes = {path: hashlib.sha256(text.encode()).hexdigest() for path, text in files.items()}
    document |= {"files": hashes, **stamp(target, read_by(target, folder))}
    files["manifest.json"] = json.dumps(document, indent=1, sort_keys=True) + "\n"
    counted = "operations" if target not in COMPONENTS else "lines"
    old_units, new_units = before.get("units", {}), document["units"]
    changes = tuple(
        Change(unit, old_units.get(unit, {}).get(counted), new_units.get(unit, {}).get(counted), counted)
        for unit in dict.fromkeys([*new_units, *old_units])
        if old_units.get(unit, {}).get("hash") != new_units.get(unit, {}).get("hash")
    )
    stale = [path for path in before.get("files", {}) if path not in files and (folder / path).is_file()]
    differing = [path for path, text in files.items() if not same(folder / path, text)]
    if not check:
        if line := of_another_version(folder, before, document, changes):
            tell(line)
        with writing:
            write(folder, {path: files[path] for path in differing}, stale)
    strange = strange_files(folder, {*files, *stale}) if before else ()
    return Report(document["model"], folder, changes, tuple(sorted(differing + stale)), False, strange=strange)


def of_another_version(folder: Path, before: dict[str, Any], now: dict[str, Any], changes: tuple[Change, ...]) -> str:
    """Which functions have other operations though their equations are the same, and why; or nothing."""
    made, of_now = before.get("made_from", {}), now["made_from"]
    known = [key for key in ("own", "model") if key in made and key in of_now]
    same_model = any(made[key] == of_now[key] for key in known)
    other = [str(change) for change in changes if change.before is not None and change.after is not None]
    if not (same_model and other):
        return ""
    was = {"Boresight": before.get("version"), **before.get("versions", {})}
    here = {"Boresight": now["version"], **now["versions"]}
    why = [f"{name} {was.get(name)} made it, {here[name]} is here" for name in here if was.get(name) != here[name]]
    shown = "; ".join(other[:3]) + f"; and {len(other) - 3} more" * (len(other) > 3)
    return (
        f"{folder}: the model is as it was, but its C gets other operations, since "
        f"{' and '.join(why) or 'the generator was edited'}: {shown}.  Their bits and their evidence change; keep a "
        "copy of the folder to compare, or install what made it"
    )


def unchanged(target: str, folder: Path | None = None) -> Report | None:
    """The report on a folder that was made of what is here now, as its manifest says; None if there is none.

    Nothing is derived, and a file of one's own is not run: what it read is known by the manifest.
    """
    if not in_a_file(target):
        return None
    own = ":" in target
    beside = (path.parent for path in sorted(Path("generated").glob("*/manifest.json")))
    for one in [folder] if folder else beside if own else [default_folder(target)]:
        try:
            before = old_manifest(one)
            made = before.get("made_from", {})
            now = stamp(target, made.get("read", ()) if own else ())
        except (BoresightError, OSError):  # which is told where it is made anew
            continue
        named = not own or folder or one.name == before.get("model", "").replace("-", "_")
        complete = before and all((one / path).is_file() for path in before["files"]) and not edited(one, before)
        if named and complete and all(before.get(key) == value for key, value in now.items()):
            strange = strange_files(one, {*before["files"], "manifest.json"})
            return Report(before["model"], one, (), (), up_to_date=True, strange=strange)
    return None


def read_by(target: str, folder: Path) -> list[str]:
    """What the file of a model of one's own read when it was run last, by paths from there; not what was made of it."""
    if ":" not in target or not in_a_file(target):
        return []
    from boresight.codegen.user_file import READ

    source = source_of(target)
    assert source is not None
    read = (path for path in READ.get(source, ()) if not path.is_relative_to(folder.resolve()))
    return sorted(Path(os.path.relpath(path, source.parent)).as_posix() for path in read)


def refuse_taken(prefix: str, name: str, folder: Path) -> None:
    """Raise BoresightError where a folder beside this one holds another model of the same prefix."""
    for path in sorted(folder.resolve().parent.glob("*/manifest.json")):
        try:
            other = json.loads(path.read_text(encoding="utf-8"))
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


def same_generator(before: dict[str, Any], stamp: dict[str, Any]) -> bool:
    """Whether what lies in the folder was made by this generator, though perhaps of another model."""
    return bool(
        before.get("versions") == stamp["versions"]
        and before.get("made_from", {}).get("generator") == stamp["made_from"]["generator"]
    )


def make(target: str, folder: Path, keep: bool, model: Any = None) -> tuple[dict[str, Any], dict[str, str]]:
    """What the manifest says of the target, and all other files.

    keep: golden vectors, which cost most of the time, are taken from the folder where the C that they test is the same.
    """
    from boresight.codegen.text.files import detector_files, folder_files

    def kept(test: str, tested: dict[str, str]) -> str | None:
        unmoved = keep and all(same(folder / path, text) for path, text in tested.items())
        return (folder / test).read_text(encoding="utf-8") if unmoved and (folder / test).is_file() else None

    if target in COMPONENTS:
        return detector_files()
    try:
        return folder_files(model, kept)
    except BoresightError as error:
        if re.match(r".+:\d+: ", str(error)):
            raise
        raise BoresightError(f"{model.where}: model {model.name}: {error}") from error


def write(folder: Path, files: dict[str, str], stale: list[str]) -> None:
    """Write all files aside, then move each into place; remove what is no longer generated."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder, prefix=".writing-") as aside:
            for i, text in enumerate(files.values()):
                (Path(aside) / str(i)).write_text(text, encoding="utf-8")
            for i, path in enumerate(files):
                (folder / path).parent.mkdir(parents=True, exist_ok=True)
                os.replace(Path(aside) / str(i), folder / path)
        for path in stale:
            (folder / path).unlink()
    except OSError as error:
        raise BoresightError(f"cannot write to {folder} ({error.strerror}); choose another folder with -o") from None
