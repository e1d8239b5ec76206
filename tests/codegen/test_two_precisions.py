"""The example of navigation in double and its errors in float, as its page says to run it."""

import re
import shutil

import pytest
from building import exported_c, run
from conftest import ROOT

EXAMPLE = ROOT / "examples" / "two-precisions"
STRICT = "CFLAGS=-O0 -Werror"


@pytest.fixture(scope="module")
def example(compiled_once, tmp_path_factory):
    copy = tmp_path_factory.mktemp("two") / "two-precisions"
    shutil.copytree(EXAMPLE, copy, ignore=shutil.ignore_patterns("build"))
    for precision in ("double", "float"):
        exported_c("azimuth-hold", copy / "build" / precision, precision)
    return copy


def test_navigation_in_double_and_errors_in_float_are_one_program(example):
    done = run("make", "-s", "-C", example, "run", STRICT)
    assert done.returncode == 0, done.stdout + done.stderr
    lines = done.stdout.splitlines()
    assert ", double, Joseph, " in lines[0] and ", float, UD, " in lines[1]
    longitudes = [float(line.split()[1]) for line in lines[3:9]]
    # less than the step of a float there, and no multiple of it: the position is carried in double
    assert 0 < max(longitudes) - min(longitudes) < 1.5e-8
    sigmas = [float(line.split()[3]) for line in lines[3:9]]
    assert sigmas == sorted(sigmas, reverse=True)


@pytest.mark.digits
def test_the_page_shows_what_is_printed(example):
    printed = run("make", "-s", "-C", example, "run", STRICT).stdout.splitlines()
    hidden = [re.sub(r"[0-9a-f]{64}$", "<hash>", line) for line in printed]
    page = (EXAMPLE / "README.md").read_text().split("```\n")[3].splitlines()
    assert page[:3] == hidden[:3] and page[-1] == hidden[-1]
    for shown in page[3:-1]:
        if shown != "...":
            (same,) = (line for line in hidden[3:] if line.split()[0] == shown.split()[0])
            for a, b in zip(shown.split(), same.split(), strict=True):
                assert abs(float(a) - float(b)) <= 0.02 * abs(float(b))


def test_the_wrong_half_alone_does_not_link(example):
    """The errors' half with the library in double alone: not one of its functions is found."""
    assert run("make", "-s", "-C", example, "run", STRICT).returncode == 0
    library = example / "build" / "double" / "build" / "libazimuth_hold.a"
    objects = [example / "build" / name for name in ("errors.o", "navigation.o")]
    done = run("gcc", example / "main.c", *objects, library, "-lm", "-o", example / "build" / "wrong")
    assert done.returncode != 0
    assert "ah_filter_propagate_f32" in done.stderr and "ah_strapdown" not in done.stderr
