"""The arrows between the layers, and what start-up may load."""

import ast
import graphlib
import re
import subprocess
import sys
from functools import cache

import pytest
from conftest import ROOT

LAYERS = ("derive", "codegen", "runtime", "analysis", "analysis/symbolic", "studies", "evidence")
ARROWS = {
    "derive": set(),
    "runtime": set(),
    "codegen": {"derive", "runtime"},
    "analysis": {"runtime"},
    "analysis/symbolic": {"derive", "analysis"},  # with SymPy; the command line alone imports it
    "studies": {"runtime", "analysis"},
    "evidence": {"derive", "codegen", "runtime", "analysis"},
}
# SymPy and CasADi stop at codegen: what flies needs neither.
FORBIDDEN = {
    **{layer: {"sympy", "casadi"} for layer in ("runtime", "analysis", "studies")},
    "derive": {"casadi", "numpy", "scipy"},
}

# Within derive, each imports only what stands before it.  The `results` of a paper are functions of which
# models are made; its letters, equations and witness judge them.
ORDER = (
    "where", "user_file", "within", "letters", "units", "constant", "named", "expressions", "checks", "model",
    "dimensions", "mechanics", "gradients", "short", "linear", "papers/*/results", "models", "ledger", "papers",
    "pages",
)  # fmt: skip
# Types that stand in annotations alone, each of what calls the file: a second description of them would say no more.
TYPES = {("derive/checks.py", "derive/model.py")}


@cache
def import_nodes(path):
    """At any depth of a file."""
    return [node for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.Import | ast.ImportFrom)]


def imported(path):
    """Dotted names of everything a file imports."""
    for node in import_nodes(path):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        else:
            assert node.level == 0, f"{path}: relative import"
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def arrows(layer):
    """Of each file of a layer those of it that it imports, also within functions and for types alone.

    `from a import b` is an arrow to the module a.b if there is one, else to a.
    """
    names = {".".join(("boresight", *path.relative_to(ROOT).with_suffix("").parts)): path for path in files(layer)}
    modules = {name.removesuffix(".__init__"): str(path.relative_to(ROOT)) for name, path in names.items()}
    found = {}
    for path in files(layer):
        here, named = str(path.relative_to(ROOT)), set()
        for node in import_nodes(path):
            if isinstance(node, ast.Import):
                named |= {alias.name for alias in node.names}
            else:
                inner = {f"{node.module}.{alias.name}" for alias in node.names}
                named |= {name if name in modules else node.module for name in inner}
        found[here] = {modules[name] for name in named & modules.keys()} - {here}
        found[here] -= {there for one, there in TYPES if one == here}
    return found


def part(file):
    """The part of a layer that a file belongs to: a folder or a file of its own.  What is run lies above all."""
    if re.fullmatch(r"derive/papers/\w+/results\.py", file):
        return "papers/*/results"
    return file if file.endswith("__main__.py") else file.split("/")[1].removesuffix(".py")


def circle(arrows):
    """The files of one, in their order, or nothing."""
    try:
        graphlib.TopologicalSorter(arrows).prepare()
    except graphlib.CycleError as error:
        return error.args[1][::-1]
    return []


def between(layer):
    """The arrows between the parts of a layer."""
    found = {}
    for file, others in arrows(layer).items():
        found.setdefault(part(file), set()).update({part(other) for other in others} - {part(file)})
    return found


@pytest.mark.parametrize("layer", LAYERS)
def test_no_files_and_no_folders_of_a_layer_import_in_a_circle(layer):
    """A lazy import is an arrow all the same, and one for a type alone is."""
    assert circle(arrows(layer)) == []
    assert circle(between(layer)) == []


def test_derive_imports_in_one_order():
    found = between("derive")
    assert set(found) - {"__init__"} == set(ORDER)
    for one, others in found.items():
        assert all(ORDER.index(other) < ORDER.index(one) for other in others), (one, others)


def files(layer):
    within = [ROOT / one for one in LAYERS if one.startswith(f"{layer}/")]
    return sorted(p for p in (ROOT / layer).rglob("*.py") if not any(p.is_relative_to(one) for one in within))


def layer_of(name):
    """The layer that a dotted name of the package lies in, or nothing."""
    parts = name.split(".")
    return next(
        ("/".join(parts[1:k]) for k in (3, 2) if parts[0] == "boresight" and "/".join(parts[1:k]) in LAYERS), ""
    )


@pytest.mark.parametrize("layer", LAYERS)
def test_a_layer_imports_only_along_the_arrows(layer):
    assert files(layer)
    for path in files(layer):
        for name in imported(path):
            parts = name.split(".")
            assert layer_of(name) in ("", layer, *ARROWS[layer]), f"{path} imports {name}"
            assert parts[:2] not in (["boresight", "cli"], ["boresight", "generated"]), f"{path} imports {name}"
            assert parts[0] not in FORBIDDEN.get(layer, ()), f"{path} imports {name}"


def test_nothing_that_flies_imports_what_is_simulated():
    for path in files("runtime"):
        if "simulation" not in path.parts:
            assert not any("simulation" in name.split(".") for name in imported(path)), path


def test_no_module_is_found_by_a_string():
    """A reader, and what looks for who uses a name, follows imports; a user's own file is run by its path.

    The models and the papers are found by the names that their packages list, so that nothing of one stands on another.
    """
    listed = [ROOT / "derive" / package / "__init__.py" for package in ("models", "papers")]
    for path in (path for layer in LAYERS for path in files(layer) if path not in listed):
        assert not re.search(r"\bimport_module\(|\b__import__\(", path.read_text()), path


def test_codegen_takes_from_runtime_only_the_library_the_compiler_the_manifest_and_the_filter():
    for path in files("codegen"):
        for name in imported(path):
            if name.startswith("boresight.runtime."):
                assert name.split(".")[2] in ("library", "compiler", "manifest", "filter"), f"{path} imports {name}"


@pytest.mark.parametrize(
    ("written", "home"),
    [
        (r"\b9\.80665", "runtime/units.py"),
        (r"\bpi / 180\b", "runtime/units.py"),
        (r"360 / 6400", "runtime/units.py"),
        (r"^Array = ", "runtime/array.py"),
        (r"\bNOT_POSITIVE = ", "runtime/status.py"),
    ],
)
def test_what_all_layers_share_is_written_once(written, home):
    """derive keeps its exact constants: a float would spoil them."""
    layers = [
        path for name in ("codegen", "runtime", "analysis", "studies", "evidence", "examples") for path in files(name)
    ]
    found = [str(path.relative_to(ROOT)) for path in layers if re.search(written, path.read_text(), re.M)]
    assert found == [home]


def test_nobody_imports_the_folders_by_their_plain_names():
    for folder in (*LAYERS, "boresight", "tests", "benchmarks", "examples"):
        for path in files(folder):
            for name in imported(path):
                assert name.split(".")[0] not in LAYERS, f"{path} imports {name}; say boresight.{name}"


@pytest.mark.parametrize(
    ("statement", "kept_out"),
    [
        ("import boresight", {"numpy", "sympy", "casadi", "scipy"}),
        ("import boresight.cli", {"numpy", "pint", "sympy", "casadi", "scipy", "matplotlib"}),
        ("import boresight.derive.model", {"casadi", "numpy", "pint"}),
        ("import boresight.runtime.library, boresight.runtime.filter", {"sympy", "casadi", "scipy", "matplotlib"}),
        ("import boresight.runtime.recording", {"sympy", "casadi", "pandas", "pydantic", "matplotlib"}),
        ("import boresight.studies.euler_table.table", {"sympy", "casadi", "matplotlib", "scipy.stats"}),
        ("import boresight.codegen.generate", {"sympy", "casadi", "numpy", "pint"}),
        ("import boresight.codegen.watch", {"sympy", "boresight.derive.model", "boresight.codegen.text.equations"}),
    ],
)
def test_start_up_stays_light(statement, kept_out):
    code = f"{statement}\nimport sys\nprint(' '.join(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert not kept_out & set(done.stdout.split())
