"""An exported folder in somebody else's build: languages, precisions, flags that are refused, what it says it is."""

import hashlib
import itertools
import json
import re
import shutil
from pathlib import Path

import pytest
from building import exported_c, passed, run
from conftest import PENDULUM
from tools import given, needs, tool

from boresight import BoresightError, __version__
from boresight.codegen import proof
from boresight.codegen.export import PLACES, export
from boresight.codegen.folder import Folder
from boresight.codegen.text.identity import model_hash, public_functions
from boresight.runtime.manifest import folder_of, read_manifest
from boresight.runtime.status import Status

IN_CXX = [build for std in ("c++17", "c++20") for build in (given("g++", std), given("clang++", std))]
STANDARDS = [build for std in ("c99", "c11", "c17", "c2x") for build in (("gcc", std), given("clang", std))] + IN_CXX
EXACT = ("-ffp-contract=off", "-Werror")


@pytest.fixture(scope="module")
def folders(compiled_once, tmp_path_factory):
    """(model, precision) -> the exported folder, exported once."""
    place, made = tmp_path_factory.mktemp("exported"), {}

    def folder(model, precision):
        out = place / f"{model}-{precision}"
        if (model, precision) not in made:
            made[model, precision] = exported_c(model, out, precision)
        return out

    return folder


@pytest.fixture(scope="module")
def libraries(folders):
    """(model, precision) -> the folder, its library built by its Makefile."""

    def library(model, precision):
        out = folders(model, precision)
        (done,) = [run("make", "-s", "-C", out, "CFLAGS=-O0")]
        assert done.returncode == 0, done.stderr
        return out, next((out / "build").glob("*.a"))

    return library


def include(folder):
    return ["-I", folder / "include"]


# ---- languages


@pytest.mark.parametrize(("compiler", "std"), STANDARDS)
def test_sources_and_headers_are_c_and_cxx_from_1999_to_today(compiler, std, folders, tmp_path):
    """Compiled, linked and run: the whole self-test in that language, and its user in it."""
    folder = folders("strapdown", "float")
    zeros = ("-Wno-missing-field-initializers", "-Wno-missing-braces")  # {0} is how C writes them
    extra = zeros if "++" in std else ()
    language = [
        "-x",
        "c++" if "++" in std else "c",
        f"-std={std}",
        *EXACT,
        "-Wall",
        "-Wextra",
        *extra,
        *include(folder),
    ]
    files = [*(folder / "src").glob("*.c"), *(folder / "selftest").glob("*.c")]
    done = run(compiler, *language, "-O0", *files, "-lm", "-o", tmp_path / "selftest")
    assert done.returncode == 0, done.stderr
    done = run(tmp_path / "selftest")
    assert done.returncode == 0 and done.stdout.splitlines()[-1] == passed(folder)


USER = """
#include <stdio.h>
#include "euler_matching_filter.h"

static em_filter filter;

int main(void)
{
    static const unsigned char considered[EM_N_STATES] = { 0 };
    (void)printf("%s", em_identity());
    return (int)em_filter_consider(&filter, considered);
}
"""


@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize(("compiler", "std"), IN_CXX)
def test_a_cxx_program_links_the_c_library(compiler, std, precision, libraries, tmp_path):
    folder, library = libraries("euler-matching", precision)
    (tmp_path / "main.cpp").write_text(USER)
    out = tmp_path / "user"
    done = run(
        compiler, f"-std={std}", "-Wall", "-Wextra", *EXACT, *include(folder), tmp_path / "main.cpp", library, "-o", out
    )
    assert done.returncode == 0, done.stderr
    assert run(out).stdout.startswith("euler-matching, Boresight")


@needs("g++")
def test_a_cxx_main_runs_the_self_test(libraries, tmp_path):
    folder, library = libraries("strapdown", "double")
    objects = []
    for source in sorted((folder / "selftest").glob("*.c")):
        objects.append(tmp_path / f"{source.stem}.o")
        done = run("gcc", "-std=c99", "-Dmain=selftest_main", *EXACT, *include(folder), "-c", source, "-o", objects[-1])
        assert done.returncode == 0, done.stderr
    (tmp_path / "main.cpp").write_text(
        '#include "selftest.h"\nextern "C" int selftest_main(void);\nint main() '
        "{ return selftest_main() + test_sd_step(); }\n"
    )
    flags = ["-std=c++17", *include(folder), "-I", folder / "selftest"]
    done = run(tool("g++"), *flags, tmp_path / "main.cpp", *objects, library, "-o", tmp_path / "program")
    assert done.returncode == 0, done.stderr
    assert run(tmp_path / "program").returncode == 0


# ---- two precisions


@pytest.mark.parametrize(("header", "library"), [("float", "double"), ("double", "float")])
def test_a_header_of_one_precision_does_not_link_with_a_library_of_the_other(header, library, libraries, tmp_path):
    (tmp_path / "main.c").write_text(USER)
    command = ["gcc", "-std=c99", *include(libraries("euler-matching", header)[0]), tmp_path / "main.c"]
    assert run(*command, libraries("euler-matching", header)[1], "-lm", "-o", tmp_path / "right").returncode == 0
    done = run(*command, libraries("euler-matching", library)[1], "-lm", "-o", tmp_path / "wrong")
    assert done.returncode != 0 and "undefined reference" in done.stderr


@pytest.mark.parametrize("precision", ["double", "float"])
def test_a_header_of_one_form_does_not_link_with_a_library_of_the_other(precision, libraries, tmp_path):
    """Both directions: the library as it is built with a user told of the other form, and the other way."""
    folder, library = libraries("euler-matching", precision)
    (tmp_path / "main.c").write_text(USER)
    own = {"double": 0, "float": 1}[precision]
    other = tmp_path / "other"
    other.mkdir()
    form = f"-DBORESIGHT_UD={1 - own}"
    made = run("gcc", "-std=c99", form, *include(folder), "-c", *(folder / "src").glob("*.c"), cwd=other)
    assert made.returncode == 0, made.stderr
    halves = {own: [library], 1 - own: list(other.glob("*.o"))}
    for header, built in itertools.product(halves, halves):
        flags = [f"-DBORESIGHT_UD={header}", *include(folder)]
        done = run("gcc", "-std=c99", *flags, tmp_path / "main.c", *halves[built], "-lm", "-o", tmp_path / "user")
        assert (done.returncode == 0) == (header == built), done.stderr
        assert header == built or "undefined reference to `em_filter_" in done.stderr


@pytest.mark.parametrize("precisions", [("double", "float"), ("float", "double")])
@pytest.mark.parametrize("before", ["", '#include "boresight.h"\n'])
def test_two_precisions_in_one_file_are_refused_in_a_sentence(precisions, before, folders, tmp_path):
    first, second = folders("strapdown", precisions[0]), folders("euler-matching", precisions[1])
    (tmp_path / "both.c").write_text(before + '#include "strapdown.h"\n#include "euler_matching.h"\n')
    done = run("gcc", "-std=c99", "-fsyntax-only", *include(first), *include(second), tmp_path / "both.c")
    assert done.returncode != 0
    assert f"euler_matching is in {precisions[1]}; another precision was seen" in done.stderr
    same = folders("euler-matching", precisions[0])
    assert run("gcc", "-std=c99", "-fsyntax-only", *include(first), *include(same), tmp_path / "both.c").returncode == 0


def test_two_versions_in_one_file_are_refused(folders, tmp_path):
    first, second = folders("strapdown", "double"), tmp_path / "second"
    shutil.copytree(folders("euler-matching", "double"), second)
    header = second / "include" / "euler_matching_identity.h"
    header.write_text(re.sub(r"(VERSION_NUMBER (?:!= )?)\d+", r"\g<1>990000", header.read_text()))
    (tmp_path / "both.c").write_text('#include "strapdown.h"\n#include "euler_matching.h"\n')
    done = run("gcc", "-std=c99", "-fsyntax-only", *include(first), *include(second), tmp_path / "both.c")
    assert done.returncode != 0 and "another version was seen" in done.stderr


def test_a_double_export_is_not_made_float_by_a_flag(folders):
    folder = folders("strapdown", "double")
    done = run("gcc", "-DBORESIGHT_FLOAT", "-fsyntax-only", *include(folder), folder / "src" / "sd_step.c")
    assert done.returncode != 0 and "exported in double" in done.stderr


@pytest.mark.parametrize("model", ["strapdown", "euler-matching", "stationary-detector"])
def test_every_symbol_says_its_precision(model, libraries):
    """All that the objects offer, whatever a header lists: so none was forgotten."""
    symbols = {}
    for precision in ("double", "float"):
        listed = run("nm", "-g", "--defined-only", "-P", libraries(model, precision)[1]).stdout
        symbols[precision] = {line.split()[0] for line in listed.splitlines() if len(line.split()) > 2}
    assert symbols["double"] and not any(name.endswith("_f32") for name in symbols["double"])
    assert symbols["float"] == {f"{name}_f32" for name in symbols["double"]}


def test_what_looks_like_a_prototype_is_no_function():
    text = "static inline int ah_a(int x)\n * bs_status ah_b(int);\ntypedef int (*ah_c)(int);\n#define ah_d(x) x\n"
    files = {"include/a.h": text + "bs_status ah_e(int x);\nconst char *ah_f(void);\n", "src/a.c": "int ah_g(void)\n"}
    assert public_functions(files, "ah") == ["ah_e", "ah_f"]


# ---- what is refused

REFUSED = [("-ffast-math", "fast-math"), ("-ffinite-math-only", "finite-math-only")]


@pytest.mark.parametrize(
    ("compiler", "flag", "word"),
    [
        *(build for words in REFUSED for build in (("gcc", *words), given("clang", *words))),
        pytest.param("gcc", "-mfpmath=387", "mfpmath=sse", marks=needs("x87")),
    ],
)
def test_arithmetic_that_is_not_as_written_is_refused(compiler, flag, word, folders):
    folder = folders("strapdown", "double")
    command = [compiler, "-std=c99", "-fsyntax-only", "-w", *include(folder), folder / "src" / "sd_step.c"]
    assert run(*command).returncode == 0
    done = run(*command, flag)
    assert done.returncode != 0 and "error: " in done.stderr and word in done.stderr


def test_reordered_sums_are_refused_where_gcc_tells(folders):
    folder = folders("strapdown", "double")
    command = ["gcc", "-std=c99", "-fsyntax-only", *include(folder), folder / "src" / "sd_step.c"]
    for flag in ("-funsafe-math-optimizations", "-freciprocal-math"):
        done = run(*command, flag)
        assert done.returncode != 0 and "change results" in done.stderr


PROBE = '#include "boresight.h"\nint main(void)\n{\n    return (int)bs_probe();\n}\n'
FUSED = "-mfma" if " fma " in Path("/proc/cpuinfo").read_text() else ""
REORDERED = "-fassociative-math -fno-signed-zeros -fno-trapping-math"
NO_NAN = "-Xclang -menable-no-nans"
TRAPS = "-fsanitize=undefined -fsanitize-trap=undefined"
LEVELS = ("-O0", "-O2", "-O3")


@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize(
    ("compiler", "flags", "status"),
    [
        *(("gcc", f"-ffp-contract=off {level}", Status.OK) for level in LEVELS),
        *(given("clang", f"-ffp-contract=off {level}", Status.OK) for level in LEVELS),
        ("gcc", f"-ffp-contract=off -O3 {FUSED}", Status.OK),
        ("gcc", f"-ffp-contract=fast -O2 {FUSED}", Status.CONTRACTED if FUSED else Status.OK),
        given("clang", f"-ffp-contract=on -O2 {FUSED}", Status.OK),  # the sources' pragma forbids it
        # which is not read then; a comparison may be made of the parts of a sum, and nothing is left to be fused
        given("clang", f"-ffp-contract=fast -O2 {FUSED}", Status.CONTRACTED if FUSED else Status.OK),
        given("clang", f"-ffp-contract=fast -O0 {TRAPS} {FUSED}", Status.CONTRACTED if FUSED else Status.OK),
        given("clang", f"-ffp-contract=off -O2 {REORDERED}", Status.CONTRACTED),
        given("clang", f"-ffp-contract=off -O2 {NO_NAN}", Status.CONTRACTED),
        given("clang", "-ffp-contract=off -O2 -fno-honor-nans", Status.CONTRACTED),
        given("clang", "-ffp-contract=off -O2 -freciprocal-math", Status.CONTRACTED),
    ],
)
def test_the_probe_finds_what_the_preprocessor_cannot_see(precision, compiler, flags, status, folders, tmp_path):
    (tmp_path / "probe.c").write_text(PROBE)
    warnings = ["-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Wfloat-equal", "-Wshadow", "-Werror"]
    command = [compiler, "-std=c99", *warnings, *flags.split(), *include(folders("strapdown", precision))]
    done = run(*command, tmp_path / "probe.c", "-lm", "-o", tmp_path / "probe")
    assert done.returncode == 0, done.stderr
    assert run(tmp_path / "probe").returncode == status


def test_the_sources_forbid_what_a_compiler_fuses_by_default(folders, tmp_path):
    folder, fused = folders("euler-matching", "double"), {}
    clang = tool("clang")
    for contract in ("on", "fast"):
        command = [clang, "-std=gnu99", "-O2", "-mfma", f"-ffp-contract={contract}", *include(folder), "-S", "-o", "-"]
        fused[contract] = sum(run(*command, source).stdout.count("vfm") for source in (folder / "src").glob("*.c"))
    assert fused["on"] == 0 < fused["fast"]


def test_constants_cut_to_single_precision_are_found(folders, tmp_path):
    (tmp_path / "probe.c").write_text(PROBE)
    command = ["gcc", "-std=c99", "-O1", "-fsingle-precision-constant", *include(folders("strapdown", "double"))]
    assert run(*command, tmp_path / "probe.c", "-o", tmp_path / "probe").returncode == 0
    assert run(tmp_path / "probe").returncode == Status.CONTRACTED


# ---- what it is


@pytest.mark.parametrize(
    ("model", "precision", "form"),
    [
        ("euler-matching", "double", "Joseph"),
        ("euler-matching", "float", "UD"),
        ("strapdown", "float", "none"),
        ("stationary-detector", "double", "none"),
    ],
)
def test_library_headers_manifest_and_self_test_say_the_same(model, precision, form, libraries, tmp_path):
    folder, library = libraries(model, precision)
    manifest = json.loads((folder / "manifest.json").read_text())
    assert (manifest["version"], manifest["precision"], manifest["form"]) == (__version__, precision, form)
    p, stem = manifest["c_prefix"], model.replace("-", "_")
    P = p.upper()
    (tmp_path / "main.c").write_text(
        f'#include <stdio.h>\n#include "{stem}.h"\nint main(void)\n{{\n'
        f'    printf("%s\\n%s|%s|%s|%s|%d.%d.%d|%d|%s\\n", {p}_identity(), {P}_MODEL, {P}_MODEL_HASH, {P}_VERSION, '
        f"BORESIGHT_VERSION, {P}_VERSION_MAJOR, {P}_VERSION_MINOR, {P}_VERSION_PATCH, {P}_PRECISION, {P}_FORM);\n"
        "    return 0;\n}\n"
    )
    done = run("gcc", "-std=c99", *EXACT, *include(folder), tmp_path / "main.c", library, "-o", tmp_path / "main")
    assert done.returncode == 0, done.stderr
    said, macros = run(tmp_path / "main").stdout.splitlines()
    assert said == f"{model}, Boresight {__version__}, {precision}, {form}, {manifest['hash']}"
    bits = "32" if precision == "float" else "64"
    assert macros.split("|") == [model, manifest["hash"], *[__version__] * 3, bits, form]
    tested = run("make", "-s", "-C", folder, "test", "CFLAGS=-O0")
    assert said in tested.stdout.splitlines()
    assert manifest["hash"] in (folder / "README.md").read_text()


def test_the_hash_is_that_of_the_files_and_the_same_in_both_precisions(folders):
    hashes = set()
    for precision in ("double", "float"):
        folder = folders("strapdown", precision)
        done = run("make", "-s", "-C", folder, "hash")
        assert done.returncode == 0, done.stdout
        hashes |= {done.stdout[:64], read_manifest(folder_of("strapdown"))["hash"]}
        hashes.add(json.loads((folder / "manifest.json").read_text())["hash"])
    assert len(hashes) == 1


def test_any_change_of_the_c_changes_the_hash(folders, tmp_path):
    folder = shutil.copytree(folders("strapdown", "double"), tmp_path / "copy", ignore=shutil.ignore_patterns("build"))
    files = {str(path.relative_to(folder)): path.read_text() for path in folder.rglob("*.[ch]")}
    first = model_hash(files)
    moved = {path for path in files if model_hash(files | {path: files[path] + " "}) != first}
    beside = {"include/strapdown_identity.h", "include/boresight_precision.h"}
    assert moved == {path for path in files if path.startswith(("src/", "include/"))} - beside
    with (folder / "src" / "sd_step.c").open("a") as source:
        source.write("\n")
    done = run("make", "-s", "-C", folder, "hash")
    assert done.returncode != 0 and "not what was exported" in done.stdout


@pytest.mark.parametrize("model", ["strapdown", "euler-matching"])
def test_the_manifest_lists_every_file_with_its_hash(model, tmp_path):
    exported_c(model, tmp_path / "out", "float")
    found = {str(path.relative_to(tmp_path / "out")) for path in (tmp_path / "out").rglob("*") if path.is_file()}
    listed = json.loads((tmp_path / "out" / "manifest.json").read_text())["files"]
    assert (
        found == {*listed, "manifest.json"} >= {"LICENSE", "README.md", "evidence.json", "Makefile", "CMakeLists.txt"}
    )
    for path, digest in listed.items():
        assert hashlib.sha256((tmp_path / "out" / path).read_bytes()).hexdigest() == digest
    assert "What you generate is yours" in (tmp_path / "out" / "LICENSE").read_text()


# ---- its evidence


@pytest.fixture
def results(tmp_path, monkeypatch):
    monkeypatch.setattr(proof, "RESULTS", tmp_path / "results")
    (tmp_path / "results").mkdir()
    return tmp_path / "results" / "strapdown.json"


def entry(sources, tools="", result=None):
    return {"sources": sources, "tools": tools, "units": dict.fromkeys(sources, result)}


def test_the_evidence_is_of_exactly_this_c_unit_by_unit(results, tmp_path):
    folder = Folder(folder_of("strapdown"))
    result = {"alarms": 0, "kinds": {}, "assumed": {}}
    now = {unit.name: unit.hash(tested=False) for unit in folder.units}
    eva = entry(now | {"sd_earth": "0" * 64}, "25.0", result)
    misra = entry({"strapdown": "0" * 64}, "2.10") | {"folder": "0" * 64}
    results.write_text(json.dumps({"eva": eva, "misra": misra}))
    exported_c("strapdown", tmp_path / "out")
    written = json.loads((tmp_path / "out" / "evidence.json").read_text())
    assert written["evidence"] == {"eva": {"tools": "25.0", "units": dict.fromkeys(now.keys() - {"sd_earth"}, result)}}
    assert written["hash"] == json.loads((tmp_path / "out" / "manifest.json").read_text())["hash"]
    assert written["verdict"] == "not made of this C"  # the lowest: most kinds are not made
    assert written["not_made"]["Eva"] == "sd_earth" and written["not_made"]["MISRA"] == "all"
    page = (tmp_path / "out" / "EVIDENCE.html").read_text()
    assert all(f"<code>{name}</code>" in page for name in now) and "http" not in page.replace("http-equiv", "")
    assert "EVIDENCE.html" in (tmp_path / "out" / "README.md").read_text()


@pytest.mark.parametrize(
    ("result", "verdict"),
    [
        ({"tried": 9, "wrong": [], "not_taken": []}, "HELD"),
        ({"tried": 9, "wrong": [], "not_taken": ["double, line 3: 1 of 2 branches"]}, "LISTED"),
        ({"tried": 9, "wrong": ["nav null: status 0"], "not_taken": []}, "WRONG"),
        (None, "NOT_MADE"),
    ],
)
def test_the_verdict_is_the_lowest_of_the_columns(result, verdict):
    (column,) = (column for column in proof.COLUMNS if column.kind == "guards")
    assert column.verdict(result).name == verdict
    assert proof.lowest({"a": column.verdict(result), "b": proof.Verdict.HELD}).name == verdict


def test_other_c_has_no_evidence_and_says_why(results, tmp_path):
    results.write_text(json.dumps({"eva": entry({"sd_step": "0" * 64})}))
    exported_c("strapdown", tmp_path / "out")
    written = json.loads((tmp_path / "out" / "evidence.json").read_text())
    assert written["evidence"] == "none" and "other C" in written["why"]
    assert f"none: {written['why']}" in (tmp_path / "out" / "README.md").read_text()


def test_a_model_of_ones_own_has_none_until_it_is_made(pendulum_folder, tmp_path):
    export(PENDULUM, tmp_path / "out", "double", pendulum_folder)
    written = json.loads((tmp_path / "out" / "evidence.json").read_text())
    assert written["evidence"] == "none" and f"'boresight evidence {PENDULUM}'" in written["make"]


def test_the_bill_of_materials_brings_nothing_of_others(tmp_path):
    exported_c("strapdown", tmp_path / "out", "float")
    bill = json.loads((tmp_path / "out" / "sbom.json").read_text())
    assert bill["bomFormat"] == "CycloneDX" and bill["components"] == []
    digest = json.loads((tmp_path / "out" / "manifest.json").read_text())["hash"]
    assert bill["metadata"]["component"]["hashes"] == [{"alg": "SHA-256", "content": digest}]


# ---- the places where it is built


@pytest.fixture(scope="module")
def everywhere(tmp_path_factory):
    return exported_c("strapdown", tmp_path_factory.mktemp("everywhere") / "out", "float", tuple(PLACES))


def test_what_other_tools_read_of_an_export_they_can_read(everywhere):
    import yaml

    assert {path for needed in PLACES.values() for path in needed} <= {
        str(path.relative_to(everywhere)) for path in everywhere.rglob("*")
    }
    library = json.loads((everywhere / "library.json").read_text())
    assert "-ffp-contract=off" in library["build"]["flags"] and (everywhere / "include" / library["headers"]).is_file()
    assert yaml.safe_load((everywhere / "idf_component.yml").read_text())["version"] == __version__
    module = yaml.safe_load((everywhere / "zephyr" / "module.yml").read_text())["build"]
    assert [(everywhere / path).exists() for path in module.values()] == [True, True]
    page = (everywhere / "EVIDENCE.html").read_text()
    assert page.count("nobody has built it there") == 4
    for place in ("zephyr", "px4"):
        named = re.findall(r"\.\./(src/\w+\.c)", (everywhere / place / "CMakeLists.txt").read_text())
        assert {everywhere / name for name in named} == set((everywhere / "src").glob("*.c"))


def test_arduino_finds_the_headers_in_src_alone(everywhere, tmp_path):
    (library,) = (everywhere / "arduino").iterdir()
    lines = (library / "library.properties").read_text().splitlines()
    assert {"name", "version", "sentence", "architectures", "includes"} <= {line.split("=")[0] for line in lines}
    for path in sorted((library / "src").glob("*.c")):
        done = run("gcc", "-std=c99", *EXACT, f"-I{library / 'src'}", "-c", path, "-o", tmp_path / "a.o")
        assert done.returncode == 0, done.stderr


@needs("cmake")
def test_esp_idf_takes_the_folder_as_a_component(everywhere, tmp_path):
    """The branch of ESP-IDF by a stand-in of its one command."""
    stand_in = tmp_path / "CMakeLists.txt"
    stand_in.write_text(
        "cmake_minimum_required(VERSION 3.16)\nproject(app C)\nset(ESP_PLATFORM 1)\nset(COMPONENT_LIB made)\n"
        'function(idf_component_register)\n  cmake_parse_arguments(A "" "" "SRCS;INCLUDE_DIRS" ${ARGN})\n'
        "  add_library(made STATIC ${A_SRCS})\n  target_include_directories(made PUBLIC ${A_INCLUDE_DIRS})\n"
        f"endfunction()\nadd_subdirectory({everywhere} made)\n"
    )
    run(tool("cmake"), "-S", tmp_path, "-B", tmp_path / "build")
    assert run(tool("cmake"), "--build", tmp_path / "build").returncode == 0
    assert list((tmp_path / "build").rglob("libmade.a"))


def test_an_unknown_place_is_refused_before_anything_is_written(tmp_path):
    with pytest.raises(BoresightError, match="'mbed'; choose of cmake, arduino"):
        export("strapdown", tmp_path / "out", places=("mbed",))
    assert not (tmp_path / "out").exists()


# ---- other people's builds


@needs("cmake")
@pytest.mark.parametrize(("wanted", "found"), [("0.1", True), (__version__, True), ("9.0", False), ("0.2", False)])
def test_cmake_finds_the_package_by_its_version(wanted, found, folders, tmp_path):
    folder, prefix = folders("strapdown", "float"), tmp_path / "prefix"
    for command in (
        ["-S", folder, "-B", tmp_path / "build", f"-DCMAKE_INSTALL_PREFIX={prefix}", "-DCMAKE_BUILD_TYPE=Debug"],
        ["--build", tmp_path / "build", "--target", "strapdown_f32"],
    ):
        done = run(tool("cmake"), *command)
        assert done.returncode == 0, done.stderr
    (tmp_path / "build" / "strapdown_f32_selftest").touch()  # which install would ask for
    done = run(tool("cmake"), "--install", tmp_path / "build")
    assert done.returncode == 0, done.stderr
    (tmp_path / "CMakeLists.txt").write_text(
        f"cmake_minimum_required(VERSION 3.16)\nproject(user C)\nfind_package(strapdown_f32 {wanted} REQUIRED)\n"
        "add_executable(user main.c)\ntarget_link_libraries(user PRIVATE boresight::strapdown_f32)\n"
    )
    (tmp_path / "main.c").write_text(
        "#include \"strapdown.h\"\nint main(void)\n{\n    return sd_identity()[0] != 's';\n}\n"
    )
    done = run(tool("cmake"), "-S", tmp_path, "-B", tmp_path / "user", f"-DCMAKE_PREFIX_PATH={prefix}")
    assert (done.returncode == 0) == found, done.stderr
    if found:
        assert run(tool("cmake"), "--build", tmp_path / "user").returncode == 0
        assert run(tmp_path / "user" / "user").returncode == 0


def test_make_installs_what_pkg_config_finds(folders, tmp_path):
    done = run(
        "make",
        "-s",
        "-C",
        folders("strapdown", "float"),
        "install",
        "CFLAGS=-O0",
        f"DESTDIR={tmp_path}",
        "PREFIX=/opt/b",
    )
    assert done.returncode == 0, done.stderr
    place = tmp_path / "opt" / "b"
    assert {path.name for path in (place / "include" / "strapdown_f32").iterdir()} == {
        path.name for path in (folders("strapdown", "float") / "include").iterdir()
    }
    described = (place / "lib" / "pkgconfig" / "strapdown_f32.pc").read_text()
    assert (
        "@" not in described and "prefix=${pcfiledir}/../..\n" in described and f"Version: {__version__}\n" in described
    )
    (tmp_path / "main.c").write_text(
        "#include \"strapdown.h\"\nint main(void)\n{\n    return sd_identity()[0] != 's';\n}\n"
    )
    words = dict(line.split(": ", 1) for line in described.splitlines() if ": " in line)
    values = {"libdir": place / "lib", "includedir": place / "include" / "strapdown_f32"}
    flags = [re.sub(r"\$\{(\w+)\}", lambda m: str(values[m[1]]), words[key]).split() for key in ("Cflags", "Libs")]
    done = run("gcc", *flags[0], tmp_path / "main.c", *flags[1], "-o", tmp_path / "main")
    assert done.returncode == 0, done.stderr
    assert run(tmp_path / "main").returncode == 0


@pytest.mark.parametrize(
    ("compiler", "level", "archiver"), [("gcc", "-O2", "ar"), given("arm-none-eabi-gcc", "-Os", "arm-none-eabi-ar")]
)
def test_arm_is_built_for_size_and_a_host_for_speed(compiler, level, archiver, folders):
    listed = run("make", "-n", "-B", "-C", folders("strapdown", "double"), f"CC={compiler}", "CFLAGS=").stdout
    compiled = [line for line in listed.splitlines() if " -c " in line]
    assert compiled and all(f" {level} " in line for line in compiled)
    assert f"\n{archiver} rcs" in listed
