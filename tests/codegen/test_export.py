"""The exported folder as a flight-software engineer takes it: built and run with the system's compiler alone."""

import subprocess

import pytest
from conftest import PENDULUM, ROOT

from boresight import BoresightError
from boresight.codegen.export import export

FLAGS = "-O1 -Wconversion -Wdouble-promotion -Wshadow -Wmissing-prototypes -Werror"


def make(folder, *targets):
    return subprocess.run(
        ["make", "-C", str(folder), f"CFLAGS={FLAGS}", *targets], capture_output=True, text=True, check=False
    )


@pytest.mark.parametrize("precision", ["double", "float"])
def test_an_exported_model_passes_its_tests_and_ends_where_python_does(precision, tmp_path):
    export("euler-matching", tmp_path / "out", precision)
    done = make(tmp_path / "out", "test", "example")
    assert done.returncode == 0, done.stdout + done.stderr
    assert ", 0 failed" in done.stdout
    assert "60 s flown" in done.stdout


def test_a_float_export_has_no_double_in_its_sources(tmp_path):
    export("euler-matching", tmp_path / "out", "float")
    listed = subprocess.run(
        [
            "cc",
            "-std=c99",
            "-E",
            "-I",
            str(tmp_path / "out" / "include"),
            str(tmp_path / "out" / "src" / "em_filter.c"),
        ],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    own = listed[listed.rindex("typedef float bs_real") :]
    assert " double " not in own


def test_the_example_notices_a_wrong_filter(tmp_path):
    export("euler-matching", tmp_path / "out", "double")
    kernel = tmp_path / "out" / "src" / "em_Qc_kernel.h"
    text = kernel.read_text()
    assert "= q_b2n_wxyz[1] * q_b2n_wxyz[1];" in text
    kernel.write_text(text.replace("= q_b2n_wxyz[1] * q_b2n_wxyz[1];", "= q_b2n_wxyz[1] + q_b2n_wxyz[1];"))
    done = make(tmp_path / "out", "example")
    assert done.returncode != 0


def test_a_model_of_ones_own_is_exported(pendulum_folder, tmp_path):
    export(PENDULUM, tmp_path / "out", "float", pendulum_folder)
    done = make(tmp_path / "out", "test")
    assert done.returncode == 0, done.stdout + done.stderr


def test_exporting_twice_gives_the_same_bytes(tmp_path):
    trees = []
    for name in ("a", "b"):
        export("euler-matching", tmp_path / name, "double")
        files = [path for path in sorted((tmp_path / name).rglob("*")) if path.is_file()]
        trees.append([(path.relative_to(tmp_path / name), path.read_bytes()) for path in files])
    assert trees[0] == trees[1]


def test_nothing_is_overwritten(tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(BoresightError, match="not empty"):
        export("euler-matching", tmp_path, "double")
    assert [path.name for path in tmp_path.iterdir()] == ["notes.txt"]


def test_a_wrong_precision_lists_the_right_ones(tmp_path):
    with pytest.raises(BoresightError, match="double or float"):
        export("euler-matching", tmp_path / "out", "half")


def test_what_has_no_filter_is_refused_by_name(tmp_path):
    with pytest.raises(BoresightError, match="no filter"):
        export("strapdown", tmp_path / "out", "double")
    assert (ROOT / "generated" / "strapdown").is_dir()
