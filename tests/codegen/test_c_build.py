"""The generated folder as an engineer takes it: warnings, self-test, CMake both ways, models in one binary."""

import re

import pytest
from building import STRICT, passed, run, self_test
from conftest import ROOT
from tools import given, needs, tool

from boresight.runtime import compiler

EM = ROOT / "generated" / "euler_matching"


@pytest.mark.parametrize("compiler", ["gcc", given("clang")])
@pytest.mark.parametrize("model", ["euler_matching", "pendulum"])
def test_compiles_without_a_warning_and_passes_its_self_test(compiler, model, tmp_path, pendulum_folder):
    """All committed folders are built so in both precisions by `make evidence`, whose results are judged elsewhere."""
    folder = pendulum_folder if model == "pendulum" else EM.parent / model
    done = self_test(folder, tmp_path, *STRICT, *(["-O0"] if folder.parent == EM.parent else []), cc=compiler)
    assert done.stdout.splitlines()[-1] == passed(folder), done.stdout


def test_the_self_test_can_fail(sd_copy, tmp_path):
    kernel = sd_copy / "src" / "sd_rates_kernel.h"
    text = kernel.read_text()
    spoilt = re.sub(r"(= \w+) - (\w+);", r"\1 + \2;", text, count=1)
    assert spoilt != text
    kernel.write_text(spoilt)
    done = self_test(sd_copy, tmp_path, "-std=c99")
    assert done.returncode == 1
    assert "FAILED sd_rates" in done.stdout


def test_fast_math_is_refused():
    done = run("cc", "-std=c99", "-ffast-math", "-I", EM / "include", "-fsyntax-only", EM / "src" / "em_F.c")
    assert done.returncode != 0
    assert "ffast-math" in done.stderr


USER = (
    '#include <stdio.h>\n#include "euler_matching.h"\nint main(void)\n{\n    em_nav nav = {{1, 0, 0, 0}, {0}};\n'
    "    bs_real e[3];\n    return (int)em_euler_angles(&nav, e);\n}\n"
)


@needs("cmake")
@pytest.mark.parametrize("way", ["add_subdirectory", "find_package"])
def test_cmake_takes_the_folder_both_ways(way, tmp_path):
    project = tmp_path / "project"
    project.mkdir()
    (project / "main.c").write_text(USER)
    prefix = tmp_path / "prefix"
    if way == "find_package":
        compiler.run([tool("cmake"), "-S", EM, "-B", tmp_path / "em", f"-DCMAKE_INSTALL_PREFIX={prefix}"])
        compiler.run([tool("cmake"), "--build", tmp_path / "em", "--parallel", "2"])
        compiler.run(["ctest", "--test-dir", tmp_path / "em", "--output-on-failure"])
        compiler.run([tool("cmake"), "--install", tmp_path / "em"])
        take = "find_package(euler_matching 0.1 REQUIRED)"
    else:
        take = f"add_subdirectory({EM} em)"
    (project / "CMakeLists.txt").write_text(
        f"cmake_minimum_required(VERSION 3.16)\nproject(user C)\n{take}\nadd_executable(user main.c)\n"
        "target_link_libraries(user PRIVATE boresight::euler_matching)\n"
    )
    compiler.run([tool("cmake"), "-S", project, "-B", project / "build", f"-DCMAKE_PREFIX_PATH={prefix}"])
    compiler.run([tool("cmake"), "--build", project / "build"])
    compiler.run([project / "build" / "user"])
