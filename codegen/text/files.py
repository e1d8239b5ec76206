"""Path below the generated folder -> text.

A template lies where its output does; `MODEL`, `PREFIX` and `UNIT` stand for the names of the model, of its functions
in C and of the unit's files.
"""

import hashlib
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import casadi as ca
from jinja2 import Environment, FileSystemLoader, StrictUndefined

from boresight.codegen.functions.reference import DIGITS
from boresight.codegen.functions.singular import refuse_singular
from boresight.codegen.functions.tape import LIBRARY, ULPS
from boresight.codegen.functions.unit import Unit
from boresight.codegen.functions.units import units
from boresight.codegen.text import stationary_detector
from boresight.codegen.text.covariance import covariance_view, nonzeros
from boresight.codegen.text.covariance_vectors import vectors_view
from boresight.codegen.text.digest import digest_view
from boresight.codegen.text.elementary import called, tests
from boresight.codegen.text.equations import FILE, equations_text
from boresight.codegen.text.filter import filter_view, has_filter, test_view
from boresight.codegen.text.identity import identity_view, numbers
from boresight.codegen.text.lanes import lanes_view, unit_lanes_view
from boresight.codegen.text.layout import laid_out
from boresight.codegen.text.live import live_view, resets
from boresight.codegen.text.manifest import described
from boresight.codegen.text.names import file_stem, snake
from boresight.codegen.text.vectors import vectors
from boresight.codegen.text.views import model_view, view
from boresight.derive.model import Model

TEMPLATES = Path(__file__).parent.parent / "templates"
SELFTEST = ("include/boresight.h", "selftest/selftest.h", "selftest/selftest.c", "CMakeLists.txt")  # of every folder


@cache
def environment() -> Environment:
    made = Environment(
        loader=FileSystemLoader(TEMPLATES),
        undefined=StrictUndefined,
        keep_trailing_newline=True,
    )
    made.globals["version"] = ".".join(map(str, numbers()))
    made.filters["capitalize_first"] = lambda text: text[:1].upper() + text[1:]
    return made


def rendered(paths: tuple[str, ...], words: dict[str, str], **views: Any) -> dict[str, str]:
    """Each template filled with the views, under its path with the words put in; C is laid out."""
    files = {}
    for path in paths:
        out = path
        for word, name in words.items():
            out = out.replace(word, name)
        text = environment().get_template(f"{path}.j2").render(**views)
        files[out] = laid_out(text) if out.endswith((".c", ".h")) else text
    return files


def folder_files(
    model: Model, kept: Callable[[str, dict[str, str]], str | None]
) -> tuple[dict[str, Any], dict[str, str]]:
    """What the manifest says of the model, and all files of its folder.

    kept: the path and the files under test of a self-test -> its text, if it need not be made again.
    """
    made = units(model)
    refuse_singular(model, made)
    views = [view(model, unit) for unit in made]
    files = {FILE: equations_text(model)}
    for unit, u in zip(made, views, strict=True):
        printed = unit_files(model, unit, u)
        test = f"selftest/test_{file_stem(model, unit.name)}.c"
        files |= printed | {test: kept(test, printed) or unit_test(model, unit, u)}
    files |= model_files(model, made, views)
    if has_filter(model):
        source, test = f"src/{model.c_prefix}_covariance.c", f"selftest/test_{model.c_prefix}_covariance.c"
        files[test] = kept(test, {source: files[source]}) or covariance_test(model, made)
    identity, digest = identity_files(files, model_view(model, []), has_filter(model))
    return described(model, made, views) | {"hash": digest}, files | identity


def unit_files(model: Model, unit: Unit, u: dict[str, Any]) -> dict[str, str]:
    """What belongs to one printed unit alone, but for its self-test."""
    m = model_view(model, [])
    paths = ("src/UNIT.c", "src/UNIT_kernel.h", "casadi/UNIT_kernel.h")
    return rendered(paths, {"UNIT": u["file"]}, u=u, m=m) | {
        f"casadi/{u['file']}_casadi.c": casadi_c(unit, model.c_prefix)
    }


def unit_test(model: Model, unit: Unit, u: dict[str, Any]) -> str:
    """The self-test of one printed unit, whose golden vectors cost most of the time."""
    views = {"u": u, "m": model_view(model, []), "vectors": vectors(model, unit)}
    (text,) = rendered(("selftest/test_UNIT.c",), {}, **views, digits=DIGITS, functions=of_the_functions(unit)).values()
    return text


def of_the_functions(unit: Unit) -> str:
    """What the self-test grants the elementary functions, in words."""
    worse = max((ULPS.get(step.op, 1) for step in unit.tape.steps if step.op in LIBRARY), default=1)
    return "elementary functions within 1 ulp" + (f", some within {worse}" if worse > 1 else "")


def model_files(model: Model, made: list[Unit], views: list[dict[str, Any]]) -> dict[str, str]:
    """What all units share, but for the self-test of the covariance."""
    m = model_view(model, views)
    paths: tuple[str, ...] = (*SELFTEST, "include/MODEL.h", "batch/PREFIX_batch.c")
    extra: dict[str, Any] = {"f": None}
    m["elementary"] = called(made)
    if m["elementary"]:
        extra["tests"] = tests(m["elementary"])
        m["parts"] = [f"{model.c_prefix}_math"]
        paths += (
            "include/boresight_math.h",
            "src/PREFIX_math.h",
            "src/PREFIX_math.c",
            "selftest/test_PREFIX_math.c",
        )
    if has_filter(model):
        f = filter_view(model, made, views)
        extra |= {"c": covariance_view(model, made), "f": f, "t": test_view(model, made, f)}
        extra["d"] = digest_view(model, f["carried"])
        extra["l"] = lanes_view(model, made, views, f)
        extra["v"] = live_view(model, made, views)
        m["parts"] += [f"{model.c_prefix}_{part}" for part in ("covariance", "filter", "digest")]
        paths += (
            *("include/boresight_filter.h", "include/MODEL_covariance.h", "include/MODEL_filter.h"),
            *("src/PREFIX_covariance.c", "src/PREFIX_filter.c", "selftest/test_PREFIX_filter.c"),
            *("include/boresight_digest.h", "include/MODEL_digest.h"),
            *("src/PREFIX_digest.c", "selftest/test_PREFIX_digest.c"),
            "batch/PREFIX_lanes.c",
        )
        if extra["v"]:
            extra["v"]["resets"] = resets(model, made)
            m["parts"] += [f"{model.c_prefix}_live"]
            paths += (
                "include/boresight_live.h",
                "include/MODEL_live.h",
                "src/PREFIX_live.c",
                "selftest/test_PREFIX_live.c",
            )
    words = {"MODEL": m["snake"], "PREFIX": model.c_prefix}
    blocks = ("batch/boresight_lanes.h", "batch/PREFIX_unit_lanes.c")
    return rendered(paths, words, m=m, **extra) | rendered(blocks, words, m=m, l=unit_lanes_view(model, made, views))


def covariance_test(model: Model, made: list[Unit]) -> str:
    """The self-test of the covariance's loops, whose golden vectors depend on nothing but sizes and places."""
    names = ("F", "Qc") if model.F is not None else ("Phi", "Q")
    A, B = (nonzeros(made, name) for name in names)
    c = covariance_view(model, made)
    v = vectors_view(model.n, A, B, model.order if model.F is not None else None, c["moving"])
    views = {"m": model_view(model, []), "c": c, "v": v}
    (text,) = rendered(("selftest/test_PREFIX_covariance.c",), {}, **views).values()
    return text


def casadi_c(unit: Unit, prefix: str) -> str:
    """CasADi's own C of the unit, but for the elementary functions, which are those of the model."""
    generator = ca.CodeGenerator(
        unit.function.name(),
        {"casadi_int": "int", "with_header": False, "static_aux": True, "prefix": unit.function.name() + "_"},
    )
    generator.add(unit.function)
    text, include = generator.dump(), "#include <math.h>\n"
    ours = [f"#define {f['name']} BS_{f['name'].upper()}\n" for f in called([unit]) if f["name"] != "sincos"]
    return text.replace(include, f'{include}#include "../src/{prefix}_math.h"\n{"".join(ours)}', 1) if ours else text


def detector_files() -> tuple[dict[str, Any], dict[str, str]]:
    """What the manifest says of the stationary detectors, which come from no model, and their files."""
    component = stationary_detector.description()
    name = component["name"]
    stem = snake(name)
    m = component | {"snake": stem, "units": [{"file": stem, "c_name": stem}], "parts": []}
    paths = (
        *SELFTEST,
        *(f"include/{stem}.h", f"src/{stem}.c", f"batch/{stem}_batch.c", f"selftest/test_{stem}.c"),
    )
    files = rendered(paths, {}, m=m, f=None)
    source = files[f"src/{stem}.c"]
    lines, digest = len(source.splitlines()), hashlib.sha256(source.encode()).hexdigest()
    identity, whole = identity_files(files, m, has_filter=False)
    document = {
        "hash": whole,
        "model": name,  # what a folder is called, whether of a model or not
        "component": component["manifest"],
        "title": component["title"],
        "c_prefix": component["prefix"],
        "units": {stem: {"c_name": stem, "file": stem, "lines": lines, "hash": digest}},
    }
    return document, files | identity


def identity_files(
    files: dict[str, str], m: dict[str, Any], has_filter: bool, exported: str = ""
) -> tuple[dict[str, str], str]:
    """What says what the folder is, made of all its other C; and the hash of that.

    m: `name`, `snake`, `prefix`.  exported: the precision of an export.
    """
    words = {"MODEL": m["snake"], "PREFIX": m["prefix"]}
    made = rendered(("src/PREFIX_identity.c",), words, m=m)
    view = identity_view(files | made, m, has_filter, exported)
    made |= rendered(("include/MODEL_identity.h", "include/boresight_precision.h"), words, **view)
    return made, view["hash"]
