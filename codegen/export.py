"""One folder of C that needs nothing of Python: a generated model in one precision, with its tests and an example."""

import hashlib
import json
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.codegen import proof, requirements
from boresight.codegen.boxes import with_boxes
from boresight.codegen.flight import FLOWN, with_flight
from boresight.codegen.folder import Folder
from boresight.codegen.form import chosen, self_test, with_form
from boresight.codegen.functions.samples import generator
from boresight.codegen.generate import generate, generated_folder, load_model, named, unchanged
from boresight.codegen.loops import loops
from boresight.codegen.only import with_only
from boresight.codegen.text.files import identity_files, rendered
from boresight.codegen.text.names import snake
from boresight.derive.model import Model
from boresight.runtime import compiler
from boresight.runtime.filter import Filter
from boresight.runtime.library import Library, load
from boresight.runtime.manifest import folder_of, read_manifest

PRECISIONS = ("double", "float")
FORMS = {"joseph": "Joseph", "ud": "UD"}  # of the covariance, and what the C calls them
NO_FORM = "there is no form {!r} of a covariance; choose {}"
FORM_OF = {"double": "joseph", "float": "ud"}  # which one a precision flies, unless another is chosen
# Where the C is built by somebody else's tool, and what that needs beside it.
PLACES = {
    "cmake": (),
    "arduino": (),
    "platformio": ("library.json",),
    "idf": ("idf_component.yml",),
    "zephyr": ("zephyr/module.yml", "zephyr/Kconfig", "zephyr/CMakeLists.txt"),
    "px4": ("px4/CMakeLists.txt",),
}
# What <math.h> of C99 has, and that of AVR has not.
OF_AVR = """#ifndef islessequal
#define isgreaterequal(a, b) __builtin_isgreaterequal(a, b)
#define islessequal(a, b) __builtin_islessequal(a, b)
#define isunordered(a, b) __builtin_isunordered(a, b)
#endif
"""
# What Boresight's own examples of these builds have seen, see examples/embed.
SEEN = {
    "cmake": "built and run by CMake",
    "arduino": "built with Arduino's core for AVR, run by an emulator; no other board was built",
    "platformio": "its tool takes library.json; nobody has built it there",
    "idf": "its tool takes idf_component.yml; nobody has built it there",
    "zephyr": "nobody has built it there",
    "px4": "a module is built as C++14 with PX4's warnings, outside PX4; nobody has built it there",
}
NO_EVIDENCE = "none was made of this model"
OTHER_BOXES = "boxes were chosen for this export, {}: its C is other than that of which evidence is kept"
OTHER_EVIDENCE = "what is kept was found of other C, with another hash"
MAKE = "'boresight evidence {}' makes what is missing, as far as the tools are there; with --quick in some 3 minutes."
MAKE_BOXED = (
    "No command makes it of boxes that an export chose: write them into a model of your own, see 'boresight new'."
)
MADE_HERE = "'python -m boresight.evidence {}' makes it, in a checkout of Boresight."
SECONDS = 60  # of the example
OFF = 0.25
GENTLE, WIDE = 1e-4, 1e-3  # of half a box: how far the example's inputs stray from its middle; one sigma at its start
PLACE = re.compile(r"(?<![a-z])(lat|lon|latitude|longitude)(?![a-z])")
EARTH_RADIUS = 6378137.0  # m, the equator's
NEAR = {"double": 1e-9, "float": 1e-2}  # of a sigma: how far the example may end from the Python loop


@dataclass(frozen=True)
class Exported:
    """The files that were written, and what the precision costs, if it does."""

    files: list[Path]
    warning: str


def export(
    target: str | Model,
    out: str | Path,
    precision: str = "double",
    folder: str | Path | None = None,
    boxes: tuple[str, ...] = (),
    places: tuple[str, ...] = (),
    only: tuple[str, ...] = (),
    form: str = "",
) -> Exported:
    """Write a model's C as one folder that needs nothing of Python, with self-test and example.

    Parameters
    ----------
    target : str or Model
        A built-in name, FILE.py:NAME, or the Model itself; its C must have been generated and be
        what the model says now.
    out : str or Path
        The new folder, which must not exist, or be empty.
    precision : {"double", "float"}, optional
        Of the numbers; in float the covariance is kept as UD factors.
    folder : str or Path, optional
        Where its C was generated, by default as for `generate`.
    boxes : tuple of str, optional
        Other boxes of inputs, as "dt=0.001:0.02"; the C is then generated anew, has another hash,
        and there is no evidence of it.
    places : tuple of str, optional
        What it is built by beside make and CMake: any of "arduino", "platformio", "idf", "zephyr",
        "px4".
    only : tuple of str, optional
        The measurements that fly; the others have no function, no self-test and no place in the
        filter.  Evidence stays of what is the same text.
    form : {"joseph", "ud"}, optional
        The form of the covariance that flies: of the other there is no function, no self-test and
        no requirement.  Evidence stays of what is the same text.  By default both are there, and
        double flies the symmetric Joseph form, float UD factors.

    Returns
    -------
    Exported
        `files`, the paths that were written, and `warning`, what single precision costs this model,
        or nothing.

    Raises
    ------
    BoresightError
        An unknown precision, a folder that is not empty, C that is not there or is not what the
        model says now; a self-test that fails on this machine, where there is no evidence of the C.
        Nothing is written then.

    Notes
    -----
    When not to use it: to fly in Python; `load` does that.  Of two models in one program the
    prefixes must differ.

    Examples
    --------
    The model of the example of `generate`, which has been generated:

    >>> from boresight import export
    >>> exported = export(model, "flight", precision="float")
    >>> sorted(path.name for path in exported.files if path.parent.name == "flight")[:2]
    ['CMakeLists.txt', 'EVIDENCE.html']
    """
    (target, model), out = named(target), Path(out)
    if precision not in PRECISIONS:
        raise BoresightError(f"there is no precision {precision!r}; choose {' or '.join(PRECISIONS)}")
    if form and form not in FORMS:
        raise BoresightError(NO_FORM.format(form, " or ".join(FORMS)))
    if unknown := [place for place in places if place not in PLACES]:
        raise BoresightError(f"nothing is known of {unknown[0]!r}; choose of {', '.join(PLACES)}")
    if out.exists() and (not out.is_dir() or any(out.iterdir())):
        raise BoresightError(f"{out} is not empty; choose another folder with -o, or remove it first")
    if boxes or only:
        with tempfile.TemporaryDirectory() as aside:
            model = with_only(model or load_model(target), only) if only else model or load_model(target)
            model = with_boxes(model, boxes)
            made = generate(target, Path(aside) / snake(model.name), model=model).folder
            if boxes:
                unproven = OTHER_BOXES.format(", ".join(boxes))
                return exported(made, out, precision, target, places, unproven, form=form, model=model)
            whole = whole_folder(target, folder, model)
            return exported(made, out, precision, target, places, whole=whole, only=only, form=form, model=model)
    return exported(current_folder(target, folder, model), out, precision, target, places, form=form, model=model)


def whole_folder(target: str, folder: str | Path | None = None, model: Model | None = None) -> Path:
    """Where a model was generated, whatever it says now; folder: if not where `generate` puts it."""
    if ":" in target:
        return generated_folder(target, Path(folder) if folder else None, model)
    return Path(folder) if folder else folder_of(target)  # from wherever the command is run


@contextmanager
def part(
    target: str, only: tuple[str, ...] = (), form: str = "", folder: str | Path | None = None
) -> Iterator[tuple[Folder, Path]]:
    """What `export` would write with these measurements and this form, as a generated folder, while it is needed; and
    the folder of the whole model.

    Raises BoresightError as `export` does.
    """
    if form and form not in FORMS:
        raise BoresightError(NO_FORM.format(form, " or ".join(FORMS)))
    with tempfile.TemporaryDirectory() as aside:
        whole = whole_folder(target, folder) if only else current_folder(target, folder)
        made, model, own = whole, load_model(target), target if ":" in target else ""
        results = part_results(whole, own, only, form)
        if only:
            model = with_only(model, only)
            made = generate(target, Path(aside) / "only" / whole.name, model=model).folder
        if form:
            manifest = read_manifest(made)
            of = written_aside(texts_of(made, manifest, target, form, model), manifest, Path(aside) / whole.name)
            made = of.path
        yield Folder(made, own, results), whole


def part_results(whole: Path, own: str, only: tuple[str, ...], form: str) -> Path:
    """Where the evidence of a part is kept: beside the folder of a model of one's own, else in ./generated."""
    home = whole.parent if own else Path("generated")
    return home / f"{'-'.join((whole.name, *sorted({*only}), *([form] if form else [])))}.evidence.json"


def texts_of(
    folder: Path, manifest: dict[str, Any], target: str, form: str = "", model: Model | None = None
) -> dict[str, str]:
    """By path what is exported of a generated folder and what evidence is made with, of one form if it is chosen."""
    if form and not manifest.get("filter"):
        raise BoresightError(f"--form: {manifest['model']} has no filter, and so no covariance")
    left_out = ("casadi/", "CMakeLists", "equations")
    files = {path: (folder / path).read_text() for path in manifest["files"] if not path.startswith(left_out)}
    if not form:
        return files
    files = with_form(files | self_test(model or load_model(target), form), manifest["c_prefix"], form)
    names = {"name": manifest["model"], "snake": snake(manifest["model"]), "prefix": manifest["c_prefix"]}
    identity, _ = identity_files(files, names, has_filter=True, form=form)
    precision = "include/boresight_precision.h"  # which refuses the other form
    return files | {precision: identity[precision]}


def current_folder(target: str, folder: str | Path | None = None, model: Model | None = None) -> Path:
    """Where a model's C is; raises BoresightError where it is not what the model says now.

    folder: where it was generated, if not where `generate` puts it.  model: what `target` names, if it is known.
    """
    folder = whole_folder(target, folder, model)
    if (model or not unchanged(target, folder)) and generate(target, folder, check=True, model=model).written:
        raise BoresightError(f"{folder} is not what {target} says now; run 'boresight generate {target}' first")
    return folder


def exported(
    folder: Path,
    out: Path,
    precision: str,
    target: str,
    places: tuple[str, ...],
    unproven: str = "",
    whole: Path | None = None,
    only: tuple[str, ...] = (),
    form: str = "",
    model: Model | None = None,
) -> Exported:
    """A generated folder, written to `out` in one precision, and in one form if it is chosen.

    target: as the user names the model.  unproven: why there can be no evidence of it, or nothing.  whole: that of the
    model, of which this one has these measurements `only`.  model: what `target` names, if it is loaded.
    """
    manifest = read_manifest(folder)
    either = texts_of(folder, manifest, target, form, model)  # in either precision, as evidence is made
    files = {path: text for path, text in either.items() if not path.startswith("batch/")}
    names = {"name": manifest["model"], "snake": snake(manifest["model"]), "prefix": manifest["c_prefix"]}
    identity, digest = identity_files(files, names, bool(manifest.get("filter")), precision, form)
    assert form or digest == manifest["hash"]  # whatever the precision
    manifest |= {"hash": digest}
    files = files | ({path: chosen(text, form == "ud") for path, text in identity.items()} if form else identity)
    chose = [*(["--only", ",".join(only)] if only else []), *(["--form", form] if form else [])]
    own = target if ":" in target else ""
    make = MAKE.format(" ".join((target, *chose))) if own or chose else MADE_HERE.format(folder.name)
    make = MAKE_BOXED if unproven else make
    with tempfile.TemporaryDirectory() as aside:
        of = written_aside(either, manifest, Path(aside) / folder.name) if form else Folder(folder)
        results = proof.place(Folder(whole or folder))
        if chose and (of_part := part_results(whole or folder, own, only, form)).is_file():
            results = of_part
        found = {} if unproven else proof.kept(of, results)
        why = "" if found else unproven or (OTHER_EVIDENCE if results.is_file() else NO_EVIDENCE)
        page = proof.page_view(of, found, why, make)
    run_here = page["lowest"]["golden"] < proof.Verdict.LISTED or "coverage" not in found
    if run_here:
        flown = dict(zip([precision], FLOWN.findall(check_self_test(files, precision)), strict=False))
    else:
        flown = found["golden"]["units"].get(f"{manifest['c_prefix']}_live", {}).get("flown", {})
    files = {path: with_flight(text, flown) for path, text in files.items()}
    demanded = requirements.requirements(files, manifest)
    page["loops"] = loops(files)
    page["trace"] = requirements.rows(demanded, files, ran(files, found, precision, run_here))
    view = export_view(manifest, folder, files, precision, form or FORM_OF[precision], page)
    made = ["Makefile", "CMakeLists.txt", "README.md", "LICENSE", "package.pc.in", "EVIDENCE.html"]
    made += ["example/main.c", "example/minute.h"] if view["minute"] else []
    view["places"] = places
    view["seen"] = {place: SEEN[place] for place in places}
    made += [f"places/{path}" for place in places for path in PLACES[place]]
    words = {"export/": "", "places/": "", "package": view["package"]}
    texts = rendered(tuple(f"export/{path}" for path in made), words, e=view)
    files |= arduino(files, view) if "arduino" in places else {}
    files |= texts | {"evidence.json": as_json(evidence(manifest, precision, view["proof"], found))}
    files |= {"sbom.json": as_json(bill_of_materials(manifest, view["package"]))}
    files |= {"trace.csv": requirements.as_csv(page["trace"])}
    files |= {"trace-back.csv": requirements.as_csv(requirements.back(demanded))}
    document = {key: manifest[key] for key in ("model", "title", "c_prefix", "hash", "version")}
    document |= {"precision": precision, "form": view["form"], "files": hashes(files)}
    document |= {"measurements": list(manifest["measurements"])} if manifest.get("filter") else {}
    files["manifest.json"] = as_json(document)
    return Exported(write(out, files), view["cost"])


def written_aside(files: dict[str, str], manifest: dict[str, Any], out: Path) -> Folder:
    """This text as a generated folder, to know what of the evidence is of the same."""
    write_all(out, files | {"manifest.json": as_json(manifest | {"files": hashes(files)})})
    return Folder(out)


def arduino(files: dict[str, str], view: dict[str, Any]) -> dict[str, str]:
    """The C once more as a library of Arduino's, which looks for headers in src/ alone."""
    home, properties = f"arduino/{view['package']}", "library.properties"
    flat = {f"{home}/src/{Path(p).name}": text for p, text in files.items() if p.startswith(("src/", "include/"))}
    boresight = f"{home}/src/boresight.h"
    flat[boresight] = flat[boresight].replace("#include <math.h>\n", f"#include <math.h>\n{OF_AVR}", 1)
    texts = rendered((f"export/places/{properties}",), {"export/places": home}, e=view)
    return flat | texts


def check_self_test(files: dict[str, str], precision: str) -> str:
    """What the self-test of an export prints on this machine; BoresightError where it fails.

    files: text by path.
    """
    with tempfile.TemporaryDirectory() as aside:
        folder, program = Path(aside), Path(aside) / "selftest.out"
        write_all(folder, {path: text for path, text in files.items() if path.endswith((".c", ".h", ".inc"))})
        parts = [f"-I{folder / part}" for part in ("include", "src", "selftest")]
        command = [*compiler.compiler(), "-std=c99", "-ffp-contract=off", *compiler.PRECISIONS[precision], *parts]
        sources = [path for part in ("src", "selftest") for path in sorted((folder / part).glob("*.c"))]
        objects = compiler.compile_sources(command, dict.fromkeys(sources, ()), folder)
        compiler.run([*command, *objects.values(), "-lm", "-o", program])
        done = subprocess.run([program], capture_output=True, text=True, check=False)
    if done.returncode:
        _, *lines = done.stdout.splitlines() or [""]
        first = "; ".join(lines[:2]) or f"it ends with {done.returncode}"
        raise BoresightError(
            f"the self-test fails on this machine ({first}), so that nothing is written; narrow the boxes of the model "
            "to where it flies, or report it"
        )
    return done.stdout


def ran(files: dict[str, str], found: dict[str, Any], precision: str, here: bool) -> dict[str, str]:
    """By function of the self-test what is known of it: how many failures on which builds, or where it passed.

    here: whether the whole self-test has just passed on this machine, as it did where its coverage was taken.
    """
    units = found.get("golden", {}).get("units", {})
    result = {}
    for path in files:
        if not re.fullmatch(r"selftest/test_\w+\.c", path):
            continue
        builds = units.get(Path(path).stem.removeprefix("test_"), {}).get("builds", {})
        of = [build["failures"] for name, build in builds.items() if name.endswith(precision)]
        for test in re.findall(r"^int (test_\w+)\(void\)", files[path], re.MULTILINE):
            known = f"{sum(of)} failures on {len(of)} builds in {precision}"
            passed = "passes on this machine" if here else "passed where its coverage was taken"
            result[test] = known if of else passed
    return result


def write_all(folder: Path, files: dict[str, str]) -> None:
    for path, text in files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)


def hashes(files: dict[str, str]) -> dict[str, str]:
    return {path: hashlib.sha256(text.encode()).hexdigest() for path, text in files.items()}


def as_json(document: dict[str, Any]) -> str:
    return json.dumps(document, indent=1, sort_keys=True) + "\n"


def evidence(manifest: dict[str, Any], precision: str, page: dict[str, Any], found: dict[str, Any]) -> dict[str, Any]:
    """The evidence of exactly this C: the verdict, of each kind that and tools and units; or "none", and why."""
    head = {"model": manifest["model"], "hash": manifest["hash"], "precision": precision}
    head |= {"verdict": proof.VERDICTS[page["verdict"]], "make": page["make"], "not_made": dict(page["not_made"])}
    head |= {"loops": {"bounded": {str(one): one.most for one in page["loops"] if one.most is not None}}}
    head["loops"] |= {"not_held": [str(one) for one in page["loops"] if one.most is None]}
    return head | ({"evidence": found} if found else {"evidence": "none", "why": page["why"]})


def bill_of_materials(manifest: dict[str, Any], package: str) -> dict[str, Any]:
    """What the folder is and what it brings of others, which is nothing, in CycloneDX's form."""
    component = {
        "type": "library",
        "bom-ref": package,
        "name": package,
        "version": manifest["version"],
        "description": manifest["title"],
        "hashes": [{"alg": "SHA-256", "content": manifest["hash"]}],
    }
    tool = {"type": "application", "name": "boresight", "version": manifest["version"]}
    return {
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {"component": component, "tools": {"components": [tool]}},
        "components": [],
        "dependencies": [{"ref": package, "dependsOn": []}],
    }


def write(out: Path, files: dict[str, str]) -> list[Path]:
    """All files aside, then the whole folder into place."""
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=out.parent, prefix=".writing-") as aside:
            write_all(Path(aside) / "new", files)
            if out.exists():
                out.rmdir()
            shutil.move(Path(aside) / "new", out)
    except OSError as error:
        raise BoresightError(f"cannot write to {out} ({error.strerror}); choose another folder with -o") from None
    return [out / path for path in sorted(files)]


# ---------------------------------------------------------------- what the templates ask for


def cost_of_float(manifest: dict[str, Any]) -> str:
    """How far apart two neighbours of a carried latitude or longitude are in float, where its box ends; or nothing.

    What is carried is the structs that the filter corrects and, of a total state, the state.
    """
    carried = [field for struct in manifest["filter"]["carried"] for field in manifest["structs"][struct]]
    carried += manifest["blocks"] if manifest["kind"] == "total-state" else []
    steps = []
    for field in carried:
        units = field["unit"].split(", ") if "," in field["unit"] else [field["unit"]] * field["size"]
        for name, unit, low, high in zip(field["components"], units, field["low"], field["high"], strict=True):
            if unit == "rad" and PLACE.search(f"{name} {field['meaning']}".lower()):
                spacing = float(np.spacing(np.float32(max(abs(low), abs(high)))))
                steps.append(f"{name} by {spacing * EARTH_RADIUS:.2g} m")
    if not steps:
        return ""
    return (
        f"in float the position moves in steps, {' and '.join(steps)} where the box ends; smaller motions in one step "
        "of time are lost: carry the position in double and correct it by x"
    )


def export_view(
    manifest: dict[str, Any], folder: Path, files: dict[str, str], precision: str, form: str, page: dict[str, Any]
) -> dict[str, Any]:
    stem, described = snake(manifest["model"]), manifest.get("filter")
    flown, why_not = None, ""
    if described:
        try:
            flown = minute(manifest, load(folder), precision)
        except BoresightError as error:  # the middle of the boxes need not suit every model, nor an error state of zero
            why_not = str(error)
    form = FORMS[form] if described else "none"
    return {
        "title": manifest["title"],
        "model": manifest["model"],
        "hash": manifest["hash"],
        "snake": stem,
        "package": stem + ("_f32" if precision == "float" else ""),
        "prefix": manifest["c_prefix"],
        "precision": precision,
        "form": form,
        "form_words": "UD factors" if form == "UD" else "symmetric Joseph form",
        "proof": page,
        "evidence_words": f"none: {page['why']}"
        if page["why"]
        else f"{proof.VERDICTS[page['verdict']]}: `EVIDENCE.html`",
        "states": manifest.get("states", []),
        "sources": sorted(Path(path).name for path in files if re.fullmatch(r"src/\w+\.c", path)),
        "tests": sorted(Path(path).name for path in files if re.fullmatch(r"selftest/\w+\.c", path)),
        "units": [
            {"name": unit["c_name"], **unit}
            for unit in manifest["units"].values()
            if unit.get("operations") is not None
        ],
        "memory": memory(manifest, folder, precision),
        "filter": described,
        "quantiles": quantiles() if "component" in manifest else [],
        "over_nonzeros": described is not None and described["prediction"] == "non-zeros",
        "minute": flown,
        "live": f"src/{manifest['c_prefix']}_live.c" in files,
        "why_not": why_not,
        "seconds": SECONDS,
        "near": NEAR[precision],
        "cost": cost_of_float(manifest) if described and precision == "float" else "",
    }


def quantiles() -> list[tuple[int, float, list[float]]]:
    """Window, rate of false alarms, and what N times the squared statistic over its noise exceeds at that rate.

    By gyro_mean, either spread, accel_mean and the likelihood ratio, whose statistic itself is meant.
    """
    from scipy.stats import chi2

    return [
        (N, rate, [float(chi2.isf(rate, freedom)) for freedom in (3, 3 * (N - 1), 1, 6 * N - 2)])
        for N in (10, 25, 50, 100)
        for rate in (1e-2, 1e-3, 1e-4)
    ]


def memory(manifest: dict[str, Any], folder: Path, precision: str) -> list[tuple[str, int]]:
    """Bytes of each struct that the caller holds; of a component its header says it."""
    prefix, listed = manifest["c_prefix"], manifest.get("structs", {}).items()
    size = 4 if precision == "float" else 8
    structs = {name: sum(field["size"] for field in fields) for name, fields in listed if name != "x"}
    found = [(f"{prefix}_{name}", count * size) for name, count in structs.items()]
    if manifest.get("filter"):
        numbers = getattr(load(folder, precision=precision).dll, f"{prefix}_batch_filter_size")()
        found.append((f"{prefix}_filter", numbers * size))
    return found


def minute(manifest: dict[str, Any], library: Library, precision: str) -> dict[str, Any]:
    """Inputs of the example, one set a second, and where the Python loop over the same units ends with them.

    The inputs are drawn near the middle of their boxes, noises near zero: they exercise the functions and describe no
    motion.  A total state begins off the middle, so that it moves, and nearer to it where that leads out of its box.
    """
    try:
        return minute_from(OFF, manifest, library, precision)
    except BoresightError:
        return minute_from(OFF / 16, manifest, library, precision)


def minute_from(off: float, manifest: dict[str, Any], library: Library, precision: str) -> dict[str, Any]:
    """off: of half a box, where a total state begins."""
    rng, described = generator("export", manifest["model"]), manifest["filter"]
    real = np.float32 if precision == "float" else np.float64
    fields = {field["name"]: field for listed in manifest["structs"].values() for field in listed}
    text = np.float32 if precision == "float" else float

    def near_middle(name: str) -> Any:
        field = fields[name]
        low, high, norm = (np.array(field[key]) for key in ("low", "high", "norm"))
        middle = np.where(low == 0, WIDE * high, (low + high) / 2)  # what begins at zero is a noise: a small one
        value = middle + GENTLE * (high - low) / 2 * rng.standard_normal(field["size"])
        if field["norm"]:
            value = np.eye(field["size"])[0] + GENTLE * rng.standard_normal(field["size"])
            value *= norm.mean() / np.linalg.norm(value)
        if name == "dt":
            value = np.clip([1.0], low, high)
        near = np.clip(value, low, high).astype(real)  # which rounding may have led out of the box again
        near = np.where(near > high, np.nextafter(near, real(-np.inf)), near)
        return np.where(near < low, np.nextafter(near, real(np.inf)), near).astype(float)

    def fill(structs: list[str]) -> dict[str, dict[str, Any]]:
        return {s: {field["name"]: near_middle(field["name"]) for field in manifest["structs"][s]} for s in structs}

    start = fill(described["carried"])
    calls = [described["propagate"], *described["measurements"].values(), described["correct"] or {"structs": []}]
    outside = [s for s in manifest["structs"] if any(s in call["structs"] for call in calls)]
    seconds = [fill(outside) for _ in range(SECONDS)]

    def flat(given: dict[str, dict[str, Any]]) -> dict[str, Any]:
        return {k: v if v.size > 1 else v[0] for part in given.values() for k, v in part.items()}

    total = manifest["kind"] == "total-state"
    lows, highs = (np.array([v for block in manifest["blocks"] for v in block[end]]) for end in ("low", "high"))
    x0 = ((lows + highs + off * (highs - lows)) / 2).astype(real).astype(float) if total else None
    P0 = np.diag(((WIDE * (highs - lows) / 2) ** 2).astype(real).astype(float))
    # one state is flown as one of many runs: alone its (1,) would be taken for their axis
    several = (1,) * (len(P0) == 1 and total)
    begun = None if x0 is None else np.tile(x0, (*several, 1))
    loop = Filter(library, flat(start), np.tile(P0, (*several, 1, 1)), begun)
    R: dict[str, Any] = {}
    brought: dict[str, list[Any]] = {name: [] for name, m in described["measurements"].items() if m["brings_z"]}
    for given in map(flat, seconds):
        loop.predict(**only(given, described["propagate"]["fields"]))
        for name, m in described["measurements"].items():
            inputs = only(given, m["fields"])
            if name not in R:
                variances = noise(loop, name, P0, inputs).astype(real).astype(float)
                R[name] = np.diag(variances) if manifest["measurements"][name]["correlated"] else variances
            if m["brings_z"]:
                inputs["z"] = drawn(loop, name, R[name], inputs, rng).astype(real).astype(float)
                brought[name].append(inputs["z"])
            loop.update(name, R[name], **inputs)
        if described["correct"]:
            loop.feedback()
    return {
        "start": start,
        "seconds": seconds,
        "P0": P0,
        "x0": x0,
        "R": {name: value.ravel() for name, value in R.items()},
        "z": brought,
        "x": loop.x.ravel(),
        "sigma": np.sqrt(np.diag(loop.P.reshape(P0.shape))),
        "literal": lambda values, braced=True: literal(values, text, braced),
    }


def noise(loop: Filter, name: str, P0: Any, inputs: dict[str, Any]) -> Any:
    """Variances of a measurement, as large as what the filter is to explain by noise."""
    H = np.reshape(loop.call(f"{name}_H", **inputs), (-1, len(P0)))
    far = np.max(loop.call(f"{name}_z", **inputs) ** 2) if hasattr(loop.model, f"{name}_z") else 0.0
    return np.einsum("ij,jk,ik->i", H, P0, H) + far + 1e-12


def drawn(loop: Filter, name: str, R: Any, inputs: dict[str, Any], rng: np.random.Generator) -> Any:
    """The value of a measurement that the caller brings: what the filter expects, as far off as R says."""
    m = R.shape[-1]
    expected = -loop.update(name, R, rows=False, z=np.zeros(m), **inputs).nu.ravel()
    return expected + np.sqrt(R.diagonal() if R.ndim > 1 else R) * rng.standard_normal(m)


def only(given: dict[str, Any], fields: list[str]) -> dict[str, Any]:
    return {name: given[name] for name in fields if name in given}


def literal(values: Any, real: Any, braced: bool = True) -> str:
    """Numbers as C, as short as `real` allows: a scalar, or a list, braced or not."""
    listed = [f"BS_REAL({np.format_float_scientific(real(v), trim='0')})" for v in np.atleast_1d(values)]
    return "{ " + ", ".join(listed) + " }" if braced and len(listed) > 1 else ", ".join(listed)
