"""The generated detector as an engineer takes it: warnings, self-test, guards, one binary with a model."""

import json
import shutil
from pathlib import Path

import pytest
from building import STRICT, c_files, passed, program, run, self_test
from conftest import ROOT
from tools import given

from boresight import BoresightError
from boresight.codegen.generate import generate, load_model, target_names
from boresight.runtime import detector
from boresight.runtime.library import load
from boresight.runtime.manifest import built_in

DETECTOR = ROOT / "generated" / "stationary_detector"
WINDOW, UNDEFINED = ("-DDET_MAX_WINDOW=32",), ("-fsanitize=undefined", "-fno-sanitize-recover")


@pytest.fixture
def copy(tmp_path):
    return Path(shutil.copytree(DETECTOR, tmp_path / "stationary_detector"))


@pytest.mark.parametrize(
    ("compiler", "more"),
    [
        *(build for more in ((), WINDOW) for build in (("gcc", more), given("clang", more))),
        ("gcc", UNDEFINED),
        given("libclang-rt", UNDEFINED),
    ],
)
def test_compiles_without_a_warning_and_passes_its_self_test(compiler, more, tmp_path):
    done = self_test(DETECTOR, tmp_path, *STRICT, *more, cc=compiler)
    assert (done.returncode, done.stdout.splitlines()[-1]) == (0, passed(DETECTOR)), done.stdout + done.stderr


@pytest.mark.parametrize("compiler", ["gcc", given("clang")])
def test_single_precision_holds_no_double(compiler, tmp_path):
    out = tmp_path / "single.o"
    source = DETECTOR / "src" / "stationary_detector.c"
    done = run(compiler, *STRICT, "-DBORESIGHT_FLOAT", "-I", DETECTOR / "include", "-c", source, "-o", out)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("sample[k][1] - y", "sample[k][1]"),
        ("sample[k][2] - z", "sample[k][1] - z"),
        ("z /= count", "z /= (count - BS_REAL(1.0))"),
        ("zz) / count", "zz) / (count - BS_REAL(1.0))"),
        ("(z * z)", "(y * z)"),
        ("yy += dy * dy", "yy += dx * dy"),
        ("(from_gravity * from_gravity)", "from_gravity"),
        ("(gyro_norm * gyro_norm)", "BS_REAL(0.0)"),
        ("statistic[i] < settings->threshold[i]", "statistic[i] > settings->threshold[i]"),
        ("detector->count < settings->window", "detector->count < 1"),
        ("(detector->next + 1) < detector->settings.window", "(detector->next + 1) < DET_MAX_WINDOW"),
        ("(of_gyro == BS_NOT_FINITE) || (of_accel == BS_NOT_FINITE)", "of_accel == BS_NOT_FINITE"),
        (
            "detector->count = 0; /* [DET-F-003] */\n    detector->next = 0;\n    return",
            "detector->next = 0;\n    return",
        ),
        ("settings->window < 2", "settings->window < 1"),
        ("!is_state(detector)", "0"),
    ],
)
def test_the_self_test_sees_each_mutation(right, wrong, copy, tmp_path):
    source = copy / "src" / "stationary_detector.c"
    text = source.read_text()
    assert text.count(right) >= 1
    source.write_text(text.replace(right, wrong))
    done = self_test(copy, tmp_path, "-std=c99")
    assert done.returncode != 0, "the self-test does not see it"  # a crash is seen too
    assert done.returncode < 0 or "FAILED stationary_detector" in done.stdout


def test_a_model_and_the_detector_link_into_one_binary(tmp_path):
    main, em = tmp_path / "main.c", ROOT / "generated" / "euler_matching"
    main.write_text(
        '#include "euler_matching.h"\n#include "stationary_detector.h"\n'
        "static det_detector detector;\n"
        "int main(void)\n{\n    em_step step = {{0}, {1e-5, 0, 0}, 1.0};\n    bs_real F[36];\n"
        "    const det_settings settings = {2, 9.81, 0.01, 0.001, {0}};\n"
        "    return (em_F(&step, F) == BS_OK && det_init(&detector, &settings) == BS_OK) ? 0 : 1;\n}\n"
    )
    includes = ["-I", em / "include", "-I", DETECTOR / "include"]
    both = program(tmp_path, [main, *c_files(em, "src"), *c_files(DETECTOR, "src")], "-std=c99", *includes)
    assert run(both).returncode == 0


@pytest.mark.digits
def test_the_committed_files_are_those_of_the_templates():
    report = generate("stationary-detector", check=True)
    assert report.comparable, "made with other versions; install with -c constraints.txt"
    assert report.written == ()


def test_a_change_is_named_and_a_file_edited_by_hand_is_kept(copy):
    source, manifest = copy / "src" / "stationary_detector.c", copy / "manifest.json"
    source.write_text(source.read_text() + "/* mine */\n")
    with pytest.raises(BoresightError, match=r"stationary_detector\.c was edited"):
        generate("stationary-detector", copy)
    source.unlink()
    document = json.loads(manifest.read_text())
    document["units"]["stationary_detector"] |= {"hash": "another", "lines": 160}
    manifest.write_text(json.dumps(document))
    report = generate("stationary-detector", copy)
    (change,) = report.changes
    assert str(change).startswith("stationary_detector: 160 -> ") and " lines (+" in str(change)
    assert source.read_bytes() == (DETECTOR / "src" / "stationary_detector.c").read_bytes()


def test_stale_c_is_not_run(copy, monkeypatch):
    monkeypatch.setattr(detector, "folder_of", lambda name: copy)
    detector.library()
    source = copy / "src" / "stationary_detector.c"
    source.write_text(source.read_text().replace("zz) / count", "zz)"))
    with pytest.raises(BoresightError, match="edited since it was generated"):
        detector.library()


def test_a_component_is_generated_with_the_models_and_is_none():
    assert "stationary-detector" in target_names()
    assert "stationary-detector" not in built_in()
    for attempt in (load, load_model):
        with pytest.raises(BoresightError, match=r"comes from no model; models are .*euler-matching"):
            attempt("stationary-detector")
